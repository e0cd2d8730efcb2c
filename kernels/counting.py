"""A quick lower bound of the number of greedy pieces, from pieces that are a little too large.

The protocol of the area metric runs on it: the least n for which pieces of area ε/n are at most n.  With f(n)
the number of greedy pieces for ε/n, n ← f(n) from below never passes the least n with f(n) ≤ n, as f grows
with n; nor does it with any lower bound in the place of f.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.course import farthest
from osculant.kernels.jit import kernel
from osculant.kernels.operations import begin, rules, source, workspace
from osculant.kernels.search import careful_arc, frame_at, next_length, quick_arc

#: errors of pieces that are too large, in parts of the largest allowed
LARGER, LARGEST = 1.002, 1.02
#: more pieces than this are not counted
MOST_PIECES = 10_000_000


@kernel
def count_larger(
    fit: Any, address: int, place: Any, a: float, start: Any, stop: float, last: Any,
    high: float, length: float, course: np.ndarray[Any, Any],
) -> int:  # fmt: skip
    """How many pieces the stretch takes if each is a little larger than ``high``: at most the greedy number.

    Arguments as of `search.spline`; errors have to grow with arcs.  The pieces are not measured again: one
    that is too long leaves fewer.
    """
    curve, space = source(fit, address, place, course), workspace(fit)
    rule = rules(fit)
    low, high = LARGER * high, LARGEST * high
    exponent, state = rule.order, begin(fit)
    previous = math.nan
    for count in range(1, MOST_PIECES):
        far = farthest(course, a, stop, rule.turning)
        b, _, after, exponent, found = quick_arc(
            fit, curve, a, start, stop, last, far, length, low, high, exponent, state, space
        )
        if found:
            state = after
        else:
            b, _, _, _ = careful_arc(fit, curve, a, start, stop, last, far, length, low, high, course, space)
            exponent = rule.order
            if not b > a:
                return count
        if b == stop:
            return count
        length, previous = next_length(b - a, previous), b - a
        start, a = frame_at(fit, curve, b, stop, last), b
    return MOST_PIECES
