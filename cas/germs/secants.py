"""Germs of secant maps of immersions at the diagonal, and the projections along a tangent (thesis 6.2).

The secant through p = (p̄ − λω)/2 and q = (p̄ + λω)/2, ω = (1, v₂, …, vₙ), of an immersion in normal position
has the direction (X(q) − X(p))/λ =: h = (h₀, …, h_m), and h₀(0) = 1: the secant germ is S = (h₁/h₀, …,
h_m/h₀), of the variables (p̄, λ, v). It is even in λ, which exchanges p and q: S = f(p̄, λ², v).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import comb, prod

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import exact
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.even import BOUNDARY, double, fresh, halve
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.immersions import Immersion, written
from osculant.cas.germs.polynomials import LARGEST, Polynomial
from osculant.cas.germs.search import Patience

#: terms of the chords of a polynomial immersion that is taken as a whole, not up to an order
WHOLE = 400
#: order up to which quotients hᵢ/h₀ are expanded to be compared with the projection
QUOTIENTS = 12
#: orders of jets of f that are tried one after the other where none is given
ORDERS = (2, 3, 5, 8)


def chord(g: Polynomial, n: int) -> Polynomial:
    """(g(q) − g(p))/λ, a polynomial in (p̄₁, …, p̄ₙ, λ, v₂, …, vₙ), for a polynomial g in n variables.

    >>> half_sum = {poly.monomial((1, 0, 0, 1)): 1, poly.monomial((0, 1, 0, 0)): 1}
    >>> chord({poly.monomial((1, 1)): 2}, 2) == half_sum
    True
    """
    unit = poly.variable(n, 2 * n)
    return {m - unit: 2 * c for m, c in _at_end(g, n, 1).items()}


def middle(g: Polynomial, n: int) -> Polynomial:
    """(g(p) + g(q))/2, a polynomial in (p̄₁, …, p̄ₙ, λ, v₂, …, vₙ), for a polynomial g in n variables.

    >>> middle({poly.monomial((2,)): 4}, 1) == {poly.monomial((2, 0)): 1, poly.monomial((0, 2)): 1}
    True
    """
    return _at_end(g, n, 0)


def _at_end(g: Polynomial, n: int, parity: int) -> Polynomial:
    """The terms of g(q) = g((p̄ + λω)/2) with an even (0) or an odd (1) power of λ; g(p) has −λ for λ."""
    found: Polynomial = {}
    for m, c in g.items():
        alpha = poly.exponents_of(m, n)
        scale = exact(c) / 2 ** sum(alpha)
        for beta in product(*(range(a + 1) for a in alpha)):
            if sum(beta) % 2 == parity:
                exponents = (*(a - b for a, b in zip(alpha, beta)), sum(beta), *beta[1:])
                term = poly.monomial(exponents)
                found[term] = found.get(term, 0) + scale * prod(map(comb, alpha, beta))
    return {m: c for m, c in found.items() if c}


@dataclass(frozen=True)
class Secant:
    """The secant germ of an immersion at a point and in a direction.

    Attributes:
        immersion: X in normal position.
        order: the order of the jets in which f and S are known; None if they are whole.
        germ: f, of (p̄, u, v) with H = {u = 0}; its source names p̄ like the variables of the immersion.
        even: S, of (p̄, λ, v).
        settled: whether f is what its jet tells: it is whole, or determined for A(H) by that order.
    """

    immersion: Immersion
    order: int | None
    germ: Germ
    even: Germ
    settled: bool

    def linked(self) -> int:
        """Check Remark 6.2.3: p₁·h₀·S is the projection where p̄ = p, λ = p₁, vᵢ = pᵢ/p₁.

        Returns the degree up to which the two were compared: all degrees for a whole S of a polynomial X, if
        h₀ = 1 or the degree of X is not high.
        AssertionError, a defect, if they differ.

        >>> secant(Immersion.of("x, y, x**3 + x*y", "x y")).linked()
        3
        """
        x, n = self.immersion, self.immersion.n
        whole = x.polynomial if self.order is None else None
        top = max((poly.degree_of(m, n) for f in whole for m in f), default=1) if whole is not None else 0
        order = self.order if self.order is not None else (3 * top) // 2
        if chord(x.germ.jet(2 * order + 1)[0], n) != {0: 1}:
            order = min(order, QUOTIENTS)
        degree = (2 * order + 1) // 3  # a term of degree a of X is at most one of degree (3a − 1)/2 of f
        jet = x.germ.jet(2 * order + 1)
        first = poly.cut(halve(chord(jet[0], n), n, 2 * n), 2 * n, order)
        for f, g in zip(self.germ.jet(order), jet[1:], strict=True):
            ahead = double(poly.times(first, f, 2 * n, order), n, 2 * n)
            assert poly.cut(projected(ahead, n), n, degree) == poly.cut(g, n, degree)
        return degree


def projected(even: Polynomial, n: int) -> Polynomial:
    """p₁·S where p̄ = p, λ = p₁ and vᵢ = pᵢ/p₁ (Remark 6.2.3), for a polynomial S in (p̄, λ, v).

    Raises DomainError if that is no polynomial: then S is no component of a secant germ.

    >>> projected({poly.monomial((1, 0, 0, 1)): 2}, 2) == {poly.monomial((1, 1)): 2}
    True
    """
    found: Polynomial = {}
    for m, c in even.items():
        exponents = poly.exponents_of(m, 2 * n)
        bar, power, v = exponents[:n], exponents[n], exponents[n + 1 :]
        along = bar[0] + 1 + power - sum(v)
        if along < 0:
            raise DomainError("A term has too high a power of v for a secant germ: p₁·S is no polynomial.")
        image = poly.monomial((along, *(a + b for a, b in zip(bar[1:], v))))
        found[image] = found.get(image, 0) + c
    return {m: c for m, c in found.items() if c}


def secant(immersion: Immersion, order: int | None = None, patience: Patience | None = None) -> Secant:
    """The secant germ of an immersion in normal position.

    Args:
        immersion: X.
        order: the order k of the jets of f that are wanted, for which X is expanded to 2k + 1; without it, a
            polynomial X with few terms is taken as a whole, and for others the first of the `ORDERS` that
            determines f for A(H), else the last.
        patience: processor time for the question whether a jet determines f.

    Raises DomainError for an immersion with one component, whose secants have no direction to tell, and for
    an order below 1 or beyond the caps of jets.

    >>> found = secant(Immersion.of("t, exp(t) - 1", "t"), order=1)
    >>> print(found.germ, found.order, found.settled)
    (1/2*t + 1/24*u) 1 True
    """
    if immersion.germ.p < 2:
        raise DomainError(
            "The secants of a map to the line have one direction: give two components at least."
        )
    n, whole = immersion.n, immersion.polynomial
    if order is not None and not 1 <= order <= LARGEST // 2 - 1:
        raise DomainError(
            f"order: jets of order 1 to {LARGEST // 2 - 1} are possible, not {order}.", argument="order"
        )
    if order is None and whole is not None and _terms(whole, n) <= WHOLE:
        return _made(immersion, None, [chord(f, n) for f in whole], True)
    for k in ORDERS if order is None else (order,):
        jet = immersion.germ.jet(2 * k + 1)
        found = _made(immersion, k, [chord(f, n) for f in jet], False)
        if _determined(found.germ, k, patience):
            return replace(found, settled=True)
    return found


def variety(immersion: Immersion, order: int | None = None) -> Germ:
    """The A(H)-germ of the secant variety, (X(p) + X(q))/2 + t·(X(q) − X(p))/λ − X(0), of (p̄, u, v, t).

    Args:
        immersion: X; in its normal position the germ is that at the diagonal, at t = 0.
        order: the order of the jets that are kept; None for the whole of a polynomial X.

    Raises DomainError if an order is missing for what is no polynomial.

    >>> print(variety(Immersion.of("t, t**2", "t")))
    (1/2*t + s, 1/4*u + 1/4*t**2 + t*s)
    """
    n, whole = immersion.n, immersion.polynomial
    if order is None and whole is None:
        raise DomainError("The secant variety of what is no polynomial is known by jets: give their order.")
    jet = whole if order is None and whole is not None else immersion.germ.jet(2 * (order or 0) + 1)
    names = variable_names(immersion.names)
    source = (*names[:n], BOUNDARY, *names[n + 1 :])
    source = (*source, fresh("t" if "t" not in source else "s", source))
    components = []
    for g in jet:
        along = _with_last(halve(chord(g, n), n, 2 * n), 2 * n, 1)
        f = poly.plus(_with_last(halve(middle(g, n), n, 2 * n), 2 * n, 0), along)
        f = f if order is None else poly.cut(f, 2 * n + 1, order)
        components.append(written(f, source, immersion.field))
    return Germ(components, source, BOUNDARY, immersion.field)


def variable_names(names: Sequence[str]) -> tuple[str, ...]:
    """The names of (p̄, λ, v) for those of p, none of which is that of the boundary variable.

    >>> variable_names(("x", "y")), variable_names(("v", "y", "z"))
    (('x', 'y', 'lam', 'v'), ('v', 'y', 'z', 'lam', 'v2', 'v3'))
    """
    taken = [*names, BOUNDARY]
    n = len(names)
    for name in ("lam", *(("v",) if n == 2 else (f"v{i}" for i in range(2, n + 1)))):
        taken.append(fresh(name, taken))
    return (*names, *taken[n + 1 :])


def _made(immersion: Immersion, order: int | None, chords: Sequence[Polynomial], settled: bool) -> Secant:
    n, field = immersion.n, immersion.field
    names = variable_names(immersion.names)
    source = (*names[:n], BOUNDARY, *names[n + 1 :])
    if order is None:
        even = [written(h, names, field) for h in chords]
        half = [written(halve(h, n, 2 * n), source, field) for h in chords]  # lemma 6.2.1: or DomainError
        even, half = ([h / nodes[0] for h in nodes[1:]] for nodes in (even, half))
    else:
        quotients = _quotients([poly.cut(halve(h, n, 2 * n), 2 * n, order) for h in chords], 2 * n, order)
        half = [written(f, source, field) for f in quotients]
        even = [written(double(f, n, 2 * n), names, field) for f in quotients]
    return Secant(
        immersion, order, Germ(half, source, BOUNDARY, field), Germ(even, names, None, field), settled
    )


def _quotients(h: Sequence[Polynomial], n: int, order: int) -> list[Polynomial]:
    """The jets of hᵢ/h₀, i ≥ 1, for h₀(0) = 1."""
    rest = poly.plus({0: 1}, h[0], -1)
    inverse: Polynomial = {0: 1}
    for _ in range(order if rest else 0):
        inverse = poly.plus({0: 1}, poly.times(inverse, rest, n, order))
    return [poly.times(f, inverse, n, order) for f in h[1:]]


def _determined(germ: Germ, order: int, patience: Patience | None) -> bool:
    try:
        found = determinacy(germ, "A(H)", patience).degree
    except UndecidedError:
        return False
    return found != "infinite" and found <= order


def _terms(jet: Sequence[Polynomial], n: int) -> int:
    """A bound of the terms of the chords."""
    return sum(prod(e + 1 for e in poly.exponents_of(m, n)) for f in jet for m in f)


def _with_last(f: Polynomial, n: int, power: int) -> Polynomial:
    """The polynomial of n variables times that power of one more."""
    return {poly.monomial((*poly.exponents_of(m, n), power)): c for m, c in f.items()}
