"""The linear functionals that vanish on given rows, exactly over ℚ, with a certificate.

A modular rank alone proves only rank_ℚ ≥ rank_p. Here the functionals found modulo p are lifted to rational
ones and every row is tried on them in exact arithmetic. If C columns carry rows of rank r modulo p and C − r
independent rational functionals vanish on all rows, then r ≤ rank_ℚ ≤ C − (C − r): the functionals are the
whole annihilator, and everything about the span of the rows (codimension, inclusions) is known over ℚ.

What one prime shows to be enough of the rows is taken modulo the others; all are tried in the end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice
from math import lcm
from typing import Any

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.algebraic import Algebraic, NumberField
from osculant.cas.germs.elimination_mod_p import Row, blocks, eliminated
from osculant.cas.germs.lifting import Residues, primes

Functional = dict[int, Any]

#: primes start here and go down: products of residues fit 63 bits; most that are used
LARGEST_PRIME, MOST_PRIMES = 2**31 - 1, 200


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
    agreeing: dict[tuple[int, ...], Residues] = {}
    divided = list(blocks(rows, columns))
    enough = divided
    for prime in islice(primes(LARGEST_PRIME), MOST_PRIMES):
        free, values, enough = eliminated(enough, columns, prime)
        residues = agreeing.setdefault(free, Residues())  # a prime in a coefficient may see other columns
        if not residues.add(values, prime):
            continue
        functionals = residues.lifted()
        if functionals is None:
            continue
        if vanish(functionals, rows):
            return Annihilator(columns, columns - len(free), free, functionals, prime)
        enough = divided
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
