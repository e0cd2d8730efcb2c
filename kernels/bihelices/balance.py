"""The bihelix of one arc by either rule, with its error: for the equioscillating rule, the offset is sought.

With the offset u = vσ/2 of the junction from the middle, v in (−1, 1), the logarithm of left peak/right peak
grows with v, by about `STEEPNESS` v on arcs short enough.
"""

from __future__ import annotations

import math

from osculant.kernels.bihelices.family import (
    EQUIOSCILLATING,
    LEVEL,
    Bihelix,
    End,
    bihelix,
    chord,
    normal_plane,
)
from osculant.kernels.bihelices.helix import SAME, place_at
from osculant.kernels.bihelices.scan import peaks
from osculant.kernels.curves.arc_length import Lengths, measure_lengths
from osculant.kernels.curves.space import Source
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

#: (left peak, right peak, trusted, bihelix): infinite peaks if there is no bihelix, or it turns too far
Assessed = tuple[float, float, bool, Bihelix]


@kernel
def is_degenerate(two: Bihelix) -> bool:
    """Whether the two helices turn too far together, or one of them is nothing."""
    first, second = two[0][13], two[1][13]
    return two[0][14] + two[1][14] > MOST_TURN or min(first, second) <= SHORTEST * (first + second)


@kernel
def assess(
    rule: int, source: Source, a: float, left: End, b: float, right: End,
    sigma: float, v: float, points: int, lengths: Lengths,
) -> Assessed:  # fmt: skip
    """The bihelix with the junction at v, and its peaks; ``points`` samples of each side at least.

    If the rule has none there, that of the rule `LEVEL`.
    """
    found, two = bihelix(rule, source, a, left, b, right, sigma, 0.5 * v * sigma, lengths)
    if not found or is_degenerate(two):
        found, two = bihelix(LEVEL, source, a, left, b, right, sigma, 0.5 * v * sigma, lengths)
        if not found or is_degenerate(two):
            return math.inf, math.inf, True, two
    first, second, trusted = peaks(source, a, b, two, points)
    length = two[0][13] + two[1][13]
    trusted = trusted and sigma <= LENGTHS_AGREE * length and length <= LENGTHS_AGREE * sigma
    return first, second, trusted, two


@kernel
def is_straight(left: End, right: End, noise: float) -> bool:
    """Whether the tangents at both ends have the chord's direction, to rounding."""
    step = subtract(right[0], left[0])
    near = SAME * norm(step) + noise
    return (
        norm(subtract(right[1], left[1])) <= 2.0 * SAME
        and norm(cross(step, left[1])) <= near
        and norm(cross(step, right[1])) <= near
    )


@kernel
def best(
    rule: int, source: Source, a: float, left: End, b: float, right: End,
    v: float, calm: float, points: int, lengths: Lengths,
) -> tuple[float, float, float, bool, Bihelix]:  # fmt: skip
    """(left peak, right peak, v, trusted, bihelix) of the arc [a, b] by the rule.

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
    noise = source[1][4]
    if is_straight(left, right, noise):
        two = chord(left, right, 0.5 * (a + b))
        t = normal_plane(source, a, b, place_at(two[1], 0.0)[0], left[1], two[2])
        two = (two[0], two[1], t)
        first, second, trusted = peaks(source, a, b, two, points)
        return first, second, 0.0, trusted, two
    if rule != EQUIOSCILLATING:
        first, second, trusted, two = assess(rule, source, a, left, b, right, sigma, 0.0, points, lengths)
        return first, second, 0.0, trusted, two
    v = min(FARTHEST, max(-FARTHEST, v))
    low, high = -FARTHEST, FARTHEST  # where the left peak is smaller, and larger
    low_g, high_g = -math.inf, math.inf
    first, second, trusted, two = assess(rule, source, a, left, b, right, sigma, v, points, lengths)
    kept = (first, second, v, trusted, two)
    tried = 0
    for _ in range(STEPS):
        larger = max(first, second)
        if larger < max(kept[0], kept[1]):
            kept = (first, second, v, trusted, two)
        if larger <= ROUNDING * noise:
            break
        if math.isinf(larger):
            if not math.isinf(kept[0]):  # nothing beyond here
                if v > kept[2]:
                    high, high_g = v, math.inf
                else:
                    low, low_g = v, -math.inf
                v = 0.5 * (v + kept[2])
            else:  # nothing yet: alternately farther to both sides of the middle
                tried += 1
                v = SCAN * ((tried + 1) // 2) * (1.0 if tried % 2 == 0 else -1.0)
                if abs(v) >= FARTHEST:
                    break
        else:
            g = math.log(first / second)
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
        first, second, trusted, two = assess(rule, source, a, left, b, right, sigma, v, points, lengths)
    return kept
