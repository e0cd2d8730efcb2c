"""The number of pieces that theory predicts for a curve."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.tolerances import checked_tolerance

if TYPE_CHECKING:
    from osculant.plane import PlaneCurve
    from osculant.stretches import Division


#: the error of one short arc is of this order in its length (`osculant.cas.complexity.LAWS`)
ORDERS = {"parabola": 4, "conic": 5}
#: a predicted number above an integer by less than this part of it is that integer
ROUNDING = 1e-12


@dataclass(frozen=True)
class Complexity:
    """N(ε) = C ε^{−1/order} + …, with C summed over the stretches between split points.

    ``constants`` are the C of the stretches to ``digits`` digits (estimates by quadrature that
    converges doubly exponentially); a stretch whose curve is the primitive itself has C = 0 and takes
    ``least`` pieces.

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

    @property
    def constant(self) -> float:
        """The leading constant C of the whole curve."""
        return math.fsum(float(c) for c in self.constants)

    def predicted(self, tolerance: float) -> float:
        """The real number C ε^{−1/order}; raises ToleranceError unless ε is positive and finite."""
        return float(self.constant * checked_tolerance(tolerance) ** (-1.0 / self.order))

    def predicted_pieces(self, tolerance: float) -> int:
        """The whole number: rounded up on every stretch, at least what the stretch needs."""
        scale = checked_tolerance(tolerance) ** (-1.0 / self.order)
        return sum(
            max(n, math.ceil(float(c) * scale * (1 - ROUNDING)))
            for c, n in zip(self.constants, self.least, strict=True)
        )

    count = predicted_pieces

    def to_json(self) -> dict[str, Any]:
        """Plain data: primitive, metric, order, constant (text, all digits), constants of the stretches."""
        from decimal import Decimal

        return {
            "primitive": self.primitive,
            "metric": self.metric,
            "order": self.order,
            "constant": str(sum((Decimal(c) for c in self.constants), Decimal(0))),
            "constants": list(self.constants),
        }


#: digits of a constant by itself, and of one that only predicts a spline's number of pieces
DIGITS, DIGITS_FOR_SPLINES = 20, 9


def complexity_of(
    curve: PlaneCurve, primitive: str, division: Division, least: tuple[int, ...]
) -> Complexity:
    """The complexity of a divided curve; ``least`` pieces are needed on each stretch in any case.

    Integrated in ball arithmetic; raises UndecidedError if that does not settle.
    """
    from osculant.cas.complexity import complexity_constant

    constants = []
    for stretch in division.stretches:
        if stretch.kind != "generic":
            constants.append("0")
            continue
        value, _ = complexity_constant(curve.balls, primitive, stretch.low, stretch.high)
        constants.append(value.str(DIGITS, radius=False))
    return Complexity(primitive, "hausdorff", ORDERS[primitive], tuple(constants), least, DIGITS)


def quick_complexity(
    curve: PlaneCurve, primitive: str, division: Division, least: tuple[int, ...], scale: float
) -> Complexity:
    """The same in doubles, to predict a spline's pieces; ``scale`` makes the curve's size about 1."""
    from osculant.cas.complexity import complexity_constant
    from osculant.codegen.jets import compile_jet
    from osculant.fitting import PRIMITIVES
    from osculant.kernels.quadrature import predicted

    order = ORDERS[primitive]
    jet = compile_jet(curve.coordinates, 5)  # owns the code at its address
    constants = []
    for stretch in division.stretches:
        constant = 0.0
        if stretch.kind == "generic":
            constant = predicted(PRIMITIVES[primitive], jet.address, scale, stretch.a, stretch.b)
        # N = C ε^{−1/p} has no unit: the constant of the scaled curve belongs to the scaled tolerance
        constant *= scale ** (-1.0 / order)
        if math.isnan(constant):  # rounding beside a singular end: balls know better
            constant = float(complexity_constant(curve.balls, primitive, stretch.low, stretch.high)[0])
        constants.append(repr(constant))
    return Complexity(primitive, "hausdorff", order, tuple(constants), least, DIGITS_FOR_SPLINES)
