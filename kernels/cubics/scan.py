"""Errors of a cubic measured over samples of the whole arc: its peaks, at the common normals."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.course import spot, spots
from osculant.kernels.cubics.arms import BEYOND, Ends, Seen, bends_little, goes_along, see
from osculant.kernels.cubics.roots import COLUMNS as POLYNOMIAL
from osculant.kernels.cubics.starts import MOST
from osculant.kernels.curves.peaks import MARGIN, cubic_peak
from osculant.kernels.curves.plane import Sample, Source, sample
from osculant.kernels.jit import kernel

#: samples of an arc at most; columns: a `Sample`, its parameter, and what it sees
ROWS, COLUMNS = 800, 12
TIME, FOOT, D, SLOPE, BY0, BY3 = 6, 7, 8, 9, 10, 11
#: peaks at most, and what each has: place, displacement, derivatives by the arms
PEAKS, PEAK_COLUMNS = 48, 4
#: neighbouring samples whose tangents, or the cubic's there, differ by more than this angle are too far apart
LARGEST_TURN = 0.35
#: visits of one peak, and the relative correction of its height that ends them
VISITS, SETTLED = 8.0, 1e-7
#: a cubic is the curve itself where it is nearer than so many units of the coordinates' noise
ITSELF = 2.0


class Space(NamedTuple):
    """Scratch space: samples, peaks, pairs of arms, room for polynomials and their zeros."""

    samples: np.ndarray[Any, Any]
    peaks: np.ndarray[Any, Any]
    arms: np.ndarray[Any, Any]
    rows: np.ndarray[Any, Any]
    zeros: np.ndarray[Any, Any]


@kernel
def workspace(fit: Any) -> Space:
    """Made once per spline."""
    return Space(
        np.empty((ROWS, COLUMNS)),
        np.empty((PEAKS, PEAK_COLUMNS)),
        np.empty((MOST, 2)),
        np.zeros((POLYNOMIAL, POLYNOMIAL)),
        np.empty((2, POLYNOMIAL + 1)),
    )


@kernel
def look(source: Source, a: float, b: float, ends: Ends, points: int, samples: np.ndarray[Any, Any]) -> int:
    """Fill ``samples`` at ``points`` inner points or more: where the course tells, and where the curve turns.

    Returns how many; −1 if there is no room for as many as it takes.
    """
    cosine = math.cos(LARGEST_TURN)
    while True:
        at = spots(source.course, a, b, points)
        count = at.steps - 1
        if count > samples.shape[0]:
            return -1
        tx, ty, fine = ends.tx0, ends.ty0, True
        for i in range(count):
            t = spot(source.course, at, i + 1)
            here = sample(source, t)
            note(samples[i], t, here)
            fine = fine and tx * here.tx + ty * here.ty >= cosine
            tx, ty = here.tx, here.ty
        if fine and tx * ends.tx3 + ty * ends.ty3 >= cosine:
            return count
        points = 2 * count + 1


@kernel
def note(row: np.ndarray[Any, Any], t: float, at: Sample) -> None:
    """Write a sample into a row."""
    for j, value in enumerate(at):
        row[j] = value
    row[TIME] = t


@kernel
def at_row(row: np.ndarray[Any, Any]) -> Sample:
    """A row's sample of the curve."""
    return Sample(row[0], row[1], row[2], row[3], row[4], row[5])


@kernel
def trace(ends: Ends, a0: float, a3: float, samples: np.ndarray[Any, Any], count: int) -> bool:
    """See the cubic from all samples; False if it does not go along with the curve (`arms`)."""
    foot = 0.0
    for i in range(count):
        row = samples[i]
        seen = see(ends, a0, a3, at_row(row), foot)
        if not seen.foot > foot - BEYOND:  # beside a cusp many samples share one foot
            return False
        if not goes_along(ends, a0, a3, foot, seen.foot, row[2], row[3]):
            return False
        foot = seen.foot
        row[FOOT], row[D], row[SLOPE], row[BY0], row[BY3] = seen.foot, seen.d, seen.slope, seen.by0, seen.by3
    return goes_along(ends, a0, a3, foot, 1.0, ends.tx3, ends.ty3)


