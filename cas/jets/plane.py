"""The Euclidean and equi-affine invariants of a plane curve, written once, over jets.

A jet holds the derivatives α⁽ⁱ⁾ = (xᵢ, yᵢ) of a curve at one parameter value. With [ij] = [α⁽ⁱ⁾, α⁽ʲ⁾] the
determinant and D = [12] everything is a rational function of the jet, of the speed |α̇| and of φ = D^{1/3}:

* signed curvature κ = D/|α̇|³ and its derivatives in Euclidean arc length s;
* affine arc length dr = φ dt, affine tangent t = α̇/φ, affine normal n = dt/dr          (thesis 2.2.1, 2.2.2);
* affine curvature k = n/(9φ⁸) with n = 3D(4[23] + [14]) − 5[13]²                        (2.12);
* dk/dr = m/(27D⁴) with m = 3ṅD − 8nḊ, where Ḋ = [13];
* canonical form y = x²/2 + kx⁴/8 + (dk/dr)x⁵/40 + O(x⁶) in the affine frame             (Lemma 2.2.2).

`osculant.cas.jets.derivations.affine` derives these forms from the definitions; the tests hold the two
together.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from osculant.cas.jets.jet import Invariant, Jet, Root, natural_power, real_root

Vector = tuple[Any, Any]


class PlaneJet(Jet):
    """A plane curve's derivatives at one parameter value, and the invariants there.

    Args:
        x: (x₀, x₁, …), derivatives of the first coordinate, not divided by factorials; any numbers with
            + - * / and integer powers: floats, mpmath, balls, sympy expressions, elements of a field.
        y: the same of the second coordinate.
        root: ``root(value, degree)``, the real square and cube root of such numbers.

    An invariant needs the derivatives up to its own order only: κ 2, k 4, dk/dr 5. Errors are those of `Jet`:
    missing derivatives, and, if the numbers refuse to be divided by zero, cusps (speed 0) and inflections.

    >>> circle = PlaneJet((2.0, 0.0, -2.0, 0.0, 2.0, 0.0), (0.0, 2.0, 0.0, -2.0, 0.0, 2.0))
    >>> circle.speed, circle.curvature, circle.evolute, circle.affine_curvature_slope
    (2.0, 0.5, (0.0, 0.0), 0.0)
    """

    def __init__(self, x: Sequence[Any], y: Sequence[Any], root: Root = real_root) -> None:
        super().__init__((x, y), root)
        self.x, self.y = self.coordinates

    def bracket(self, i: int, j: int) -> Any:
        """[ij] = xᵢyⱼ − yᵢxⱼ."""
        self._need(i, j)
        return self.x[i] * self.y[j] - self.y[i] * self.x[j]

    # Forms whose zeros are the special points; `…_rate` is the derivative by the parameter.

    @cached_property
    def inflection_form(self) -> Any:
        """D = [12]: zero exactly where κ = 0 (or the curve is singular)."""
        return self.bracket(1, 2)

    @cached_property
    def inflection_rate(self) -> Any:
        """Ḋ = [13]."""
        return self.bracket(1, 3)

    @cached_property
    def _inflection_rate_2(self) -> Any:
        return self.bracket(2, 3) + self.bracket(1, 4)

    @cached_property
    def parabolic_form(self) -> Any:
        """n = 3D(4[23] + [14]) − 5Ḋ² = 9φ⁸k: zero exactly where k = 0, given D ≠ 0."""
        mixed = 4 * self.bracket(2, 3) + self.bracket(1, 4)
        return 3 * self.inflection_form * mixed - 5 * natural_power(self.inflection_rate, 2)

    @cached_property
    def parabolic_rate(self) -> Any:
        """ṅ = Ḋ(2[23] − 7[14]) + 3D(5[24] + [15])."""
        mixed = 2 * self.bracket(2, 3) - 7 * self.bracket(1, 4)
        higher = 5 * self.bracket(2, 4) + self.bracket(1, 5)
        return self.inflection_rate * mixed + 3 * self.inflection_form * higher

    @cached_property
    def sextactic_form(self) -> Any:
        """m = 3ṅD − 8nḊ = 27D⁴ dk/dr: zero exactly where dk/dr = 0, given D ≠ 0."""
        return 3 * self.parabolic_rate * self.inflection_form - 8 * self.parabolic_form * self.inflection_rate

    # Euclidean invariants.

    @cached_property
    def curvature(self) -> Any:
        """κ = D/|α̇|³, positive where the curve turns left."""
        return self._ratio(self.inflection_form, self.speed_squared * self.speed)

    @cached_property
    def curvature_slope_form(self) -> Any:
        """Ḋ|α̇|² − 3D⟨12⟩ = |α̇|⁶κ′: zero exactly at vertices, κ′ = 0 (or where the curve is singular)."""
        return self.inflection_rate * self.speed_squared - 3 * self.inflection_form * self.dot(1, 2)

    @cached_property
    def curvature_slope(self) -> Any:
        """κ′ = dκ/ds = (Ḋ|α̇|² − 3D⟨12⟩)/|α̇|⁶."""
        return self._ratio(self.curvature_slope_form, natural_power(self.speed_squared, 3))

    @cached_property
    def curvature_bend(self) -> Any:
        """κ″ = d²κ/ds²."""
        rate = (
            self._inflection_rate_2 * self.speed_squared
            - self.inflection_rate * self.dot(1, 2)
            - 3 * self.inflection_form * (self.dot(2, 2) + self.dot(1, 3))
        )
        form = rate * self.speed_squared - 6 * self.dot(1, 2) * self.curvature_slope_form
        return self._ratio(form, natural_power(self.speed_squared, 4) * self.speed)

    @cached_property
    def evolute(self) -> Vector:
        """The centre of curvature α + N/κ; needs the point itself."""
        radius = self._ratio(self.speed_squared, self.inflection_form)
        return self.x[0] - self.y[1] * radius, self.y[0] + self.x[1] * radius

    # Equi-affine invariants.

    @cached_property
    def affine_speed(self) -> Any:
        """φ = dr/dt = D^{1/3}, negative where the curve turns right (2.3)."""
        return self.root(self.inflection_form, 3)

    @cached_property
    def affine_tangent(self) -> Vector:
        """t = dα/dr = α̇/φ."""
        return self._ratio(self.x[1], self.affine_speed), self._ratio(self.y[1], self.affine_speed)

    @cached_property
    def affine_normal(self) -> Vector:
        """n = dt/dr = (3Dα̈ − Ḋα̇)/(3Dφ²)."""
        slope, scale = self.inflection_rate, 3 * self.inflection_form
        below = scale * natural_power(self.affine_speed, 2)
        return (
            self._ratio(scale * self.x[2] - slope * self.x[1], below),
            self._ratio(scale * self.y[2] - slope * self.y[1], below),
        )

    @cached_property
    def affine_curvature(self) -> Any:
        """k = n/(9φ⁸), (2.12)."""
        below = 9 * natural_power(self.inflection_form, 2) * natural_power(self.affine_speed, 2)
        return self._ratio(self.parabolic_form, below)

    @cached_property
    def affine_curvature_slope(self) -> Any:
        """dk/dr = m/(27D⁴): rational in the jet."""
        return self._ratio(self.sextactic_form, 27 * natural_power(self.inflection_form, 4))

    @cached_property
    def canonical_form(self) -> Vector:
        """(k/8, (dk/dr)/40), coefficients of x⁴ and x⁵ in y = x²/2 + …, in the affine frame (Lemma 2.2.2)."""
        return self.affine_curvature / 8, self.affine_curvature_slope / 40


#: the invariants of `PlaneJet` in the order in which they are printed
INVARIANTS = (
    Invariant("speed", "speed", "ds/dt", r"\frac{ds}{dt}", "everywhere"),
    Invariant("curvature", "curvature", "kappa", r"\kappa", "regular"),
    Invariant(
        "curvature_slope", "derivative of the curvature", "dkappa/ds", r"\frac{d\kappa}{ds}", "regular"
    ),
    Invariant("curvature_bend", "second derivative", "d^2kappa/ds^2", r"\frac{d^2\kappa}{ds^2}", "regular"),
    Invariant("evolute", "evolute", "alpha + N/kappa", r"\alpha + \frac{1}{\kappa} N", "curved"),
    Invariant("affine_speed", "affine speed", "phi = dr/dt", r"\varphi = \frac{dr}{dt}", "everywhere"),
    Invariant("affine_tangent", "affine tangent", "t", r"\mathbf{t}", "curved"),
    Invariant("affine_normal", "affine normal", "n", r"\mathbf{n}", "curved"),
    Invariant("affine_curvature", "affine curvature", "k", "k", "curved"),
    Invariant("affine_curvature_slope", "its derivative", "dk/dr", r"\frac{dk}{dr}", "curved"),
    Invariant(
        "canonical_form",
        "canonical form",
        "(k/8, (dk/dr)/40)",
        r"\left(\frac{k}{8}, \frac{1}{40}\frac{dk}{dr}\right)",
        "curved",
    ),
)
