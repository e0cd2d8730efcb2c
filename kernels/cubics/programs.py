"""Linear programs in both arms: how far max |d| is lowered, d being linear at its peaks and some samples."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.cubics.arms import SHORTEST, Ends
from osculant.kernels.cubics.scan import BY0, BY3, D, Space, peaks_of, trace
from osculant.kernels.curves.plane import Source
from osculant.kernels.jit import kernel

#: peaks are visited so often for a linear program
BRIEF = 2.0
#: peaks and samples in one linear program, and samples among them
CONSTRAINTS, AMONG = 16, 5


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
