"""Small pieces between two frames, whatever the curve does in between: for arcs that lie below the tolerance.

Nothing is fitted. A piece only has to be tangent at both ends and small: with the arms hT₀ and hT₁ laid off
from both ends, q₀ = p₀ + hT₀ and q₁ = p₁ − hT₁, everything stays near the polygon p₀ q₀ q₁ p₁.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from osculant.pieces.biarcs import Biarc
from osculant.pieces.conics import Piece
from osculant.pieces.helices import HelixArc, SpacePiece

if TYPE_CHECKING:
    from collections.abc import Callable

#: arms as long as this, in chords, or longer, are too long for one piece
LONGEST = 2.0
#: the cosine of an angle by which there is no turning without room
STRAIGHT_BACK = -0.99
#: below this, in parts of a chord, there is no direction
NO_LENGTH = 1e-6

Interval = tuple[float, float]
Vector = tuple[float, ...]
#: a point and the unit tangent there
End = tuple[Vector, Vector]


def parabolas(interval: Interval, start: End, end: End, error: float) -> list[Any]:
    """The parabola between two frames of the plane if their tangents meet ahead, else two.

    >>> [piece.kind for piece in parabolas((0, 1), ((0, 0), (1, 0)), ((1, 1), (0, 1)), 0.1)]
    ['parabola']
    >>> len(parabolas((0, 1), ((0, 0), (1, 0)), ((0, 1), (-1, 0)), 0.1))
    2
    """
    meeting = _meeting(start, end)
    if meeting is not None:
        return [Piece("parabola", interval, _pair(start[0]), _pair(end[0]), _pair(meeting), 1.0, error)]
    first, middle, last = _guide(start, end)
    a, centre, b = interval[0], (interval[0] + interval[1]) / 2, interval[1]
    return [
        Piece("parabola", (a, centre), _pair(start[0]), _pair(middle[0]), _pair(first), 1.0, error),
        Piece("parabola", (centre, b), _pair(middle[0]), _pair(end[0]), _pair(last), 1.0, error),
    ]


def biarcs(interval: Interval, start: End, end: End, error: float) -> list[Any]:
    """The biarc between two frames of the plane with arms of equal lengths, or two biarcs if they are long.

    >>> [piece] = biarcs((0, 1), ((0.0, 0.0), (1.0, 0.0)), ((1.0, 1.0), (0.0, 1.0)), 0.1)
    >>> [round(radius, 12) for radius in piece.radii]
    [1.0, 1.0]
    """

    def piece(part: Interval, first: End, middle: End, last: End) -> Any:
        bends = _bend(first, middle[0]), _bend(middle, last[0])
        points = _pair(first[0]), _pair(middle[0]), _pair(last[0])
        return Biarc("biarc", part, *points, (_pair(first[1]), _pair(middle[1])), bends, error)

    return _joined(piece, interval, start, end)


def space_arcs(interval: Interval, start: End, end: End, error: float) -> list[Any]:
    """Two circular arcs between two frames in space with arms of equal lengths, or four if they are long.

    >>> [piece] = space_arcs((0, 1), ((0, 0, 0), (1, 0, 0)), ((1, 1, 1), (0, 0, 1)), 0.1)
    >>> [arc.kind for arc in piece.arcs]
    ['arc', 'arc']
    """

    def piece(part: Interval, first: End, middle: End, last: End) -> Any:
        arcs = _space_arc(first, middle[0]), _space_arc(middle, last[0])
        lengths = [arc.length for arc in arcs]
        return SpacePiece(part, arcs, error, part[0] + (part[1] - part[0]) * lengths[0] / sum(lengths))

    return _joined(piece, interval, start, end)


def _joined(
    piece: Callable[[Interval, End, End, End], Any], interval: Interval, start: End, end: End
) -> list[Any]:
    """One pair of arcs, or two with a frame between."""
    middle = _junction(start, end)
    if middle is not None:
        return [piece(interval, start, middle, end)]
    between = _aside(start, _guide(start, end)[1], math.dist(start[0], end[0]))
    a, centre, b = interval[0], (interval[0] + interval[1]) / 2, interval[1]
    halves = ((a, centre), start, between), ((centre, b), between, end)
    found = []
    for part, first, last in halves:
        inner = _junction(first, last)
        assert inner is not None  # the tangent of the frame between leads from one arm to the other
        found.append(piece(part, first, inner, last))
    return found


def _junction(start: End, end: End) -> End | None:
    """Where arcs meet whose arms have equal lengths h: |Δ − h(T₀ + T₁)| = 2h; None if they are long."""
    chord = _between(start[0], end[0])
    total = [u + v for u, v in zip(start[1], end[1])]
    square, along, size = _dot(total, total) - 4, _dot(chord, total), _dot(chord, chord)
    # (|T₀ + T₁|² − 4)h² − 2⟨Δ, T₀ + T₁⟩h + |Δ|² = 0 has one positive root
    root = math.sqrt(max(along * along - square * size, 0.0))
    below = along + root
    h = size / below if below > 0 else math.inf
    if not h < LONGEST * math.sqrt(size):
        return None
    q0, q1 = _moved(start, h), _moved(end, -h)
    return _middle(q0, q1), _unit(_between(q0, q1))


def _guide(start: End, end: End) -> tuple[Vector, End, Vector]:
    """(q₀, the frame in the middle between q₀ and q₁, q₁) for arms of half a chord, or a third."""
    chord = math.dist(start[0], end[0])
    for part in (2.0, 3.0):
        q0, q1 = _moved(start, chord / part), _moved(end, -chord / part)
        if math.dist(q0, q1) > NO_LENGTH * chord:
            break
    return q0, (_middle(q0, q1), _unit(_between(q0, q1))), q1


def _aside(start: End, middle: End, chord: float) -> End:
    """The frame in the middle, moved aside where arcs from the start would have to turn back on the spot."""
    point, tangent = middle
    if _dot(start[1], tangent) > STRAIGHT_BACK:
        return middle
    axis = min(range(len(tangent)), key=lambda i: abs(tangent[i]))
    across = _unit(tuple((i == axis) - tangent[axis] * part for i, part in enumerate(tangent)))
    return tuple(x + chord * part / 2 for x, part in zip(point, across)), tangent


def _meeting(start: End, end: End) -> Vector | None:
    """Where the tangents of two frames of the plane meet, if that is ahead of both and not far."""
    dx, dy = _between(start[0], end[0])
    (ux, uy), (vx, vy) = start[1], end[1]
    below, chord = ux * vy - uy * vx, math.hypot(dx, dy)
    if below == 0:
        return None
    s, r = (dx * vy - dy * vx) / below, (ux * dy - uy * dx) / below
    ahead = all(NO_LENGTH * chord < arm < LONGEST * chord for arm in (s, r))
    return _moved(start, s) if ahead else None


def _bend(end: End, point: Vector) -> float:
    """The signed curvature of the arc from a frame to a point."""
    (x, y), (tx, ty) = _between(end[0], point), end[1]
    return 2 * (tx * y - ty * x) / (x * x + y * y)


def _space_arc(end: End, point: Vector) -> HelixArc:
    """The arc of a circle from a frame to a point."""
    x, y, z = _between(end[0], point)
    tx, ty, tz = end[1]
    axis = ty * z - tz * y, tz * x - tx * z, tx * y - ty * x
    size, chord = math.hypot(*axis), math.hypot(x, y, z)
    start, tangent = _triple(end[0]), _triple(end[1])
    if size <= NO_LENGTH**2 * chord:
        return HelixArc(start, tangent, tangent, 0.0, 0.0, chord)
    half = math.atan2(size, tx * x + ty * y + tz * z)
    curvature = 2 * size / (chord * chord)
    return HelixArc(start, tangent, _triple(_unit(axis)), curvature, 0.0, 2 * half / curvature)


def _between(p: Vector, q: Vector) -> Vector:
    return tuple(b - a for a, b in zip(p, q))


def _middle(p: Vector, q: Vector) -> Vector:
    return tuple((a + b) / 2 for a, b in zip(p, q))


def _moved(end: End, h: float) -> Vector:
    return tuple(a + h * u for a, u in zip(*end))


def _dot(u: Any, v: Any) -> float:
    return math.fsum(a * b for a, b in zip(u, v))


def _unit(v: Vector) -> Vector:
    length = math.hypot(*v)
    return tuple(a / length for a in v)


def _pair(v: Vector) -> tuple[float, float]:
    x, y = v
    return float(x), float(y)


def _triple(v: Vector) -> tuple[float, float, float]:
    x, y, z = v
    return float(x), float(y), float(z)
