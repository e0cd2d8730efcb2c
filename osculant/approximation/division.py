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
    from osculant.curves.curve import FormulaCurve
    from osculant.primitives.primitive import Primitive

#: derivatives tried for the limit tangent at a cusp
CUSP_ORDERS = 9
#: where in a stretch or an arc is read off what is the same everywhere: at no special place
INSIDE = 0.4871

#: a coordinate each
Vector = tuple[float, ...]
Kind = Literal["generic", "level", "segment", "exact"]


@dataclass(frozen=True)
class Frame:
    """A point of the curve and its unit tangent, at a cusp the limit tangent from the stretch's side."""

    point: Vector
    tangent: Vector


@dataclass(frozen=True)
class Stretch:
    """A part of the interval without special points inside but those that are passed.

    Attributes:
        low, high: its ends, balls.
        a, b: their nearest doubles.
        start, end: the frames there.
        kind: "segment" or "exact" if the curve is a segment or an arc of the primitive itself there, "level"
            if it is not, but the leading term of the primitive's error vanishes (a bihelix's, on a curve of
            constant curvature).
        bend: the sign of the curvature; 1 in space, where it has none.
        passed: the points inside, balls, where theory wants a split and none is to be made.
    """

    low: Any
    high: Any
    a: float
    b: float
    start: Frame
    end: Frame
    kind: Kind
    bend: float
    passed: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Division:
    """The stretches of a curve, the split points between them and those that were not decided.

    ``proved`` is False if the curve seems to be a segment or an arc of the primitive, to hundreds of
    digits, but no symbolic proof was found.  ``free`` says that the one stretch of a closed curve may begin
    anywhere.
    """

    stretches: tuple[Stretch, ...]
    splits: tuple[float, ...]
    undecided: tuple[float, ...]
    proved: bool
    free: bool = False

    @property
    def unsplit(self) -> tuple[float, ...]:
        """The points inside stretches where theory wants a split and none was made.

        They lie beyond the curve's interval where the last stretch of a closed curve does.
        """
        return tuple(sorted({as_float(at) for stretch in self.stretches for at in stretch.passed}))


def divide(
    curve: FormulaCurve,
    primitive: str,
    split_at: Sequence[Any] = (),
    closing: Closing = "open",
    split: str = "theory",
) -> Division:
    """Divide the curve for a spline of the primitive.

    Args:
        curve: has to be finite: see `FormulaCurve.check_finite`.
        primitive: one of the curve's dimension; cusps and its special points (`Primitive.splits`,
            `Primitive.theory`) are split points.
        split_at: the user's split points.
        closing: "smooth" makes the first split point the beginning, and the last stretch end there one
            period later, where the formula has to go on; without split points the one stretch is the whole
            interval, and free.  "corner" and "open" keep the ends.
        split: "never" leaves out `Primitive.theory`, and tells the points as ``passed``.

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
    >>> from osculant.curves.space import SpaceCurve
    >>> divide(SpaceCurve("2*cos(t), sin(t), t/5", "1", "4"), "bihelix").splits
    (1.5707963267948966, 3.141592653589793)
    """
    from osculant.cas.numbers.balls import PRECISION, constant, precision

    check_split(split)
    wanted = PRIMITIVES[curve.dimension][primitive]
    kind, proved = _kind(curve, wanted)
    every = curve.special_points(_forms(wanted, kind))
    left_out = set(wanted.theory) if split == "never" else set[str]()
    found = [point for point in every if not point.kinds <= left_out]
    passed = [point.at for point in every if point.kinds <= left_out]
    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        if closing == "smooth":
            splits = cut_around(curve, found, split_at, low, high)
            knots = _around(splits, low, high)
            passed += [at + (high - low) for at in passed]
        else:
            splits, cuts = cut(curve, found, split_at, low, high)
            knots = [(point.at, point) for point in cuts]
        free = closing == "smooth" and not splits
        stretches = [_stretch(curve, *start, *end, kind, passed, free) for start, end in pairwise(knots)]
    return Division(
        tuple(stretches),
        tuple(at for at in (as_float(point.at) for point in splits) if at != as_float(low)),
        tuple(as_float(p.at) for p in (splits if closing == "smooth" else found) if not p.decided),
        proved,
        free,
    )


