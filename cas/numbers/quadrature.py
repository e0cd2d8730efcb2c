"""Quadrature of densities in ball arithmetic: double exponential, halved where it does not settle."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from flint import arb

from osculant.cas.errors import UndecidedError
from osculant.cas.numbers.balls import PRECISION, precision

#: steps of the quadrature are 2^−COARSEST … 2^−FINEST; then the interval is halved, DEPTH times at most
COARSEST, FINEST, DEPTH = 1, 6, 24
#: steps that agree to this end the quadrature; the error after the last is less by this factor
AGREEMENT = 1e-10
#: nodes nearer to an end than this part of the interval are left out: at the worst end singularity,
#: t^(−2/5), they weigh less than 1e-18
NEAREST = 1e-32


def integral(density: Callable[[Any], Any], low: Any, high: Any) -> tuple[Any, float]:
    """(∫ density, estimated error) over [low, high]: double exponential, halved where it does not settle.

    At flint's current precision, which should be `PRECISION`. Raises UndecidedError, naming the place, if the
    finest step of the smallest interval does not settle it: the integral may diverge there.

    >>> with precision(PRECISION):
    ...     value, error = integral(lambda t: 1 / t.sqrt(), arb(0), arb(4))
    >>> round(float(value), 12), error < 1e-15
    (4.0, True)
    """
    total, error, parts = arb(0), 0.0, [(low, high, 0)]
    while parts:
        a, b, depth = parts.pop()
        value, change = double_exponential(density, a, b)
        if change <= AGREEMENT * max(abs(float(value)), abs(float(total))):
            total, error = total + value, error + change * AGREEMENT
        elif depth == DEPTH:
            raise UndecidedError(
                f"The complexity integral did not settle near t = {float(a):.10g}: split there."
            )
        else:  # a singularity beside the real line: it is relatively farther from each half
            middle = (a + b) / 2
            parts += [(middle, b, depth + 1), (a, middle, depth + 1)]
    return total, error


def double_exponential(density: Callable[[Any], Any], low: Any, high: Any) -> tuple[Any, float]:
    """(∫ density, change at the last halving of the step) over [low, high] by tanh-sinh quadrature.

    Every halving squares the relative error, so the change should be about the square of the one before. The
    larger of both is returned: two steps may agree by chance.

    >>> with precision(PRECISION):
    ...     value, change = double_exponential(lambda t: t.sqrt(), arb(0), arb(1))
    >>> abs(float(value) - 2 / 3) < 1e-15, change < 1e-10
    (True, True)
    """
    total, value, size = arb(0), arb(0), high - low
    latest = change = float("inf")
    for level in range(COARSEST, FINEST + 1):
        for near, weight in nodes(level):
            total += weight * density(low + size * near)
            if near < 0.5:
                total += weight * density(high - size * near)
        previous, value, before = value, total * size * arb(2) ** -level, latest
        latest, height = abs(float(value - previous)), abs(float(value))
        change = max(latest, before * (before / height) if height else before)
        if change <= AGREEMENT * height:
            break
    return value, change


@cache
def nodes(level: int) -> tuple[tuple[Any, Any], ...]:
    """(distance from the nearer end of [0, 1], weight) of the nodes that are new at step 2^−level.

    >>> len(nodes(3)) > 10
    True
    """
    with precision(PRECISION):
        step, pi = arb(2) ** -level, arb.pi()
        found: list[tuple[Any, Any]] = []
        index = 0
        while True:
            if level == COARSEST or index % 2:
                u = step * index
                near = 1 / (1 + (pi * u.sinh()).exp())
                if near < NEAREST:
                    return tuple(found)
                found.append((near, pi * u.cosh() * near * (1 - near)))
            index += 1
