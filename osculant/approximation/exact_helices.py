"""A stretch on which a space curve is a segment, a circle or a helix: the pieces are parts of it."""

from __future__ import annotations

import math
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.division import INSIDE
from osculant.approximation.runs import Floats, Progress, Run, equal_shares
from osculant.approximation.space_stretches import SpaceFrame
from osculant.kernels.curves.space import JET_SIZE, sample_many
from osculant.pieces.helices import HelixArc, SpacePiece, Vector

if TYPE_CHECKING:
    from osculant.approximation.space_stretches import SpaceStretch
    from osculant.curves.space import SpaceCurve

#: panels, of the stretch and per piece, and nodes of the quadrature of arc length
PANELS, PANELS_PER_PIECE, NODES = 256, 4, 8
#: one arc turns by at most this part of 2π
WHOLE_TURN = 1 - 1e-9


class SpaceSegments:
    """A straight stretch: a `runs.Part` whose pieces have equal lengths."""

    exact, order, noise = True, 1, 0.0

    def __init__(self, curve: SpaceCurve, stretch: SpaceStretch) -> None:
        self.curve, self.stretch, self.ends = curve, stretch, (stretch.a, stretch.b)

    @property
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
        """Knots that cut the stretch into pieces of nearly equal length, whatever the parameter."""
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        edges = np.linspace(*self.ends, max(PANELS, PANELS_PER_PIECE * count) + 1)
        half = np.diff(edges) / 2
        times = (edges[:-1] + half)[:, None] + half[:, None] * nodes
        jets = np.empty((times.size, JET_SIZE))
        sample_many(self.curve.compiled.address, times.ravel(), jets)
        speed = np.sqrt(np.square(jets[:, 1::4]).sum(axis=1)).reshape(times.shape)
        lengths = np.concatenate([[0.0], np.cumsum(half * (speed @ weights))])
        return equal_shares(edges, lengths, count)

    def pieces(self, run: Run) -> list[SpacePiece]:
        """The segments themselves."""
        points = [frame.point for frame in self._frames(run.knots)] + [self.stretch.end.point]
        found = []
        for a, b, start, end in zip(run.knots, run.knots[1:], points, points[1:]):
            length = math.dist(start, end)
            x, y, z = ((last - first) / length for first, last in zip(start, end))
            arc = HelixArc(start, (x, y, z), (x, y, z), 0.0, 0.0, length)
            found.append(SpacePiece((float(a), float(b)), (arc,), 0.0))
        return found

    def _frames(self, knots: Floats) -> list[SpaceFrame]:
        """The frames at all knots but the last."""
        from osculant.cas.numbers.balls import PRECISION, precision

        frames = [self.stretch.start]
        with precision(PRECISION):
            for at in self._balls(knots)[1:-1]:
                jet = self.curve.balls.jet(at, 1)
                frames.append(SpaceFrame(_floats(jet.point(0)), _floats(jet.tangent)))
        return frames

    def _balls(self, knots: Floats) -> list[Any]:
        """The knots, the ends as exactly as they are known."""
        from flint import arb

        return [self.stretch.low, *(arb(float(t)) for t in knots[1:-1]), self.stretch.high]


class Helices(SpaceSegments):
    """A stretch of a helix or a circle: a `runs.Part` whose pieces turn by less than 2π each."""

    @cached_property
    def least(self) -> int:
        """How many pieces of equal lengths turn by less than 2π each.

        >>> from osculant.curves.space import SpaceCurve
        >>> from osculant.approximation.space_stretches import divide
        >>> helix = SpaceCurve("3*cos(t), 3*sin(t), 4*t", 0, "4*pi")
        >>> Helices(helix, divide(helix).stretches[0]).least
        3
        """
        curvature, torsion, _ = self._constants
        rate = math.hypot(curvature, torsion)
        count = math.floor(rate * sum(self._lengths(np.array(self.ends))) / math.tau) + 1
        while rate * max(self._lengths(self.spread(count))) >= WHOLE_TURN * math.tau:
            count += 1
        return count

    def pieces(self, run: Run) -> list[SpacePiece]:
        """The arcs themselves."""
        curvature, torsion, axis = self._constants
        found = []
        parts = zip(pairwise(run.knots), self._frames(run.knots), self._lengths(run.knots), strict=True)
        for (a, b), frame, length in parts:
            arc = HelixArc(frame.point, frame.tangent, axis, curvature, torsion, length)
            found.append(SpacePiece((float(a), float(b)), (arc,), 0.0))
        return found

    @cached_property
    def _constants(self) -> tuple[float, float, Vector]:
        """Curvature, torsion and axis, which are the same everywhere."""
        from osculant.cas.numbers.balls import PRECISION, precision

        with precision(PRECISION):
            inside = (self.stretch.low + (self.stretch.high - self.stretch.low) * INSIDE).mid()
            jet = self.curve.balls.jet(inside, 3)
            axis = _floats(tuple(-part for part in jet.axis))
            return float(jet.curvature.mid()), float(jet.torsion.mid()), axis

    def _lengths(self, knots: Floats) -> list[float]:
        """The arc lengths between the knots."""
        from osculant.cas.numbers.balls import PRECISION, precision
        from osculant.cas.numbers.quadrature import integral

        def speed(t: Any) -> Any:
            return self.curve.balls.jet(t, 1).speed.mid()

        with precision(PRECISION):
            return [float(integral(speed, low, high)[0]) for low, high in pairwise(self._balls(knots))]


def _floats(vector: Any) -> Vector:
    x, y, z = (0.0 if part.contains(0) else float(part.mid()) for part in vector)
    return x, y, z
