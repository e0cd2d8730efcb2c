"""How far an arc of a curve is from one of a conic or a cubic, enclosed from both sides in ball arithmetic.

A continuous map v of the curve's parameters onto [0, 1] makes sup |α(u) − X(v(u))| an upper bound of the
Hausdorff distance: every point of either has one of the other so near. Any such map will do, so floats may
choose it: on each part of the interval v is the polynomial through feet of perpendiculars at Chebyshev nodes,
or, where feet jump, through points on the curve's normals, its ends pinned to numbers that adjoining parts
share (where rounding takes it out of [0, 1], it stops at 0 or 1). With α = its Taylor polynomial plus a
remainder, the squared distance is a quotient of polynomials in s ∈ [−1, 1], and `enclosures.supremum` bounds
it. Parts whose bound is not good enough are halved. From below: `osculant.cas.geometry.point_distance`.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from itertools import count
from typing import Any

from flint import arb, arb_poly, ctx

from osculant.cas.geometry.feet import Moving, Pair, nearest, opposite
from osculant.cas.geometry.point_distance import (
    CLOSE,
    Coefficients,
    PlaneArc,
    from_arc,
    from_point,
    local_series,
    squared,
)
from osculant.cas.numbers.balls import ball
from osculant.cas.numbers.enclosures import supremum

#: the degree of maps between curve and arc
DEGREE = 12
#: parts of an interval looked at before the bound is taken as it is
PARTS = 400
#: the least part, in parts of the whole, as a power of two; and of those where feet jump, which gain little
SMALLEST, SMALL = 30, 20
#: an upper bound so much above the lower one, relatively, is far from it: then other maps are tried
FAR = 1e-3
#: how near to a value attained a bound should come, relatively, where the tolerance is as near
CLOSEST = 1e-11
#: bounds below this part of the conic arc's size, or of the tolerance, are good enough
ROUNDING, NEGLIGIBLE = 2.0**-46, 1e-9
#: how fast a map may run backwards, by rounding
BACKWARDS = 1e-10
#: steps of a search for a parameter, and the relative change that ends it
STEPS, SETTLED = 60, 1e-15

#: (arc, point and tangent of the curve, least and largest parameter) → the parameter of the arc's point there
Choice = Callable[[Moving, Pair, Pair, float, float], float]


@dataclass(frozen=True)
class Distance:
    """An enclosure of the Hausdorff distance.

    Attributes:
        lower: so far at least is the curve's point at ``at`` from every point of the arc, or the arc's point
            at ``foot`` from every one of the curve's: of those the one that tells more.
        upper: no two points that the map joins are farther apart.
        at: a parameter of the curve.
        foot: about the one of the arc that the map joins with it.
        of_curve: whether it is the curve's point that is so far away.
        worst: the part of the curve's interval with the largest upper bound.
    """

    lower: Any
    upper: Any
    at: Any
    foot: float
    of_curve: bool
    worst: Any


def distance(curve: Coefficients, low: Any, high: Any, arc: PlaneArc, tolerance: float = 0.0) -> Distance:
    """Enclose the Hausdorff distance of the curve from ``low`` to ``high`` and an arc.

    Args:
        curve: its Taylor coefficients.
        low: a ball around the beginning of its interval; what holds, holds for all numbers in it.
        high: likewise its end.
        arc: the arc of a conic or a cubic.
        tolerance: bounds are sharpened to show, where they can, that the distance is within it.

    Returns the enclosure; its upper bound is infinite where the curve has no finite series.

    >>> from osculant.cas.jets.balls import CurveBalls
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.geometry.conic_arcs import ConicArc
    >>> circle = CurveBalls(parse_tuple("cos(t), sin(t)"))
    >>> chord = ConicArc((-1.0, 0.0), (0.0, 0.0), (1.0, 0.0), 1.0)
    >>> found = distance(circle.coefficients, arb.pi(), 2 * arb.pi(), chord)
    >>> abs(found.lower - 1) < 1e-5, abs(found.upper - 1) < 1e-5
    (True, True)
    """
    best: Distance | None = None
    for choice in (nearest, opposite):
        found = _mapped(curve, low, high, arc, tolerance, choice)
        if best is None:
            best = found
        else:
            below = found if found.lower > best.lower else best
            least = found if found.upper < best.upper else best
            best = replace(below, upper=least.upper, worst=least.worst)
        if best.upper <= (best.lower * (1 + FAR)).max(arb(tolerance)):
            break
    assert best is not None
    return best


def _mapped(
    curve: Coefficients, low: Any, high: Any, arc: PlaneArc, tolerance: float, choice: Choice
) -> Distance:
    """The enclosure by one kind of maps."""
    order = count()
    heap: list[tuple[float, int, _Part]] = []
    least = arb(max(arc.size * ROUNDING, tolerance * NEGLIGIBLE)) ** 2

    def goal(attained: Any) -> Any:
        near, nearest = (attained * (1 + 2 * arb(step)) + least for step in (CLOSE, CLOSEST))
        return nearest.max(arb(tolerance) ** 2).min(near)

    def highest() -> _Part:
        return max((part for _, _, part in heap), key=lambda part: part.peak)

    def look(begin: Any, end: Any, first: float, last: float) -> None:
        peak = highest().peak if heap else arb(0)
        ends = (begin, end), (first, last)
        part = _Part(curve, *ends, arc, choice, lambda attained: goal(peak.max(attained)))
        heapq.heappush(heap, (-float(part.upper) if part.upper.is_finite() else -math.inf, next(order), part))

    look(low, high, 0.0, 1.0)
    for _ in range(PARTS):
        worst = heap[0][2]
        narrow = (high - low) * arb(2) ** -(SMALL if worst.jumps else SMALLEST)
        if worst.upper <= goal(highest().peak) or not worst.end - worst.begin > narrow:
            break
        heapq.heappop(heap)
        look(worst.begin, worst.middle, worst.first, worst.between)
        look(worst.middle, worst.end, worst.between, worst.last)
    upper = arb(0)
    for _, _, part in heap:
        upper = upper.max(part.upper)
    upper = upper.sqrt().upper()
    top, worst = highest(), heap[0][2]
    below, of_curve = from_point(curve, top.at, arc, top.foot), True
    if not upper <= below * (1 + FAR):
        other = from_arc(curve, low, high, arc, top.foot)
        below, of_curve = (other, False) if other > below else (below, True)
    return Distance(below, upper, top.at, top.foot, of_curve, ball(worst.begin, worst.end))


def parting(curve: Coefficients, low: Any, high: Any, guess: float, point: Pair, tangent: Pair) -> Any:
    """About where the curve crosses the normal of a direction at a point: an exact number inside.

    The search begins at ``guess``. If there is no crossing the number is any one inside.
    """
    a, b = float(low), float(high)
    u = guess
    for _ in range(STEPS):
        rows = curve(arb(u), 1)
        ahead = sum(float(row[0] - p) * t for row, p, t in zip(rows, point, tangent))
        speed = sum(float(row[1]) * t for row, t in zip(rows, tangent))
        a, b = (a, u) if ahead > 0 else (u, b)
        new = u - ahead / speed if speed > 0 else (a + b) / 2
        if abs(new - u) <= SETTLED * abs(u):
            break
        if not a < new < b:
            new = (a + b) / 2
        if not a < new < b:
            break
        u = new
    return arb(u)


class _Part:
    """The curve on one part of the interval, its map to the conic arc, and the bound there."""

    def __init__(
        self,
        curve: Coefficients,
        ends: tuple[Any, Any],
        arc_ends: tuple[float, float],
        arc: PlaneArc,
        choice: Choice,
        goal: Callable[[Any], Any],
    ) -> None:
        (begin, end), (first, last) = ends, arc_ends
        self.begin, self.end, self.first, self.last = begin, end, first, last
        self.middle = (begin + end) / 2
        self.upper, self.peak, self.at, self.foot = arb.pos_inf(), arb(0), begin, first
        self.jumps = False
        half = (end - begin) / 2
        local = local_series(curve, self.middle, ball(begin, end), half, arc)
        if local is None:
            self.between = _joined(curve, self.middle, arc, choice, first, last)[0]
            return
        feet = _feet(local, arc, choice, first, last)
        self.between = feet[DEGREE // 2]
        v = sum((basis * arb(foot) for basis, foot in zip(_basis(DEGREE, ctx.prec), feet)), arb_poly([]))
        fall = supremum(-v.derivative(), arb_poly([1]), lambda _: arb(1e-18)).upper
        if not fall < BACKWARDS:  # feet jump, or the series is not good yet: an affine map
            self.jumps = True
            v, fall = arb_poly([(arb(last) + first) / 2, (arb(last) - first) / 2]), arb(0)
        square, total = squared(arc, v, local)
        found = supremum(square, total, goal)
        self.upper, self.at = found.upper, self.middle + half * found.at
        self.foot, self.peak = _joined(curve, self.at, arc, choice, first, last)
        beyond = (2 * fall - min(first, 1 - last)).upper()  # so far v may leave [0, 1], over a way of 2
        if beyond > 0:
            self.upper = (self.upper.max(arb(0)).sqrt() + arc.near_ends(beyond)) ** 2
        if not self.upper.is_finite():
            self.upper = arb.pos_inf()


def _feet(rows: list[list[Any]], arc: PlaneArc, choice: Choice, first: float, last: float) -> list[float]:
    """Parameters of the arc's points that are chosen for the curve's at the nodes, both ends pinned."""
    x, y = ([float(c) for c in row] for row in rows)
    dx, dy = ([i * c for i, c in enumerate(row)][1:] for row in (x, y))
    feet = [
        choice(arc, (_horner(x, s), _horner(y, s)), (_horner(dx, s), _horner(dy, s)), first, last)
        for s in _nodes(DEGREE)[1:-1]
    ]
    return [first, *feet, last]


def _joined(
    curve: Coefficients, at: Any, arc: PlaneArc, choice: Choice, first: float, last: float
) -> tuple[float, Any]:
    """The parameter of the arc's point that is chosen for the curve's, and their squared distance."""
    rows = curve(at, 1)
    x, y = (row[0] - p for row, p in zip(rows, arc.start))
    dx, dy = (float(row[1]) for row in rows)
    foot = choice(arc, (float(x), float(y)), (dx, dy), first, last)
    square, total = squared(arc, arb_poly([foot]), ([x], [y]))
    apart = (square[0] / total[0]).mid()
    return foot, arb(apart) if apart.is_finite() else arb(0)


@cache
def _nodes(degree: int) -> list[float]:
    """Chebyshev nodes from −1 to 1, rounded; symmetric."""
    return [math.sin(math.pi * (2 * j - degree) / (2 * degree)) for j in range(degree + 1)]


@cache
def _basis(degree: int, bits: int) -> list[Any]:
    """Lagrange's polynomials of the nodes, as balls; ``bits``, the precision, tells apart what is cached."""
    nodes = [arb(s) for s in _nodes(degree)]
    found = []
    for j, node in enumerate(nodes):
        others = nodes[:j] + nodes[j + 1 :]
        product = arb_poly([1])
        for other in others:
            product *= arb_poly([-other, 1]) * (1 / (node - other))
        found.append(product)
    return found


def _horner(row: list[float], s: float) -> float:
    value = 0.0
    for c in reversed(row):
        value = value * s + c
    return value
