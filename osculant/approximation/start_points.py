"""Where a spline of a closed curve without split points had best begin.

Every such spline with errors of at most l has a knot among the points from any s to the end of the longest
piece from s. And if the error of a piece grows with its arc (Propositions 3.3.4, 3.4.2), the end of n greedy
pieces, nextⁿ(s), grows with s. So if nextⁿ(s) − T < s, T being the period, then no start between these two
will do either: the first such starts, s, nextⁿ(s) − T, …, exclude all of them in a few steps.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

#: (start, level, number of pieces) → where longest pieces with errors of at most that level end, or beyond
Reach = Callable[[float, float, int], float]

#: how far below the error found no start is shown to have one, in parts of it, in turn
GAPS = (1e-1, 1e-2, 1e-3, 1e-4)
#: pieces that the proof may take, and the search for a start within a tolerance
WORK = 200_000
#: starts tried first, and steps of the search between them
SAMPLES, STEPS = 8, 20
#: starts excluded one by one before one that will do is looked for
FIRST_STEPS = 64
#: errors that agree to this part of them are the same
SAME = 1e-10
#: the golden section
GOLDEN = (math.sqrt(5) - 1) / 2


@dataclass(frozen=True)
class Start:
    """A parameter value to begin at, the error from there, and what is known of all others.

    No start has an error smaller than ``floor`` if errors grow with the arcs; 0 if nothing was shown.

    >>> Start(0.5, 1e-6, 0.999e-6).gap
    0.001
    """

    at: float
    error: float
    floor: float = 0.0

    @property
    def gap(self) -> float:
        """By which part the error may at most be larger than the best start's."""
        return round(1 - self.floor / self.error, 12) if self.error > 0 else 0.0


def best_start(
    error_from: Callable[[float], float],
    reach: Reach,
    low: float,
    period: float,
    count: int,
    resolution: float = 0.0,
    work: int = WORK,
) -> Start:
    """The start from which a given number of pieces have the least greatest error, with the gap to a proof.

    Args:
        error_from: the error of ``count`` pieces from a start, in [low, low + T], once round, all as equal
            as they can be.
        reach: see `Reach`.
        low: any start; the ones up to the end of the first piece from there are tried.
        period: T.
        count: the number of pieces.
        resolution: errors that differ by less cannot be told apart.
        work: pieces that the proof may take; the gap is wider if it is not enough.

    Returns:
        The best of all starts seen; its gap is 1e-4 if the work suffices.

    Pieces whose error is that of their length to the fourth power are best equal, from wherever:

    >>> def reach(start, level, pieces):
    ...     return start + pieces * level**0.25
    >>> start = best_start(lambda start: (1 / 3) ** 4, reach, 0.0, 1.0, 3)
    >>> round(start.error * 81, 12), start.gap
    (1.0, 0.0001)
    """

    def error_at(at: float) -> float:
        return error_from(_wrapped(at, low, period))

    first = error_from(low)
    end = min(reach(low, first, 1), low + period) if math.isfinite(first) else low + period
    best = _sampled(error_at, Start(low, first), end)
    if not math.isfinite(best.error):
        return best
    best = Start(_wrapped(best.at, low, period), best.error)
    end = min(reach(low, best.error, 1), low + period)
    for gap in GAPS:
        while gap * best.error >= resolution:
            level = best.error * (1 - gap)
            march = _march(partial(_at_level, reach, level, count), low, end, period, work // count)
            work -= march.steps * count
            if march.end <= low:
                best = Start(best.at, best.error, level)
                break
            if not march.met:
                return best
            found = _refined(error_at, Start(march.end, error_at(march.end)), (end - low) / SAMPLES)
            if not found.error < best.error:
                return best
            best = Start(_wrapped(found.at, low, period), found.error, best.floor)
    return best


def start_within(
    end_within: Callable[[float, int], float],
    beyond: Callable[[float, int], float],
    low: float,
    period: float,
    count: int,
    work: int = WORK,
) -> tuple[float | None, bool]:
    """A start from which so many pieces within a tolerance go once round.

    Args:
        end_within: (start, number of pieces) → where greedy pieces end, their errors within the tolerance.
        beyond: the same for errors no smaller than the tolerance: at least where the longest ones end.
        low: any start.
        period: T.
        count: the number of pieces.
        work: pieces that the search may take.

    Returns:
        (the start, True); (None, True) if no start will do, errors growing with the arcs; (None, False) if
        none was found, and the work did not suffice, or the accuracy of errors does not, to exclude all.

    >>> def reach(start, pieces):  # pieces of length 0.3
    ...     return start + 0.3 * pieces
    >>> start_within(reach, reach, 0.0, 1.0, 4), start_within(reach, reach, 0.0, 1.0, 3)
    ((0.0, True), (None, True))
    """

    def missing(at: float) -> float:
        at = _wrapped(at, low, period)
        return period + at - end_within(at, count)

    if count < 1:
        return None, True
    end = min(beyond(low, 1), low + period)
    if missing(low) <= 0:
        return low, True
    march = _march(lambda at: beyond(at, count), low, end, period, min(FIRST_STEPS, work // count))
    if march.end > low:
        best = _sampled(missing, Start(march.end, missing(march.end)), low)
        if best.error <= 0:
            return _wrapped(best.at, low, period), True
        if not march.met:
            march = _march(lambda at: beyond(at, count), low, march.end, period, work // count)
    return None, march.end <= low


def _wrapped(at: float, low: float, period: float) -> float:
    """The same start in [low, low + T]; unchanged if it is there."""
    return at if low <= at <= low + period else low + (at - low) % period


def _at_level(reach: Reach, level: float, count: int, at: float) -> float:
    return reach(at, level, count)


@dataclass(frozen=True)
class _March:
    """The excluded starts are those above ``end``; whether the pieces from there go round, and the steps."""

    end: float
    met: bool
    steps: int


def _march(reach: Callable[[float], float], low: float, high: float, period: float, steps: int) -> _March:
    """Exclude starts from ``high`` down, all to ``low`` or until one may do."""
    at = high
    for step in range(steps):
        if at <= low:
            return _March(at, False, step)
        back = reach(at) - period
        if not back < at:
            return _March(at, True, step + 1)
        at = back
    return _March(at, False, steps)


def _sampled(value: Callable[[float], float], first: Start, end: float) -> Start:
    """The start with the least value found between one that is known and ``end``."""
    step = (end - first.at) / SAMPLES
    samples = [first]
    samples += [Start(at, value(at)) for at in (first.at + i * step for i in range(1, SAMPLES))]
    best = min(samples, key=lambda start: start.error)
    if max(sample.error for sample in samples) - best.error <= SAME * abs(best.error):
        return best
    return _refined(value, best, abs(step))


def _refined(value: Callable[[float], float], known: Start, width: float) -> Start:
    """The least value found by golden sections around a known one; the value may be infinite."""
    low, high = known.at - width, known.at + width
    left, right = (Start(at, value(at)) for at in (high - GOLDEN * (high - low), low + GOLDEN * (high - low)))
    best = known
    for _ in range(STEPS):
        best = min(best, left, right, key=lambda start: start.error)
        if left.error <= right.error:
            high, right = right.at, left
            at = high - GOLDEN * (high - low)
            left = Start(at, value(at))
        else:
            low, left = left.at, right
            at = low + GOLDEN * (high - low)
            right = Start(at, value(at))
    return min(best, left, right, key=lambda start: start.error)
