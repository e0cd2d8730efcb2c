"""Local algebras of a germ: Milnor and Tjurina numbers, Q-algebra, multiplicity, ramification."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.codimension import COLUMNS, ORDER
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.tangent import JetSpace


@dataclass(frozen=True)
class LocalAlgebra:
    """O/I: its dimension, and its Hilbert function dim (Mⁱ + I)/(Mⁱ⁺¹ + I) for all i ≥ 0."""

    dimension: int
    hilbert: tuple[int, ...]


def local_algebra(generators: Callable[[int], Sequence[Polynomial]], n: int, what: str) -> LocalAlgebra:
    """The algebra of power series in n variables modulo an ideal, exactly (Nakayama).

    Args:
        generators: generators(k) are the generators of the ideal, cut above degree k.
        n: the number of variables.
        what: the name of the algebra, for the error.

    Raises UndecidedError if the dimension does not settle within the caps: it may be infinite.

    >>> x = poly.variable(0, 2); y = poly.variable(1, 2)
    >>> local_algebra(lambda k: [{2 * x: 1}, {3 * y: 1}], 2, "example").hilbert
    (1, 2, 2, 1)
    """
    for order in range(ORDER + 1):
        space = JetSpace(n, 1, order)
        if space.columns > COLUMNS:
            break
        place = space.place()
        spanning = []
        for f in generators(order):
            for m in poly.monomials(n, order):
                row = space.row((poly.times(f, {m: 1}, n, order),), place)
                if row:
                    spanning.append(row)
        found = annihilator(spanning, space.columns)
        depth = max((space.degree(c) for f in found.functionals for c in f), default=-1)
        if order > depth:
            return LocalAlgebra(found.codimension, _hilbert(spanning, n, depth))
    raise UndecidedError(
        f"The dimension of the {what} does not settle in jets of order {order}: it may be infinite."
    )


def _hilbert(spanning: Sequence[dict[int, int]], n: int, depth: int) -> tuple[int, ...]:
    dimensions = [0]
    for degree in range(depth + 1):
        columns = JetSpace(n, 1, degree).columns  # columns are sorted by degree
        cut = [short for row in spanning if (short := {c: v for c, v in row.items() if c < columns})]
        dimensions.append(annihilator(cut, columns).codimension)
    return tuple(b - a for a, b in pairwise(dimensions))


def milnor_number(germ: Germ) -> int:
    """dim O/(∂f/∂x₁, …, ∂f/∂xₙ) of a function.

    Raises DomainError for p > 1, UndecidedError if the singularity may not be isolated.

    >>> milnor_number(Germ("x**3 + y**4", "x y"))
    6
    """
    if germ.p != 1:
        raise DomainError(f"The Milnor number is that of a function; this germ has {germ.p} components.")

    def gradient(order: int) -> list[Polynomial]:
        f = germ.jet(order + 1)[0]
        return [poly.derivative(f, i, germ.n) for i in range(germ.n)]

    return local_algebra(gradient, germ.n, "Milnor algebra").dimension


def q_algebra(germ: Germ) -> LocalAlgebra:
    """Q(f) = O/(f₁, …, fₚ), with its Hilbert function; its dimension is the multiplicity of f.

    >>> q_algebra(Germ("x**2, y**2, x*y", "x y"))
    LocalAlgebra(dimension=3, hilbert=(1, 2))
    """
    return local_algebra(germ.jet, germ.n, "Q-algebra")


def multiplicity(germ: Germ) -> int:
    """dim Q(f)."""
    return q_algebra(germ).dimension


def ramification(germ: Germ) -> LocalAlgebra:
    """O/R with R the ideal of the largest minors of df: where f is no immersion (n ≤ p) or submersion.

    >>> ramification(Germ("x, y**2, x*y", "x y")).dimension
    1
    """
    n, p = germ.n, germ.p
    size = min(n, p)

    def minors(order: int) -> list[Polynomial]:
        matrix = [[poly.derivative(f, i, n) for i in range(n)] for f in germ.jet(order + 1)]
        return [
            _determinant([[matrix[j][i] for i in columns] for j in rows], n, order)
            for rows in combinations(range(p), size)
            for columns in combinations(range(n), size)
        ]

    return local_algebra(minors, n, "ramification algebra")


def _determinant(matrix: Sequence[Sequence[Polynomial]], n: int, order: int) -> Polynomial:
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
