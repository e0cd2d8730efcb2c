"""Generalised and circular helices from their data at one point (thesis 2.3.2, 4.2).

Torsion has the usual sign, positive for a right-handed helix. With β = √(κ² + τ²), φ = ∫β, C = ∫cos φ and
S = ∫sin φ, a curve of constant τ/κ with the frame {T₀, N₀, B₀} at p₀ is

    α(s) = p₀ + s τ̄V + C(s)(T₀ − τ̄V) + S(s) T₀×V,   V = −(τT₀ + κB₀)/β,   τ̄ = −τ/β      (corollary 2.3.5)

(V and τ̄ are the thesis's, whose torsion is −τ). The numbers may be floats, mpmath, balls or sympy
expressions, as in `osculant.cas.jets.space`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.jets.jet import Root, real_root
from osculant.cas.numbers.fields import field_of
from osculant.cas.numbers.vectors import Vector3, add, cross, scale, subtract


@dataclass(frozen=True)
class Integrals:
    """cos φ, sin φ and their integrals C = ∫cos φ, S = ∫sin φ from 0 to s (2.18)."""

    cosine: Any
    sine: Any
    C: Any
    S: Any


@dataclass(frozen=True)
class GeneralisedHelix:
    """A curve of constant τ/κ, from its start and from φ = ∫√(κ² + τ²).

    Args:
        point: p₀.
        tangent: T₀, a unit vector.
        normal: N₀, a unit vector perpendicular to T₀.
        ratio: τ/κ, usual sign.
        integrals: the arc length s to the four functions of φ there, with φ(0) = 0.
        root: ``root(value, 2)``, the square root of such numbers.

    >>> import math
    >>> T, N = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
    >>> flat = GeneralisedHelix((0.0, 0.0, 0.0), T, N, 0.0, circular_integrals(1.0))
    >>> [round(x, 12) + 0.0 for x in flat.at(math.pi / 2)]  # a quarter of the unit circle
    [1.0, 1.0, 0.0]
    """

    point: Vector3
    tangent: Vector3
    normal: Vector3
    ratio: Any
    integrals: Callable[[Any], Integrals]
    root: Root = real_root

    @property
    def axis(self) -> Vector3:
        """V, the constant direction of the rulings: −(τT + κB)/β."""
        binormal = cross(self.tangent, self.normal)
        size = self.root(1 + self.ratio * self.ratio, 2)
        return scale(-1 / size, add(scale(self.ratio, self.tangent), binormal))

    @property
    def slope(self) -> Any:
        """τ̄ = ⟨T, V⟩, the constant cosine between tangent and ruling: −τ/β."""
        return -self.ratio / self.root(1 + self.ratio * self.ratio, 2)

    def at(self, s: Any) -> Vector3:
        """The point at arc length s."""
        along, outwards, sideways = self._frame()
        f = self.integrals(s)
        return add(self.point, scale(s, along), scale(f.C, outwards), scale(f.S, sideways))

    def tangent_at(self, s: Any) -> Vector3:
        """The unit tangent at arc length s."""
        along, outwards, sideways = self._frame()
        f = self.integrals(s)
        return add(along, scale(f.cosine, outwards), scale(f.sine, sideways))

    def _frame(self) -> tuple[Vector3, Vector3, Vector3]:
        along = scale(self.slope, self.axis)
        return along, subtract(self.tangent, along), cross(self.tangent, self.axis)


@dataclass(frozen=True)
class CircularHelix:
    """The curve of constant curvature and torsion with a given frame; a straight line for κ = 0.

    Args:
        point: p₀.
        tangent: T₀, a unit vector.
        normal: N₀, a unit vector perpendicular to T₀.
        curvature: κ ≥ 0.
        torsion: τ, usual sign; positive for a right-handed helix.
        root: ``root(value, 2)``, the square root of such numbers.

    >>> import math
    >>> helix = CircularHelix((3.0, 0.0, 0.0), (0.0, 0.6, 0.8), (-1.0, 0.0, 0.0), 0.12, 0.16)
    >>> [round(x, 12) + 0.0 for x in helix.at(10 * math.pi)]  # one turn: pitch 8π
    [3.0, 0.0, 25.132741228718]
    >>> round(helix.radius, 12), [round(x, 12) + 0.0 for x in helix.centre]
    (3.0, [0.0, 0.0, 0.0])
    """

    point: Vector3
    tangent: Vector3
    normal: Vector3
    curvature: Any
    torsion: Any
    root: Root = real_root

    @property
    def rate(self) -> Any:
        """β = √(κ² + τ²), the angle turned about the axis per arc length."""
        return self.root(self.curvature * self.curvature + self.torsion * self.torsion, 2)

    @property
    def radius(self) -> Any:
        """Of the cylinder, κ/(κ² + τ²) (lemma 4.2.1); raises DomainError for a straight line."""
        return self._curved().curvature / (self.curvature * self.curvature + self.torsion * self.torsion)

    @property
    def centre(self) -> Vector3:
        """The point of the axis nearest p₀, p₀ + radius·N₀; raises DomainError for a straight line."""
        return add(self.point, scale(self.radius, self.normal))

    @property
    def axis(self) -> Vector3:
        """V, the direction of the axis, about which the helix turns negatively; DomainError for a line."""
        return self._generalised().axis

    def at(self, s: Any) -> Vector3:
        """The point at arc length s."""
        if self.curvature == 0:
            return add(self.point, scale(s, self.tangent))
        return self._generalised().at(s)

    def tangent_at(self, s: Any) -> Vector3:
        """The unit tangent at arc length s."""
        return self.tangent if self.curvature == 0 else self._generalised().tangent_at(s)

    def _curved(self) -> CircularHelix:
        if self.curvature == 0:
            raise DomainError(
                f"A straight line (curvature {self.curvature}) has no axis and no radius: treat it apart."
            )
        return self

    def _generalised(self) -> GeneralisedHelix:
        ratio = self._curved().torsion / self.curvature
        integrals = circular_integrals(self.rate)
        return GeneralisedHelix(self.point, self.tangent, self.normal, ratio, integrals, self.root)


def circular_integrals(rate: Any) -> Callable[[Any], Integrals]:
    """The four functions for constant β ≠ 0: φ = βs, C = sin(βs)/β, S = (1 − cos βs)/β (4.1).

    >>> circular_integrals(2.0)(0.0)
    Integrals(cosine=1.0, sine=0.0, C=0.0, S=0.0)
    """

    def at(s: Any) -> Integrals:
        sin, cos = (field_of(rate * s).function(name) for name in ("sin", "cos"))
        half_sine, cosine, sine = sin(rate * s / 2), cos(rate * s), sin(rate * s)
        return Integrals(cosine, sine, sine / rate, 2 * half_sine * half_sine / rate)  # no cancellation

    return at
