"""Points of an arc that belong to one of a curve, in doubles: what certificates choose their maps by."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

#: steps, and the change of the parameter that ends them
STEPS, SETTLED = 60, 1e-17

Pair = tuple[float, float]


class Moving(Protocol):
    """An arc X, as far as searches along it need one."""

    def at(self, v: float) -> tuple[Pair, Pair]:
        """X(v) − X(0) and X′(v), rounded."""


def nearest(arc: Moving, point: Pair, tangent: Pair, low: float, high: float) -> float:
    """About where the distance of an arc from a point is least between two parameters: a foot.

    Args:
        arc: the arc X.
        point: of the curve, less X(0).
        tangent: of the curve there, of any length; it does not matter here.
        low: the least parameter.
        high: the largest.
    """

    def along(v: float) -> tuple[float, float]:
        (x, y), (dx, dy) = arc.at(v)
        return (point[0] - x) * dx + (point[1] - y) * dy, dx * dx + dy * dy

    return crossing(along, low, high)


def opposite(arc: Moving, point: Pair, tangent: Pair, low: float, high: float) -> float:
    """About where the curve's normal at a point meets an arc between two parameters.

    The arguments are those of `nearest`.  Beyond the centres of curvature of the arc there are points of the
    curve with no foot that moves on as they do; but these may.
    """

    def along(v: float) -> tuple[float, float]:
        (x, y), (dx, dy) = arc.at(v)
        ahead = (point[0] - x) * tangent[0] + (point[1] - y) * tangent[1]
        return ahead, dx * tangent[0] + dy * tangent[1]

    return crossing(along, low, high)


def crossing(along: Callable[[float], tuple[float, float]], low: float, high: float) -> float:
    """Where a function changes from positive to negative, by Newton's method or bisection.

    Args:
        along: v → (the function, about what it falls by a unit of v).
        low: the least parameter.
        high: the largest.

    >>> crossing(lambda v: (0.25 - v, 1.0), 0.0, 1.0)
    0.25
    """
    v = (low + high) / 2
    for _ in range(STEPS):
        ahead, speed = along(v)
        low, high = (v, high) if ahead > 0 else (low, v)
        new = v + ahead / speed if speed > 0 else low
        if not low <= new <= high:
            new = (low + high) / 2
        if abs(new - v) <= SETTLED or not high > low:
            return new
        v = new
    return v
