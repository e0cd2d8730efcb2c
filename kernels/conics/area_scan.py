"""The careful step of the area metric: areas by adaptive panels, whatever the number of crossings.

A panel carries a Legendre series of the strip; it is halved while the terms left out may exceed `ACCURACY`
of the whole area and rounding, or while the curve turns much between neighbouring nodes, where samples are
blind.  So the area's relative error is about `ACCURACY`, as far as series decay as they seem to: an estimate,
not a certificate.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from osculant.kernels.conics.area_exchange import WHOLE, halfway
from osculant.kernels.conics.pencil import (
    Pencil,
    is_flat,
    is_proper,
    parabola,
    pencil,
    through,
    weight,
    within_noise,
)
from osculant.kernels.conics.scan import (
    LARGEST_PART,
    LARGEST_TURN,
    TOLD,
    at_row,
    look,
    members_through,
)
from osculant.kernels.conics.strip import (
    BY_Q,
    N2,
    SERIES,
    SINE,
    STRIP,
    Lanes,
    fill,
    lanes_of,
    sample_panel,
    through_node,
)
from osculant.kernels.conics.strip_series import COUNTS, WEIGHTS, expand, tail, unsigned
from osculant.kernels.curves.peaks import DEPTH, Space
from osculant.kernels.curves.plane import Frame, Source
from osculant.kernels.jit import kernel

#: a part of an arc, and the numbers of nodes (indices) of a panel and of a whole arc
PANEL, PANEL_LEVEL, WHOLE_LEVEL = 0, 3, 3
#: relative accuracy of areas, and panels in all; units of noise that a tail may have
ACCURACY, MOST_PANELS, ROUNDING = 1e-12, 400, 1.0
#: rounds of the search for Q; the signed area in parts of the area, or the bracket in parts of Q, ending it
ROUNDS, EVEN = 80, 1e-13
#: members among which the least area is looked for, and golden sections
GRID_Q, SECTIONS = 24, 45
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


class Areas(NamedTuple):
    """Signed area, its derivative by Q, and area.

    The first is NaN if a normal misses the member, and the last then is positive if Q is too large, negative
    if it is too small, and NaN if that helps nothing.
    """

    signed: float
    by_q: float
    area: float


@kernel
def turns_much(
    cosine: float, sine: float, lanes: Lanes, count: int, largest: float
) -> tuple[bool, float, float]:
    """Whether tangents of neighbouring nodes differ much, from a tangent before the first; the last one's."""
    for i in range(count):
        cosine_here, sine_here = lanes[N2, i], lanes[SINE, i]
        across, along = cosine * sine_here - sine * cosine_here, cosine * cosine_here + sine * sine_here
        if across > largest or along < 0.0:
            return True, cosine, sine
        cosine, sine = cosine_here, sine_here
    return False, cosine, sine


@kernel
def largest_turn(pen: Pencil) -> float:
    """The sine of the angle by which tangents of neighbouring nodes may differ (`scan.look`)."""
    cosine, sine = pen.tx0 * pen.tx2 + pen.ty0 * pen.ty2, pen.sin_psi
    largest = math.sin(LARGEST_TURN)
    if cosine > 0.0 and sine > 0.0:
        return min(largest, max(TOLD, LARGEST_PART * sine))
    return largest


@kernel
def summed(count: int, order: int, level: int, lanes: Lanes) -> tuple[float, float]:
    """(signed area, its derivative by Q) of a panel."""
    signed, by_q = 0.0, 0.0
    for i in range(count):
        share = WEIGHTS[order, level, i]
        signed += share * lanes[STRIP, i]
        by_q += share * lanes[BY_Q, i]
    return signed, by_q


