"""The greedy spline of one stretch: the longest arc within the tolerance, again and again.

Each arc's end is found by secant steps on log error against log length, with `exchange` as the
evaluation (about three curve samples each; for biarcs `biarc_spline.exchange`); whatever does not come out
consistent goes through a bracketed search on `minimax`.  An arc is kept only after its error, measured on
common normals of its own, is found within the tolerance.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.biarcs import area_exchange as biarc_area
from osculant.kernels.biarcs import area_scan as biarc_moons
from osculant.kernels.biarcs import exchange as biarc_spline
from osculant.kernels.biarcs import family as biarc
from osculant.kernels.biarcs import scan as biarc_scan
from osculant.kernels.conics import area_exchange, area_scan
from osculant.kernels.conics.exchange import Peaks, exchange, first_peaks
from osculant.kernels.conics.minimax import minimax
from osculant.kernels.conics.pencil import pencil
from osculant.kernels.conics.scan import GRID, Space, measure, workspace
from osculant.kernels.curves.plane import JET_SIZE, Frame, Place, Source, sample
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel
from osculant.kernels.primitives import (
    AREA_PARABOLA,
    BIARC,
    BIARCS,
    CONIC,
    CONIC_AREAS,
    EQUISYMMETRIC_BIARC,
    PARABOLA,
)

#: why an arc ends where it does
ENDS_AT_TOLERANCE, ENDS_AT_STRETCH, ENDS_AT_LIMIT, ENDS_EARLY = 0, 1, 2, 3
#: columns of the table of pieces, as `record` fills them, and which say the error and why the arc ends
COLUMNS, ERROR, REASON = 15, 3, 4
#: inner samples of the measurement that decides
CHECKED = 8
#: fast evaluations per arc before the careful search takes over
FAST_STEPS = 16
#: an arc changes its length at most by this factor in one fast step
STRIDE = 3.0
#: the secant aims here in the window of admissible errors, 0 being its upper end
AIM = 0.3
#: a settled evaluation: peak corrections below this part of the admissible error window
UNREST = 0.05
#: if less than this part of an arc would be left to the end of the stretch, doubles can hardly carry what is
#: left: the arc ends early, after this part of the whole, for a last piece of some length
SHORT, EARLY = 1e-6, 0.9
#: evaluations of the careful search
CAREFUL_STEPS = 200


@kernel
def frame(source: Source, t: float) -> Frame:
    """The frame of the curve at t."""
    x, y, tx, ty, _, _ = sample(source, t)
    return x, y, tx, ty


@kernel
def frame_at(source: Source, t: float, stop: float, last: Frame) -> Frame:
    """The frame at t, which at the end of the stretch is the given limit frame."""
    return last if t == stop else frame(source, t)


@kernel
def order(primitive: int) -> float:
    """The order of a short arc's error in its length."""
    if primitive == BIARC:
        return 3.0
    if primitive in (PARABOLA, EQUISYMMETRIC_BIARC):
        return 4.0
    return 5.0 if primitive in (CONIC, AREA_PARABOLA) else 6.0


@kernel
def peaks_at_first(primitive: int) -> Peaks:
    """What `exchange` of the primitive starts with."""
    if primitive == BIARC:
        return biarc_spline.FIRST_PEAKS
    if primitive == EQUISYMMETRIC_BIARC:
        return biarc_area.FIRST_PEAKS
    if primitive in (PARABOLA, CONIC):
        return first_peaks(primitive)
    return area_exchange.FIRST_LEVEL


@kernel
def step(
    primitive: int, source: Source, a: float, start: Frame, b: float, end: Frame,
    peaks: Peaks, steeps: tuple[float, float], before: tuple[float, float], calm: float, space: Space,
) -> tuple[float, float, float, Peaks, tuple[float, float]]:  # fmt: skip
    """One fast evaluation of the arc [a, b], as `exchange`; ``calm`` is the unrest aimed at."""
    if primitive == BIARC:
        error, q, unrest, moved = biarc_spline.exchange(source, a, start, b, end, peaks)
        return error, q, unrest, moved, steeps
    if primitive == EQUISYMMETRIC_BIARC:
        error, q, unrest, moved = biarc_area.exchange(source, a, start, b, end, peaks)
        return error, q, unrest, moved, steeps
    if primitive in CONIC_AREAS:
        error, q, unrest, moved = area_exchange.exchange(
            primitive, source, a, start, b, end, peaks, calm, space
        )
        return error, q, unrest, moved, steeps
    return exchange(primitive, source, a, start, b, end, peaks, steeps, before)


