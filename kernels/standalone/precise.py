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
#: and doubles in all; the first derivative that is not 0 at a singular point is of this order at most
DERIVATIVES, FORMS, WIDE, ORDERS = 7, 2, 50, 5
#: steps to one zero, and how far they lead at most in parts of the interval
STEPS, TRUSTED, SEEN = 8, 1e-9, 1e-3
#: derivatives below this part of the next one's share vanish; parts of the interval in which shares are told,
#: and at a parameter that is only a double
VANISHED, NEAR, ROUGHLY = 2.0**-60, 2.0**-20, 2.0**-20
#: parameters, coordinates and parts of tangents that are 0 but for rounding: below this part of how far a
#: step may lead, of the curve's size and of 1
NOTHING = 2.0**-80


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
def load(jets: Jets, at: Pair) -> None:
    """Take the precise jet at a parameter; what the double lacks of it is `entry`'s shift."""
    call_jet(jets.precise, at.high, jets.wide)


@kernel
def form_in_pairs(fit: Any, jets: Jets, which: int, t: float) -> float:
    """The value of a form, by its place in the precise jet."""
    load(jets, Pair(t, 0.0))
    return entry(jets, DERIVATIVES * dimension(fit) + 2 * which, 0.0).high


@kernel
def along(fit: Any, jets: Jets, first: int, second: int, shift: float) -> Pair:
    """The inner product of two derivatives in the precise jet."""
    total = Pair(0.0, 0.0)
    for i in range(dimension(fit)):
        one, other = (
            entry(jets, DERIVATIVES * i + first, shift),
            entry(jets, DERIVATIVES * i + second, shift),
        )
        total = add(total, multiply(one, other))
    return total


@kernel
def length_in_pairs(fit: Any, jets: Jets, order: int, shift: float) -> float:
    """The length of a derivative in the precise jet."""
    return math.sqrt(max(0.0, along(fit, jets, order, order, shift).high))


@kernel
def step_to_zero(fit: Any, jets: Jets, which: int) -> Pair:
    """Newton's step from where the precise jet was taken to the zero of a form."""
    place = DERIVATIVES * dimension(fit) + 2 * which
    return divide(negative(entry(jets, place, 0.0)), entry(jets, place + 1, 0.0))


@kernel
def step_to_point(fit: Any, jets: Jets, order: int) -> Pair:
    """And to where derivatives below an order vanish: a simple zero of α⁽ᵏ⁻¹⁾·α⁽ᵏ⁾."""
    slope = add(along(fit, jets, order, order, 0.0), along(fit, jets, order - 1, order + 1, 0.0))
    return divide(negative(along(fit, jets, order - 1, order, 0.0)), slope)


@kernel
def polished(fit: Any, jets: Jets, which: int, order: int, t: float, most: float) -> tuple[Pair, bool]:
    """(the zero near t of a form, whether Newton's method finds it within ``most``); else t.

    If an order is given it is the point where derivatives below that order vanish instead.
    """
    found = Pair(t, 0.0)
    if not jets.sure:
        return found, False
    for _ in range(STEPS):
        load(jets, found)
        step = step_to_point(fit, jets, order) if order > 0 else step_to_zero(fit, jets, which)
        if not abs(found.high - t) + abs(step.high) <= most:
            break
        new = add(Pair(found.high, 0.0), step)
        if abs(new.high) <= NOTHING * most:  # parts of it never come to an end
            new = Pair(0.0, 0.0)
        if new.high == found.high:
            return new, True
        found = new
    return Pair(t, 0.0), False


@kernel
def singular_point(fit: Any, jets: Jets, t: float, width: float) -> tuple[Pair, bool]:
    """(the point near t where the curve stands still, whether there is one), on an interval so wide."""
    for order in range(2, ORDERS + 1):
        found, settled = polished(fit, jets, 0, order, t, SEEN * width)
        if not settled:
            continue
        load(jets, found)
        share = length_in_pairs(fit, jets, order, found.low)
        vanishes = share > 0.0
        for lower in range(order - 1, 0, -1):
            share *= width
            vanishes = vanishes and length_in_pairs(fit, jets, lower, found.low) <= VANISHED * share
        if vanishes:
            return found, True
    return Pair(t, 0.0), False


@kernel
def order_there(fit: Any, jets: Jets, at: Pair, width: float) -> int:
    """The order of the first derivative that does not vanish at a point where the speed does; 0 for none."""
    load(jets, at)
    near = NEAR * width
    largest, found = 0.0, 0
    for order in range(ORDERS + 1, 1, -1):
        share = length_in_pairs(fit, jets, order, at.low if order <= ORDERS else 0.0) * near**order
        if share > ROUGHLY * largest and order <= ORDERS:
            found = order
        largest = max(largest, share)
    return found


@kernel
def write_precise(
    fit: Any, jets: Jets, at: Pair, order: int, sign: float, size: float, row: np.ndarray[Any, Any],
    first: int,
) -> None:  # fmt: skip
    """Write the point and the unit tangent at a parameter, from a derivative of some order times the sign.

    The curve is as large as ``size``: what is far below that is 0.
    """
    n = dimension(fit)
    load(jets, at)
    length = root(along(fit, jets, order, order, at.low))
    for i in range(n):
        point = entry(jets, DERIVATIVES * i, at.low).high
        tangent = divide(entry(jets, DERIVATIVES * i + order, at.low), length).high
        if math.isfinite(point) and math.isfinite(tangent):
            row[first + i] = point if abs(point) > NOTHING * size else 0.0
            row[first + n + i] = sign * tangent if abs(tangent) > NOTHING else 0.0
