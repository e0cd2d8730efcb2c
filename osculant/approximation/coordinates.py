"""The coordinates in which kernels see a curve: moved to its first point and scaled to a size of about 1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from osculant.approximation.division import Frame
from osculant.kernels.curves import plane, space

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve
    from osculant.curves.extent import Extent

#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4

#: the kernels' `Place` of a curve, and a `Frame` in it, of the plane or of space
Place: TypeAlias = Any
Local: TypeAlias = Any


class Coordinates:
    """The kernels' coordinates of a curve.

    Attributes:
        curve: with its interval.
        size: its extent.
        scale: what the user's lengths are multiplied by.
        noise: what rounding may do to a position, in the kernels' units.

    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.plane import PlaneCurve
    >>> parabola = PlaneCurve("t, t^2", 1, 4)
    >>> Coordinates(parabola, extent(parabola)).place(-1.0)[:4]
    (1.0, 1.0, 0.0625, -1.0)
    """

    def __init__(self, curve: FormulaCurve, size: Extent) -> None:
        self.curve, self.size, self.scale = curve, size, size.scale
        self.noise = NOISE_ULPS * size.rounding() * size.scale

    def place(self, bend: float = 1.0) -> Place:
        """What kernels take as the place of a curve; one in the plane bends to the left (1) or right (−1)."""
        if self.curve.dimension == 2:
            x, y = self.size.origin
            return plane.Place(x, y, self.scale, bend, self.noise)
        x, y, z = self.size.origin
        return space.Place(x, y, z, self.scale, self.noise)

    def error_noise(self, degree: int) -> float:
        """What rounding does to an error in the user's units: a length (degree 1), or an area (2)."""
        return NOISE_ULPS * self.size.rounding(degree)

    def local(self, frame: Frame, place: Place) -> Local:
        """A frame in the kernels' coordinates."""
        moved = [(x - origin) * self.scale for x, origin in zip(frame.point, self.size.origin)]
        if isinstance(place, plane.Place):
            (x, y), (tx, ty) = moved, frame.tangent
            return plane.Frame(x, y * place.side, tx, ty * place.side)
        x, y, z = moved
        tx, ty, tz = frame.tangent
        return space.Frame((x, y, z), (tx, ty, tz))

    def frame_at(self, t: float, place: Place) -> Local:
        """The frame of the curve at t in the kernels' coordinates."""
        if isinstance(place, plane.Place):
            return plane.frame(plane.source_of(None, self.curve.compiled.address, place), t)
        return space.frame(space.source_of(None, self.curve.compiled.address, place), t)

    def user_frame(self, t: float, place: Place) -> Frame:
        """The frame of the curve at t in the user's."""
        jet = self.curve.jets(np.array([t]))[0]
        length = float(np.linalg.norm(jet[:, 1]))
        return Frame(tuple(jet[:, 0].tolist()), tuple((jet[:, 1] / length).tolist()))
