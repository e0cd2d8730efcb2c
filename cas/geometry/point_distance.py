"""How far at least a point of a curve is from an arc of a conic or a cubic, or one of the arc from the curve.

The arc is a rational curve, and the curve a Taylor polynomial with a remainder; so a squared distance is a
quotient of polynomials in s ∈ [−1, 1], and `osculant.cas.numbers.enclosures.supremum` finds its bounds.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Sequence
from itertools import count
from typing import Any

from flint import arb, arb_poly

from osculant.cas.geometry.conic_arcs import ConicArc
from osculant.cas.geometry.cubic_arcs import CubicArc
from osculant.cas.numbers.balls import ball
from osculant.cas.numbers.enclosures import shortened, supremum

#: terms of Taylor polynomials
ORDER = 14
#: how near to a value attained a bound should come, relatively
CLOSE = 1e-6
#: halvings of a curve's interval, after which the bound is taken as it is
HALVINGS = 200

#: (ball, order) → Taylor coefficients 0…order of x and y at all points of the ball
Coefficients = Callable[[Any, int], Sequence[Sequence[Any]]]
#: the arcs that curves are compared with
PlaneArc = ConicArc | CubicArc


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
    square, total = squared(arc, arb_poly([0, 1]), [[c] for c in point])
    near, reach = arb(foot), arb(min(foot, 1 - foot, 1 / 16))
    # a box around the foot, where the distance is flat, and what is on both sides of it
    sides = (near - reach) / 2, (1 - near - reach) / 2
    boxes = [(near, reach), (sides[0], sides[0]), (1 - sides[1], sides[1])]
    below = supremum(-square, total, lambda attained: attained * (1 - 2 * arb(CLOSE)), boxes)
    return (-below.upper).lower().max(arb(0)).sqrt().lower() if below.upper.is_finite() else arb(0)


def from_arc(curve: Coefficients, low: Any, high: Any, arc: PlaneArc, foot: float) -> Any:
    """A lower bound of the distance of an arc's point from the curve between two parameters.

    Args:
        curve: its Taylor coefficients.
        low: a ball around the beginning of its interval.
        high: likewise its end.
        arc: the arc of a conic or a cubic.
        foot: the parameter of its point, exactly.

    >>> from osculant.cas.jets.balls import CurveBalls
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> unit = CurveBalls(parse_tuple("t, 1")).coefficients
    >>> from_arc(unit, arb(-1), arb(1), ConicArc((-1.0, 0.0), (0.0, 0.0), (1.0, 0.0), 1.0), 0.5) > 1 - 1e-5
    True
    """
    x, y, total = arc.off(arb_poly([foot]), (arb_poly([0]), arb_poly([0])))
    order = count()
    heap: list[tuple[float, int, Any, tuple[Any, Any]]] = []
    attained = arb.neg_inf()

    def look(begin: Any, end: Any) -> None:
        nonlocal attained
        half, upper = (end - begin) / 2, arb.pos_inf()
        local = local_series(curve, (begin + end) / 2, ball(begin, end), half, arc)
        if local is not None:
            across = [arb_poly(row) + c[0] / total[0].sqrt() for row, c in zip(local, (x, y))]
            found = supremum(-sum((c * c for c in across), arb_poly([])), arb_poly([1]), goal)
            upper, attained = found.upper, attained.max(found.attained)
        heapq.heappush(
            heap, (-float(upper) if upper.is_finite() else -math.inf, next(order), upper, (begin, end))
        )

    def goal(value: Any) -> Any:
        return attained.max(value) * (1 - 2 * arb(CLOSE))

    look(low, high)
    for _ in range(HALVINGS):
        if heap[0][2] <= goal(attained):
            break
        begin, end = heapq.heappop(heap)[3]
        middle = (begin + end) / 2
        look(begin, middle)
        look(middle, end)
    upper = heap[0][2]
    for _, _, other, _ in heap:  # the keys are rounded
        upper = upper.max(other)
    return (-upper).lower().max(arb(0)).sqrt().lower() if upper.is_finite() else arb(0)


def local_series(curve: Coefficients, at: Any, over: Any, half: Any, arc: PlaneArc) -> list[list[Any]] | None:
    """The curve less P₀ as polynomials in s, the last coefficients being balls that cover the remainder."""
    centred, whole = curve(at, ORDER), curve(over, ORDER)
    rows = [[*near[:-1], far[-1]] for near, far in zip(centred, whole)]
    if not all(c.is_finite() for row in rows for c in row):
        return None
    powers = [arb(1)]
    for _ in range(ORDER):
        powers.append(powers[-1] * half)
    return [[row[0] - p, *(c * h for c, h in zip(row[1:], powers[1:]))] for row, p in zip(rows, arc.start)]


def squared(arc: PlaneArc, v: Any, point: Sequence[Any]) -> tuple[Any, Any]:
    """Numerator and denominator of |α − X(v)|², α − P₀ and v being polynomials; not of high degrees."""
    x, y, total = arc.off(v, (arb_poly(point[0]), arb_poly(point[1])))
    x, y = (arb_poly(shortened(p.coeffs(), ORDER + 2)) for p in (x, y))
    return x * x + y * y, total
