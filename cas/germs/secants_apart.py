"""Secants of an immersion through two different points: germs of (p, q), and both orders as a bigerm.

At (p₀, q₀) the secant map is a family, with the parameters p, of projections of X near q₀ from the centre
X(p); Proposition 6.2.4 is about its versality. It has the same values at (q, p): as a bigerm at both places
it is as unstable as it can be, unless it is a submersion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node, number, to_text, variable
from osculant.cas.formulas.graph import substitute
from osculant.cas.germs.algebraic import NumberField, exact
from osculant.cas.germs.even import BOUNDARY, fresh
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.immersions import (
    check_count,
    constants,
    expanded_if_polynomial,
    immersed,
    moved_to_origin,
)
from osculant.cas.germs.multigerm import MultiGerm, codimension
from osculant.cas.germs.search import Patience
from osculant.cas.germs.versal import Family, Versality, versality

Size = int | Literal["infinite"]


@dataclass(frozen=True)
class SecantApart:
    """The secant germ at two points with different images.

    Attributes:
        immersion: the components of X, in the variables ``given``.
        given: the names of the source variables of X.
        points: the coordinates of the points, constants.
        parameters: the names of the coordinates p of the first point.
        source: those of the coordinates q of the second.
        germ: (p, q) ↦ the direction of X(q) − X(p), in an affine chart; p and q are 0 at the points.
        back: the same germ where p and q have changed their roles: the other branch of the bigerm.
    """

    immersion: tuple[Node, ...]
    given: tuple[str, ...]
    points: tuple[tuple[Node, ...], tuple[Node, ...]]
    parameters: tuple[str, ...]
    source: tuple[str, ...]
    germ: Germ
    back: Germ

    @property
    def bigerm(self) -> MultiGerm:
        """The germs at (p₀, q₀) and at (q₀, p₀); DomainError for coefficients that are not rational."""
        return MultiGerm([self.germ, self.back])

    def bigerm_codimension(self, patience: Patience | None = None) -> Size:
        """The extended A-codimension of the bigerm, whose branches f have the same image.

        It is 0 for a submersion. Else it is infinite if the target has a dimension m of 2 at least: the set Σ
        of points where f is no submersion has dimension m − 1 or more, so near its image, unless f is 0 on a
        curve in Σ, are points y ≠ 0 with two equal branches. Of a finite multigerm these would be stable, and
        their strata in the target, which are equal and not everything, in general position. For m = 1 it is
        computed: UndecidedError if it is not known.

        >>> from osculant.cas.formulas.parser import parse_tuple
        >>> line = parse_tuple("t, t**2", ("t",))
        >>> secant_apart(line, ("t",), [number(0)], [number(1)]).bigerm_codimension()
        0
        """
        if self.germ.rank == self.germ.p:
            return 0
        return "infinite" if self.germ.p > 1 else codimension(self.bigerm, True, patience).value

    def versality(self, patience: Patience | None = None) -> Versality:
        """Whether the germ is an A-versal unfolding, with the parameters p, of q ↦ its value at (0, q).

        Raises DomainError if that germ has no versal unfolding, UndecidedError if it is not known.

        >>> from osculant.cas.formulas.parser import parse_tuple
        >>> tangent = parse_tuple("t - 2*t**4, t**2 - t**4, t**3 - t**4", ("t",))  # through the point at 1
        >>> secant_apart(tangent, ("t",), [number(1)], [number(0)]).versality().versal
        True
        """
        return versality(Family(self.germ, self.parameters), "A", patience)


def secant_apart(
    components: Sequence[Node], source: Sequence[str], at: Sequence[Node], to: Sequence[Node]
) -> SecantApart:
    """The secant germ of an immersion at two points p₀ and q₀.

    Args:
        components: the formulas of X.
        source: the names of the source variables, in order.
        at: the coordinates of p₀, constants: rational, or roots of numbers.
        to: those of q₀.

    Raises DomainError for a wrong number of coordinates, points where X is not analytic or no immersion, the
    same image at both, a map to the line, and coefficients that are not algebraic.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> found = secant_apart(parse_tuple("t, t**2", ("t",)), ("t",), [number(0)], [number(1)])
    >>> found.parameters, found.source, print(found.germ)
    ((2*t + t**2 - pt**2 - (t - pt))/(t - pt + 1))
    (('pt',), ('t',), None)
    """
    given = tuple(source)
    Germ([variable(name) for name in given], given)  # refuses the names
    q = tuple(f"q{i + 1}" for i in range(len(given))) if BOUNDARY in given else given
    p = tuple(fresh(f"p{i + 1}" if BOUNDARY in given else f"p{name}", q) for i, name in enumerate(q))
    ends, values = [], []
    field = None
    for argument, names, point in (("at", p, at), ("to", q, to)):
        check_count(argument, "coordinate", len(point), len(given))
        _, field = constants(argument, point, field)
        where = f"({', '.join(map(to_text, point))})"
        shifts = {name: variable(name) + a for name, a in zip(given, point)}
        moved, found, field = moved_to_origin(substitute(components, shifts), given, field, where, argument)
        end = Germ(moved, given, None, field)
        immersed(end, where)
        end = expanded_if_polynomial(end)
        field = end.field
        ends.append(substitute(end.components, {old: variable(new) for old, new in zip(given, names)}))
        values.append(found)
    germ = _direction(ends, values, (*p, *q), field)
    exchanged = {old: variable(new) for old, new in zip((*p, *q), (*q, *p))}
    back = Germ(substitute(germ.components, exchanged), germ.source, None, germ.field)
    return SecantApart(tuple(components), given, (tuple(at), tuple(to)), p, q, germ, back)


def _direction(
    ends: Sequence[Sequence[Node]],
    values: Sequence[Sequence[Node]],
    names: tuple[str, ...],
    field: NumberField | None,
) -> Germ:
    """The direction of the difference of the ends, in the chart where its value is the origin."""
    apart = [b - a for a, b in zip(*values)]
    known, field = constants("to", apart, field)
    if not any(known):
        raise DomainError(
            "to: both points have the same image, and no secant goes through them: choose another point.",
            argument="to",
        )
    if len(known) < 2:
        raise DomainError(
            "The secants of a map to the line have one direction: give two components at least."
        )
    pivot = next(i for i, d in enumerate(known) if d)
    moving = [b - a for a, b in zip(*ends)]
    below = moving[pivot] + apart[pivot]
    slopes = [exact(d / known[pivot]) for d in known]
    nodes = [
        (f - (number(s) if field is None else field.expression(s)) * moving[pivot]) / below
        for i, (f, s) in enumerate(zip(moving, slopes))
        if i != pivot
    ]
    return Germ(nodes, names, None, field)
