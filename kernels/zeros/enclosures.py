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
def power(a: Ball, exponent: float) -> Ball:
    """a**exponent for a > 0, the exponent a double that may be rounded itself."""
    low, high = (a[0] - a[1]) * (1.0 - 2.0 * UNIT), (a[0] + a[1]) * SPARE
    if not (low > 0.0 and high < math.inf):
        return math.nan, math.inf
    value = a[0] ** exponent
    steepest = abs(exponent) * max(low ** (exponent - 1.0), high ** (exponent - 1.0))
    bent = abs(exponent * math.log(a[0]))  # what rounding of the exponent costs
    return rounded(value, a[1] * steepest * (1.0 + 64.0 * UNIT), LIBRARY + 2.0 * bent)


@kernel
def _spread(name: int, m: float, r: float) -> Ball:
    """(value, how far it changes within r), without roundings, of the elementary function of that code."""
    far, near = (abs(m) + r) * SPARE, max(0.0, abs(m) - r)
    if name == SIN:
        return math.sin(m), min(2.0, r * (abs(math.cos(m)) + 0.5 * r))
    if name == COS:
        return math.cos(m), min(2.0, r * (abs(math.sin(m)) + 0.5 * r))
    if name == EXP:
        value = math.exp(m)
        return value, value * r * (1.0 + r) if r < 1.0 else math.exp(m + r)
    if name == LOG:
        return math.log(m), (r / (m - r) if m > r else math.inf)
    if name == SQRT:
        return math.sqrt(m), (r / (math.sqrt(m) + math.sqrt(m - r)) if m >= r and m > 0.0 else math.inf)
    if name == TAN:
        least = abs(math.cos(m))
        return math.tan(m), (r / (least * (least - r)) if least > 1.05 * r else math.inf)
    if name == SINH:
        return math.sinh(m), r * math.cosh(far)
    if name == COSH:
        return math.cosh(m), r * math.sinh(far)
    if name == TANH:
        below = math.cosh(near)
        return math.tanh(m), min(2.0, r / (below * below))
    if name == ATAN:
        return math.atan(m), min(4.0, r / (1.0 + near * near))
    if name == ATANH:
        return (math.atanh(m), r / ((1.0 - far) * (1.0 + far))) if far < 1.0 else (math.nan, math.inf)
    if name in (ASIN, ACOS):
        value = math.asin(m) if name == ASIN else math.acos(m)
        return (value, r / math.sqrt((1.0 - far) * (1.0 + far))) if far < 1.0 else (math.nan, math.inf)
    if name == ASINH:
        return math.asinh(m), r / math.sqrt(1.0 + near * near)
    if name == ACOSH:
        least = m - r - SPARE
        return (math.acosh(m), r / math.sqrt(least * (least + 2.0))) if least > 0.0 else (math.nan, math.inf)
    if name == CBRT:
        root = np.cbrt(near)
        return np.cbrt(m), (r / (3.0 * root * root) if near > 0.0 else 2.0 * np.cbrt(far))
    if name == SIGN and near > 0.0:
        return math.copysign(1.0, m), 0.0
    return math.nan, math.inf


@kernel
def function(name: int, a: Ball) -> Ball:
    """An elementary function by its code."""
    if not is_finite(a):
        return math.nan, math.inf
    value, spread = _spread(name, a[0], a[1] * SPARE)
    if not spread < math.inf:
        return math.nan, math.inf
    # its slopes at doubles are right to some units as well
    return rounded(value, spread * (1.0 + 64.0 * UNIT), LIBRARY)
