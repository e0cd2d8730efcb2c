"""The linear functionals that vanish on given rows, exactly over ℚ, with a certificate.

A modular rank alone proves only rank_ℚ ≥ rank_p. Here the functionals found modulo p are lifted to rational
ones and every row is tried on them in exact arithmetic. If C columns carry rows of rank r modulo p and C − r
independent rational functionals vanish on all rows, then r ≤ rank_ℚ ≤ C − (C − r): the functionals are the
whole annihilator, and everything about the span of the rows (codimension, inclusions) is known over ℚ.

Elimination is sparse first: rows with different leading columns are pivots that cost nothing; what is left
becomes a dense matrix on the columns that are no pivots, for flint.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice
from math import isqrt, lcm
from typing import Any

import numpy as np
from flint import fmpz, nmod_mat

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.algebraic import Algebraic, NumberField

#: entries are whole numbers, or numbers of a number field
Row = Mapping[int, Any]
Functional = dict[int, Any]

#: primes start here and go down: products of residues fit 63 bits; most that are used
LARGEST_PRIME, MOST_PRIMES = 2**31 - 1, 200
#: after so many primes, then each time half as many more, the residues are lifted
EAGER = 4


@dataclass(frozen=True)
class Annihilator:
    """The functionals that vanish on the span of rows in ℚᶜ.

    ``functionals`` is a basis; functional i is 1 on column ``free[i]`` and 0 on the other free columns.
    ``rank`` is the rank over ℚ, ``prime`` the last one used.

    >>> found = annihilator([{0: 1, 1: 1}, {1: 2, 2: 1}], 3)
    >>> found.rank, found.free, found.functionals[0][0]
    (2, (2,), Fraction(1, 2))
    """

    columns: int
    rank: int
    free: tuple[int, ...]
    functionals: tuple[Functional, ...]
    prime: int

    @property
    def codimension(self) -> int:
        """The dimension of ℚᶜ modulo the span."""
        return len(self.free)


def annihilator(rows: Sequence[Row], columns: int, field: NumberField | None = None) -> Annihilator:
    """The annihilator of rows {column: entry} of integers, or of numbers of a field; exact.

    Over a number field of degree d the rows are taken as d rows over ℚ each, every column as d of them: the
    echelon form over ℚ has whole blocks of d columns, and functional number i of the block of a column is the
    part of αⁱ of the functional over the field.

    Functionals are lifted from one prime or, by the Chinese remainder theorem, from as many as needed.
    Raises UndecidedError if the entries are too large even for `MOST_PRIMES`.
    """
    if field is not None:
        return _over_field(rows, columns, field)
    agreeing: dict[tuple[int, ...], _Residues] = {}
    for prime in islice(_primes(), MOST_PRIMES):
        free, values = modular_annihilator(rows, columns, prime)
        residues = agreeing.setdefault(free, _Residues())  # a prime in a coefficient may see other columns
        if not residues.add(values, prime):
            continue
        functionals = residues.lifted()
        if functionals is not None and vanish(functionals, rows):
            return Annihilator(columns, columns - len(free), free, functionals, prime)
    raise UndecidedError(
        f"The annihilator of {len(rows)} rows in {columns} columns was not found with {MOST_PRIMES} primes."
    )


def _over_field(rows: Sequence[Row], columns: int, field: NumberField) -> Annihilator:
    d = field.degree
    found = annihilator(restricted(rows, field), columns * d)
    free = tuple(c // d for c in found.free[::d])
    functionals = []
    for k in range(len(free)):
        parts: dict[int, list[Fraction]] = {}
        for i, functional in enumerate(found.functionals[k * d : (k + 1) * d]):
            for c, v in functional.items():
                if not c % d:  # the values on numbers of ℚ
                    parts.setdefault(c // d, [Fraction(0)] * d)[i] = v
        functionals.append({c: field.of(values) for c, values in sorted(parts.items())})
    return Annihilator(columns, found.rank // d, free, tuple(functionals), found.prime)


def restricted(rows: Sequence[Row], field: NumberField) -> list[dict[int, int]]:
    """The multiples of the rows by 1, α, …, α^{d−1} over ℚ, in whole numbers: column c·d + i is that of αⁱ.

    >>> field = NumberField.stated("a^2 - 2")
    >>> restricted([{1: field.generator}], field)
    [{3: 1}, {2: 2}]
    """
    found = []
    for row in rows:
        for power in range(field.degree):
            factor = field.generator**power
            entries: dict[int, Fraction] = {}
            for c, v in row.items():
                value = v * factor
                parts = value.coefficients() if isinstance(value, Algebraic) else (Fraction(value),)
                entries |= {c * field.degree + i: part for i, part in enumerate(parts) if part}
            common = lcm(*(v.denominator for v in entries.values()))
            found.append({c: int(v * common) for c, v in entries.items()})
    return found


def _primes() -> Iterator[int]:
    candidate = LARGEST_PRIME
    while True:
        if fmpz(candidate).is_prime():
            yield candidate
        candidate -= 2


def vanish(functionals: Sequence[Functional], rows: Sequence[Row]) -> bool:
    """Whether every functional is exactly 0 on every row.

    >>> vanish([{0: Fraction(1), 1: Fraction(-1)}], [{0: 2, 1: 2}]), vanish([{0: Fraction(1)}], [{0: 2}])
    (True, False)
    """
    by_column: dict[int, list[tuple[int, int]]] = {}
    for i, functional in enumerate(functionals):
        common = lcm(*(q.denominator for q in functional.values()))
        for column, q in functional.items():
            by_column.setdefault(column, []).append((i, q.numerator * (common // q.denominator)))
    for row in rows:
        sums: dict[int, int] = {}
        for column, entry in row.items():
            for i, value in by_column.get(column, ()):
                sums[i] = sums.get(i, 0) + entry * value
        if any(sums.values()):
            return False
    return True


def modular_annihilator(rows: Sequence[Row], columns: int, prime: int) -> tuple[tuple[int, ...], np.ndarray]:
    """(free columns, values): a basis of the annihilator modulo a prime, one functional a column of values.

    Blocks of rows and columns that have nothing to do with each other, such as the weights of a
    quasi-homogeneous germ, are eliminated one by one.

    >>> free, values = modular_annihilator([{0: 1, 1: 1}], 2, 7)
    >>> free, values.tolist()
    ((1,), [[6], [1]])
    """
    pieces = [_block(here, where, prime) for here, where in blocks(rows, columns)]
    free = sorted(c for found, _, _ in pieces for c in found)
    place = {c: j for j, c in enumerate(free)}
    values = np.zeros((columns, len(free)), dtype=np.int64)
    for found, where, part in pieces:
        if found:
            values[np.ix_(where, [place[c] for c in found])] = part
    return tuple(free), values


def blocks(rows: Sequence[Row], columns: int) -> Iterator[tuple[list[Row], list[int]]]:
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


def _block(rows: Sequence[Row], where: Sequence[int], prime: int) -> tuple[list[int], list[int], np.ndarray]:
    """(free columns, all columns, values) of one block."""
    columns, place = len(where), {c: i for i, c in enumerate(where)}
    if columns == 1:
        seen = any(v % prime for row in rows for v in row.values())
        return ([] if seen else list(where)), list(where), np.ones((1, 0 if seen else 1), dtype=np.int64)
    local = [{place[c]: v for c, v in row.items()} for row in rows]
    pivots, rest = _structural_pivots(local, prime)
    dense_columns = np.array([c for c in range(columns) if c not in pivots], dtype=np.int64)
    reduced = _reduced(rest, pivots, columns, prime)[:, dense_columns]
    echelon, leading = _echelon(reduced, prime)
    lead = set(leading)
    free = [j for j in range(len(dense_columns)) if j not in lead]
    values = np.zeros((columns, len(free)), dtype=np.int64)
    values[dense_columns[free], np.arange(len(free))] = 1
    if leading and free:
        values[dense_columns[leading]] = (-echelon[:, free]) % prime
    for column in sorted(pivots, reverse=True):  # a pivot row's other columns come later: they are known
        indices, entries = pivots[column]
        if len(indices) and free:
            values[column] = (-((entries[:, None] * values[indices]) % prime).sum(axis=0)) % prime
    return [where[int(c)] for c in dense_columns[free]], list(where), values


def _structural_pivots(
    rows: Sequence[Row], prime: int
) -> tuple[dict[int, tuple[np.ndarray, np.ndarray]], list[dict[int, int]]]:
    """For each first column the shortest row, as (other columns, entries / first); and the other rows."""
    best: dict[int, dict[int, int]] = {}
    rest: list[dict[int, int]] = []
    for row in rows:
        residues = {c: r for c, v in row.items() if (r := v % prime)}
        if not residues:
            continue
        first = min(residues)
        rival = best.get(first)
        if rival is None or len(residues) < len(rival):
            best[first] = residues
            residues = rival if rival is not None else {}
        if residues:
            rest.append(residues)
    pivots = {}
    for first, row in best.items():
        inverse = pow(row[first], -1, prime)
        others = [(c, v * inverse % prime) for c, v in row.items() if c != first]
        pivots[first] = (
            np.array([c for c, _ in others], dtype=np.int64),
            np.array([v for _, v in others], dtype=np.int64),
        )
    return pivots, rest


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


def _echelon(matrix: np.ndarray, prime: int) -> tuple[np.ndarray, list[int]]:
    """(reduced row echelon form without zero rows, leading columns) modulo a prime."""
    matrix = matrix[matrix.any(axis=1)]
    used = np.flatnonzero(matrix.any(axis=0))
    if not matrix.size or not len(used):
        return np.zeros((0, matrix.shape[1]), dtype=np.int64), []
    small = matrix[:, used]
    form, rank = nmod_mat(small.shape[0], small.shape[1], small.ravel().tolist(), prime).rref()
    entries = np.array([int(v) for v in form.entries()[: rank * small.shape[1]]], dtype=np.int64)
    echelon = np.zeros((rank, matrix.shape[1]), dtype=np.int64)
    echelon[:, used] = entries.reshape(rank, small.shape[1])
    return echelon, [int(np.flatnonzero(row)[0]) for row in echelon]


class _Residues:
    """Functionals modulo the product of some primes."""

    def __init__(self) -> None:
        self.combined: Any = None
        self.modulus, self.count, self.next = 1, 0, 1

    def add(self, values: np.ndarray, prime: int) -> bool:
        """Take in the residues modulo one more prime; whether it is time to lift them."""
        if self.combined is None:
            self.combined = values.astype(object)
        else:
            inverse = pow(self.modulus, -1, prime)
            self.combined += self.modulus * (((values - self.combined) % prime) * inverse % prime)
        self.modulus *= prime
        self.count += 1
        if self.count < self.next:
            return False
        self.next = self.count + max(1, self.count // 2 if self.count >= EAGER else 1)
        return True

    def lifted(self) -> tuple[Functional, ...] | None:
        """The rational functionals with these residues, or None where one has no small enough fraction."""
        bound = isqrt(self.modulus // 2)
        known: dict[int, Fraction] = {}
        functionals = []
        for j in range(self.combined.shape[1]):
            functional: Functional = {}
            for column in np.flatnonzero(self.combined[:, j]):
                residue = int(self.combined[column, j])
                if residue not in known:
                    fraction = _fraction(residue, self.modulus, bound)
                    if fraction is None:
                        return None
                    known[residue] = fraction
                functional[int(column)] = known[residue]
            functionals.append(functional)
        return tuple(functionals)


def _fraction(residue: int, modulus: int, bound: int) -> Fraction | None:
    """The fraction a/b ≡ residue with |a|, b ≤ bound, by the Euclidean algorithm (Wang)."""
    previous, current, s, t = modulus, residue, 0, 1
    while current > bound:
        quotient = previous // current
        previous, current, s, t = current, previous - quotient * current, t, s - quotient * t
    if t == 0 or abs(t) > bound:
        return None
    return Fraction(current, t)
