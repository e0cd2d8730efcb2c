"""A quick lower bound of the number of greedy pieces, from pieces that are a little too large.

The protocol of the area metric runs on it: the least n for which pieces of area ε/n are at most n.  With f(n)
the number of greedy pieces for ε/n, n ← f(n) from below never passes the least n with f(n) ≤ n, as f grows
with n; nor does it with any lower bound in the place of f.
"""

from __future__ import annotations

import math

import numpy as np

from osculant.kernels.conics.scan import workspace
from osculant.kernels.curves.plane import JET_SIZE, Frame, Place
from osculant.kernels.jit import kernel
from osculant.kernels.search import careful_arc, frame_at, peaks_at_first, quick_arc

#: errors of pieces that are too large, in parts of the largest allowed
LARGER, LARGEST = 1.002, 1.02
#: more pieces than this are not counted
MOST_PIECES = 10_000_000


@kernel
def count_larger(
    code: int, address: int, place: Place, a: float, start: Frame, stop: float, last: Frame,
    high: float, length: float,
) -> int:  # fmt: skip
    """How many pieces the stretch takes if each is a little larger than ``high``: at most the greedy number.

    Arguments as of `greedy.spline`.  The pieces are not measured again: one that is too long leaves fewer.
    """
    source = (address, place, np.empty(JET_SIZE))
    space = workspace()
    peaks = peaks_at_first(code)
    previous = math.nan
    for count in range(1, MOST_PIECES):
        b, _, after, found = quick_arc(
            code, source, a, start, stop, last, length, LARGER * high, LARGEST * high, peaks, space
        )
        if found:
            peaks = after
        else:
            b, q, _ = careful_arc(
                code, source, a, start, stop, last, length, LARGER * high, LARGEST * high, space
            )
            if math.isnan(q):
                return count
        if b == stop:
            return count
        length = b - a
        if previous > 0.0:
            length *= min(2.0, max(0.5, length / previous))
        previous = b - a
        start, a = frame_at(source, b, stop, last), b
    return MOST_PIECES
