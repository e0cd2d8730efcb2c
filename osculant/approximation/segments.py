"""A stretch on which the curve is straight: the pieces are segments of it, of equal lengths."""

from __future__ import annotations

import math
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.runs import Floats, Progress, Run, equal_parts, equal_shares

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.stretches import Stretch
    from osculant.primitives.primitive import Fit

#: samples per piece that tell lengths, whatever the parameter
PANELS = 64


class Segments:
    """A straight stretch, in the plane or in space: a `osculant.approximation.runs.Part`.

    >>> from osculant.approximation.coordinates import Coordinates
    >>> from osculant.approximation.division import divide
    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.space import SpaceCurve
    >>> from osculant.primitives.table import choose
    >>> line = SpaceCurve("t, t, t", 0, 6)
    >>> fit, (stretch,) = choose("bihelix", "hausdorff", dimension=3), divide(line, "bihelix").stretches
    >>> Segments(Coordinates(line, extent(line)), fit, stretch).spread(3).round(12).tolist()
    [0.0, 2.0, 4.0, 6.0]
    """

    exact, order = True, 1

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        self.coordinates, self.curve, self.fit, self.stretch = coordinates, coordinates.curve, fit, stretch
        self.ends, self.noise = (stretch.a, stretch.b), coordinates.error_noise(fit.degree)

    @cached_property
    def least(self) -> int:
        """One segment is enough."""
        return 1

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """As few pieces as there can be."""
        return self.fitted(self.spread(self.least))

    def at_least(self, high: float) -> int:
        """As many as it takes however large errors may be."""
        return self.least

    def fitted(self, knots: Floats) -> Run:
        """Parts of the curve between the knots."""
        return Run(knots, np.zeros(len(knots) - 1), np.empty((len(knots) - 1, 0)))

    def spread(self, count: int) -> Floats:
        """Knots that divide the stretch equally."""
        if count == 1:
            return np.array(self.ends)
        times = equal_parts(self.ends, PANELS * count)
        start = self.stretch.start.point
        reached = [math.dist(start, point) for point in self.curve.jets(times)[..., 0]]
        return equal_shares(times, np.maximum.accumulate(reached), count)

    def pieces(self, run: Run) -> list[Any]:
        """The segments themselves."""
        inner = map(tuple, self.curve.jets(run.knots[1:-1])[..., 0].tolist())
        points = [self.stretch.start.point, *inner, self.stretch.end.point]
        make, knots = self.fit.primitive.segment, run.knots.tolist()
        return [make(*ends) for ends in zip(pairwise(knots), points, points[1:])]
