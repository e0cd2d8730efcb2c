"""Certificates: the errors of a spline in the plane enclosed, for the very numbers that are stored.

A piece's doubles are exact rationals, and so are the knots between pieces. The first and the last piece reach
to the exact ends of the curve's interval, so that the whole curve is covered. What is enclosed is, for each
piece, the Hausdorff distance to its arc of the curve; of a biarc, to the arcs in `Biarc.arcs`.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError
from osculant.pieces.chain import conic_arcs, plane_arcs
from osculant.pieces.cubics import Cubic

if TYPE_CHECKING:
    from osculant.cas.geometry.point_distance import Coefficients, PlaneArc
    from osculant.curves.plane import PlaneCurve
    from osculant.pieces.piece import PieceLike

#: bits of the balls, and those tried where a bound is not finite, or far above what was found from below
BITS = (128, 320)
#: a knot nearer to an end than this part of the interval, or of the end itself, stands for the end
APART = 2.0**-51

Knots = tuple[Any, Any]


@dataclass(frozen=True)
class PieceBounds:
    """The Hausdorff distance of one piece and its arc of the curve lies in [lower, upper].

    Attributes:
        lower: so far at least is the curve's point at ``at`` from the whole piece, or the point of the piece
            that is compared with it from the whole arc of the curve.
        upper: infinite if none was proved.
        at: that parameter, rounded.
        reason: why there is no upper bound; None if there is one.
    """

    lower: float
    upper: float
    at: float
    reason: str | None = None

    def to_json(self) -> dict[str, Any]:
        """Return the bounds as plain data, null for an infinite one."""
        upper = self.upper if math.isfinite(self.upper) else None
        return {"lower": self.lower, "upper": upper, "at": self.at, "reason": self.reason}


@dataclass(frozen=True)
class Certificate:
    """Proved bounds of a spline's error: the largest distance of a piece and its arc of the curve.

    So ``upper`` bounds the Hausdorff distance of curve and spline as a whole, too.

    Attributes:
        pieces: the bounds piece by piece.
        tolerance: what the error should be within.
        bits: the precision of the balls that was needed.
        seconds: how long it took.

    >>> proof = Certificate((PieceBounds(0.9e-6, 1e-6, 0.5), PieceBounds(0.0, 2e-6, 1.5)), 1e-6, 128, 0.01)
    >>> proof.lower, proof.upper, proof.within
    (9e-07, 2e-06, False)
    """

    pieces: tuple[PieceBounds, ...]
    tolerance: float
    bits: int
    seconds: float

    @property
    def lower(self) -> float:
        """The largest of the pieces' lower bounds: the error is at least this."""
        return max(piece.lower for piece in self.pieces)

    @property
    def upper(self) -> float:
        """The largest of the pieces' upper bounds, infinite if one has none: the error is at most this."""
        return max(piece.upper for piece in self.pieces)

    @property
    def within(self) -> bool:
        """Whether it is proved that the error is within the tolerance."""
        return self.upper <= self.tolerance

    def to_json(self) -> dict[str, Any]:
        """Return the certificate as plain data: its bounds (null for an infinite one) and each piece's."""
        return {
            "lower": self.lower,
            "upper": self.upper if math.isfinite(self.upper) else None,
            "within": self.within,
            "bits": self.bits,
            "seconds": self.seconds,
            "pieces": [piece.to_json() for piece in self.pieces],
        }


def certify(
    curve: object,
    pieces: Sequence[PieceLike],
    tolerance: float,
    progress: Callable[[float], None] | None = None,
) -> Certificate:
    """Enclose the Hausdorff distance of each piece and its arc of the curve.

    Args:
        curve: a `PlaneCurve`; ends of its interval that the first or last knot is the double of are taken
            exactly.
        pieces: in order, each beginning where the one before ends.
        tolerance: what the error should be within.
        progress: called with the part of the pieces done, 0…1.

    Returns the certificate; a piece where no bound was found has the reason.

    Raises DomainError for pieces that leave a gap or are no arcs in the plane, and without a formula.

    Guarantee: both bounds are proved in ball arithmetic, whatever the floats that chose the maps. Where the
    curve's points have one nearest point each on the piece, or one each on their normals, they are usually
    within 10⁻⁶ of each other; where both jump (errors larger than radii of curvature) the upper one may be a
    tenth too large.

    >>> from osculant.pieces.conics import Piece
    >>> from osculant.curves.plane import PlaneCurve
    >>> chord = Piece.segment((0.0, 1.0), (0.0, 0.0), (1.0, 1.0))
    >>> proof = certify(PlaneCurve("t, t^2", 0, 1), [chord], 0.2)
    >>> round(proof.lower * 32**0.5, 4), round(proof.upper * 32**0.5, 4), proof.within
    (1.0, 1.0, True)
    """
    from osculant.cas.geometry.arc_distance import FAR
    from osculant.curves.plane import PlaneCurve

    began = time.perf_counter()
    plane_arcs(pieces)
    if not isinstance(curve, PlaneCurve):
        text = getattr(curve, "text", "this curve")
        raise DomainError(f"Of {text} only the text is known: certify what approximate returns.")
    for before, after in pairwise(pieces):
        if before.interval[1] != after.interval[0]:
            raise DomainError(
                f"One piece ends at t = {before.interval[1]!r} and the next begins at {after.interval[0]!r}: "
                "only pieces without gaps can be certified."
            )
    found = []
    needed = BITS[0]
    for i, piece in enumerate(pieces):
        for bits in BITS:
            bounds = _bounds(curve, piece, tolerance, bits, i == 0, i == len(pieces) - 1)
            if math.isfinite(bounds.upper) and bounds.upper <= max((1 + FAR) * bounds.lower, tolerance):
                break
        needed = max(needed, bits)
        found.append(bounds)
        if progress is not None:
            progress((i + 1) / len(pieces))
    return Certificate(tuple(found), tolerance, needed, time.perf_counter() - began)


