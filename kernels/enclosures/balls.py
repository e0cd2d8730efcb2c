"""Arithmetic of enclosures: a double and a radius, within which the true value lies.

Results are rounded to the nearest double, and the radius is made larger by what that may cost; no rounding
modes.  What has no finite enclosure has a radius that is infinite or NaN, and so has all that is made of it.
Elementary functions are taken to be right to `LIBRARY` units of rounding, 8 ulps: those of today's C
libraries are within 4.
"""

from __future__ import annotations

import math

import numpy as np

from osculant.kernels.jit import kernel

#: half an ulp of 1; what a radius is short of at most after some roundings, in parts and absolutely
UNIT, SPARE, LEAST = 2.0**-53, 1.0 + 2.0**-48, 2.0**-1060
#: errors of the C library's functions, in units
LIBRARY = 16.0
#: a ball is narrow if a function's values change by less than this part of them
NARROW = 0.05
#: codes of the elementary functions, as in tables of programs
NAMES = (
    *("sin", "cos", "exp", "log", "sqrt", "tan", "sinh", "cosh", "tanh", "atan", "atanh", "asin", "acos"),
    *("asinh", "acosh", "cbrt", "sign"),
)
(SIN, COS, EXP, LOG, SQRT, TAN, SINH, COSH, TANH, ATAN, ATANH, ASIN, ACOS, ASINH, ACOSH, CBRT, SIGN) = range(
    len(NAMES)
)

Ball = tuple[float, float]


@kernel
def rounded(value: float, radius: float, units: float) -> Ball:
    """A ball whose middle was computed to so many units."""
    return value, (radius + abs(value) * units * UNIT + LEAST) * SPARE


@kernel
def is_finite(ball: Ball) -> bool:
    """Whether the ball encloses anything.

    >>> is_finite((1.0, 2.0)), is_finite((1.0, math.inf)), is_finite((math.nan, 1.0))
    (True, False, False)
    """
    return abs(ball[0]) + ball[1] < math.inf


@kernel
def excludes_zero(ball: Ball) -> bool:
    """Whether 0 is surely not inside."""
    return abs(ball[0]) > ball[1]


@kernel
def add(a: Ball, b: Ball) -> Ball:
    """a + b."""
    return rounded(a[0] + b[0], a[1] + b[1], 1.0)


@kernel
def sub(a: Ball, b: Ball) -> Ball:
    """a − b."""
    return rounded(a[0] - b[0], a[1] + b[1], 1.0)


@kernel
def mul(a: Ball, b: Ball) -> Ball:
    """a·b."""
    return rounded(a[0] * b[0], abs(a[0]) * b[1] + a[1] * (abs(b[0]) + b[1]), 1.0)


@kernel
def div(a: Ball, b: Ball) -> Ball:
    """a/b; without a finite radius where b may be 0."""
    quotient, least = a[0] / b[0], abs(b[0]) - b[1] * SPARE
    if not least > 0.0:
        return math.nan, math.inf
    return rounded(quotient, (a[1] + abs(quotient) * b[1]) / least * SPARE, 2.0)


@kernel
def _between(one: float, other: float) -> Ball:
    """The ball around two values of the library's."""
    size = max(abs(one), abs(other))
    return 0.5 * one + 0.5 * other, (0.5 * abs(one - other) + (LIBRARY + 2.0) * UNIT * size + LEAST) * SPARE


@kernel
def power(a: Ball, exponent: float) -> Ball:
    """a**exponent for a > 0, the exponent a double that may be rounded itself."""
    low, high = (a[0] - a[1]) * (1.0 - 2.0 * UNIT), (a[0] + a[1]) * (1.0 + 2.0 * UNIT)
    if not (low > 0.0 and high < math.inf):
        return math.nan, math.inf
    one, other = low**exponent, high**exponent
    middle, radius = _between(one, other)
    # what rounding of the exponent costs
    bent = 4.0 * UNIT * abs(exponent) * max(abs(math.log(low)), abs(math.log(high)))
    return middle, (radius + bent * max(one, other)) * SPARE


