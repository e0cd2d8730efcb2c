"""Tools for rows of Table 6.1: generic surfaces over a projection, and what tells stable germs apart."""

from __future__ import annotations

from collections.abc import Hashable
from fractions import Fraction
from random import Random
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_6.germ_signs import signature
from osculant.cas.formulas.expression import ZERO, number, variable
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import exact
from osculant.cas.germs.entry import Entry
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Version, group
from osculant.cas.germs.immersions import Immersion
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.reference import reference
from osculant.cas.germs.secants import Secant, secant
from osculant.cas.germs.tangent_space import tangent
from osculant.cas.germs.unfolding import is_stable

#: rows of the table as corrected that the thesis does not have
MISSING = {"4-P_3", "5-7"}
#: the secant germs depend on (p, w): strata of codimension at most 3 occur
DIMENSION = 3
#: the degree of a random diffeomorphism and its coefficients
DEGREE, COEFFICIENTS = 3, tuple(c for c in range(-9, 10) if c)
#: surfaces that are tried until one is generic
TRIED = 5
#: orders of jets whose orbits are compared: over the complex numbers they tell the classes of Table 6.2 apart
ORDERS = range(1, 5)


def rows_of(n: int) -> list[Entry]:
    """The rows of the table as printed, for surfaces in Rⁿ.

    >>> [row.projection for row in rows_of(8)]
    ['y, x**2, x*y, x**3, 0, 0, 0']
    """
    return [e for e in reference("table 6.1").entries if e.id.startswith(f"{n}-") and e.id not in MISSING]


def surface(projection: Germ, order: int, seed: str) -> Immersion:
    """The jet of that order of X = (x, Φ∘π), Φ a random diffeomorphism, at 0 in the direction (1, 0).

    >>> surface(Germ("y, x**2", "x y"), 2, "1").projection.jet(1)[0] == {poly.variable(1, 2): 1}
    True
    """
    chance = Random(seed)
    jet = projection.jet(order)
    components: list[Polynomial] = []
    for i in range(projection.p):
        phi: Polynomial = {m: chance.choice(COEFFICIENTS) for m in poly.monomials(projection.p, DEGREE) if m}
        for j in range(i, projection.p):  # the derivative is unipotent
            phi[poly.variable(j, projection.p)] = int(i == j)
        total: Polynomial = {}
        for m, c in phi.items():
            term: Polynomial = {0: c}
            for g, e in zip(jet, poly.exponents_of(m, projection.p)):
                for _ in range(e):
                    term = poly.times(term, g, 2, order)
            total = poly.plus(total, term)
        components.append(total)
    nodes = [as_node(f, ("x", "y")) for f in components]
    return Immersion([variable("x"), *nodes], ("x", "y"), [ZERO] * 2, [number(1), ZERO])


def generic_secant(projection: Germ, order: int) -> Secant | None:
    """The secant germ, by jets of that order, of a surface over a projection that makes it stable.

    None if none of `TRIED` surfaces does; with most Φ it is stable or never.

    >>> found = generic_secant(Germ("y, x**2", "x y"), 1)
    >>> found is not None and found.germ.rank
    2
    """
    for seed in range(TRIED):
        found = secant(surface(projection, 2 * order + 1, f"{projection} {seed}"), order)
        if found.settled and is_stable(found.germ, "A(H)"):
            return found
    return None


def key(germ: Germ) -> Hashable:
    """Invariants for A(H): codimensions of orbits of jets, of f for A(H) and A, of f|H for A; signs.

    >>> key(Germ("x, u", "x u")) == key(Germ("x + u, u", "x u"))
    True
    >>> key(Germ("x1, u + x2**2", "x1 x2 u")) == key(Germ("x1, u - x2**2", "x1 x2 u"))
    False
    """
    source = tuple(name for name in germ.source if name != germ.boundary)
    on_boundary = Germ(
        [as_node(_at_zero(f, germ), source) for f in germ.jet(max(ORDERS))], source, None, germ.field
    )
    orbits = tuple(
        tangent(f, group(name), Version.ORDINARY, k).annihilator.codimension
        for f, name in ((germ, "A(H)"), (germ, "A"), (on_boundary, "A"))
        for k in ORDERS
    )
    return orbits, signs(germ)


def _at_zero(f: Polynomial, germ: Germ) -> Polynomial:
    """f|H in the variables without u."""
    place, found = germ.boundary_index, {}
    for m, c in f.items():
        exponents = poly.exponents_of(m, germ.n)
        if not exponents[place]:
            found[poly.monomial((*exponents[:place], *exponents[place + 1 :]))] = c
    return found


def signs(germ: Germ) -> Hashable:
    """Signatures of second derivatives, which changes of coordinates that keep H, with u ↦ u·k, k > 0, keep.

    With η ≠ 0 a covector that vanishes on df(TH), one up to factors: if η(∂f/∂u) ≠ 0, that of η∘f on the
    kernel of d(f|H), divided by that number; else those of η∘f on the kernels of df and of d(f|H) together,
    up to one common sign. None if there is no such η, or more than one.

    >>> signs(Germ("x1, u - x2**2", "x1 x2 u")), signs(Germ("x1, x2", "x1 x2 u"))
    ((0, 1), None)
    """
    n, u = germ.n, germ.boundary_index
    jet = germ.jet(2)
    rows = [[exact(f.get(poly.variable(i, n), 0)) for i in range(n)] for f in jet]
    inside = [i for i in range(n) if i != u]
    columns = [[row[i] for row in rows] for i in inside]
    covectors = null_space(columns, germ.p)
    if len(covectors) != 1:
        return None
    (eta,) = covectors
    g: Polynomial = {}
    for factor, f in zip(eta, jet):
        g = poly.plus(g, f, factor)
    slope = exact(g.get(poly.variable(u, n), 0))
    kernel = [_with_zero(v, u) for v in null_space([[row[i] for i in inside] for row in rows], n - 1)]
    on_boundary = _form(g, kernel, n)
    if slope:
        return signature(on_boundary * sp.sign(sp.Rational(slope.numerator, slope.denominator)))
    whole = _form(g, null_space(rows, n), n)
    return frozenset((signature(s * whole), signature(s * on_boundary)) for s in (1, -1))


def _with_zero(vector: list[Any], place: int) -> list[Any]:
    return [*vector[:place], Fraction(0), *vector[place:]]


def _form(g: Polynomial, vectors: list[list[Any]], n: int) -> Any:
    """The matrix of the second derivative of g on vectors."""

    def entry(i: int, j: int) -> Fraction:
        m = poly.variable(i, n) + poly.variable(j, n)
        return Fraction(g.get(m, 0)) * (2 if i == j else 1)

    hessian = [[entry(i, j) for j in range(n)] for i in range(n)]
    values = [
        [
            sum((a * hessian[i][j] * b for i, a in enumerate(v) for j, b in enumerate(w)), Fraction(0))
            for w in vectors
        ]
        for v in vectors
    ]
    size = len(vectors)
    return sp.Matrix(size, size, [sp.Rational(c.numerator, c.denominator) for row in values for c in row])