@kernel
def quick_arc(
    primitive: int, source: Source, a: float, start: Frame,
    stop: float, last: Frame, length: float, low: float, high: float, peaks: Peaks, space: Space,
) -> tuple[float, float, Peaks, bool]:  # fmt: skip
    """(b, Q, peaks, found) of the longest arc with error in [low, high], by fast steps from ``length``."""
    exponent = order(primitive)
    aim = AIM * low + (1.0 - AIM) * high
    calm = UNREST * (high - low) / high
    steeps, before = (math.nan, math.nan), (math.nan, math.nan)
    previous, previous_error = math.nan, math.nan
    for _ in range(FAST_STEPS):
        b = min(a + length, stop)
        if a + length > stop - 1e-9 * length:
            b = stop
        length = b - a
        end = frame_at(source, b, stop, last)
        error, q, unrest, moved, steeps = step(
            primitive, source, a, start, b, end, peaks, steeps, before, calm, space
        )
        if not error > 0.0:
            return b, q, peaks, False
        before, peaks = (peaks[0], peaks[1]), moved
        if unrest <= calm and error <= high and (error >= low or b == stop):
            return b, q, peaks, True
        if error != previous_error and length != previous:
            seen = math.log(error / previous_error) / math.log(length / previous)
            if 1.0 < seen < 12.0:  # not so while there is no previous evaluation
                exponent = seen
        previous, previous_error = length, error
        if low <= error <= high or (b == stop and error < low and unrest > calm):
            continue  # only the peaks have to settle
        length *= min(STRIDE, max(1.0 / STRIDE, (aim / error) ** (1.0 / exponent)))
    return a + length, math.nan, peaks, False


@kernel
def careful_arc(
    primitive: int, source: Source, a: float, start: Frame,
    stop: float, last: Frame, length: float, low: float, high: float, space: Space,
) -> tuple[float, float, int]:  # fmt: skip
    """(b, Q, reason) of the longest arc with error at most ``high``, by a bracketed search.

    Q is NaN if not even the shortest arc can be approximated.
    """
    error, q = minimax(primitive, source, a, start, stop, last, space)
    if error <= high:
        return stop, q, ENDS_AT_STRETCH
    aim = AIM * low + (1.0 - AIM) * high
    good, good_q, good_error = 0.0, math.nan, 0.0
    bad, bad_error = stop - a, error
    length = min(length, 0.5 * bad)
    for step in range(CAREFUL_STEPS):
        b = a + length
        if not (b > a and b < stop) or length <= good or length >= bad:
            break
        error, q = minimax(primitive, source, a, start, b, frame(source, b), space)
        if error <= high:
            good, good_q, good_error = length, q, error
            if error >= low:
                return b, q, ENDS_AT_TOLERANCE
        else:
            bad, bad_error = length, error
        if good == 0.0:
            length = (
                0.5 * bad if not math.isfinite(bad_error) else bad * max(0.1, 0.9 * (aim / bad_error) ** 0.2)
            )
        elif step % 3 == 0 or not math.isfinite(bad_error):
            length = 0.5 * (good + bad)
        else:  # false position on log error against log length
            slope = math.log(bad_error / good_error) / math.log(bad / good)
            length = good * (aim / good_error) ** (1.0 / slope)
            if not good < length < bad:
                length = 0.5 * (good + bad)
    if good == 0.0:
        return a, math.nan, ENDS_AT_LIMIT
    return a + good, good_q, ENDS_AT_LIMIT


