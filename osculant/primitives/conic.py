"""Parabolas and conics: pieces that are arcs of them, tangent to the curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.primitive import Itself, Method, Primitive, Theorem, user_point

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.kernels.conics.records import Row
    from osculant.kernels.curves.plane import Place
    from osculant.pieces.conics import Piece, Point
    from osculant.pieces.kinds import ConicKind


def conic_piece(values: Sequence[float], place: Place, error: float) -> Piece:
    """A row of the kernels' table (`kernels.conics.records.Row`) as a conic arc."""
    from osculant.pieces.conics import classify

    row = _row(values)
    return _arc(row, place, error, classify(row.weight), row.weight)


def parabola_piece(values: Sequence[float], place: Place, error: float) -> Piece:
    """A row of the kernels' table as an arc of a parabola."""
    return _arc(_row(values), place, error, "parabola", 1.0)


def _row(values: Sequence[float]) -> Row:
    from osculant.kernels.conics.records import Row

    return Row(*values)


def _arc(row: Row, place: Place, error: float, kind: ConicKind, weight: float) -> Piece:
    from osculant.pieces.conics import Piece

    start, end = user_point(place, row.x0, row.y0), user_point(place, row.x2, row.y2)
    if row.q == 0:
        return Piece.segment((row.a, row.b), start, end, error)
    reach = row.reach / place.scale
    middle = (weight * start[0] + reach * row.tx0, weight * start[1] + reach * row.ty0 * place.side)
    return Piece(kind, (row.a, row.b), start, end, middle, weight, error)


def member(values: Sequence[float]) -> float:
    """Q of a row of the kernels' table."""
    return _row(values).q


def segment(interval: tuple[float, float], start: Point, end: Point) -> Piece:
    """The straight piece between two points."""
    from osculant.pieces.conics import Piece

    return Piece.segment(interval, start, end)


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """Small parabolas between two frames: see `osculant.pieces.bridges`."""
    from osculant.pieces.bridges import parabolas

    return parabolas(interval, start, end, error)


def record(name: str) -> Method:
    """What loads the record of that name from `kernels.conics.records`."""

    def load(order: int) -> Any:
        from osculant.kernels.conics import records

        return getattr(records, name)()

    return load


PARABOLA = Primitive(
    name="parabola",
    plural="parabolas",
    dimension=2,
    arcs=("parabola", "segment"),
    methods={
        "hausdorff": {"bitangent": record("Parabola")},
        "area": {"bitangent": record("ParabolaArea")},
    },
    theory=("parabolic",),
    itself=Itself("conic", ("parabolic",), lambda exact: exact.parabola, turning=math.pi),
    theorems={("hausdorff", "bitangent"): Theorem("remark 3.3.5", half_turns=1, member=member)},
    piece=parabola_piece,
    segment=segment,
    bridge=bridge,
)

CONIC = Primitive(
    name="conic",
    plural="conics",
    dimension=2,
    arcs=("ellipse", "parabola", "hyperbola", "segment", "arc"),
    methods={
        "hausdorff": {"equioscillating": record("Conic")},
        "area": {
            "equisymmetric": record("EquisymmetricConic"),
            "minimal-area": record("LeastAreaConic"),
        },
    },
    theory=("sextactic",),
    itself=Itself("conic", ("sextactic",), lambda exact: exact.conic, turning=math.pi),
    theorems={
        ("hausdorff", "equioscillating"): Theorem("X3.3-6", member=member),
        ("area", "equisymmetric"): Theorem("proposition 3.4.2"),
        ("area", "minimal-area"): Theorem("X3.4-5"),
    },
    piece=conic_piece,
    segment=segment,
    bridge=bridge,
)
