"""Exact rational numbers of bounded size: decimal literals, powers, roots, never computed beyond `BITS`."""

from __future__ import annotations

import math
import re
from fractions import Fraction

from osculant.cas.errors import DomainError, FormulaError

#: bits that a numerator or a denominator may have
BITS = 4096


def bounded(q: Fraction) -> Fraction:
    """The number q itself; FormulaError if it needs more than `BITS` bits.

    >>> bounded(Fraction(1, 10))
    Fraction(1, 10)
    """
    if _bits(q) > BITS:
        raise _too_large()
    return q


def _bits(q: Fraction) -> int:
    return max(q.numerator.bit_length(), q.denominator.bit_length())


def _too_large() -> FormulaError:
    return FormulaError(f"A number of this formula needs more than {BITS} bits; use smaller numbers.")


def as_double(q: Fraction) -> float:
    """The nearest double, infinite beyond all.

    >>> as_double(Fraction(1, 4)), as_double(-Fraction(10) ** 400)
    (0.25, -inf)
    """
    try:
        return float(q)
    except OverflowError:
        return math.inf if q > 0 else -math.inf


def shown(q: Fraction) -> str:
    """A number as messages write it: in words if it is long.

    >>> shown(Fraction(-1, 3)), shown(Fraction(3**50))
    ('-1/3', 'of that size')
    """
    return str(q) if _bits(q) <= 64 else "of that size"


def decimal(text: str) -> Fraction:
    """The exact rational that a decimal literal such as "1.5e-3" writes, its size checked before computing.

    >>> decimal("0.1"), decimal("-2.50e2")
    (Fraction(1, 10), Fraction(-250, 1))
    """
    match = re.fullmatch(r"([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?)0*(\d+))?", text, re.ASCII)
    if match is None or not match[2] + match[3]:
        raise FormulaError(f"{text!r} is not a decimal number; write for instance 0.5 or 1e-6.")
    sign, whole, part, exponent_sign, exponent = match.groups(default="")
    digits = (whole + part).lstrip("0")
    if not digits:
        return Fraction(0)
    significant = digits.rstrip("0")
    limit = BITS * 0.30103 + 1  # decimal digits
    if len(significant) > limit or len(exponent) > 6:
        raise _too_large()
    scale = int(exponent_sign + (exponent or "0")) - len(part) + len(digits) - len(significant)
    if abs(scale) > limit:
        raise _too_large()
    return Fraction(int(sign + significant)) * Fraction(10) ** scale


def exact_power(base: Fraction, exponent: Fraction) -> Fraction | None:
    """The real power base**exponent if it is rational, None if it is not.

    DomainError for 0 under a negative exponent and for a negative base under one that is not an integer;
    FormulaError if the power would outgrow `BITS`, which is seen before computing it.

    >>> exact_power(Fraction(8), Fraction(-2, 3)), exact_power(Fraction(2), Fraction(1, 2))
    (Fraction(1, 4), None)
    """
    if base == 0 and exponent < 0:
        raise DomainError(f"Division by zero: 0 has no power {shown(exponent)}.")
    if base < 0 and exponent.denominator > 1:
        raise DomainError(f"{shown(base)} has no real power {shown(exponent)}; cbrt is the real cube root.")
    if (_bits(base) - 1) * abs(exponent) >= BITS:  # a lower bound of the result's bits, before computing it
        raise _too_large()
    root = exact_root(base, exponent.denominator)
    return None if root is None else bounded(root**exponent.numerator)


def exact_root(q: Fraction, degree: int) -> Fraction | None:
    """The rational r with r**degree == q, and r >= 0 where the degree is even, if there is one.

    >>> exact_root(Fraction(-8, 27), 3), exact_root(Fraction(2), 2)
    (Fraction(-2, 3), None)
    """
    if q < 0:
        root = exact_root(-q, degree) if degree % 2 else None
        return None if root is None else -root
    above, below = _integer_root(q.numerator, degree), _integer_root(q.denominator, degree)
    return None if above is None or below is None else Fraction(above, below)


def _integer_root(n: int, degree: int) -> int | None:
    if n <= 1 or degree == 1:
        return n
    if degree >= n.bit_length():  # 1 < the root < 2
        return None
    if degree == 2:
        root = math.isqrt(n)
    else:  # Newton's iteration from above descends to the floor of the root
        root, step = 0, 1 << -(-n.bit_length() // degree)
        while root == 0 or step < root:
            root, step = step, ((degree - 1) * step + n // step ** (degree - 1)) // degree
    return root if root**degree == n else None
