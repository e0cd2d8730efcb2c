"""From stretches to pieces: feeds the kernels and turns their tables into `Piece` objects."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from osculant.biarcs import Biarc
from osculant.cas.errors import UndecidedError
from osculant.kernels import bitangent, greedy, scan
from osculant.kernels.curve import JET_SIZE, Place, sample_many
from osculant.kernels.jit import announce
from osculant.pieces import Piece, classify
from osculant.primitives import PRIMITIVES
from osculant.stretches import Division, Frame, Stretch
from osculant.tolerances import window

if TYPE_CHECKING:
    from osculant.extent import Extent
    from osculant.plane import PlaneCurve

#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: pieces per call of the kernel
CHUNK = 4096
#: more pieces than this are not made
MOST_PIECES = 5_000_000
#: panels and nodes of the quadrature of affine length along an exact arc
PANELS, NODES = 64, 8


class Job(NamedTuple):
    """The arguments of `kernels.greedy.spline` but for its table."""

    primitive: int
    address: int
    place: Place
    a: float
    start: tuple[float, float, float, float]
    stop: float
    last: tuple[float, float, float, float]
    low: float
    high: float
    length: float


class Fitting:
    """One approximation: a divided curve, a primitive and a tolerance, in the kernels' local coordinates."""

    def __init__(
        self, curve: PlaneCurve, primitive: str, tolerance: float, division: Division, size: Extent
    ) -> None:
        announce()
        self.curve, self.primitive, self.tolerance = curve, primitive, tolerance
        self.division = division
        self.origin, self.scale = size.origin, size.scale
        self.noise = NOISE_ULPS * math.ulp(size.largest) * size.scale
        self.window = window(tolerance, size.largest)
        #: how many pieces too many one piece may be, its error being anywhere in the window
        self.slack = (1 - self.window[0] / tolerance) / PRIMITIVES[primitive].order
        #: whether a piece ended where no longer arc had a proper conic or parabola, short of the tolerance
        self.limited = False

    def _jets(self, times: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        out = np.empty((len(times), JET_SIZE))
        sample_many(self.curve.compiled.address, times, out)
        return out

    def pieces(self, stretch: Stretch, progress: Callable[[float], None] | None) -> list[Piece | Biarc]:
        """The pieces of one stretch; errors of inner pieces within the window of the tolerance."""
        if stretch.kind == "segment":
            return [Piece.segment((stretch.a, stretch.b), stretch.start.point, stretch.end.point)]
        if stretch.kind == "exact" and self.primitive == "biarc":
            return self._circle_pieces(stretch, progress)
        if stretch.kind == "exact":
            return self._exact_pieces(stretch, progress)
        return self._greedy_pieces(stretch, progress)

    def _place(self, stretch: Stretch) -> Place:
        return (*self.origin, self.scale, stretch.bend, self.noise)

    def _local(self, frame: Frame, bend: float) -> tuple[float, float, float, float]:
        (x, y), (tx, ty) = frame.point, frame.tangent
        return (
            (x - self.origin[0]) * self.scale,
            (y - self.origin[1]) * self.scale * bend,
            tx,
            ty * bend,
        )

    def job(self, stretch: Stretch) -> Job:
        """The kernel's arguments for a stretch from its beginning."""
        return Job(
            PRIMITIVES[self.primitive].code,
            self.curve.compiled.address,
            self._place(stretch),
            stretch.a,
            self._local(stretch.start, stretch.bend),
            stretch.b,
            self._local(stretch.end, stretch.bend),
            self.window[0] * self.scale,
            self.window[1] * self.scale,
            (stretch.b - stretch.a) / 8,
        )

    def _greedy_pieces(
        self, stretch: Stretch, progress: Callable[[float], None] | None
    ) -> list[Piece | Biarc]:
        job = self.job(stretch)
        pieces: list[Piece | Biarc] = []
        first, last = self.division.stretches[0].a, self.division.stretches[-1].b
        table = np.empty((CHUNK, greedy.COLUMNS))
        while job.a < stretch.b:
            count, reached, _ = greedy.spline(*job, table)
            pieces += [self._piece(row, stretch.bend) for row in table[:count]]
            self.limited |= bool((table[:count, greedy.REASON] == greedy.ENDS_AT_LIMIT).any())
            if progress is not None:
                progress((reached - first) / (last - first))
            if count < CHUNK and reached < stretch.b:
                raise UndecidedError(
                    f"No {self.primitive} within {self.tolerance:g} was found for the curve after "
                    f"t = {reached:.15g}, where double numbers cannot follow it: choose a split point there, "
                    "or another interval."
                )
            if len(pieces) > MOST_PIECES:
                raise UndecidedError(
                    f"More than {MOST_PIECES} pieces are needed: choose a larger tolerance "
                    "or a shorter interval."
                )
            start = greedy.frame((job.address, job.place, np.empty(JET_SIZE)), reached)
            job = job._replace(a=reached, start=start, length=table[count - 1, 1] - table[count - 1, 0])
        return pieces

    def _piece(self, row: np.ndarray[Any, Any], bend: float) -> Piece | Biarc:
        """A row of the kernel's table (`greedy.record`) in the user's coordinates."""
        if self.primitive == "biarc":
            return self._biarc(row, bend)
        a, b, q, error, _, x0, y0, tx, ty, x2, y2, w, reach, _, _ = (float(v) for v in row)
        kind = classify(w)
        if self.primitive == "parabola":
            kind, w = "parabola", 1.0
        back = 1.0 / self.scale
        start, end = self._user(x0, y0, bend), self._user(x2, y2, bend)
        if q == 0:
            return Piece.segment((a, b), start, end, error * back)
        reach *= back
        middle = (w * start[0] + reach * tx, w * start[1] + reach * ty * bend)
        return Piece(kind, (a, b), start, end, middle, w, error * back)

    def _user(self, x: float, y: float, bend: float) -> tuple[float, float]:
        back = 1.0 / self.scale
        return x * back + self.origin[0], y * back * bend + self.origin[1]

    def _biarc(self, row: np.ndarray[Any, Any], bend: float) -> Biarc:
        a, b, _, error, _, x0, y0, tx, ty, x2, y2, x1, y1, *bends = (float(v) for v in row)
        chord = math.hypot(x1 - x0, y1 - y0)
        dx, dy = (x1 - x0) / chord, (y1 - y0) / chord
        dot, cross = tx * dx + ty * dy, tx * dy - ty * dx
        return Biarc(
            "biarc",
            (a, b),
            self._user(x0, y0, bend),
            self._user(x1, y1, bend),
            self._user(x2, y2, bend),
            ((tx, ty * bend), (dx * dot - dy * cross, (dy * dot + dx * cross) * bend)),
            (bends[0] * bend * self.scale, bends[1] * bend * self.scale),
            error / self.scale,
        )

    def _circle_pieces(
        self, stretch: Stretch, progress: Callable[[float], None] | None
    ) -> list[Piece | Biarc]:
        """The least number of arcs turning less than 2π each, of equal length, of a circle itself."""
        from osculant.cas.balls import PRECISION, precision

        with precision(PRECISION):
            inside = (stretch.low + (stretch.high - stretch.low) * 0.4871).mid()
            bend = float(self.curve.balls.jet(inside, 2).curvature.mid())
        knots = np.array(self._equal_affine_lengths(stretch, 2))
        jets = self._jets(knots)
        speeds = np.hypot(jets[:, 1], jets[:, 4])
        points, tangents = jets[:, [0, 3]], jets[:, [1, 4]] / speeds[:, None]
        for i, frame in ((0, stretch.start), (-1, stretch.end)):
            points[i], tangents[i] = frame.point, frame.tangent
        attained = _off_circles(points, tangents, bend, knots, self._jets)
        if not attained <= self.tolerance:
            self.limited = True
            return self._greedy_pieces(stretch, progress)
        error = 0.0 if self.division.proved else attained
        return [
            Biarc(
                "arc",
                (float(knots[i]), float(knots[i + 2])),
                _pair(points[i]),
                _pair(points[i + 1]),
                _pair(points[i + 2]),
                (_pair(tangents[i]), _pair(tangents[i + 1])),
                (bend, bend),
                error,
            )
            for i in range(0, len(knots) - 1, 2)
        ]

    def _exact_pieces(
        self, stretch: Stretch, progress: Callable[[float], None] | None
    ) -> list[Piece | Biarc]:
        """The least number of arcs turning less than π each, of equal affine length, of a conic itself."""
        source = (self.curve.compiled.address, self._place(stretch), np.empty(JET_SIZE))
        space = scan.workspace()
        knots = self._equal_affine_lengths(stretch)
        frames = [greedy.frame(source, t) for t in knots[1:-1]]
        frames = [self._local(stretch.start, stretch.bend), *frames, self._local(stretch.end, stretch.bend)]
        pieces: list[Piece | Biarc] = []
        row = np.empty(greedy.COLUMNS)
        for a, b, start, end in zip(knots, knots[1:], frames, frames[1:]):
            pencil = bitangent.pencil(start, end, self.noise)
            q = bitangent.through(bitangent.view(pencil, source, a + 0.4871 * (b - a)))
            attained = scan.measure(pencil, q, source, a, b, scan.GRID, space) / self.scale
            if not attained <= self.tolerance:  # a bend too sharp for the arc's doubles: search instead
                self.limited = True
                return self._greedy_pieces(stretch, progress)
            error = 0.0 if self.division.proved else attained * self.scale
            greedy.record(PRIMITIVES[self.primitive].code, row, a, b, q, error, 0, start, end, self.noise)
            pieces.append(self._piece(row, stretch.bend))
        return pieces

    def _equal_affine_lengths(self, stretch: Stretch, parts: int = 1) -> list[float]:
        """Knots of the arcs of an exact conic, each in so many parts: it turns by π over r = π/√k."""
        from osculant.cas.balls import PRECISION, precision

        with precision(PRECISION):
            inside = (stretch.low + (stretch.high - stretch.low) * 0.4871).mid()
            k = float(self.curve.balls.jet(inside, 4).affine_curvature.mid())
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        edges = np.linspace(stretch.a, stretch.b, PANELS + 1)
        half = np.diff(edges) / 2
        times = (edges[:-1] + half)[:, None] + half[:, None] * nodes
        jets = self._jets(times.ravel())
        density = np.cbrt(np.abs(jets[:, 1] * jets[:, 5] - jets[:, 2] * jets[:, 4])).reshape(times.shape)
        lengths = np.concatenate([[0.0], np.cumsum(half * (density @ weights))])
        turns = lengths[-1] * math.sqrt(max(k, 0.0)) / PRIMITIVES[self.primitive].turning
        count = (math.floor(turns + 1e-9) + 1) * parts  # a turning of exactly so much is one too much
        inner = np.interp(np.arange(1, count) * lengths[-1] / count, lengths, edges)
        return [stretch.a, *map(float, inner), stretch.b]


def _pair(row: np.ndarray[Any, Any]) -> tuple[float, float]:
    return float(row[0]), float(row[1])


def _off_circles(
    points: np.ndarray[Any, Any],
    tangents: np.ndarray[Any, Any],
    bend: float,
    knots: np.ndarray[Any, Any],
    jets_at: Callable[[np.ndarray[Any, Any]], np.ndarray[Any, Any]],
) -> float:
    """How far the curve is from the circles with curvature ``bend`` that touch it at the knots."""
    parts = np.linspace(0.0, 1.0, scan.GRID)
    times = knots[:-1, None] + np.diff(knots)[:, None] * parts
    at = jets_at(times.ravel())[:, [0, 3]].reshape(*times.shape, 2) - points[:-1, None]
    (tx, ty), (x, y) = tangents[:-1, :, None].transpose(1, 0, 2), np.moveaxis(at, -1, 0)
    twice = 2 * (tx * y - ty * x) - bend * (x * x + y * y)
    return float(np.abs(twice / (1 + np.sqrt(np.maximum(0.0, 1 - bend * twice)))).max())
