"""The bihelix of one arc by either rule, with its error: for the equioscillating rule, the offset is sought.

With the offset u = vσ/2 of the junction from the middle, v in (−1, 1), the logarithm of left peak/right peak
grows with v, by about `STEEPNESS` v on arcs short enough.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from osculant.kernels.bihelices.family import (
    EQUIOSCILLATING,
    LEVEL,
    Bihelix,
    bihelix,
    chord,
    normal_plane,
)
from osculant.kernels.bihelices.hausdorff import two_sided
from osculant.kernels.bihelices.helix import SAME
from osculant.kernels.bihelices.scan import all_peaks, peaks
from osculant.kernels.curves.arc_length import Lengths, measure_lengths
from osculant.kernels.curves.space import Frame, Source
from osculant.kernels.curves.vectors import cross, norm, subtract
from osculant.kernels.jit import kernel

#: d log(left peak/right peak)/dv of short arcs
STEEPNESS = 12.0
#: farthest offset, longest step of v while no sign change is known, evaluations
FARTHEST, STRIDE, STEPS = 0.8, 0.2, 40
#: steps from the middle outwards where there is no bihelix
SCAN = 0.1
#: length of curve and bihelix must agree up to this factor for samples to be trusted
LENGTHS_AGREE = 1.25
#: the two helices together turn less than this: just below one turn, where the ends' tangents agree and no
#: junction line exists
MOST_TURN = 1.98 * math.pi
#: neither helix is shorter than this part of both
SHORTEST = 1e-6
#: errors up to this many times the noise of the coordinates are rounding
ROUNDING = 16.0


class Assessed(NamedTuple):
    """A bihelix and its peaks on both sides; infinite if there is no bihelix, or it turns too far."""

    left: float
    right: float
    trusted: bool
    two: Bihelix


class Balanced(NamedTuple):
    """A piece: the bihelix with the junction at the offset v, its error and its peaks on both sides."""

    error: float
    left: float
    right: float
    v: float
    two: Bihelix


@kernel
def is_degenerate(two: Bihelix) -> bool:
    """Whether the two helices turn too far together, or one of them is nothing."""
    first, second = two.left.length, two.right.length
    return two.left.turning + two.right.turning > MOST_TURN or min(first, second) <= SHORTEST * (
        first + second
    )


@kernel
def assess(
    rule: int, source: Source, a: float, left: Frame, b: float, right: Frame,
    sigma: float, v: float, points: int, lengths: Lengths,
) -> Assessed:  # fmt: skip
    """The bihelix with the junction at v, and its peaks; ``points`` samples of each side at least.

    If the rule has none there, that of the rule `LEVEL`.
    """
    found, two = bihelix(rule, source, a, left, b, right, sigma, 0.5 * v * sigma, lengths)
    if not found or is_degenerate(two):
        found, two = bihelix(LEVEL, source, a, left, b, right, sigma, 0.5 * v * sigma, lengths)
        if not found or is_degenerate(two):
            return Assessed(math.inf, math.inf, True, two)
    first, second, trusted = peaks(source, a, b, two, points)
    length = two.left.length + two.right.length
    trusted = trusted and sigma <= LENGTHS_AGREE * length and length <= LENGTHS_AGREE * sigma
    return Assessed(first, second, trusted, two)


@kernel
def is_straight(left: Frame, right: Frame, noise: float) -> bool:
    """Whether the tangents at both ends have the chord's direction, to rounding."""
    step = subtract(right.point, left.point)
    near = SAME * norm(step) + noise
    return (
        norm(subtract(right.tangent, left.tangent)) <= 2.0 * SAME
        and norm(cross(step, left.tangent)) <= near
        and norm(cross(step, right.tangent)) <= near
    )


