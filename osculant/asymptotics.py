"""The number of pieces that theory predicts for a curve."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.primitives import PRIMITIVES
from osculant.tolerances import checked_tolerance

if TYPE_CHECKING:
    from osculant.plane import PlaneCurve
    from osculant.stretches import Division


#: a predicted number above an integer by less than this part of it is that integer
ROUNDING = 1e-12


@dataclass(frozen=True)
class Complexity:
    """N(ε) = C ε^{−1/order} + c₁ ε^{1/order} + …, C and c₁ summed over the stretches between split points.

    ``constants`` are the C of the stretches to ``digits`` digits (estimates by quadrature that
    converges doubly exponentially); a stretch whose curve is the primitive itself has C = 0 and takes
    ``least`` pieces.  ``next_constants`` are the c₁ of the stretches, estimates too, if they were asked for.

    >>> law = Complexity("conic", "hausdorff", 5, ("1.5", "0"), (1, 2), 15)
    >>> law.constant, round(law.predicted(1e-5), 9), law.predicted_pieces(1e-5)
    (1.5, 15.0, 17)
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
        return math.fsum(float(c) for c in self.constants)

    def predicted(self, tolerance: float) -> float:
        """The real number C ε^{−1/order}; raises ToleranceError unless ε is positive and finite."""
        return float(self.constant * checked_tolerance(tolerance) ** (-1.0 / self.order))

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
        """The whole number: rounded up on every stretch, at least what the stretch needs."""
        scale = checked_tolerance(tolerance) ** (-1.0 / self.order)
        return sum(
            max(n, math.ceil(float(c) * scale * (1 - ROUNDING)))
            for c, n in zip(self.constants, self.least, strict=True)
        )

    count = predicted_pieces

    def to_json(self) -> dict[str, Any]:
        """Plain data: primitive, metric, order, constant (text, all digits), constants of the stretches.

        With c₁ also "next_constant" and "next_constants".
        """

        def total(constants: tuple[str, ...]) -> str:
            from decimal import Decimal

            return str(sum((Decimal(c) for c in constants), Decimal(0)))

        data: dict[str, Any] = {
            "primitive": self.primitive,
            "metric": self.metric,
            "order": self.order,
            "constant": total(self.constants),
            "constants": list(self.constants),
        }
        if self.next_constants is not None:
            data["next_constant"] = total(self.next_constants)
            data["next_constants"] = list(self.next_constants)
        return data


#: digits of a constant by itself, of c₁, and of one that only predicts a spline's number of pieces
DIGITS, DIGITS_OF_NEXT, DIGITS_FOR_SPLINES = 20, 12, 9


def complexity_of(
    curve: PlaneCurve, primitive: str, division: Division, least: tuple[int, ...], next_term: bool = False
) -> Complexity:
    """The complexity of a divided curve; ``least`` pieces are needed on each stretch in any case.

    Integrated in ball arithmetic; raises UndecidedError if that does not settle, and DomainError if c₁ is
    asked for and its integral diverges at a special point.
    """
    from osculant.cas.complexity import complexity_constant

    constants = []
    for stretch in division.stretches:
        if stretch.kind != "generic":
            constants.append("0")
            continue
        value, _ = complexity_constant(curve.balls, primitive, stretch.low, stretch.high)
        constants.append(value.str(DIGITS, radius=False))
    following = tuple(_next_constants(curve, primitive, division)) if next_term else None
    order = PRIMITIVES[primitive].order
    return Complexity(primitive, "hausdorff", order, tuple(constants), least, DIGITS, following)


def _next_constants(curve: PlaneCurve, primitive: str, division: Division) -> Iterator[str]:
    from osculant.cas.asymptotics.next_term import next_constant

    for stretch in division.stretches:
        if stretch.kind != "generic":
            yield "0"
        else:
            value, _ = next_constant(curve.balls, primitive, stretch.low, stretch.high)
            yield value.str(DIGITS_OF_NEXT, radius=False)


def quick_complexity(
    curve: PlaneCurve, primitive: str, division: Division, least: tuple[int, ...], scale: float
) -> Complexity:
    """The same in doubles, to predict a spline's pieces; ``scale`` makes the curve's size about 1."""
    from osculant.cas.complexity import complexity_constant
    from osculant.codegen.jets import compile_jet
    from osculant.kernels.quadrature import predicted

    order = PRIMITIVES[primitive].order
    jet = compile_jet(curve.coordinates, 5)  # owns the code at its address
    constants = []
    for stretch in division.stretches:
        constant = 0.0
        if stretch.kind == "generic":
            constant = predicted(PRIMITIVES[primitive].code, jet.address, scale, stretch.a, stretch.b)
        # N = C ε^{−1/p} has no unit: the constant of the scaled curve belongs to the scaled tolerance
        constant *= scale ** (-1.0 / order)
        if math.isnan(constant):  # rounding beside a singular end: balls know better
            constant = float(complexity_constant(curve.balls, primitive, stretch.low, stretch.high)[0])
        constants.append(repr(constant))
    return Complexity(primitive, "hausdorff", order, tuple(constants), least, DIGITS_FOR_SPLINES)
