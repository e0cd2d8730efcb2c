"""Products of vectors of the plane, of any numbers."""

from __future__ import annotations

from typing import Any

Vector = tuple[Any, Any]


def bracket(v: Vector, w: Vector) -> Any:
    """The determinant [v, w].

    >>> bracket((1, 0), (3, 2))
    2
    """
    return v[0] * w[1] - v[1] * w[0]


def dot(v: Vector, w: Vector) -> Any:
    """⟨v, w⟩.

    >>> dot((1, 0), (3, 2))
    3
    """
    return v[0] * w[0] + v[1] * w[1]
