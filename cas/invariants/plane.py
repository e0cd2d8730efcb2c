"""Exact invariants of a plane curve given by formulas."""

from __future__ import annotations

from osculant.cas.formulas.expression import Node
from osculant.cas.invariants import values as exact_values
from osculant.cas.invariants.values import ExactValues
from osculant.cas.jets.plane import INVARIANTS, Invariant, PlaneJet

#: derivatives that the invariants need
ORDER = 5
#: arc lengths, which are integrals and so no part of a jet: the Invariant to print and the integrand's name
LENGTHS = (
    (Invariant("arc_length", "arc length", "s", "s", "everywhere"), "speed"),
    (Invariant("affine_arc_length", "affine arc length", "r", "r", "everywhere"), "affine_speed"),
)


def jet_symbols() -> PlaneJet:
    """The generic jet, in sympy symbols x, x1 … x5, y, y1 … y5.

    >>> jet_symbols().inflection_form
    x1*y2 - x2*y1
    """
    return exact_values.jet_symbols(PlaneJet, "xy", ORDER)


class ExactInvariants(ExactValues[PlaneJet]):
    r"""The invariants of the curve (x(t), y(t)) by name, in the order of `INVARIANTS`, then the arc lengths.

    Args:
        x, y: the coordinates' expressions.
        variable: name of the parameter.
        start, end: constants between which the arc lengths are taken; without them they are indefinite.

    Values are sympy expressions in the real symbol of the parameter, pairs for vectors, None for what does
    not exist anywhere (the affine invariants of a straight line). ``over_jets`` names the invariants that
    were too large to be written out and stand in the symbols x1 … y5 of the derivatives instead. The arc
    lengths are unevaluated integrals unless an antiderivative is evident.

    Raises DomainError for a formula that is nowhere defined.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> sextic = ExactInvariants(*parse_tuple("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)"))
    >>> print(sextic.text("curvature"), "|", sextic.text("arc_length"))
    1/(3*cos(t/3)**2) | 2*t + 3*sin(2*t/3)
    >>> print(sextic.latex("speed"))
    4 \cos^{2}{\left(\frac{t}{3} \right)}
    """

    def __init__(
        self, x: Node, y: Node, variable: str = "t", start: Node | None = None, end: Node | None = None
    ) -> None:
        ends = None if start is None or end is None else (start, end)
        super().__init__((x, y), PlaneJet, ORDER, INVARIANTS, LENGTHS, variable, ends)

    @property
    def parabola(self) -> bool | None:
        """Whether the curve is of parabolic arcs (k vanishes identically); None if undecided."""
        return self._curved_and("parabolic_form")

    @property
    def conic(self) -> bool | None:
        """Whether the curve is of conic arcs (dk/dr vanishes identically); None if undecided.

        One conic between points where the formula is smooth: t*abs(t) is of two.
        """
        return self._curved_and("sextactic_form")

    @property
    def circle(self) -> bool | None:
        """Whether the curve is of circular arcs (κ′ vanishes identically, κ does not); None if undecided."""
        return self._curved_and("curvature_slope_form")

    def _curved_and(self, form: str) -> bool | None:
        return False if self.straight else self.vanishes(form)
