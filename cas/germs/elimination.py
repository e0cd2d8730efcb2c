"""Rank of a matrix over ℚ[a₁, …, a_m], and polynomials off whose zeros the rank is the generic one.

Elimination without fractions: constant entries are pivots first; then entries of least degree, and the rows
below are cross-multiplied by them and divided by what all entries have in common. Where no pivot and no such
divisor is 0, the rank is that over ℚ(a): it can only drop on the zeros of the polynomials that are told.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.search import Patience

#: terms of the largest entry
TERMS = 2000


@dataclass(frozen=True)
class GenericRank:
    """The rank over ℚ(a), and irreducible ``candidates`` on whose zeros alone it may drop."""

    rank: int
    candidates: tuple[Any, ...]


def generic_rank(rows: Sequence[Mapping[int, Any]], patience: Patience | None = None) -> GenericRank:
    """The generic rank of rows {column: fmpq_mpoly}, and where it may drop.

    Raises UndecidedError if entries grow beyond `TERMS` terms or time is over.

    >>> from osculant.cas.germs.model import ring
    >>> a, b = ring(["a", "b"]).gens()
    >>> found = generic_rank([{0: a, 1: b}, {0: b, 1: a}])
    >>> found.rank, sorted(map(str, found.candidates))
    (2, ['a', 'a + b', 'a - b'])
    """
    left = [entries for row in rows if (entries := {c: v for c, v in row.items() if not v.is_zero()})]
    rank, factors = 0, dict[str, Any]()
    while left:
        if patience is not None and patience.left() < 0:
            raise UndecidedError("The rank of a matrix with parameters is not known in time.")
        i, column = _pivot(left)
        row = left.pop(i)
        pivot, rank = row[column], rank + 1
        factors |= _factors(pivot)
        following = []
        for other in left:
            if column in other:
                other, common = _cleared(other, row, column)
                factors |= _factors(common)
            if other:
                following.append(other)
        left = following
    return GenericRank(rank, tuple(factors.values()))


def _pivot(rows: Sequence[Mapping[int, Any]]) -> tuple[int, int]:
    """(row, column) of an entry of least degree, in a short row."""
    best: tuple[tuple[int, int, int], int, int] | None = None
    for i, row in enumerate(rows):
        for c, v in row.items():
            cost = (v.total_degree(), len(row), len(v))
            if best is None or cost < best[0]:
                best = cost, i, c
        if best is not None and best[0][:2] == (0, 1):
            break
    assert best is not None
    return best[1], best[2]


def _cleared(row: Mapping[int, Any], by: Mapping[int, Any], column: int) -> tuple[dict[int, Any], Any]:
    """(the row without the column, what was divided out)."""
    pivot, factor = by[column], row[column]
    common = pivot.gcd(factor)
    pivot, factor = pivot / common, factor / common
    found = {c: v * pivot for c, v in row.items() if c not in by}
    for c, v in by.items():
        value = row[c] * pivot - v * factor if c in row else -v * factor
        if not value.is_zero():
            found[c] = value
    content = common.context().constant(0)
    for v in found.values():
        if len(v) > TERMS:
            raise UndecidedError(f"Entries of more than {TERMS} terms in the parameters came up.")
        if not content.is_constant() or content.is_zero():
            content = content.gcd(v)
    if not content.is_constant():
        found = {c: v / content for c, v in found.items()}
    # where the pivot is 0 the rank may drop anyway; where what all had in common is 0, the row was 0
    return found, content


def _factors(f: Any) -> dict[str, Any]:
    return {} if f.is_constant() else {str(q): q for q, _ in f.factor()[1]}
