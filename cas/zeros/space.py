"""Special points of a space curve, where theory wants a spline of bihelices to be split.

* cusps and other singular points, α̇ = 0;
* points of zero curvature, κ = 0, where the Frenet frame and the torsion do not exist;
* vertices, κ′ = 0, where the leading term |κ′|σ³/324 of a bihelix's error vanishes.

The first two are zeros of sums of squares, hence multiple: they are proved at a simple rational, a simple
multiple of pi or an end of the interval, and called undecided elsewhere. In a plane α̇ × α̈ has a constant
direction, and one of its coordinates, whose zeros are simple, will do for κ = 0. A zero of κ is a zero of the
form of κ′ as well, and a cusp one of all forms: such a point has several kinds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from flint import arb

from osculant.cas.formulas.expression import Node
from osculant.cas.jets.balls import SpaceBalls
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.balls import PRECISION, constant, precision
from osculant.cas.zeros.form_zeros import BITS, FormZeros, Looks, ZeroForm
from osculant.cas.zeros.points import SpecialPoint

#: a place inside the interval, unlikely to be a zero of anything
INSIDE = "0.38196601"
#: what splits a spline, and the form that tells whether the torsion is constant, given a constant curvature
FORMS: Mapping[str, ZeroForm[SpaceJet]] = {
    "cusp": ZeroForm(lambda jet: jet.speed_squared, 1, lambda jet: jet.point(1)),
    "inflection": ZeroForm(lambda jet: jet.inflection_form, 2, lambda jet: jet.cross(1, 2)),
    "vertex": ZeroForm(lambda jet: jet.curvature_slope_form, 3),
    "planar": ZeroForm(lambda jet: jet.torsion_form, 3),
    "slope": ZeroForm(lambda jet: jet.helix_form, 4),
}


def zeros(curve: SpaceBalls, look: Looks | None = None) -> FormZeros[SpaceJet]:
    """The zeros of `FORMS` along a curve; ``look`` makes what looks for them first.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> helix = zeros(SpaceBalls(parse_tuple("3*cos(t), 3*sin(t), 4*t")))
    >>> [helix.vanishes(name, arb(0), arb(1)) for name in ("inflection", "vertex", "planar", "slope")]
    [False, True, False, True]
    """
    return FormZeros(curve, FORMS, look)


def special_points(
    curve: SpaceBalls,
    low: Node,
    high: Node,
    names: Sequence[str],
    planar: bool = False,
    limit: int | None = None,
    look: Looks | None = None,
    bits: int = BITS,
) -> list[SpecialPoint]:
    """The special points of the given kinds in [low, high], in order, merged where they coincide.

    Args:
        curve: finite on the interval, see `FormZeros.require_finite`.
        low: first end, a constant formula.
        high: last end.
        names: among "cusp", "inflection" (κ = 0) and "vertex" (κ′ = 0); forms that vanish identically
            are not to be asked for.
        planar: whether the curve is known to lie in a plane.
        limit: boxes that are looked at, by default `isolate.WORK_LIMIT`.
        look: makes what looks first.
        bits: of the interval, to which simple zeros are known.

    Points at the ends are reported too.

    >>> from osculant.cas.formulas.parser import parse_constant, parse_tuple
    >>> cubic, ends = SpaceBalls(parse_tuple("t, t^2, t^3")), map(parse_constant, ("-1", "1"))
    >>> [vertex] = special_points(cubic, *ends, ["cusp", "inflection", "vertex"])
    >>> sorted(vertex.kinds), abs(vertex.at) < 1e-30
    (['vertex'], True)
    """
    forms = dict(FORMS)
    if planar and "inflection" in names:
        with precision(PRECISION):
            forms["inflection"] = _bend_in_plane(curve, constant(low), constant(high))
    return FormZeros(curve, forms, look).within(low, high, names, limit, bits)


def _bend_in_plane(curve: SpaceBalls, low: Any, high: Any) -> ZeroForm[SpaceJet]:
    """The coordinate of α̇ × α̈ that is largest somewhere inside, where the curve is not straight."""
    middle = arb((low + (high - low) * arb(INSIDE)).mid())
    sizes = [abs(float(part.mid())) for part in curve.jet(middle, 2).cross(1, 2)]
    largest = sizes.index(max(sizes))
    return ZeroForm(lambda jet: jet.cross(1, 2)[largest], 2)
