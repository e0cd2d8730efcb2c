"""Germs of secant maps of surfaces at the diagonal, and the projections along a tangent (thesis 6.2)."""

from __future__ import annotations

from typing import Any

from sympy import QQ, ring

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import LARGEST, Polynomial

RING, X, Y, LAMBDA, V = ring("x,y,lambda,v", QQ)


def secant_germ(graph: str) -> Germ:
    """The germ f(x, y, u, v) with f(x̄, ȳ, λ², v) the secant map of a surface at 0 in the direction (1, 0).

    The surface is the graph of g = (g₃, …, gₙ), polynomials without constant and linear terms. The secant
    through p = (p̄ − λω)/2 and q = (p̄ + λω)/2, ω = (1, v), has the direction (1, v, …, (gᵢ(q) − gᵢ(p))/λ, …).

    Raises DomainError for functions that are no polynomials or have terms of degree 1.

    >>> secant_germ("x**3").text(3)
    ('v', 'u/4 + 3*x**2/4')
    """
    surface = Germ(graph, "x y")
    jet = surface.polynomial(LARGEST)
    if jet is None or any(f and poly.order_of(f, 2) < 2 for f in jet):
        raise DomainError(
            f"({graph}) are not polynomials without constant and linear terms: take Monge form."
        )
    components = ["v"]
    for f in jet:
        difference = chord(f)
        components.append(" + ".join(_term(e, c) for e, c in difference.terms()) if difference else "0")
    return Germ(", ".join(components), "x y u v")


def chord(g: Polynomial) -> Any:
    """(g(q) − g(p))/λ as a polynomial in x̄, ȳ, λ, v; every polynomial g in two variables will do.

    >>> chord({poly.monomial((1, 1)): 1})
    1/2*x*v + 1/2*y
    """
    total = RING.zero
    for m, c in g.items():
        i, j = poly.exponents_of(m, 2)
        ahead, behind = (X + LAMBDA) ** i * (Y + LAMBDA * V) ** j, (X - LAMBDA) ** i * (Y - LAMBDA * V) ** j
        total += (ahead - behind) * (QQ(c.numerator, c.denominator) / 2 ** (i + j))
    return total.quo(LAMBDA) if total else total


def _term(exponents: tuple[int, ...], c: Any) -> str:
    i, j, k, m = exponents
    assert k % 2 == 0  # lemma 6.2.1
    return f"({c})*x**{i}*y**{j}*u**{k // 2}*v**{m}"
