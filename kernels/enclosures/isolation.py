"""Isolation of the zeros of forms by Taylor models in doubles, all forms at once, with bounded work.

A box is done for a form when its Taylor model excludes 0 there, or excludes 0 from its derivative; then
the signs at both ends tell whether there is a zero, and Newton's method makes its bracket narrow.  What
doubles cannot tell, such as multiple zeros, is given back as open.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.enclosures.balls import Ball, add, div, excludes_zero, mul
from osculant.kernels.enclosures.programs import Table, run, value
from osculant.kernels.jit import kernel

#: boxes are divided here, not in the middle, where formulas like to have their special points
CUT = 0.48713
#: the smallest box, in parts of the interval, and units of the larger end that it must be wide
SMALLEST, RESOLVED = 2.0**-32, 2.0**-46
#: which `model`: numba would compile for each whole number anew
FORM, SLOPE = 0.0, 1.0
#: steps for one zero, and units of its place within which it is known
STEPS, KNOWN = 60, 2.0**-50


class Forms(NamedTuple):
    """Which values of a program are whose Taylor coefficients.

    Attributes:
        rows: (m, terms) indices of values.
        owners: (m,) the form a row belongs to.  Its first row is the form itself; the others vanish, too,
            wherever it does.
        leading: (forms,) the first row of each.
    """

    rows: np.ndarray[Any, Any]
    owners: np.ndarray[Any, Any]
    leading: np.ndarray[Any, Any]


class Room(NamedTuple):
    """Scratch space: values at a centre and over a box; boxes to come: both ends, forms still open."""

    at: np.ndarray[Any, Any]
    over: np.ndarray[Any, Any]
    boxes: np.ndarray[Any, Any]


class Found(NamedTuple):
    """How many brackets and open boxes there are."""

    brackets: int
    open: int


@kernel
def model(
    at: np.ndarray[Any, Any], over: np.ndarray[Any, Any], row: np.ndarray[Any, Any], h: Ball, slope: float
) -> Ball:
    """The Taylor model of a row, or of its derivative if ``slope`` is 1, over a box of half width h."""
    last, first = row.shape[0] - 1, int(slope)
    total = mul((1.0 + slope * (last - 1), 0.0), (over[row[last], 0], over[row[last], 1]))
    for k in range(last - 1, first - 1, -1):
        factor = 1.0 + slope * (k - 1)
        total = add(mul((factor, 0.0), (at[row[k], 0], at[row[k], 1])), mul(h, total))
    return total


@kernel
def sharpened(
    table: Table, row: np.ndarray[Any, Any], low: float, high: float, rising: bool, room: Room
) -> tuple[float, float, Ball]:
    """(low, high, derivative there) of the one zero of a form, monotone in [low, high].

    The bracket is as narrow as doubles can see.
    """
    for _ in range(STEPS):
        middle, width = low + 0.5 * (high - low), high - low
        if not low < middle < high or width <= KNOWN * abs(middle):
            break
        here = value(table, middle, row[0], room.at)
        if not excludes_zero(here):
            break
        if (here[0] > 0.0) == rising:
            high = middle
        else:
            low = middle
        centre = low + 0.5 * (high - low)
        run(table, centre, max(high - centre, centre - low) * (1.0 + 2.0**-50), room.over)
        slope = (room.over[row[1], 0], room.over[row[1], 1])
        step = div(here, slope)
        if excludes_zero(slope):
            slack = 2.0**-51 * abs(middle) + step[1]
            low, high = max(low, middle - step[0] - slack), min(high, middle - step[0] + slack)
        if not high - low <= 0.75 * width:
            break
    centre = low + 0.5 * (high - low)
    run(table, centre, max(high - centre, centre - low) * (1.0 + 2.0**-50), room.over)
    return low, high, (room.over[row[1], 0], room.over[row[1], 1])


@kernel
def examined(
    table: Table, forms: Forms, start: float, end: float, open_forms: int, room: Room
) -> tuple[int, int]:
    """(forms that may vanish between two places, those of them that are monotone), a bit for each."""
    centre = start + 0.5 * (end - start)
    h = (0.0, max(end - centre, centre - start) * (1.0 + KNOWN))
    run(table, centre, h[1], room.over)
    run(table, centre, 0.0, room.at)
    monotone = 0
    for i in range(forms.rows.shape[0]):
        bit = 1 << forms.owners[i]
        if open_forms & bit and excludes_zero(model(room.at, room.over, forms.rows[i], h, FORM)):
            open_forms &= ~bit
    for k in range(forms.leading.shape[0]):
        row = forms.rows[forms.leading[k]]
        if open_forms & (1 << k) and excludes_zero(model(room.at, room.over, row, h, SLOPE)):
            monotone |= 1 << k
    return open_forms, monotone


@kernel
def isolate(
    table: Table, forms: Forms, low: float, high: float, budget: int, room: Room,
    brackets: np.ndarray[Any, Any], open_boxes: np.ndarray[Any, Any],
) -> Found:  # fmt: skip
    """Isolate the zeros of all forms on [low, high].

    After ``budget`` boxes what is left is open.  Rows of ``brackets`` (most, 5) are zeros: form, both ends,
    the form's derivative between them, a ball; of ``open_boxes`` (most, 3) what is not decided: both ends,
    and a bit for each form.  If there is no room for all, the numbers found are larger than the arrays.
    """
    count, capacity = forms.leading.shape[0], room.boxes.shape[0]
    first, last, zeros, left = 0, 1, 0, 0
    box = room.boxes[0]
    box[0], box[1], box[2] = low, high, float(2**count - 1)
    while first < last:  # wide boxes first: a hard place must not starve the others
        box = room.boxes[first % capacity]
        start, end, still, monotone = box[0], box[1], int(box[2]), 0
        first += 1
        if first <= budget:
            still, monotone = examined(table, forms, start, end, still, room)
        for k in range(count):
            if not monotone & (1 << k):
                continue
            row = forms.rows[forms.leading[k]]
            at_start, at_end = value(table, start, row[0], room.at), value(table, end, row[0], room.at)
            if not (excludes_zero(at_start) and excludes_zero(at_end)):
                continue
            still &= ~(1 << k)
            if (at_start[0] > 0.0) == (at_end[0] > 0.0):
                continue
            if zeros < brackets.shape[0]:
                bracket = brackets[zeros]
                one, other, slope = sharpened(table, row, start, end, at_end[0] > 0.0, room)
                bracket[0], bracket[1], bracket[2] = float(k), one, other
                bracket[3], bracket[4] = slope
            zeros += 1
        if still == 0:
            continue
        cut = start + CUT * (end - start)
        wide = end - start > max(SMALLEST * (high - low), RESOLVED * max(abs(start), abs(end)))
        if wide and first <= budget and last - first + 2 <= capacity:
            for one, other in ((start, cut), (cut, end)):
                box = room.boxes[last % capacity]
                box[0], box[1], box[2] = one, other, float(still)
                last += 1
        else:
            if left < open_boxes.shape[0]:
                box = open_boxes[left]
                box[0], box[1], box[2] = start, end, float(still)
            left += 1
    return Found(zeros, left)
