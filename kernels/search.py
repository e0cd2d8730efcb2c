"""The greedy spline of one stretch: the longest arc within the tolerance, again and again.

Each arc's end is found by secant steps on log error against log length, with `step` as the evaluation (about
three curve samples each); whatever does not come out consistent goes through a bracketed search on `best`.
An arc is kept only after its error, measured on common normals of its own, is found within the tolerance.
Where errors are monotone in the length the arc is the longest of all; elsewhere a bracket holds an arc within
the tolerance and a longer one that is not.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.course import farthest, resolving
from osculant.kernels.jit import kernel
from osculant.kernels.operations import (
    ERROR,
    REASON,
    A,
    B,
    begin,
    best,
    confirm,
    frame,
    record,
    renew,
    resume,
    rules,
    source,
    step,
    workspace,
)

#: why an arc ends where it does; at the limit: no longer arc has a proper piece, or doubles tell no more
ENDS_AT_TOLERANCE, ENDS_AT_STRETCH, ENDS_AT_LIMIT, ENDS_EARLY = 0, 1, 2, 3
#: fast evaluations per arc before the careful search takes over, and evaluations of that
FAST_STEPS, CAREFUL_STEPS = 16, 200
#: a settled evaluation would change by less than this part of the window of admissible errors
UNREST = 0.05
#: relative width of a bracket that ends the careful search
NARROW = 1e-12
#: an arc that has to end early takes this part of what is left
EARLY = 0.9


@kernel
def frame_at(fit: Any, curve: Any, t: float, stop: float, last: Any) -> Any:
    """The frame at t, which at the end of the stretch is the given limit frame."""
    return last if t == stop else frame(fit, curve, t)


@kernel
def quick_arc(
    fit: Any, curve: Any, a: float, start: Any, stop: float, last: Any, far: float, length: float,
    low: float, high: float, exponent: float, state: Any, space: Any,
) -> tuple[float, Any, Any, float, bool]:  # fmt: skip
    """(b, choice, state, found) of the longest arc with error in [low, high], by fast steps from ``length``.

    It ends at ``far`` at the latest.
    """
    rule = rules(fit)
    stride = rule.stride
    aim = rule.aim * low + (1.0 - rule.aim) * high
    calm = UNREST * (high - low) / high
    state = renew(fit, state)
    previous, previous_error = math.nan, math.nan
    for _ in range(FAST_STEPS):
        b = min(a + length, far)
        if a + length > far - 1e-9 * length:
            b = far
        length = b - a
        end = frame_at(fit, curve, b, stop, last)
        error, choice, settled, moved = step(fit, curve, a, start, b, end, state, calm, space)
        if not error > 0.0:
            return b, choice, state, exponent, False
        state = moved
        if settled and error <= high and (error >= low or b == far):
            return b, choice, state, exponent, True
        if error != previous_error and length != previous:
            seen = math.log(error / previous_error) / math.log(length / previous)
            if 1.0 < seen < 12.0:  # not so while there is no previous evaluation
                exponent = seen
        previous, previous_error = length, error
        if low <= error <= high or (b == far and error < low and not settled):
            continue  # only the choice has to settle
        length *= min(stride, max(1.0 / stride, (aim / error) ** (1.0 / exponent)))
    return a + length, choice, state, exponent, False


@kernel
def careful_arc(
    fit: Any, curve: Any, a: float, start: Any, stop: float, last: Any, far: float, length: float,
    low: float, high: float, course: np.ndarray[Any, Any], space: Any,
) -> tuple[float, float, Any, int]:  # fmt: skip
    """(b, error, piece, reason) of a long arc with error at most ``high``, by a bracketed search.

    The whole stretch, or what ``far`` leaves of it, is tried first, then lengths from the first guess on.
    The error is infinite, and b = a, if not even the shortest arc can be approximated.
    """
    rule = rules(fit)
    end = frame_at(fit, curve, far, stop, last)
    error, piece = best(fit, curve, a, start, far, end, resolving(course, a, far, rule.careful), space)
    if error <= high:
        return far, error, piece, ENDS_AT_STRETCH if far == stop else ENDS_AT_LIMIT
    aim = rule.aim * low + (1.0 - rule.aim) * high
    good, good_error, good_piece = 0.0, 0.0, piece
    bad, bad_error = far - a, error
    length = min(length, 0.5 * bad)
    grown = False  # whether ``bad`` is a length tried, and not the whole stretch
    for i in range(CAREFUL_STEPS):
        b = a + length
        if not (b > a and b < far) or length <= good or length >= bad:
            break
        end = frame(fit, curve, b)
        error, piece = best(fit, curve, a, start, b, end, resolving(course, a, b, rule.careful), space)
        if error <= high:
            good, good_error, good_piece = length, error, piece
            if error >= low:
                return b, error, piece, ENDS_AT_TOLERANCE
        else:
            bad, bad_error, grown = length, error, True
        if bad - good <= NARROW * bad:
            break
        ratio = aim / good_error if good_error > 0.0 else math.inf
        if good == 0.0:
            length = 0.5 * bad
            if math.isfinite(bad_error):
                length = bad * max(0.1, 0.9 * (aim / bad_error) ** (1.0 / rule.order))
        elif not grown:  # the end of the stretch is far: go on in steps
            length = min(rule.stride * good, good * ratio ** (1.0 / rule.order), 0.5 * (good + bad))
        elif i % 3 == 0 or not math.isfinite(bad_error) or good_error == 0.0:
            length = 0.5 * (good + bad)
        else:  # false position on log error against log length
            slope = math.log(bad_error / good_error) / math.log(bad / good)
            length = good * ratio ** (1.0 / slope)
            if not good < length < bad:
                length = 0.5 * (good + bad)
    return a + good, (good_error if good > 0.0 else math.inf), good_piece, ENDS_AT_LIMIT


@kernel
def next_length(length: float, previous: float) -> float:
    """A guess of the next arc's length: neighbouring arcs change by about the same factor."""
    if previous > 0.0:
        return length * min(2.0, max(0.5, length / previous))
    return length


