"""A bihelix tangent to a short arc at both ends: its distance from the arc as a power series.

The arc has length σ = 2h and is seen from its midpoint: T′ = κN, N′ = −κT + τB, B′ = −τN with the usual
torsion (the thesis's τ is −τ here). A helical arc leaves each end of the curve with the curve's tangent
there, its own curvature, torsion and principal normal, and both arcs meet with a common tangent. These are
the *true contact conditions*: five equations, solved here order by order in h for the curvatures, for the
angles between the principal normals of helix and curve, and for the length of the right arc. Free remain
the length h(1 + v) of the left arc and the two torsions, the three parameters of all bihelices.

At the point s = hx of the curve the displacement, measured in the curve's normal plane, is f·N + g·B.
Everything is a polynomial or a fraction in the symbols given, so what the series say holds for every curve.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import factorial
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.numbers.power_series import PowerSeries, identity, ratio

#: components along the tangent, the principal normal and the binormal
Triple = tuple[PowerSeries, PowerSeries, PowerSeries]


@dataclass(frozen=True)
class FrenetSeries:
    """A curve by arc length and its frame, as power series in components of the frame at s = 0."""

    point: Triple
    T: Triple
    N: Triple
    B: Triple

    def at(self, x: Any) -> FrenetSeries:
        """The same at s = hx, as series in h."""
        return FrenetSeries(*(_scaled(v, x) for v in (self.point, self.T, self.N, self.B)))

    def components(self, vector: Triple) -> Triple:
        """A vector's components along T, N and B."""
        return _dot(vector, self.T), _dot(vector, self.N), _dot(vector, self.B)


def frenet_series(kappa: Sequence[Any], tau: Sequence[Any], length: int) -> FrenetSeries:
    """The curve with given curvature and torsion (usual sign), to ``length`` terms in arc length.

    Args:
        kappa: κ, κ′, κ″, … at s = 0, elements of one ring; derivatives not given are 0.
        tau: τ, τ′, … likewise.
        length: number of terms of the frame; the point has one more, and is the origin at s = 0.

    >>> from sympy import QQ, ring
    >>> _, k, t = ring("k, t", QQ)
    >>> frenet_series([k], [t], 4).point[2]
    PowerSeries([0, 0, 0, 1/6*k*t, 0])
    """
    zero = kappa[0] * 0
    k, t = (_taylor(row, length, zero) for row in (kappa, tau))
    frame = [[[zero + int(i == j)] for j in range(3)] for i in range(3)]
    for n in range(length - 1):
        for j in range(3):
            T, N, B = (frame[i][j] for i in range(3))
            bent, twisted = _product(k, N, n), _product(t, B, n)
            rates = bent, twisted - _product(k, T, n), -_product(t, N, n)
            for i in range(3):
                frame[i][j].append(rates[i] * ratio(1, n + 1, zero))
    T3, N3, B3 = (_triple([PowerSeries(c) for c in frame[i]]) for i in range(3))
    return FrenetSeries(_triple([c.integral() for c in T3]), T3, N3, B3)


@dataclass(frozen=True)
class HelixSeries:
    """One helical arc of the bihelix: its data at the curve's end, as series in h.

    Attributes:
        end: −1 for the arc that begins at s = −h, 1 for the one that ends at s = h.
        curvature, torsion: constant along the arc.
        angle: from the curve's principal normal to the helix's, about the common tangent at the end.
        reach: the length of the arc.
    """

    end: int
    curvature: PowerSeries
    torsion: PowerSeries
    angle: PowerSeries
    reach: PowerSeries

    def run(self, curve: FrenetSeries, t: PowerSeries) -> tuple[Triple, Triple]:
        """Point and unit tangent at signed arc length t from the end, t(0) = 0."""
        at = curve.at(self.end)
        cosine, sine = _cosine_and_sine(self.angle)
        N = _triple([n * cosine + b * sine for n, b in zip(at.N, at.B)])
        B = _triple([b * cosine - n * sine for n, b in zip(at.N, at.B)])
        zero = t * 0
        rate: Triple = (zero + 1, zero, zero)
        point, tangent = [zero] * 3, [zero] * 3
        power = zero + 1
        for n in range(t.length):
            for i in range(3):
                tangent[i] = tangent[i] + rate[i] * power * ratio(1, factorial(n), zero[0])
                point[i] = point[i] + rate[i] * power * t * ratio(1, factorial(n + 1), zero[0])
            power = power * t
            k, tau = self.curvature, self.torsion
            rate = (-k * rate[1], k * rate[0] - tau * rate[2], tau * rate[1])
        moved, turned = (
            [v[0] * a + v[1] * b + v[2] * c for a, b, c in zip(at.T, N, B)] for v in (point, tangent)
        )
        return _triple([a + b for a, b in zip(at.point, moved)]), _triple(turned)


