"""Isolation of the zeros of analytic functions on an interval, in ball arithmetic, with bounded work.

The functions are given by enclosures of their Taylor series.  An interval is done when the Taylor
form excludes 0, or when the derivative excludes 0, so that there is one zero or none; otherwise it is
divided.  What is left at the smallest width is returned as unresolved: multiple zeros look like that,
and the caller may decide them exactly.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from flint import arb

from osculant.cas.errors import UndecidedError
from osculant.cas.numbers.balls import ball
from osculant.cas.numbers.taylor import Program

#: intervals are divided here, not in the middle, where formulas like to have their special points
CUT = 0.48713
#: intervals looked at before all open ones are given back as unresolved
WORK_LIMIT = 8_000
#: the smallest width, in parts of the whole interval, as a power of two
SMALLEST = 60

#: from this width on, in the same measure, multiple zeros are looked for
SMALL = 5

#: terms of Taylor forms, and of those where more terms help more than a narrower interval
LENGTH, LONGER = 14, (20, 28, 40, 56, 80, 112, 160)

#: (ball, names, terms) → for each function its series there, then series that vanish too wherever it does;
#: None where one is not finite
Evaluate = Callable[[Any, Sequence[str], int], Mapping[str, list[list[Any]]] | None]
#: (name, low, high) → an interval around it that needs no more work for this function, or None
Decide = Callable[[str, Any, Any], tuple[Any, Any] | None]


@dataclass
class Box:
    """An interval and the functions whose zeros in it are open."""

    low: Any
    high: Any
    open: tuple[str, ...]


@dataclass
class Isolation:
    """Simple zeros by function (as narrow brackets), and the boxes that stayed unresolved."""

    brackets: dict[str, list[tuple[Any, Any]]] = field(default_factory=dict)
    unresolved: list[Box] = field(default_factory=list)
    #: (function, low, high): intervals whose zeros the caller has decided by other means
    decided: list[tuple[str, Any, Any]] = field(default_factory=list)
    #: by function and lower end, what is known of its derivative on a bracket: a ball without 0
    slopes: dict[tuple[str, float], Any] = field(default_factory=dict)


class Look(Protocol):
    """Who looks at an interval before balls do, and faster."""

    def __call__(self, names: Sequence[str], low: Any, high: Any) -> Isolation:
        """Brackets of zeros that were found, and as unresolved what is left to look at."""

    def unclear(self, low: Any, high: Any) -> list[tuple[Any, Any]]:
        """Intervals outside of which the functions are finite."""

    def written(self, name: str, length: int) -> Program | None:
        """The program for a function's first Taylor coefficients, if it is written already."""


class Blind:
    """The look of who sees nothing."""

    def __call__(self, names: Sequence[str], low: Any, high: Any) -> Isolation:
        """All is left to look at."""
        return Isolation({name: [] for name in names}, [Box(low, high, tuple(names))])

    def unclear(self, low: Any, high: Any) -> list[tuple[Any, Any]]:
        """The whole interval."""
        return [(low, high)]

    def written(self, name: str, length: int) -> Program | None:
        """None."""
        return None


def taylor_form(at_centre: list[Any], over: list[Any], h: Any) -> Any:
    """An enclosure over an interval: the polynomial at its centre plus the last term over all of it."""
    total = over[-1]
    for c in reversed(at_centre[:-1]):
        total = c + h * total
    return total


def differentiated(series: list[Any]) -> list[Any]:
    """The coefficients of the derivative."""
    return [k * c for k, c in enumerate(series)][1:]


def divided(low: Any, high: Any) -> Any:
    """Where an interval is cut."""
    return arb((low + CUT * (high - low)).mid())


def first_infinite(
    evaluate: Evaluate, names: Sequence[str], low: Any, high: Any, look: Look | None = None
) -> tuple[Any, Any] | None:
    """A smallest interval in which no finite series was found, the leftmost; None if there is none.

    ``look`` tells where to seek it.  Raises UndecidedError after `WORK_LIMIT` intervals.

    >>> first_infinite(lambda t, names, terms: None, ["f"], arb(0), arb(1)) is not None
    True
    """
    least = (high - low) * arb(2) ** -SMALLEST
    stack = (look or Blind()).unclear(low, high)[::-1]
    for _ in range(WORK_LIMIT):
        if not stack:
            return None
        low, high = stack.pop()
        if evaluate(ball(low, high), names, LENGTH) is None:
            if high - low < least:
                return low, high
            cut = divided(low, high)
            stack += [(cut, high), (low, cut)]
    raise UndecidedError(
        f"Whether the curve is finite near t = {float(low):.10g} could not be told: "
        "write the formula so that less cancels, or take an interval without this point."
    )


def isolate(
    evaluate: Evaluate,
    decide: Decide,
    names: Sequence[str],
    low: Any,
    high: Any,
    limit: int | None = None,
    boxes: Sequence[Box] | None = None,
) -> Isolation:
    """Isolate the zeros of the named functions on [low, high], where all of them are finite.

    Brackets of simple zeros have ends where the sign is certain, or the end of the whole interval.
    Instead of all of it, only some ``boxes`` of the interval may be left to look at.
    ``decide(name, low, high)`` may settle what happens on a small interval; it then returns an interval
    on which nothing is left to do for that function.  After ``limit`` boxes, by default `WORK_LIMIT`, the
    open ones are unresolved; one that takes more terms counts as several.
    """
    found = Isolation({name: [] for name in names})
    size = high - low
    # wide ones first: a hard place must not starve the others
    queue = deque([Box(low, high, tuple(names))] if boxes is None else boxes)
    work, most = 0, WORK_LIMIT if limit is None else limit
    while queue and work < most:
        box = queue.popleft()
        width = box.high - box.low
        box.open = tuple(name for name in box.open if not _is_decided(found, name, box))
        box.open, terms = _undecided(evaluate, box, found, LENGTH)
        work += 1
        longer = next((length for length in LONGER if length >= terms > LENGTH), None)
        if longer:
            box.open, _ = _undecided(evaluate, box, found, longer)
            work += longer // LENGTH
        if width < size * arb(2) ** -SMALL:
            box.open = tuple(name for name in box.open if not _decide(decide, name, box, found))
        if box.open and width < size * arb(2) ** -SMALLEST:
            found.unresolved.append(box)
        elif box.open:
            cut = divided(box.low, box.high)
            queue += [Box(box.low, cut, box.open), Box(cut, box.high, box.open)]
    found.unresolved += queue
    return found


