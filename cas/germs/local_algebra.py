"""Local algebras of a germ: Milnor and Tjurina numbers, Q-algebra, multiplicity, ramification."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import Any

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import NumberField
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.geometry import Geometry
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import GROUPS
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.search import Patience, Search
from osculant.cas.germs.tangent import JetSpace


@dataclass(frozen=True)
class LocalAlgebra:
    """O/I: its dimension, and its Hilbert function dim (Mⁱ + I)/(Mⁱ⁺¹ + I) for all i ≥ 0."""

    dimension: int
    hilbert: tuple[int, ...]


def local_algebra(
    generators: Callable[[int], Sequence[Polynomial]],
    n: int,
    what: str,
    geometry: Geometry | None = None,
    patience: Patience | None = None,
    field: NumberField | None = None,
) -> LocalAlgebra | None:
    """The algebra of power series in n variables modulo an ideal, exactly (Nakayama).

    Args:
        generators: generators(k) are the generators of the ideal, cut above degree k.
        n: the number of variables.
        what: the name of the algebra, for the error.
        geometry: looks for a proof that the dimension is infinite.
        patience: the time that it may take.
        field: of the coefficients, if they are not rational.

    Returns the algebra, or None if its dimension is proved to be infinite. Raises UndecidedError if the
    dimension does not settle in time: it may be infinite.

    >>> x = poly.variable(0, 2); y = poly.variable(1, 2)
    >>> local_algebra(lambda k: [{2 * x: 1}, {3 * y: 1}], 2, "example").hilbert
    (1, 2, 2, 1)
    """
    patience = patience or Patience()
    search = Search(n, 1, geometry, patience)
    for order in search.orders():
        space = JetSpace(n, 1, order)
        spanning = multiples(generators(order), space)
        found = annihilator(spanning, space.columns, field)
        depth = max((space.degree(c) for f in found.functionals for c in f), default=-1)
        if order > depth:
            return LocalAlgebra(found.codimension, _hilbert(spanning, n, depth, field))
        if search.grown(found.codimension):
            return None
    if geometry is not None and patience.wait(geometry) is not None:
        return None
    raise UndecidedError(
        f"The dimension of the {what} does not settle in jets of order {search.order}: it may be infinite."
    )


def multiples(generators: Sequence[Polynomial], space: JetSpace) -> list[dict[int, Any]]:
    """Rows of jets that span an ideal modulo those of higher order: its generators times all monomials.

    >>> multiples([{poly.variable(0, 1): 1}], JetSpace(1, 1, 2))
    [{1: 1}, {2: 1}]
    """
    n, place = space.n, space.place()
    products = (
        poly.times(f, {m: 1}, n, space.order) for f in generators for m in poly.monomials(n, space.order)
    )
    return [row for product in products if (row := space.row((product,), place))]


def _hilbert(
    spanning: Sequence[dict[int, Any]], n: int, depth: int, field: NumberField | None
) -> tuple[int, ...]:
    dimensions = [0]
    for degree in range(depth + 1):
        columns = JetSpace(n, 1, degree).columns  # columns are sorted by degree
        cut = [short for row in spanning if (short := {c: v for c, v in row.items() if c < columns})]
        dimensions.append(annihilator(cut, columns, field).codimension)
    return tuple(b - a for a, b in pairwise(dimensions))


def milnor_number(germ: Germ, patience: Patience | None = None) -> int:
    """dim O/(∂f/∂x₁, …, ∂f/∂xₙ) of a function.

    Raises DomainError for p > 1 and if the singularity is not isolated, UndecidedError if it may not be.

    >>> milnor_number(Germ("x**3 + y**4", "x y"))
    6
    """
    if germ.p != 1:
        raise DomainError(f"The Milnor number is that of a function; this germ has {germ.p} components.")

    def gradient(order: int) -> list[Polynomial]:
        f = germ.jet(order + 1)[0]
        return [poly.derivative(f, i, germ.n) for i in range(germ.n)]

    found = _decided(gradient, germ, "Milnor algebra", "R", patience)
    if found is None:
        raise DomainError(f"The Milnor number of {germ} is infinite: its critical point is not isolated.")
    return found.dimension


def q_algebra(germ: Germ, patience: Patience | None = None, what: str = "Q-algebra") -> LocalAlgebra:
    """Q(f) = O/(f₁, …, fₚ), with its Hilbert function; its dimension is the multiplicity of f.

    ``what`` is its name in errors.

    Raises DomainError if it is infinite, UndecidedError if it may be.

    >>> q_algebra(Germ("x**2, y**2, x*y", "x y"))
    LocalAlgebra(dimension=3, hilbert=(1, 2))
    """
    found = _decided(germ.jet, germ, what, "C", patience)
    if found is None:
        raise DomainError(f"The {what} of {germ} is infinite.")
    return found


def _decided(
    generators: Callable[[int], Sequence[Polynomial]],
    germ: Germ,
    what: str,
    group: str,
    patience: Patience | None,
) -> LocalAlgebra | None:
    """The algebra; None if its dimension is infinite, as that of a tangent space of the group then is."""
    geometry = Geometry(germ, GROUPS[group])
    try:
        return local_algebra(generators, germ.n, what, geometry, patience, germ.field)
    finally:
        geometry.stop()


def multiplicity(germ: Germ) -> int:
    """dim Q(f); errors as for `q_algebra`."""
    return q_algebra(germ).dimension


def ramification(germ: Germ, patience: Patience | None = None) -> LocalAlgebra:
    """O/R with R the ideal of the largest minors of df: where f is no immersion (n ≤ p) or submersion.

    Raises DomainError if its dimension is infinite, UndecidedError if it may be.

    >>> ramification(Germ("x, y**2, x*y", "x y")).dimension
    1
    """
    n, p = germ.n, germ.p
    size = min(n, p)

    def minors(order: int) -> list[Polynomial]:
        matrix = [[poly.derivative(f, i, n) for i in range(n)] for f in germ.jet(order + 1)]
        return [
            determinant([[matrix[j][i] for i in columns] for j in rows], n, order)
            for rows in combinations(range(p), size)
            for columns in combinations(range(n), size)
        ]

    # for n ≥ p the minors are what R has no tangent vectors off, for n < p a locus of L
    geometry = Geometry(germ, GROUPS["R" if n >= p else "L"], ("module" if n >= p else "rank",))
    try:
        found = local_algebra(minors, n, "ramification algebra", geometry, patience, germ.field)
    finally:
        geometry.stop()
    if found is None:
        raise DomainError(f"The ramification algebra of {germ} is infinite.")
    return found


def determinant(matrix: Sequence[Sequence[Polynomial]], n: int, order: int) -> Polynomial:
    """By expansion along one row after the other; minors are known by the set of their columns."""
    known: dict[int, Polynomial] = {0: {0: 1}}
    for row in matrix:
        larger: dict[int, Polynomial] = {}
        for columns, minor in known.items():
            for j, entry in enumerate(row):
                if entry and not columns >> j & 1:
                    sign = (-1) ** (columns >> j).bit_count()
                    both = columns | 1 << j
                    product = poly.times(minor, entry, n, order)
                    larger[both] = poly.plus(larger.get(both, {}), product, sign)
        known = {columns: minor for columns, minor in larger.items() if minor}
    return known.get((1 << len(matrix)) - 1, {})
