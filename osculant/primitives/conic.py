"""Parabolas and conics: pieces that are arcs of them, tangent to the curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from osculant.kernels import primitives as codes
from osculant.pieces.conics import Kind, Piece, classify
from osculant.primitives.primitive import Floats, Itself, Primitive, user_point

if TYPE_CHECKING:
    from osculant.kernels.curves.plane import Place


def conic_piece(row: Floats, place: Place, error: float) -> Piece:
    """A row of the kernel's table (`kernels.search.record`) as a conic arc."""
    weight = float(row[11])
    return _arc(row, place, error, classify(weight), weight)


def parabola_piece(row: Floats, place: Place, error: float) -> Piece:
    """A row of the kernel's table as an arc of a parabola."""
    return _arc(row, place, error, "parabola", 1.0)


def _arc(row: Floats, place: Place, error: float, kind: Kind, weight: float) -> Piece:
    a, b, q, _, _, x0, y0, tx, ty, x2, y2, _, reach, _, _ = row.tolist()
    start, end = user_point(place, x0, y0), user_point(place, x2, y2)
    if q == 0:
        return Piece.segment((a, b), start, end, error)
    reach /= place[2]
    middle = (weight * start[0] + reach * tx, weight * start[1] + reach * ty * place[3])
    return Piece(kind, (a, b), start, end, middle, weight, error)


PARABOLA = Primitive(
    name="parabola",
    plural="parabolas",
    dimension=2,
    methods={
        "hausdorff": {"bitangent": lambda: codes.PARABOLA},
        "area": {"bitangent": lambda: codes.AREA_PARABOLA},
    },
    theory=("parabolic",),
    itself=Itself("conic", ("parabolic",), lambda exact: exact.parabola, turning=math.pi),
    minimal="by theory",
    piece=parabola_piece,
    segment=Piece.segment,
)

CONIC = Primitive(
    name="conic",
    plural="conics",
    dimension=2,
    methods={
        "hausdorff": {"equioscillating": lambda: codes.CONIC},
        "area": {
            "equisymmetric": lambda: codes.EQUISYMMETRIC,
            "minimal-area": lambda: codes.LEAST_AREA,
        },
    },
    theory=("sextactic",),
    itself=Itself("conic", ("sextactic",), lambda exact: exact.conic, turning=math.pi),
    minimal="by theory",
    piece=conic_piece,
    segment=Piece.segment,
)
