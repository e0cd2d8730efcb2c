"""From stretches to pieces: the fewest for a tolerance, for an area in all, or the best of a given number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from osculant.approximation.allocation import (
    CHECKED_PIECES,
    check_least,
    fewer,
    fewer_in_all,
    fewest,
    given_pieces,
    may_be_less,
)
from osculant.approximation.arcs import Arcs
from osculant.approximation.backward import either_way
from osculant.approximation.bridges import Bridge
from osculant.approximation.circuits import Circuit
from osculant.approximation.coordinates import Coordinates
from osculant.approximation.exact_arcs import CircleArcs, ConicArcs
from osculant.approximation.exact_helices import Helices
from osculant.approximation.runs import share_of, whole_error
from osculant.approximation.segments import Segments
from osculant.approximation.unsplit import UnsplitArcs
from osculant.cas.errors import UndecidedError
from osculant.tolerances import window

if TYPE_CHECKING:
    from osculant.approximation.division import Division
    from osculant.approximation.runs import Part, Progress, Run
    from osculant.approximation.stretches import Stretch
    from osculant.curves.curve import FormulaCurve
    from osculant.curves.extent import Extent
    from osculant.primitives.primitive import Fit

#: rounds of the search for the number of pieces of an area
ROUNDS = 200
#: tolerances are looked at so much above, in parts of them, for a closed curve with one piece less
NEAR = 1e-5
#: features that are larger than this part of the tolerance are not missed, which is less than the window of
#: errors leaves, and this one where theory says what errors look like; if no tolerance is given, parts of the
#: size in its place
RESOLVED, OUTLINED, SMALL = 1e-7, 1e-3, 1e-2
#: by `Itself.shape`, how a stretch of the plane is fitted that is an arc of the primitive
EXACT = {"conic": ConicArcs, "circle": CircleArcs}


@dataclass(frozen=True)
class Fitted:
    """The pieces that a search found, stretch by stretch, and what is known of them.

    Attributes:
        division: of the curve, begun where the search had it begin.
        parts: the stretches with the way pieces were fitted to them.
        runs: the pieces of each.
        certain: False where the fewest pieces found may not be the fewest there are: a piece ended, short of
            the tolerance, where no longer arc had a proper one, or rounding may have cost one.
        gap: of a closed curve that may begin anywhere, by what part of itself the error of so many pieces
            might be smaller from elsewhere; None if that was not sought.
    """

    division: Division
    parts: Sequence[Part]
    runs: Sequence[Run]
    certain: bool = True
    gap: float | None = None

    @property
    def count(self) -> int:
        """The number of pieces."""
        return sum(map(len, self.runs))

    def pieces(self) -> list[Any]:
        """The pieces of all stretches, in the user's coordinates."""
        return [piece for part, run in zip(self.parts, self.runs, strict=True) for piece in part.pieces(run)]


