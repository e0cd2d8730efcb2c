"""Levels of the terms of a jet: the filtration that a unipotent group of changes of coordinates raises.

Every source coordinate x_a has a weight w_a and every target coordinate Y_j a weight W_j; x^α in component j
has the level α·w − W_j. The fields x^α∂_a with α·w > w_a, Y^β∂_j with β·W > W_j and, for K, x^α f_i e_j with
α·w + W_i > W_j raise levels. Weights are `UNIT` and a flag, a small number: all fields of order two raise
levels then, and of the linear ones those that are triangular for the flags.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from osculant.cas.germs import polynomials as poly
from osculant.cas.recognition.forms import Column, Exponents

#: the part of a weight that counts degrees; flags are below half of it
UNIT = 1000


@dataclass(frozen=True)
class Weights:
    """The weights of the source coordinates and of the target coordinates.

    >>> weights = flagged((12, 2), (12, 13))
    >>> weights.level((1, 1), 1), weights.source_gain((1, 0), 1)
    (1001, 10)
    """

    source: tuple[int, ...]
    target: tuple[int, ...]

    def of(self, exponents: Sequence[int]) -> int:
        """The weight of a monomial of the source."""
        return sum(w * e for w, e in zip(self.source, exponents))

    def level(self, exponents: Sequence[int], component: int) -> int:
        """The level of a monomial of a component."""
        return self.of(exponents) - self.target[component]

    def source_gain(self, exponents: Sequence[int], variable: int) -> int:
        """By how much x^α∂_a raises levels."""
        return self.of(exponents) - self.source[variable]

    def target_gain(self, exponents: Sequence[int], component: int) -> int:
        """By how much Y^β∂_j raises levels, of terms of level 0 or more."""
        return sum(w * e for w, e in zip(self.target, exponents)) - self.target[component]


def flagged(source: Sequence[int], target: Sequence[int]) -> Weights:
    """The weights with these flags."""
    return Weights(tuple(UNIT + flag for flag in source), tuple(UNIT + flag for flag in target))


class Columns:
    """The terms of a jet in the order of their levels, those that are allowed to remain last in theirs.

    Args:
        weights: the weights.
        order: the order of the jets.
        allowed: the terms that may remain.

    >>> columns = Columns(flagged((12, 2), (12, 13)), 2, {((1, 1), 1)})
    >>> [columns.order_of[i] for i in range(3)]
    [((0, 1), 1), ((0, 1), 0), ((1, 0), 1)]
    """

    def __init__(self, weights: Weights, order: int, allowed: Collection[Column] = ()) -> None:
        self.weights, self.order = weights, order
        n, p = len(weights.source), len(weights.target)
        #: the monomials of degree 1 to k
        self.monomials: tuple[Exponents, ...] = tuple(monomials(n, order))
        found = [(m, j) for m in self.monomials for j in range(p)]
        found.sort(key=lambda c: (weights.level(*c), c in allowed, c))
        #: the terms in their order, and the place of each
        self.order_of: tuple[Column, ...] = tuple(found)
        self.place: dict[Column, int] = {column: i for i, column in enumerate(found)}

    def level(self, place: int) -> int:
        """The level of the term at a place."""
        return self.weights.level(*self.order_of[place])


def monomials(n: int, order: int) -> Iterator[Exponents]:
    """The exponents of the monomials of degree 1 to k in n variables."""
    for m in poly.monomials(n, order):
        if m:
            yield poly.exponents_of(m, n)
