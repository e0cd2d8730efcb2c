"""Areas between an arc and a cubic: ∫ |d − κd²/2| ds, the strip along the normals, between crossings.

Sign d is constant from one crossing to the next, so each part is smooth: Gauss's rule, on halves until its
last coefficient is small.  With it come the derivatives of the area by both arms, ∫ sign d (1 − κd) ∂d.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.cubics.arms import Ends, see
from osculant.kernels.cubics.scan import FOOT, ITSELF, TIME, D, Space, look, trace
from osculant.kernels.curves.plane import Source, sample
from osculant.kernels.gauss import NODES, SIZES, TAILS, WEIGHTS
from osculant.kernels.jit import kernel

#: the rule of `gauss`, the last coefficient's square in parts of the area that is small, and panels at most
RULE, ACCURATE, MOST = 2.0, 1e-11, 64
#: visits of one crossing, and the relative step that ends them: an area depends on its square
VISITS, SETTLED = 8, 1e-8


class Strip(NamedTuple):
    """Signed area of a part, derivatives by the arms, the last Legendre coefficient, and the last foot."""

    area: float
    by0: float
    by3: float
    tail: float
    foot: float


class Areas(NamedTuple):
    """The whole area, infinite if the cubic strays, and its derivatives by the arms."""

    area: float
    by0: float
    by3: float


@kernel
def swept(
    source: Source, ends: Ends, a0: float, a3: float, low: float, high: float, foot: float, rule: float
) -> Strip:
    """The strip between two parameters by one Gauss rule; NaN where the cubic strays."""
    index = int(rule)  # whole numbers would be compiled for one by one
    area, by0, by3, tail = 0.0, 0.0, 0.0, 0.0
    for i in range(SIZES[index]):
        at = sample(source, low + (high - low) * NODES[index, i])
        seen = see(ends, a0, a3, at, foot)
        foot = seen.foot
        rate = (high - low) * at.speed
        height = rate * seen.d * (1.0 - 0.5 * at.curvature * seen.d)
        share = WEIGHTS[index, i] * rate * (1.0 - at.curvature * seen.d)
        area += WEIGHTS[index, i] * height
        tail += TAILS[index, i] * height
        by0 += share * seen.by0
        by3 += share * seen.by3
    return Strip(area, by0, by3, abs(tail), foot)


@kernel
def swept_finely(
    source: Source, ends: Ends, a0: float, a3: float, low: float, high: float, foot: float, panels: int
) -> Strip:
    """The strip between two crossings by as many panels as it takes, ``panels`` at least."""
    floor = ITSELF * source.place.noise * ends.chord
    found = Strip(math.nan, math.nan, math.nan, math.nan, foot)
    while panels <= MOST:
        area, by0, by3, error, here = 0.0, 0.0, 0.0, 0.0, foot
        for i in range(panels):
            left, right = low + (high - low) * i / panels, low + (high - low) * (i + 1) / panels
            part = swept(source, ends, a0, a3, left, right, here, RULE)
            area, by0, by3, here = area + part.area, by0 + part.by0, by3 + part.by3, part.foot
            error += part.tail * part.tail / max(abs(part.area), floor)
        found = Strip(area, by0, by3, error, here)
        if not error > max(ACCURATE * abs(area), floor):  # NaN, too
            break
        panels *= 2
    return found


@kernel
def crossing(
    source: Source, ends: Ends, a0: float, a3: float, low: float, d_low: float, high: float, d_high: float,
    foot: float,
) -> float:  # fmt: skip
    """Where d changes its sign between two parameters: Newton's method in the bracket."""
    t = (low * d_high - high * d_low) / (d_high - d_low)
    width = high - low
    for _ in range(VISITS):
        seen = see(ends, a0, a3, sample(source, t), foot)
        if seen.d * d_low > 0.0:
            low = t
        else:
            high = t
        before = t
        t -= seen.d / seen.slope
        if not low <= t <= high:
            t = 0.5 * (low + high)
        if abs(t - before) <= SETTLED * width:
            break
    return t


@kernel
def areas_of(
    source: Source,
    a: float,
    b: float,
    ends: Ends,
    a0: float,
    a3: float,
    count: int,
    panels: int,
    space: Space,
) -> Areas:
    """The `Areas` of a cubic whose crossings the samples in ``space`` tell apart."""
    samples = space.samples
    if not trace(ends, a0, a3, samples, count):
        return Areas(math.inf, math.nan, math.nan)
    total, by0, by3, foot = 0.0, 0.0, 0.0, 0.0
    begin = a
    for i in range(count):
        end = b
        if i < count - 1:
            here, there = samples[i], samples[i + 1]
            if (here[D] > 0.0) == (there[D] > 0.0):  # 0 is on one side: a sample may be a crossing
                continue
            end = crossing(
                source,
                ends,
                a0,
                a3,
                here[TIME],
                here[D],
                there[TIME],
                there[D],
                0.5 * (here[FOOT] + there[FOOT]),
            )
        part = swept_finely(source, ends, a0, a3, begin, end, foot, panels)
        side = 1.0 if samples[i, D] > 0.0 else -1.0
        total, by0, by3 = total + side * part.area, by0 + side * part.by0, by3 + side * part.by3
        begin, foot = end, part.foot
    if not total >= 0.0:
        return Areas(math.inf, math.nan, math.nan)
    return Areas(total, by0, by3)


@kernel
def highest(samples: np.ndarray[Any, Any], count: int) -> float:
    """The largest |d| of the samples."""
    top = 0.0
    for i in range(count):
        top = max(top, abs(samples[i, D]))
    return top


@kernel
def measure(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float, points: int, space: Space
) -> float:
    """The area between arc and cubic, from ``points`` samples or more; infinite if it strays (`arms`).

    An estimate, as accurate as the last coefficients of its panels say, and as far as the samples tell
    crossings apart.  Where d is below the noise of the coordinates everywhere the cubic is the curve: 0.
    """
    count = look(source, a, b, ends, points, space.samples)
    if count < 0:
        return math.inf
    found = areas_of(source, a, b, ends, a0, a3, count, 1 + count // (4 * SIZES[int(RULE)]), space)
    if found.area < math.inf and highest(space.samples, count) <= ITSELF * source.place.noise:
        return 0.0
    return found.area
