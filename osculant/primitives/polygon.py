"""Inscribed polygons: chords between points of the curve, in the plane and in space."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.primitives import bihelix, conic
from osculant.primitives.primitive import Primitive, Theorem, columns

if TYPE_CHECKING:
    from osculant.pieces.conics import Piece
    from osculant.pieces.helices import SpacePiece
    from osculant.pieces.piece import Floats


#: pieces touch the curve with their ends only, and their least number is among such
INSCRIBED = "the fewest inscribed that were found"


def chord(order: int) -> Any:
    """The kernels' record of chords in the plane, by their Hausdorff distance."""
    from osculant.kernels.polygons.records import Chord

    return Chord()


def chord_area(order: int) -> Any:
    """The kernels' record of chords in the plane, by the area between."""
    from osculant.kernels.polygons.records import ChordArea

    return ChordArea()


def space_chord(order: int) -> Any:
    """The kernels' record of chords in space."""
    from osculant.kernels.polygons.records import SpaceChord

    return SpaceChord()


def plane_pieces(rows: Floats, shapes: Floats) -> list[Piece]:
    """Shapes of chords (`kernels.polygons.shapes.Segment`), (n, numbers), as segments of the plane.

    ``rows`` of the kernels' table tell nothing more.
    """
    from osculant.kernels.polygons.shapes import Segment
    from osculant.pieces.conics import Piece

    chords = columns(Segment, shapes)
    ends = zip(chords.x0, chords.y0), zip(chords.x1, chords.y1)
    return list(map(Piece.segment, zip(chords.a, chords.b), *ends, chords.error))


def space_pieces(rows: Floats, shapes: Floats) -> list[SpacePiece]:
    """The same in space, of `kernels.polygons.shapes.SpaceSegment`."""
    from osculant.kernels.polygons.shapes import SpaceSegment

    chords = columns(SpaceSegment, shapes)
    ends = zip(chords.x0, chords.y0, chords.z0), zip(chords.x1, chords.y1, chords.z1)
    return list(map(bihelix.segment, zip(chords.a, chords.b), *ends, chords.error))


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """The chord between two frames of the plane."""
    from osculant.pieces.conics import Piece

    return [Piece.segment(interval, start[0], end[0], error)]


def space_bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """The chord between two frames in space."""
    return [bihelix.segment(interval, start[0], end[0], error)]


POLYGON = Primitive(
    name="polygon",
    plural="polygons",
    dimension=2,
    arcs=("segment",),
    methods={"hausdorff": {"inscribed": chord}, "area": {"inscribed": chord_area}},
    theory=(),
    itself=None,
    theorems={("hausdorff", "inscribed"): Theorem("X3.1-2")},
    pieces=plane_pieces,
    segment=conic.segment,
    bridge=bridge,
    smooth=False,
    fewest=INSCRIBED,
)

SPACE_POLYGON = Primitive(
    name="polygon",
    plural="polygons",
    dimension=3,
    arcs=("segment",),
    methods={"hausdorff": {"inscribed": space_chord}},
    theory=(),
    itself=None,
    theorems={},
    pieces=space_pieces,
    segment=bihelix.segment,
    bridge=space_bridge,
    splits=(),
    monotone=False,
    smooth=False,
    fewest=INSCRIBED,
)
