"""The affine curvature of the bitangent conic nearest to a short arc, as a series in the arc's length.

Theorem 3.6.1: it is the mean of the affine curvatures of the curve at the two ends, to the second order. Here
it comes from the conic's matrix: k = S (T²)^{−1/3}, T the determinant and S that of its quadratic part.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.arc_displacement import KAPPA, optimal_pencil
from osculant.cas.jets.canonical import euclidean_arc
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.power_series import PowerSeries, power

#: powers of s carried along the curve; its middle term needs κ₄
ORDER = 8


def mean_end_curvature() -> PowerSeries:
    """(k(−h/2) + k(h/2))/2 as a series in h for κ = 1, three terms, over sympy's field ℚ(κ₁, κ₂, …).

    >>> mean_end_curvature()[0]
    (-5*kappa1**2 + 3*kappa2 + 9)/9
    """
    _, (X, Y) = _arc()
    rows = []
    for row in (X, Y):
        chain = [row]
        while len(chain) < 5:
            chain.append(chain[-1].derivative())
        rows.append([c.cut(ORDER - 3) for c in chain])
    jet = PlaneJet(rows[0], rows[1])
    k: PowerSeries = jet.parabolic_form * power(jet.inflection_form, Fraction(-8, 3)) / 9
    half = sp.QQ(1, 2)
    mean: PowerSeries = (k.scaled(half) + k.scaled(-half)) * half
    return mean.cut(3)


def optimal_curvature() -> PowerSeries:
    """k of the conic of least Hausdorff distance, in the form of `mean_end_curvature`.

    >>> difference = optimal_curvature() - mean_end_curvature()
    >>> difference[0], difference[1], difference[2] == 0
    (0, 0, False)
    """
    field, (X, Y) = _arc()
    half = field(sp.QQ(1, 2))
    (start, first), (end, last) = (
        ((X.scaled(at), Y.scaled(at)), (X.derivative().scaled(at), Y.derivative().scaled(at)))
        for at in (-half, half)
    )
    chord = (end[0] - start[0], end[1] - start[1])
    # the line [v, (x, y) − p] as coefficients of x, y, 1
    l0, l1, l2 = (
        (-v[1], v[0], v[1] * p[0] - v[0] * p[1]) for v, p in ((last, end), (chord, start), (first, start))
    )
    q = optimal_pencil()
    q = PowerSeries([field.zero] * 2 + [*q.coefficients])  # Q comes with h²
    matrix = [
        [(l1[i] * l1[j] - q * (l0[i] * l2[j] + l0[j] * l2[i]) * half).shifted(-4) for j in range(3)]
        for i in range(3)
    ]
    s = _minor(matrix, 0, 1)
    t = sum(
        (matrix[2][i] * _minor(matrix, (i + 1) % 3, (i + 2) % 3) for i in range(1, 3)),
        matrix[2][0] * _minor(matrix, 1, 2),
    )
    squared = t * t
    root = sp.cbrt(sp.sympify(squared[0].as_expr())) ** -1  # of a rational number: T does not vanish at h = 0
    return s * power(squared, Fraction(-1, 3), field(sp.QQ(root.p, root.q)))


def _minor(matrix: list[list[PowerSeries]], i: int, j: int) -> PowerSeries:
    return matrix[0][i] * matrix[1][j] - matrix[0][j] * matrix[1][i]


def _arc() -> tuple[Any, tuple[PowerSeries, PowerSeries]]:
    field = sp.QQ.frac_field(*KAPPA[1:6])
    X, Y, _ = euclidean_arc(ORDER, [field.one, *field.gens, field.zero])
    return field, (X, Y)
