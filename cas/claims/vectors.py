"""Forms that are vectors: linear combinations written in symbols, and their comparison by components."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from operator import and_
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence
from osculant.cas.claims.proof import read_tuple, vanishes
from osculant.cas.jets.derivations.space import combine
from osculant.cas.numbers.vectors import Vector3, subtract


def read_vectors(
    form: str, scalars: Mapping[str, Any], vectors: Mapping[str, Vector3], count: int | None = None
) -> tuple[Vector3, ...]:
    """The vectors that a form's linear combinations stand for.

    Args:
        form: one or more linear combinations, separated by commas.
        scalars: what the names of numbers mean.
        vectors: what the names of vectors mean, by components along some basis.
        count: how many there must be.

    Raises DomainError for a part that is not linear in the vectors, or another number of parts.

    >>> a = sp.Symbol("a")
    >>> read_vectors("a*E, F - E", {"a": a}, {"E": (1, 0, 0), "F": (0, 1, 0)})
    ((a, 0, 0), (-1, 1, 0))
    """
    names = {name: sp.Dummy(name) for name in vectors}
    places = {names[name]: vector for name, vector in vectors.items()}
    return tuple(combine(part, places) for part in read_tuple(form, {**scalars, **names}, count))


def same(
    vectors: Sequence[Vector3],
    expected: Sequence[Vector3],
    what: str,
    relations: Sequence[tuple[Any, Any]] = (),
) -> Evidence:
    """Proof that vectors agree with others, component by component; relations as for `vanishes`.

    >>> same([(1, 0, 0)], [(1, 0, 0)], "E").certificate
    ('E: all 3 components agree identically',)
    """
    if len(vectors) != len(expected):
        return Evidence(False, (f"{what}: {len(vectors)} vectors instead of {len(expected)}",))
    parts = [p for a, b in zip(vectors, expected) for p in subtract(a, b)]
    found = [vanishes(part, f"{what}, component {i + 1}", relations) for i, part in enumerate(parts)]
    failed = [evidence for evidence in found if not evidence]
    if failed:
        return reduce(and_, failed)
    return Evidence(True, (f"{what}: all {len(parts)} components agree identically",))
