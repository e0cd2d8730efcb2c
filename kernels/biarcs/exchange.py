"""The fast step of biarc splines: the best biarc of one arc from two curve samples.

The distance of a spiral arc from a biarc has two peaks of opposite sign, one beside each arc; those of the
best biarc are equal.  The peaks' places in parts of the arc, and μ, change slowly from arc to arc, so the
caller keeps them: each call samples the curve at the believed peaks, chooses μ, and moves the peaks by one
Newton step.  Nothing is bracketed here: the search measures each result and has `scan.best` to fall back on.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from osculant.kernels.biarcs.family import distance, family, is_proper, member
from osculant.kernels.curves.peaks import Space, within_reason
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.jit import kernel

#: secant steps for μ, the first one, and the rest of the sum of the peaks, in parts of them, that ends them
MU_STEPS, MU_STEP, EVEN = 12, 1e-3, 1e-10


class Peaks(NamedTuple):
    """Places of the two peaks, in parts of the arc, and μ, for the next arc."""

    first: float
    last: float
    mu: float


@kernel
def first_peaks(fit: Any) -> Peaks:
    """Those of a short arc: the peaks of |κ′|σ³/324 are at a third and at two thirds."""
    return Peaks(1.0 / 3.0, 2.0 / 3.0, 0.5)


@kernel
def peak(d: float, slope: float, second: float) -> float:
    """The extreme value near a sample: that of the parabola with this value, slope and second derivative."""
    return d - 0.5 * slope * slope / second if second * d < 0.0 else d


@kernel
def place(x: float, slope: float, second: float, d: float, length: float) -> float:
    """The peak's place after one Newton step, kept within reason; ``length`` is speed times b − a."""
    return within_reason(x, -slope / (second * length) if second * d < 0.0 else 0.0)


@kernel
def visit(
    fit: Any, source: Source, a: float, start: Frame, b: float, end: Frame,
    peaks: Peaks, calm: float, space: Space,
) -> tuple[float, float, bool, Peaks]:  # fmt: skip
    """(error, μ, settled, peaks moved) of the best biarc of the arc [a, b], by one fast evaluation.

    The peaks have settled if their correction is at most the part ``calm`` of the error, which is NaN where
    nothing is found.
    """
    fam = family(start, end)
    if not is_proper(fam):
        return math.nan, math.nan, False, peaks
    x0, y0, tx0, ty0, speed0, bend0 = sample(source, a + peaks.first * (b - a))
    x1, y1, tx1, ty1, speed1, bend1 = sample(source, a + peaks.last * (b - a))
    mu, before, sum_before = peaks.mu, math.nan, math.nan
    error, unrest = math.nan, math.inf
    for _ in range(MU_STEPS):
        arcs = member(fam, mu)
        d0, slope0, second0 = distance(arcs, x0, y0, tx0, ty0, bend0)
        d1, slope1, second1 = distance(arcs, x1, y1, tx1, ty1, bend1)
        peak0, peak1 = peak(d0, slope0, second0), peak(d1, slope1, second1)
        error, total = max(abs(peak0), abs(peak1)), peak0 + peak1
        if not error > 0.0:
            return math.nan, math.nan, False, peaks
        unrest = max(abs(peak0 - d0), abs(peak1 - d1)) / error
        if abs(total) <= EVEN * error:
            break
        step = MU_STEP
        if total != sum_before and not math.isnan(before):
            step = -total * (mu - before) / (total - sum_before)
        before, sum_before = mu, total
        mu = min(0.99, max(0.01, mu + min(0.2, max(-0.2, step))))
        if mu == before:
            break
    if not peak0 * peak1 < 0.0 or abs(peak0 + peak1) > 1e-7 * error:
        unrest = math.inf
    first = place(peaks.first, slope0, second0, d0, speed0 * (b - a))
    last = place(peaks.last, slope1, second1, d1, speed1 * (b - a))
    return error, mu, unrest <= calm, Peaks(first, last, mu)
