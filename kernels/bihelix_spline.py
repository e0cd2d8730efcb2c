"""The greedy bihelix spline of one stretch of a space curve: arcs as long as the tolerance allows.

Each arc's end is found by secant steps on log error against log length, the junction's offset being
corrected at the same time; whatever does not come out consistent goes through a bracketed search.  Errors
are monotone in the length only while they are small, so a bracket holds an arc within the tolerance and a
longer one that is not: what is between need not be the longest arc of all.

A row of the table, all in the user's coordinates and units, torsion with the usual sign:

* 0, 1: a and b, the piece's interval of the curve's parameter;
* 2: the error, the two-sided Hausdorff distance between the curve over [a, b] and the bihelix;
* 3: why it ends there, `ENDS_AT_TOLERANCE` and so on;
* 4: the parameter of the curve point in the normal plane of the junction;
* 5, 6: the largest distances on the left and on the right of the junction;
* `LEFT` 7:24 and `RIGHT` 24:41: the two helices, 17 numbers each, as in `osculant.kernels.bihelices.helix`:
  start point, start tangent, τ̄V, κ̄N₀, β, length, turning, κ, τ;
* 41:44 and 44:47: end point and end tangent.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.bihelices.balance import FARTHEST, ROUNDING, STEEPNESS, assess, best, is_straight
from osculant.kernels.bihelices.family import EQUIOSCILLATING, Bihelix, End
from osculant.kernels.bihelices.hausdorff import two_sided
from osculant.kernels.bihelices.helix import HELIX_SIZE, moved
from osculant.kernels.curves.arc_length import Lengths, measure_lengths
from osculant.kernels.curves.arc_length import workspace as lengths_workspace
from osculant.kernels.curves.space import JET_SIZE, Frame, Place, Source, bends, frame, placed
from osculant.kernels.curves.vectors import Vector
from osculant.kernels.jit import kernel

#: why a piece ends where it does; at the turn: it would turn by a whole turn otherwise
ENDS_AT_TOLERANCE, ENDS_AT_STRETCH, ENDS_AT_LIMIT, ENDS_EARLY, ENDS_AT_TURN = 0, 1, 2, 3, 4
#: columns of the table, where the helices are in it, and which column says why the piece ends
LEFT, RIGHT, END, COLUMNS, REASON = 7, 24, 41, 47, 3
#: samples of each side of a junction: while searching, and for the error that decides
QUICK, CHECKED = 4, 8
#: fast evaluations per arc before the careful search takes over, and evaluations of that
FAST_STEPS, CAREFUL_STEPS = 16, 100
#: an arc changes its length at most by this factor in one step
STRIDE = 2.0
#: log(left peak/right peak) of a junction that is left as it is; unequal peaks cost length
CALM = 2e-7
#: the secant aims here in the window of admissible errors, 0 being its upper end
AIM = 0.4
#: relative width of a bracket that ends the careful search
NARROW = 1e-9
#: if less than this part of an arc would be left to the end of the stretch, the arc ends early, after this
#: part of the whole, for a last piece of some length
SHORT, EARLY = 1e-3, 0.9


@kernel
def end_at(source: Source, t: float, stop: float, last: End) -> End:
    """Point and tangent at t, which at the end of the stretch are the given (limit) ones."""
    return last if t == stop else frame(source, t)


@kernel
def first_length(source: Source, a: float, stop: float, high: float) -> float:
    """A first guess of the longest arc from a, from the law |κ′|σ³/324 and at most 1/2 of turning."""
    _, _, _, speed, curvature, slope = bends(source, a + 0.01 * (stop - a))
    sigma = min((324.0 * high / (abs(slope) + 1e-300)) ** (1.0 / 3.0), 0.5 / (curvature + 1e-300))
    guess = sigma / speed
    return min(stop - a, guess) if guess > 0.0 else 0.01 * (stop - a)


@kernel
def quick_arc(
    rule: int, source: Source, a: float, start: End, stop: float, last: End,
    length: float, low: float, high: float, w: float, exponent: float, lengths: Lengths,
) -> tuple[float, float, float, bool]:  # fmt: skip
    """(b, w, exponent, found) of the longest arc with error in [low, high], by fast steps from ``length``.

    The offset is v = wσ on arcs of any length σ; errors grow like the length to the power of the exponent.
    """
    aim = AIM * low + (1.0 - AIM) * high
    previous, previous_error = math.nan, math.nan
    previous_w, previous_g, steepness = math.nan, math.nan, STEEPNESS
    for _ in range(FAST_STEPS):
        b = a + length
        if b > stop - 1e-9 * length:
            b = stop
        length = b - a
        end = end_at(source, b, stop, last)
        if is_straight(start, end, source[1][4]):
            return b, w, exponent, False
        sigma = measure_lengths(source, a, b, lengths)
        v = min(FARTHEST, max(-FARTHEST, w * sigma))
        first, second, trusted, _ = assess(rule, source, a, start, b, end, sigma, v, QUICK, lengths)
        error = max(first, second)
        if not trusted or not error > ROUNDING * source[1][4] or math.isinf(error):
            return b, w, exponent, False
        g = math.log(first / second) if rule == EQUIOSCILLATING else 0.0
        calm = max(CALM, 8.0 * source[1][4] / error)
        if abs(g) <= calm and error <= high and (error >= low or b == stop):
            return b, w, exponent, True
        if abs(g) > calm:
            turned = (v / sigma - previous_w) * sigma
            if abs(turned) > 1e-9:  # not so while there is no previous evaluation
                steepness = min(4.0 * STEEPNESS, max(0.25 * STEEPNESS, (g - previous_g) / turned))
            previous_w, previous_g = v / sigma, g
            w = (v - max(-0.1, min(0.1, g / steepness))) / sigma
            error = math.sqrt(first * second)  # about that of equal peaks
        if error != previous_error and length != previous:
            seen = math.log(error / previous_error) / math.log(length / previous)
            if 1.0 < seen < 12.0:  # not so while there is no previous evaluation
                exponent = seen
        previous, previous_error = length, error
        length *= min(STRIDE, max(1.0 / STRIDE, (aim / error) ** (1.0 / exponent)))
    return a + length, w, exponent, False


@kernel
def careful_arc(
    rule: int, source: Source, a: float, start: End, stop: float, last: End,
    length: float, low: float, high: float, v: float, lengths: Lengths,
) -> tuple[float, int]:  # fmt: skip
    """(b, reason) of a long arc with error at most ``high``, by a bracketed search; b = a if there is none.

    The whole stretch is tried first, then lengths from the first guess on.
    """
    error = balanced(rule, source, a, start, stop, last, v, lengths)[0]
    if error <= high:
        return stop, ENDS_AT_STRETCH
    aim = AIM * low + (1.0 - AIM) * high
    good, good_error = 0.0, 0.0
    bad, bad_error = stop - a, error
    length = min(length, 0.5 * bad)
    grown = False  # whether ``bad`` is the next length tried after a good one
    for step in range(CAREFUL_STEPS):
        b = a + length
        if not (b > a and b < stop) or length <= good or length >= bad:
            break
        error = balanced(rule, source, a, start, b, frame(source, b), v, lengths)[0]
        if error <= high:
            good, good_error = length, error
            if error >= low:
                return b, ENDS_AT_TOLERANCE
        else:
            bad, bad_error, grown = length, error, True
        if bad - good <= NARROW * bad:
            break
        ratio = aim / good_error if good_error > 0.0 else math.inf
        if good == 0.0:
            length = 0.5 * bad
            if math.isfinite(bad_error):
                length = bad * max(0.1, 0.9 * (aim / bad_error) ** (1.0 / 3.0))
        elif not grown:  # the end of the stretch is far: go on in steps
            length = min(STRIDE * good, good * ratio ** (1.0 / 3.0), 0.5 * (good + bad))
        elif step % 3 == 0 or not math.isfinite(bad_error) or good_error == 0.0:
            length = 0.5 * (good + bad)
        else:  # false position on log error against log length
            slope = math.log(bad_error / good_error) / math.log(bad / good)
            length = good * ratio ** (1.0 / slope)
            if not good < length < bad:
                length = 0.5 * (good + bad)
    return a + good, (ENDS_AT_TURN if math.isinf(bad_error) else ENDS_AT_LIMIT)


@kernel
def balanced(
    rule: int, source: Source, a: float, start: End, b: float, end: End, v: float, lengths: Lengths,
    calm: float = CALM,
) -> tuple[float, float, float, float, Bihelix]:  # fmt: skip
    """(error, left peak, right peak, v, bihelix) by the rule over [a, b]; infinite error if there is none.

    Where the feet do not move along the bihelix in order, the error is searched with more care.
    """
    first, second, v, trusted, two = best(rule, source, a, start, b, end, v, calm, CHECKED, lengths)
    error = max(first, second)
    if not trusted and math.isfinite(error):
        error = two_sided(source, a, b, measure_lengths(source, a, b, lengths), two)
    return error, first, second, v, two


@kernel
def record(
    row: np.ndarray[Any, Any], a: float, b: float, error: float, reason: int,
    left_peak: float, right_peak: float, two: Bihelix, end: End, place: Place,
) -> None:  # fmt: skip
    """Write one piece into a row of the table, in the user's coordinates."""
    scale = place[3]
    origin: Vector = (place[0], place[1], place[2])
    row[0], row[1], row[2], row[3], row[4] = a, b, error / scale, reason, two[2]
    row[5], row[6] = left_peak / scale, right_peak / scale
    left, right = moved(two[0], origin, scale), moved(two[1], origin, scale)
    for j in range(HELIX_SIZE):
        row[LEFT + j], row[RIGHT + j] = left[j], right[j]
    for j in range(3):
        row[END + j], row[END + 3 + j] = end[0][j] / scale + origin[j], end[1][j]


