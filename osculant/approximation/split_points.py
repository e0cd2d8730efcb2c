"""Where an interval is cut, in the plane and in space: points found, points asked for, and the ends."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.curves.curve import as_constant

if TYPE_CHECKING:
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.curves.curve import FormulaCurve

#: split points nearer to an end than this part of the interval are that end
APART = 2.0**-50


def as_float(at: Any) -> float:
    """The double of a ball, 0 if the ball contains 0."""
    return 0.0 if at.contains(0) else float(at.mid())


def cut(
    curve: FormulaCurve, found: list[SpecialPoint], split_at: Sequence[Any], low: Any, high: Any
) -> tuple[list[SpecialPoint], list[SpecialPoint]]:
    """(inner split points, the same with both ends); the points asked for are added to those found.

    To be called within the balls' precision. Raises DomainError for a point outside the interval.
    """
    every = [*found, *(_asked(curve, asked, low, high) for asked in split_at)]
    points = _inner(every, low, high)
    return points, [_end(every, low), *points, _end(every, high)]


def cut_around(
    curve: FormulaCurve, found: list[SpecialPoint], split_at: Sequence[Any], low: Any, high: Any
) -> list[SpecialPoint]:
    """The split points of a curve with period high − low, in order, the seam's at low; as `cut`.

    What was found at either end, or is asked for there, is one point.
    """
    from osculant.cas.zeros.points import SpecialPoint

    every = [*found, *(_asked(curve, asked, low, high, seam=True) for asked in split_at)]
    seam = [point for point in every if _is_near(point, low, low, high) or _is_near(point, high, low, high)]
    inner = _inner(every, low, high)
    if not seam:
        return inner
    kinds = frozenset[str]().union(*(point.kinds for point in seam))
    return [SpecialPoint(low, kinds, all(point.decided for point in seam)), *inner]


def _asked(curve: FormulaCurve, asked: Any, low: Any, high: Any, seam: bool = False) -> SpecialPoint:
    """The split point a user asked for, inside the interval, or at an end if that is a ``seam``."""
    from osculant.cas.numbers.balls import constant

    at = constant(as_constant(asked, "split_at"))
    if (at > low and at < high) or (seam and (at.overlaps(low) or at.overlaps(high))):
        return _point(at, frozenset(["asked"]))
    raise DomainError(
        f"The split point {asked} is not inside the interval from {to_text(curve.ends[0])} "
        f"to {to_text(curve.ends[1])}: leave it out or choose another."
    )


def _inner(found: list[SpecialPoint], low: Any, high: Any) -> list[SpecialPoint]:
    """The split points strictly inside, one for each double."""
    inside: dict[float, SpecialPoint] = {}
    for point in found:
        if not (_is_near(point, low, low, high) or _is_near(point, high, low, high)):
            known = inside.get(as_float(point.at))
            inside[as_float(point.at)] = point if known is None else _both(known, point)
    return [point for _, point in sorted(inside.items())]


def _is_near(point: SpecialPoint, end: Any, low: Any, high: Any) -> bool:
    """Whether a point is an end, or cannot be told from it in doubles."""
    return as_float(point.at) == as_float(end) or not abs(point.at - end) > (high - low) * APART


def _end(found: list[SpecialPoint], at: Any) -> SpecialPoint:
    """An end of the interval with what was found there."""
    kinds = [point.kinds for point in found if as_float(point.at) == as_float(at)]
    return _point(at, frozenset[str]().union(*kinds))


def _both(known: SpecialPoint, other: SpecialPoint) -> SpecialPoint:
    """One point for two with the same double: where theory found it, with all that it is."""
    from osculant.cas.zeros.points import SpecialPoint

    return SpecialPoint(known.at, known.kinds | other.kinds, known.decided and other.decided)


def _point(at: Any, kinds: frozenset[str]) -> SpecialPoint:
    from osculant.cas.zeros.points import SpecialPoint

    return SpecialPoint(at, kinds)
