"""How far an arc is from its chord.

The largest distance of the arc's points from the chord is the Hausdorff distance of the two: whatever the arc
does between its ends, it passes over every point of the chord, no farther away than that.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from osculant.kernels.bracket import safeguarded
from osculant.kernels.course import spot, spots
from osculant.kernels.curves import plane, space
from osculant.kernels.curves.vectors import combine, dot, norm, subtract
from osculant.kernels.jit import kernel
from osculant.kernels.operations import operation

#: steps to one peak, and their relative size that ends them: a height depends on its square
STEPS, SETTLED = 40, 1e-9
#: samples of one arc at most: longer arcs are not measured
MOST = 2000
#: a peak is not believed nearer than this to an end of the arc, in parts of it
MARGIN = 0.01


class Rise(NamedTuple):
    """The distance of a curve point from the chord, and its derivatives by the parameter."""

    distance: float
    slope: float
    second: float


@operation
def rise(fit: Any, source: Any, start: Any, end: Any, t: Any) -> Any:
    """The `Rise` of the curve over the chord between two frames at t."""


@kernel
def risen(distance: float, slope: float, across: float, lean: float) -> Rise:
    """The rise of a point that is w from the nearest point of the chord.

    Args:
        distance: |w|.
        slope: its derivative, ⟨w, α̇⟩/|w|.
        across: |α̇|², beside the chord without the component along it.
        lean: ⟨w, α̈⟩/|w|.
    """
    return Rise(distance, slope, lean + (across - slope * slope) / distance)


@kernel
def rise_in_the_plane(fit: Any, source: plane.Source, start: plane.Frame, end: plane.Frame, t: float) -> Rise:
    """`rise` of a plane curve; its second derivative is exact where the first is 0."""
    at = plane.sample(source, t)
    dx, dy = end.x - start.x, end.y - start.y
    length = math.sqrt(dx * dx + dy * dy)
    cx, cy = dx / length, dy / length
    ux, uy = at.x - start.x, at.y - start.y
    reached = cx * ux + cy * uy
    bend = at.speed * at.speed * at.curvature
    if reached < 0.0 or reached > length:  # an end of the chord is nearest
        if reached > length:
            ux, uy = at.x - end.x, at.y - end.y
        away = math.sqrt(ux * ux + uy * uy)
        slope = at.speed * (ux * at.tx + uy * at.ty) / away
        return risen(away, slope, at.speed * at.speed, bend * (uy * at.tx - ux * at.ty) / away)
    height = cx * uy - cy * ux
    side = math.copysign(1.0, height)
    slope = side * at.speed * (cx * at.ty - cy * at.tx)
    return Rise(abs(height), slope, side * bend * (cx * at.tx + cy * at.ty))


@kernel
def rise_in_space(fit: Any, source: space.Source, start: space.Frame, end: space.Frame, t: float) -> Rise:
    """`rise` of a space curve."""
    at = space.sample(source, t)
    chord = subtract(end.point, start.point)
    length = norm(chord)
    c = (chord[0] / length, chord[1] / length, chord[2] / length)
    u, v = subtract(at.point, start.point), at.velocity
    reached = dot(u, c)
    if reached > length:
        u = subtract(at.point, end.point)
    elif reached >= 0.0:
        u, v = combine(1.0, u, -reached, c), combine(1.0, v, -dot(v, c), c)
    away = norm(u)
    if not away > 0.0:
        return Rise(0.0, norm(v), 0.0)
    return risen(away, dot(u, v) / away, dot(v, v), dot(u, at.acceleration) / away)


@kernel
def first_peak(fit: Any) -> float:
    """Where the peak of a short arc is, in parts of it."""
    return 0.5


@kernel
def visit(
    fit: Any, source: Any, a: float, start: Any, b: float, end: Any, peak: float, calm: float, space: Any
) -> tuple[float, float, bool, float]:
    """(error, 0, settled, peak moved) of the chord of the arc [a, b], from one sample at the believed peak.

    It has settled if its last correction is at most the part ``calm`` of the error.  Nothing is bracketed
    here: a result is kept only after it is measured.
    """
    seen = rise(fit, source, start, end, a + peak * (b - a))
    if not seen.second < 0.0:
        return seen.distance, 0.0, False, 0.5
    top = seen.distance - 0.5 * seen.slope * seen.slope / seen.second
    moved = min(1.0 - MARGIN, max(MARGIN, peak - seen.slope / (seen.second * (b - a))))
    return top, 0.0, abs(top / seen.distance - 1.0) <= calm, moved


@kernel
def peak_between(fit: Any, source: Any, start: Any, end: Any, low: float, t: float, high: float) -> float:
    """The largest distance found between two parameters about a peak, from t on: safeguarded Newton."""
    top, width = 0.0, high - low
    for _ in range(STEPS):
        seen = rise(fit, source, start, end, t)
        top = max(top, seen.distance)
        before, step = t, -seen.slope / seen.second if seen.second < 0.0 else math.nan
        t, low, high = safeguarded(t, step, not seen.slope > 0.0, low, high)
        if abs(t - before) <= SETTLED * width:
            break
    return top


@kernel
def measure(fit: Any, source: Any, a: float, start: Any, b: float, end: Any, points: int) -> float:
    """The Hausdorff distance of the arc [a, b] and its chord, from ``points`` inner samples or more.

    An estimate as far as the samples see each peak; infinite if the ends of the arc coincide, or if it takes
    more than `MOST` samples to see what the course tells of it.
    """
    at = spots(source.course, a, b, points)
    if at.steps > max(MOST, points + 1):
        return math.inf
    low, t = a, spot(source.course, at, 1)
    top, before, here = 0.0, 0.0, rise(fit, source, start, end, t).distance
    for i in range(2, at.steps + 1):
        high, after = spot(source.course, at, i), 0.0
        if i < at.steps:
            after = rise(fit, source, start, end, high).distance
        if not here < math.inf:  # there is no chord
            return math.inf
        if here >= before and here >= after:
            top = max(top, here, peak_between(fit, source, start, end, low, t, high))
        low, t, before, here = t, high, here, after
    return top


@kernel
def confirm(
    fit: Any, choice: float, source: Any, a: float, start: Any, b: float, end: Any, points: int, space: Any
) -> tuple[float, float]:
    """(error, 0) of the chord, measured from ``points`` samples or more."""
    return measure(fit, source, a, start, b, end, points), 0.0


@kernel
def best(
    fit: Any, source: Any, a: float, start: Any, b: float, end: Any, points: int, space: Any
) -> tuple[float, float]:
    """(error, 0) of the chord, which is the only piece there is."""
    return measure(fit, source, a, start, b, end, points), 0.0
