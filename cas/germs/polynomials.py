"""Polynomials in several variables, cut above a total degree: dictionaries from monomials to exact numbers.

A monomial xᵅ is one integer: the exponents in fields of `BITS` bits and the total degree above them, so that
the product of monomials is the sum of their integers and the degree is a shift away. The degree may count the
variables with weights: then all functions that name ``weights`` must be given them, and "degree" means the
weight.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import combinations_with_replacement
from typing import Any

#: bits of one exponent: degrees up to `LARGEST`
BITS = 12
LARGEST = (1 << BITS) - 1

#: an int, a Fraction or an `osculant.cas.germs.algebraic.Algebraic`
Number = Any
Polynomial = dict[int, Number]


def monomial(exponents: Sequence[int]) -> int:
    """The integer of xᵅ.

    >>> exponents_of(monomial((2, 0, 1)), 3), degree_of(monomial((2, 0, 1)), 3)
    ((2, 0, 1), 3)
    """
    packed = sum(exponents)
    for e in reversed(exponents):
        packed = packed << BITS | e
    return packed


def exponents_of(packed: int, n: int) -> tuple[int, ...]:
    """The exponents of a monomial in n variables."""
    return tuple(packed >> BITS * i & LARGEST for i in range(n))


def degree_of(packed: int, n: int) -> int:
    """The total degree of a monomial in n variables."""
    return packed >> BITS * n


@lru_cache(maxsize=64)
def monomials(n: int, order: int, weights: tuple[int, ...] = ()) -> tuple[int, ...]:
    """All monomials in n variables of degree at most ``order``, by degree.

    >>> [exponents_of(m, 2) for m in monomials(2, 2)]
    [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
    >>> [exponents_of(m, 2) for m in monomials(2, 3, (2, 1))]
    [(0, 0), (0, 1), (0, 2), (1, 0), (0, 3), (1, 1)]
    """
    units = [variable(i, n, weights) for i in range(n)]
    if weights:
        found = [0]
        for unit in units:
            top = order + 1 << BITS * n
            reach = [(unit * e) for e in range(order // (unit >> BITS * n) + 1)]
            found = [m + power for m in found for power in reach if m + power < top]
        return tuple(sorted(found, key=lambda m: (degree_of(m, n), -m)))
    return tuple(
        sum(chosen) for degree in range(order + 1) for chosen in combinations_with_replacement(units, degree)
    )


def variable(i: int, n: int, weights: tuple[int, ...] = ()) -> int:
    """The monomial xᵢ, i from 0."""
    return (weights[i] if weights else 1) << BITS * n | 1 << BITS * i


def weighted(a: Polynomial, n: int, weights: tuple[int, ...]) -> Polynomial:
    """The same polynomial with monomials whose degree counts the weights.

    >>> [degree_of(m, 2) for m in weighted({monomial((2, 1)): 1}, 2, (3, 5))]
    [11]
    """
    found = {}
    low = (1 << BITS * n) - 1
    for m, c in a.items():
        degree = sum(w * e for w, e in zip(weights, exponents_of(m, n)))
        found[degree << BITS * n | m & low] = c
    return found


def times(a: Polynomial, b: Polynomial, n: int, order: int) -> Polynomial:
    """The product without the terms above degree ``order``.

    >>> x = {variable(0, 1): 1, 0: 1}
    >>> times(x, x, 1, 1) == {0: 1, variable(0, 1): 2}
    True
    """
    top = order + 1 << BITS * n
    result: Polynomial = {}
    whole = max(a, default=0) + max(b, default=0) < top
    factors = list(b.items()) if whole else sorted(b.items(), key=_monomial)
    for left, c in a.items():
        for right, d in factors:
            product = left + right
            if product >= top:
                break
            result[product] = result.get(product, 0) + c * d
    return {m: c for m, c in result.items() if c}


def _monomial(term: tuple[int, Number]) -> int:
    return term[0]


def plus(a: Polynomial, b: Polynomial, factor: Number = 1) -> Polynomial:
    """a + factor·b."""
    result = dict(a)
    for m, c in b.items():
        total = result.get(m, 0) + factor * c
        if total:
            result[m] = total
        else:
            result.pop(m, None)
    return result


def cut(a: Polynomial, n: int, order: int) -> Polynomial:
    """The terms of degree at most ``order``."""
    top = order + 1 << BITS * n
    return {m: c for m, c in a.items() if m < top}


def derivative(a: Polynomial, i: int, n: int, weights: tuple[int, ...] = ()) -> Polynomial:
    """∂/∂xᵢ.

    >>> derivative({monomial((2, 1)): 5}, 0, 2) == {monomial((1, 1)): 10}
    True
    """
    unit = variable(i, n, weights)
    return {m - unit: c * e for m, c in a.items() if (e := m >> BITS * i & LARGEST)}


def order_of(a: Polynomial, n: int) -> int:
    """The least degree of a term; `LARGEST` + 1 for the zero polynomial."""
    return min((degree_of(m, n) for m in a), default=LARGEST + 1)


def powers(factors: Sequence[Polynomial], n: int, order: int) -> Iterator[tuple[tuple[int, ...], Polynomial]]:
    """(β, f^β) for every β with f^β not zero up to degree ``order``, starting with β = 0.

    The factors have no constant term, so there are finitely many.

    >>> [b for b, _ in powers([{variable(0, 1): 1}, {monomial((2,)): 1}], 1, 2)]
    [(0, 0), (1, 0), (0, 1), (2, 0)]
    """
    level: dict[tuple[int, ...], Polynomial] = {(0,) * len(factors): {0: 1}}
    while level:
        yield from level.items()
        following: dict[tuple[int, ...], Polynomial] = {}
        for beta, value in level.items():
            last = max((i for i, e in enumerate(beta) if e), default=0)
            for i in range(last, len(factors)):
                product = times(value, factors[i], n, order)
                if product:
                    following[(*beta[:i], beta[i] + 1, *beta[i + 1 :])] = product
        level = following
