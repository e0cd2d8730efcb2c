"""Sparse elimination with the combination of the rows recorded."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from heapq import heapify, heappop, heappush
from typing import Any

#: entries by their column
Vector = dict[int, Any]
#: how a vector is combined of the rows: their labels and factors
Combination = dict[Any, Any]
#: by leading column: a row with 1 there and nothing before, and how it is combined
Echelon = dict[int, tuple[Vector, Combination]]


def echelon(rows: Iterable[tuple[Hashable, Vector]]) -> Echelon:
    """The echelon form of labelled rows, shortest rows first; they are used up.

    >>> from flint import fmpq
    >>> found = echelon([("a", {0: fmpq(2), 3: fmpq(1)}), ("b", {0: fmpq(1)})])
    >>> {lead: {key: str(v) for key, v in made.items()} for lead, (_, made) in found.items()}
    {0: {'b': '1'}, 3: {'a': '1', 'b': '-2'}}
    """
    found: Echelon = {}
    for label, row in sorted(rows, key=lambda pair: len(pair[1])):
        made: Combination = {label: 1}
        lead = swept(row, found, made)
        if lead is not None:
            inverse = 1 / row[lead]
            found[lead] = (
                {j: v * inverse for j, v in row.items()},
                {key: v * inverse for key, v in made.items()},
            )
    return found


def swept(vector: Vector, rows: Echelon, made: Combination) -> int | None:
    """Subtracts rows from a vector, column by column, up to the first column where none leads.

    Returns that column; None if nothing remains. What is subtracted is subtracted from ``made`` too.
    """
    waiting = list(vector)
    heapify(waiting)
    while waiting:
        j = heappop(waiting)
        value = vector.get(j)
        if value is None:
            continue
        if j not in rows:
            return j
        row, combined = rows[j]
        for i, v in row.items():
            old = vector.get(i)
            if old is None:
                vector[i] = -value * v
                heappush(waiting, i)
            elif (new := old - value * v) == 0:
                del vector[i]
            else:
                vector[i] = new
        for key, v in combined.items():
            old = made.get(key)
            new = -value * v if old is None else old - value * v
            if new == 0:
                made.pop(key, None)
            else:
                made[key] = new
    return None
