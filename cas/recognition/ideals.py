"""Ideals of a germ that do not depend on coordinates, by their generators in jets.

A set of functions in more variables, with squares of the others added, has the same quotients O/I by each of
them: what is told of a function is told of all that are stably equivalent to it.
"""

from __future__ import annotations

from itertools import combinations

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import exact
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import rank
from osculant.cas.germs.local_algebra import determinant
from osculant.cas.germs.polynomials import Polynomial


def algebra(germ: Germ, order: int) -> list[Polynomial]:
    """The components: O/I is the local algebra of the germ."""
    return list(germ.jet(order))


def gradient(germ: Germ, order: int) -> list[Polynomial]:
    """The derivatives of a function.

    >>> gradient(Germ("x**3", "x"), 2) == [{2 * poly.variable(0, 1): 3}]
    True
    """
    (f,) = germ.jet(order + 1)
    return [poly.derivative(f, i, germ.n) for i in range(germ.n)]


def tjurina(germ: Germ, order: int) -> list[Polynomial]:
    """A function and its derivatives."""
    return [*germ.jet(order), *gradient(germ, order)]


def ramification(germ: Germ, order: int) -> list[Polynomial]:
    """The largest minors of df.

    >>> ramification(Germ("x, y**2", "x y"), 1) == [{poly.variable(1, 2): 2}]
    True
    """
    n, size = germ.n, min(germ.n, germ.p)
    matrix = [[poly.derivative(f, i, n) for i in range(n)] for f in germ.jet(order + 1)]
    return [
        determinant([[matrix[j][i] for i in columns] for j in rows], n, order)
        for rows in combinations(range(germ.p), size)
        for columns in combinations(range(n), size)
    ]


def singular(germ: Germ, order: int) -> list[Polynomial]:
    """The components and the largest minors of df: where the zeros of the germ are singular."""
    return [*germ.jet(order), *ramification(germ, order)]


def branching(germ: Germ, order: int) -> list[Polynomial]:
    """The largest minors of df, and the minors of size |n − p| + 1 of their own derivatives.

    For a stable germ the zeros of the former are smooth of that codimension where they have rank 1 less than
    the largest; the latter are 0 where they are not.

    >>> len(branching(Germ("x, y**3 + x**2*y", "x y"), 3))
    3
    """
    n, size = germ.n, abs(germ.n - germ.p) + 1
    found = [f for f in ramification(germ, order + 1) if f]
    matrix = [[poly.derivative(f, i, n) for i in range(n)] for f in found]
    return [poly.cut(f, n, order) for f in found] + [
        determinant([[matrix[j][i] for i in columns] for j in rows], n, order)
        for rows in combinations(range(len(found)), size)
        for columns in combinations(range(n), size)
    ]


def hessian(germ: Germ, order: int, excess: int) -> list[Polynomial]:
    """The derivatives of a function and the minors of its Hessian matrix of size n − corank + excess.

    The Hessian form is a tensor modulo the derivatives.

    >>> len(hessian(Germ("x**3 + y**3", "x y"), 2, 2))
    3
    """
    n, slopes = germ.n, gradient(germ, order + 1)
    matrix = [[poly.derivative(slope, i, n) for i in range(n)] for slope in slopes]
    size = n - corank(germ) + excess
    found = [poly.cut(slope, n, order) for slope in slopes]
    return found + [
        determinant([[matrix[j][i] for i in columns] for j in rows], n, order)
        for rows in combinations(range(n), size)
        for columns in combinations(range(n), size)
        if rows <= columns  # symmetric
    ]


def corank(germ: Germ) -> int:
    """The corank of the second derivative of a function at 0.

    >>> corank(Germ("x**2 + y**3", "x y"))
    1
    """
    n, slopes = germ.n, gradient(germ, 1)
    return n - rank([[exact(s.get(poly.variable(i, n), 0)) for i in range(n)] for s in slopes], n)


def on_boundary(germ: Germ, order: int) -> Germ | None:
    """The jet of the germ on H, in the other variables; None if there is no other variable.

    >>> print(on_boundary(Germ("x**2 + u*x + u", "x u"), 2))
    (x**2)
    """
    place, n = germ.boundary_index, germ.n
    if n == 1:
        return None
    components = []
    for f in germ.jet(order):
        kept = {}
        for m, c in f.items():
            powers = poly.exponents_of(m, n)
            if not powers[place]:
                kept[poly.monomial((*powers[:place], *powers[place + 1 :]))] = c
        components.append(kept)
    source = (*germ.source[:place], *germ.source[place + 1 :])
    return Germ([as_node(f, source, germ.field) for f in components], source, None, germ.field)
