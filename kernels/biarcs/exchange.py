"""The fast step of biarc splines: the best biarc of one arc from two curve samples.

The distance of a spiral arc from a biarc has two peaks of opposite sign, one beside each arc; those of the
best biarc are equal.  The peaks' places in parts of the arc, and μ, change slowly from arc to arc, so the
caller keeps them: each call samples the curve at the believed peaks, chooses μ, and moves the peaks by one
Newton step.  Nothing is bracketed here: `greedy` measures each result and has `minimax` to fall back on.
"""

from __future__ import annotations

import math

from osculant.kernels.biarcs.family import distance, family, is_proper, member
from osculant.kernels.conics.exchange import LARGEST_MOVE, MARGIN, Peaks
from osculant.kernels.curves.plane import Frame, Source, sample
from osculant.kernels.jit import kernel

#: places of the peaks and μ of a short arc: the peaks of |κ′|σ³/324 are at a third and at two thirds
FIRST_PEAKS = (1.0 / 3.0, 2.0 / 3.0, 0.5, 0.0)
#: secant steps for μ, the first one, and the rest of the sum of the peaks, in parts of them, that ends them
MU_STEPS, MU_STEP, EVEN = 12, 1e-3, 1e-10


@kernel
def peak(d: float, slope: float, second: float) -> float:
    """The extreme value near a sample: that of the parabola with this value, slope and second derivative."""
    return d - 0.5 * slope * slope / second if second * d < 0.0 else d


@kernel
def place(x: float, slope: float, second: float, d: float, length: float) -> float:
    """The peak's place after one Newton step, kept within reason; ``length`` is speed times b − a."""
    if second * d < 0.0:
        x -= min(LARGEST_MOVE, max(-LARGEST_MOVE, slope / (second * length)))
    return min(1.0 - MARGIN, max(MARGIN, x))


@kernel
def exchange(
    source: Source, a: float, start: Frame, b: float, end: Frame, peaks: Peaks
) -> tuple[float, float, float, Peaks]:
    """(error, μ, the peaks' relative correction, peaks moved); the error is NaN where nothing is found."""
    fam = family(start, end)
    if not is_proper(fam):
        return math.nan, math.nan, math.inf, peaks
    x0, y0, tx0, ty0, speed0, bend0 = sample(source, a + peaks[0] * (b - a))
    x1, y1, tx1, ty1, speed1, bend1 = sample(source, a + peaks[1] * (b - a))
    mu, before, sum_before = peaks[2], math.nan, math.nan
    error, unrest = math.nan, math.inf
    for _ in range(MU_STEPS):
        arcs = member(fam, mu)
        d0, slope0, second0 = distance(arcs, x0, y0, tx0, ty0, bend0)
        d1, slope1, second1 = distance(arcs, x1, y1, tx1, ty1, bend1)
        peak0, peak1 = peak(d0, slope0, second0), peak(d1, slope1, second1)
        error, total = max(abs(peak0), abs(peak1)), peak0 + peak1
        if not error > 0.0:
            return math.nan, math.nan, math.inf, peaks
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
    first = place(peaks[0], slope0, second0, d0, speed0 * (b - a))
    last = place(peaks[1], slope1, second1, d1, speed1 * (b - a))
    return error, mu, unrest, (first, last, mu, 0.0)
