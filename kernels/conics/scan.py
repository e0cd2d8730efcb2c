"""Errors of one member of a pencil, measured over samples of the whole arc.

`measure` finds the peaks of the displacement, at the common normals of arc and conic.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.conics.pencil import Pencil, View, displacement, pencil, through, view, within_noise
from osculant.kernels.curves.peaks import DEPTH, MARGIN, ROW_SIZE, Space, cubic_peak
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.jit import kernel

#: neighbouring samples whose tangents differ by more than this angle, or by more than this part of the arc's
#: whole turning if that can be told from rounding, get one between them …
LARGEST_TURN, LARGEST_PART, TOLD = 0.35, 0.3, 1e-10
#: … and so do those at whose feet conic and curve differ by angles further apart (tangent of the angle)
LARGEST_LEAN = 0.5
#: intervals are cut in two at most this often in all between two samples
CUTS = 100
#: visits of one peak at most, and the relative correction of its height that ends them
VISITS, SETTLED = 8, 1e-7


@kernel
def look(
    pen: Pencil, source: Source, a: float, b: float, points: int,
    space: Space,
) -> int:  # fmt: skip
    """Views of the arc at ``points`` equidistant inner points, and between where the curve turns a lot.

    Fills the rows of ``space`` in the order of the curve and returns how many; −1 if the capacity
    does not suffice.
    """
    count = 0
    cosine, sine = 1.0, 0.0  # of the angle from T₀ to the tangent of the last row
    last_cosine, last_sine = pen.tx0 * pen.tx2 + pen.ty0 * pen.ty2, pen.sin_psi
    largest = math.sin(LARGEST_TURN)
    if last_cosine > 0.0 and last_sine > 0.0:
        largest = min(largest, max(TOLD, LARGEST_PART * last_sine))
    before = a
    rows, pending = space[0], space[1][:, 0]
    for i in range(1, points + 2):
        pending[0] = b if i == points + 1 else a + (b - a) * i / (points + 1)
        open_ends = 1
        while open_ends > 0:
            t = pending[open_ends - 1]
            if t == b:
                cosine_here, sine_here = last_cosine, last_sine
            else:
                if count == rows.shape[0]:
                    return -1
                seen = view(pen, source, t)
                cosine_here, sine_here = seen.n2, seen.t2
            turns = cosine * sine_here - sine * cosine_here  # the sine of the angle
            beyond = cosine * cosine_here + sine * sine_here < 0.0
            if (turns > largest or beyond) and open_ends < DEPTH:
                pending[open_ends] = 0.5 * (before + t)
                open_ends += 1
                continue
            if t != b:
                for j, value in enumerate(seen):
                    rows[count, j] = value
                rows[count, ROW_SIZE - 1] = t
                count += 1
            before, cosine, sine = t, cosine_here, sine_here
            open_ends -= 1
    return count


@kernel
def at_row(rows: np.ndarray[Any, Any], i: int) -> View:
    """Row i of ``rows`` as a `View`."""
    v = rows[i]
    return View(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10])


@kernel
def members_through(pen: Pencil, space: Space, count: int) -> tuple[float, float]:
    """(least, greatest) Q of the members through the ``count`` samples; (0, 0) if one has no member.

    So it is, too, if rounding hides them all.
    """
    low, high = math.inf, 0.0
    for i in range(count):
        seen = at_row(space[0], i)
        if within_noise(pen, seen):  # says nothing
            continue
        q = through(seen)
        if math.isnan(q):
            return 0.0, 0.0
        low, high = min(low, q), max(high, q)
    return (low, high) if high > 0.0 else (0.0, 0.0)


@kernel
def height(
    pen: Pencil, q: float, source: Source, low: float, high: float,
    t: float, bend: float,
) -> float:  # fmt: skip
    """The value of d at its peak in [low, high], from the guess t with d″ ≈ bend; NaN if a normal misses."""
    d, before, steepness = math.nan, math.nan, math.nan
    margin = MARGIN * (high - low)  # at an end of the arc the displacement is 0/0
    for _ in range(VISITS):
        d, _, slope = displacement(pen, q, view(pen, source, t))
        if not math.isfinite(d):
            return math.nan
        if t != before and slope != steepness and not math.isnan(before):
            bend = (slope - steepness) / (t - before)
        if not bend * d < 0.0:  # not a peak of |d|: the bracket's samples said more than this
            return d
        gain = -0.5 * slope * slope / bend
        if abs(gain) <= SETTLED * abs(d):
            return d + gain
        before, steepness = t, slope
        t = min(high - margin, max(low + margin, t - slope / bend))
    return d


@kernel
def missed(q: float, seen: View) -> tuple[float, float]:
    """What `extremes` returns where the normal at a point misses the arc of the member Q."""
    return math.nan, q - through(seen)


@kernel
def lean(slope: float, d: float, seen: View) -> float:
    """The tangent of the angle between the curve and the conic at the foot."""
    return slope / (seen.speed * (1.0 - seen.curvature * d))


@kernel
def apart(lean0: float, lean1: float) -> bool:
    """Whether two leans, given by their tangents, differ by more than `LARGEST_LEAN`."""
    return not abs(lean1 - lean0) <= LARGEST_LEAN * (1.0 + lean0 * lean1)


@kernel
def peak_inside(
    pen: Pencil, q: float, source: Source, t0: float, d0: float,
    s0: float, t1: float, d1: float, s1: float,
) -> float:  # fmt: skip
    """d at the peak between two samples (value, slope), 0 if there is none; at ends d = d′ = 0."""
    h = t1 - t0
    grows_in = d0 == 0.0 or s0 * d0 > 0.0  # |d| grows into the interval from the left …
    grows_out = d1 == 0.0 or s1 * d1 < 0.0  # … and from the right
    if not ((grows_in and grows_out) or (d0 * d1 < 0.0 and (grows_in or grows_out))):
        return 0.0
    u, bend = cubic_peak(d0, s0 * h, d1, s1 * h)
    return height(pen, q, source, t0, t1, t0 + u * h, bend / (h * h))


@kernel
def extremes_between(
    pen: Pencil, q: float, source: Source, t0: float, d0: float,
    s0: float, l0: float, t1: float, d1: float, s1: float, l1: float, space: Space,
) -> tuple[float, float]:  # fmt: skip
    """(max d, min d) between two samples that are too far apart to trust: cut until they are not."""
    top, bottom = max(d0, 0.0), min(d0, 0.0)
    pending = space[1]
    pending[0, 0], pending[0, 1], pending[0, 2], pending[0, 3] = t1, d1, s1, l1
    open_ends, cuts = 1, 0
    while open_ends > 0:
        row = pending[open_ends - 1]
        t, d, s, leaning = row[0], row[1], row[2], row[3]
        both = d0 * d < 0.0 and s0 * d0 > 0.0 and s * d < 0.0
        if (both or apart(l0, leaning)) and open_ends < DEPTH and cuts < CUTS:
            cuts += 1
            middle = 0.5 * (t0 + t)
            seen = view(pen, source, middle)
            value, _, slope = displacement(pen, q, seen)
            if not math.isfinite(value):
                return missed(q, seen)
            new = pending[open_ends]
            new[0], new[1], new[2], new[3] = middle, value, slope, lean(slope, value, seen)
            open_ends += 1
            continue
        value = peak_inside(pen, q, source, t0, d0, s0, t, d, s)
        if math.isnan(value):
            return math.nan, -(d0 + d)
        top, bottom = max(top, value, d), min(bottom, value, d)
        t0, d0, s0, l0 = t, d, s, leaning
        open_ends -= 1
    return top, bottom


@kernel
def extremes(
    pen: Pencil, q: float, source: Source, a: float, b: float,
    space: Space, count: int,
) -> tuple[float, float]:  # fmt: skip
    """(max d, min d) of the member Q over the arc seen in ``space``.

    Every interval between neighbouring samples in which |d| must have a peak is searched.  If a normal misses
    the member's arc, max d is NaN, and min d positive if Q is too large there, else negative.
    """
    top, bottom = 0.0, 0.0
    t0, d0, s0, l0 = a, 0.0, 0.0, 0.0
    for i in range(count + 1):
        t1, d1, s1, l1 = b, 0.0, 0.0, 0.0
        if i < count:
            seen = at_row(space[0], i)
            t1 = space[0][i, ROW_SIZE - 1]
            d1, _, s1 = displacement(pen, q, seen)
            if not math.isfinite(d1):
                return missed(q, seen)
            l1 = lean(s1, d1, seen)
            top, bottom = max(top, d1), min(bottom, d1)
        if apart(l0, l1) or (d0 * d1 < 0.0 and s0 * d0 > 0.0 and s1 * d1 < 0.0):
            above, below = extremes_between(pen, q, source, t0, d0, s0, l0, t1, d1, s1, l1, space)
            if math.isnan(above):
                return above, below
            top, bottom = max(top, above), min(bottom, below)
        else:
            value = peak_inside(pen, q, source, t0, d0, s0, t1, d1, s1)
            if math.isnan(value):
                return math.nan, -(d0 + d1)
            top, bottom = max(top, value), min(bottom, value)
        t0, d0, s0, l0 = t1, d1, s1, l1
    return top, bottom


@kernel
def measure(
    pen: Pencil, q: float, source: Source, a: float, b: float,
    points: int, space: Space,
) -> float:  # fmt: skip
    """max |d| of the member Q over [a, b], from ``points`` samples or more; Q = 0 is the chord.

    Infinite if a normal of the curve misses the arc of the member.
    An upper bound of the Hausdorff distance as far as the peaks between the samples have been found:
    an estimate, not a certificate.
    """
    count = look(pen, source, a, b, points, space)
    if count < 0:
        return math.inf
    if q == 0.0:
        farthest = 0.0
        for i in range(count):
            farthest = max(farthest, abs(space[0][i, 1]))  # |l₁|, the distance from the chord
        return farthest
    top, bottom = extremes(pen, q, source, a, b, space, count)
    return math.inf if math.isnan(top) else max(top, -bottom)


@kernel
def confirm(
    fit: Any,
    q: float,
    source: Source,
    a: float,
    start: Frame,
    b: float,
    end: Frame,
    points: int,
    space: Space,
) -> tuple[float, float]:
    """(error, Q) of the member Q, measured from ``points`` samples or more."""
    return measure(pencil(start, end, source.place.noise), q, source, a, b, points, space), q
