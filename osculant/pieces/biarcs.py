"""Pieces made of two circular arcs with a common tangent where they meet.

Both arcs turn by less than π, and are ordinary conic pieces of kind "arc" (`osculant.pieces.conics`): an arc
from P to Q with the unit tangent T at P has weight w = cos(θ/2) = ⟨T, d⟩/|d| and leg A = T·|d|/2, d = Q − P.
So nearly straight arcs, whose centres are far away, are as good as any.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, Literal

from osculant.pieces.conics import Piece, Point
from osculant.pieces.piece import OfArcs


@dataclass(frozen=True)
class Biarc(OfArcs):
    """Two circular arcs that stand for the curve on one parameter interval.

    Attributes:
        kind: "biarc"; "arc" if both are halves of one circular arc.
        interval: the curve's parameters at both ends.
        start: first end point.
        junction: where the arcs meet.
        end: last end point.
        tangents: unit tangents at start and junction.
        curvatures: signed curvatures of the two arcs, positive where they turn left.
        error: Hausdorff distance to the curve, or the area between, as estimated; 0 if the piece is exact.

    >>> half = 0.5**0.5
    >>> ends = (1.0, 0.0), (half, half), (0.0, 1.0)
    >>> quarter = Biarc("arc", (0.0, 1.5), *ends, ((0.0, 1.0), (-half, half)), (1.0, 1.0), 0.0)
    >>> quarter.radii, quarter.bounding_box()
    ((1.0, 1.0), ((0.0, 0.0), (1.0, 1.0)))
    """

    kind: Literal["biarc", "arc"]
    interval: tuple[float, float]
    start: Point
    junction: Point
    end: Point
    tangents: tuple[Point, Point]
    curvatures: tuple[float, float]
    error: float

    @cached_property
    def arcs(self) -> tuple[Piece, Piece]:
        """The two arcs, the curve's interval divided by their lengths."""
        points = (self.start, self.junction), (self.junction, self.end)
        parts = zip(pairwise(self.arc_ends), points, self.tangents)
        first, last = (Piece.arc(part, *ends, tangent, self.error) for part, ends, tangent in parts)
        return first, last

    @property
    def arc_ends(self) -> tuple[float, float, float]:
        """The curve's parameters where the arcs begin and end: the interval divided by their lengths."""
        a, b = self.interval
        return a, a + self.share * (b - a), b

    @property
    def lengths(self) -> tuple[float, float]:
        """Lengths of the two arcs."""
        chords = math.dist(self.start, self.junction), math.dist(self.junction, self.end)
        first, last = (_length(chord, k) for chord, k in zip(chords, self.curvatures))
        return first, last

    @property
    def numbers(self) -> int:
        """How many numbers store it if its start is known: those of its arcs, or of the one arc it is."""
        return 3 if self.kind == "arc" else sum(arc.numbers for arc in self.arcs)

    @cached_property
    def share(self) -> float:
        """The first arc's part of the whole length."""
        first, last = self.lengths
        return first / (first + last)

    @property
    def radii(self) -> tuple[float | None, float | None]:
        """Radii of the two arcs; None for one that is straight (or whose radius overflows)."""
        first, last = (_finite(abs(1 / k)) if k else None for k in self.curvatures)
        return first, last

    @property
    def centres(self) -> tuple[Point | None, Point | None]:
        """Centres of the two arcs; None for one that is straight (or whose centre overflows)."""
        found: list[Point | None] = []
        for (x, y), (tx, ty), k in zip((self.start, self.junction), self.tangents, self.curvatures):
            centre = (x - ty / k, y + tx / k) if k else (math.inf, math.inf)
            found.append(centre if all(map(math.isfinite, centre)) else None)
        return found[0], found[1]

    def to_json(self) -> dict[str, Any]:
        """Return the piece as plain lists and numbers, as in the JSON of a spline.

        "centres" and "radii" are null for a straight arc; "curvatures" are signed.
        """
        return {
            "kind": self.kind,
            "interval": list(map(float, self.interval)),
            "points": [list(map(float, point)) for point in (self.start, self.junction, self.end)],
            "tangents": [list(map(float, tangent)) for tangent in self.tangents],
            "centres": [None if centre is None else list(centre) for centre in self.centres],
            "radii": list(self.radii),
            "curvatures": list(map(float, self.curvatures)),
            "error": float(self.error),
        }


def _length(chord: float, curvature: float) -> float:
    """Length of an arc that turns by less than π."""
    sine = min(1.0, abs(curvature) * chord / 2)
    return chord if sine == 0 else chord * math.asin(sine) / sine


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
