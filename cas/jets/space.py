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

from osculant.cas.errors import DomainError
from osculant.cas.jets.plane import Root, real_root

Vector3 = tuple[Any, Any, Any]
Frame = tuple[Vector3, Vector3, Vector3]


def _in_space(*vectors: Sequence[Any]) -> None:
    """Refuse what has not three coordinates."""
    for vector in vectors:
        if len(vector) != 3:
            raise DomainError(f"A vector of space has three coordinates, but {vector} has {len(vector)}.")


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """⟨a, b⟩ of two vectors of three numbers; like all functions here, raises DomainError for other vectors.

    >>> dot((1, 2, 3), (4, 5, 6))
    32
    """
    _in_space(a, b)
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Sequence[Any], b: Sequence[Any]) -> Vector3:
    """a × b.

    >>> cross((1, 0, 0), (0, 1, 0))
    (0, 0, 1)
    """
    _in_space(a, b)
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def det(a: Sequence[Any], b: Sequence[Any], c: Sequence[Any]) -> Any:
    """The determinant ⟨a × b, c⟩, positive for a positively oriented triple.

    >>> det((1, 0, 0), (0, 1, 0), (5, 5, 2))
    2
    """
    return dot(cross(a, b), c)


def scale(factor: Any, a: Sequence[Any]) -> Vector3:
    """factor·a.

    >>> scale(2, (1, 2, 3))
    (2, 4, 6)
    """
    _in_space(a)
    return factor * a[0], factor * a[1], factor * a[2]


def add(*vectors: Sequence[Any]) -> Vector3:
    """The sum of one or more vectors.

    >>> add((1, 2, 3), (4, 5, 6), (0, 0, 1))
    (5, 7, 10)
    """
    if not vectors:
        raise DomainError("A sum of no vectors has no kind of number: give at least one vector.")
    _in_space(*vectors)
    x, y, z = vectors[0]
    for a in vectors[1:]:
        x, y, z = x + a[0], y + a[1], z + a[2]
    return x, y, z


def subtract(a: Sequence[Any], b: Sequence[Any]) -> Vector3:
    """a − b.

    >>> subtract((4, 5, 6), (1, 2, 3))
    (3, 3, 3)
    """
    _in_space(a, b)
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


class SpaceJet:
    """A space curve's derivatives at one parameter value, and the invariants there.

    Args:
        x: (x₀, x₁, …), derivatives of the first coordinate, not divided by factorials; any numbers with
            + - * /: floats, mpmath, balls, sympy expressions, elements of a field.
        y: the same of the second coordinate.
        z: the same of the third.
        root: ``root(value, 2)``, the square root of such numbers.

    An invariant needs the derivatives up to its own order only: κ 2, τ and κ′ 3, τ′ and γ 4; it raises
    DomainError if they are not there, as does a jet whose coordinates have unequal orders. At a cusp
    (speed 0) and where κ = 0 it raises DomainError if the numbers refuse to be divided by zero, as rationals
    and floats do; sympy and balls have values of their own for that.

    Torsion has the usual sign, opposite to the thesis's: see the top of this module.

    >>> right_handed = SpaceJet((3.0, 0.0, -3.0, 0.0), (0.0, 3.0, 0.0, -3.0), (0.0, 4.0, 0.0, 0.0))
    >>> right_handed.curvature, right_handed.torsion, right_handed.normal
    (0.12, 0.16, (-1.0, 0.0, 0.0))
    """

    def __init__(self, x: Sequence[Any], y: Sequence[Any], z: Sequence[Any], root: Root = real_root) -> None:
        self.x, self.y, self.z, self.root = tuple(x), tuple(y), tuple(z), root
        orders = [len(coordinate) - 1 for coordinate in (self.x, self.y, self.z)]
        if len(set(orders)) > 1:
            found = ", ".join(map(str, orders))
            raise DomainError(f"The coordinates of a jet have one order, not {found}: cut or extend them.")

    def _need(self, *orders: int) -> None:
        """Refuse derivatives that the jet does not have."""
        known = len(self.x) - 1
        if max(orders) > known:
            raise DomainError(
                f"The jet has order {known}, and the derivative of order {max(orders)} is needed: add it."
            )

    def _ratio(self, above: Any, below: Any) -> Any:
        """A quotient; where the denominator is 0 the message says of the curve what that means."""
        try:
            return above / below
        except ZeroDivisionError:
            reason = "speed is 0, so the curve is singular" if self.speed_squared == 0 else "curvature is 0"
            raise DomainError(f"An invariant does not exist here: the {reason}.") from None

    def _divided(self, a: Vector3, below: Any) -> Vector3:
        return self._ratio(a[0], below), self._ratio(a[1], below), self._ratio(a[2], below)

    def point(self, order: int) -> Vector3:
        """The derivative of that order, (xᵢ, yᵢ, zᵢ)."""
        self._need(order)
        return self.x[order], self.y[order], self.z[order]

    def dot(self, i: int, j: int) -> Any:
        """⟨ij⟩ = ⟨α⁽ⁱ⁾, α⁽ʲ⁾⟩."""
        self._need(i, j)
        return dot(self.point(i), self.point(j))

    def cross(self, i: int, j: int) -> Vector3:
        """α⁽ⁱ⁾ × α⁽ʲ⁾."""
        self._need(i, j)
        return cross(self.point(i), self.point(j))

    def det(self, i: int, j: int, k: int) -> Any:
        """The determinant [ijk] of α⁽ⁱ⁾, α⁽ʲ⁾, α⁽ᵏ⁾."""
        self._need(i, j, k)
        return det(self.point(i), self.point(j), self.point(k))

    # Forms whose zeros are the special points; `…_rate` is the derivative by the parameter.

    @cached_property
    def speed_squared(self) -> Any:
        """|α̇|² = ⟨11⟩: zero exactly at cusps and other singular points."""
        return self.dot(1, 1)

    @cached_property
    def _speed_rate(self) -> Any:
        return self.dot(1, 2)  # half the derivative of |α̇|²

    @cached_property
    def inflection_form(self) -> Any:
        """|c|² = |α̇ × α̈|²: zero exactly where κ = 0 (or the curve is singular)."""
        return dot(self.cross(1, 2), self.cross(1, 2))

    @cached_property
    def _inflection_rate(self) -> Any:
        self._need(3)
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
    def speed(self) -> Any:
        """ds/dt = |α̇|."""
        return self.root(self.speed_squared, 2)

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
