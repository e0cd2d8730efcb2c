"""Arc lengths along one arc from few samples: the speed as a Chebyshev series, and its integral.

The series has `FEW` terms, or `MANY` where those do not suffice, so the middle of an arc by arc length
needs no further samples of the curve.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.bracket import safeguarded
from osculant.kernels.curves.space import Source, sample
from osculant.kernels.curves.vectors import norm
from osculant.kernels.jit import kernel

#: degrees of the two series, and the last coefficients relative to the first with which the short one is good
FEW, MANY, GOOD = 8, 32, 1e-9
#: Newton steps of the inversion, and the change of the place in [−1, 1] that ends them
STEPS, SETTLED = 20, 1e-13

#: rows: speeds at the nodes, coefficients of the speed, of the arc length; [0, −1] the degree
Lengths = np.ndarray[Any, Any]


@kernel
def workspace(fit: Any) -> Lengths:
    """Scratch space for `measure_lengths`, made once per spline."""
    return np.zeros((3, MANY + 3))


@kernel
def fit(source: Source, a: float, b: float, degree: int, space: Lengths) -> float:
    """Fill ``space`` with the series of one degree; returns how large its last coefficients are."""
    middle, half = 0.5 * (a + b), 0.5 * (b - a)
    values, speed, length = space[0], space[1], space[2]
    for k in range(degree + 1):
        t = middle + half * math.cos(math.pi * k / degree)
        values[k] = half * norm(sample(source, min(b, max(a, t))).velocity)
    # cosines of multiples of π/degree, by the index modulo 2·degree
    for j in range(degree + 1):
        total = 0.5 * (values[0] + (values[degree] if j % 2 == 0 else -values[degree]))
        for k in range(1, degree):
            total += values[k] * math.cos(math.pi * ((j * k) % (2 * degree)) / degree)
        speed[j] = total * 2.0 / degree
    speed[0] *= 0.5
    speed[degree] *= 0.5
    speed[degree + 1] = speed[degree + 2] = 0.0
    length[1] = speed[0] - 0.5 * speed[2]
    for j in range(2, degree + 2):
        length[j] = 0.5 * (speed[j - 1] - speed[j + 1]) / j
    total, sign = 0.0, 1.0
    for j in range(1, degree + 2):  # the length is 0 at −1
        total += sign * length[j]
        sign = -sign
    length[0] = total
    space[0, -1] = degree
    return float(abs(speed[degree]) + abs(speed[degree - 1]))


@kernel
def series(coefficients: np.ndarray[Any, Any], degree: int, x: float) -> float:
    """A Chebyshev series at x, by Clenshaw's recurrence."""
    last, before = 0.0, 0.0
    for j in range(degree, 0, -1):
        last, before = 2.0 * x * last - before + coefficients[j], last
    return float(x * last - before + coefficients[0])


@kernel
def measure_lengths(source: Source, a: float, b: float, space: Lengths) -> float:
    """σ, the arc length from a to b, leaving in ``space`` what `after` needs."""
    if fit(source, a, b, FEW, space) > GOOD * space[1, 0]:
        fit(source, a, b, MANY, space)
    return series(space[2], int(space[0, -1]) + 1, 1.0)


@kernel
def after(space: Lengths, a: float, b: float, length: float, sigma: float) -> float:
    """The parameter at an arc length from a, within [a, b]."""
    degree = int(space[0, -1])
    low, high = -1.0, 1.0
    x = 2.0 * length / sigma - 1.0
    for _ in range(STEPS):
        miss = series(space[2], degree + 1, x) - length
        before = x
        x, low, high = safeguarded(x, -miss / series(space[1], degree, x), not miss < 0.0, low, high)
        if abs(x - before) <= SETTLED:
            break
    return 0.5 * (a + b) + 0.5 * (b - a) * x
