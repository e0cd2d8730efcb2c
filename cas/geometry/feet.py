"""The foot of a perpendicular on an arc, in doubles: what certificates choose their maps by."""

from __future__ import annotations

from collections.abc import Callable

#: steps, and the change of the parameter that ends them
STEPS, SETTLED = 60, 1e-17


def foot_between(along: Callable[[float], tuple[float, float]], low: float, high: float) -> float:
    """About where the distance from a point p to an arc X is least between two parameters.

    Where ⟨p − X(v), X′(v)⟩ changes sign, by Newton's method without the curvature's part, or bisection.

    Args:
        along: v → (⟨p − X(v), X′(v)⟩, |X′(v)|²).
        low: the least parameter.
        high: the largest.

    >>> foot_between(lambda v: (0.25 - v, 1.0), 0.0, 1.0)
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
