"""Motions along lines and arcs in rounded numbers, such that the two radii of every arc agree.

Machines are told an arc by its end and its centre, so that the distances of the two ends from the centre
differ after rounding: the mismatch. It is kept below half a last unit and below a machine's limit, in exact
arithmetic; where no rounding of the centre does that, the arc is cut in halves.

What is printed shall lie near what is meant, and where along it a motion ends does not matter if the next one
goes on in the same direction. So an end is the multiple of the last unit, among those beside it, that is
nearest to the line of the tangent; and the centre, among the multiples near that of the circle through both
printed ends and the middle that is meant, the one with the least distance of what is meant from the circle,
for either radius: a controller may keep that of the start or reach that of the end. An arc that is a line to
within a quarter of a unit is written as one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from osculant.pieces.piece import Floats

#: in last units: the sagitta of arcs that are lines, the chord of arcs that cannot be cut
STRAIGHT, SHORTEST = 0.25, 1.5
#: the part of an arc that is not cut again
FINEST = 2.0**-8
#: what is meant may be so far from the printed circle, in last units and in parts of the centre's coordinates
FAR, NOISE = 2.0, 2.0**-48
#: the mismatch allowed, in last units; how far the end of an arc may slide along it
MISMATCH, SLIDE = Fraction(1, 2), 1.0
#: of one motion: half turns, however rounded
LARGEST_TURNING = 3.2
#: centres are sought so many units away, and farther along the bisector where that hardly moves the arc
AWAY, FARTHEST, MOVED = 3, 40, 0.3
#: fractions of an arc where its distance from the printed one is measured
PROBES = np.linspace(0.0, 1.0, 5)
PLANES = {2: "G17", 1: "G18", 0: "G19"}  # by the axis at right angles


@dataclass(frozen=True)
class Arc:
    """An arc of a circle or helix about a coordinate axis.

    Attributes:
        point: its points, for fractions of the turning from 0 to 1.
        axis: the number of that axis, 2 in the plane.
        turning: the angle, positive if anticlockwise seen from + of the axis.
        radius: of the circle or cylinder.
        chord_square: κL², eight times the distance to the chord.
    """

    point: Callable[[float], Sequence[float]]
    axis: int
    turning: float
    radius: float
    chord_square: float


class Program:
    """The motions of a program, as rounded numbers.

    Args:
        decimals: of every number.
        start: the first point, with two or three coordinates.
        at: the curve's parameter there.
        largest_turning: of one arc.
        mismatch: of the radii allowed, in last units.

    Attributes:
        lines: the program's, from the rapid motion to the start on.
        ends: the curve's parameters where motions begin and end, one more than there are.

    >>> program = Program(2, (1.0, 0.0))
    >>> program.turn(Arc(lambda f: (math.cos(3 * f), math.sin(3 * f)), 2, 3.0, 1.0, 9.0), (0.0, 1.0))
    >>> program.lines, program.ends
    (['G0 X1.00 Y0.00', 'G3 X-0.99 Y0.14 I-1.00 J0.00'], [0.0, 1.0])
    """

    def __init__(
        self,
        decimals: int,
        start: Sequence[float],
        at: float = 0.0,
        *,
        largest_turning: float = LARGEST_TURNING,
        mismatch: Fraction = MISMATCH,
    ) -> None:
        self.decimals, self.axis, self.unit = decimals, 2, 10.0**-decimals
        self.largest_turning, self.mismatch = largest_turning, min(mismatch, MISMATCH)
        self.here = self._rounded(start)
        self.lines, self.ends = [f"G0 {self._words('XYZ', self.here)}"], [at]

    def line(self, end: Sequence[float], at: float, tangent: Sequence[float] | None = None) -> None:
        """Move straight to a point; nothing is written if it is printed like the last one.

        Args:
            end: the point.
            at: the curve's parameter there.
            tangent: the unit vector along which the end may slide; None for one that may not.
        """
        self._straight(self._rounded(end, tangent), at)

    def chords(
        self, point: Callable[[float], Sequence[float]], n: int, interval: tuple[float, float]
    ) -> None:
        """Move along n chords between points at equal steps of a parameter from 0 to 1."""
        a, b = interval
        for i in range(1, n + 1):
            self.line(point(i / n), a + i / n * (b - a))

    def turn(
        self,
        arc: Arc,
        interval: tuple[float, float],
        tangent: Sequence[float] | None = None,
        part: tuple[float, float] = (0.0, 1.0),
    ) -> None:
        """Move along a part of an arc, given by fractions of its turning; the last move ended about there.

        Args:
            arc: what is meant.
            interval: the curve's parameters at the ends of the whole arc.
            tangent: the unit vector along which the end may slide; None for one that may not.
            part: the fractions.
        """
        first, last = part
        at = interval[0] + last * (interval[1] - interval[0])
        turning = (last - first) * arc.turning
        plane = [(arc.axis + 1) % 3, (arc.axis + 2) % 3]  # in this order seen from + of the axis
        meant = np.array([arc.point(first + f * (last - first)) for f in PROBES])
        if arc.radius < 8 * SLIDE * self.unit:
            tangent = None
        there = self._rounded(meant[-1], tangent)
        chord = there[plane[0]] - self.here[plane[0]], there[plane[1]] - self.here[plane[1]]
        away = (meant[:, plane] / self.unit) - [self.here[k] for k in plane]
        height = arc.radius / self.unit * (1 - math.cos(turning / 2))
        # a short chord tells nothing of an arc that turns by more than half a turn
        length = math.hypot(*chord) if abs(turning) <= LARGEST_TURNING else math.inf
        if min(height / STRAIGHT, length / SHORTEST, (last - first) / FINEST) <= 1:
            self._straight(there, at)
            return
        centre = None
        if abs(turning) < self.largest_turning:
            centre = best_centre(
                chord, raised(away, chord, math.copysign(height, turning)), turning, self.mismatch
            )
        if centre is None:
            middle = (first + last) / 2
            ahead = meant[3] - meant[1]
            self.turn(arc, interval, (ahead / np.linalg.norm(ahead)).tolist(), (first, middle))
            self.turn(arc, interval, tangent, (middle, last))
            return
        if arc.axis != self.axis:
            self.axis = arc.axis
            self.lines.append(PLANES[arc.axis])
        offset = {"IJK"[k]: along for k, along in zip(plane, centre)}
        letters = "".join(sorted(offset))
        end, about = self._words("XYZ", there), self._words(letters, [offset[letter] for letter in letters])
        self.lines.append(f"G{3 if turning > 0 else 2} {end} {about}")
        self._arrive(there, at)

    def _straight(self, there: tuple[int, ...], at: float) -> None:
        if there == self.here:
            if len(self.ends) > 1:
                self.ends[-1] = at
            return
        self.lines.append(f"G1 {self._words('XYZ', there)}")
        self._arrive(there, at)

    def _arrive(self, there: tuple[int, ...], at: float) -> None:
        self.here = there
        self.ends.append(at)

    def _rounded(self, point: Sequence[float], tangent: Sequence[float] | None = None) -> tuple[int, ...]:
        """The multiples of the unit nearest to a point, or to a line through it among those beside it."""
        exact = [Fraction(float(value)) * 10**self.decimals for value in point]
        nearest = tuple(map(round, exact))
        if tangent is None:
            return nearest
        steps = np.array(list(product((0, -1, 1), repeat=len(nearest))))
        gaps = steps - np.array([float(x - n) for x, n in zip(exact, nearest)])
        along = gaps @ np.asarray(tangent)
        across = np.linalg.norm(gaps - along[:, None] * np.asarray(tangent), axis=1)
        cost = np.where(np.abs(along) <= SLIDE, across + 0.02 * np.abs(along), np.inf)
        step = steps[int(cost.argmin())].tolist() if np.isfinite(cost).any() else [0] * len(nearest)
        return tuple(n + k for n, k in zip(nearest, step))

    def _words(self, letters: str, numbers: Sequence[int]) -> str:
        return " ".join(letter + self._number(number) for letter, number in zip(letters, numbers))

    def _number(self, units: int) -> str:
        digits = str(abs(units)).rjust(self.decimals + 1, "0")
        whole, rest = digits[: len(digits) - self.decimals], digits[len(digits) - self.decimals :]
        return ("-" if units < 0 else "") + whole + ("." + rest if rest else "")


def raised(meant: Floats, chord: tuple[int, int], height: float) -> Floats:
    """Points of an arc, moved if rounding brought the middle too near to the printed chord: half its height.

    Args:
        meant: the points, shape (n, 2).
        chord: the end of the arc from the origin.
        height: of the middle above the chord, positive if the arc turns to the left and lies on the right.

    >>> raised(np.array([[0.0, 0.0], [1.5, 1.0], [3.0, 0.0]]), (3, 0), 1.0)[1].tolist()
    [1.5, -0.5]
    """
    right = np.array([chord[1], -chord[0]]) / math.hypot(*chord) * math.copysign(1.0, height)
    missing = abs(height) / 2 - float(meant[len(meant) // 2] @ right)
    return meant + max(0.0, missing) * right


def best_centre(
    chord: tuple[int, int], meant: Floats, turning: float, mismatch: Fraction = MISMATCH
) -> tuple[int, int] | None:
    """Return whole numbers for the centre of an arc from the origin, such that it is near what is meant.

    Args:
        chord: the end of the arc, in last units; not the origin.
        meant: points of the arc as it is meant, shape (n, 2), the middle one off the chord.
        turning: the angle, positive if anticlockwise.
        mismatch: of both radii allowed.

    Returns:
        The centre, or None if none near has so small a mismatch.

    >>> half = np.array([[math.cos(t) - 1, math.sin(t)] for t in PROBES * math.pi])
    >>> best_centre((-20, 0), 10 * half, math.pi), best_centre((-21, 0), 10.5 * half, math.pi)
    ((-10, 0), None)
    """
    middle, end = meant[len(meant) // 2], np.array(chord, dtype=float)
    doubled = 2 * (middle[0] * end[1] - middle[1] * end[0])
    squares = middle @ middle, end @ end
    centre = np.array(
        [end[1] * squares[0] - middle[1] * squares[1], middle[0] * squares[1] - end[0] * squares[0]]
    )
    centre = centre / doubled
    ahead = np.array([-end[1], end[0]]) / math.hypot(*chord)
    lazy = min(FARTHEST, math.ceil(MOVED / max(1e-9, 1 - math.cos(turning / 2))))
    bases = np.rint(centre + np.arange(-lazy, lazy + 1)[:, None] * ahead)
    reach = np.arange(-AWAY, AWAY + 1) if lazy <= AWAY else np.arange(-1, 2)
    steps = np.array(list(product(reach, reach)))
    tried = np.unique((bases[:, None] + steps).reshape(-1, 2), axis=0)
    radii = np.stack([np.linalg.norm(tried, axis=1), np.linalg.norm(tried - end, axis=1)])
    gaps = np.linalg.norm(meant[:, None] - tried, axis=2)
    cost = np.abs(gaps[None] - radii[:, None]).max(axis=(0, 1))
    x, y = chord
    for place in np.argsort(cost):
        if cost[place] > FAR + NOISE * np.abs(centre).max():
            return None
        i, j = map(int, tried[place])
        if small_mismatch(i * i + j * j, (x - i) ** 2 + (y - j) ** 2, mismatch):
            return i, j
    return None


def small_mismatch(a: int, b: int, limit: Fraction = MISMATCH) -> bool:
    """Whether the square roots of two whole numbers differ by less than a limit, exactly.

    >>> small_mismatch(100, 109), small_mismatch(100, 110), small_mismatch(100, 111), small_mismatch(0, 1)
    (True, True, False, False)
    """
    low, high = sorted((a, b))
    excess = high - low - limit**2  # √high − √low < l if high − low − l² < 2l√low
    return excess < 0 or excess**2 < 4 * limit**2 * low
