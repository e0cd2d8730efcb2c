"""Series of functions on [−1, 1] that vanish to order m at both ends, for areas between their zeros.

f = (1 − x²)^m Σ a_k p_k with the polynomials p_k orthonormal for the weight (1 − x²)^m.  From values at the
Gauss nodes of that weight the coefficients are those of interpolation, and the antiderivative is closed:
∫ (1 − x²)^m p_k = −(1 − x²)^{m+1} r_{k−1}/√(k(k + 2m + 1)), with r the polynomials of the next weight.  So
areas between zeros need no further values of f, and the last coefficients say how far to trust the series.

The tables are of numerical analysis: the nodes are eigenvalues of the recurrence (Golub, Welsch).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.jit import kernel

#: numbers of nodes to choose from
NODES = (6, 8, 12, 16, 24)
MOST = NODES[-1]
#: the orders m for which there are tables: panels inside an arc, and a whole arc
ORDERS = (0, 2)
#: visits of one zero, and the step, in parts of [−1, 1], that ends them: the area is stationary in it
VISITS, SETTLED = 12, 1e-7
#: neighbouring terms taken together, as they oscillate; a zero counts twice in the area, and decay may be
#: irregular
GROUP, CAUTION = 3, 4.0
#: points at which the terms' greatest values are looked for
FINE = 2001

Table = np.ndarray[Any, Any]


def _recurrence(m: int) -> Table:
    """b₁ … of x p_k = b_{k+1} p_{k+1} + b_k p_{k−1}, for the weight (1 − x²)^m."""
    k = np.arange(1.0, MOST + 1)
    return np.asarray(0.5 * np.sqrt(k * (k + 2 * m) / ((k + m + 0.5) * (k + m - 0.5))))


def _total(m: int) -> float:
    """∫ (1 − x²)^m over [−1, 1]."""
    return 2.0 * math.prod(2 * j / (2 * j + 1) for j in range(1, m + 1))


def _polynomials(m: int, x: Table) -> Table:
    """p_k(x), a row for each k < `MOST`."""
    b = _recurrence(m)
    rows = [np.full_like(x, _total(m) ** -0.5)]
    rows.append(x * rows[0] / b[0])
    for k in range(1, MOST - 1):
        rows.append((x * rows[k] - b[k - 1] * rows[k - 1]) / b[k])
    return np.array(rows)


def _rule(m: int, count: int) -> tuple[Table, Table, Table]:
    """Nodes, weights for ∫f from its values, and the matrix [i, k] from values to coefficients."""
    b = _recurrence(m)[: count - 1]
    nodes = np.linalg.eigvalsh(np.diag(b, 1) + np.diag(b, -1))
    nodes = (nodes - nodes[::-1]) / 2
    values = _polynomials(m, nodes)[:count]
    gauss = 1.0 / (values**2).sum(axis=0) / (1 - nodes**2) ** m
    return nodes, gauss, (values * gauss).T


def _tables() -> tuple[Table, Table, Table]:
    shape = (len(ORDERS), len(NODES), MOST)
    nodes, weights, matrices = np.zeros(shape), np.zeros(shape), np.zeros((*shape, MOST))
    for i, m in enumerate(ORDERS):
        for j, count in enumerate(NODES):
            rule = _rule(m, count)
            nodes[i, j, :count], weights[i, j, :count], matrices[i, j, :count, :count] = rule
    return nodes, weights, matrices


def _reach(m: int) -> Table:
    """The greatest value of the antiderivative of each term k ≥ 1 (of the first, 0)."""
    x = np.linspace(-1, 1, FINE)
    k = np.arange(1, MOST)
    values = (1 - x * x) ** (m + 1) * _polynomials(m + 1, x)[:-1] / np.sqrt(k * (k + 2 * m + 1))[:, None]
    return np.concatenate([[0.0], np.abs(values).max(axis=1)])


#: by order and number of nodes (indices into `ORDERS`, `NODES`)
POINTS, WEIGHTS, MATRICES = _tables()
COUNTS = np.array(NODES)
REACH = np.array([_reach(m) for m in ORDERS])
#: b_k and 1/b_k of the weights of orders m and m + 1
_B = np.array([[_recurrence(m), _recurrence(m + 1)] for m in ORDERS])
DOWN, UP = _B, 1.0 / _B
#: √(k(k + 2m + 1)) and the constants p₀, r₀
FACTORS = np.array([np.sqrt(np.arange(MOST) * (np.arange(MOST) + 2.0 * m + 1)) for m in ORDERS])
FIRST = np.array([[_total(m) ** -0.5, _total(m + 1) ** -0.5] for m in ORDERS])


@kernel
def expand(order: int, level: int, values: Table, series: Table) -> None:
    """The coefficients of the function with these values at the nodes."""
    count = COUNTS[level]
    for k in range(count):
        series[k] = 0.0
    for i in range(count):
        value = values[i]
        for k in range(count):
            series[k] += MATRICES[order, level, i, k] * value


@kernel
def evaluate(order: int, count: int, series: Table, x: float) -> tuple[float, float, float]:
    """(g, g′, ∫f from −1) at x, where f = (1 − x²)^m g."""
    square = 1.0 - x * x
    whole, end = x + 1.0, square
    if order == 1:  # m = 2
        whole, end = x * (1.0 - x * x * (2.0 / 3.0 - 0.2 * x * x)) + 8.0 / 15.0, square * square * square
    p_before, p = 0.0, FIRST[order, 0]
    r_before, r = 0.0, FIRST[order, 1]
    value, slope, area = series[0] * p, 0.0, 0.0
    for k in range(1, count):
        p_before, p = p, (x * p - DOWN[order, 0, k - 2] * p_before if k > 1 else x * p) * UP[order, 0, k - 1]
        value += series[k] * p
        slope += series[k] * FACTORS[order, k] * r
        area += series[k] * r / FACTORS[order, k]
        r_before, r = r, (x * r - DOWN[order, 1, k - 2] * r_before if k > 1 else x * r) * UP[order, 1, k - 1]
    return value, slope, series[0] * FIRST[order, 0] * whole - end * area


@kernel
def zero(
    order: int, count: int, series: Table, low: float, at_low: float, high: float, at_high: float
) -> float:
    """∫f from −1 to a zero of g between two places where it has opposite signs."""
    x = (low * at_high - high * at_low) / (at_high - at_low)
    area = 0.0
    for _ in range(VISITS):
        value, slope, area = evaluate(order, count, series, x)
        if (value > 0.0) == (at_low > 0.0):
            low = x
        else:
            high = x
        new = x - value / slope
        if not low <= new <= high:
            new = 0.5 * (low + high)
        if abs(new - x) <= SETTLED:
            break  # the integral is stationary there
        x = new
    return area


@kernel
def unsigned(order: int, level: int, values: Table, series: Table) -> tuple[float, int]:
    """(∫|f|, zeros) from the values at the nodes and their series."""
    count = COUNTS[level]
    x0 = -1.0
    g0, _, _ = evaluate(order, count, series, x0)
    total, before, zeros = 0.0, 0.0, 0
    for i in range(count + 1):
        if i < count:
            x = POINTS[order, level, i]
            g = values[i] / (1.0 - x * x) ** (2 * order)
        else:
            x = 1.0
            g, _, _ = evaluate(order, count, series, x)
        if (g0 > 0.0) != (g > 0.0):  # 0 is on one side: a node may be a crossing
            area = zero(order, count, series, x0, g0, x, g)
            total += abs(area - before)
            before = area
            zeros += 1
        x0, g0 = x, g
    _, _, area = evaluate(order, count, series, 1.0)
    return total + abs(area - before), zeros


@kernel
def tail(order: int, count: int, series: Table) -> float:
    """What the terms left out of ``count`` may contribute to the area between two zeros.

    From the last two groups of terms, taken for parts of a geometric series, times `CAUTION`.
    """
    last, before = 0.0, 0.0
    for k in range(count - GROUP, count):
        last += abs(series[k]) * REACH[order, k]
        before += abs(series[k - GROUP]) * REACH[order, k - GROUP]
    return CAUTION * last * min(1.0, last / before) if before > 0.0 else CAUTION * last