def _bounds(
    curve: PlaneCurve, piece: PieceLike, tolerance: float, bits: int, first: bool, last: bool
) -> PieceBounds:
    """The bounds of one piece, which may be the first or last of all, at one precision."""
    from osculant.cas.geometry.arc_distance import distance
    from osculant.cas.geometry.point_distance import from_arc, from_point
    from osculant.cas.numbers.balls import precision

    balls = curve.balls.coefficients
    with precision(bits):
        arcs = _arcs(piece)
        cuts = _cuts(balls, piece, _ends(curve, piece.interval, first, last))
        each = [distance(balls, *cut, arc, tolerance) for cut, arc in zip(pairwise(cuts), arcs)]
        lower, at = -math.inf, piece.interval[0]
        for arc, one in zip(arcs, each):
            # from the other arc, or the other part of the curve, too, the point must be so far
            others = (
                from_point(balls, one.at, other) if one.of_curve else from_arc(balls, *cut, arc, one.foot)
                for cut, other in zip(pairwise(cuts), arcs)
                if other is not arc
            )
            value = min(_down(one.lower), *(_down(other) for other in others), math.inf)
            if value > lower:
                lower, at = value, float(one.at.mid())
        upper = max(_up(one.upper) for one in each)
        reason = None
        if not math.isfinite(upper):
            where = next(one.worst for one in each if not one.upper.is_finite())
            reason = (
                f"no finite Taylor series was found near t = {float(where.mid()):.10g} "
                f"({curve.balls.explain(where)})"
            )
    return PieceBounds(lower, upper, at, reason)


def _arcs(piece: PieceLike) -> list[PlaneArc]:
    from osculant.cas.geometry.conic_arcs import ConicArc
    from osculant.cas.geometry.cubic_arcs import CubicArc

    return [
        CubicArc(arc.start, arc.controls, arc.end)
        if isinstance(arc, Cubic)
        else ConicArc(arc.start, arc.middle, arc.end, arc.weight)
        for arc in plane_arcs([piece])
    ]


def _cuts(balls: Coefficients, piece: PieceLike, ends: Knots) -> list[Any]:
    """The ends, and for a biarc between them where the curve passes the junction."""
    from osculant.cas.geometry.arc_distance import parting

    if len(piece.arcs) == 1:
        return list(ends)
    junction = conic_arcs([piece])[1]
    tangent = junction.tangent(0.0).tolist()
    return [ends[0], parting(balls, *ends, piece.arc_ends[1], junction.start, tangent), ends[1]]


def _ends(curve: PlaneCurve, interval: tuple[float, float], first: bool, last: bool) -> Knots:
    """The knots as balls: exact doubles, but the ends of the curve's interval themselves."""
    from flint import arb

    from osculant.cas.numbers.balls import constant

    low, high = (constant(end) for end in curve.ends)
    start, end = map(arb, interval)
    near = (high - low + abs(high) + abs(start)) * APART
    if first and abs(start - low) < near:
        start = low
    if last:
        for whole in (high, start + (high - low)):  # the second of a closed curve that begins elsewhere
            if abs(end - whole) < near:
                end = whole
    return start, end


def _up(value: Any) -> float:
    """The least double that is not below."""
    rounded = float(value)
    return rounded if not value > rounded else math.nextafter(rounded, math.inf)


def _down(value: Any) -> float:
    rounded = float(value)
    return rounded if not value < rounded else math.nextafter(rounded, -math.inf)
