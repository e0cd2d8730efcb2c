"""The Smith normal form of an integer matrix with both transformations, and linear equations modulo 2."""

from __future__ import annotations

from collections.abc import Sequence

Matrix = list[list[int]]


def smith(matrix: Sequence[Sequence[int]]) -> tuple[Matrix, list[int], Matrix]:
    """(U, the diagonal, V) with U·A·V diagonal, U and V of determinant ±1.

    The entries of the diagonal are positive, as many as the rank is, and each divides the next.

    >>> smith([[2, 0], [0, 3]])[1]
    [1, 6]
    """
    a = [list(row) for row in matrix]
    m, n = len(a), len(a[0]) if a else 0
    u = [[int(i == j) for j in range(m)] for i in range(m)]
    v = [[int(i == j) for j in range(n)] for i in range(n)]
    found: list[int] = []
    for t in range(min(m, n)):
        while (at := _least(a, t)) is not None:
            _brought(a, u, v, at, t)
            if not _cleared(a, u, v, t):
                continue
            bad = next((i for i in range(t + 1, m) if any(e % a[t][t] for e in a[i][t + 1 :])), None)
            if bad is None:
                break
            _add_row(a, u, t, bad, 1)
        else:
            break
        if a[t][t] < 0:
            a[t], u[t] = [-e for e in a[t]], [-e for e in u[t]]
        found.append(a[t][t])
    return u, found, v


def _least(a: Matrix, t: int) -> tuple[int, int] | None:
    """The place of the smallest entry that is not 0, from the t-th row and column on."""
    places = [(abs(a[i][j]), i, j) for i in range(t, len(a)) for j in range(t, len(a[i])) if a[i][j]]
    return min(places)[1:] if places else None


def _brought(a: Matrix, u: Matrix, v: Matrix, at: tuple[int, int], t: int) -> None:
    i, j = at
    for rows in (a, u):
        rows[t], rows[i] = rows[i], rows[t]
    for row in (*a, *v):
        row[t], row[j] = row[j], row[t]


def _add_row(a: Matrix, u: Matrix, to: int, of: int, factor: int) -> None:
    for rows in (a, u):
        rows[to] = [x + factor * y for x, y in zip(rows[to], rows[of])]


def _cleared(a: Matrix, u: Matrix, v: Matrix, t: int) -> bool:
    """Clears the row and the column of the t-th pivot as far as it divides; whether all of it is 0 then."""
    pivot = a[t][t]
    for i in range(t + 1, len(a)):
        if q := a[i][t] // pivot:
            _add_row(a, u, i, t, -q)
    for j in range(t + 1, len(a[t])):
        if q := a[t][j] // pivot:
            for row in (*a, *v):
                row[j] -= q * row[t]
    return not any(a[i][t] for i in range(t + 1, len(a))) and not any(a[t][t + 1 :])


def solutions_mod_2(rows: Sequence[Sequence[int]], right: Sequence[int], size: int) -> list[list[int]] | None:
    """A solution of rows·x ≡ right mod 2, and after it a basis of those of rows·x ≡ 0; None if there is none.

    >>> solutions_mod_2([[1, 1]], [1], 2)
    [[1, 0], [1, 1]]
    """
    pivots: list[tuple[int, list[int]]] = []
    for row, b in zip(rows, right):
        rest = [e % 2 for e in (*row, b)]
        for lead, other in pivots:
            if rest[lead]:
                rest = [x ^ y for x, y in zip(rest, other)]
        lead = next((j for j in range(size) if rest[j]), -1)
        if lead < 0:
            if rest[size]:
                return None
            continue
        pivots = [(k, [x ^ y for x, y in zip(other, rest)] if other[lead] else other) for k, other in pivots]
        pivots.append((lead, rest))
    leading = dict(pivots)
    found = [[leading[j][size] if j in leading else 0 for j in range(size)]]
    free = [j for j in range(size) if j not in leading]
    found += [[leading[j][i] if j in leading else int(j == i) for j in range(size)] for i in free]
    return found
