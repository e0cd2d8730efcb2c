"""Special points of a plane curve: where theory wants a spline to be split.

* cusps and other singular points, α̇ = 0;
* inflections, κ = 0;
* for parabolas k = 0, for conics dk/dr = 0 (sextactic points), for biarcs dκ/ds = 0 (vertices).

Simple zeros are isolated in ball arithmetic.  Multiple zeros (all cusps are) are decided exactly where they
lie at a simple rational, at a simple multiple of pi, or at an end of the interval; the rest is called
undecided.
"""

from __future__ import annotations

from collections.abc import Mapping

from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.zeros.form_zeros import FormZeros, Looks, ZeroForm

#: what splits a spline
FORMS: Mapping[str, ZeroForm[PlaneJet]] = {
    "cusp": ZeroForm(lambda jet: jet.speed_squared, 1, lambda jet: jet.point(1)),
    "inflection": ZeroForm(lambda jet: jet.inflection_form, 2),
    "parabolic": ZeroForm(lambda jet: jet.parabolic_form, 4),
    "sextactic": ZeroForm(lambda jet: jet.sextactic_form, 5),
    "vertex": ZeroForm(lambda jet: jet.curvature_slope_form, 3),
}


def zeros(curve: CurveBalls, look: Looks | None = None) -> FormZeros[PlaneJet]:
    """The zeros of `FORMS` along a curve; those at the ends count too (their frames are limits).

    ``look`` makes what looks for them first, if balls are not to do it all.

    >>> from osculant.cas.formulas.parser import parse_constant, parse_tuple
    >>> cubic, ends = CurveBalls(parse_tuple("t, t^3")), map(parse_constant, ("-1", "2"))
    >>> [point] = zeros(cubic).within(*ends, ["cusp", "inflection"])
    >>> sorted(point.kinds), abs(point.at) < 1e-30
    (['inflection'], True)
    """
    return FormZeros(curve, FORMS, look)
