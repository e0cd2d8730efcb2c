"""The arcs of one stretch of a space curve, fitted with bihelices by the kernels."""

from __future__ import annotations

import math
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.runs import Floats, Progress, Run, equal_parts, equal_shares, not_found, too_many
from osculant.kernels import bihelix_spline
from osculant.kernels.bihelix_given import contents, fit_arcs

if TYPE_CHECKING:
    from osculant.approximation.coordinates import Coordinates
    from osculant.approximation.division import Frame, Stretch
    from osculant.kernels.curves.space import Frame as Local
    from osculant.primitives.primitive import Fit

#: pieces per call of the kernel
CHUNK = 2048
#: more pieces than this are not made
MOST_PIECES = 2_000_000
#: panels per piece, and of all, that tell the content of a stretch
CONTENT_POINTS, LEAST_POINTS = 8, 1024
#: an error, for a curve of size 1, that no piece has
BOUNDLESS = 1e100


class SpaceArcs:
    """A stretch of a space curve that is no helix itself: a `osculant.approximation.runs.Part`.

    The error of a bihelix need not grow with its arc, unless it is small: then the pieces found are good
    ones, and no proof says that they are the best.
    """

    exact = False

    def __init__(self, coordinates: Coordinates, fit: Fit, stretch: Stretch) -> None:
        self.curve, self.fit, self.stretch = coordinates.curve, fit, stretch
        self.rule, self.place = fit.code, coordinates.place()
        self.noise = coordinates.error_noise(fit.degree)
        self.order, self.ends = fit.law(stretch.kind).order, (stretch.a, stretch.b)

    @cached_property
    def least(self) -> int:
        """How many pieces it takes however large their errors may be, the longest that are bihelices."""
        return len(self.greedy(math.inf, math.inf))

    def greedy(self, low: float, high: float, progress: Progress | None = None) -> Run:
        """The longest pieces within ``high``; raises UndecidedError where doubles cannot follow the curve."""
        (a, b), address = self.ends, self.curve.compiled.address
        most = BOUNDLESS / self.place[3]
        low, high = min(low, 0.5 * most), min(high, most)
        tables, count = [], 0
        table = np.empty((CHUNK, bihelix_spline.COLUMNS))
        reached, start, length = a, _row(self.stretch.start), 0.0
        while reached < b:
            found, reached, _ = bihelix_spline.spline(
                self.rule, address, self.place, reached, start, b, _row(self.stretch.end),
                low, high, length, table,
            )  # fmt: skip
            tables.append(table[:found].copy())
            count += found
            if progress is not None:
                progress((reached - a) / (b - a))
            if found < CHUNK and reached < b:
                raise not_found("bihelix", high, reached)
            if count > MOST_PIECES:
                raise too_many(MOST_PIECES)
            start = tuple(table[found - 1, 41:47].tolist())
            length = float(table[found - 1, 1] - table[found - 1, 0])
        return _run(np.concatenate(tables))

    def at_least(self, high: float) -> int:
        """As many as it takes however large errors may be."""
        return self.least

    def fitted(self, knots: Floats) -> Run:
        """The best bihelix by the rule on each arc; its error is infinite where there is none."""
        table = np.empty((len(knots) - 1, bihelix_spline.COLUMNS))
        first, last = _row(self.stretch.start), _row(self.stretch.end)
        fit_arcs(self.rule, self.curve.compiled.address, self.place, knots, first, last, table)
        return _run(table)

    def spread(self, count: int) -> Floats:
        """Knots of equal content, from the density that theory integrates to the number of pieces."""
        times = equal_parts(self.ends, max(LEAST_POINTS, CONTENT_POINTS * count))
        total = np.empty_like(times)
        contents(self.order, self.curve.compiled.address, self.place, times, total)
        if not total[-1] > 0:
            return equal_parts(self.ends, count)
        knots = equal_shares(times, total, count)
        return knots if (np.diff(knots) > 0).all() else equal_parts(self.ends, count)

    def pieces(self, run: Run) -> list[Any]:
        """The pieces themselves, in the user's coordinates."""
        make = self.fit.primitive.piece
        return [make(row, self.place, float(error)) for row, error in zip(run.rows, run.errors, strict=True)]


def _run(table: Floats) -> Run:
    reasons = table[:, bihelix_spline.REASON]
    limits = bihelix_spline.ENDS_AT_LIMIT, bihelix_spline.ENDS_AT_TURN
    return Run(
        np.append(table[:, 0], table[-1, 1]),
        table[:, 2].copy(),
        table,
        bool(np.isin(reasons, limits).any()),
        bool((reasons == bihelix_spline.ENDS_EARLY).any()),
    )


def _row(frame: Frame) -> Local:
    (x, y, z), (tx, ty, tz) = frame.point, frame.tangent
    return x, y, z, tx, ty, tz
