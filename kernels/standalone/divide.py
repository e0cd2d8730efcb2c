"""The size and the stretches of a curve that is known only when it is to be approximated, in doubles."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.generated import forms
from osculant.kernels.jit import kernel
from osculant.kernels.operations import NOISE, ORIGIN, SCALE, dimension
from osculant.kernels.standalone.cusps import add_cusps
from osculant.kernels.standalone.pairs import Pair
from osculant.kernels.standalone.precise import Jets, order_there, write_precise
from osculant.kernels.standalone.special import NO_FORM, add_zeros, insert
from osculant.kernels.standalone.stretches import DONE, FRAMES, SIDE, START, STOP, TOO_MUCH, UNDEFINED, WRONG

#: samples that tell the size of a curve, as in `osculant.curves.extent`
SAMPLES = 257
#: rounding units of the largest coordinate that positions may be wrong by
NOISE_ULPS = 4
#: special points at most
POINTS = 250
#: a speed below this part of the curve's size over its interval is that of a cusp
SLOW = 1e-9
#: where the side to which a stretch bends is read off, in parts of it
INSIDE = 0.4871


@kernel
def measured(fit: Any, jets: Jets, low: float, high: float, units: np.ndarray[Any, Any], degree: int,
    size: np.ndarray[Any, Any],
) -> bool:  # fmt: skip
    """Fill ``size`` (`osculant.kernels.operations.SCALE` …) from samples; False where the curve is undefined.

    ``units`` are the floor of tolerances, the share kept for rounding and the least of it in rounding units,
    and the resolution over the tolerance.
    """
    k = dimension(fit) + 1
    least, most = np.empty(3), np.empty(3)
    largest, step = 0.0, (high - low) / (SAMPLES - 1)
    for i in range(SAMPLES):
        t = high if i == SAMPLES - 1 else i * step + low
        call_jet(jets.address, t, jets.jet)
        for j in range(dimension(fit)):
            x = jets.jet[k * j]
            if not math.isfinite(x):
                return False
            if i == 0:
                size[ORIGIN + j] = x
                least[j], most[j] = x, x
            least[j], most[j] = min(least[j], x), max(most[j], x)
            largest = max(largest, abs(x))
    extent = 0.0
    for j in range(dimension(fit)):
        extent = max(extent, most[j] - least[j])
    if not (extent > 0.0 and extent < math.inf):
        return False
    rounding = 2.0**-53 / power_of_two(largest)
    size[SCALE] = power_of_two(extent)
    size[NOISE] = NOISE_ULPS * rounding * size[SCALE]
    if degree == 2:
        rounding *= extent
    size[NOISE + 1], size[NOISE + 2], size[NOISE + 3] = units[0] * rounding, units[1], units[2] * rounding
    size[NOISE + 4] = units[3] if degree == 1 else units[3] / extent
    return True


@kernel
def power_of_two(x: float) -> float:
    """The power of two p with ½ ≤ px < 1.

    >>> power_of_two(3.0), power_of_two(0.5)
    (0.25, 1.0)
    """
    power = 1.0
    while x * power >= 1.0:
        power *= 0.5
    while x * power < 0.5:
        power *= 2.0
    return power


@kernel
def write_frame(
    fit: Any, jets: Jets, at: Pair, sign: float, extent: float, width: float, row: np.ndarray[Any, Any],
    first: int,
) -> bool:  # fmt: skip
    """Write the point and unit tangent at a parameter into a row, at a cusp that of the side ``sign``.

    The curve is as large as ``extent``, on an interval so wide.  Returns False if there is no tangent.
    """
    n = dimension(fit)
    k = n + 1
    call_jet(jets.address, at.high, jets.jet)
    order = 1
    if not derivative_length(fit, jets.jet, 1) > SLOW * extent / width:
        order = order_there(fit, jets, at, width) if jets.sure else 2
    side = sign if order % 2 == 0 else 1.0
    length = derivative_length(fit, jets.jet, min(order, 2))
    if order == 0 or not (length < math.inf and (length > 0.0 or jets.sure)):
        return False
    for i in range(n):
        row[first + i] = jets.jet[k * i]
        row[first + n + i] = side * jets.jet[k * i + min(order, 2)] / length
    if jets.sure:
        write_precise(fit, jets, at, order, side, extent, row, first)
    return True


@kernel
def derivative_length(fit: Any, jet: np.ndarray[Any, Any], order: int) -> float:
    """The length of a derivative in a jet that kernels take."""
    square = 0.0
    for i in range(dimension(fit)):
        square += jet[(dimension(fit) + 1) * i + order] ** 2
    return math.sqrt(square)


@kernel
def divided(
    fit: Any, jets: Jets, form: int, other: int, low: Pair, high: Pair, grid: np.ndarray[Any, Any],
    splits: np.ndarray[Any, Any], given: bool, extent: float, stretches: np.ndarray[Any, Any],
) -> tuple[int, int]:  # fmt: skip
    """(number of stretches, how it went): ``stretches`` filled between the special points of [low, high].

    Args:
        fit: a record.
        jets: of the curve.
        form: whose zeros split it, `NO_FORM` for none,
        other: and another.
        low: one end,
        high: and the other.
        grid: places between which special points are sought (`special.add_zeros`).
        splits: where it is to be split, increasing, if they are
        given: by the caller; then nothing is sought.
        extent: of the curve.
        stretches: room for `POINTS` + 1 rows.
    """
    points = np.empty((POINTS, 2))
    count, a, b = 0, low.high, high.high
    if given:
        for i in range(splits.shape[0]):
            if not (splits[i] > a and splits[i] < b) or (i > 0 and not splits[i] > splits[i - 1]):
                return 0, WRONG
            count = insert(points, count, Pair(splits[i], 0.0), a, b)
            if count < 0:
                return 0, TOO_MUCH
    else:
        count = add_cusps(fit, jets, grid, points, count)
        if form != NO_FORM and count >= 0:
            count = add_zeros(fit, jets, form, 0, grid, points, count)
        if other != NO_FORM and count >= 0:
            count = add_zeros(fit, jets, other, 1, grid, points, count)
        if count < 0:
            return 0, TOO_MUCH
    n = dimension(fit)
    start = low
    for i in range(count + 1):
        row = stretches[i]
        end = Pair(points[i, 0], points[i, 1]) if i < count else high
        row[START], row[STOP], row[SIDE] = start.high, end.high, 1.0
        first = write_frame(fit, jets, start, 1.0, extent, b - a, row, FRAMES)
        last = write_frame(fit, jets, end, -1.0, extent, b - a, row, FRAMES + 2 * n)
        if not (first and last):
            return 0, UNDEFINED
        if n == 2:
            call_jet(jets.address, start.high + (end.high - start.high) * INSIDE, jets.jet)
            if forms.inflection(jets.jet[1], jets.jet[2], jets.jet[4], jets.jet[5]) < 0.0:
                row[SIDE] = -1.0
        start = end
    return count + 1, DONE
