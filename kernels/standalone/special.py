"""Special points of a curve in doubles: zeros of forms, for compiled approximators.

They are sought as sign changes of the forms that `osculant.cas.zeros` isolates, on a grid that knows the
curve's features and is refined where a form comes near to 0.  Nothing is proved here: two zeros closer to
each other than the finest grid are missed, and so are zeros without a change of sign.
Changes of sign that rounding made, as it does near cusps, are told by pairs of doubles, if there are any.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.generated import forms
from osculant.kernels.jit import kernel
from osculant.kernels.standalone.pairs import Pair
from osculant.kernels.standalone.precise import TRUSTED, Jets, form_in_pairs, polished

#: how often a panel of the grid is halved, and a form that falls below this part of its ends' in the middle
#: may have zeros
DEPTH, NEAR = 12, 0.5
#: special points closer to each other, or to an end, than this part of the interval are one
TOGETHER = 1e-9
#: steps to one zero
STEPS = 200
#: forms that are smaller than this part of their terms are rounding
ROUNDING = 2.0**-44
#: the forms by number, and the doubles of the longest jets
NO_FORM, INFLECTION, PARABOLIC, SEXTACTIC, VERTEX, SPACE_VERTEX = 0, 1, 2, 3, 4, 5
JET = 18


@kernel
def length(jet: np.ndarray[Any, Any], coordinates: int, k: int, order: int) -> float:
    """The length of a derivative in a jet with k numbers for each coordinate."""
    total = 0.0
    for i in range(coordinates):
        total += jet[k * i + order] ** 2
    return math.sqrt(total)


@kernel
def form_at(jets: Jets, form: int, t: float) -> tuple[float, float]:
    """(value, size of the terms) of a form at t."""
    jet, k = jets.jet, jets.order + 1
    call_jet(jets.longer, t, jet)
    if form == SPACE_VERTEX:
        m = 2 * k
        value = forms.space_vertex(
            jet[1], jet[2], jet[3], jet[k + 1], jet[k + 2], jet[k + 3], jet[m + 1], jet[m + 2], jet[m + 3]
        )
        size = forms.space_vertex_size(length(jet, 3, k, 1), length(jet, 3, k, 2), length(jet, 3, k, 3))
        return value, size
    x1, x2, y1, y2 = jet[1], jet[2], jet[k + 1], jet[k + 2]
    n1, n2 = length(jet, 2, k, 1), length(jet, 2, k, 2)
    if form == INFLECTION:
        return forms.inflection(x1, x2, y1, y2), forms.inflection_size(n1, n2)
    x3, y3, n3 = jet[3], jet[k + 3], length(jet, 2, k, 3)
    if form == VERTEX:
        return forms.vertex(x1, x2, x3, y1, y2, y3), forms.vertex_size(n1, n2, n3)
    x4, y4, n4 = jet[4], jet[k + 4], length(jet, 2, k, 4)
    if form == PARABOLIC:
        return forms.parabolic(x1, x2, x3, x4, y1, y2, y3, y4), forms.parabolic_size(n1, n2, n3, n4)
    x5, y5, n5 = jet[5], jet[k + 5], length(jet, 2, k, 5)
    return forms.sextactic(x1, x2, x3, x4, x5, y1, y2, y3, y4, y5), forms.sextactic_size(n1, n2, n3, n4, n5)


@kernel
def told(jets: Jets, form: int, t: float) -> float:
    """The value of a form at t; 0 where rounding may have made it."""
    value, size = form_at(jets, form, t)
    return 0.0 if abs(value) <= ROUNDING * size else value


@kernel
def zero_between(jets: Jets, form: int, low: float, high: float, at_low: float) -> float:
    """The sign change of a form between two places where its signs differ, by bisection to the last bit."""
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        if not (middle > low and middle < high):
            break
        value, _ = form_at(jets, form, middle)
        if value == 0.0:
            return middle
        if (value > 0.0) == (at_low > 0.0):
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@kernel
def truly_changes(fit: Any, jets: Jets, which: int, low: float, high: float) -> bool:
    """Whether a form changes its sign in pairs of doubles too, if there are any."""
    if not jets.sure:
        return True
    return not form_in_pairs(fit, jets, which, low) * form_in_pairs(fit, jets, which, high) > 0.0


@kernel
def zero_in_pairs(fit: Any, jets: Jets, which: int, low: float, high: float) -> float:
    """The change of a form's sign by bisection in pairs of doubles, where Newton's method does not settle."""
    positive = form_in_pairs(fit, jets, which, low) > 0.0
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        if not (middle > low and middle < high):
            break
        if (form_in_pairs(fit, jets, which, middle) > 0.0) == positive:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@kernel
def insert(points: np.ndarray[Any, Any], count: int, at: Pair, low: float, high: float) -> int:
    """Put a parameter where it belongs among the first increasing ``points``; the new number, −1 if too many.

    Ends of the interval, and what is known, are left out.  A point is a row: both parts of its parameter.
    """
    near, t = TOGETHER * (high - low), at.high
    if t - low <= near or high - t <= near:
        return count
    place = count
    while place > 0 and points[place - 1, 0] > t:
        place -= 1
    if place > 0 and t - points[place - 1, 0] <= near:
        return count
    if place < count and points[place, 0] - t <= near:
        return count
    if count == points.shape[0]:
        return -1
    for i in range(count, place, -1):
        points[i, 0], points[i, 1] = points[i - 1, 0], points[i - 1, 1]
    points[place, 0], points[place, 1] = at.high, at.low
    return count + 1


@kernel
def add_zeros(
    fit: Any, jets: Jets, form: int, which: int, grid: np.ndarray[Any, Any], points: np.ndarray[Any, Any],
    count: int,
) -> int:  # fmt: skip
    """Add the zeros of a form to the points; their new number, −1 if there are too many.

    ``which`` it is in the precise jet; ``grid`` (m, 2) has increasing places as rows, both ends among them.
    """
    last = grid.shape[0] - 1
    low, high = grid[0, 0], grid[last, 0]
    pending = np.empty((DEPTH + 2, 3))
    before, at_before = low, told(jets, form, low)
    for i in range(1, last + 1):
        end = grid[i, 0]
        pending[0, 0], pending[0, 1], pending[0, 2] = end, told(jets, form, end), 0.0
        open_ends = 1
        while open_ends > 0:
            t, value, depth = pending[open_ends - 1, 0], pending[open_ends - 1, 1], pending[open_ends - 1, 2]
            middle = 0.5 * (before + t)
            at_middle = told(jets, form, middle)
            changes = at_before * value < 0.0
            dips = not changes and abs(at_middle) < NEAR * min(abs(at_before), abs(value))
            hidden = not changes and at_middle * value < 0.0
            if (hidden or dips) and depth < DEPTH and open_ends <= DEPTH:
                new = pending[open_ends]
                new[0], new[1], new[2] = middle, at_middle, depth + 1.0
                pending[open_ends - 1, 2] = depth + 1.0
                open_ends += 1
                continue
            if changes and truly_changes(fit, jets, which, before, t):
                zero = zero_between(jets, form, before, t, at_before)
                point, settled = polished(fit, jets, which, 0, zero, TRUSTED * (high - low))
                if jets.sure and not settled:
                    point = Pair(zero_in_pairs(fit, jets, which, before, t), 0.0)
                count = insert(points, count, point, low, high)
                if count < 0:
                    return -1
            if value != 0.0 or at_before == 0.0:  # a sign that is not told is left to the next place
                before, at_before = t, value
            open_ends -= 1
    return count
