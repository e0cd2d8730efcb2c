"""How far an arc of a curve is from one of a conic or a cubic, enclosed from both sides in ball arithmetic.

A continuous map v of the curve's parameters onto [0, 1] makes sup |α(u) − X(v(u))| an upper bound of the
Hausdorff distance: every point of either has one of the other so near. Any such map will do, so floats may
choose it: on each part of the interval v is the polynomial through feet of perpendiculars at Chebyshev nodes,
its ends pinned to numbers that adjoining parts share (where rounding takes it out of [0, 1], it stops at 0 or
1). With α = its Taylor polynomial plus a remainder, the squared distance is a quotient of polynomials in
s ∈ [−1, 1], and `enclosures.supremum` bounds it. Parts whose bound is not good enough are halved. From below:
the distance of one point of the curve from the whole conic arc.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import count
from typing import Any

from flint import arb, arb_poly, ctx

from osculant.cas.geometry.conic_arcs import ConicArc, Pair
from osculant.cas.geometry.cubic_arcs import CubicArc
from osculant.cas.numbers.balls import ball
from osculant.cas.numbers.enclosures import shortened, supremum

#: terms of Taylor polynomials, and the degree of maps between curve and conic
ORDER, DEGREE = 14, 12
#: parts of an interval looked at before the bound is taken as it is
PARTS = 400
#: the least part, in parts of the whole, as a power of two; and of those where feet jump, which gain little
SMALLEST, SMALL = 30, 20
#: how near to a value attained a bound should come, relatively: usually, and where the tolerance is as near
CLOSE, CLOSEST = 1e-6, 1e-11
#: bounds below this part of the conic arc's size, or of the tolerance, are good enough
ROUNDING, NEGLIGIBLE = 2.0**-46, 1e-9
#: how fast a map may run backwards, by rounding
BACKWARDS = 1e-10
#: steps of a search for a parameter, and the relative change that ends it
STEPS, SETTLED = 60, 1e-15

#: (ball, order) → Taylor coefficients 0…order of x and y at all points of the ball
Coefficients = Callable[[Any, int], Sequence[Sequence[Any]]]
#: the arcs that curves are compared with
PlaneArc = ConicArc | CubicArc


@dataclass(frozen=True)
class Distance:
    """An enclosure of the Hausdorff distance.

    No two points that the map joins are farther apart than ``upper``. The curve's point at the parameter
    ``at`` is at least ``lower`` away from every point of the conic arc. ``worst`` is the part of the interval
    with the largest upper bound.
    """

    lower: Any
    upper: Any
    at: Any
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
    >>> circle = CurveBalls(parse_tuple("cos(t), sin(t)"))
    >>> chord = ConicArc((-1.0, 0.0), (0.0, 0.0), (1.0, 0.0), 1.0)
    >>> found = distance(circle.coefficients, arb.pi(), 2 * arb.pi(), chord)
    >>> abs(found.lower - 1) < 1e-5, abs(found.upper - 1) < 1e-5
    (True, True)
    """
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
        part = _Part(curve, begin, end, first, last, arc, lambda attained: goal(peak.max(attained)))
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
    top, worst = highest(), heap[0][2]
    below = from_point(curve, top.at, arc, top.foot)
    return Distance(below, upper.sqrt().upper(), top.at, ball(worst.begin, worst.end))


