"""A stretch on which a space curve is a circle or a helix: the pieces are parts of it."""

from __future__ import annotations

import math
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from osculant.approximation.runs import Floats, Run, equal_shares, integrated, speed
from osculant.approximation.segments import Segments
from osculant.approximation.split_points import as_float
from osculant.approximation.stretches import INSIDE, Frame
from osculant.pieces.helices import HelixArc, SpacePiece, Vector

#: panels, of the stretch and per piece, of the quadrature of arc length
PANELS, PANELS_PER_PIECE = 256, 4
#: one arc turns by at most this part of 2π
WHOLE_TURN = 1 - 1e-9


class Helices(Segments):
    """A stretch of a helix or a circle: a `runs.Part` whose pieces turn by less than 2π each.

    That it is one has to be proved: no error is measured.

    >>> from osculant.approximation.coordinates import Coordinates
    >>> from osculant.approximation.division import divide
    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.space import SpaceCurve
    >>> from osculant.primitives.table import choose
    >>> helix = SpaceCurve("3*cos(t), 3*sin(t), 4*t", 0, "4*pi")
    >>> fit, (stretch,) = choose("bihelix", "hausdorff", dimension=3), divide(helix, "bihelix").stretches
    >>> Helices(Coordinates(helix, extent(helix)), fit, stretch).least
    3
    """

    @cached_property
    def least(self) -> int:
        """How many pieces of equal lengths turn by less than 2π each."""
        curvature, torsion, _ = self._constants
        rate = math.hypot(curvature, torsion)
        count = math.floor(rate * sum(self._lengths(np.array(self.ends))) / math.tau) + 1
        while rate * max(self._lengths(self.spread(count))) >= WHOLE_TURN * math.tau:
            count += 1
        return count

    def spread(self, count: int) -> Floats:
        """Knots that cut the stretch into pieces of nearly equal length, whatever the parameter."""
        panels = max(PANELS, PANELS_PER_PIECE * count)
        return equal_shares(*integrated(self.curve, self.ends, panels, speed), count)

    def pieces(self, run: Run) -> list[SpacePiece]:
        """The arcs themselves."""
        curvature, torsion, axis = self._constants
        found = []
        parts = zip(pairwise(run.knots), self._frames(run.knots), self._lengths(run.knots), strict=True)
        for (a, b), frame, length in parts:
            arc = HelixArc(_vector(frame.point), _vector(frame.tangent), axis, curvature, torsion, length)
            found.append(SpacePiece((float(a), float(b)), (arc,), 0.0))
        return found

    @cached_property
    def _constants(self) -> tuple[float, float, Vector]:
        """Curvature, torsion and axis, which are the same everywhere."""
        from osculant.cas.numbers.balls import PRECISION, precision

        with precision(PRECISION):
            inside = (self.stretch.low + (self.stretch.high - self.stretch.low) * INSIDE).mid()
            jet = self.curve.balls.jet(inside, 3)
            axis = _vector(tuple(as_float(-part) for part in jet.axis))
            return float(jet.curvature.mid()), float(jet.torsion.mid()), axis

    def _lengths(self, knots: Floats) -> list[float]:
        """The arc lengths between the knots."""
        from osculant.cas.numbers.balls import PRECISION, precision
        from osculant.cas.numbers.quadrature import integral

        def density(t: Any) -> Any:
            return self.curve.balls.jet(t, 1).speed.mid()

        with precision(PRECISION):
            return [float(integral(density, low, high)[0]) for low, high in pairwise(self._balls(knots))]

    def _frames(self, knots: Floats) -> list[Frame]:
        """The frames at all knots but the last."""
        from osculant.cas.numbers.balls import PRECISION, precision

        frames = [self.stretch.start]
        with precision(PRECISION):
            for at in self._balls(knots)[1:-1]:
                jet = self.curve.balls.jet(at, 1)
                frames.append(Frame(tuple(map(as_float, jet.point(0))), tuple(map(as_float, jet.tangent))))
        return frames

    def _balls(self, knots: Floats) -> list[Any]:
        """The knots, the ends as exactly as they are known."""
        from flint import arb

        return [self.stretch.low, *(arb(float(t)) for t in knots[1:-1]), self.stretch.high]


def _vector(values: tuple[float, ...]) -> Vector:
    x, y, z = values
    return x, y, z
