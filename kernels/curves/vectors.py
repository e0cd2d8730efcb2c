"""Vectors of three numbers in kernels: tuples, which stay in registers."""

from __future__ import annotations

import math

from osculant.kernels.jit import kernel

#: three coordinates
Vector = tuple[float, float, float]


@kernel
def dot(a: Vector, b: Vector) -> float:
    """⟨a, b⟩.

    >>> dot((1.0, 2.0, 3.0), (4.0, 5.0, 6.0))
    32.0
    """
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def cross(a: Vector, b: Vector) -> Vector:
    """a × b.

    >>> cross((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    (0.0, 0.0, 1.0)
    """
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel
def subtract(a: Vector, b: Vector) -> Vector:
    """a − b.

    >>> subtract((4.0, 5.0, 6.0), (1.0, 2.0, 3.0))
    (3.0, 3.0, 3.0)
    """
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@kernel
def combine(x: float, a: Vector, y: float, b: Vector) -> Vector:
    """x·a + y·b.

    >>> combine(2.0, (1.0, 0.0, 0.0), 3.0, (0.0, 1.0, 0.0))
    (2.0, 3.0, 0.0)
    """
    return x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]


@kernel
def scaled(x: float, a: Vector) -> Vector:
    """x·a.

    >>> scaled(2.0, (1.0, 2.0, 3.0))
    (2.0, 4.0, 6.0)
    """
    return x * a[0], x * a[1], x * a[2]


@kernel
def norm(a: Vector) -> float:
    """|a|.

    >>> norm((2.0, 3.0, 6.0))
    7.0
    """
    return math.sqrt(dot(a, a))


@kernel
def unit(a: Vector) -> Vector:
    """a/|a|; NaN for the zero vector.

    >>> unit((0.0, 3.0, 4.0))
    (0.0, 0.6, 0.8)
    """
    size = norm(a)
    return a[0] / size, a[1] / size, a[2] / size
