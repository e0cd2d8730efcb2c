"""The fast step of the area metric: the piece of one arc, and its area, from one row of samples.

The curve is sampled once, at the Gauss nodes of the weight (1 − x²)², as the strip between arc and conic
vanishes doubly at both ends; Q is found by Newton's method on these samples, and the moons' areas by the
strip's series (`strip_series`).  The number of nodes, a level, follows the decay of the series:
a result is trusted only where the terms left out cannot matter.
"""

from __future__ import annotations

import math
from typing import Any

from osculant.kernels.bracket import safeguarded
from osculant.kernels.conics.pencil import Pencil, is_proper, parabola, pencil, through, view, weight
from osculant.kernels.conics.strip import (
    BY_Q,
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
from osculant.kernels.curves.peaks import Space
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.jit import kernel

#: a whole arc, as one panel
WHOLE = 1
#: which of `COUNTS` is the number of nodes at first
FIRST_LEVEL = 1
#: Newton steps for Q; the last one is taken on the strip's tangent, at this part of the area
Q_STEPS, NEARLY = 8, 1e-7
#: steps for the crossing of the conic of least area; one so small, in parts of the arc, is the last: Newton's
#: method squares it
PLACE_STEPS, PLACED = 40, 1e-6
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
        if abs(signed) <= NEARLY * size + pen.noise * pen.chord:
            for i in range(count):
                lanes[STRIP, i] -= step * lanes[BY_Q, i]
            return q - step
        q -= step
    return math.nan


@kernel
def halfway(pen: Pencil, source: Source, a: float, b: float) -> tuple[float, float]:
    """(Q, place) of the member that crosses the arc on the line through its control point and mid-chord.

    The place is the root of the linear form l₀ sin A − l₂ sin B, positive at a and negative at b: of a
    strictly convex arc that each member crosses once at most the member through it is the only one of least
    area (theorem C, the thesis's conjecture 3.1.2).  Q is NaN if it has no member.
    """
    low, high, t = a, b, 0.5 * (a + b)
    for _ in range(PLACE_STEPS):
        seen = view(pen, source, t)
        form = seen.l0 * pen.sin_a - seen.l2 * pen.sin_b
        slope = (seen.t0 * pen.sin_a - seen.t2 * pen.sin_b) * seen.speed
        before = t
        t, low, high = safeguarded(t, -form / slope, form < 0.0, low, high)
        if abs(t - before) <= PLACED * (b - a):
            break
    return through(view(pen, source, t)), t


@kernel
def relative_tail(pen: Pencil, count: int, series: Lane, area: float, zeros: int) -> float:
    """The part of the area that terms after ``count`` may make up, as far as rounding lets it be told."""
    part = max(0.0, tail(WHOLE, count, series) - pen.noise * pen.chord) / area
    if zeros == 0:  # Gauss quadrature is exact to twice the degree
        part *= math.sqrt(min(1.0, part))
    return part


@kernel
def through_middle(lanes: Lanes, count: int) -> float:
    """About the Q of the member that crosses the arc in its middle."""
    return 0.5 * (through_node(lanes, count // 2 - 1) + through_node(lanes, count // 2))


@kernel
def other_level(
    pen: Pencil, level: int, series: Lane, area: float, zeros: int, calm: float
) -> tuple[bool, int]:
    """(settled, next level): whether the area's relative error is small, and more or fewer nodes."""
    if not relative_tail(pen, COUNTS[level], series, area, zeros) <= calm:
        return False, min(level + 1, len(NODES) - 1)
    if level > 0 and relative_tail(pen, COUNTS[level - 1], series, area, zeros) <= SPARE * calm:
        return True, level - 1
    return True, level


@kernel
def area_of(pen: Pencil, q: float, level: int, calm: float, lanes: Lanes) -> tuple[float, float, bool, int]:
    """(area, Q, settled, next level) of the member Q, whose strip is in ``lanes``; NaN if improper."""
    if not (q > 0.0 and weight(pen, q) > -1.0):
        return math.nan, math.nan, False, level
    series = lanes[SERIES]
    expand(WHOLE, level, lanes[STRIP], series)
    area, zeros = unsigned(WHOLE, level, lanes[STRIP], series)
    settled, after = other_level(pen, level, series, area, zeros, calm)
    return area, q, settled, after


@kernel
def parabola_area(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    level: int, calm: float, space: Space,
) -> tuple[float, float, bool, int]:  # fmt: skip
    """(area, Q, settled, next level) of the parabola of the arc [a, b], from `COUNTS` [level] nodes.

    Where the estimated relative error of the area is above ``calm``, it has not settled, and more nodes are
    asked for in the next call; fewer where they would do.  The area is NaN where nothing was found.
    """
    lanes = lanes_of(space)
    pen = pencil(start, end, source.place.noise)
    q = math.nan
    if is_proper(pen):
        sample_panel(pen, source, a, b, WHOLE, level, lanes)
        q = parabola(pen)
        if not math.isnan(q) and fill(pen, q, COUNTS[level], lanes) > 0:
            q = math.nan
    return area_of(pen, q, level, calm, lanes)


@kernel
def equal_area(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    level: int, calm: float, space: Space,
) -> tuple[float, float, bool, int]:  # fmt: skip
    """The same for the conic whose moons are equal."""
    lanes = lanes_of(space)
    pen = pencil(start, end, source.place.noise)
    q = math.nan
    if is_proper(pen):
        sample_panel(pen, source, a, b, WHOLE, level, lanes)
        q = equal_moons(pen, through_middle(lanes, COUNTS[level]), level, lanes)
    return area_of(pen, q, level, calm, lanes)


@kernel
def stationary_area(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    level: int, calm: float, space: Space,
) -> tuple[float, float, bool, int]:  # fmt: skip
    """The same for the conic of least area, which has not settled where it crosses the arc more than once.

    Then the linear form does not tell it.
    """
    lanes, x, q = lanes_of(space), 0.0, math.nan
    count = COUNTS[level]
    pen = pencil(start, end, source.place.noise)
    if is_proper(pen):
        sample_panel(pen, source, a, b, WHOLE, level, lanes)
        q, t = halfway(pen, source, a, b)
        x = 2.0 * (t - a) / (b - a) - 1.0
        if not (q > 0.0) or fill(pen, q, count, lanes) > 0:
            q = math.nan
    area, q, settled, after = area_of(pen, q, level, calm, lanes)
    if area > 0.0:
        _, _, first = evaluate(WHOLE, count, lanes[SERIES], x)
        _, _, signed = evaluate(WHOLE, count, lanes[SERIES], 1.0)
        if area - abs(first) - abs(signed - first) > calm * area + pen.noise * pen.chord:
            return area, q, False, level
    return area, q, settled, after


@kernel
def first_level(fit: Any) -> int:
    """`FIRST_LEVEL`, whatever the fit."""
    return FIRST_LEVEL
