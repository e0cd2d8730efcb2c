"""The elementary functions of formulas for pairs of doubles (`osculant.kernels.standalone.pairs`).

The exponential, sine and cosine are sums of their series after a reduction of the argument, the others one
step of Newton's method from libm's value, which squares its error.  Errors are about 2⁻¹⁰⁰, absolute where a
logarithm or an inverse function is near 0; arguments of sine and cosine beyond 2³⁰ lose digits.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from osculant.kernels.generated.constants import HALF_PI, LOG_2
from osculant.kernels.jit import kernel
from osculant.kernels.standalone.pairs import Pair, add, divide, multiply, negative, root, subtract, times

#: terms of the sine and cosine together; halvings of the exponential's argument, and terms of it
TERMS, HALVINGS, SHORT = 30, 9, 9
#: beyond which the exponential overflows, and below which it is 0
LARGEST, SMALLEST = 709.0, -700.0
#: from here on tanh is ±1; below this a series is summed for sinh
FLAT, NEAR = 40.0, 0.5
#: near ±1 the inverse sine has a steep slope
STEEP = 0.7


def _inverse_factorials() -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    found = np.empty((TERMS, 2))
    for k in range(TERMS):
        exact = Fraction(1, math.factorial(k))
        found[k] = float(exact), float(exact - Fraction(float(exact)))
    return found


#: 1/k!, as pairs
INVERSE_FACTORIALS = _inverse_factorials()


@kernel
def series(x: Pair, square: Pair, first: int, last: int) -> Pair:
    """x·(1/first! + square/(first + 2)! + … ) up to 1/last!."""
    total = Pair(0.0, 0.0)
    for k in range(last, first - 1, -2):
        total = add(multiply(total, square), Pair(INVERSE_FACTORIALS[k, 0], INVERSE_FACTORIALS[k, 1]))
    return multiply(total, x)


@kernel
def less(x: Pair, multiple: float, parts: tuple[float, float, float]) -> Pair:
    """x less a multiple of the sum of three doubles."""
    for part in parts:
        x = subtract(x, times(Pair(part, 0.0), multiple))
    return x


@kernel
def sine_cosine(x: Pair) -> tuple[Pair, Pair]:
    """(sin x, cos x)."""
    quarter = float(math.floor(x.high / HALF_PI[0] + 0.5))
    rest = less(x, quarter, HALF_PI)
    square = negative(multiply(rest, rest))
    s, c = series(rest, square, 1, TERMS - 1), series(Pair(1.0, 0.0), square, 0, TERMS - 2)
    turn = quarter - 4.0 * math.floor(0.25 * quarter)
    if turn == 1.0:
        return c, negative(s)
    if turn == 2.0:
        return negative(s), negative(c)
    if turn == 3.0:
        return negative(c), s
    return s, c


@kernel
def sine(x: Pair) -> Pair:
    """sin x.

    >>> sine(Pair(1.0, 0.0))
    Pair(high=0.8414709848078965, low=1.776845092935533e-18)
    """
    return sine_cosine(x)[0]


@kernel
def cosine(x: Pair) -> Pair:
    """cos x."""
    return sine_cosine(x)[1]


@kernel
def tangent(x: Pair) -> Pair:
    """tan x."""
    s, c = sine_cosine(x)
    return divide(s, c)


@kernel
def exponential(x: Pair) -> Pair:
    """exp x."""
    if not (x.high < LARGEST and x.high > SMALLEST):
        return Pair(math.exp(x.high), 0.0)
    multiple = math.floor(x.high / LOG_2[0] + 0.5)
    rest = times(less(x, float(multiple), LOG_2), 2.0**-HALVINGS)
    total = Pair(0.0, 0.0)
    for k in range(SHORT, 0, -1):  # the exponential less 1
        total = multiply(add(total, Pair(INVERSE_FACTORIALS[k, 0], INVERSE_FACTORIALS[k, 1])), rest)
    for _ in range(HALVINGS):
        total = add(times(total, 2.0), multiply(total, total))
    total = add(total, Pair(1.0, 0.0))
    half = multiple // 2
    return times(times(total, 2.0**half), 2.0 ** (multiple - half))


@kernel
def logarithm(x: Pair) -> Pair:
    """log x."""
    y = math.log(x.high) if x.high > 0.0 else math.nan
    rest = subtract(multiply(x, exponential(Pair(-y, 0.0))), Pair(1.0, 0.0))
    return add(Pair(y, 0.0), subtract(rest, times(multiply(rest, rest), 0.5)))


@kernel
def hyperbolic_sine(x: Pair) -> Pair:
    """sinh x."""
    if abs(x.high) < NEAR:
        return series(x, multiply(x, x), 1, TERMS - 1)
    e = exponential(x)
    return times(subtract(e, divide(Pair(1.0, 0.0), e)), 0.5)


@kernel
def hyperbolic_cosine(x: Pair) -> Pair:
    """cosh x."""
    e = exponential(x)
    return times(add(e, divide(Pair(1.0, 0.0), e)), 0.5)


@kernel
def hyperbolic_tangent(x: Pair) -> Pair:
    """tanh x."""
    if abs(x.high) > FLAT:
        return Pair(math.copysign(1.0, x.high), 0.0)
    return divide(hyperbolic_sine(x), hyperbolic_cosine(x))


@kernel
def inverse_tangent(x: Pair) -> Pair:
    """atan x."""
    y = Pair(math.atan(x.high), 0.0)
    s, c = sine_cosine(y)
    return add(y, divide(subtract(multiply(x, c), s), add(c, multiply(x, s))))


@kernel
def quarter_turn() -> Pair:
    """π/2."""
    return add(Pair(HALF_PI[0], 0.0), Pair(HALF_PI[1], HALF_PI[2]))


@kernel
def small_inverse_sine(x: Pair) -> Pair:
    """asin x where that is not steep."""
    y = Pair(math.asin(x.high) if abs(x.high) <= 1.0 else math.nan, 0.0)
    s, c = sine_cosine(y)
    return add(y, divide(subtract(x, s), c))


@kernel
def complement(x: Pair) -> Pair:
    """acos |x| = 2 asin √((1 − |x|)/2)."""
    size = x if x.high > 0.0 else negative(x)
    half = times(subtract(Pair(1.0, 0.0), size), 0.5)
    return times(small_inverse_sine(root(half)), 2.0) if half.high >= 0.0 else Pair(math.nan, math.nan)


@kernel
def inverse_sine(x: Pair) -> Pair:
    """asin x."""
    if abs(x.high) <= STEEP:
        return small_inverse_sine(x)
    y = subtract(quarter_turn(), complement(x))
    return y if x.high > 0.0 else negative(y)


@kernel
def inverse_cosine(x: Pair) -> Pair:
    """acos x."""
    if abs(x.high) <= STEEP:
        return subtract(quarter_turn(), small_inverse_sine(x))
    y = complement(x)
    return y if x.high > 0.0 else subtract(times(quarter_turn(), 2.0), y)


@kernel
def inverse_hyperbolic_sine(x: Pair) -> Pair:
    """asinh x."""
    size = x if x.high >= 0.0 else negative(x)
    y = logarithm(add(size, root(add(multiply(x, x), Pair(1.0, 0.0)))))
    return y if x.high >= 0.0 else negative(y)


@kernel
def inverse_hyperbolic_cosine(x: Pair) -> Pair:
    """acosh x."""
    one = Pair(1.0, 0.0)
    return logarithm(add(x, root(multiply(subtract(x, one), add(x, one)))))


@kernel
def inverse_hyperbolic_tangent(x: Pair) -> Pair:
    """atanh x."""
    one = Pair(1.0, 0.0)
    return times(logarithm(divide(add(one, x), subtract(one, x))), 0.5)


@kernel
def cube_root(x: Pair) -> Pair:
    """The real cube root of x."""
    y = Pair(float(np.cbrt(x.high)), 0.0)
    if y.high == 0.0:
        return y
    square = multiply(y, y)
    return subtract(y, divide(subtract(multiply(square, y), x), times(square, 3.0)))


@kernel
def sign(x: Pair) -> Pair:
    """±1, NaN at 0."""
    return Pair(math.copysign(1.0, x.high) if x.high != 0.0 else math.nan, 0.0)


@kernel
def power(x: Pair, exponent: Pair) -> Pair:
    """x to a power, for x > 0."""
    if x.high == 0.0 and exponent.high > 0.0:
        return Pair(0.0, 0.0)
    return exponential(multiply(logarithm(x), exponent))
