"""What a file draws, as read back from its own numbers: strokes, end to end.

A stroke is a rational Bézier curve of degree three at most, which segments, parabolas, cubics and arcs of
conics are, or a turn: a motion about an axis whose radius and height grow evenly with the angle. All strokes
of a file are evaluated at once.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from osculant.pieces.piece import Coordinates, Floats

DEGREE = 3
Whole = np.ndarray[Any, np.dtype[np.integer[Any]]]


class Bezier(NamedTuple):
    """A rational Bézier curve.

    Attributes:
        points: its control points, two to four.
        weights: of these; all 1 if empty.
    """

    points: tuple[Coordinates, ...]
    weights: tuple[float, ...] = ()


class Turn(NamedTuple):
    """A motion about an axis through a centre, parallel to one of the coordinates'.

    Attributes:
        centre: any point of the axis.
        axis: its number; 2 in the plane.
        radii: at the start and at the end.
        angles: likewise, measured from the coordinate after the axis towards the one after that.
        heights: along the axis, likewise; of no meaning in the plane.
    """

    centre: Coordinates
    axis: int
    radii: tuple[float, float]
    angles: tuple[float, float]
    heights: tuple[float, float] = (0.0, 0.0)


Stroke: TypeAlias = Bezier | Turn


class Path:
    """Strokes as one curve over [0, n]: the i-th over [i, i + 1].

    Args:
        strokes: at least one, all in the plane or all in space.

    >>> quarter = Turn((2.0, 1.0), 2, (1.0, 1.0), (-math.pi / 2, 0.0))
    >>> corner = Path([Bezier(((0.0, 0.0), (2.0, 0.0))), quarter])
    >>> corner.at(np.array([0.25, 2.0])).tolist()
    [[0.5, 0.0], [3.0, 1.0]]
    """

    def __init__(self, strokes: Sequence[Stroke]) -> None:
        self.count = len(strokes)
        first = strokes[0]
        self.dimension = len(first.points[0] if isinstance(first, Bezier) else first.centre)
        self._turns = np.array([isinstance(stroke, Turn) for stroke in strokes])
        self._place = np.where(self._turns, np.cumsum(self._turns), np.cumsum(~self._turns)) - 1
        curves = [elevated(stroke) for stroke in strokes if isinstance(stroke, Bezier)]
        self._curves = np.array(curves).reshape(len(curves), DEGREE + 1, self.dimension + 1)
        rows = [_row(stroke) for stroke in strokes if isinstance(stroke, Turn)]
        self._rows = np.array(rows).reshape(len(rows), 9)
        self._axes = np.array([stroke.axis for stroke in strokes if isinstance(stroke, Turn)], dtype=int)

    def at(self, s: Floats) -> Floats:
        """The points at parameters of shape (m,), of shape (m, dimension)."""
        i = np.clip(np.floor(s).astype(int), 0, self.count - 1)
        return self.on(i, s - i)

    def on(self, i: Whole, f: Floats) -> Floats:
        """The points of the strokes of indices i at fractions f, both of shape (m,)."""
        turns = self._turns[i]
        out = np.empty((len(i), self.dimension))
        if turns.any():
            out[turns] = self._turned(self._place[i[turns]], f[turns])
        if not turns.all():
            out[~turns] = self._bent(self._place[i[~turns]], f[~turns])
        return out

    def _bent(self, j: Whole, f: Floats) -> Floats:
        """Points of Bézier curves, by de Casteljau's rule from the nearer end."""
        points = self._curves[j]
        f = f[:, None, None]
        for _ in range(DEGREE):
            points = points[:, :-1] + f * (points[:, 1:] - points[:, :-1])
        found: Floats = points[:, 0, :-1] / points[:, 0, -1:]
        return found

    def _turned(self, j: Whole, f: Floats) -> Floats:
        """Points of turns."""
        rows, axes = self._rows[j], self._axes[j]
        centre, (r0, r1, a0, a1, h0, h1) = rows[:, :3], rows[:, 3:].T
        radius, angle = r0 + f * (r1 - r0), a0 + f * (a1 - a0)
        points = centre.copy()
        k = np.arange(len(j))
        points[k, (axes + 1) % 3] += radius * np.cos(angle)
        points[k, (axes + 2) % 3] += radius * np.sin(angle)
        points[k, axes] = h0 + f * (h1 - h0)
        found: Floats = points[:, : self.dimension]
        return found


def _row(turn: Turn) -> list[float]:
    """A turn as numbers, in space."""
    return [*(*turn.centre, 0.0)[:3], *turn.radii, *turn.angles, *turn.heights]


def elevated(curve: Bezier) -> list[list[float]]:
    """The homogeneous control points of a Bézier curve as one of degree three."""
    weights = curve.weights or (1.0,) * len(curve.points)
    points = [[*(w * x for x in point), w] for point, w in zip(curve.points, weights, strict=True)]
    while (n := len(points)) <= DEGREE:
        inner = [[i / n * x + (1 - i / n) * y for x, y in zip(points[i - 1], points[i])] for i in range(1, n)]
        points = [points[0], *inner, points[-1]]
    return points


def bulged(start: Coordinates, end: Coordinates, turning: float) -> Bezier:
    """The circular arc between two points of the plane that turns by less than π.

    >>> bulged((1.0, 0.0), (0.0, 1.0), math.pi / 2).points[1]
    (1.0, 1.0)
    """
    tangent = math.tan(turning / 2) / 2
    (x0, y0), (x1, y1) = start, end
    dx, dy = x1 - x0, y1 - y0
    control = (x0 + dx / 2 + tangent * dy, y0 + dy / 2 - tangent * dx)
    return Bezier((start, control, end), (1.0, math.cos(turning / 2), 1.0))


def elliptic(
    centre: Coordinates,
    p: Coordinates,
    q: Coordinates,
    first: float,
    last: float,
    ends: Sequence[Coordinates],
) -> Bezier:
    """The arc centre + p·cos φ + q·sin φ, first <= φ <= last < first + π, between these end points."""
    half, middle = (last - first) / 2, (first + last) / 2
    weight = math.cos(half)
    control = tuple(
        c + (u * math.cos(middle) + v * math.sin(middle)) / weight for c, u, v in zip(centre, p, q)
    )
    return Bezier((tuple(ends[0]), control, tuple(ends[1])), (1.0, weight, 1.0))
