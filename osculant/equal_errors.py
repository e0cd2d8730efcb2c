"""A given number of pieces on one stretch: the knots at which all errors are equal.

The error of an arc grows with the arc (Propositions 3.3.4, 3.4.2), so that if all pieces have the same error
no other knots make the largest error smaller. Knots start at equal content (Remark 3.6.7: content is what
theory integrates to the number of pieces); then the measured errors take the place of the density: an arc of
order p with the error e has the content e^{1/p}, spread evenly over it, and the knots move to equal contents.
"""

from __future__ import annotations

import math

import numpy as np

from osculant.runs import Floats, Part, Run

#: rounds of moving the knots; so many without a gain end them
ROUNDS, PATIENCE = 60, 3
#: errors that agree to this are equal
EQUAL = 1e-12
#: errors below so many times the noise are rounding, and not worth a round
ROUNDING = 4.0
#: errors that do not agree to this, or to so many times the rounding noise, have not settled
SETTLED, SETTLED_NOISE = 1e-9, 4.0
#: the level of greedy pieces is bracketed to this ratio, in so many steps, to start from
NARROW, STEPS = 1.05, 80


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
    gap = run.error - float(run.errors.min())
    return gap <= max(SETTLED * run.error, SETTLED_NOISE * part.noise)


def _settled(part: Part, knots: Floats) -> Run:
    """Move the knots until the errors are equal, or no longer get more so; less far where that failed."""
    best = part.fitted(knots)
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
    finite = np.isfinite(contents)
    if not finite.any():
        contents = np.ones_like(contents)
    elif not finite.all():  # too long for a piece: how much too long is not known
        contents = np.where(finite, contents, 2.0 * contents[finite].max())
    total = np.concatenate([[0.0], np.cumsum(contents)])
    knots = np.interp(np.linspace(0.0, total[-1], len(total)), total, run.knots)
    knots[0], knots[-1] = run.knots[0], run.knots[-1]
    return knots


def _greedy_knots(part: Part, count: int) -> Floats:
    """Knots of greedy pieces at a level where there are ``count`` of them, or, cut in two, so many."""
    low, high = 0.0, math.inf
    errors = part.fitted(part.spread(count)).errors
    level = max(float(min(errors[np.isfinite(errors)], default=1.0)), 16 * part.noise)
    run = part.greedy(level / NARROW, level)
    for _ in range(STEPS):
        if len(run) == count:
            break
        if len(run) > count:
            low = level
        else:
            high = level
        if high < low * NARROW:
            break
        level = math.sqrt(low * high) if low > 0.0 and high < math.inf else level * (4.0 if low else 0.25)
        run = part.greedy(level / NARROW, level)
    knots = run.knots
    while len(knots) <= count:  # cut the longest
        i = int(np.argmax(np.diff(knots)))
        knots = np.insert(knots, i + 1, 0.5 * (knots[i] + knots[i + 1]))
    return knots if len(knots) == count + 1 else part.spread(count)
