"""Exact invariants of a space curve given by formulas."""

from __future__ import annotations

from osculant.cas.formulas.expression import Node
from osculant.cas.invariants.values import ExactValues
from osculant.cas.jets.plane import Invariant
from osculant.cas.jets.space import SpaceJet

#: derivatives that the invariants below need
ORDER = 4

#: the invariants of `SpaceJet` in the order in which they are printed; torsion has the usual sign
SPACE_INVARIANTS = (
    Invariant("speed", "speed", "ds/dt", r"\frac{ds}{dt}", "everywhere"),
    Invariant("curvature", "curvature", "kappa", r"\kappa", "regular"),
    Invariant("torsion", "torsion", "tau", r"\tau", "curved"),
    Invariant("curvature_slope", "derivative of the curvature", "dkappa/ds", r"\frac{d\kappa}{ds}", "curved"),
    Invariant("torsion_slope", "derivative of the torsion", "dtau/ds", r"\frac{d\tau}{ds}", "curved"),
    Invariant("tangent", "tangent", "T", "T", "regular"),
    Invariant("normal", "principal normal", "N", "N", "curved"),
    Invariant("binormal", "binormal", "B", "B", "curved"),
    Invariant("darboux_vector", "Darboux vector", "tau T + kappa B", r"\tau T + \kappa B", "curved"),
    Invariant("frame_rate", "its length", "beta", r"\beta", "curved"),
    Invariant("darboux_frame", "Darboux frame", "(N, W, V)", "(N, W, V)", "curved"),
    Invariant("axis_rate", "rate of V", "gamma", r"\gamma", "curved"),
)
#: the arc length, which is an integral and so no part of a jet, and its integrand's name
SPACE_LENGTHS = ((Invariant("arc_length", "arc length", "s", "s", "everywhere"), "speed"),)


class SpaceExactInvariants(ExactValues[SpaceJet]):
    r"""The invariants of the curve (x(t), y(t), z(t)) by name, in the order of `SPACE_INVARIANTS`.

    Args:
        x, y, z: the coordinates' expressions.
        variable: name of the parameter.
        start, end: constants between which the arc length is taken; without them it is indefinite.

    Values, ``over_jets`` and errors are as for `ExactValues`; symbols of jets are x1 … x4, y1 … z4.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> helix = SpaceExactInvariants(*parse_tuple("3*cos(t), 3*sin(t), 4*t"))
    >>> [helix.text(name) for name in ("curvature", "torsion", "tangent", "arc_length")]
    ['3/25', '4/25', '(-3*sin(t)/5, 3*cos(t)/5, 4/5)', '5*t']
    >>> helix.circular_helix, helix.planar
    (True, False)
    """

    def __init__(
        self,
        x: Node,
        y: Node,
        z: Node,
        variable: str = "t",
        start: Node | None = None,
        end: Node | None = None,
    ) -> None:
        ends = None if start is None or end is None else (start, end)
        super().__init__((x, y, z), SpaceJet, ORDER, SPACE_INVARIANTS, SPACE_LENGTHS, variable, ends)

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
