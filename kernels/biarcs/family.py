"""The family of biarcs of one arc's end frames, and the signed distance of points from a biarc.

With Δ = p_R − p_L = |Δ|·T_L·e^{iα} and the turning ω from T_L to T_R the junctions p₀ lie on the junction
circle: p₀ = c + (p_L − c)e^{iμω}, 0 < μ < 1. As p_L − c = −Δ/(1 − e^{iω}), this is

    p₀ − p_L = Δ·e^{−i(1−μ)ω/2}·sin(μω/2)/sin(ω/2),   p_R − p₀ = Δ·e^{iμω/2}·sin((1−μ)ω/2)/sin(ω/2),

which also holds in the limit ω = 0, where the circle is a line. Arcs are kept by their curvature, so that
nearly straight ones are ordinary. Source: the reconstructed chapter 5 of the thesis, as in
`osculant.cas.geometry.biarcs`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from osculant.kernels.curves.plane import Frame
from osculant.kernels.jit import kernel

#: below this the quotient of sines is that of the angles
TINY = 1e-8
#: a turning less than −this is one of more than π; above, it is rounding
BACKWARDS = 1e-6


class Family(NamedTuple):
    """(p_L, T_L), (p_R, T_R), |Δ|, the direction of Δ, α and ω."""

    x0: float
    y0: float
    tx0: float
    ty0: float
    x2: float
    y2: float
    tx2: float
    ty2: float
    chord: float
    cx: float
    cy: float
    alpha: float
    omega: float


class Biarc(NamedTuple):
    """(p_L, T_L), the junction (p₀, T₀), (p_R, T_R), and the curvatures of both arcs."""

    x0: float
    y0: float
    tx0: float
    ty0: float
    x1: float
    y1: float
    tx1: float
    ty1: float
    x2: float
    y2: float
    tx2: float
    ty2: float
    bend0: float
    bend1: float


@kernel
def family(start: Frame, end: Frame) -> Family:
    """The family of biarcs between two frames; the turning is taken in (−π, π]."""
    x0, y0, tx0, ty0 = start
    x2, y2, tx2, ty2 = end
    dx, dy = x2 - x0, y2 - y0
    length = math.sqrt(dx * dx + dy * dy)
    cx, cy = dx / length, dy / length
    alpha = math.atan2(tx0 * cy - ty0 * cx, tx0 * cx + ty0 * cy)
    omega = math.atan2(tx0 * ty2 - ty0 * tx2, tx0 * tx2 + ty0 * ty2)
    return Family(x0, y0, tx0, ty0, x2, y2, tx2, ty2, length, cx, cy, alpha, omega)


@kernel
def is_proper(fam: Family) -> bool:
    """Whether the family belongs to an arc that bends to the left by less than π."""
    alpha, omega = fam.alpha, fam.omega
    return fam.chord > 0.0 and omega > -BACKWARDS and alpha > -BACKWARDS and omega - alpha > -BACKWARDS


@kernel
def member(fam: Family, mu: float) -> Biarc:
    """The biarc with parameter μ in (0, 1)."""
    x0, y0, tx0, ty0, x2, y2, tx2, ty2, length, cx, cy, alpha, omega = fam
    first, last = 0.5 * mu * omega, 0.5 * (1.0 - mu) * omega
    part, rest = mu, 1.0 - mu
    sine_first, cosine_first = math.sin(first), math.cos(first)
    sine_last, cosine_last = math.sin(last), math.cos(last)
    if abs(omega) > TINY:
        sine = sine_first * cosine_last + cosine_first * sine_last
        part, rest = sine_first / sine, sine_last / sine
    # the chord's direction turned by −last is that of p₀ − p_L
    ux, uy = cx * cosine_last + cy * sine_last, cy * cosine_last - cx * sine_last
    dot, cross = tx0 * ux + ty0 * uy, tx0 * uy - ty0 * ux
    tx, ty = ux * dot - uy * cross, uy * dot + ux * cross  # T_L mirrored in it
    bend, next_bend = alpha - last, omega - alpha - first
    return Biarc(
        x0, y0, tx0, ty0,
        x0 + length * part * ux, y0 + length * part * uy, tx, ty,
        x2, y2, tx2, ty2,
        2.0 * math.sin(bend) / (length * part), 2.0 * math.sin(next_bend) / (length * rest),
    )  # fmt: skip


@kernel
def is_short(arcs: Biarc) -> bool:
    """Whether both arcs turn by less than π."""
    first = (arcs.x1 - arcs.x0) * arcs.tx0 + (arcs.y1 - arcs.y0) * arcs.ty0
    last = (arcs.x2 - arcs.x1) * arcs.tx2 + (arcs.y2 - arcs.y1) * arcs.ty2
    return first > 0.0 and last > 0.0


@kernel
def to_circle(
    px: float, py: float, tx: float, ty: float, bend: float,
    x: float, y: float, sx: float, sy: float, curvature: float,
) -> tuple[float, float, float]:  # fmt: skip
    """(D, D′, D″) of a point of a curve from a circle: signed distance and derivatives by arc length.

    The circle touches (px, py) with tangent (tx, ty) and has the signed curvature ``bend``; D is positive to
    its left.  (x, y), (sx, sy), ``curvature`` are the curve's point, unit tangent and curvature.
    """
    wx, wy = x - px, y - py
    twice = 2.0 * (tx * wy - ty * wx) - bend * (wx * wx + wy * wy)
    root = math.sqrt(max(0.0, 1.0 - bend * twice))  # distance from the centre over the radius
    nx, ny = -ty - bend * wx, tx - bend * wy
    slope = (nx * sx + ny * sy) / root
    second = (curvature * (ny * sx - nx * sy) - bend * (1.0 - slope * slope)) / root
    return twice / (1.0 + root), slope, second


@kernel
def distance(
    arcs: Biarc, x: float, y: float, sx: float, sy: float, curvature: float,
) -> tuple[float, float, float]:  # fmt: skip
    """(D, D′, D″) of a point of a curve from the biarc, D > 0 to its left; arguments as of `to_circle`.

    The normal at the junction separates the points that belong to either arc.
    """
    if (x - arcs.x1) * arcs.tx1 + (y - arcs.y1) * arcs.ty1 <= 0.0:
        return to_circle(arcs.x0, arcs.y0, arcs.tx0, arcs.ty0, arcs.bend0, x, y, sx, sy, curvature)
    return to_circle(arcs.x2, arcs.y2, arcs.tx2, arcs.ty2, arcs.bend1, x, y, sx, sy, curvature)


@kernel
def is_beside(arcs: Biarc, x: float, y: float, slack: float) -> bool:
    """Whether the foot of the point on the nearer circle lies on the biarc, up to ``slack``.

    For arcs that turn by less than π: the normals at the ends of an arc bound the points beside it.
    """
    after = (x - arcs.x0) * arcs.tx0 + (y - arcs.y0) * arcs.ty0
    before = (arcs.x2 - x) * arcs.tx2 + (arcs.y2 - y) * arcs.ty2
    ahead = (x - arcs.x1) * arcs.tx1 + (y - arcs.y1) * arcs.ty1
    return (after >= -slack) if ahead <= 0.0 else (before >= -slack)
