"""Plane curves given by formulas."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from osculant.curves.curve import DIGITS, FormulaCurve, as_constant

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    from osculant.cas.invariants.plane import ExactInvariants
    from osculant.cas.jets.balls import CurveBalls
    from osculant.cas.jets.jet import Invariant
    from osculant.cas.jets.plane import PlaneJet
    from osculant.cas.laws.law import Law
    from osculant.cas.zeros.form_zeros import FormZeros
    from osculant.codegen.jets import CompiledJet

__all__ = ["DIGITS", "PlaneCurve", "as_constant"]


class PlaneCurve(FormulaCurve):
    """A plane curve t ↦ (x(t), y(t)) on a closed interval.

    Args:
        coordinates: text such as ``"t*cos(t), t*sin(t)"``, or two sympy or symengine expressions in t.
        low, high: the ends of the interval, as text, numbers or sympy constants; without them the curve
            has its invariants, but nothing can be approximated.

    Raises FormulaError for text that is no formula or has not two coordinates, DomainError for an
    interval that is empty or reversed.  Singular points are found when they matter, not here.

    >>> spiral = PlaneCurve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    >>> spiral.text, spiral.curvature
    ('t*cos(t), t*sin(t)', (t**2 + 2)/(t**2 + 1)**(3/2))
    """

    dimension, called, example = 2, "plane", "t, t^2"
    sampled_order, tabulated_order, law_order = 2, 5, 5
    highest_form = "sextactic"

    @cached_property
    def balls(self) -> CurveBalls:
        """The curve in ball arithmetic."""
        from osculant.cas.jets.balls import CurveBalls

        return CurveBalls(self.coordinates)

    @cached_property
    def exact(self) -> ExactInvariants:
        """The invariants as simplified expressions."""
        from osculant.cas.invariants.plane import ExactInvariants

        return ExactInvariants(*self.coordinates, ends=self._ends)

    @cached_property
    def zeros(self) -> FormZeros[PlaneJet]:
        """The zeros of `osculant.cas.zeros.plane.FORMS`: cusps, inflections, sextactic points, …."""
        from osculant.cas.zeros.plane import zeros
        from osculant.curves.first_look import FirstLook

        return zeros(self.balls, FirstLook)

    def jet_for(self, law: Law) -> CompiledJet:
        """The machine code that the density of a law takes: one derivative more for cubics."""
        return self.compiled_to(self.law_order + (law.jet > self.law_order))

    def bend(self, t: Any) -> float:
        """1 if the curve bends to the left at a ball t, −1 if to the right."""
        form = self.zeros.series("inflection", t, 1)
        return -1.0 if form is not None and form[0] < 0 else 1.0

    def _listed(self) -> tuple[Sequence[Invariant], Sequence[Invariant], int]:
        from osculant.cas.invariants.plane import LENGTHS, ORDER
        from osculant.cas.jets.plane import INVARIANTS

        return INVARIANTS, [length for length, _ in LENGTHS], ORDER

    def _table(self, jet: CompiledJet, times: NDArray[float64]) -> dict[str, NDArray[float64]]:
        import numpy as np

        from osculant.kernels.curves.invariants import COLUMNS, invariants_at

        out = np.empty((times.size, len(COLUMNS)))
        invariants_at(jet.address, times, out)
        return {name: out[:, i] for i, name in enumerate(COLUMNS)}
