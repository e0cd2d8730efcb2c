"""Where an interval is cut, in the plane and in space: points found, points asked for, and the ends."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.cas.text import to_text
from osculant.formula_curve import as_constant

if TYPE_CHECKING:
    from osculant.cas.form_zeros import SpecialPoint
    from osculant.formula_curve import FormulaCurve

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
    from osculant.cas.balls import constant
    from osculant.cas.form_zeros import SpecialPoint

    for asked in split_at:
        at = constant(as_constant(asked, "--split-at"))
        if not (at > low and at < high):
            raise DomainError(
                f"The split point {asked} is not inside the interval from {to_text(curve.ends[0])} "
                f"to {to_text(curve.ends[1])}: leave it out or choose another."
            )
        found.append(SpecialPoint(at, frozenset(["asked"])))
    points = _inner(found, low, high)
    return points, [_end(found, low), *points, _end(found, high)]


def _inner(found: list[SpecialPoint], low: Any, high: Any) -> list[SpecialPoint]:
    """The split points strictly inside, one for each double."""
    a, b = as_float(low), as_float(high)
    inside = {as_float(point.at): point for point in found if a < as_float(point.at) < b}
    near = (high - low) * APART
    return [point for _, point in sorted(inside.items()) if point.at - low > near and high - point.at > near]


def _end(found: list[SpecialPoint], at: Any) -> SpecialPoint:
    """An end of the interval with what was found there."""
    from osculant.cas.form_zeros import SpecialPoint

    kinds = [point.kinds for point in found if as_float(point.at) == as_float(at)]
    return SpecialPoint(at, frozenset().union(*kinds))
