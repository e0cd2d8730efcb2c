"""Cubic Bézier curves, tangent to the curve at both ends, with both arms free."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.primitive import Primitive, columns

if TYPE_CHECKING:
    from osculant.pieces.conics import Point
    from osculant.pieces.cubics import Cubic
    from osculant.pieces.piece import Floats


def least_distance(order: int) -> Any:
    """The kernels' record of the cubic with the least Hausdorff distance."""
    from osculant.kernels.cubics.records import Cubic

    return Cubic()


def least_area(order: int) -> Any:
    """The kernels' record of the cubic with the least area between."""
    from osculant.kernels.cubics.records import CubicArea

    return CubicArea()


def pieces(rows: Floats, shapes: Floats) -> list[Cubic]:
    """Shapes of cubics (`kernels.cubics.shapes.Bezier`), (n, numbers), as cubics.

    ``rows`` of the kernels' table tell nothing more.
    """
    from osculant.kernels.cubics.shapes import Bezier
    from osculant.pieces.cubics import Cubic
    from osculant.pieces.piece import from_columns

    curve = columns(Bezier, shapes)
    inner = zip(zip(curve.x1, curve.y1), zip(curve.x2, curve.y2))
    ends = zip(curve.x0, curve.y0), zip(curve.x3, curve.y3)
    return from_columns(Cubic, zip(curve.a, curve.b), ends[0], inner, ends[1], curve.error)


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
    pieces=pieces,
    segment=segment,
    bridge=bridge,
    splits=(),
    monotone=False,
    few=8,
)
