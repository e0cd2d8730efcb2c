"""The short helix through two points with given unit tangents (thesis theorem 4.3.2), and its points.

A helical arc is short if it turns by less than 2π about its axis.  One parameter χ describes all unit vectors
V with ⟨V, T₀⟩ = ⟨V, T₁⟩ and the turning φ about V that takes T₀ to T₁; the direction of the chord fixes it.
`osculant.cas.geometry.short_helices` has the formulas and the reference, claim R4.3-7 the proof that the
root is unique.  V, τ̄ and χ are the thesis's; the torsion of a `Helix` has the usual sign.

Data of a short arc hardly determine V and τ, but the points of the arc do not care: they are computed from
T₀ with corrections that carry the small factors (sin x − x)/x and (1 − cos x)/x.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.vectors import Vector, combine, cross, dot, norm, scaled, subtract, unit
from osculant.kernels.jit import kernel

#: what `short_helix` found: a proper helix; an arc of a circle; a half circle, T₁ = −T₀; a straight segment
TWISTED, PLANE, HALF_CIRCLE, SEGMENT = 0, 1, 2, 3
#: … or why there is none: p₁ = p₀; ⟨p₁ − p₀, T₁ − T₀⟩ ≠ 0; T₁ = T₀ not along the chord; no finite numbers
COINCIDENT, NOT_COPLANAR, ASKEW, UNDEFINED = -1, -2, -3, -4

#: sines of half angles below which tangents count as equal, or as opposite
SAME = 8.0 * 2.0**-53
#: the most that a tangent is moved to make up for rounding of the data
NUDGE = 2e-15
#: sine of the angle between chord and mean tangent below which the chord's side is lost in rounding
ALIGNED = 1e-12
#: steps of the root finder for χ
STEPS = 100
#: turnings below which differences of trigonometric functions are taken from their series
SMALL = 0.5


class Helix(NamedTuple):
    """A helical arc, an arc of a circle, or a straight segment.

    Attributes:
        start: its first point.
        tangent: T₀, the unit tangent there.
        pole: τ̄V; of a segment the tangent.
        side: T₀ × V = κ̄N₀; of a segment 0.
        rate: β, the turning by arc length; of a segment 0, as are the following but for the length.
        length: of the arc.
        turning: φ about the axis.
        curvature: κ.
        torsion: τ.
    """

    start: Vector
    tangent: Vector
    pole: Vector
    side: Vector
    rate: float
    length: float
    turning: float
    curvature: float
    torsion: float


#: how many numbers that is
HELIX_SIZE = 17


@kernel
def write_helix(helix: Helix, row: np.ndarray[Any, Any], first: int) -> None:
    """Write the numbers of a helix into a row, from column ``first`` on."""
    for j in range(3):
        row[first + j], row[first + 3 + j] = helix.start[j], helix.tangent[j]
        row[first + 6 + j], row[first + 9 + j] = helix.pole[j], helix.side[j]
    row[first + 12], row[first + 13], row[first + 14] = helix.rate, helix.length, helix.turning
    row[first + 15], row[first + 16] = helix.curvature, helix.torsion


@kernel
def turning_defect(half: float, sine: float, cosine: float) -> float:
    """2 sin(φ/2) − φ cos(φ/2) ≥ 0 for half = φ/2 and its sine and cosine, without cancellation.

    >>> round(turning_defect(0.001, math.sin(0.001), math.cos(0.001)) * 1.5e9, 6)
    1.0
    """
    if half > SMALL:
        return 2.0 * (sine - half * cosine)
    # sin x − x cos x = Σ (−1)^(k+1) 2k x^(2k+1)/(2k+1)!
    x = half * half
    series = 1.0 / 3.0 - x * (
        1.0 / 30.0 - x * (1.0 / 840.0 - x * (1.0 / 45360.0 - x * (1.0 / 3991680.0 - x * (1.0 / 518918400.0))))
    )
    return 2.0 * half * x * series


@kernel
def parameter(h: float, c: float, ahead: float, aside: float) -> float:
    """χ in (0, π) at which (X, Y) has the direction of (ahead, aside), aside > 0: safeguarded Newton.

    h and c are sine and cosine of half the angle between the tangents.
    """
    target = math.atan2(aside, ahead)
    low, high = 0.0, math.pi
    # on short arcs the angle of (X, Y) is hχ/3; for h near 1 it is χ
    chi = min(target * (3.0 / h - (3.0 / h - 1.0) * target / math.pi), 0.999 * math.pi)
    for _ in range(STEPS):
        sine, cosine = math.sin(chi), math.cos(chi)
        s = math.sqrt(sine * sine + h * h * cosine * cosine)
        half = math.atan2(s, c * cosine)
        defect = turning_defect(half, s, c * cosine)
        phi = 2.0 * half
        x = phi * c * sine * sine + 2.0 * h * h * s * cosine
        y = h * sine * defect
        turn = c * sine / s  # half the derivative of φ
        x_slope = 2.0 * c * sine * (turn * sine + phi * cosine)
        x_slope += 2.0 * h * h * (c * turn * cosine * cosine - s * sine)
        y_slope = h * (cosine * defect + sine * sine * phi * c)
        miss = y * ahead - x * aside
        if miss < 0.0:
            low = chi
        else:
            high = chi
        # Newton's step for the angle itself, which is nearly linear in χ
        angle = math.atan2(miss, x * ahead + y * aside)
        new = chi - angle * (x * x + y * y) / (x * y_slope - y * x_slope)
        if abs(new - chi) <= 1e-15 * chi:
            return new
        if not (new > low and new < high):
            new = 0.5 * (low + high)
        if high - low <= 1e-15 * high:
            return new
        chi = new
    return chi


@kernel
def straight(p: Vector, tangent: Vector, length: float) -> Helix:
    """The straight segment from p in the direction of the unit vector ``tangent``.

    >>> point_at(straight((1.0, 2.0, 3.0), (0.0, 0.0, 1.0), 5.0), 4.0)
    (1.0, 2.0, 7.0)
    """
    return Helix(p, tangent, tangent, (0.0, 0.0, 0.0), 0.0, length, 0.0, 0.0, 0.0)


@kernel
def short_helix(
    p0: Vector, t0: Vector, p1: Vector, t1: Vector, tolerance: float, flat: float
) -> tuple[int, float, Helix]:
    """The short helix from (p₀, T₀) to (p₁, T₁).

    Args:
        p0: start point.
        t0: unit tangent there.
        p1: end point.
        t1: unit tangent there.
        tolerance: the most that |⟨p₁ − p₀, T₁ − T₀⟩|/|p₁ − p₀| may be (0 in theory, never 0 in doubles).
            So that there is a helix, both tangents are moved by half of it, each by `NUDGE` at most, and the
            end point by the rest.
        flat: distance of the end point from the plane of the start point and the tangents up to which the arc
            is taken to lie in that plane, and of a straight segment's end from its tangent; at least
            rounding, 64 units of |p₁ − p₀|.

    Returns:
        What it is (`TWISTED` … `SEGMENT`, or `COINCIDENT` … if there is none), the residual
        |⟨p₁ − p₀, T₁ − T₀⟩|/|p₁ − p₀|, and the helix.

    >>> kind, residual, arc = short_helix((0., 0., 0.), (0., 1., 0.), (2., 0., 0.), (0., -1., 0.), 1e-12, 0.0)
    >>> kind == HALF_CIRCLE, round(arc.length, 12), arc.curvature
    (True, 3.14159265359, 1.0)
    """
    chord = subtract(p1, p0)
    distance = norm(chord)
    none = straight(p0, t0, 0.0)
    if distance == 0.0:
        return COINCIDENT, 0.0, none
    along = scaled(1.0 / distance, chord)
    change = subtract(t1, t0)
    residual = dot(along, change)
    if not abs(residual) <= tolerance:
        return (NOT_COPLANAR if math.isfinite(residual) else UNDEFINED), abs(residual), none
    flat = max(flat, 16.0 * SAME * distance)
    middle = combine(0.5, t0, 0.5, t1)
    h, c = 0.5 * norm(change), norm(middle)
    if h <= SAME:
        off = cross(chord, middle)
        if dot(chord, middle) < 0.0 or norm(off) > flat:
            return ASKEW, abs(residual), none
        return SEGMENT, abs(residual), straight(p0, along, distance)
    # T₁ − T₀ and T₀ + T₁ are made orthogonal to one another, which they are but for the rounding of |T₀| and
    # |T₁|, and the first to the chord, as far as the tangents may be moved
    pull = along
    if c >= h:
        m = scaled(1.0 / c, middle)
        change = combine(1.0, change, -dot(change, m), m)
        pull = combine(1.0, along, -dot(along, m), m)
        pull = combine(1.0, pull, -dot(pull, m), m)
    size = norm(pull)
    if size > ALIGNED:
        pull = scaled(1.0 / size, pull)
        nudge = min(2.0 * NUDGE, max(-2.0 * NUDGE, dot(pull, change)))
        change = combine(1.0, change, -nudge, pull)
    h = min(1.0, 0.5 * norm(change))
    g = unit(change)
    chord = combine(1.0, chord, -dot(chord, g), g)
    distance = norm(chord)
    middle = combine(1.0, middle, -dot(middle, g), g)
    c = norm(middle)
    kind = TWISTED
    if c <= SAME:
        c, h, e = 0.0, 1.0, unit(chord)
        kind = HALF_CIRCLE
    else:
        e = scaled(1.0 / c, middle)
        c = math.sqrt((1.0 - h) * (1.0 + h)) if h < 0.75 else c
        h = math.sqrt((1.0 - c) * (1.0 + c)) if h >= 0.75 else h
    f = cross(g, e)
    ahead, aside = dot(chord, e), dot(chord, f)
    if kind == HALF_CIRCLE or abs(aside) <= flat:
        kind = PLANE if kind == TWISTED else kind
        sine, cosine = 0.0, math.copysign(1.0, ahead)
    else:
        chi = parameter(h, c, ahead, abs(aside))
        sine, cosine = math.copysign(math.sin(chi), -aside), math.cos(chi)
    s = math.sqrt(sine * sine + h * h * cosine * cosine)
    phi = 2.0 * math.atan2(s, c * cosine)
    v = combine(sine / s, e, h * cosine / s, f)
    slope = c * sine / s
    rate = math.hypot(2.0 * h, slope * phi) / distance
    tangent = combine(c, e, -h, g)  # T₀ moved to where the helix exists: by rounding, or half the residual
    side = cross(tangent, v)
    length, curvature = phi / rate, h / s * rate
    helix = Helix(p0, tangent, scaled(slope, v), side, rate, length, phi, curvature, -slope * rate)
    return kind, abs(residual), helix


@kernel
def rounding(x: float, sine: float, cosine: float) -> tuple[float, float]:
    """((sin x − x)/x, (1 − cos x)/x) for sine and cosine of x, without cancellation.

    >>> [f"{x:.9e}" for x in rounding(1e-4, math.sin(1e-4), math.cos(1e-4))]
    ['-1.666666666e-09', '4.999999996e-05']
    """
    if abs(x) > SMALL:
        return (sine - x) / x, (1.0 - cosine) / x
    y = x * x
    third = -y * (
        1.0 / 6.0 - y * (1.0 / 120.0 - y * (1.0 / 5040.0 - y * (1.0 / 362880.0 - y * (1.0 / 39916800.0))))
    )
    second = x * (
        0.5
        - y * (1.0 / 24.0 - y * (1.0 / 720.0 - y * (1.0 / 40320.0 - y * (1.0 / 3628800.0 - y / 479001600.0))))
    )
    return third, second


@kernel
def place_at(helix: Helix, s: float) -> tuple[Vector, Vector, Vector]:
    """Point, unit tangent T and its derivative κN at arc length s; the helix goes on beyond its ends.

    >>> circle = short_helix((1., 0., 0.), (0., 1., 0.), (-1., 0., 0.), (0., -1., 0.), 1e-12, 0.0)[2]
    >>> [[round(x, 9) + 0.0 for x in vector] for vector in place_at(circle, math.pi / 2)]
    [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]
    """
    t, side, rate = helix.tangent, helix.side, helix.rate
    out = subtract(t, helix.pole)
    x = rate * s
    sine, cosine = math.sin(x), math.cos(x)
    if x == 0.0:
        third, second = 0.0, 0.0
    else:
        third, second = rounding(x, sine, cosine)
    p = (
        helix.start[0] + s * (t[0] + third * out[0] + second * side[0]),
        helix.start[1] + s * (t[1] + third * out[1] + second * side[1]),
        helix.start[2] + s * (t[2] + third * out[2] + second * side[2]),
    )
    versine = -x * second
    tangent = (
        t[0] + versine * out[0] + sine * side[0],
        t[1] + versine * out[1] + sine * side[1],
        t[2] + versine * out[2] + sine * side[2],
    )
    return p, tangent, combine(rate * cosine, side, -rate * sine, out)


@kernel
def point_at(helix: Helix, s: float) -> Vector:
    """The point at arc length s."""
    return place_at(helix, s)[0]


@kernel
def tangent_at(helix: Helix, s: float) -> Vector:
    """The unit tangent at arc length s."""
    return place_at(helix, s)[1]


@kernel
def moved(helix: Helix, origin: Vector, scale: float) -> Helix:
    """The helix with all coordinates divided by ``scale`` and then moved by ``origin``."""
    k = helix.start
    start = (k[0] / scale + origin[0], k[1] / scale + origin[1], k[2] / scale + origin[2])
    return Helix(
        start, helix.tangent, helix.pole, helix.side, helix.rate * scale, helix.length / scale,
        helix.turning, helix.curvature * scale, helix.torsion * scale,
    )  # fmt: skip
