"""The careful step: the best cubic of an arc whatever the number and place of its error's peaks.

From every start the largest |d| is lowered by linear programs in both arms: d is linearised at its peaks and
at some samples.  The sum of the arms is stiff, their difference soft, and the valley is curved: only changes
of the difference are bounded by a trust region, and after each the sum is corrected alone.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.cubics.arms import SHORTEST, Ends, ends_of, reach
from osculant.kernels.cubics.exchange import Arms, level, likely_rival
from osculant.kernels.cubics.programs import CONSTRAINTS, gather, looked, lowest, lowest_by_sum
from osculant.kernels.cubics.scan import Space, look, measure
from osculant.kernels.cubics.starts import starts
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.generated import cubics as generated
from osculant.kernels.jit import kernel

#: rounds from one start, and the promise of a linear program that ends them; rounds are floats here, as numba
#: would compile for each whole number anew
ROUNDS, ENOUGH = 40.0, 1e-9
#: rounds that tell which start is the best; the second is followed, too, if it is so much worse at most, and
#: if its arms differ by more than this part
FEW_ROUNDS, RIVAL, ALIKE = 5.0, 3.0, 1e-3
#: differences of arms to start from besides, in parts of the sum
TILTS = (0.0, 0.5, -0.5, 0.85, -0.85)
#: the trust region at first, in parts of the arms, and the least one
REGION, NARROWEST = 0.1, 1e-12
#: corrections of the sum for one difference; the first step along the valley in parts of the sum, steps at
#: most, and golden sections, each of which leaves this part of the longer side
SUMS, FIRST, SLIDES, SECTIONS, GOLDEN = 5, 1e-3, 12, 24, 0.381966
#: what fast steps level peaks to, after the search
CALM = 1e-9
#: a rival that has no three peaks is looked at so closely, and sought with care if it is so much lower
RIVAL_POINTS, RIVAL_ROUNDS, LOWER = 9.0, 4.0, 1.05


@kernel
def lowered(
    source: Source,
    a: float,
    b: float,
    ends: Ends,
    a0: float,
    a3: float,
    count: int,
    rounds: float,
    space: Space,
) -> tuple[float, float, float]:
    """(max |d|, arms) after lowering it from given arms, over the samples in ``space``; infinite if none."""
    table = np.empty((CONSTRAINTS, 3))
    error, found = looked(source, a, b, ends, a0, a3, count, space)
    region = REGION * (a0 + a3)
    for _ in range(int(rounds)):
        if not error < math.inf:
            break
        size = gather(space, found, count, table)
        target, by_sum, by_difference = lowest(table, size, region)
        promise = error - target
        if not promise > ENOUGH * error or region <= NARROWEST * (a0 + a3):
            break
        shortest = SHORTEST * ends.chord
        new0 = max(shortest, a0 + by_sum + by_difference)
        new3 = max(shortest, a3 + by_sum - by_difference)
        value, found = looked(source, a, b, ends, new0, new3, count, space)
        if value < math.inf:
            size = gather(space, found, count, table)
            _, by_sum = lowest_by_sum(table, size, 0.0)
            other, others = looked(source, a, b, ends, new0 + by_sum, new3 + by_sum, count, space)
            if other < value:
                value, found, new0, new3 = other, others, new0 + by_sum, new3 + by_sum
        if value < error:
            region *= 2.0 if error - value > 0.5 * promise else 0.5
            error, a0, a3 = value, new0, new3
        else:
            region = 0.25 * min(region, abs(by_difference))
        # what is in the space must belong to these arms
        error, found = looked(source, a, b, ends, a0, a3, count, space)
    return error, a0, a3


@kernel
def along_valley(
    source: Source, a: float, b: float, ends: Ends, total: float, difference: float, count: int, space: Space
) -> tuple[float, float]:
    """(max |d|, sum) of the cubic that has the least with a given difference of arms, from a sum nearby."""
    table = np.empty((CONSTRAINTS, 3))
    least = abs(difference) + 2.0 * SHORTEST * ends.chord
    best, best_total, total = math.inf, total, max(total, least)
    for _ in range(SUMS):
        error, found = looked(
            source, a, b, ends, 0.5 * (total + difference), 0.5 * (total - difference), count, space
        )
        if not error < best:
            break
        best, best_total = error, total
        _, by_sum = lowest_by_sum(table, gather(space, found, count, table), 0.0)
        total = max(least, total + 2.0 * by_sum)
    return best, best_total


@kernel
def slid(
    source: Source, a: float, b: float, ends: Ends, error: float, a0: float, a3: float, count: int,
    space: Space,
) -> tuple[float, float, float]:  # fmt: skip
    """(max |d|, arms) after following the valley down from given arms, where it is too curved for `lowered`.

    Steps of the difference grow while the error falls; golden sections then find where it is least.
    """
    total, at = a0 + a3, a0 - a3
    for side in (-1.0, 1.0):
        behind, step = at, side * FIRST * total
        ahead = at + step
        value, found = along_valley(source, a, b, ends, total, ahead, count, space)
        if not value < error * (1.0 - ENOUGH):
            continue
        for _ in range(SLIDES):
            behind, at, error, total = at, ahead, value, found
            step *= 2.0
            ahead = at + step
            value, found = along_valley(source, a, b, ends, total, ahead, count, space)
            if not value < error:
                break
        for _ in range(SECTIONS):
            on = abs(ahead - at) > abs(behind - at)
            probe = at + GOLDEN * ((ahead if on else behind) - at)
            value, found = along_valley(source, a, b, ends, total, probe, count, space)
            if value < error:
                if on:
                    behind = at
                else:
                    ahead = at
                at, error, total = probe, value, found
            elif on:
                ahead = probe
            else:
                behind = probe
        break
    return error, 0.5 * (total + at), 0.5 * (total - at)


@kernel
def best(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, Arms]:
    """(error, arms) of the best cubic of the arc [a, b] that is found from every start; infinite if none."""
    ends = ends_of(start, end)
    count = look(source, a, b, ends, points, space.samples)
    if count < 0:
        return math.inf, Arms(math.nan, math.nan)
    _, tried = starts(source, a, b, ends, space.rows, space.zeros, space.arms)
    error, arm0, arm3 = math.inf, math.nan, math.nan
    second, next0, next3 = math.inf, math.nan, math.nan
    for i in range(tried + len(TILTS)):  # from all a few rounds, from the two best as many as it takes
        if i < tried:
            a0, a3 = space.arms[i, 0], space.arms[i, 1]
        else:
            arm = reach(ends)
            a0, a3 = arm * (1.0 + TILTS[i - tried]), arm * (1.0 - TILTS[i - tried])
        value, a0, a3 = lowered(source, a, b, ends, a0, a3, count, FEW_ROUNDS, space)
        if value < error:
            second, next0, next3 = error, arm0, arm3
            error, arm0, arm3 = value, a0, a3
        elif value < second and abs(a0 - arm0) + abs(a3 - arm3) > ALIKE * (a0 + a3):
            second, next0, next3 = value, a0, a3
    error, arm0, arm3 = lowered(source, a, b, ends, arm0, arm3, count, ROUNDS, space)
    if second < RIVAL * error:
        value, a0, a3 = lowered(source, a, b, ends, next0, next3, count, ROUNDS, space)
        if value < error:
            error, arm0, arm3 = value, a0, a3
    if not error < math.inf:
        return math.inf, Arms(math.nan, math.nan)
    value, a0, a3 = slid(source, a, b, ends, error, arm0, arm3, count, space)
    if value < error:
        _, arm0, arm3 = lowered(source, a, b, ends, a0, a3, count, ROUNDS, space)
    error = measure(source, a, b, ends, arm0, arm3, points, space)
    fine = level(source, a, b, ends, arm0, arm3, generated.FIRST, 0.5, generated.LAST, CALM)
    if fine.settled and error > 0.0:
        value = measure(source, a, b, ends, fine.a0, fine.a3, points, space)
        if value <= error * (1.0 + CALM):
            return value, Arms(fine.a0, fine.a3)
    return error, Arms(arm0, arm3)


@kernel
def confirm(
    fit: Any,
    arms: Arms,
    source: Source,
    a: float,
    start: Frame,
    b: float,
    end: Frame,
    points: int,
    space: Space,
) -> tuple[float, Arms]:
    """(error, arms) of the cubic, measured from ``points`` samples or more; or of a better one, if there is.

    All other cubics with the arc's area and moment are compared with it, and those that merged ones leave.
    """
    ends = ends_of(start, end)
    error = measure(source, a, b, ends, arms.a0, arms.a3, points, space)
    if not 0.0 < error < math.inf:
        return error, arms
    other, sure, merged = likely_rival(source, a, b, ends, error, space)
    if other.error < error:
        value = measure(source, a, b, ends, other.a0, other.a3, points, space)
        if value < error:
            error, arms = value, Arms(other.a0, other.a3)
    for i in range(sure, merged):
        count = look(source, a, b, ends, int(RIVAL_POINTS), space.samples)
        value, a0, a3 = lowered(
            source, a, b, ends, space.arms[i, 0], space.arms[i, 1], count, RIVAL_ROUNDS, space
        )
        if value < LOWER * error:
            count = look(source, a, b, ends, points, space.samples)
            _, a0, a3 = lowered(source, a, b, ends, a0, a3, count, ROUNDS, space)
            value = measure(source, a, b, ends, a0, a3, points, space)
            if value < error:
                error, arms = value, Arms(a0, a3)
    return error, arms
