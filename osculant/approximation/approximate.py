"""Approximating a plane curve: by a tolerance or by a number of pieces, in either metric."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

from osculant.approximation.closing import closing
from osculant.approximation.division import check_finite, divide
from osculant.approximation.predicted import Prediction
from osculant.approximation.prediction import quick_complexity
from osculant.approximation.request import requested
from osculant.approximation.runs import whole_error
from osculant.cas.errors import DomainError, UndecidedError
from osculant.primitives.table import PRIMITIVES, choose, first_rule
from osculant.spline import Spline
from osculant.tolerances import FLOOR_ULPS, check_floor, reserve

if TYPE_CHECKING:
    from osculant.approximation.fitting import Fitting
    from osculant.approximation.runs import Progress, Run
    from osculant.curves.extent import Extent
    from osculant.curves.plane import PlaneCurve
    from osculant.primitives.table import Fit

#: of smaller curves, and of those larger than its inverse, no areas are computed
SMALLEST = 1e-130


def approximate_in_plane(
    curve: PlaneCurve,
    primitive: str,
    tolerance: float | None,
    *,
    pieces: int | None,
    rule: str | None,
    metric: str,
    closed: bool | None,
    split: str,
    split_at: Sequence[Any],
    progress: Progress | None,
) -> Spline:
    """What `osculant.approximate` says, for a curve in the plane and one primitive."""
    fit = choose(primitive, metric, rule)
    allowed, count = requested(tolerance, pieces)
    check_finite(curve)

    from osculant.approximation.fitting import (
        Fitting,  # these load the kernels: only once something is to be fitted
    )
    from osculant.curves.extent import extent

    size = extent(curve)
    check_areas(curve, size, fit)
    rounding = size.rounding(fit.dimension)
    if count is None:
        check_floor(allowed, rounding, size.largest)
    closed_how = closing(curve, closed)
    division = divide(curve, primitive, split_at, closed_how, split)
    fitting = Fitting(curve, primitive, fit, division, size)
    if count is not None:
        runs = fitting.of_number(count)
        error = whole_error(runs, fit.dimension)
        allowed = error + reserve(error, rounding)
    elif metric == "area":
        runs = fitting.of_area(allowed, progress)
    else:
        runs = fitting.within(allowed, progress)
    made = tuple(fitting.pieces(runs))
    least = tuple(len(run) if part.exact else 1 for part, run in zip(fitting.parts, runs, strict=True))
    law = partial(quick_complexity, curve, primitive, fitting.division, least, size.scale, metric)
    return Spline(
        curve=curve,
        primitive=primitive,
        metric=metric,
        rule=rule or first_rule(primitive, metric),
        tolerance=allowed,
        pieces=made,
        minimal=_minimal(fitting, runs, count is None),
        undecided=fitting.division.undecided,
        splits=fitting.division.splits,
        closed=closed_how != "open",
        split=split,
        given="tolerance" if count is None else "pieces",
        gap=fitting.gap,
        predict=lambda: Prediction.of(law(), allowed, len(made)),
    )


def check_areas(curve: PlaneCurve, size: Extent, fit: Fit) -> None:
    """Raises DomainError if errors are areas and doubles cannot hold those of a curve of this size."""
    if fit.dimension == 2 and not SMALLEST < size.size < 1 / SMALLEST:
        raise DomainError(
            f"The curve {curve.text} has the size {size.size:.3g}, and areas of such curves leave the range "
            "of double numbers: scale it."
        )


def _minimal(
    fitting: Fitting, runs: list[Run], by_tolerance: bool
) -> Literal["proved", "by theory", "unknown"]:
    """Whether the number of pieces, or, if that was given, their error, is the least."""
    division, count = fitting.division, sum(map(len, runs))
    if division.undecided or not division.proved:
        return "unknown"
    if count == len(division.stretches) if by_tolerance else whole_error(runs, 1) == 0:
        return "proved"  # every stretch takes at least one piece, and no error is less than 0
    if not by_tolerance and whole_error(runs, 1) < FLOOR_ULPS * fitting.size.rounding(fitting.fit.dimension):
        return "unknown"  # errors that rounding may have made
    if not fitting.certain or division.unsplit or any(part.exact for part in fitting.parts):
        return "unknown"
    return "by theory"


def approximate_with_least_numbers(
    curve: PlaneCurve, tolerance: float | None, *, pieces: int | None, rule: str | None, **wanted: Any
) -> Spline:
    """The spline of the primitive that takes the fewest numbers to store; `Spline.choice` tells of all.

    Raises DomainError with a number of pieces or a rule, which belong to one primitive, and whatever the
    last primitive raises if none can approximate the curve.
    """
    for name, value in (("number of pieces", pieces), ("rule", rule)):
        if value is not None:
            raise DomainError(
                f"The {name} {value!r} belongs to one primitive: name that and not 'best', or leave it out."
            )
    found: list[Spline] = []
    reasons: list[str] = []
    for primitive in PRIMITIVES:
        try:
            spline = approximate_in_plane(curve, primitive, tolerance, pieces=None, rule=None, **wanted)
        except UndecidedError as error:
            reasons.append(f"{primitive}: {error}")
            failure = error
            continue
        found.append(spline)
        reasons.append(f"{primitive}: {len(spline)} pieces, {spline.numbers} numbers")
    if not found:
        raise failure
    best = min(found, key=lambda spline: spline.numbers)
    return replace(best, choice=tuple(reasons))
