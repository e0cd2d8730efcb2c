"""The careful step: errors measured over a whole grid of the arc, roots always bracketed.

`measure` finds the peaks of the displacement of one member, at the common normals of arc and conic;
`minimax` finds the best member of a pencil whatever the number and place of its error's peaks.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from osculant.kernels.bitangent import Pencil, displacement, is_proper, pencil, through, view, weight
from osculant.kernels.curve import Frame, Place
from osculant.kernels.exchange import PARABOLA
from osculant.kernels.generated import pencil as generated
from osculant.kernels.jit import kernel

#: numbers of a `View`
VIEW_SIZE = 11
#: points of the grid on which `minimax` looks for peaks
GRID = 40
#: visits of one peak at most, and the relative correction of its height that ends them
VISITS, SETTLED = 8, 1e-7
#: rounds of the search for Q, and its relative accuracy
ROUNDS, BALANCED = 80, 1e-12


@kernel
def look(
    pen: Pencil, address: int, place: Place, jet: np.ndarray[Any, Any], a: float, b: float,
    views: np.ndarray[Any, Any],
) -> None:  # fmt: skip
    """Views of the arc at as many equidistant inner points as ``views`` (n, `VIEW_SIZE`) has rows."""
    n = views.shape[0]
    for i in range(n):
        seen = view(pen, address, place, jet, a + (b - a) * (i + 1) / (n + 1))
        for j, value in enumerate(seen):
            views[i, j] = value


@kernel
def at_row(views: np.ndarray[Any, Any], i: int) -> tuple[float, ...]:
    """Row i of ``views`` as a `View`."""
    v = views[i]
    return v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10]


@kernel
def cubic_peak(d0: float, s0: float, d1: float, s1: float) -> tuple[float, float]:
    """(u, second derivative there) of the extreme in (0, 1) of the cubic with these ends and slopes."""
    b = 3.0 * (d1 - d0) - 2.0 * s0 - s1
    c = s0 + s1 - 2.0 * (d1 - d0)
    # the derivative s0 + 2bu + 3cu² vanishes; the larger root in magnitude first, the other by Vieta
    below = -(b + math.copysign(math.sqrt(max(0.0, b * b - 3.0 * c * s0)), b))
    u = s0 / below if below != 0.0 else 0.5
    if not 0.0 < u < 1.0:
        u = below / (3.0 * c) if c != 0.0 else 0.5
    if not 0.0 < u < 1.0:
        u = 0.5
    return u, 2.0 * b + 6.0 * c * u


@kernel
def height(
    pen: Pencil, q: float, address: int, place: Place, jet: np.ndarray[Any, Any], low: float, high: float,
    t: float, bend: float,
) -> float:  # fmt: skip
    """The value of d at its peak in [low, high], from the guess t with d″ ≈ bend; NaN if a normal misses."""
    d, before, steepness = math.nan, math.nan, math.nan
    for _ in range(VISITS):
        d, _, slope = displacement(q, view(pen, address, place, jet, t))
        if not math.isfinite(d):
            return math.nan
        if t != before and slope != steepness and not math.isnan(before):
            bend = (slope - steepness) / (t - before)
        if not bend * d < 0.0:  # not a peak of |d|: the bracket's samples said more than this
            return d
        gain = -0.5 * slope * slope / bend
        if abs(gain) <= SETTLED * abs(d):
            return d + gain
        before, steepness = t, slope
        t = min(high, max(low, t - slope / bend))
    return d


@kernel
def extremes(
    pen: Pencil, q: float, address: int, place: Place, jet: np.ndarray[Any, Any], a: float, b: float,
    views: np.ndarray[Any, Any],
) -> tuple[float, float]:  # fmt: skip
    """(max d, min d) of the member Q over the arc seen in ``views``; NaN if a normal misses its arc.

    Every interval between neighbouring samples in which |d| must have a peak is searched.
    """
    n = views.shape[0]
    h = (b - a) / (n + 1)
    top, bottom = 0.0, 0.0
    d0, s0 = 0.0, 0.0
    for i in range(n + 1):
        d1, s1 = 0.0, 0.0
        if i < n:
            d1, _, slope = displacement(q, at_row(views, i))
            s1 = slope * h
            if not math.isfinite(d1):
                return math.nan, math.nan
            top, bottom = max(top, d1), min(bottom, d1)
        grows_in = i == 0 or s0 * d0 > 0.0  # |d| grows into the interval from the left …
        grows_out = i == n or s1 * d1 < 0.0  # … and from the right
        if (grows_in and grows_out) or (d0 * d1 < 0.0 and (grows_in or grows_out)):
            u, bend = cubic_peak(d0, s0, d1, s1)
            low = a + i * h
            value = height(pen, q, address, place, jet, low, low + h, low + u * h, bend / (h * h))
            if math.isnan(value):
                return math.nan, math.nan
            top, bottom = max(top, value), min(bottom, value)
        d0, s0 = d1, s1
    return top, bottom


@kernel
def measure(
    pen: Pencil, q: float, address: int, place: Place, jet: np.ndarray[Any, Any], a: float, b: float,
    views: np.ndarray[Any, Any],
) -> float:  # fmt: skip
    """max |d| of the member Q over [a, b]; infinite if a normal of the curve misses its arc.

    An upper bound of the Hausdorff distance as far as the peaks between the samples have been found:
    an estimate, not a certificate.
    """
    look(pen, address, place, jet, a, b, views)
    top, bottom = extremes(pen, q, address, place, jet, a, b, views)
    return math.inf if math.isnan(top) else max(top, -bottom)


@kernel
def minimax(
    primitive: int, address: int, place: Place, jet: np.ndarray[Any, Any], a: float, start: Frame,
    b: float, end: Frame, views: np.ndarray[Any, Any],
) -> tuple[float, float]:  # fmt: skip
    """(error, Q) of the best conic, or of the parabola, of the arc [a, b]; error infinite if none.

    d decreases or increases with Q at every point at once, so max d + min d has one zero, between
    the least and the greatest Q of the members through the samples.
    """
    pen = pencil(start, end)
    if not is_proper(pen):
        return math.inf, math.nan
    look(pen, address, place, jet, a, b, views)
    if primitive == PARABOLA:
        if not pen[13] > 0.0:
            return math.inf, math.nan
        q = generated.parabola(pen[11], pen[12], pen[13])
        top, bottom = extremes(pen, q, address, place, jet, a, b, views)
        return (math.inf if math.isnan(top) else max(top, -bottom)), q
    low, high = math.inf, 0.0
    for i in range(views.shape[0]):
        q = through(at_row(views, i))
        if math.isnan(q):
            return math.inf, math.nan
        low, high = min(low, q), max(high, q)
    return balanced(pen, address, place, jet, a, b, views, low, high)


@kernel
def balanced(
    pen: Pencil, address: int, place: Place, jet: np.ndarray[Any, Any], a: float, b: float,
    views: np.ndarray[Any, Any], low: float, high: float,
) -> tuple[float, float]:  # fmt: skip
    """(error, Q) with max d = −min d, Q in [low, high]: false position, bisection where it is slow."""
    excess_low, excess_high = math.nan, math.nan
    error, q = math.inf, math.nan
    for step in range(ROUNDS):
        q = 0.5 * (low + high)
        if step % 3 and math.isfinite(excess_low) and math.isfinite(excess_high):
            q = (low * excess_high - high * excess_low) / (excess_high - excess_low)
        if not weight(pen, q) > -1.0:  # an unbounded arc: w < 0 falls with Q
            high, excess_high, error = q, math.nan, math.inf
            continue
        top, bottom = extremes(pen, q, address, place, jet, a, b, views)
        if math.isnan(top):
            return math.inf, q
        excess, error = top + bottom, max(top, -bottom)
        if abs(excess) <= BALANCED * error or high - low <= BALANCED * high:
            break
        if excess > 0.0:  # ∂d/∂Q < 0 inside the tangents of an arc that bends to the left
            low, excess_low = q, excess
        else:
            high, excess_high = q, excess
    return error, q
