"""Where the stretches of a curve meet: at a knot, or where an arc between them is passed over."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from osculant.approximation.bridging import Blemish, meeting
from osculant.approximation.split_points import as_float
from osculant.approximation.stretches import INSIDE, Frame, Kind, Stretch, Vector
from osculant.cas.errors import UndecidedError

if TYPE_CHECKING:
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.curves.curve import FormulaCurve

#: derivatives tried for the limit tangent at a cusp
CUSP_ORDERS = 9


@dataclass(frozen=True)
class Joint:
    """Where stretches meet: where the one before ends, where the one after begins, and what lies between.

    ``at`` is the knot of their pieces, None if there is a bridge, as small as ``reach``, between them.
    """

    low: Any
    end: Frame
    high: Any
    start: Frame
    at: float | None
    reach: float = 0.0


def joints_at(
    curve: FormulaCurve,
    knots: Sequence[tuple[Any, SpecialPoint]],
    passed_over: Sequence[Blemish],
    lead: bool,
) -> list[Joint]:
    """The joints at the knots, in order, and instead of knots in arcs that are passed over, those there."""
    found = [_passing(curve, blemish, lead) for blemish in passed_over]
    for at, point in knots:
        if not any(as_float(b.low) <= as_float(at) <= as_float(b.high) for b in passed_over):
            end = frame_at(curve, point, -1)
            start = end if end.order % 2 else frame_at(curve, point, 1)  # it may turn back
            found.append(Joint(at, end, at, start, as_float(at)))
    return sorted(found, key=lambda joint: as_float(joint.low))


def _passing(curve: FormulaCurve, blemish: Blemish, lead: bool) -> Joint:
    """The joint where an arc is passed over."""
    low, high, reach = blemish.low, blemish.high, blemish.reach
    ends = [tuple(as_float(row[0]) for row in curve.balls.coefficients(at, 0)) for at in (low, high)]
    if blemish.at_start or blemish.at_end:
        tangent = _regular(curve, high if blemish.at_start else low)
        first, last = (Frame(point, tangent) for point in ends)
        if lead:
            return Joint(low, first, high, last, None, reach)
        frame, at = (first, low) if blemish.at_start else (last, high)
        return Joint(low, frame, high, frame, as_float(at), reach)
    tangents = _regular(curve, low), _regular(curve, high)
    turn = meeting(*tangents)
    if turn is None:
        return Joint(low, Frame(ends[0], tangents[0]), high, Frame(ends[1], tangents[1]), None, reach)
    sign, tangent = turn
    point = tuple((p + q) / 2 for p, q in zip(*ends))
    back = tuple(sign * part for part in tangent)
    return Joint(low, Frame(point, tangent), high, Frame(point, back), as_float((low + high) / 2), reach)


def _regular(curve: FormulaCurve, at: Any) -> Vector:
    """The tangent at a parameter that is no special point."""
    from osculant.cas.zeros.points import SpecialPoint

    return frame_at(curve, SpecialPoint(at, frozenset()), 1).tangent


def between(
    curve: FormulaCurve, before: Joint, after: Joint, kind: Kind, passed: Sequence[Any], free: bool
) -> list[Stretch]:
    """The stretch between two joints, and the bridge at the first if there is one."""
    low, high = before.high, after.low
    a, b = as_float(low), as_float(high)
    inside = tuple(at for at in passed if a < as_float(at) < b or (free and as_float(at) == a))
    bend = curve.bend((low + (high - low) * INSIDE).mid())
    reach = max((joint.reach for joint in (before, after) if joint.at is not None), default=0.0)
    covers = (
        (a if before.at is None else before.at, b if after.at is None else after.at) if reach > 0 else None
    )
    whole = Stretch(low, high, a, b, before.start, after.end, kind, bend, inside, reach, covers)
    if before.at is not None:
        return [whole]
    return [bridge(before), whole]


def bridge(joint: Joint) -> Stretch:
    """The stretch of the small pieces at a joint."""
    a, b = as_float(joint.low), as_float(joint.high)
    return Stretch(joint.low, joint.high, a, b, joint.end, joint.start, "bridge", 1.0, (), joint.reach)


def frame_at(curve: FormulaCurve, point: SpecialPoint, side: int) -> Frame:
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
            return Frame(tuple(as_float(row[0]) for row in rows), tangent, order)
    raise UndecidedError(
        f"The curve has no tangent at t = {as_float(point.at):.10g} that {CUSP_ORDERS} derivatives could "
        "tell: choose an interval without this point."
    )