class Fitting:
    """A divided curve, ready to be approximated in one way.

    Args:
        curve: with its interval.
        fit: what the pieces are and how they are chosen.
        division: of the curve, for the fit's primitive.
        size: the curve's.
        tolerance: what will be asked for; None if it is a number of pieces.
    """

    def __init__(
        self, curve: FormulaCurve, fit: Fit, division: Division, size: Extent, tolerance: float | None = None
    ) -> None:
        self.fit, self.division, self.size = fit, division, size
        self.coordinates = Coordinates(curve, size, resolution(curve, fit, division, size, tolerance))
        self.rounding = size.rounding(fit.degree)
        self.parts = [part_of(self.coordinates, fit, division, stretch) for stretch in division.stretches]
        self.circuit: Circuit | None = None
        if division.free and division.stretches[0].kind == "generic":
            self.circuit = Circuit(self.coordinates, fit, division)

    def for_tolerance(self, tolerance: float, progress: Progress | None = None) -> Fitted:
        """The fewest pieces with errors up to the tolerance, stretch by stretch."""
        ends, runs, certain = window(tolerance, self.rounding), [], True
        for i, part in enumerate(self.parts):
            run, sure = fewest(part, *ends, tolerance, share_of(progress, i, len(self.parts)))
            kind = self.fit.primitive
            if not kind.monotone:
                run = fewer(part, run, tolerance, kind.few)
            elif run.limited:
                run = either_way(part, run, ends[1])
                sure = not run.limited
            runs.append(run)
            certain &= sure
        found = Fitted(self.division, self.parts, runs, certain)
        return self._from_elsewhere(found, tolerance, lambda count: tolerance)

    def for_area(self, tolerance: float, progress: Progress | None = None) -> Fitted:
        """The least n for which the n pieces of `for_number` have areas of the tolerance in all.

        No more than suffice if each has at most the tolerance/n (thesis 3.7), which is exact on one stretch.
        Several do not share the area equally: there pieces are left out one by one while the rest will do.
        """
        found = self._alike(tolerance, progress)
        if self.circuit is not None:
            return self._from_elsewhere(found, tolerance, lambda count: tolerance / count)
        alike = len(self.parts) == 1 and self.fit.primitive.monotone and not self.division.unsplit
        if alike or found.count > CHECKED_PIECES:
            return found
        runs = fewer_in_all(self.parts, found.runs, tolerance)
        return found if runs is None else replace(found, runs=runs)

    def _alike(self, tolerance: float, progress: Progress | None) -> Fitted:
        """The least n such that n pieces with areas up to tolerance/n suffice (thesis 3.7), and its pieces.

        The number at one n is a lower bound of all larger solutions: going on with it finds the least.
        """
        low, high = window(tolerance, self.rounding)
        count, beaten = len(self.parts), 0  # beaten: so many pieces are certainly too few
        while (found := self._at_least(high / count)) > count:
            beaten, count = count, found
        for _ in range(ROUNDS):
            runs = [part.greedy(low / count, high / count) for part in self.parts]
            fitted = Fitted(self.division, self.parts, runs, not any(run.limited for run in runs))
            if progress is not None:
                progress(min(1.0, count / fitted.count))
            if fitted.count <= count:
                return self._without_window(fitted, tolerance) if fitted.count > beaten + 1 else fitted
            count = fitted.count
        raise UndecidedError(
            f"The number of pieces for the area {tolerance:g} did not settle: choose another tolerance."
        )

    def for_number(self, count: int) -> Fitted:
        """The pieces, ``count`` in all, with the least greatest error."""
        check_least(self.parts, count)
        if self.circuit is None:
            return Fitted(self.division, self.parts, given_pieces(self.parts, count))
        start = self.circuit.best_start(count)
        division, part = self._begun_at(start.at)
        return Fitted(division, [part], given_pieces([part], count), gap=start.gap)

    def _at_least(self, high: float) -> int:
        """A quick lower bound of the number of greedy pieces with errors up to ``high``."""
        return sum(part.at_least(high) for part in self.parts)

    def _without_window(self, found: Fitted, tolerance: float) -> Fitted:
        """What was found, or one piece less if only the window of the search was in its way."""
        count = found.count - 1
        if count < sum(part.least for part in self.parts):
            return found
        low, high = (end / count for end in window(tolerance, self.rounding))
        if self._at_least(high) > count:
            return found
        trial = [part.greedy(low, high) for part in self.parts]
        spare = sum(
            may_be_less(part, run, low, high, tolerance / count)
            for part, run in zip(self.parts, trial, strict=True)
        )
        if sum(map(len, trial)) - spare > count:
            return found
        if count > CHECKED_PIECES:
            return replace(found, certain=False)
        less = given_pieces(self.parts, count)
        # equal areas are so up to rounding: the largest may be above the mean by the window and the noise
        noise = max(part.noise for part in self.parts)
        equal = max(run.error for run in less) <= tolerance / count * (high / low) + noise
        return replace(found, runs=less) if whole_error(less, 2) <= tolerance and equal else found

    def _from_elsewhere(self, found: Fitted, tolerance: float, level: Callable[[int], float]) -> Fitted:
        """What was found on a closed curve, or fewer pieces from another start, errors up to level(number).

        From any start the longest pieces are at most one too many, as they pass the knots of the fewest.
        """
        if self.circuit is None:
            return found
        while (count := found.count - 1) >= max(1, found.parts[0].least):
            start, decided = self.circuit.start_within(level(count) * (1 + NEAR), count)
            if start is None:
                found = replace(found, certain=found.certain and decided)
                if decided or self.fit.degree == 1:
                    return found
            less = None if start is None else self._fewer_from(start, level(count), count)
            less = less or self.for_number(count)
            if not whole_error(less.runs, self.fit.degree) <= tolerance:
                return replace(found, certain=False)
            found = replace(less, certain=found.certain, gap=None)
        return found

    def _fewer_from(self, start: float, level: float, count: int) -> Fitted | None:
        """So many pieces within the level from a start, None if they do not suffice."""
        division, part = self._begun_at(start)
        run, _ = fewest(part, *window(level, self.rounding), level)
        return Fitted(division, [part], [run]) if len(run) <= count else None

    def _begun_at(self, start: float) -> tuple[Division, Arcs]:
        """A closed curve that begins there."""
        assert self.circuit is not None
        part = self.circuit.arcs_from(start)
        return replace(self.division, stretches=(part.stretch,)), part


def resolution(
    curve: FormulaCurve, fit: Fit, division: Division, size: Extent, tolerance: float | None
) -> float:
    """What features of the curve have to be seen whatever lies between samples.

    In the plane a curve is split where it has them, unless that was not decided, or not to be done: errors
    have few peaks, and it only matters where the curve turns.
    """
    smallest = SMALL * size.size if tolerance is None else tolerance / size.size ** (fit.degree - 1)
    outlined = curve.dimension == 2 and not (division.undecided or division.unsplit)
    return smallest * (OUTLINED if outlined else RESOLVED)


def part_of(coordinates: Coordinates, fit: Fit, division: Division, stretch: Stretch) -> Part:
    """A stretch with the way to fit pieces to it."""
    if stretch.kind == "bridge":
        return Bridge(coordinates, fit, stretch)
    if stretch.kind == "segment":
        return Segments(coordinates, fit, stretch)
    if stretch.kind == "exact" and (itself := fit.primitive.itself) is not None:
        if itself.shape != "helix":
            return EXACT[itself.shape](coordinates, fit, stretch, division.proved)
        if division.proved:  # no error of a helix is measured
            return Helices(coordinates, fit, stretch)
    across = division.unsplit and fit.primitive.monotone  # elsewhere errors need not grow anyway
    return (UnsplitArcs if across else Arcs)(coordinates, fit, stretch)
