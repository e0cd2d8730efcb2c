"""Arcs of a curve that is a circle itself."""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.biarcs.family import Biarc, to_circle
from osculant.kernels.biarcs.records import write_shape
from osculant.kernels.curves.plane import Frame, Place, alone, frame, sample
from osculant.kernels.jit import kernel
from osculant.kernels.operations import ERROR, REASON, A, B
from osculant.kernels.search import ENDS_AT_STRETCH

#: equidistant samples of each arc
SAMPLES = 40


@kernel
def circles_along(
    address: int, place: Place, knots: np.ndarray[Any, Any], middles: np.ndarray[Any, Any], start: Frame,
    last: Frame, bend: float, table: np.ndarray[Any, Any],
) -> None:  # fmt: skip
    """Fill ``table`` (m, columns of `records.Row`) with biarcs whose arcs are both on the circle.

    Args:
        address: of the compiled jet.
        place: of the kernel's coordinates.
        knots: increasing parameters (m + 1,).
        middles: of the junctions (m,).
        start: the (limit) frame at the first knot.
        last: at the last one.
        bend: the circle's curvature.
        table: rows; their error is how far the curve is from the circle.
    """
    source = alone(address, place)
    count = knots.shape[0] - 1
    for i in range(count):
        a, b = knots[i], knots[i + 1]
        end = last if i == count - 1 else frame(source, b)
        joint = frame(source, middles[i])
        off = 0.0
        for j in range(SAMPLES):
            at = sample(source, a + (b - a) * j / (SAMPLES - 1))
            d, _, _ = to_circle(
                start.x, start.y, start.tx, start.ty, bend, at.x, at.y, at.tx, at.ty, at.curvature
            )
            off = max(off, abs(d))
        row = table[i]
        row[A], row[B], row[ERROR], row[REASON] = a, b, off, ENDS_AT_STRETCH
        arcs = Biarc(
            start.x, start.y, start.tx, start.ty, joint.x, joint.y, joint.tx, joint.ty,
            end.x, end.y, end.tx, end.ty, bend, bend,
        )  # fmt: skip
        write_shape(row, 0.5, arcs)
        start = end
