"""Beyond section 1.3.3: the error of the best cubic does not grow with the arc, unlike that of conics."""

from __future__ import annotations

from functools import cache
from itertools import combinations, pairwise
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integer, read, read_tuple, vanishes

X, C0, C1 = sp.symbols("x c0 c1", real=True)
#: ends of two arcs from −1, exchanges of Remez, digits of the coefficients
SHORT, LONG, EXCHANGES, DIGITS = sp.Rational(4, 5), sp.Integer(1), 8, 20


@claim(
    "X1.3-11",
    "To first order a cubic near (t, η(t² + t³/2)) differs from it in height by any polynomial of degree ≤ "
    "5: so a cubic tangent to y = η(x² + x³/2 + δx⁷) at −1 and b misses it by ηδ(x+1)²(x−b)²(x³ + (2b−2)x² "
    "+ c₁x + c₀).",
    method=Method.PROOF,
    form="2*b - 2",
    wrong=("2 - 2*b", "2*b + 2", "b - 1", "0"),
)
def cubic_variations(form: str) -> Evidence:
    """Heights of variations (ξ, ζ), cubic polynomials of t, are ζ − η(2t + 3t²/2)ξ: their space is computed.

    x⁷ less a polynomial of degree ≤ 5 with double zeros at both ends is the square of (x+1)(x−b) times a
    cubic without x⁶ in the product: that is the form, the coefficient of x² in the cubic.
    """
    t, b = sp.symbols("t b")
    monomials = [t**i for i in range(4)]
    heights = [*monomials, *[sp.expand((2 * t + sp.Rational(3, 2) * t**2) * m) for m in monomials]]
    matrix = sp.Matrix([[sp.Poly(h, t).coeff_monomial(t**i) for i in range(7)] for h in heights])
    space = Evidence(
        matrix.rank() == 6 and all(row[6] == 0 for row in matrix.tolist()),
        (f"heights of variations: a space of dimension {matrix.rank()} of polynomials of degree ≤ 5",),
    )
    square = read(form, {"b": b})
    product = sp.Poly(sp.expand((X + 1) ** 2 * (X - b) ** 2 * (X**3 + square * X**2 + C1 * X + C0)), X)
    return space & vanishes(product.coeff_monomial(X**6), "the coefficient of x⁶")


@claim(
    "X1.3-12",
    "The least error of tangent cubics is not monotone in the arc: to first order in η, δ it is at least "
    "0.0489 ηδ on [−1, 0.8] and at most 0.0436 ηδ on [−1, 1]. So greedy splines of cubics need not be "
    "minimal.",
    method=Method.EXACT,
    form="0.0489, 0.0436",
    wrong=("0.0490, 0.0436", "0.0489, 0.0435", "0.0436, 0.0489", "0, 0.0436"),
)
def cubic_errors(form: str) -> Evidence:
    """The form bounds min over c₀, c₁ of max |(x+1)²(x−b)²(x³ + (2b−2)x² + c₁x + c₀)| for both arcs.

    Below: for one choice the function has alternating signs at three points and exceeds the bound there;
    another choice that were smaller at all three would differ by a linear function with two changes of sign.
    Above: for one choice no point exceeds the bound, by counts of real roots. Rational numbers throughout;
    the bounds must be the best ones with four digits.
    """
    below, above = read_tuple(form, {}, 2)
    lower, places = _alternation(SHORT)
    upper = _error(LONG, _coefficients(LONG)[0], above)
    step = sp.Rational(1, 10**4)
    tight = _error(LONG, _coefficients(LONG)[0], above - step)
    line = (
        f"on [−1, {SHORT}] ≥ {sp.N(lower, 8)} at x = {', '.join(str(sp.N(p, 5)) for p in places)}; "
        f"on [−1, {LONG}] {'≤' if upper else '>'} {above}"
    )
    best = bool(below <= lower < below + step) and upper and not tight
    return Evidence(best and integer(sp.Integer(len(places))) == 3, (line,))


def _function(b: Any, c: tuple[Any, Any]) -> Any:
    return sp.Poly((X + 1) ** 2 * (X - b) ** 2 * (X**3 + (2 * b - 2) * X**2 + c[1] * X + c[0]), X)


@cache
def _coefficients(b: Any) -> tuple[tuple[Any, Any], tuple[Any, ...]]:
    """Rational c₀, c₁ near the best ones, and three points where the function is largest, alternately."""
    places = tuple(-1 + (b + 1) * sp.Rational(n, 6) for n in (1, 3, 5))
    c: tuple[Any, Any] = (sp.S.Zero, sp.S.Zero)
    for _ in range(EXCHANGES):
        level = sp.Symbol("level")
        general = _function(b, (C0, C1)).as_expr()
        conditions = [general.subs(X, p) - (-1) ** i * level for i, p in enumerate(places)]
        solved = sp.solve(conditions, [C0, C1, level])
        c = tuple(sp.Rational(str(sp.N(solved[s], DIGITS))) for s in (C0, C1))
        slope = sp.Poly(sp.diff(_function(b, c).as_expr(), X), X)
        inner = [
            sp.Rational(str(sp.N(z, DIGITS))) for z in slope.nroots(n=DIGITS) if z.is_real and -1 < z < b
        ]
        sizes = {z: _function(b, c).eval(z) for z in inner}
        triples = [p for p in combinations(sorted(inner), 3) if _alternates([sizes[z] for z in p])]
        ranked = [(max(map(abs, v)), min(map(abs, v)), p) for p in triples for v in [[sizes[z] for z in p]]]
        places = max(ranked)[2]
    return c, places


def _alternation(b: Any) -> tuple[Any, tuple[Any, ...]]:
    """The least size of the function at three points where its signs alternate: 0 if they do not."""
    c, places = _coefficients(b)
    values = [_function(b, c).eval(p) for p in places]
    return (min(abs(v) for v in values) if _alternates(values) else sp.S.Zero), places


def _alternates(values: list[Any]) -> bool:
    return all(one * two < 0 for one, two in pairwise(values))


def _error(b: Any, c: tuple[Any, Any], bound: Any) -> bool:
    """Whether the function stays within a bound: no real root of bound ± it between −1 and b."""
    function = _function(b, c)
    sides = [sp.Poly(sp.Rational(str(bound)) + sign * function.as_expr(), X) for sign in (1, -1)]
    return all(side.eval(0) > 0 and side.count_roots(-1, b) == 0 for side in sides)
