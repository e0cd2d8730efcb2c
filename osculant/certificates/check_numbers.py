"""Numbers of a number field ℚ(α), for the checker: polynomials in α with rational coefficients.

The polynomial m of α need not be proved irreducible: what must not be 0 must be invertible modulo m, and then
it is not 0 for any root α of m. Roots of numbers, such as √2, are told as numbers of the field: that their
powers are right is computed, that they are positive at the root of m in an interval too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from typing import Any

from osculant.certificates.check_text import rational, require, spend

#: degree of a field at most
DEGREE = 24


class Field:
    """A number field as a certificate tells it.

    Args:
        told: "polynomial" (the coefficients c₀, …, c_d of m), "name" of α in formulas or None, "interval"
            with a real root of m or None, "roots" of numbers: their "degree", "of" what, and "value".
        source: the names of the variables, of which the name must be none.

    >>> field = Field({"polynomial": [-2, 0, 1], "name": "a", "interval": None, "roots": []}, ("x",))
    >>> field.generator * field.generator
    Fraction(2, 1)
    """

    def __init__(self, told: Mapping[str, Any], source: Sequence[str]) -> None:
        given = [rational(c) for c in told["polynomial"]]
        require(3 <= len(given) <= DEGREE + 1 and given[-1] != 0, "no polynomial of a number field")
        self.polynomial = [c / given[-1] for c in given]
        self.degree = len(given) - 1
        self.name = told["name"]
        require(
            self.name is None or (isinstance(self.name, str) and self.name not in source), "no name of a root"
        )
        self.generator = Algebraic(self, (Fraction(0), Fraction(1), *([Fraction(0)] * (self.degree - 2))))
        self.roots: dict[tuple[int, tuple[Fraction, ...]], Any] = {}
        interval = told["interval"]
        #: rational numbers around a real root; None if no real root is told
        self.interval: tuple[Fraction, Fraction] | None = None
        if interval is None:
            require(not told["roots"], "roots of numbers in a field that has no real root")
            return
        low, high = map(rational, interval)
        require(low < high and self._at(low) * self._at(high) < 0, "the interval is not told to have a root")
        self.interval = (low, high)
        for root in told["roots"]:
            value, of, q = self._read(root["value"]), self._read(root["of"]), root["degree"]
            require(type(q) is int and 2 <= q <= DEGREE and value**q == of, "a root of a number is wrong")
            require(_bounds(value, low, high)[0] > 0, "a root of a number is not told to be positive")
            self.roots[q, _parts(of)] = value

    def _read(self, told: Sequence[Any]) -> Any:
        values = [rational(c) for c in told]
        require(0 < len(values) <= self.degree, "a number of another field")
        return made(self, values)

    def _at(self, value: Fraction) -> Fraction:
        total = Fraction(0)
        for c in reversed(self.polynomial):
            total = total * value + c
        return total

    def positive(self, value: Any) -> bool:
        """Whether bounds tell that a number is positive at the roots in the interval; False without one."""
        return self.interval is not None and _bounds(value, *self.interval)[0] > 0

    def root(self, of: Any, degree: int) -> Any:
        """The positive root of a number; for an odd degree also the negative one. Rejects if not known."""
        known = self.roots.get((degree, _parts(of)))
        if known is None and degree % 2:
            other = self.roots.get((degree, _parts(-of)))
            known = None if other is None else -other
        require(known is not None, f"the root of {_shown(of)} is not known")
        return known


class Algebraic:
    """A number of a field that is not rational; the coefficients of 1, α, …, α^{d−1}."""

    __slots__ = ("coefficients", "field")

    def __init__(self, field: Field, coefficients: tuple[Fraction, ...]) -> None:
        self.field, self.coefficients = field, coefficients

    def _other(self, other: object) -> tuple[Fraction, ...] | None:
        if isinstance(other, Algebraic):
            return other.coefficients
        return (Fraction(other),) if isinstance(other, int | Fraction) else None

    def __add__(self, other: object) -> Any:
        b = self._other(other)
        if b is None:
            return NotImplemented
        return made(self.field, [c + (b[i] if i < len(b) else 0) for i, c in enumerate(self.coefficients)])

    def __mul__(self, other: object) -> Any:
        b = self._other(other)
        if b is None:
            return NotImplemented
        spend(len(b) * self.field.degree)
        found = [Fraction(0)] * (self.field.degree + len(b) - 1)
        for i, c in enumerate(self.coefficients):
            for j, v in enumerate(b):
                found[i + j] += c * v
        return made(self.field, found)

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, tuple(-c for c in self.coefficients))

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    __radd__, __rmul__ = __add__, __mul__

    def inverse(self) -> Any:
        """1 over the number; rejects if it has none."""
        # a = u·number, b = v·number modulo the polynomial
        a, u = _trimmed(list(self.field.polynomial)), [Fraction(0)]
        b, v = _trimmed(list(self.coefficients)), [Fraction(1)]
        while len(b) > 1:
            spend(len(a) * len(b))
            quotient, rest = _division(a, b)
            product = [Fraction(0)] * (len(quotient) + len(v) - 1)
            for i, c in enumerate(quotient):
                for j, d in enumerate(v):
                    product[i + j] += c * d
            size = max(len(u), len(product))
            padded = [[*w, *([Fraction(0)] * (size - len(w)))] for w in (u, product)]
            a, b, u, v = b, rest, v, [x - y for x, y in zip(*padded)]
        require(bool(b), "a number that has no inverse: the polynomial of the field is reducible")
        return made(self.field, [c / b[0] for c in v])

    def __truediv__(self, other: object) -> Any:
        if isinstance(other, Algebraic):
            return self * other.inverse()
        return self * (1 / Fraction(other)) if isinstance(other, int | Fraction) else NotImplemented

    def __rtruediv__(self, other: object) -> Any:
        return self.inverse() * other

    def __pow__(self, exponent: int) -> Any:
        base: Any = self if exponent >= 0 else self.inverse()
        found: Any = Fraction(1)
        for bit in bin(abs(exponent))[2:]:
            found = found * found * (base if bit == "1" else 1)
        return found

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Algebraic) and other.coefficients == self.coefficients

    def __hash__(self) -> int:
        return hash(self.coefficients)


#: the field of the certificate that is being checked
_field: ContextVar[Field | None] = ContextVar("_field", default=None)


def current() -> Field | None:
    """The field of the block `over`; None for ℚ."""
    return _field.get()


@contextmanager
def over(field: Field | None) -> Iterator[None]:
    """A block in which formulas and numbers are those of a field."""
    token = _field.set(field)
    try:
        yield
    finally:
        _field.reset(token)


def made(field: Field, coefficients: Sequence[Fraction]) -> Any:
    """The number Σ cᵢαⁱ, a Fraction if it is rational."""
    rest = list(coefficients)
    while len(rest) > field.degree:
        top, shift = rest.pop(), len(rest) - field.degree
        for i, c in enumerate(field.polynomial[:-1]):
            rest[shift + i] -= top * c
    rest += [Fraction(0)] * (field.degree - len(rest))
    return Algebraic(field, tuple(rest)) if any(rest[1:]) else rest[0]


def exact(value: Any) -> Any:
    """A whole number as a Fraction, other numbers as they are."""
    return value if isinstance(value, Algebraic) else Fraction(value)


def restricted(rows: Sequence[Mapping[int, Any]], field: Field) -> list[dict[int, Fraction]]:
    """The multiples of rows by 1, α, …, α^{d−1} as rows over ℚ: their rank is d times that of the rows."""
    found = []
    for row in rows:
        for power in range(field.degree):
            factor, entries = field.generator**power, dict[int, Fraction]()
            for c, v in row.items():
                parts = _parts(factor * v)
                entries |= {c * field.degree + i: part for i, part in enumerate(parts) if part}
            found.append(entries)
    return found


def _parts(value: Any) -> tuple[Fraction, ...]:
    return value.coefficients if isinstance(value, Algebraic) else (Fraction(value),)


def _shown(value: Any) -> str:
    return " + ".join(f"{c}*α^{i}" for i, c in enumerate(_parts(value)))


def _bounds(value: Any, low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
    """Bounds of a number for α between two rationals."""
    a, b = Fraction(0), Fraction(0)
    for c in reversed(_parts(value)):
        ends = [x * y for x in (a, b) for y in (low, high)]
        a, b = min(ends) + c, max(ends) + c
    return a, b


def _trimmed(a: list[Fraction]) -> list[Fraction]:
    while a and not a[-1]:
        a.pop()
    return a


def _division(a: list[Fraction], b: list[Fraction]) -> tuple[list[Fraction], list[Fraction]]:
    rest, quotient = list(a), [Fraction(0)] * (len(a) - len(b) + 1)
    while len(rest) >= len(b):
        shift = len(rest) - len(b)
        quotient[shift] = factor = rest[-1] / b[-1]
        for i, c in enumerate(b):
            rest[shift + i] -= factor * c
        _trimmed(rest)
    return quotient, rest
