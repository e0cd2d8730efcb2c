"""Where a curve stands still, in doubles, for compiled approximators: cusps, and where it only pauses.

Between places of the grid the speed falls to its least or the tangent turns back; pairs of doubles tell
whether the curve stands still there, to the last bit.  Without them, of a curve of the caller's own, only
cusps are found, where the tangent turns back all at once.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.jit import kernel
from osculant.kernels.operations import dimension
from osculant.kernels.standalone.pairs import Pair
from osculant.kernels.standalone.precise import Jets, singular_point
from osculant.kernels.standalone.special import insert

#: steps to one point, and the part of the speed beside it that is left there
STEPS, SLOWER = 200, 1e-3


@kernel
def velocity_at(fit: Any, jets: Jets, t: float, velocity: np.ndarray[Any, Any]) -> float:
    """Write α̇ at t into ``velocity``; returns α̇·α̈, which is negative where the curve slows down."""
    k = dimension(fit) + 1
    call_jet(jets.address, t, jets.jet)
    total = 0.0
    for i in range(dimension(fit)):
        velocity[i] = jets.jet[k * i + 1]
        total += velocity[i] * jets.jet[k * i + 2]
    return total


@kernel
def product(fit: Any, first: np.ndarray[Any, Any], last: np.ndarray[Any, Any]) -> float:
    """The inner product of two velocities, negative if they point to opposite sides."""
    total = 0.0
    for i in range(dimension(fit)):
        total += first[i] * last[i]
    return total


@kernel
def add_cusps(
    fit: Any, jets: Jets, grid: np.ndarray[Any, Any], points: np.ndarray[Any, Any], count: int
) -> int:
    """Add the places where the curve stands still to the points; their new number, −1 if there are too many.

    ``grid`` (m, 2) has increasing places as rows, both ends among them.
    """
    first, last, middle = np.empty(3), np.empty(3), np.empty(3)
    panels = grid.shape[0] - 1
    low, high = grid[0, 0], grid[panels, 0]
    for i in range(1, panels + 1):
        a, b = grid[i - 1, 0], grid[i, 0]
        slowing, quickening = velocity_at(fit, jets, a, first), velocity_at(fit, jets, b, last)
        beside = math.sqrt(max(product(fit, first, first), product(fit, last, last)))
        slowest = slowing < 0.0 and quickening >= 0.0
        if not (slowest or product(fit, first, last) < 0.0):
            continue
        at = b
        for _ in range(STEPS):
            t = 0.5 * (a + b)
            if not (t > a and t < b):
                break
            at = t
            slowing = velocity_at(fit, jets, t, middle)
            if product(fit, middle, middle) == 0.0:
                break
            before = slowing >= 0.0 if slowest else product(fit, first, middle) < 0.0
            for j in range(dimension(fit)):
                if before:
                    last[j] = middle[j]
                else:
                    first[j] = middle[j]
            a, b = (a, t) if before else (t, b)
        velocity_at(fit, jets, at, middle)
        found, there = Pair(at, 0.0), product(fit, first, last) < 0.0
        if jets.sure and (there or math.sqrt(product(fit, middle, middle)) <= SLOWER * beside):
            found, still = singular_point(fit, jets, at, high - low)
            there = there or still
        if there:
            count = insert(points, count, found, low, high)
            if count < 0:
                return -1
    return count
