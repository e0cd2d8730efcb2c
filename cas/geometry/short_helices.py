"""The short helix through two points with given tangents (thesis theorem 4.3.2): the reference solver.

An arc of a circular helix is short if it turns by less than 2π about its axis. Between T₀ ≠ ±T₁ let θ be the
angle, h = sin(θ/2), c = cos(θ/2), E = (T₀ + T₁)/2c, G = (T₁ − T₀)/2h, F = G × E. All unit vectors V with
⟨V, T₀⟩ = ⟨V, T₁⟩, and the turning φ about V that takes T₀ to T₁, are functions of one parameter χ:

    cos(φ/2) = c cos χ,  s = sin(φ/2) = √(sin²χ + h²cos²χ),  V = (sin χ E + h cos χ F)/s.

The end point fixes χ by the angle of (X, Y), which grows from 0 to π with χ (claim R4.3-7). V and τ̄ are
the thesis's: the usual torsion is −τ̄β.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import factorial
from typing import Any

import mpmath as mp

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.geometry.helices import CircularHelix
from osculant.cas.numbers.vectors import Vector3, add, cross, dot, scale, subtract

#: digits carried beyond the caller's, the most steps of the root finder, and the units of rounding below
#: which tangents count as equal or opposite, and an arc as plane
GUARD, STEPS, SAME = 20, 4000, 100


@dataclass(frozen=True)
class SegmentForms:
    """What the parameter χ determines, in any numbers with + − * /.

    Attributes:
        h: sin(θ/2).
        c: cos(θ/2).
        sine: sin χ.
        cosine: cos χ.
        s: sin(φ/2) > 0.
        phi: φ, the turning about the axis, in (0, 2π).
        defect: 2s − φ cos(φ/2), see `turning_defect`.
    """

    h: Any
    c: Any
    sine: Any
    cosine: Any
    s: Any
    phi: Any
    defect: Any

    @property
    def axis(self) -> tuple[Any, Any]:
        """The components of V along E and F."""
        return self.sine / self.s, self.h * self.cosine / self.s

    @property
    def kappa_bar(self) -> Any:
        """κ̄ = κ/β."""
        return self.h / self.s

    @property
    def tau_bar(self) -> Any:
        """τ̄ in the thesis's sign, ⟨T, V⟩."""
        return self.c * self.sine / self.s

    @property
    def X(self) -> Any:
        """s²β⟨p₁ − p₀, E⟩."""
        return self.phi * self.c * self.sine * self.sine + 2 * self.h * self.h * self.s * self.cosine

    @property
    def Y(self) -> Any:
        """−s²β⟨p₁ − p₀, F⟩."""
        return self.h * self.sine * self.defect


@dataclass(frozen=True)
class ShortHelix:
    """An arc of a circular helix, or a straight segment.

    Attributes:
        helix: the curve, starting at p₀ with T₀; usual sign of the torsion.
        length: of the arc.
        turning: φ about the axis, in [0, 2π).
    """

    helix: CircularHelix
    length: Any
    turning: Any


def turning_defect(phi: Any) -> Any:
    """2 sin(φ/2) − φ cos(φ/2) for a non-negative mpmath number, by its series where the terms would cancel.

    >>> print(mp.nstr(turning_defect(mp.mpf("1e-5")), 8))
    8.3333333e-17
    """
    if phi > 1:
        return 2 * mp.sin(phi / 2) - phi * mp.cos(phi / 2)
    total, power, k = mp.mpf(0), mp.mpf(phi), 0
    while True:
        k += 1
        power *= phi * phi
        coefficient = defect_coefficient(k)
        term = power * coefficient.numerator / coefficient.denominator
        total += term
        if abs(term) <= abs(total) * mp.eps:
            return total


def defect_coefficient(k: int) -> Fraction:
    """The coefficient of φ^{2k+1} in 2 sin(φ/2) − φ cos(φ/2), k ≥ 1: difference of those of its two terms.

    >>> [str(defect_coefficient(k)) for k in (1, 2, 3)]
    ['1/12', '-1/480', '1/53760']
    """
    sine = Fraction((-1) ** k * 2, 2 ** (2 * k + 1) * factorial(2 * k + 1))
    cosine = Fraction((-1) ** k, 2 ** (2 * k) * factorial(2 * k))
    return sine - cosine


def segment_forms(h: Any, c: Any, sine: Any, cosine: Any) -> SegmentForms:
    """The forms for mpmath numbers sin χ and cos χ.

    >>> print(mp.nstr(segment_forms(mp.mpf(0.6), mp.mpf(0.8), mp.mpf(0), mp.mpf(1)).kappa_bar, 5))  # plane
    1.0
    """
    s = mp.sqrt(sine * sine + h * h * cosine * cosine)
    phi = 2 * mp.atan2(s, c * cosine)
    return SegmentForms(h, c, sine, cosine, s, phi, turning_defect(phi))


