"""The pencil of bitangent conics of one arc, seen from points of the curve (thesis 3.3)."""

from __future__ import annotations

import math
from typing import NamedTuple

from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel


class Pencil(NamedTuple):
    """The bitangent conics of one arc: end frames (P₀, T₀), (P₂, T₂), the chord, and its angles.

    ``c`` is the chord's direction and A, B, ψ its angles with the end tangents and the angle between those.
    """

    x0: float
    y0: float
    tx0: float
    ty0: float
    x2: float
    y2: float
    tx2: float
    ty2: float
    cx: float
    cy: float
    chord: float
    sin_a: float
    sin_b: float
    sin_psi: float
    noise: float


class View(NamedTuple):
    """l₀, l₁, l₂ at a curve point, their derivatives along N and along T, the speed and the curvature."""

    l0: float
    l1: float
    l2: float
    n0: float
    n1: float
    n2: float
    t0: float
    t1: float
    t2: float
    speed: float
    curvature: float


@kernel
def pencil(start: Frame, end: Frame, noise: float) -> Pencil:
    """The pencil of an arc from its end frames, whose points are known up to ``noise``."""
    x0, y0, tx0, ty0 = start
    x2, y2, tx2, ty2 = end
    chord = math.sqrt((x2 - x0) ** 2 + (y2 - y0) ** 2)
    cx, cy = (x2 - x0) / chord, (y2 - y0) / chord
    sin_a = tx0 * cy - ty0 * cx
    sin_b = cx * ty2 - cy * tx2
    sin_psi = tx0 * ty2 - ty0 * tx2
    return Pencil(x0, y0, tx0, ty0, x2, y2, tx2, ty2, cx, cy, chord, sin_a, sin_b, sin_psi, noise)


@kernel
def is_proper(pen: Pencil) -> bool:
    """Whether bounded members can exist: the arc bends to the left of both end tangents."""
    return pen.chord > 0.0 and pen.sin_a > 0.0 and pen.sin_b > 0.0


#: angles between the chord and the end tangents below which an arc is straight …
FLAT = 1e-13


@kernel
def is_flat(pen: Pencil) -> bool:
    """Whether the chord meets both end tangents as well as doubles can tell: then it is the piece."""
    flat = FLAT + pen.noise / pen.chord  # … where they can be told from rounding
    return abs(pen.sin_a) < flat and abs(pen.sin_b) < flat and pen.tx0 * pen.cx + pen.ty0 * pen.cy > 0.0


@kernel
def weight(pen: Pencil, q: float) -> float:
    """The Bézier weight w of the member Q; the arc is bounded iff w > −1."""
    w, _ = generated.weight(q, pen.chord, pen.sin_a, pen.sin_b, pen.sin_psi)
    return w


#: the sine of the angle by which an arc must turn less than π for a parabola
NEAR_PI = 1e-8


@kernel
def parabola(pen: Pencil) -> float:
    """Q of the parabola; NaN if the end tangents do not meet ahead, or as good as at infinity."""
    turns_back = pen.tx0 * pen.tx2 + pen.ty0 * pen.ty2 < 0.0
    if not pen.sin_psi > (NEAR_PI if turns_back else 0.0):
        return math.nan
    return generated.parabola(pen.sin_a, pen.sin_b, pen.sin_psi)


@kernel
def view(pen: Pencil, source: Source, t: float) -> View:
    """The three lines of the pencil and their derivatives at α(t)."""
    x, y, tx, ty, speed, curvature = sample(source, t)
    ux, uy, vx, vy = x - pen.x0, y - pen.y0, x - pen.x2, y - pen.y2
    tx0, ty0, tx2, ty2, cx, cy = pen.tx0, pen.ty0, pen.tx2, pen.ty2, pen.cx, pen.cy
    # [v, N] with N = (−T_y, T_x) is the scalar product of v and T
    return View(
        tx2 * vy - ty2 * vx,
        cx * uy - cy * ux,
        tx0 * uy - ty0 * ux,
        tx2 * tx + ty2 * ty,
        cx * tx + cy * ty,
        tx0 * tx + ty0 * ty,
        tx2 * ty - ty2 * tx,
        cx * ty - cy * tx,
        tx0 * ty - ty0 * tx,
        speed,
        curvature,
    )


@kernel
def displacement(pen: Pencil, q: float, seen: View) -> tuple[float, float, float]:
    """d, ∂d/∂Q and d′ at a point; d is NaN where the normal misses the arc of the member Q."""
    d, by_q, slope, foot0, foot1, foot2 = generated.displacement(
        q, seen.l0, seen.l1, seen.l2, seen.n0, seen.n1, seen.n2,
        seen.t0, seen.t1, seen.t2, seen.speed, seen.curvature,
    )  # fmt: skip
    noise = pen.noise
    if foot0 >= -noise and foot1 <= noise and foot2 >= -noise:
        return d, by_q, slope
    return math.nan, by_q, slope


@kernel
def within_noise(pen: Pencil, seen: View) -> bool:
    """Whether the point is so near an end tangent or the chord that rounding hides on which side it is."""
    noise = pen.noise
    return abs(seen.l0) <= noise or abs(seen.l1) <= noise or abs(seen.l2) <= noise


@kernel
def through(seen: View) -> float:
    """Q of the member through the point, NaN unless the point is inside both end tangents."""
    if seen.l0 > 0.0 and seen.l2 > 0.0 and seen.l1 < 0.0:
        return generated.through(seen.l0, seen.l1, seen.l2)
    return math.nan
