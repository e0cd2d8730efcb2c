"""What splines can be made of: everything that the front door knows about a primitive, one line each."""

from __future__ import annotations

import math
from dataclasses import dataclass

from osculant.kernels import primitives as codes


@dataclass(frozen=True)
class Primitive:
    """A kind of pieces.

    Attributes:
        code: its number in the kernels.
        order: the error of one short arc is of this order in its length (`osculant.cas.complexity.LAWS`).
        splits: the special points (`osculant.cas.special.FORMS`) that split besides cusps and inflections.
        exact: the property of `osculant.cas.plane_exact.ExactInvariants` that proves a curve to be one.
        turning: such a curve is cut into pieces that turn by less than this.
    """

    code: int
    order: int
    splits: str
    exact: str
    turning: float


PRIMITIVES = {
    "parabola": Primitive(codes.PARABOLA, 4, "parabolic", "parabola", math.pi),
    "conic": Primitive(codes.CONIC, 5, "sextactic", "conic", math.pi),
    "biarc": Primitive(codes.BIARC, 3, "vertex", "circle", 2 * math.pi),
}