@dataclass(frozen=True)
class BihelixSeries:
    """The solved contact conditions: the curve, and the helical arcs left and right of the junction.

    ``order``: displacements and curvatures are known to errors O(h^(order+1)) and O(h^(order−1)).
    """

    curve: FrenetSeries
    left: HelixSeries
    right: HelixSeries
    order: int

    def displacement(self, side: str, x: Any) -> tuple[PowerSeries, PowerSeries]:
        """(f, g): normal and binormal component at s = hx, x an element of the ring, as series in h.

        Args:
            side: "left" or "right" of the junction; the formula of that side is given for every x.
            x: the position as a fraction of the half length, −1 to 1.
        """
        helix = self._side(side)
        at = self.curve.at(x)
        zero = self.left.reach[0] * 0
        # near the point of the same arc length; each step gains an order, for the speeds differ by O(h²)
        t = identity(self.order + 1, zero) * (x - helix.end)
        for _ in range(self.order):
            point, _ = helix.run(self.curve, t)
            along, f, g = at.components(_minus(point, at.point))
            t = t - along
        return f.cut(self.order + 1), g.cut(self.order + 1)

    def junction(self, side: str = "left") -> tuple[Triple, Triple]:
        """Junction point and tangent in the frame of the midpoint; both sides give the same."""
        helix = self._side(side)
        point, tangent = helix.run(self.curve, helix.reach * -helix.end)
        return _triple([c.cut(self.order + 1) for c in point]), _triple([c.cut(self.order) for c in tangent])

    def _side(self, side: str) -> HelixSeries:
        if side not in {"left", "right"}:
            raise DomainError(f'A side of the junction is "left" or "right", not {side!r}.')
        return self.left if side == "left" else self.right


def bihelix_series(
    kappa: Sequence[Any],
    tau: Sequence[Any],
    torsions: tuple[Sequence[Any], Sequence[Any]],
    offset: Sequence[Any],
    order: int = 3,
) -> BihelixSeries:
    """Solve the contact conditions of a bihelix with a curve.

    Args:
        kappa: κ, κ′, κ″, … of the curve at the midpoint, elements of one field; κ must not be 0.
        tau: τ, τ′, … likewise, with the usual sign.
        torsions: of the left and the right helix, each as coefficients of a power series in h.
        offset: v, likewise a power series in h; with v(0) = ±1 one side would have no arc.
        order: of the displacement in h, at least 3.

    Raises DomainError where the conditions are singular (κ = 0, v(0) = ±1) or the order too low.

    >>> from sympy import QQ, field
    >>> _, k, k1, t, x = field("k, k1, t, x", QQ)
    >>> spline = bihelix_series([k, k1], [t], ([t], [t]), [k * 0])
    >>> spline.displacement("left", x)[0][3]
    (-k1*x**3 - 2*k1*x**2 - k1*x)/6
    """
    if order < 3:
        raise DomainError(f"The displacement of a bihelix begins with order 3: order {order} says nothing.")
    if kappa[0] == 0 or offset[0] * offset[0] == 1:
        raise DomainError(
            f"The contact conditions are singular for κ = {kappa[0]}, offset {offset[0]}: neither may κ be 0 "
            "nor the offset ±1."
        )
    zero = kappa[0] * 0 + offset[0] * 0
    size = order + 1
    curve = frenet_series(kappa, tau, size)
    h = identity(size, zero)
    v, twist_left, twist_right = (_padded(row, size, zero) for row in (offset, *torsions))
    a_left: list[Any] = []
    a_right: list[Any] = []
    b_left: list[Any] = []
    b_right: list[Any] = []
    longer: list[Any] = []
    for n in range(order - 1):
        left = _arc(-1, kappa[0], a_left, b_left, twist_left, h * (1 + v))
        right = _arc(1, kappa[0], a_right, b_right, twist_right, h * (1 - v) + _raised(longer, 3, h))
        if n == order - 2:
            break
        gap = [_minus(p, q) for p, q in zip(left.run(curve, left.reach), right.run(curve, -right.reach))]
        # To leading order a term aₙ of a curvature, or bₙ of an angle times κ, moves the junction by
        # aₙh^(n+3)(1 ± v)²/2 along N, or along B, and its tangent by ± aₙh^(n+2)(1 ± v).
        for i, (lefts, rights, unit) in enumerate(
            [(a_left, a_right, zero + 1), (b_left, b_right, kappa[0])], start=1
        ):
            point, tangent = gap[0][i][n + 3], gap[1][i][n + 2]
            p, q = 1 + v[0], 1 - v[0]
            scale = ratio(1, 1, zero) / (p * q * unit)
            lefts.append(-(point + tangent * q * ratio(1, 2, zero)) * scale * q)
            rights.append((point - tangent * p * ratio(1, 2, zero)) * scale * p)
        longer.append(-gap[0][0][n + 3])
    return BihelixSeries(curve, left, right, order)


