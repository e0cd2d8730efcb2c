"""The arcs of one stretch of a space curve, fitted with bihelices by the kernels."""

from __future__ import annotations

import math
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from osculant.approximation.runs import Floats, Progress, Run, equal_parts, equal_shares, not_found, too_many
from osculant.approximation.space_stretches import LAWS
from osculant.cas.laws.table import law_of
from osculant.kernels import bihelix_spline
from osculant.kernels.bihelices.helix import HELIX_SIZE
from osculant.kernels.bihelix_given import contents, fit_arcs
from osculant.pieces.helices import HelixArc, SpacePiece, Vector

if TYPE_CHECKING:
    from osculant.approximation.space_stretches import SpaceFrame, SpaceStretch
    from osculant.curves.space import SpaceCurve
    from osculant.kernels.curves.space import Frame, Place

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

    def __init__(
        self, curve: SpaceCurve, rule: int, place: Place, stretch: SpaceStretch, noise: float
    ) -> None:
        self.curve, self.rule, self.place, self.stretch, self.noise = curve, rule, place, stretch, noise
        self.order = law_of(LAWS[stretch.shape]).order
        self.ends = stretch.a, stretch.b

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

    def pieces(self, run: Run) -> list[SpacePiece]:
        """The pieces themselves."""
        return [_piece(row) for row in run.rows]


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


def _row(frame: SpaceFrame) -> Frame:
    return (*frame.point, *frame.tangent)


def _piece(row: Floats) -> SpacePiece:
    """A row of the kernel's table."""
    left, right = bihelix_spline.LEFT, bihelix_spline.RIGHT
    arcs = tuple(helix_arc(row[place : place + HELIX_SIZE]) for place in (left, right))
    a, b, error, _, middle = row[:5].tolist()
    return SpacePiece((a, b), arcs, error, middle)


def helix_arc(helix: Floats) -> HelixArc:
    """A `kernels.bihelices.helix.Helix` as a `HelixArc`: V of the thesis is minus the axis."""
    start, tangent, inward = helix[0:3], helix[3:6], helix[9:12]
    rate, length, _, curvature, torsion = helix[12:17].tolist()
    axis = tangent
    if rate:  # V = T₀×(V×T₀) + ⟨V,T₀⟩T₀
        axis = np.cross(tangent, inward) + torsion / rate * tangent
        axis = axis / np.linalg.norm(axis)
    return HelixArc(_vector(start), _vector(tangent), _vector(axis), curvature, torsion, length)


def _vector(values: Floats) -> Vector:
    x, y, z = values.tolist()
    return x, y, z
