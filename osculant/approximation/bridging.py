"""Arcs that lie below the tolerance as a whole: what the curve does there is passed over.

Points where a curve would have to be split may lie so near to each other, or to an end of the curve, that
the arc between is smaller than the tolerance; and doubles may be unable to follow a bend of that size.  Such
an arc need not be followed.  At an end of the curve the piece before goes on to the end itself, in the
direction that it had.  Elsewhere, if the curve goes on, or back, as it came, the pieces on both sides meet in
one point; if it does not, small pieces (`osculant.pieces.bridges`) lead from the one side to the other.  The
extent of the arc is an error of the pieces next to it: they pass through a point so near to all of it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.split_points import as_float
from osculant.curves.kept import kept

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from osculant.approximation.runs import Run
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.curves.curve import FormulaCurve

#: an arc is passed over if it lies within this part of the tolerance; of an area's, within that of its root
PART, AREA_PART = 1 / 4, 1 / 16
#: a curve that is so near to its chord, in parts of the tolerance, is its chord
FLAT = 1 / 256
#: and in parts of the curve's size
STRAIGHTEST = 1e-6
#: directions that differ by less than this are one
STRAIGHT = 0.02
#: pieces of one small arc that are too many
CROWD = 4
#: what a curve may turn by, in radians, next to its end: within this part of what is passed over
HOOK, NEXT = 0.02, 2.0**-9
#: ends of an arc so far apart, in parts of its allowed extent, are seen in doubles to be too far
SEEN = 2.0
#: boxes in which an arc is enclosed: few, more where these tell nothing
BOXES = (8, 32, 128, 512)
#: boxes in which a curve that may be flat is enclosed, and the terms of the Taylor forms there and above
FLAT_BOXES, TERMS = 64, 6
#: an arc that is passed over, margins and all, is at most so many times as large as one between knots
WHOLE = 2
#: how far margins go towards the next knot, and towards one passed over too; halved so often if too large
ALONE, SHARED, SHORTENED = 31 / 32, 15 / 32, 8
#: where a curve is looked at first, in parts of its interval
PROBES = (0.25, 0.5, 0.75)
#: bisections that find where an arc that is passed over begins and ends
HALVINGS = 60


@dataclass(frozen=True)
class Blemish:
    """An arc [low, high] that is passed over, balls; the curve is within ``reach`` of each of its points.

    ``at_start`` and ``at_end`` tell whether it lies at that end of the curve.
    """

    low: Any
    high: Any
    reach: float
    at_start: bool
    at_end: bool


def allowed_extent(tolerance: float, degree: int) -> float:
    """How large an arc that is passed over may be, for a tolerance that is a length (degree 1) or an area.

    >>> allowed_extent(1.0, 1)
    0.25
    """
    return tolerance * PART if degree == 1 else math.sqrt(tolerance) * AREA_PART


def flat_enough(tolerance: float, degree: int, size: float) -> float:
    """How near to its chord a curve of that size may be for the chord to stand for it."""
    return min(tolerance * FLAT / size ** (degree - 1), STRAIGHTEST * size)


def blemishes(
    curve: FormulaCurve,
    knots: Sequence[tuple[Any, SpecialPoint]],
    extent: float,
    stuck: Sequence[float] = (),
    closed: bool = False,
) -> list[Blemish]:
    """The arcs between neighbouring knots, or around places where a search was stuck, that are passed over.

    Args:
        curve: with its interval.
        knots: where it would be divided, its ends among them, and what they are.
        extent: how large an arc that is passed over may be.
        stuck: parameters.
        closed: whether the curve goes on beyond its ends.

    Those that hold a point that the user asked for are left alone.  To be called within the balls' precision.
    """
    from flint import arb

    places = [(at, "asked" in point.kinds) for at, point in knots] + [(arb(t), False) for t in stuck]
    places.sort(key=lambda place: as_float(place[0]))
    points = curve.jets([as_float(at) for at, _ in places])[..., 0].tolist()
    groups, first = [places[:1]], points[0]
    for place, point in zip(places[1:], points[1:]):
        # doubles see enough where the distance is not nearly the extent
        far = math.dist(first, point) > SEEN * extent
        if not far and _reach(curve, groups[-1][0][0], place[0], extent) <= extent:
            groups[-1].append(place)
        else:
            groups.append([place])
            first = point
    spans = [(group[0][0], group[-1][0]) for group in groups]
    small = []
    for i, (group, (low, _)) in enumerate(zip(groups, spans)):
        lone = len(group) == 1 and as_float(low) not in stuck
        if lone and not closed and len(groups) > 1 and i in (0, len(groups) - 1):
            lone = not _is_hook(curve, low, spans[1][0] if i == 0 else spans[-2][1], extent * NEXT)
        if not (lone or len(groups) == 1 or any(asked for _, asked in group)):
            small.append(i)
    found = []
    for i in small:
        before = spans[i - 1][1] if i > 0 else None
        after = spans[i + 1][0] if i + 1 < len(spans) else None
        if closed and (before is None or after is None):
            continue
        shares = [SHARED if j in small else ALONE for j in (i - 1, i + 1)]
        arc = _with_margins(curve, *spans[i], (before, after), shares, extent)
        if arc is not None:
            found.append(Blemish(*arc, before is None, after is None))
    return found


def _with_margins(
    curve: FormulaCurve, low: Any, high: Any, knots: tuple[Any, Any], shares: Sequence[float], extent: float
) -> tuple[Any, Any, float] | None:
    """(first, last, reach) of an arc and of what is near on either side; None if no bound shows it small.

    The next knots are None at the ends of the curve; the margins go so far towards them at most.
    """
    for i in range(SHORTENED):
        first, last = (
            at if knot is None else _away(curve, at, at + (knot - at) * share * 2.0**-i, extent / 2)
            for at, knot, share in zip((low, high), knots, shares)
        )
        reach = _reach(curve, first, last, WHOLE * extent)
        if reach < math.inf:
            return first, last, reach
    return None


def crowded(curve: FormulaCurve, runs: Sequence[Run], extent: float) -> list[float]:
    """Ends of arcs of an extent at most so large that take `CROWD` pieces or more, split by nothing.

    Whoever winds about a point need not be followed for ever: a piece turns less than once.

    >>> from osculant.curves.plane import PlaneCurve
    >>> import numpy as np
    >>> from osculant.approximation.runs import Run
    >>> fading = PlaneCurve("exp(-t)*cos(20*t), exp(-t)*sin(20*t)", 0, 12)
    >>> crowded(fading, [Run(np.arange(13.0), np.zeros(12), np.empty((12, 0)))], 0.01)
    [6.0, 12.0]
    """
    found = []
    for run in runs:
        points = curve.jets(run.knots)[:, :, 0]
        steps = np.hypot.reduce(points[1:] - points[:-1], axis=1)
        if len(run) < CROWD or (steps > extent / 2).all():
            continue  # the usual case, quickly
        first = 0
        while first + CROWD < len(points):
            last = _last_near(points, first, extent / 2)
            if last - first >= CROWD:
                found += [float(run.knots[first]), float(run.knots[last])]
            first = max(last, first + 1)
    return found


def _last_near(points: np.ndarray[Any, Any], first: int, far: float) -> int:
    """The last of the points that follow one without being far from it."""
    start, length = first + 1, CROWD
    while start < len(points):
        away = np.hypot.reduce(points[start : start + length] - points[first], axis=1) > far
        if away.any():
            return start + int(np.argmax(away)) - 1
        start, length = start + length, 2 * length
    return len(points) - 1


def meeting(before: Sequence[float], after: Sequence[float]) -> tuple[float, tuple[float, ...]] | None:
    """(1 or −1, the tangent) if a curve goes on, or back, as it came; None if it turns a corner.

    The tangent is that of the pieces that end there; those that begin there have it, or its opposite.

    >>> meeting((1.0, 0.0), (-1.0, 1e-3))[0], meeting((1.0, 0.0), (0.0, 1.0))
    (-1.0, None)
    """
    along = math.fsum(u * v for u, v in zip(before, after))
    sign = math.copysign(1.0, along)
    total = [u + sign * v for u, v in zip(before, after)]
    apart = math.hypot(*(u - sign * v for u, v in zip(before, after)))
    if apart > STRAIGHT:
        return None
    length = math.hypot(*total)
    return sign, tuple(part / length for part in total)


def _away(curve: FormulaCurve, at: Any, end: Any, far: float) -> Any:
    """Where the curve, on from a parameter towards another, is so far from its point there, or that one."""
    from flint import arb

    centre, near, beyond = _point(curve, at), at, end
    for _ in range(HALVINGS):
        middle = arb(((near + beyond) / 2).mid())
        if math.dist(_point(curve, middle), centre) < far:
            near = middle
        else:
            beyond = middle
    return arb(as_float(beyond))


def _is_hook(curve: FormulaCurve, end: Any, inside: Any, far: float) -> bool:
    """Whether a curve, regular at its end, turns by more than `HOOK` until it is ``far`` off, or twice so."""
    from flint import arb

    (direction, speed), centre = _tangent(curve, end), _point(curve, end)
    if not speed > 0:
        return False
    most = (inside - end) / 2
    step = arb(far / speed.mid() * (1 if most > 0 else -1))
    for _ in range(HALVINGS):
        if abs(step) > abs(most) or math.dist(_point(curve, end + step), centre) >= far:
            break
        step *= 2
    other, length = _tangent(curve, arb((end + (step if abs(step) < abs(most) else most)).mid()))
    return bool(length > 0 and sum((u * v for u, v in zip(direction, other)), arb(0)) < math.cos(HOOK))


def _tangent(curve: FormulaCurve, at: Any) -> tuple[list[Any], Any]:
    """(unit tangent, speed) as balls; not finite where the speed may be 0."""
    from flint import arb

    parts = [row[1] for row in curve.balls.coefficients(at, 1)]
    speed = sum((part * part for part in parts), arb(0)).sqrt()
    return [part / speed for part in parts], speed


def _point(curve: FormulaCurve, t: Any) -> tuple[float, ...]:
    return tuple(float(row[0].mid()) for row in curve.balls.coefficients(t, 0))


def _reach(curve: FormulaCurve, low: Any, high: Any, most: float) -> float:
    """A bound of the distances between points of the arc; infinite if ``most`` is none."""
    return _reached(curve, (low.mid(), low.rad()), (high.mid(), high.rad()), most)


@kept
def _reached(curve: FormulaCurve, first: tuple[Any, Any], last: tuple[Any, Any], most: float) -> float:
    """`_reach` by the middles and radii of the ends, which are asked for again wherever a search is stuck."""
    from flint import arb

    low, high = arb(*first), arb(*last)
    for count in BOXES:
        points = zip(*(_point(curve, low + (high - low) * i / count) for i in range(count + 1)))
        if math.hypot(*(max(side) - min(side) for side in points)) > most:
            break
        sides = []
        for boxes in zip(*(rows for rows, _ in _boxes(curve, low, high, count))):
            side = boxes[0]
            for box in boxes[1:]:
                side = side.union(box)
            sides.append(2 * float(side.rad()))
        size = math.hypot(*sides)
        if size <= most:
            return size
    return math.inf


@kept
def width(curve: FormulaCurve, most: float = math.inf) -> float:
    """A bound of the curve's distance from its chord, and of the way that it runs back along that, together.

    It is infinite if a few points are seen to be farther than ``most`` from the chord.

    >>> from osculant.curves.plane import PlaneCurve
    >>> 0.0009 < width(PlaneCurve("t, t*(1-t)*4e-3", 0, 1)) < 0.0011, width(PlaneCurve("t^2, t", -1, 1)) >= 1
    (True, True)
    """
    from flint import arb

    from osculant.cas.numbers.balls import PRECISION, constant, precision

    with precision(PRECISION):
        low, high = map(constant, curve.ends)
        start, end = ([row[0] for row in curve.balls.coefficients(at, 0)] for at in (low, high))
        chord = [q - p for p, q in zip(start, end)]
        length = sum((part * part for part in chord), arb(0)).sqrt()
        if not length > 0:
            return math.inf
        along, farthest, back = [part / length for part in chord], arb(0), arb(0)

        def split(rows: list[list[Any]]) -> list[list[Any]]:
            """The series along the chord, then what is left of each coordinate's."""
            ahead = [sum((u * c for u, c in zip(along, terms)), arb(0)) for terms in zip(*rows)]
            return [ahead, *([c - u * a for c, a in zip(row, ahead)] for u, row in zip(along, rows))]

        first = split([[part] for part in start])[1:]
        for part in PROBES:
            rows = curve.balls.coefficients(low + (high - low) * part, 0)
            squares = ((at - origin) ** 2 for [at], [origin] in zip(split(rows)[1:], first))
            if sum(squares, arb(0)) > arb(most) ** 2:
                return math.inf
        for (_, *across), (slope, *_) in _boxes(curve, low, high, FLAT_BOXES, split):
            back += (-slope).nonnegative_part().upper() * (high - low) / FLAT_BOXES
            apart = [part - origin for part, [origin] in zip(across, first)]
            off = sum((part * part for part in apart), arb(0))  # a power of a ball around 0 is not finite
            farthest = farthest.max(off.upper())
        bound = (farthest.upper().max(arb(0)) + back * back).upper().sqrt().upper()
        return float(bound) if bound.is_finite() else math.inf


def _boxes(
    curve: FormulaCurve, low: Any, high: Any, count: int, combined: Any = list
) -> Iterator[tuple[list[Any], list[Any]]]:
    """Enclosures of the curve, and of its derivative, on equal parts of [low, high].

    Of what is ``combined`` linearly from the series of its coordinates, which are these themselves.
    """
    from osculant.cas.numbers.balls import ball
    from osculant.cas.zeros.isolate import differentiated, taylor_form

    edges = [low + (high - low) * i / count for i in range(count + 1)]
    for a, b in pairwise(edges):
        whole = ball(a, b)
        centre = whole.mid()
        h = whole - centre
        both = (combined(curve.balls.coefficients(at, TERMS)) for at in (centre, whole))
        rows = list(zip(*both))
        slopes = [taylor_form(differentiated(at), differentiated(over), h) for at, over in rows]
        yield [taylor_form(at, over, h) for at, over in rows], slopes
