"""Elimination modulo a prime of rows that are sparse or dense.

Rows with different leading columns are pivots that cost nothing; what is left becomes a dense matrix on the
columns that are no pivots. Blocks of rows and columns that have nothing to do with each other, such as the
weights of a quasi-homogeneous germ, are eliminated one by one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from osculant.cas.germs.modular_span import Array, Span

#: entries are whole numbers, or numbers of a number field
Row = Mapping[int, Any]
#: rows, and the columns in which they have entries
Block = tuple[list[Row], list[int]]
#: rows of a dense matrix that are taken in before it is asked whether the others add anything
PART = 128


def modular_annihilator(rows: Sequence[Row], columns: int, prime: int) -> tuple[tuple[int, ...], Array]:
    """(free columns, values): a basis of the annihilator modulo a prime, one functional a column of values.

    >>> free, values = modular_annihilator([{0: 1, 1: 1}], 2, 7)
    >>> free, values.tolist()
    ((1,), [[6], [1]])
    """
    free, values, _ = eliminated(list(blocks(rows, columns)), columns, prime)
    return free, values


def eliminated(
    divided: Sequence[Block], columns: int, prime: int
) -> tuple[tuple[int, ...], Array, list[Block]]:
    """(free columns, values, blocks with rows that suffice) of rows in blocks, modulo a prime.

    >>> eliminated(list(blocks([{0: 1, 1: 1}, {0: 2, 1: 2}], 2)), 2, 7)[2]
    [([{0: 1, 1: 1}], [0, 1])]
    """
    pieces = [_block(rows, where, prime) for rows, where in divided]
    free = sorted(c for found, *_ in pieces for c in found)
    place = {c: j for j, c in enumerate(free)}
    values = np.zeros((columns, len(free)), dtype=np.int64)
    for (found, part, _), (_, where) in zip(pieces, divided):
        if found:
            values[np.ix_(where, [place[c] for c in found])] = part
    return tuple(free), values, [(used, where) for (*_, used), (_, where) in zip(pieces, divided)]


def blocks(rows: Sequence[Row], columns: int) -> Iterator[Block]:
    """(rows, columns) of the finest division in which no row has entries in two parts.

    >>> [where for _, where in blocks([{0: 1, 2: 1}, {1: 5}], 3)]
    [[0, 2], [1]]
    """
    parent = list(range(columns))

    def root(c: int) -> int:
        while parent[c] != c:
            parent[c] = parent[parent[c]]
            c = parent[c]
        return c

    for row in rows:
        first, *others = map(root, row)
        for other in others:
            parent[other] = first if (other := root(other)) != first else other
    gathered: dict[int, tuple[list[Row], list[int]]] = {}
    for c in range(columns):
        gathered.setdefault(root(c), ([], []))[1].append(c)
    for row in rows:
        gathered[root(next(iter(row)))][0].append(row)
    yield from gathered.values()


def _block(rows: list[Row], where: Sequence[int], prime: int) -> tuple[list[int], Array, list[Row]]:
    """(free columns, values on all columns, rows that suffice) of one block."""
    columns, place = len(where), {c: i for i, c in enumerate(where)}
    if columns == 1:
        seen = [row for row in rows if any(v % prime for v in row.values())][:1]
        return ([] if seen else list(where)), np.ones((1, 1 - len(seen)), dtype=np.int64), seen
    residues = [{place[c]: r for c, v in row.items() if (r := v % prime)} for row in rows]
    chosen, rest = _structural_pivots(residues)
    pivots = {first: _divided(residues[i], first, prime) for first, i in chosen.items()}
    dense_columns = np.array([c for c in range(columns) if c not in pivots], dtype=np.int64)
    reduced = _reduced([residues[i] for i in rest], pivots, columns, prime)[:, dense_columns]
    span = Span(len(dense_columns), prime)
    span.add_all([reduced[i : i + PART] for i in range(0, len(reduced), PART)])
    free, part = span.annihilator()
    values = np.zeros((columns, len(free)), dtype=np.int64)
    values[dense_columns] = part
    for column in sorted(pivots, reverse=True):  # a pivot row's other columns come later: they are known
        indices, entries = pivots[column]
        if len(indices) and len(free):
            values[column] = (-((entries[:, None] * values[indices]) % prime).sum(axis=0)) % prime
    used = [rows[i] for i in sorted([*chosen.values(), *(rest[j] for j in span.used)])]
    return [where[int(c)] for c in dense_columns[free]], values, used


def _structural_pivots(rows: Sequence[dict[int, int]]) -> tuple[dict[int, int], list[int]]:
    """For each first column the number of the shortest row; and the numbers of the other rows."""
    best: dict[int, int] = {}
    for i, row in enumerate(rows):
        if row:
            first = min(row)
            rival = best.get(first)
            if rival is None or len(row) < len(rows[rival]):
                best[first] = i
    taken = set(best.values())
    return best, [i for i, row in enumerate(rows) if row and i not in taken]


def _divided(row: dict[int, int], first: int, prime: int) -> tuple[Array, Array]:
    """(other columns, entries divided by the first one)."""
    inverse = pow(row[first], -1, prime)
    others = [(c, v * inverse % prime) for c, v in row.items() if c != first]
    return (
        np.array([c for c, _ in others], dtype=np.int64),
        np.array([v for _, v in others], dtype=np.int64),
    )


def _reduced(
    rest: Sequence[Row], pivots: Mapping[int, tuple[np.ndarray, np.ndarray]], columns: int, prime: int
) -> np.ndarray:
    """The rows left over, with the pivot columns eliminated, as a dense matrix."""
    block = np.zeros((columns, len(rest)), dtype=np.int64)  # transposed: a column of the matrix is contiguous
    for j, row in enumerate(rest):
        block[list(row), j] = list(row.values())
    for column in sorted(pivots):
        factor = block[column]
        indices, entries = pivots[column]
        if len(indices) and factor.any():
            hit = np.flatnonzero(factor)
            grid = np.ix_(indices, hit)
            block[grid] = (block[grid] - entries[:, None] * factor[hit]) % prime
    block[list(pivots)] = 0
    return block.T
