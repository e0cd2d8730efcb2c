"""Dividing a curve's interval where theory demands a knot (design, "where the curve is split")."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

from osculant.approximation.request import check_split
from osculant.approximation.split_points import as_float, cut, cut_around
from osculant.cas.errors import DomainError, UndecidedError
from osculant.primitives.table import PRIMITIVES

if TYPE_CHECKING:
    from osculant.approximation.closing import Closing
    from osculant.cas.zeros.form_zeros import SpecialPoint
    from osculant.curves.plane import PlaneCurve

#: derivatives tried for the limit tangent at a cusp
CUSP_ORDERS = 9
#: where in a stretch or an arc is read off what is the same everywhere: at no special place
INSIDE = 0.4871

Vector = tuple[float, float]
Kind = Literal["generic", "segment", "exact"]


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
    kind: Kind


@dataclass(frozen=True)
class Division:
    """The stretches of a curve, the split points between them and those that were not decided.

    ``proved`` is False if the curve seems to be a segment or an arc of the primitive, to hundreds of
    digits, but no symbolic proof was found.  ``free`` says that the one stretch of a closed curve may begin
    anywhere.  ``unsplit`` are the points inside stretches where theory wants a split and none was made.
    """

    stretches: tuple[Stretch, ...]
    splits: tuple[float, ...]
    undecided: tuple[float, ...]
    proved: bool
    free: bool = False
    unsplit: tuple[float, ...] = ()


def check_finite(curve: PlaneCurve) -> None:
    """Raises DomainError, naming the parameter value, where the curve is undefined or not smooth.

    >>> from osculant.curves.plane import PlaneCurve
    >>> check_finite(PlaneCurve("t, 1/t", -1, 1))
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: The curve is undefined or infinite at t = 0 (a division by zero): take
    an interval without it.
    """
    from osculant.cas.zeros.plane import require_finite

    require_finite(curve.balls, *curve.ends)


def divide(
    curve: PlaneCurve,
    primitive: str,
    split_at: Sequence[Any] = (),
    closing: Closing = "open",
    split: str = "theory",
) -> Division:
    """Divide the curve for a spline of the primitive.

    Args:
        curve: has to be finite: see `check_finite`.
        primitive: its special points (`Primitive.splits`) are split points besides cusps and inflections.
        split_at: the user's split points.
        closing: "smooth" makes the first split point the beginning, and the last stretch end there one
            period later, where the formula has to go on; without split points the one stretch is the whole
            interval, and free.  "corner" and "open" keep the ends.
        split: "never" leaves out the primitive's special points and tells them as ``unsplit`` (beyond the
            interval where the last stretch is).

    Raises:
        DomainError: a split point outside the interval (the seam of a closed curve is inside), an unknown
            word, or a curve that is a single point.

    >>> from osculant.curves.plane import PlaneCurve
    >>> divide(PlaneCurve("t, sin(t)", "1", "4"), "conic").splits
    (1.5707963267948966, 3.141592653589793)
    >>> divide(PlaneCurve("t, sin(t)", "1", "4"), "conic", split="never").unsplit
    (1.5707963267948966,)
    >>> eight = divide(PlaneCurve("cos(t), sin(2*t)", 0, "2*pi"), "parabola", [1], "smooth", "never")
    >>> [(round(s.a, 3), round(s.b, 3)) for s in eight.stretches]
    [(1.0, 1.571), (1.571, 4.712), (4.712, 7.283)]
    """
    from osculant.cas.numbers.balls import PRECISION, constant, precision
    from osculant.cas.zeros.plane import special_points

    check_split(split)
    kind, proved = _kind(curve, primitive)
    names = ["cusp"]
    names += ["inflection"] if kind != "segment" else []
    names += [PRIMITIVES[primitive].splits] if kind == "generic" else []
    skipped = {PRIMITIVES[primitive].splits} if split == "never" else set[str]()
    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        every = special_points(curve.balls, *curve.ends, names)
        found = [point for point in every if not point.kinds <= skipped]
        if closing == "smooth":
            splits = cut_around(curve, found, split_at, low, high)
            knots = _around(splits, low, high)
        else:
            splits, cuts = cut(curve, found, split_at, low, high)
            knots = [(point.at, point) for point in cuts]
        stretches = tuple(_stretch(curve, *before, *after, kind) for before, after in pairwise(knots))
        passed = [point.at for point in every if point.kinds <= skipped]
        if closing == "smooth":
            passed += [at + (high - low) for at in passed]
        left_out = list(map(as_float, passed))
    free = closing == "smooth" and not splits
    known = set[float]() if free else {part.a for part in stretches}
    return Division(
        stretches,
        tuple(at for at in map(as_float, (point.at for point in splits)) if at != as_float(low)),
        tuple(as_float(p.at) for p in (splits if closing == "smooth" else found) if not p.decided),
        proved,
        free,
        tuple(sorted({at for at in left_out if stretches[0].a <= at < stretches[-1].b} - known)),
    )


def _around(splits: list[SpecialPoint], low: Any, high: Any) -> list[tuple[Any, SpecialPoint]]:
    """Where the stretches of a closed curve end, and the points of the curve there."""
    from osculant.cas.zeros.form_zeros import SpecialPoint

    first = splits[0] if splits else SpecialPoint(low, frozenset())
    knots = [(point.at, point) for point in splits or [first]]
    return [*knots, (high if first.at is low else first.at + (high - low), first)]


def _kind(curve: PlaneCurve, primitive: str) -> tuple[Kind, bool]:
    """What the curve is as a whole, and whether that is certain."""
    from osculant.cas.numbers.balls import PRECISION, constant, precision
    from osculant.cas.zeros.plane import vanishes

    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        if vanishes(curve.balls, "cusp", low, high):
            raise DomainError(f"The curve {curve.text} is a single point: give a formula that moves.")
        if vanishes(curve.balls, "inflection", low, high):
            return "segment", curve.exact.straight is True
        if vanishes(curve.balls, PRIMITIVES[primitive].splits, low, high):
            return "exact", getattr(curve.exact, PRIMITIVES[primitive].exact) is True
    return "generic", True


def begun_at(curve: PlaneCurve, division: Division, at: float) -> Stretch:
    """The one stretch of a free division, begun elsewhere: from ``at`` to one period later.

    >>> import math
    >>> from osculant.curves.plane import PlaneCurve
    >>> ellipse = PlaneCurve("2*cos(t), sin(t)", 0, "2*pi")
    >>> begun_at(ellipse, divide(ellipse, "parabola", closing="smooth"), 1.0).b == 1 + 2 * math.pi
    True
    """
    from flint import arb

    from osculant.cas.numbers.balls import PRECISION, precision
    from osculant.cas.zeros.form_zeros import SpecialPoint

    (whole,) = division.stretches
    with precision(PRECISION):
        start = SpecialPoint(arb(at), frozenset())
        return _stretch(curve, start.at, start, start.at + (whole.high - whole.low), start, whole.kind)


def _stretch(
    curve: PlaneCurve, low: Any, start: SpecialPoint, high: Any, end: SpecialPoint, kind: Kind
) -> Stretch:
    """The stretch from low to high, where the curve is at the points ``start`` and ``end``."""
    inside = low + (high - low) * INSIDE
    bend = curve.balls.jet(inside.mid(), 2).inflection_form
    return Stretch(
        low,
        high,
        as_float(low),
        as_float(high),
        _frame(curve, start, 1),
        _frame(curve, end, -1),
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
