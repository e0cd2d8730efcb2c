"""One piece of a spline of bihelices: two helical arcs with a common tangent, or a single one.

An arc of a circular helix starts at p₀ with unit tangent T₀ and turns about its axis V, the direction of the
Darboux vector τT + κB, by β = √(κ² + τ²) per unit of length:

    α(s) = p₀ + s⟨T₀,V⟩V + (sin βs/β)(T₀ − ⟨T₀,V⟩V) + ((1 − cos βs)/β) V×T₀.

Torsion has the usual sign, positive for a right-handed helix; the thesis's V (2.14) and torsion are minus
these. τ = 0 is an arc of a circle, κ = 0 a straight segment. Source: thesis, Lemma 4.2.1 with its erratum.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from osculant.cas.errors import DomainError
from osculant.pieces.kinds import HelixKind
from osculant.pieces.piece import OfArcs

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike

    from osculant.pieces.piece import Floats

Vector = tuple[float, float, float]
#: how many numbers an arc takes, given where it begins
NUMBERS = {"segment": 3, "arc": 5, "helix": 6}


@dataclass(frozen=True)
class HelixArc:
    """An arc of a circular helix, of a circle or of a line.

    Attributes:
        start: p₀.
        direction: T₀, the unit tangent there.
        axis: V, a unit vector; of a segment, its direction.
        curvature: κ >= 0.
        torsion: τ, positive for a right-handed helix.
        length: of the arc.

    >>> turn = HelixArc((1.0, 0.0, 0.0), (0.0, 0.6, 0.8), (0.0, 0.0, 1.0), 0.36, 0.48, 2.5 * math.pi)
    >>> turn.kind, round(turn.turning / math.pi, 12), round(turn.radius, 12), round(turn.pitch, 6)
    ('helix', 1.5, 1.0, 8.37758)
    >>> turn.point([0.0, 1.0]).round(6).tolist()[1][1:]
    [-1.0, 6.283185]
    """

    start: Vector
    direction: Vector
    axis: Vector
    curvature: float
    torsion: float
    length: float

    def __post_init__(self) -> None:
        if not (0 < self.length < math.inf):
            raise DomainError(f"A helical arc has a positive length; this one has {self.length!r}.")

    @property
    def kind(self) -> HelixKind:
        """The word "segment" if κ = 0, "arc" if only τ = 0, else "helix"."""
        if self.curvature == 0:
            return "segment"
        return "helix" if self.torsion else "arc"

    @property
    def rate(self) -> float:
        """β = √(κ² + τ²), of a segment 0: the turning per unit of length."""
        return math.hypot(self.curvature, self.torsion) if self.curvature else 0.0

    @property
    def turning(self) -> float:
        """The angle φ = β·length by which the arc turns about its axis, in radians."""
        return self.rate * self.length

    @property
    def radius(self) -> float:
        """The radius κ/β² of the cylinder the arc lies on; 0 for a segment."""
        return self.curvature / self.rate**2 if self.curvature else 0.0

    @property
    def pitch(self) -> float:
        """The rise 2πτ/β² of a full turn, negative for a left-handed helix; 0 for a segment."""
        return math.tau * self.torsion / self.rate**2 if self.curvature else 0.0

    @property
    def centre(self) -> Vector:
        """The point of the axis nearest to p₀; of a segment p₀."""
        if not self.curvature:
            return self.start
        x, y, z = (np.array(self.start) + self._vectors[2] / self.rate).tolist()
        return x, y, z

    @cached_property
    def _vectors(self) -> tuple[Floats, Floats, Floats]:
        """⟨T₀,V⟩V, T₀ − ⟨T₀,V⟩V and V×T₀."""
        tangent, axis = np.array(self.direction), np.array(self.axis)
        if not self.curvature:
            return tangent, np.zeros(3), np.zeros(3)
        along = np.dot(tangent, axis) * axis
        return along, tangent - along, np.cross(axis, tangent)

    @staticmethod
    def together(arcs: Sequence[HelixArc]) -> Callable[[Any, Floats], Floats]:
        """Return a function that evaluates many arcs at once, for arrays of their indices and of u."""
        rows = ((arc.start, [arc.length], [arc.rate], *arc._vectors) for arc in arcs)
        starts, lengths, rates, *vectors = map(np.array, zip(*rows))
        return lambda i, u: (
            starts[i] + _from_start(lengths[i] * u[..., None], rates[i], *(v[i] for v in vectors))
        )

    @property
    def numbers(self) -> int:
        """How many numbers store it if its start is known.

        A segment takes 3 (its end). An arc of a circle takes 5: the tangent (2) and the direction of the
        centre (1), which are its frame, the curvature and the length. A helix takes its torsion besides, 6.
        """
        return NUMBERS[self.kind]

    def point(self, u: ArrayLike) -> Floats:
        """α at the fraction u in [0, 1] of the length, of u's shape with a last axis of length 3."""
        s = self.length * np.asarray(u, dtype=np.float64)[..., None]
        points: Floats = np.array(self.start) + _from_start(s, self.rate, *self._vectors)
        return points

    def tangent(self, u: ArrayLike) -> Floats:
        """The unit tangent there, of u's shape with a last axis of length 3."""
        angle = self.turning * np.asarray(u, dtype=np.float64)[..., None]
        along, across, inward = self._vectors
        tangents: Floats = along + np.cos(angle) * across + np.sin(angle) * inward
        return tangents

    def normal(self, u: ArrayLike) -> Floats:
        """The principal normal there, likewise, towards the axis; of a segment 0."""
        angle = self.turning * np.asarray(u, dtype=np.float64)[..., None]
        _, across, inward = self._vectors
        bend: Floats = np.cos(angle) * inward - np.sin(angle) * across
        return bend / (math.sqrt(float(across @ across)) or 1.0)

    @property
    def end(self) -> Vector:
        """The last point."""
        x, y, z = self.point(1.0).tolist()
        return x, y, z

    def bounding_box(self) -> tuple[Vector, Vector]:
        """Return the lower and upper corners of the box around it, from the extreme points themselves.

        >>> arc = HelixArc((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), 1.0, 0.0, math.pi)
        >>> [[round(side, 12) + 0.0 for side in corner] for corner in arc.bounding_box()]
        [[-1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]
        """
        places = [0.0, 1.0]
        if self.rate:
            for rise, across, inward in zip(*(v.tolist() for v in self._vectors)):
                # the tangent's component rise + across·cos + inward·sin is 0
                size = math.hypot(across, inward)
                if size > abs(rise):
                    middle, away = math.atan2(inward, across), math.acos(-rise / size)
                    angles = ((middle + sign * away) % math.tau for sign in (-1, 1))
                    places += [angle / self.turning for angle in angles if angle < self.turning]
        points = self.point(places)
        (x, y, z), (u, v, w) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        return (x, y, z), (u, v, w)

    def to_json(self) -> dict[str, Any]:
        """Plain data: "kind", "start", "tangent", "axis", "curvature", "torsion", "length", "turning"."""
        return {
            "kind": self.kind,
            "start": list(self.start),
            "tangent": list(self.direction),
            "axis": list(self.axis),
            "curvature": self.curvature,
            "torsion": self.torsion,
            "length": self.length,
            "turning": self.turning,
        }


