"""Errors of biarcs, measured at the common normals of arc and biarc, and the best biarc of a family.

The distance D of the curve's points from a biarc (`biarc.distance`) has extremes where the curve's normal
passes through the centre of the nearer arc: common normals.  Between samples they are sought by Newton's
method with the exact D″, kept within brackets.
"""

from __future__ import annotations

import math
from typing import Any

from osculant.kernels.biarcs.family import (
    BACKWARDS,
    Biarc,
    distance,
    family,
    is_beside,
    is_proper,
    is_short,
    member,
)
from osculant.kernels.bracket import safeguarded
from osculant.kernels.curves.peaks import DEPTH, Space, cubic_peak
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.jit import kernel

#: neighbouring samples get one between them if their tangents differ by more than this angle, or by more than
#: this part of the arc's turning if that can be told from rounding, or if they lie apart by more than this
#: part of the arc's length
LARGEST_TURN, LARGEST_PART, TOLD, LARGEST_STEP = 0.35, 0.3, 1e-10, 0.3
#: visits of one extreme at most, and the relative correction of its height that ends them
VISITS, SETTLED = 24, 1e-7
#: rounds of the search for μ, and what ends it: the sum of the peaks, in parts of them, or the bracket
ROUNDS, BALANCED, NARROW = 80, 1e-12, 2.0**-50
#: where no μ makes the peaks equal, the best is taken of those this far from 0 and 1: shorter arcs are no use
LOPSIDED = 0.02
#: units of the coordinates' noise by which a foot may miss the biarc
SLACK = 64.0


@kernel
def look(
    arcs: Biarc, source: Source, a: float, b: float, points: int,
    space: Space,
) -> int:  # fmt: skip
    """Samples of the arc at ``points`` equidistant inner points, and between where much happens.

    Fills rows (x, y, tangent, speed, curvature, t) in the order of the curve and returns how many; −1 if the
    arc turns by more than π, or if the capacity does not suffice.
    """
    rows, pending = space[0], space[1][:, 0]
    last_cosine = arcs.tx0 * arcs.tx2 + arcs.ty0 * arcs.ty2
    last_sine = arcs.tx0 * arcs.ty2 - arcs.ty0 * arcs.tx2
    largest = math.sin(LARGEST_TURN)
    if last_cosine > 0.0 and last_sine > 0.0:
        largest = min(largest, max(TOLD, LARGEST_PART * last_sine))
    # a convex arc that turns by ω is no longer than its chord over cos(ω/2)
    chord = (arcs.x2 - arcs.x0) ** 2 + (arcs.y2 - arcs.y0) ** 2
    farthest = LARGEST_STEP * LARGEST_STEP * chord * 2.0 / max(1e-6, 1.0 + last_cosine)
    count, before = 0, a
    x, y, sx, sy = arcs.x0, arcs.y0, arcs.tx0, arcs.ty0
    for i in range(1, points + 2):
        pending[0] = b if i == points + 1 else a + (b - a) * i / (points + 1)
        open_ends = 1
        while open_ends > 0:
            t = pending[open_ends - 1]
            if t == b:
                px, py, tx, ty, speed, curvature = arcs.x2, arcs.y2, arcs.tx2, arcs.ty2, 0.0, 0.0
            else:
                if count == rows.shape[0]:
                    return -1
                px, py, tx, ty, speed, curvature = sample(source, t)
            turns, along = sx * ty - sy * tx, sx * tx + sy * ty
            step = (px - x) ** 2 + (py - y) ** 2
            if (turns > largest or along < 0.0 or step > farthest) and open_ends < DEPTH:
                pending[open_ends] = 0.5 * (before + t)
                open_ends += 1
                continue
            if arcs.tx0 * ty - arcs.ty0 * tx < -BACKWARDS:
                return -1
            if t != b:
                row = rows[count]
                row[0], row[1], row[2], row[3], row[4], row[5], row[6] = px, py, tx, ty, speed, curvature, t
                count += 1
            before, x, y, sx, sy = t, px, py, tx, ty
            open_ends -= 1
    return count


@kernel
def extreme(
    arcs: Biarc, source: Source, t0: float, t1: float, rising: bool,
    u: float,
) -> float:  # fmt: skip
    """D at its extreme in (t0, t1), a maximum if ``rising``, from the guess t0 + u(t1 − t0)."""
    t, d = t0 + u * (t1 - t0), math.nan
    for _ in range(VISITS):
        x, y, sx, sy, speed, curvature = sample(source, t)
        d, slope, second = distance(arcs, x, y, sx, sy, curvature)
        bends = second < 0.0 if rising else second > 0.0
        if bends:
            gain = -0.5 * slope * slope / second
            if abs(gain) <= SETTLED * abs(d):
                return d + gain
        step = -slope / (second * speed) if bends else math.nan
        t, t0, t1 = safeguarded(t, step, (slope > 0.0) != rising, t0, t1)
    return d


