"""The best pieces on given arcs: what is needed to move knots until all errors are equal.

So errors must change smoothly with the knots: the fast steps are repeated until they no longer change the
error, and their error is kept, while the measurement that decides elsewhere only has to confirm it.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.course import resolving, turns
from osculant.kernels.jit import kernel
from osculant.kernels.operations import (
    ERROR,
    REASON,
    A,
    B,
    begin,
    best,
    confirm,
    operation,
    record,
    renew,
    rules,
    source,
    step,
    workspace,
)
from osculant.kernels.search import ENDS_AT_STRETCH, frame_at

#: fast steps on one arc, and the part of the error that the measurement has to confirm it to
VISITS, CONFIRMED = 12, 1e-6


@operation
def settle(
    fit: Any, curve: Any, a: Any, start: Any, b: Any, end: Any, state: Any, points: Any, space: Any
) -> Any:
    """(error, piece, state, settled) of the best piece of a given arc, its error smooth in the ends."""
    state = renew(fit, state)
    calm = rules(fit).settled
    error, choice, settled, moved = step(fit, curve, a, start, b, end, state, calm, space)
    for _ in range(VISITS - 1):
        if not error > 0.0 or settled:
            break
        state = moved
        error, choice, settled, moved = step(fit, curve, a, start, b, end, state, calm, space)
    checked, piece = confirm(fit, choice, curve, a, start, b, end, points, space)
    agreed = abs(checked - error) <= CONFIRMED * error + curve.place.noise
    return error, piece, moved, settled and error > 0.0 and agreed


@kernel
def best_between(
    fit: Any, curve: Any, a: float, start: Any, b: float, end: Any, state: Any,
    course: np.ndarray[Any, Any], space: Any,
) -> tuple[float, Any, Any]:  # fmt: skip
    """(error, piece, state) of the best piece of the arc [a, b]; infinite if there is none."""
    rule = rules(fit)
    points = resolving(course, a, b, rule.checked)
    error, piece, state, settled = settle(fit, curve, a, start, b, end, state, points, space)
    if not settled:
        points = resolving(course, a, b, rule.careful)
        error, piece = best(fit, curve, a, start, b, end, points, space)
        state = begin(fit)
    if not error < math.inf or turns(course, a, b) > rule.turning:
        error = math.inf
    return error, piece, state


@kernel
def fit_arcs(
    fit: Any, address: int, place: Any, knots: np.ndarray[Any, Any], start: Any, last: Any,
    course: np.ndarray[Any, Any], table: np.ndarray[Any, Any],
) -> None:  # fmt: skip
    """Fill ``table`` with the best pieces of the m arcs between m + 1 neighbouring knots.

    Args:
        fit: a record (`osculant.kernels.operations`).
        address: of the compiled jet.
        place: of the kernel's coordinates.
        knots: increasing parameters (m + 1,).
        start: the (limit) frame at the first knot.
        last: at the last one.
        course: of the stretch (`osculant.kernels.course`).
        table: (m, columns of the family); the error of an arc without a proper piece is infinite.

    Errors are those of `best`, as smooth in the knots as rounding permits.
    """
    curve, space = source(fit, address, place, course), workspace(fit)
    state = begin(fit)
    count = knots.shape[0] - 1
    stop = knots[count]
    for i in range(count):
        a, b = knots[i], knots[i + 1]
        end = frame_at(fit, curve, b, stop, last)
        error, piece, state = best_between(fit, curve, a, start, b, end, state, course, space)
        row = table[i]
        row[A], row[B], row[ERROR], row[REASON] = a, b, error, ENDS_AT_STRETCH
        record(fit, row, piece, start, end, curve)
        start = end
