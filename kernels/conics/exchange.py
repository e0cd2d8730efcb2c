"""The fast step: the best member of the pencil of one arc from two (or one) curve samples.

A conic's error has two peaks of opposite sign, equal for the minimax conic; a parabola's has one.
The peaks' places and sharpnesses, in units of the arc, change slowly from arc to arc, so the caller
keeps them in a `Peaks` tuple: each call samples the curve at the believed peaks, chooses Q, and moves
the peaks by one Newton step.  Nothing is bracketed here: a result is trusted only if it is
consistent, and `greedy` has `minimax` to fall back on.
"""

from __future__ import annotations

import math

from osculant.kernels.conics.pencil import (
    Pencil,
    View,
    displacement,
    is_proper,
    parabola,
    pencil,
    through,
    view,
    weight,
)
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel
from osculant.kernels.primitives import CONIC as CONIC
from osculant.kernels.primitives import PARABOLA as PARABOLA

#: places and sharpnesses −d″/d of the two peaks (one peak: both the same), in units of the arc
Peaks = tuple[float, float, float, float]

#: Newton steps for Q: it starts within the bracket of the two samples' own members
Q_STEPS = 12
#: a Newton step of Q this small, in parts of its bracket, is the last: d is nearly linear in Q there
Q_ACCURACY = 1e-4
#: a peak moves at most this part of the arc at once, and stays inside these margins
LARGEST_MOVE, MARGIN = 0.1, 0.01
#: believable sharpnesses
FLATTEST, SHARPEST = 4.0, 2000.0
#: moves smaller than this say nothing about the sharpness
TELLING_MOVE = 1e-5


@kernel
def first_peaks(primitive: int) -> Peaks:
    """The peaks of the leading error term of a short arc."""
    if primitive == PARABOLA:
        x, c = generated.PARABOLA_FIRST, generated.PARABOLA_SHARPNESS
        return x, x, c, c
    c = generated.CONIC_SHARPNESS
    return generated.CONIC_FIRST, generated.CONIC_LAST, c, c


@kernel
def peak(d: float, slope: float, sharpness: float) -> float:
    """The extreme value near a sample: that of the parabola with this value, slope and curvature."""
    return d + slope * slope / (2.0 * sharpness * d)


@kernel
def moved(x: float, d: float, slope: float, sharpness: float) -> float:
    """The peak's place after one Newton step, kept within reason."""
    step = slope / (sharpness * d)
    step = min(LARGEST_MOVE, max(-LARGEST_MOVE, step))
    return min(1.0 - MARGIN, max(MARGIN, x + step))


@kernel
def sharpened(
    sharpness: float, before: float, after: float, steep_before: float, steep_after: float
) -> float:
    """The sharpness −Δ(d′/d)/Δx seen between two visits of a peak, where they tell anything."""
    step = after - before
    if abs(step) > TELLING_MOVE:
        seen = (steep_before - steep_after) / step
        if FLATTEST < seen < SHARPEST:
            return seen
    return sharpness


@kernel
def balance(pen: Pencil, first: View, last: View, h: float, sharp1: float, sharp2: float) -> float:
    """Q for which the peaks near two points are opposite: safeguarded Newton, NaN if there is none."""
    low, high = through(first), through(last)
    if not (low > 0.0 and high > 0.0):
        return math.nan
    low, high = min(low, high), max(low, high)
    q, accuracy = 0.5 * (low + high), Q_ACCURACY * (high - low)
    for _ in range(Q_STEPS):
        d1, by1, slope1 = displacement(pen, q, first)
        d2, by2, slope2 = displacement(pen, q, last)
        if not d1 * d2 < 0.0:
            return math.nan if d1 * d2 != 0.0 else q
        excess = peak(d1, slope1 * h, sharp1) + peak(d2, slope2 * h, sharp2)
        step = excess / (by1 + by2)
        q = min(high, max(low, q - step))
        if abs(step) <= accuracy:
            return q
    return q


@kernel
def exchange(
    primitive: int,
    source: Source,
    a: float,
    start: Frame,
    b: float,
    end: Frame,
    peaks: Peaks,
    steeps: tuple[float, float],
    before: tuple[float, float],
) -> tuple[float, float, float, Peaks, tuple[float, float]]:
    """One fast evaluation of the arc [a, b].

    ``steeps`` and ``before`` are d′/d and the places of the previous visit (NaN at first).  Returns
    (error, Q, unrest, next peaks, steeps): ``unrest`` is the relative size of the last peak
    correction, small once the peaks have settled.  The error is NaN if the arc has no such member or
    the two samples are not on opposite sides.
    """
    x1, x2, sharp1, sharp2 = peaks
    h = b - a
    pen = pencil(start, end, source[1][4])
    failed = (math.nan, math.nan, math.nan, peaks, steeps)
    if not is_proper(pen):
        return failed
    first = view(pen, source, a + x1 * h)
    if primitive == PARABOLA:
        q = parabola(pen)
        if math.isnan(q):
            return failed
        d, _, slope = displacement(pen, q, first)
        steep = slope * h / d
        sharp = sharpened(sharp1, before[0], x1, steeps[0], steep)
        top = peak(d, slope * h, sharp)
        x = moved(x1, d, slope * h, sharp)
        return abs(top), q, abs(top / d - 1.0), (x, x, sharp, sharp), (steep, steep)
    last = view(pen, source, a + x2 * h)
    q = balance(pen, first, last, h, sharp1, sharp2)
    if not (q > 0.0 and weight(pen, q) > -1.0):
        return failed
    d1, _, slope1 = displacement(pen, q, first)
    d2, _, slope2 = displacement(pen, q, last)
    if not d1 * d2 < 0.0:
        return failed
    steep1, steep2 = slope1 * h / d1, slope2 * h / d2
    sharp1 = sharpened(sharp1, before[0], x1, steeps[0], steep1)
    sharp2 = sharpened(sharp2, before[1], x2, steeps[1], steep2)
    top1, top2 = peak(d1, slope1 * h, sharp1), peak(d2, slope2 * h, sharp2)
    unrest = max(abs(top1 / d1 - 1.0), abs(top2 / d2 - 1.0))
    places = (moved(x1, d1, slope1 * h, sharp1), moved(x2, d2, slope2 * h, sharp2))
    error = max(abs(top1), abs(top2))
    return error, q, unrest, (places[0], places[1], sharp1, sharp2), (steep1, steep2)
