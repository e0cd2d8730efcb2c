"""A given number of pieces on one stretch: the knots at which all errors are equal.

The error of an arc grows with the arc (Propositions 3.3.4, 3.4.2), so that if all pieces have the same error
no other knots make the largest error smaller. Knots start at equal content (Remark 3.6.7: content is what
theory integrates to the number of pieces); then the measured errors take the place of the density: an arc of
order p with the error e has the content e^{1/p}, spread evenly over it, and the knots move to equal contents.
"""

from __future__ import annotations

import math

import numpy as np

from osculant.approximation.runs import Floats, Part, Run, equal_shares

#: rounds of moving the knots; so many without a gain end them
ROUNDS, PATIENCE = 60, 3
#: errors that agree to this are equal
EQUAL = 1e-12
#: errors below so many times the noise are rounding, and not worth a round
ROUNDING = 4.0
#: errors that do not agree to this, or to so many times the rounding noise, have not settled
SETTLED, SETTLED_NOISE = 1e-9, 4.0
#: the level of greedy pieces is bracketed to this ratio, in so many steps, to start from; the errors of
#: pieces may be less than the level by this part
NARROW, STEPS, WINDOW = 1 + 1e-5, 80, 1e-6


def equalise(part: Part, count: int) -> Run:
    """The pieces of a stretch, ``count`` of them, with equal errors: the least greatest error.

    Args:
        part: the stretch.
        count: at least ``part.least``.

    Returns the best run seen: errors agree to about 1e-12 of them or to rounding noise, where the errors are
    monotone; whatever they are, the run is measured as any other. The same arguments give the same run.

    Source: thesis, Remark 3.6.7.
    """
    if part.exact or count == 1:
        return part.fitted(part.spread(count))
    run = _settled(part, part.spread(count))
    if not _is_equal(part, run):  # too coarse for theory's content: start from greedy pieces
        other = _settled(part, _greedy_knots(part, count))
        run = min(run, other, key=lambda run: run.error)
    return run


def _is_equal(part: Part, run: Run) -> bool:
    gap = run.error - float(run.errors.min())  # NaN if all are infinite
    return math.isfinite(gap) and gap <= max(SETTLED * run.error, SETTLED_NOISE * part.noise)


def _settled(part: Part, knots: Floats) -> Run:
    """Move the knots until the errors are equal, or no longer get more so; less far where that failed."""
    best = part.fitted(knots)
    if not math.isfinite(best.error):
        return best
    way, stale = 1.0, 0
    for _ in range(ROUNDS):
        gap = best.error - float(best.errors.min())
        if gap <= EQUAL * best.error or best.error <= ROUNDING * part.noise or stale == PATIENCE:
            break
        moved = best.knots + way * (_equal_content(best, part.order) - best.knots)
        moved[0], moved[-1] = best.knots[0], best.knots[-1]
        if not (np.diff(moved) > 0).all():
            break
        run = part.fitted(moved)
        if run.error < best.error:
            best, way, stale = run, min(1.0, 2.0 * way), 0
        else:
            way, stale = 0.25 * way, stale + 1
    return best


def _equal_content(run: Run, order: int) -> Floats:
    """Knots of equal content, if every piece had its content spread evenly."""
    contents = run.errors ** (1.0 / order)
    total = np.concatenate([[0.0], np.cumsum(contents)])
    return equal_shares(run.knots, total, len(run))


def _greedy_knots(part: Part, count: int) -> Floats:
    """Knots of greedy pieces at the least level where there are ``count`` of them, or, cut, so many."""
    best = part.greedy(math.inf, math.inf)
    low, high = part.noise, best.error
    for _ in range(STEPS):
        if high <= low * NARROW:
            break
        level = math.sqrt(low * high)
        run = part.greedy(level * (1 - WINDOW), level)
        if len(run) <= count:
            best, high = run, min(level, run.error)
        else:
            low = level
    knots = best.knots
    while len(knots) <= count:  # cut the longest
        i = int(np.argmax(np.diff(knots)))
        knots = np.insert(knots, i + 1, 0.5 * (knots[i] + knots[i + 1]))
    return knots
