"""Whether an arc of a plane curve is strictly convex, proved in ball arithmetic.

An arc is strictly convex if every line meets it in at most two points.  One without an inflection inside is,
if it turns by less than 2π and its chord makes angles between 0 and π with the tangents at both ends: closed
by the chord it turns once, so that every height above a line has one maximum and one minimum.  The theorems
on the least number of pieces are about such arcs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.cas.geometry.vectors import Vector, bracket, dot

if TYPE_CHECKING:
    from osculant.cas.geometry.point_distance import Coefficients

#: an arc is cut in two at most this often
CUTS = 1000


@dataclass(frozen=True)
class End:
    """An end of an arc.

    Attributes:
        at: its parameter, a ball.
        order: of the first derivative there that does not vanish: 1, but at a cusp, where the tangent is a
            limit.
    """

    at: Any
    order: int = 1


def turning(coefficients: Coefficients, low: End, high: End) -> Any:
    """How far the tangent turns from one end of an arc to the other, to the left counted positive: a ball.

    Args:
        coefficients: (ball, order) → the Taylor coefficients of both coordinates there.
        low: its beginning; derivatives below the ``order`` of an end are taken to vanish there.
        high: its end.

    Returns a ball that contains it, with whole turns; None if `CUTS` cuts did not tell.

    The arc is cut until the tangents of each part lie in a half-plane: then the angle between those at its
    ends is what it turns by.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> spiral = CurveBalls(parse_tuple("exp(t/9)*cos(t), exp(t/9)*sin(t)")).coefficients
    >>> from flint import arb
    >>> round(float(turning(spiral, End(arb(0)), End(arb(10)))), 12)
    10.0
    """
    from flint import arb

    whole = arb(0)
    before, start = low, tangent(coefficients, low, 1)
    pending, cuts = [(high, tangent(coefficients, high, -1))], 0
    while pending:
        after, end = pending[-1]
        if not _in_a_half_plane(coefficients, before, after):
            cuts += 1
            if cuts > CUTS:
                return None
            middle = End(((before.at + after.at) / 2).mid())
            pending.append((middle, tangent(coefficients, middle, 1)))
            continue
        whole += arb.atan2(bracket(start, end), dot(start, end))
        before, start = pending.pop()
    return whole


def tangent(coefficients: Coefficients, end: End, side: int) -> Vector:
    """A vector in the direction of motion at an end, seen from the arc after (side 1) or before it (−1)."""
    x, y = (row[end.order] for row in coefficients(end.at, end.order))
    sign = side ** (end.order - 1)  # α̇ ~ (t − c)^(order − 1)
    return sign * x, sign * y


def _in_a_half_plane(coefficients: Coefficients, low: End, high: End) -> bool:
    """Whether it is proved that all tangents between two places lie in one open half-plane."""
    if low.order > 1 and high.order > 1:
        return False
    singular = max(low, high, key=lambda end: end.order)
    ball = low.at.union(high.at)
    rows = coefficients(ball, singular.order + 1)
    sign = 1 if singular is low else (-1) ** (singular.order - 1)
    directions = [sign * row[singular.order] for row in rows]
    if singular.order == 1:  # by the mean value, too
        inside = coefficients(ball.mid(), 1)
        spread = (ball - ball.mid()) * 2
        nearer = [row[1] + spread * wide[2] for row, wide in zip(inside, rows)]
        directions = [_meet(one, other) for one, other in zip(directions, nearer)]
    if not all(value.is_finite() for value in directions):
        return False
    x, y = directions
    return bool(dot((x.mid(), y.mid()), (x, y)) > 0)


def _meet(one: Any, other: Any) -> Any:
    """The narrower of two balls around the same number."""
    if not one.is_finite() or (other.is_finite() and other.rad() < one.rad()):
        return other
    return one


def is_strictly_convex(coefficients: Coefficients, low: End, high: End, turned: Any) -> bool:
    """Whether an arc without inflection inside is proved to be strictly convex; False if that is open.

    Args:
        coefficients: (ball, order) → the Taylor coefficients of both coordinates there.
        low: its beginning.
        high: its end.
        turned: how far it turns, as `turning` says.

    >>> from flint import arb
    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> from osculant.cas.jets.balls import CurveBalls
    >>> spiral = CurveBalls(parse_tuple("t*cos(t), t*sin(t)")).coefficients
    >>> arcs = [(End(arb("0.2")), End(arb(b))) for b in ("3.4", "5")]
    >>> [is_strictly_convex(spiral, *ends, turning(spiral, *ends)) for ends in arcs]
    [True, False]
    """
    from flint import arb

    if turned is None:
        return False
    side = -1 if turned < 0 else 1
    start, end = tangent(coefficients, low, 1), tangent(coefficients, high, -1)
    chord = _chord(coefficients, low, high)
    return bool(
        side * turned < 2 * arb.pi() and side * bracket(start, chord) > 0 and side * bracket(chord, end) > 0
    )


def _chord(coefficients: Coefficients, low: End, high: End) -> Vector:
    """From the one end to the other."""
    (x0, y0), (x1, y1) = ((row[0] for row in coefficients(end.at, 0)) for end in (low, high))
    return x1 - x0, y1 - y0
