"""Tilted helices as motions of a machine: chords, and arcs about its axes whose height grows evenly.

An arc about the axis e that passes through two points of a curve with the unit tangent T can follow the part
of the curvature vector κN along e × T. The rest ρ bends away from it as all of κN does from a chord: over the
length h by |ρ|h²/8, or half of that to either side if the ends are moved by ρh²/16 outwards. So where |ρ| is
small arcs are longer than chords. Moves are chosen one after the other, each the longest of all kinds that is
within what is allowed, by its distances from points of the helices.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from osculant.files.motions import Arc
from osculant.pieces.helices import HelixArc

if TYPE_CHECKING:
    from osculant.pieces.piece import Coordinates, Floats

#: points of the helices that a move is compared with
PROBES = np.linspace(0.0, 1.0, 9)
#: an arc is tried where the law lets it be so much longer than a chord; trials of its length
LONGER, TRIALS = 1.15, 10
#: of what is allowed, for the law and between the points that are compared
SAFE = 0.97
#: the largest turning of one arc
TURNING = 2.6
#: longer runs are of chords alone
MOST_MOVES = 20_000


class Move(NamedTuple):
    """A motion: along a chord to its end, or along an arc."""

    end: Coordinates
    at: float
    arc: Arc | None


class Run:
    """Consecutive helical arcs as one curve, by its length.

    Args:
        arcs: with curvature, each starting where the one before ends with the same tangent.
        ends: the curve's parameters where they begin and end.
        allowed: how far moves may be from them.
        radii: the smallest and the largest radius of an arc.
        turning: no arc turns by so much.
    """

    def __init__(
        self,
        arcs: Sequence[HelixArc],
        ends: Sequence[float],
        allowed: float,
        radii: tuple[float, float],
        turning: float,
    ) -> None:
        self.arcs, self.ends, self.radii = arcs, ends, radii
        self.allowed, self.turning = SAFE * allowed, min(turning, TURNING)
        self.reached = np.cumsum([0.0, *(arc.length for arc in arcs)])
        self.length = float(self.reached[-1])
        self.points = HelixArc.together(arcs)

    def moves(self) -> list[Move] | None:
        """Moves along the run, each as long as may be; None if they are too many."""
        here, place = np.array(self.arcs[0].start), 0.0
        found: list[Move] = []
        while place < self.length and len(found) < MOST_MOVES:
            move, place, here = self._longest(here, place)
            found.append(move)
        return found if place >= self.length else None

    def _longest(self, here: Floats, place: float) -> tuple[Move, float, Floats]:
        """The longest move from a point beside the one at that length."""
        chord = self._law(place, None)
        best = self._reach(here, place, None, chord)
        for axis in range(3):
            guess = self._law(place, axis)
            if guess > LONGER * chord:
                found = self._reach(here, place, axis, guess)
                if found is not None and (best is None or found[1] > best[1]):
                    best = found
        if best is None:  # the last vertex is as far out as may be: a short chord does
            stop = min(self.length, place + chord / 4)
            best = self._move(here, place, stop, None)[0], stop
        move, stop = best
        return move, stop, np.array(move.end)

    def _law(self, place: float, axis: int | None) -> float:
        """The length of moves of that kind by the second order."""
        bend = float(np.linalg.norm(self._bend(place, axis)))
        return math.sqrt(16 * self.allowed / max(bend, 1e-12 / self.length))

    def _bend(self, place: float, axis: int | None) -> Floats:
        """The curvature vector but for what an arc about the axis follows."""
        i = min(max(int(np.searchsorted(self.reached, place)) - 1, 0), len(self.arcs) - 1)
        arc = self.arcs[i]
        u = (place - self.reached[i]) / arc.length
        bend: Floats = arc.curvature * arc.normal(u)
        if axis is None:
            return bend
        tangent = arc.tangent(u)
        across = np.zeros(3)
        across[(axis + 1) % 3], across[(axis + 2) % 3] = -tangent[(axis + 2) % 3], tangent[(axis + 1) % 3]
        square = float(across @ across)
        return bend - (bend @ across) / square * across if square > 1e-6 else bend

    def _reach(self, here: Floats, place: float, axis: int | None, guess: float) -> tuple[Move, float] | None:
        """The longest move of a kind that is within what is allowed, and where it ends; None if none is."""
        low, high, best = 0.0, math.inf, None
        length = min(guess, self.length - place)
        for _ in range(TRIALS):
            stop = self.length if place + length >= self.length * (1 - 1e-12) else place + length
            move, gap = self._move(here, place, stop, axis)
            if gap <= self.allowed:
                low, best = length, (move, stop)
                if stop == self.length:
                    break
            else:
                high = length
            length = 1.3 * low if math.isinf(high) else (low + high) / 2 if low else 0.75 * length
            length = min(length, self.length - place)
            if low and high < 1.02 * low:
                break
        return best

    def _move(self, here: Floats, place: float, stop: float, axis: int | None) -> tuple[Move, float]:
        """A move between two lengths, and how far it is from the run."""
        points = self._at(place + PROBES * (stop - place))
        end = points[-1]
        if stop < self.length:
            out = self._bend(stop, axis) * (stop - place) ** 2 / 16
            end = end - out * min(1.0, SAFE * self.allowed / max(float(np.linalg.norm(out)), 1e-300))
        at = self._parameter(stop)
        target = tuple(end.tolist())
        if axis is None:
            chord = (end - here) / math.dist(end, here)
            gaps = points - here
            squares = (gaps * gaps).sum(axis=1) - (gaps @ chord) ** 2
            return Move(target, at, None), math.sqrt(max(0.0, squares.max()))
        arc = circling(here, points[len(points) // 2], end, axis)
        if arc is None or not self.radii[0] <= arc.radius <= self.radii[1] or abs(arc.turning) > self.turning:
            return Move(target, at, None), math.inf
        ahead = np.empty_like(points)
        ahead[1:-1] = points[2:] - points[:-2]
        ahead[0], ahead[-1] = points[1] - points[0], points[-1] - points[-2]
        gaps = points - arc.beside(points)
        along = (gaps * ahead).sum(axis=1) ** 2 / (ahead * ahead).sum(axis=1)
        return Move(target, at, arc.arc()), math.sqrt(max(0.0, ((gaps * gaps).sum(axis=1) - along).max()))

    def _at(self, places: Floats) -> Floats:
        """Points at lengths."""
        i = np.clip(np.searchsorted(self.reached, places, side="right") - 1, 0, len(self.arcs) - 1)
        found: Floats = self.points(i, (places - self.reached[i]) / np.diff(self.reached)[i])
        return found

    def _parameter(self, place: float) -> float:
        """The curve's parameter at a length."""
        return float(np.interp(place, self.reached, self.ends))


