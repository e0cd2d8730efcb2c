"""The best pieces on given arcs: what is needed to move knots until all errors are equal.

So errors must change smoothly with the knots: the fast steps are repeated until they no longer change the
error, and their error is kept, while the measurement that decides elsewhere only has to confirm it.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.conics.exchange import Peaks
from osculant.kernels.conics.minimax import minimax
from osculant.kernels.conics.scan import Space, workspace
from osculant.kernels.curves.plane import JET_SIZE, Frame, Place, Source
from osculant.kernels.jit import kernel
from osculant.kernels.primitives import BIARC, CONIC, PARABOLA
from osculant.kernels.search import CHECKED, ENDS_AT_STRETCH, frame_at, measured, peaks_at_first, record, step

#: fast steps on one arc; what they must come to: an unrest below `SETTLED`, which Newton's method squares,
#: and an error that the measurement confirms to this part
VISITS, SETTLED, CONFIRMED = 12, 1e-9, 1e-6
#: the same for areas, whose unrest is the error itself
EXACT = 1e-12


@kernel
def settle(
    primitive: int, source: Source, a: float, start: Frame, b: float, end: Frame, peaks: Peaks, space: Space
) -> tuple[float, float, Peaks, bool]:  # fmt: skip
    """(error, Q, peaks, settled) of the arc [a, b] by fast steps."""
    calm = SETTLED if primitive in (PARABOLA, CONIC, BIARC) else EXACT
    steeps, before = (math.nan, math.nan), (math.nan, math.nan)
    error, q = math.nan, math.nan
    for _ in range(VISITS):
        error, q, unrest, moved, steeps = step(
            primitive, source, a, start, b, end, peaks, steeps, before, calm, space
        )
        if not error > 0.0:
            return error, q, peaks, False
        before, peaks = (peaks[0], peaks[1]), moved
        if unrest <= calm:
            return error, q, peaks, True
    return error, q, peaks, False


@kernel
def fit_arcs(
    code: int, address: int, place: Place, knots: np.ndarray[Any, Any], start: Frame, last: Frame,
    table: np.ndarray[Any, Any],
) -> None:  # fmt: skip
    """Fill ``table`` (m, `COLUMNS`) with the best pieces of the arcs between m + 1 neighbouring knots.

    Args:
        code: of `osculant.kernels.primitives`.
        address: of the compiled jet.
        place: of the kernel's coordinates.
        knots: increasing parameters (m + 1,).
        start: the (limit) frame at the first knot.
        last: at the last one.
        table: rows for `record`; the error of an arc without a proper piece is infinite, and its Q NaN.

    Errors are those of `minimax`, as smooth in the knots as rounding permits.
    """
    source = (address, place, np.empty(JET_SIZE))
    space = workspace()
    shape = peaks_at_first(code)
    peaks = shape
    count = knots.shape[0] - 1
    stop = knots[count]
    for i in range(count):
        a, b = knots[i], knots[i + 1]
        end = frame_at(source, b, stop, last)
        error, q, after, found = settle(code, source, a, start, b, end, peaks, space)
        if found:
            checked = measured(code, q, source, a, start, b, end, CHECKED, space)
            found = abs(checked - error) <= CONFIRMED * error + place[4]
        if found:
            peaks = after
        else:
            error, q = minimax(code, source, a, start, b, end, space)
            peaks = shape
        if not error < math.inf:
            error, q = math.inf, math.nan
        record(code, table[i], a, b, q, error, ENDS_AT_STRETCH, start, end, place[4])
        start = end
