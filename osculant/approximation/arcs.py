"""The arcs of one stretch of a plane curve, fitted by the kernels."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from osculant.approximation.division import Frame
from osculant.approximation.runs import Floats, Progress, Run, equal_parts, equal_shares, not_found, too_many
from osculant.codegen.jets import compile_jet
from osculant.kernels import search as greedy
from osculant.kernels.counting import count_larger
from osculant.kernels.curves.plane import JET_SIZE, Place, Source
from osculant.kernels.given_knots import fit_arcs
from osculant.kernels.primitives import BIARCS, PARABOLAS
from osculant.kernels.quadrature import contents
from osculant.pieces.biarcs import Biarc
from osculant.pieces.conics import Piece, classify

if TYPE_CHECKING:
    from osculant.approximation.division import Stretch
    from osculant.curves.extent import Extent
    from osculant.curves.plane import PlaneCurve
    from osculant.primitives.table import Fit

#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: pieces per call of the kernel
CHUNK = 4096
#: more pieces than this are not made
MOST_PIECES = 5_000_000
#: points per piece, and of all, that tell the content of a stretch
CONTENT_POINTS, LEAST_POINTS = 4, 256
#: an error, in the kernels' units, that no piece has
BOUNDLESS = 1e100

Local = tuple[float, float, float, float]


class Job(NamedTuple):
    """The arguments of `kernels.search.spline` but for its table."""

    code: int
    address: int
    place: Place
    a: float
    start: Local
    stop: float
    last: Local
    low: float
    high: float
    length: float


class Coordinates:
    """The kernels' coordinates of a curve: moved to its first point and scaled to a size of about 1."""

    def __init__(self, curve: PlaneCurve, size: Extent) -> None:
        x, y = size.origin
        self.curve, self.origin, self.scale, self.size = curve, (x, y), size.scale, size
        self.noise = NOISE_ULPS * math.ulp(size.largest) * size.scale

    def place(self, bend: float) -> Place:
        """What kernels take as the place of a curve that bends to the left (1) or to the right (−1)."""
        return (*self.origin, self.scale, bend, self.noise)

    def local(self, frame: Frame, bend: float) -> Local:
        """A frame in the kernels' coordinates."""
        (x, y), (tx, ty) = frame.point, frame.tangent
        return (
            (x - self.origin[0]) * self.scale,
            (y - self.origin[1]) * self.scale * bend,
            tx,
            ty * bend,
        )

    def user(self, x: float, y: float, bend: float) -> tuple[float, float]:
        """A point of the kernels' in the user's coordinates."""
        back = 1.0 / self.scale
        return x * back + self.origin[0], y * back * bend + self.origin[1]


