"""Exact rational numbers as a field for Taylor programs: an oracle for rational functions."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from osculant.cas.errors import DomainError


class Rationals:
    """Exact rational numbers: polynomials and rational functions only."""

    def precision(self) -> int:
        """Exact."""
        return 0

    def number(self, value: Fraction) -> Fraction:
        """The rational itself."""
        return value

    def constant(self, name: str) -> Fraction:
        """Raises DomainError: pi and e are not rational."""
        raise DomainError(f"{name} is not a rational number.")

    def function(self, name: str) -> Callable[[Fraction], Fraction]:
        """Raises DomainError: no elementary function is rational."""
        raise DomainError(f"{name} does not map rational numbers to rational numbers.")

    def power(self, base: Fraction, exponent: Fraction) -> Fraction:
        """Raises DomainError: roots are not rational."""
        raise DomainError(f"A power with exponent {exponent} is not a rational number.")
