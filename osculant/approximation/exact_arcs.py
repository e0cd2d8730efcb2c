"""A stretch of a conic, for conics, or of a circle, for biarcs: the pieces are parts of it.

They are made from the conic's equation and from points of the curve, in balls: however unevenly the formula
runs along the conic, and however sharp its bends are, doubles enter only where the results are rounded.
"""

from __future__ import annotations

import math
from contextlib import suppress
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.runs import Floats, Progress, Run
from osculant.approximation.segments import Segments
from osculant.approximation.split_points import as_float
from osculant.approximation.stretches import INSIDE
from osculant.cas.errors import DomainError, UndecidedError

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.stretches import Stretch
    from osculant.cas.geometry.conic_curves import ConicCurve
    from osculant.primitives.primitive import Fit

#: an arc of a conic turns at most by this: it is bounded up to 2π, and well-conditioned up to here
WIDEST = 1.5 * math.pi
#: boxes into which a stretch is cut, at most, so that none goes half round the conic, and their bits
MOST_BOXES, BITS = 10_000, 160
#: a box whose points are enclosed to this part of the curve's size goes not round the conic
SMALL = 0.25
#: bisections that find a knot, or a point inside an arc
HALVINGS = 60
#: places inside an arc where its conic is read off, in turn: at no special ones
RATIOS = (0.8713, 0.2957, 3.719)


class ExactArcs(Segments):
    """A stretch of an arc of the primitive: a `osculant.approximation.runs.Part`.

    Pieces are equal arcs, in the eccentric angle, and turn by less than `Itself.turning` each.  Errors are 0
    where it is proved that the curve is what it seems to be, else what rounding may make of them.
    """

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch, proved: bool) -> None:
        super().__init__(coordinates, fit, stretch)
        self.proved = proved
        assert fit.primitive.itself is not None
        self.turning = fit.primitive.itself.turning

    @cached_property
    def usual(self) -> int:
        """How many pieces there are unless a number is given: they turn by less than `Itself.turning`."""
        return self._parts(self.turning)

    @cached_property
    def least(self) -> int:
        """How many pieces can be asked for: a conic's weight is −1/√2 where it turns by `WIDEST`."""
        return self._parts(max(WIDEST, self.turning))

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """As few pieces as the turning allows."""
        return self.fitted(self.spread(self.usual))

    def fitted(self, knots: Floats) -> Run:
        """The arcs of the curve between the knots."""
        error = 0.0 if self.proved else self.noise
        return Run(knots, np.full(len(knots) - 1, error), np.empty((len(knots) - 1, 0)))

    def spread(self, count: int) -> Floats:
        """Knots of equal arcs."""
        from osculant.cas.numbers.balls import precision

        edges, reached = self._boxes[0], [float(tau.mid()) for tau in self._boxes[1]]
        knots = [self.ends[0]]
        with precision(BITS):
            for i in range(1, count):
                goal = reached[-1] * i / count
                box = min(int(np.searchsorted(reached, goal)), len(edges) - 1)
                knots.append(self._within(edges[box - 1], edges[box], goal - reached[box - 1]))
        return np.array([*knots, self.ends[1]])

    def pieces(self, run: Run) -> list[Any]:
        """The pieces themselves, each rounded once."""
        from osculant.cas.numbers.balls import PRECISION, precision

        with precision(PRECISION):
            points = [self._point(t) for t in self._balls(run.knots)]
            parts = zip(pairwise(run.knots.tolist()), pairwise(points), run.errors.tolist(), strict=True)
            return [self._piece(interval, *ends, error) for interval, ends, error in parts]

    def _piece(self, interval: tuple[float, float], start: Any, end: Any, error: float) -> Any:
        """The piece between two points, balls."""
        raise NotImplementedError

    @cached_property
    def conic(self) -> ConicCurve:
        """The conic that the curve is an arc of, from a jet in the middle of the arc."""
        from osculant.cas.geometry.conic_curves import ConicCurve
        from osculant.cas.numbers.balls import PRECISION, precision

        parabola = self.curve.vanishes("parabolic")
        with precision(PRECISION):
            for ratio in RATIOS:
                with suppress(DomainError, UndecidedError):  # a point where the formula is singular
                    return ConicCurve.through(self.curve.balls.jet(self._inside(ratio), 4), parabola)
        raise UndecidedError(
            f"The conic that {self.curve.text} runs along could not be told: give another interval."
        )

    def _inside(self, ratio: float) -> Any:
        """A parameter where the distances to both ends, squared, have about this ratio."""
        low, high = self.stretch.low, self.stretch.high
        start, end = self._point(low), self._point(high)
        if not _distance(start, end) > 0:  # it goes once round
            return (low + (high - low) * INSIDE).mid()
        for _ in range(HALVINGS):
            middle = ((low + high) / 2).mid()
            point = self._point(middle)
            ahead = _distance(point, start) - ratio * _distance(point, end)
            if ahead.contains(0):
                break
            low, high = (middle, high) if ahead < 0 else (low, middle)
        return middle

    def _parts(self, turning: float) -> int:
        """How many equal arcs turn by less than that, a multiple of π/2, by which one turns too far."""
        from flint import arb

        from osculant.cas.numbers.balls import precision

        if not self.conic.ellipse:
            return 1
        with precision(BITS):
            allowed = arb.pi() * round(2 * turning / math.pi) / 2
            parts = self._boxes[1][-1] * self.conic.S.sqrt() / allowed
            return int(parts.upper().floor().unique_fmpz()) + 1  # where it may be a whole number, it is

    @cached_property
    def _boxes(self) -> tuple[list[Any], list[Any]]:
        """Parameters so near that no arc between neighbours goes round, and how far τ has run at each."""
        from flint import arb

        from osculant.cas.numbers.balls import ball, precision

        with precision(BITS):
            pending = [(self.stretch.low, self.stretch.high)]
            edges, reached = [self.stretch.low], [arb(0)]
            reach = SMALL * self.coordinates.size.size
            for _ in range(MOST_BOXES):
                if not pending:
                    return edges, reached
                low, high = pending.pop()
                box = self._point(ball(low, high)) if self.conic.ellipse else ()
                if all(part.rad() < reach for part in box):
                    edges.append(high)
                    reached.append(reached[-1] + self._advance(low, high))
                else:
                    middle = ((low + high) / 2).mid()
                    pending += [(middle, high), (low, middle)]
        raise UndecidedError(
            f"How often {self.curve.text} goes round its conic could not be told: give a shorter interval."
        )

    def _within(self, low: Any, high: Any, goal: float) -> float:
        """The parameter in a box where τ has run so far from its beginning."""
        first = low
        for _ in range(HALVINGS):
            middle = ((low + high) / 2).mid()
            low, high = (middle, high) if self._advance(first, middle) < goal else (low, middle)
        return float(high.mid())

    def _advance(self, low: Any, high: Any) -> Any:
        return self.conic.advance(self._point(low), self._point(high))

    def _point(self, t: Any) -> tuple[Any, Any]:
        x, y = self.curve.balls.coefficients(t, 0)
        return x[0], y[0]

    def _balls(self, knots: Floats) -> list[Any]:
        """The knots, the ends as exactly as they are known."""
        from flint import arb

        return [self.stretch.low, *(arb(float(t)) for t in knots[1:-1]), self.stretch.high]


