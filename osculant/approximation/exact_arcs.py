"""A stretch of a conic, for conics, or of a circle, for biarcs: the pieces are parts of it."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from osculant.approximation.arcs import Arcs
from osculant.approximation.division import INSIDE
from osculant.approximation.runs import Floats, Progress, Run, equal_shares, integrated, speed
from osculant.kernels.biarcs.exact import circles_along
from osculant.kernels.conics.exact import conics_through
from osculant.kernels.operations import ERROR

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.division import Stretch
    from osculant.primitives.primitive import Fit

#: panels of the quadrature of affine length along an exact arc
PANELS = 64
#: an arc of a conic turns at most by this: it is bounded up to 2π, and well-conditioned up to here
WIDEST = 1.5 * math.pi
#: errors of arcs of the curve itself below so many times the noise, the floor of tolerances, are rounding
RESOLVED = 250.0


class ExactArcs(Arcs):
    """A stretch of an arc of the primitive: a `osculant.approximation.runs.Part`.

    Pieces have equal affine lengths and turn by less than `Itself.turning` each.  Without a symbolic proof
    that the curve is what it seems to be, errors are what is measured; where a bend is too sharp for the
    arc's doubles, pieces are fitted as to any curve.
    """

    exact = True

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch, proved: bool) -> None:
        super().__init__(coordinates, fit, stretch)
        self.proved = proved
        assert fit.primitive.itself is not None
        self.turning = fit.primitive.itself.turning

    @cached_property
    def _lengths(self) -> tuple[Floats, Floats]:
        """Parameters, and the affine lengths from the beginning to them."""
        return integrated(self.curve, self.ends, PANELS, affine_speed)

    def _constant(self, name: str) -> float:
        """Curvature or affine curvature, which is the same everywhere."""
        from osculant.cas.numbers.balls import PRECISION, precision

        with precision(PRECISION):
            inside = (self.stretch.low + (self.stretch.high - self.stretch.low) * INSIDE).mid()
            return float(getattr(self.curve.balls.jet(inside, 4), name).mid())

    @cached_property
    def _turning(self) -> float:
        """A conic turns by π over the affine length π/√k."""
        return float(self._lengths[1][-1]) * math.sqrt(max(self._constant("affine_curvature"), 0.0))

    @cached_property
    def usual(self) -> int:
        """How many pieces there are unless a number is given: they turn by less than `Itself.turning`."""
        return _parts(self._turning / self.turning)

    @cached_property
    def least(self) -> int:
        """How many pieces can be asked for: a conic's weight is −1/√2 where it turns by `WIDEST`."""
        return _parts(self._turning / max(WIDEST, self.turning))

    def spread(self, count: int) -> Floats:
        """Knots of equal affine lengths."""
        edges, lengths = self._lengths
        return equal_shares(edges, lengths, count)

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """As few pieces as the turning allows, or, if doubles cannot follow those, as to any curve."""
        run = self.fitted(self.spread(self.usual))
        if run.error <= high:
            return run
        return replace(super().greedy(low, high, progress), limited=True)

    def at_least(self, high: float) -> int:
        """As many as the turning allows."""
        return self.least

    def fitted(self, knots: Floats) -> Run:
        """The arcs of the curve between the knots; errors are 0 if doubles can follow them."""
        rows, off = self._measured(knots)
        errors = off / self.coordinates.scale
        if self.fit.degree == 2:  # an area is no more than width times length
            errors = errors * integrated(self.curve, self.ends, PANELS, speed)[1][-1]
        resolved = errors <= RESOLVED * self.noise
        return Run(knots, np.where(resolved & self.proved, 0.0, errors), rows)

    def _measured(self, knots: Floats) -> tuple[Floats, Floats]:
        """Rows of the arcs between the knots, and how far the curve is from them, in the kernels' units."""
        raise NotImplementedError


class ConicArcs(ExactArcs):
    """A stretch of a conic."""

    def _measured(self, knots: Floats) -> tuple[Floats, Floats]:
        """Rows of the conics through an inner point each, and how far the curve is from them."""
        rows = np.empty((len(knots) - 1, self.columns))
        job = self.job(0.0, 0.0)
        conics_through(job.record, job.address, job.place, knots, job.start, job.last, INSIDE, rows)
        return rows, rows[:, ERROR]


class CircleArcs(ExactArcs):
    """A stretch of a circle."""

    def _measured(self, knots: Floats) -> tuple[Floats, Floats]:
        """Rows of biarcs with both arcs on the circle, and how far the curve is from it."""
        bend = self._constant("curvature") * self.stretch.bend / self.coordinates.scale
        edges, lengths = self._lengths
        at_knots = np.interp(knots, edges, lengths)
        middles = np.interp((at_knots[:-1] + at_knots[1:]) / 2, lengths, edges)
        rows = np.empty((len(knots) - 1, self.columns))
        job = self.job(0.0, 0.0)
        circles_along(job.address, job.place, knots, middles, job.start, job.last, bend, rows)
        return rows, rows[:, ERROR]


def _parts(turns: float) -> int:
    """How many parts take less than 1 each; exactly 1 is too much."""
    return math.floor(turns + 1e-9) + 1


def affine_speed(jets: Floats) -> Floats:
    """|α̇ × α̈|^{1/3} of jets of a plane curve (m, 2, 3)."""
    (_, dx, ddx), (_, dy, ddy) = jets.transpose(1, 2, 0)
    return np.asarray(np.cbrt(np.abs(dx * ddy - ddx * dy)))
