"""One bihelix of an arc: its junction by either rule, and its two helices.

Two short helices from (p_L, T_L) over (p₀, T₀) to (p_R, T_R).  Given T₀, the junction point p₀ is on the
junction line, ⟨p₀ − p_L, T₀ − T_L⟩ = 0 = ⟨p_R − p₀, T_R − T₀⟩.  At the offset u from the middle of an arc of
length σ the approximation theorem asks for T₀ = normalise(T − κ′(σ²/24 + u²/2)N).

* `THESIS`: u = 0, and p₀ is the point of the line nearest to the middle of the arc;
* `EQUIOSCILLATING`: p₀ is the point of the line nearest to the curve, and u makes the largest distances on
  both sides of the junction equal (`osculant.kernels.bihelices.balance`);
* `LEVEL`, in place of either where it has no bihelix: T₀ is turned until q, the curve point at u, has the
  same distance d from both junction planes, along their normals, and p₀ is the point of the line nearest to
  q.  Beside κ = 0 the two planes are so nearly parallel that their line may be as far from the curve as the
  arc from its chord, and helices turn a lot to get there; here |p₀ − q| is d/cos(half the planes' angle).

`osculant.cas.geometry.bihelix_rules` is the reference.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from osculant.kernels.bihelices.helix import SAME, Helix, short_helix, straight
from osculant.kernels.bracket import safeguarded
from osculant.kernels.curves.arc_length import Lengths, after
from osculant.kernels.curves.space import Frame, Source, bends, sample
from osculant.kernels.curves.vectors import Vector, combine, cross, dot, norm, scaled, subtract, unit
from osculant.kernels.jit import kernel

#: the rules, and what stands in for either
THESIS, EQUIOSCILLATING, LEVEL = 0, 1, 2
#: the residual of ⟨p₁ − p₀, T₁ − T₀⟩/|p₁ − p₀| that a helix of a bihelix may have
RESIDUAL = 1e-10
#: arcs count as plane, and as straight, up to this many times the noise of the coordinates
FLAT = 16.0
#: planes whose normals' angle has a smaller sine are parallel
PARALLEL = 1e-9
#: steps to the foot of the junction, and their relative change that ends them
STEPS, SETTLED = 30, 1e-9
#: difference of the distances from two junction planes times change of tangent, relative to σ: that is none
SAME_HEIGHT = 2.0**-52


class Bihelix(NamedTuple):
    """Two helices with a common tangent, and t, the curve's parameter in the junction's normal plane."""

    left: Helix
    right: Helix
    t: float


@kernel
def offset(left: Frame, right: Frame, tangent: Vector, q: Vector) -> tuple[Vector, Vector]:
    """(p₀ − q, W) for the point p₀ of the junction line of ``tangent`` nearest to q, W being its direction.

    W is 0 where the two junction planes are parallel; then p₀ is in that of the left end, and there may be no
    bihelix.

    >>> left = Frame((0., 0., 0.), (1., 0., 0.))
    >>> right = Frame((2., 2., 0.), (0., 1., 0.))
    >>> r = math.sqrt(0.5)
    >>> [round(x, 12) for x in offset(left, right, (r, r, 0.0), (1.0, 1.0, 3.0))[0][:2]]
    [0.414213562373, -0.414213562373]
    """
    first, second = subtract(tangent, left.tangent), subtract(right.tangent, tangent)
    off_first = -dot(subtract(q, left.point), first)
    off_second = -dot(subtract(q, right.point), second)
    w = cross(first, second)
    square, size = dot(w, w), dot(first, first)
    if square <= PARALLEL * PARALLEL * size * dot(second, second):
        if size <= 16.0 * SAME * SAME:
            return (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        return scaled(off_first / size, first), (0.0, 0.0, 0.0)
    a, b = cross(second, w), cross(w, first)
    return combine(off_first / square, a, off_second / square, b), w


@kernel
def nearest_to_curve(
    source: Source, a: float, left: Frame, b: float, right: Frame, tangent: Vector, t: float
) -> tuple[float, Vector]:
    """(parameter, p₀) of the curve point nearest to the junction line of ``tangent`` and of the line's point.

    Safeguarded Newton on the distance, from t on.
    """
    low, high = a, b
    p, v, _ = sample(source, t)
    away, w = offset(left, right, tangent, p)
    if dot(w, w) == 0.0:
        return t, combine(1.0, p, 1.0, away)
    w = unit(w)
    for _ in range(STEPS):
        p, v, acceleration = sample(source, t)
        away = offset(left, right, tangent, p)[0]
        fall = dot(away, v)  # minus half the derivative of the squared distance
        across = combine(1.0, v, -dot(v, w), w)
        bend = dot(across, across) - dot(away, acceleration)
        before = t
        t, low, high = safeguarded(t, fall / bend if bend > 0.0 else math.nan, not fall > 0.0, low, high)
        step = t - before
        if abs(step) <= SETTLED * (b - a):
            break
    p = sample(source, t).point
    return t, combine(1.0, p, 1.0, offset(left, right, tangent, p)[0])


@kernel
def levelled(left: Frame, right: Frame, tangent: Vector, q: Vector, sigma: float) -> tuple[Vector, Vector]:
    """(T₀, p₀) with q equally far from both junction planes, T₀ turned from ``tangent`` along their normals.

    Turning T₀ by β changes the difference of the distances by βσ/2, to leading order on every short arc,
    which starts secant steps.  p₀ is NaN if they find nothing.

    >>> left = Frame((0., 0., 0.), (1., 0., 0.))
    >>> right = Frame((2., 2., 0.), (0., 1., 0.))
    >>> r = math.sqrt(0.5)
    >>> tangent, p = levelled(left, right, (0.6, 0.8, 0.0), (2 * r, 2 - 2 * r, 0.0), math.pi)
    >>> [abs(round(x, 9)) for x in subtract(tangent, (r, r, 0.0))], [round(x, 9) for x in p]
    ([0.0, 0.0, 0.0], [1.414213562, 0.585786438, 0.0])
    """
    slope, turned, before = 0.5 * sigma, 0.0, 0.0
    for _ in range(STEPS):
        first, second = subtract(tangent, left.tangent), subtract(right.tangent, tangent)
        least = min(norm(first), norm(second))
        first, second = unit(first), unit(second)
        off_first, off_second = dot(subtract(left.point, q), first), dot(subtract(right.point, q), second)
        mean = combine(1.0, first, 1.0, second)
        gap = off_first - off_second
        if abs(gap) * least <= SAME_HEIGHT * sigma:  # as exactly as rounded tangents can tell
            return tangent, combine(1.0, q, (off_first + off_second) / dot(mean, mean), mean)
        if turned != 0.0:
            slope = min(2.0 * sigma, max(0.125 * sigma, (gap - before) / turned))
        turned, before = -gap / slope, gap
        tangent = unit(combine(1.0, tangent, turned, unit(mean)))
    return tangent, (math.nan, math.nan, math.nan)


@kernel
def normal_plane(source: Source, a: float, b: float, p: Vector, tangent: Vector, t: float) -> float:
    """The parameter near t of the curve point x with ⟨x − p, tangent⟩ = 0."""
    low, high = a, b
    for _ in range(STEPS):
        x, v, _ = sample(source, t)
        height = dot(subtract(x, p), tangent)
        slope, before = dot(v, tangent), t
        step = -height / slope if slope > 0.0 else math.nan
        t, low, high = safeguarded(t, step, not height < 0.0, low, high)
        step = t - before
        if abs(step) <= SETTLED * (b - a):
            break
    return t


@kernel
def bihelix(
    rule: int, source: Source, a: float, left: Frame, b: float, right: Frame,
    sigma: float, u: float, lengths: Lengths,
) -> tuple[bool, Bihelix]:  # fmt: skip
    """(found, bihelix) of the arc [a, b] with the junction at the offset u from its middle (0: `THESIS`).

    Args:
        rule: `THESIS`, `EQUIOSCILLATING` or `LEVEL`: which junction.
        source: the curve, of size about 1.
        a: parameter of the left end.
        left: point and tangent there.
        b: of the right end.
        right: likewise.
        sigma: the arc's length, as ``measure_lengths`` found it.
        u: arc length from the middle to the curve point that determines the junction tangent.
        lengths: what ``measure_lengths`` left.
    """
    noise = source.place.noise
    t = after(lengths, a, b, 0.5 * sigma + u, sigma)
    at = bends(source, t)
    p, tangent, lean = at.point, at.tangent, at.lean
    junction_tangent = unit(combine(1.0, tangent, -(sigma * sigma / 24.0 + 0.5 * u * u), lean))
    if rule == THESIS:
        junction = combine(1.0, p, 1.0, offset(left, right, junction_tangent, p)[0])
    elif rule == LEVEL:
        junction_tangent, junction = levelled(left, right, junction_tangent, p, sigma)
    else:
        t, junction = nearest_to_curve(source, a, left, b, right, junction_tangent, t)
    flat = FLAT * noise
    kind, _, left_helix = short_helix(left.point, left.tangent, junction, junction_tangent, RESIDUAL, flat)
    next_kind, _, right_helix = short_helix(
        junction, junction_tangent, right.point, right.tangent, RESIDUAL, flat
    )
    found = kind >= 0 and next_kind >= 0
    if found:
        t = normal_plane(source, a, b, junction, junction_tangent, t)
    return found, Bihelix(left_helix, right_helix, t)


@kernel
def chord(left: Frame, right: Frame, t: float) -> Bihelix:
    """The straight segment between the ends as a bihelix, cut at its middle; t is the curve's."""
    step = subtract(right.point, left.point)
    half, tangent = 0.5 * norm(step), unit(step)
    middle = combine(0.5, left.point, 0.5, right.point)
    return Bihelix(straight(left.point, tangent, half), straight(middle, tangent, half), t)
