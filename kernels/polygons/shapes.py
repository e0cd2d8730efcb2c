"""Rows of polygons as pieces in the user's coordinates."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves import plane, space
from osculant.kernels.jit import kernel
from osculant.kernels.operations import SHAPE, A, B


class Segment(NamedTuple):
    """The segment from P₀ to P₁, for the parameters [a, b]."""

    a: float
    b: float
    error: float
    x0: float
    y0: float
    x1: float
    y1: float


class SpaceSegment(NamedTuple):
    """The segment from P₀ to P₁ in space, for the parameters [a, b]."""

    a: float
    b: float
    error: float
    x0: float
    y0: float
    z0: float
    x1: float
    y1: float
    z1: float


@kernel
def in_the_plane(fit: Any, row: np.ndarray[Any, Any], place: plane.Place, error: float) -> Segment:
    """The piece of a row of the plane."""
    x0, y0 = plane.user_point(place, row[SHAPE], row[SHAPE + 1])
    x1, y1 = plane.user_point(place, row[SHAPE + 2], row[SHAPE + 3])
    return Segment(row[A], row[B], error, x0, y0, x1, y1)


@kernel
def in_space(fit: Any, row: np.ndarray[Any, Any], place: space.Place, error: float) -> SpaceSegment:
    """The piece of a row of space."""
    k = place.scale
    return SpaceSegment(
        row[A], row[B], error,
        row[SHAPE] / k + place.x, row[SHAPE + 1] / k + place.y, row[SHAPE + 2] / k + place.z,
        row[SHAPE + 3] / k + place.x, row[SHAPE + 4] / k + place.y, row[SHAPE + 5] / k + place.z,
    )  # fmt: skip