def _is_decided(found: Isolation, name: str, box: Box) -> bool:
    return any(name == known and box.low >= low and box.high <= high for known, low, high in found.decided)


def _decide(decide: Decide, name: str, box: Box, found: Isolation) -> bool:
    settled = decide(name, box.low, box.high)
    if settled is not None:
        found.decided.append((name, *settled))
    return settled is not None


def _undecided(evaluate: Evaluate, box: Box, found: Isolation, terms: int) -> tuple[tuple[str, ...], int]:
    """The functions still open on the box, and with how many terms they may not be.

    Simple zeros go to ``found``.
    """
    if not box.open:
        return (), 0
    centre = arb(((box.low + box.high) / 2).mid())
    whole = ball(box.low, box.high)
    over = evaluate(whole, box.open, terms)
    if over is None:
        return box.open, 0
    still = [name for name in box.open if all(series[0].contains(0) for series in over[name])]
    at = evaluate(centre, still, terms) if still else {}
    if at is None:
        return box.open, 0
    left, wanted = [], 0
    for name in still:
        pairs = list(zip(at[name], over[name], strict=True))
        if not all(taylor_form(*pair, whole - centre).contains(0) for pair in pairs):
            continue
        slope = taylor_form(differentiated(at[name][0]), differentiated(over[name][0]), whole - centre)
        if slope.contains(0):
            left.append(name)
            wanted = max(wanted, min(terms_wanted(*pair, whole - centre) for pair in pairs))
        else:
            found.brackets[name].append((box.low, box.high))
    return tuple(left), wanted


def terms_wanted(at_centre: list[Any], over: list[Any], h: Any) -> int:
    """How many terms a Taylor form takes to exclude 0, if they go on to fall as they do; many if they do not.

    Where large functions cancel and leave little, the last term hides it unless it is as small.

    >>> terms_wanted([arb(2) ** -100, arb(0), arb(0)], [arb(0, 1), arb(0, 1), arb(0, 1)], arb(0, 2**-10))
    12
    """
    value = abs(at_centre[0]).lower()
    sizes = [abs(c).upper() * abs(h).upper() ** k for k, c in enumerate(over)]
    largest = max(sizes)
    if not (value > 0 and sizes[-1] > 0 and sizes[-1] < largest):
        return LONGER[-1] + 1
    rate = (sizes[-1] / largest).log() / (len(sizes) - 1)
    return int(min(float((value / (2 * largest)).log() / rate), LONGER[-1])) + 2


def refine(
    value: Callable[[Any], Any], slope: Callable[[Any], Any], low: Any, high: Any, target: Any
) -> Any | None:
    """The zero of a monotone function in [low, high] as a ball no wider than about ``target``.

    Interval Newton steps, bisection where they do not halve.  ``value`` and ``slope`` enclose the
    function and its derivative over a ball.  A step that ends inside the interval proves that there is a
    zero; else the signs at its ends tell.  None if there is no zero; where the sign at an end of the
    interval cannot be told, that end is returned: the zero is there or indistinguishably near.

    >>> zero = refine(lambda t: t * t - 2, lambda t: 2 * t, arb(1), arb(2), arb("1e-12"))
    >>> abs(zero - arb(2).sqrt()) < 1e-11
    True
    """
    while (inside := _newton(value, slope, low, high)) is not None:
        slow = 2 * (inside[1] - inside[0]) > high - low
        low, high = inside
        if not high - low > target:
            return ball(low, high)
        if slow:
            break
    at_low, at_high = value(low), value(high)
    if at_low.contains(0):
        return arb(low)
    if at_high.contains(0):
        return arb(high)
    if (at_low > 0) == (at_high > 0):
        return None
    rising = bool(at_high > 0)
    while high - low > target:
        width = high - low
        middle = arb(((low + high) / 2).mid())
        at_middle = value(middle)
        if at_middle.contains(0):
            return ball(middle - target, middle + target)
        if (at_middle > 0) == rising:
            high = middle
        else:
            low = middle
        newton = middle - at_middle / slope(ball(low, high))
        if newton.is_finite():
            if newton.lower() > low:
                low = arb(newton.lower())
            if newton.upper() < high:
                high = arb(newton.upper())
        if not high - low < width:
            break
    return ball(low, high)


def _newton(
    value: Callable[[Any], Any], slope: Callable[[Any], Any], low: Any, high: Any
) -> tuple[Any, Any] | None:
    """The interval after a Newton step, if it lies inside the one before: then the zero in it is proved."""
    middle = arb(((low + high) / 2).mid())
    newton = middle - value(middle) / slope(ball(low, high))
    inside = newton.is_finite() and newton > low and newton < high
    return (arb(newton.lower()), arb(newton.upper())) if inside else None
