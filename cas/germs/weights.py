"""Quasi-homogeneous germs: weights for which all monomials of a component have one weight.

Tangent spaces split by weight then, and jets that are cut by weight are far smaller than those cut by degree.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import gcd, lcm

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.polynomials import LARGEST

#: where the weights are not unique: the largest weight of a variable that is free
FREE = 12
#: and how many choices of them are tried at most
CHOICES = 2000


@dataclass(frozen=True)
class Weights:
    """Positive integers without a common factor: the weights of the variables and of the components."""

    source: tuple[int, ...]
    target: tuple[int, ...]


def weights(germ: Germ) -> Weights | None:
    """Weights for which a polynomial germ is quasi-homogeneous in the coordinates given; None if it is not.

    A component that is 0 has weight 0. If the weights are not unique, small ones are chosen, with the free
    weights up to 12 (less where more than three are free); None then means that there are none of that size.

    Raises DomainError for a germ that is not polynomial.

    >>> weights(Germ("y, x*y + x**3, x**2*y + x**4", "x y"))
    Weights(source=(1, 2), target=(2, 3, 4))
    >>> weights(Germ("x**2 + x**3", "x")) is None
    True
    """
    jet = germ.polynomial(LARGEST)
    if jet is None:
        raise DomainError(f"{germ} is not a polynomial germ: take a jet of it first.")
    exponents = [[poly.exponents_of(m, germ.n) for m in f] for f in jet]
    conditions = [
        [Fraction(a - b) for a, b in zip(e, first)] for first, *rest in filter(None, exponents) for e in rest
    ]
    chosen = _positive(null_space(conditions, germ.n))
    if chosen is None:
        return None
    return Weights(chosen, tuple(_weight(chosen, e[0]) if e else 0 for e in exponents))


def _positive(basis: Sequence[Sequence[Fraction]]) -> tuple[int, ...] | None:
    """A small positive integer vector in the span of a basis whose free coordinates are unit vectors."""
    free = max((f for f in range(1, FREE + 1) if f ** len(basis) <= CHOICES), default=1)
    factors = sorted(product(range(1, free + 1), repeat=len(basis)), key=lambda f: (max(f, default=0), f))
    for chosen in factors:
        vector = [sum((f * v for f, v in zip(chosen, column)), Fraction(0)) for column in zip(*basis)]
        if vector and min(vector) > 0:
            common = lcm(*(v.denominator for v in vector))
            whole = [int(v * common) for v in vector]
            return tuple(w // gcd(*whole) for w in whole)
    return None


def _weight(source: Sequence[int], exponents: Sequence[int]) -> int:
    return sum(w * e for w, e in zip(source, exponents))


def graded_by(germ: Germ) -> tuple[int, ...] | None:
    """The weights of the variables of a quasi-homogeneous germ, if they are not all equal; else None.

    >>> graded_by(Germ("x, x*y + y**10", "x y")), graded_by(Germ("x**2 + y**2", "x y"))
    ((9, 1), None)
    """
    found = None if germ.polynomial(LARGEST) is None else weights(germ)
    return None if found is None or max(found.source) == 1 else found.source
