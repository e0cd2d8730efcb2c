"""Approximation of a curve whose interval or parameters are known only now."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.jit import kernel
from osculant.kernels.operations import FLOOR, RESOLUTION, SCALE, dimension
from osculant.kernels.standalone.divide import POINTS, divided, measured
from osculant.kernels.standalone.features import SEEN, Features, edges_of, grid_of
from osculant.kernels.standalone.pairs import Pair
from osculant.kernels.standalone.precise import WIDE, Jets
from osculant.kernels.standalone.special import JET
from osculant.kernels.standalone.stretches import (
    DONE,
    EDGES,
    FRAMES,
    TOO_MUCH,
    UNDEFINED,
    WRONG,
    Outcome,
    for_number,
    for_tolerance,
)

#: numbers of a curve's size, and of a stretch, at most
SIZE, STRETCH = 9, 15


@kernel
def approximate(
    fit: Any, address: int, longer: int, order: int, precise: int, sure: bool, form: int, other: int,
    low: float, low_rest: float, high: float, high_rest: float, features: Features,
    splits: np.ndarray[Any, Any], given: bool, units: np.ndarray[Any, Any], tolerance: float, number: int,
    degree: int, pieces: np.ndarray[Any, Any],
) -> Outcome:  # fmt: skip
    """The outcome for a tolerance or, if that is 0, a number of pieces.

    Args:
        fit: a record (`osculant.kernels.operations`).
        address: of the jet that kernels take.
        longer: that for the forms, of so many derivatives:
        order: their number.
        precise: that in pairs (`precise.Jets`), if it is there:
        sure: whether it is.
        form: whose zeros split the curve (`special.NO_FORM` …),
        other: and another.
        low: one end of the interval,
        low_rest: what the double lacks of it,
        high: the other,
        high_rest: and what that lacks.
        features: what tells of the curve between samples.
        splits: special points, if they are
        given: by the caller.
        units: see `divide.measured`.
        tolerance: of errors.
        number: of pieces.
        degree: of an error: 1 for lengths, 2 for areas.
        pieces: the caller's array.
    """
    width = high - low
    if not (width > 0.0 and width < math.inf and math.isfinite(low) and math.isfinite(high)):
        return Outcome(0, WRONG, 0.0, 0.0)
    jets = Jets(address, longer, order, precise, sure, np.empty(JET), np.empty(WIDE))
    size = np.empty(SIZE)
    if not measured(fit, jets, low, high, units, degree, size):
        return Outcome(0, UNDEFINED, 0.0, 0.0)
    columns = FRAMES + 4 * dimension(fit)
    stretches = np.empty((POINTS + 1, STRETCH)).reshape(((POINTS + 1) * STRETCH // columns, columns))
    ends = Pair(low, low_rest), Pair(high, high_rest)
    edges = np.empty((EDGES, 2))
    level = max(size[FLOOR], tolerance)  # also where the tolerance is none
    count = edges_of(features, low, high, level * size[RESOLUTION], edges)
    if count < 0:
        return Outcome(0, TOO_MUCH, 0.0, 0.0)
    grid = np.empty((EDGES + SEEN + 1, 2))
    places = grid[: grid_of(low, high, edges[:count], grid)]
    found, status = divided(
        fit, jets, form, other, ends[0], ends[1], places, splits, given, 1.0 / size[SCALE], stretches
    )
    if status != DONE:
        return Outcome(0, status, 0.0, 0.0)
    if tolerance == 0.0 and number > 0:
        return for_number(fit, address, size, stretches[:found], edges[:count], number, degree, pieces)
    return for_tolerance(fit, address, size, stretches[:found], edges[:count], tolerance, degree, pieces)
