"""Quasi-homogeneous germs: weights, the Milnor number they give, and the proof that there is none.

If all monomials of fⱼ have the weight dⱼ, tangent spaces split by weight. For a function of weight d with an
isolated critical point at 0 the partial derivatives, of weights d − wᵢ, are a regular sequence: the Milnor
algebra has dimension Π (d − wᵢ)/wᵢ (Milnor and Orlik), and its highest weight is Σ (d − 2wᵢ).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import gcd, lcm

from osculant.cas.errors import DomainError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import tangent
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.polynomials import LARGEST

#: where the weights are not unique: the largest weight of a variable that is free
FREE = 12


@dataclass(frozen=True)
class Weights:
    """Positive integers without a common factor: the weights of the variables and of the components."""

    source: tuple[int, ...]
    target: tuple[int, ...]


def weights(germ: Germ) -> Weights | None:
    """Weights for which a polynomial germ is quasi-homogeneous in the coordinates given; None if it is not.

    A component that is 0 has weight 0. If the weights are not unique, small ones are chosen, with the free
    weights up to 12; None then means that there are none of that size.

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
    factors = sorted(product(range(1, FREE + 1), repeat=len(basis)), key=lambda f: (max(f, default=0), f))
    for chosen in factors:
        vector = [sum((f * v for f, v in zip(chosen, column)), Fraction(0)) for column in zip(*basis)]
        if vector and min(vector) > 0:
            common = lcm(*(v.denominator for v in vector))
            whole = [int(v * common) for v in vector]
            return tuple(w // gcd(*whole) for w in whole)
    return None


def _weight(source: Sequence[int], exponents: Sequence[int]) -> int:
    return sum(w * e for w, e in zip(source, exponents))


def not_isolated(germ: Germ, group: Group) -> bool:
    """Proof that a quasi-homogeneous function has infinite R and K codimension; False proves nothing.

    An isolated critical point would have M^kθ ⊂ T R_e f for k·min wᵢ > Σ (d − 2wᵢ); it is tried, exactly.

    >>> from osculant.cas.germs.groups import GROUPS
    >>> not_isolated(Germ("(x**2 + y**2)**2", "x y"), GROUPS["R"])
    True
    """
    if germ.p != 1 or group.source != "all" or group.target == "left" or germ.polynomial(LARGEST) is None:
        return False
    found = weights(germ)
    if found is None or not found.target[0]:
        return False
    # f itself is in the ideal of its partial derivatives (Euler): R and K have the same tangent space
    highest = max(sum(found.target[0] - 2 * w for w in found.source), 0)
    k = highest // min(found.source) + 1
    return tangent(germ, Group("R", "all", "none"), Version.EXTENDED, k).depth >= k
