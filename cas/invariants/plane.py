"""Exact invariants of a plane curve given by formulas."""

from __future__ import annotations

from osculant.cas.invariants.values import ExactValues
from osculant.cas.jets.jet import Invariant
from osculant.cas.jets.plane import INVARIANTS, PlaneJet

#: derivatives that the invariants need
ORDER = 5
#: arc lengths, which are integrals and so no part of a jet: the Invariant to print and the integrand's name
LENGTHS = (
    (Invariant("arc_length", "arc length", "s", "s", "everywhere"), "speed"),
    (Invariant("affine_arc_length", "affine arc length", "r", "r", "everywhere"), "affine_speed"),
)


class ExactInvariants(ExactValues[PlaneJet]):
    r"""The invariants of the curve (x(t), y(t)) by name, in the order of `INVARIANTS`, then the arc lengths.

    Arguments, values, ``over_jets`` and errors are those of `ExactValues`; symbols of jets are x1 … y5.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> sextic = ExactInvariants(*parse_tuple("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)"))
    >>> print(sextic.text("curvature"), "|", sextic.text("arc_length"))
    1/(3*cos(t/3)**2) | 2*t + 3*sin(2*t/3)
    >>> print(sextic.latex("speed"))
    4 \cos^{2}{\left(\frac{t}{3} \right)}
    """

    jet_type, order, invariants, lengths = PlaneJet, ORDER, INVARIANTS, LENGTHS

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
