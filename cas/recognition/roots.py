"""Real roots of positive numbers, exactly: the numbers by which coordinates are scaled."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import exp, gcd, lcm
from typing import Any

from flint import fmpz

from osculant.cas.errors import DomainError
from osculant.cas.germs.algebraic import exact
from osculant.cas.recognition.real_fields import logarithm
from osculant.cas.recognition.real_fields import sign as real_sign


@dataclass(frozen=True)
class Root:
    """sign·base^{1/index}, the positive root of a positive number; of a rational one the index is least.

    The base may be a number of a real number field. Made by `root`, so that equal numbers are equal.

    >>> root(Fraction(4, 9), 4), root(2, 2) * root(8, 2)
    (Root(base=Fraction(2, 3), index=2, sign=1), Root(base=Fraction(4, 1), index=1, sign=1))
    >>> str(root(2, 2)), str(-root(2, 2) ** 3)
    ('2**(1/2)', '-8**(1/2)')
    """

    base: Any
    index: int = 1
    sign: int = 1

    def __mul__(self, other: Root) -> Root:
        both = lcm(self.index, other.index)
        value = self.base ** (both // self.index) * other.base ** (both // other.index)
        return root(value, both, self.sign * other.sign)

    def __pow__(self, exponent: int) -> Root:
        common = gcd(exponent, self.index)
        return root(self.base ** (exponent // common), self.index // common, self.sign if exponent % 2 else 1)

    def same(self, other: Root) -> bool:
        """Whether the numbers are equal, those of a number field too, which have several spellings."""
        return self.sign == other.sign and self.base**other.index == other.base**self.index

    def __neg__(self) -> Root:
        return Root(self.base, self.index, -self.sign)

    def __float__(self) -> float:
        size = exp(logarithm(self.base) / self.index)
        return size if self.sign > 0 else -size

    def __str__(self) -> str:
        if self.index == 1:
            return str(self.sign * self.base)
        whole = isinstance(self.base, Fraction) and self.base.denominator == 1
        base = str(self.base) if whole else f"({self.base})"
        return f"{'-' if self.sign < 0 else ''}{base}**(1/{self.index})"

    @property
    def rational(self) -> Fraction | None:
        """The number if it is rational; else None."""
        return self.sign * self.base if self.index == 1 else None

    @property
    def value(self) -> Fraction | Root:
        """A Fraction if the number is rational; else the root."""
        return self.sign * self.base if self.index == 1 else self


def root(base: Any, index: int = 1, sign: int = 1) -> Root:
    """sign times the positive root of a positive number, of a rational one with the least index.

    Raises DomainError for a base that is not positive, an index below 1 and a sign that is not ±1.
    """
    value = exact(base)
    if real_sign(value) <= 0 or index < 1 or sign not in (1, -1):
        raise DomainError(f"{sign} times the root of {base} of index {index} is no real root as meant here.")
    for prime, _ in fmpz(index).factor() if index > 1 and isinstance(value, Fraction) else ():
        while index % int(prime) == 0 and (found := _exact_root(value, int(prime))) is not None:
            value, index = found, index // int(prime)
    return Root(value, index, sign)


def _exact_root(value: Fraction, index: int) -> Fraction | None:
    """The rational root of that index; None if there is none."""
    parts = [int(fmpz(part).root(index)) for part in (value.numerator, value.denominator)]
    found = Fraction(*parts)
    return found if found**index == value else None
