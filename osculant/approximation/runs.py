"""Consecutive pieces on one stretch of a curve, and what the searches for knots ask of a stretch."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from osculant.cas.errors import UndecidedError

if TYPE_CHECKING:
    from osculant.approximation.stretches import Stretch
    from osculant.curves.curve import FormulaCurve

#: nodes of the quadrature along a curve
NODES = 8

Floats = np.ndarray[Any, Any]
Progress = Callable[[float], None]


@dataclass(frozen=True)
class Run:
    """Pieces from one end of a stretch to the other, as numbers.

    Attributes:
        knots: parameters, shape (n + 1,).
        errors: of the n pieces, in the user's units; infinite where an arc has no proper piece.
        rows: the kernels' table, shape (n, columns).
        limited: whether a piece ends, short of the tolerance, where no longer arc had a proper one.
        early: whether a piece was cut short so that the last one has some length.

    >>> run = Run(np.array([0.0, 1.0, 2.0]), np.array([0.1, 0.2]), np.empty((2, 0)))
    >>> len(run), run.error
    (2, 0.2)
    """

    knots: Floats
    errors: Floats
    rows: Floats
    limited: bool = False
    early: bool = False

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.errors)

    @property
    def error(self) -> float:
        """The largest error of a piece."""
        return float(self.errors.max())


class Part(Protocol):
    """A stretch of a curve with a way to fit pieces to its arcs.

    If ``exact``, its pieces are parts of the curve itself, and no error is worth a search.
    """

    exact: bool
    stretch: Stretch

    @property
    def order(self) -> int:
        """The error of one short arc is of this order in its length."""

    @property
    def noise(self) -> float:
        """What rounding does to the error of a piece, in the user's units."""

    @property
    def least(self) -> int:
        """How many pieces it takes however large their errors may be."""

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """The longest pieces with errors at most ``high``; those that end there have at least ``low``."""

    def at_least(self, high: float) -> int:
        """A quick lower bound of the number of greedy pieces with errors at most ``high``."""

    def fitted(self, knots: Floats) -> Run:
        """The best piece for each arc between neighbouring knots."""

    def spread(self, count: int) -> Floats:
        """First guess of the knots of so many pieces with equal errors: equal content."""

    def pieces(self, run: Run) -> list[Any]:
        """The pieces themselves, in the user's coordinates."""


def whole_error(runs: Sequence[Run], dimension: int) -> float:
    """The error of runs one after the other: areas (dimension 2) add, of distances the largest counts.

    >>> halves = [Run(np.array([0.0, 1.0]), np.array([error]), np.empty((1, 0))) for error in (0.25, 0.5)]
    >>> whole_error(halves, 1), whole_error(halves, 2)
    (0.5, 0.75)
    """
    if dimension == 2:
        return math.fsum(error for run in runs for error in run.errors)
    return max(run.error for run in runs)


def equal_parts(ends: tuple[float, float], count: int) -> Floats:
    """Knots that divide an interval equally; the ends are kept to the last bit.

    >>> equal_parts((0.0, 1.0), 4).tolist()
    [0.0, 0.25, 0.5, 0.75, 1.0]
    """
    knots = np.linspace(*ends, count + 1)
    knots[0], knots[-1] = ends
    return knots


def equal_shares(times: Floats, total: Floats, count: int) -> Floats:
    """Knots that divide equally what has come together at increasing times; the ends are kept.

    >>> equal_shares(np.array([0.0, 1.0, 2.0]), np.array([0.0, 3.0, 4.0]), 2).round(6).tolist()
    [0.0, 0.666667, 2.0]
    """
    knots = np.interp(np.linspace(0.0, total[-1], count + 1), total, times)
    knots[0], knots[-1] = times[0], times[-1]
    return knots


def integrated(
    curve: FormulaCurve, ends: tuple[float, float], panels: int, density: Callable[[Floats], Floats]
) -> tuple[Floats, Floats]:
    """(edges of equal panels, the integral from the first of them to each) of a density along a curve.

    Args:
        curve: that is sampled.
        ends: of the parameter's interval.
        panels: in each, Gauss's rule with `NODES` nodes.
        density: of jets as `FormulaCurve.jets` returns them.
    """
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    edges = np.linspace(*ends, panels + 1)
    half = np.diff(edges) / 2
    times = (edges[:-1] + half)[:, None] + half[:, None] * nodes
    values = density(curve.jets(times)).reshape(times.shape)
    return edges, np.concatenate([[0.0], np.cumsum(half * (values @ weights))])


def speed(jets: Floats) -> Floats:
    """|α̇| of jets (m, dimension, order + 1), the density of arc length."""
    return np.asarray(np.sqrt(np.square(jets[..., 1]).sum(axis=1)))


def share(error: float, level: float, order: int) -> float:
    """What part of a full piece one with this error is, at most 1.

    >>> share(1.0, 32.0, 5)
    0.5
    """
    return min(1.0, math.pow(max(error, 0.0) / level, 1.0 / order))


def share_of(progress: Progress | None, i: int, count: int) -> Progress | None:
    """The progress of one stretch of so many, the i-th from 0, as that of the whole."""
    return None if progress is None else lambda done: progress((i + done) / count)


class StuckError(UndecidedError):
    """Greedy pieces end where doubles cannot follow the curve: at the parameter ``at``."""

    def __init__(self, message: str, at: float) -> None:
        super().__init__(message)
        self.at = at


def not_found(high: float, at: float) -> StuckError:
    """The error of greedy pieces that end where doubles cannot follow the curve."""
    return StuckError(
        f"No piece with an error of {high:g} or less was found for the curve after t = {at:.15g}, "
        "where double numbers cannot follow it: choose a split point there, or another interval.",
        at,
    )


def too_many(most: int) -> UndecidedError:
    """The error of a search that is given up at so many pieces."""
    return UndecidedError(
        f"More than {most} pieces are needed: choose a larger tolerance or a shorter interval."
    )
