"""What a law is: how the error of one short arc depends on the curve and on the arc's length."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node

if TYPE_CHECKING:
    from osculant.cas.numbers.algebraic import Algebraic

#: the metrics, and the dimension of an error in each: 1 for a length, 2 for an area
METRICS = {"hausdorff": 1, "area": 2}


@dataclass(frozen=True)
class Law:
    """The error of one short arc of Euclidean length σ: c·J·σ^``order``, to leading order.

    Attributes:
        primitive: what the arc is replaced by; another name, such as "level bihelix", where it has another
            law on special curves.
        metric: a name of `METRICS`.
        order: p.
        jet: the derivatives of the curve that J needs.
        invariant: J ≥ 0 at a jet of any numbers.
        constant: gives c, an exact constant.
        source: the module that derives the law.
        spaces: the dimensions of the spaces whose curves it is for.
        branch: where J is the least of several values, which of them it is at a jet of balls, a label that
            changes where J is not smooth; None of laws whose J is a closed form.
    """

    primitive: str
    metric: str
    order: int
    jet: int
    invariant: Callable[[Any], Any]
    constant: Callable[[], Node | Algebraic]
    source: str
    spaces: tuple[int, ...] = (2,)
    branch: Callable[[Any], Hashable] | None = None

    @property
    def dimension(self) -> int:
        """1 if the error is a length, 2 if it is an area."""
        return METRICS[self.metric]

    @property
    def spline_order(self) -> int:
        """The q in N(ε) = C·ε^{−1/q}: p if ε is the greatest error, p − 1 if it is the sum of all areas."""
        return self.order - (self.metric == "area")

    def ball(self) -> Any:
        """c as a ball at the current precision."""
        from osculant.cas.numbers.balls import constant

        c = self.constant()
        return constant(c) if isinstance(c, Node) else c.ball()

    def exact(self) -> Any:
        """c as a number of sympy's."""
        from osculant.cas.formulas.sympy_bridge import to_sympy

        c = self.constant()
        return to_sympy(c) if isinstance(c, Node) else c.number()

    def density(self, jet: Any, constant: Any) -> Any:
        """(c·J)^{1/p} |α̇| at a jet of balls, c being given as a ball: what a number of pieces integrates."""
        value = constant * self.invariant(jet)
        return value.root(self.order) * jet.speed if value > 0 else 0 * jet.speed


def table(laws: Iterable[Law]) -> dict[tuple[str, str], Law]:
    """The laws by primitive and metric.

    Raises DomainError if two are for the same primitive and metric.

    >>> from osculant.cas.laws.bihelices import LAWS
    >>> sorted(table(LAWS))
    [('bihelix', 'hausdorff'), ('level bihelix', 'hausdorff')]
    >>> table(2 * LAWS)
    Traceback (most recent call last):
    osculant.cas.errors.DomainError: Two laws are for 'bihelix' and 'hausdorff': name one of them otherwise.
    """
    found: dict[tuple[str, str], Law] = {}
    for law in laws:
        key = law.primitive, law.metric
        if key in found:
            raise DomainError(f"Two laws are for {key[0]!r} and {key[1]!r}: name one of them otherwise.")
        found[key] = law
    return found
