"""Areas between an arc and biarcs, measured, and the careful search for the member with equal moons.

The arc is cut where the junction's normal meets it and where it crosses the biarc; each part is integrated
with Gauss's rules, halved until the last Legendre coefficient is small enough (`gauss`) and the integrand has
one sign at all nodes, so that crossings closer to each other than the samples are found, too.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from osculant.kernels.biarcs.area_exchange import NOISE, strip
from osculant.kernels.biarcs.family import Biarc, distance, family, is_proper, member, to_circle
from osculant.kernels.biarcs.scan import LOPSIDED, SLACK, is_along, look
from osculant.kernels.bracket import safeguarded
from osculant.kernels.curves.peaks import DEPTH, Space
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.gauss import NODES, SIZES, TAILS, WEIGHTS
from osculant.kernels.jit import kernel


class Areas(NamedTuple):
    """Signed area, area, and the estimated error of the quadrature."""

    signed: float
    area: float
    error: float


#: the rule of `gauss` for each part, and the estimated error of a part, over the area, that is small enough
RULE, ACCURATE = 2, 1e-12
#: an area with a larger estimated error, over the area, is not believed
TRUSTED = 1e-9
#: parts at most, between two cuts
PARTS = 400
#: visits of one cut at most, and its accuracy in parts of the arc: areas depend on its square
VISITS, PLACED = 60, 1e-7
#: rounds of the search for μ, and its accuracy
ROUNDS, BALANCED = 80, 1e-12
#: a signed area within this part of the area, or within rounding, counts as 0
EVEN = 1e-9


@kernel
def ahead(arcs: Biarc, x: float, y: float) -> float:
    """How far a point is ahead of the junction's normal."""
    return (x - arcs.x1) * arcs.tx1 + (y - arcs.y1) * arcs.ty1


@kernel
def foot(arcs: Biarc, source: Source, t0: float, t1: float, accuracy: float) -> float:
    """Where the junction's normal meets the curve, between parameters on both sides of it."""
    t = 0.5 * (t0 + t1)
    for _ in range(VISITS):
        x, y, sx, sy, speed, _ = sample(source, t)
        value, slope = ahead(arcs, x, y), speed * (sx * arcs.tx1 + sy * arcs.ty1)
        before = t
        t, t0, t1 = safeguarded(t, -value / slope if slope > 0.0 else math.nan, value > 0.0, t0, t1)
        if abs(t - before) <= accuracy:
            break
    return t


@kernel
def crossing(
    arcs: Biarc, source: Source, late: bool, t0: float, t1: float, falling: bool,
    accuracy: float,
) -> float:  # fmt: skip
    """Where the curve crosses the circle of one arc, between parameters on both sides of it."""
    k, bend = (8, arcs.bend1) if late else (0, arcs.bend0)
    t = 0.5 * (t0 + t1)
    for _ in range(VISITS):
        x, y, sx, sy, speed, curvature = sample(source, t)
        d, slope, _ = to_circle(arcs[k], arcs[k + 1], arcs[k + 2], arcs[k + 3], bend, x, y, sx, sy, curvature)
        if abs(d) <= source.place.noise:
            break
        before, step = t, -d / (slope * speed) if slope != 0.0 else math.nan
        t, t0, t1 = safeguarded(t, step, (d > 0.0) != falling, t0, t1)
        if abs(t - before) <= accuracy:
            break
    return t


@kernel
def part(
    arcs: Biarc, source: Source, late: bool, low: float, high: float, scale: float,
    space: Space,
) -> Areas:  # fmt: skip
    """Signed area, area and their estimated error between [low, high] and one arc's circle.

    ``scale`` is about the area of the whole, by which the error is judged.
    """
    size, stack = SIZES[RULE], space[1]
    stack[0, 0], stack[0, 1] = low, high
    open_parts, signed, area, error = 1, 0.0, 0.0, 0.0
    for _ in range(PARTS):
        if open_parts == 0:
            return Areas(signed, area, error)
        open_parts -= 1
        low, high = stack[open_parts, 0], stack[open_parts, 1]
        value, tail, top, bottom, fastest = 0.0, 0.0, 0.0, 0.0, 0.0
        for i in range(size):
            x, y, sx, sy, speed, _ = sample(source, low + (high - low) * NODES[RULE, i])
            rate = (high - low) * speed * strip(arcs, late, x, y, sx, sy)
            value += WEIGHTS[RULE, i] * rate
            tail += TAILS[RULE, i] * rate
            top, bottom = max(top, rate), min(bottom, rate)
            fastest = max(fastest, speed)
        peak, noise = max(top, -bottom), NOISE * source.place.noise * fastest * (high - low)
        if not math.isfinite(value):
            break
        rest = 0.0 if abs(tail) <= noise else tail * tail / peak
        mixed = min(top, -bottom) > noise
        if (rest > ACCURATE * scale or mixed) and open_parts + 2 <= DEPTH:
            middle = 0.5 * (low + high)
            stack[open_parts, 0], stack[open_parts, 1] = middle, high
            stack[open_parts + 1, 0], stack[open_parts + 1, 1] = low, middle
            open_parts += 2
            continue
        signed += value
        area += abs(value)
        error += rest + (peak if mixed else 0.0)
    return Areas(math.nan, math.nan, math.inf)


