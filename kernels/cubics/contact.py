"""The density of the law of cubics: min |D| over the real roots of (C), from a jet of order six."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.cubics.roots import COLUMNS, real_zeros
from osculant.kernels.curves.jets import call_jet
from osculant.kernels.generated import cubics as generated
from osculant.kernels.generated import laws
from osculant.kernels.jit import kernel

#: the order of the jet
ORDER = 6
#: roots beyond this, in units in which the largest coefficient is 1, belong to cubics with no use
FARTHEST = 1e6


@kernel
def tangent_graph(jet: np.ndarray[Any, Any], heights: np.ndarray[Any, Any]) -> float:
    """Fill ``heights`` (7,) with Y₂ … Y₆ over the tangent at 2 … 6; returns the speed |α̇|.

    ``jet`` has the derivatives 0 … 6 of x, then of y.
    """
    along, left, power = np.empty(ORDER + 1), np.empty(ORDER + 1), np.empty(ORDER + 1)
    dx, dy = jet[1], jet[ORDER + 2]
    speed = math.sqrt(dx * dx + dy * dy)
    factorial = 1.0
    for i in range(1, ORDER + 1):
        factorial *= i
        x, y = jet[i] / factorial, jet[ORDER + 1 + i] / factorial
        along[i] = (x * dx + y * dy) / speed
        left[i] = (y * dx - x * dy) / speed
        power[i] = along[i]
    unit = speed
    for n in range(2, ORDER + 1):
        for i in range(ORDER, n - 1, -1):  # the next power of the series, from its highest term on
            total = 0.0
            for j in range(n - 1, i):
                total += power[j] * along[i - j]
            power[i] = total
        unit *= speed
        heights[n] = left[n] / unit
        for i in range(n, ORDER + 1):
            left[i] -= heights[n] * power[i]
    return speed


@kernel
def least_residual(heights: np.ndarray[Any, Any]) -> float:
    """min |D| over the real roots of (C); infinite if there is none.  ``heights`` are spoilt."""
    rows, found = np.zeros((COLUMNS, COLUMNS)), np.empty((2, COLUMNS + 1))
    unit = 0.0  # of the curve's own: the largest coefficient is 1 in it
    for n in range(2, ORDER + 1):
        unit = max(unit, abs(heights[n]) ** (1.0 / (n - 1)))
    if not 0.0 < unit < math.inf:
        return 0.0 if unit == 0.0 else math.inf
    for n in range(2, ORDER + 1):
        heights[n] /= unit ** (n - 1)
    y2, y3, y4, y5, y6 = heights[2], heights[3], heights[4], heights[5], heights[6]
    rows[0, 3], rows[0, 2], rows[0, 1], rows[0, 0] = generated.condition(y2, y3, y4, y5)
    least, reach = math.inf, FARTHEST
    if rows[0, 3] != 0.0:  # Cauchy's bound of the roots
        largest = max(abs(rows[0, 0]), abs(rows[0, 1]), abs(rows[0, 2]))
        reach = min(FARTHEST, 1.001 + largest / abs(rows[0, 3]))
    for i in range(real_zeros(rows, -reach, reach, found)):
        a = found[0, i]
        above, below, other_above, other_below = generated.thirds(a, y2, y3, y4, y5)
        b = above / below if abs(below) > abs(other_below) else other_above / other_below
        least = min(least, abs(generated.residual(a, b, y2, y3, y4, y5, y6)))
    return least * unit ** (ORDER - 1)


@kernel
def density_at(
    address: int, scale: float, jet: np.ndarray[Any, Any], t: float, constant: float, order: float
) -> float:
    """(c·min |D|)^{1/p}|α̇| at t, 0 where rounding leaves no number."""
    call_jet(address, t, jet)
    jet *= scale
    heights = np.empty(ORDER + 1)
    speed = tangent_graph(jet, heights)
    found = (constant * least_residual(heights)) ** (1.0 / order) * speed
    return found if math.isfinite(found) else 0.0


@kernel
def density(fit: Any, address: int, scale: float, jet: np.ndarray[Any, Any], t: float) -> float:
    """The `density` of distances."""
    return density_at(address, scale, jet, t, laws.CUBIC_CONSTANT, float(laws.CUBIC_ORDER))


@kernel
def area_density(fit: Any, address: int, scale: float, jet: np.ndarray[Any, Any], t: float) -> float:
    """The `density` of areas."""
    return density_at(address, scale, jet, t, laws.CUBIC_AREA_CONSTANT, float(laws.CUBIC_AREA_ORDER))
