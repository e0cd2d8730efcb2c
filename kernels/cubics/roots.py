"""Real zeros of polynomials of degree four at most, and where they nearly have one."""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.bracket import safeguarded
from osculant.kernels.jit import kernel

#: degree at most, and the columns that a polynomial takes
DEGREE = 4
COLUMNS = DEGREE + 1
#: Newton steps of one zero, and the relative change that ends them
STEPS, SETTLED = 80, 1e-14


@kernel
def value(row: np.ndarray[Any, Any], x: float) -> float:
    """The polynomial with coefficients from x⁰ on, at x."""
    total = 0.0
    for i in range(DEGREE, -1, -1):
        total = total * x + row[i]
    return total


@kernel
def zero_between(
    row: np.ndarray[Any, Any], slope: np.ndarray[Any, Any], low: float, high: float, rising: bool
) -> float:
    """The zero of a monotone polynomial between two places where it has opposite signs."""
    x = 0.5 * (low + high)
    for _ in range(STEPS):
        at = value(row, x)
        rate = value(slope, x)
        before = x
        x, low, high = safeguarded(x, -at / rate, (at > 0.0) == rising, low, high)
        if abs(x - before) <= SETTLED * abs(x):
            break
    return x


@kernel
def real_zeros(rows: np.ndarray[Any, Any], low: float, high: float, found: np.ndarray[Any, Any]) -> int:
    """Fill ``found`` with the zeros inside (low, high), in order; returns how many.

    Args:
        rows: (5, 5): the first row has the coefficients from x⁰ on; its derivatives fill the others.
        low: the lower bound.
        high: the upper one.
        found: (2, 6) room: the second row gets the zeros of the derivative, NaN after the last.

    Zeros of even order count if rounding lets the polynomial change its sign there.
    """
    for k in range(1, DEGREE + 1):
        for i in range(DEGREE):
            rows[k, i] = (i + 1) * rows[k - 1, i + 1]
        rows[k, DEGREE] = 0.0
    zeros, stops = found[0], found[1]
    count = 0
    for k in range(DEGREE - 1, -1, -1):
        row, slope = rows[k], rows[k + 1]
        for i in range(count):
            stops[i] = zeros[i]
        for i in range(count, stops.shape[0]):
            stops[i] = np.nan
        last, count = count, 0
        before, at_before = low, value(row, low)
        for i in range(last + 1):
            after = stops[i] if i < last else high
            at_after = value(row, after)
            if at_before * at_after < 0.0:
                zeros[count] = zero_between(row, slope, before, after, at_after > 0.0)
                count += 1
            before, at_before = after, at_after
    return count