@kernel
def extremes(
    arcs: Biarc, source: Source, a: float, b: float, space: Space, count: int
) -> tuple[float, float]:
    """(max D, min D) over the arc seen in ``space``; at the ends D = D′ = 0."""
    top, bottom = 0.0, 0.0
    t0, d0, s0 = a, 0.0, 0.0
    for i in range(count + 1):
        t1, d1, s1 = b, 0.0, 0.0
        if i < count:
            row = space[0][i]
            t1 = row[6]
            d1, slope, _ = distance(arcs, row[0], row[1], row[2], row[3], row[5])
            s1 = slope * row[4]
            top, bottom = max(top, d1), min(bottom, d1)
        if i == 0:
            inside, rising = s1 * d1 < 0.0, d1 > 0.0
        elif i == count:
            inside, rising = s0 * d0 > 0.0, d0 > 0.0
        else:
            inside, rising = s0 * s1 < 0.0, s0 > 0.0
        if inside:
            u, _ = cubic_peak(d0, s0 * (t1 - t0), d1, s1 * (t1 - t0))
            d = extreme(arcs, source, t0, t1, rising, u)
            top, bottom = max(top, d), min(bottom, d)
        t0, d0, s0 = t1, d1, s1
    return top, bottom


@kernel
def is_along(arcs: Biarc, source: Source, space: Space, count: int) -> bool:
    """Whether both arcs turn by less than π and all points seen in ``space`` are beside the biarc."""
    rows, slack = space[0], SLACK * source.place.noise
    along = is_short(arcs)
    for i in range(count):
        along = along and is_beside(arcs, rows[i, 0], rows[i, 1], slack)
    return along


@kernel
def attained(arcs: Biarc, source: Source, a: float, b: float, space: Space, count: int) -> float:
    """max |D| over the arc seen in ``space``; infinite where the nearest point of a circle is off its arc.

    So it is, too, if an arc turns by π or more.
    """
    if not is_along(arcs, source, space, count):
        return math.inf
    top, bottom = extremes(arcs, source, a, b, space, count)
    error = max(top, -bottom)
    return error if math.isfinite(error) else math.inf


@kernel
def measure(
    arcs: Biarc, source: Source, a: float, b: float, points: int,
    space: Space,
) -> float:  # fmt: skip
    """The Hausdorff distance of the arc [a, b] and a biarc between its end frames.

    From ``points`` samples or more: an estimate as far as the extremes between the samples have been found.
    Infinite if the arc turns by more than π, or is not beside the biarc everywhere.
    """
    count = look(arcs, source, a, b, points, space)
    return math.inf if count < 0 else attained(arcs, source, a, b, space, count)


@kernel
def best(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(error, μ) of the biarc with max D = −min D over [a, b]; error infinite if there is none.

    Of a spiral arc the members lie side by side: max D and min D move in one direction with μ, so false
    position with bisection finds the best.  Across a vertex they need not: then it is the best one seen.
    """
    fam = family(start, end)
    if not is_proper(fam):
        return math.inf, math.nan
    count = look(member(fam, 0.5), source, a, b, points, space)
    if count < 0:
        return math.inf, math.nan
    upward = fam.omega < 2.0 * fam.alpha  # κ decreases, and D increases with μ
    low, high = 0.0, 1.0
    excess_low, excess_high = math.nan, math.nan
    kept, least = 0.5, math.inf
    for step in range(ROUNDS):
        mu = 0.5 * (low + high)
        if step % 3 and math.isfinite(excess_low) and math.isfinite(excess_high):
            mu = (low * excess_high - high * excess_low) / (excess_high - excess_low)
        top, bottom = extremes(member(fam, mu), source, a, b, space, count)
        excess, size = top + bottom, max(top, -bottom)
        if size < least and LOPSIDED < mu < 1.0 - LOPSIDED:
            kept, least = mu, size
        if abs(excess) <= BALANCED * size:
            kept = mu
            break
        if high - low <= NARROW:
            if size < least and math.isfinite(excess_low) and math.isfinite(excess_high):
                kept = mu  # equal as far as doubles near 1 can tell
            break
        if step == 0 and size <= source.place.noise:
            break  # rounding says nothing about μ
        if (excess > 0.0) == upward:
            high, excess_high = mu, excess
        else:
            low, excess_low = mu, excess
    error = attained(member(fam, kept), source, a, b, space, count)
    if math.isinf(error):
        kept = 0.5
        error = attained(member(fam, kept), source, a, b, space, count)
    return error, kept


@kernel
def confirm(
    fit: Any,
    mu: float,
    source: Source,
    a: float,
    start: Frame,
    b: float,
    end: Frame,
    points: int,
    space: Space,
) -> tuple[float, float]:
    """(error, μ) of the member μ, measured from ``points`` samples or more."""
    return measure(member(family(start, end), mu), source, a, b, points, space), mu
