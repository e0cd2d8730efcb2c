"""Rows of parabolas and conics as pieces in the user's coordinates."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.plane import Place, user_point
from osculant.kernels.jit import kernel
from osculant.kernels.operations import SHAPE, A, B


class Arc(NamedTuple):
    """The arc ((1−u)²P₀ + 2u(1−u)M + u²P₂)/((1−u)² + 2u(1−u)w + u²), 0 ≤ u ≤ 1, for the parameters [a, b].

    M = (mx, my) is the weight w times the middle control point.
    """

    a: float
    b: float
    error: float
    x0: float
    y0: float
    mx: float
    my: float
    x2: float
    y2: float
    weight: float


@kernel
def arc(row: np.ndarray[Any, Any], place: Place, error: float, weight: float) -> Arc:
    """The arc of a row with a weight; Q = 0 is the chord."""
    x0, y0 = user_point(place, row[SHAPE + 1], row[SHAPE + 2])
    x2, y2 = user_point(place, row[SHAPE + 5], row[SHAPE + 6])
    if row[SHAPE] == 0.0:
        return Arc(row[A], row[B], error, x0, y0, x0 / 2 + x2 / 2, y0 / 2 + y2 / 2, x2, y2, 1.0)
    reach = row[SHAPE + 8] / place.scale
    mx, my = weight * x0 + reach * row[SHAPE + 3], weight * y0 + reach * row[SHAPE + 4] * place.side
    return Arc(row[A], row[B], error, x0, y0, mx, my, x2, y2, weight)


@kernel
def of_conic(fit: Any, row: np.ndarray[Any, Any], place: Place, error: float) -> Arc:
    """The piece of a conic's row."""
    return arc(row, place, error, row[SHAPE + 7])


@kernel
def of_parabola(fit: Any, row: np.ndarray[Any, Any], place: Place, error: float) -> Arc:
    """The piece of a parabola's row."""
    return arc(row, place, error, 1.0)
