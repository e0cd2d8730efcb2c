"""Quadratic forms over ℚ, diagonalised."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import fmpq


def diagonalised(matrix: Sequence[Sequence[Any]]) -> tuple[list[list[Any]], list[Any]]:
    """(S, d) with Sᵗ·A·S diagonal, d its entries; S is invertible, A symmetric, numbers are flint's.

    >>> change, values = diagonalised([[fmpq(0), fmpq(1)], [fmpq(1), fmpq(0)]])
    >>> [[str(v) for v in row] for row in change], [str(v) for v in values]
    ([['1', '-1/2'], ['1', '1/2']], ['2', '-1/2'])
    """
    n = len(matrix)
    a = [list(row) for row in matrix]
    s = [[fmpq(int(i == j)) for j in range(n)] for i in range(n)]

    def add(to: int, of: int, factor: Any) -> None:
        """Adds a multiple of a new coordinate vector to another."""
        for row in (*s, *a):
            row[to] += factor * row[of]
        a[to] = [x + factor * y for x, y in zip(a[to], a[of])]

    for t in range(n):
        if a[t][t] == 0:
            later = next((j for j in range(t + 1, n) if a[j][j] != 0), None)
            mixed = next((j for j in range(t + 1, n) if a[t][j] != 0), None)
            if later is not None:
                add(t, later, fmpq(1))
                if a[t][t] == 0:  # a_tt = 0 and 2·a_tj + a_jj = 0
                    add(t, later, fmpq(1))
            elif mixed is not None:
                add(t, mixed, fmpq(1))
            else:
                continue
        if a[t][t] != 0:
            for j in range(t + 1, n):
                if a[t][j] != 0:
                    add(j, t, -a[t][j] / a[t][t])
    return s, [a[i][i] for i in range(n)]
