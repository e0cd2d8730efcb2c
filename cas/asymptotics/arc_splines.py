"""Leading errors of a short arc replaced by a chord, tangent, biarc or triarc, from contact conditions.

The arc has Euclidean length σ = 2h; x ∈ [−1, 1] is arc length from its middle divided by h, and κ, κ₁, κ₂, …
are the curvature and its derivatives by arc length in the middle. The curve's ends are series in h over the
field ℚ(x, v, κ, κ₁, …), a circular arc is its entire series in curvature and length, and the contact
conditions are solved for the unknown curvatures and lengths coefficient by coefficient. Inserting the curve
into the equation K|p|²/2 − ⟨N, p⟩ = 0 of a circle through the origin with normal N and curvature K gives its
displacement along the normal, since the gradient is −N up to O(h). Nothing about f″ = K − κ(s) is assumed:
it comes out.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import factorial
from typing import Any

import sympy as sp

from osculant.cas.errors import DomainError
from osculant.cas.jets.canonical import euclidean_arc, series_of_derivatives
from osculant.cas.numbers.power_series import PowerSeries

#: the place on the arc, the junction of a biarc, those −a and b of a triarc, all divided by h
x, v, a, b = sp.symbols("x v a b", real=True)
#: the curvature and its derivatives by arc length in the middle
KAPPA = sp.symbols("kappa kappa1 kappa2 kappa3", real=True)
#: the highest power of h that is known: κ₃ enters the coordinates with h⁵
ORDER = 5

_FIELD, _X, _V, _A, _B, *_KAPPA = sp.field((x, v, a, b, *KAPPA), sp.QQ)
_ZERO, _ONE = _FIELD.zero, _FIELD.one

Pair = tuple[PowerSeries, PowerSeries]


@dataclass(frozen=True)
class Displacement:
    """The leading displacement of a primitive from the curve along the normal.

    Args:
        order: the power of h = σ/2, half the length of the arc.
        pieces: (from, to, f) for each piece: f(x)·h^order is the displacement for from ≤ x ≤ to.
    """

    order: int
    pieces: tuple[tuple[Any, Any, Any], ...]

    def curvature_difference(self) -> tuple[Any, ...]:
        """f″ of each piece: its curvature minus the curve's, over h^(order − 2).

        >>> chord().curvature_difference()
        (-kappa,)
        """
        return tuple(sp.factor(sp.diff(f, x, 2)) for _, _, f in self.pieces)

    def area(self) -> Any:
        """∫ f dx, signed: times h^(order + 1) the area between the primitive and the curve.

        >>> chord().area()
        2*kappa/3
        """
        return sp.factor(sum(sp.integrate(f, (x, low, high)) for low, high, f in self.pieces))


def chord() -> Displacement:
    """The chord of the arc: the contact conditions are two points.

    >>> chord().pieces
    ((-1, 1, -kappa*(x - 1)*(x + 1)/2),)
    """
    start = _point(-_ONE)
    along, across = _minus(_point(_ONE), start)
    q = _minus(_point(_X), start)
    return _leading([(-1, 1, (across * q[0] - along * q[1]).shifted(-1) / along.shifted(-1))])


def tangent() -> Displacement:
    """The tangent in the middle, as far as its neighbours touch the curve half an arc further: |x| ≤ 1.

    >>> tangent().pieces
    ((-1, 1, -kappa*x**2/2),)
    """
    return _leading([(-1, 1, -_point(_X)[1])])


@cache
def biarc_contact(order: int = ORDER - 2) -> tuple[PowerSeries, PowerSeries, PowerSeries]:
    """The biarc tangent to the curve at both ends whose first arc has length (1 + v)h.

    Three contact conditions (the turning, and both coordinates of the end) determine the curvatures K₁, K₂
    and the second length. The coefficient of hⁿ in the length is the first to appear, in the coordinate
    along the tangent at hⁿ⁺¹; then those of K₁ and K₂ enter the turning and the height linearly, with
    determinant v² − 1.

    Returns (K₁, K₂, second length over h) as series in h, of that order, over ℚ(v, κ, κ₁, …).

    Raises DomainError for an order below 0 or above 3, which κ … κ₃ do not carry.

    >>> first, second, length = biarc_contact(1)
    >>> first[1], second[1], length[1]
    (-2*kappa1/(3*v + 3), -2*kappa1/(3*v - 3), 0)
    """
    if not 0 <= order <= ORDER - 2:
        raise DomainError(f"Contact of order {order} is not carried by the jet: choose 0 to {ORDER - 2}.")
    p, q = _ONE + _V, _ONE - _V
    unknown = [[_KAPPA[0]], [_KAPPA[0]], [q]]
    for n in range(1, order + 1):
        for coefficients in unknown:
            coefficients.append(_ZERO)
        unknown[2][n] = _missing(p, unknown)[1][n + 1]
        turning, _, height = (part[n + k] for part, k in zip(_missing(p, unknown), (1, 0, 2), strict=True))
        # p·K₁ + q·K₂ = turning, (p²/2 + p·q)·K₁ + (q²/2)·K₂ = height
        lever = p * p / 2 + p * q
        determinant = p * q * q / 2 - q * lever
        unknown[0][n] = (turning * q * q / 2 - q * height) / determinant
        unknown[1][n] = (p * height - lever * turning) / determinant
    first, second, length = (PowerSeries(coefficients) for coefficients in unknown)
    return first, second, length


def _missing(p: Any, unknown: list[list[Any]]) -> tuple[PowerSeries, PowerSeries, PowerSeries]:
    """What the biarc lacks at its end: in turning, along the tangent, and in height."""
    first, second, length = (_long(coefficients) for coefficients in unknown)
    lengths = [_long([p]), length]
    return _end_defects([first, second], [part.shifted(1).cut(ORDER + 1) for part in lengths])


@cache
def biarc() -> Displacement:
    """The leading displacement of the bitangent biarc with junction vh from the middle.

    >>> [sp.factor(f.subs(v, 0)) for _, _, f in biarc().pieces]
    [-kappa1*x*(x + 1)**2/6, -kappa1*x*(x - 1)**2/6]
    """
    first, second, _ = (_long(series.coefficients) for series in biarc_contact(2))
    return _leading(
        [(-1, v, _to_circle(first, -_ONE)), (v, 1, _to_circle(second, _ONE))],
    )


@cache
def vertex_biarc() -> Displacement:
    """The same at a vertex, κ₁ = 0: both arcs lie on one circle, wherever the junction is.

    >>> vertex_biarc().pieces[0][2]
    -kappa2*(x - 1)**2*(x + 1)**2/24
    """
    first, second, _ = (_long(series.coefficients) for series in biarc_contact(2))
    pieces = [(-1, v, _to_circle(first, -_ONE)), (v, 1, _to_circle(second, _ONE))]
    return _leading(
        [(low, high, PowerSeries([_at_vertex(c) for c in f.coefficients])) for low, high, f in pieces]
    )


@cache
def triarc_conditions() -> tuple[Any, Any]:
    """The leading contact conditions of three arcs whose outer ones osculate the curve at its ends.

    The junctions are −a and b, and the curvature of the arc between them is that of the curve at v.
    Returns the polynomials in a, b, v that vanish: turning over κ₁h², height over κ₁h³.

    >>> triarc_conditions()[0]
    -a*v - a - b*v + b
    """
    turning, _, height = _end_defects(*_triarc())
    return tuple(sp.expand((c / _KAPPA[1]).as_expr()) for c in (turning[2], height[3]))


@cache
def triarc() -> Displacement:
    """The symmetric triarc (v = 0), the one whose two lobes are opposite; its junctions are −a and a.

    The conditions give 3a² = 1. Raises DomainError if they are singular there.

    >>> triarc().pieces[1][:2]
    (-sqrt(3)/3, sqrt(3)/3)
    """
    turning, height = (c.subs(v, 0) for c in triarc_conditions())
    positive = [s for s in sp.solve([turning, height], [a, b], dict=True) if s[a].is_positive]
    conditions = sp.Matrix(triarc_conditions())
    if len(positive) != 1 or conditions.jacobian([a, b]).det().subs(v, 0).subs(positive[0]) == 0:
        raise DomainError(
            f"The triarc's contact conditions are singular: {len(positive)} solutions at v = 0."
        )
    place = positive[0][a]
    outer = [
        _to_circle(curvature, end)
        for curvature, end in ((_curvature(-_ONE), -_ONE), (_curvature(_ONE), _ONE))
    ]
    curvatures, lengths = _triarc()
    start, heading = _step(_point(-_ONE), _heading(-_ONE), curvatures[0], lengths[0])
    between = _circle(curvatures[1], start, heading)
    found = _leading([(-1, -a, outer[0]), (-a, b, between), (b, 1, outer[1])])
    at = {a: place, b: place, v: 0}
    pieces = tuple(tuple(sp.expand(sp.sympify(part).subs(at)) for part in piece) for piece in found.pieces)
    return Displacement(found.order, pieces)


def _triarc() -> tuple[list[PowerSeries], list[PowerSeries]]:
    middle = _long([_KAPPA[0], _KAPPA[1] * _V])
    lengths = [_long([_ZERO, part]) for part in (_ONE - _A, _A + _B, _ONE - _B)]
    return [_curvature(-_ONE), middle, _curvature(_ONE)], lengths


# The curve, and circular arcs, as series in h.


def _long(coefficients: Any) -> PowerSeries:
    return PowerSeries([*coefficients, *(_ZERO,) * (ORDER + 1 - len(coefficients))])


@cache
def _coordinates() -> Pair:
    along, across, _ = euclidean_arc(ORDER, _KAPPA)
    return along, across


def _point(place: Any) -> Pair:
    along, across = _coordinates()
    return along.scaled(place), across.scaled(place)


def _heading(place: Any) -> Pair:
    along, across = (_long(c.derivative().coefficients) for c in _coordinates())
    return along.scaled(place), across.scaled(place)


def _curvature(place: Any) -> PowerSeries:
    return _long(series_of_derivatives(_KAPPA).coefficients).scaled(place)


def _minus(p: Pair, q: Pair) -> Pair:
    return p[0] - q[0], p[1] - q[1]


def _step(start: Pair, heading: Pair, curvature: PowerSeries, length: PowerSeries) -> tuple[Pair, Pair]:
    """The end and the heading there of a circular arc; sin ψ/ψ and (1 − cos ψ)/ψ need no division."""
    turning = curvature * length
    sinc, cosc, cosine, sine = (turning * 0 for _ in range(4))
    term = turning * 0 + _ONE
    for n in range(ORDER + 1):
        sign = (-1) ** (n // 2)
        if n % 2 == 0:
            cosine, sinc = cosine + term * sign * _over(n), sinc + term * sign * _over(n + 1)
        else:
            sine, cosc = sine + term * sign * _over(n), cosc + term * sign * _over(n + 1)
        term = term * turning
    t, n_ = heading, (-heading[1], heading[0])
    end = (
        start[0] + length * (sinc * t[0] + cosc * n_[0]),
        start[1] + length * (sinc * t[1] + cosc * n_[1]),
    )
    return end, (cosine * t[0] + sine * n_[0], cosine * t[1] + sine * n_[1])


def _over(n: int) -> Any:
    return _ONE / factorial(n)


def _end_defects(
    curvatures: list[PowerSeries], lengths: list[PowerSeries]
) -> tuple[PowerSeries, PowerSeries, PowerSeries]:
    """Turning, abscissa and ordinate of the curve's end minus those of the chain of arcs from its start."""
    bending = series_of_derivatives(_KAPPA).integral()
    turning = _long((bending - bending.scaled(-_ONE)).coefficients)
    place, heading = _point(-_ONE), _heading(-_ONE)
    for curvature, length in zip(curvatures, lengths, strict=True):
        turning = turning - curvature * length
        place, heading = _step(place, heading, curvature, length)
    return turning, *_minus(_point(_ONE), place)


def _to_circle(curvature: PowerSeries, end: Any) -> PowerSeries:
    """The displacement of the circle that touches the curve at that end."""
    return _circle(curvature, _point(end), _heading(end))


def _circle(curvature: PowerSeries, start: Pair, heading: Pair) -> PowerSeries:
    along, across = _minus(_point(_X), start)
    return curvature * (along * along + across * across) / 2 - (heading[0] * across - heading[1] * along)


def _at_vertex(coefficient: Any) -> Any:
    numerator, denominator = (
        _FIELD.ring(part.as_expr().subs(KAPPA[1], 0)) for part in (coefficient.numer, coefficient.denom)
    )
    return _FIELD(numerator) / _FIELD(denominator)


def _leading(pieces: list[tuple[Any, Any, PowerSeries]]) -> Displacement:
    order = min(n for _, _, f in pieces for n in range(f.length) if f[n] != 0)
    return Displacement(order, tuple((low, high, sp.factor(f[order].as_expr())) for low, high, f in pieces))
