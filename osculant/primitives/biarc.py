"""Biarcs: pairs of circular arcs with a common tangent, tangent to the curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.conic import segment
from osculant.primitives.primitive import Itself, Primitive, Theorem, columns

if TYPE_CHECKING:
    from osculant.pieces.biarcs import Biarc
    from osculant.pieces.piece import Floats


def pieces(rows: Floats, shapes: Floats) -> list[Biarc]:
    """Shapes of biarcs (`kernels.biarcs.shapes.Arcs`), (n, numbers), as biarcs, or as arcs where two are one.

    ``rows`` of the kernels' table tell nothing more.
    """
    from osculant.kernels.biarcs.shapes import Arcs
    from osculant.pieces.biarcs import Biarc
    from osculant.pieces.piece import from_columns

    arcs = columns(Arcs, shapes)
    bends = list(zip(arcs.bend0, arcs.bend1))
    kinds = [
        "arc" if first == last and error == 0 else "biarc" for (first, last), error in zip(bends, arcs.error)
    ]
    points = zip(arcs.x0, arcs.y0), zip(arcs.x1, arcs.y1), zip(arcs.x2, arcs.y2)
    tangents = zip(zip(arcs.tx0, arcs.ty0), zip(arcs.tx1, arcs.ty1))
    return from_columns(Biarc, kinds, zip(arcs.a, arcs.b), *points, tangents, bends, arcs.error)


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
    pieces=pieces,
    segment=segment,
    bridge=bridge,
)
