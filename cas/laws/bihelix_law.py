"""The number of bihelices that theory predicts: N(ε) = C ε^{−1/p}, to many digits.

The error of one short arc of length σ is |κ′|σ³/324, so p = 3 and C = ∫ (|κ′|/324)^{1/3} ds. On a curve of
constant curvature that vanishes and κ|τ′|σ⁴/5760 is left: p = 4, C = ∫ (κ|τ′|/5760)^{1/4} ds.
`osculant.cas.asymptotics.bihelix_series` and the claims about bihelices derive both.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from flint import arb

from osculant.cas.jets.space import SpaceJet
from osculant.cas.laws.complexity import integral
from osculant.cas.numbers.balls import PRECISION, SpaceBalls, precision


@dataclass(frozen=True)
class SpaceLaw:
    """The error of one short arc, ``invariant``·σ^``order``/``divisor``; jets of order ``derivatives``."""

    order: int
    divisor: int
    derivatives: int
    invariant: Callable[[SpaceJet], Any]

    def density(self, jet: SpaceJet) -> Any:
        """(c·J)^{1/p} |α̇| at a jet of balls."""
        value = abs(self.invariant(jet)) / self.divisor
        return value.root(self.order) * jet.speed if value > 0 else arb(0) * jet.speed


#: by the shape of the curve: generic, or of constant curvature
LAWS: Mapping[str, SpaceLaw] = {
    "generic": SpaceLaw(3, 324, 3, lambda jet: jet.curvature_slope),
    "level": SpaceLaw(4, 5760, 4, lambda jet: jet.curvature * jet.torsion_slope),
}


def bihelix_constant(curve: SpaceBalls, shape: str, low: Any, high: Any) -> tuple[Any, float]:
    """(C, estimated error) over one stretch [low, high] between special points, to about 20 digits.

    Args:
        curve: in ball arithmetic.
        shape: "generic" or "level" (constant curvature).
        low: first end, a ball.
        high: last end.

    Double exponential quadrature in 320-bit balls. Raises UndecidedError if it does not settle.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> cone = SpaceBalls(parse_tuple("t*cos(t), t*sin(t), t"))
    >>> with precision(PRECISION):
    ...     low, high = arb.pi() / 6, 2 * arb.pi()
    >>> round(float(bihelix_constant(cone, "generic", low, high)[0]), 6)
    0.851459
    """
    law = LAWS[shape]
    with precision(PRECISION):
        return integral(lambda t: law.density(curve.jet(t, law.derivatives)).mid(), low, high)
