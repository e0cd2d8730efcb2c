"""Space curves given by formulas."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from osculant.curves.curve import DIGITS, FormulaCurve, as_constant

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import ArrayLike, NDArray

    from osculant.cas.invariants.space import SpaceExactInvariants
    from osculant.cas.jets.balls import SpaceBalls
    from osculant.codegen.jets import CompiledJet

#: order of the jets that the kernels sample
COMPILED_ORDER = 3


class SpaceCurve(FormulaCurve):
    """A space curve t ↦ (x(t), y(t), z(t)) on a closed interval.

    Args:
        coordinates: text such as ``"t*cos(t), t*sin(t), t"``, or three sympy or symengine expressions in t.
        low, high: the ends of the interval, as text, numbers or sympy constants; without them the curve
            has its invariants, but nothing can be approximated.

    The invariants are attributes under their names: speed, curvature, torsion (positive for a right-handed
    helix; the thesis's sign is the opposite), curvature_slope, torsion_slope (by arc length), tangent,
    normal, binormal, darboux_vector, frame_rate, darboux_frame, axis_rate, arc_length; sympy expressions,
    tuples of them for vectors, None for what does not exist anywhere.

    Raises FormulaError for text that is no formula or has not three coordinates, DomainError for an
    interval that is empty or reversed.

    >>> cone = SpaceCurve("t*cos(t), t*sin(t), t", "pi/6", "2*pi")
    >>> cone.curvature, cone.torsion
    (sqrt(t**4 + 5*t**2 + 8)/(t**2 + 2)**(3/2), (t**2 + 6)/(t**4 + 5*t**2 + 8))
    """

    dimension, called, example = 3, "space", "t, t^2, t^3"

    @cached_property
    def balls(self) -> SpaceBalls:
        """The curve in ball arithmetic."""
        from osculant.cas.jets.balls import SpaceBalls

        return SpaceBalls(self.coordinates)

    @cached_property
    def compiled(self) -> CompiledJet:
        """Machine code for position and the first three derivatives."""
        from osculant.codegen.jets import compile_jet

        return compile_jet(self.coordinates, COMPILED_ORDER)

    @cached_property
    def exact(self) -> SpaceExactInvariants:
        """The invariants as simplified expressions."""
        from osculant.cas.invariants.space import SpaceExactInvariants

        x, y, z = self.coordinates
        return SpaceExactInvariants(x, y, z, "t", *(self._ends or ()))

    def invariants(self) -> dict[str, Any]:
        """All exact invariants by name: sympy expressions, tuples for vectors, None if undefined."""
        return dict(self.exact)

    @property
    def frame(self) -> tuple[Any, Any, Any]:
        """The Frenet frame (T, N, B), each a triple of expressions, or None where it does not exist.

        >>> SpaceCurve("cos(t), sin(t), 0").frame
        ((-sin(t), cos(t), 0), (-cos(t), -sin(t), 0), (0, 0, 1))
        """
        return self.exact["tangent"], self.exact["normal"], self.exact["binormal"]

    def __getattr__(self, name: str) -> Any:
        from osculant.cas.invariants.space import SPACE_INVARIANTS

        if name in {*(invariant.name for invariant in SPACE_INVARIANTS), "arc_length"}:
            return self.exact[name]
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def tabulate(self, times: ArrayLike) -> dict[str, NDArray[float64]]:
        """The scalar invariants at many parameter values, by name, each an array as long as ``times``.

        Doubles from machine code, not certified: speed, curvature, torsion, curvature_slope, torsion_slope
        (by arc length); infinite or NaN where undefined.

        >>> SpaceCurve("3*cos(t), 3*sin(t), 4*t").tabulate([0.0, 1.0])["torsion"].round(12).tolist()
        [0.16, 0.16]
        """
        import numpy as np

        from osculant.cas.invariants.space import ORDER
        from osculant.cas.jets.space import SpaceJet
        from osculant.codegen.jets import compile_jet

        flat = np.ascontiguousarray(times, dtype=np.float64).ravel()
        jet = compile_jet(self.coordinates, ORDER)  # owns the code at its address
        rows = np.array([jet(float(t)) for t in flat]).reshape(flat.size, self.dimension, ORDER + 1)
        x, y, z = (tuple(column) for column in np.moveaxis(rows, 0, 2))  # each derivative an array
        with np.errstate(all="ignore"):
            forms = SpaceJet(x, y, z, lambda value, _: np.sqrt(value))
            return {name: np.asarray(getattr(forms, name)) for name in TABULATED}

    def at(self, t: Any, digits: int = DIGITS) -> dict[str, Any]:
        """The invariants at one parameter value, as mpmath numbers correct to ``digits`` digits.

        Evaluated in ball arithmetic at growing precision until every digit is certain. Triples for vectors,
        None where an invariant does not exist. Raises DomainError where the curve is not smooth.

        >>> SpaceCurve("t, t^2, t^3").at("0", 5)["torsion"]
        mpf('3.0')
        """
        from osculant.cas.invariants.space import ORDER, SPACE_INVARIANTS
        from osculant.curves.values import invariants_to_digits

        return invariants_to_digits(self.balls, as_constant(t, "t"), digits, SPACE_INVARIANTS, ORDER)


#: the invariants of `SpaceCurve.tabulate`
TABULATED = ("speed", "curvature", "torsion", "curvature_slope", "torsion_slope")
