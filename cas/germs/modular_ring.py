"""Functions of n variables modulo a prime and an ideal of monomials, as arrays of residues.

The monomials kept are those up to a degree, and those of the last variables alone up to another one: the
quotient of the ring of power series by (x₁, …, x_r)·M^low + M^{high+1}.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement

import numpy as np

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.modular_span import Array, product
from osculant.cas.germs.polynomials import Polynomial

#: primes below are used
BELOW = 2**25


class ModularRing:
    """The residues of functions of n variables.

    Args:
        n: the number of variables.
        low: monomials up to that degree are kept.
        high: those of the variables from ``first`` on up to that degree, not less.
        first: r.
        prime: the prime, below `BELOW`.

    >>> ring = ModularRing(2, 1, 3, 1, 7)
    >>> [m.tolist() for m in ring.exponents]
    [[0, 0], [1, 0], [0, 1], [0, 2], [0, 3]]
    >>> y = ring.variable(1)
    >>> ring.times(y, y + 2 * ring.variable(0)).tolist()
    [0, 0, 0, 1, 0]
    """

    def __init__(self, n: int, low: int, high: int, first: int, prime: int) -> None:
        self.n, self.prime = n, prime
        kept = [poly.exponents_of(m, n) for m in poly.monomials(n, low)]
        for degree in range(low + 1, high + 1):
            several = combinations_with_replacement(range(first, n), degree)
            kept += [tuple(chosen.count(i) for i in range(n)) for chosen in several]
        self.exponents: Array = np.array(kept, dtype=np.int64).reshape(len(kept), n)
        self.degrees: Array = self.exponents.sum(axis=1)
        self.size, self.high = len(kept), max(low, high)
        self._scale = np.array([(2 * self.high + 1) ** i for i in range(n)], dtype=np.int64)
        keys = self.exponents @ self._scale
        self._order = np.argsort(keys)
        self._keys = keys[self._order]
        #: the place of the product of two monomials; ``size`` where it is not kept
        self.places = self.place(keys[:, None] + keys[None, :])

    def place(self, keys: Array) -> Array:
        """The places of monomials by their keys."""
        at = np.minimum(np.searchsorted(self._keys, keys), self.size - 1)
        return np.where(self._keys[at] == keys, self._order[at], self.size)

    def variable(self, i: int) -> Array:
        """xᵢ."""
        found = np.zeros(self.size + 1, dtype=np.int64)
        found[self.place(self._scale[i])] = 1
        return found[:-1]

    def matrix(self, f: Array) -> Array:
        """The products of all monomials with a function, as rows."""
        found = np.zeros((self.size, self.size + 1), dtype=np.int64)
        np.put_along_axis(found, self.places, np.broadcast_to(f, self.places.shape), axis=1)
        return found[:, :-1]

    def times(self, a: Array, b: Array) -> Array:
        """The product of a function, or of functions as rows, with a function."""
        found = product(np.atleast_2d(a), self.matrix(b), self.prime)
        return found if a.ndim > 1 else found[0]

    def derivative(self, f: Array, i: int) -> Array:
        """∂f/∂xᵢ; right where f is known one degree further."""
        found = np.zeros(self.size + 1, dtype=np.int64)
        keys = self.exponents @ self._scale - self._scale[i]
        has = self.exponents[:, i] > 0
        found[self.place(keys[has])] = f[has] * self.exponents[has, i] % self.prime
        return found[:-1]

    def powers(self, factors: Sequence[Array], degree: int) -> list[tuple[Array, Array]]:
        """(exponents β, products f^β) of each degree |β| from 0 up; products that are 0 are left out."""
        matrices = [self.matrix(f) for f in factors]
        beta = np.zeros((1, len(factors)), dtype=np.int64)
        one = np.zeros((1, self.size), dtype=np.int64)
        one[0, 0] = 1
        found = [(beta, one)]
        for _ in range(degree):
            betas, values = [], []
            for i, matrix in enumerate(matrices):
                mine = ~found[-1][0][:, i + 1 :].any(axis=1)  # only the factors up to i so far
                made = product(found[-1][1][mine], matrix, self.prime)
                more = found[-1][0][mine].copy()
                more[:, i] += 1
                alive = made.any(axis=1)
                betas.append(more[alive])
                values.append(made[alive])
            found.append((np.concatenate(betas), np.concatenate(values)))
            if not len(found[-1][0]):
                break
        return found

    def evaluated(self, functions: Sequence[dict[tuple[int, ...], int]], images: Sequence[Array]) -> Array:
        """Polynomials {exponents: residue} of the images of their variables, as rows."""
        degree = max((sum(m) for f in functions for m in f), default=0)
        total = np.zeros((len(functions), self.size), dtype=np.int64)
        for betas, values in self.powers(images, degree):
            wanted = [tuple(map(int, beta)) for beta in betas]
            coefficients = np.array([[f.get(m, 0) for m in wanted] for f in functions], dtype=np.int64)
            if coefficients.size:
                total = (total + product(coefficients, values, self.prime)) % self.prime
        return total

    def projected(self, functions: Array, onto: ModularRing) -> Array:
        """Functions, as rows, in a smaller ring."""
        return functions[:, self.place(onto.exponents @ self._scale)]


def residues(f: Polynomial, n: int, prime: int) -> dict[tuple[int, ...], int] | None:
    """A polynomial over ℚ modulo a prime, by exponents; None if it divides a denominator."""
    found = {}
    for m, c in f.items():
        if not c.denominator % prime:
            return None
        found[poly.exponents_of(m, n)] = c.numerator * pow(c.denominator, -1, prime) % prime
    return found
