"""A stretch that lies below the tolerance: small pieces lead from its beginning to its end."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.runs import Floats, Run
from osculant.approximation.segments import Segments

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.stretches import Stretch
    from osculant.primitives.primitive import Fit

#: the area between what lies within a distance of one point, in squares of that
SQUARE = 4.0
#: cosines of angles that doubles take for 0
ALONG = 1 - 1e-15


class Bridge(Segments):
    """A stretch that is passed over: a `osculant.approximation.runs.Part` with as many pieces as it takes.

    Its error is the extent of all that there is, curve and pieces: it is no use to look at it.
    """

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        super().__init__(coordinates, fit, stretch)
        extent = stretch.reach
        if not self._is_chord:
            extent = max(extent, self._size)
        self.error = extent if fit.degree == 1 else SQUARE * extent * self._size

    @cached_property
    def _is_chord(self) -> bool:
        """Whether both tangents go along the chord."""
        start, end = self.stretch.start, self.stretch.end
        chord = np.subtract(end.point, start.point)
        ahead = float(chord @ np.array(start.tangent))
        return start.tangent == end.tangent and ahead >= ALONG * math.hypot(*chord)

    @cached_property
    def least(self) -> int:
        """As many as lead from one frame to another."""
        return len(self._made)

    def fitted(self, knots: Floats) -> Run:
        """The same pieces whatever the knots."""
        count = len(self._made)
        ends = [piece.interval[0] for piece in self._made]
        return Run(np.array([*ends, self.ends[1]]), np.full(count, self.error), np.empty((count, 0)))

    def pieces(self, run: Run) -> list[Any]:
        """The pieces themselves."""
        return self._bridge(self.error)

    @cached_property
    def _made(self) -> list[Any]:
        return self._bridge(0.0)

    @cached_property
    def _size(self) -> float:
        """The diagonal of the box around the pieces."""
        corners = np.array([piece.bounding_box() for piece in self._made])
        return math.hypot(*(corners[:, 1].max(axis=0) - corners[:, 0].min(axis=0)))

    def _bridge(self, error: float) -> list[Any]:
        bridge, start, end = self.fit.primitive.bridge, self.stretch.start, self.stretch.end
        assert bridge is not None  # or the curve would not have been divided so
        if self._is_chord:
            return [replace(self.fit.primitive.segment(self.ends, start.point, end.point), error=error)]
        return bridge(self.ends, (start.point, start.tangent), (end.point, end.tangent), error)
