"""Longest pieces from the end of a stretch back: as few as from its beginning, where errors grow with arcs.

So a curve and the same curve run through backwards take the same number of pieces, and if either proves that
it is the least, it is.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from osculant.approximation.arcs import Arcs
from osculant.approximation.runs import Part, Run
from osculant.cas.errors import UndecidedError

if TYPE_CHECKING:
    from osculant.approximation.fitting import Fitted

#: pieces at most; bisections for the beginning of each
MOST, HALVINGS = 60, 40
#: errors that jump by more than this factor where an arc is hardly longer have no longest arc
JUMP = 1.001


def backward(part: Part, high: float, most: int = MOST) -> Run | None:
    """The longest pieces within ``high`` from the end of a stretch on; None for more than so many.

    Args:
        part: the stretch, on which errors grow with arcs.
        high: the error allowed.
        most: pieces looked for, of which `MOST` are the most.

    >>> from osculant.approximation.division import divide
    >>> from osculant.approximation.fitting import Fitting
    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.plane import PlaneCurve
    >>> from osculant.primitives.table import choose
    >>> curve, fit = PlaneCurve("t, exp(t)", 0, 1), choose("conic", "hausdorff")
    >>> part = Fitting(curve, fit, divide(curve, "conic"), extent(curve)).parts[0]
    >>> len(backward(part, 1e-7)), len(part.greedy(0.99e-7, 1e-7))
    (4, 4)
    """
    if type(part) is not Arcs:
        return None
    pieces: list[Run] = []
    end = part.ends[1]
    while end > part.ends[0]:
        if len(pieces) == min(most, MOST):
            return None
        try:
            piece = _longest(part, end, high)
        except UndecidedError:
            return None
        if not (piece.error <= high and piece.knots[0] < end):
            return None
        pieces.insert(0, piece)
        end = float(piece.knots[0])
    return Run(
        np.append([piece.knots[0] for piece in pieces], part.ends[1]),
        np.concatenate([piece.errors for piece in pieces]),
        np.concatenate([piece.rows for piece in pieces]),
        any(piece.limited for piece in pieces),
    )


def either_way(part: Part, run: Run, high: float) -> Run:
    """A run that ends pieces at a limit, or one from the end if that takes fewer, or as many without it."""
    other = backward(part, high, len(run))
    if other is None or (other.limited and len(other) == len(run)):
        return run
    return other


def from_the_end(found: Fitted, high: float) -> Fitted | None:
    """What was found, its pieces from the end back; None if they are not as many, or end at a limit."""
    runs = []
    for part, run in zip(found.parts, found.runs, strict=True):
        other = run if part.exact else backward(part, high, len(run))
        if other is None or other.limited or len(other) != len(run):
            return None
        runs.append(other)
    return replace(found, runs=runs)


def _longest(part: Arcs, end: float, high: float) -> Run:
    """The longest piece within ``high`` that ends there, if any does."""
    arcs = part if end == part.ends[1] else Arcs(part.coordinates, part.fit, part.ending_at(end))
    bad, good = part.ends[0], end

    def fitted(start: float) -> Run:
        here = arcs if start == part.ends[0] else Arcs(part.coordinates, part.fit, arcs.starting_at(start))
        return here.fitted(np.array([start, end]))

    beyond, found = fitted(bad), None
    if beyond.error <= high:
        return beyond
    for _ in range(HALVINGS):
        middle = 0.5 * (bad + good)
        if not bad < middle < good:
            break
        piece = fitted(middle)
        if piece.error <= high:
            good, found = middle, piece
        else:
            bad, beyond = middle, piece
    return beyond if found is None else replace(found, limited=not beyond.error <= JUMP * high)
