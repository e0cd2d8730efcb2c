"""Circular and helical arcs for formats that have no other curves, and chords for helices.

The vertices of chords lie outside the helix and their middles inside, both by the same distance d, so that
chords of the length √(16d/κ) do where those between points of the helix are √(8d/κ) long. They run on over
consecutive arcs, and only at the ends of such a run are vertices on the helix itself.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from osculant.cas.errors import DomainError, ToleranceError
from osculant.files.motions import Arc
from osculant.pieces.chain import conic_arcs
from osculant.pieces.helices import HelixArc

if TYPE_CHECKING:
    from osculant.pieces.chain import Chain
    from osculant.pieces.conics import Piece
    from osculant.pieces.piece import Arc as PieceArc
    from osculant.pieces.piece import Coordinates

#: arcs whose tangents differ by more meet at a corner
CORNER = 0.05
#: of the outward distance, as the middles of chords on a helix are a little farther in
SAFE = 0.98
#: of the tolerance: chords need that much at least
LEAST_ROOM = 0.1


def circular_arcs(chain: Chain, what: str) -> list[Piece]:
    """The arcs of a chain in the plane, all of circles or lines; none if the chain is in space.

    Args:
        chain: the pieces of a spline.
        what: the format that has no others, as the error begins.

    Raises:
        DomainError: an arc of another kind.
    """
    if chain.dimension == 3:
        return []
    arcs = conic_arcs(chain.pieces)
    for arc in arcs:
        if arc.kind not in ("segment", "arc"):
            raise DomainError(
                f"{what} has lines and circular arcs, and the piece on {arc.interval} is of kind "
                f"{arc.kind!r}: approximate with biarcs."
            )
    return arcs


def helical_arcs(chain: Chain) -> list[HelixArc]:
    """The arcs of a chain in space; none if it is in the plane."""
    return [arc for arc in chain.arcs if isinstance(arc, HelixArc)]


def sliding(arcs: Sequence[PieceArc]) -> list[Coordinates | None]:
    """For each arc the tangent at its end if the next arc goes on in that direction, else None."""
    found: list[Coordinates | None] = []
    for arc, after in zip(arcs, [*arcs[1:], None]):
        tangent = arc.tangent(1.0)
        smooth = after is not None and float(np.linalg.norm(after.tangent(0.0) - tangent)) < CORNER
        found.append(tuple(tangent.tolist()) if smooth else None)
    return found


def chords_needed(chord_square: float, tolerance: float) -> int:
    """Return how many equal chords keep a helical arc with this κL² within a tolerance.

    On a chord of arc length h the arc is at most κh²/8 away.

    >>> chords_needed(1.0, 1e-3)
    12
    """
    return max(1, math.ceil(math.sqrt(chord_square / (8 * tolerance))))


def check_room(room: float, tolerance: float) -> None:
    """Raises ToleranceError if there is hardly room for curves that stand for others.

    Args:
        room: how far they may be from the pieces.
        tolerance: of the spline, as a length.
    """
    if room < LEAST_ROOM * tolerance:
        raise ToleranceError(
            f"The pieces leave {room:.3g} of the tolerance {tolerance:.3g} for lines and arcs that stand for "
            "helices: name the file when approximating, so that the search leaves more."
        )


def balanced_chords(
    arcs: Sequence[HelixArc], ends: Sequence[float], allowed: float
) -> tuple[list[Coordinates], list[float]]:
    """The vertices of chords along consecutive helical arcs after the first point, and their parameters.

    Args:
        arcs: with curvature, each starting where the one before ends with the same tangent.
        ends: the curve's parameters where they begin and end.
        allowed: how far chords may be from the arcs.

    """
    rates = [math.sqrt(arc.curvature / (16 * SAFE * allowed)) for arc in arcs]
    reached = np.cumsum([0.0, *(rate * arc.length for rate, arc in zip(rates, arcs))])
    # the first and the last chord, with one vertex on the helix, are shorter: (1 + √½)/2 of the others
    count = math.ceil(float(reached[-1]) + 2 - math.sqrt(2) - 1e-9) if reached[-1] > 1 else 1
    if math.sqrt(2) * reached[-1] <= count - 1 + 1e-9:
        count = max(1, math.ceil(math.sqrt(2) * reached[-1]))
    short = (1 + math.sqrt(0.5)) / 2 if count > 2 else 1.0
    widths = np.array([short, *[1.0] * (count - 2), short][:count])
    places = np.cumsum(widths) / widths.sum() * reached[-1]
    points: list[Coordinates] = []
    at: list[float] = []
    for place in places[:-1].tolist():
        i = min(max(int(np.searchsorted(reached, place)) - 1, 0), len(arcs) - 1)
        u = (place - reached[i]) / (reached[i + 1] - reached[i])
        out = SAFE * allowed * arcs[i].normal(u)
        points.append(tuple((arcs[i].point(u) - out).tolist()))
        at.append(float(ends[i] + u * (ends[i + 1] - ends[i])))
    return [*points, tuple(arcs[-1].end)], [*at, float(ends[-1])]


def circle_turn(arc: Piece) -> Arc:
    """Return a circular arc in the plane."""
    cx, cy = arc.legs[2]
    half = arc.turning / 2
    chord = math.hypot(cx, cy)
    sine = math.sin(half)
    radius = chord / (2 * abs(sine)) if sine else math.inf

    def point(fraction: float) -> tuple[float, float]:
        if fraction == 1.0 or not sine:
            return (arc.start[0] + fraction * cx, arc.start[1] + fraction * cy) if fraction < 1 else arc.end
        size, angle = math.sin(fraction * half) / sine, (fraction - 1) * half
        u, v = size * math.cos(angle), size * math.sin(angle)
        return arc.start[0] + u * cx - v * cy, arc.start[1] + u * cy + v * cx

    square = chord * 2 * half**2 / abs(sine) if sine else 0.0  # κL² = L·2|half|
    return Arc(point, 2, 2 * half, radius, square)


def helix_turn(arc: HelixArc, tilt: float) -> Arc | None:
    """Return a helical arc about a coordinate axis, or None if tilting it there moves a point by more."""
    axis = max(range(3), key=lambda k: abs(arc.axis[k]))
    away = math.hypot(*(arc.axis[k] for k in range(3) if k != axis))
    if away * arc.length > tilt:
        return None
    turning = math.copysign(arc.turning, arc.axis[axis])
    return Arc(_points(arc), axis, turning, arc.radius, arc.curvature * arc.length**2)


def _points(arc: HelixArc) -> Callable[[float], Sequence[float]]:
    def point(fraction: float) -> Sequence[float]:
        found: list[float] = arc.point(fraction).tolist()
        return found

    return point
