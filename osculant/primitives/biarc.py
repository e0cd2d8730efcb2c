"""Biarcs: pairs of circular arcs with a common tangent, tangent to the curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.conic import segment
from osculant.primitives.primitive import Itself, Primitive, Theorem, user_point

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.kernels.curves.plane import Place
    from osculant.pieces.biarcs import Biarc


def biarc_piece(values: Sequence[float], place: Place, error: float) -> Biarc:
    """A row of the kernels' table (`kernels.biarcs.records.Row`) as a biarc, or as the one arc that it is."""
    from osculant.kernels.biarcs.records import Row
    from osculant.pieces.biarcs import Biarc

    row = Row(*values)
    scale, side = place.scale, place.side
    chord = math.hypot(row.x1 - row.x0, row.y1 - row.y0)
    dx, dy = (row.x1 - row.x0) / chord, (row.y1 - row.y0) / chord
    dot, cross = row.tx0 * dx + row.ty0 * dy, row.tx0 * dy - row.ty0 * dx
    return Biarc(
        "arc" if row.bend0 == row.bend1 and error == 0 else "biarc",
        (row.a, row.b),
        user_point(place, row.x0, row.y0),
        user_point(place, row.x1, row.y1),
        user_point(place, row.x2, row.y2),
        ((row.tx0, row.ty0 * side), (dx * dot - dy * cross, (dy * dot + dx * cross) * side)),
        (row.bend0 * side * scale, row.bend1 * side * scale),
        error,
    )


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """Small biarcs between two frames: see `osculant.pieces.bridges`."""
    from osculant.pieces.bridges import biarcs

    return biarcs(interval, start, end, error)


def equioscillating(order: int) -> Any:
    """The kernels' record of the biarc with the least Hausdorff distance."""
    from osculant.kernels.biarcs.records import Biarc

    return Biarc()


def equisymmetric(order: int) -> Any:
    """The kernels' record of the biarc whose two moons have the same area."""
    from osculant.kernels.biarcs.records import EquisymmetricBiarc

    return EquisymmetricBiarc()


BIARC = Primitive(
    name="biarc",
    plural="biarcs",
    dimension=2,
    arcs=("arc", "segment"),
    methods={
        "hausdorff": {"equioscillating": equioscillating},
        "area": {"equisymmetric": equisymmetric},
    },
    theory=("vertex",),
    itself=Itself("circle", ("vertex",), lambda exact: exact.circle, turning=2 * math.pi),
    theorems={("hausdorff", "equioscillating"): Theorem("X5.3-7")},
    piece=biarc_piece,
    segment=segment,
    bridge=bridge,
)
