"""The cubic of an arc by its two arms, and how far it is from a point of the curve along the normal.

B has the controls P₀, P₀ + a₀T₀, P₃ − a₃T₃, P₃.  Relative to a point of the curve, in its tangent and normal,
it is two scalar cubics: the foot is where the one along the tangent vanishes, the displacement d is the other
there.  B stands for the arc only where feet go from 0 to 1 with the curve and B′ never turns against it; then
it is a graph over the curve, without loop or cusp, and max |d| bounds the Hausdorff distance of the two.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from osculant.kernels.curves.plane import Frame, Sample
from osculant.kernels.jit import kernel

#: Newton steps to a foot, and the step that is the last: what is left is its square
STEPS, NEAR = 12, 1e-7
#: feet may be outside [0, 1] by so much, by rounding
BEYOND = 1e-9
#: the least arm, in parts of the chord
SHORTEST = 1e-6


class Ends(NamedTuple):
    """The ends of an arc: start, chord as a vector, both unit tangents, the length of the chord."""

    x: float
    y: float
    dx: float
    dy: float
    tx0: float
    ty0: float
    tx3: float
    ty3: float
    chord: float


class Seen(NamedTuple):
    """A cubic as a point of the curve sees it along the normal.

    Attributes:
        foot: the cubic's parameter there; NaN if the normal does not meet it as it should.
        d: displacement, positive to the left.
        slope: its derivative by the curve's parameter.
        by0, by3: its derivatives by the arms.
    """

    foot: float
    d: float
    slope: float
    by0: float
    by3: float


@kernel
def ends_of(start: Frame, end: Frame) -> Ends:
    """The ends of the arc between two frames."""
    dx, dy = end.x - start.x, end.y - start.y
    chord = math.sqrt(dx * dx + dy * dy)
    return Ends(start.x, start.y, dx, dy, start.tx, start.ty, end.tx, end.ty, chord)


@kernel
def reach(ends: Ends) -> float:
    """Both arms of the circular arc's cubic with such a chord and such a turning below π; infinite above."""
    cosine = ends.tx0 * ends.tx3 + ends.ty0 * ends.ty3
    half = math.sqrt(max(0.0, 0.5 * (1.0 + cosine)))
    return 2.0 * ends.chord / (3.0 * (1.0 + half))


@kernel
def blossom(first: float, middle: float, last: float, u: float, v: float) -> float:
    """The polar form of a quadratic by its Bernstein coefficients: on [u, v] three of these are its own."""
    one, other = (1.0 - u) * first + u * middle, (1.0 - u) * middle + u * last
    return (1.0 - v) * one + v * other


@kernel
def goes_along(ends: Ends, a0: float, a3: float, low: float, high: float, tx: float, ty: float) -> bool:
    """Whether B′ has a positive component along a direction at all parameters between two.

    It is so if its three Bernstein coefficients are there.
    """
    first, last = a0 * (ends.tx0 * tx + ends.ty0 * ty), a3 * (ends.tx3 * tx + ends.ty3 * ty)
    middle = ends.dx * tx + ends.dy * ty - first - last
    return (
        blossom(first, middle, last, low, low) > 0.0
        and blossom(first, middle, last, low, high) > 0.0
        and blossom(first, middle, last, high, high) > 0.0
    )


@kernel
def bends_little(ends: Ends, a0: float, a3: float, low: float, high: float, cosine: float) -> bool:
    """Whether B′ turns between two parameters by no more than an angle below a right one, given its cosine.

    It is so if its three Bernstein coefficients there do not.
    """
    x0, y0, x2, y2 = a0 * ends.tx0, a0 * ends.ty0, a3 * ends.tx3, a3 * ends.ty3
    x1, y1 = ends.dx - x0 - x2, ends.dy - y0 - y2
    px, py = blossom(x0, x1, x2, low, low), blossom(y0, y1, y2, low, low)
    qx, qy = blossom(x0, x1, x2, low, high), blossom(y0, y1, y2, low, high)
    rx, ry = blossom(x0, x1, x2, high, high), blossom(y0, y1, y2, high, high)
    p, q, r = math.sqrt(px * px + py * py), math.sqrt(qx * qx + qy * qy), math.sqrt(rx * rx + ry * ry)
    return (
        px * qx + py * qy >= cosine * p * q
        and qx * rx + qy * ry >= cosine * q * r
        and px * rx + py * ry >= cosine * p * r
    )


@kernel
def see(ends: Ends, a0: float, a3: float, at: Sample, guess: float) -> Seen:
    """The cubic with these arms from a sample of the curve, the foot being sought from a guess."""
    rx, ry = at.x - ends.x, at.y - ends.y
    tx, ty = at.tx, at.ty
    ex, ey = ends.dx - rx, ends.dy - ry
    # controls along the tangent and along the normal
    along0, across0 = -rx * tx - ry * ty, rx * ty - ry * tx
    along3, across3 = ex * tx + ey * ty, ey * tx - ex * ty
    tangent0, normal0 = ends.tx0 * tx + ends.ty0 * ty, ends.ty0 * tx - ends.tx0 * ty
    tangent3, normal3 = ends.tx3 * tx + ends.ty3 * ty, ends.ty3 * tx - ends.tx3 * ty
    along1, across1 = along0 + a0 * tangent0, across0 + a0 * normal0
    along2, across2 = along3 - a3 * tangent3, across3 - a3 * normal3
    u, step, rate = guess, math.inf, 0.0
    for _ in range(STEPS):
        v = 1.0 - u
        value = v * v * (v * along0 + 3.0 * u * along1) + u * u * (3.0 * v * along2 + u * along3)
        rate = 3.0 * (v * v * (along1 - along0) + 2.0 * u * v * (along2 - along1) + u * u * (along3 - along2))
        step = value / rate
        u = min(1.5, max(-0.5, u - step))
        if abs(step) <= NEAR:
            break
    v = 1.0 - u
    rate = 3.0 * (v * v * (along1 - along0) + 2.0 * u * v * (along2 - along1) + u * u * (along3 - along2))
    if not (abs(step) <= NEAR and rate > 0.0 and u > -BEYOND and v > -BEYOND):
        return Seen(math.nan, math.nan, math.nan, math.nan, math.nan)
    d = v * v * (v * across0 + 3.0 * u * across1) + u * u * (3.0 * v * across2 + u * across3)
    rise = 3.0 * (
        v * v * (across1 - across0) + 2.0 * u * v * (across2 - across1) + u * u * (across3 - across2)
    )
    lean = rise / rate
    return Seen(
        u,
        d,
        at.speed * lean * (1.0 - at.curvature * d),
        3.0 * v * v * u * (normal0 - lean * tangent0),
        -3.0 * v * u * u * (normal3 - lean * tangent3),
    )
