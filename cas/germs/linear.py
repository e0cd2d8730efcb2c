"""Exact null spaces of small rational matrices."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mat


def null_space(conditions: Sequence[Sequence[Fraction]], size: int) -> list[list[Fraction]]:
    """A basis of the vectors of that size on which all conditions vanish.

    >>> null_space([[Fraction(1), Fraction(-1)]], 2)
    [[Fraction(1, 1), Fraction(1, 1)]]
    """
    if not conditions:
        return [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]
    flat = [fmpq(v.numerator, v.denominator) for row in conditions for v in row]
    form, rank = fmpq_mat(len(conditions), size, flat).rref()
    leading = [next(j for j in range(size) if form[i, j] != 0) for i in range(rank)]
    basis = []
    for j in (j for j in range(size) if j not in leading):
        vector = [Fraction(0)] * size
        vector[j] = Fraction(1)
        for i, lead in enumerate(leading):
            vector[lead] = -Fraction(int(form[i, j].p), int(form[i, j].q))
        basis.append(vector)
    return basis
