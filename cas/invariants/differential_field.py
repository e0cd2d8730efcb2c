"""Differential fields: rational functions of t and of finitely many kernels: sin(t), exp(t), √(1 + t²) ….

A `Field` has generators, each with its derivative and, where it is algebraic over the earlier ones, a
relation rᑫ = p that keeps powers low: sin² = 1 − cos², a root's power, |u|² = u². An `Element` is a quotient
of polynomials over ℚ (python-flint's, exact) in lowest terms, square roots below the line cleared where that
helps. So derivatives and whole invariants come out simplified, and a zero that the relations imply is seen to
be zero. (An element that is not 0 here may still vanish if its kernels have a relation unknown to the field.)

Nothing hangs: the size of every product is known beforehand, and beyond the caps UndecidedError is raised.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from osculant.cas.errors import UndecidedError

GENERATORS = 16
#: terms and total degree of a polynomial, and products of terms in all, beyond which the field gives up
TERMS, DEGREE, WORK = 800, 1000, 1_000_000


@dataclass
class Generator:
    """A kernel: how it prints, its derivative, and its relation kernel**degree = power (degree 0: none).

    cleared: whether it is cleared from denominators (for degree 2).
    """

    symbol: sympy.Expr
    derivative: Element | None = None
    degree: int = 0
    power: Element | None = None
    cleared: bool = False


class Element:
    """A quotient of polynomials in the generators; + - * / and integer powers, also with int and Fraction."""

    __slots__ = ("above", "below", "field")

    def __init__(self, field: Field, above: Any, below: Any) -> None:
        self.field, self.above, self.below = field, above, below

    def _coerce(self, other: Element | int | Fraction) -> Element:
        return other if isinstance(other, Element) else self.field.number(other)

    def __add__(self, other: Element | int | Fraction) -> Element:
        b, times = self._coerce(other), self.field.times
        if self.below == b.below:
            return self.field.quotient(self.above + b.above, self.below)
        return self.field.quotient(
            times(self.above, b.below) + times(b.above, self.below), times(self.below, b.below)
        )

    def __neg__(self) -> Element:
        return Element(self.field, -self.above, self.below)

    def __sub__(self, other: Element | int | Fraction) -> Element:
        return self + -self._coerce(other)

    def __rsub__(self, other: int | Fraction) -> Element:
        return -self + other

    def __mul__(self, other: Element | int | Fraction) -> Element:
        b, times = self._coerce(other), self.field.times
        return self.field.quotient(times(self.above, b.above), times(self.below, b.below))

    def __truediv__(self, other: Element | int | Fraction) -> Element:
        b, times = self._coerce(other), self.field.times
        return self.field.quotient(times(self.above, b.below), times(self.below, b.above))

    def __rtruediv__(self, other: int | Fraction) -> Element:
        return self._coerce(other) / self

    def __pow__(self, exponent: int) -> Element:
        base = self if exponent >= 0 else 1 / self
        result = self.field.number(1)
        for bit in f"{abs(exponent):b}":
            result = result * result
            if bit == "1":
                result = result * base
        return result

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Element, int, Fraction)) and bool((self - other).above.is_zero())

    __hash__ = None  # type: ignore[assignment]  # equal elements may be written differently

    def derivative(self) -> Element:
        """The derivative by the field's variable."""
        above, below = (Element(self.field, part, self.field.one) for part in (self.above, self.below))
        rise, fall = (self.field.derivative_of(part) for part in (self.above, self.below))
        return (rise * below - above * fall) / below**2