@dataclass(frozen=True)
class SpacePiece(OfArcs):
    """A bihelix, or a single helical arc, that stands for the curve on one parameter interval.

    Attributes:
        interval: the curve's parameters at both ends.
        arcs: one or two, each starting where the one before ends, with the same tangent.
        error: Hausdorff distance to the curve, as estimated; 0 if the piece is exact.
        junction: the curve's parameter at the junction of two arcs, None for a single one.

    >>> line = HelixArc((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 1.0), 0.0, 0.0, 2.0)
    >>> piece = SpacePiece((0.0, 1.0), (line,), 0.0)
    >>> piece.kind, piece.point(0.5).tolist(), piece.end
    ('segment', [0.0, 0.0, 1.0], (0.0, 0.0, 2.0))
    """

    interval: tuple[float, float]
    arcs: tuple[HelixArc, ...]
    error: float
    junction: float | None = None

    def __post_init__(self) -> None:
        if len(self.arcs) != (1 if self.junction is None else 2):
            raise DomainError(
                f"A piece has one arc, or two and a junction between them; this one has {len(self.arcs)} "
                f"and the junction {self.junction}."
            )

    @property
    def kind(self) -> Literal["bihelix"] | HelixKind:
        """The word "bihelix" for two arcs, else the arc's own kind."""
        return "bihelix" if len(self.arcs) == 2 else self.arcs[0].kind

    @property
    def length(self) -> float:
        """The length of the arcs together."""
        return math.fsum(arc.length for arc in self.arcs)

    @property
    def start(self) -> Vector:
        """The first point."""
        return self.arcs[0].start

    @property
    def end(self) -> Vector:
        """The last point."""
        return self.arcs[-1].end

    @property
    def share(self) -> float:
        """The first arc's part of the length."""
        return self.arcs[0].length / self.length

    @property
    def arc_ends(self) -> tuple[float, ...]:
        """The curve's parameters where the arcs begin and end."""
        a, b = self.interval
        return (a, b) if self.junction is None else (a, self.junction, b)

    @property
    def numbers(self) -> int:
        """How many numbers store it if its start is known: those of its arcs."""
        return sum(arc.numbers for arc in self.arcs)

    def to_json(self) -> dict[str, Any]:
        """Plain data: "kind", "interval", "junction" (null for one arc), "arcs" (dictionaries), "error"."""
        return {
            "kind": self.kind,
            "interval": [float(end) for end in self.interval],
            "junction": self.junction,
            "arcs": [arc.to_json() for arc in self.arcs],
            "error": float(self.error),
        }


def _from_start(s: Floats, rate: Any, along: Floats, across: Floats, inward: Floats) -> Floats:
    """α(s) − p₀ at arc lengths s, with a last axis of length 1, for one arc or as many as there are s."""
    turned = np.where(rate == 0, 1.0, rate)  # of a segment, whose vectors across and inward are 0
    half = turned * s / 2
    versine = 2 * np.sin(half) ** 2  # 1 − cos, without cancellation
    offset: Floats = s * along + np.sin(2 * half) / turned * across + versine / turned * inward
    return offset
