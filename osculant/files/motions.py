"""Motions along lines and arcs in rounded numbers, such that the two radii of every arc agree.

Machines are told an arc by its end and its centre, so that the distances of the two ends from the centre
differ after rounding: the mismatch. Let u be the last unit. Here it is below u/2, in exact arithmetic:

* among the roundings of the centre there is one at most u/2 off the perpendicular bisector of the printed
  chord. So every arc that turns by less than π/3 has a centre with a mismatch below u/2, but a half turn
  over a chord of an odd number of units has none. Where none will do, the arc is cut in halves;
* an arc with a chord of 3u or less is a line, at most 1.5u away.

What is printed stays within 4u: both ends are rounded to nearest, and the arc follows them by a similarity,
by no more than u, as it turns by at most π; then its centre moves to a multiple of u at most u·√5/2 away, and
the arc by at most twice that; last, it becomes a spiral between the two radii.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

ROUNDING = 4  # what rounding moves, in last units
SHORTEST_CHORD = 3  # of an arc, in last units
LARGEST_TURNING = 3.2  # of one motion: half turns, however rounded
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

    >>> program = Program(2, (1.0, 0.0))
    >>> program.turn(Arc(lambda f: (math.cos(3 * f), math.sin(3 * f)), 2, 3.0, 1.0, 9.0))
    >>> program.lines
    ['G0 X1.00 Y0.00', 'G3 X-0.99 Y0.14 I-1.00 J0.00']
    """

    def __init__(self, decimals: int, start: Sequence[float]) -> None:
        self.decimals, self.axis = decimals, 2
        self.here = self._rounded(start)
        self.lines = [f"G0 {self._words('XYZ', self.here)}"]

    def line(self, end: Sequence[float]) -> None:
        """Move straight to a point; nothing is written if it is printed like the last one."""
        there = self._rounded(end)
        if there != self.here:
            self.here = there
            self.lines.append(f"G1 {self._words('XYZ', there)}")

    def chords(self, point: Callable[[float], Sequence[float]], n: int) -> None:
        """Move along n chords between points at equal steps of a parameter from 0 to 1."""
        for i in range(1, n + 1):
            self.line(point(i / n))

    def turn(self, arc: Arc, first: float = 0.0, last: float = 1.0) -> None:
        """Move along a part of an arc, given by fractions of its turning; the last move ended about there."""
        there = self._rounded(arc.point(last))
        turning = (last - first) * arc.turning
        a, b = (arc.axis + 1) % 3, (arc.axis + 2) % 3  # in this order the plane is seen from + of the axis
        chord = there[a] - self.here[a], there[b] - self.here[b]
        centre = None
        if abs(turning) < LARGEST_TURNING:
            if chord[0] ** 2 + chord[1] ** 2 <= SHORTEST_CHORD**2:
                self.line(arc.point(last))
                return
            centre = rounded_centre(chord, turning)
        if centre is None:
            middle = (first + last) / 2
            self.turn(arc, first, middle)
            self.turn(arc, middle, last)
            return
        if arc.axis != self.axis:
            self.axis = arc.axis
            self.lines.append(PLANES[arc.axis])
        offset = {"IJK"[a]: centre[0], "IJK"[b]: centre[1]}
        letters = "".join(sorted(offset))
        end, about = self._words("XYZ", there), self._words(letters, [offset[letter] for letter in letters])
        self.lines.append(f"G{3 if turning > 0 else 2} {end} {about}")
        self.here = there

    def _rounded(self, point: Sequence[float]) -> tuple[int, ...]:
        return tuple(round(Fraction(float(value)) * 10**self.decimals) for value in point)

    def _words(self, letters: str, numbers: Sequence[int]) -> str:
        return " ".join(letter + self._number(number) for letter, number in zip(letters, numbers))

    def _number(self, units: int) -> str:
        digits = str(abs(units)).rjust(self.decimals + 1, "0")
        whole, rest = digits[: len(digits) - self.decimals], digits[len(digits) - self.decimals :]
        return ("-" if units < 0 else "") + whole + ("." + rest if rest else "")


def rounded_centre(chord: tuple[int, int], turning: float) -> tuple[int, int] | None:
    """Return whole numbers for the centre of an arc from the origin, with a mismatch of radii below 1/2.

    Args:
        chord: the end of the arc, in last units; not the origin.
        turning: the angle, not 0, positive if anticlockwise.

    Returns:
        The nearest such centre, or None if there is none within √5/2.

    >>> rounded_centre((-20, 0), math.pi), rounded_centre((-21, 0), math.pi), rounded_centre((-21, 0), 1.0)
    ((-10, 0), None, (-11, -19))
    """
    x, y = chord
    cotangent = Fraction(1 / math.tan(turning / 2))
    centre = (x - y * cotangent) / 2, (y + x * cotangent) / 2
    found = []
    for i in range(round(centre[0]) - 1, round(centre[0]) + 2):
        for j in range(round(centre[1]) - 1, round(centre[1]) + 2):
            away = (i - centre[0]) ** 2 + (j - centre[1]) ** 2
            if away <= Fraction(5, 4) and small_mismatch(i * i + j * j, (x - i) ** 2 + (y - j) ** 2):
                found.append((away, (i, j)))
    return min(found)[1] if found else None


def small_mismatch(a: int, b: int) -> bool:
    """Whether the square roots of two whole numbers differ by less than 1/2, exactly.

    >>> small_mismatch(100, 109), small_mismatch(100, 110), small_mismatch(100, 111), small_mismatch(0, 1)
    (True, True, False, False)
    """
    low, high = sorted((a, b))
    excess = 4 * (high - low) - 1  # √high − √low < 1/2 if high − low − 1/4 < √low
    return excess < 0 or excess * excess < 16 * low
