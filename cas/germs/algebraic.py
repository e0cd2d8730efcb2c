"""Number fields ℚ(α) and their numbers, exactly: polynomials in α modulo its irreducible polynomial.

All that is told of a germ over ℚ(α) is the same for every root α of that polynomial: an isomorphism moves one
to the other. So no root is chosen, but where roots of numbers are taken (`osculant.cas.germs.radicals`): they
are the positive ones, and α is real.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import fmpq, fmpq_poly, fmpz, nmod_poly

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import ZERO, Node, number, to_text, variable
from osculant.cas.formulas.graph import fold, variables

#: degree of a field at most
DEGREE = 12
#: residues are taken modulo the first prime below with a root of the field's polynomial
BELOW = 2**30


class NumberField:
    """ℚ(α), α a root of an irreducible polynomial.

    Args:
        polynomial: the coefficients c₀, …, c_d; it becomes monic.
        node: α as an expression: a variable for a root without a formula.
        real: a ball around α in flint's precision, for a real α with a formula; else None.

    Raises DomainError for a polynomial that is reducible, of degree 1 or less or above `DEGREE`.

    >>> golden = NumberField.stated("a^2 - a - 1")
    >>> a = golden.generator
    >>> str(a * a), a / a, str(1 / a)
    ('a + 1', Fraction(1, 1), 'a - 1')
    """

    def __init__(self, polynomial: Any, node: Node, real: Callable[[], Any] | None = None) -> None:
        found = fmpq_poly(polynomial)
        name = to_text(node)
        if not 2 <= found.degree() <= DEGREE:
            raise DomainError(
                f"The number {name} of a germ has degree {found.degree()} over the rationals: from 2 to "
                f"{DEGREE} is possible."
            )
        factors = found.factor()[1]
        if len(factors) > 1 or factors[0][1] > 1:
            raise DomainError(
                f"The polynomial {found} of {name} is reducible: state one of its irreducible factors."
            )
        self.polynomial = found / found[found.degree()]
        self.degree: int = found.degree()
        self.node, self.real = node, real
        self.generator = Algebraic(self, fmpq_poly([0, 1]))
        #: the text that states the polynomial, if there is one
        self.text: str | None = None
        #: roots of numbers: (degree, of what) → the root
        self.roots: dict[tuple[int, Any], Any] = {}

    @classmethod
    def stated(cls, text: str) -> NumberField:
        """The field of a root of a polynomial in one variable, which names the root.

        >>> NumberField.stated("r**3 - 2").degree
        3
        """
        from osculant.cas.formulas.parser import parse

        names = sorted(set(re.findall(r"[^\W\d]\w*", text)))
        if len(names) != 1:
            raise DomainError(
                f"root: {text!r} is no polynomial in one variable: state one such as a**2 - a - 1.",
                argument="root",
            )
        coefficients = _coefficients(parse(text, names), names[0])
        if coefficients is None:
            raise DomainError(
                f"root: {text!r} is no polynomial with rational coefficients of degree up to {DEGREE}.",
                argument="root",
            )
        made = cls(coefficients, variable(names[0]))
        made.text = text
        return made

    @property
    def name(self) -> str | None:
        """The name of a stated root; None for a root with a formula."""
        return str(self.node.value) if self.node.kind == "variable" else None

    def number(self, polynomial: Any) -> Any:
        """The number with that polynomial in α: a Fraction if it is rational."""
        rest = polynomial % self.polynomial
        if rest.degree() <= 0:
            return Fraction(int(rest[0].p), int(rest[0].q))
        return Algebraic(self, rest)

    def of(self, coefficients: Any) -> Any:
        """The number Σ cᵢαⁱ."""
        return self.number(fmpq_poly([rational(Fraction(c)) for c in coefficients]))

    def expression(self, value: Any) -> Node:
        """A number of the field as an expression."""
        if not isinstance(value, Algebraic):
            return number(value)
        total = ZERO
        for i, c in reversed(list(enumerate(value.coefficients()))):
            if c:
                term = number(abs(c)) * (self.node**i if i else number(1))
                total = total + term if c > 0 else total - term if total is not ZERO else -term
        return total

    @cached_property
    def split(self) -> tuple[int, int]:
        """(p, r): a prime p with m(r) ≡ 0: residues of numbers take α to r."""
        prime = BELOW
        while True:
            prime -= 1
            if fmpz(prime).is_prime() and all(int(c.q) % prime for c in self.polynomial.coeffs()):
                modular = nmod_poly(
                    [int(c.p) * pow(int(c.q), -1, prime) % prime for c in self.polynomial.coeffs()], prime
                )
                for factor, _ in modular.factor()[1]:
                    if factor.degree() == 1:
                        return prime, int(-factor[0] / factor[1])

    def told(self, bits: int = 80) -> dict[str, Any]:
        """The field as plain data, for certificates: see `osculant.certificates.check_numbers`.

        Args:
            bits: the interval around a real root is about 2^−bits wide.
        """
        interval = None
        if self.real is not None:
            interval = [str(v) for v in _interval(self, bits)]
        return {
            "name": self.name,
            "polynomial": [str(c) for c in self.polynomial.coeffs()],
            "interval": interval,
            "roots": [
                {"degree": q, "of": _listed(of), "value": _listed(value)}
                for (q, of), value in self.roots.items()
            ],
        }


class Algebraic:
    """A number of a number field that is not rational."""

    __slots__ = ("field", "value")

    def __init__(self, field: NumberField, value: Any) -> None:
        self.field, self.value = field, value

    def _other(self, other: object) -> Any:
        if isinstance(other, Algebraic):
            if other.field is not self.field:
                raise ValueError("numbers of two fields")
            return other.value
        if isinstance(other, int):
            return fmpq(other)
        return rational(other) if isinstance(other, Fraction) else None

    def __add__(self, other: object) -> Any:
        value = self._other(other)
        return NotImplemented if value is None else self.field.number(self.value + value)

    def __mul__(self, other: object) -> Any:
        value = self._other(other)
        return NotImplemented if value is None else self.field.number(self.value * value)

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, -self.value)

    def __sub__(self, other: object) -> Any:
        value = self._other(other)
        return NotImplemented if value is None else self.field.number(self.value - value)

    def __rsub__(self, other: object) -> Any:
        return -self + other

    __radd__, __rmul__ = __add__, __mul__

    def inverse(self) -> Any:
        """1 over the number."""
        _, s, _ = self.value.xgcd(self.field.polynomial)
        return self.field.number(s)

    def __truediv__(self, other: object) -> Any:
        if isinstance(other, Algebraic):
            return self * other.inverse()
        value = self._other(other)
        return NotImplemented if value is None else self.field.number(self.value / value)

    def __rtruediv__(self, other: object) -> Any:
        return self.inverse() * other

    def __pow__(self, exponent: int) -> Any:
        base: Any = self if exponent >= 0 else self.inverse()
        found: Any = 1
        for bit in bin(abs(exponent))[2:]:
            found = found * found * (base if bit == "1" else 1)
        return found

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Algebraic) and other.field is self.field and other.value == self.value

    def __hash__(self) -> int:
        return hash((id(self.field), str(self.value)))

    def __bool__(self) -> bool:
        return True

    def __str__(self) -> str:
        return to_text(self.field.expression(self))

    def __repr__(self) -> str:
        return f"<{self}>"

    @property
    def denominator(self) -> int:
        """A common denominator of the coefficients."""
        return int(self.value.denom())

    def coefficients(self) -> tuple[Fraction, ...]:
        """Those of 1, α, …, α^{d−1}."""
        found = [Fraction(int(c.p), int(c.q)) for c in self.value.coeffs()]
        return (*found, *([Fraction(0)] * (self.field.degree - len(found))))

    def residue(self) -> int:
        """The number modulo the prime p of the field's `split`; 0 where p is in a denominator."""
        prime, root = self.field.split
        total = 0
        for c in reversed(self.coefficients()):
            if not c.denominator % prime:
                return 0
            total = (total * root + c.numerator * pow(c.denominator, -1, prime)) % prime
        return total


