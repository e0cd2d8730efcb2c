"""The careful step for areas: the cubic of least area whatever the number of its crossings.

Longer arms move the cubic outwards everywhere, so the area falls and then grows with their sum: its minimum
is where its derivative changes sign.  That minimum is a function of the difference alone, which golden
sections follow down from every start.
"""

from __future__ import annotations

import math
from typing import Any

from osculant.kernels.cubics.area_exchange import BETTER, LIKELY, crossed, from_starts
from osculant.kernels.cubics.area_scan import areas_of, measure
from osculant.kernels.cubics.arms import SHORTEST, Ends, ends_of, reach
from osculant.kernels.cubics.exchange import Arms
from osculant.kernels.cubics.scan import Space, look
from osculant.kernels.cubics.starts import starts
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.generated import cubics as generated
from osculant.kernels.jit import kernel

#: steps of the search for the sum, and the relative change of it that ends them
STEPS, SETTLED = 24, 1e-10
#: how far from a start a difference is looked for, in parts of the sum, samples there, and golden sections
WINDOW, GRID, SECTIONS = 0.2, 5, 32
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
#: a cubic that crosses twice has the area that the crossings say, to this part
ALIKE, CALM = 1e-8, 1e-12
#: panels between crossings
PANELS = 1.0


@kernel
def least_by_sum(
    source: Source, a: float, b: float, ends: Ends, total: float, difference: float, count: int, space: Space
) -> tuple[float, float]:
    """(area, sum) of the cubic of least area with a given difference of arms, the sum sought from a guess."""
    low, high = max(abs(difference) * (1.0 + SHORTEST), SHORTEST * ends.chord), 4.0 * total
    best, best_total = math.inf, total
    x, before, slope_before = total, math.nan, math.nan
    for _ in range(STEPS):
        found = areas_of(
            source, a, b, ends, 0.5 * (x + difference), 0.5 * (x - difference), count, int(PANELS), space
        )
        if found.area < best:
            best, best_total = found.area, x
        slope = found.by0 + found.by3
        if not found.area < math.inf:  # nearer to the guess, or to the best
            if abs(x - best_total) <= SETTLED * x:
                break
            if x > best_total:
                high = x
            else:
                low = x
            x = 0.5 * (x + best_total)
            continue
        if slope > 0.0:
            high = x
        else:
            low = x
        new = x - slope * (x - before) / (slope - slope_before)
        if math.isnan(before):
            new = x * (1.0 - math.copysign(0.01, slope))
        if not low < new < high:
            new = 0.5 * (max(low, 0.5 * x) + min(high, 2.0 * x))
        before, slope_before = x, slope
        if abs(new - x) <= SETTLED * x:
            break
        x = new
    return best, best_total


@kernel
def descended(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float, count: int, space: Space
) -> tuple[float, float, float]:
    """(area, arms) of a cubic of least area near given arms; infinite if none is found."""
    total, centre = a0 + a3, a0 - a3
    best, at, at_total = math.inf, centre, total
    width = 2.0 * WINDOW * total / (GRID - 1)
    for i in range(GRID):
        x = centre + (i - (GRID - 1) // 2) * width
        value, found = least_by_sum(source, a, b, ends, total, x, count, space)
        if value < best:
            best, at, at_total = value, x, found
    if not best < math.inf:
        return math.inf, math.nan, math.nan
    low, high = at - width, at + width
    left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    value_left, total_left = least_by_sum(source, a, b, ends, at_total, left, count, space)
    value_right, total_right = least_by_sum(source, a, b, ends, at_total, right, count, space)
    for _ in range(SECTIONS):
        if value_left < best:
            best, at, at_total = value_left, left, total_left
        if value_right < best:
            best, at, at_total = value_right, right, total_right
        if value_left < value_right:
            high, right, value_right = right, left, value_left
            left = high - GOLDEN * (high - low)
            value_left, total_left = least_by_sum(source, a, b, ends, at_total, left, count, space)
        else:
            low, left, value_left = left, right, value_right
            right = low + GOLDEN * (high - low)
            value_right, total_right = least_by_sum(source, a, b, ends, at_total, right, count, space)
    return best, 0.5 * (at_total + at), 0.5 * (at_total - at)


@kernel
def best(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, Arms]:
    """(area, arms) of the cubic of least area that is found from every start; infinite if there is none."""
    ends = ends_of(start, end)
    count = look(source, a, b, ends, points, space.samples)
    if count < 0:
        return math.inf, Arms(math.nan, math.nan)
    _, tried = starts(source, a, b, ends, space.rows, space.zeros, space.arms)
    area, arm0, arm3 = math.inf, math.nan, math.nan
    for i in range(tried + 1):
        if i == tried and area < math.inf:
            break
        a0 = a3 = reach(ends)
        if i < tried:
            a0, a3 = space.arms[i, 0], space.arms[i, 1]
        fast = crossed(source, a, b, ends, a0, a3, generated.CROSSING, 1.0 - generated.CROSSING, CALM)
        value = math.inf
        if fast.settled:
            value = areas_of(source, a, b, ends, fast.a0, fast.a3, count, int(PANELS), space).area
        if abs(value - fast.area) <= ALIKE * fast.area:
            a0, a3 = fast.a0, fast.a3
        else:
            value, a0, a3 = descended(source, a, b, ends, a0, a3, count, space)
        if value < area:
            area, arm0, arm3 = value, a0, a3
    if not area < math.inf:
        return math.inf, Arms(math.nan, math.nan)
    return measure(source, a, b, ends, arm0, arm3, points, space), Arms(arm0, arm3)


@kernel
def confirm(
    fit: Any, arms: Arms, source: Source, a: float, start: Frame, b: float, end: Frame, points: int,
    space: Space,
) -> tuple[float, Arms]:  # fmt: skip
    """(area, arms) of the cubic, measured from ``points`` samples or more; or of a better one there is."""
    ends = ends_of(start, end)
    area = measure(source, a, b, ends, arms.a0, arms.a3, points, space)
    if area == 0.0:
        return area, arms
    other = from_starts(source, a, b, ends, BETTER * area, LIKELY, space)
    if other.area < area:
        value = measure(source, a, b, ends, other.a0, other.a3, points, space)
        if value < area:
            return value, Arms(other.a0, other.a3)
    return area, arms
