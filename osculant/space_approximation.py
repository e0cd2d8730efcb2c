"""Approximating a space curve by bihelices, and how many theory predicts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from osculant.asymptotics import Complexity
from osculant.cas.errors import DomainError
from osculant.formula_curve import FormulaCurve
from osculant.space_spline import SpaceSpline
from osculant.space_stretches import SpaceDivision, check_finite, divide
from osculant.tolerances import check_floor, checked_tolerance

if TYPE_CHECKING:
    from osculant.space import SpaceCurve

#: how the junction of a bihelix is chosen; the first is the default
RULES = ("equioscillating", "thesis")
#: digits of the constants of `complexity_in_space`
DIGITS = 20


def approximate_in_space(
    curve: FormulaCurve,
    primitive: str = "bihelix",
    tolerance: float = 1e-6,
    *,
    rule: str = RULES[0],
    metric: str = "hausdorff",
    split_at: Sequence[Any] = (),
    progress: Callable[[float], None] | None = None,
) -> SpaceSpline:
    """A tangent-continuous spline of bihelices, pairs of helical arcs, within a tolerance.

    Args:
        curve: with its interval.
        primitive: "bihelix".
        tolerance: the Hausdorff distance allowed, in the units of the coordinates.
        rule: "equioscillating" makes the errors on both sides of the junction equal; "thesis" takes the
            junction of section 4.1.2 and needs one or two pieces more.
        metric: "hausdorff".
        split_at: parameter values that shall be knots besides cusps, points with κ = 0 and vertices.
        progress: called now and then with the part of the interval done, 0…1.

    Returns a `SpaceSpline`. Straight lines, circles and helices become single pieces that are exact, each
    turning by less than 2π; a planar curve becomes a spline of biarcs. The errors are estimates of the
    two-sided Hausdorff distance, not certificates. The number of pieces is not proved to be the least: the
    error of a bihelix is monotone in the length of the arc only while it is small.

    Raises DomainError where the curve is undefined or no space curve, ToleranceError for a tolerance that is
    not a positive number or lies below the rounding floor, UndecidedError where a cap was reached.

    Source: thesis, section 4.5 and what is missing after it, reconstructed.

    >>> from osculant.space import SpaceCurve
    >>> helix = SpaceCurve("3*cos(t), 3*sin(t), 4*t", 0, "4*pi")
    >>> spline = approximate_in_space(helix)
    >>> len(spline), spline.error_kind, spline.minimal, round(spline.pieces[0].arcs[0].torsion, 12)
    (3, 'exact', 'unknown', 0.16)
    """
    curve = _checked(curve, primitive, metric)
    if rule not in RULES:
        raise DomainError(f"The rule {rule!r} is unknown: choose one of {', '.join(RULES)}.")
    tolerance = checked_tolerance(tolerance)
    check_finite(curve)

    from osculant.space_fitting import SpaceFitting, extent  # these load the kernels

    size = extent(curve)
    check_floor(tolerance, size.largest)
    division = divide(curve, split_at)
    fitting = SpaceFitting(curve, rule, tolerance, division, size)
    pieces, least = [], []
    for stretch in division.stretches:
        found = fitting.pieces(stretch, progress)
        pieces += found
        least.append(len(found) if stretch.shape in {"exact", "segment"} else 1)
    certain = not division.undecided and division.proved
    return SpaceSpline(
        curve,
        primitive,
        rule,
        metric,
        tolerance,
        tuple(pieces),
        "proved" if certain and len(pieces) == len(division.stretches) else "unknown",
        division.undecided,
        division.splits,
        lambda: _Prediction(_law(curve, division, tuple(least)), tolerance),
    )


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

    >>> from osculant.space import SpaceCurve
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
            from osculant.space_fitting import exact_pieces

            least[-1] = len(exact_pieces(curve, stretch))
    return _law(curve, division, tuple(least))


class _Prediction:
    """A complexity at one tolerance."""

    def __init__(self, law: Complexity, tolerance: float) -> None:
        self.predicted = law.predicted(tolerance)
        self.predicted_pieces = law.predicted_pieces(tolerance)


def _law(curve: SpaceCurve, division: SpaceDivision, least: tuple[int, ...]) -> Complexity:
    from osculant.cas.bihelix_law import LAWS, bihelix_constant

    constants = []
    for stretch in division.stretches:
        if stretch.shape not in LAWS:
            constants.append("0")
            continue
        value, _ = bihelix_constant(curve.balls, stretch.shape, stretch.low, stretch.high)
        constants.append(value.str(DIGITS, radius=False))
    shape = division.stretches[0].shape
    order = LAWS[shape if shape in LAWS else "generic"].order
    return Complexity("bihelix", "hausdorff", order, tuple(constants), least, DIGITS)


def _checked(curve: FormulaCurve, primitive: str, metric: str) -> SpaceCurve:
    from osculant.space import SpaceCurve

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
    if metric != "hausdorff":
        raise DomainError(f"The metric {metric!r} is unknown: choose hausdorff.")
    return curve