@kernel
def two_of(
    rule: int, source: Source, a: float, left: Frame, b: float, right: Frame,
    v: float, calm: float, points: int, lengths: Lengths,
) -> tuple[Assessed, float]:  # fmt: skip
    """(bihelix and its peaks, v) of the arc [a, b] by the rule.

    Args:
        rule: `THESIS`, for which v = 0, or `EQUIOSCILLATING`.
        source: the curve, of size about 1.
        a: parameter of the left end.
        left: point and tangent there.
        b: of the right end.
        right: likewise.
        v: first guess.
        calm: the search ends with |log(left peak/right peak)| at most this.
        points: samples of each side, at least.
        lengths: scratch space of ``osculant.kernels.curves.arc_length.workspace``.

    If no v tried makes the peaks change places (on long arcs there may be none), the best v tried; infinite
    peaks if there is no bihelix.
    """
    sigma = measure_lengths(source, a, b, lengths)
    noise = source.place.noise
    if is_straight(left, right, noise):
        two = chord(left, right, 0.5 * (a + b))
        t = normal_plane(source, a, b, two.right.start, left.tangent, two.t)
        two = Bihelix(two.left, two.right, t)
        first, second, trusted = peaks(source, a, b, two, points)
        return Assessed(first, second, trusted, two), 0.0
    if rule != EQUIOSCILLATING:
        return assess(rule, source, a, left, b, right, sigma, 0.0, points, lengths), 0.0
    v = min(FARTHEST, max(-FARTHEST, v))
    low, high = -FARTHEST, FARTHEST  # where the left peak is smaller, and larger
    low_g, high_g = -math.inf, math.inf
    seen = assess(rule, source, a, left, b, right, sigma, v, points, lengths)
    kept, kept_v = seen, v
    tried = 0
    for _ in range(STEPS):
        larger = max(seen.left, seen.right)
        if larger < max(kept.left, kept.right):
            kept, kept_v = seen, v
        if larger <= ROUNDING * noise:
            break
        if math.isinf(larger):
            if not math.isinf(kept.left):  # nothing beyond here
                if v > kept_v:
                    high, high_g = v, math.inf
                else:
                    low, low_g = v, -math.inf
                v = 0.5 * (v + kept_v)
            else:  # nothing yet: alternately farther to both sides of the middle
                tried += 1
                v = SCAN * ((tried + 1) // 2) * (1.0 if tried % 2 == 0 else -1.0)
                if abs(v) >= FARTHEST:
                    break
        else:
            g = math.log(seen.left / seen.right)
            if abs(g) <= calm:
                break
            if g < 0.0:
                low, low_g = v, g
            else:
                high, high_g = v, g
            if math.isfinite(low_g) and math.isfinite(high_g):
                new = low - low_g * (high - low) / (high_g - low_g)
                if g < 0.0:
                    high_g *= 0.5  # the Illinois method
                else:
                    low_g *= 0.5
            else:
                new = v - max(-STRIDE, min(STRIDE, g / STEEPNESS))
            if not (new > low and new < high):
                new = 0.5 * (low + high)
            v = new
        if high - low <= 1e-12:
            break
        seen = assess(rule, source, a, left, b, right, sigma, v, points, lengths)
    return kept, kept_v


@kernel
def with_all_peaks(source: Source, a: float, b: float, seen: Assessed, points: int) -> Assessed:
    """A bihelix with the peaks that only the course of the curve tells of, too."""
    if not math.isfinite(max(seen.left, seen.right)):
        return seen
    left, right, trusted = all_peaks(source, a, b, seen.two, points, seen.left, seen.right, seen.trusted)
    return Assessed(left, right, trusted, seen.two)


@kernel
def balanced(
    rule: int, source: Source, a: float, start: Frame, b: float, end: Frame,
    v: float, calm: float, points: int, lengths: Lengths,
) -> Balanced:  # fmt: skip
    """The piece by the rule over [a, b], from the guess v; its error is infinite if there is none.

    Where the feet do not move along the bihelix in order, the error is searched with more care.
    """
    seen, v = two_of(rule, source, a, start, b, end, v, calm, points, lengths)
    seen = with_all_peaks(source, a, b, seen, points)
    error = max(seen.left, seen.right)
    if not seen.trusted and math.isfinite(error):
        error = two_sided(source, a, b, measure_lengths(source, a, b, lengths), seen.two)
    return Balanced(error, seen.left, seen.right, v, seen.two)
