"""The fast step of the area metric: the piece of one arc, and its area, from one row of samples.

The curve is sampled once, at the Gauss nodes of the weight (1 − x²)², as the strip between arc and conic
vanishes doubly at both ends; Q is found by Newton's method on these samples, and the moons' areas by the
strip's series (`strip_series`).  The number of nodes is kept in `Peaks`, and follows the decay of the series:
a result is trusted only where the terms left out cannot matter.
"""

from __future__ import annotations

import math

from osculant.kernels.conics.exchange import Peaks
from osculant.kernels.conics.pencil import Pencil, is_proper, parabola, pencil, through, view, weight
from osculant.kernels.conics.scan import Space
from osculant.kernels.conics.strip import (
    BY_Q,
    BY_SERIES,
    SERIES,
    STRIP,
    Lane,
    Lanes,
    fill,
    lanes_of,
    sample_panel,
    through_node,
)
from osculant.kernels.conics.strip_series import COUNTS, NODES, WEIGHTS, evaluate, expand, tail, unsigned
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.jit import kernel
from osculant.kernels.primitives import AREA_PARABOLA, LEAST_AREA

#: a whole arc, as one panel
WHOLE = 1
#: the number of nodes at first
FIRST_LEVEL = (1.0, 0.0, 0.0, 0.0)
#: Newton steps for Q; the last one is taken on the strip's tangent, at this part of the area
Q_STEPS, NEARLY = 8, 1e-7
#: rounds of the search for the least area; the move of its crossing that ends them: the area is stationary
LEAST_ROUNDS, LEAST_MOVE = 6, 1e-7
#: fewer nodes will do if their error is below this part of what is allowed
SPARE = 0.1


@kernel
def equal_moons(pen: Pencil, q: float, level: int, lanes: Lanes) -> float:
    """Q with the signed area 0 by Newton's method from a guess; leaves its strip, NaN if there is none."""
    count = COUNTS[level]
    for _ in range(Q_STEPS):
        if not (q > 0.0) or fill(pen, q, count, lanes) > 0:
            return math.nan
        signed, by_q, size = 0.0, 0.0, 0.0
        for i in range(count):
            share = WEIGHTS[WHOLE, level, i]
            signed += share * lanes[STRIP, i]
            by_q += share * lanes[BY_Q, i]
            size += share * abs(lanes[STRIP, i])
        step = signed / by_q
        if abs(signed) <= NEARLY * size + pen[14] * pen[10]:
            for i in range(count):
                lanes[STRIP, i] -= step * lanes[BY_Q, i]
            return q - step
        q -= step
    return math.nan


@kernel
def halving(order: int, count: int, lanes: Lanes, x: float) -> float:
    """The place that cuts ∫ by_q(1 − κd) ds in two equal parts, by Newton's method from x."""
    _, _, whole = evaluate(order, count, lanes[BY_SERIES], 1.0)
    for _ in range(Q_STEPS):
        value, _, area = evaluate(order, count, lanes[BY_SERIES], x)
        square = 1.0 - x * x
        step = (area - 0.5 * whole) / (value * square * square)
        x = min(0.9, max(-0.9, x - step))
        if abs(step) <= LEAST_MOVE:
            break
    return x


@kernel
def least_area(
    pen: Pencil, source: Source, a: float, b: float, q: float, level: int, lanes: Lanes
) -> tuple[float, float]:  # fmt: skip
    """(Q, crossing) of the member whose crossing halves ∫ by_q(1 − κd) ds, so that its area is stationary.

    NaN if there is none; leaves its strip.
    """
    count, x = COUNTS[level], 0.0
    for _ in range(LEAST_ROUNDS):
        if not (q > 0.0) or fill(pen, q, count, lanes) > 0:
            return math.nan, x
        expand(WHOLE, level, lanes[BY_Q], lanes[BY_SERIES])
        moved = halving(WHOLE, count, lanes, x)
        if abs(moved - x) <= LEAST_MOVE:
            return q, x
        x = moved
        q = through(view(pen, source, 0.5 * (a + b) + 0.5 * (b - a) * x))
    return math.nan, x


@kernel
def relative_tail(pen: Pencil, count: int, series: Lane, area: float, zeros: int) -> float:
    """The part of the area that terms after ``count`` may make up, as far as rounding lets it be told."""
    part = max(0.0, tail(WHOLE, count, series) - pen[14] * pen[10]) / area
    if zeros == 0:  # Gauss quadrature is exact to twice the degree
        part *= math.sqrt(min(1.0, part))
    return part


@kernel
def exchange(
    code: int, source: Source, a: float, start: Frame, b: float, end: Frame,
    peaks: Peaks, calm: float, space: Space,
) -> tuple[float, float, float, Peaks]:  # fmt: skip
    """(area, Q, unrest, next peaks) of the arc [a, b].

    ``unrest`` estimates the relative error of the area; where it is above ``calm``, more nodes are asked for
    in the next call, and fewer where they would do.  The area is NaN where nothing was found.
    """
    level = int(peaks[0])
    lanes, crossing = lanes_of(space), 0.0
    more = (min(level + 1.0, len(NODES) - 1.0), 0.0, 0.0, 0.0)
    pen = pencil(start, end, source[1][4])
    if not is_proper(pen):
        return math.nan, math.nan, math.inf, peaks
    count = COUNTS[level]
    sample_panel(pen, source, a, b, WHOLE, level, lanes)
    if code == AREA_PARABOLA:
        q = parabola(pen)
        if math.isnan(q):
            return math.nan, math.nan, math.inf, peaks
        if fill(pen, q, count, lanes) > 0:
            q = math.nan
    else:
        q = 0.5 * (through_node(lanes, count // 2 - 1) + through_node(lanes, count // 2))
        if code == LEAST_AREA:
            q, crossing = least_area(pen, source, a, b, q, level, lanes)
        else:
            q = equal_moons(pen, q, level, lanes)
    if not (q > 0.0 and weight(pen, q) > -1.0):
        return math.nan, math.nan, math.inf, peaks
    series = lanes[SERIES]
    expand(WHOLE, level, lanes[STRIP], series)
    area, zeros = unsigned(WHOLE, level, lanes[STRIP], series)
    if code == LEAST_AREA:
        _, _, first = evaluate(WHOLE, count, series, crossing)
        _, _, signed = evaluate(WHOLE, count, series, 1.0)
        if area - abs(first) - abs(signed - first) > calm * area + pen[14] * pen[10]:
            return area, q, math.inf, peaks  # more than one crossing: stationarity is another equation
    unrest = relative_tail(pen, count, series, area, zeros)
    if not unrest <= calm:
        return area, q, unrest, more
    if level > 0:
        fewer = relative_tail(pen, COUNTS[level - 1], series, area, zeros)
        if fewer <= SPARE * calm:
            return area, q, unrest, (level - 1.0, 0.0, 0.0, 0.0)
    return area, q, unrest, peaks