@kernel
def longest_piece(
    fit: Any, curve: Any, a: float, start: Any, stop: float, last: Any, length: float,
    low: float, high: float, exponent: float, state: Any, course: np.ndarray[Any, Any], space: Any,
) -> tuple[float, Any, float, Any, int, float, Any, bool]:  # fmt: skip
    """(b, frame there, error, piece, reason, state, by careful search) of the longest piece from a.

    b = a if there is none.
    """
    rule = rules(fit)
    far = farthest(course, a, stop, rule.turning)
    b, choice, after, exponent, found = quick_arc(
        fit, curve, a, start, stop, last, far, length, low, high, exponent, state, space
    )
    reason = ENDS_AT_STRETCH if b == stop else ENDS_AT_TOLERANCE
    error = math.inf
    if found:
        end = frame_at(fit, curve, b, stop, last)
        points = resolving(course, a, b, rule.checked)
        error, piece = confirm(fit, choice, curve, a, start, b, end, points, space)
    careful = not (error <= high and (error >= low or b == stop))
    if careful:
        b, error, piece, reason = careful_arc(
            fit, curve, a, start, stop, last, far, length, low, high, course, space
        )
        end = frame_at(fit, curve, b, stop, last)
        after = resume(fit, piece, curve, a, b, space)
        exponent = rule.order
    if b > a and 0.0 < stop - b < rule.short * (b - a):
        early = a + EARLY * (stop - a)
        early_end = frame(fit, curve, early)
        points = resolving(course, a, early, rule.careful)
        early_error, early_piece = best(fit, curve, a, start, early, early_end, points, space)
        if early_error <= high:
            return early, early_end, early_error, early_piece, ENDS_EARLY, exponent, after, careful
    return b, end, error, piece, reason, exponent, after, careful


@kernel
def next_piece(
    fit: Any, curve: Any, a: float, start: Any, stop: float, last: Any, length: float,
    low: float, high: float, exponent: float, state: Any, course: np.ndarray[Any, Any], space: Any,
    row: np.ndarray[Any, Any],
) -> tuple[float, Any, float, Any, bool]:  # fmt: skip
    """(b, frame there, exponent, state, by careful search) of the longest piece from a, written into a row.

    b = a, and nothing is written, if there is none.
    """
    b, end, error, piece, reason, exponent, state, careful = longest_piece(
        fit, curve, a, start, stop, last, length, low, high, exponent, state, course, space
    )
    if b > a:
        row[A], row[B], row[ERROR], row[REASON] = a, b, error, reason
        record(fit, row, piece, start, end, curve)
    return b, end, exponent, state, careful


@kernel
def spline(
    fit: Any, address: int, place: Any, a: float, start: Any, stop: float, last: Any,
    low: float, high: float, length: float, course: np.ndarray[Any, Any], table: np.ndarray[Any, Any],
) -> tuple[int, float, int]:  # fmt: skip
    """Fill ``table`` with the pieces of the stretch [a, stop].

    Args:
        fit: a record (`osculant.kernels.operations`).
        address: of the curve's compiled jet.
        place: of the kernel's coordinates.
        a: where the stretch starts.
        start: the (limit) frame there.
        stop: where it ends.
        last: the (limit) frame there.
        low: errors of pieces that end at the tolerance are at least this,
        high: and those of all pieces at most this, in the kernel's units.
        length: first guess of a piece's length in the parameter.
        course: of the stretch (`osculant.kernels.course`).
        table: (capacity, columns of the family).

    Returns:
        (pieces, where the last one ends, careful searches); the last one ends before ``stop`` if the table is
        full or if nothing can be found there.
    """
    curve, space = source(fit, address, place, course), workspace(fit)
    exponent, state = rules(fit).order, begin(fit)
    searches = 0
    previous = math.nan
    for count in range(table.shape[0]):
        b, end, exponent, state, careful = next_piece(
            fit, curve, a, start, stop, last, length, low, high, exponent, state, course, space, table[count]
        )
        searches += careful
        if not b > a:
            return count, a, searches
        if b == stop:
            return count + 1, b, searches
        length, previous = next_length(b - a, previous), b - a
        start, a = end, b
    return table.shape[0], a, searches
