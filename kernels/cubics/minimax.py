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
from osculant.kernels.cubics.scan import BY0, BY3, D, Space, look, measure, peaks_of, trace
from osculant.kernels.cubics.starts import starts
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.generated import cubics as generated
from osculant.kernels.jit import kernel

#: rounds from one start, the promise of a linear program that ends them, and that of a rival
ROUNDS, ENOUGH = 40, 1e-9
#: differences of arms to start from besides, in parts of the sum
TILTS = (0.0, 0.5, -0.5, 0.85, -0.85)
#: peaks are visited so often for a linear program
BRIEF = 2
#: the trust region at first, in parts of the arms, and the least one
REGION, NARROWEST = 0.1, 1e-12
#: peaks and samples in one linear program, and samples among them
CONSTRAINTS, AMONG = 20, 7
#: what fast steps level peaks to, after the search
CALM = 1e-9
#: a rival that has no three peaks is looked at so closely, and sought with care if it is so much lower
RIVAL_POINTS, RIVAL_ROUNDS, LOWER = 9, 4, 1.05


@kernel
def gather(space: Space, found: int, count: int, table: np.ndarray[Any, Any]) -> int:
    """Fill ``table`` with (d, derivative by the sum, by the difference) of peaks and samples; how many."""
    size = 0
    for k in range(min(found, CONSTRAINTS - AMONG)):
        peak, row = space.peaks[k], table[size]
        row[0], row[1], row[2] = peak[1], peak[2] + peak[3], peak[2] - peak[3]
        size += 1
    for k in range(AMONG):
        at, row = space.samples[(2 * k + 1) * count // (2 * AMONG)], table[size]
        row[0], row[1], row[2] = at[D], at[BY0] + at[BY3], at[BY0] - at[BY3]
        size += 1
    return size


@kernel
def lowest_by_sum(table: np.ndarray[Any, Any], size: int, by_difference: float) -> tuple[float, float]:
    """(level, change of the sum) that makes max |d| least for a given change of the difference."""
    top, step = 0.0, 0.0
    for i in range(size):
        di = table[i, 0] + by_difference * table[i, 2]
        for j in range(i + 1, size):
            dj = table[j, 0] + by_difference * table[j, 2]
            gi, gj = table[i, 1], table[j, 1]
            total = abs(gi) + abs(gj)
            if not total > 0.0:
                continue
            value = abs(di * gj - dj * gi) / total
            if value > top:
                # d + g·step is ±value at both
                sign = math.copysign(1.0, (di * gj - dj * gi) * gj)
                top = value
                if abs(gi) >= abs(gj):
                    step = (sign * value - di) / gi
                else:
                    sign = -math.copysign(1.0, (di * gj - dj * gi) * gi)
                    step = (sign * value - dj) / gj
    return top, step


@kernel
def lowest(table: np.ndarray[Any, Any], size: int, region: float) -> tuple[float, float, float]:
    """(level, change of the sum, change of the difference) that makes max |d| least, to first order.

    The least maximum of three unknowns is the largest of those of any three rows (Helly).
    """
    top, by_sum, by_difference = 0.0, 0.0, 0.0
    for i in range(size):
        for j in range(i + 1, size):
            wk = table[i, 1] * table[j, 2] - table[j, 1] * table[i, 2]
            for k in range(j + 1, size):
                wi = table[j, 1] * table[k, 2] - table[k, 1] * table[j, 2]
                wj = table[k, 1] * table[i, 2] - table[i, 1] * table[k, 2]
                total = abs(wi) + abs(wj) + abs(wk)
                if not total > 0.0:
                    continue
                sum_d = wi * table[i, 0] + wj * table[j, 0] + wk * table[k, 0]
                if not abs(sum_d) > top * total:
                    continue
                top = abs(sum_d) / total
                side = math.copysign(top, sum_d)
                ui = math.copysign(side, side * wi) - table[i, 0]
                uj = math.copysign(side, side * wj) - table[j, 0]
                uk = math.copysign(side, side * wk) - table[k, 0]
                if abs(wk) >= abs(wi) and abs(wk) >= abs(wj):
                    by_sum = (ui * table[j, 2] - uj * table[i, 2]) / wk
                    by_difference = (uj * table[i, 1] - ui * table[j, 1]) / wk
                elif abs(wi) >= abs(wj):
                    by_sum = (uj * table[k, 2] - uk * table[j, 2]) / wi
                    by_difference = (uk * table[j, 1] - uj * table[k, 1]) / wi
                else:
                    by_sum = (uk * table[i, 2] - ui * table[k, 2]) / wj
                    by_difference = (ui * table[k, 1] - uk * table[i, 1]) / wj
    if abs(by_difference) > region:
        by_difference = math.copysign(region, by_difference)
        top, by_sum = lowest_by_sum(table, size, by_difference)
    return top, by_sum, by_difference


@kernel
def looked(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float, count: int, space: Space
) -> tuple[float, int]:
    """(max |d|, peaks) of a cubic over the samples in ``space``; infinite if it strays."""
    if not (min(a0, a3) >= SHORTEST * ends.chord and trace(ends, a0, a3, space.samples, count)):
        return math.inf, 0
    return peaks_of(source, a, b, ends, a0, a3, count, space, BRIEF)


@kernel
def lowered(
    source: Source,
    a: float,
    b: float,
    ends: Ends,
    a0: float,
    a3: float,
    count: int,
    rounds: int,
    space: Space,
) -> tuple[float, float, float]:
    """(max |d|, arms) after lowering it from given arms, over the samples in ``space``; infinite if none."""
    table = np.empty((CONSTRAINTS, 3))
    error, found = looked(source, a, b, ends, a0, a3, count, space)
    region = REGION * (a0 + a3)
    for _ in range(rounds):
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
    for i in range(tried + len(TILTS)):
        if i < tried:
            a0, a3 = space.arms[i, 0], space.arms[i, 1]
        else:
            arm = reach(ends)
            a0, a3 = arm * (1.0 + TILTS[i - tried]), arm * (1.0 - TILTS[i - tried])
        value, a0, a3 = lowered(source, a, b, ends, a0, a3, count, ROUNDS, space)
        if value < error:
            error, arm0, arm3 = value, a0, a3
    if not error < math.inf:
        return math.inf, Arms(math.nan, math.nan)
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
        count = look(source, a, b, ends, RIVAL_POINTS, space.samples)
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
