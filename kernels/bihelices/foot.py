"""The point of a helix, circle or line nearest to a given point: safeguarded Newton foot points.

A foot x = α(s) of p is a zero of ⟨α(s) − p, T(s)⟩.  Its derivative is 1 − ⟨p − α, κN⟩, positive just where
the squared distance is convex, so at the nearest point.  For points of an approximated curve the relative
arc length is a good first value.
"""

from __future__ import annotations

import math

from osculant.kernels.bihelices.helix import Helix, place_at, point_at
from osculant.kernels.curves.vectors import Vector, combine, dot, norm, subtract
from osculant.kernels.jit import kernel

#: steps of one foot point, and the relative change of a foot that ends them
STEPS, SETTLED = 60, 1e-10
#: first steps that stop at an end of the interval
CLAMPED = 2
#: turning between the points of a helix among which the nearest is looked for first
SPACING = 0.25


@kernel
def foot(helix: Helix, p: Vector, s: float, low: float, high: float) -> tuple[float, Vector, Vector, float]:
    """(s, p − α(s), T(s), 1 − ⟨p − α, κN⟩) at a foot of p between two arc lengths, near the first value s.

    Where the distance only grows or only falls between ``low`` and ``high``, that end is taken.  At a foot
    inside, p − α(s) is orthogonal to T to rounding.  The last number is positive unless the distance is
    largest there, not least.

    >>> from osculant.kernels.bihelices.helix import straight
    >>> foot(straight((0., 0., 0.), (1., 0., 0.), 5.), (3., 4., 0.), 1.0, 0.0, 5.0)[:2]
    (3.0, (0.0, 4.0, 0.0))
    """
    point, tangent, bend = place_at(helix, s)
    away = subtract(p, point)
    stiff = 1.0 - dot(away, bend)
    for i in range(STEPS):
        fall = dot(away, tangent)  # minus the derivative of half the squared distance
        if fall > 0.0:
            low = s
        else:
            high = s
        new = s + fall / stiff if stiff > 0.1 else s + fall
        if not (new >= low and new <= high):
            # the end of the arc is tried, and then what is between
            new = min(high, max(low, new)) if i < CLAMPED else 0.5 * (low + high)
        step, s = new - s, new
        point, tangent, bend = place_at(helix, s)
        away = subtract(p, point)
        stiff = 1.0 - dot(away, bend)
        if abs(step) <= SETTLED * helix.length:
            break
    fall = dot(away, tangent)
    if abs(fall) <= 4.0 * SETTLED * helix.length * max(1.0, stiff):  # what the next step would take away
        away = combine(1.0, away, -fall, tangent)
    return s, away, tangent, stiff


@kernel
def nearest(helix: Helix, p: Vector) -> tuple[float, float]:
    """(distance, arc length) of the point of a helix, circle or line nearest to p.

    The nearest of points that turn by `SPACING` at most from one to the next, then Newton's method between
    its neighbours.

    >>> from osculant.kernels.bihelices.helix import short_helix
    >>> half = short_helix((1., 0., 0.), (0., 1., 0.), (-1., 0., 0.), (0., -1., 0.), 1e-12, 0.0)[2]
    >>> [round(x, 9) for x in nearest(half, (0.0, 3.0, 0.0))]
    [2.0, 1.570796327]
    """
    count = 2 + math.ceil(helix.turning / SPACING)
    step = helix.length / count
    least, found = math.inf, 0
    for i in range(count + 1):
        away = subtract(p, point_at(helix, i * step))
        if dot(away, away) < least:
            least, found = dot(away, away), i
    low, high = max(0, found - 1) * step, min(count, found + 1) * step
    s, away, _, _ = foot(helix, p, found * step, low, min(high, helix.length))
    return norm(away), s
