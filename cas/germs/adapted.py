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

from flint import fmpq, fmpq_mat

from osculant.cas.formulas.expression import Node, number, to_text, variable
from osculant.cas.formulas.graph import substitute
from osculant.cas.germs.codimension import tangent
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.unipotent import LinearField

Matrix = list[list[Fraction]]

#: elements of the algebra of symmetries that are tried
TRIED = 60


@dataclass(frozen=True)
class Adapted:
    """A germ in new linear coordinates (the rows: linear functions of the old ones), boundary kept."""

    germ: Germ
    source: Matrix
    target: Matrix

    def text(self, old: Germ) -> tuple[str, ...]:
        """The new coordinates as written: "X = x + 2*y", and Y1, Y2, … of the target."""
        targets = [f"y{j + 1}" for j in range(old.p)]
        found = []
        for names, rows, news in (
            (old.source, self.source, [name.upper() for name in old.source]),
            (targets, self.target, [name.upper() for name in targets]),
        ):
            for new, row in zip(news, rows):
                found.append(f"{new} = {to_text(_combination(row, [variable(name) for name in names]))}")
        return tuple(found)


def adapted(germ: Germ, group: Group, order: int) -> Adapted | None:
    """The germ in adapted coordinates; None if no symmetry tells any apart, or for a group of own fields.

    Args:
        germ: the germ.
        group: the group.
        order: order of the jets in which T G₁ f is taken.

    >>> from osculant.cas.germs.groups import group
    >>> moved = adapted(Germ("(x + y)**2 + (x + 2*y)**5", "x y"), group("R"), 6)
    >>> moved.germ.text(2)  # no mixed term
    ('y**2',)
    """
    if group.source == "own":
        return None
    fields = _linear(germ, group)
    symmetries = _symmetries(germ, group, fields, order)
    fixed = germ.boundary_index if group.source == "boundary" else None
    best: tuple[int, int, Matrix, Matrix] | None = None
    for weights in _simple(symmetries):
        source, kinds = _eigenbasis(_matrix("source", germ.n, fields, weights), fixed)
        target, others = _eigenbasis(_matrix("target", germ.p, fields, weights), None)
        size = sum(abs(v.numerator) + v.denominator for row in source + target for v in row)
        if best is None or (kinds + others, -size) > best[:2]:
            best = kinds + others, -size, source, target
    if best is None or best[0] <= 2:  # all eigenvalues equal on either side: nothing is told apart
        return None
    _, _, source, target = best
    if group.target == "none":
        target = [[Fraction(int(i == j)) for j in range(germ.p)] for i in range(germ.p)]
    return Adapted(_moved(germ, source, target), source, target)


def _simple(symmetries: Matrix) -> list[list[Fraction]]:
    """Elements of the algebra with small coefficients: the basis, sums of two of it, and one generic one."""
    found = list(symmetries)
    found += [[2 * x + y for x, y in zip(a, b)] for a in symmetries for b in symmetries if a is not b]
    source = random.Random(6)
    weights = [source.randint(1, 40) for _ in symmetries]
    found.append([sum((w * x for w, x in zip(weights, column)), Fraction(0)) for column in zip(*symmetries)])
    return found[:TRIED] if symmetries else []


def _linear(germ: Germ, group: Group) -> list[LinearField]:
    """All linear fields x_a ∂/∂x_b of the group, and all y_i ∂/∂y_j.

    The target counts for every group: a quasi-homogeneous function is only scaled by its Euler field.
    """
    found = []
    if group.source != "none":
        u = germ.boundary_index if group.source == "boundary" else -1
        pairs = [(a, b) for a in range(germ.n) for b in range(germ.n) if b != u or a == u]
        found += [LinearField("source", a, b) for a, b in pairs]
    return found + [LinearField("target", i, j) for i in range(germ.p) for j in range(germ.p)]


def _symmetries(germ: Germ, group: Group, fields: Sequence[LinearField], order: int) -> Matrix:
    """A basis of the combinations D of the fields with D f in T G₁ f."""
    first = tangent(germ, group, Version.UNIPOTENT, order)
    place = first.space.place()
    images = []
    for field in fields:  # not as an integer row: the combination matters
        vector = field.image(germ, order)
        images.append({germ.p * place[m] + j: c for j, f in enumerate(vector) for m, c in f.items()})
    conditions = [
        [sum((v * image[c] for c, v in functional.items() if c in image), Fraction(0)) for image in images]
        for functional in first.annihilator.functionals
    ]
    return null_space(conditions, len(fields))


def _matrix(side: str, size: int, fields: Sequence[LinearField], weights: Sequence[Fraction]) -> Matrix:
    """The endomorphism of linear functions: entry (a, b) is the coefficient of x_a in D(x_b)."""
    matrix = [[Fraction(0)] * size for _ in range(size)]
    for field, weight in zip(fields, weights):
        if field.side == side:
            matrix[field.a][field.b] += weight
    return matrix


def _eigenbasis(matrix: Matrix, fixed: int | None) -> tuple[Matrix, int]:
    """(rows, number of different eigenvalues): a basis of linear functions out of generalised eigenvectors.

    Row ``fixed`` is that coordinate itself, which is an eigenvector. Conjugate eigenvalues count as one.
    """
    size = len(matrix)
    rational = fmpq_mat(size, size, [fmpq(v.numerator, v.denominator) for row in matrix for v in row])
    own = [Fraction(int(i == fixed)) for i in range(size)]
    rows: Matrix = []
    _, factors = rational.charpoly().factor()
    for factor, multiplicity in factors:
        power = _polynomial_at(factor, rational) ** multiplicity
        conditions = [
            [Fraction(int(power[i, j].p), int(power[i, j].q)) for j in range(size)] for i in range(size)
        ]
        rows += null_space(conditions, size)
    if fixed is None:
        return rows, len(factors)
    # the boundary function is an eigenvector: it takes the place of a row that it needs
    at = next(i for i in range(size) if _independent([*rows[:i], *rows[i + 1 :], own]))
    rows.pop(at)
    rows.insert(fixed, own)
    return rows, len(factors)


def _polynomial_at(polynomial: object, matrix: fmpq_mat) -> fmpq_mat:
    size = matrix.nrows()
    unit = fmpq_mat(size, size, [fmpq(int(i == j)) for i in range(size) for j in range(size)])
    value = unit * fmpq(0)
    for c in reversed(polynomial.coeffs()):  # type: ignore[attr-defined]
        value = value * matrix + unit * c
    return value


def _independent(rows: Matrix) -> bool:
    flat = [fmpq(v.numerator, v.denominator) for row in rows for v in row]
    return bool(fmpq_mat(len(rows), len(rows), flat).rank() == len(rows))


def _moved(germ: Germ, source: Matrix, target: Matrix) -> Germ:
    """The germ with x = (source)⁻¹X and Y = (target) y."""
    n = germ.n
    flat = [fmpq(v.numerator, v.denominator) for row in source for v in row]
    inverse = fmpq_mat(n, n, flat).inv()
    variables = [variable(name) for name in germ.source]
    old = {
        name: _combination(
            [Fraction(int(inverse[i, j].p), int(inverse[i, j].q)) for j in range(n)], variables
        )
        for i, name in enumerate(germ.source)
    }

    components = substitute(germ.components, old)
    return Germ([_combination(row, components) for row in target], germ.source, germ.boundary)


def _combination(weights: Sequence[Fraction], nodes: Sequence[Node]) -> Node:
    total = number(0)
    for weight, node in zip(weights, nodes):
        if weight:
            total = total + number(weight) * node
    return total