@kernel
def in_panels(pen: Pencil, q: float, source: Source, a: float, b: float, size: float, space: Space) -> Areas:
    """Areas of the member Q by panels, for a whole area of about ``size``."""
    lanes, pending = lanes_of(space), space[1][:, 0]
    count, largest = COUNTS[PANEL_LEVEL], largest_turn(pen)
    signed, by_q, area = 0.0, 0.0, 0.0
    low, cosine, sine = a, 1.0, 0.0
    pending[0] = b
    open_ends = 1
    for _ in range(MOST_PANELS):
        if open_ends == 0:
            return Areas(signed, by_q, area)
        high = pending[open_ends - 1]
        sample_panel(pen, source, low, high, PANEL, PANEL_LEVEL, lanes)
        much, next_cosine, next_sine = turns_much(cosine, sine, lanes, count, largest)
        if not much:
            missing = fill(pen, q, count, lanes)
            if missing > 0:
                return Areas(math.nan, math.nan, q - through_node(lanes, missing - 1))
            series = lanes[SERIES]
            expand(PANEL, PANEL_LEVEL, lanes[STRIP], series)
            rest = tail(PANEL, count, series) - ROUNDING * pen.noise * pen.chord * (high - low) / (b - a)
            much = not rest <= ACCURACY * size
        if much and open_ends < DEPTH:
            pending[open_ends] = 0.5 * (low + high)
            open_ends += 1
            continue
        if much:
            return Areas(math.nan, math.nan, math.nan)
        more, more_by_q = summed(count, PANEL, PANEL_LEVEL, lanes)
        signed, by_q = signed + more, by_q + more_by_q
        part, _ = unsigned(PANEL, PANEL_LEVEL, lanes[STRIP], lanes[SERIES])
        area += part
        low, cosine, sine = high, next_cosine, next_sine
        open_ends -= 1
    return Areas(math.nan, math.nan, math.nan)


@kernel
def areas(pen: Pencil, q: float, source: Source, a: float, b: float, space: Space) -> Areas:
    """Areas of the member Q over [a, b]: one panel of the whole arc where that will do."""
    lanes = lanes_of(space)
    count = COUNTS[WHOLE_LEVEL]
    sample_panel(pen, source, a, b, WHOLE, WHOLE_LEVEL, lanes)
    much, _, _ = turns_much(1.0, 0.0, lanes, count, largest_turn(pen))
    missing = fill(pen, q, count, lanes)
    if missing > 0 and not much:
        return Areas(math.nan, math.nan, q - through_node(lanes, missing - 1))
    size = 0.0
    if missing == 0:
        series = lanes[SERIES]
        expand(WHOLE, WHOLE_LEVEL, lanes[STRIP], series)
        size, _ = unsigned(WHOLE, WHOLE_LEVEL, lanes[STRIP], series)
        if not much and tail(WHOLE, count, series) <= ACCURACY * size + ROUNDING * pen.noise * pen.chord:
            signed, by_q = summed(count, WHOLE, WHOLE_LEVEL, lanes)
            return Areas(signed, by_q, size)
    result = in_panels(pen, q, source, a, b, size, space)
    if result.area < 0.5 * size:  # panels have to be finer than it seemed
        result = in_panels(pen, q, source, a, b, result.area, space)
    return result


@kernel
def measure(pen: Pencil, q: float, source: Source, a: float, b: float, space: Space) -> float:
    """The area between the arc and the member Q over [a, b]; Q = 0 is the chord.

    The area is ∫|d(1 − κd/2)|ds along the curve's normals: that of the regions between the two as long as
    |κd| < 2, and an upper bound where the member passes so far beyond the curve's centres.  Infinite if a
    normal misses the arc of the member, or if doubles do not reach the accuracy.
    """
    signed, _, area = areas(pen, q, source, a, b, space)
    return area if math.isfinite(signed) else math.inf


@kernel
def even(
    pen: Pencil, source: Source, a: float, b: float, low: float, high: float, space: Space
) -> tuple[float, float]:  # fmt: skip
    """(area, Q) with the signed area 0, Q in [low, high]: Newton's method within the bracket.

    d and so the signed area fall as Q grows, at every point of an arc that bends to the left.
    """
    q, area = 0.5 * (low + high), math.inf
    for _ in range(ROUNDS):
        signed, by_q, area = math.nan, math.nan, 1.0  # an unbounded arc: w < 0 falls with Q
        if weight(pen, q) > -1.0:
            signed, by_q, area = areas(pen, q, source, a, b, space)
        if math.isnan(signed):
            if math.isnan(area):  # neither way helps
                return math.inf, math.nan
            too_large, area = area > 0.0, math.inf
        else:
            if abs(signed) <= EVEN * area or high - low <= EVEN * high:
                break
            too_large = signed < 0.0
        if too_large:
            high = q
        else:
            low = q
        step = q - signed / by_q
        before, q = q, step if low < step < high else 0.5 * (low + high)
        if q == before:
            break
    return area, q


@kernel
def bounded_area(pen: Pencil, q: float, source: Source, a: float, b: float, space: Space) -> float:
    """`measure` for a member whose arc may be unbounded."""
    return measure(pen, q, source, a, b, space) if weight(pen, q) > -1.0 else math.inf