@cache
def leading_constant() -> Fraction:
    """c in the least error c·|κ′|σ³ of a bihelix: the peak of the normal component for v = 0.

    >>> leading_constant()
    Fraction(1, 324)
    """
    import sympy as sp

    _, k, slope, x = sp.field("k, slope, x", sp.QQ)
    zero = k * 0
    series = bihelix_series([k, slope], [zero], ([zero], [zero]), [zero])
    shape = series.displacement("left", x)[0][3].as_expr().subs("slope", 1)
    height = max(abs(shape.subs("x", root)) for root in sp.solve(sp.diff(shape, "x"), "x"))
    return Fraction(int(height.p), int(height.q)) / 8  # h³ = σ³/8


def _arc(
    end: int, kappa: Any, bends: list[Any], angles: list[Any], torsion: PowerSeries, reach: PowerSeries
) -> HelixSeries:
    h = identity(reach.length, reach[0] * 0)
    return HelixSeries(end, kappa + _raised(bends, 1, h), torsion, _raised(angles, 1, h), reach)


def _raised(coefficients: list[Any], by: int, h: PowerSeries) -> PowerSeries:
    """The series with these coefficients, times h to that power."""
    zero = h[0]
    return _padded([zero] * by + coefficients, h.length, zero)


def _padded(row: Sequence[Any], length: int, zero: Any) -> PowerSeries:
    return PowerSeries([*(c + zero for c in row), *[zero] * length][:length])


def _taylor(derivatives: Sequence[Any], length: int, zero: Any) -> list[Any]:
    """Taylor coefficients from derivatives, filled up with zeros."""
    found = [d * ratio(1, factorial(n), zero) + zero for n, d in enumerate(derivatives)]
    return (found + [zero] * length)[:length]


def _product(a: list[Any], b: list[Any], n: int) -> Any:
    """The coefficient of order n of a product of two series."""
    return sum((a[i] * b[n - i] for i in range(1, n + 1)), a[0] * b[n])


def _cosine_and_sine(angle: PowerSeries) -> tuple[PowerSeries, PowerSeries]:
    """Of a series without constant term, by their own series."""
    cosine, sine = angle * 0 + 1, angle
    power = angle
    for n in range(2, angle.length):
        power = power * angle
        term = power * ratio((-1) ** (n // 2), factorial(n), angle[0])
        if n % 2:
            sine = sine + term
        else:
            cosine = cosine + term
    return cosine, sine


def _triple(items: Sequence[PowerSeries]) -> Triple:
    a, b, c = items
    return a, b, c


def _scaled(v: Triple, factor: Any) -> Triple:
    return _triple([c.scaled(factor) for c in v])


def _minus(a: Triple, b: Triple) -> Triple:
    return _triple([p - q for p, q in zip(a, b)])


def _dot(a: Triple, b: Triple) -> PowerSeries:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
