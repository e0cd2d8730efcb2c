"""The number of pieces that theory predicts for a curve."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.primitives.table import choose
from osculant.tolerances import checked_tolerance

if TYPE_CHECKING:
    from osculant.approximation.division import Division
    from osculant.curves.plane import PlaneCurve


#: a predicted number above an integer by less than this part of it is that integer
ROUNDING = 1e-12


@dataclass(frozen=True)
class Complexity:
    """N(ε) = C ε^{−1/order} + c₁ ε^{1/order} + …, with C and c₁ of the whole curve.

    ``constants`` are the C of the stretches between split points to ``digits`` digits (estimates by
    quadrature that converges doubly exponentially); a stretch whose curve is the primitive itself has C = 0
    and takes ``least`` pieces.  ``next_constants`` are the c₁ of the stretches, estimates too, if they were
    asked for.

    In the metric "hausdorff" every piece has the error ε, ``order`` p is that of a short arc's error, and C
    is the sum (3.17), (3.18).  In "area" the pieces' areas add up to ε, each having the same; ``order`` is
    then q = p − 1, and C^{q/p}, the content, is the sum (3.25), (3.26).

    >>> law = Complexity("conic", "hausdorff", 5, ("1.5", "0"), (1, 2), 15)
    >>> law.constant, round(law.predicted(1e-5), 9), law.predicted_pieces(1e-5)
    (1.5, 15.0, 17)
    >>> halves = Complexity("conic", "area", 5, ("0.7", "0.7"), (1, 1), 15)
    >>> round(halves.constant / 0.7, 9) == round(2 ** (6 / 5), 9), halves.predicted_pieces(1e-5)
    (True, 18)
    """

    primitive: str
    metric: str
    order: int
    constants: tuple[str, ...]
    least: tuple[int, ...]
    digits: int
    next_constants: tuple[str, ...] | None = None

    @property
    def constant(self) -> float:
        """The leading constant C of the whole curve."""
        return float(math.fsum(self._contents) ** self._power)

    @property
    def _power(self) -> float:
        """p/q: the power of the content that C is."""
        return (self.order + 1) / self.order if self.metric == "area" else 1.0

    @property
    def _contents(self) -> list[float]:
        """What adds over stretches: pieces with the error ε each take content·ε^{−1/p} of them."""
        return [float(c) ** (1 / self._power) for c in self.constants]

    def predicted(self, tolerance: float) -> float:
        """The real number C ε^{−1/order}; raises ToleranceError unless ε is positive and finite."""
        return float(self.constant * checked_tolerance(tolerance) ** (-1.0 / self.order))

    def predicted_error(self, pieces: int) -> float:
        """The error of the best spline with that many pieces, to leading order: (C/N)^order.

        The Hausdorff distance, or the whole area: the asymptotic formulas of Fejes Tóth, of McClure and
        Vitale and of Ludwig for polygons and parabolas (thesis, section 1.3 and Corollary 3.6.5), with the
        pieces shared among all stretches by their contents.

        Raises DomainError for less than one piece.

        >>> law = Complexity("conic", "hausdorff", 5, ("1.5",), (1,), 15)
        >>> round(law.predicted_error(15), 12)
        1e-05
        """
        if not pieces >= 1:
            raise DomainError(f"A spline has at least one piece, not {pieces!r}.")
        return math.prod([self.constant / pieces] * self.order)  # ∞, not an error, where it overflows

    @property
    def next_constant(self) -> float | None:
        """c₁ of the whole curve, None if it was not asked for."""
        if self.next_constants is None:
            return None
        return math.fsum(float(c) for c in self.next_constants)

    def refined(self, tolerance: float) -> float | None:
        """C ε^{−1/order} + c₁ ε^{1/order}, None without c₁."""
        if self.next_constant is None:
            return None
        return self.predicted(tolerance) + self.next_constant * float(tolerance ** (1.0 / self.order))

    def predicted_pieces(self, tolerance: float) -> int:
        """The whole number: rounded up on every stretch, at least what the stretch needs.

        In the metric "area" the least n that n pieces of the area ε/n suffice for.
        """
        if self.metric != "area":
            return self._pieces(checked_tolerance(tolerance) ** (-1.0 / self.order))
        scale = checked_tolerance(tolerance) ** (-1.0 / (self.order + 1))
        needed, pieces = 1, 0
        while needed > pieces:  # the pieces needed grow with n, so this ends at the least n from below
            pieces = needed
            needed = self._pieces(float(scale * pieces ** (1.0 / (self.order + 1))))
        return pieces

    def _pieces(self, scale: float) -> int:
        """The pieces of all stretches, ``scale`` being ε^{−1/p} for the error ε of each."""
        return sum(
            max(n, math.ceil(content * scale * (1 - ROUNDING)))
            for content, n in zip(self._contents, self.least, strict=True)
        )

    count = predicted_pieces

    def to_json(self) -> dict[str, Any]:
        """Plain data: primitive, metric, order, constant (text, all digits), constants of the stretches.

        With c₁ also "next_constant" and "next_constants".
        """
        from decimal import Decimal, localcontext

        def total(constants: tuple[str, ...], order: int, degree: int) -> str:
            """(Σ c^{order/degree})^{degree/order}."""
            if order == degree:
                return str(sum((Decimal(c) for c in constants), Decimal(0)))
            with localcontext() as context:
                context.prec = self.digits + 10
                content = sum((Decimal(c) ** (Decimal(order) / degree) for c in constants), Decimal(0))
                whole = content ** (Decimal(degree) / order)
                context.prec = self.digits
                return str(+whole)

        data: dict[str, Any] = {
            "primitive": self.primitive,
            "metric": self.metric,
            "order": self.order,
            "constant": total(self.constants, self.order, self.order + (self.metric == "area")),
            "constants": list(self.constants),
        }
        if self.next_constants is not None:
            data["next_constant"] = total(self.next_constants, self.order, self.order)
            data["next_constants"] = list(self.next_constants)
        return data


#: digits of a constant by itself, of c₁, and of one that only predicts a spline's number of pieces
DIGITS, DIGITS_OF_NEXT, DIGITS_FOR_SPLINES = 20, 12, 9


def complexity_of(
    curve: PlaneCurve,
    primitive: str,
    division: Division,
    least: tuple[int, ...],
    next_term: bool = False,
    metric: str = "hausdorff",
) -> Complexity:
    """The complexity of a divided curve; ``least`` pieces are needed on each stretch in any case.

    Integrated in ball arithmetic; raises UndecidedError if that does not settle, and DomainError if c₁ is
    asked for in the metric "area", or its integral diverges at a special point.
    """
    from osculant.cas.laws.complexity import complexity_constant

    if next_term and metric != "hausdorff":
        raise DomainError(f"The second term is not known for the metric {metric!r}: ask without next_term.")
    constants = []
    for stretch in division.stretches:
        if stretch.kind != "generic":
            constants.append("0")
            continue
        value, _ = complexity_constant(curve.balls, primitive, stretch.low, stretch.high, metric)
        constants.append(value.str(DIGITS, radius=False))
    following = tuple(_next_constants(curve, primitive, division)) if next_term else None
    return Complexity(
        primitive, metric, _order(primitive, metric), tuple(constants), least, DIGITS, following
    )


def _order(primitive: str, metric: str) -> int:
    """The order of a spline's error in its number of pieces: areas add, which costs one."""
    return choose(primitive, metric).law.spline_order


