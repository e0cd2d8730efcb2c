"""Enclosed suprema of rational functions on an interval, with bounded work.

The coefficients are balls, so a function that is known up to a remainder is covered too: ``sⁿ`` with a wide
coefficient is any function between its two bounds. On a box with centre c and radius ρ the quotient p/q with
q > 0 is λ + g/q, where λ = p(c)/q(c) and g = p − λq starts with 0; of g's expansion in (s − c)/ρ ∈ [−1, 1]
the terms to second order are maximised exactly and the rest is added up. What is lost is of third order in ρ,
so that a maximum is enclosed to 10⁻⁶ from boxes of about a hundredth.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

from flint import arb, arb_poly

#: all of [−1, 1], as a centre and a radius
WHOLE = ((0.0, 1.0),)


@dataclass(frozen=True)
class Supremum:
    """An upper bound, and a value attained: a lower bound of it, at an exact place."""

    upper: Any
    attained: Any
    at: Any


def supremum(
    numerator: Any,
    denominator: Any,
    goal: Callable[[Any], Any],
    boxes: Sequence[tuple[Any, Any]] = WHOLE,
    work: int = 60,
) -> Supremum:
    """The supremum of the quotient of two polynomials, the denominator being positive.

    Args:
        numerator: an ``arb_poly``.
        denominator: likewise; at most 0 somewhere, there is no bound.
        goal: of the largest value attained so far: an upper bound that is good enough.
        boxes: (centre, radius) of intervals that cover where the supremum is taken.
        work: how often a box may be halved; after that the bound is what it is.

    Returns the bounds, not finite if the denominator was not seen to be positive.

    Guarantee: every value of the quotient, whatever the coefficients in their balls, is at most ``upper``;
    the value at ``at`` is at least ``attained`` for some, or all, of them.

    >>> wave = supremum(arb_poly([0, 1, -1]), arb_poly([1]), lambda attained: attained + 1e-9, work=40)
    >>> wave.upper < 0.25 + 1e-8, wave.attained > 0.25 - 1e-8, abs(wave.at - 0.5) < 1e-3
    (True, True, True)
    """
    order = count()
    heap: list[tuple[float, int, _Box]] = []
    best = Supremum(arb.neg_inf(), arb.neg_inf(), arb(0))

    def look(centre: Any, radius: Any) -> None:
        nonlocal best
        box = _box(numerator, denominator, arb(centre), arb(radius))
        if box.attained > best.attained:
            best = Supremum(best.upper, box.attained, box.centre)
        heapq.heappush(heap, (-_key(box.upper), next(order), box))

    for centre, radius in boxes:
        look(centre, radius)
    for _ in range(work):
        worst = heap[0][2]
        if worst.upper <= goal(best.attained):
            break
        heapq.heappop(heap)
        half = worst.radius / 2
        look(worst.centre - half, half)
        look(worst.centre + half, half)
    upper = heap[0][2].upper
    for _, _, box in heap:  # the keys are rounded
        upper = upper.max(box.upper)
    return Supremum(upper, best.attained, best.at)


def shortened(coefficients: Sequence[Any], degree: int) -> list[Any]:
    """A polynomial on [−1, 1] with all terms beyond a degree put into that of the degree, as a ball.

    >>> shortened([arb(1), arb(2), arb(3)], 1)[1].contains(5)
    True
    """
    if len(coefficients) <= degree + 1:
        return list(coefficients)
    # |sᵏ| ≤ |s|ⁿ for k > n, with any sign
    rest = sum((abs(c).upper() for c in coefficients[degree + 1 :]), arb(0)).upper()
    return [*coefficients[:degree], coefficients[degree] + (-rest).union(rest)]


@dataclass(frozen=True)
class _Box:
    centre: Any
    radius: Any
    upper: Any
    attained: Any


def _box(numerator: Any, denominator: Any, centre: Any, radius: Any) -> _Box:
    inner = arb_poly([centre, radius])
    p, q = _coefficients(numerator(inner)), _coefficients(denominator(inner))
    least = q[0] - _absolute(q[1:])
    value = p[0] / q[0]
    unknown = not (least > 0 and value.is_finite())
    if unknown:
        return _Box(centre, radius, arb.pos_inf(), arb.neg_inf())
    level = arb(value.mid())
    g = [a - level * b for a, b in zip(p, q)] + p[len(q) :] + [-level * b for b in q[len(p) :]]
    excess = _quadratic(g).upper()
    if not excess <= 0:  # NaN must not pass for a bound
        level += excess / least.lower()
    return _Box(centre, radius, level.upper(), value.lower())


def _quadratic(g: list[Any]) -> Any:
    """An upper bound of g on [−1, 1]: its first three terms exactly, the others as multiples of s²."""
    slope = abs(g[1]).upper() if len(g) > 1 else arb(0)
    bend = (g[2] + _absolute(g[3:])).upper() if len(g) > 2 else arb(0)
    if 2 * bend <= -slope:
        return g[0] - (slope * slope / (4 * bend) if bend < 0 else 0)
    return g[0] + slope + bend


def _coefficients(polynomial: Any) -> list[Any]:
    return polynomial.coeffs() or [arb(0)]


def _absolute(values: Sequence[Any]) -> Any:
    return sum((abs(value).upper() for value in values), arb(0))


def _key(upper: Any) -> float:
    value = float(upper)
    return math.inf if math.isnan(value) else value
