"""Pieces that are cubic Bézier curves, tangent to the curve at both ends.

    B(u) = (1−u)³P₀ + 3(1−u)²u P₁ + 3(1−u)u² P₂ + u³P₃,

evaluated from the nearer end, so that a distant origin costs no figures.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.pieces.conics import Point

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike

    from osculant.pieces.piece import Floats

#: nodes of the rule for lengths, and the halvings of the parameter's interval
NODES, HALVINGS = 16, 12
#: two values of a length that agree to this part of it
AGREED = 1e-14


@dataclass(frozen=True)
class Cubic:
    """A cubic Bézier curve that stands for the curve on one parameter interval.

    Attributes:
        interval: the curve's parameters at both ends.
        start: first control point P₀.
        controls: the two inner ones, P₁ and P₂.
        end: last control point P₃.
        error: Hausdorff distance to the curve, or the area between, as estimated; 0 if the piece is exact.

    >>> hill = Cubic((0.0, 1.0), (0.0, 0.0), ((0.0, 2.0), (2.0, 2.0)), (2.0, 0.0), 1e-3)
    >>> hill.point(0.5), hill.bounding_box(), hill.numbers
    (array([1. , 1.5]), ((0.0, 0.0), (2.0, 1.5)), 6)
    """

    interval: tuple[float, float]
    start: Point
    controls: tuple[Point, Point]
    end: Point
    error: float

    #: what curve it is
    kind = "cubic"

    @cached_property
    def arcs(self) -> tuple[Cubic]:
        """The arcs it is made of: itself."""
        return (self,)

    @property
    def share(self) -> float:
        """The part of the piece that belongs to the first of `arcs`: all."""
        return 1.0

    @property
    def arc_ends(self) -> tuple[float, float]:
        """The curve's parameters where `arcs` begin and end: the interval."""
        return self.interval

    @property
    def numbers(self) -> int:
        """How many numbers store it if its start is known: three points."""
        return 6

    @staticmethod
    def together(arcs: Sequence[Cubic]) -> Callable[[Any, Floats], Floats]:
        """Return a function that evaluates many cubics at once, for arrays of their indices and of u."""
        points = np.array([arc._points for arc in arcs])
        return lambda i, u: _combine(u[..., None], *np.moveaxis(points[i], -2, 0))

    @cached_property
    def _points(self) -> Floats:
        return np.array([self.start, *self.controls, self.end], dtype=np.float64)

    def point(self, u: ArrayLike) -> Floats:
        """Return B(u); exactly the end points at u = 0 and u = 1.

        Args:
            u: the cubic's own parameter in [0, 1], an array of any shape.

        Returns:
            Points, of u's shape with a last axis of length 2.
        """
        return _combine(np.asarray(u, dtype=np.float64)[..., None], *self._points)

    def velocity(self, u: ArrayLike) -> Floats:
        """Return B′(u), of u's shape with a last axis of length 2."""
        u = np.asarray(u, dtype=np.float64)[..., None]
        first, middle, last = np.diff(self._points, axis=0)
        v = 1 - u
        rate: Floats = 3 * (v * v * first + 2 * u * v * middle + u * u * last)
        return rate

    def tangent(self, u: ArrayLike) -> Floats:
        """Return the unit tangent at B(u), of u's shape with a last axis of length 2.

        >>> Cubic((0.0, 1.0), (0.0, 0.0), ((0.0, 2.0), (2.0, 2.0)), (2.0, 0.0), 0.0).tangent([0, 0.5])
        array([[0., 1.],
               [1., 0.]])
        """
        direction = self.velocity(u)
        direction = direction / np.abs(direction).max(axis=-1, keepdims=True)  # squares must not underflow
        unit: Floats = direction / np.hypot(direction[..., :1], direction[..., 1:])
        return unit

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points B(u) with u equally spaced and both ends included; shape (n, 2)."""
        return self.point(np.linspace(0.0, 1.0, n))

    @cached_property
    def length(self) -> float:
        """The arc length, by Gauss's rule on halves until it no longer changes.

        >>> Cubic((0.0, 1.0), (0.0, 0.0), ((1.0, 0.0), (2.0, 0.0)), (3.0, 0.0), 0.0).length
        3.0
        """
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        value = math.inf
        for halvings in range(HALVINGS):
            parts = 2**halvings
            u = (np.arange(parts)[:, None] + (nodes + 1) / 2) / parts
            before, value = value, float((np.hypot(*np.moveaxis(self.velocity(u), -1, 0)) @ weights).sum())
            value /= 2 * parts
            if abs(value - before) <= AGREED * value:
                break
        return value

    def bounding_box(self) -> tuple[Point, Point]:
        """Return the lower and upper corners from the cubic's extreme points themselves, not from samples."""
        sides = []
        for axis in (0, 1):
            values = [self.start[axis], self.end[axis]]
            values += [float(self.point(u)[axis]) for u in _turns(np.diff(self._points[:, axis]))]
            sides.append((min(values), max(values)))
        (left, right), (bottom, top) = sides
        return (left, bottom), (right, top)

    def to_json(self) -> dict[str, Any]:
        """Return the piece as plain lists and numbers, as in the JSON of a spline: "points" has all four.

        >>> Cubic((0.0, 1.0), (0.0, 0.0), ((0.0, 2.0), (2.0, 2.0)), (2.0, 0.0), 0.0).to_json()["points"]
        [[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]]
        """
        return {
            "kind": self.kind,
            "interval": [float(end) for end in self.interval],
            "points": self._points.tolist(),
            "error": float(self.error),
        }


def _combine(u: Floats, p0: Floats, p1: Floats, p2: Floats, p3: Floats) -> Floats:
    """Evaluate cubics from their nearer end; u has a last axis of length 1, points one of length 2."""
    v = 1 - u
    outer, inner = 3 * u * v * v, 3 * u * u * v
    from_start = p0 + (outer * (p1 - p0) + inner * (p2 - p0) + u * u * u * (p3 - p0))
    from_end = p3 + (inner * (p2 - p3) + outer * (p1 - p3) + v * v * v * (p0 - p3))
    return np.where(u <= 0.5, from_start, from_end)


def _turns(steps: Floats) -> list[float]:
    """Where in (0, 1) (1−u)²s₀ + 2u(1−u)s₁ + u²s₂ is 0, without cancellation."""
    largest = float(np.abs(steps).max())
    if largest == 0:
        return []
    a, b, c = (float(step) / largest for step in steps)
    discriminant = b * b - a * c
    if discriminant < 0:
        return []
    q = -(b + math.copysign(math.sqrt(discriminant), b))
    ratios = [a / q if q else 0.0, q / c if c else 0.0]  # u/(1−u)
    return [r / (1 + r) for r in ratios if 0 < r < math.inf]
