"""Arms to start from: cubics that have the area and the first moment of the arc.

They are the zeros of a quartic, near all the cubics of least distance; where two of them have merged and
vanished, the quartic's extreme nearest to 0 is near what they leave.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.cubics.arms import SHORTEST, Ends
from osculant.kernels.cubics.roots import COLUMNS, real_zeros, value
from osculant.kernels.curves.plane import Source, sample
from osculant.kernels.gauss import NODES, SIZES, WEIGHTS
from osculant.kernels.generated import cubics as generated
from osculant.kernels.jit import kernel

#: the rule of `gauss` for area and moment
RULE = 2
#: pairs of arms at most, and the longest arm in parts of the arc's length
MOST, LONGEST = 10, 4.0
#: a chord shorter than this part of the arc has no direction
SHORT = 1e-9


@kernel
def starts(
    source: Source, a: float, b: float, ends: Ends, rows: np.ndarray[Any, Any], found: np.ndarray[Any, Any],
    out: np.ndarray[Any, Any],
) -> tuple[int, int]:  # fmt: skip
    """Fill ``out`` (MOST, 2) with pairs of arms; returns how many belong to zeros, and how many there are.

    ``rows`` and ``found`` are room for `roots.real_zeros`.
    """
    length = 0.0
    cx, cy = ends.dx, ends.dy
    if ends.chord > 0.0:
        cx, cy = ends.dx / ends.chord, ends.dy / ends.chord
    area, moment = 0.0, 0.0
    for i in range(SIZES[RULE]):
        at = sample(source, a + (b - a) * NODES[RULE, i])
        x, y = at.x - ends.x, at.y - ends.y
        share = WEIGHTS[RULE, i] * (b - a) * at.speed
        along, height = cx * x + cy * y, cx * y - cy * x
        rate = share * (cx * at.tx + cy * at.ty)
        length += share
        area += rate * height
        moment += rate * height * along
    if not (length > 0.0 and ends.chord > SHORT * length):
        return 0, 0
    # in units of the arc's length
    chord, area, moment = ends.chord / length, area / (length * length), moment / (length * length * length)
    tx0, ty0 = cx * ends.tx0 + cy * ends.ty0, cx * ends.ty0 - cy * ends.tx0
    tx3, ty3 = cx * ends.tx3 + cy * ends.ty3, cx * ends.ty3 - cy * ends.tx3
    quartic = generated.quartic(chord, tx0, ty0, tx3, ty3, area, moment)
    for i in range(COLUMNS):
        rows[0, i] = quartic[COLUMNS - 1 - i]
    shortest = SHORTEST * chord
    zeros = real_zeros(rows, shortest, LONGEST, found)
    count, sure = 0, 0
    for k in range(2):
        for i in range(found.shape[1]):
            if k == 0 and i >= zeros:
                break
            arm = found[k, i]
            if not arm > 0.0:
                break
            if k == 1 and value(rows[0], arm) * value(rows[2], arm) <= 0.0:
                continue  # not turned away from 0 there
            above, below = generated.other_arm(arm, chord, tx0, ty0, tx3, ty3, area)
            other = above / below
            if shortest < other < LONGEST and count < MOST:
                out[count, 0], out[count, 1] = arm * length, other * length
                count += 1
        if k == 0:
            sure = count
    return sure, count
