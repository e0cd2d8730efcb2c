"""The span of rows modulo a prime, in reduced echelon form, batch by batch.

Products of matrices are those of matrices of floats, exact: one factor is split into parts of few bits.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.int64]]

#: rows that are reduced together, and random combinations that tell that the rest adds nothing
BATCH, SAMPLES = 64, 4


def product(a: Array, b: Array, prime: int) -> Array:
    """The product of two matrices of residues modulo a prime of at most 31 bits.

    >>> product(np.array([[3]]), np.array([[5, 4]]), 7).tolist()
    [[1, 5]]
    """
    size = prime.bit_length()
    bits = 52 - size - len(b).bit_length()  # sums of products of a part and a residue are exact
    right = b.astype(np.float64)
    found = np.zeros((len(a), b.shape[1]))
    for shift in reversed(range(0, size, bits)):
        part = (a >> shift & (1 << bits) - 1).astype(np.float64)
        found = (found * float(1 << bits) + part @ right) % prime
    return found.astype(np.int64)


class Span:
    """A reduced echelon form that grows.

    >>> span = Span(3, 7)
    >>> span.add(np.array([[1, 2, 0], [2, 4, 0]]))
    >>> span.pivots, span.rows.tolist()
    ([0], [[1, 2, 0]])
    >>> free, values = span.annihilator()
    >>> free.tolist(), values.tolist()
    ([1, 2], [[5, 0], [1, 0], [0, 1]])
    """

    def __init__(self, columns: int, prime: int) -> None:
        self.columns, self.prime = columns, prime
        self.pivots: list[int] = []
        #: the numbers of the rows taken in that added something
        self.used: list[int] = []
        self._seen = 0
        self.rows: Array = np.zeros((0, columns), dtype=np.int64)

    def reduced(self, rows: Array) -> Array:
        """The rows modulo the span; 0 where they are in it."""
        if not self.pivots:
            return rows
        return (rows - product(rows[:, self.pivots], self.rows, self.prime)) % self.prime

    def add(self, rows: Array) -> None:
        """Take in more rows."""
        for begin in range(0, len(rows), BATCH):
            batch = rows[begin : begin + BATCH]
            self._take(self.reduced(batch))
            self._seen += len(batch)

    def add_all(self, parts: Sequence[Array]) -> None:
        """Take in parts one by one, until random combinations of the rest lie in the span.

        The rest adds nothing then, but for one chance in prime^SAMPLES: what is left out is seen by who needs
        to know.
        """
        chance = np.random.default_rng(len(parts))
        for i, part in enumerate(parts):
            self.add(part)
            rest = parts[i + 1 :]
            if not rest or len(self.pivots) == self.columns:
                return
            total = np.zeros((SAMPLES, self.columns), dtype=np.int64)
            for other in rest:
                total += product(chance.integers(0, self.prime, (SAMPLES, len(other))), other, self.prime)
            if not self.reduced(total % self.prime).any():
                return

    def _take(self, rows: Array) -> None:
        alive = np.flatnonzero(rows.any(axis=1))
        rows = rows[alive]
        fresh: list[int] = []
        for i in range(len(rows)):
            entries = np.flatnonzero(rows[i])
            if not len(entries):
                continue
            column = int(entries[0])
            rows[i] = rows[i] * pow(int(rows[i, column]), -1, self.prime) % self.prime
            factor = rows[:, column].copy()
            factor[i] = 0
            hit = np.flatnonzero(factor)
            rows[hit] = (rows[hit] - factor[hit, None] * rows[i]) % self.prime
            fresh.append(column)
            self.used.append(self._seen + int(alive[i]))
        if not fresh:
            return
        rows = rows[rows.any(axis=1)]
        if self.pivots:
            self.rows = (self.rows - product(self.rows[:, fresh], rows, self.prime)) % self.prime
        self.rows = np.concatenate([self.rows, rows])
        self.pivots += fresh

    def annihilator(self) -> tuple[Array, Array]:
        """(free columns, values): a basis of the functionals that vanish on the span, one a column of values.

        Functional number i is 1 on free column i and 0 on the others.
        """
        free = np.setdiff1d(np.arange(self.columns), self.pivots)
        values = np.zeros((self.columns, len(free)), dtype=np.int64)
        values[free, np.arange(len(free))] = 1
        if self.pivots:
            values[self.pivots] = -self.rows[:, free] % self.prime
        return free, values
