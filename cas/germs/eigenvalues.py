"""Characteristic polynomials of small matrices, over ℚ or a number field, and factors of them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from flint import fmpq_mat, fmpq_poly

from osculant.cas.germs.algebraic import Algebraic, exact, rational
from osculant.cas.germs.linear import Rows, product

#: coefficients of a polynomial, from the constant on
Coefficients = list[Any]


def factors(matrix: Rows) -> list[tuple[Coefficients, int]]:
    """(polynomial, multiplicity): pairwise prime factors of the characteristic polynomial.

    Over ℚ they are irreducible; over a number field the factors over ℚ are told, and what is left is one.

    >>> factors([[Fraction(2), Fraction(0)], [Fraction(0), Fraction(3)]])
    [([Fraction(-3, 1), Fraction(1, 1)], 1), ([Fraction(-2, 1), Fraction(1, 1)], 1)]
    """
    if not any(isinstance(v, Algebraic) for row in matrix for v in row):
        size = len(matrix)
        known = fmpq_mat(size, size, [rational(Fraction(v)) for row in matrix for v in row]).charpoly()
        return [([Fraction(int(c.p), int(c.q)) for c in f.coeffs()], e) for f, e in known.factor()[1]]
    whole = _characteristic(matrix)
    found, rest = [], whole
    for factor in _over_rationals(whole):
        count = 0
        while (quotient := _divided(rest, factor)) is not None:
            rest, count = quotient, count + 1
        found.append((factor, count))
    if len(rest) > 1:
        found.append((rest, 1))
    return found


def rational_root(factor: Coefficients) -> Fraction | None:
    """The zero of a linear factor over ℚ; None for others."""
    if len(factor) != 2 or any(isinstance(c, Algebraic) for c in factor):
        return None
    return Fraction(-factor[0]) / Fraction(factor[1])


def at_matrix(polynomial: Sequence[Any], matrix: Rows) -> list[list[Any]]:
    """The value of a polynomial at a square matrix."""
    size = len(matrix)
    value: list[list[Any]] = [[Fraction(0)] * size for _ in range(size)]
    for c in reversed(polynomial):
        value = product(value, matrix)
        for i in range(size):
            value[i][i] = exact(value[i][i] + c)
    return value


def _characteristic(matrix: Rows) -> Coefficients:
    """By the method of Faddeev and Le Verrier."""
    size = len(matrix)
    found: Coefficients = [Fraction(1)]
    value: list[list[Any]] = [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]
    for k in range(1, size + 1):
        value = product(matrix, value)
        c = exact(sum((value[i][i] for i in range(size)), Fraction(0)) * Fraction(-1, k))
        found.insert(0, c)
        for i in range(size):
            value[i][i] = exact(value[i][i] + c)
    return found


def _over_rationals(whole: Coefficients) -> list[Coefficients]:
    """The irreducible polynomials over ℚ that divide one over a number field."""
    degree = next((c.field.degree for c in whole if isinstance(c, Algebraic)), 1)
    common = fmpq_poly([0])
    for i in range(degree):  # those that divide the coefficients of every power of α
        part = [c.coefficients()[i] if isinstance(c, Algebraic) else Fraction(c) * int(i == 0) for c in whole]
        common = common.gcd(fmpq_poly([rational(v) for v in part]))
    return [[Fraction(int(c.p), int(c.q)) for c in f.coeffs()] for f, _ in common.factor()[1]]


def _divided(a: Coefficients, b: Coefficients) -> Coefficients | None:
    """a/b; None if it leaves a rest."""
    rest, quotient = list(a), list[Any]()
    while len(rest) >= len(b):
        factor = exact(rest[-1] / b[-1])
        quotient.insert(0, factor)
        shift = len(rest) - len(b)
        rest = [exact(v - factor * b[i - shift]) if i >= shift else v for i, v in enumerate(rest)][:-1]
    return None if any(rest) or not quotient else quotient