def exact(value: Any) -> Any:
    """An int or a Fraction as a Fraction; a number of a field as it is.

    >>> exact(2)
    Fraction(2, 1)
    """
    return value if isinstance(value, Algebraic) else Fraction(value)


def height(value: Any) -> int:
    """How long a number is to write: the sizes of numerators and denominators.

    >>> height(Fraction(-3, 2))
    5
    """
    parts = value.coefficients() if isinstance(value, Algebraic) else (Fraction(value),)
    return sum(abs(v.numerator) + v.denominator for v in parts)


def rational(value: Fraction) -> fmpq:
    """A Fraction for flint."""
    return fmpq(value.numerator, value.denominator)


def _listed(value: Any) -> list[str]:
    return [str(c) for c in value.coefficients()] if isinstance(value, Algebraic) else [str(value)]


def _interval(field: NumberField, bits: int) -> tuple[Fraction, Fraction]:
    """Rational numbers around the real root of the field, and no other root: the polynomial changes sign."""
    from flint import ctx

    assert field.real is not None
    kept, ctx.prec = ctx.prec, bits + 48
    try:
        ball = field.real()
        (low, e), (high, d) = (v.man_exp() for v in (ball.lower(), ball.upper()))
    finally:
        ctx.prec = kept
    width = Fraction(1, 2**bits)
    return Fraction(int(low)) * Fraction(2) ** int(e) - width, Fraction(int(high)) * Fraction(2) ** int(
        d
    ) + width


def _coefficients(node: Node, name: str) -> list[fmpq] | None:
    """The coefficients of a polynomial in one variable; None if it is none of degree up to `DEGREE`."""

    def rule(node: Node, args: list[Any]) -> Any:
        if node.kind == "variable":
            return fmpq_poly([0, 1])
        if node.kind == "number":
            return fmpq_poly([rational(node.value)])
        if any(a is None or a.degree() > DEGREE for a in args):
            return None
        if node.kind in {"add", "sub", "mul"}:
            a, b = args
            return a + b if node.kind == "add" else a - b if node.kind == "sub" else a * b
        if node.kind == "neg":
            return -args[0]
        if node.kind == "div" and not variables(node.args[1:]) and args[1]:
            return args[0] / args[1][0]
        if node.kind == "pow" and node.value.denominator == 1 and 0 <= node.value <= DEGREE:
            return args[0] ** int(node.value)
        return None

    found = fold([node], rule)[0]
    return None if found is None or not 1 <= found.degree() <= DEGREE else list(found.coeffs())
