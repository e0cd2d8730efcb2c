"""The fast step: the cubic whose displacement has three equal peaks of alternating sign.

Newton's method for both arms and the level, from three samples of the curve; the peaks move by Newton steps
of their own.  Arms, in parts of those of a circular arc, and places of peaks change slowly from arc to arc,
so the caller keeps them as a `Trail`; without one, or where it leads nowhere, all cubics with the arc's area
and moment are tried.  Nothing is bracketed here: a result is kept only after it is measured (`scan`), and
the search has `minimax` to fall back on.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from osculant.kernels.cubics.arms import Ends, Seen, ends_of, reach, see
from osculant.kernels.cubics.scan import Space
from osculant.kernels.cubics.starts import starts
from osculant.kernels.curves.peaks import within_reason
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.generated import cubics as generated
from osculant.kernels.jit import kernel


class Trail(NamedTuple):
    """What the fast steps of one arc leave for the next.

    Attributes:
        first, middle, last: places of the peaks, in parts of the arc.
        mean, half: mean and half difference of the arms over `arms.reach`; NaN if nothing is known.
        length: of the arc, in the parameter.
    """

    first: float
    middle: float
    last: float
    mean: float
    half: float
    length: float


class Level(NamedTuple):
    """A cubic with three nearly equal peaks: their height, NaN if there is none, and their places."""

    error: float
    a0: float
    a3: float
    first: float
    middle: float
    last: float
    settled: bool


class Arms(NamedTuple):
    """The choice of a cubic, and all that is recorded of it."""

    a0: float
    a3: float


#: Newton steps of one arc, and how uneven peaks may be at last without being called none
ROUNDS, UNEVEN = 14, 0.3
#: peaks are moved where they are uneven by less, and their heights corrected where that is by less
ROUGH, FINE = 1.0, 0.15
#: an arm changes at most by this factor in one step
FACTOR = 2.0
#: peaks whose level the arms can hardly change relative to one another are no three
SINGULAR = 1e-6
#: corrections of heights are squared by one more step, so they may be larger than what is asked for
SQUARED = 10.0
#: units of noise to which peaks can be levelled
LEVELLED = 16.0
#: unevenness and error, in parts of the chosen one's, of rivals that are worth a measurement
LIKELY, BETTER = 0.05, 0.999


@kernel
def begin(fit: Any) -> Trail:
    """Peaks of a short arc, and no arms."""
    return Trail(generated.FIRST, 0.5, generated.LAST, math.nan, math.nan, math.nan)


@kernel
def height(seen: Seen, h: float, sharpness: float) -> float:
    """The extreme value near a sample, if that is believable."""
    gain = 0.5 * (seen.slope * h) ** 2 / (sharpness * seen.d)
    return seen.d + gain if abs(gain) < FINE * abs(seen.d) else seen.d


@kernel
def moved(place: float, seen: Seen, h: float, sharpness: float) -> float:
    """The peak's place after one Newton step, kept within reason."""
    return within_reason(place, seen.slope * h / (sharpness * seen.d))


@kernel
def limited(arm: float, step: float) -> float:
    """The arm after a step that is not too large."""
    return min(FACTOR * arm, max(arm / FACTOR, arm + step))


