"""Fields of numbers that Taylor programs run on: rationals, mpmath floats, balls, exact sympy numbers."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from osculant.cas.errors import DomainError


class Rationals:
    """Exact rational numbers: polynomials and rational functions only.

    >>> Rationals().number(Fraction(1, 3))
    Fraction(1, 3)
    """

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


class Balls:
    """python-flint's real balls: every result encloses the true value; NaN outside the domain.

    The precision is flint's current one (``flint.ctx.prec``).
    """

    def __init__(self) -> None:
        from flint import arb

        self._arb = arb

    def number(self, value: Fraction) -> Any:
        """A ball around a rational.

        >>> Balls().number(Fraction(1, 2))
        0.500000000000000
        """
        above = self._arb(value.numerator)
        return above if value.denominator == 1 else above / value.denominator

    def constant(self, name: str) -> Any:
        """A ball around pi or e."""
        return self._arb.pi() if name == "pi" else self._arb.const_e()

    def function(self, name: str) -> Callable[[Any], Any]:
        """The enclosure of an elementary function."""
        if name == "cbrt":
            return self._cbrt
        if name == "sign":
            return self._sign
        function: Callable[[Any], Any] = getattr(self._arb, name)
        return function

    def power(self, base: Any, exponent: Fraction) -> Any:
        """base**exponent for a non-negative base; at 0 only for a positive exponent."""
        if base > 0 or (base == 0 and exponent > 0):
            return base ** self.number(exponent)
        if exponent > 0 and base >= 0:
            return self._arb.nan() if base.lower() < 0 else self._hull(base, exponent)
        return self._arb.nan()

    def _hull(self, base: Any, exponent: Fraction) -> Any:
        top = base.upper() ** self.number(exponent)
        return self._arb(0).union(top)

    def _cbrt(self, x: Any) -> Any:
        if x > 0:
            return x.root(3)
        if x < 0:
            return -((-x).root(3))
        if not x.is_finite():
            return self._arb.nan()
        low, high = x.lower(), x.upper()
        ends = [-((-low).root(3)) if low < 0 else self._arb(0), high.root(3) if high > 0 else self._arb(0)]
        return ends[0].union(ends[1])

    def _sign(self, x: Any) -> Any:
        if x > 0 or x < 0:
            return self._arb(1 if x > 0 else -1)
        return self._arb.nan()


class Multiprecision:
    """mpmath's real floats at the current ``mpmath.mp`` precision; NaN outside the domain."""

    def __init__(self) -> None:
        import mpmath

        self._mp = mpmath.mp

    def number(self, value: Fraction) -> Any:
        """The nearest float.

        >>> Multiprecision().number(Fraction(1, 4))
        mpf('0.25')
        """
        return self._mp.mpf(value.numerator) / value.denominator

    def constant(self, name: str) -> Any:
        """pi or e to the current precision."""
        return +(self._mp.pi if name == "pi" else self._mp.e)

    def function(self, name: str) -> Callable[[Any], Any]:
        """The real elementary function."""
        if name == "sign":
            return lambda x: self._mp.sign(x) if x else self._mp.nan
        if name == "cbrt":
            return lambda x: self._mp.sign(x) * self._mp.cbrt(abs(x))
        return lambda x: self._real(getattr(self._mp, name)(x))

    def power(self, base: Any, exponent: Fraction) -> Any:
        """base**exponent, NaN for a negative base."""
        return self._real(self._mp.power(base, self.number(exponent)))

    def _real(self, x: Any) -> Any:
        return x if isinstance(x, self._mp.mpf) else self._mp.nan


class ExactNumbers:
    """Exact constants as sympy expressions: to decide whether a derivative at a nice point is 0."""

    def __init__(self) -> None:
        import sympy

        self._sp = sympy

    def number(self, value: Fraction) -> Any:
        """The sympy rational.

        >>> ExactNumbers().number(Fraction(1, 2))
        1/2
        """
        return self._sp.Rational(value.numerator, value.denominator)

    def constant(self, name: str) -> Any:
        """sympy's pi or E."""
        return self._sp.pi if name == "pi" else self._sp.E

    def function(self, name: str) -> Callable[[Any], Any]:
        """sympy's function, evaluated where it knows the value."""
        if name == "cbrt":
            return lambda x: self._sp.real_root(x, 3)
        if name == "sign":
            return lambda x: self._sp.sign(x) if x != 0 else self._sp.nan
        function: Callable[[Any], Any] = getattr(self._sp, name)
        return function

    def power(self, base: Any, exponent: Fraction) -> Any:
        """base**exponent."""
        return base ** self.number(exponent)
