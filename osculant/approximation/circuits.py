"""A closed curve without split points, as a spline goes round it from any start."""

from __future__ import annotations

import math
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from osculant.approximation.arcs import Arcs
from osculant.approximation.division import begun_at
from osculant.approximation.equal_errors import equalise
from osculant.approximation.start_points import Start, best_start, start_within
from osculant.approximation.unsplit import UnsplitArcs
from osculant.kernels import search
from osculant.tolerances import window, writing_share

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.division import Division
    from osculant.approximation.runs import Floats
    from osculant.primitives.primitive import Fit

#: periods after which a kernel stops in any case
ROUNDS = 2
#: where the errors from other starts are sought, as a ratio to the first, and how sharply
WITHIN, SHARP = 16.0, 1e-6
#: starts tried where errors need not grow with arcs
FEW = 6


class Circuit:
    """What `osculant.approximation.start_points` asks of a closed curve.

    Args:
        coordinates: the curve's.
        fit: of what the pieces are.
        division: of the curve, free; its stretch is generic.

    With points in ``division.unsplit`` errors need not grow with arcs, and nothing is said of all starts.
    What is said rests on errors measured in doubles.

    >>> from osculant.approximation.coordinates import Coordinates
    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.plane import PlaneCurve
    >>> from osculant.primitives.table import choose
    >>> from osculant.approximation.division import divide
    >>> ellipse = PlaneCurve("2*cos(t), sin(t)", 0, "2*pi")
    >>> division = divide(ellipse, "parabola", closing="smooth")
    >>> circuit = Circuit(Coordinates(ellipse, extent(ellipse)), choose("parabola", "hausdorff"), division)
    >>> error = circuit.error_from(1.0, 8)
    >>> abs(circuit.reach(1.0, error, 8) - 1.0 - circuit.period) < 1e-5
    True
    """

    def __init__(self, coordinates: Coordinates, fit: Fit, division: Division) -> None:
        self.coordinates, self.fit, self.division = coordinates, fit, division
        (stretch,) = division.stretches
        self.low, self.period = stretch.a, stretch.b - stretch.a
        self._arcs = Arcs(coordinates, fit, stretch)
        self._rounding = coordinates.size.rounding(fit.degree)

    @cached_property
    def _course(self) -> Floats:
        """The course of all that may be passed, from any start."""
        return self._arcs.course(self.low, self.low + (1 + ROUNDS) * self.period)

    @property
    def resolution(self) -> float:
        """What two errors must differ by to be told apart."""
        return 16 * writing_share(0.0, self._rounding)

    def best_start(self, count: int) -> Start:
        """The start from which so many pieces have the least greatest error: `best_start` there."""
        if self.division.unsplit:
            return self._likely_start(count)
        return best_start(
            partial(self.error_from, count=count), self.reach, self.low, self.period, count, self.resolution
        )

    def _likely_start(self, count: int) -> Start:
        """The same where errors need not grow with arcs: of a few starts, one the best for greedy pieces.

        A greedy chain is quick, but not always near the least error; that takes too long for a finer search.
        """
        first = Start(self.low, self.error_from(self.low, count))
        if not math.isfinite(first.error):
            return first

        def greedy_error(start: float) -> float:
            low, high = first.error / WITHIN, first.error * WITHIN
            if not self.end_within(high, start, count) >= start + self.period:
                return math.inf
            while high > low * (1 + SHARP):
                level = math.sqrt(low * high)
                if self.end_within(level, start, count) >= start + self.period:
                    high = level
                else:
                    low = level
            return high

        likely = best_start(greedy_error, self.reach, self.low, self.period, count, work=0).at
        step = (min(self.reach(self.low, first.error, 1), self.low + self.period) - self.low) / FEW
        others = [likely, *(self.low + i * step for i in range(1, FEW))]
        starts = [first, *(Start(at, self.error_from(at, count)) for at in others)]
        return min(starts, key=lambda start: start.error)

    def start_within(self, tolerance: float, count: int) -> tuple[float | None, bool]:
        """A start from which so many pieces within the tolerance go round: `start_within` there."""
        beyond = partial(self._beyond, tolerance)
        found, decided = start_within(
            partial(self.end_within, tolerance), beyond, self.low, self.period, count
        )
        if found is not None or not self.division.unsplit:
            return found, decided
        best = self.best_start(count)
        return (best.at, True) if best.error <= tolerance else (None, False)

    def arcs_from(self, start: float) -> Arcs:
        """The stretch once round from a start."""
        stretch = begun_at(self.coordinates.curve, self.division, start)
        return (UnsplitArcs if self.division.unsplit else Arcs)(self.coordinates, self.fit, stretch)

    def error_from(self, start: float, count: int) -> float:
        """The error of so many pieces once round from a start, as equal as they can be."""
        return equalise(self.arcs_from(start), count).error

    def end_within(self, tolerance: float, start: float, count: int) -> float:
        """Where so many greedy pieces from a start end whose errors are within the tolerance."""
        end = self._end(start, *window(tolerance, self._rounding), count)
        return start if end is None else end

    def reach(self, start: float, level: float, count: int) -> float:
        """At least where the longest pieces from a start with errors of at most the level end."""
        above = level + 4 * writing_share(level, self._rounding)  # the window of that lies above the level
        end = self._end(start, *window(above, self._rounding), count)
        return math.inf if end is None else end

    def _beyond(self, level: float, start: float, count: int) -> float:
        return self.reach(start, level, count)

    def _end(self, start: float, low: float, high: float, count: int) -> float | None:
        """Where so many greedy pieces end; None where doubles cannot follow the curve."""
        job = self._arcs.job(low, high)
        frame = self._arcs.frame_at(start)
        job = job._replace(
            a=start,
            start=frame,
            stop=start + ROUNDS * self.period,  # so far on that no piece is fitted to end there
            last=frame,
            length=self.period / count,
            course=self._course,
        )
        found, end, _ = search.spline(*job, np.empty((count, self._arcs.columns)))
        return end if found == count or end == job.stop else None
