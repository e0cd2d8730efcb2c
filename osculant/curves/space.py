"""Space curves given by formulas."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from osculant.curves.curve import FormulaCurve

if TYPE_CHECKING:
    from numpy import float64
    from numpy.typing import NDArray

    from osculant.cas.invariants.space import SpaceExactInvariants
    from osculant.cas.jets.balls import SpaceBalls
    from osculant.cas.jets.jet import Invariant
    from osculant.cas.jets.space import SpaceJet
    from osculant.cas.zeros.form_zeros import FormZeros
    from osculant.cas.zeros.points import SpecialPoint
    from osculant.codegen.jets import CompiledJet

#: the invariants of `SpaceCurve.tabulate`
TABULATED = ("speed", "curvature", "torsion", "curvature_slope", "torsion_slope")


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
    sampled_order, tabulated_order, law_order = 3, 4, 3
    highest_form = "vertex"

    @cached_property
    def balls(self) -> SpaceBalls:
        """The curve in ball arithmetic."""
        from osculant.cas.jets.balls import SpaceBalls

        return SpaceBalls(self.coordinates)

    @cached_property
    def exact(self) -> SpaceExactInvariants:
        """The invariants as simplified expressions."""
        from osculant.cas.invariants.space import SpaceExactInvariants

        return SpaceExactInvariants(*self.coordinates, ends=self._ends)

    @cached_property
    def zeros(self) -> FormZeros[SpaceJet]:
        """The zeros of `osculant.cas.zeros.space.FORMS`: cusps, points with κ = 0, vertices, …."""
        from osculant.cas.zeros.space import zeros
        from osculant.curves.first_look import FirstLook

        return zeros(self.balls, FirstLook)

    def _special_points_of_jets(self, forms: Sequence[str], limit: int | None = None) -> list[SpecialPoint]:
        """In a plane the zeros of the curvature are simple, and are told apart.

        >>> SpaceCurve("t, t^3, 0", -1, 2).special_points(["inflection"])[0].decided
        True
        """
        from osculant.cas.zeros.space import special_points
        from osculant.curves.first_look import FirstLook
        from osculant.curves.special import BITS

        planar = "inflection" in forms and self.vanishes("planar") and self.exact.planar is True
        return special_points(self.balls, *self.ends, forms, planar, limit, FirstLook, BITS)

    @property
    def frame(self) -> tuple[Any, Any, Any]:
        """The Frenet frame (T, N, B), each a triple of expressions, or None where it does not exist.

        >>> SpaceCurve("cos(t), sin(t), 0").frame
        ((-sin(t), cos(t), 0), (-cos(t), -sin(t), 0), (0, 0, 1))
        """
        return self.exact["tangent"], self.exact["normal"], self.exact["binormal"]

    def bend(self, t: Any) -> float:
        """1: to be seen from one side or the other is for plane curves."""
        return 1.0

    def _listed(self) -> tuple[Sequence[Invariant], Sequence[Invariant], int]:
        from osculant.cas.invariants.space import ORDER, SPACE_LENGTHS
        from osculant.cas.jets.space import SPACE_INVARIANTS

        return SPACE_INVARIANTS, [length for length, _ in SPACE_LENGTHS], ORDER

    def _table(self, jet: CompiledJet, times: NDArray[float64]) -> dict[str, NDArray[float64]]:
        import numpy as np

        from osculant.cas.jets.space import SpaceJet

        shape = times.size, self.dimension, self.tabulated_order + 1
        rows = np.array([jet(float(t)) for t in times]).reshape(shape)
        x, y, z = (tuple(column) for column in np.moveaxis(rows, 0, 2))  # each derivative an array
        with np.errstate(all="ignore"):
            forms = SpaceJet(x, y, z, lambda value, _: np.sqrt(value))
            return {name: np.asarray(getattr(forms, name)) for name in TABULATED}
