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

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]

Vector = tuple[float, float, float]
ArcKind = Literal["helix", "arc", "segment"]
PieceKind = Literal["bihelix", "helix", "arc", "segment"]


@dataclass(frozen=True)
class HelixArc:
    """An arc of a circular helix, of a circle or of a line.

    Attributes:
        start: p₀.
        tangent: T₀, a unit vector.
        axis: V, a unit vector; of a segment, its direction.
        curvature: κ >= 0.
        torsion: τ, positive for a right-handed helix.
        length: of the arc.

    >>> turn = HelixArc((1.0, 0.0, 0.0), (0.0, 0.6, 0.8), (0.0, 0.0, 1.0), 0.36, 0.48, 2.5 * math.pi)
    >>> turn.kind, round(turn.turning / math.pi, 12), round(turn.radius, 12), round(turn.pitch, 6)
    ('helix', 1.5, 1.0, 8.37758)
    >>> turn.point([0.0, turn.length]).round(6).tolist()[1][1:]
    [-1.0, 6.283185]
    """

    start: Vector
    tangent: Vector
    axis: Vector
    curvature: float
    torsion: float
    length: float

    def __post_init__(self) -> None:
        if not (0 < self.length < math.inf):
            raise DomainError(f"A helical arc has a positive length; this one has {self.length!r}.")

    @property
    def kind(self) -> ArcKind:
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
        tangent, axis = np.array(self.tangent), np.array(self.axis)
        if not self.curvature:
            return tangent, np.zeros(3), np.zeros(3)
        along = np.dot(tangent, axis) * axis
        return along, tangent - along, np.cross(axis, tangent)

    def point(self, s: ArrayLike) -> Floats:
        """α(s) at arc lengths from the start, of s's shape with a last axis of length 3."""
        s = np.asarray(s, dtype=np.float64)[..., None]
        along, across, inward = self._vectors
        sine, versine = s, np.zeros_like(s)
        if self.rate:
            half = self.rate * s / 2
            sine = np.sin(2 * half) / self.rate
            versine = 2 * np.sin(half) ** 2 / self.rate  # 1 − cos, without cancellation
        points: Floats = np.array(self.start) + (s * along + sine * across + versine * inward)
        return points

    def tangent_at(self, s: ArrayLike) -> Floats:
        """The unit tangent at arc lengths from the start, of s's shape with a last axis of length 3."""
        angle = self.rate * np.asarray(s, dtype=np.float64)[..., None]
        along, across, inward = self._vectors
        tangents: Floats = along + np.cos(angle) * across + np.sin(angle) * inward
        return tangents

    @property
    def end(self) -> Vector:
        """The last point."""
        x, y, z = self.point(self.length).tolist()
        return x, y, z

    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corners of the smallest box around the arc, from the extreme points themselves.

        >>> arc = HelixArc((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), 1.0, 0.0, math.pi)
        >>> [(corner + 0.0).round(12).tolist() for corner in arc.bounds()]
        [[-1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]
        """
        lengths = [0.0, self.length]
        if self.rate:
            for rise, across, inward in zip(*(v.tolist() for v in self._vectors)):
                # the tangent's component rise + across·cos + inward·sin is 0
                size = math.hypot(across, inward)
                if size > abs(rise):
                    middle, away = math.atan2(inward, across), math.acos(-rise / size)
                    angles = ((middle + sign * away) % math.tau for sign in (-1, 1))
                    lengths += [angle / self.rate for angle in angles if angle < self.turning]
        points = self.point(lengths)
        return points.min(axis=0), points.max(axis=0)

    def to_json(self) -> dict[str, Any]:
        """Plain data: "kind", "start", "tangent", "axis", "curvature", "torsion", "length", "turning"."""
        return {
            "kind": self.kind,
            "start": list(self.start),
            "tangent": list(self.tangent),
            "axis": list(self.axis),
            "curvature": self.curvature,
            "torsion": self.torsion,
            "length": self.length,
            "turning": self.turning,
        }


@dataclass(frozen=True)
class SpacePiece:
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
    def kind(self) -> PieceKind:
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

    def _on(self, u: ArrayLike, what: str) -> Floats:
        """`HelixArc.point` or `HelixArc.tangent_at` at the fraction u of the length."""
        s = np.asarray(u, dtype=np.float64) * self.length
        first = self.arcs[0]
        found: Floats = getattr(first, what)(np.minimum(s, first.length))
        for arc in self.arcs[1:]:
            later = getattr(arc, what)(np.clip(s - first.length, 0.0, arc.length))
            found = np.where((s > first.length)[..., None], later, found)
        return found

    def point(self, u: ArrayLike) -> Floats:
        """The point at the fraction u in [0, 1] of the length; of u's shape with a last axis of length 3."""
        return self._on(u, "point")

    def tangent(self, u: ArrayLike) -> Floats:
        """The unit tangent there, likewise."""
        return self._on(u, "tangent_at")

    def at_parameter(self, t: ArrayLike) -> Floats:
        """The points for parameters of the curve in the interval, affinely in arc length on each arc.

        So the result is on the piece, but in general not the foot of the curve's point at t.
        """
        t = np.asarray(t, dtype=np.float64)
        a, b = self.interval
        first = self.arcs[0].length / self.length
        if self.junction is None:
            return self.point((t - a) / (b - a))
        left = first * (t - a) / (self.junction - a)
        right = first + (1 - first) * (t - self.junction) / (b - self.junction)
        return self.point(np.clip(np.where(t <= self.junction, left, right), 0.0, 1.0))

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points, equally spaced in arc length, both ends included; shape (n, 3)."""
        return self.point(np.linspace(0.0, 1.0, n))

    def bounding_box(self) -> tuple[Vector, Vector]:
        """Return the lower and upper corners of the smallest box around the arcs."""
        corners = [arc.bounds() for arc in self.arcs]
        x, y, z = np.min([low for low, _ in corners], axis=0).tolist()
        u, v, w = np.max([high for _, high in corners], axis=0).tolist()
        return (x, y, z), (u, v, w)

    def to_json(self) -> dict[str, Any]:
        """Plain data: "kind", "interval", "junction" (null for one arc), "arcs" (dictionaries), "error"."""
        return {
            "kind": self.kind,
            "interval": [float(end) for end in self.interval],
            "junction": self.junction,
            "arcs": [arc.to_json() for arc in self.arcs],
            "error": float(self.error),
        }
