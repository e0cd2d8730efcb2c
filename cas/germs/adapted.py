"""Linear coordinates adapted to a germ: those in which its linear symmetries are diagonal.

The unipotent groups tried for determinacy are triangular in the coordinates, which a linear change spoils.
The linear fields D = (ξ, η) of the group with D f ∈ T G₁ f form the Lie algebra of the linear parts of
symmetries of f; for a germ equivalent to a quasi-homogeneous one it contains the Euler field. Its generic
element is an endomorphism of the linear functions on source and target; their bases of generalised
eigenvectors depend on the class of f only, so the search in them does not depend on the coordinates that f
came in.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.cas.formulas.expression import Node, number, to_text, variable
from osculant.cas.germs.algebraic import NumberField, height
from osculant.cas.germs.eigenvalues import at_matrix, factors, rational_root
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.germs.linear import inverse, null_space, product, rank
from osculant.cas.germs.linear_fields import LinearField, all_linear_fields
from osculant.cas.germs.symmetries import symmetries

Matrix = list[list[Any]]

#: elements of the algebra of symmetries that are tried
TRIED = 60


@dataclass(frozen=True)
class Frame:
    """Linear coordinates, as rows: linear functions of the old ones; boundary kept.

    ``source_weights`` and ``target_weights`` are the eigenvalues of a symmetry that has them as eigenvectors;
    None where there is no such, or an eigenvalue is not rational. ``moved`` tells whether they are new
    coordinates, ``kinds`` how many different eigenvalues there are on either side, in all.
    """

    source: Matrix
    target: Matrix
    source_weights: tuple[Fraction, ...] | None = None
    target_weights: tuple[Fraction, ...] | None = None
    moved: bool = True
    kinds: int = 0

    def field(self, field: LinearField) -> Matrix:
        """The matrix, in the old coordinates, of the field X_a ∂/∂X_b of the new ones.

        Entry (c, i) is the coefficient of x_c ∂/∂x_i; of the target likewise.

        >>> given([[Fraction(1)]], [[Fraction(1)]]).field(LinearField("source", 0, 0))
        [[Fraction(1, 1)]]
        """
        rows = self.source if field.side == "source" else self.target
        if not self.moved:
            size = range(len(rows))
            return [[Fraction(int((c, i) == (field.a, field.b))) for i in size] for c in size]
        back = inverse(rows)
        return [[a * row[field.b] for row in back] for a in rows[field.a]]

    def parts(self, field: LinearField) -> list[tuple[LinearField, Any]]:
        """The field of the new coordinates as a combination of those of the old: (field, coefficient)."""
        return [
            (LinearField(field.side, c, i), entry)
            for c, row in enumerate(self.field(field))
            for i, entry in enumerate(row)
            if entry
        ]

    def text(self, germ: Germ) -> tuple[str, ...]:
        """The new coordinates as written: "X = x + 2*y", and Y1, Y2, … of the target."""
        targets = [f"y{j + 1}" for j in range(germ.p)]
        found = []
        for names, rows in ((germ.source, self.source), (targets, self.target)):
            for name, row in zip(names, rows):
                nodes = [variable(n) for n in names]
                found.append(f"{name.upper()} = {to_text(_combination(row, nodes, germ.field))}")
        return tuple(found)


def given(source: Matrix, target: Matrix) -> Frame:
    """The coordinates as they are: unit matrices."""
    return Frame(source, target, moved=False)


def unit(size: int) -> Matrix:
    """The unit matrix."""
    return [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]


def adapted(germ: Germ, group: Group, order: int) -> Frame | None:
    """Adapted coordinates; None if no symmetry tells any apart, or for a group of own fields.

    Args:
        germ: the germ.
        group: the group.
        order: order of the jets in which T G₁ f is taken.

    >>> from osculant.cas.germs.groups import group
    >>> found = adapted(Germ("(x + y)**2 + (x + 2*y)**5", "x y"), group("R"), 6)
    >>> found.text(Germ("(x + y)**2 + (x + 2*y)**5", "x y"))[:2]
    ('X = 2/5*x + y', 'Y = x + y')
    """
    if group.source == "own":
        return None
    fields = all_linear_fields(germ, group)
    found = symmetries(germ, group, order)
    fixed = germ.boundary_index if group.source == "boundary" else None
    best: tuple[tuple[int, int], Frame] | None = None
    for weights in _simple(found):
        source, kinds, own = _eigenbasis(_matrix("source", germ.n, fields, weights), fixed)
        target, others, theirs = _eigenbasis(_matrix("target", germ.p, fields, weights), None)
        size = sum(height(v) for row in source + target for v in row)
        if group.target == "none":
            target = unit(germ.p)
        if best is None or (kinds + others, -size) > best[0]:
            best = (kinds + others, -size), Frame(source, target, own, theirs, True, kinds + others)
    if best is None or best[0][0] <= 2:  # all eigenvalues equal on either side: nothing is told apart
        return None
    return best[1]


def _simple(symmetries: Matrix) -> list[list[Fraction]]:
    """Elements of the algebra with small coefficients: the basis, sums of two of it, and one generic one."""
    found = list(symmetries)
    found += [[2 * x + y for x, y in zip(a, b)] for a in symmetries for b in symmetries if a is not b]
    source = random.Random(6)
    weights = [source.randint(1, 40) for _ in symmetries]
    found.append([sum((w * x for w, x in zip(weights, column)), Fraction(0)) for column in zip(*symmetries)])
    return found[:TRIED] if symmetries else []


def _matrix(side: str, size: int, fields: Sequence[LinearField], weights: Sequence[Fraction]) -> Matrix:
    """The endomorphism of linear functions: entry (a, b) is the coefficient of x_a in D(x_b)."""
    matrix = [[Fraction(0)] * size for _ in range(size)]
    for field, weight in zip(fields, weights):
        if field.side == side:
            matrix[field.a][field.b] += weight
    return matrix


def _eigenbasis(matrix: Matrix, fixed: int | None) -> tuple[Matrix, int, tuple[Fraction, ...] | None]:
    """(rows, number of different eigenvalues, eigenvalues): a basis out of generalised eigenvectors.

    Row ``fixed`` is that coordinate itself, which is an eigenvector. Conjugate eigenvalues count as one; the
    eigenvalues are None unless all are rational.
    """
    size = len(matrix)
    rows: Matrix = []
    values: list[Fraction | None] = []
    found = factors(matrix)
    for factor, multiplicity in found:
        power = value = at_matrix(factor, matrix)
        for _ in range(multiplicity - 1):
            power = product(power, value)
        here = null_space(power, size)
        rows += here
        values += [rational_root(factor)] * len(here)
    if len(rows) != size or not _independent(rows):  # the factors have a common one over a number field
        return [[Fraction(int(i == j)) for j in range(size)] for i in range(size)], 1, None
    if fixed is not None:
        # the boundary function is an eigenvector: it takes the place of a row that it needs
        own = [Fraction(int(i == fixed)) for i in range(size)]
        at = next(i for i in range(size) if _independent([*rows[:i], *rows[i + 1 :], own]))
        rows.pop(at)
        rows.insert(fixed, own)
        values.pop(at)
        values.insert(fixed, matrix[fixed][fixed])
    known = [v for v in values if v is not None]
    return rows, len(found), tuple(known) if len(known) == size else None


def _independent(rows: Matrix) -> bool:
    return rank(rows, len(rows)) == len(rows)


def _combination(weights: Sequence[Any], nodes: Sequence[Node], field: NumberField | None) -> Node:
    total = number(0)
    for weight, node in zip(weights, nodes):
        if weight:
            total = total + (number(weight) if field is None else field.expression(weight)) * node
    return total
