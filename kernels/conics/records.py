"""Fits with parabolas and conics, by distance and by area, as records (`osculant.kernels.operations`)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.conics import area_exchange, area_scan, exchange, minimax, scan, shapes
from osculant.kernels.conics.pencil import pencil
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import IN_THE_PLANE, Frame, Source
from osculant.kernels.generated import laws
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel
from osculant.kernels.operations import EXACT, SETTLED, SHAPE, Rules, register
from osculant.kernels.quadrature import by_law


class Parabola(NamedTuple):
    """The parabola tangent at both ends, by its Hausdorff distance."""


class Conic(NamedTuple):
    """The conic with the least Hausdorff distance."""


class ParabolaArea(NamedTuple):
    """The parabola, by the area between."""


class EquisymmetricConic(NamedTuple):
    """The conic whose two moons have the same area."""


class LeastAreaConic(NamedTuple):
    """The conic with the least area between."""


class Row(NamedTuple):
    """What a row of the table says.

    P₀ and T₀ are the start and its tangent, P₂ the end; ``reach`` is |V|, w times the distance of the middle
    control point from P₀.  Q = 0 is the chord.
    """

    a: float
    b: float
    error: float
    reason: float
    q: float
    x0: float
    y0: float
    tx0: float
    ty0: float
    x2: float
    y2: float
    weight: float
    reach: float


@kernel
def record(fit: Any, row: np.ndarray[Any, Any], q: float, start: Frame, end: Frame, source: Source) -> None:
    """Write the shape of the member Q into a `Row`."""
    pen = pencil(start, end, source.place.noise)
    w, reach = 1.0, 0.5 * pen.chord  # the chord
    if q > 0.0:
        w, reach = generated.weight(q, pen.chord, pen.sin_a, pen.sin_b, pen.sin_psi)
    row[SHAPE] = q
    row[SHAPE + 1], row[SHAPE + 2], row[SHAPE + 3], row[SHAPE + 4] = start.x, start.y, start.tx, start.ty
    row[SHAPE + 5], row[SHAPE + 6], row[SHAPE + 7], row[SHAPE + 8] = end.x, end.y, w, reach


ALIKE = {**IN_THE_PLANE, "workspace": workspace, "record": record}
BY_DISTANCE = {**ALIKE, "renew": exchange.unvisited, "confirm": scan.confirm}
BY_AREA = {**ALIKE, "begin": area_exchange.first_level, "confirm": area_scan.confirm}

register(
    Parabola,
    len(Row._fields),
    **BY_DISTANCE,
    shape=shapes.of_parabola,
    rules=Rules(float(laws.PARABOLA_ORDER), SETTLED),
    begin=exchange.one_peak,
    step=exchange.visit_one,
    best=minimax.best_parabola,
    density=by_law(laws.parabola_density),
)
register(
    Conic,
    len(Row._fields),
    **BY_DISTANCE,
    shape=shapes.of_conic,
    rules=Rules(float(laws.CONIC_ORDER), SETTLED),
    begin=exchange.two_peaks,
    step=exchange.visit_two,
    best=minimax.best_conic,
    density=by_law(laws.conic_density),
)
register(
    ParabolaArea,
    len(Row._fields),
    **BY_AREA,
    shape=shapes.of_parabola,
    rules=Rules(float(laws.PARABOLA_AREA_ORDER), EXACT),
    step=area_exchange.parabola_area,
    best=area_scan.best_parabola,
    density=by_law(laws.parabola_area_density),
)
register(
    EquisymmetricConic,
    len(Row._fields),
    **BY_AREA,
    shape=shapes.of_conic,
    rules=Rules(float(laws.CONIC_AREA_ORDER), EXACT),
    step=area_exchange.equal_area,
    best=area_scan.best_equal,
    density=by_law(laws.conic_area_density),
)
register(
    LeastAreaConic,
    len(Row._fields),
    **BY_AREA,
    shape=shapes.of_conic,
    rules=Rules(float(laws.CONIC_AREA_ORDER), EXACT),
    step=area_exchange.stationary_area,
    best=area_scan.best_least,
    density=by_law(laws.conic_area_density),  # the same law
)
