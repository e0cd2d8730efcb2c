"""The fast step: the best member of the pencil of one arc from two (or one) curve samples.

A conic's error has two peaks of opposite sign, equal for the minimax conic; a parabola's has one.
The peaks' places and sharpnesses, in units of the arc, change slowly from arc to arc, so the caller
keeps them in a `Peaks` tuple: each call samples the curve at the believed peaks, chooses Q, and moves
the peaks by one Newton step.  Nothing is bracketed here: a result is trusted only if it is
consistent, and the search has `minimax` to fall back on.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

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
from osculant.kernels.curves.peaks import Space, within_reason
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel


class Peaks(NamedTuple):
    """The peaks of one arc's error, for the next arc; of one peak both say the same.

    Attributes:
        first, last: their places, in parts of the arc.
        sharp_first, sharp_last: their sharpnesses −d″/d, in units of the arc.
        before_first, before_last: where they were believed to be in the visit before, NaN if there was none.
        steep_first, steep_last: d′/d there.
    """

    first: float
    last: float
    sharp_first: float
    sharp_last: float
    before_first: float
    before_last: float
    steep_first: float
    steep_last: float


#: Newton steps for Q: it starts within the bracket of the two samples' own members
Q_STEPS = 12
#: a Newton step of Q this small, in parts of its bracket, is the last: d is nearly linear in Q there
Q_ACCURACY = 1e-4
#: believable sharpnesses
FLATTEST, SHARPEST = 4.0, 2000.0
#: moves smaller than this say nothing about the sharpness
TELLING_MOVE = 1e-5


@kernel
def at_rest(first: float, last: float, sharp_first: float, sharp_last: float) -> Peaks:
    """Peaks that were not visited before."""
    return Peaks(first, last, sharp_first, sharp_last, math.nan, math.nan, math.nan, math.nan)


@kernel
def one_peak(fit: Any) -> Peaks:
    """The peak of a short arc's distance from its parabola, by the leading term."""
    x, c = generated.PARABOLA_FIRST, generated.PARABOLA_SHARPNESS
    return at_rest(x, x, c, c)


@kernel
def two_peaks(fit: Any) -> Peaks:
    """The peaks of a short arc's distance from its best conic, by the leading term."""
    c = generated.CONIC_SHARPNESS
    return at_rest(generated.CONIC_FIRST, generated.CONIC_LAST, c, c)


@kernel
def unvisited(fit: Any, peaks: Peaks) -> Peaks:
    """The same peaks for another arc."""
    return at_rest(peaks.first, peaks.last, peaks.sharp_first, peaks.sharp_last)


@kernel
def peak(d: float, slope: float, sharpness: float) -> float:
    """The extreme value near a sample: that of the parabola with this value, slope and curvature."""
    return d + slope * slope / (2.0 * sharpness * d)


@kernel
def moved(x: float, d: float, slope: float, sharpness: float) -> float:
    """The peak's place after one Newton step, kept within reason."""
    return within_reason(x, slope / (sharpness * d))


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
def visit_one(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    peaks: Peaks, calm: float, space: Space,
) -> tuple[float, float, bool, Peaks]:  # fmt: skip
    """(error, Q, settled, next peaks) of the parabola of the arc [a, b], by one fast evaluation.

    The peak has settled if its last correction is at most the part ``calm`` of the error.  The error is NaN
    if there is no parabola.
    """
    x, h = peaks.first, b - a
    pen = pencil(start, end, source.place.noise)
    if not is_proper(pen):
        return math.nan, math.nan, False, peaks
    q = parabola(pen)
    if math.isnan(q):
        return math.nan, math.nan, False, peaks
    d, _, slope = displacement(pen, q, view(pen, source, a + x * h))
    steep = slope * h / d
    sharp = sharpened(peaks.sharp_first, peaks.before_first, x, peaks.steep_first, steep)
    top = peak(d, slope * h, sharp)
    place = moved(x, d, slope * h, sharp)
    return abs(top), q, abs(top / d - 1.0) <= calm, Peaks(place, place, sharp, sharp, x, x, steep, steep)


@kernel
def visit_two(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    peaks: Peaks, calm: float, space: Space,
) -> tuple[float, float, bool, Peaks]:  # fmt: skip
    """(error, Q, settled, next peaks) of the best conic of the arc [a, b], as `visit_one`.

    The error is NaN, too, if the two samples are not on opposite sides of it.
    """
    x1, x2, h = peaks.first, peaks.last, b - a
    pen = pencil(start, end, source.place.noise)
    if not is_proper(pen):
        return math.nan, math.nan, False, peaks
    first, last = view(pen, source, a + x1 * h), view(pen, source, a + x2 * h)
    q = balance(pen, first, last, h, peaks.sharp_first, peaks.sharp_last)
    if not (q > 0.0 and weight(pen, q) > -1.0):
        return math.nan, math.nan, False, peaks
    d1, _, slope1 = displacement(pen, q, first)
    d2, _, slope2 = displacement(pen, q, last)
    if not d1 * d2 < 0.0:
        return math.nan, math.nan, False, peaks
    steep1, steep2 = slope1 * h / d1, slope2 * h / d2
    sharp1 = sharpened(peaks.sharp_first, peaks.before_first, x1, peaks.steep_first, steep1)
    sharp2 = sharpened(peaks.sharp_last, peaks.before_last, x2, peaks.steep_last, steep2)
    top1, top2 = peak(d1, slope1 * h, sharp1), peak(d2, slope2 * h, sharp2)
    unrest = max(abs(top1 / d1 - 1.0), abs(top2 / d2 - 1.0))
    place1, place2 = moved(x1, d1, slope1 * h, sharp1), moved(x2, d2, slope2 * h, sharp2)
    error = max(abs(top1), abs(top2))
    return error, q, unrest <= calm, Peaks(place1, place2, sharp1, sharp2, x1, x2, steep1, steep2)
