"""Zeros of a function of one real variable between bounds, in mpmath numbers at its current precision."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from mpmath import mp

from osculant.cas.errors import UndecidedError

#: Newton steps beside the halvings that the precision may need
STEPS = 60


def root_between(function: Callable[[Any], Any], low: Any, high: Any, enough: Any = 0) -> Any:
    """A zero of a continuous function between two parameters of opposite sign, to the working precision.

    Regula falsi after Anderson and Björck; it ends sooner where the function is at most ``enough``.

    >>> mp.nstr(root_between(lambda t: t * t - 2, mp.mpf(1), mp.mpf(2)), 12)
    '1.41421356237'
    """
    at_low, at_high = function(low), function(high)
    narrow = 4 * mp.eps * (abs(low) + abs(high))
    for _ in range(8 * mp.dps):
        if min(abs(at_low), abs(at_high)) <= enough or abs(high - low) <= narrow:
            break
        t = (low * at_high - high * at_low) / (at_high - at_low)
        value = function(t)
        if value * at_high <= 0:
            low, at_low = high, at_high
        else:  # the end that stays counts for less, so the other side is met soon
            factor = 1 - value / at_high
            at_low *= factor if factor > 0 else mp.mpf(1) / 2
        high, at_high = t, value
    return low if abs(at_low) < abs(at_high) else high


def increasing_root(f: Callable[[Any], tuple[Any, Any]], low: Any, high: Any, start: Any) -> Any:
    """A point of [low, high] where f changes from negative to positive: Newton's method, or else halving.

    Args:
        f: gives the value and the derivative.
        low: f < 0 is expected here; where it is not, the end nearest to a root is returned.
        high: likewise, f > 0.
        start: first guess.

    Raises UndecidedError if neither settles, or f is not a number somewhere.

    >>> print(increasing_root(lambda x: (x * x - 2, 2 * x), mp.mpf(0), mp.mpf(2), mp.mpf(1)))
    1.41421356237309
    """
    x, settled = start, mp.eps * 64 * max(abs(low), abs(high))
    for _ in range(STEPS + mp.prec):
        value, slope = f(x)
        if mp.isnan(value):
            break
        if value < 0:
            low = x
        else:
            high = x
        new = x - value / slope if slope > 0 else low
        if slope > 0 and abs(new - x) <= settled:
            return new
        if not low < new < high:
            new = (low + high) / 2
            if high - low <= settled:
                return new
        x = new
    raise UndecidedError(f"No root was settled near {mp.nstr(x, 10)}: start nearer to it.")
