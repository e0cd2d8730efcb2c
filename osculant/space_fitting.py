"""From stretches of a space curve to pieces: feeds the kernels and turns their tables into `SpacePiece`s."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.cas.errors import DomainError, UndecidedError
from osculant.helix_pieces import HelixArc, SpacePiece, Vector
from osculant.kernels import bihelix, bihelix_spline
from osculant.kernels.helix import HELIX_SIZE
from osculant.kernels.jit import announce
from osculant.kernels.space_curve import JET_SIZE, Frame, Place, sample_many
from osculant.space_stretches import SpaceDivision, SpaceFrame, SpaceStretch
from osculant.tolerances import window

if TYPE_CHECKING:
    from osculant.space import SpaceCurve

#: samples that tell the size of a curve
SAMPLES = 257
#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: pieces per call of the kernel
CHUNK = 2048
#: more pieces than this are not made
MOST_PIECES = 2_000_000
#: panels and nodes of the quadrature of arc length along an exact stretch
PANELS, NODES = 256, 8
#: where in a stretch the constants of a helix are read off
INSIDE = 0.4871
#: one arc turns by at most this part of 2π
WHOLE_TURN = 1 - 1e-9

RULES = {"equioscillating": bihelix.EQUIOSCILLATING, "thesis": bihelix.THESIS}


@dataclass(frozen=True)
class SpaceExtent:
    """Size of a curve: its first point, largest absolute coordinate and largest extent."""

    origin: Vector
    largest: float
    size: float

    @property
    def scale(self) -> float:
        """The power of two that makes the curve's size about 1."""
        return 2.0 ** -math.frexp(self.size)[1] if self.size > 0 else 1.0


def extent(curve: SpaceCurve) -> SpaceExtent:
    """Sample a curve that is finite on its interval; raises DomainError if doubles cannot hold it.

    >>> from osculant.space import SpaceCurve
    >>> extent(SpaceCurve("t, t^2, -t", 0, 3))
    SpaceExtent(origin=(0.0, 0.0, 0.0), largest=9.0, size=9.0)
    """
    a, b = curve.interval
    jets = np.empty((SAMPLES, JET_SIZE))
    sample_many(curve.compiled.address, np.linspace(a, b, SAMPLES), jets)
    points = jets[:, ::4]
    # a double next to an end may lie outside the interval, where the formula need not be defined
    if not np.isfinite(points[1:-1]).all():
        raise DomainError(
            f"The curve {curve.text} leaves the range of double numbers on its interval: "
            "scale it or take a smaller interval."
        )
    points = points[np.isfinite(points).all(axis=1)]
    with np.errstate(over="ignore"):
        size = float(np.ptp(points, axis=0).max())
    if not math.isfinite(size):
        raise DomainError(f"The curve {curve.text} is too large for double numbers: scale it.")
    x, y, z = (points[0] + 0.0).tolist()
    return SpaceExtent((x, y, z), float(np.abs(points).max()), size)


class SpaceFitting:
    """One approximation: a divided curve, a rule for junctions and a tolerance."""

    def __init__(
        self, curve: SpaceCurve, rule: str, tolerance: float, division: SpaceDivision, size: SpaceExtent
    ) -> None:
        announce()
        self.curve, self.rule, self.division = curve, RULES[rule], division
        self.place: Place = (*size.origin, size.scale, NOISE_ULPS * math.ulp(size.largest) * size.scale)
        self.window = window(tolerance, size.largest)
        self.tolerance = tolerance

    def pieces(self, stretch: SpaceStretch, progress: Callable[[float], None] | None) -> list[SpacePiece]:
        """The pieces of one stretch."""
        if stretch.shape == "segment":
            return [_segment(stretch)]
        if stretch.shape == "exact" and self.division.proved:
            return exact_pieces(self.curve, stretch)
        return self._greedy_pieces(stretch, progress)

    def _greedy_pieces(
        self, stretch: SpaceStretch, progress: Callable[[float], None] | None
    ) -> list[SpacePiece]:
        pieces: list[SpacePiece] = []
        first, last = self.division.stretches[0].a, self.division.stretches[-1].b
        table = np.empty((CHUNK, bihelix_spline.COLUMNS))
        reached, start, length = stretch.a, _row(stretch.start), 0.0
        while reached < stretch.b:
            count, reached, _ = bihelix_spline.spline(
                self.rule,
                self.curve.compiled.address,
                self.place,
                reached,
                start,
                stretch.b,
                _row(stretch.end),
                *self.window,
                length,
                table,
            )
            pieces += [_piece(row) for row in table[:count]]
            if progress is not None:
                progress((reached - first) / (last - first))
            if count < CHUNK and reached < stretch.b:
                raise UndecidedError(
                    f"No bihelix within {self.tolerance:g} was found for the curve after t = {reached:.15g}, "
                    "where double numbers cannot follow it: choose a split point there, or another interval."
                )
            if len(pieces) > MOST_PIECES:
                raise UndecidedError(
                    f"More than {MOST_PIECES} pieces are needed: choose a larger tolerance "
                    "or a shorter interval."
                )
            start = tuple(table[count - 1, 41:47].tolist())
            length = pieces[-1].interval[1] - pieces[-1].interval[0]
        return pieces


