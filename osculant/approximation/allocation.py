"""How many pieces each stretch gets: for a given number of pieces in all, or for an error of each piece.

Stretches are independent but for the number of pieces they share. The least greatest error for N pieces is
had by giving each stretch as few as the same error level allows; pieces left over go, one at a time, to the
stretch with the largest error.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from osculant.approximation.equal_errors import equalise
from osculant.approximation.runs import Part, Progress, Run, share, whole_error
from osculant.cas.errors import DomainError, UndecidedError

#: greedy pieces are checked for one too many only up to so many of them
CHECKED_PIECES = 20_000
#: a last piece that is less than this part of a full one is looked at in any case
CLOSE = 0.02
#: bisections of the level, and the ratio that ends them
STEPS, NARROW = 200, 1e-9
#: the errors of pieces at a level may be less by this part of it
WINDOW = 1e-7


def fewest(
    part: Part, low: float, high: float, tolerance: float, progress: Progress | None = None
) -> tuple[Run, bool]:
    """(the fewest pieces of a stretch with errors up to the tolerance, whether that is certain).

    Greedy pieces have errors in [low, high]; where that window, a little below the tolerance, may have cost a
    piece, the least greatest error of one piece less decides.
    """
    run = part.greedy(low, high, progress)
    if not may_be_less(part, run, low, high, tolerance) or len(run) <= part.least:
        return run, not run.limited
    if len(run) > CHECKED_PIECES:
        return run, False
    less = equalise(part, len(run) - 1)
    return (less if less.error <= tolerance else run), not run.limited


def fewer(part: Part, run: Run, tolerance: float, few: int) -> Run:
    """The run, or fewer pieces where errors that fall as arcs grow have ended greedy pieces early.

    So it is sought if there are at most ``few``.
    """
    while not part.exact and part.least < len(run) <= few:
        less = equalise(part, len(run) - 1)
        if less.error > tolerance:
            break
        run = less
    return run


def fewer_in_all(parts: Sequence[Part], runs: Sequence[Run], tolerance: float) -> list[Run] | None:
    """The fewest pieces with areas of at most the tolerance in all; None if no fewer than in the runs.

    Among so many pieces those with the least largest area, as `given_pieces` finds them: the first to be left
    out is the one without which the largest area of its stretch is least.
    """
    found = None
    counts = [len(run) for run in runs]
    seen: dict[tuple[int, int], Run] = {}

    def equal(i: int, count: int) -> Run:
        if (i, count) not in seen:
            seen[i, count] = runs[i] if parts[i].exact else equalise(parts[i], count)
        return seen[i, count]

    def error_without(i: int) -> float:
        return equal(i, counts[i] - 1).error

    while shrinking := [i for i, part in enumerate(parts) if not part.exact and counts[i] > part.least]:
        counts[min(shrinking, key=error_without)] -= 1
        less = [equal(i, count) for i, count in enumerate(counts)]
        if not whole_error(less, 2) <= tolerance:
            break
        found = less
    return found


def may_be_less(part: Part, run: Run, low: float, high: float, level: float) -> bool:
    """Whether the window [low, high] below the level may have cost a greedy run its last piece."""
    if part.exact or len(run) == 1:
        return False
    if run.early:
        return True
    slack = len(run) * (1 - low / level) / part.order
    before, knot, end = map(float, run.knots[-3:])
    last = (end - knot) / (knot - before)  # of a very short piece the error says nothing
    return min(share(float(run.errors[-1]), high, part.order), last) <= max(2 * slack, CLOSE)


def given_pieces(parts: Sequence[Part], count: int) -> list[Run]:
    """The runs of ``count`` pieces in all with the least greatest error; in each stretch all are equal.

    Raises DomainError, saying the least number, if the stretches need more, and UndecidedError if so many
    were not found.
    """
    check_least(parts, count)
    counts = [count]
    if len(parts) > 1:
        counts = _counts(parts, count)
    runs = [equalise(part, n) for part, n in zip(parts, counts, strict=True)]
    for _ in range(count - sum(counts)):  # errors equal in two stretches: no level has this number of pieces
        worst = max(range(len(runs)), key=lambda i: (runs[i].error, -len(runs[i])))
        runs[worst] = equalise(parts[worst], len(runs[worst]) + 1)
    if not all(math.isfinite(run.error) for run in runs):
        raise UndecidedError(
            f"No {count} pieces with finite errors were found for the curve: ask for more pieces, "
            "or for a tolerance."
        )
    return runs


def check_least(parts: Sequence[Part], count: int) -> None:
    """Raises DomainError if so many pieces are too few for the stretches, whatever their error."""
    least = sum(part.least for part in parts)
    if count < least:
        because = f"it is split into {len(parts)} parts" if len(parts) > 1 else "it turns too far for fewer"
        raise DomainError(
            f"The number of pieces is {count}, and the curve takes at least {least}, as {because}: "
            f"ask for {least} or more."
        )


def _counts(parts: Sequence[Part], count: int) -> list[int]:
    """Pieces of each stretch at the least level at which they are not more than ``count`` in all.

    The level is bracketed, and guessed by the power law.
    """
    searched = [part for part in parts if not part.exact]
    rest = count - sum(part.least for part in parts if part.exact)
    best = [part.least for part in searched]
    if searched and rest > sum(best):
        order, floor = searched[0].order, max(64 * part.noise for part in searched)
        low, high = floor, math.inf
        level = max([2 * floor, *(_coarse_error(part) for part in searched)])
        for step in range(STEPS):
            narrow = max(WINDOW * level, floor / 64)
            counts = [len(part.greedy(level - narrow, level)) for part in searched]
            if sum(counts) <= rest:
                best, high = counts, level
            else:
                low = level
            if sum(best) == rest or high <= low * (1 + NARROW):
                break
            level *= (sum(counts) / rest) ** order * (0.99 if sum(counts) <= rest else 1.01)
            if not low < level < high or step % 3 == 2:
                level = math.sqrt(low * high) if math.isfinite(high) else 16 * low
    left = iter(best)
    counts = [part.least if part.exact else next(left) for part in parts]
    spare = count - sum(counts)
    if spare >= len(parts):  # no more to be had from them, or not from rounding
        counts = [n + spare * n // sum(counts) for n in counts]
    return counts


def _coarse_error(part: Part) -> float:
    """About the error of as few pieces as there can be, or 0."""
    errors = part.fitted(part.spread(part.least)).errors
    return float(max((e for e in errors if math.isfinite(e)), default=0.0))
