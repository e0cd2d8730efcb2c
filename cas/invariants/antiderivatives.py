"""Antiderivatives that are cheap and certain: no search, so nothing hangs; all else stays an integral."""

from __future__ import annotations

import sympy

#: operations of an integrand beyond which it is left alone
OPERATIONS = 80

_TABLE = {
    sympy.sin: lambda u: -sympy.cos(u),
    sympy.cos: sympy.sin,
    sympy.sinh: sympy.cosh,
    sympy.cosh: sympy.sinh,
    sympy.exp: sympy.exp,
}


def antiderivative(f: sympy.Expr, t: sympy.Symbol) -> sympy.Expr | None:
    """An antiderivative by t of a sum of simple terms; None for anything else.

    Simple are polynomials, trigonometric polynomials, exp, sinh and cosh of linear arguments, and √q, 1/√q
    and 1/q for a positive quadratic polynomial q.
    The antiderivative is valid on the whole line.

    >>> t = sympy.Symbol("t", real=True)
    >>> antiderivative(4 * sympy.cos(t / 3) ** 2, t), antiderivative(sympy.sqrt(1 + t**2), t)
    (2*t + 3*sin(2*t/3), t*sqrt(t**2 + 1)/2 + asinh(t)/2)
    >>> antiderivative(sympy.sqrt(1 + t**4), t) is None
    True
    """
    from sympy.simplify.fu import TR8  # products of sines and cosines → sums

    if f.count_ops() > OPERATIONS:
        return None
    if f.has(sympy.sin, sympy.cos):
        f = TR8(sympy.expand(f))
    parts = [_term(term, t) for term in sympy.Add.make_args(sympy.expand(f))]
    return None if None in parts else sympy.Add(*parts)


def _term(term: sympy.Expr, t: sympy.Symbol) -> sympy.Expr | None:
    factor, rest = term.as_independent(t, as_Add=False)
    if rest.is_polynomial(t):
        return factor * sympy.integrate(rest, t)
    if rest.func in _TABLE and rest.args[0].is_polynomial(t) and sympy.degree(rest.args[0], t) == 1:
        return factor * _TABLE[rest.func](rest.args[0]) / sympy.diff(rest.args[0], t)
    if rest.is_Pow and rest.base.is_polynomial(t):
        part = _power_of_quadratic(sympy.Poly(rest.base, t), rest.exp)
        return None if part is None else factor * part
    return None


def _power_of_quadratic(q: sympy.Poly, exponent: sympy.Expr) -> sympy.Expr | None:
    """∫qᵉ dt for q = at² + bt + c that is positive everywhere and e one of 1/2, −1/2, −1."""
    if q.degree() != 2:
        return None
    (t,), (a, b, c) = q.gens, q.all_coeffs()
    gap = sympy.expand(4 * a * c - b**2)
    if not (a.is_positive and gap.is_positive):
        return None
    slope, width = 2 * a * t + b, sympy.sqrt(gap)
    if exponent == -1:
        return 2 * sympy.atan(slope / width) / width
    logarithm = sympy.asinh(slope / width) / sympy.sqrt(a)
    if exponent == sympy.Rational(-1, 2):
        return logarithm
    if exponent == sympy.Rational(1, 2):
        return (slope * sympy.sqrt(q.as_expr()) + gap * logarithm / 2) / (4 * a)
    return None
