"""Where a curve is finite, and where nearly a polynomial, from enclosures of its Taylor coefficients."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.enclosures.balls import is_finite
from osculant.kernels.enclosures.programs import Table, run
from osculant.kernels.jit import kernel

#: where boxes are divided: not in the middle, where formulas like to be singular
CUT = 0.48713


@kernel
def last_terms(
    table: Table, rows: np.ndarray[Any, Any], middle: float, half: float, values: np.ndarray[Any, Any]
) -> float:
    """The largest last term of Taylor's formula about the middle of a box; infinite where one is not finite.

    ``rows`` (coordinates, terms) are the coefficients' places among the program's values.
    """
    run(table, middle, half * (1.0 + 2.0**-50), values)
    order, largest = rows.shape[1] - 1, 0.0
    for i in range(rows.shape[0]):
        for k in range(order + 1):
            index = rows[i, k]
            if not is_finite((values[index, 0], values[index, 1])):
                return math.inf
        last = rows[i, order]
        largest = max(largest, (abs(values[last, 0]) + values[last, 1]) * half**order)
    return largest


@kernel
def polynomial_parts(
    table: Table, rows: np.ndarray[Any, Any], accuracy: float, least: float, most: int,
    edges: np.ndarray[Any, Any], pending: np.ndarray[Any, Any], count: int, values: np.ndarray[Any, Any],
) -> int:  # fmt: skip
    """Halve the ``count`` parts that are pending until each is a polynomial to an accuracy, wide ones first.

    The new edges are written to ``edges``, and how many there are is returned.  Parts below ``least``, and
    all beyond ``most`` visits, are left as they are.  ``pending`` (capacity, 2) holds the parts to come.
    """
    first, last, found, capacity = 0, count, 0, pending.shape[0]
    while first < last and first < most:
        a, b = pending[first % capacity, 0], pending[first % capacity, 1]
        first += 1
        middle, half = 0.5 * (a + b), 0.5 * (b - a)
        if half < least or not a < middle < b or found == edges.shape[0] or last - first + 2 > capacity:
            continue
        if last_terms(table, rows, middle, half, values) <= accuracy:
            continue
        edges[found] = middle
        found += 1
        pending[last % capacity, 0], pending[last % capacity, 1] = a, middle
        pending[(last + 1) % capacity, 0], pending[(last + 1) % capacity, 1] = middle, b
        last += 2
    return found


@kernel
def unclear(
    table: Table, rows: np.ndarray[Any, Any], low: float, high: float, least: float, most: int,
    boxes: np.ndarray[Any, Any], pending: np.ndarray[Any, Any], values: np.ndarray[Any, Any],
) -> int:  # fmt: skip
    """Boxes no wider than ``least`` in which the coefficients are not seen to be finite, from left to right.

    Written to ``boxes`` (capacity, 2); returns how many, −1 if they do not fit or after ``most`` visits.
    """
    open_boxes, found = 1, 0
    pending[0, 0], pending[0, 1] = low, high
    for _ in range(most):
        if open_boxes == 0:
            return found
        a, b = pending[open_boxes - 1, 0], pending[open_boxes - 1, 1]
        open_boxes -= 1
        middle = 0.5 * (a + b)
        if last_terms(table, rows, middle, max(b - middle, middle - a), values) < math.inf:
            continue
        cut = a + CUT * (b - a)
        if b - a <= least or not a < cut < b or open_boxes + 2 > pending.shape[0]:
            if found == boxes.shape[0]:
                return -1
            boxes[found, 0], boxes[found, 1] = a, b
            found += 1
            continue
        pending[open_boxes, 0], pending[open_boxes, 1] = cut, b
        pending[open_boxes + 1, 0], pending[open_boxes + 1, 1] = a, cut
        open_boxes += 2
    return -1
