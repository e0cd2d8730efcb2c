"""Special points to the last bit, and the frames there, from jets in pairs of doubles.

Errors that are measured in doubles have a noise which, in parts of a small tolerance, moves knots visibly.
It is the same noise for all that begin from the same bits: so points that are found at run time are the
doubles nearest to the true ones, and so are the frames there, as the front door's are from ball arithmetic.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.jit import kernel
from osculant.kernels.operations import dimension
from osculant.kernels.standalone.pairs import Pair, add, divide, multiply, negative, root, times

#: derivatives of each coordinate in a precise jet, the value and the slope of each of two forms behind them,
#: and doubles in all
DERIVATIVES, FORMS, WIDE = 4, 2, 32
#: which form: none, the zero being a cusp
CUSP = -1
#: steps to one zero, and their length at most in parts of the interval
STEPS, TRUSTED = 8, 1e-9


class Jets(NamedTuple):
    """What samples the curve.

    Attributes:
        address: of the jet that kernels take.
        longer: of one for the forms, of so many derivatives:
        order: their number.
        precise: of one in pairs, if there is one, which
        sure: says.
        jet: room for the first two.
        wide: room for the precise one.
    """

    address: int
    longer: int
    order: int
    precise: int
    sure: bool
    jet: np.ndarray[Any, Any]
    wide: np.ndarray[Any, Any]


@kernel
def entry(jets: Jets, index: int, shift: float) -> Pair:
    """A derivative from the precise jet at a parameter, so far moved from the double where it was taken."""
    wide = jets.wide
    here, rate = Pair(wide[2 * index], wide[2 * index + 1]), Pair(wide[2 * index + 2], wide[2 * index + 3])
    return add(here, times(rate, shift))


@kernel
def step_to_zero(fit: Any, jets: Jets, which: int) -> Pair:
    """Newton's step from where the precise jet was taken to the zero of a form, or of α̇·α̈."""
    n = dimension(fit)
    if which != CUSP:
        place = DERIVATIVES * n + 2 * which
        return divide(negative(entry(jets, place, 0.0)), entry(jets, place + 1, 0.0))
    value, slope = Pair(0.0, 0.0), Pair(0.0, 0.0)
    for i in range(n):
        velocity, second = entry(jets, DERIVATIVES * i + 1, 0.0), entry(jets, DERIVATIVES * i + 2, 0.0)
        third = entry(jets, DERIVATIVES * i + 3, 0.0)
        value = add(value, multiply(velocity, second))
        slope = add(slope, add(multiply(second, second), multiply(velocity, third)))
    return divide(negative(value), slope)


@kernel
def polished(fit: Any, jets: Jets, which: int, t: float, width: float) -> Pair:
    """The zero near t of a form, or the cusp there, on an interval so wide; t if nothing better is found."""
    found = Pair(t, 0.0)
    if not jets.sure:
        return found
    for _ in range(STEPS):
        call_jet(jets.precise, found.high, jets.wide)
        step = step_to_zero(fit, jets, which)
        if not abs(step.high) <= TRUSTED * width:
            return Pair(t, 0.0)
        new = add(Pair(found.high, 0.0), step)
        if new.high == found.high:
            return new
        found = new
    return found


@kernel
def write_precise(
    fit: Any, jets: Jets, at: Pair, order: int, sign: float, row: np.ndarray[Any, Any], first: int
) -> None:
    """Write the point and the unit tangent at a parameter, from a derivative of some order times the sign."""
    n = dimension(fit)
    call_jet(jets.precise, at.high, jets.wide)
    square = Pair(0.0, 0.0)
    for i in range(n):
        part = entry(jets, DERIVATIVES * i + order, at.low)
        square = add(square, multiply(part, part))
    length = root(square)
    for i in range(n):
        point = entry(jets, DERIVATIVES * i, at.low)
        tangent = divide(entry(jets, DERIVATIVES * i + order, at.low), length)
        if math.isfinite(point.high) and math.isfinite(tangent.high):
            row[first + i], row[first + n + i] = point.high, sign * tangent.high
