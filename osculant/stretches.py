"""Dividing a curve's interval where theory demands a knot (design, "where the curve is split")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError, UndecidedError
from osculant.primitives import PRIMITIVES
from osculant.split_points import as_float, cut

if TYPE_CHECKING:
    from osculant.cas.form_zeros import SpecialPoint
    from osculant.plane import PlaneCurve

#: derivatives tried for the limit tangent at a cusp
CUSP_ORDERS = 9

Vector = tuple[float, float]


@dataclass(frozen=True)
class Frame:
    """A point of the curve and its unit tangent, at a cusp the limit tangent from the stretch's side."""

    point: Vector
    tangent: Vector


@dataclass(frozen=True)
class Stretch:
    """A part of the interval without special points inside.

    ``low``, ``high`` are balls, ``a``, ``b`` their nearest doubles; ``bend`` is the sign of the curvature.
    ``kind`` says whether the curve is a segment or an arc of the primitive itself there.
    """

    low: Any
    high: Any
    a: float
    b: float
    start: Frame
    end: Frame
    bend: float
    kind: Literal["generic", "segment", "exact"]


@dataclass(frozen=True)
class Division:
    """The stretches of a curve, the inner split points and those of them that were not decided.

    ``proved`` is False if the curve seems to be a segment or an arc of the primitive, to hundreds of
    digits, but no symbolic proof was found.
    """

    stretches: tuple[Stretch, ...]
    splits: tuple[float, ...]
    undecided: tuple[float, ...]
    proved: bool


def check_finite(curve: PlaneCurve) -> None:
    """Raises DomainError, naming the parameter value, where the curve is undefined or not smooth.

    >>> from osculant.plane import PlaneCurve
    >>> check_finite(PlaneCurve("t, 1/t", -1, 1))
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: The curve is undefined or infinite at t = 0 (a division by zero): take
    an interval without it.
    """
    from osculant.cas.special import require_finite

    require_finite(curve.balls, *curve.ends)


def divide(curve: PlaneCurve, primitive: str, split_at: Sequence[Any] = ()) -> Division:
    """Divide the curve for a spline of the primitive, also at the user's points.

    The curve has to be finite: see `check_finite`.  Raises DomainError for a split point outside the
    interval, or if the curve is a single point.

    >>> from osculant.plane import PlaneCurve
    >>> divide(PlaneCurve("t, sin(t)", "1", "4"), "conic").splits
    (1.5707963267948966, 3.141592653589793)
    """
    from osculant.cas.balls import PRECISION, constant, precision
    from osculant.cas.special import special_points

    kind, proved = _kind(curve, primitive)
    names = ["cusp"]
    names += ["inflection"] if kind != "segment" else []
    names += [PRIMITIVES[primitive].splits] if kind == "generic" else []
    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        found = special_points(curve.balls, *curve.ends, names)
        points, cuts = cut(curve, found, split_at, low, high)
        stretches = tuple(_stretch(curve, before, after, kind) for before, after in pairwise(cuts))
    return Division(
        stretches,
        tuple(as_float(point.at) for point in points),
        tuple(as_float(point.at) for point in found if not point.decided),
        proved,
    )


def _kind(curve: PlaneCurve, primitive: str) -> tuple[Literal["generic", "segment", "exact"], bool]:
    """What the curve is as a whole, and whether that is certain."""
    from osculant.cas.balls import PRECISION, constant, precision
    from osculant.cas.special import vanishes

    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        if vanishes(curve.balls, "cusp", low, high):
            raise DomainError(f"The curve {curve.text} is a single point: give a formula that moves.")
        if vanishes(curve.balls, "inflection", low, high):
            return "segment", curve.exact.straight is True
        if vanishes(curve.balls, PRIMITIVES[primitive].splits, low, high):
            return "exact", getattr(curve.exact, PRIMITIVES[primitive].exact) is True
    return "generic", True


def _stretch(
    curve: PlaneCurve,
    before: SpecialPoint,
    after: SpecialPoint,
    kind: Literal["generic", "segment", "exact"],
) -> Stretch:
    inside = before.at + (after.at - before.at) * 0.4871
    bend = curve.balls.jet(inside.mid(), 2).inflection_form
    return Stretch(
        before.at,
        after.at,
        as_float(before.at),
        as_float(after.at),
        _frame(curve, before, 1),
        _frame(curve, after, -1),
        -1.0 if bend < 0 else 1.0,
        kind,
    )


def _frame(curve: PlaneCurve, point: SpecialPoint, side: int) -> Frame:
    """The frame at a split point, seen from the stretch after (side 1) or before it (side −1)."""
    from flint import arb

    at = point.at.mid() if not point.decided else point.at
    singular = "cusp" in point.kinds
    x, y = curve.balls.coefficients(arb(at), CUSP_ORDERS if singular else 1)
    for order in range(2 if singular else 1, len(x)):
        length = (x[order] * x[order] + y[order] * y[order]).sqrt()
        if length > 0:
            sign = side ** (order - 1)  # α̇ ~ (t − c)^(order − 1)
            tangent = (float((sign * x[order] / length).mid()), float((sign * y[order] / length).mid()))
            return Frame((float(x[0].mid()), float(y[0].mid())), tangent)
    raise UndecidedError(
        f"The curve has no tangent at t = {as_float(point.at):.10g} that {CUSP_ORDERS} derivatives could "
        "tell: choose an interval without this point."
    )