@kernel
def _value(name: int, x: float) -> float:
    """The elementary function of that code at a double, NaN beyond its domain."""
    if name == SIN:
        return math.sin(x)
    if name == COS:
        return math.cos(x)
    if name == EXP:
        return math.exp(x)
    if name == LOG:
        return math.log(x) if x > 0.0 else math.nan
    if name == SQRT:
        return math.sqrt(x) if x >= 0.0 else math.nan
    if name == TAN:
        return math.tan(x)
    if name == SINH:
        return math.sinh(x)
    if name == COSH:
        return math.cosh(x)
    if name == TANH:
        return math.tanh(x)
    if name == ATAN:
        return math.atan(x)
    if name == ATANH:
        return math.atanh(x) if abs(x) < 1.0 else math.nan
    if name == ASIN:
        return math.asin(x) if abs(x) <= 1.0 else math.nan
    if name == ACOS:
        return math.acos(x) if abs(x) <= 1.0 else math.nan
    if name == ASINH:
        return math.asinh(x)
    if name == ACOSH:
        return math.acosh(x) if x >= 1.0 else math.nan
    if name == CBRT:
        return float(np.cbrt(x))
    return math.copysign(1.0, x) if x != 0.0 else math.nan


@kernel
def _steepest(name: int, m: float, r: float) -> float:
    """A bound of a monotone function's slopes within r of m; infinite where it may have none."""
    far, near = (abs(m) + r) * SPARE, max(0.0, abs(m) - r)
    steepest = math.inf
    if name == EXP:
        steepest = math.exp(m + r)
    elif name == LOG and m > r:
        steepest = 1.0 / (m - r)
    elif name == SQRT and m > r:
        steepest = 0.5 / math.sqrt(m - r)
    elif name == TAN:
        least = abs(math.cos(m)) - r
        steepest = 1.0 / (least * least) if least > 0.05 * r else math.inf
    elif name == SINH:
        steepest = math.cosh(far)
    elif name == TANH:
        below = math.cosh(near)
        steepest = 1.0 / (below * below)
    elif name == ATAN:
        steepest = 1.0 / (1.0 + near * near)
    elif name == ATANH and far < 1.0:
        steepest = 1.0 / ((1.0 - far) * (1.0 + far))
    elif name in (ASIN, ACOS) and far < 1.0:
        steepest = 1.0 / math.sqrt((1.0 - far) * (1.0 + far))
    elif name == ASINH:
        steepest = 1.0 / math.sqrt(1.0 + near * near)
    elif name == ACOSH and m - r > SPARE:
        least = m - r - SPARE
        steepest = 1.0 / math.sqrt(least * (least + 2.0))
    elif name == CBRT and near > 0.0:
        root = np.cbrt(near)
        steepest = 1.0 / (3.0 * root * root)
    elif name == SIGN and near > 0.0:
        steepest = 0.0
    return steepest * (1.0 + 64.0 * UNIT)


@kernel
def function(name: int, a: Ball) -> Ball:
    """An elementary function by its code."""
    if not is_finite(a):
        return math.nan, math.inf
    m, r = a[0], a[1] * SPARE
    value = _value(name, m)
    if name in (SIN, COS):  # |f(m + h) − f(m)| ≤ |f′(m)||h| + h²/2
        slope = abs(_value(SIN + COS - name, m))
        return rounded(value, min(2.0, r * (slope + 0.5 * r) * (1.0 + 64.0 * UNIT)), LIBRARY)
    if name == COSH:
        near, far = max(0.0, abs(m) - r), (abs(m) + r) * SPARE
        if r > NARROW:
            return _between(math.cosh(near), math.cosh(far))
        return rounded(value, r * math.sinh(far) * (1.0 + 64.0 * UNIT), LIBRARY)
    spread = r * _steepest(name, m, r) if r > 0.0 else 0.0
    if spread <= NARROW * abs(value):
        return rounded(value, spread, LIBRARY)
    if spread == math.inf and name not in (CBRT, EXP, SINH):
        return math.nan, math.inf
    # of a wide ball the values at the ends tell more: the function is monotone
    return _between(_value(name, (m - r) - UNIT * abs(m)), _value(name, (m + r) + UNIT * abs(m)))
