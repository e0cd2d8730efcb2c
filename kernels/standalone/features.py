"""Where a curve that is known only now has its features: edges of parts that samples do not see beyond."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.enclosures.parts import polynomial_parts
from osculant.kernels.enclosures.programs import Table
from osculant.kernels.jit import kernel
from osculant.kernels.standalone.stretches import EDGES

#: equally long panels of a curve that only samples tell of, parts that wait to be halved at most, and equally
#: long panels in which special points are sought besides
PANELS, WAITING, SEEN = 64, 4096, 128


class Features(NamedTuple):
    """The Taylor program of a curve, as `osculant.kernels.enclosures` interprets it.

    Attributes:
        table: its instructions, with the constants' values.
        rows: (coordinates, terms) where the coefficients are among its values.
        values: room for these.
        known: whether there is a program; a curve of the caller's has none.
        first: how many parts there are at first.
        narrowest: parts are not halved below this part of the interval.
        most: parts that are looked at.
    """

    table: Table
    rows: np.ndarray[Any, Any]
    values: np.ndarray[Any, Any]
    known: bool
    first: int
    narrowest: float
    most: int


@kernel
def sort_rows(rows: np.ndarray[Any, Any], count: int) -> None:
    """Put the first ``count`` rows, of two numbers, in increasing order of the first, which is nearly so."""
    gap = count // 2
    while gap > 0:
        for i in range(gap, count):
            at, level, place = rows[i, 0], rows[i, 1], i
            while place >= gap and rows[place - gap, 0] > at:
                rows[place, 0], rows[place, 1] = rows[place - gap, 0], rows[place - gap, 1]
                place -= gap
            rows[place, 0], rows[place, 1] = at, level
        gap //= 2


@kernel
def grid_of(low: float, high: float, edges: np.ndarray[Any, Any], grid: np.ndarray[Any, Any]) -> int:
    """Fill ``grid`` with equally distant places and the edges, in order, with both ends; their number."""
    count = int(edges.shape[0])
    for i in range(count):
        grid[i, 0], grid[i, 1] = edges[i, 0], edges[i, 1]
    for i in range(SEEN + 1):
        grid[count, 0], grid[count, 1] = high if i == SEEN else low + (high - low) * i / SEEN, math.inf
        count += 1
    sort_rows(grid, count)
    return count


@kernel
def edges_of(
    features: Features, low: float, high: float, accuracy: float, edges: np.ndarray[Any, Any]
) -> int:
    """Fill ``edges`` (`EDGES`, 2) with places in order, each with the accuracy below which it is an edge.

    The same as `osculant.curves.enclosed.Enclosed.levels` has for the front door, for one accuracy.  Returns
    how many there are, −1 if too many.
    """
    width = high - low
    first = features.first if features.known else PANELS
    count = 0
    if features.known:
        pending, left = np.empty((WAITING, 3)), np.empty((1, 2))
        for i in range(first):
            pending[i, 0], pending[i, 2] = low + width * i / first, math.inf
            pending[i, 1] = high if i == first - 1 else low + width * (i + 1) / first
        table, rows, values = features.table, features.rows, features.values
        least = features.narrowest * width
        count, _ = polynomial_parts(
            table, rows, accuracy, least, features.most, first, pending, edges, left, values
        )
    if count + first > EDGES:
        return -1
    for i in range(1, first):
        edges[count, 0], edges[count, 1] = low + width * i / first, math.inf
        count += 1
    sort_rows(edges, count)
    return count
