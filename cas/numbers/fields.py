"""Fields of numbers that Taylor programs run on: doubles, mpmath floats, balls, exact sympy numbers."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from fractions import Fraction
from typing import Any, Protocol

from osculant.cas.errors import DomainError


class Field(Protocol):
    """Numbers a program runs on: constructors and the elementary functions of one argument.

    ``function(name)`` gives an elementary function of formulas, or ``sign``, which is NaN at 0;
    ``power(x, q)`` is x**q for a rational q and x > 0.  Out of their domain functions give NaN or raise, as
    the field prefers.
    """

    def number(self, value: Fraction) -> Any:
        """The number of the field that a rational is."""

    def constant(self, name: str) -> Any:
        """pi or e."""

    def function(self, name: str) -> Callable[[Any], Any]:
        """An elementary function by its name."""

    def power(self, base: Any, exponent: Fraction) -> Any:
        """base**exponent for base > 0."""

    def precision(self) -> int:
        """The bits that its numbers have for now, 0 if they are exact."""


class Balls:
    """python-flint's real balls: every result encloses the true value; NaN outside the domain.

    The precision is flint's current one (``flint.ctx.prec``).
    """

    def __init__(self) -> None:
        from flint import arb, ctx

        self._arb, self._context = arb, ctx

    def precision(self) -> int:
        """flint's precision."""
        return int(self._context.prec)

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


class ComplexBalls:
    """python-flint's complex balls: formulas continued off the real line, to integrate."""

    def __init__(self) -> None:
        from flint import acb, arb, ctx

        self._acb, self._arb, self._context = acb, arb, ctx

    def precision(self) -> int:
        """flint's precision."""
        return int(self._context.prec)

    def number(self, value: Fraction) -> Any:
        """The ball of a rational number.

        >>> ComplexBalls().number(Fraction(1, 2))
        0.500000000000000
        """
        return self._acb(self._arb(value.numerator) / value.denominator)

    def constant(self, name: str) -> Any:
        """pi or e."""
        return self._acb(self._arb.pi() if name == "pi" else self._arb.const_e())

    def function(self, name: str) -> Callable[[Any], Any]:
        """An entire or meromorphic elementary function; DomainError for those with branches."""
        if name not in {"sin", "cos", "tan", "sinh", "cosh", "tanh", "exp"}:
            raise DomainError(
                f"{name} has branches in the complex plane: its integral is not certified here."
            )
        function: Callable[[Any], Any] = getattr(self._acb, name)
        return function

    def power(self, base: Any, exponent: Fraction) -> Any:
        """Raises DomainError: roots have branches."""
        raise DomainError(
            f"The power {exponent} has branches in the complex plane: write the formula without."
        )


class Multiprecision:
    """mpmath's real floats at the current ``mpmath.mp`` precision; NaN outside the domain."""

    def __init__(self) -> None:
        import mpmath

        self._mp = mpmath.mp

    def precision(self) -> int:
        """mpmath's precision."""
        return int(self._mp.prec)

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

    def precision(self) -> int:
        """Exact."""
        return 0

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


class Doubles:
    """Python's floats."""

    def precision(self) -> int:
        """Of a double."""
        return sys.float_info.mant_dig

    def number(self, value: Fraction) -> float:
        """The nearest float.

        >>> Doubles().number(Fraction(1, 4))
        0.25
        """
        return float(value)

    def constant(self, name: str) -> float:
        """pi or e to 53 bits."""
        return math.pi if name == "pi" else math.e

    def function(self, name: str) -> Callable[[float], float]:
        """Python's function."""
        if name == "sign":
            return lambda x: math.copysign(1.0, x) if x else math.nan
        function: Callable[[float], float] = getattr(math, name)
        return function

    def power(self, base: float, exponent: Fraction) -> float:
        """base**exponent."""
        return math.pow(base, float(exponent))


class Expressions(ExactNumbers):
    """sympy expressions with real symbols; cube roots are `osculant.cas.formulas.sympy_bridge.cbrt`."""

    def function(self, name: str) -> Callable[[Any], Any]:
        """sympy's function; real cube roots stay real, whatever the sign of what is below them."""
        if name != "cbrt":
            return super().function(name)
        from osculant.cas.formulas.sympy_bridge import cbrt

        return cbrt


def field_of(value: Any) -> Field:
    """The field of numbers that a number belongs to; sympy's expressions if it is none of the others.

    >>> field_of(2.0).function("sqrt")(9.0)
    3.0
    """
    if isinstance(value, (int, float)):
        return Doubles()
    library = type(value).__module__.partition(".")[0]
    fields: dict[str, Callable[[], Field]] = {"flint": Balls, "mpmath": Multiprecision}
    return fields.get(library, Expressions)()
