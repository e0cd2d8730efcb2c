"""O_n as a module over the functions of a target, for quasi-homogeneous germs, by matrices of polynomials.

If n components f₁, …, f_n have an isolated zero, O_n is free over ℂ{y₁, …, y_n} with the monomials of a basis
B of O/(f₁, …, f_n). For weights, multiplication by h is a matrix of polynomials in f of known weights, found
by linear algebra: h·b = Σ c·f^β·b′ with one weight on both sides. The Fitting ideals of O_n over the target
of a germ with p = n + 1 are those of y_p − M for the last component, whichever is taken; the determinant of
the multiplication by the Jacobian determinant is the equation of the discriminant for n = p.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from flint import fmpq

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.local_algebra import q_algebra
from osculant.cas.germs.loci import minors
from osculant.cas.germs.model import Model, polynomial, ring
from osculant.cas.germs.polynomials import LARGEST, Polynomial
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import independent_columns
from osculant.cas.germs.weights import Weights, weights

#: the rank of a module whose determinants are taken
RANK = 14
Matrix = list[list[Any]]


class Pushforward:
    """The module over the target's functions, for a quasi-homogeneous germ with p = n or n + 1.

    Raises DomainError for other dimensions and for a germ that is not quasi-homogeneous, or whose zero is not
    isolated; UndecidedError if that is not settled in time.

    >>> umbrella = Pushforward(Germ("x, y**2, x*y", "x y"))
    >>> print(umbrella.equation())
    y1^2*y2 - y3^2
    >>> print(Pushforward(Germ("x, x*y + y**3", "x y")).equation())
    4*y1^3 + 27*y2^2
    """

    def __init__(self, germ: Germ, patience: Patience | None = None) -> None:
        jet = germ.polynomial(LARGEST)
        found = None if jet is None else weights(germ)
        if jet is None or found is None:
            raise DomainError(f"{germ} is not quasi-homogeneous in these coordinates.")
        if germ.p not in (germ.n, germ.n + 1):
            raise DomainError(
                f"An image or discriminant has an equation for p = n or n + 1, not p = {germ.p}."
            )
        self.germ, self.jet, self.weights = germ, jet, found
        self.context = ring([f"y{j + 1}" for j in range(germ.p)])
        self.patience = patience or Patience()
        self.chosen = self._chosen()
        self.basis = self._basis()

    def _chosen(self) -> tuple[int, ...]:
        """The components over which O_n is free with the fewest generators."""
        n, p = self.germ.n, self.germ.p
        found: list[tuple[int, tuple[int, ...]]] = []
        for left_out in range(p) if p > n else (None,):
            chosen = tuple(j for j in range(p) if j != left_out)
            part = Germ([self.germ.components[j] for j in chosen], self.germ.source, None)
            try:
                found.append((q_algebra(part, self.patience).dimension, chosen))
            except DomainError:
                continue
        if not found:
            raise DomainError(f"The components of {self.germ} have no isolated common zero, {n} at a time.")
        return min(found)[1]

    def _basis(self) -> list[int]:
        """Monomials that are a basis of O modulo the chosen components."""
        n = self.germ.n
        order = 1
        while True:
            space = JetSpace(n, 1, order)
            place = space.place()
            rows = [
                row
                for j in self.chosen
                for m in space.monomials
                if (row := space.row((poly.times(self.jet[j], {m: 1}, n, order),), place))
            ]
            found = annihilator(rows, space.columns)
            depth = max((space.degree(c) for f in found.functionals for c in f), default=-1)
            if order > depth:
                return [space.monomials[c] for c in independent_columns(found.functionals)]
            order += max(1, order // 3)
            if self.patience.left() < 0:
                raise UndecidedError(f"A basis of the algebra of {self.germ} is not found in time.")

    def multiplication(self, h: Polynomial) -> Matrix:
        """The matrix of multiplication by a quasi-homogeneous polynomial, over the target's functions.

        >>> [[str(v) for v in row] for row in Pushforward(Germ("x, y**2, x*y", "x y")).multiplication(
        ...     {poly.monomial((0, 1)): 1}
        ... )]
        [['0', 'y2'], ['1', '0']]
        """
        columns = [self._column(poly.times(h, {b: 1}, self.germ.n, LARGEST)) for b in self.basis]
        return [[column[i] for column in columns] for i in range(len(self.basis))]

    def _column(self, product: Polynomial) -> list[Any]:
        """The coefficients of a polynomial by the basis, as polynomials in y."""
        zero = self.context.constant(0)
        found = [zero] * len(self.basis)
        if not product:
            return found
        weight = self._weight(next(iter(product)))
        unknowns = [
            (beta, i, poly.times(power, {b: 1}, self.germ.n, LARGEST))
            for i, b in enumerate(self.basis)
            for beta, power in self._powers(weight - self._weight(b))
        ]
        terms = sorted({m for *_, f in unknowns for m in f} | set(product))
        conditions = [
            [Fraction(f.get(m, 0)) for *_, f in unknowns] + [-Fraction(product.get(m, 0))] for m in terms
        ]
        solution = next(v for v in null_space(conditions, len(unknowns) + 1) if v[-1])
        for (beta, i, _), value in zip(unknowns, solution):
            if value:
                q = value / solution[-1]
                found[i] = found[i] + self.context.from_dict({beta: fmpq(q.numerator, q.denominator)})
        return found

    def _weight(self, m: int) -> int:
        exponents = poly.exponents_of(m, self.germ.n)
        return sum(w * e for w, e in zip(self.weights.source, exponents))

    def _powers(self, weight: int) -> Iterator[tuple[tuple[int, ...], Polynomial]]:
        """(β, f^β) for the chosen components, of that weight."""
        for exponents in _sums(weight, [self.weights.target[j] for j in self.chosen]):
            power: Polynomial = {0: 1}
            beta = [0] * self.germ.p
            for j, e in zip(self.chosen, exponents):
                beta[j] = e
                for _ in range(e):
                    power = poly.times(power, self.jet[j], self.germ.n, LARGEST)
            yield tuple(beta), power

    def presentation(self) -> Matrix:
        """The square matrix y_p − M whose minors are the Fitting ideals, p = n + 1.

        >>> len(Pushforward(Germ("x, y**3, x*y + y**5", "x y")).presentation())
        3
        """
        (left_out,) = set(range(self.germ.p)) - set(self.chosen)
        matrix = self.multiplication(self.jet[left_out])
        y = self.context.gens()[left_out]
        return [[(y if i == j else 0) - v for j, v in enumerate(row)] for i, row in enumerate(matrix)]

    def fitting(self, k: int) -> list[Any]:
        """Generators of the k-th Fitting ideal, p = n + 1: the target points with more than k preimages.

        Raises UndecidedError if there are too many minors.

        >>> Pushforward(Germ("x, y**2, x*y", "x y")).fitting(2) == []
        False
        """
        matrix = self.presentation()
        size = len(matrix) - k
        if size <= 0:
            return [self.context.constant(1)]
        if len(matrix) > RANK:
            raise UndecidedError(f"The module of {self.germ} has rank {len(matrix)}, more than {RANK}.")
        try:
            return minors(matrix, size, Model(self.context, self.germ.p, (), ()))
        except ValueError:
            raise UndecidedError(f"The Fitting ideal {k} of {self.germ} has too many minors.") from None

    def equation(self) -> Any:
        """The equation of the image (p = n + 1) or of the discriminant (n = p)."""
        if self.germ.p > self.germ.n:
            (found,) = self.fitting(0)
        else:
            n = self.germ.n
            source = ring(self.germ.source)
            rows = [[poly.derivative(f, i, n) for i in range(n)] for f in self.jet]
            whole = [[polynomial(c, source, n) for c in row] for row in rows]
            (jacobian,) = minors(whole, n, Model(source, n, (), ()))
            terms: Polynomial = {
                poly.monomial(tuple(map(int, m))): Fraction(int(c.p), int(c.q))
                for m, c in jacobian.to_dict().items()
            }
            if len(self.basis) > RANK:
                raise UndecidedError(
                    f"The module of {self.germ} has rank {len(self.basis)}, more than {RANK}."
                )
            (found,) = minors(self.multiplication(terms), len(self.basis), Model(self.context, n, (), ()))
        return primitive(found)


def primitive(f: Any) -> Any:
    """The multiple of a polynomial with integers without common factor, the leading one positive.

    >>> x, y = ring(["x", "y"]).gens()
    >>> print(primitive(-x / 2 + y / 3))
    3*x - 2*y
    """
    from math import gcd, lcm

    common = lcm(*(int(c.q) for c in f.coeffs()))
    content = gcd(*(int(c.p) * (common // int(c.q)) for c in f.coeffs()))
    return f * fmpq(common, content) * (-1 if f.leading_coefficient() < 0 else 1)


def _sums(total: int, parts: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """The exponents with Σ eᵢ·partᵢ = total."""
    if not parts:
        if total == 0:
            yield ()
        return
    if total < 0:
        return
    for e in range(total // parts[0] + 1 if parts[0] > 0 else 1):
        for rest in _sums(total - e * parts[0], parts[1:]):
            yield (e, *rest)


def known_weights(germ: Germ) -> Weights | None:
    """The weights of a germ that is polynomial and quasi-homogeneous; else None.

    >>> known_weights(Germ("exp(x) - 1", "x")) is None
    True
    """
    return None if germ.polynomial(LARGEST) is None else weights(germ)
