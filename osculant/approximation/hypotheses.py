"""Whether the theorems on the least number of pieces hold on the very arcs that a search found.

That no curvature vanishes inside a stretch, nor what else the theorem wants, is known from its division.
What is left is checked here, in ball arithmetic, arc by arc: that it is strictly convex, turns no more than
it may, and that its piece is what normals meet first.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from osculant.approximation.fitting import Fitted
    from osculant.approximation.runs import Run
    from osculant.approximation.stretches import Stretch
    from osculant.curves.curve import FormulaCurve
    from osculant.primitives.primitive import Theorem

#: bits of the balls
BITS = 96


def hold(theorem: Theorem, curve: FormulaCurve, found: Fitted) -> bool:
    """Whether a theorem's hypotheses are proved for every piece of a plane curve's spline.

    >>> from osculant.approximation.division import divide
    >>> from osculant.approximation.fitting import Fitting
    >>> from osculant.curves.extent import extent
    >>> from osculant.curves.plane import PlaneCurve
    >>> from osculant.primitives.table import choose
    >>> spiral, fit = PlaneCurve("t*cos(t), t*sin(t)", "0.2", "3.4"), choose("conic", "hausdorff")
    >>> fitting = Fitting(spiral, fit, divide(spiral, "conic"), extent(spiral))
    >>> [hold(fit.theorem, spiral, fitting.for_number(count)) for count in (1, 2)]
    [False, True]
    """
    from osculant.cas.numbers.balls import precision

    with precision(BITS):
        return all(
            _on_stretch(theorem, curve, part.stretch, run)
            for part, run in zip(found.parts, found.runs, strict=True)
        )


def _on_stretch(theorem: Theorem, curve: FormulaCurve, stretch: Stretch, run: Run) -> bool:
    """The same for the pieces of one stretch."""
    from flint import arb

    from osculant.cas.geometry.convex_arcs import End

    inner = [End(arb(knot)) for knot in run.knots[1:-1].tolist()]
    ends = [End(stretch.low, stretch.start.order), *inner, End(stretch.high, stretch.end.order)]
    return all(_on_arc(theorem, curve, *arc, row) for arc, row in zip(pairwise(ends), run.rows, strict=True))


def _on_arc(theorem: Theorem, curve: FormulaCurve, low: Any, high: Any, row: Any) -> bool:
    """The same for one piece."""
    from flint import arb

    from osculant.cas.geometry.convex_arcs import is_strictly_convex, turning
    from osculant.cas.geometry.first_hits import hits_first

    balls = curve.balls.coefficients
    turned = turning(balls, low, high)
    if turned is None or not abs(turned) < theorem.half_turns * arb.pi():
        return False
    if not is_strictly_convex(balls, low, high, turned):
        return False
    return theorem.member is None or hits_first(balls, low, high, theorem.member(row), turned)
