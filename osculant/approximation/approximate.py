"""Approximating a curve: by a tolerance or by a number of pieces, in any metric, in the plane or in space."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from osculant.approximation.bridging import allowed_extent, crowded, flat_enough, width
from osculant.approximation.closing import closing
from osculant.approximation.division import chord_of, divide, is_exact
from osculant.approximation.hypotheses import hold
from osculant.approximation.prediction import prediction, quick_complexity
from osculant.approximation.request import requested
from osculant.approximation.runs import StuckError, whole_error
from osculant.cas.errors import DomainError
from osculant.primitives.table import choose
from osculant.spline import Minimal, Prediction, Spline
from osculant.tolerances import FLOOR_ULPS, check_floor, window, writing_share

if TYPE_CHECKING:
    from osculant.approximation.fitting import Fitted
    from osculant.approximation.runs import Part, Progress, Run
    from osculant.curves.curve import FormulaCurve
    from osculant.curves.extent import Extent
    from osculant.primitives.primitive import Fit

#: of smaller curves, and of those larger than its inverse, no areas are computed
SMALLEST = 1e-130
#: places where a search may be stuck
MOST_STUCK = 30


def approximate_curve(
    curve: FormulaCurve,
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
    reserved: float = 0.0,
) -> Spline:
    """What `osculant.approximate` says, for one primitive, with so much of the tolerance left for writing."""
    fit = choose(primitive, metric, rule, dimension=curve.dimension, curve=curve.text)
    asked, count = requested(tolerance, pieces)
    allowed = asked - reserved
    curve.check_finite()

    from osculant.approximation.fitting import Fitting  # these load the kernels: only once there is work
    from osculant.curves.extent import extent

    size = extent(curve)
    check_areas(curve, size, fit)
    rounding = size.rounding(fit.degree)
    if count is None:
        check_floor(allowed, rounding, size.largest)
    # a search for the best beginning takes errors that are monotone
    closed_how = closing(curve, closed, seam=not fit.primitive.monotone)

    def fitted(stuck: Sequence[float] | None, lead: bool = False) -> Fitted:
        """The pieces, with small arcs passed over, also where the search was stuck; None: without that."""
        level = allowed if count is None else FLOOR_ULPS * rounding
        passed_over = 0.0 if stuck is None else allowed_extent(level, fit.degree)
        flat = passed_over if stuck and fit.degree == 1 else flat_enough(level, fit.degree, size.size)
        off = math.inf
        if closed_how == "open" and not split_at and count is None and not is_exact(curve, primitive):
            off = width(curve, flat)  # what the curve is exactly is better than its chord
        if off <= flat:
            division = chord_of(curve, off)
        else:
            division = divide(
                curve, primitive, tuple(split_at), closed_how, split, passed_over, tuple(stuck or ()), lead
            )
        fitting = Fitting(curve, fit, division, size, allowed if count is None else None)
        if count is not None:
            return fitting.for_number(count)
        return (
            fitting.for_area(allowed, progress)
            if metric == "area"
            else fitting.for_tolerance(allowed, progress)
        )

    found, places = _unstuck(fitted)
    crowds = crowded(curve, found.runs, allowed_extent(allowed, fit.degree)) if count is None else []
    if crowds:
        places = [*places, *crowds]
        found = _fewest(lambda: found, lambda: fitted(places), lambda: fitted(places, lead=True)) or found
    if count is not None:
        error = whole_error(found.runs, fit.degree)
        asked = allowed = error + writing_share(error, rounding)

    def needed(part: Part, run: Run) -> int:
        """How many pieces a stretch takes in any case."""
        if not part.exact:
            return 1
        return len(run if count is None else part.greedy(math.inf, math.inf))

    def predict() -> Prediction:
        least = tuple(map(needed, found.parts, found.runs))
        law = quick_complexity(curve, fit, found.division, least, size.scale)
        return prediction(law, allowed, found.count)

    return Spline(
        curve=curve,
        primitive=primitive,
        metric=metric,
        rule=fit.rule,
        tolerance=asked,
        reserved=reserved if count is None else 0.0,
        pieces=tuple(found.pieces()),
        judge=lambda: _minimal(curve, found, fit, rounding, allowed if count is None else None),
        undecided=found.division.undecided,
        bridged=found.division.bridged,
        splits=found.division.splits,
        closed=closed_how != "open",
        split=split,
        given="tolerance" if count is None else "pieces",
        gap=found.gap,
        predict=predict,
    )


def _unstuck(fitted: Callable[..., Fitted]) -> tuple[Fitted, list[float]]:
    """What is found once small arcs are passed over wherever the search is stuck, and where that is.

    It is so often, but not forever.  Where it is stuck only because an arc at an end is passed over, none is,
    or small pieces lead there.
    """
    places: list[float] = []
    while True:
        try:
            return fitted(places), places
        except StuckError as error:
            if error.at in places or len(places) == MOST_STUCK:
                raise
            if not places:
                found = _fewest(lambda: fitted(None), lambda: fitted((), lead=True))
                if found is not None:
                    return found, places
            places.append(error.at)


def _fewest(*ways: Callable[[], Fitted]) -> Fitted | None:
    """What takes the fewest pieces of what some ways find, the first of them; None if all are stuck."""
    found = []
    for way in ways:
        with suppress(StuckError):
            found.append(way())
    return min(found, key=lambda one: one.count, default=None)


def check_areas(curve: FormulaCurve, size: Extent, fit: Fit) -> None:
    """Raises DomainError if errors are areas and doubles cannot hold those of a curve of this size."""
    if fit.degree == 2 and not SMALLEST < size.size < 1 / SMALLEST:
        raise DomainError(
            f"The curve {curve.text} has the size {size.size:.3g}, and areas of such curves leave the range "
            "of double numbers: scale it."
        )


def _minimal(
    curve: FormulaCurve, found: Fitted, fit: Fit, rounding: float, tolerance: float | None
) -> Minimal:
    """Whether the number of pieces, or, if that was given and no tolerance, their error, is the least."""
    division, error = found.division, whole_error(found.runs, 1)
    if tolerance is not None and found.count == 1:
        return "proved"
    if division.undecided or division.bridged or not division.proved:
        return "unknown"
    if tolerance is not None and found.count == len(division.stretches):
        return "proved"  # every stretch takes at least one piece
    if tolerance is None and error == 0:
        return "proved"  # no errors are less
    if fit.theorem is None or (tolerance is not None and fit.degree == 2):
        return "unknown"  # no theorem is about sums of areas
    if tolerance is None and error < FLOOR_ULPS * rounding:
        return "unknown"  # errors that rounding may have made
    if not found.certain or division.unsplit or any(part.exact for part in found.parts):
        return "unknown"
    if hold(fit.theorem, curve, found):
        return "by theory"
    if tolerance is None:
        return "unknown"
    from osculant.approximation.backward import from_the_end  # it loads the kernels

    other = from_the_end(found, window(tolerance, rounding)[1])  # either way will do
    return "by theory" if other is not None and hold(fit.theorem, curve, other) else "unknown"
