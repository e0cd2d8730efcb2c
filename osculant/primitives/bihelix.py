"""Bihelices: pairs of helical arcs with a common tangent, tangent to a space curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.primitive import Itself, Primitive

if TYPE_CHECKING:
    from osculant.pieces.helices import SpacePiece, Vector
    from osculant.pieces.piece import Floats


def equioscillating(order: int) -> Any:
    """The kernels' record of the rule that makes the errors on both sides of the junction equal."""
    from osculant.kernels.bihelices.family import EQUIOSCILLATING
    from osculant.kernels.bihelices.records import Bihelix

    return Bihelix(EQUIOSCILLATING, float(order))


def thesis(order: int) -> Any:
    """The kernels' record of the rule of section 4.1.2."""
    from osculant.kernels.bihelices.family import THESIS
    from osculant.kernels.bihelices.records import Bihelix

    return Bihelix(THESIS, float(order))


def pieces(rows: Floats, shapes: Floats) -> list[SpacePiece]:
    """Shapes of bihelices (`kernels.bihelices.shapes.Helices`), (n, numbers), as pieces.

    ``rows`` of the kernels' table tell nothing more.

    Raises:
        DomainError: an arc of no length.
    """
    from osculant.kernels.bihelices.shapes import Helices
    from osculant.pieces.helices import HelixArc, SpacePiece

    made = []
    for values in shapes.tolist():
        h = Helices(*values)
        arcs = (
            HelixArc(
                (h.px0, h.py0, h.pz0), (h.tx0, h.ty0, h.tz0), (h.vx0, h.vy0, h.vz0),
                h.curvature0, h.torsion0, h.length0,
            ),
            HelixArc(
                (h.px1, h.py1, h.pz1), (h.tx1, h.ty1, h.tz1), (h.vx1, h.vy1, h.vz1),
                h.curvature1, h.torsion1, h.length1,
            ),
        )  # fmt: skip
        made.append(SpacePiece((h.a, h.b), arcs, h.error, h.t))
    return made


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """Small bihelices between two frames, made of circular arcs: see `osculant.pieces.bridges`."""
    from osculant.pieces.bridges import space_arcs

    return space_arcs(interval, start, end, error)


def segment(interval: tuple[float, float], start: Vector, end: Vector, error: float = 0.0) -> SpacePiece:
    """The straight piece between two points.

    >>> segment((0.0, 1.0), (0.0, 0.0, 1.0), (0.0, 0.0, 3.0)).arcs[0].length
    2.0
    """
    from osculant.pieces.helices import HelixArc, SpacePiece

    length = math.dist(start, end)
    x, y, z = ((last - first) / length for first, last in zip(start, end))
    return SpacePiece(interval, (HelixArc(start, (x, y, z), (x, y, z), 0.0, 0.0, length),), error)


BIHELIX = Primitive(
    name="bihelix",
    plural="bihelices",
    dimension=3,
    arcs=("helix", "arc", "segment"),
    methods={
        "hausdorff": {
            "equioscillating": equioscillating,
            "thesis": thesis,
        },
    },
    theory=("vertex",),
    itself=Itself("helix", ("vertex", "slope"), lambda exact: exact.circular_helix, turning=2 * math.pi),
    theorems={},
    pieces=pieces,
    segment=segment,
    bridge=bridge,
    monotone=False,  # only while errors are small
)
