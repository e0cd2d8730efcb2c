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
from osculant.kernels.quadrature import contents

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates, Local
    from osculant.approximation.division import Stretch
    from osculant.primitives.primitive import Fit

#: pieces per call of the kernel
CHUNK = 4096
#: more pieces than this are not made
MOST_PIECES = 5_000_000
#: points per piece, and of all, that tell the content of a stretch
CONTENT_POINTS, LEAST_POINTS = 4, 256
#: an error, in the kernels' units, that no piece has
BOUNDLESS = 1e100


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


class Arcs:
    """A stretch where curve and primitive differ, for a fit: a `osculant.approximation.runs.Part`."""

    exact = False

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        self.coordinates, self.fit, self.stretch = coordinates, fit, stretch
        self.order, self.ends = fit.order, (stretch.a, stretch.b)
        self.unit = coordinates.scale**fit.degree
        self.noise = coordinates.error_noise(fit.degree)

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

    def pieces(self, run: Run) -> list[Any]:
        """The pieces themselves, in the user's coordinates."""
        place = self.coordinates.place(self.stretch.bend)
        make = self.fit.primitive.piece
        return [make(row, place, float(error)) for row, error in zip(run.rows, run.errors, strict=True)]
