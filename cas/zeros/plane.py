"""Special points of a plane curve: where theory wants a spline to be split.

* cusps and other singular points, α̇ = 0;
* inflections, κ = 0;
* for parabolas k = 0, for conics dk/dr = 0 (sextactic points), for biarcs dκ/ds = 0 (vertices).

Simple zeros are isolated in ball arithmetic.  Multiple zeros (all cusps are) are decided exactly where they
lie at a simple rational, at a simple multiple of pi, or at an end of the interval; the rest is called
undecided.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from osculant.cas.formulas.expression import Node
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.zeros.form_zeros import FormZeros, SpecialPoint, ZeroForm

__all__ = ["FORMS", "SpecialPoint", "require_finite", "special_points", "vanishes"]

#: what splits a spline
FORMS: Mapping[str, ZeroForm[PlaneJet]] = {
    "cusp": ZeroForm(lambda jet: jet.speed_squared, 1, lambda jet: jet.point(1)),
    "inflection": ZeroForm(lambda jet: jet.inflection_form, 2),
    "parabolic": ZeroForm(lambda jet: jet.parabolic_form, 4),
    "sextactic": ZeroForm(lambda jet: jet.sextactic_form, 5),
    "vertex": ZeroForm(lambda jet: jet.curvature_slope_form, 3),
}


def vanishes(curve: CurveBalls, name: str, low: Any, high: Any) -> bool:
    """Whether a form seems to vanish identically: its balls contain 0 at every probe, to 600 digits.

    False is a proof; True asks for a symbolic one.
    """
    return FormZeros(curve, FORMS).vanishes(name, low, high)


def require_finite(curve: CurveBalls, low: Node, high: Node) -> None:
    """Raises DomainError, naming the parameter value, unless the derivatives are finite on [low, high]."""
    FormZeros(curve, FORMS).require_finite(low, high, tuple(FORMS))


def special_points(curve: CurveBalls, low: Node, high: Node, names: Sequence[str]) -> list[SpecialPoint]:
    """The special points of the given kinds inside [low, high], in order, merged where they coincide.

    Points at the ends are reported too (their frames are limits).  The curve has to be finite there:
    see `require_finite`.

    >>> from osculant.cas.formulas.parser import parse_constant, parse_tuple
    >>> cubic = CurveBalls(parse_tuple("t, t^3"))
    >>> [point] = special_points(cubic, parse_constant("-1"), parse_constant("2"), ["cusp", "inflection"])
    >>> sorted(point.kinds), abs(point.at) < 1e-30
    (['inflection'], True)
    """
    return FormZeros(curve, FORMS).within(low, high, names)
