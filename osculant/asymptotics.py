"""The number of pieces that theory predicts for a curve."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.tolerances import checked_tolerance

if TYPE_CHECKING:
    from osculant.plane import PlaneCurve
    from osculant.stretches import Division


#: a predicted number above an integer by less than this part of it is that integer
ROUNDING = 1e-12


@dataclass(frozen=True)
class Complexity:
    """N(ε) = C ε^{−1/order} + …, with C summed over the stretches between split points.

    ``constants`` are the C of the stretches to ``digits`` digits (estimates by quadrature that
    converges doubly exponentially); a stretch whose curve is the primitive itself has C = 0 and takes
    ``least`` pieces.

    >>> law = Complexity("conic", "hausdorff", 5, ("1.5", "0"), (1, 2), 15)
    >>> law.constant, law.predicted(1e-5), law.predicted_pieces(1e-5)
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
DIGITS, DIGITS_FOR_SPLINES = 20, 12


def complexity_of(
    curve: PlaneCurve, primitive: str, division: Division, least: tuple[int, ...], digits: int = DIGITS
) -> Complexity:
    """The complexity of a divided curve; ``least`` pieces are needed on each stretch in any case."""
    from osculant.cas.complexity import LAWS, complexity_constant

    constants = []
    for stretch in division.stretches:
        if stretch.kind != "generic":
            constants.append("0")
            continue
        value, _ = complexity_constant(curve.balls, primitive, stretch.low, stretch.high, digits)
        constants.append(value.str(digits, radius=False))
    return Complexity(primitive, "hausdorff", LAWS[primitive].order, tuple(constants), least, digits)
