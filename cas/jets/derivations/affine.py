"""Affine and Euclidean invariants of plane curves, derived from their definitions (thesis 2.2).

Nothing here is a formula for an invariant: each follows from reparametrisation by arc length. The forms of
`osculant.cas.jets.plane`, which are what the programs run, are held against these by the tests.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from osculant.cas.jets.derivations.plane import Vector, along, bracket, derivative, phi, v, x, y


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
