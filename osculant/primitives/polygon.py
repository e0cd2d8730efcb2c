"""Inscribed polygons: chords between points of the curve, in the plane and in space."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.primitives import bihelix, conic
from osculant.primitives.primitive import Primitive, Theorem, user_point

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.kernels.curves import plane, space
    from osculant.pieces.conics import Piece
    from osculant.pieces.helices import SpacePiece


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


def plane_piece(row: Sequence[float], place: plane.Place, error: float) -> Piece:
    """A row of the kernels' table (`kernels.polygons.records`) as a segment of the plane."""
    from osculant.kernels.operations import SHAPE
    from osculant.pieces.conics import Piece

    a, b, *_ = row
    x0, y0, x1, y1 = row[SHAPE:]
    return Piece.segment((a, b), user_point(place, x0, y0), user_point(place, x1, y1), error)


def space_piece(row: Sequence[float], place: space.Place, error: float) -> SpacePiece:
    """A row of the kernels' table as a segment in space."""
    from dataclasses import replace

    from osculant.kernels.operations import SHAPE

    a, b, *_ = row
    back, ends = 1.0 / place.scale, row[SHAPE:]

    def user(x: float, y: float, z: float) -> tuple[float, float, float]:
        return x * back + place.x, y * back + place.y, z * back + place.z

    return replace(bihelix.segment((a, b), user(*ends[:3]), user(*ends[3:])), error=error)


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """The chord between two frames of the plane."""
    from osculant.pieces.conics import Piece

    return [Piece.segment(interval, start[0], end[0], error)]


def space_bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """The chord between two frames in space."""
    from dataclasses import replace

    return [replace(bihelix.segment(interval, start[0], end[0]), error=error)]


POLYGON = Primitive(
    name="polygon",
    plural="polygons",
    dimension=2,
    arcs=("segment",),
    methods={"hausdorff": {"inscribed": chord}, "area": {"inscribed": chord_area}},
    theory=(),
    itself=None,
    theorems={("hausdorff", "inscribed"): Theorem("X3.1-2")},
    piece=plane_piece,
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
    piece=space_piece,
    segment=bihelix.segment,
    bridge=space_bridge,
    splits=(),
    monotone=False,
    smooth=False,
    fewest=INSCRIBED,
)
