"""Section 6.2: secant maps at the diagonal are even, and tell the projection along the direction."""

from __future__ import annotations

from itertools import product
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.secants import chord, projected

x, y, lam, v = sp.symbols("x y lambda v")
#: a component of an immersion of a surface, any function
g = sp.Function("g")
#: the degree up to which the chords of the engine are compared with the definition
DEGREE = 6


def _secant() -> Any:
    """(g(q) − g(p))/λ for p = (p̄ − λω)/2, q = (p̄ + λω)/2, ω = (1, v)."""
    ahead, behind = ((s * lam + x) / 2 for s in (1, -1)), ((s * lam * v + y) / 2 for s in (1, -1))
    (q, p), (b, a) = ahead, behind
    return (g(q, b) - g(p, a)) / lam


def _monomial(i: int, j: int) -> tuple[Any, Any]:
    """The chord of x^i y^j by the definition, and that of the engine, as expressions."""
    defined = _secant().replace(g, lambda a, b: a**i * b**j)
    symbols = (x, y, lam, v)
    made = sum(
        sp.Rational(c.numerator, c.denominator)
        * sp.prod(s**e for s, e in zip(symbols, poly.exponents_of(m, 4)))
        for m, c in chord({poly.monomial((i, j)): 1}, 2).items()
    )
    return sp.expand(sp.cancel(defined)), sp.expand(made)


@claim(
    "lemma 6.2.1",
    "The germ of the secant map at the diagonal is even in λ: so it is f(x̄, ȳ, λ², v).",
    method=Method.PROOF,
    form="even",
    wrong=("odd",),
)
def evenness(form: str) -> Evidence:
    """For any function g: λ → −λ exchanges p and q, and the divisor changes its sign.

    The chords that the engine makes of monomials are those of the definition.
    """
    if form not in {"even", "odd"}:
        raise DomainError(f"{form!r} is no parity: even or odd.")
    h = _secant()
    sign = 1 if form == "even" else -1
    evidence = vanishes(h.subs(lam, -lam) - sign * h, "S(−λ) against S(λ)")
    powers = [(i, j) for i, j in product(range(DEGREE + 1), repeat=2) if i + j <= DEGREE]
    right = all(a == b for a, b in (_monomial(i, j) for i, j in powers))
    return evidence & Evidence(right, (f"the engine's chords of {len(powers)} monomials are those defined",))


@claim(
    "remark 6.2.3",
    "The projection along the x-axis is π = factor·S with x̄ = x, ȳ = y, λ = x, v = y/x, for factor = x.",
    method=Method.PROOF,
    form="x",
    wrong=("2*x", "x**2", "y", "x + 1/1000"),
)
def projection_from_secants(form: str) -> Evidence:
    """For any function g: then q = (x, y) and p = 0, and g(q) − g(p) is the projection, as g(0) = 0.

    The engine's substitution takes the chord of a monomial of 1, 2 or 3 variables to that monomial.
    """
    factor = read(form, {"x": x, "y": y})
    values = {x: x, y: y, lam: x, v: y / x}
    h = _secant().subs(values, simultaneous=True).replace(g, lambda a, b: g(sp.cancel(a), sp.cancel(b)))
    evidence = vanishes(factor * h - (g(x, y) - g(0, 0)), "factor·S against g")
    monomials = [(n, m) for n in (1, 2, 3) for m in poly.monomials(n, DEGREE) if m]
    right = all(projected(chord({m: 1}, n), n) == {m: 1} for n, m in monomials)
    return evidence & Evidence(right, (f"the engine's substitution for {len(monomials)} monomials",))
