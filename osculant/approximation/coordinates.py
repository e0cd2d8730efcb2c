"""The coordinates in which kernels see a curve: moved to its first point and scaled to a size of about 1."""

from __future__ import annotations

from typing import TYPE_CHECKING

from osculant.primitives.primitive import user_point

if TYPE_CHECKING:
    from osculant.approximation.division import Frame
    from osculant.curves.curve import FormulaCurve
    from osculant.curves.extent import Extent
    from osculant.kernels.curves.plane import Place

#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4

#: position and unit tangent of a plane curve in the kernels' coordinates
Local = tuple[float, float, float, float]


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
            return x, y, self.scale, bend, self.noise
        x, y, z = self.size.origin
        return x, y, z, self.scale, self.noise

    def error_noise(self, degree: int) -> float:
        """What rounding does to an error in the user's units: a length (degree 1), or an area (2)."""
        return NOISE_ULPS * self.size.rounding(degree)

    def local(self, frame: Frame, bend: float) -> Local:
        """A frame of a plane curve in the kernels' coordinates."""
        (x, y), (tx, ty) = frame.point, frame.tangent
        x0, y0 = self.size.origin
        return (x - x0) * self.scale, (y - y0) * self.scale * bend, tx, ty * bend

    def user(self, x: float, y: float, bend: float) -> tuple[float, float]:
        """A point of the kernels' plane in the user's coordinates."""
        return user_point(self.place(bend), x, y)
