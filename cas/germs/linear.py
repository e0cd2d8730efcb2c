"""Exact linear algebra with small matrices, over ℚ or a number field."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from flint import fmpq_mat

from osculant.cas.germs.algebraic import Algebraic, exact, rational

#: rows of numbers: Fractions, or numbers of one number field
Rows = Sequence[Sequence[Any]]


def echelon(rows: Rows, size: int) -> tuple[list[list[Any]], list[int]]:
    """(the rows of the reduced echelon form that are not 0, their leading columns) of rows of that length.

    >>> echelon([[Fraction(2), Fraction(4)], [Fraction(1), Fraction(2)]], 2)
    ([[Fraction(1, 1), Fraction(2, 1)]], [0])
    """
    if not rows or not size:
        return [], []
    if any(isinstance(v, Algebraic) for row in rows for v in row):
        return _eliminated(rows)
    flat = [rational(v) for row in rows for v in row]
    form, rank = fmpq_mat(len(rows), size, flat).rref()
    found = [[Fraction(int(form[i, j].p), int(form[i, j].q)) for j in range(size)] for i in range(rank)]
    return found, [next(j for j, v in enumerate(row) if v) for row in found]


def _eliminated(rows: Rows) -> tuple[list[list[Any]], list[int]]:
    rest, found, leading = [[exact(v) for v in row] for row in rows], list[list[Any]](), list[int]()
    for j in range(len(rows[0])):
        at = next((i for i, row in enumerate(rest) if row[j]), None)
        if at is None:
            continue
        pivot = rest.pop(at)
        inverse = 1 / pivot[j]
        pivot = [exact(v * inverse) if v else v for v in pivot]
        for row in (*rest, *found):
            if factor := row[j]:
                row[:] = [exact(a - factor * b) if b else a for a, b in zip(row, pivot)]
        found.append(pivot)
        leading.append(j)
    return found, leading


def rank(rows: Rows, size: int) -> int:
    """The rank of rows of that length."""
    return len(echelon(rows, size)[1])


def null_space(conditions: Rows, size: int) -> list[list[Any]]:
    """A basis of the vectors of that size on which all conditions vanish.

    >>> null_space([[Fraction(1), Fraction(-1)]], 2)
    [[Fraction(1, 1), Fraction(1, 1)]]
    """
    form, leading = echelon(conditions, size)
    basis = []
    for j in (j for j in range(size) if j not in leading):
        vector: list[Any] = [Fraction(0)] * size
        vector[j] = Fraction(1)
        for row, lead in zip(form, leading):
            vector[lead] = -row[j]
        basis.append(vector)
    return basis


def solution(rows: Rows, right: Sequence[Any], size: int) -> list[Any] | None:
    """A solution of rows·x = right, 0 on the free coordinates; None if there is none.

    >>> solution([[Fraction(2), Fraction(0)]], [Fraction(1)], 2)
    [Fraction(1, 2), Fraction(0, 1)]
    """
    form, leading = echelon([[*row, b] for row, b in zip(rows, right)], size + 1)
    if leading and leading[-1] == size:
        return None
    found: list[Any] = [Fraction(0)] * size
    for row, lead in zip(form, leading):
        found[lead] = row[size]
    return found


def inverse(rows: Rows) -> list[list[Any]]:
    """The inverse of an invertible matrix.

    >>> inverse([[Fraction(2)]])
    [[Fraction(1, 2)]]
    """
    size = len(rows)
    both = [[*row, *(Fraction(int(i == j)) for j in range(size))] for i, row in enumerate(rows)]
    return [row[size:] for row in echelon(both, 2 * size)[0]]


def product(a: Rows, b: Rows) -> list[list[Any]]:
    """The product of two matrices."""
    columns = list(zip(*b))
    return [
        [exact(sum((x * y for x, y in zip(row, c) if x and y), Fraction(0))) for c in columns] for row in a
    ]
