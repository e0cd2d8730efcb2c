"""The fit with bihelices as a record (`osculant.kernels.operations`).

The offset of the junction is v = wσ on arcs of any length σ, so the state of the search is w, with what was
seen of log(left peak/right peak) as v changed.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.bihelices import shapes
from osculant.kernels.bihelices.balance import (
    FARTHEST,
    ROUNDING,
    STEEPNESS,
    Balanced,
    assess,
    balanced,
    is_straight,
    with_all_peaks,
)
from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS
from osculant.kernels.bihelices.helix import HELIX_SIZE, moved, write_helix
from osculant.kernels.curves.arc_length import Lengths, measure_lengths, workspace
from osculant.kernels.curves.space import IN_SPACE, Frame, Source, frenet_at
from osculant.kernels.generated import laws
from osculant.kernels.jit import kernel
from osculant.kernels.operations import SHAPE, TURNING, Rules, register

#: samples of each side of a junction: while searching, and for the error that decides
QUICK, CHECKED = 4, 8
#: log(left peak/right peak) of a junction that is left as it is, as unequal peaks cost length, and at which
#: errors are smooth in the ends; at least so many times noise/error
CALM, EQUAL, NOISE = 2e-7, 1e-11, 8.0
#: nodes of Gauss's rule of two points, from the middle in halves of a panel
NODE = 1.0 / math.sqrt(3.0)


class Bihelix(NamedTuple):
    """The bihelix whose junction is chosen by a rule of `osculant.kernels.bihelices.family`.

    ``order`` is that of the error in the length of a short arc, 3, or 4 where the curvature is constant.
    """

    rule: int = EQUIOSCILLATING
    order: float = 3.0


#: what a record may say
VARIANTS = [
    (rule, float(order))
    for rule in (EQUIOSCILLATING, THESIS)
    for order in (laws.BIHELIX_ORDER, laws.LEVEL_BIHELIX_ORDER)
]


class State(NamedTuple):
    """w, the one before and log(left peak/right peak) there, and the growth of that with v."""

    w: float
    before: float
    g: float
    steepness: float


#: columns of a row, all in the user's coordinates and units, torsion with the usual sign: the parameter in
#: the junction's normal plane, the peaks on both sides, the helices (`write_helix`), end point and tangent
MIDDLE, PEAKS, LEFT = SHAPE, SHAPE + 1, SHAPE + 3
RIGHT, END = LEFT + HELIX_SIZE, LEFT + 2 * HELIX_SIZE
COLUMNS = END + 6


@kernel
def rules(fit: Bihelix) -> Rules:
    """How arcs are searched for: errors need not be monotone in the length, so rests may be longer."""
    return Rules(fit.order, EQUAL, 0.4, 2.0, 1e-3, CHECKED, CHECKED, TURNING)


@kernel
def begin(fit: Bihelix) -> State:
    """The junction in the middle."""
    return State(0.0, math.nan, math.nan, STEEPNESS)


@kernel
def renew(fit: Bihelix, state: State) -> State:
    """The same offset on another arc."""
    return State(state.w, math.nan, math.nan, STEEPNESS)


@kernel
def step(
    fit: Bihelix, source: Source, a: float, start: Frame, b: float, end: Frame,
    state: State, calm: float, lengths: Lengths,
) -> tuple[float, float, bool, State]:  # fmt: skip
    """(error, w, settled, state) by one fast evaluation; the error is about that of equal peaks."""
    w, noise = state.w, source.place.noise
    if is_straight(start, end, noise):
        return math.nan, w, False, state
    sigma = measure_lengths(source, a, b, lengths)
    v = min(FARTHEST, max(-FARTHEST, w * sigma))
    seen = assess(fit.rule, source, a, start, b, end, sigma, v, QUICK, lengths)
    error = max(seen.left, seen.right)
    if not seen.trusted or not error > ROUNDING * noise or math.isinf(error):
        return math.nan, w, False, state
    g = math.log(seen.left / seen.right) if fit.rule == EQUIOSCILLATING else 0.0
    if abs(g) <= max(CALM, NOISE * noise / error):
        return error, w, True, state
    steepness = state.steepness
    turned = (v / sigma - state.before) * sigma
    if abs(turned) > 1e-9:  # not so while there is no previous evaluation
        steepness = min(4.0 * STEEPNESS, max(0.25 * STEEPNESS, (g - state.g) / turned))
    moved_w = (v - max(-0.1, min(0.1, g / steepness))) / sigma
    return math.sqrt(seen.left * seen.right), w, False, State(moved_w, v / sigma, g, steepness)


@kernel
def confirm(
    fit: Bihelix, w: float, source: Source, a: float, start: Frame, b: float, end: Frame,
    points: int, lengths: Lengths,
) -> tuple[float, Balanced]:  # fmt: skip
    """(error, piece) of the junction at wσ, from ``points`` samples of each side; infinite if not trusted."""
    sigma = measure_lengths(source, a, b, lengths)
    v = min(FARTHEST, max(-FARTHEST, w * sigma)) if fit.rule == EQUIOSCILLATING else 0.0
    seen = assess(fit.rule, source, a, start, b, end, sigma, v, points, lengths)
    seen = with_all_peaks(source, a, b, seen, points)
    error = max(seen.left, seen.right) if seen.trusted else math.inf
    return error, Balanced(error, seen.left, seen.right, v, seen.two)


@kernel
def best(
    fit: Bihelix, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, lengths: Lengths
) -> tuple[float, Balanced]:
    """(error, piece) by the rule, sought with care."""
    piece = balanced(fit.rule, source, a, start, b, end, 0.0, CALM, points, lengths)
    return piece.error, piece


@kernel
def resume(fit: Bihelix, piece: Balanced, source: Source, a: float, b: float, lengths: Lengths) -> State:
    """The offset that a careful search has found."""
    return State(piece.v / measure_lengths(source, a, b, lengths), math.nan, math.nan, STEEPNESS)


@kernel
def settle(
    fit: Bihelix, source: Source, a: float, start: Frame, b: float, end: Frame,
    state: State, points: int, lengths: Lengths,
) -> tuple[float, Balanced, State, bool]:  # fmt: skip
    """(error, piece, state, True) of a given arc: the peaks are made equal more closely.

    From the middle, so that the error is one of this arc alone.
    """
    piece = balanced(fit.rule, source, a, start, b, end, 0.0, CALM, points, lengths)
    if fit.rule == EQUIOSCILLATING and piece.error > 0.0 and piece.error < math.inf:
        calm = max(EQUAL, NOISE * source.place.noise / piece.error)
        if calm < CALM:
            piece = balanced(fit.rule, source, a, start, b, end, piece.v, calm, points, lengths)
    return piece.error, piece, state, True


@kernel
def record(
    fit: Bihelix, row: np.ndarray[Any, Any], piece: Balanced, start: Frame, end: Frame, source: Source
) -> None:
    """Write a piece's shape, in the user's coordinates."""
    place = source.place
    origin, scale = (place.x, place.y, place.z), place.scale
    row[MIDDLE], row[PEAKS], row[PEAKS + 1] = piece.two.t, piece.left / scale, piece.right / scale
    write_helix(moved(piece.two.left, origin, scale), row, LEFT)
    write_helix(moved(piece.two.right, origin, scale), row, RIGHT)
    for j in range(3):
        row[END + j], row[END + 3 + j] = end.point[j] / scale + origin[j], end.tangent[j]


@kernel
def bend_at(address: int, scale: float, jet: np.ndarray[Any, Any], t: float) -> tuple[float, float, float]:
    """Speed, κ and τ at t of the curve times ``scale``."""
    found = frenet_at(address, scale, jet, t)
    return found[0], found[1], found[3]


@kernel
def content(
    fit: Bihelix, address: int, scale: float, jet: np.ndarray[Any, Any], a: float, b: float, singular: bool
) -> float:
    """∫|κ′|^{1/3} ds over a panel for the order 3, ∫|κτ′|^{1/4} ds for 4 (constant curvature).

    Equal contents give equal errors, to leading order.  Slopes are those of secants between two nodes inside,
    so singular ends do no harm, and the result is as accurate as the grid is fine: for knots to start from.
    """
    middle, half = 0.5 * (a + b), 0.5 * (b - a)
    speed0, bend0, twist0 = bend_at(address, scale, jet, middle - NODE * half)
    speed1, bend1, twist1 = bend_at(address, scale, jet, middle + NODE * half)
    length = half * (speed0 + speed1)
    change = abs(bend1 - bend0) if fit.order == 3.0 else 0.5 * (bend0 + bend1) * abs(twist1 - twist0)
    if length > 0.0 and math.isfinite(change):
        return float((change / (NODE * length)) ** (1.0 / fit.order) * length)
    return 0.0


register(
    Bihelix,
    COLUMNS,
    **IN_SPACE,
    rules=rules,
    workspace=workspace,
    begin=begin,
    renew=renew,
    step=step,
    confirm=confirm,
    best=best,
    resume=resume,
    settle=settle,
    record=record,
    shape=shapes.of_bihelix,
    content=content,
)