class ConicArcs(ExactArcs):
    """A stretch of a conic."""

    def _piece(self, interval: tuple[float, float], start: Any, end: Any, error: float) -> Any:
        """An arc of the conic."""
        from osculant.pieces.conics import Piece, classify

        arc = self.conic.between(start, end)
        weight = float(arc.weight.mid())
        kind = "parabola" if self.conic.parabola else classify(weight)
        return Piece(kind, interval, _rounded(start), _rounded(end), _rounded(arc.middle), weight, error)


class CircleArcs(ExactArcs):
    """A stretch of a circle."""

    def _piece(self, interval: tuple[float, float], start: Any, end: Any, error: float) -> Any:
        """A biarc with both arcs on the circle, of equal lengths."""
        from osculant.pieces.biarcs import Biarc

        arc = self.conic.between(start, end)
        tangents = _unit(self.conic.along(start)), _unit((end[0] - start[0], end[1] - start[1]))
        tx, ty = self.conic.along(start)
        bend = self.conic.sense * self.conic.conic.a / (tx * tx + ty * ty).sqrt()
        curvature = float(bend.mid())
        first, last = map(_rounded, tangents)
        points = _rounded(start), _rounded(arc.shoulder), _rounded(end)
        return Biarc("arc", interval, *points, (first, last), (curvature, curvature), error)


def _distance(point: Any, other: Any) -> Any:
    """The square of a distance."""
    dx, dy = point[0] - other[0], point[1] - other[1]
    return dx * dx + dy * dy


def _unit(vector: Any) -> Any:
    length = (vector[0] * vector[0] + vector[1] * vector[1]).sqrt()
    return vector[0] / length, vector[1] / length


def _rounded(point: Any) -> tuple[float, float]:
    return as_float(point[0]), as_float(point[1])