def _forms(primitive: Primitive, kind: Kind) -> list[str]:
    """The forms whose zeros split a curve of that kind: those that do not vanish identically on it."""
    forms = ["cusp"]
    forms += primitive.splits if kind != "segment" else ()
    forms += primitive.theory if kind == "generic" else ()
    return forms


def _kind(curve: FormulaCurve, primitive: Primitive) -> tuple[Kind, bool]:
    """What the curve is as a whole, and whether that is certain."""
    if curve.vanishes("cusp"):
        raise DomainError(f"The curve {curve.text} is a single point: give a formula that moves.")
    if curve.vanishes("inflection"):
        return "segment", curve.exact.straight is True
    itself = primitive.itself
    if itself is None or not curve.vanishes(itself.forms[0]):
        return "generic", True
    if not all(map(curve.vanishes, itself.forms[1:])):
        return "level", True
    return "exact", itself.proof(curve.exact) is True


def _around(splits: list[SpecialPoint], low: Any, high: Any) -> list[tuple[Any, SpecialPoint]]:
    """Where the stretches of a closed curve end, and the points of the curve there."""
    from osculant.cas.zeros.form_zeros import SpecialPoint

    first = splits[0] if splits else SpecialPoint(low, frozenset())
    knots = [(point.at, point) for point in splits or [first]]
    return [*knots, (high if first.at is low else first.at + (high - low), first)]


def begun_at(curve: FormulaCurve, division: Division, at: float) -> Stretch:
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
        start, period = SpecialPoint(arb(at), frozenset()), whole.high - whole.low
        passed = [*whole.passed, *(point + period for point in whole.passed)]
        return _stretch(curve, start.at, start, start.at + period, start, whole.kind, passed)


def _stretch(
    curve: FormulaCurve,
    low: Any,
    start: SpecialPoint,
    high: Any,
    end: SpecialPoint,
    kind: Kind,
    passed: Sequence[Any],
    free: bool = False,
) -> Stretch:
    """The stretch from low to high, where the curve is at the points ``start`` and ``end``.

    Of a free one the beginning, which is no knot, may be passed too.
    """
    a, b = as_float(low), as_float(high)
    inside = tuple(at for at in passed if a < as_float(at) < b or (free and as_float(at) == a))
    bend = curve.bend((low + (high - low) * INSIDE).mid())
    return Stretch(low, high, a, b, _frame(curve, start, 1), _frame(curve, end, -1), kind, bend, inside)


def _frame(curve: FormulaCurve, point: SpecialPoint, side: int) -> Frame:
    """The frame at a split point, seen from the stretch after (side 1) or before it (side −1)."""
    from flint import arb

    at = point.at.mid() if not point.decided else point.at
    singular = "cusp" in point.kinds
    rows = curve.balls.coefficients(arb(at), CUSP_ORDERS if singular else 1)
    for order in range(2 if singular else 1, len(rows[0])):
        parts = [row[order] for row in rows]
        length = sum((part * part for part in parts), arb(0)).sqrt()
        if length > 0:
            sign = side ** (order - 1)  # α̇ ~ (t − c)^(order − 1)
            # what cannot be told from 0 in balls is 0: its double would be the noise of the last bits
            tangent = tuple(as_float(sign * part / length) for part in parts)
            return Frame(tuple(as_float(row[0]) for row in rows), tangent)
    raise UndecidedError(
        f"The curve has no tangent at t = {as_float(point.at):.10g} that {CUSP_ORDERS} derivatives could "
        "tell: choose an interval without this point."
    )