class Field:
    """A differential field that starts as ℚ; `generator` adjoins a kernel.

    >>> field = Field()
    >>> cos = field.generator(sympy.Symbol("cos"))
    >>> sin = field.generator(sympy.Symbol("sin"), 2, 1 - cos**2)
    >>> field.differentiate(cos, -sin)
    >>> field.differentiate(sin, cos)
    >>> sin**2 + cos**2 == 1, (sin / cos).derivative() == 1 / cos**2
    (True, True)
    """

    def __init__(self) -> None:
        self.ring = fmpq_mpoly_ctx.get(tuple(f"g{i}" for i in range(GENERATORS)), Ordering.lex)
        self.one = self.ring.constant(1)
        self.generators: list[Generator] = []
        self.work = 0

    def number(self, q: int | Fraction) -> Element:
        """A rational number as an element."""
        q = Fraction(q)
        return Element(self, self.ring.constant(fmpq(q.numerator, q.denominator)), self.one)

    def generator(
        self, symbol: sympy.Expr, degree: int = 0, power: Element | None = None, cleared: bool = True
    ) -> Element:
        """Adjoins a kernel that prints as the symbol, with kernel**degree = power if the degree is not 0.

        Raises UndecidedError if `GENERATORS` are in use.
        """
        index = len(self.generators)
        if index == GENERATORS:
            raise UndecidedError(f"The formula needs more than {GENERATORS} independent functions.")
        self.generators.append(Generator(symbol, None, degree, power, cleared and degree == 2))
        return Element(self, self.ring.gens()[index], self.one)

    def differentiate(self, kernel: Element, derivative: Element) -> None:
        """Sets the derivative of a generator, which is 0 until it is set."""
        index = next(i for i, g in enumerate(self.ring.gens()) if g == kernel.above)
        self.generators[index].derivative = derivative

    def derivative_of(self, polynomial: Any) -> Element:
        """The derivative of a polynomial in the generators, by the chain rule."""
        total = self.number(0)
        for index, generator in enumerate(self.generators):
            if generator.derivative is not None and polynomial.degrees()[index]:
                total += Element(self, polynomial.derivative(index), self.one) * generator.derivative
        return total

    def times(self, a: Any, b: Any) -> Any:
        """a*b for polynomials, if it stays within the caps; UndecidedError otherwise."""
        size = len(a) * len(b)
        self.work += size
        if (
            self.work > WORK
            or max(len(a), len(b)) > TERMS
            or size > 50 * TERMS
            or a.total_degree() + b.total_degree() > DEGREE
        ):
            raise UndecidedError(f"An invariant has more than {TERMS} terms or a degree above {DEGREE}.")
        return a * b

    def quotient(self, above: Any, below: Any) -> Element:
        """The element above/below in lowest terms, relations applied, roots below cleared if that is shorter.

        Raises ZeroDivisionError if below is 0 by the relations.
        """
        above, below = self._applied(above, below)
        forms = [self._lowest(above, below)]
        while (conjugate := self._conjugate(below)) is not None:
            above, below = self._applied(self.times(above, conjugate), self.times(below, conjugate))
            forms.append(self._lowest(above, below))
        return min(forms, key=lambda form: len(form.above) + len(form.below))

    def _applied(self, above: Any, below: Any) -> tuple[Any, Any]:
        """Numerator and denominator of above/below with the relations applied to both."""
        while True:
            above, outer = self._reduced(above)
            below, inner = self._reduced(below)
            if below.is_zero():
                raise ZeroDivisionError("a quantity that vanishes identically stands below the line")
            if outer == inner:
                return above, below
            above, below = self.times(above, inner), self.times(below, outer)

    def _lowest(self, above: Any, below: Any) -> Element:
        common = above.gcd(below)
        scale = below.leading_coefficient() / common.leading_coefficient()
        return Element(self, above / common / scale, below / common / scale)

    def _reduced(self, p: Any) -> tuple[Any, Any]:
        """Polynomials (a, b) with p = a/b, where a has lower degree in each kernel than its relation."""
        below = self.one
        for index in reversed(range(len(self.generators))):
            generator = self.generators[index]
            degree = generator.degree
            if degree == 0 or generator.power is None or p.degrees()[index] < degree:
                continue
            parts: dict[int, dict[tuple[int, ...], Any]] = {}
            for monomial, coefficient in p.to_dict().items():
                times, rest = divmod(monomial[index], degree)
                parts.setdefault(times, {})[(*monomial[:index], rest, *monomial[index + 1 :])] = coefficient
            top, scale = max(parts), self.one
            p = self.ring.constant(0)
            for times in range(top, -1, -1):  # Horner's scheme in power.above / power.below
                part = self.ring.from_dict(parts.get(times, {}))
                p = self.times(p, generator.power.above) + self.times(part, scale)
                if times:
                    scale = self.times(scale, generator.power.below)
            below = self.times(below, scale)
        return p, below

    def _conjugate(self, below: Any) -> Any:
        """a − br for below = a + br with the last square root r that is to be cleared, or None."""
        degrees = below.degrees()
        for index in reversed(range(len(self.generators))):
            if self.generators[index].cleared and degrees[index]:
                signs = {m: -c if m[index] else c for m, c in below.to_dict().items()}
                return self.ring.from_dict(signs)
        return None