@kernel
def look_closer(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float, count: int,
    samples: np.ndarray[Any, Any],
) -> int:  # fmt: skip
    """Add samples, after `trace`, where the cubic turns between two as the curve does not, and see it again.

    A curve bent more closely than the cubic is far off sees much of that from a few of its points: peaks
    between them would be missed.  Returns how many samples there are; −1 if it takes too many, or the cubic
    does not go along.
    """
    cosine = math.cos(LARGEST_TURN)
    while True:
        before, t1, u1 = count, b, 1.0
        for i in range(count, -1, -1):  # backwards, as samples are added behind
            t0, u0 = a, 0.0
            if i > 0:
                t0, u0 = samples[i - 1, TIME], samples[i - 1, FOOT]
            if not bends_little(ends, a0, a3, u0, u1, cosine):
                middle = 0.5 * (t0 + t1)
                if count == samples.shape[0] or not t0 < middle < t1:
                    return -1
                for j in range(count, i, -1):
                    for k in range(COLUMNS):
                        samples[j, k] = samples[j - 1, k]
                note(samples[i], middle, sample(source, middle))
                count += 1
            t1, u1 = t0, u0
        if count == before:
            return count
        if not trace(ends, a0, a3, samples, count):
            return -1


@kernel
def peak_between(
    source: Source, ends: Ends, a0: float, a3: float, t0: float, u0: float, d0: float, s0: float,
    t1: float, u1: float, d1: float, s1: float, visits: float,
) -> tuple[float, Seen]:  # fmt: skip
    """(gain of the last step, what is seen) at the extreme of d between two samples.

    Its foot is NaN if the normal misses.
    """
    h = t1 - t0
    part, bend = cubic_peak(d0, s0 * h, d1, s1 * h)
    bend /= h * h
    margin = MARGIN * h
    t, before, steepness, gain = t0 + part * h, math.nan, math.nan, 0.0
    seen = see(ends, a0, a3, sample(source, t), u0 + part * (u1 - u0))
    for _ in range(int(visits)):
        if math.isnan(seen.foot):
            break
        if t != before and seen.slope != steepness and not math.isnan(before):
            bend = (seen.slope - steepness) / (t - before)
        if not bend * seen.d < 0.0:
            gain = 0.0
            break
        gain = -0.5 * seen.slope * seen.slope / bend
        if abs(gain) <= SETTLED * abs(seen.d):
            break
        before, steepness = t, seen.slope
        t = min(t1 - margin, max(t0 + margin, t - seen.slope / bend))
        seen = see(ends, a0, a3, sample(source, t), seen.foot)
    return gain, seen


@kernel
def peaks_of(
    source: Source,
    a: float,
    b: float,
    ends: Ends,
    a0: float,
    a3: float,
    count: int,
    space: Space,
    visits: float,
) -> tuple[float, int]:
    """(max |d|, number of peaks), the peaks in ``space``, after `trace`; infinite if a normal misses."""
    samples, peaks = space.samples, space.peaks
    found, top = 0, 0.0
    t0, u0, d0, s0 = a, 0.0, 0.0, 0.0
    for i in range(count + 1):
        t1, u1, d1, s1 = b, 1.0, 0.0, 0.0
        if i < count:
            row = samples[i]
            t1, u1, d1, s1 = row[TIME], row[FOOT], row[D], row[SLOPE]
            top = max(top, abs(d1))
        rising = s0 if i > 0 else d1  # |d| grows from 0 at both ends
        falling = s1 if i < count else -d0
        if rising * falling < 0.0 and found < peaks.shape[0]:
            gain, seen = peak_between(source, ends, a0, a3, t0, u0, d0, s0, t1, u1, d1, s1, visits)
            if math.isnan(seen.foot):
                return math.inf, 0
            peak = peaks[found]
            peak[0], peak[1], peak[2], peak[3] = seen.foot, seen.d + gain, seen.by0, seen.by3
            top = max(top, abs(peak[1]))
            found += 1
        t0, u0, d0, s0 = t1, u1, d1, s1
    return top, found


@kernel
def measure(
    source: Source, a: float, b: float, ends: Ends, a0: float, a3: float, points: int, space: Space
) -> float:
    """max |d| of the cubic over [a, b], from ``points`` samples or more; infinite if it strays (`arms`).

    An upper bound of the Hausdorff distance as far as the peaks between the samples have been found: an
    estimate, not a certificate.  Below the noise of the coordinates the cubic is the curve itself: 0.
    """
    count = look(source, a, b, ends, points, space.samples)
    if count < 0 or not trace(ends, a0, a3, space.samples, count):
        return math.inf
    count = look_closer(source, a, b, ends, a0, a3, count, space.samples)
    if count < 0:
        return math.inf
    top, _ = peaks_of(source, a, b, ends, a0, a3, count, space, VISITS)
    return 0.0 if top <= ITSELF * source.place.noise else top