@kernel
def level(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float,
    first: float, middle: float, last: float, calm: float,
) -> Level:  # fmt: skip
    """The cubic with three equal peaks near the given arms and places, level to the part ``calm``."""
    h = b - a
    outer, inner = generated.OUTER_SHARPNESS, generated.MIDDLE_SHARPNESS
    error, uneven = math.nan, math.inf
    floor = LEVELLED * source.place.noise
    for _ in range(ROUNDS):
        one = see(ends, a0, a3, sample(source, a + first * h), first)
        two = see(ends, a0, a3, sample(source, a + middle * h), middle)
        three = see(ends, a0, a3, sample(source, a + last * h), last)
        d1, d2, d3 = height(one, h, outer), height(two, h, inner), height(three, h, outer)
        # the combination of the three in which both arms drop out, to first order
        w1 = two.by0 * three.by3 - three.by0 * two.by3
        w2 = three.by0 * one.by3 - one.by0 * three.by3
        w3 = one.by0 * two.by3 - two.by0 * one.by3
        total = w1 - w2 + w3
        if not abs(total) > SINGULAR * (abs(w1) + abs(w2) + abs(w3)):  # NaN, too
            return Level(math.nan, a0, a3, first, middle, last, False)
        error = (w1 * d1 + w2 * d2 + w3 * d3) / total
        up1, up2, up3 = error - d1, -error - d2, error - d3
        if abs(w2) >= abs(w1) and abs(w2) >= abs(w3):  # solved from the other two
            by_a0, by_a3 = (up3 * one.by3 - up1 * three.by3) / w2, (up1 * three.by0 - up3 * one.by0) / w2
        elif abs(w1) >= abs(w3):
            by_a0, by_a3 = (up2 * three.by3 - up3 * two.by3) / w1, (up3 * two.by0 - up2 * three.by0) / w1
        else:
            by_a0, by_a3 = (up1 * two.by3 - up2 * one.by3) / w3, (up2 * one.by0 - up1 * two.by0) / w3
        size = abs(error) + 1e-300
        uneven = max(abs(up1), abs(up2), abs(up3)) / size
        gains = max(abs(d1 / one.d - 1.0), abs(d2 / two.d - 1.0), abs(d3 / three.d - 1.0))
        a0, a3 = limited(a0, by_a0), limited(a3, by_a3)
        if uneven < ROUGH:
            first, last = moved(first, one, h, outer), moved(last, three, h, outer)
            middle = moved(middle, two, h, inner)
        noise = floor / size
        if uneven <= max(calm, noise) and gains <= max(SQUARED * calm, noise):
            return Level(abs(error), a0, a3, first, middle, last, True)
    if not uneven < UNEVEN:
        error = math.nan
    return Level(abs(error), a0, a3, first, middle, last, False)


@kernel
def trail_of(found: Level, ends: Ends, h: float) -> Trail:
    """What a level leaves for the next arc."""
    unit = reach(ends)
    mean, half = 0.5 * (found.a0 + found.a3) / unit, 0.5 * (found.a0 - found.a3) / unit
    return Trail(found.first, found.middle, found.last, mean, half, h)


@kernel
def visit(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    trail: Trail, calm: float, space: Space,
) -> tuple[float, Arms, bool, Trail]:  # fmt: skip
    """(error, arms, settled, trail) of the best cubic of the arc [a, b] with three peaks that is found fast.

    The error is NaN if there is none.
    """
    h, ends = b - a, ends_of(start, end)
    found = Level(math.nan, math.nan, math.nan, math.nan, math.nan, math.nan, False)
    if trail.mean > 0.0:
        ratio = h / trail.length
        unit = reach(ends)
        mean = 1.0 + (trail.mean - 1.0) * min(4.0, ratio * ratio)
        half = trail.half * min(2.0, ratio)
        if mean - abs(half) > 0.0:
            found = level(
                source, a, b, ends, unit * (mean + half), unit * (mean - half),
                trail.first, trail.middle, trail.last, calm,
            )  # fmt: skip
    if math.isnan(found.error):
        arms = space.arms
        sure, _ = starts(source, a, b, ends, space.rows, space.zeros, arms)
        for i in range(sure):
            other = level(
                source, a, b, ends, arms[i, 0], arms[i, 1], generated.FIRST, 0.5, generated.LAST, calm
            )
            if not other.error >= found.error and not math.isnan(other.error):
                found = other
    return found.error, Arms(found.a0, found.a3), found.settled, trail_of(found, ends, h)


@kernel
def likely_rival(
    source: Source, a: float, b: float, ends: Ends, error: float, space: Space
) -> tuple[Level, int, int]:
    """(cubic, sure, count): one near the arc's area and moment, with three peaks below the error.

    Its error is NaN if there is none.  The starts are left in ``space``: those from ``sure`` to ``count`` are
    near places where two have merged, and what is there has no three peaks.
    """
    best = Level(math.nan, math.nan, math.nan, math.nan, math.nan, math.nan, False)
    arms = space.arms
    sure, count = starts(source, a, b, ends, space.rows, space.zeros, arms)
    for i in range(sure):
        other = level(
            source, a, b, ends, arms[i, 0], arms[i, 1], generated.FIRST, 0.5, generated.LAST, LIKELY
        )
        lower = error if math.isnan(best.error) else best.error
        if other.error < BETTER * lower:
            best = other
    return best, sure, count
