"""Plane curves given by formulas."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from osculant.curves.curve import DIGITS, FormulaCurve, as_constant

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from osculant.cas.invariants.plane import ExactInvariants
    from osculant.cas.jets.balls import CurveBalls
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

    @cached_property
    def balls(self) -> CurveBalls:
        """The curve in ball arithmetic."""
        from osculant.cas.jets.balls import CurveBalls

        return CurveBalls(self.coordinates)

    @cached_property
    def compiled(self) -> CompiledJet:
        """Machine code for position, first and second derivative."""
        from osculant.codegen.jets import compile_jet

        return compile_jet(self.coordinates, 2)

    @cached_property
    def exact(self) -> ExactInvariants:
        """The invariants as simplified expressions."""
        from osculant.cas.invariants.plane import ExactInvariants

        x, y = self.coordinates
        return ExactInvariants(x, y, "t", *(self._ends or ()))

    def invariants(self) -> dict[str, Any]:
        """All exact invariants by name: sympy expressions, pairs of them for vectors, None if undefined."""
        return dict(self.exact)

    def __getattr__(self, name: str) -> Any:
        # the invariants are attributes under their names: curvature, affine_curvature, arc_length, …
        from osculant.cas.jets.plane import INVARIANTS

        if name in {*(invariant.name for invariant in INVARIANTS), "arc_length", "affine_arc_length"}:
            return self.exact[name]
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def tabulate(self, times: ArrayLike) -> dict[str, NDArray[np.float64]]:
        """The scalar invariants at many parameter values, by name, each an array as long as ``times``.

        Doubles from machine code, not certified: speed, curvature, curvature_slope (by arc length),
        affine_speed, affine_curvature, affine_curvature_slope; infinite or NaN where undefined.

        >>> PlaneCurve("t, t^2").tabulate([0.0, 1.0])["curvature"].round(6).tolist()
        [2.0, 0.178885]
        """
        import numpy as np

        from osculant.codegen.jets import compile_jet
        from osculant.kernels.curves.invariants import COLUMNS, invariants_at

        flat = np.ascontiguousarray(times, dtype=np.float64).ravel()
        out = np.empty((flat.size, len(COLUMNS)))
        jet = compile_jet(self.coordinates, 5)  # owns the code at its address
        invariants_at(jet.address, flat, out)
        return {name: out[:, i] for i, name in enumerate(COLUMNS)}

    def at(self, t: Any, digits: int = DIGITS) -> dict[str, Any]:
        """The invariants at one parameter value, as mpmath numbers correct to ``digits`` digits.

        Evaluated in ball arithmetic at growing precision until every digit is certain.  Pairs for vectors,
        None where an invariant does not exist.  Raises DomainError where the curve is not smooth.

        >>> PlaneCurve("t, t^2").at("0", 5)["curvature"]
        mpf('2.0')
        """
        from osculant.cas.invariants.plane import ORDER
        from osculant.cas.jets.plane import INVARIANTS
        from osculant.curves.values import invariants_to_digits

        return invariants_to_digits(self.balls, as_constant(t, "t"), digits, INVARIANTS, ORDER)