@kernel
def areas(arcs: Biarc, source: Source, a: float, b: float, space: Space, count: int) -> Areas:
    """Signed area, area and estimated error between a biarc and the arc seen in ``space``."""
    rows, accuracy = space[0], PLACED * (b - a)
    scale = 0.0
    for i in range(count):
        row = rows[i]
        late = ahead(arcs, row[0], row[1]) > 0.0
        until = rows[i + 1, 6] if i + 1 < count else b
        since = rows[i - 1, 6] if i > 0 else a
        scale += 0.5 * (until - since) * row[4] * abs(strip(arcs, late, row[0], row[1], row[2], row[3]))
    signed, area, error = 0.0, 0.0, 0.0
    # at the ends D = D′ = 0, and D has the sign of D″
    done, t0, d0, late = a, a, sample(source, a).curvature - arcs.bend0, False
    for i in range(count + 1):
        t1, d1, passed = b, 0.0, True
        if i == count:
            d1 = sample(source, b).curvature - arcs.bend1
        if i < count:
            row = rows[i]
            t1 = row[6]
            d1, _, _ = distance(arcs, row[0], row[1], row[2], row[3], row[5])
            passed = ahead(arcs, row[0], row[1]) > 0.0
        cut, d = t1, d1
        if passed and not late:
            cut = foot(arcs, source, t0, t1, accuracy)
            x, y, sx, sy, _, curvature = sample(source, cut)
            d, _, _ = distance(arcs, x, y, sx, sy, curvature)
        for _ in range(2):  # before and after the junction's foot
            if (d0 > 0.0) != (d > 0.0):  # 0 is on one side: a sample may be a crossing
                t = crossing(arcs, source, late, t0, cut, d0 > 0.0, accuracy)
                more = part(arcs, source, late, done, t, scale, space)
                signed, area, error, done = signed + more.signed, area + more.area, error + more.error, t
            t0, d0 = cut, d
            if late or not passed:
                break
            more = part(arcs, source, late, done, cut, scale, space)
            signed, area, error, done = signed + more.signed, area + more.area, error + more.error, cut
            late, cut, d = True, t1, d1
    more = part(arcs, source, True, done, b, scale, space)
    return Areas(signed + more.signed, area + more.area, error + more.error)


@kernel
def attained(
    arcs: Biarc, source: Source, a: float, b: float, space: Space, count: int
) -> tuple[float, float]:
    """(signed area, area) over the arc seen in ``space``; infinite where the arc is not beside the biarc.

    So they are, too, if an arc of the biarc turns by π or more or if the quadrature does not settle.
    """
    if not is_along(arcs, source, space, count):
        return math.inf, math.inf
    signed, area, error = areas(arcs, source, a, b, space, count)
    return (signed, area) if error <= TRUSTED * area or area == 0.0 else (math.inf, math.inf)


@kernel
def measure(
    arcs: Biarc, source: Source, a: float, b: float, points: int,
    space: Space,
) -> float:  # fmt: skip
    """The area between the arc [a, b] and a biarc between its end frames: the sum over all regions.

    From ``points`` samples or more, between which the quadrature finds what they miss.  Infinite if the arc
    turns by more than π, is not beside the biarc everywhere, or if the quadrature does not settle.
    """
    count = look(arcs, source, a, b, points, space)
    return math.inf if count < 0 else attained(arcs, source, a, b, space, count)[1]


@kernel
def best(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Space
) -> tuple[float, float]:
    """(area, μ) of the biarc with equal moons: signed area 0; the area is infinite if no biarc is beside.

    Of a spiral arc the members lie side by side: the signed area moves in one direction with μ, so secant
    steps within a bracket find the root.  Across a vertex there may be none with equal moons: then it is the
    one of least area that was seen.
    """
    fam = family(start, end)
    if not is_proper(fam):
        return math.inf, math.nan
    count = look(member(fam, 0.5), source, a, b, points, space)
    if count < 0:
        return math.inf, math.nan
    upward = fam.omega < 2.0 * fam.alpha  # κ decreases, and D increases with μ
    low, high, mu = 0.0, 1.0, 0.5
    before, signed_before = math.nan, math.nan
    kept, least = 0.5, math.inf
    for step in range(ROUNDS):
        signed, area, _ = areas(member(fam, mu), source, a, b, space, count)
        if area < least and LOPSIDED < mu < 1.0 - LOPSIDED:
            kept, least = mu, area
        if abs(signed) <= BALANCED * area or high - low <= BALANCED:
            break
        if step == 0 and area <= source.place.noise * fam.chord:
            break  # rounding says nothing about μ
        if (signed > 0.0) == upward:
            high = mu
        else:
            low = mu
        middle = mu - signed * (mu - before) / (signed - signed_before)
        before, signed_before = mu, signed
        mu = middle if low < middle < high and step % 4 < 3 else 0.5 * (low + high)
    signed, area = attained(member(fam, mu), source, a, b, space, count)
    rounding = SLACK * source.place.noise * fam.chord
    if not abs(signed) <= EVEN * area + rounding:
        mu = kept
        _, area = attained(member(fam, mu), source, a, b, space, count)
    return area, mu


@kernel
def confirm(
    fit: Any,
    mu: float,
    source: Source,
    a: float,
    start: Frame,
    b: float,
    end: Frame,
    points: int,
    space: Space,
) -> tuple[float, float]:
    """(area, μ) of the member μ, measured from ``points`` samples or more."""
    return measure(member(family(start, end), mu), source, a, b, points, space), mu
