"""From stretches to pieces: the fewest for a tolerance, for an area in all, or the best of a given number."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from osculant.approximation.allocation import CHECKED_PIECES, check_least, given_pieces, may_be_less, within
from osculant.approximation.arcs import Arcs, Coordinates
from osculant.approximation.circuits import Circuit
from osculant.approximation.exact_arcs import ExactArcs, Segments
from osculant.approximation.runs import share_of, whole_error
from osculant.approximation.unsplit import UnsplitArcs
from osculant.cas.errors import UndecidedError
from osculant.kernels.jit import announce
from osculant.tolerances import window

if TYPE_CHECKING:
    from osculant.approximation.division import Division, Stretch
    from osculant.approximation.runs import Progress, Run
    from osculant.curves.extent import Extent
    from osculant.curves.plane import PlaneCurve
    from osculant.pieces.biarcs import Biarc
    from osculant.pieces.conics import Piece
    from osculant.primitives.table import Fit

#: rounds of the search for the number of pieces of an area
ROUNDS = 200
#: tolerances are looked at so much above, in parts of them, for a closed curve with one piece less
NEAR = 1e-5


class Fitting:
    """A divided curve, ready to be approximated by one primitive.

    ``certain`` turns False where the fewest pieces found may not be the fewest there are: a piece ended,
    short of the tolerance, where no longer arc had a proper one, or rounding may have cost one.

    A closed curve without split points may begin anywhere: ``parts`` and ``division`` then change to where it
    had best begin, and ``gap`` tells by what part of itself the error might be smaller from elsewhere.
    """

    def __init__(self, curve: PlaneCurve, primitive: str, fit: Fit, division: Division, size: Extent) -> None:
        announce()
        self.primitive, self.fit, self.division, self.size = primitive, fit, division, size
        self.coordinates = Coordinates(curve, size)
        self.parts = [self.part(stretch) for stretch in division.stretches]
        self.certain = True
        self.circuit: Circuit | None = None
        self.gap: float | None = None
        if division.free and division.stretches[0].kind == "generic":
            self.circuit = Circuit(self.coordinates, fit, division)

    def part(self, stretch: Stretch) -> Arcs | Segments:
        """A stretch with the way to fit pieces to it."""
        if stretch.kind == "segment":
            return Segments(self.coordinates, self.fit, stretch)
        if stretch.kind == "exact":
            return ExactArcs(self.coordinates, self.fit, stretch, self.primitive, self.division.proved)
        if self.division.unsplit:
            return UnsplitArcs(self.coordinates, self.fit, stretch, self.division.unsplit)
        return Arcs(self.coordinates, self.fit, stretch)

    def within(self, tolerance: float, progress: Progress | None = None) -> list[Run]:
        """The fewest pieces with errors up to the tolerance, stretch by stretch."""
        low, high = window(tolerance, self.size.rounding(self.fit.dimension))
        runs, self.certain = [], True
        for i, part in enumerate(self.parts):
            run, certain = within(part, low, high, tolerance, share_of(progress, i, len(self.parts)))
            runs.append(run)
            self.certain &= certain
        return self._from_elsewhere(runs, tolerance, lambda count: tolerance)

    def of_area(self, tolerance: float, progress: Progress | None = None) -> list[Run]:
        """The least n such that n pieces with areas up to tolerance/n suffice (thesis 3.7), and its pieces.

        The number at one n is a lower bound of all larger solutions: going on with it finds the least.
        """
        low, high = window(tolerance, self.size.rounding(2))
        count, beaten = len(self.parts), 0  # beaten: so many pieces are certainly too few
        while (found := self._at_least(high / count)) > count:
            beaten, count = count, found
        for _ in range(ROUNDS):
            runs = [part.greedy(low / count, high / count) for part in self.parts]
            found, self.certain = sum(map(len, runs)), not any(run.limited for run in runs)
            if progress is not None:
                progress(min(1.0, count / found))
            if found <= count:
                if found > beaten + 1:
                    runs = self._without_window(runs, tolerance)
                return self._from_elsewhere(runs, tolerance, lambda count: tolerance / count)
            count = found
        raise UndecidedError(
            f"The number of pieces for the area {tolerance:g} did not settle: choose another tolerance."
        )

    def _at_least(self, high: float) -> int:
        """A quick lower bound of the number of greedy pieces with errors up to ``high``."""
        return sum(part.at_least(high) for part in self.parts)

    def _without_window(self, runs: list[Run], tolerance: float) -> list[Run]:
        """The runs, or those of one piece less if only the window of the search was in their way."""
        count = sum(map(len, runs)) - 1
        if count < sum(part.least for part in self.parts):
            return runs
        low, high = (end / count for end in window(tolerance, self.size.rounding(2)))
        if self._at_least(high) > count:
            return runs
        trial = [part.greedy(low, high) for part in self.parts]
        spare = sum(
            may_be_less(part, run, low, high, tolerance / count)
            for part, run in zip(self.parts, trial, strict=True)
        )
        if sum(map(len, trial)) - spare > count:
            return runs
        if count > CHECKED_PIECES:
            self.certain = False
            return runs
        fewer = given_pieces(self.parts, count)
        # equal areas are so up to rounding: the largest may be above the mean by the window and the noise
        noise = max(part.noise for part in self.parts)
        equal = max(run.error for run in fewer) <= tolerance / count * (high / low) + noise
        return fewer if whole_error(fewer, 2) <= tolerance and equal else runs

    def of_number(self, count: int) -> list[Run]:
        """The pieces, ``count`` in all, with the least greatest error."""
        if self.circuit is not None:
            check_least(self.parts, count)
            start = self.circuit.best_start(count)
            self._begin_at(start.at)
            self.gap = start.gap
        return given_pieces(self.parts, count)

    def _begin_at(self, start: float) -> None:
        """Let a closed curve begin there."""
        assert self.circuit is not None
        part = self.circuit.arcs_from(start)
        self.parts, self.division = [part], replace(self.division, stretches=(part.stretch,))

    def _from_elsewhere(self, runs: list[Run], tolerance: float, level: Callable[[int], float]) -> list[Run]:
        """The runs of a closed curve, or fewer pieces from another start, their errors up to level(number).

        From any start the longest pieces are at most one too many, as they pass the knots of the fewest.
        """
        if self.circuit is None:
            return runs
        while (count := len(runs[0]) - 1) >= max(1, self.parts[0].least):
            near = level(count) * (1 + NEAR)
            start, decided = self.circuit.start_within(near, count)
            if start is None:
                self.certain &= decided
                break
            before, certain = (self.parts, self.division), self.certain
            fewer = self._fewer_from(start, level(count), count) or self.of_number(count)
            if not whole_error(fewer, self.fit.dimension) <= tolerance:
                (self.parts, self.division), self.certain, self.gap = before, False, None
                break
            runs, self.certain, self.gap = fewer, certain, None
        return runs

    def _fewer_from(self, start: float, level: float, count: int) -> list[Run] | None:
        """So many pieces within the level from a start, None if they do not suffice."""
        self._begin_at(start)
        run, _ = within(self.parts[0], *window(level, self.size.rounding(self.fit.dimension)), level)
        return [run] if len(run) <= count else None

    def pieces(self, runs: list[Run]) -> list[Piece | Biarc]:
        """The pieces of all stretches, in the user's coordinates."""
        return [piece for part, run in zip(self.parts, runs, strict=True) for piece in part.pieces(run)]
