"""Real numbers a·Π bᵉ for the checker: a and the positive bases b numbers of the field, exponents rational.

The root bᵉ is the positive one. Two such numbers are compared exactly: whole exponents go into a, and what is
left is raised to the power that makes all exponents whole; positive numbers with one power are equal.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import floor, lcm
from typing import Any

from osculant.certificates.check_algebra import number
from osculant.certificates.check_numbers import Algebraic, current
from osculant.certificates.check_text import rational, require, spend

#: denominators and sizes of exponents at most
EXPONENT = 1000


class Power:
    """A number a·Π bᵉ that is not 0.

    >>> half = Fraction(1, 2)
    >>> Power(Fraction(-2), {Fraction(2): half}) == Power(Fraction(-1), {Fraction(8): half})
    True
    """

    def __init__(self, factor: Any, powers: Mapping[Any, Fraction] | None = None) -> None:
        self.factor, self.powers = factor, {}
        for base, e in (powers or {}).items():
            require(e.denominator <= EXPONENT and abs(e) <= EXPONENT, "an exponent that is too large")
            whole = floor(e)
            if whole:
                self.factor = self.factor * _whole(base, whole)
            if e != whole:
                self.powers[base] = e - whole

    def __mul__(self, other: Power) -> Power:
        powers = dict(self.powers)
        for base, e in other.powers.items():
            powers[base] = powers.get(base, Fraction(0)) + e
        return Power(self.factor * other.factor, powers)

    def __pow__(self, exponent: int) -> Power:
        return Power(_whole(self.factor, exponent), {b: e * exponent for b, e in self.powers.items()})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Power):
            return NotImplemented
        ratio = self * other**-1
        if not ratio.powers:
            return bool(ratio.factor == 1)
        if not is_positive(ratio.factor):
            return False
        common = lcm(*(e.denominator for e in ratio.powers.values()))
        require(common <= EXPONENT, "exponents with a common denominator that is too large")
        total = _whole(ratio.factor, common)
        for base, e in ratio.powers.items():
            total = total * _whole(base, int(e * common))
        return bool(total == 1)

    __hash__ = None  # type: ignore[assignment]

    def positive(self) -> bool:
        """Whether the number is told to be positive: that of a field by bounds at its root."""
        return is_positive(self.factor)


def read_power(told: Any) -> Power:
    """A number of a certificate that is not 0: as `number` reads it, or {"factor", "powers"} with roots.

    Raises RejectedError for what is none, and for a root of a number that is not told to be positive.
    """
    if not isinstance(told, Mapping):
        told = {"factor": told, "powers": []}
    factor = number(told["factor"])
    require(bool(factor), "a factor that is 0")
    if isinstance(factor, Algebraic):
        factor.inverse()  # so it is not 0 for any root that generates the field
    powers: dict[Any, Fraction] = {}
    for base, exponent in told["powers"]:
        value = number(base)
        require(is_positive(value), f"the root of {str(base)[:60]!r}, which is not told to be positive")
        powers[value] = powers.get(value, Fraction(0)) + rational(exponent)
    return Power(factor, powers)


def is_positive(value: Any) -> bool:
    """Whether a number is positive; one of a field if bounds at its real root say so."""
    if isinstance(value, Algebraic):
        field = current()
        return field is not None and field.positive(value)
    return bool(value > 0)


def _whole(base: Any, exponent: int) -> Any:
    """A power with a whole exponent, counted as work by the digits that it has."""
    size = base.numerator.bit_length() + base.denominator.bit_length() if isinstance(base, Fraction) else 64
    spend(abs(exponent) * size)
    return base**exponent