@kernel
def spline(
    rule: int, address: int, place: Place, a: float, start: Frame, stop: float, last: Frame,
    low: float, high: float, length: float, table: np.ndarray[Any, Any],
) -> tuple[int, float, int]:  # fmt: skip
    """Fill ``table`` with the bihelices of the stretch [a, stop].

    Args:
        rule: `THESIS` or `EQUIOSCILLATING` of `osculant.kernels.bihelices.family`.
        address: of the curve's compiled jet of order 3.
        place: origin and scale (a power of two that gives the curve size about 1) of the kernel's coordinates
            and the noise of those.
        a: where the stretch starts.
        start: the (limit) frame there: x, y, z and the unit tangent, in the user's coordinates.
        stop: where it ends.
        last: the (limit) frame there.
        low: errors of pieces that end at the tolerance are at least this, in the user's units …
        high: … and those of all pieces at most this.
        length: first guess of a piece's length in the parameter; without one, 0.
        table: (capacity, `COLUMNS`).

    Returns:
        (pieces, where the last one ends, careful searches); the last one ends before ``stop`` if the table is
        full or if nothing can be found there.
    """
    source = (address, place, np.empty(JET_SIZE))
    lengths = lengths_workspace()
    low, high = low * place[3], high * place[3]
    left, final = placed(place, start), placed(place, last)
    careful = 0
    w, exponent = 0.0, 3.0
    if not length > 0.0:
        length = first_length(source, a, stop, high)
    previous = math.nan
    for count in range(table.shape[0]):
        b, w, exponent, found = quick_arc(
            rule, source, a, left, stop, final, min(length, stop - a), low, high, w, exponent, lengths
        )
        reason = ENDS_AT_STRETCH if b == stop else ENDS_AT_TOLERANCE
        if found:
            end = end_at(source, b, stop, final)
            sigma = measure_lengths(source, a, b, lengths)
            v = min(FARTHEST, max(-FARTHEST, w * sigma)) if rule == EQUIOSCILLATING else 0.0
            first, second, trusted, two = assess(rule, source, a, left, b, end, sigma, v, CHECKED, lengths)
            error = max(first, second)
            found = trusted and error <= high and (error >= low or b == stop)
        if not found:
            careful += 1
            b, reason = careful_arc(rule, source, a, left, stop, final, length, low, high, 0.0, lengths)
            if not b > a:
                return count, a, careful
            end = end_at(source, b, stop, final)
            error, first, second, v, two = balanced(rule, source, a, left, b, end, 0.0, lengths)
            w, exponent = v / measure_lengths(source, a, b, lengths), 3.0
        if 0.0 < stop - b < SHORT * (b - a):
            early = a + EARLY * (stop - a)
            early_end = frame(source, early)
            again = balanced(rule, source, a, left, early, early_end, 0.0, lengths)
            if again[0] <= high:
                b, end, reason = early, early_end, ENDS_EARLY
                error, first, second, _, two = again
        record(table[count], a, b, error, reason, first, second, two, end, place)
        if b == stop:
            return count + 1, b, careful
        length = b - a
        if previous > 0.0:  # lengths of neighbouring arcs change by about the same factor
            length *= min(2.0, max(0.5, length / previous))
        previous = b - a
        a, left = b, end
    return table.shape[0], a, careful
