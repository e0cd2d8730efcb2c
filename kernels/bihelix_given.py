"""The best bihelix on each of given arcs, and the contents that knots start from.

Knots are moved until all errors are equal, so errors must change smoothly with the knots: the peaks on both
sides of a junction are made equal more closely than the search for long arcs needs.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.bihelices.family import EQUIOSCILLATING
from osculant.kernels.bihelix_spline import CALM, ENDS_AT_STRETCH, balanced, end_at, record
from osculant.kernels.curves.arc_length import workspace as lengths_workspace
from osculant.kernels.curves.space import JET_SIZE, Frame, Place, Source, frenet_at, placed
from osculant.kernels.jit import kernel

#: log(left peak/right peak) at the junctions, and at least so many times noise/error
EQUAL, EQUAL_NOISE = 1e-11, 8.0
#: nodes of Gauss's rule of two points, from the middle in halves of a panel
NODE = 1.0 / math.sqrt(3.0)


@kernel
def fit_arcs(
    rule: int, address: int, place: Place, knots: np.ndarray[Any, Any], start: Frame, last: Frame,
    table: np.ndarray[Any, Any],
) -> None:  # fmt: skip
    """Fill ``table`` (m, ``bihelix_spline.COLUMNS``) with the bihelices between m + 1 neighbouring knots.

    Args:
        rule: `THESIS` or `EQUIOSCILLATING` of `osculant.kernels.bihelices.family`.
        address: of the curve's compiled jet of order 3.
        place: of the kernel's coordinates.
        knots: increasing parameters (m + 1,).
        start: the (limit) frame at the first knot, in the user's coordinates.
        last: at the last one.
        table: rows as `osculant.kernels.bihelix_spline` says; errors are infinite where there is no bihelix.
    """
    source = (address, place, np.empty(JET_SIZE))
    lengths = lengths_workspace()
    count = knots.shape[0] - 1
    stop = knots[count]
    left, final = placed(place, start), placed(place, last)
    for i in range(count):
        a, b = knots[i], knots[i + 1]
        right = end_at(source, b, stop, final)
        # from the middle, so that the error is one of this arc alone
        found = balanced(rule, source, a, left, b, right, 0.0, lengths)
        if rule == EQUIOSCILLATING and found[0] > 0.0 and found[0] < math.inf:
            calm = max(EQUAL, EQUAL_NOISE * place[4] / found[0])
            if calm < CALM:
                found = balanced(rule, source, a, left, b, right, found[3], lengths, calm)
        error, first, second, _, two = found
        if not error < math.inf:  # NaN where a helix is one in name only
            error = math.inf
        record(table[i], a, b, error, ENDS_AT_STRETCH, first, second, two, right, place)
        left = right


@kernel
def bend_at(source: Source, t: float) -> tuple[float, float, float]:
    """Speed, κ and τ at t, in the kernel's coordinates."""
    found = frenet_at(source, t)
    return found[0], found[1], found[3]


@kernel
def contents(
    order: int, address: int, place: Place, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]
) -> None:
    """Contents from ``times[0]`` to every one of the increasing ``times`` (m,), into ``out`` (m,).

    ∫|κ′|^{1/3} ds for the order 3, ∫|κτ′|^{1/4} ds for 4 (constant curvature), whose equal steps give equal
    errors, to leading order.  Slopes are those of secants between two nodes inside each panel, so singular
    ends do no harm, and the result is as accurate as the grid is fine: for knots to start from.
    """
    source = (address, place, np.empty(JET_SIZE))
    out[0] = 0.0
    for j in range(1, times.shape[0]):
        middle, half = 0.5 * (times[j - 1] + times[j]), 0.5 * (times[j] - times[j - 1])
        speed0, bend0, twist0 = bend_at(source, middle - NODE * half)
        speed1, bend1, twist1 = bend_at(source, middle + NODE * half)
        length = half * (speed0 + speed1)
        change = abs(bend1 - bend0) if order == 3 else 0.5 * (bend0 + bend1) * abs(twist1 - twist0)
        value = 0.0
        if length > 0.0 and math.isfinite(change):
            value = (change / (NODE * length)) ** (1.0 / order) * length
        out[j] = out[j - 1] + value
