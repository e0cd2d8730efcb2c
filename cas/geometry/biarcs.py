"""True biarcs of plane data in complex numbers of mpmath: the junction circle, its family, and displacements.

Points and unit tangents are complex; a circular arc from p with tangent T to q ends with the tangent
conj(T)d/conj(d), d = q − p. For data (p_L, T_L), (p_R, T_R) with ρ = T_R/T_L the junctions lie on the circle
about (p_R − ρp_L)/(1 − ρ) through p_L and p_R, or on the line through them if ρ = 1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath as mp

from osculant.cas.errors import DomainError
from osculant.cas.geometry.moons import integral
from osculant.cas.numbers.roots import root_between

#: a parameter to the curve's point and unit tangent there, complex
Curve = Callable[[Any], tuple[Any, Any]]
#: a parameter to the curve's point and velocity there, complex
Path = Callable[[Any], tuple[Any, Any]]


@dataclass(frozen=True)
class Biarc:
    """Two arcs: ``start`` with tangent ``heading``, ``junction`` with tangent ``direction``, ``end``."""

    start: Any
    heading: Any
    junction: Any
    direction: Any
    end: Any

    @property
    def curvatures(self) -> tuple[Any, Any]:
        """Signed curvatures 2[T, d]/|d|² of the arcs with chord d."""
        return (
            _curvature(self.start, self.heading, self.junction),
            _curvature(self.junction, self.direction, self.end),
        )

    def displacement(self, point: Any, tangent: Any) -> Any:
        """The biarc's signed distance from the point along the normal, which is left of the tangent.

        Raises DomainError if the normal misses both circles.
        """
        found = []
        for first, curvature in zip((True, False), self.curvatures, strict=True):
            base, T = (self.start, self.heading) if first else (self.junction, self.direction)
            d = _to_circle(base, T, curvature, point, tangent)
            if d is None:
                continue
            ahead = mp.re(mp.conj(self.direction) * (point + 1j * tangent * d - self.junction))
            found.append((abs(d), first == (ahead <= 0), d))
        fitting = [entry for entry in found if entry[1]] or found
        if not fitting:
            raise DomainError(f"The normal at {mp.nstr(point, 6)} misses the biarc: the arc is too long.")
        return min(fitting)[2]


def junction_circle(start: Any, heading: Any, end: Any, arrival: Any) -> Any:
    """The centre of the circle of junctions.

    Raises DomainError if the tangents are equal: then it is a line.

    >>> mp.nstr(junction_circle(mp.mpc(0), mp.mpc(0, -1), mp.mpc(1), mp.mpc(0, 1)), 5)
    '(0.5 + 0.0j)'
    """
    ratio = arrival / heading
    if ratio == 1:
        raise DomainError("The tangents are equal, so the junctions lie on the chord's line: no centre.")
    return (end - ratio * start) / (1 - ratio)


def member(start: Any, heading: Any, end: Any, turning: Any, mu: Any) -> Biarc:
    """The biarc of the family with parameter μ in (0, 1).

    Args:
        start: the first point.
        heading: the unit tangent there.
        end: the last point; the tangent there is heading·exp(i·turning).
        turning: the true signed turning ω of the curve, 0 < |ω| < 2π.
        mu: where on the junction circle: the junction turned by μω about its centre.

    Raises DomainError for a μ or a turning out of range.

    >>> both = member(mp.mpc(0), mp.expj(-0.4), mp.mpc(1), mp.mpf(1), mp.mpf(0.5))
    >>> mp.nstr(both.curvatures[0] < both.curvatures[1], 5)
    'True'
    """
    if not 0 < mu < 1 or not 0 < abs(turning) < 2 * mp.pi:
        raise DomainError(
            f"No biarc belongs to μ = {mp.nstr(mu, 6)} and turning {mp.nstr(turning, 6)}: "
            "0 < μ < 1 and 0 < |ω| < 2π are needed."
        )
    centre = junction_circle(start, heading, end, heading * mp.expj(turning))
    junction = centre + (start - centre) * mp.expj(mu * turning)
    d = junction - start
    return Biarc(start, heading, junction, mp.conj(heading) * d / mp.conj(d), end)


def extremes(biarc: Biarc, curve: Curve, parameters: Sequence[Any]) -> tuple[Any, Any]:
    """(max, min) of the displacement at the parameters."""
    values = [biarc.displacement(*curve(t)) for t in parameters]
    return max(values), min(values)


def equioscillating(
    family: Callable[[Any], Biarc], curve: Curve, parameters: Sequence[Any]
) -> tuple[Any, Any]:
    """(μ, error) of the member whose largest and smallest displacement are opposite.

    Raises DomainError if max + min has the same sign near both ends of (0, 1).
    """

    def balance(mu: Any) -> Any:
        return sum(extremes(family(mu), curve, parameters))

    low, high = mp.mpf(1) / 16, mp.mpf(15) / 16
    if balance(low) * balance(high) >= 0:
        raise DomainError("The extreme displacements do not balance for any junction between 1/16 and 15/16.")
    mu = root_between(balance, low, high)
    return mu, max(abs(e) for e in extremes(family(mu), curve, parameters))


def signed_area(biarc: Biarc, path: Path, low: Any, high: Any) -> Any:
    """The signed area between a biarc and a curve from one common point to another, by Green's theorem.

    ½∮[α, dα] of the biarc's part minus that of the curve's: positive where the curve is to the left.

    Args:
        biarc: it contains path(low) and path(high).
        path: the curve; a quadrature for smooth integrands is applied to [α, α′].
        low: the parameter of the first common point.
        high: that of the last; closed regions that lie between them add up.

    >>> half = member(mp.mpc(1), mp.mpc(0, 1), mp.mpc(-1), mp.pi, mp.mpf(1) / 3)
    >>> ellipse = lambda t: (mp.mpc(mp.cos(t), mp.sin(t) / 2), mp.mpc(-mp.sin(t), mp.cos(t) / 2))
    >>> mp.nstr(signed_area(half, ellipse, 0, mp.pi) / mp.pi, 12)
    '0.25'
    """
    origin = biarc.start

    def swept(t: Any) -> Any:
        point, velocity = path(t)
        return _cross(point - origin, velocity) / 2

    return _sector(biarc, path(high)[0]) - _sector(biarc, path(low)[0]) - integral(swept, low, high)


def equisymmetric(family: Callable[[Any], Biarc], path: Path, low: Any, high: Any) -> tuple[Any, Any, Any]:
    """(μ, area, crossing) of the member whose two moons have the same area: its signed area is 0.

    Args:
        family: μ to the biarcs of the arc.
        path: the curve.
        low: the parameter of the arc's start.
        high: that of its end.

    Raises DomainError if the signed area has the same sign near both ends of (0, 1), or if the middle of the
    arc is not near the crossing.

    >>> turn = mp.atan(2)
    >>> def parabola(t): return mp.mpc(t, t * t), mp.mpc(1, 2 * t)
    >>> def of(mu): return member(mp.mpc(0), mp.mpc(1), mp.mpc(1, 1), turn, mu)
    >>> mu, area, t = equisymmetric(of, parabola, 0, 1)
    >>> abs(signed_area(of(mu), parabola, 0, t) - area / 2) < 1e-14
    True
    """

    def balance(mu: Any) -> Any:
        return signed_area(family(mu), path, low, high)

    ends = mp.mpf(1) / 16, mp.mpf(15) / 16
    if balance(ends[0]) * balance(ends[1]) >= 0:
        raise DomainError("The moons do not balance for any junction between 1/16 and 15/16.")
    mu = root_between(balance, *ends)
    biarc = family(mu)

    def distance(t: Any) -> Any:
        point, velocity = path(t)
        return biarc.displacement(point, velocity / abs(velocity))

    quarter = (high - low) / 4
    if distance(low + quarter) * distance(high - quarter) >= 0:
        raise DomainError("The arc does not cross the biarc in its middle half: shorten it.")
    crossing = root_between(distance, low + quarter, high - quarter)
    moons = (signed_area(biarc, path, *ends) for ends in ((low, crossing), (crossing, high)))
    return mu, sum(abs(moon) for moon in moons), crossing


def _sector(biarc: Biarc, point: Any) -> Any:
    """½∫[α, dα] about the biarc's start along it until that point, which lies on it."""
    ahead = mp.re(mp.conj(biarc.direction) * (point - biarc.junction))
    if point == biarc.start or (ahead <= 0 and point != biarc.end):  # an arc may turn by more than π
        return _segment(biarc.heading, point - biarc.start)
    r = point - biarc.junction
    corner = biarc.junction - biarc.start
    return _segment(biarc.heading, corner) + _cross(corner, r) / 2 + _segment(biarc.direction, r)


