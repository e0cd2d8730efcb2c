"""Biarcs: pairs of circular arcs with a common tangent, tangent to the curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from osculant.kernels import primitives as codes
from osculant.pieces.biarcs import Biarc
from osculant.pieces.conics import Piece
from osculant.primitives.primitive import Floats, Itself, Primitive, user_point

if TYPE_CHECKING:
    from osculant.kernels.curves.plane import Place


def biarc_piece(row: Floats, place: Place, error: float) -> Biarc:
    """A row of the kernel's table (`kernels.search.record`) as a biarc, or as the one arc that it is."""
    a, b, _, _, _, x0, y0, tx, ty, x2, y2, x1, y1, first, second = row.tolist()
    scale, bend = place[2], place[3]
    chord = math.hypot(x1 - x0, y1 - y0)
    dx, dy = (x1 - x0) / chord, (y1 - y0) / chord
    dot, cross = tx * dx + ty * dy, tx * dy - ty * dx
    return Biarc(
        "arc" if first == second and error == 0 else "biarc",
        (a, b),
        user_point(place, x0, y0),
        user_point(place, x1, y1),
        user_point(place, x2, y2),
        ((tx, ty * bend), (dx * dot - dy * cross, (dy * dot + dx * cross) * bend)),
        (first * bend * scale, second * bend * scale),
        error,
    )


BIARC = Primitive(
    name="biarc",
    plural="biarcs",
    dimension=2,
    methods={
        "hausdorff": {"equioscillating": lambda: codes.BIARC},
        "area": {"equisymmetric": lambda: codes.EQUISYMMETRIC_BIARC},
    },
    theory=("vertex",),
    itself=Itself("circle", ("vertex",), lambda exact: exact.circle, turning=2 * math.pi),
    minimal="by theory",
    piece=biarc_piece,
    segment=Piece.segment,
)
