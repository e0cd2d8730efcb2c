"""What all searches for the peaks of an error share: room for samples, and the place of a peak.

A peak is sought between two samples of a displacement along an arc, from values and slopes there.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.jit import kernel

#: numbers of a row, what is seen from one point and its parameter value; rows, twice as many as a course
#: asks for at most (`osculant.kernels.course.MOST_POINTS`): there is room for samples between
ROW_SIZE, ROWS = 12, 800
#: (rows for samples, stack for intervals): what `workspace` makes
Space = tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]
#: intervals are cut in two at most this often, one within the other
DEPTH = 40
#: a peak moves at most by this part of its arc or interval at once, and stays this far from the ends
LARGEST_MOVE, MARGIN = 0.1, 0.01


@kernel
def workspace(fit: Any) -> Space:
    """Scratch space for the searches of one family, made once per spline."""
    return np.empty((ROWS, ROW_SIZE)), np.empty((DEPTH, 4))


@kernel
def cubic_peak(d0: float, s0: float, d1: float, s1: float) -> tuple[float, float]:
    """(u, second derivative there) of the extreme in (0, 1) of the cubic with these ends and slopes."""
    b = 3.0 * (d1 - d0) - 2.0 * s0 - s1
    c = s0 + s1 - 2.0 * (d1 - d0)
    # the derivative s0 + 2bu + 3cu² vanishes; the larger root in magnitude first, the other by Vieta
    below = -(b + math.copysign(math.sqrt(max(0.0, b * b - 3.0 * c * s0)), b))
    u = s0 / below if below != 0.0 else 0.5
    if not 0.0 < u < 1.0:
        u = below / (3.0 * c) if c != 0.0 else 0.5
    if not 0.0 < u < 1.0:
        u = 0.5
    return u, 2.0 * b + 6.0 * c * u


@kernel
def within_reason(x: float, step: float) -> float:
    """The place x of a peak, in parts of its arc, after a step of Newton's method."""
    return min(1.0 - MARGIN, max(MARGIN, x + min(LARGEST_MOVE, max(-LARGEST_MOVE, step))))
