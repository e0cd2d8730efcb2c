"""Rows of biarcs as pieces in the user's coordinates."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.plane import Place, user_point
from osculant.kernels.jit import kernel
from osculant.kernels.operations import SHAPE, A, B


class Arcs(NamedTuple):
    """Two circular arcs from P₀ over the junction P₁ to P₂, for the parameters [a, b].

    (tx0, ty0) and (tx1, ty1) are the unit tangents at P₀ and P₁, ``bend0`` and ``bend1`` the arcs' signed
    curvatures, positive where they turn left.
    """

    a: float
    b: float
    error: float
    x0: float
    y0: float
    x1: float
    y1: float
    x2: float
    y2: float
    tx0: float
    ty0: float
    tx1: float
    ty1: float
    bend0: float
    bend1: float


@kernel
def of_biarc(fit: Any, row: np.ndarray[Any, Any], place: Place, error: float) -> Arcs:
    """The piece of a row."""
    x0, y0 = user_point(place, row[SHAPE + 1], row[SHAPE + 2])
    x2, y2 = user_point(place, row[SHAPE + 5], row[SHAPE + 6])
    x1, y1 = user_point(place, row[SHAPE + 7], row[SHAPE + 8])
    dx, dy = row[SHAPE + 7] - row[SHAPE + 1], row[SHAPE + 8] - row[SHAPE + 2]
    chord = math.hypot(dx, dy)
    dx, dy = dx / chord, dy / chord
    tx, ty, side = row[SHAPE + 3], row[SHAPE + 4], place.side
    dot, cross = tx * dx + ty * dy, tx * dy - ty * dx
    turned_x, turned_y = dx * dot - dy * cross, (dy * dot + dx * cross) * side
    bend0, bend1 = row[SHAPE + 9] * side * place.scale, row[SHAPE + 10] * side * place.scale
    return Arcs(
        row[A], row[B], error, x0, y0, x1, y1, x2, y2, tx, ty * side, turned_x, turned_y, bend0, bend1
    )
