"""The public functions: `curve`, `approximate`, `complexity`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Literal

from osculant.asymptotics import Complexity, complexity_of, quick_complexity
from osculant.biarcs import Biarc
from osculant.cas.errors import DomainError
from osculant.formula_curve import coordinates_of
from osculant.pieces import Piece
from osculant.plane import PlaneCurve
from osculant.primitives import PRIMITIVES
from osculant.space import SpaceCurve
from osculant.space_spline import SpaceSpline
from osculant.spline import Spline
from osculant.stretches import Division, check_finite, divide
from osculant.tolerances import check_floor, checked_tolerance

#: pieces that may be due to the window of errors before the least number is called unknown
CERTAIN_SLACK = 0.5


def curve(formulas: Any, low: Any = None, high: Any = None) -> PlaneCurve | SpaceCurve:
    """A plane or space curve from its formulas and, to approximate it, the ends of its interval.

    Args:
        formulas: text such as ``"t*cos(t), t*sin(t)"`` (a graph is ``"t, f(t)"``, a polar curve
            ``"r(t)*cos(t), r(t)*sin(t)"``), or two sympy or symengine expressions in t; three are a curve in
            space.
        low: where it begins: a formula without variables as text, a number, or a sympy constant.
        high: where it ends, likewise.

    Raises FormulaError or DomainError as `PlaneCurve` does.

    >>> curve("t, t^2", -1, "sqrt(2)")
    <PlaneCurve t, t**2, t from -1 to sqrt(2)>
    """
    coordinates = coordinates_of(formulas)
    return (SpaceCurve if len(coordinates) == 3 else PlaneCurve)(coordinates, low, high)


def approximate(
    curve: PlaneCurve | SpaceCurve,
    primitive: str | None = None,
    tolerance: float = 1e-6,
    *,
    rule: str | None = None,
    metric: str = "hausdorff",
    split_at: Sequence[Any] = (),
    progress: Callable[[float], None] | None = None,
) -> Spline | SpaceSpline:
    """The tangent-continuous spline with the fewest parabolas, conics or biarcs, in space bihelices.

    Args:
        curve: with its interval.
        primitive: "parabola", "conic" (the default in the plane) or "biarc" (two circular arcs with a common
            tangent, each piece turning by less than π, and by less than 2π where the curve is a circle); in
            space "bihelix" (two helical arcs).
        tolerance: the Hausdorff distance allowed, in the units of the coordinates.
        rule: of bihelices only, which junction: "equioscillating" (the default) or "thesis".
        metric: "hausdorff".
        split_at: parameter values that shall be knots besides those that theory demands.
        progress: called now and then with the part of the interval done, 0…1.

    Returns a `Spline`: its pieces' errors are measured on common normals of curve and piece after the
    search and lie within the tolerance; a piece that ends neither at a split point nor at the end
    has its error in [ε(1−δ), ε], δ = max(1e-6, 32 ulp(largest coordinate)/ε).  The errors are
    estimates, not certificates.  They are Hausdorff distances while smaller than the curve's radii of
    curvature; beyond, upper bounds of them.

    Raises DomainError where the curve is undefined, ToleranceError for a tolerance that is not a
    positive number or lies below the rounding floor, UndecidedError where a cap was reached.

    Source: thesis, sections 3.3 and 3.7, and chapter 5 as reconstructed for biarcs.

    >>> import osculant as osc
    >>> spline = osc.approximate(osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "conic", 1e-4)
    >>> len(spline), spline.predicted_pieces, spline.minimal
    (9, 9, 'by theory')
    """
    primitive = primitive or _usual(curve)
    if isinstance(curve, SpaceCurve) or primitive == "bihelix":
        from osculant.space_approximation import RULES, approximate_in_space

        return approximate_in_space(
            curve,
            primitive,
            tolerance,
            rule=rule or RULES[0],
            metric=metric,
            split_at=split_at,
            progress=progress,
        )
    if rule is not None:
        raise DomainError(f"The rule {rule!r} is for bihelices, and {primitive!r} has none: leave it out.")
    _check_choices(primitive, metric)
    tolerance = checked_tolerance(tolerance)
    check_finite(curve)

    from osculant.extent import extent
    from osculant.fitting import Fitting  # these load the kernels: only once something is to be fitted

    size = extent(curve)
    check_floor(tolerance, size.largest)
    division = divide(curve, primitive, split_at)
    fitting = Fitting(curve, primitive, tolerance, division, size)
    pieces: list[Piece | Biarc] = []
    least: list[int] = []
    for stretch in division.stretches:
        found = fitting.pieces(stretch, progress)
        pieces += found
        least.append(len(found) if stretch.kind == "exact" else 1)
    law = partial(quick_complexity, curve, primitive, division, tuple(least), size.scale)
    return Spline(
        curve,
        primitive,
        metric,
        tolerance,
        tuple(pieces),
        _minimal(division, len(pieces), fitting.limited or fitting.slack * len(pieces) > CERTAIN_SLACK),
        division.undecided,
        division.splits,
        lambda: _Prediction(law(), tolerance),
    )


def complexity(
    curve: PlaneCurve | SpaceCurve,
    primitive: str | None = None,
    *,
    metric: str = "hausdorff",
    split_at: Sequence[Any] = (),
    next_term: bool = False,
) -> Complexity:
    """How many pieces theory predicts: leading constant, order, and ``count(tolerance)``.

    Formulas (3.17) and (3.18), integrated over every stretch between special points; with ``next_term`` also
    the second term's c₁, ``next_constant`` (open in section 3.8; it takes seconds, and the curve may have no
    special point: DomainError).  Other arguments and errors as for `approximate`.

    >>> law = complexity(curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "conic")
    >>> law.constants, law.order, law.count(1e-8)
    (('1.2695901170369955254',), 5, 51)
    """
    primitive = primitive or _usual(curve)
    if isinstance(curve, SpaceCurve) or primitive == "bihelix":
        from osculant.space_approximation import complexity_in_space

        if next_term:
            raise DomainError("The second term is not known for bihelices: ask without next_term.")
        return complexity_in_space(curve, primitive, metric=metric, split_at=split_at)
    _check_choices(primitive, metric)
    check_finite(curve)
    division = divide(curve, primitive, split_at)
    return complexity_of(curve, primitive, division, (1,) * len(division.stretches), next_term)


def _usual(curve: PlaneCurve | SpaceCurve) -> str:
    return "bihelix" if isinstance(curve, SpaceCurve) else "conic"


class _Prediction:
    """A complexity at one tolerance."""

    def __init__(self, law: Complexity, tolerance: float) -> None:
        self.predicted = law.predicted(tolerance)
        self.predicted_pieces = law.predicted_pieces(tolerance)


def _minimal(division: Division, count: int, limited: bool) -> Literal["proved", "by theory", "unknown"]:
    if division.undecided or not division.proved:
        return "unknown"
    if count == len(division.stretches):
        return "proved"  # every stretch takes at least one piece
    if limited or any(stretch.kind == "exact" for stretch in division.stretches):
        return "unknown"
    return "by theory"


def _check_choices(primitive: str, metric: str) -> None:
    if primitive not in PRIMITIVES:
        raise DomainError(f"The primitive {primitive!r} is unknown: choose one of {', '.join(PRIMITIVES)}.")
    if metric != "hausdorff":
        raise DomainError(f"The metric {metric!r} is unknown: choose hausdorff.")