def _segment(T: Any, chord: Any) -> Any:
    """The area between an arc with that tangent and its chord, positive if it bends to the left."""
    turning = 2 * mp.arg(chord / T) if chord != 0 else mp.mpf(0)
    if turning == 0:
        return mp.mpf(0)
    return (turning - mp.sin(turning)) * abs(chord) ** 2 / (8 * mp.sin(turning / 2) ** 2)


def _cross(u: Any, v: Any) -> Any:
    return mp.im(mp.conj(u) * v)


def _curvature(p: Any, T: Any, q: Any) -> Any:
    d = q - p
    return 2 * mp.im(mp.conj(T) * d) / abs(d) ** 2


def _to_circle(base: Any, T: Any, curvature: Any, point: Any, tangent: Any) -> Any:
    """The small root d of K|r|²/2 − ⟨iT, r⟩ = 0 at r = point + i·tangent·d − base, or None."""
    r, normal = point - base, 1j * tangent
    linear = curvature * mp.re(mp.conj(normal) * r) - mp.re(mp.conj(1j * T) * normal)
    constant = curvature * abs(r) ** 2 / 2 - mp.re(mp.conj(1j * T) * r)
    discriminant = linear**2 - 2 * curvature * constant
    if discriminant < 0:
        return None
    root = mp.sqrt(discriminant)
    return -2 * constant / (linear + root if linear > 0 else linear - root)
