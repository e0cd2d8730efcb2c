"""The distance between an arc and a bihelix: peaks on each side of the junction.

Distances are measured from points of the curve to their feet on the helix; the foot moves continuously from
one end of the bihelix to the other, so that the largest of them bounds the two-sided Hausdorff distance,
and at a peak both curves have a common normal: peaks are the same seen from either.  If the feet do not
reach both ends of each helix, parts of it are not seen, and the distances are not trusted.
"""

from __future__ import annotations

import math

from osculant.kernels.bihelices.family import Bihelix
from osculant.kernels.bihelices.foot import foot
from osculant.kernels.bihelices.helix import Helix
from osculant.kernels.course import Spots, equidistant, in_one_row, spot, spots
from osculant.kernels.curves.space import Source, sample
from osculant.kernels.curves.vectors import dot, norm
from osculant.kernels.jit import kernel

#: visits of one peak at most, and the relative correction of its height that ends them
VISITS, SETTLED = 8, 1e-8
#: most that a helix turns between two samples, and the most samples of one side
TURN, MOST = 0.35, 64
#: samples of one side at most: longer arcs are not measured; a peak counts as another one if it is higher by
#: this part, which is less than the window of errors leaves
MOST_OF_ALL, MORE = 600, 1e-7
#: the sight of a point is trusted if the curve leans to the helix by less (cosine) …
LEAN = 0.8
#: … and the helix is not near its evolute: 1 − ⟨p − α, κN⟩ is larger
STIFF = 0.3

#: feet this part of a helix from its end, and this many times the noise, are there: the parameter of the
#: junction is known to rounding
REACHED, REACHED_NOISE = 1e-6, 64.0

#: (distance, its derivative by the parameter, foot's arc length, speed, trusted)
View = tuple[float, float, float, float, bool]


@kernel
def look(source: Source, helix: Helix, t: float, s: float, noise: float) -> View:
    """The curve point t seen from the helix, its foot near arc length s."""
    p, v, _ = sample(source, t)
    at, away, tangent, stiff = foot(helix, p, min(s, helix.length), 0.0, helix.length)
    d, speed = norm(away), norm(v)
    slope = dot(away, v) / d if d > noise else 0.0
    return d, slope, at, speed, stiff > STIFF and dot(v, tangent) >= LEAN * speed


@kernel
def height(
    source: Source, helix: Helix, low: float, high: float, t: float, bend: float, s: float, noise: float
) -> tuple[float, bool]:
    """(distance at its peak in [low, high], trusted), from the guess t with d″ ≈ bend and a foot near s."""
    before, steepness, d, trusted = math.nan, 0.0, 0.0, True
    for _ in range(VISITS):
        d, slope, s, speed, trusted = look(source, helix, t, s, noise)
        if not trusted:
            break
        if slope != steepness and not math.isnan(before):
            bend = (slope - steepness) / (t - before)
        if not bend < 0.0:  # not a peak: the samples around said more than this
            break
        gain = -0.5 * slope * slope / bend
        if gain <= SETTLED * d:
            return d + gain, True
        before, steepness = t, slope
        t = min(high, max(low, t - slope / bend))
        s += speed * (t - before)
    return d, trusted


@kernel
def summit(d0: float, s0: float, d1: float, s1: float) -> tuple[float, float]:
    """(u, second derivative there) of the local maximum in (0, 1) of the cubic with these ends and slopes.

    u is NaN if there is none.  There may be one though the cubic falls at both ends.

    >>> summit(0.0, 1.0, 0.0, -1.0)
    (0.5, -2.0)
    """
    b = 3.0 * (d1 - d0) - 2.0 * s0 - s1
    c = s0 + s1 - 2.0 * (d1 - d0)
    square = b * b - 3.0 * c * s0  # the derivative is s0 + 2bu + 3cu²
    if not square > 0.0:
        return math.nan, 0.0
    root = math.sqrt(square)
    u = -(b + root) / (3.0 * c) if b > 0.0 and c != 0.0 else s0 / (root - b)
    return (u if 0.0 < u < 1.0 else math.nan), -2.0 * root


@kernel
def side(source: Source, helix: Helix, at: Spots, noise: float) -> tuple[float, bool]:
    """(largest distance, trusted) of the curve from one helix, with matching ends.

    Between samples at the spots of the arc each peak is sought.
    """
    t0 = at.a
    d0, slope0, s0, speed0, trusted = look(source, helix, t0, 0.0, noise)
    near = REACHED * helix.length + REACHED_NOISE * noise
    trusted = trusted and s0 <= near
    top = d0
    for i in range(1, at.steps + 1):
        t = spot(source.course, at, i)
        step = t - t0
        d1, slope1, s1, speed1, good = look(source, helix, t, s0 + speed0 * step, noise)
        trusted = trusted and good and s1 >= s0
        top = max(top, d1)
        u, bend = summit(d0, slope0 * step, d1, slope1 * step)
        if not math.isnan(u) and top > noise:
            seed = s0 + u * (s1 - s0)
            peak, good = height(source, helix, t0, t, t + (u - 1.0) * step, bend / (step * step), seed, noise)
            trusted = trusted and good
            top = max(top, peak)
        t0, d0, slope0, s0, speed0 = t, d1, slope1, s1, speed1
    return top, trusted and s0 >= helix.length - near


@kernel
def peaks(source: Source, a: float, b: float, two: Bihelix, points: int) -> tuple[float, float, bool]:
    """(left peak, right peak, trusted): the largest distances on both sides of the junction.

    From ``points`` samples of each, or more where a helix turns a lot; `all_peaks` sees more.
    """
    noise = source.place.noise
    t = two.t
    left, sure = side(source, two.left, quick(two.left, a, t, points), noise)
    right, sure_too = side(source, two.right, quick(two.right, t, b, points), noise)
    return left, right, sure and sure_too


@kernel
def quick(helix: Helix, a: float, b: float, points: int) -> Spots:
    """So many samples of an arc, or more where the helix turns a lot."""
    count = int(min(float(MOST), max(float(points), math.ceil(helix.turning / TURN))))
    return equidistant(a, b, count)


@kernel
def seen_all(
    source: Source, helix: Helix, a: float, b: float, points: int, top: float, trusted: bool
) -> tuple[float, bool]:
    """(largest distance, trusted) of a side with all that the course tells of it, from what was seen before.

    Infinite if that takes more than `MOST_OF_ALL` samples.  What was seen is kept if there is no more to it,
    so that errors are smooth in the ends of the arc.
    """
    at = spots(source.course, a, b, points)
    if in_one_row(at):
        return top, trusted
    if at.steps > MOST_OF_ALL:
        return math.inf, trusted
    found, sure = side(source, helix, at, source.place.noise)
    return (found if found > (1.0 + MORE) * top else top), trusted and sure


@kernel
def all_peaks(
    source: Source, a: float, b: float, two: Bihelix, points: int, left: float, right: float, trusted: bool
) -> tuple[float, float, bool]:
    """`peaks` with all that the course tells of the arc, from what was seen before."""
    left, trusted = seen_all(source, two.left, a, two.t, points, left, trusted)
    right, trusted = seen_all(source, two.right, two.t, b, points, right, trusted)
    return left, right, trusted
