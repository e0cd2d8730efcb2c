"""The strip between an arc and a conic of its pencil: d(1 − κd/2)|α′| at the nodes of one panel.

Its integral is the signed area between arc and conic, and by_q(1 − κd)|α′| its derivative by Q: the ends of
the arc stay.  Views of the curve are kept, so that other Q cost no samples.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.conics.pencil import Pencil, view
from osculant.kernels.conics.strip_series import COUNTS, MOST, POINTS
from osculant.kernels.curves.peaks import Space
from osculant.kernels.curves.plane import Source
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel

#: rows of the scratch space: the lines and their derivatives along N, speed times half the panel, curvature,
#: the sine of the angle from T₀; the strip, its derivative by Q, and the strip's series
L0, L1, L2, N0, N1, N2, SPEED, CURVATURE, SINE = 0, 1, 2, 3, 4, 5, 6, 7, 8
STRIP, BY_Q, SERIES = 9, 10, 11

#: all rows, and one of them
Lanes = np.ndarray[Any, Any]
Lane = np.ndarray[Any, Any]


@kernel
def lanes_of(space: Space) -> Lanes:
    """The scratch space for views as rows of quantities, a column for each node."""
    return space[0].reshape((space[0].size // MOST, MOST))


@kernel
def sample_panel(
    pen: Pencil, source: Source, low: float, high: float, order: int, level: int, lanes: Lanes
) -> None:
    """Views of the arc at the nodes of the panel [low, high]."""
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    for i in range(COUNTS[level]):
        l0, l1, l2, n0, n1, n2, _, _, t2, speed, curvature = view(
            pen, source, middle + half * POINTS[order, level, i]
        )
        lanes[L0, i], lanes[L1, i], lanes[L2, i] = l0, l1, l2
        lanes[N0, i], lanes[N1, i], lanes[N2, i] = n0, n1, n2
        lanes[SPEED, i], lanes[CURVATURE, i], lanes[SINE, i] = speed * half, curvature, t2


@kernel
def fill(pen: Pencil, q: float, count: int, lanes: Lanes) -> int:
    """The strip and its derivative by Q at the nodes, of the member Q or, if Q = 0, the chord.

    Returns 0, or 1 + a node whose normal misses the member's arc.
    """
    noise, missed = pen.noise, 0
    if q == 0.0:
        for i in range(count):
            d = -lanes[L1, i] / lanes[N1, i]
            lanes[STRIP, i] = d * (1.0 - 0.5 * lanes[CURVATURE, i] * d) * lanes[SPEED, i]
            lanes[BY_Q, i] = 0.0
            missed = max(missed, (i + 1) * (not lanes[N1, i] > 0.0))
        return missed
    for i in range(count):
        d, by_q, _, foot0, foot1, foot2 = generated.displacement(
            q, lanes[L0, i], lanes[L1, i], lanes[L2, i], lanes[N0, i], lanes[N1, i], lanes[N2, i],
            0.0, 0.0, 0.0, 1.0, 0.0,
        )  # fmt: skip
        bend, speed = lanes[CURVATURE, i] * d, lanes[SPEED, i]
        lanes[STRIP, i] = d * (1.0 - 0.5 * bend) * speed
        lanes[BY_Q, i] = by_q * (1.0 - bend) * speed
        missed = max(missed, (i + 1) * (not (foot0 >= -noise and foot1 <= noise and foot2 >= -noise)))
    return missed


@kernel
def through_node(lanes: Lanes, i: int) -> float:
    """Q of the member through a node, NaN unless it is inside both end tangents."""
    l0, l1, l2 = lanes[L0, i], lanes[L1, i], lanes[L2, i]
    if l0 > 0.0 and l2 > 0.0 and l1 < 0.0:
        return generated.through(l0, l1, l2)
    return math.nan
