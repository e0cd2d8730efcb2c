"""Whether normals of an arc meet a bitangent conic at the nearer of two places, proved in ball arithmetic.

Along the normal at a point of the arc the member Q of the pencil, F = l₁² − 4Q l₀ l₂ = 0, is met where a
quadratic in the distance vanishes.  While its linear coefficient B keeps its sign along the arc, the root
that is small near the ends of the arc is the first hit on the member's side everywhere, and the displacement
is the one that the theorems on the least error speak of.  B < 0 on arcs that turn by at most π/2: there all
terms of B are negative, as no tangent is farther than that from the end tangents and from the chord.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.cas.geometry.convex_arcs import CUTS, End, tangent
from osculant.cas.geometry.vectors import Vector, bracket, dot

if TYPE_CHECKING:
    from osculant.cas.geometry.point_distance import Coefficients


def hits_first(coefficients: Coefficients, low: End, high: End, q: float, turned: Any) -> bool:
    """Whether B < 0 is proved on a strictly convex arc for the member Q; False if that is open.

    Args:
        coefficients: (ball, order) → the Taylor coefficients of both coordinates there.
        low: the arc's beginning.
        high: its end.
        q: Q of the member, positive.
        turned: how far the arc turns, a ball (`osculant.cas.geometry.convex_arcs.turning`).

    >>> from flint import arb
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.geometry.convex_arcs import turning
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> spiral = CurveBalls(parse_tuple("t*cos(t), t*sin(t)")).coefficients
    >>> arcs = [(End(arb(a)), End(arb(b))) for a, b in (("0.6", "2.4"), ("0.2", "3.4"))]
    >>> [hits_first(spiral, *ends, 0.25, turning(spiral, *ends)) for ends in arcs]
    [True, False]
    """
    from flint import arb

    if abs(turned) < arb.pi() / 2:
        return True
    if low.order > 1 or high.order > 1:
        return False
    pencil = _Pencil(coefficients, low, high)
    side = -1 if turned < 0 else 1
    pending, cuts, before = [high.at], 0, low.at
    while pending:
        if side * pencil.across(before.union(pending[-1]), q) < 0:
            before = pending.pop()
            continue
        cuts += 1
        if cuts > CUTS:
            return False
        pending.append(((before + pending[-1]) / 2).mid())
    return True


class _Pencil:
    """The three lines of an arc's pencil, in the plane as it is."""

    def __init__(self, coefficients: Coefficients, low: End, high: End) -> None:
        self.coefficients = coefficients
        self.start, self.end = (_point(coefficients, end.at) for end in (low, high))
        self.first, self.last = (
            _unit(tangent(coefficients, low, 1)),
            _unit(tangent(coefficients, high, -1)),
        )
        self.chord = _unit((self.end[0] - self.start[0], self.end[1] - self.start[1]))

    def across(self, t: Any, q: float) -> Any:
        """The derivative of F along the left normal on a ball, times half the speed."""
        x, y = self.coefficients(t, 1)
        here = (x[0] - self.start[0], y[0] - self.start[1])
        there = (x[0] - self.end[0], y[0] - self.end[1])
        motion = (x[1], y[1])
        l0, l1, l2 = bracket(self.first, here), bracket(self.chord, here), bracket(self.last, there)
        along = dot(self.first, motion) * l2 + dot(self.last, motion) * l0
        return l1 * dot(self.chord, motion) - 2 * q * along


def _point(coefficients: Coefficients, t: Any) -> Vector:
    x, y = coefficients(t, 0)
    return x[0], y[0]


def _unit(v: Vector) -> Vector:
    length = dot(v, v).sqrt()
    return v[0] / length, v[1] / length
