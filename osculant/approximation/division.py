"""Dividing a curve's interval where theory demands a knot (design, "where the curve is split")."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from osculant.approximation.bridging import Blemish, blemishes
from osculant.approximation.joints import Joint, between, bridge, frame_at, joints_at
from osculant.approximation.request import check_split
from osculant.approximation.split_points import as_float, cut, cut_around
from osculant.approximation.stretches import Frame, Kind, Stretch
from osculant.cas.errors import DomainError
from osculant.curves.kept import kept
from osculant.primitives.table import PRIMITIVES

if TYPE_CHECKING:
    from osculant.approximation.closing import Closing
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.curves.curve import FormulaCurve
    from osculant.primitives.primitive import Primitive


@dataclass(frozen=True)
class Division:
    """The stretches of a curve, the split points between them and those that were not decided.

    ``proved`` is False if the curve seems to be a segment or an arc of the primitive, to hundreds of
    digits, but no symbolic proof was found.  ``free`` says that the one stretch of a closed curve may begin
    anywhere.  ``bridged`` are the arcs that are passed over: (first end, last end, extent).
    """

    stretches: tuple[Stretch, ...]
    splits: tuple[float, ...]
    undecided: tuple[float, ...]
    proved: bool
    free: bool = False
    bridged: tuple[tuple[float, float, float], ...] = ()

    @property
    def unsplit(self) -> tuple[float, ...]:
        """The points inside stretches where theory wants a split and none was made.

        They lie beyond the curve's interval where the last stretch of a closed curve does.
        """
        return tuple(sorted({as_float(at) for stretch in self.stretches for at in stretch.passed}))


@kept
def divide(
    curve: FormulaCurve,
    primitive: str,
    split_at: Sequence[Any] = (),
    closing: Closing = "open",
    split: str = "theory",
    extent: float = 0.0,
    stuck: Sequence[float] = (),
    lead: bool = False,
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
        extent: arcs between split points that are smaller, or so near to an end, are passed over
            (`osculant.approximation.bridging`); 0 if none is.
        stuck: parameters around which arcs of that size are passed over in any case.
        lead: whether small pieces lead to an end of the curve, where an arc is passed over there; otherwise
            the piece next to it does.

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
    kind, proved = _kind(curve, primitive)
    every = curve.special_points(_forms(wanted, kind))
    if kind in (
        "segment",
        "exact",
    ):  # there nothing but the formula is singular where the curve goes straight on
        every = [point for point in every if not _goes_on(curve, point)]
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
        passed_over: list[Blemish] = []
        if extent > 0 and kind in ("generic", "level") and wanted.bridge is not None and not free:
            passed_over = blemishes(curve, knots, extent, stuck, closing == "smooth")
        joints = joints_at(curve, knots, passed_over, lead)
        stretches = [
            part
            for before, after in pairwise(joints)
            for part in between(curve, before, after, kind, passed, free)
        ]
        if lead and joints[-1].at is None:
            stretches.append(bridge(joints[-1]))
    inside = [(as_float(b.low), as_float(b.high)) for b in passed_over]

    def followed(at: float) -> bool:
        return not any(first <= at <= last for first, last in inside)

    return Division(
        tuple(stretches),
        tuple(at for at in (as_float(p.at) for p in splits) if at != as_float(low) and followed(at)),
        tuple(
            at
            for at in (as_float(p.at) for p in (splits if closing == "smooth" else found) if not p.decided)
            if followed(at)
        ),
        proved,
        free,
        tuple((*ends, b.reach) for ends, b in zip(inside, passed_over)),
    )


def is_exact(curve: FormulaCurve, primitive: str) -> bool:
    """Whether the curve seems to be a segment or of arcs of the primitive itself.

    >>> from osculant.curves.plane import PlaneCurve
    >>> [is_exact(PlaneCurve("t, t^2", 0, 1), primitive) for primitive in ("parabola", "biarc")]
    [True, False]
    """
    return _kind(curve, primitive)[0] in ("segment", "exact")


def chord_of(curve: FormulaCurve, off: float) -> Division:
    """The division of a curve that is nowhere farther than ``off`` from its chord, which stands for it.

    >>> from osculant.curves.plane import PlaneCurve
    >>> chord_of(PlaneCurve("t, t^2/1000", 0, 1), 1e-3).stretches[0].kind
    'bridge'
    """
    from osculant.cas.numbers.balls import PRECISION, constant, precision

    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        start, end = (
            tuple(as_float(row[0]) for row in curve.balls.coefficients(at, 0)) for at in (low, high)
        )
    length = math.dist(start, end)
    along = tuple((q - p) / length for p, q in zip(start, end))
    a, b = as_float(low), as_float(high)
    whole = Stretch(low, high, a, b, Frame(start, along), Frame(end, along), "bridge", 1.0, (), off)
    return Division((whole,), (), (), True, bridged=((a, b, off),))


def _forms(primitive: Primitive, kind: Kind) -> list[str]:
    """The forms whose zeros split a curve of that kind: those that do not vanish identically on it."""
    forms = ["cusp"]
    forms += primitive.splits if kind in ("generic", "level") else ()
    forms += primitive.theory if kind == "generic" else ()
    return forms


@kept
def _kind(curve: FormulaCurve, primitive: str) -> tuple[Kind, bool]:
    """What the curve is as a whole, and whether that is certain."""
    if curve.vanishes("cusp"):
        raise DomainError(f"The curve {curve.text} is a single point: give a formula that moves.")
    if curve.vanishes("inflection") and curve.exact.straight is not False:
        return "segment", curve.exact.straight is True
    itself = PRIMITIVES[curve.dimension][primitive].itself
    if itself is None or not curve.vanishes(itself.forms[0]):
        return "generic", True
    if not all(map(curve.vanishes, itself.forms[1:])):
        return "level", True
    proof = itself.proof(curve.exact)
    return ("generic", True) if proof is False else ("exact", proof is True)


def _goes_on(curve: FormulaCurve, point: SpecialPoint) -> bool:
    """Whether the tangents on both sides of a point, surely singular, are the same."""
    if not point.decided:
        return False
    before, after = (frame_at(curve, point, side).tangent for side in (-1, 1))
    return sum(x * y for x, y in zip(before, after)) > 0


def _around(splits: list[SpecialPoint], low: Any, high: Any) -> list[tuple[Any, SpecialPoint]]:
    """Where the stretches of a closed curve end, and the points of the curve there."""
    from osculant.cas.zeros.points import SpecialPoint

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
    from osculant.cas.zeros.points import SpecialPoint

    (whole,) = division.stretches
    with precision(PRECISION):
        start, period = SpecialPoint(arb(at), frozenset()), whole.high - whole.low
        passed = [*whole.passed, *(point + period for point in whole.passed)]
        joint = Joint(start.at, frame_at(curve, start, -1), start.at, frame_at(curve, start, 1), at)
        [stretch] = between(curve, joint, replace(joint, low=start.at + period), whole.kind, passed, False)
        return stretch