def exact_pieces(curve: SpaceCurve, stretch: SpaceStretch) -> list[SpacePiece]:
    """The least number of arcs turning by less than 2π each, of equal length, of a helix or circle itself.

    >>> from osculant.space import SpaceCurve
    >>> from osculant.space_stretches import divide
    >>> helix = SpaceCurve("3*cos(t), 3*sin(t), 4*t", 0, "4*pi")
    >>> [piece.kind for piece in exact_pieces(helix, divide(helix).stretches[0])]
    ['helix', 'helix', 'helix']
    """
    from osculant.cas.balls import PRECISION, precision
    from osculant.cas.complexity import integral

    def length(low: Any, high: Any) -> float:
        return float(integral(lambda t: curve.balls.jet(t, 1).speed.mid(), low, high)[0])

    with precision(PRECISION):
        inside = (stretch.low + (stretch.high - stretch.low) * INSIDE).mid()
        jet = curve.balls.jet(inside, 3)
        curvature, torsion = float(jet.curvature.mid()), float(jet.torsion.mid())
        axis = _floats(tuple(-part for part in jet.axis))
        turns = math.hypot(curvature, torsion) * length(stretch.low, stretch.high) / math.tau
        count = math.floor(turns) + 1
        while True:
            knots = _equal_lengths(curve, stretch, count)
            lengths = [length(low, high) for low, high in pairwise(knots)]
            if math.hypot(curvature, torsion) * max(lengths) < WHOLE_TURN * math.tau:
                break
            count += 1
        frames = [stretch.start]
        for knot in knots[1:-1]:
            jet = curve.balls.jet(knot, 1)
            frames.append(SpaceFrame(_floats(jet.point(0)), _floats(jet.tangent)))
    ends = pairwise([stretch.a, *map(float, knots[1:-1]), stretch.b])
    arcs = (HelixArc(f.point, f.tangent, axis, curvature, torsion, s) for f, s in zip(frames, lengths))
    return [SpacePiece(interval, (arc,), 0.0) for interval, arc in zip(ends, arcs)]


def _equal_lengths(curve: SpaceCurve, stretch: SpaceStretch, count: int) -> list[Any]:
    """Parameters that cut a stretch into pieces of nearly equal length, the inner ones doubles."""
    from flint import arb

    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    edges = np.linspace(stretch.a, stretch.b, PANELS + 1)
    half = np.diff(edges) / 2
    times = (edges[:-1] + half)[:, None] + half[:, None] * nodes
    jets = np.empty((times.size, JET_SIZE))
    sample_many(curve.compiled.address, times.ravel(), jets)
    speed = np.sqrt(np.square(jets[:, 1::4]).sum(axis=1)).reshape(times.shape)
    lengths = np.concatenate([[0.0], np.cumsum(half * (speed @ weights))])
    inner = np.interp(np.arange(1, count) * lengths[-1] / count, lengths, edges)
    return [stretch.low, *(arb(float(t)) for t in inner), stretch.high]


def _segment(stretch: SpaceStretch) -> SpacePiece:
    """The straight piece between the ends of a stretch."""
    start, end = stretch.start.point, stretch.end.point
    length = math.dist(start, end)
    x, y, z = ((b - a) / length for a, b in zip(start, end))
    arc = HelixArc(start, (x, y, z), (x, y, z), 0.0, 0.0, length)
    return SpacePiece((stretch.a, stretch.b), (arc,), 0.0)


def _row(frame: SpaceFrame) -> Frame:
    return (*frame.point, *frame.tangent)


def _floats(vector: Any) -> Vector:
    x, y, z = (0.0 if part.contains(0) else float(part.mid()) for part in vector)
    return x, y, z


def _piece(row: np.ndarray[Any, Any]) -> SpacePiece:
    """A row of the kernel's table."""
    left, right = bihelix_spline.LEFT, bihelix_spline.RIGHT
    arcs = tuple(helix_arc(row[place : place + HELIX_SIZE]) for place in (left, right))
    a, b, error, _, middle = row[:5].tolist()
    return SpacePiece((a, b), arcs, error, middle)


def helix_arc(helix: np.ndarray[Any, Any]) -> HelixArc:
    """A `kernels.helix.Helix`, an array of 17 numbers, as a `HelixArc`: V of the thesis is minus the axis."""
    start, tangent, inward = helix[0:3], helix[3:6], helix[9:12]
    rate, length, _, curvature, torsion = helix[12:17].tolist()
    axis = tangent
    if rate:  # V = T₀×(V×T₀) + ⟨V,T₀⟩T₀
        axis = np.cross(tangent, inward) + torsion / rate * tangent
        axis = axis / np.linalg.norm(axis)
    return HelixArc(_vector(start), _vector(tangent), _vector(axis), curvature, torsion, length)


def _vector(values: np.ndarray[Any, Any]) -> Vector:
    x, y, z = values.tolist()
    return x, y, z
