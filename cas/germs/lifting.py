"""Rational vectors from their residues modulo primes."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import isqrt
from typing import Any

import numpy as np
from flint import fmpz

#: after so many primes, then each time half as many more, the residues are lifted
EAGER = 4


def primes(first: int) -> Iterator[int]:
    """The odd primes from a number down.

    >>> next(primes(10)), next(primes(11))
    (7, 11)
    """
    candidate = first - 1 + first % 2
    while True:
        if fmpz(candidate).is_prime():
            yield candidate
        candidate -= 1


class Residues:
    """Vectors, as columns, modulo the product of some primes.

    >>> known = Residues()
    >>> known.add(np.array([[51]]), 101), known.lifted()
    (True, ({0: Fraction(1, 2)},))
    """

    def __init__(self) -> None:
        self.combined: Any = None
        self.modulus, self.count, self.next = 1, 0, 1

    def add(self, values: np.ndarray, prime: int) -> bool:
        """Take in the residues modulo one more prime; whether it is time to lift them."""
        if self.combined is None:
            self.combined = values.astype(object)
        else:
            inverse = pow(self.modulus, -1, prime)
            self.combined += self.modulus * (((values - self.combined) % prime) * inverse % prime)
        self.modulus *= prime
        self.count += 1
        if self.count < self.next:
            return False
        self.next = self.count + max(1, self.count // 2 if self.count >= EAGER else 1)
        return True

    def lifted(self) -> tuple[dict[int, Fraction], ...] | None:
        """The rational vectors with these residues, or None where one has no small enough fraction."""
        bound = isqrt(self.modulus // 2)
        known: dict[int, Fraction] = {}
        vectors = []
        for j in range(self.combined.shape[1]):
            vector: dict[int, Fraction] = {}
            for column in np.flatnonzero(self.combined[:, j]):
                residue = int(self.combined[column, j])
                if residue not in known:
                    fraction = _fraction(residue, self.modulus, bound)
                    if fraction is None:
                        return None
                    known[residue] = fraction
                vector[int(column)] = known[residue]
            vectors.append(vector)
        return tuple(vectors)


def _fraction(residue: int, modulus: int, bound: int) -> Fraction | None:
    """The fraction a/b ≡ residue with |a|, b ≤ bound, by the Euclidean algorithm (Wang)."""
    previous, current, s, t = modulus, residue, 0, 1
    while current > bound:
        quotient = previous // current
        previous, current, s, t = current, previous - quotient * current, t, s - quotient * t
    if t == 0 or abs(t) > bound:
        return None
    return Fraction(current, t)
