"""The pencil of quadratic forms of a pair of functions: the multiplicities of the roots of its determinant.

For f = (f₁, f₂) with df(0) = 0 the determinant of λ·Hess f₁ + μ·Hess f₂ is a binary form, up to a linear
change of (λ, μ) and a factor, whatever the coordinates and for contact equivalence too.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import exact
from osculant.cas.germs.germ import Germ

#: coefficients, the constant first, the last not 0
Coefficients = list[Any]


def root_multiplicities(germ: Germ) -> tuple[int, ...]:
    """The multiplicities of the roots, in order; none where the determinant is 0 or f has a linear part.

    >>> root_multiplicities(Germ("x**2 + y**3 + z**3, y*z", "x y z"))
    (1, 2)
    >>> root_multiplicities(Germ("x**2 + y*z, x*y + z**3", "x y z"))
    (3,)
    """
    n, jet = germ.n, germ.jet(2)
    if germ.p != 2 or any(poly.order_of(f, n) < 2 for f in jet):
        return ()
    first, second = (_hessian(f, n) for f in jet)
    values = [
        _determinant([[a + t * b for a, b in zip(row, other)] for row, other in zip(first, second)])
        for t in range(n + 1)
    ]
    form = _interpolated(values)
    if not form:
        return ()
    at_infinity = n + 1 - len(form)
    return tuple(sorted([*([at_infinity] if at_infinity else []), *multiplicities(form)]))


def multiplicities(form: Coefficients) -> list[int]:
    """The multiplicities of the roots of a polynomial, over a field that has all roots.

    >>> multiplicities([0, 0, Fraction(1), Fraction(1)])
    [1, 2]
    """
    counts, rest = [], form
    while len(rest) > 1:  # the degrees of gcd(f, f′), … tell how many roots have which multiplicity
        following = _gcd(rest, [k * c for k, c in enumerate(rest)][1:])
        counts.append(len(rest) - len(following))
        rest = following
    found: list[int] = []
    for multiplicity, count in enumerate(counts, start=1):
        beyond = counts[multiplicity] if multiplicity < len(counts) else 0
        found += [multiplicity] * (count - beyond)
    return found


def _hessian(f: poly.Polynomial, n: int) -> list[list[Any]]:
    return [
        [exact(f.get(poly.variable(i, n) + poly.variable(j, n), 0)) * (2 if i == j else 1) for j in range(n)]
        for i in range(n)
    ]


def _determinant(matrix: list[list[Any]]) -> Any:
    rows, total = [list(row) for row in matrix], Fraction(1)
    for i in range(len(rows)):
        at = next((k for k in range(i, len(rows)) if rows[k][i]), None)
        if at is None:
            return Fraction(0)
        if at != i:
            rows[i], rows[at], total = rows[at], rows[i], -total
        total = total * rows[i][i]
        for k in range(i + 1, len(rows)):
            if rows[k][i]:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    return total


def _interpolated(values: Sequence[Any]) -> Coefficients:
    """The polynomial with these values at 0, 1, 2, …, by Newton's differences."""
    differences, row = [], list(values)
    while row:
        differences.append(row[0])
        row = [b - a for a, b in pairwise(row)]
    found: Coefficients = []
    for k in reversed(range(len(differences))):  # Horner: f = d₀ + t(d₁ + (t − 1)/2·(d₂ + …))
        shifted = [Fraction(0), *found]
        for i, c in enumerate(found):
            shifted[i] = shifted[i] - k * c
        found = [c / (k + 1) for c in shifted] or [Fraction(0)]
        found[0] = found[0] + differences[k]
    return _trimmed(found)


def _trimmed(f: Coefficients) -> Coefficients:
    found = list(f)
    while found and not found[-1]:
        found.pop()
    return found


def _gcd(a: Coefficients, b: Coefficients) -> Coefficients:
    a, b = _trimmed(a), _trimmed(b)
    while b:
        while len(a) >= len(b):
            factor, shift = a[-1] / b[-1], len(a) - len(b)
            a = _trimmed([*a[:shift], *(c - factor * d for c, d in zip(a[shift:], b))])
        a, b = b, a
    return a