def _next_constants(curve: PlaneCurve, primitive: str, division: Division) -> Iterator[str]:
    from osculant.cas.laws.next_term import next_constant

    for stretch in division.stretches:
        if stretch.kind != "generic":
            yield "0"
        else:
            value, _ = next_constant(curve.balls, primitive, stretch.low, stretch.high)
            yield value.str(DIGITS_OF_NEXT, radius=False)


def quick_complexity(
    curve: PlaneCurve,
    primitive: str,
    division: Division,
    least: tuple[int, ...],
    scale: float,
    metric: str = "hausdorff",
) -> Complexity:
    """The same in doubles, to predict a spline's pieces; ``scale`` makes the curve's size about 1."""
    from osculant.cas.laws.complexity import complexity_constant
    from osculant.codegen.jets import compile_jet
    from osculant.kernels.quadrature import predicted

    fit, order = choose(primitive, metric), _order(primitive, metric)
    power = fit.order / order  # of the content that C is
    jet = compile_jet(curve.coordinates, 5)  # owns the code at its address
    constants = []
    for stretch in division.stretches:
        constant = 0.0
        if stretch.kind == "generic":
            constant = predicted(fit.code, jet.address, scale, stretch.a, stretch.b) ** power
        # N = C ε^{−1/order} has no unit: the constant of the scaled curve belongs to the scaled tolerance
        constant *= scale ** (-fit.dimension / order)
        if math.isnan(constant):  # rounding beside a singular end: balls know better
            ends = stretch.low, stretch.high
            constant = float(complexity_constant(curve.balls, primitive, *ends, metric)[0])
        constants.append(repr(constant))
    return Complexity(primitive, metric, order, tuple(constants), least, DIGITS_FOR_SPLINES)
