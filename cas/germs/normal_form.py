"""Coordinates in which a germ of corank 1 is (x, g(x, y)), by polynomials.

The multiple-point schemes of Marar and Mond are written in such coordinates. The change is linear in the
target; that of the source is found by solving fᵢ = Xᵢ for the first n − 1 coordinates by iteration: it is a
polynomial for germs such as (x + y², …), and where it is not there is none here.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.cas.germs import linear
from osculant.cas.germs.algebraic import Algebraic, rational
from osculant.cas.germs.model import Model

#: degree of the polynomials of a change at most
DEGREE = 12


@dataclass(frozen=True)
class NormalForm:
    """``target``·f∘``source`` = (x₁, …, x_{n−1}, g): the rows of a matrix, the old coordinates, g.

    >>> from osculant.cas.germs.germ import Germ
    >>> from osculant.cas.germs.model_reading import model_of
    >>> found = normal_form(model_of(Germ("x*y + y**3, x + y**2", "x y")))
    >>> [str(f) for f in found.source], [str(g) for g, _ in found.functions]
    (['-y^2 + x', 'y'], ['x*y'])
    """

    source: tuple[Any, ...]
    target: tuple[tuple[Any, ...], ...]
    functions: tuple[tuple[Any, Any], ...]


def normal_form(model: Model) -> NormalForm | None:
    """The normal form of a rational germ of rank n − 1 with n ≤ p, if such a change gives it; else None."""
    n, p = model.n, len(model.components)
    if model.rules or p < n:
        return None
    rows = [_linear(f, b, model) for f, b in model.components]
    echelon, target = _reduced(rows, n)
    if sum(any(row) for row in echelon) != n - 1:
        return None
    leading, kernel = _leading(echelon, n)
    moved: list[tuple[Any, Any]] = []
    for row in target:
        parts = [(f * model.number(c), b) for c, (f, b) in zip(row, model.components) if c]
        if any(not b.is_constant() for _, b in parts) and len(moved) < n - 1:
            return None
        moved.append(_sum(parts, model))
    first = [model.reduced(a / b.leading_coefficient()) for a, b in moved[: n - 1]]
    source = _solved(first, leading, kernel, model)
    if source is None:
        return None
    context, images = model.context, (*source, *model.constants)
    functions = tuple(
        (a.compose(*images, ctx=context), b.compose(*images, ctx=context)) for a, b in moved[n - 1 :]
    )
    numbers = (tuple(c if isinstance(c, Algebraic) else rational(c) for c in row) for row in target)
    return NormalForm(tuple(source), tuple(numbers), functions)


def truncated_form(model: Model, order: int) -> tuple[Any, ...]:
    """The functions g of a polynomial germ in its normal form (x, g), cut above degree ``order``.

    Here the change of coordinates is a power series, known to that order. For germs of rank n − 1, n ≤ p.

    >>> from osculant.cas.germs.germ import Germ
    >>> from osculant.cas.germs.model_reading import model_of
    >>> [str(g) for g in truncated_form(model_of(Germ("x + x**2, x*y + y**3", "x y")), 3)]
    ['-x^2*y + y^3 + x*y']
    """
    n = model.n
    linear = [_linear(f, b, model) for f, b in model.components]
    echelon, target = _reduced(linear, n)
    leading, kernel = _leading(echelon, n)
    moved = [
        _sum([(f * model.number(c), b) for c, (f, b) in zip(row, model.components)], model)[0]
        for row in target
    ]
    source = _solved(moved[: n - 1], leading, kernel, model, order)
    assert source is not None
    return tuple(_cut(f.compose(*source, ctx=model.context), order) for f in moved[n - 1 :])


def _cut(f: Any, order: int) -> Any:
    """The terms of degree at most ``order``."""
    kept = {m: c for m, c in f.to_dict().items() if sum(map(int, m)) <= order}
    return f.context().from_dict(kept)


def _leading(echelon: list[list[Any]], n: int) -> tuple[list[int], int]:
    """The leading columns of an echelon form of rank n − 1, and the one that is none."""
    leading = [next(j for j in range(n) if row[j]) for row in echelon[: n - 1]]
    return leading, next(j for j in range(n) if j not in leading)


def _linear(f: Any, denominator: Any, model: Model) -> list[Any]:
    """The derivatives at the origin."""
    below = model.at_origin(denominator)
    axes = [tuple(int(i == j) for i in range(model.n)) for j in range(model.n)]
    return [model.at_origin(f, axis) / below for axis in axes]


def _sum(parts: list[tuple[Any, Any]], model: Model) -> tuple[Any, Any]:
    above, below = model.zero, model.one
    for a, b in parts:
        above, below = (above + a, below) if b == below else (above * b + a * below, below * b)
    return above, below


def _reduced(rows: list[list[Any]], n: int) -> tuple[list[list[Any]], list[list[Any]]]:
    """(echelon form, the matrix that makes it from the rows)."""
    p = len(rows)
    both = [[*row, *(Fraction(int(i == j)) for j in range(p))] for i, row in enumerate(rows)]
    whole, _ = linear.echelon(both, n + p)
    return [row[:n] for row in whole], [row[n:] for row in whole]


def _solved(
    first: list[Any], leading: list[int], kernel: int, model: Model, order: int | None = None
) -> list[Any] | None:
    """The old coordinates as polynomials in X₁, …, X_{n−1}, the first variables, and y, the last.

    With an order they are cut above it; without, None if they are no polynomials of small degree.
    """
    n, gens, context = model.n, model.variables, model.context
    start = [context.constant(0)] * n
    for i, j in enumerate(leading):
        start[j] = gens[i]
    start[kernel] = gens[n - 1]
    # fᵢ = x_{leading i} + (kernel part) + higher: the remainder is pushed to the other side
    rest = [f - gens[j] for f, j in zip(first, leading)]
    found = list(start)
    for _ in range(n + 2 if order is None else order + 1):
        following = list(start)
        for i, j in enumerate(leading):
            following[j] = model.reduced(gens[i] - rest[i].compose(*found, *model.constants, ctx=context))
            if order is not None:
                following[j] = _cut(following[j], order)
            elif following[j].total_degree() > DEGREE:
                return None
        if following == found:
            return found
        found = following
    return None if order is None else found
