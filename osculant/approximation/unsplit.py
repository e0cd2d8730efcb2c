"""Arcs across sextactic points, zeros of k and vertices, where errors need not grow with the arc.

Away from such a point the greedy rule is right; the arc across it may be longer if it begins earlier, and an
arc that is too long may be within the tolerance again farther on. So the arc across is sought among all that
begin within the piece before it, on a grid that is then refined: what is found is kept only with its measured
error, but nothing proves that there is nothing better.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from osculant.approximation.arcs import Arcs
from osculant.approximation.runs import Floats, Progress, Run
from osculant.approximation.split_points import as_float
from osculant.cas.errors import UndecidedError

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.stretches import Stretch
    from osculant.primitives.primitive import Fit

#: beginnings tried for an arc across, and ends for each; bisections of the last end
STARTS, ENDS, HALVINGS = 9, 24, 40
#: with more points inside, the greedy pieces are left as they are
MOST_POINTS = 100
#: ends are tried up to so many lengths of the greedy arc beyond it
FARTHEST = 2.0


class UnsplitArcs(Arcs):
    """A stretch with points inside where theory would split it: a `osculant.approximation.runs.Part`."""

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        super().__init__(coordinates, fit, stretch)
        self.points = [at for at in map(as_float, stretch.passed) if stretch.a < at < stretch.b]

    @cached_property
    def least(self) -> int:
        """How many pieces the greedy rule takes however large their errors may be."""
        return Arcs(self.coordinates, self.fit, self.stretch).least

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """Long pieces within ``high``, across the points too; the fewest that were found."""
        best = super().greedy(low, high, progress)
        if not 0 < len(self.points) <= MOST_POINTS:
            return best
        i = int(np.searchsorted(best.knots, self.points[0])) - 1  # the piece across
        earliest = best.knots[max(i - 1, 0)]
        starts = np.linspace(earliest, best.knots[i], STARTS + 1)[1:] if i else best.knots[:1]
        ends = [self._farthest(a, float(best.knots[i + 1]), high) for a in starts]
        j = int(np.argmax(ends))
        if not ends[j] > best.knots[i + 1]:
            j = len(starts) - 1
        across = self.fitted_between(np.append(best.knots[:i], [starts[j], ends[j]]))
        other = across
        if ends[j] != self.ends[1]:
            try:
                other = joined(across, self.after(ends[j]).greedy(low, high))
            except UndecidedError:  # what is left is too short for doubles
                return best
        return other if len(other) < len(best) and other.error <= high else best

    def at_least(self, high: float) -> int:
        """One: errors need not grow with arcs."""
        return 1

    def after(self, t: float) -> UnsplitArcs:
        """The rest of the stretch."""
        return UnsplitArcs(self.coordinates, self.fit, self.starting_at(t))

    def fitted_between(self, knots: Floats) -> Run:
        """`fitted` for knots that may end before the stretch does."""
        if knots[-1] == self.ends[1]:
            return self.fitted(knots)
        return Arcs(self.coordinates, self.fit, self.ending_at(float(knots[-1]))).fitted(knots)

    def _farthest(self, a: float, reached: float, high: float) -> float:
        """The farthest end of an arc from a within ``high`` that was found."""
        arcs = self if a == self.ends[0] else Arcs(self.coordinates, self.fit, self.starting_at(a))

        def fits(b: float) -> bool:
            stretch = arcs.stretch if b == self.ends[1] else arcs.ending_at(b)
            return Arcs(self.coordinates, self.fit, stretch).fitted(np.array([a, b])).error <= high

        limit = min(self.ends[1], reached + FARTHEST * (reached - a))
        ends = np.linspace(self.points[0], limit, ENDS)
        good = [b for b in map(float, ends) if b > a and fits(b)]
        if not good:
            return -math.inf
        best = max(good)
        if best == limit:
            return best
        bad = float(ends[np.searchsorted(ends, best) + 1])
        for _ in range(HALVINGS):
            middle = 0.5 * (best + bad)
            best, bad = (middle, bad) if fits(middle) else (best, middle)
        return best


def joined(first: Run, second: Run) -> Run:
    """Two runs, the second of which starts where the first ends, as one."""
    return replace(
        second,
        knots=np.concatenate([first.knots, second.knots[1:]]),
        errors=np.concatenate([first.errors, second.errors]),
        rows=np.concatenate([first.rows, second.rows]),
        limited=first.limited or second.limited,
        early=first.early or second.early,
    )
