"""The splitting lemma on jets: a function with critical point 0 as a function of few variables plus squares.

In suitable coordinates f = g(x₁, …, x_c) + Σ dᵢzᵢ² + terms in the square of the ideal (z), with c the corank
of the Hessian. The coordinates are a linear change, that takes the kernel of the Hessian to the x-space and
makes it diagonal, and a shift z ↦ z + h(x) by the critical point over x. If a boundary u = 0 is to be kept, u
is one more parameter: the Hessian is that of f on H, and g and h are functions of x and u.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import rational
from osculant.cas.germs.jets_of_maps import MapJet, map_jet
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.recognition.quadratic import diagonalised

Matrix = list[list[Fraction]]


@dataclass(frozen=True)
class Splitting:
    """f∘φ = g(x) + Σ dᵢzᵢ² + …, among the variables other than u the x's first, then those with dᵢ > 0.

    Attributes:
        corank: how many x's there are.
        change: φ.
        rest: g, in all n variables.
    """

    corank: int
    change: MapJet
    rest: Polynomial


def splitting(f: Polynomial, n: int, order: int, boundary: int | None = None) -> Splitting:
    """The splitting of a function, on H without linear terms, on jets of that order.

    >>> x, y = poly.variable(0, 2), poly.variable(1, 2)
    >>> found = splitting({2 * y: 1, y + 2 * x: 2, 3 * y: 1}, 2, 4)  # y² + 2x²y + y³
    >>> found.corank, found.rest == {4 * x: -1}
    (1, True)
    """
    own = [i for i in range(n) if i != boundary]
    form = hessian(f, n)
    corank, inner = diagonal_basis([[form[i][j] for j in own] for i in own])
    matrix = [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]
    for i, row in zip(own, inner):
        for j, value in zip(own, row):
            matrix[i][j] = value
    change = linear_jet(matrix, order)
    jet = map_jet([f], n, order).compose(change)
    terms, squares = jet.polynomials()[0], own[corank:]
    over: list[Polynomial] = [{} for _ in squares]
    images: list[Polynomial] = [{poly.variable(i, n): 1} for i in range(n)]
    if squares:
        halves = [Fraction(-1, 2) / terms[2 * poly.variable(i, n)] for i in squares]
        slopes = map_jet([poly.derivative(terms, i, n) for i in squares], n, order)
        for _ in range(order - 1):  # each step is right in one degree more
            for i, h in zip(squares, over):
                images[i] = h
            values = slopes.compose(map_jet(images, n, order)).polynomials()
            over = [poly.plus(h, v, half) for h, v, half in zip(over, values, halves)]
        for i, h in zip(squares, over):
            images[i] = poly.plus(h, {poly.variable(i, n): 1})
    shift = map_jet(images, n, order)
    moved = jet.compose(shift).polynomials()[0]
    rest = {m: c for m, c in moved.items() if not any(poly.exponents_of(m, n)[i] for i in squares)}
    return Splitting(corank, change.compose(shift), rest)


def hessian(f: Polynomial, n: int) -> Matrix:
    """The symmetric matrix H of the quadratic part xᵀHx."""
    found = [[Fraction(0)] * n for _ in range(n)]
    for i in range(n):
        for j in range(n):
            c = Fraction(f.get(poly.variable(i, n) + poly.variable(j, n), 0))
            found[i][j] = c if i == j else c / 2
    return found


def diagonal_basis(form: Matrix) -> tuple[int, Matrix]:
    """(corank, P): the columns of P are a basis in which a symmetric matrix is diagonal.

    The kernel comes first, negative squares last.

    >>> diagonal_basis([[Fraction(0), Fraction(-1)], [Fraction(-1), Fraction(0)]])[1]
    [[Fraction(-1, 2), Fraction(1, 1)], [Fraction(1, 2), Fraction(1, 1)]]
    """
    change, values = diagonalised([[rational(v) for v in row] for row in form])
    order = sorted(range(len(form)), key=lambda i: (values[i] != 0, values[i] < 0))
    found = [[Fraction(int(row[i].p), int(row[i].q)) for i in order] for row in change]
    return sum(v == 0 for v in values), found


def linear_jet(matrix: Sequence[Sequence[Fraction]], order: int) -> MapJet:
    """The linear map with these rows as a jet."""
    n = len(matrix[0])
    rows = [{poly.variable(j, n): c for j, c in enumerate(row) if c} for row in matrix]
    return map_jet(rows, n, order)
