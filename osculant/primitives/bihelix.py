"""Bihelices: pairs of helical arcs with a common tangent, tangent to a space curve at both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.primitives.primitive import Itself, Primitive

if TYPE_CHECKING:
    from collections.abc import Sequence

    from osculant.kernels.curves.space import Place
    from osculant.pieces.helices import HelixArc, SpacePiece, Vector


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


def bihelix_piece(values: Sequence[float], place: Place, error: float) -> SpacePiece:
    """A row of the kernels' table (`kernels.bihelices.records`), which is in the user's coordinates."""
    from osculant.kernels.bihelices.helix import HELIX_SIZE
    from osculant.kernels.bihelices.records import LEFT, MIDDLE, RIGHT
    from osculant.kernels.operations import A, B
    from osculant.pieces.helices import SpacePiece

    arcs = tuple(helix_arc(values[first : first + HELIX_SIZE]) for first in (LEFT, RIGHT))
    return SpacePiece((values[A], values[B]), arcs, error, values[MIDDLE])


def helix_arc(helix: Sequence[float]) -> HelixArc:
    """A `kernels.bihelices.helix.Helix` as a `HelixArc`: V of the thesis is minus the axis."""
    from osculant.pieces.helices import HelixArc

    (x, y, z), (u, v, w) = helix[3:6], helix[9:12]  # tangent, inward
    rate, length, _, curvature, torsion = helix[12:17]
    axis = (x, y, z)
    if rate:  # V = T₀×(V×T₀) + ⟨V,T₀⟩T₀
        along = torsion / rate
        axis = (y * w - z * v + along * x, z * u - x * w + along * y, x * v - y * u + along * z)
        size = math.hypot(*axis)
        axis = (axis[0] / size, axis[1] / size, axis[2] / size)
    return HelixArc((helix[0], helix[1], helix[2]), (x, y, z), axis, curvature, torsion, length)


def bridge(interval: tuple[float, float], start: Any, end: Any, error: float) -> list[Any]:
    """Small bihelices between two frames, made of circular arcs: see `osculant.pieces.bridges`."""
    from osculant.pieces.bridges import space_arcs

    return space_arcs(interval, start, end, error)


def segment(interval: tuple[float, float], start: Vector, end: Vector) -> SpacePiece:
    """The straight piece between two points.

    >>> segment((0.0, 1.0), (0.0, 0.0, 1.0), (0.0, 0.0, 3.0)).arcs[0].length
    2.0
    """
    from osculant.pieces.helices import HelixArc, SpacePiece

    length = math.dist(start, end)
    x, y, z = ((last - first) / length for first, last in zip(start, end))
    return SpacePiece(interval, (HelixArc(start, (x, y, z), (x, y, z), 0.0, 0.0, length),), 0.0)


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
    piece=bihelix_piece,
    segment=segment,
    bridge=bridge,
    monotone=False,  # only while errors are small
)
