"""Affine and Euclidean invariants of plane curves, derived from their definitions (thesis 2.2).

Nothing here is a formula for an invariant: each follows from reparametrisation by arc length. The forms of
`osculant.cas.invariants`, which are what the programs run, are held against these by the tests.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from osculant.cas.derivations.jets import Vector, along, bracket, derivative, phi, v, x, y


def by_affine_arc_length(order: int) -> list[Vector]:
    """The derivatives γ′, …, γ⁽ᵒʳᵈᵉʳ⁾ by affine arc length r of γ(r) = α(u(r)), where du/dr = 1/φ (2.4).

    That (2.1), [γ′, γ″] = 1, holds with this φ = [α̇, α̈]^{1/3} is proved in the tests.

    >>> by_affine_arc_length(1)
    [(x1/phi, y1/phi)]
    """
    vectors = [(x[1] / phi, y[1] / phi)]
    while len(vectors) < order:
        vectors.append(along(vectors[-1], phi))
    return vectors


@cache
def affine_curvature() -> sp.Expr:
    """k = [γ″, γ‴], the coefficient in γ‴ = −kγ′ (2.5)."""
    _, second, third = by_affine_arc_length(3)
    return bracket(second, third)


@cache
def affine_curvature_slope() -> sp.Expr:
    """dk/dr."""
    return derivative(affine_curvature()) / phi


@cache
def curvature(order: int = 0) -> sp.Expr:
    """κ = [T, dT/ds] or its derivative of that order by Euclidean arc length (2.6).

    >>> curvature().free_symbols == {v, x[1], x[2], y[1], y[2]}
    True
    """
    if order > 0:
        return derivative(curvature(order - 1)) / v
    tangent = (x[1] / v, y[1] / v)
    return bracket(tangent, along(tangent, v))


k = sp.symbols("k:6", real=True)
r, z = sp.symbols("r z", real=True)


def arc_in_frame(order: int) -> Vector:
    """The Taylor polynomials in r of a curve in its own affine frame (t₀, n₀), by t′ = n, n′ = −kt (2.7).

    k0, k1, … stand for k and its derivatives by r at r = 0.

    >>> arc_in_frame(4)
    (-k0*r**3/6 - k1*r**4/24 + r, -k0*r**4/24 + r**2/2)
    """
    along_t, along_n = sp.Integer(1), sp.Integer(0)  # γ⁽ⁱ⁾ = along_t·t + along_n·n
    first = second = sp.Integer(0)
    for i in range(1, order + 1):
        first, second = (
            total + c * r**i / sp.factorial(i) for total, c in ((first, along_t), (second, along_n))
        )
        along_t, along_n = _rate(along_t) - k[0] * along_n, along_t + _rate(along_n)
    return sp.expand(first), sp.expand(second)


def _rate(coefficient: sp.Expr) -> sp.Expr:
    return sp.expand(sum(sp.diff(coefficient, k[i]) * k[i + 1] for i in range(len(k) - 1)))


def canonical_form(order: int = 5) -> sp.Expr:
    """y as a polynomial of that degree in the other coordinate z along t₀ (Lemma 2.2.2), by series inversion.

    >>> canonical_form()
    k0*z**4/8 + k1*z**5/40 + z**2/2
    """
    first, second = arc_in_frame(order)
    inverse = z  # r as a series in z: Newton's step, one more term each time
    for _ in range(order - 1):
        inverse = _truncated(inverse - (first.subs(r, inverse) - z), order)
    return _truncated(second.subs(r, inverse), order)


def _truncated(series: sp.Expr, order: int) -> sp.Expr:
    polynomial = sp.Poly(sp.expand(series), z)
    return sp.Add(*(c * z**e for (e,), c in polynomial.terms() if e <= order))
