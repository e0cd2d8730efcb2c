"""The arcs of one stretch, in the plane or in space, fitted by the kernels."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from osculant.approximation.coordinates import Coordinates
from osculant.approximation.runs import (
    Floats,
    Progress,
    Run,
    equal_parts,
    equal_shares,
    not_found,
    too_many,
)
from osculant.curves.kept import kept
from osculant.kernels import operations, search
from osculant.kernels.counting import count_larger
from osculant.kernels.course import MOST, lay_out
from osculant.kernels.given_knots import fit_arcs
from osculant.kernels.quadrature import contents
from osculant.kernels.shapes import shapes

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Local, Place
    from osculant.approximation.stretches import Stretch
    from osculant.curves.curve import FormulaCurve
    from osculant.curves.extent import Extent
    from osculant.primitives.primitive import Fit

#: pieces per call of the kernel
CHUNK = 4096
#: more pieces than this are not made
MOST_PIECES = 20_000_000
#: rows of a stretch's course at first
COURSE = 1024
#: panels per piece, and of all, that tell the content of a stretch
CONTENT_POINTS, LEAST_POINTS = 8, 1024
#: the area between what lies within a distance of one point and a small piece, in squares of that
PASSED = 4.0
#: an error, in the kernels' units, that no piece has
BOUNDLESS = 1e100


class Job(NamedTuple):
    """The arguments of `kernels.search.spline` but for its table."""

    record: Any
    address: int
    place: Place
    a: float
    start: Local
    stop: float
    last: Local
    low: float
    high: float
    length: float
    course: Floats


class Arcs:
    """A stretch where curve and primitive differ, for a fit: a `osculant.approximation.runs.Part`.

    Where the primitive's errors are not monotone (`Primitive.monotone`), the pieces found are good ones, and
    no proof says that they are the best.
    """

    exact = False

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        self.coordinates, self.curve, self.fit, self.stretch = coordinates, coordinates.curve, fit, stretch
        self.order, self.ends = fit.law(stretch.kind).order, (stretch.a, stretch.b)
        self.unit = coordinates.scale**fit.degree
        self.noise = coordinates.error_noise(fit.degree)
        #: where the curve is passed over at an end, areas have so much more, distances are at least so much
        self.spare = PASSED * stretch.reach**2 if fit.degree == 2 else 0.0
        self.reach = stretch.reach if fit.degree == 1 else 0.0
        self.record = fit.record(self.order)
        self.columns = operations.columns(type(self.record))

    @cached_property
    def least(self) -> int:
        """How many pieces it takes however large their errors may be, the longest that are proper."""
        return len(self.greedy(math.inf, math.inf))

    @cached_property
    def _scratch(self) -> Floats:
        return np.empty((CHUNK, self.columns))

    @cached_property
    def place(self) -> Place:
        """The kernels' place of the curve, which bends to the left there."""
        return self.coordinates.place(self.stretch.bend)

    def frame_at(self, t: float) -> Local:
        """The frame of the curve at t in the kernels' coordinates."""
        return self.coordinates.frame_at(t, self.place)

    def course(self, a: float, b: float) -> Floats:
        """How the curve turns and how long it is from a to b (`osculant.kernels.course`); kept."""
        size, resolution = self.coordinates.size, self.coordinates.resolution
        return _course(self.curve, type(self.record), self.record, size, resolution, self.place, a, b)

    def job(self, low: float, high: float) -> Job:
        """The kernel's arguments for the stretch from its beginning, for errors in the user's units."""
        low, high = max(low - self.spare, 0.0), max(high - self.spare, 0.0)
        return self._job._replace(low=low * self.unit, high=high * self.unit)

    @cached_property
    def _job(self) -> Job:
        (a, b), at = self.ends, self.coordinates
        return Job(
            self.record,
            self.curve.compiled.address,
            self.place,
            a,
            at.local(self.stretch.start, self.place),
            b,
            at.local(self.stretch.end, self.place),
            0.0,
            0.0,
            (b - a) / 8,
            self.course(a, b),
        )

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """The longest pieces within ``high``; raises UndecidedError where doubles cannot follow the curve."""
        most = BOUNDLESS / self.unit
        job = self.job(min(low, 0.5 * most), min(high, most))
        tables, count, table = [], 0, self._scratch
        while True:
            found, reached, _ = search.spline(*job, table)
            tables.append(table[:found].copy())
            count += found
            if progress is not None:
                progress((reached - self.ends[0]) / (job.stop - self.ends[0]))
            if found < CHUNK and reached < job.stop:
                raise not_found(high, reached)
            if count > MOST_PIECES:
                raise too_many(MOST_PIECES)
            if not reached < job.stop:
                break
            length = table[found - 1, operations.B] - table[found - 1, operations.A]
            job = job._replace(a=reached, start=self.frame_at(reached), length=length)
        return self._run(tables[0] if len(tables) == 1 else np.concatenate(tables))

    def at_least(self, high: float) -> int:
        """A quick lower bound of the number of greedy pieces with errors at most ``high``."""
        if not self.fit.primitive.monotone:
            return self.least
        job = self.job(high, high)
        return int(count_larger(*job[:7], job.high, job.length, job.course))

    def fitted(self, knots: Floats) -> Run:
        """The best piece for each arc between neighbouring knots; error infinite where there is none."""
        table = np.empty((len(knots) - 1, self.columns))
        job = self.job(0.0, 0.0)
        fit_arcs(job.record, job.address, job.place, knots, job.start, job.last, job.course, table)
        return self._run(table)

    def spread(self, count: int) -> Floats:
        """Knots of equal content, from the density that theory integrates to the number of pieces."""
        times = equal_parts(self.ends, max(LEAST_POINTS, CONTENT_POINTS * count))
        total = np.empty_like(times)
        jet = self.curve.jet_for(self.fit.law(self.stretch.kind))  # owns the code at its address
        contents(self.record, jet.address, self.coordinates.scale, times, total)
        if not (math.isfinite(total[-1]) and total[-1] > 0):
            return equal_parts(self.ends, count)
        knots = equal_shares(times, total, count)
        return knots if (np.diff(knots) > 0).all() else equal_parts(self.ends, count)

    def starting_at(self, t: float) -> Stretch:
        """The stretch from t on."""
        from flint import arb

        return replace(self.stretch, low=arb(t), a=t, start=self.coordinates.user_frame(t, self.place))

    def ending_at(self, t: float) -> Stretch:
        """The stretch up to t."""
        from flint import arb

        return replace(self.stretch, high=arb(t), b=t, end=self.coordinates.user_frame(t, self.place))

    def _run(self, table: Floats) -> Run:
        reasons = set(table[:, operations.REASON].tolist())
        knots = np.empty(len(table) + 1)
        knots[:-1], knots[-1] = table[:, operations.A], table[-1, operations.B]
        return Run(
            knots,
            np.maximum(table[:, operations.ERROR] / self.unit + self.spare, self.reach),
            table,
            search.ENDS_AT_LIMIT in reasons,
            search.ENDS_EARLY in reasons,
        )

    def pieces(self, run: Run) -> list[Any]:
        """The pieces themselves, in the user's coordinates."""
        found = np.empty((len(run), len(operations.piece_type(type(self.record))._fields)))
        shapes(self.record, run.rows, self.place, run.errors, found)
        pieces = self.fit.primitive.pieces(run.rows, found)
        if self.stretch.covers is not None:
            first, last = self.stretch.covers
            pieces[0] = replace(pieces[0], interval=(first, pieces[0].interval[1]))
            pieces[-1] = replace(pieces[-1], interval=(pieces[-1].interval[0], last))
        return pieces


@kept
def _course(
    curve: FormulaCurve,
    fit: type,
    record: Any,
    size: Extent,
    resolution: float | None,
    place: Place,
    a: float,
    b: float,
) -> Floats:
    """`Arcs.course`, of records of the class ``fit``: equal ones may be of different classes."""
    edges = Coordinates(curve, size, resolution).edges(a, b)
    for rows in (COURSE, MOST):
        course = np.empty((rows, 3))
        found = lay_out(record, curve.compiled.address, place, edges, course)
        if found > 0:
            return course[:found].copy()
    raise too_many(MOST)
