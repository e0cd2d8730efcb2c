"""The public functions: `curve`, `approximate`, `complexity`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from osculant.approximation.best import approximate_best
from osculant.approximation.for_files import approximate_for, wanted_files
from osculant.approximation.prediction import Complexity, complexity_of_curve
from osculant.cas.errors import DomainError
from osculant.curves.curve import coordinates_of
from osculant.curves.plane import PlaneCurve
from osculant.curves.space import SpaceCurve
from osculant.primitives.table import USUAL
from osculant.spline import Spline


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
    tolerance: float | None = None,
    *,
    pieces: int | None = None,
    rule: str | None = None,
    metric: str = "hausdorff",
    closed: bool | None = None,
    split: str = "theory",
    split_at: Sequence[Any] = (),
    files: Any = None,
    progress: Callable[[float], None] | None = None,
) -> Spline:
    """The tangent-continuous spline with the fewest pieces for a tolerance, or the best of a given number.

    Args:
        curve: with its interval.
        primitive: "parabola", "conic" (the default in the plane), "biarc" (two circular arcs with a common
            tangent, each piece turning by less than π, and by less than 2π where the curve is a circle) or
            "cubic" (a Bézier curve, tangent at both ends with both arms free; it may pass inflections);
            "best" chooses the one that takes the fewest numbers to store, in the first of ``files`` if there
            are any (`Spline.choice` tells them; of equals the first named here), with the knots that
            ``split`` demands; in space "bihelix" (two helical arcs); in both "polygon" (inscribed chords,
            whose pieces are not tangent).
        tolerance: the error allowed, 1e-6 unless ``pieces`` is given.
        pieces: a number of pieces instead of a tolerance: the least greatest error of a piece, for which all
            errors between two split points are equal.
        rule: how a piece is chosen among those tangent to the curve at both ends: of conics in the metric
            "area" "equisymmetric" (the default; both moons are equal) or "minimal-area"; of bihelices
            "equioscillating" (the default) or "thesis".
        metric: "hausdorff", the distance, in the units of the coordinates; or "area", the area between the
            curve and the spline, of the whole curve, in which the areas of all pieces add up: the number is
            the least for which the spline of so many ``pieces`` is within the tolerance. Areas are those of
            the regions between each piece and its arc of the curve, also where the curve crosses itself.
        closed: True joins the ends of a closed curve, which then begins where that takes the fewest pieces;
            its knots may lie beyond the interval by less than a period. By default it is found out.
        split: "theory" has a knot at every point where theory needs one (sextactic points for conics, zeros
            of the affine curvature for parabolas, vertices for biarcs, besides inflections and cusps);
            "never" only at inflections and cusps, which often saves a piece but nothing proves that the
            number is then the least.
        split_at: parameter values that shall be knots besides, or one.
        files: what will be written, so that the files keep the tolerance too: a path, several, or a mapping
            of paths to options of `Spline.write`, such as ``{"part.nc": {"decimals": 3}}``. All that could
            be refused about them is refused before anything is computed; nothing is written. The search gets
            the tolerance less what they need (`Spline.reserved`), and of several ways to share it the one
            with the shortest first file.
        progress: called now and then with the part done, 0…1.

    Returns a `Spline`: its pieces' errors are measured after the search, distances on common normals of
    curve and piece, and lie within the tolerance; a piece that ends neither at a split point nor at the end
    has its error in [ε(1−δ), ε], δ = max(1e-6, 32 ulp(largest coordinate)/ε).  The errors are
    estimates, not certificates.  They are Hausdorff distances while smaller than the curve's radii of
    curvature; beyond, upper bounds of them.  ``minimal`` says whether the number is the least among splines
    with knots at the split points whose pieces are tangent to the curve at both ends and each lie over a
    strictly convex arc; "by theory" means that a theorem's hypotheses are proved for its very arcs.

    Raises DomainError where the curve is undefined, for a closed curve that is open, for fewer pieces than
    the curve takes or a choice that does not exist; ToleranceError for a tolerance that is not a positive
    number or lies below the rounding floor; UndecidedError where a cap was reached.

    Source: thesis, sections 3.3, 3.4, 3.6.2 and 3.7, and chapter 5 as reconstructed for biarcs.

    >>> import osculant as osc
    >>> spiral = osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    >>> spline = osc.approximate(spiral, "conic", 1e-4)
    >>> len(spline), spline.predicted_pieces, spline.minimal
    (9, 9, 'by theory')
    >>> f"{osc.approximate(spiral, 'conic', pieces=9).error:.3g}"
    '5.78e-05'
    >>> len(osc.approximate(spiral, "conic", 1e-4, metric="area"))
    13
    >>> spline = osc.approximate(spiral, "biarc", 1e-2, files={"spiral.nc": {"decimals": 3}})
    >>> spline.tolerance, 0 < spline.reserved < 1e-3  # of the tolerance, for rounding to three decimals
    (0.01, True)
    """
    _check_curve(curve)
    wanted: dict[str, Any] = {
        "pieces": pieces, "rule": rule, "metric": metric, "closed": closed, "split": split,
        "split_at": _several(split_at), "progress": progress,
    }  # fmt: skip
    targets = wanted_files(files, curve.dimension)
    if primitive == "best":
        return approximate_best(curve, tolerance, targets, **wanted)
    return approximate_for(curve, primitive or USUAL[curve.dimension], tolerance, targets, **wanted)


def complexity(
    curve: PlaneCurve | SpaceCurve,
    primitive: str | None = None,
    *,
    metric: str = "hausdorff",
    split_at: Sequence[Any] = (),
    next_term: bool = False,
) -> Complexity:
    """How many pieces theory predicts: leading constant, order, and ``count(tolerance)``.

    Formulas (3.17) and (3.18), in the metric "area" (3.25) and (3.26), integrated over every stretch between
    special points; with ``next_term`` also the second term's c₁, ``next_constant`` (open in section 3.8; it
    takes seconds, the metric must be "hausdorff" and the curve have no special point: DomainError).
    ``predicted_error(pieces)`` is the inverse.  Other arguments and errors as for `approximate`.

    >>> law = complexity(curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "conic")
    >>> law.constants, law.order, law.count(1e-8)
    (('1.2695901170369955254',), 5, 51)
    >>> complexity(curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "conic", metric="area").count(1e-6)
    33
    """
    _check_curve(curve)
    primitive = primitive or USUAL[curve.dimension]
    return complexity_of_curve(curve, primitive, metric, _several(split_at), next_term)


def _check_curve(curve: Any) -> None:
    if not isinstance(curve, (PlaneCurve, SpaceCurve)):
        raise DomainError(
            f"The curve is {curve!r}: give what osculant.curve makes of formulas and the ends of an interval."
        )


def _several(split_at: Any) -> Sequence[Any]:
    """The parameter values as a sequence, also if there is one only."""
    return split_at if isinstance(split_at, Sequence) and not isinstance(split_at, str) else [split_at]
