"""Arcs of a curve that is a conic itself."""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.conics import records
from osculant.kernels.conics.pencil import pencil, through, view
from osculant.kernels.conics.scan import measure
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import Frame, Place, alone, frame
from osculant.kernels.jit import kernel
from osculant.kernels.operations import ERROR, REASON, A, B
from osculant.kernels.search import ENDS_AT_STRETCH

#: equidistant samples of each arc, at least
SAMPLES = 40


@kernel
def conics_through(
    fit: Any, address: int, place: Place, knots: np.ndarray[Any, Any], start: Frame, last: Frame,
    part: float, table: np.ndarray[Any, Any],
) -> None:  # fmt: skip
    """Fill ``table`` (m, columns of `records.Row`) with the conics through one inner point of each arc.

    Args:
        fit: a record of conics or parabolas.
        address: of the compiled jet.
        place: of the kernel's coordinates.
        knots: increasing parameters (m + 1,).
        start: the (limit) frame at the first knot.
        last: at the last one.
        part: where in an arc the point is, between 0 and 1.
        table: rows; their error is how far the curve is from the conic.
    """
    source, space = alone(address, place), workspace(fit)
    count = knots.shape[0] - 1
    for i in range(count):
        a, b = knots[i], knots[i + 1]
        end = last if i == count - 1 else frame(source, b)
        pen = pencil(start, end, place.noise)
        q = through(view(pen, source, a + part * (b - a)))
        row = table[i]
        row[A], row[B], row[REASON] = a, b, ENDS_AT_STRETCH
        row[ERROR] = measure(pen, q, source, a, b, SAMPLES, space)
        records.record(fit, row, q, start, end, source)
        start = end
