"""Exact invariants of a space curve given by formulas."""

from __future__ import annotations

from osculant.cas.invariants.values import ExactValues
from osculant.cas.jets.jet import Invariant
from osculant.cas.jets.space import SPACE_INVARIANTS, SpaceJet

#: derivatives that the invariants below need
ORDER = 4

#: the arc length, which is an integral and so no part of a jet, and its integrand's name
SPACE_LENGTHS = ((Invariant("arc_length", "arc length", "s", "s", "everywhere"), "speed"),)


class SpaceExactInvariants(ExactValues[SpaceJet]):
    r"""The invariants of the curve (x(t), y(t), z(t)) by name, in the order of `SPACE_INVARIANTS`.

    Arguments, values, ``over_jets`` and errors are those of `ExactValues`; symbols of jets are x1 … z4.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> helix = SpaceExactInvariants(*parse_tuple("3*cos(t), 3*sin(t), 4*t"))
    >>> [helix.text(name) for name in ("curvature", "torsion", "tangent", "arc_length")]
    ['3/25', '4/25', '(-3*sin(t)/5, 3*cos(t)/5, 4/5)', '5*t']
    >>> helix.circular_helix, helix.planar
    (True, False)
    """

    jet_type, order, invariants, lengths = SpaceJet, ORDER, SPACE_INVARIANTS, SPACE_LENGTHS

    @property
    def planar(self) -> bool | None:
        """Whether the curve lies in a plane (the torsion vanishes identically); None if undecided."""
        return True if self.straight else self.vanishes("torsion_form")

    @property
    def circular_helix(self) -> bool | None:
        """Whether curvature and torsion are constant, κ ≠ 0: a helix or a circle; None if undecided.

        One helix between points where the formula is smooth.
        """
        if self.straight:
            return False
        slopes = [self.vanishes(form) for form in ("curvature_slope_form", "helix_form")]
        return False if False in slopes else (None if None in slopes else True)
