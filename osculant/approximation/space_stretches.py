"""Dividing a space curve's interval where a spline of bihelices shall have a knot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

from osculant.approximation.request import check_split
from osculant.approximation.split_points import as_float, cut
from osculant.cas.errors import DomainError, UndecidedError

if TYPE_CHECKING:
    from osculant.cas.zeros.form_zeros import SpecialPoint
    from osculant.curves.space import SpaceCurve

#: derivatives tried for the limit tangent at a cusp
CUSP_ORDERS = 9

Vector = tuple[float, float, float]
#: "level" is a curve of constant curvature and varying torsion: every point would be a vertex
Shape = Literal["generic", "level", "segment", "exact"]
#: the name of the law of bihelices along a curve of that shape
LAWS = {"generic": "bihelix", "level": "level bihelix"}


@dataclass(frozen=True)
class SpaceFrame:
    """A point of the curve and its unit tangent, at a cusp the limit tangent from the stretch's side."""

    point: Vector
    tangent: Vector


@dataclass(frozen=True)
class SpaceStretch:
    """A part of the interval without special points inside.

    ``low``, ``high`` are balls, ``a``, ``b`` their nearest doubles; ``shape`` says whether the curve is a
    segment there, a circle or helix itself ("exact"), or has constant curvature ("level").  ``passed`` are
    the vertices inside, balls, if they are not to split.
    """

    low: Any
    high: Any
    a: float
    b: float
    start: SpaceFrame
    end: SpaceFrame
    shape: Shape
    passed: tuple[Any, ...] = ()


@dataclass(frozen=True)
class SpaceDivision:
    """The stretches of a curve, the inner split points and those of them that were not decided.

    ``proved`` is False if the curve seems to be a segment, a circle or a helix, to hundreds of digits, but no
    symbolic proof was found.
    """

    stretches: tuple[SpaceStretch, ...]
    splits: tuple[float, ...]
    undecided: tuple[float, ...]
    proved: bool


def check_finite(curve: SpaceCurve) -> None:
    """Raises DomainError, naming the parameter value, where the curve is undefined or not smooth.

    >>> from osculant.curves.space import SpaceCurve
    >>> check_finite(SpaceCurve("t, t^2, 1/t", -1, 1))
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: The curve is undefined or infinite at t = 0 (a division by zero): take
    an interval without it.
    """
    from osculant.cas.zeros.space import require_finite

    require_finite(curve.balls, *curve.ends)


def divide(curve: SpaceCurve, split_at: Sequence[Any] = (), split: str = "theory") -> SpaceDivision:
    """Divide the curve at its cusps, where κ = 0 and at its vertices (κ′ = 0), also at the user's points.

    With ``split="never"`` not at its vertices. The curve has to be finite: see `check_finite`. Raises
    DomainError for a split point outside the interval, an unknown word, or if the curve is a single point.

    >>> from osculant.curves.space import SpaceCurve
    >>> divide(SpaceCurve("2*cos(t), sin(t), t/5", "1", "4")).splits
    (1.5707963267948966, 3.141592653589793)
    >>> divide(SpaceCurve("2*cos(t), sin(t), t/5", "1", "4"), split="never").splits
    ()
    """
    from osculant.cas.numbers.balls import PRECISION, constant, precision
    from osculant.cas.zeros.space import special_points, vanishes

    check_split(split)
    shape, proved = _shape(curve)
    names = ["cusp"]
    names += ["inflection"] if shape != "segment" else []
    names += ["vertex"] if shape == "generic" else []
    skipped = {"vertex"} if split == "never" else set[str]()
    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        planar = (
            shape == "generic" and vanishes(curve.balls, "planar", low, high) and curve.exact.planar is True
        )
        every = special_points(curve.balls, *curve.ends, names, planar)
        found = [point for point in every if not point.kinds <= skipped]
        passed = [point.at for point in every if point.kinds <= skipped]
        points, cuts = cut(curve, found, split_at, low, high)
        stretches = tuple(_stretch(curve, *ends, shape, passed) for ends in pairwise(cuts))
    return SpaceDivision(
        stretches,
        tuple(as_float(point.at) for point in points),
        tuple(as_float(point.at) for point in found if not point.decided),
        proved,
    )


def _shape(curve: SpaceCurve) -> tuple[Shape, bool]:
    """What the curve is as a whole, and whether that is certain."""
    from osculant.cas.numbers.balls import PRECISION, constant, precision
    from osculant.cas.zeros.space import vanishes

    with precision(PRECISION):
        low, high = (constant(end) for end in curve.ends)
        if vanishes(curve.balls, "cusp", low, high):
            raise DomainError(f"The curve {curve.text} is a single point: give a formula that moves.")
        if vanishes(curve.balls, "inflection", low, high):
            return "segment", curve.exact.straight is True
        if not vanishes(curve.balls, "vertex", low, high):
            return "generic", True
        if not vanishes(curve.balls, "slope", low, high):
            return "level", True
    return "exact", curve.exact.circular_helix is True


def _stretch(
    curve: SpaceCurve, before: SpecialPoint, after: SpecialPoint, shape: Shape, passed: Sequence[Any]
) -> SpaceStretch:
    a, b = as_float(before.at), as_float(after.at)
    return SpaceStretch(
        before.at,
        after.at,
        a,
        b,
        _frame(curve, before, 1),
        _frame(curve, after, -1),
        shape,
        tuple(at for at in passed if a < as_float(at) < b),
    )


def _frame(curve: SpaceCurve, point: SpecialPoint, side: int) -> SpaceFrame:
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
            x, y, z = (as_float(row[0]) for row in rows)
            tx, ty, tz = (as_float(sign * part / length) for part in parts)
            return SpaceFrame((x, y, z), (tx, ty, tz))
    raise UndecidedError(
        f"The curve has no tangent at t = {as_float(point.at):.10g} that {CUSP_ORDERS} derivatives could "
        "tell: choose an interval without this point."
    )