@kernel
def least(
    pen: Pencil, source: Source, a: float, b: float, low: float, high: float, space: Space
) -> tuple[float, float]:  # fmt: skip
    """(area, Q) of the member of least area, Q in [low, high]: golden sections about the best of a grid.

    With one crossing the area is convex enough to have one minimum; with several there may be more, and the
    best of `GRID_Q` members chooses among them.  Near its minimum the area is flat: Q is known to half its
    digits.
    """
    step, best_q, least_seen = (high - low) / GRID_Q, math.nan, math.inf
    for i in range(GRID_Q + 1):
        q = low + i * step
        area = bounded_area(pen, q, source, a, b, space)
        if area < least_seen:
            least_seen, best_q = area, q
    if not least_seen < math.inf:
        return math.inf, math.nan
    low, high = max(low, best_q - step), min(high, best_q + step)
    x, y = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_x, at_y = bounded_area(pen, x, source, a, b, space), bounded_area(pen, y, source, a, b, space)
    for _ in range(SECTIONS):
        if at_x <= at_y:
            high, y, at_y = y, x, at_x
            x = high - GOLDEN * (high - low)
            at_x = bounded_area(pen, x, source, a, b, space)
        else:
            low, x, at_x = x, y, at_y
            y = low + GOLDEN * (high - low)
            at_y = bounded_area(pen, y, source, a, b, space)
    return (at_x, x) if at_x <= at_y else (at_y, y)


@kernel
def best_parabola(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(area, Q) of the parabola of the arc [a, b]; the area is infinite if there is none.

    Q = 0 is the chord, of an arc that is straight to rounding.
    """
    pen = pencil(start, end, source.place.noise)
    if is_flat(pen):
        return measure(pen, 0.0, source, a, b, space), 0.0
    if not is_proper(pen):
        return math.inf, math.nan
    q = parabola(pen)
    if math.isnan(q):
        return math.inf, math.nan
    return measure(pen, q, source, a, b, space), q


@kernel
def bracket(
    pen: Pencil, source: Source, a: float, b: float, points: int, space: Space
) -> tuple[float, float]:
    """(least, greatest) Q of members through points of the arc; (0, 0) if there are none."""
    if not is_proper(pen):
        return 0.0, 0.0
    count = look(pen, source, a, b, points, space)
    return members_through(pen, space, count) if count > 0 else (0.0, 0.0)


@kernel
def best_equal(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(area, Q) of the conic whose moons are equal, as `best_parabola`."""
    pen = pencil(start, end, source.place.noise)
    if is_flat(pen):
        return measure(pen, 0.0, source, a, b, space), 0.0
    low, high = bracket(pen, source, a, b, points, space)
    return even(pen, source, a, b, low, high, space) if low > 0.0 else (math.inf, math.nan)


@kernel
def best_least(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(area, Q) of the conic of least area, as `best_parabola`.

    Where samples see it cross the arc once the linear form tells it; else it is searched for.
    """
    pen = pencil(start, end, source.place.noise)
    if is_flat(pen):
        return measure(pen, 0.0, source, a, b, space), 0.0
    if not is_proper(pen):
        return math.inf, math.nan
    q, _ = halfway(pen, source, a, b)
    count = look(pen, source, a, b, points, space)
    low, high = members_through(pen, space, count) if count > 0 else (0.0, 0.0)
    if not low > 0.0:
        return math.inf, math.nan
    if q > 0.0 and weight(pen, q) > -1.0 and is_monotone(pen, space, count):
        area = measure(pen, q, source, a, b, space)
        if area < math.inf:
            return area, q
    return least(pen, source, a, b, low, high, space)


@kernel
def is_monotone(pen: Pencil, space: Space, count: int) -> bool:
    """Whether Q of the members through the samples goes one way: then each crosses the arc once at most."""
    before, way = math.nan, 0.0
    for i in range(count):
        seen = at_row(space[0], i)
        if within_noise(pen, seen):  # says nothing
            continue
        q = through(seen)
        if (q - before) * way < 0.0:
            return False
        if q != before and not math.isnan(before):
            way = q - before
        before = q
    return way != 0.0


@kernel
def confirm(
    fit: Any,
    q: float,
    source: Source,
    a: float,
    start: Frame,
    b: float,
    end: Frame,
    points: int,
    space: Space,
) -> tuple[float, float]:
    """(area, Q) of the member Q, measured."""
    return measure(pencil(start, end, source.place.noise), q, source, a, b, space), q
