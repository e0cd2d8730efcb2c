"""Approximating a space curve by bihelices, and how many theory predicts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from osculant.approximation.closing import ends_meet
from osculant.approximation.predicted import Prediction
from osculant.approximation.prediction import Complexity
from osculant.approximation.request import requested
from osculant.approximation.space_stretches import LAWS, SpaceDivision, check_finite, divide
from osculant.cas.errors import DomainError
from osculant.curves.curve import FormulaCurve
from osculant.spline import Spline
from osculant.tolerances import check_floor, reserve

if TYPE_CHECKING:
    from osculant.approximation.runs import Progress
    from osculant.curves.space import SpaceCurve

#: how the junction of a bihelix is chosen; the first is the default
RULES = ("equioscillating", "thesis")
#: digits of the constants of `complexity_in_space`
DIGITS = 20


def approximate_in_space(
    curve: FormulaCurve,
    primitive: str = "bihelix",
    tolerance: float | None = None,
    *,
    pieces: int | None = None,
    rule: str | None = None,
    metric: str = "hausdorff",
    closed: bool | None = None,
    split: str = "theory",
    split_at: Sequence[Any] = (),
    progress: Progress | None = None,
) -> Spline:
    """A tangent-continuous spline of bihelices (pairs of helical arcs): few for a tolerance, or so many.

    Args:
        curve: with its interval.
        primitive: "bihelix"; "best" means the same, there being no other in space.
        tolerance: the Hausdorff distance allowed, in the units of the coordinates; 1e-6 unless ``pieces`` is
            given.
        pieces: a number of pieces instead: the least greatest error found, for which all errors between two
            split points are equal.
        rule: "equioscillating" (the default) makes the errors on both sides of the junction equal; "thesis"
            takes the junction of section 4.1.2 and needs one or two pieces more.
        metric: "hausdorff".
        closed: True if the ends have to meet. They are a knot in any case.
        split: "theory" has knots at cusps, points with κ = 0 and vertices, "never" not at vertices.
        split_at: parameter values that shall be knots besides.
        progress: called now and then with the part of the interval done, 0…1.

    Returns a `Spline`. Straight lines, circles and helices become single pieces that are exact, each
    turning by less than 2π; a planar curve becomes a spline of biarcs. The errors are estimates of the
    two-sided Hausdorff distance, not certificates. The number of pieces is not proved to be the least, nor
    the error of a given number: the error of a bihelix is monotone in the length of the arc only while it is
    small. While it is, a spline of n pieces with the error e is found again for the tolerance e(1 + 1e-9).

    Raises DomainError where the curve is undefined or no space curve, for fewer pieces than it takes, for an
    open curve that is to be closed, or a choice that does not exist; ToleranceError for a tolerance that is
    not a positive number or lies below the rounding floor; UndecidedError where a cap was reached.

    Source: thesis, section 4.5 and what is missing after it, reconstructed.

    >>> from osculant.curves.space import SpaceCurve
    >>> helix = SpaceCurve("3*cos(t), 3*sin(t), 4*t", 0, "4*pi")
    >>> spline = approximate_in_space(helix)
    >>> len(spline), spline.error_kind, spline.minimal, round(spline.pieces[0].arcs[0].torsion, 12)
    (3, 'exact', 'unknown', 0.16)
    >>> cone = approximate_in_space(SpaceCurve("t*cos(t), t*sin(t), t", "pi/6", "2*pi"), pieces=19)
    >>> f"{cone.error:.3g}", max(cone.errors) - min(cone.errors) < 1e-9 * cone.error
    ('9.01e-05', True)
    """
    curve = _checked(curve, "bihelix" if primitive == "best" else primitive, metric)
    rule = RULES[0] if rule is None else rule
    if rule not in RULES:
        raise DomainError(f"The rule {rule!r} is unknown: choose one of {', '.join(RULES)}.")
    allowed, count = requested(tolerance, pieces)
    check_finite(curve)

    from osculant.approximation.space_fitting import SpaceFitting  # these load the kernels
    from osculant.curves.extent import extent

    size = extent(curve)
    if count is None:
        check_floor(allowed, size.rounding(), size.largest)
    is_closed = ends_meet(curve, closed)
    division = divide(curve, split_at, split)
    fitting = SpaceFitting(curve, rule, division, size)
    if count is None:
        runs = fitting.within(allowed, progress)
    else:
        runs = fitting.of_number(count)
        error = max(run.error for run in runs)
        allowed = error + reserve(error, size.rounding())
    made = tuple(fitting.pieces(runs))
    least = tuple(part.least if part.exact else 1 for part in fitting.parts)
    certain = count is None and not division.undecided and division.proved
    spline = Spline(
        curve=curve,
        primitive="bihelix",
        metric=metric,
        rule=rule,
        tolerance=allowed,
        pieces=made,
        minimal="proved" if certain and len(made) == len(division.stretches) else "unknown",
        undecided=division.undecided,
        splits=division.splits,
        closed=is_closed,
        split=split,
        given="tolerance" if count is None else "pieces",
        predict=lambda: Prediction.of(_law(curve, division, least), allowed, len(made)),
    )
    if primitive == "best":
        spline = replace(spline, choice=(f"bihelix: {len(made)} pieces, {spline.numbers} numbers",))
    return spline


def complexity_in_space(
    curve: FormulaCurve,
    primitive: str = "bihelix",
    *,
    metric: str = "hausdorff",
    split_at: Sequence[Any] = (),
) -> Complexity:
    """How many bihelices theory predicts: 324^{−1/3} ∫|κ′|^{1/3} ds · ε^{−1/3}, stretch by stretch.

    On a curve of constant curvature that is 0, and 5760^{−1/4} ∫|κτ′|^{1/4} ds ε^{−1/4} takes its place.
    A straight line, circle or helix has the constant 0. Arguments and errors as for `approximate_in_space`.

    >>> from osculant.curves.space import SpaceCurve
    >>> law = complexity_in_space(SpaceCurve("t, t^2, t^3", 0, 1))
    >>> law.constants, law.order, law.count(1e-8)
    (('0.24808651560647953918',), 3, 116)
    """
    curve = _checked(curve, primitive, metric)
    check_finite(curve)
    division = divide(curve, split_at)
    least = []
    for stretch in division.stretches:
        least.append(1)
        if stretch.shape == "exact":
            from osculant.approximation.exact_helices import Helices

            least[-1] = Helices(curve, stretch).least
    return _law(curve, division, tuple(least))


def _law(curve: SpaceCurve, division: SpaceDivision, least: tuple[int, ...]) -> Complexity:
    from flint import arb

    from osculant.cas.laws.complexity import complexity_constant
    from osculant.cas.laws.table import law_of
    from osculant.cas.numbers.balls import PRECISION, precision

    constants = []
    for stretch in division.stretches:
        if stretch.shape not in LAWS:
            constants.append("0")
            continue
        ends = pairwise([stretch.low, *stretch.passed, stretch.high])
        with precision(PRECISION):
            law = LAWS[stretch.shape]
            value = sum((complexity_constant(curve.balls, law, *pair)[0] for pair in ends), arb(0))
        constants.append(value.str(DIGITS, radius=False))
    shape = division.stretches[0].shape
    order = law_of(LAWS.get(shape, "bihelix")).spline_order
    return Complexity("bihelix", "hausdorff", order, tuple(constants), least, DIGITS)


def _checked(curve: FormulaCurve, primitive: str, metric: str) -> SpaceCurve:
    from osculant.curves.space import SpaceCurve

    if not isinstance(curve, SpaceCurve):
        raise DomainError(
            f"Bihelices approximate curves in space and {curve.text} has two coordinates: "
            "choose conic, parabola or biarc, or add a third coordinate such as 0."
        )
    if primitive != "bihelix":
        raise DomainError(
            f"A curve in space is approximated with bihelix, not {primitive!r}: "
            "choose bihelix, or leave out the third coordinate."
        )
    if metric == "area":
        raise DomainError(
            f"The metric 'area' is one of plane curves, and {curve.text} has three coordinates: "
            "choose hausdorff, or leave out the third coordinate."
        )
    if metric != "hausdorff":
        raise DomainError(f"The metric {metric!r} is unknown: choose hausdorff.")
    return curve
