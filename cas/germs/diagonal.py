"""Matrices over ℚ[a]: a diagonal form, from which the rank at every value of a is read off, exactly.

ℚ[a] is a principal ideal domain: invertible row and column operations make a matrix diagonal, with entries
d₁, …, dᵣ. The rank over ℚ(a) is r, and the rank at a number a₀ of any extension field is the number of i with
dᵢ(a₀) ≠ 0. So the values where the rank drops are the zeros of d₁⋯dᵣ: none is missed, none is only likely.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from osculant.cas.errors import UndecidedError

Row = Mapping[int, Any]

#: degree in a of an entry above which the elimination gives up
DEGREE = 2000


def diagonal_form(rows: Sequence[Row]) -> list[Any]:
    """The entries d₁, …, dᵣ of a diagonal form of a sparse matrix of fmpq_poly, up to constant factors.

    Constant entries are taken as pivots first, those that cost least first (Markowitz), and then those of
    least degree, with Euclidean division in their column and row.

    >>> from flint import fmpq_poly
    >>> a, one = fmpq_poly([0, 1]), fmpq_poly([1])
    >>> diagonal_form([{0: one, 1: a}, {0: a, 1: one}])
    [1, x^2 + (-1)]
    """
    matrix = _Matrix(rows)
    entries = []
    while (pivot := matrix.choose()) is not None:
        found = matrix.clear(*pivot)
        if found is not None:
            entries.append(found)
    return entries


class _Matrix:
    """A sparse matrix under elimination: rows, and for each column the rows that have an entry in it."""

    def __init__(self, rows: Sequence[Row]) -> None:
        self.rows: dict[int, dict[int, Any]] = {}
        self.columns: dict[int, set[int]] = {}
        for i, row in enumerate(rows):
            entries = {c: v for c, v in row.items() if v}
            if entries:
                self.rows[i] = entries
            for c in entries:
                self.columns.setdefault(c, set()).add(i)
        self.without_units: set[int] = set()

    def choose(self) -> tuple[int, int] | None:
        """(row, column) of the next pivot."""
        while candidates := [(len(self.rows[i]), i) for i in self.rows if i not in self.without_units]:
            i = min(candidates)[1]
            units = [c for c, v in self.rows[i].items() if v.degree() == 0]
            if units:
                return i, min(units, key=lambda c: (len(self.columns[c]), c))
            self.without_units.add(i)
        entries = (
            (v.degree(), len(row), len(self.columns[c]), i, c)
            for i, row in self.rows.items()
            for c, v in row.items()
        )
        best = min(entries, default=None)
        if best is not None and best[0] > DEGREE:
            raise UndecidedError(f"Entries of degree above {DEGREE} in the parameter came up in elimination.")
        return None if best is None else (best[3], best[4])

    def clear(self, i: int, column: int) -> Any:
        """Reduce column and row by the pivot; the pivot if nothing else is left there, else None."""
        pivot, row = self.rows[i][column], self.rows[i]
        done = True
        for k in sorted(self.columns[column] - {i}):
            quotient = self.rows[k][column] // pivot
            self._subtract(k, quotient, row)
            done &= column not in self.rows.get(k, {})
        if not done:
            return None
        # the column has the pivot alone: column operations change no other row
        for c, v in list(row.items()):
            if c == column:
                continue
            rest = v % pivot
            if rest:
                row[c] = rest
                done = False
            else:
                del row[c]
                self.columns[c].discard(i)
        self.without_units.discard(i)
        if not done:
            return None
        del self.rows[i]
        del self.columns[column]
        return pivot / pivot[pivot.degree()]

    def _subtract(self, k: int, quotient: Any, row: Mapping[int, Any]) -> None:
        target = self.rows[k]
        for c, v in row.items():
            old = target.get(c)
            new = -quotient * v if old is None else old - quotient * v
            if new:
                target[c] = new
                if old is None:
                    self.columns[c].add(k)
            elif old is not None:
                del target[c]
                self.columns[c].discard(k)
        self.without_units.discard(k)
        if not target:
            del self.rows[k]
