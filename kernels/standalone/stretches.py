"""The pieces of all stretches of a curve, for a tolerance or a number of pieces, into the caller's array.

The stretches, their frames and the curve's size arrive as numbers: found by the front door where the curve
and its interval are fixed, else by `osculant.kernels.standalone.divide`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.course import lay_out
from osculant.kernels.jit import kernel
from osculant.kernels.operations import (
    ERROR,
    FLOOR,
    LEAST_SHARE,
    RESOLUTION,
    SCALE,
    SHARE,
    begin,
    dimension,
    frame_in,
    place_in,
    rules,
    shape,
    source,
    workspace,
)
from osculant.kernels.search import next_length, next_piece

#: how it went: everything is written; the array is too small; the tolerance is below the rounding floor; the
#: curve is undefined somewhere; no piece was found from some point on; too many features, pieces or special
#: points; an argument makes no sense; fewer pieces are asked for than there must be
DONE, FULL, BELOW, UNDEFINED, STUCK, TOO_MUCH, WRONG, TOO_FEW = 0, 1, 2, 3, 4, 5, 6, 7
#: columns of a stretch: its ends, the side to which it bends, then the frames at both ends
START, STOP, SIDE, FRAMES = 0, 1, 2, 3
#: pieces after which the search begins anew, as in `osculant.approximation.arcs`; the most there can be
CHUNK, MOST_PIECES = 4096, 20_000_000
#: rows of a stretch's course, edges of panels, and columns of a row at most
COURSE, EDGES, COLUMNS = 4096, 2048, 48
#: rounds of the search for a number of pieces with areas, and for the level of a given number
ROUNDS, STEPS, NARROW = 200, 100, 1e-9
#: an error that no piece has, in the kernels' units
BOUNDLESS = 1e100


class Outcome(NamedTuple):
    """How many pieces there are, how it went, and their largest and their whole error."""

    found: int
    status: int
    largest: float
    whole: float


@kernel
def on_stretch(
    fit: Any, address: int, size: np.ndarray[Any, Any], stretch: np.ndarray[Any, Any],
    edges: np.ndarray[Any, Any], resolution: float, low: float, high: float, degree: int, so_far: Outcome,
    pieces: np.ndarray[Any, Any],
) -> Outcome:  # fmt: skip
    """The outcome after the longest pieces of one stretch with errors up to ``high``.

    Args:
        fit: a record (`osculant.kernels.operations`).
        address: of the compiled jet.
        size: the curve's numbers, `osculant.kernels.operations.SCALE` …
        stretch: `START` …
        edges: (m, 2): where panels end, and the resolution below which they do.
        resolution: features that are larger are not missed.
        low: of the window of errors, in the user's units,
        high: and its upper end.
        degree: of an error: 1 for lengths, 2 for areas.
        so_far: of the stretches before.
        pieces: room for all; those that it has no room for are counted.
    """
    a, stop, scale = stretch[START], stretch[STOP], size[SCALE]
    place = place_in(fit, size, stretch[SIDE])
    start, last = (
        frame_in(fit, place, stretch, FRAMES),
        frame_in(fit, place, stretch, FRAMES + 2 * dimension(fit)),
    )
    count, largest, whole = so_far.found, so_far.largest, so_far.whole
    panels = np.empty(EDGES)
    course_room = np.empty((COURSE, 3))
    panels[0] = a
    used = 1
    for i in range(edges.shape[0]):
        if edges[i, 1] > resolution and edges[i, 0] > a and edges[i, 0] < stop and used < EDGES - 1:
            panels[used] = edges[i, 0]
            used += 1
    panels[used] = stop
    rows = lay_out(fit, address, place, panels[: used + 1], course_room)
    if rows < 0:
        return Outcome(count, TOO_MUCH, largest, whole)
    course = course_room[:rows]
    unit = scale if degree == 1 else scale * scale
    most = BOUNDLESS / unit
    low, high = min(low, 0.5 * most) * unit, min(high, most) * unit
    curve, space = source(fit, address, place, course), workspace(fit)
    row = np.empty(COLUMNS)
    exponent, state, length, previous = rules(fit).order, begin(fit), (stop - a) / 8, math.nan
    found = 0
    while a < stop:
        b, end, exponent, state, _ = next_piece(
            fit, curve, a, start, stop, last, length, low, high, exponent, state, course, space, row
        )
        if not b > a:
            return Outcome(count, STUCK, largest, whole)
        error = row[ERROR] / unit
        largest, whole = max(largest, error), whole + error
        if count < pieces.shape[0]:
            into = pieces[count]
            for j, value in enumerate(shape(fit, row, place, error)):
                into[j] = value
        count += 1
        found += 1
        if count > MOST_PIECES:
            return Outcome(count, TOO_MUCH, largest, whole)
        length, previous = next_length(b - a, previous), b - a
        if found % CHUNK == 0:
            exponent, state, length, previous = rules(fit).order, begin(fit), b - a, math.nan
        start, a = end, b
    return Outcome(count, DONE, largest, whole)


@kernel
def greedy(
    fit: Any, address: int, size: np.ndarray[Any, Any], stretches: np.ndarray[Any, Any],
    edges: np.ndarray[Any, Any], resolution: float, low: float, high: float, degree: int,
    pieces: np.ndarray[Any, Any],
) -> Outcome:  # fmt: skip
    """The longest pieces of all stretches with errors in the window, as `on_stretch`."""
    outcome = Outcome(0, DONE, 0.0, 0.0)
    for i in range(stretches.shape[0]):
        outcome = on_stretch(
            fit, address, size, stretches[i], edges, resolution, low, high, degree, outcome, pieces
        )
        if outcome.status != DONE:
            return outcome
    if outcome.found > pieces.shape[0]:
        return Outcome(outcome.found, FULL, outcome.largest, outcome.whole)
    return outcome


@kernel
def for_tolerance(
    fit: Any, address: int, size: np.ndarray[Any, Any], stretches: np.ndarray[Any, Any],
    edges: np.ndarray[Any, Any], tolerance: float, degree: int, pieces: np.ndarray[Any, Any],
) -> Outcome:  # fmt: skip
    """The fewest pieces found with errors up to the tolerance: of each distance, or of the areas' sum.

    n areas of tolerance/n each, for the least n that this suffices for: the number at one n is a lower bound
    of all larger solutions.
    """
    if not 0.0 < tolerance < math.inf:
        return Outcome(0, WRONG, 0.0, 0.0)
    if tolerance < size[FLOOR]:
        return Outcome(0, BELOW, 0.0, 0.0)
    kept = max(size[SHARE] * tolerance, size[LEAST_SHARE])
    low, high, resolution = tolerance - 3.5 * kept, tolerance - kept, tolerance * size[RESOLUTION]
    if degree == 1:
        return greedy(fit, address, size, stretches, edges, resolution, low, high, degree, pieces)
    count = stretches.shape[0]
    outcome = Outcome(0, TOO_MUCH, 0.0, 0.0)
    for _ in range(ROUNDS):
        outcome = greedy(
            fit, address, size, stretches, edges, resolution, low / count, high / count, degree, pieces
        )
        if outcome.found <= count or not (outcome.status == DONE or outcome.status == FULL):
            return outcome
        count = outcome.found
    return Outcome(outcome.found, TOO_MUCH, outcome.largest, outcome.whole)


@kernel
def for_number(
    fit: Any, address: int, size: np.ndarray[Any, Any], stretches: np.ndarray[Any, Any],
    edges: np.ndarray[Any, Any], number: int, degree: int, pieces: np.ndarray[Any, Any],
) -> Outcome:  # fmt: skip
    """At most so many pieces whose largest error is about the least: the level is bracketed to 1e-9 of it.

    The last pieces of stretches have smaller errors.
    """
    none = pieces[:0]
    resolution = size[FLOOR] * size[RESOLUTION]
    outcome = greedy(fit, address, size, stretches, edges, resolution, math.inf, math.inf, degree, none)
    if not (outcome.status == DONE or outcome.status == FULL):
        return outcome
    if outcome.found > number:
        return Outcome(outcome.found, TOO_FEW, outcome.largest, outcome.whole)
    low, high, level = size[FLOOR], math.inf, max(outcome.largest, 2.0 * size[FLOOR])
    if not level < math.inf:
        level = 1.0 / size[SCALE]
    best = math.inf
    for step in range(STEPS):
        narrow = max(1e-7 * level, size[LEAST_SHARE])
        outcome = greedy(
            fit, address, size, stretches, edges, resolution, level - narrow, level, degree, none
        )
        if not (outcome.status == DONE or outcome.status == FULL):
            return outcome
        if outcome.found <= number:
            best, high = level, level
        else:
            low = level
        if high <= low * (1.0 + NARROW):
            break
        ratio = outcome.found / number
        level *= ratio ** rules(fit).order * (0.99 if outcome.found <= number else 1.01)
        if not (level > low and level < high) or step % 3 == 2:
            level = math.sqrt(low * high) if high < math.inf else 16.0 * low
    narrow = max(1e-7 * best, size[LEAST_SHARE])
    return greedy(fit, address, size, stretches, edges, resolution, best - narrow, best, degree, pieces)