def from_point(curve: Coefficients, at: Any, arc: PlaneArc, foot: float = 0.5) -> Any:
    """A lower bound of the distance of the curve's point at ``at`` from an arc.

    Args:
        curve: its Taylor coefficients.
        at: a ball around the parameter.
        arc: the arc of a conic or a cubic.
        foot: about where the nearest point of the arc is.

    >>> from osculant.cas.jets.balls import CurveBalls
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> unit = CurveBalls(parse_tuple("t, 1")).coefficients
    >>> from_point(unit, arb(0), ConicArc((-1.0, 0.0), (0.0, 0.0), (1.0, 0.0), 1.0)) > 1 - 1e-5
    True
    """
    point = [row[0] - p for row, p in zip(curve(at, 0), arc.start)]
    square, total = _squared(arc, arb_poly([0, 1]), [[c] for c in point])
    near, reach = arb(foot), arb(min(foot, 1 - foot, 1 / 16))
    # a box around the foot, where the distance is flat, and what is on both sides of it
    sides = (near - reach) / 2, (1 - near - reach) / 2
    boxes = [(near, reach), (sides[0], sides[0]), (1 - sides[1], sides[1])]
    below = supremum(-square, total, lambda attained: attained * (1 - 2 * arb(CLOSE)), boxes)
    return (-below.upper).lower().max(arb(0)).sqrt().lower() if below.upper.is_finite() else arb(0)


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
        begin: Any,
        end: Any,
        first: float,
        last: float,
        arc: PlaneArc,
        goal: Callable[[Any], Any],
    ) -> None:
        self.begin, self.end, self.first, self.last = begin, end, first, last
        self.middle = (begin + end) / 2
        self.upper, self.peak, self.at, self.foot = arb.pos_inf(), arb(0), begin, first
        self.jumps = False
        half = (end - begin) / 2
        local = _local(curve, self.middle, ball(begin, end), half, arc)
        if local is None:
            self.between = _nearest(curve, self.middle, arc, first, last)[0]
            return
        feet = _feet(local, arc, first, last)
        self.between = feet[DEGREE // 2]
        v = sum((basis * arb(foot) for basis, foot in zip(_basis(DEGREE, ctx.prec), feet)), arb_poly([]))
        fall = supremum(-v.derivative(), arb_poly([1]), lambda _: arb(1e-18)).upper
        if not fall < BACKWARDS:  # feet jump, or the series is not good yet: an affine map
            self.jumps = True
            v, fall = arb_poly([(arb(last) + first) / 2, (arb(last) - first) / 2]), arb(0)
        square, total = _squared(arc, v, local)
        found = supremum(square, total, goal)
        self.upper, self.at = found.upper, self.middle + half * found.at
        self.foot, self.peak = _nearest(curve, self.at, arc, first, last)
        beyond = (2 * fall - min(first, 1 - last)).upper()  # so far v may leave [0, 1], over a way of 2
        if beyond > 0:
            self.upper = (self.upper.max(arb(0)).sqrt() + arc.near_ends(beyond)) ** 2
        if not self.upper.is_finite():
            self.upper = arb.pos_inf()


def _local(curve: Coefficients, at: Any, over: Any, half: Any, arc: PlaneArc) -> list[list[Any]] | None:
    """The curve less P₀ as polynomials in s, the last coefficients being balls that cover the remainder."""
    centred, whole = curve(at, ORDER), curve(over, ORDER)
    rows = [[*near[:-1], far[-1]] for near, far in zip(centred, whole)]
    if not all(c.is_finite() for row in rows for c in row):
        return None
    powers = [arb(1)]
    for _ in range(ORDER):
        powers.append(powers[-1] * half)
    return [[row[0] - p, *(c * h for c, h in zip(row[1:], powers[1:]))] for row, p in zip(rows, arc.start)]


def _squared(arc: PlaneArc, v: Any, point: Sequence[Any]) -> tuple[Any, Any]:
    """Numerator and denominator of |α − X(v)|², α − P₀ and v being polynomials; not of high degrees."""
    x, y, total = arc.off(v, (arb_poly(point[0]), arb_poly(point[1])))
    x, y = (arb_poly(shortened(p.coeffs(), ORDER + 2)) for p in (x, y))
    return x * x + y * y, total


def _feet(rows: list[list[Any]], arc: PlaneArc, first: float, last: float) -> list[float]:
    """Parameters of the points of the conic arc nearest to the curve at the nodes, both ends pinned."""
    x, y = ([float(c) for c in row] for row in rows)
    inner = _nodes(DEGREE)[1:-1]
    return [first, *(arc.foot((_horner(x, s), _horner(y, s)), first, last) for s in inner), last]


def _nearest(curve: Coefficients, at: Any, arc: PlaneArc, first: float, last: float) -> tuple[float, Any]:
    """About where on part of the conic arc the nearest point to the curve's is, and the squared distance."""
    x, y = (row[0] - p for row, p in zip(curve(at, 0), arc.start))
    foot = arc.foot((float(x), float(y)), first, last)
    square, total = _squared(arc, arb_poly([foot]), ([x], [y]))
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