@kernel
def measured(
    primitive: int, q: float, source: Source, a: float, start: Frame,
    b: float, end: Frame, points: int, space: Space,
) -> float:  # fmt: skip
    """The error of the member Q (of a biarc μ), from ``points`` samples or more."""
    if primitive == BIARC:
        arcs = biarc.member(biarc.family(start, end), q)
        return biarc_scan.measure(arcs, source, a, b, points, space)
    if primitive == EQUISYMMETRIC_BIARC:
        arcs = biarc.member(biarc.family(start, end), q)
        return biarc_moons.measure(arcs, source, a, b, points, space)
    if primitive in CONIC_AREAS:
        return area_scan.measure(pencil(start, end, source[1][4]), q, source, a, b, space)
    return measure(pencil(start, end, source[1][4]), q, source, a, b, points, space)


@kernel
def record(
    primitive: int, row: np.ndarray[Any, Any], a: float, b: float, q: float,
    error: float, reason: int, start: Frame, end: Frame, noise: float,
) -> None:  # fmt: skip
    """Write one piece into a row: a, b, Q (of a biarc μ), error, reason, P₀, T₀, P₂, and its shape.

    The shape is weight and |V| of a conic, junction and both curvatures of a biarc.
    """
    row[0], row[1], row[2], row[3], row[4] = a, b, q, error, reason
    row[5], row[6], row[7], row[8], row[9], row[10] = start[0], start[1], start[2], start[3], end[0], end[1]
    if primitive in BIARCS:
        arcs = biarc.member(biarc.family(start, end), q)
        row[11], row[12], row[13], row[14] = arcs[4], arcs[5], arcs[12], arcs[13]
        return
    pen = pencil(start, end, noise)
    w, reach = 1.0, 0.5 * pen[10]  # the chord
    if q > 0.0:
        w, reach = generated.weight(q, pen[10], pen[11], pen[12], pen[13])
    row[11], row[12] = w, reach


@kernel
def spline(
    primitive: int, address: int, place: Place, a: float, start: Frame, stop: float, last: Frame,
    low: float, high: float, length: float, table: np.ndarray[Any, Any],
) -> tuple[int, float, int]:  # fmt: skip
    """Fill ``table`` (capacity, `COLUMNS`) with the pieces of the stretch [a, stop].

    Errors of pieces that end at the tolerance lie in [low, high], those of the others at most at
    ``high``; ``start`` and ``last`` are the (limit) frames at the ends and ``length`` is a first guess in
    units of the parameter.  Returns (pieces, where the last one ends, careful searches); the last one
    ends before ``stop`` if the table is full or if nothing can be found there.
    """
    source = (address, place, np.empty(JET_SIZE))
    space = workspace()
    shape = peaks_at_first(primitive)
    peaks = shape
    careful = 0
    previous = math.nan
    for count in range(table.shape[0]):
        b, q, after, found = quick_arc(
            primitive, source, a, start, stop, last, length, low, high, peaks, space
        )
        reason = ENDS_AT_STRETCH if b == stop else ENDS_AT_TOLERANCE
        error = math.inf
        if found:
            end = frame_at(source, b, stop, last)
            error = measured(primitive, q, source, a, start, b, end, CHECKED, space)
        if error <= high and (error >= low or b == stop):
            peaks = after
        else:
            careful += 1
            b, q, reason = careful_arc(primitive, source, a, start, stop, last, length, low, high, space)
            if math.isnan(q):
                return count, a, careful
            end = frame_at(source, b, stop, last)
            error = measured(primitive, q, source, a, start, b, end, GRID, space)
            peaks = shape
        if 0.0 < stop - b < SHORT * (b - a):
            early = a + EARLY * (stop - a)
            early_end = frame(source, early)
            early_error, early_q = minimax(primitive, source, a, start, early, early_end, space)
            if early_error <= high:
                b, end, q, error, reason = early, early_end, early_q, early_error, ENDS_EARLY
        record(primitive, table[count], a, b, q, error, reason, start, end, place[4])
        if b == stop:
            return count + 1, b, careful
        length = b - a
        if previous > 0.0:  # lengths of neighbouring arcs change by about the same factor
            length *= min(2.0, max(0.5, length / previous))
        previous = b - a
        a, start = b, end
    return table.shape[0], a, careful