class Circling(NamedTuple):
    """An arc about an axis of the coordinates whose height grows evenly.

    Attributes:
        axis: its number.
        centre: in the plane of the two coordinates after it.
        radius: of the circle there.
        first: the angle at the start.
        turning: the angle, positive if anticlockwise seen from + of the axis.
        heights: along the axis, at the start and at the end.
    """

    axis: int
    centre: complex
    radius: float
    first: float
    turning: float
    heights: tuple[float, float]

    def points(self, fractions: Floats) -> Floats:
        """Points at fractions of the turning."""
        around = self.centre + self.radius * np.exp(1j * (self.first + fractions * self.turning))
        low, high = self.heights
        columns = (low + fractions * (high - low), around.real, around.imag)
        return np.stack([columns[(k - self.axis) % 3] for k in range(3)], axis=-1)

    def beside(self, points: Floats) -> Floats:
        """Its points at the angles of others."""
        z = points[:, (self.axis + 1) % 3] + 1j * points[:, (self.axis + 2) % 3] - self.centre
        return self.points(np.angle(z * np.exp(-1j * self.first)) / self.turning)

    def arc(self) -> Arc:
        """As the motions of a program take it."""
        square = self.radius * self.turning**2
        return Arc(
            lambda fraction: self.points(np.array([fraction]))[0].tolist(),
            self.axis,
            self.turning,
            self.radius,
            square,
        )


def circling(start: Floats, middle: Floats, end: Floats, axis: int) -> Circling | None:
    """The arc about an axis between two points, its circle through the middle; None if that is a line.

    >>> arc = circling(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), np.array([-1.0, 0, 2]), 2)
    >>> abs(arc.centre) < 1e-12, round(arc.radius, 12), round(arc.turning / math.pi, 12)
    (True, 1.0, 1.0)
    >>> arc.points(np.array([0.5])).round(12).tolist()
    [[0.0, 1.0, 1.0]]
    """
    z0, z1, z2 = (complex(p[(axis + 1) % 3], p[(axis + 2) % 3]) for p in (start, middle, end))
    m, e = z1 - z0, z2 - z0
    doubled = 2 * (m.conjugate() * e).imag
    if not abs(doubled) > 1e-12 * abs(e) ** 2:
        return None
    away = 1j * (m * abs(e) ** 2 - e * abs(m) ** 2) / doubled  # from the start to the centre
    half, whole = (cmath.phase((z - z0 - away) / -away) for z in (z1, z2))
    sense = math.copysign(1.0, half)
    turning = sense * (sense * whole % math.tau)
    return Circling(
        axis, z0 + away, abs(away), cmath.phase(-away), turning, (float(start[axis]), float(end[axis]))
    )