def short_helix(
    p0: Sequence[Any], T0: Sequence[Any], p1: Sequence[Any], T1: Sequence[Any], tolerance: Any = None
) -> ShortHelix:
    """The short helix from (p₀, T₀) to (p₁, T₁), at mpmath's current precision.

    Args:
        p0: start point, three numbers.
        T0: tangent there, not 0; made a unit vector.
        p1: end point.
        T1: tangent there.
        tolerance: the most that |⟨p₁ − p₀, T₁ − T₀⟩|/|p₁ − p₀| may be, 0 in theory; by default the working
            accuracy to the power 2/3.

    Returns:
        The arc; a straight segment for T₀ = T₁, a half circle for T₀ = −T₁, both up to `SAME` units of
        rounding.

    Raises DomainError if something given is not finite or no number, the points coincide, a tangent is 0,
    ⟨p₁ − p₀, T₁ − T₀⟩ ≠ 0, or T₀ = T₁ is not the direction of p₁ − p₀.

    >>> arc = short_helix((0, 0, 0), (0, 1, 0), (2, 0, 0), (0, -1, 0))
    >>> print(mp.nstr(arc.length, 5), mp.nstr(arc.helix.curvature, 5))
    3.1416 1.0
    """
    if tolerance is None:
        tolerance = mp.eps ** (mp.mpf(2) / 3)
    elif not tolerance >= 0:
        raise DomainError(f"The tolerance of a short helix is not negative, but it is {tolerance}.")
    rounding = SAME * mp.eps
    with mp.extradps(GUARD):
        chord = subtract(_vector(p1), _vector(p0))
        distance = mp.sqrt(dot(chord, chord))
        if distance == 0:
            raise DomainError(f"Start and end point coincide at {_show(p0)}: no short helix joins them.")
        start, end = _unit(T0, "start"), _unit(T1, "end")
        residual = dot(chord, subtract(end, start))
        if abs(residual) > tolerance * distance:
            raise DomainError(
                f"No short helix: ⟨p₁−p₀, T₁−T₀⟩ = 0 is needed and the residual is {mp.nstr(residual, 8)}; "
                "choose an end point in the plane through p₀ perpendicular to T₁−T₀."
            )
        return _arc(_vector(p0), start, end, chord, tolerance, rounding)


def _arc(p0: Vector3, T0: Vector3, T1: Vector3, chord: Vector3, tolerance: Any, rounding: Any) -> ShortHelix:
    distance = mp.sqrt(dot(chord, chord))
    total, difference = add(T0, T1), subtract(T1, T0)
    c, h = mp.sqrt(dot(total, total)) / 2, mp.sqrt(dot(difference, difference)) / 2
    if h <= rounding:
        return _segment(p0, T0, chord, distance, tolerance)
    if c <= rounding:
        return _half_circle(p0, T0, chord, distance)
    E, G = scale(1 / (2 * c), total), scale(1 / (2 * h), difference)
    F = cross(G, E)
    ahead, aside = dot(chord, E), dot(chord, F)
    if abs(aside) <= rounding * distance:  # the arc is plane, up to the rounding of the data
        aside = mp.mpf(0)
    if aside == 0:  # χ is 0 or π: exactly no torsion
        forms = segment_forms(h, c, mp.mpf(0), mp.sign(ahead))
    else:
        chi = -mp.sign(aside) * _parameter(h, c, ahead, abs(aside))
        forms = segment_forms(h, c, mp.sin(chi), mp.cos(chi))
    V = add(scale(forms.axis[0], E), scale(forms.axis[1], F))
    rate = mp.sqrt(4 * h * h + (forms.tau_bar * forms.phi) ** 2) / distance
    normal = scale(1 / forms.kappa_bar, cross(T0, V))
    helix = CircularHelix(p0, T0, normal, forms.kappa_bar * rate, -forms.tau_bar * rate)
    return ShortHelix(helix, forms.phi / rate, forms.phi)


def _parameter(h: Any, c: Any, ahead: Any, aside: Any) -> Any:
    """χ in (0, π) with (X, Y) in the direction of (ahead, aside): bisection, as the angle grows."""
    low, high = mp.mpf(0), +mp.pi
    for _ in range(STEPS):
        middle = (low + high) / 2
        forms = segment_forms(h, c, mp.sin(middle), mp.cos(middle))
        if forms.Y * ahead - forms.X * aside < 0:
            low = middle
        else:
            high = middle
        if high - low <= mp.eps * low:
            return (low + high) / 2
    raise UndecidedError(f"The parameter of the short helix was not found in {STEPS} halvings.")


def _segment(p0: Vector3, T0: Vector3, chord: Vector3, distance: Any, tolerance: Any) -> ShortHelix:
    miss = cross(chord, T0)
    if dot(chord, T0) < 0 or mp.sqrt(dot(miss, miss)) > tolerance * distance:
        raise DomainError(
            f"The tangents are equal, so only a straight segment is possible, but the chord {_show(chord)} "
            f"does not have their direction {_show(T0)}: move the end point onto the tangent."
        )
    zero = mp.mpf(0)
    k = min(range(3), key=lambda i: abs(T0[i]))
    most_across = [mp.mpf(int(i == k)) for i in range(3)]
    normal = _unit(cross(T0, most_across), "start")
    return ShortHelix(CircularHelix(p0, T0, normal, zero, zero), distance, zero)


def _half_circle(p0: Vector3, T0: Vector3, chord: Vector3, distance: Any) -> ShortHelix:
    helix = CircularHelix(p0, T0, scale(1 / distance, chord), 2 / distance, mp.mpf(0))
    return ShortHelix(helix, mp.pi * distance / 2, +mp.pi)


def _vector(a: Sequence[Any]) -> Vector3:
    try:
        x, y, z = (mp.mpf(i.numerator) / i.denominator if isinstance(i, Fraction) else mp.mpf(i) for i in a)
    except (TypeError, ValueError):
        raise DomainError(f"A point or tangent in space needs three real numbers, not {a!r}.") from None
    if not all(map(mp.isfinite, (x, y, z))):
        raise DomainError(f"A point or tangent in space needs finite numbers, not {_show((x, y, z))}.")
    return x, y, z


def _unit(a: Sequence[Any], where: str) -> Vector3:
    vector = _vector(a)
    size = mp.sqrt(dot(vector, vector))
    if size == 0:
        raise DomainError(f"The tangent at the {where} is the zero vector: it needs a direction.")
    return scale(1 / size, vector)


def _show(a: Sequence[Any]) -> str:
    return "(" + ", ".join(mp.nstr(mp.mpf(x), 8) for x in a) + ")"
