"""The target part of K: a germ f becomes M(x)·f, M an invertible matrix of functions of the source.

A matrix is kept as the jet of its p·p entries, row by row, in the present coordinates of the source: changes
of the source move it with f. The flow of the field Σ a(x)·fᵢeⱼ at time 1 is f ↦ exp(A)f.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from flint import fmpq, fmpq_mat

from osculant.cas.germs.jets_of_maps import MapJet, plus, times
from osculant.cas.germs.model import ring
from osculant.cas.recognition.elimination import Vector
from osculant.cas.recognition.levels import Columns
from osculant.cas.recognition.moves import Field, Moved, Sum, TargetPart, Terms


def unit(p: int, n: int, order: int) -> MapJet:
    """The unit matrix."""
    context = ring([f"x{i + 1}" for i in range(n)])
    zero = context.constant(0)
    entries = (context.constant(int(i == j)) for i in range(p) for j in range(p))
    return MapJet(order, tuple((entry, *(zero,) * order) for entry in entries))


def matrix_times(matrix: MapJet, f: MapJet, p: int) -> MapJet:
    """A p × p matrix times a germ with p components, or times a matrix.

    >>> from osculant.cas.germs.jets_of_maps import map_jet
    >>> f = map_jet([{1 << 12 | 1: 3}], 1, 2)
    >>> matrix_times(unit(1, 1, 2), f, 1) == f
    True
    """
    wide = len(f.components) // p
    zero = (f.context.constant(0),) * (f.order + 1)
    found = []
    for i in range(p):
        for j in range(wide):
            total = zero
            for k in range(p):
                total = plus(total, times(matrix.components[i * p + k], f.components[k * wide + j], f.order))
            found.append(total)
    return MapJet(f.order, tuple(found))


def _fields(columns: Columns, terms: Terms) -> Iterator[tuple[Field, Vector]]:
    weights, n, p = columns.weights, len(columns.weights.source), len(columns.weights.target)
    for alpha in ((0,) * n, *columns.monomials):
        for i in range(p):
            for j in range(p):
                if weights.of(alpha) + weights.target[i] <= weights.target[j]:
                    continue
                row: Vector = {}
                for (m, component), c in terms.items():
                    image = tuple(a + b for a, b in zip(m, alpha))
                    if component == i and (at := columns.place.get((image, j))) is not None:
                        row[at] = fmpq(c)
                yield Field("contact", j, alpha, i), row


def _flowed(moved: Moved, fields: Sum) -> Moved:
    n, p, order = moved.n, moved.p, moved.order
    context = ring([f"x{i + 1}" for i in range(n)])
    entries: list[list[dict[Any, Any]]] = [[{} for _ in range(order + 1)] for _ in range(p * p)]
    for field, c in fields.items():
        if (degree := sum(field.exponents)) <= order:
            entries[field.index * p + field.row][degree][field.exponents] = c
    algebra = MapJet(order, tuple(tuple(context.from_dict(part) for part in parts) for parts in entries))
    found = []
    for jet in (moved.f, _matrix(moved)):
        total, term, j = jet, matrix_times(algebra, jet, p), 1
        while any(not part.is_zero() for parts in term.components for part in parts):
            term = MapJet(order, tuple(tuple(part / fmpq(j) for part in parts) for parts in term.components))
            total = MapJet(order, tuple(plus(a, b) for a, b in zip(total.components, term.components)))
            term, j = matrix_times(algebra, term, p), j + 1
        found.append(total)
    return replace(moved, f=found[0], target=found[1])


def _mapped(moved: Moved, matrix: fmpq_mat) -> Moved:
    n, p, order = moved.n, moved.p, moved.order
    context = ring([f"x{i + 1}" for i in range(n)])
    zero = context.constant(0)
    constant = MapJet(
        order,
        tuple((context.constant(matrix[i, j]), *(zero,) * order) for i in range(p) for j in range(p)),
    )
    return replace(
        moved, f=matrix_times(constant, moved.f, p), target=matrix_times(constant, _matrix(moved), p)
    )


def _matrix(moved: Moved) -> MapJet:
    """What the target was multiplied by; None stands for the unit matrix."""
    return unit(moved.p, moved.n, moved.order) if moved.target is None else moved.target


def _applied(change: MapJet, f: MapJet) -> MapJet:
    return matrix_times(change, f, len(f.components))


CONTACT = TargetPart(None, _fields, _flowed, _mapped, _matrix, _applied, scales=True, along=True)
