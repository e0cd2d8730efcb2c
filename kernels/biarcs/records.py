"""Fits with biarcs, by distance and by area, as records (`osculant.kernels.operations`)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.biarcs import area_exchange, area_scan, exchange, scan, shapes
from osculant.kernels.biarcs.family import Biarc as Arcs
from osculant.kernels.biarcs.family import family, member
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import IN_THE_PLANE, Frame, Source
from osculant.kernels.generated import laws
from osculant.kernels.jit import kernel
from osculant.kernels.operations import EXACT, SETTLED, SHAPE, Rules, register
from osculant.kernels.quadrature import by_law


class Biarc(NamedTuple):
    """The biarc with the least Hausdorff distance."""


class EquisymmetricBiarc(NamedTuple):
    """The biarc whose two moons have the same area."""


class Row(NamedTuple):
    """What a row of the table says: μ, p_L, T_L, p_R, the junction and the curvatures of both arcs."""

    a: float
    b: float
    error: float
    reason: float
    mu: float
    x0: float
    y0: float
    tx0: float
    ty0: float
    x2: float
    y2: float
    x1: float
    y1: float
    bend0: float
    bend1: float


@kernel
def write_shape(row: np.ndarray[Any, Any], mu: float, arcs: Arcs) -> None:
    """Write the shape of a biarc into a `Row`."""
    row[SHAPE] = mu
    row[SHAPE + 1], row[SHAPE + 2], row[SHAPE + 3], row[SHAPE + 4] = arcs.x0, arcs.y0, arcs.tx0, arcs.ty0
    row[SHAPE + 5], row[SHAPE + 6], row[SHAPE + 7], row[SHAPE + 8] = arcs.x2, arcs.y2, arcs.x1, arcs.y1
    row[SHAPE + 9], row[SHAPE + 10] = arcs.bend0, arcs.bend1


@kernel
def record(fit: Any, row: np.ndarray[Any, Any], mu: float, start: Frame, end: Frame, source: Source) -> None:
    """Write the shape of the member μ."""
    write_shape(row, mu, member(family(start, end), mu))


ALIKE = {**IN_THE_PLANE, "workspace": workspace, "record": record, "shape": shapes.of_biarc}

register(
    Biarc,
    len(Row._fields),
    **ALIKE,
    rules=Rules(float(laws.BIARC_ORDER), SETTLED),
    begin=exchange.first_peaks,
    step=exchange.visit,
    confirm=scan.confirm,
    best=scan.best,
    density=by_law(laws.biarc_density),
)
register(
    EquisymmetricBiarc,
    len(Row._fields),
    **ALIKE,
    rules=Rules(float(laws.BIARC_AREA_ORDER), EXACT),
    begin=area_exchange.first_places,
    step=area_exchange.visit,
    confirm=area_scan.confirm,
    best=area_scan.best,
    density=by_law(laws.biarc_area_density),
)
