"""Special points of a curve, from its jets where that is quick, else from the factors of its forms.

What cancels in a form over jets costs arithmetic of enclosures many small intervals; the differential field
cancels it once and for all, and of what is left the zeros are quickly isolated.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from osculant.cas.formulas.expression import Node
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.curves.curve import FormulaCurve

#: of each kind of points, the form over jets and the derivatives that it takes
FORMS = {
    2: {
        "cusp": ("speed_squared", 1),
        "inflection": ("inflection_form", 2),
        "parabolic": ("parabolic_form", 4),
        "sextactic": ("sextactic_form", 5),
        "vertex": ("curvature_slope_form", 3),
    },
    3: {
        "cusp": ("speed_squared", 1),
        "inflection": ("inflection_form", 2),
        "vertex": ("curvature_slope_form", 3),
    },
}


#: bits of the interval to which the points are known: more than doubles can tell, also near others
BITS = 96
#: boxes in which balls seek the zeros of forms at first, and those of one factor, so that the attempt costs
#: little where it fails
SOON, LIMIT = 300, 2500
#: (names, boxes at most) → zeros of the forms over jets
OfJets = Callable[[Sequence[str], int | None], "list[SpecialPoint]"]


def from_factors(curve: FormulaCurve, name: str) -> list[SpecialPoint] | None:
    """The zeros of one form on the curve's interval, all of them decided; None if that is not to be had so.

    >>> from osculant.curves.plane import PlaneCurve
    >>> points = from_factors(PlaneCurve("t, sin(t)", 1, 10), "sextactic")
    >>> [round(float(point.at), 6) for point in points]
    [1.570796, 4.712389, 7.853982]
    """
    from osculant.cas.invariants.factored import factored
    from osculant.cas.jets.plane import PlaneJet
    from osculant.cas.jets.space import SpaceJet

    form = FORMS[curve.dimension].get(name)
    if form is None:
        return None
    jet_type: Any = PlaneJet if curve.dimension == 2 else SpaceJet
    factors = factored(curve.coordinates, jet_type, form[1], form[0])
    if factors is None or any(_zeros(curve, factor, name) for factor in factors[1]):
        return None
    points = [point for factor in factors[0] for point in _zeros(curve, factor, name)]
    return points if all(point.decided for point in points) else None


def _zeros(curve: FormulaCurve, factor: Node, name: str) -> list[SpecialPoint]:
    """The zeros of a formula on the curve's interval."""
    from osculant.cas.numbers.balls import FormulaBalls
    from osculant.cas.zeros.form_zeros import FormZeros, ZeroForm
    from osculant.curves.first_look import FirstLook

    def first(values: list[Any]) -> Any:
        return values[0]

    balls: FormulaBalls[Any] = FormulaBalls([factor], first)
    forms: dict[str, ZeroForm[Any]] = {name: ZeroForm(lambda value: value, 0)}
    return FormZeros(balls, forms, FirstLook).within(*curve.ends, [name], LIMIT, BITS)


def together(curve: FormulaCurve, names: Sequence[str], of_jets: OfJets) -> list[SpecialPoint]:
    """The zeros of the named forms, in order, merged where they coincide.

    ``of_jets`` finds those of some of the forms over jets. What it does not soon decide is left to factors.
    """
    from osculant.cas.numbers.balls import PRECISION, constant, precision
    from osculant.cas.zeros.points import SpecialPoint, merged

    soon = of_jets(names, SOON)
    hard = {kind for point in soon if not point.decided for kind in point.kinds}
    if not hard:
        return soon
    found = [SpecialPoint(point.at, point.kinds - hard) for point in soon if not point.kinds <= hard]
    left = []
    for name in sorted(hard):
        points = from_factors(curve, name)
        if points is None:
            left.append(name)
        else:
            found += points
    if left:
        found += of_jets(left, None)
    with precision(PRECISION):
        low, high = map(constant, curve.ends)
        return merged(found, high - low)
