"""Vectors of space with three components of any numbers: sums, multiples and products."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from osculant.cas.errors import DomainError

Vector3 = tuple[Any, Any, Any]


def _in_space(*vectors: Sequence[Any]) -> None:
    """Refuse what has not three coordinates."""
    for vector in vectors:
        if len(vector) != 3:
            raise DomainError(f"A vector of space has three coordinates, but {vector} has {len(vector)}.")


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """⟨a, b⟩ of two vectors of three numbers; like all functions here, raises DomainError for other vectors.

    >>> dot((1, 2, 3), (4, 5, 6))
    32
    """
    _in_space(a, b)
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Sequence[Any], b: Sequence[Any]) -> Vector3:
    """a × b.

    >>> cross((1, 0, 0), (0, 1, 0))
    (0, 0, 1)
    """
    _in_space(a, b)
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def det(a: Sequence[Any], b: Sequence[Any], c: Sequence[Any]) -> Any:
    """The determinant ⟨a × b, c⟩, positive for a positively oriented triple.

    >>> det((1, 0, 0), (0, 1, 0), (5, 5, 2))
    2
    """
    return dot(cross(a, b), c)


def scale(factor: Any, a: Sequence[Any]) -> Vector3:
    """factor·a.

    >>> scale(2, (1, 2, 3))
    (2, 4, 6)
    """
    _in_space(a)
    return factor * a[0], factor * a[1], factor * a[2]


def add(*vectors: Sequence[Any]) -> Vector3:
    """The sum of one or more vectors.

    >>> add((1, 2, 3), (4, 5, 6), (0, 0, 1))
    (5, 7, 10)
    """
    if not vectors:
        raise DomainError("A sum of no vectors has no kind of number: give at least one vector.")
    _in_space(*vectors)
    x, y, z = vectors[0]
    for a in vectors[1:]:
        x, y, z = x + a[0], y + a[1], z + a[2]
    return x, y, z


def subtract(a: Sequence[Any], b: Sequence[Any]) -> Vector3:
    """a − b.

    >>> subtract((4, 5, 6), (1, 2, 3))
    (3, 3, 3)
    """
    _in_space(a, b)
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]