class Arcs:
    """A stretch where curve and primitive differ, for a fit: a `osculant.approximation.runs.Part`."""

    exact = False

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        self.coordinates, self.fit, self.stretch = coordinates, fit, stretch
        self.order, self.ends = fit.order, (stretch.a, stretch.b)
        self.unit = coordinates.scale**fit.dimension
        self.noise = NOISE_ULPS * coordinates.size.rounding(fit.dimension)

    @cached_property
    def least(self) -> int:
        """How many pieces it takes however large their errors may be."""
        return len(self.greedy(math.inf, math.inf))

    @cached_property
    def _scratch(self) -> Floats:
        return np.empty((CHUNK, greedy.COLUMNS))

    @cached_property
    def source(self) -> Source:
        """What kernels sample the curve by, with room for one jet."""
        at = self.coordinates
        return at.curve.compiled.address, at.place(self.stretch.bend), np.empty(JET_SIZE)

    def frame_at(self, t: float) -> Local:
        """The frame of the curve at t in the kernels' coordinates."""
        return greedy.frame(self.source, t)

    def job(self, low: float, high: float) -> Job:
        """The kernel's arguments for the stretch from its beginning, for errors in the user's units."""
        return self._job._replace(low=low * self.unit, high=high * self.unit)

    @cached_property
    def _job(self) -> Job:
        stretch, at = self.stretch, self.coordinates
        return Job(
            self.fit.code,
            at.curve.compiled.address,
            at.place(stretch.bend),
            stretch.a,
            at.local(stretch.start, stretch.bend),
            stretch.b,
            at.local(stretch.end, stretch.bend),
            0.0,
            0.0,
            (stretch.b - stretch.a) / 8,
        )

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """The longest pieces within ``high``; raises UndecidedError where doubles cannot follow the curve."""
        most = BOUNDLESS / self.unit
        job = self.job(min(low, 0.5 * most), min(high, most))
        tables, count, table = [], 0, self._scratch
        while job.a < job.stop:
            found, reached, _ = greedy.spline(*job, table)
            tables.append(table[:found].copy())
            count += found
            if progress is not None:
                progress((reached - self.ends[0]) / (job.stop - self.ends[0]))
            if found < CHUNK and reached < job.stop:
                raise not_found("piece", high, reached)
            if count > MOST_PIECES:
                raise too_many(MOST_PIECES)
            length = table[found - 1, 1] - table[found - 1, 0]
            job = job._replace(a=reached, start=self.frame_at(reached), length=length)
        return self._run(np.concatenate(tables))

    def at_least(self, high: float) -> int:
        """A quick lower bound of the number of greedy pieces with errors at most ``high``."""
        job = self.job(high, high)
        return int(count_larger(*job[:7], job.high, job.length))

    def fitted(self, knots: Floats) -> Run:
        """The best piece for each arc between neighbouring knots; error infinite where there is none."""
        table = np.empty((len(knots) - 1, greedy.COLUMNS))
        job = self.job(0.0, 0.0)
        fit_arcs(job.code, job.address, job.place, knots, job.start, job.last, table)
        return self._run(table)

    def spread(self, count: int) -> Floats:
        """Knots of equal content, from the density that theory integrates to the number of pieces."""
        times = equal_parts(self.ends, max(LEAST_POINTS, CONTENT_POINTS * count))
        total = np.empty_like(times)
        jet = compile_jet(self.coordinates.curve.coordinates, 5)  # owns the code at its address
        contents(self.fit.code, jet.address, self.coordinates.scale, times, total)
        if not (math.isfinite(total[-1]) and total[-1] > 0):
            return equal_parts(self.ends, count)
        knots = equal_shares(times, total, count)
        return knots if (np.diff(knots) > 0).all() else equal_parts(self.ends, count)

    def starting_at(self, t: float) -> Stretch:
        """The stretch from t on."""
        from flint import arb

        return replace(self.stretch, low=arb(t), a=t, start=self._frame(t))

    def ending_at(self, t: float) -> Stretch:
        """The stretch up to t."""
        from flint import arb

        return replace(self.stretch, high=arb(t), b=t, end=self._frame(t))

    def _frame(self, t: float) -> Frame:
        bend = self.stretch.bend
        x, y, tx, ty = self.frame_at(t)
        return Frame(self.coordinates.user(x, y, bend), (tx, ty * bend))

    def _run(self, table: Floats) -> Run:
        reasons = table[:, greedy.REASON]
        return Run(
            np.append(table[:, 0], table[-1, 1]),
            table[:, greedy.ERROR] / self.unit,
            table,
            bool((reasons == greedy.ENDS_AT_LIMIT).any()),
            bool((reasons == greedy.ENDS_EARLY).any()),
        )

    def pieces(self, run: Run) -> list[Piece | Biarc]:
        """The pieces themselves, in the user's coordinates."""
        make = self._biarc if self.fit.code in BIARCS else self._conic
        return [make(row, float(error)) for row, error in zip(run.rows, run.errors, strict=True)]

    def _conic(self, row: np.ndarray[Any, Any], error: float) -> Piece:
        """A row of the kernel's table (`greedy.record`) as a conic arc."""
        a, b, q, _, _, x0, y0, tx, ty, x2, y2, w, reach, _, _ = (float(v) for v in row)
        at, bend = self.coordinates, self.stretch.bend
        start, end = at.user(x0, y0, bend), at.user(x2, y2, bend)
        if q == 0:
            return Piece.segment((a, b), start, end, error)
        kind = classify(w)
        if self.fit.code in PARABOLAS:
            kind, w = "parabola", 1.0
        reach /= at.scale
        middle = (w * start[0] + reach * tx, w * start[1] + reach * ty * bend)
        return Piece(kind, (a, b), start, end, middle, w, error)

    def _biarc(self, row: np.ndarray[Any, Any], error: float) -> Biarc:
        """A row of the kernel's table as a biarc."""
        a, b, _, _, _, x0, y0, tx, ty, x2, y2, x1, y1, *bends = (float(v) for v in row)
        at, bend = self.coordinates, self.stretch.bend
        chord = math.hypot(x1 - x0, y1 - y0)
        dx, dy = (x1 - x0) / chord, (y1 - y0) / chord
        dot, cross = tx * dx + ty * dy, tx * dy - ty * dx
        return Biarc(
            "arc" if self.exact and error == 0 else "biarc",
            (a, b),
            at.user(x0, y0, bend),
            at.user(x1, y1, bend),
            at.user(x2, y2, bend),
            ((tx, ty * bend), (dx * dot - dy * cross, (dy * dot + dx * cross) * bend)),
            (bends[0] * bend * at.scale, bends[1] * bend * at.scale),
            error,
        )
