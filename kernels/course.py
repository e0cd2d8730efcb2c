"""How a stretch goes: turning of the tangent and length, accumulated along it.

Samples of one arc cannot tell whole turns apart, nor whether the curve is somewhere else between them.  So
the course of a stretch is laid out once, from as many samples as it takes for turning and length to come out
the same in two ways, and says of every arc how far it turns and how many samples resolve it.  Its rows are
close where the curve does something: samples that are even in rows miss none of it.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.jit import kernel
from osculant.kernels.operations import pace, source

#: how many panels are kept open, and the part of the stretch that is not halved any more; rows at most
DEPTH, NARROWEST, MOST = 40, 2.0**-40, 200_000
#: most that a panel may turn, and its turning and its length may differ, in radians and in parts, between
#: Simpson's rule on the whole and on its halves
TURN, AGREED = 0.5, 0.05
#: equidistant samples resolve an arc that is as uneven as this, and more do in proportion to the unevenness
UNEVEN, MOST_POINTS = 3.0, 400
#: samples that are even in rows: so many in each at least
PER_ROW = 2.0
#: columns of a course
TIME, TURNED, LENGTH = 0, 1, 2


@kernel
def lay_out(
    fit: Any, address: int, place: Any, edges: np.ndarray[Any, Any], course: np.ndarray[Any, Any]
) -> int:
    """Fill ``course`` (capacity, 3) with the parameter, turning and length along a stretch.

    Args:
        fit: a record (`osculant.kernels.operations`).
        address: of the curve's compiled jet.
        place: of the kernel's coordinates.
        edges: increasing parameters from one end of the stretch to the other (m + 1,): panels that are halved
            until turning and length are known, and that rows lie at in any case.
        course: to be filled.

    Returns the number of rows, or −1 if the capacity does not suffice.
    """
    curve = source(fit, address, place, course)
    a, b = edges[0], edges[edges.shape[0] - 1]
    pending = np.empty((DEPTH + 2, 3))
    course[0, TIME], course[0, TURNED], course[0, LENGTH] = a, 0.0, 0.0
    count = 1
    time = a
    speed, rate = pace(fit, curve, a)
    for i in range(1, edges.shape[0]):
        end = edges[i]
        end_speed, end_rate = pace(fit, curve, end)
        pending[0, 0], pending[0, 1], pending[0, 2] = end, end_speed, end_rate
        open_ends = 1
        while open_ends > 0:
            row = pending[open_ends - 1]
            end, end_speed, end_rate = row[0], row[1], row[2]
            step, middle = end - time, 0.5 * (time + end)
            speed1, rate1 = pace(fit, curve, 0.5 * (time + middle))
            speed2, rate2 = pace(fit, curve, middle)
            speed3, rate3 = pace(fit, curve, 0.5 * (middle + end))
            turned = step * (rate + 4.0 * rate2 + end_rate) / 6.0
            length = step * (speed + 4.0 * speed2 + end_speed) / 6.0
            fine_turned = step * (rate + 4.0 * rate1 + 2.0 * rate2 + 4.0 * rate3 + end_rate) / 12.0
            fine = step * (speed + 4.0 * speed1 + 2.0 * speed2 + 4.0 * speed3 + end_speed) / 12.0
            agreed = (
                fine_turned <= TURN
                and abs(turned - fine_turned) <= AGREED * TURN
                and abs(length - fine) <= AGREED * fine
            )
            hidden = fine <= curve.place.noise  # how what doubles cannot tell from a point turns is no matter
            wide = step > NARROWEST * (b - a) and middle > time and middle < end
            if not (agreed or hidden) and open_ends <= DEPTH and wide:
                new = pending[open_ends]
                new[0], new[1], new[2] = middle, speed2, rate2
                open_ends += 1
                continue
            if count == course.shape[0]:
                return -1
            if hidden and not agreed and (time == a or end == b):
                fine_turned = 0.0  # the limit tangents are given there, and rounding may show any others
            course[count, TIME] = end
            course[count, TURNED] = course[count - 1, TURNED] + (
                fine_turned if fine_turned < math.inf else 0.0
            )
            course[count, LENGTH] = course[count - 1, LENGTH] + (fine if fine < math.inf else 0.0)
            count += 1
            time, speed, rate = end, end_speed, end_rate
            open_ends -= 1
    return count


@kernel
def row_before(course: np.ndarray[Any, Any], column: int, value: float) -> int:
    """The last row but one, or the last whose entry in an increasing column is at most the value."""
    low, high = 0, course.shape[0] - 1
    while high - low > 1:
        middle = (low + high) // 2
        if course[middle, column] <= value:
            low = middle
        else:
            high = middle
    return low


@kernel
def along(course: np.ndarray[Any, Any], t: float) -> tuple[float, float]:
    """(turning, length) of the course up to t, linear between rows."""
    i = row_before(course, TIME, t)
    low, high = course[i], course[i + 1]
    part = (t - low[TIME]) / (high[TIME] - low[TIME])
    return (
        low[TURNED] + part * (high[TURNED] - low[TURNED]),
        low[LENGTH] + part * (high[LENGTH] - low[LENGTH]),
    )


@kernel
def farthest(course: np.ndarray[Any, Any], a: float, stop: float, turning: float) -> float:
    """Where the arc from a has turned so far, at most ``stop``."""
    whole = course[course.shape[0] - 1, TURNED]
    if whole <= turning:
        return stop
    turned = along(course, a)[0] + turning
    if turned >= whole:
        return stop
    i = row_before(course, TURNED, turned)
    low, high = course[i], course[i + 1]
    part = (turned - low[TURNED]) / (high[TURNED] - low[TURNED])
    return float(min(stop, low[TIME] + part * (high[TIME] - low[TIME])))


@kernel
def turns(course: np.ndarray[Any, Any], a: float, b: float) -> float:
    """How far the arc [a, b] turns."""
    return along(course, b)[0] - along(course, a)[0]


@kernel
def resolving(course: np.ndarray[Any, Any], a: float, b: float, points: int) -> int:
    """How many equidistant samples resolve the arc [a, b] as ``points`` do an even one."""
    i, last = row_before(course, TIME, a), course.shape[0] - 1
    if course[i + 1, TIME] >= b:
        return points
    before, after = along(course, a), along(course, b)
    turned, length = after[0] - before[0], after[1] - before[1]
    uneven = 1.0
    while i < last and course[i, TIME] < b:
        part = (course[i + 1, TIME] - course[i, TIME]) / (b - a)
        uneven = max(uneven, (course[i + 1, LENGTH] - course[i, LENGTH]) / (length * part))
        if turned > TURN:
            uneven = max(uneven, (course[i + 1, TURNED] - course[i, TURNED]) / (turned * part))
        i += 1
    return min(max(points, MOST_POINTS), int(points * max(1.0, uneven / UNEVEN)))


class Spots(NamedTuple):
    """Where samples of an arc are: ``steps`` + 1 places even in rows of the course, both ends among them."""

    a: float
    b: float
    first: float
    last: float
    steps: int


@kernel
def equidistant(a: float, b: float, steps: int) -> Spots:
    """Samples of [a, b] that see no more than they happen to see."""
    return Spots(a, b, 0.0, 0.0, steps)


@kernel
def in_one_row(at: Spots) -> bool:
    """Whether the course tells nothing of an arc that equidistant samples do not see."""
    return at.first == at.last or math.ceil(at.last) - math.floor(at.first) <= 1.0


@kernel
def row_at(course: np.ndarray[Any, Any], t: float) -> float:
    """The place of t in rows."""
    i = row_before(course, TIME, t)
    low, high = course[i, TIME], course[i + 1, TIME]
    return float(i + (t - low) / (high - low))


@kernel
def spots(course: np.ndarray[Any, Any], a: float, b: float, points: int) -> Spots:
    """Samples that see all that the course tells of the arc [a, b], at least ``points`` between its ends.

    Without a course, one of no rows, they are equidistant.
    """
    if course.shape[0] < 2:
        return equidistant(a, b, points + 1)
    first, last = row_at(course, a), row_at(course, b)
    return Spots(a, b, first, last, max(points + 1, math.ceil(PER_ROW * (last - first))))


@kernel
def spot(course: np.ndarray[Any, Any], at: Spots, i: int) -> float:
    """The parameter of the sample i, from 0 to ``at.steps``."""
    if i == 0 or i == at.steps:
        return at.a if i == 0 else at.b
    if at.first == at.last:
        return at.a + (at.b - at.a) * i / at.steps
    place = at.first + (at.last - at.first) * i / at.steps
    row = min(int(place), course.shape[0] - 2)
    low, high = course[row, TIME], course[row + 1, TIME]
    return float(min(at.b, max(at.a, low + (place - row) * (high - low))))
