"""How kernels see a curve: moved to its first point, scaled to a size of about 1, its features known."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from osculant.approximation.runs import Floats, equal_parts
from osculant.approximation.stretches import Frame
from osculant.curves.enclosed import enclosed
from osculant.curves.kept import kept
from osculant.kernels.curves import plane, space

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve
    from osculant.curves.extent import Extent

#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: parts of a stretch where theory says that samples miss nothing
PANELS = 16

#: the kernels' `Place` of a curve, and a `Frame` in it, of the plane or of space
Place: TypeAlias = Any
Local: TypeAlias = Any


class Coordinates:
    """The kernels' coordinates of a curve.

    Attributes:
        curve: with its interval.
        size: its extent.
        resolution: features of the curve that are larger than this are not to be missed between samples; None
            if none can be, as it is split at its special points.
        scale: what the user's lengths are multiplied by.
        noise: what rounding may do to a position, in the kernels' units.

    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.plane import PlaneCurve
    >>> parabola = PlaneCurve("t, t^2", 1, 4)
    >>> Coordinates(parabola, extent(parabola)).place(-1.0)[:4]
    (1.0, 1.0, 0.0625, -1.0)
    """

    def __init__(self, curve: FormulaCurve, size: Extent, resolution: float | None = None) -> None:
        self.curve, self.size, self.scale = curve, size, size.scale
        self.resolution = resolution
        self.noise = NOISE_ULPS * size.rounding() * size.scale

    def place(self, bend: float = 1.0) -> Place:
        """What kernels take as the place of a curve; one in the plane bends to the left (1) or right (−1)."""
        if self.curve.dimension == 2:
            x, y = self.size.origin
            return plane.Place(x, y, self.scale, bend, self.noise)
        x, y, z = self.size.origin
        return space.Place(x, y, z, self.scale, self.noise)

    def edges(self, a: float, b: float) -> Floats:
        """Edges of parts of [a, b] that are at least as fine as the curve's features: increasing (m + 1,).

        Beyond the curve's interval it is taken to be periodic.

        >>> from osculant.curves.extent import extent
        >>> from osculant.curves.space import SpaceCurve
        >>> bump = SpaceCurve("t, 0, exp(-((t - 1/3)/10^-5)^2)", 0, 1)
        >>> edges = Coordinates(bump, extent(bump), 1e-9).edges(0.0, 1.0)
        >>> float(np.diff(edges).min()) < 1e-5 < float(np.diff(edges).max())
        True
        """
        if self.resolution is None:
            return equal_parts((a, b), PANELS)
        low, high = self.curve.interval
        period = high - low
        first, last = math.floor((a - low) / period), max(1, math.ceil((b - low) / period))
        every = _repeated(self.curve, self.resolution, first, last)
        inside = slice(np.searchsorted(every, a, "right"), np.searchsorted(every, b, "left"))
        return np.concatenate([[a], every[inside], [b]])

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
            return plane.frame_at(self.curve.compiled.address, place, t)
        return space.frame_at(self.curve.compiled.address, place, t)

    def user_frame(self, t: float, place: Place) -> Frame:
        """The frame of the curve at t in the user's."""
        jet = self.curve.jets(np.array([t]))[0]
        length = math.hypot(*jet[:, 1])
        return Frame(tuple(jet[:, 0].tolist()), tuple((jet[:, 1] / length).tolist()))


@kept
def parts(curve: FormulaCurve, resolution: float) -> Floats:
    """Edges of parts of the curve's interval on which it is a polynomial, up to the resolution.

    >>> from osculant.curves.plane import PlaneCurve
    >>> parts(PlaneCurve("t, t^2", 0, 1), 1e-3).size
    17
    """
    return np.array(enclosed(curve.balls).parts(*curve.interval, resolution))


@kept
def _repeated(curve: FormulaCurve, resolution: float, first: int, last: int) -> Floats:
    """The edges of `parts` in order, from the first turn of a periodic curve up to the last."""
    low, high = curve.interval
    turns = np.arange(first, last)
    edges: Floats = np.sort((parts(curve, resolution) + (high - low) * turns[:, None]).ravel())
    different: Floats = np.append(edges[1:] != edges[:-1], True)
    return np.compress(different, edges)  # np.unique would load all of numpy.ma
