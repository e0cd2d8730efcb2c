"""Tangent spaces of group orbits in spaces of jets, as the rows of a sparse matrix.

T G f is spanned by x^α·df(ξ) for the source fields ξ, and by f^β e_j (A, L) or x^α f_i e_j (K, C). The
version of the group sets the least order of the vector fields that are used: x^α ξ in the source, y^β ∂/∂y_j
in the target (K counts α alone there, since f vanishes at 0).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import comb, lcm
from typing import Any, Literal

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, exact
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Field, Group, Version
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.polynomials import Polynomial

Vector = tuple[Polynomial, ...]
Side = Literal["source", "target", "contact"]


@dataclass(frozen=True)
class JetSpace:
    """The jets of order k of maps in n variables with p components, constants included; columns by degree.

    With ``weights`` the order and the degrees count the variables with them.

    >>> space = JetSpace(2, 1, 2)
    >>> space.columns, space.degree(0), space.degree(5)
    (6, 0, 2)
    """

    n: int
    p: int
    order: int
    weights: tuple[int, ...] = ()

    @property
    def monomials(self) -> tuple[int, ...]:
        """The monomials, by degree."""
        return poly.monomials(self.n, self.order, self.weights)

    @property
    def columns(self) -> int:
        """The dimension, p·C(n + k, k) without weights."""
        if self.weights:
            return self.p * len(self.monomials)
        return self.p * comb(self.n + self.order, self.n)

    def place(self) -> dict[int, int]:
        """The number of each monomial; component j of monomial number i has column p·i + j."""
        return {m: i for i, m in enumerate(self.monomials)}

    def degree(self, column: int) -> int:
        """The degree of a column's monomial, with the weights."""
        return poly.degree_of(self.monomials[column // self.p], self.n)

    def plain_degree(self, column: int) -> int:
        """The degree of a column's monomial, without weights."""
        return sum(poly.exponents_of(self.monomials[column // self.p], self.n))

    def term(self, column: int) -> tuple[int, int]:
        """(monomial without weights, component) of a column."""
        m, j = self.monomials[column // self.p], column % self.p
        return (poly.monomial(poly.exponents_of(m, self.n)) if self.weights else m), j

    def row(self, vector: Vector, place: dict[int, int]) -> dict[int, Any]:
        """The vector as a row of integers (a multiple of it), or of numbers of a number field."""
        entries = {self.p * place[m] + j: c for j, f in enumerate(vector) for m, c in f.items()}
        common = lcm(*{c.denominator for c in entries.values()})
        return {
            column: c * common if isinstance(c, Algebraic) else int(c * common)
            for column, c in entries.items()
            if c
        }


def along(jet: Vector, field: Field, n: int, order: int, weights: tuple[int, ...] = ()) -> Vector:
    """df(ξ) up to degree ``order``; the jet must be known one degree further where ξ(0) is not 0.

    >>> x = poly.variable(0, 1)
    >>> along(({2 * x: 1},), ({x: 1},), 1, 3) == ({2 * x: 2},)
    True
    """
    found = []
    for f in jet:
        total: Polynomial = {}
        for i, coefficient in enumerate(field):
            if coefficient:
                slope = poly.derivative(f, i, n, weights)
                total = poly.plus(total, poly.times(coefficient, slope, n, order))
        found.append(total)
    return tuple(found)


def order_of(vector: Iterable[Polynomial], n: int) -> int:
    """The least degree of a term of a vector of polynomials."""
    return min(poly.order_of(f, n) for f in vector)


def vectors(
    germ: Germ, group: Group, version: Version, order: int, weights: tuple[int, ...] = ()
) -> Iterator[Vector]:
    """Spanning vectors of the tangent space of that version of the group, modulo terms above ``order``.

    With ``weights`` the order counts the variables with them; the monomials of the vectors do so too.
    """
    for *_, vector in spanning(germ, group, version, order, weights, integral=True):
        yield vector


def spanning(
    germ: Germ,
    group: Group,
    version: Version,
    order: int,
    weights: tuple[int, ...] = (),
    integral: bool = False,
) -> Iterator[tuple[Side, tuple[int, ...], int | tuple[int, int], Vector]]:
    """The same vectors with their fields: (side, exponents of the multiplier, generator, vector).

    The generator is the number of a source field, that of a target coordinate, or for x^α f_i e_j the pair
    (i, j). With ``integral`` vectors are multiples that have integers as coefficients.
    """
    n = germ.n
    jet = _jet(germ, order + max(weights, default=1), weights)
    every = poly.monomials(n, order, weights)
    for i, (field, least) in enumerate(_fields(germ, group, version)):
        if weights:
            field = tuple(poly.weighted(c, n, weights) for c in field)
        image = along(jet, field, n, order, weights)
        if integral:
            image = _integral(image)
        for m in every:
            if _reaches(m, n, least):
                yield "source", poly.exponents_of(m, n), i, tuple(_shifted(f, m, n, order) for f in image)
    jet = _jet(germ, order, weights)
    if integral:
        jet = tuple(_integral((f,))[0] for f in jet)
    if group.target == "left":
        for beta, power in poly.powers(jet, n, order):
            if sum(beta) >= version:
                for j, vector in enumerate(_units(power, germ.p)):
                    yield "target", beta, j, vector
    elif group.target == "contact":
        least = max(0, version - 1)
        for i, f in enumerate(jet):
            for m in every:
                if _reaches(m, n, least):
                    for j, vector in enumerate(_units(_shifted(f, m, n, order), germ.p)):
                        yield "contact", poly.exponents_of(m, n), (i, j), vector


def _jet(germ: Germ, order: int, weights: tuple[int, ...]) -> Vector:
    """The components up to that degree, which counts the weights."""
    if not weights:
        return germ.jet(order)
    jet = germ.jet(min(order // min(weights), poly.LARGEST))
    return tuple(poly.cut(poly.weighted(f, germ.n, weights), germ.n, order) for f in jet)


def _integral(vector: Vector) -> Vector:
    """A multiple of a vector with integers as coefficients, which are quicker."""
    numbers = [c for f in vector for c in f.values()]
    if not all(isinstance(c, int | Fraction) for c in numbers):
        return vector  # coefficients of another ring
    common = lcm(*{c.denominator for c in numbers})
    return tuple({m: int(c * common) for m, c in f.items()} for f in vector)


def _reaches(m: int, n: int, least: int) -> bool:
    """Whether a monomial has that degree, without weights."""
    return least <= 0 or (m > 0 and (least == 1 or sum(poly.exponents_of(m, n)) >= least))


def _fields(germ: Germ, group: Group, version: Version) -> Iterator[tuple[Field, int]]:
    """(field, least degree of its multipliers): they span the fields of the module of order ≥ version."""
    n, generators = germ.n, group.generators(germ)
    if group.source != "own":  # the generators' leading terms are independent
        for field in generators:
            yield field, max(0, version - order_of(field, n))
        return
    low = [
        tuple(_shifted(c, m, n, poly.LARGEST) for c in field)
        for field in generators
        for m in poly.monomials(n, version - 1)
    ]
    for field in generators:
        yield field, version
    # combinations of the other multiples may vanish to that order too
    terms = sorted({(m, j) for field in low for j, c in enumerate(field) for m in c if _below(m, n, version)})
    conditions = [[exact(field[j].get(m, 0)) for field in low] for m, j in terms]
    for weights in null_space(conditions, len(low)):
        total: list[Polynomial] = [{} for _ in range(n)]
        for weight, field in zip(weights, low):
            total = [poly.plus(a, b, weight) if weight else a for a, b in zip(total, field)]
        yield tuple(total), 0


def _below(m: int, n: int, degree: int) -> bool:
    return poly.degree_of(m, n) < degree


def _shifted(f: Polynomial, m: int, n: int, order: int) -> Polynomial:
    top = order + 1 << poly.BITS * n
    return {m + k: c for k, c in f.items() if m + k < top}


def _units(f: Polynomial, p: int) -> Iterator[Vector]:
    if f:
        for j in range(p):
            yield tuple(f if i == j else {} for i in range(p))


def rows(vectors_: Iterable[Vector], space: JetSpace) -> list[dict[int, Any]]:
    """The vectors as rows; zero vectors are left out."""
    place = space.place()
    return [row for v in vectors_ if (row := space.row(v, place))]
