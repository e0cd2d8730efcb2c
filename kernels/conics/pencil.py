"""The pencil of bitangent conics of one arc, seen from points of the curve (thesis 3.3)."""

from __future__ import annotations

import math

from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel

#: (P₀, T₀, P₂, T₂, ĉ, |chord|, sin A, sin B, sin ψ, noise of coordinates), flattened
Pencil = tuple[
    float, float, float, float, float, float, float, float, float, float, float, float, float, float, float
]
#: l₀, l₁, l₂, their derivatives along N and along T, the speed and the curvature at one curve point
View = tuple[float, float, float, float, float, float, float, float, float, float, float]


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
    return x0, y0, tx0, ty0, x2, y2, tx2, ty2, cx, cy, chord, sin_a, sin_b, sin_psi, noise


@kernel
def is_proper(pen: Pencil) -> bool:
    """Whether bounded members can exist: the arc bends to the left of both end tangents."""
    return pen[10] > 0.0 and pen[11] > 0.0 and pen[12] > 0.0


#: angles between the chord and the end tangents below which an arc is straight …
FLAT = 1e-13


@kernel
def is_flat(pen: Pencil) -> bool:
    """Whether the chord meets both end tangents as well as doubles can tell: then it is the piece."""
    flat = FLAT + pen[14] / pen[10]  # … where they can be told from rounding
    return abs(pen[11]) < flat and abs(pen[12]) < flat and pen[2] * pen[8] + pen[3] * pen[9] > 0.0


@kernel
def weight(pen: Pencil, q: float) -> float:
    """The Bézier weight w of the member Q; the arc is bounded iff w > −1."""
    w, _ = generated.weight(q, pen[10], pen[11], pen[12], pen[13])
    return w


#: the sine of the angle by which an arc must turn less than π for a parabola
NEAR_PI = 1e-8


@kernel
def parabola(pen: Pencil) -> float:
    """Q of the parabola; NaN if the end tangents do not meet ahead, or as good as at infinity."""
    turns_back = pen[2] * pen[6] + pen[3] * pen[7] < 0.0
    if not pen[13] > (NEAR_PI if turns_back else 0.0):
        return math.nan
    return generated.parabola(pen[11], pen[12], pen[13])


@kernel
def view(pen: Pencil, source: Source, t: float) -> View:
    """The three lines of the pencil and their derivatives at α(t)."""
    x, y, tx, ty, speed, curvature = sample(source, t)
    x0, y0, tx0, ty0, x2, y2, tx2, ty2, cx, cy, _, _, _, _, _ = pen
    ux, uy, vx, vy = x - x0, y - y0, x - x2, y - y2
    # [v, N] with N = (−T_y, T_x) is the scalar product of v and T
    return (
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
    d, by_q, slope, foot0, foot1, foot2 = generated.displacement(q, *seen)
    noise = pen[14]
    if foot0 >= -noise and foot1 <= noise and foot2 >= -noise:
        return d, by_q, slope
    return math.nan, by_q, slope


@kernel
def within_noise(pen: Pencil, seen: View) -> bool:
    """Whether the point is so near an end tangent or the chord that rounding hides on which side it is."""
    noise = pen[14]
    return abs(seen[0]) <= noise or abs(seen[1]) <= noise or abs(seen[2]) <= noise


@kernel
def through(seen: View) -> float:
    """Q of the member through the point, NaN unless the point is inside both end tangents."""
    if seen[0] > 0.0 and seen[2] > 0.0 and seen[1] < 0.0:
        return generated.through(seen[0], seen[1], seen[2])
    return math.nan
