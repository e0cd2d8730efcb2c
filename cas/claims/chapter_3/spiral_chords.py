"""Chords of the spiral r = 1 − θ/50 in balls: how far an arc of it lies from its chord, from both sides."""

from __future__ import annotations

from typing import Any

from flint import arb

from osculant.cas.errors import UndecidedError
from osculant.cas.numbers.balls import ball

#: parts of an arc on which a distance is bounded from above, halvings of parts, points tried at a time
BOXES, DEPTH, CANDIDATES = 64, 20, 24

Point = tuple[Any, Any]


def point(t: Any) -> Point:
    """The spiral at a ball.

    >>> float(point(arb(0))[0])
    1.0
    """
    radius = 1 - t / 50
    return radius * t.cos(), radius * t.sin()


def distance(p: Point, a: Point, b: Point) -> tuple[Any, Any]:
    """Lower and upper bounds of the distance of a point from the segment ab.

    >>> low, high = distance((arb(1), arb(2)), (arb(0), arb(0)), (arb(3), arb(0)))
    >>> float(low), float(high)
    (2.0, 2.0)
    """
    chord = b[0] - a[0], b[1] - a[1]
    size = _length(*chord)
    ends = [_length(p[0] - e[0], p[1] - e[1]) for e in (a, b)]
    if size.contains(0):
        return arb(0), min((e.upper() for e in ends), key=float)
    line = abs(chord[0] * (p[1] - a[1]) - chord[1] * (p[0] - a[0])) / size
    along = (chord[0] * (p[0] - a[0]) + chord[1] * (p[1] - a[1])) / size
    if along > 0 and along < size:
        return line.lower(), line.upper()
    beyond = ends[0] if along < 0 else ends[1] if along > size else None
    if beyond is not None:
        return beyond.lower(), beyond.upper()
    return line.lower(), min((e.upper() for e in ends), key=float)


def _length(x: Any, y: Any) -> Any:
    """The length of a vector; the square of a ball around 0 is not positive."""
    square = x * x + y * y
    return ball(square.lower().sqrt() if square > 0 else 0, square.upper().sqrt())


def within(start: Any, end: Any, tolerance: Any) -> bool:
    """Whether the arc from start to end certainly lies within a tolerance of its chord.

    >>> within(arb(0), arb(1), arb("0.2")), within(arb(0), arb(3), arb("0.2"))
    (True, False)
    """
    a, b, step = point(start), point(end), (end - start) / BOXES
    waiting = [(start + step * i, start + step * (i + 1), 0) for i in range(BOXES)]
    while waiting:
        low, high, depth = waiting.pop()
        if distance(point(ball(low, high)), a, b)[1] <= tolerance:
            continue
        if depth == DEPTH:
            return False
        middle = (low + high) / 2
        waiting += [(low, middle, depth + 1), (middle, high, depth + 1)]
    return True


def farther(start: Any, end: Any, tolerance: Any) -> bool:
    """Whether some point of the arc is certainly farther from the chord; start and end may be wide balls.

    >>> farther(arb(0), arb(3), arb("0.2")), farther(arb(0), arb(1), arb("0.2"))
    (True, False)
    """
    a, b = point(start), point(end)
    low, high = start.mid(), end.mid()
    best, step = (low + high) / 2, (high - low) / 2
    while step * CANDIDATES * CANDIDATES > high - low:  # a grid about the farthest point of the one before
        step /= CANDIDATES / 2
        grid = [(best + step * i).mid() for i in range(-CANDIDATES // 2, CANDIDATES // 2 + 1)]
        inside = [t for t in grid if low < t and t < high]
        best = max(inside, key=lambda t: float(distance(point(t), a, b)[0]))
        if distance(point(best), a, b)[0] > tolerance:
            return True
    return False


def all_farther(start: Any, low: Any, high: Any, tolerance: Any) -> bool:
    """Whether that is so for every end between two numbers: on boxes, halved where need be.

    >>> all_farther(arb(0), arb(3), arb(4), arb("0.76")), all_farther(arb(0), arb(2), arb(4), arb("0.76"))
    (True, False)
    """
    waiting = [(low, high, 0)]
    while waiting:
        a, b, depth = waiting.pop()
        if farther(start, ball(a, b), tolerance):
            continue
        if depth == DEPTH:
            return False
        middle = ((a + b) / 2).mid()
        waiting += [(a, middle, depth + 1), (middle, b, depth + 1)]
    return True


def longest(start: Any, last: Any, tolerance: Any, width: Any) -> Any:
    """The end of the longest arc from start within the tolerance, as a ball; ``last`` if that can be.

    Args:
        start: a ball, narrow against ``width``.
        last: the end of the curve.
        tolerance: of the distance from the chord.
        width: the radius of the ball returned.

    Raises UndecidedError if no such ball can be certified.
    """
    if within(start, last, tolerance):
        return last
    low, high = start.mid(), start.mid() + 4  # arcs longer than that are refuted below
    while high - low > width / 4:
        middle = ((low + high) / 2).mid()
        low, high = (low, middle) if farther(start.mid(), middle, tolerance) else (middle, high)
    below, above = low - width, low + width
    if not (within(start, below, tolerance) and all_farther(start, above, last, tolerance)):
        raise UndecidedError("The longest arc of the spiral was not certified: take a larger width.")
    return ball(below, above)
