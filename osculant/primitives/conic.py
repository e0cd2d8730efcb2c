"""Parabolas and conics: pieces that are arcs of them, tangent to the curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.primitive import Itself, Method, Primitive, Theorem, columns

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.pieces.conics import Piece, Point
    from osculant.pieces.piece import Floats


def pieces(rows: Floats, shapes: Floats) -> list[Piece]:
    """Rows of the kernels' table and their shapes (`kernels.conics.shapes.Arc`) as arcs of conics.

    Args:
        rows: of `kernels.conics.records.Row`, shape (n, columns); where Q = 0 the arc is its chord.
        shapes: the same in the user's coordinates, shape (n, numbers).

    Raises:
        DomainError: a weight at which an arc is not bounded.
    """
    from osculant.kernels.conics.records import Row
    from osculant.kernels.conics.shapes import Arc
    from osculant.pieces.conics import Piece, classify, require_bounded
    from osculant.pieces.piece import from_columns

    arc = columns(Arc, shapes)
    require_bounded(*arc.weight)
    chords = (rows[:, Row._fields.index("q")] == 0).tolist()
    kinds = ["segment" if straight else classify(w) for w, straight in zip(arc.weight, chords)]
    ends = zip(arc.x0, arc.y0), zip(arc.x2, arc.y2)
    return from_columns(Piece, kinds, zip(arc.a, arc.b), *ends, zip(arc.mx, arc.my), arc.weight, arc.error)


def member(values: Sequence[float]) -> float:
    """Q of a row of the kernels' table."""
    from osculant.kernels.conics.records import Row

    return Row(*values).q


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
    pieces=pieces,
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
    pieces=pieces,
    segment=segment,
    bridge=bridge,
)
