"""Numbers of twice a double's digits, sums of two doubles, for what has to be right to its last bit.

T. J. Dekker, *A floating-point technique for extending the available precision*, Numer. Math. 18 (1971): the
rounding errors of sums and products of doubles are doubles.  Errors are some units of 2⁻¹⁰⁴ of the result.
Infinite and undefined numbers come out as NaN.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from osculant.kernels.jit import kernel

#: times a double, it leaves the upper half of its digits
SPLITTER = 2.0**27 + 1.0


class Pair(NamedTuple):
    """The number high + low; high is the nearest double."""

    high: float
    low: float


@kernel
def normal(high: float, low: float) -> Pair:
    """The sum of two numbers, the first of which is the larger."""
    total = high + low
    return Pair(total, low - (total - high))


@kernel
def sum_of(a: float, b: float) -> Pair:
    """The exact sum of two doubles.

    >>> sum_of(1.0, 2.0**-60)
    Pair(high=1.0, low=8.673617379884035e-19)
    """
    total = a + b
    other = total - a
    return Pair(total, (a - (total - other)) + (b - other))


@kernel
def product_of(a: float, b: float) -> Pair:
    """The exact product of two doubles below 2⁹⁹⁶."""
    total, wide, other = a * b, SPLITTER * a, SPLITTER * b
    high, above = wide - (wide - a), other - (other - b)
    low, below = a - high, b - above
    return Pair(total, ((high * above - total) + high * below + low * above) + low * below)


@kernel
def add(a: Pair, b: Pair) -> Pair:
    """a + b."""
    upper, lower = sum_of(a.high, b.high), sum_of(a.low, b.low)
    total = normal(upper.high, upper.low + lower.high)
    return normal(total.high, total.low + lower.low)


@kernel
def negative(a: Pair) -> Pair:
    """−a."""
    return Pair(-a.high, -a.low)


@kernel
def subtract(a: Pair, b: Pair) -> Pair:
    """a − b."""
    return add(a, negative(b))


@kernel
def multiply(a: Pair, b: Pair) -> Pair:
    """ab."""
    total = product_of(a.high, b.high)
    return normal(total.high, total.low + (a.high * b.low + a.low * b.high))


@kernel
def times(a: Pair, b: float) -> Pair:
    """ab with a double b."""
    total = product_of(a.high, b)
    return normal(total.high, total.low + a.low * b)


@kernel
def divide(a: Pair, b: Pair) -> Pair:
    """a/b.

    >>> divide(Pair(1.0, 0.0), Pair(3.0, 0.0))
    Pair(high=0.3333333333333333, low=1.850371707708594e-17)
    """
    first = a.high / b.high
    rest = subtract(a, times(b, first))
    second = rest.high / b.high
    rest = subtract(rest, times(b, second))
    return add(normal(first, second), Pair(rest.high / b.high, 0.0))


@kernel
def root(a: Pair) -> Pair:
    """√a, by one step of Newton's method from the double's root."""
    if a.high == 0.0:
        return a
    first = math.sqrt(a.high)
    rest = subtract(a, product_of(first, first))
    return normal(first, rest.high / (2.0 * first))
