"""Conic arcs in the terms of other formats: cubic Bézier curves with a proved error, and axes of ellipses.

A conic arc with weight w > 0 and control triangle P₀, P₁, P₂ is followed to order six by the cubic with
control points P₀, P₀ + λ(P₁−P₀), P₂ + λ(P₁−P₂), P₂, λ = 4w/(3(1+w)), which has the same end tangents and
the same point in the middle (for a circle the familiar 4/3·tan(θ/4)). In barycentric coordinates τ of the
triangle the conic is f = τ₁² − 4w²τ₀τ₂ = 0, and on the cubic, at parameter t,

    f = 16w²((1−w)/(1+w))² (t(1−t)(1/2−t))²,   so   0 <= f <= w²(1−w)²/(27(1+w)²).

The cubic stays inside the triangle if w <= 3. Moving a point of it by −δe, e = P₁ − (P₀+P₂)/2, takes δ from
τ₁ and changes f at a rate of at least 2·min(1, w²) all the way down to τ₁ = 0, where f <= 0: hence the conic
is met at a δ of at most f/(2·min(1, w²)). As every line along e that meets the chord meets both arcs, this
bounds the distance both ways:

    Hausdorff distance <= max(1, w²)(1−w)²/(54(1+w)²) · |e|.

Likewise the parabola on the same triangle, where f = (1−w²)(2t(1−t))², is within |1−w²|/(8·min(1, w²)) · |e|.
Compare M. Floater, An O(h²ⁿ) Hermite approximation for conic sections, CAGD 14 (1997).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Context, Decimal, localcontext
from typing import TYPE_CHECKING

from osculant.cas.errors import ToleranceError

if TYPE_CHECKING:
    from osculant.pieces.conics import Piece, Point

Cubic = tuple["Point", "Point", "Point"]

WEIGHT_RANGE = (0.5, 2.0)  # of a sub-arc that becomes one cubic; the bound is proved for (0, 3]
MOST_CUBICS = 100_000  # for one piece: a few hundred reach the rounding floor


@dataclass(frozen=True)
class Ellipse:
    """An elliptic arc by the ellipse that carries it, divided into arcs of equal eccentric angle.

    Attributes:
        radii: semi-axes, the larger first, rounded once.
        rotation: angle of the larger one against the x-axis in radians, good to 2⁻⁵¹.
        half_angle: half the eccentric angle of one of the arcs, in (0, π).
        ends: the end point of each arc, rounded once.
        height: the largest height of an arc above its chord is at most this.
        positive: whether the arcs run counterclockwise.
    """

    radii: tuple[float, float]
    rotation: float
    half_angle: float
    ends: tuple[Point, ...]
    height: float
    positive: bool


def ellipse(piece: Piece, halvings: int = 0) -> Ellipse:
    """Return the ellipse of a piece with weight in (−1, 1), and 2^halvings equal arcs of it.

    With p the semi-diameter that ends in the piece's middle point and q the one conjugate to it the piece is
    centre + p·cos φ + q·sin φ, |φ| <= θ, cos θ = w. All is reckoned with 60 digits, so that arcs far from the
    origin, or tiny on their ellipse, keep all the figures that the piece has.

    >>> from osculant.pieces.conics import Piece
    >>> half = Piece("ellipse", (0, 3), (2.0, 0.0), (-2.0, 0.0), (0.0, 1.0), 0.0, 0.0)
    >>> ellipse(half).radii, ellipse(half, 1).ends
    ((2.0, 1.0), ((0.0, 1.0), (-2.0, 0.0)))
    """
    with localcontext(Context(prec=60)):
        w = Decimal(piece.weight)
        start, end, middle = (tuple(map(Decimal, point)) for point in (piece.start, piece.end, piece.middle))
        square = (1 - w) * (1 + w)
        sine = square.sqrt()
        mean = [(x + y) / 2 for x, y in zip(start, end)]
        px, py = p = [(x - w * y) / square for x, y in zip(middle, mean)]
        qx, qy = q = [(y - x) / (2 * sine) for x, y in zip(start, end)]
        # Singular values of the matrix (p q) as sum and difference of its rotating and its mirroring part.
        (ax, ay), (bx, by) = ((px + qy) / 2, (py - qx) / 2), ((px - qy) / 2, (py + qx) / 2)
        major, minor = (ax * ax + ay * ay).sqrt(), (bx * bx + by * by).sqrt()
        larger = major + minor
        smaller = abs(px * qy - py * qx) / larger if larger else larger
        rotation = (math.atan2(ay, ax) + math.atan2(by, bx)) / 2
        # Points at equal steps of the angle, by rotation; the step is 2θ halved so many times.
        cosine, step_sine = 2 * w * w - 1, 2 * w * sine
        half_cosine, half_sine = w, sine
        for _ in range(halvings):
            cosine, step_sine = half_cosine, half_sine
            half_cosine = ((1 + cosine) / 2).sqrt()
            half_sine = step_sine / (2 * half_cosine)
        x, y = w, -sine
        ends = []
        for _ in range(2**halvings - 1):
            x, y = x * cosine - y * step_sine, x * step_sine + y * cosine
            ends.append(tuple(float(m + (x - w) * s + y * t) for m, s, t in zip(mean, p, q)))
        height = (1 - half_cosine) * (larger if halvings else (px * px + py * py).sqrt())
        return Ellipse(
            (float(larger), float(smaller)),
            rotation,
            math.atan2(half_sine, half_cosine),
            (*((x, y) for x, y in ends), piece.end),
            float(height),
            px * qy > py * qx,
        )


def parabola_bound(piece: Piece) -> float:
    """Bound the distance between a piece and the parabola with the same control triangle.

    It is inf for w < 1/2, where the parabola is no use and the division might overflow.

    >>> from osculant.pieces.conics import Piece
    >>> parabola_bound(Piece("parabola", (0, 1), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0), 1.0, 0.0))
    0.0
    """
    w = piece.weight
    if w < WEIGHT_RANGE[0]:
        return math.inf
    return abs(1 - w) * (1 + w) / (8 * min(1.0, w * w)) * math.hypot(*piece.bulge) / w


def cubic_bound(w: float, height: float) -> float:
    """Bound the Hausdorff distance between a conic arc and its cubic (module text).

    Args:
        w: weight in (0, 3].
        height: |P₁ − (P₀+P₂)/2|.

    >>> cubic_bound(1.0, 5.0)
    0.0
    """
    return max(1.0, w * w) * ((1 - w) / (1 + w)) ** 2 / 54 * height


def cubics(piece: Piece, budget: float) -> list[Cubic]:
    """Return cubics, hardly more than needed, of equal angle, within a distance of the piece.

    Args:
        piece: any piece with weight above −1, of any kind.
        budget: the largest Hausdorff distance allowed, > 0; rounding of a few units comes on top.

    Returns:
        For each cubic its three control points after the first, which is the end of the one before. Tangents
        are continuous from one to the next and agree with the piece at both its ends.

    Raises:
        ToleranceError: a budget that 100,000 cubics do not reach.

    >>> from osculant.pieces.conics import Piece
    >>> quarter = Piece("ellipse", (0, 1), (1.0, 0.0), (0.0, 1.0), (0.5**0.5, 0.5**0.5), 0.5**0.5, 0.0)
    >>> len(cubics(quarter, 1e-3)), len(cubics(quarter, 1e-12))
    (1, 26)
    """
    low, high = WEIGHT_RANGE
    w = piece.weight
    n = 1
    if w < low:
        n = math.ceil(math.acos(w) / math.acos(low))
    elif w > high:
        n = math.ceil(math.acosh(w) / math.acosh(high))
    while n <= MOST_CUBICS:
        result, bound = _divide(piece, n)
        if bound <= budget:
            return result
        # The bound falls with about the sixth power of n, at first a little faster: aim short.
        guess = n * (bound / budget) ** (1 / 6) if budget > 0 else math.inf
        n = max(n + 1, int(0.97 * guess)) if guess < MOST_CUBICS else MOST_CUBICS + 1
    raise ToleranceError(
        f"No {MOST_CUBICS} cubics follow a conic piece to within {budget!r}; allow a larger error."
    )


def _divide(piece: Piece, n: int) -> tuple[list[Cubic], float]:
    """Return n cubics for sub-arcs of equal angle, and the greatest of their error bounds."""
    (ax, ay), _, (cx, cy) = piece.legs
    x0, y0 = piece.start
    w = piece.weight
    if w < 1:
        part = math.cos(math.acos(w) / n)
    else:
        part = math.cosh(math.acosh(w) / n)
    ratio = 4 * part / (3 * (1 + part))

    def place(a: tuple[float, float], b: tuple[float, float], weight: float) -> Point:
        """Return the blossom at two parameters, relative to P₀."""
        middle, last = (a[0] * b[1] + a[1] * b[0]) / weight, a[1] * b[1] / weight
        return middle * ax + last * cx, middle * ay + last * cy

    result: list[Cubic] = []
    bound = 0.0
    here, at, size = (1.0, 0.0), (0.0, 0.0), 1.0
    for i in range(1, n + 1):
        there = _parameter(w, i, n)
        next_size = math.hypot(there[0] - there[1], math.sqrt(2 * (1 + w) * there[0] * there[1]))
        to = place(there, there, next_size**2) if i < n else (cx, cy)
        # The weight between is known in closed form; the blossom's own would cancel for w < 0.
        control = place(here, there, part * size * next_size)
        height = math.hypot(control[0] - (at[0] + to[0]) / 2, control[1] - (at[1] + to[1]) / 2)
        bound = max(bound, cubic_bound(part, height))
        handles = [(e[0] + ratio * (control[0] - e[0]), e[1] + ratio * (control[1] - e[1])) for e in (at, to)]
        c1, c2 = ((x0 + x, y0 + y) for x, y in handles)
        result.append((c1, c2, (x0 + to[0], y0 + to[1]) if i < n else piece.end))
        here, at, size = there, to, next_size
    return result, bound


def _parameter(w: float, i: int, n: int) -> tuple[float, float]:
    """Return (1−u, u) of the i-th of n+1 points that divide the arc into equal angles."""
    if w == 1:
        return (n - i) / n, i / n
    angle, wave = (math.acos(w), math.sin) if w < 1 else (math.acosh(w), math.sinh)
    before, after = wave(angle * i / n), wave(angle * (n - i) / n)
    return after / (before + after), before / (before + after)
