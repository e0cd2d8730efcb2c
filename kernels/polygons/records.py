"""Fits with inscribed polygons, by distance and by area, as records (`osculant.kernels.operations`)."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves import plane, space
from osculant.kernels.generated import laws
from osculant.kernels.jit import kernel
from osculant.kernels.operations import EXACT, SETTLED, SHAPE, Rules, register
from osculant.kernels.polygons import areas, chords, shapes
from osculant.kernels.quadrature import by_law

#: the dimension of the coordinates, the start and then the end, which a row has from `SHAPE` on
PLANE, SPACE = 2, 3


class Chord(NamedTuple):
    """The chord of an arc in the plane, by its Hausdorff distance."""


class ChordArea(NamedTuple):
    """The chord of an arc in the plane, by the area between."""


class SpaceChord(NamedTuple):
    """The chord of an arc in space, by its Hausdorff distance."""


@kernel
def no_space(fit: Any) -> float:
    """No scratch space is needed."""
    return 0.0


@kernel
def record_in_the_plane(
    fit: Any, row: np.ndarray[Any, Any], piece: float, start: plane.Frame, end: plane.Frame, source: Any
) -> None:
    """Write both ends, in the kernel's coordinates."""
    row[SHAPE], row[SHAPE + 1], row[SHAPE + 2], row[SHAPE + 3] = start.x, start.y, end.x, end.y


@kernel
def record_in_space(
    fit: Any, row: np.ndarray[Any, Any], piece: float, start: space.Frame, end: space.Frame, source: Any
) -> None:
    """Write both ends, in the kernel's coordinates."""
    for i in range(SPACE):
        row[SHAPE + i], row[SHAPE + SPACE + i] = start.point[i], end.point[i]


@kernel
def density_in_space(fit: Any, address: int, scale: float, jet: np.ndarray[Any, Any], t: float) -> float:
    """√κ|α̇|, which is the density of the law in space but for its constant."""
    found = space.frenet_at(address, scale, jet, t)
    value = math.sqrt(found[1]) * found[0]
    return value if math.isfinite(value) else 0.0


BY_DISTANCE = {
    "workspace": no_space,
    "begin": chords.first_peak,
    "step": chords.visit,
    "confirm": chords.confirm,
    "best": chords.best,
    "rules": Rules(float(laws.POLYGON_ORDER), SETTLED),
}

register(
    Chord,
    SHAPE + 2 * PLANE,
    **plane.IN_THE_PLANE,
    **BY_DISTANCE,
    rise=chords.rise_in_the_plane,
    record=record_in_the_plane,
    shape=shapes.in_the_plane,
    density=by_law(laws.polygon_density),
)
register(
    SpaceChord,
    SHAPE + 2 * SPACE,
    **space.IN_SPACE,
    **BY_DISTANCE,
    rise=chords.rise_in_space,
    record=record_in_space,
    shape=shapes.in_space,
    density=density_in_space,
)
register(
    ChordArea,
    SHAPE + 2 * PLANE,
    **plane.IN_THE_PLANE,
    workspace=no_space,
    begin=areas.nothing,
    step=areas.visit,
    confirm=areas.confirm,
    best=areas.best,
    rules=Rules(float(laws.POLYGON_AREA_ORDER), EXACT),
    record=record_in_the_plane,
    shape=shapes.in_the_plane,
    density=by_law(laws.polygon_area_density),
)
