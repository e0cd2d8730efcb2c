"""The careful step: the best member of a pencil whatever the number and place of its error's peaks."""

from __future__ import annotations

import math
from typing import Any

from osculant.kernels.conics.pencil import Pencil, is_flat, is_proper, parabola, pencil, weight
from osculant.kernels.conics.scan import extremes, look, measure, members_through
from osculant.kernels.curves.peaks import Space
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.jit import kernel

#: rounds of the search for Q, and its relative accuracy
ROUNDS, BALANCED = 80, 1e-12


@kernel
def best_parabola(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(error, Q) of the parabola of the arc [a, b]; error infinite if there is none.

    Q = 0 is the chord, of an arc that is straight to rounding.
    """
    pen = pencil(start, end, source.place.noise)
    if is_flat(pen):
        return measure(pen, 0.0, source, a, b, points, space), 0.0
    if not is_proper(pen):
        return math.inf, math.nan
    q = parabola(pen)
    if math.isnan(q):
        return math.inf, math.nan
    return measure(pen, q, source, a, b, points, space), q


@kernel
def best_conic(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(error, Q) of the conic of the arc [a, b] with max d = −min d; error infinite if there is none.

    Q = 0 is the chord, of an arc that is straight to rounding.  d decreases or increases with Q at every
    point at once, so max d + min d has one zero, between the least and the greatest Q of the members through
    the samples.
    """
    pen = pencil(start, end, source.place.noise)
    if is_flat(pen):
        return measure(pen, 0.0, source, a, b, points, space), 0.0
    if not is_proper(pen):
        return math.inf, math.nan
    count = look(pen, source, a, b, points, space)
    if count < 0:
        return math.inf, math.nan
    low, high = members_through(pen, space, count)
    if high == 0.0:
        return math.inf, math.nan
    return balanced(pen, source, a, b, space, count, low, high)


@kernel
def balanced(
    pen: Pencil, source: Source, a: float, b: float,
    space: Space, count: int, low: float, high: float,
) -> tuple[float, float]:  # fmt: skip
    """(error, Q) with max d = −min d, Q in [low, high]: false position, bisection where it is slow."""
    excess_low, excess_high = math.nan, math.nan
    error, q = math.inf, math.nan
    for step in range(ROUNDS):
        q = 0.5 * (low + high)
        if step % 3 and math.isfinite(excess_low) and math.isfinite(excess_high):
            q = (low * excess_high - high * excess_low) / (excess_high - excess_low)
        top, bottom = math.nan, 1.0  # an unbounded arc: w < 0 falls with Q
        if weight(pen, q) > -1.0:
            top, bottom = extremes(pen, q, source, a, b, space, count)
        if math.isnan(top):
            excess, error, too_large = math.nan, math.inf, bottom > 0.0
        else:  # ∂d/∂Q < 0 inside the tangents of an arc that bends to the left
            excess, error, too_large = top + bottom, max(top, -bottom), top + bottom < 0.0
        if abs(excess) <= BALANCED * error or high - low <= BALANCED * high:
            break
        if too_large:
            high, excess_high = q, excess
        else:
            low, excess_low = q, excess
    return error, q
