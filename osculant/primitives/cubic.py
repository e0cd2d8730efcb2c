"""Cubic Bézier curves, tangent to the curve at both ends, with both arms free."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.primitive import Primitive, user_point

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.kernels.curves.plane import Place
    from osculant.pieces.conics import Point
    from osculant.pieces.cubics import Cubic


def least_distance(order: int) -> Any:
    """The kernels' record of the cubic with the least Hausdorff distance."""
    from osculant.kernels.cubics.records import Cubic

    return Cubic()


def least_area(order: int) -> Any:
    """The kernels' record of the cubic with the least area between."""
    from osculant.kernels.cubics.records import CubicArea

    return CubicArea()


def cubic_piece(values: Sequence[float], place: Place, error: float) -> Cubic:
    """A row of the kernels' table (`kernels.cubics.records.Row`) as a cubic."""
    from osculant.kernels.cubics.records import Row
    from osculant.pieces.cubics import Cubic

    row = Row(*values)
    arm0, arm3 = row.a0 / place.scale, row.a3 / place.scale
    start, end = user_point(place, row.x0, row.y0), user_point(place, row.x3, row.y3)
    first = start[0] + arm0 * row.tx0, start[1] + arm0 * row.ty0 * place.side
    last = end[0] - arm3 * row.tx3, end[1] - arm3 * row.ty3 * place.side
    return Cubic((row.a, row.b), start, (first, last), end, error)


def segment(interval: tuple[float, float], start: Point, end: Point) -> Any:
    """The straight piece between two points."""
    from osculant.pieces.conics import Piece

    return Piece.segment(interval, start, end)


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """A small cubic between two frames, its arms a third of the chord."""
    from osculant.pieces.cubics import Cubic

    ((x0, y0), (tx0, ty0)), ((x3, y3), (tx3, ty3)) = start, end
    arm = math.dist((x0, y0), (x3, y3)) / 3
    handles = (x0 + arm * tx0, y0 + arm * ty0), (x3 - arm * tx3, y3 - arm * ty3)
    return [Cubic(interval, (x0, y0), handles, (x3, y3), error)]


CUBIC = Primitive(
    name="cubic",
    plural="cubics",
    dimension=2,
    arcs=("cubic", "segment"),
    methods={
        "hausdorff": {"equioscillating": least_distance},
        "area": {"minimal-area": least_area},
    },
    theory=(),
    itself=None,
    # where D keeps its sign and the number of cubics with six contacts does not change, no longer arc of
    # thousands had a smaller error; elsewhere errors do fall: an observation, no proof
    theorems={},
    piece=cubic_piece,
    segment=segment,
    bridge=bridge,
    splits=(),
    monotone=False,
    few=8,
)
