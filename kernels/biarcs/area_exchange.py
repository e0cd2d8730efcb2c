"""Biarcs in the area metric: the fast step to the member whose two moons are equal.

The strip between a circle and a curve, swept by the radius through the curve's point α, has the area
½(R² − ρ²)dθ.  For the circle through p with tangent T, normal N and signed curvature b, and w = α − p, put
twice = 2[T, w] − b|w|²; then R² − ρ² = twice/b and ρ²dθ/dt = [w − N/b, α′], so that

    dA/dt = ½·twice·[b·w − N, α′]/(1 − b·twice),

positive to the left of the circle, also for b = 0.  The junction's normal separates the points that belong
to either arc; where the curve meets it, dA/dt jumps by D²/2 times the curvatures' difference only, but its
higher derivatives do too.  So each arc has its own integral, and so have the two moons, which meet where the
curve crosses the biarc.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.biarcs.family import Biarc, family, is_proper, member
from osculant.kernels.curves.peaks import Space, within_reason
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.gauss import NODES, SIZES, TAILS, WEIGHTS
from osculant.kernels.jit import kernel

#: steps for μ, the first one, and the rest of the signed area, in parts of the area, that ends them
MU_STEPS, MU_STEP, EVEN = 12, 1e-3, 1e-12
#: places whose correction matters less than this, in parts of the area, stay: their rounding would wander
SETTLED = 1e-14
#: a rule is finer than needed if its estimated error is below this part of the area …
FINE = 1e-10
#: … and not to be believed if the finest one's is above this, or the rest of the signed area
COARSE, UNEVEN = 1e-9, 1e-9
#: units of the coordinates' noise within which a spectrum tells nothing
NOISE = 16.0
#: rows for the finest rule on three parts
ROWS = 2 * SIZES[-1] + SIZES[-2]


class Places(NamedTuple):
    """What is kept for the next arc.

    Attributes:
        foot: of the junction's normal, and
        crossing: of curve and biarc, in parts of the arc.
        mu: of the member.
        steep: the growth of the signed area with μ in parts of the first moon's, 0 as long as it is unknown.
    """

    foot: float
    crossing: float
    mu: float
    steep: float


@kernel
def first_places(fit: Any) -> Places:
    """Those of a short arc."""
    return Places(0.5, 0.5, 0.5, 0.0)


@kernel
def strip(arcs: Biarc, late: bool, x: float, y: float, sx: float, sy: float) -> float:
    """The area swept per arc length between one arc's circle and the curve, positive to the left.

    (x, y), (sx, sy) are the curve's point and unit tangent; ``late`` chooses the second arc's circle.
    """
    px, py, tx, ty, bend = arcs.x0, arcs.y0, arcs.tx0, arcs.ty0, arcs.bend0
    if late:
        px, py, tx, ty, bend = arcs.x2, arcs.y2, arcs.tx2, arcs.ty2, arcs.bend1
    wx, wy = x - px, y - py
    twice = 2.0 * (tx * wy - ty * wx) - bend * (wx * wx + wy * wy)
    return 0.5 * twice * ((bend * wx + ty) * sy - (bend * wy - tx) * sx) / (1.0 - bend * twice)


@kernel
def lay(source: Source, low: float, high: float, rule: int, rows: np.ndarray[Any, Any], first: int) -> int:
    """Sample the nodes of a rule on [low, high] into ``rows`` from ``first`` on; returns the next row.

    A row is point, unit tangent, and the arc length that belongs to one unit of weight.
    """
    size = SIZES[rule]
    for i in range(size):
        row = rows[first + i]
        row[0], row[1], row[2], row[3], speed, _ = sample(source, low + (high - low) * NODES[rule, i])
        row[4] = speed * (high - low)
    return first + size


@kernel
def swept(arcs: Biarc, late: bool, rule: int, rows: np.ndarray[Any, Any], first: int) -> tuple[float, float]:
    """(signed area, its last Legendre coefficient) of a part sampled by `lay`."""
    area, tail = 0.0, 0.0
    for i in range(SIZES[rule]):
        row = rows[first + i]
        value = row[4] * strip(arcs, late, row[0], row[1], row[2], row[3])
        area += WEIGHTS[rule, i] * value
        tail += TAILS[rule, i] * value
    return area, abs(tail)


@kernel
def within(place: float, step: float) -> float:
    """A place after a step, kept within reason."""
    return within_reason(place, step)


@kernel
def balanced(
    source: Source, a: float, start: Frame, b: float, end: Frame, places: Places, rule: int
) -> tuple[float, float, float, float, Places]:
    """(area, μ, unrest, error, places moved) of the member with equal moons, with one rule of `gauss`.

    The unrest is the relative correction of the places, the error that of the quadrature, both in parts of
    the area; they are infinite if μ did not settle, or nothing is found.
    """
    failed = (math.nan, math.nan, math.inf, math.inf, places)
    fam = family(start, end)
    if not is_proper(fam):
        return failed
    length = b - a
    foot, crossing = a + places.foot * length, a + places.crossing * length
    low, high = min(foot, crossing), max(foot, crossing)
    late = foot < crossing  # what lies between them is beside the second arc, and of the first moon
    rows = np.empty((ROWS, 5))
    one = lay(source, a, low, rule, rows, 0)
    two = lay(source, low, high, rule - 1, rows, one)
    lay(source, high, b, rule, rows, two)
    fx, fy, fsx, fsy, foot_speed, _ = sample(source, foot)
    cx, cy, csx, csy, cross_speed, _ = sample(source, crossing)
    mu, steep = places.mu, places.steep
    before, total_before = math.nan, math.nan
    area, total, unrest, foot_step, cross_step, tail = math.nan, math.nan, 0.0, 0.0, 0.0, 0.0
    for _ in range(MU_STEPS):
        arcs = member(fam, mu)
        left, tail = swept(arcs, False, rule, rows, 0)
        between, _ = swept(arcs, late, rule - 1, rows, one)
        right, right_tail = swept(arcs, True, rule, rows, two)
        tail = max(tail, right_tail)
        # the junction's foot is elsewhere: circles that touch each other differ by squares up to there
        foot_step = -((fx - arcs.x1) * arcs.tx1 + (fy - arcs.y1) * arcs.ty1)
        foot_step /= foot_speed * (fsx * arcs.tx1 + fsy * arcs.ty1)
        wrong = strip(arcs, False, fx, fy, fsx, fsy) - strip(arcs, True, fx, fy, fsx, fsy)
        between += wrong * foot_speed * foot_step / 3.0
        # so is the crossing: a triangle goes from one moon to the other
        k = 8 if late else 0
        bend = arcs.bend1 if late else arcs.bend0
        nx, ny = -arcs[k + 3] - bend * (cx - arcs[k]), arcs[k + 2] - bend * (cy - arcs[k + 1])
        lean = (nx * csx + ny * csy) * (ny * csx - nx * csy)
        miss = strip(arcs, late, cx, cy, csx, csy)
        cross_step = -miss / (lean * cross_speed)
        triangle = 0.5 * miss * cross_speed * cross_step
        total = left + between + right
        first = left + triangle + (between if late else 0.0)
        area = abs(first) + abs(total - first)
        if not area > 0.0:
            return failed
        unrest = (abs(wrong * foot_speed * foot_step) + abs(triangle)) / area
        if abs(total) <= EVEN * area:
            break
        step = MU_STEP
        if total != total_before and not math.isnan(before):
            steep = (total - total_before) / (first * (mu - before))
        if steep != 0.0:
            step = -total / (steep * first)
        before, total_before = mu, total
        mu = min(0.99, max(0.01, mu + min(0.2, max(-0.2, step))))
        if mu == before:
            break
    if not abs(total) <= UNEVEN * area:
        unrest = math.inf
    noise = NOISE * source.place.noise * fam.chord
    error = 0.0 if tail <= noise else tail * tail / (area * area)
    if unrest <= SETTLED:
        return area, mu, unrest, error, Places(places.foot, places.crossing, mu, steep)
    foot_place = within(places.foot, foot_step / length)
    cross_place = within(places.crossing, cross_step / length)
    return area, mu, unrest, error, Places(foot_place, cross_place, mu, steep)


@kernel
def visit(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    places: Places, calm: float, space: Space,
) -> tuple[float, float, bool, Places]:  # fmt: skip
    """(area, μ, settled, places moved) of the member with equal moons.

    The places of the junction's foot and of the crossing change slowly from arc to arc, so the caller keeps
    them.  They have settled if their correction is at most the part ``calm`` of the area, and the quadrature
    and μ have; the area is NaN where nothing is found.  Nothing is bracketed here: `area_scan.best` is there
    to fall back on.
    """
    area, mu, unrest, error, moved = balanced(source, a, start, b, end, places, 1)
    for rule in range(2, len(SIZES)):
        if error <= FINE or not area > 0.0:
            break
        area, mu, unrest, error, moved = balanced(source, a, start, b, end, places, rule)
    return area, mu, unrest <= calm and error <= COARSE, moved
