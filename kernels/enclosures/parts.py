"""Where a curve is finite, nearly a polynomial and not turning back, from enclosed Taylor coefficients."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.enclosures.balls import is_finite
from osculant.kernels.enclosures.programs import Table, run
from osculant.kernels.jit import kernel

#: vectors that are within so much of one, in parts of its length, are within a right angle of each other
STRAIGHT = math.sqrt(0.5)


@kernel
def clearness(
    table: Table, rows: np.ndarray[Any, Any], middle: float, half: float, values: np.ndarray[Any, Any]
) -> float:
    """Down to what accuracy a box is no feature of the curve; infinite where a coefficient is not finite.

    ``rows`` (coordinates, terms) are the coefficients' places among the program's values.  The last term of
    Taylor's formula about the middle is at most so large; and either all tangents are within a right angle,
    so that the curve does not turn back, or the box as a whole is as small.
    """
    run(table, middle, half * (1.0 + 2.0**-50), values)
    order, largest, length, velocity, doubt = rows.shape[1] - 1, 0.0, 0.0, 0.0, 0.0
    for i in range(rows.shape[0]):
        for k in range(order + 1):
            index = rows[i, k]
            if not is_finite((values[index, 0], values[index, 1])):
                return math.inf
        first, last = values[rows[i, 1]], values[rows[i, order]]
        largest = max(largest, (abs(last[0]) + last[1]) * half**order)
        velocity, doubt = math.hypot(velocity, first[0]), math.hypot(doubt, first[1])
        length += 2.0 * half * (abs(first[0]) + first[1])
    return largest if doubt <= STRAIGHT * velocity else max(largest, length)


@kernel
def polynomial_parts(
    table: Table, rows: np.ndarray[Any, Any], accuracy: float, least: float, most: int, count: int,
    pending: np.ndarray[Any, Any], edges: np.ndarray[Any, Any], left: np.ndarray[Any, Any],
    values: np.ndarray[Any, Any],
) -> tuple[int, int]:  # fmt: skip
    """Halve the ``count`` parts that are pending until each is clear to an accuracy, wide ones first.

    Returns how many new ``edges`` were written, (capacity, 2): each with the accuracy below which it is one;
    and how many parts are left as they are, written to ``left`` (capacity, 2) as far as they fit: those
    narrower than ``least``, and all after ``most`` visits.  Ever so coarse an accuracy asks that Taylor
    coefficients are finite.  ``pending`` (capacity, 3) is for parts to come, each with its parent's accuracy.
    """
    first, last, found, remaining = 0, count, 0, 0
    while first < last:
        part = pending[first % pending.shape[0]]
        a, b, level = part[0], part[1], part[2]
        first += 1
        middle, half = 0.5 * (a + b), 0.5 * (b - a)
        if first <= most:
            level = min(level, clearness(table, rows, middle, half, values))
        if level <= accuracy:
            continue
        room = found < edges.shape[0] and last - first + 2 <= pending.shape[0]
        if first > most or half < least or not a < middle < b or not room:
            if remaining < left.shape[0]:
                left[remaining, 0], left[remaining, 1] = a, b
            remaining += 1
            continue
        edges[found, 0], edges[found, 1] = middle, level
        found += 1
        for one, other in ((a, middle), (middle, b)):
            part = pending[last % pending.shape[0]]
            part[0], part[1], part[2] = one, other, level
            last += 1
    return found, remaining
