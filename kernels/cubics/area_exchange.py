"""The fast step for areas: the cubic that crosses the curve twice, at canonical points.

The area is least where sign d is orthogonal to both changes of d with the arms, ∫ sign d (1 − κd) ∂d ds = 0:
two equations for the two crossings.  Two samples give the arms that cross there; the equations' residuals
then move the crossings by a Newton step, in which the arms' influence on ∂d is left out.  The area depends on
the square of what is missing.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from osculant.kernels.cubics.area_scan import swept
from osculant.kernels.cubics.arms import Ends, ends_of, reach, see
from osculant.kernels.cubics.exchange import Arms, limited
from osculant.kernels.cubics.scan import Space
from osculant.kernels.cubics.starts import starts
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.generated import cubics as generated
from osculant.kernels.jit import kernel


class AreaTrail(NamedTuple):
    """What the fast steps of one arc leave for the next.

    Attributes:
        first, last: places of the crossings, in parts of the arc.
        mean, half: mean and half difference of the arms over `arms.reach`; NaN if nothing is known.
        length: of the arc, in the parameter.
    """

    first: float
    last: float
    mean: float
    half: float
    length: float


class Crossed(NamedTuple):
    """A cubic that crosses twice: its area, NaN if there is none, its arms, and where."""

    area: float
    a0: float
    a3: float
    first: float
    last: float
    settled: bool


#: Newton steps for arms, of crossings, and the residual in parts of the first that is none
STEPS, ROUNDS, NONE = 10, 6, 1e-9
#: the rule of `gauss` between crossings
RULE = 1.0
#: crossings that the arms can hardly move relative to one another are no two
SINGULAR = 1e-9
#: a crossing moves at most this part of the arc at once, and stays inside these margins
LARGEST_MOVE, MARGIN = 0.05, 0.02
#: the area's relative loss is about this times the square of a crossing's displacement
LOSS = 200.0
#: areas in parts of the chosen one's of rivals that are worth a measurement, and what they are settled to
BETTER, LIKELY = 0.999, 1e-3


@kernel
def begin(fit: Any) -> AreaTrail:
    """Crossings of a short arc, and no arms."""
    return AreaTrail(generated.CROSSING, 1.0 - generated.CROSSING, math.nan, math.nan, math.nan)


@kernel
def crossing_at(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float, first: float, last: float
) -> tuple[float, float]:
    """The arms of the cubic that crosses the curve at two places, from arms nearby; NaN if none is found."""
    one_at, two_at = sample(source, a + first * (b - a)), sample(source, a + last * (b - a))
    foot1, foot2, before = first, last, math.inf
    for _ in range(STEPS):
        one, two = see(ends, a0, a3, one_at, foot1), see(ends, a0, a3, two_at, foot2)
        away = abs(one.d) + abs(two.d)
        minor = one.by0 * two.by3 - two.by0 * one.by3
        if not abs(minor) > SINGULAR * (abs(one.by0 * two.by3) + abs(two.by0 * one.by3)):
            return math.nan, math.nan
        by0 = (two.d * one.by3 - one.d * two.by3) / minor
        by3 = (one.d * two.by0 - two.d * one.by0) / minor
        a0, a3 = limited(a0, by0), limited(a3, by3)
        if abs(by0) + abs(by3) <= NONE * (a0 + a3) or (away <= source.place.noise and away >= before):
            return a0, a3
        foot1, foot2, before = one.foot, two.foot, away
    return math.nan, math.nan


@kernel
def crossed(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float,
    first: float, last: float, calm: float,
) -> Crossed:  # fmt: skip
    """The cubic of least area among those that cross twice near the given places, settled to ``calm``."""
    h, area = b - a, math.nan
    for _ in range(ROUNDS):
        a0, a3 = crossing_at(source, a, b, ends, a0, a3, first, last)
        if math.isnan(a0):
            break
        t1, t2 = a + first * h, a + last * h
        one = swept(source, ends, a0, a3, a, t1, 0.0, RULE)
        two = swept(source, ends, a0, a3, t1, t2, one.foot, RULE)
        three = swept(source, ends, a0, a3, t2, b, two.foot, RULE)
        area = abs(one.area) + abs(two.area) + abs(three.area)
        if not area > 0.0:
            break
        at1, at2 = sample(source, t1), sample(source, t2)
        seen1, seen2 = see(ends, a0, a3, at1, first), see(ends, a0, a3, at2, last)
        w1, w2 = 2.0 * h * at1.speed, 2.0 * h * at2.speed
        off0, off3 = one.by0 - two.by0 + three.by0, one.by3 - two.by3 + three.by3
        j10, j13, j20, j23 = w1 * seen1.by0, w1 * seen1.by3, -w2 * seen2.by0, -w2 * seen2.by3
        minor = j10 * j23 - j20 * j13
        move1 = (off3 * j20 - off0 * j23) / minor
        move2 = (off0 * j13 - off3 * j10) / minor
        if not (abs(move1) < math.inf and abs(move2) < math.inf):
            break
        move1 = min(LARGEST_MOVE, max(-LARGEST_MOVE, move1))
        move2 = min(LARGEST_MOVE, max(-LARGEST_MOVE, move2))
        first, last = max(MARGIN, first + move1), min(1.0 - MARGIN, last + move2)
        if not last > first:
            break
        if LOSS * (move1 * move1 + move2 * move2) <= calm:
            return Crossed(area, a0, a3, first, last, True)
    return Crossed(math.nan, a0, a3, first, last, False)


@kernel
def from_starts(
    source: Source, a: float, b: float, ends: Ends, below: float, calm: float, space: Space
) -> Crossed:
    """The best cubic below an area near those with the arc's area and moment; its area NaN if none is."""
    arms = space.arms
    sure, _ = starts(source, a, b, ends, space.rows, space.zeros, arms)
    found = Crossed(math.nan, math.nan, math.nan, math.nan, math.nan, False)
    for i in range(sure):
        x, y = generated.CROSSING, 1.0 - generated.CROSSING
        other = crossed(source, a, b, ends, arms[i, 0], arms[i, 1], x, y, calm)
        if other.area < below:
            found, below = other, other.area
    return found


@kernel
def visit(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    trail: AreaTrail, calm: float, space: Space,
) -> tuple[float, Arms, bool, AreaTrail]:  # fmt: skip
    """(area, arms, settled, trail) of the cubic of the arc [a, b] that crosses twice.

    The area is NaN if it is not found fast.
    """
    h, ends = b - a, ends_of(start, end)
    unit = reach(ends)
    found = Crossed(math.nan, math.nan, math.nan, math.nan, math.nan, False)
    if trail.mean > 0.0:
        ratio = h / trail.length
        mean = 1.0 + (trail.mean - 1.0) * min(4.0, ratio * ratio)
        half = trail.half * min(2.0, ratio)
        if mean - abs(half) > 0.0:
            a0, a3 = unit * (mean + half), unit * (mean - half)
            found = crossed(source, a, b, ends, a0, a3, trail.first, trail.last, calm)
    if math.isnan(found.area):
        found = from_starts(source, a, b, ends, math.inf, calm, space)
    mean, half = 0.5 * (found.a0 + found.a3) / unit, 0.5 * (found.a0 - found.a3) / unit
    moved = AreaTrail(found.first, found.last, mean, half, h)
    return found.area, Arms(found.a0, found.a3), found.settled, moved
