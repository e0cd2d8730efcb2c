"""Power series in one variable, cut after a fixed number of terms, over any commutative ring containing ℚ.

The coefficients may be rationals (`Fraction`, flint's `fmpq`), flint or sympy polynomials in jets of a
curve, elements of a fraction field, sympy expressions, mpmath numbers or balls; they need + − * and a product
with rationals. Division needs a leading coefficient whose reciprocal the ring can form.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from numbers import Rational
from typing import Any

from flint.utils.flint_exceptions import DomainError as NoQuotient

from osculant.cas.errors import DomainError


class PowerSeries:
    """c₀ + c₁x + … + cₙ₋₁xⁿ⁻¹ + O(xⁿ), n the ``length``; results have the length that is known.

    Args:
        coefficients: (c₀, …, cₙ₋₁), at least one; integers are allowed beside elements of the ring.

    >>> x = PowerSeries([Fraction(0), 1, 0, 0, 0])
    >>> geometric = 1 / (1 - x)
    >>> geometric
    PowerSeries([1, 1, 1, 1, 1])
    >>> geometric.integral().length, (geometric - 1).reversion()
    (6, PowerSeries([0, 1, -1, 1, -1]))
    """

    __slots__ = ("coefficients",)

    def __init__(self, coefficients: Sequence[Any]) -> None:
        if not coefficients:
            raise DomainError("A power series of length 0 says nothing: give at least one coefficient.")
        self.coefficients = tuple(coefficients)

    @property
    def length(self) -> int:
        """The number of coefficients known."""
        return len(self.coefficients)

    def __getitem__(self, power: int) -> Any:
        """The coefficient of x to that power; raises DomainError beyond the length."""
        if not 0 <= power < self.length:
            raise DomainError(
                f"The coefficient of order {power} is not known: this series has orders 0 to "
                f"{self.length - 1}."
            )
        return self.coefficients[power]

    def __repr__(self) -> str:
        return f"PowerSeries([{', '.join(str(c) for c in self.coefficients)}])"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PowerSeries) and self.coefficients == other.coefficients

    def __hash__(self) -> int:
        return hash(self.coefficients)

    def _with(self, other: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        if not isinstance(other, PowerSeries):
            zero = self.coefficients[0] * 0
            return self.coefficients, (other, *(zero,) * (self.length - 1))
        n = min(self.length, other.length)
        return self.coefficients[:n], other.coefficients[:n]

    def __add__(self, other: Any) -> PowerSeries:
        return PowerSeries([a + b for a, b in zip(*self._with(other))])

    __radd__ = __add__

    def __neg__(self) -> PowerSeries:
        return PowerSeries([-a for a in self.coefficients])

    def __sub__(self, other: Any) -> PowerSeries:
        return PowerSeries([a - b for a, b in zip(*self._with(other))])

    def __rsub__(self, other: Any) -> PowerSeries:
        return PowerSeries([b - a for a, b in zip(*self._with(other))])

    def __mul__(self, other: Any) -> PowerSeries:
        if not isinstance(other, PowerSeries):
            return PowerSeries([a * other for a in self.coefficients])
        a, b = self._with(other)
        return PowerSeries(
            [sum((a[i] * b[n - i] for i in range(1, n + 1)), a[0] * b[n]) for n in range(len(a))]
        )

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> PowerSeries:
        """The power with an integer exponent, DomainError for another; a negative one needs a reciprocal."""
        if not isinstance(exponent, int):
            raise DomainError(
                f"The operator ** takes integers, not {exponent!r}: use power() with a Fraction."
            )
        base = self if exponent >= 0 else self.reciprocal()
        zero = self.coefficients[0] * 0
        result = PowerSeries([zero + 1, *(zero,) * (self.length - 1)])
        for _ in range(abs(exponent)):
            result = result * base
        return result

    def reciprocal(self) -> PowerSeries:
        """1/self; raises DomainError if the constant coefficient has no reciprocal in the ring."""
        unit = _reciprocal(self.coefficients[0], "A power series whose constant coefficient is")
        found = [unit]
        for n in range(1, self.length):
            total = sum((self.coefficients[i] * found[n - i] for i in range(2, n + 1)), 0 * unit)
            found.append(-unit * (self.coefficients[1] * found[n - 1] + total))
        return PowerSeries(found)

    def __truediv__(self, other: Any) -> PowerSeries:
        if isinstance(other, PowerSeries):
            return self * other.reciprocal()
        unit = _reciprocal(other, "Division by")
        return PowerSeries([a * unit for a in self.coefficients])

    def __rtruediv__(self, other: Any) -> PowerSeries:
        return PowerSeries([a * other for a in self.reciprocal().coefficients])

    def cut(self, length: int) -> PowerSeries:
        """The same series with at most that many coefficients."""
        return PowerSeries(self.coefficients[:length])

    def shifted(self, power: int) -> PowerSeries:
        """The series times x^power; a negative power raises DomainError unless those coefficients are 0.

        >>> PowerSeries([0, 0, 3, 4]).shifted(-2)
        PowerSeries([3, 4])
        """
        if power >= 0:
            return PowerSeries([self.coefficients[0] * 0] * power + list(self.coefficients))
        if not all(_is_zero(c) for c in self.coefficients[:-power]) or self.length <= -power:
            raise DomainError(f"The series is not divisible by its variable to the power {-power}: {self}.")
        return PowerSeries(self.coefficients[-power:])

    def scaled(self, factor: Any) -> PowerSeries:
        """The series at factor·x.

        >>> PowerSeries([1, 1, 1]).scaled(3)
        PowerSeries([1, 3, 9])
        """
        power, found = 1, []
        for c in self.coefficients:
            found.append(c * power)
            power = power * factor
        return PowerSeries(found)

    def derivative(self) -> PowerSeries:
        """d/dx, one coefficient shorter; raises DomainError for a single coefficient."""
        if self.length == 1:
            raise DomainError("The derivative of a series of length 1 has no coefficient that is known.")
        return PowerSeries([c * n for n, c in enumerate(self.coefficients)][1:])

    def integral(self) -> PowerSeries:
        """∫₀ˣ, one coefficient longer."""
        terms = [c * ratio(1, n + 1, c) for n, c in enumerate(self.coefficients)]
        return PowerSeries([self.coefficients[0] * 0, *terms])

    def at(self, inner: PowerSeries) -> PowerSeries:
        """The composition self(inner(x)) by Horner's rule; inner's constant coefficient must be 0.

        >>> PowerSeries([1, 1, 1]).at(PowerSeries([0, 2, 1]))
        PowerSeries([1, 2, 5])
        """
        if not _is_zero(inner.coefficients[0]):
            raise DomainError(
                f"A series is composed with one without constant coefficient, not with {inner}."
            )
        length = min(self.length, inner.length)
        result: PowerSeries = inner.cut(length) * 0 + self.coefficients[length - 1]
        for c in reversed(self.coefficients[: length - 1]):
            result = result * inner.cut(length) + c
        return result

    def reversion(self) -> PowerSeries:
        """The series g with self(g(x)) = x, by Lagrange's formula n·gₙ = [xⁿ⁻¹] (x/self)ⁿ.

        Raises DomainError unless c₀ = 0 and c₁ is known and has a reciprocal in the ring.

        >>> PowerSeries([0, 2, 1]).reversion()
        PowerSeries([0, 1/2, -1/8])
        """
        if not _is_zero(self.coefficients[0]):
            raise DomainError(f"Only a series without constant coefficient has a reversion, not {self}.")
        _reciprocal(self[1], "Reversion of a series whose coefficient of x is")
        quotient = self.shifted(-1).reciprocal()  # x/self
        found, powers = [quotient[0] * 0], quotient
        for n in range(1, self.length):
            c = powers[n - 1]
            found.append(c * ratio(1, n, c))
            powers = powers * quotient
        return PowerSeries(found)


def identity(length: int, zero: Any = Fraction(0)) -> PowerSeries:
    """The series x itself, with coefficients in the ring of ``zero``.

    >>> identity(3)
    PowerSeries([0, 1, 0])
    """
    return PowerSeries([zero, zero + 1, *(zero,) * (length - 2)][:length])


def solve(equation: Callable[[PowerSeries], PowerSeries], slope: Any, length: int) -> PowerSeries:
    """The series y with y(0) = 0 and equation(y) = 0, one coefficient at a time (implicit function theorem).

    Args:
        equation: maps a series y to the series F(x, y(x)); F(0, 0) must be 0.
        slope: ∂F/∂y at (0, 0), an element of the ring of coefficients that has a reciprocal.
        length: number of coefficients wanted; ``equation`` must return at least as many.

    Raises DomainError if F(0, 0) ≠ 0, or if ∂F/∂y has no reciprocal: the condition is singular.

    >>> x = identity(5)
    >>> solve(lambda y: y + y * y - x, Fraction(1), 5)  # y = (√(1 + 4x) − 1)/2
    PowerSeries([0, 1, -1, 2, -5])
    """
    unit = _reciprocal(slope, "An implicit equation whose derivative by the unknown is")
    found = [unit * 0]
    for n in range(length):
        residual = equation(PowerSeries(found + [unit * 0] * (length - len(found))))[n]
        if n == 0 and residual != 0:
            raise DomainError(f"The implicit equation does not hold at the origin: it leaves {residual}.")
        if n > 0:
            found.append(-unit * residual)
    return PowerSeries(found)


def power(series: PowerSeries, exponent: Fraction, root: Any = None) -> PowerSeries:
    """series**exponent for a rational exponent, from f·g′ = exponent·f′·g.

    Args:
        series: its constant coefficient must have a reciprocal.
        exponent: any rational number; an integer, a `Fraction` or sympy's `Rational`.
        root: the constant coefficient to that power, an element of the ring; 1 if that coefficient is 1.

    Raises DomainError for another exponent, without the root where it is not 1, and if the constant
    coefficient has no reciprocal.

    >>> power(PowerSeries([1, Fraction(1), 0, 0]), Fraction(1, 2))
    PowerSeries([1, 1/2, -1/8, 1/16])
    """
    if not isinstance(exponent, Rational):
        raise DomainError(f"The exponent {exponent!r} of a series is not rational: write it as a Fraction.")
    c = series.coefficients
    if root is None:
        if c[0] != 1:
            raise DomainError(f"The power {exponent} of {c[0]} must be given to begin the series.")
        root = c[0]
    unit = _reciprocal(c[0], "A power of a series whose constant coefficient is")
    found = [root]
    for n in range(1, series.length):
        total = 0 * root
        for i in range(1, n + 1):
            factor = exponent * i - (n - i)
            total = total + c[i] * found[n - i] * ratio(factor.numerator, factor.denominator * n, total)
        found.append(unit * total)
    return PowerSeries(found)


def ratio(numerator: int, denominator: int, like: Any) -> Any:
    """A rational number that can be multiplied with elements of the ring of ``like``.

    >>> ratio(1, 3, 0)
    Fraction(1, 3)
    """
    library = type(like).__module__.partition(".")[0]
    if library == "flint":
        from flint import fmpq

        return fmpq(numerator, denominator)
    if library == "sympy":
        from sympy import QQ, Rational
        from sympy.core.basic import Basic

        return Rational(numerator, denominator) if isinstance(like, Basic) else QQ(numerator, denominator)
    if library == "mpmath":
        return type(like)(numerator) / denominator
    return Fraction(numerator, denominator)


def _is_zero(value: Any) -> bool:
    return bool(value == 0)  # for a ball: is exactly 0, whereas `!=` asks whether it excludes 0


def _reciprocal(value: Any, what: str) -> Any:
    if _is_zero(value):
        raise DomainError(f"{what} 0 is singular: no series solves it.")
    if type(value).__name__ in {"arb", "acb"} and value.contains(0):
        raise DomainError(f"{what} {value} may be 0: no series is certain to solve it, raise the precision.")
    try:
        return ratio(1, 1, value) / value
    except (ArithmeticError, ValueError, TypeError, NoQuotient) as error:
        raise DomainError(f"{what} {value} cannot be inverted in the ring of its coefficients.") from error
