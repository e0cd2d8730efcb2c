"""The two-sided Hausdorff distance of an arc and a bihelix that are far apart for their size.

Where the feet of the curve's points do not move along the bihelix in order, both one-sided distances are
searched: samples of both, the nearest point of each by Newton's method from the nearest sample, and the
largest of these distances by golden section about each sample where a larger one is possible.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.bihelices.family import Bihelix
from osculant.kernels.bihelices.foot import foot
from osculant.kernels.bihelices.helix import point_at
from osculant.kernels.bracket import safeguarded
from osculant.kernels.course import spot, spots
from osculant.kernels.curves.space import Source, sample
from osculant.kernels.curves.vectors import Vector, dot, norm, subtract
from osculant.kernels.jit import kernel

#: samples of the bihelix, an odd number, and of the curve at least, and at most: longer arcs are not measured
POINTS, MOST = 161, 600
#: the samples of a curve that is followed have chords of at least this part of its length
FOLLOWED = 0.98
#: steps to a nearest point of the curve, their relative size that ends them, and golden sections
STEPS, SETTLED, SECTIONS = 40, 1e-10, 44
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
#: the curve, or the bihelix, as the one whose points are measured from the other
CURVE, BIHELIX = 0, 1


@kernel
def at(source: Source, two: Bihelix, which: int, x: float) -> Vector:
    """A point of the curve at the parameter x, or of the bihelix at the arc length x."""
    if which == CURVE:
        return sample(source, x).point
    first = two.left.length
    return point_at(two.left, x) if x <= first else point_at(two.right, x - first)


@kernel
def closest(rows: np.ndarray[Any, Any], p: Vector) -> int:
    """The row (place, x, y, z) of the sample nearest to p."""
    least, found = math.inf, 0
    for i in range(rows.shape[0]):
        x, y, z = rows[i, 1] - p[0], rows[i, 2] - p[1], rows[i, 3] - p[2]
        square = x * x + y * y + z * z
        if square < least:
            least, found = square, i
    return found


@kernel
def to_bihelix(two: Bihelix, rows: np.ndarray[Any, Any], p: Vector) -> float:
    """The distance of p from the bihelix, from its samples."""
    i = closest(rows, p)
    low, high = rows[max(0, i - 1), 0], rows[min(rows.shape[0] - 1, i + 1), 0]
    first = two.left.length
    least = math.inf
    if low < first:
        least = norm(foot(two.left, p, min(rows[i, 0], first), low, min(high, first))[1])
    if high > first:
        s = max(rows[i, 0], first) - first
        least = min(least, norm(foot(two.right, p, s, max(low, first) - first, high - first)[1]))
    return least


@kernel
def to_curve(source: Source, rows: np.ndarray[Any, Any], p: Vector) -> float:
    """The distance of p from the curve, from its samples."""
    i = closest(rows, p)
    t, low, high = rows[i, 0], rows[max(0, i - 1), 0], rows[min(rows.shape[0] - 1, i + 1), 0]
    width = high - low
    least = math.inf
    for _ in range(STEPS):
        x, v, acceleration = sample(source, t)
        away = subtract(p, x)
        least = min(least, norm(away))
        fall = dot(away, v)
        bend = dot(v, v) - dot(away, acceleration)
        before = t
        t, low, high = safeguarded(t, fall / bend if bend > 0.0 else math.nan, not fall > 0.0, low, high)
        step = t - before
        if abs(step) <= SETTLED * width:
            break
    return min(least, norm(subtract(p, sample(source, t).point)))


@kernel
def distance(source: Source, two: Bihelix, which: int, other: np.ndarray[Any, Any], x: float) -> float:
    """The distance of a point of one of the two, at x, from the other, whose samples are given."""
    p = at(source, two, which, x)
    return to_bihelix(two, other, p) if which == CURVE else to_curve(source, other, p)


@kernel
def one_sided(
    source: Source, two: Bihelix, which: int, own: np.ndarray[Any, Any], other: np.ndarray[Any, Any],
    top: float,
) -> float:  # fmt: skip
    """The larger of ``top`` and the largest distance of points of one of the two from the other."""
    count = own.shape[0]
    for i in range(count):
        own[i, 4] = distance(source, two, which, other, own[i, 0])
        top = max(top, own[i, 4])
    for i in range(count):
        before, after = max(0, i - 1), min(count - 1, i + 1)
        if own[i, 4] < own[before, 4] or own[i, 4] < own[after, 4]:
            continue
        reach = 0.0
        for j in (before, after):
            d = (own[i, 1] - own[j, 1], own[i, 2] - own[j, 2], own[i, 3] - own[j, 3])
            reach = max(reach, norm(d))
        if own[i, 4] + reach <= top:  # distances change no faster than the point moves
            continue
        low, high = own[before, 0], own[after, 0]
        x, y = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_x, at_y = distance(source, two, which, other, x), distance(source, two, which, other, y)
        for _ in range(SECTIONS):
            if at_x > at_y:
                high, y, at_y = y, x, at_x
                x = high - GOLDEN * (high - low)
                at_x = distance(source, two, which, other, x)
            else:
                low, x, at_x = x, y, at_y
                y = low + GOLDEN * (high - low)
                at_y = distance(source, two, which, other, y)
        top = max(top, at_x, at_y)
    return top


@kernel
def two_sided(source: Source, a: float, b: float, sigma: float, two: Bihelix) -> float:
    """The Hausdorff distance between the curve over [a, b], of length σ, and a bihelix.

    Infinite if the samples do not follow the curve, or if it takes more than `MOST` to see what the course
    tells of it.  An estimate as far as they see each peak.
    """
    at_spots = spots(source.course, a, b, POINTS - 2)
    count = at_spots.steps + 1
    if count > MOST:
        return math.inf
    curve, helices = np.empty((MOST, 5))[:count], np.empty((POINTS, 5))
    half, first, second = POINTS // 2, two.left.length, two.right.length
    chords = 0.0
    for i in range(POINTS):
        helices[i, 0] = first * i / half if i <= half else first + second * (i - half) / half
        write_point(source, two, BIHELIX, helices[i])
    for i in range(count):
        curve[i, 0] = spot(source.course, at_spots, i)
        write_point(source, two, CURVE, curve[i])
        if i > 0:
            p, q = curve[i], curve[i - 1]
            chords += norm((p[1] - q[1], p[2] - q[2], p[3] - q[3]))
    if not chords >= FOLLOWED * sigma:
        return math.inf
    top = one_sided(source, two, CURVE, curve, helices, 0.0)
    return one_sided(source, two, BIHELIX, helices, curve, top)


@kernel
def write_point(source: Source, two: Bihelix, which: int, row: np.ndarray[Any, Any]) -> None:
    """Write the point at the place of a row into it."""
    p = at(source, two, which, row[0])
    row[1], row[2], row[3] = p[0], p[1], p[2]
