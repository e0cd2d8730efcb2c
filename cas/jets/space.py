"""The Euclidean invariants of a space curve, written once, over jets.

A jet holds the derivatives α⁽ⁱ⁾ = (xᵢ, yᵢ, zᵢ) of a curve at one parameter value. With c = α̇ × α̈, ċ = α̇ × α⃛,
D = det(α̇, α̈, α⃛) and Ḋ = det(α̇, α̈, α⁗) everything is rational in the jet, |α̇| and |c|:

* speed ds/dt = |α̇|, curvature κ = |c|/|α̇|³ ≥ 0, torsion τ = D/|c|² and their derivatives by arc length s;
* Frenet frame T = α̇/|α̇|, N = B × T, B = c/|c|, with T′ = κN, N′ = −κT + τB, B′ = −τN;
* Darboux vector Ω = τT + κB, with X′ = Ω × X for X = T, N, B, and |Ω| = β = √(κ² + τ²);
* Darboux frame {N, W, V}, positively oriented, V = −Ω/β, W = V × N = (κT − τB)/β    (thesis 2.14, 2.15),
  N′ = −βW, W′ = βN − γV, V′ = γW with γ = −(τ/κ)′/(1 + (τ/κ)²)                      (thesis 2.17).

Torsion has the usual sign here, positive for a right-handed helix. **The thesis has the opposite sign**, in
T′ = κN, N′ = −κT − τB, B′ = τN; its V = (τT − κB)/β is the vector V above, so the Darboux frame and γ are
those of the thesis, and only τ changes its sign. `osculant.cas.claims.chapter_2.space_curves` proves all of
this.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from osculant.cas.jets.jet import Invariant, Jet, Root, real_root
from osculant.cas.numbers.vectors import Vector3, add, cross, det, dot, scale

Frame = tuple[Vector3, Vector3, Vector3]


class SpaceJet(Jet):
    """A space curve's derivatives at one parameter value, and the invariants there.

    Args:
        x: (x₀, x₁, …), derivatives of the first coordinate, not divided by factorials; any numbers with
            + - * /: floats, mpmath, balls, sympy expressions, elements of a field.
        y: the same of the second coordinate.
        z: the same of the third.
        root: ``root(value, 2)``, the square root of such numbers.

    An invariant needs the derivatives up to its own order only: κ 2, τ and κ′ 3, τ′ and γ 4. Errors are
    those of `Jet`: missing derivatives, and, if the numbers refuse to be divided by zero, cusps (speed 0) and
    points where κ = 0.

    Torsion has the usual sign, opposite to the thesis's: see the top of this module.

    >>> right_handed = SpaceJet((3.0, 0.0, -3.0, 0.0), (0.0, 3.0, 0.0, -3.0), (0.0, 4.0, 0.0, 0.0))
    >>> right_handed.curvature, right_handed.torsion, right_handed.normal
    (0.12, 0.16, (-1.0, 0.0, 0.0))
    """

    def __init__(self, x: Sequence[Any], y: Sequence[Any], z: Sequence[Any], root: Root = real_root) -> None:
        super().__init__((x, y, z), root)
        self.x, self.y, self.z = self.coordinates

    def _divided(self, a: Sequence[Any], below: Any) -> Vector3:
        return self._ratio(a[0], below), self._ratio(a[1], below), self._ratio(a[2], below)

    def cross(self, i: int, j: int) -> Vector3:
        """α⁽ⁱ⁾ × α⁽ʲ⁾."""
        return cross(self.point(i), self.point(j))

    def det(self, i: int, j: int, k: int) -> Any:
        """The determinant [ijk] of α⁽ⁱ⁾, α⁽ʲ⁾, α⁽ᵏ⁾."""
        return det(self.point(i), self.point(j), self.point(k))

    # Forms whose zeros are the special points; `…_rate` is the derivative by the parameter.

    @cached_property
    def _speed_rate(self) -> Any:
        return self.dot(1, 2)  # half the derivative of |α̇|²

    @cached_property
    def inflection_form(self) -> Any:
        """|c|² = |α̇ × α̈|²: zero exactly where κ = 0 (or the curve is singular)."""
        return dot(self.cross(1, 2), self.cross(1, 2))

    @cached_property
    def _inflection_rate(self) -> Any:
        return dot(self.cross(1, 2), self.cross(1, 3))  # half the derivative of |c|²

    @cached_property
    def torsion_form(self) -> Any:
        """D = [123]: zero exactly where τ = 0, given κ ≠ 0."""
        return self.det(1, 2, 3)

    @cached_property
    def torsion_rate(self) -> Any:
        """Ḋ = [124]."""
        return self.det(1, 2, 4)

    @cached_property
    def curvature_slope_form(self) -> Any:
        """⟨c, ċ⟩|α̇|² − 3|c|²⟨12⟩: zero exactly where dκ/ds = 0, given κ ≠ 0."""
        return self._inflection_rate * self.speed_squared - 3 * self.inflection_form * self._speed_rate

    @cached_property
    def helix_form(self) -> Any:
        """Ḋ|α̇|²|c|² + 3D(⟨12⟩|c|² − |α̇|²⟨c, ċ⟩): zero exactly where (τ/κ)′ = 0, given κ ≠ 0."""
        self._need(4)
        mixed = self._speed_rate * self.inflection_form - self.speed_squared * self._inflection_rate
        return self.torsion_rate * self.speed_squared * self.inflection_form + 3 * self.torsion_form * mixed

    # Euclidean invariants.

    @cached_property
    def _bend(self) -> Any:
        return self.root(self.inflection_form, 2)

    @cached_property
    def curvature(self) -> Any:
        """κ = |c|/|α̇|³, never negative."""
        return self._ratio(self._bend, self.speed_squared * self.speed)

    @cached_property
    def torsion(self) -> Any:
        """τ = D/|c|², positive for a right-handed helix; the thesis's is −τ."""
        return self._ratio(self.torsion_form, self.inflection_form)

    @cached_property
    def curvature_slope(self) -> Any:
        """κ′ = dκ/ds."""
        below = self.speed_squared * self.speed_squared * self.speed_squared
        return self._ratio(self.curvature_slope_form, below * self._bend)

    @cached_property
    def torsion_slope(self) -> Any:
        """τ′ = dτ/ds = (Ḋ|c|² − 2D⟨c, ċ⟩)/(|α̇||c|⁴)."""
        above = self.torsion_rate * self.inflection_form - 2 * self.torsion_form * self._inflection_rate
        return self._ratio(above, self.speed * self.inflection_form * self.inflection_form)

    @cached_property
    def ratio_slope(self) -> Any:
        """(τ/κ)′ = d(τ/κ)/ds, zero all along a generalised helix."""
        return self._ratio(self.helix_form, self.inflection_form * self.inflection_form * self._bend)

    # Moving frames.

    @cached_property
    def tangent(self) -> Vector3:
        """T = α̇/|α̇|."""
        return self._divided(self.point(1), self.speed)

    @cached_property
    def binormal(self) -> Vector3:
        """B = c/|c|."""
        return self._divided(self.cross(1, 2), self._bend)

    @cached_property
    def normal(self) -> Vector3:
        """N = B × T, the direction in which the curve turns."""
        return self._divided(cross(self.cross(1, 2), self.point(1)), self._bend * self.speed)

    @cached_property
    def frenet_frame(self) -> Frame:
        """{T, N, B}."""
        return self.tangent, self.normal, self.binormal

    @cached_property
    def darboux_vector(self) -> Vector3:
        """Ω = τT + κB: the angular velocity of the Frenet frame by arc length, X′ = Ω × X.

        The thesis calls −Ω = βV the Darboux vector, because of its sign of the torsion.
        """
        return add(scale(self.torsion, self.tangent), scale(self.curvature, self.binormal))

    @cached_property
    def frame_rate(self) -> Any:
        """β = |Ω| = √(κ² + τ²)."""
        return self.root(self.curvature * self.curvature + self.torsion * self.torsion, 2)

    @cached_property
    def axis(self) -> Vector3:
        """V = −Ω/β, the thesis's normalised Darboux vector: minus the usual direction of Ω."""
        return self._divided(self.darboux_vector, -self.frame_rate)

    @cached_property
    def darboux_frame(self) -> Frame:
        """{N, W, V} with W = V × N = (κT − τB)/β: orthonormal, positively oriented (2.15)."""
        return self.normal, cross(self.axis, self.normal), self.axis

    @cached_property
    def axis_rate(self) -> Any:
        """γ in V′ = γW, that is −(τ/κ)′/(1 + (τ/κ)²), zero all along a generalised helix."""
        slope, ratio = self.ratio_slope, self._ratio(self.torsion, self.curvature)
        return -slope / (1 + ratio * ratio)


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
