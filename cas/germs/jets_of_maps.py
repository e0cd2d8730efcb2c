"""Jets of maps (Kᵐ,0) → (Kⁿ,0) over ℚ: composition, inverses, flows of vector fields, exactly.

A polynomial is kept as its homogeneous parts, each of flint's ring: the product up to degree k is Σ
aᵢb_{d−i}, so that no term above k is ever made.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import fmpq, fmpq_mat

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.model import polynomial, ring

#: the homogeneous parts of degrees 0, …, k
Parts = tuple[Any, ...]


@dataclass(frozen=True)
class MapJet:
    """The jet of order k of a map that keeps the origin, or of a vector field.

    Attributes:
        order: k.
        components: the parts of every component; all of one ring, that of the source.

    >>> x, y = poly.variable(0, 2), poly.variable(1, 2)
    >>> shear = map_jet([{x: 1, 2 * y: 1}, {y: 1}], 2, 3)
    >>> shear.compose(shear.inverse()).polynomials() == ({x: 1}, {y: 1})
    True
    """

    order: int
    components: tuple[Parts, ...]

    @property
    def context(self) -> Any:
        """The ring of the source variables."""
        return self.components[0][0].context()

    @property
    def source(self) -> int:
        """The number of variables."""
        return int(self.context.nvars())

    def polynomials(self) -> tuple[poly.Polynomial, ...]:
        """The components as polynomials of this room."""
        found = []
        for parts in self.components:
            terms: poly.Polynomial = {}
            for part in parts:
                for m, c in part.to_dict().items():
                    value = Fraction(int(c.p), int(c.q))
                    terms[poly.monomial(tuple(map(int, m)))] = int(value) if value.denominator == 1 else value
            found.append(terms)
        return tuple(found)

    def compose(self, inner: MapJet) -> MapJet:
        """This map after another one; raises DomainError if their dimensions or orders do not fit."""
        if self.source != len(inner.components) or self.order != inner.order:
            raise DomainError(
                f"A jet of {self.source} variables and order {self.order} is not composed with one of "
                f"{len(inner.components)} components and order {inner.order}."
            )
        return MapJet(self.order, tuple(_substituted(f, inner) for f in self.components))

    def powers(self) -> Iterator[tuple[tuple[int, ...], Parts]]:
        """(β, f^β) for every β ≠ 0 with f^β not zero up to the order; no component has a constant term.

        >>> square = map_jet([{poly.monomial((2,)): 1}], 1, 5)
        >>> [beta for beta, _ in square.powers()]
        [(1,), (2,)]
        """
        p = len(self.components)
        units = [tuple(int(i == j) for i in range(p)) for j in range(p)]
        level = {unit: f for unit, f in zip(units, self.components) if any(not q.is_zero() for q in f)}
        while level:
            yield from level.items()
            following = {}
            for beta, value in level.items():
                for i in range(max(i for i, e in enumerate(beta) if e), p):
                    product = times(value, self.components[i], self.order)
                    if any(not part.is_zero() for part in product):
                        following[(*beta[:i], beta[i] + 1, *beta[i + 1 :])] = product
            level = following

    def linear_part(self) -> fmpq_mat:
        """The matrix of the derivative at the origin."""
        n = self.source
        axes = [tuple(int(i == j) for j in range(n)) for i in range(n)]
        rows = [[f[1].to_dict().get(axis, fmpq(0)) for axis in axes] for f in self.components]
        return fmpq_mat(len(rows), n, [v for row in rows for v in row])

    def inverse(self) -> MapJet:
        """The inverse map; raises DomainError if the derivative at the origin is not invertible."""
        n, matrix = self.source, self.linear_part()
        if matrix.nrows() != n or matrix.det() == 0:
            raise DomainError("The derivative of the jet at the origin is not invertible.")
        back, gens = matrix.inv(), self.context.gens()
        zero = self.context.constant(0)

        def linear(vector: Sequence[Parts]) -> list[Parts]:
            return [
                tuple(
                    sum((part * back[i, j] for j, part in enumerate(parts) if not part.is_zero()), zero)
                    for parts in zip(*vector)
                )
                for i in range(n)
            ]

        identity = [_parts(g, self.order) for g in gens]
        higher = MapJet(self.order, tuple((zero, zero, *f[2:]) for f in self.components))
        found = MapJet(self.order, tuple(linear(identity)))
        for _ in range(self.order - 1):  # each step is right in one degree more
            rest = higher.compose(found)
            moved = [plus(a, b, -1) for a, b in zip(identity, rest.components)]
            found = MapJet(self.order, tuple(linear(moved)))
        return found

    def flow(self, f: MapJet) -> MapJet:
        """f after the flow of this vector field at time 1, by the Lie series Σ Xʲf/j!.

        The field must vanish at the origin, its linear part be nilpotent (the series is finite then); raises
        DomainError else, or if dimensions do not fit.
        """
        n = self.source
        if len(self.components) != n or f.source != n or f.order != self.order:
            raise DomainError("A vector field flows in the source of a jet of the same order.")
        matrix = self.linear_part()
        if any(not g[0].is_zero() for g in self.components) or _power(matrix, n) != matrix * fmpq(0):
            raise DomainError("The flow of a field is a jet over ℚ only if its linear part is nilpotent.")
        found = []
        for parts in f.components:
            total, term, j = parts, self._along(parts), 1
            while any(not part.is_zero() for part in term):
                term = tuple(part / fmpq(j) for part in term)
                total, term, j = plus(total, term), self._along(term), j + 1
            found.append(total)
        return MapJet(self.order, tuple(found))

    def _along(self, parts: Parts) -> Parts:
        """The derivative of a function along this vector field."""
        zero = self.context.constant(0)
        total = (zero,) * (self.order + 1)
        for i, coefficient in enumerate(self.components):
            slopes = (*(part.derivative(i) for part in parts[1:]), zero)
            total = plus(total, times(coefficient, slopes, self.order))
        return total


def map_jet(components: Sequence[poly.Polynomial], n: int, order: int) -> MapJet:
    """The jet of that order of polynomials in n variables without constant terms.

    Raises DomainError for a constant term, and for no component or an order below 1.
    """
    if not components or order < 1:
        raise DomainError("A jet of a map has components, and an order of at least 1.")
    if any(f.get(0) for f in components):
        raise DomainError("A jet of a map that does not keep the origin: subtract the constants.")
    context = ring([f"x{i + 1}" for i in range(n)])
    cut = [polynomial(poly.cut(f, n, order), context, n) for f in components]
    return MapJet(order, tuple(_parts(f, order) for f in cut))


def _parts(f: Any, order: int) -> Parts:
    found: list[dict[Any, Any]] = [{} for _ in range(order + 1)]
    for m, c in f.to_dict().items():
        if sum(m) <= order:
            found[int(sum(m))][m] = c
    return tuple(f.context().from_dict(part) for part in found)


def plus(a: Parts, b: Parts, factor: int = 1) -> Parts:
    """a + factor·b."""
    return tuple(x + y * factor if not y.is_zero() else x for x, y in zip(a, b))


def times(a: Parts, b: Parts, order: int) -> Parts:
    """The product up to that degree."""
    zero = a[0].context().constant(0)
    found = [zero] * (order + 1)
    for i, x in enumerate(a):
        if not x.is_zero():
            for j in range(order + 1 - i):
                if not b[j].is_zero():
                    found[i + j] = found[i + j] + x * b[j]
    return tuple(found)


def _power(matrix: fmpq_mat, e: int) -> fmpq_mat:
    found = matrix
    for _ in range(e - 1):
        found = found * matrix
    return found


def _substituted(f: Parts, inner: MapJet) -> Parts:
    """f(inner), the powers of the components made once."""
    order, context = inner.order, inner.context
    one = _parts(context.constant(1), order)
    known: dict[tuple[int, ...], Parts] = {(0,) * len(inner.components): one}

    def power(m: tuple[int, ...]) -> Parts:
        if m not in known:
            i = next(i for i, e in enumerate(m) if e)
            known[m] = times(power((*m[:i], m[i] - 1, *m[i + 1 :])), inner.components[i], order)
        return known[m]

    total: Parts = (context.constant(0),) * (order + 1)
    for part in f:
        for m, c in part.to_dict().items():
            total = tuple(
                x + y * c if not y.is_zero() else x for x, y in zip(total, power(tuple(map(int, m))))
            )
    return total
