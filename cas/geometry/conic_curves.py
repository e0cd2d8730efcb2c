"""Curves that are arcs of one conic: its equation from one jet, and the arc between any two of its points.

With Q = 0 the conic, A the symmetric matrix of its quadratic part, S = det A, and T = J∇Q/2 (J the quarter
turn) the point runs along the conic by dP/dτ = T: on an ellipse τ√S is the eccentric angle. Between two
points with C = P₂ − P₀ the vector T₀ + T₂ is parallel to C, say σC, and the arc is the rational quadratic
Bézier curve with the legs M − wP₀ = λT₀ and wP₂ − M = λT₂, where λ = 1/√(σ² + S) and w = λσ. So nothing of
the formula's parametrisation enters but the points themselves.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb

from osculant.cas.geometry.five_points import Conic, osculating_conic
from osculant.cas.jets.plane import PlaneJet

Pair = tuple[Any, Any]


@dataclass(frozen=True)
class Bezier:
    """The arc as a rational quadratic Bézier curve with outer weights 1: M = wP₁, in balls."""

    start: Pair
    middle: Pair
    end: Pair
    weight: Any

    @property
    def shoulder(self) -> Pair:
        """The point at the parameter 1/2, where the tangent is parallel to the chord."""
        x, y = ((p + 2 * m + q) / (2 + 2 * self.weight) for p, m, q in zip(self.start, self.middle, self.end))
        return x, y


@dataclass(frozen=True)
class ConicCurve:
    """A conic with the sense in which a curve runs along it.

    Args:
        conic: no pair of lines.
        sense: 1 if the curve runs along J∇Q, −1 if against it.
        parabola: whether S is 0; in balls that cannot be seen.

    >>> x, y = map(arb, (1, 0, -1, 0, 1)), map(arb, (0, 1, 0, -1, 0))
    >>> half = ConicCurve.through(PlaneJet(tuple(x), tuple(y)))
    >>> arc = half.between((arb(1), arb(0)), (arb(-1), arb(0)))
    >>> abs(arc.weight) < 1e-12, abs(arc.middle[1] - 1) < 1e-12
    (True, True)
    """

    conic: Conic
    sense: int
    parabola: bool = False

    @classmethod
    def through(cls, jet: PlaneJet, parabola: bool = False) -> ConicCurve:
        """The conic that a curve is an arc of, from its jet of order 4 at one point, in balls.

        Raises DomainError and UndecidedError as `five_points.osculating_conic`.
        """
        conic = osculating_conic(jet)
        largest = max(abs(arb(c).mid()) for c in conic)
        found = cls(Conic(*(c / largest for c in conic)), 1, parabola)
        tx, ty = found.along(jet.point(0))
        along = tx * jet.x[1] + ty * jet.y[1]
        return found if along > 0 else cls(found.conic, -1, parabola)

    @cached_property
    def S(self) -> Any:
        """det A: positive on an ellipse."""
        return arb(0) if self.parabola else self.conic.S

    @property
    def ellipse(self) -> bool:
        """Whether the conic is closed, so that a curve may go round it."""
        return bool(self.S > 0)

    def along(self, point: Pair) -> Pair:
        """T at a point, in the curve's sense."""
        a, b, c, d, e, _ = self.conic
        x, y = point
        return -self.sense * (b * x + c * y + e), self.sense * (a * x + b * y + d)

    def off(self, point: Pair) -> Any:
        """How far a point is from the conic, to first order: |Q|/|∇Q|."""
        tx, ty = self.along(point)
        return abs(self.conic(*point)) / (2 * (tx * tx + ty * ty).sqrt())

    def advance(self, start: Pair, end: Pair) -> Any:
        """How far τ runs from a point to another, by less than once round; 0 if they cannot be told apart."""
        chord, sigma = self._chord(start, end)
        if chord is None:
            return arb(0)
        root = abs(self.S).sqrt()
        if self.ellipse:
            return 2 * arb.atan2(root, sigma) / root
        if self.S < 0:
            return 2 * (root / sigma).atanh() / root
        return 2 / sigma

    def between(self, start: Pair, end: Pair) -> Bezier:
        """The arc between two points, less than once round."""
        _, sigma = self._chord(start, end)
        scale = 1 / (sigma * sigma + self.S).sqrt()
        weight = arb(1) if self.parabola else scale * sigma
        x, y = (weight * p + scale * t for p, t in zip(start, self.along(start)))
        return Bezier(start, (x, y), end, weight)

    def _chord(self, start: Pair, end: Pair) -> tuple[Pair | None, Any]:
        """The chord C, None if it cannot be told from 0, and σ."""
        dx, dy = end[0] - start[0], end[1] - start[1]
        square = dx * dx + dy * dy
        if not square > 0:
            return None, arb(0)
        (x0, y0), (x2, y2) = self.along(start), self.along(end)
        return (dx, dy), ((x0 + x2) * dx + (y0 + y2) * dy) / square
