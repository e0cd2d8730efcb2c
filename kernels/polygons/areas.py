"""The area between an arc of the plane and its chord: ½∫[α − α(a), α̇]dt, by Gauss's rules on panels."""

from __future__ import annotations

import math
from typing import Any

from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.gauss import NODES, SIZES, TAILS, WEIGHTS
from osculant.kernels.jit import kernel

#: the rule of `gauss`, the estimated error of a panel over the area that is small enough, and panels at most
RULE, ACCURATE, MOST = 2, 1e-12, 1024
#: units of the coordinates' noise within which a point is on the chord, and a spectrum tells nothing
NOISE = 16.0


@kernel
def swept(source: Source, start: Frame, end: Frame, low: float, high: float) -> tuple[float, float, float]:
    """(area, its last Legendre coefficient, how far a point is on the wrong side of the chord) of a panel."""
    dx, dy = end.x - start.x, end.y - start.y
    length = math.sqrt(dx * dx + dy * dy)
    area, tail, beyond = 0.0, 0.0, 0.0
    for i in range(SIZES[RULE]):
        at = sample(source, low + (high - low) * NODES[RULE, i])
        ux, uy = at.x - start.x, at.y - start.y
        rate = 0.5 * (high - low) * at.speed * (ux * at.ty - uy * at.tx)
        area += WEIGHTS[RULE, i] * rate
        tail += TAILS[RULE, i] * rate
        beyond = max(beyond, dx * uy - dy * ux)
    return area, abs(tail), beyond / length


@kernel
def measure(source: Source, a: float, start: Frame, b: float, end: Frame, points: int) -> float:
    """The area between the arc [a, b], which bends to the left, and its chord.

    Infinite if the arc crosses the chord, if its ends coincide, or if the quadrature does not settle.  An
    estimate, as accurate as the last coefficients of its panels say; ``points`` is the least number of nodes.
    """
    noise = NOISE * source.place.noise
    panels = max(1, points // SIZES[RULE])
    while panels <= MOST:
        area, error = 0.0, 0.0
        for i in range(panels):
            low, high = a + (b - a) * i / panels, a + (b - a) * (i + 1) / panels
            part, tail, beyond = swept(source, start, end, low, high)
            if not beyond <= noise:
                return math.inf
            area += part
            size = abs(end.x - start.x) + abs(end.y - start.y)
            error += 0.0 if tail <= noise * size else tail * tail / max(abs(part), noise * size)
        if error <= ACCURATE * area or area <= noise:
            return area
        panels *= 2
    return math.inf


@kernel
def nothing(fit: Any) -> float:
    """No state: the area has no peak to remember."""
    return 0.0


@kernel
def visit(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    state: float, calm: float, space: Any,
) -> tuple[float, float, bool, float]:  # fmt: skip
    """(area, 0, settled, state) of the chord of the arc [a, b]; NaN where it crosses the chord."""
    area = measure(source, a, start, b, end, 1)
    return (area if math.isfinite(area) else math.nan), 0.0, True, state


@kernel
def confirm(
    fit: Any, choice: float, source: Source, a: float, start: Frame, b: float, end: Frame,
    points: int, space: Any,
) -> tuple[float, float]:  # fmt: skip
    """(area, 0) of the chord, from ``points`` samples or more."""
    return measure(source, a, start, b, end, points), 0.0


@kernel
def best(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame, points: int, space: Any
) -> tuple[float, float]:
    """(area, 0) of the chord, which is the only piece there is."""
    return measure(source, a, start, b, end, points), 0.0
