"""How large a curve is, from samples: for rounding floors and for the kernels' local coordinates."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from osculant.cas.errors import DomainError
from osculant.curves.kept import kept

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve

#: samples that tell the size of a curve
SAMPLES = 257
#: below this size doubles have no room for errors, nor for the scale that makes it 1
SMALLEST = 2.0**-900


@dataclass(frozen=True)
class Extent:
    """Size of a curve: its first point, largest absolute coordinate and largest extent."""

    origin: tuple[float, ...]
    largest: float
    size: float

    @property
    def scale(self) -> float:
        """The power of two that makes the curve's size about 1."""
        return 2.0 ** -math.frexp(self.size)[1] if self.size > 0 else 1.0

    def rounding(self, dimension: int = 1) -> float:
        """One rounding unit of the largest coordinate, as a length (dimension 1) or as an area (2).

        The area is that of a strip so wide along the whole size.

        >>> Extent((0.0, 0.0), 1.0, 2.0).rounding(2) == 2 * math.ulp(1.0)
        True
        """
        return math.ulp(self.largest) * self.size ** (dimension - 1)


@kept
def extent(curve: FormulaCurve) -> Extent:
    """Sample a curve that is finite on its interval; raises DomainError if doubles cannot hold it.

    >>> from osculant.curves.plane import PlaneCurve
    >>> extent(PlaneCurve("t, t^2", 0, 3))
    Extent(origin=(0.0, 0.0), largest=9.0, size=9.0)
    """
    a, b = curve.interval
    with np.errstate(all="ignore"):
        times = np.linspace(a, b, SAMPLES)
    # a double next to an end may lie outside the interval, where the formula need not be defined
    points = curve.jets(times)[..., 0]
    if not np.isfinite(points[1:-1]).all():
        raise DomainError(
            f"The curve {curve.text} leaves the range of double numbers on its interval: "
            "scale it or take a smaller interval."
        )
    points = points[np.isfinite(points).all(axis=1)]
    with np.errstate(over="ignore"):
        size = float(np.ptp(points, axis=0).max())
    if not math.isfinite(size):
        raise DomainError(f"The curve {curve.text} is too large for double numbers: scale it.")
    if 0.0 < size < SMALLEST:
        raise DomainError(f"The curve {curve.text} is too small for double numbers: scale it.")
    return Extent(tuple((points[0] + 0.0).tolist()), float(np.abs(points).max()), size)
