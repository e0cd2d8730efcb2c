"""Fits with cubics, by distance and by area, as records (`osculant.kernels.operations`)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.cubics import (
    area_exchange,
    area_search,
    contact,
    exchange,
    minimax,
    scan,
    shapes,
)
from osculant.kernels.cubics.exchange import Arms
from osculant.kernels.curves.plane import IN_THE_PLANE, Frame, Source
from osculant.kernels.generated import laws
from osculant.kernels.jit import kernel
from osculant.kernels.operations import EXACT, SETTLED, SHAPE, Rules, register


class Cubic(NamedTuple):
    """The cubic, tangent at both ends, with the least Hausdorff distance."""


class CubicArea(NamedTuple):
    """The cubic, tangent at both ends, with the least area between."""


class Row(NamedTuple):
    """What a row of the table says: both ends with their tangents, and the arms along them."""

    a: float
    b: float
    error: float
    reason: float
    x0: float
    y0: float
    tx0: float
    ty0: float
    x3: float
    y3: float
    tx3: float
    ty3: float
    a0: float
    a3: float


@kernel
def record(fit: Any, row: np.ndarray[Any, Any], arms: Arms, start: Frame, end: Frame, source: Source) -> None:
    """Write the shape of a cubic into a `Row`."""
    row[SHAPE], row[SHAPE + 1], row[SHAPE + 2], row[SHAPE + 3] = start.x, start.y, start.tx, start.ty
    row[SHAPE + 4], row[SHAPE + 5], row[SHAPE + 6], row[SHAPE + 7] = end.x, end.y, end.tx, end.ty
    row[SHAPE + 8], row[SHAPE + 9] = arms.a0, arms.a3


#: no usable cubic was seen for arcs that turn by more
TURNING = 4.7
#: equidistant samples that tell four peaks
CHECKED = 16

ALIKE = {**IN_THE_PLANE, "workspace": scan.workspace, "record": record, "shape": shapes.of_cubic}

register(
    Cubic,
    len(Row._fields),
    **ALIKE,
    rules=Rules(float(laws.CUBIC_ORDER), SETTLED, checked=CHECKED, turning=TURNING),
    begin=exchange.begin,
    step=exchange.visit,
    confirm=minimax.confirm,
    best=minimax.best,
    density=contact.density,
)
register(
    CubicArea,
    len(Row._fields),
    **ALIKE,
    rules=Rules(float(laws.CUBIC_AREA_ORDER), EXACT, checked=CHECKED, turning=TURNING),
    begin=area_exchange.begin,
    step=area_exchange.visit,
    confirm=area_search.confirm,
    best=area_search.best,
    density=contact.area_density,
)
