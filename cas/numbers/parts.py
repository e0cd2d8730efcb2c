"""Where a curve has its features: parts on which it is a polynomial, as nearly as one likes.

Samples of a curve cannot tell what it does between them; balls can.  On a part where the last term of
Taylor's formula is below an accuracy, every coordinate is its Taylor polynomial about the middle up to that
accuracy; where all tangents are within a right angle, it does not turn back.  A few samples there miss
nothing larger.
"""

from __future__ import annotations

import math
from collections import deque
from itertools import pairwise
from typing import Any

from flint import arb

from osculant.cas.numbers.balls import FormulaBalls, precision

#: the order of the last term, bits of the balls, parts at first
ORDER, BITS, FIRST = 8, 64, 16
#: parts are halved down to this part of the whole, and in all so many are looked at
NARROWEST, WORK_LIMIT = 2.0**-44, 20_000
#: vectors that are within so much of one, in parts of its length, are within a right angle of each other
STRAIGHT = math.sqrt(0.5)


def polynomial_parts(curve: FormulaBalls[Any], low: float, high: float, accuracy: float) -> list[float]:
    """The edges of parts of [low, high] on which the curve is a polynomial and does not turn back.

    Args:
        curve: its coordinates in ball arithmetic.
        low: one end, a double,
        high: and the other.
        accuracy: how far from a polynomial of degree `ORDER` − 1 a coordinate may be at most, and how large a
            part on which the curve may turn back.

    Returns:
        Increasing doubles, from low to high.  Wide parts are halved first; where the curve is singular, and
        beyond `WORK_LIMIT`, parts are left as they are, so that the work is bounded.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> bump = CurveBalls(parse_tuple("t, exp(-((t - 1/3)/10^-5)^2)/1000"))
    >>> edges = polynomial_parts(bump, 0.0, 1.0, 1e-9)
    >>> narrowest = min((b - a, a) for a, b in zip(edges, edges[1:]))
    >>> narrowest[0] < 1e-5, abs(narrowest[1] - 1 / 3) < 1e-4, len(edges) < 200
    (True, True, True)
    """
    return [edge for edge, _ in levels(curve, low, high, accuracy)]


def levels(curve: FormulaBalls[Any], low: float, high: float, accuracy: float) -> list[tuple[float, float]]:
    """(edge, accuracy below which it is one) of `polynomial_parts` for all accuracies down to one."""
    edges = dict.fromkeys([*(low + (high - low) * i / FIRST for i in range(FIRST)), high], math.inf)
    least = NARROWEST * (high - low)
    pending = deque((a, b, math.inf) for a, b in pairwise(edges))
    with precision(BITS):
        for _ in range(WORK_LIMIT):
            if not pending:
                break
            a, b, level = pending.popleft()
            middle, half = 0.5 * (a + b), 0.5 * (b - a)
            level = min(level, clearness(curve, middle, half))
            if half < least or not a < middle < b or level <= accuracy:
                continue
            edges[middle] = level
            pending += [(a, middle, level), (middle, b, level)]
    return sorted(edges.items())


def clearness(curve: FormulaBalls[Any], middle: float, half: float) -> float:
    """Down to what accuracy a part is no feature of the curve; infinite where a coefficient is not finite.

    The last term of Taylor's formula about the middle is at most so large; and either all tangents are within
    a right angle, so that the curve does not turn back, or the part as a whole is as small.
    """
    largest, length, velocity, doubt = 0.0, 0.0, 0.0, 0.0
    for row in curve.coefficients(arb(middle, half), ORDER):
        size = float(abs(row[ORDER]).upper()) * half**ORDER
        first = row[1]
        if not all(term.is_finite() for term in row):
            return math.inf
        largest = max(largest, size)
        velocity = math.hypot(velocity, float(first.mid()))
        doubt = math.hypot(doubt, float(first.rad()))
        length += 2.0 * half * float(abs(first).upper())
    return largest if doubt <= STRAIGHT * velocity else max(largest, length)
