"""Rows of cubics as pieces in the user's coordinates."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.plane import Place, user_point
from osculant.kernels.jit import kernel
from osculant.kernels.operations import SHAPE, A, B


class Bezier(NamedTuple):
    """The Bézier curve with the control points P₀, P₁, P₂, P₃, for the parameters [a, b]."""

    a: float
    b: float
    error: float
    x0: float
    y0: float
    x1: float
    y1: float
    x2: float
    y2: float
    x3: float
    y3: float


@kernel
def of_cubic(fit: Any, row: np.ndarray[Any, Any], place: Place, error: float) -> Bezier:
    """The piece of a row."""
    arm0, arm3 = row[SHAPE + 8] / place.scale, row[SHAPE + 9] / place.scale
    x0, y0 = user_point(place, row[SHAPE], row[SHAPE + 1])
    x3, y3 = user_point(place, row[SHAPE + 4], row[SHAPE + 5])
    x1, y1 = x0 + arm0 * row[SHAPE + 2], y0 + arm0 * row[SHAPE + 3] * place.side
    x2, y2 = x3 - arm3 * row[SHAPE + 6], y3 - arm3 * row[SHAPE + 7] * place.side
    return Bezier(row[A], row[B], error, x0, y0, x1, y1, x2, y2, x3, y3)
