"""The Hausdorff distance of a piece and its arc of a curve, from the definition alone.

The curve is its formula, read by sympy and evaluated in long doubles; a piece is what its JSON says.  Where
the curve does something is told by ball arithmetic: its interval is halved until Taylor's remainder is far
below the tolerance on every part, so that no feature hides between samples however small it is.  Both sets of
points are then sampled evenly in length and turning and on every part; distances are to cubics through four
neighbouring samples, and the largest are looked at again between their neighbours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import sympy
from flint import arb, arb_series, ctx
from scipy.spatial import cKDTree

T = sympy.Symbol("t", real=True)
#: the order of Taylor's remainder, and the narrowest and the most parts
ORDER, NARROWEST, MOST = 8, 2.0**-44, 20_000
#: samples evenly spread over a piece and its arc, samples between the edges of parts, and about each peak
SAMPLES, INNER, AGAIN = 100, 4, 9
#: peaks lower than this part of the highest are not looked at again, nor are more than so many
HIGH, MOST_PEAKS = 0.97, 8
#: nearest samples among which the nearest point is looked for where the distance is high
AMONG = 12
#: looks at each peak, and what the last of them may add, in parts of the height
ROUNDS, GAIN = 16, 1e-9

ON_ARRAYS = {
    name: getattr(np, name) for name in ("exp", "sin", "cos", "log", "sqrt", "tan", "sinh", "cosh", "tanh")
} | {"atan": np.arctan, "asin": np.arcsin, "acos": np.arccos}
ON_SERIES = {
    name: getattr(arb_series, name)
    for name in ("exp", "sin", "cos", "log", "sqrt", "tan", "atan", "asin", "acos")
} | {
    "tanh": lambda x: 1 - 2 / ((2 * x).exp() + 1),
    "cosh": lambda x: (x.exp() + (-x).exp()) / 2,
    "sinh": lambda x: (x.exp() - (-x).exp()) / 2,
}


class GaveUpError(Exception):
    """The curve takes more parts than there may be."""


def evaluate(expression, t, functions, constant):
    """A sympy expression at t, of any type that has arithmetic and the functions."""
    if not expression.free_symbols:
        return constant(expression)
    if expression == T:
        return t
    parts = [evaluate(part, t, functions, constant) for part in expression.args]
    if expression.is_Add:
        return sum(parts[1:], parts[0])
    if expression.is_Mul:
        return math.prod(parts[1:], start=parts[0])
    if expression.is_Pow:
        base, power = expression.base, expression.exp
        if power.is_Integer:
            found = whole_power(parts[0], abs(int(power)))
            return found if power > 0 else 1 / found
        if power == sympy.Rational(1, 2):
            return functions["sqrt"](parts[0])
        exponent = evaluate(power, t, functions, constant)
        if base.free_symbols:
            return functions["exp"](exponent * functions["log"](parts[0]))
        return functions["exp"](exponent * constant(sympy.log(base)))
    return functions[expression.func.__name__](parts[0])


def whole_power(x, n):
    """xⁿ by products, n > 0."""
    if n == 1:
        return x
    half = whole_power(x, n // 2)
    return half * half * x if n % 2 else half * half


@lru_cache(4096)
def long_double(constant):
    """A constant as a long double."""
    return np.longdouble(str(sympy.N(constant, 30)))


@lru_cache(4096)
def as_ball(constant):
    """A constant as a ball."""
    return arb(str(sympy.N(constant, 30)))


@dataclass(frozen=True)
class Formula:
    """A curve by its formulas, on an interval.

    Attributes:
        text: coordinates as the tool takes them, ``t`` the variable.
        low: the interval's first end,
        high: and its last one.
    """

    text: str
    low: str
    high: str

    @cached_property
    def coordinates(self):
        """The coordinates in sympy."""
        parsed = sympy.sympify(f"[{self.text.replace('^', '**')}]", locals={"t": T}, rational=True)
        return tuple(parsed)

    def points(self, times):
        """The points at times (m,): long doubles (m, dimension)."""
        times = np.asarray(times, dtype=np.longdouble)
        columns = [evaluate(c, times, ON_ARRAYS, long_double) for c in self.coordinates]
        return np.stack([np.broadcast_to(column, times.shape) for column in columns], axis=1)

    def parts(self, a, b, accuracy):
        """Edges of parts of [a, b], on each of which the curve is a polynomial to within the accuracy."""
        edges, pending = [a], [(a, b)]
        before, ctx.cap = ctx.cap, ORDER + 1
        try:
            while pending:
                low, high = pending.pop()
                half = 0.5 * (high - low)
                middle = low + half
                if half > NARROWEST * (b - a) and not self._remainder(middle, half) <= accuracy:
                    pending += [(middle, high), (low, middle)]
                    if len(edges) + len(pending) > MOST:
                        raise GaveUpError(self.text)
                    continue
                edges.append(high)
        finally:
            ctx.cap = before
        return np.array(edges)

    def _remainder(self, middle, half):
        """The largest remainder of a coordinate's Taylor polynomial; NaN where the ball is not finite."""
        t = arb_series([arb(middle, half), 1])
        largest = 0.0
        for coordinate in self.coordinates:
            try:
                series = evaluate(coordinate, t, ON_SERIES, as_ball)
            except ValueError:
                return math.nan
            if isinstance(series, arb_series):
                size = float(abs(series[ORDER]).upper()) * half**ORDER
                if not math.isfinite(size):
                    return math.nan
                largest = max(largest, size)
        return largest


def on_circle(start, end, tangent, u):
    """Points of the arc of a circle, or the segment, between two points with that tangent at the first."""
    chord = end - start
    tx, ty = tangent
    theta = np.arctan2(tx * chord[1] - ty * chord[0], tx * chord[0] + ty * chord[1])  # half the turning
    angle = theta * (u - 1)
    ratio = u if abs(theta) < 1e-9 else np.sin(theta * u) / np.sin(theta)
    x = ratio * (chord[0] * np.cos(angle) - chord[1] * np.sin(angle))
    y = ratio * (chord[0] * np.sin(angle) + chord[1] * np.cos(angle))
    return start + np.stack([x, y], axis=1)


def piece_points(segment, u):
    """The points of a piece, as its JSON says, at u (m,) in [0, 1]: long doubles (m, dimension)."""
    u = np.asarray(u, dtype=np.longdouble)
    if "arcs" in segment:
        lengths = number([arc["length"] for arc in segment["arcs"]])
        s, found = u * lengths.sum(), None
        for arc, before in zip(segment["arcs"], np.append(0, np.cumsum(lengths)[:-1])):
            here = helix_points(arc, np.clip(s - before, 0, number(arc["length"])))
            found = here if found is None else np.where((s > before)[:, None], here, found)
        return found
    points = segment["points"]
    if "tangents" in segment:
        first, middle, last = map(number, points)
        one, two = map(number, segment["tangents"])
        before = on_circle(first, middle, one, np.clip(2 * u, 0, 1))
        return np.where((u > 0.5)[:, None], on_circle(middle, last, two, np.clip(2 * u - 1, 0, 1)), before)
    first, last = number(points[0]), number(points[-1])
    if segment["kind"] == "segment":
        return first + u[:, None] * (last - first)
    if segment["kind"] == "cubic":
        one, two = number(points[1]) - first, number(points[2]) - first
        v = 1 - u
        inner = np.outer(3 * v * v * u, one) + np.outer(3 * v * u * u, two)
        return first + inner + np.outer(u**3, last - first)
    middle, w = number(segment["middle"]), number(segment["weight"])
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u * u
    top = np.outer(b1, middle - w * first) + np.outer(b2, last - first)
    return first + top / (b0 + w * b1 + b2)[:, None]


def number(values):
    """Long doubles."""
    return np.array(values, dtype=np.longdouble)


def helix_points(arc, s):
    """The points of an arc of a helix at lengths s: it turns about its axis as it goes along."""
    start, tangent, axis = number(arc["start"]), number(arc["tangent"]), number(arc["axis"])
    rate = np.hypot(number(arc["curvature"]), number(arc["torsion"]))
    if arc["curvature"] == 0:
        return start + np.outer(s, tangent)
    along = np.dot(tangent, axis) * axis
    turned = np.outer(np.sin(rate * s), tangent - along) + np.outer(
        1 - np.cos(rate * s), np.cross(axis, tangent)
    )
    return start + np.outer(s, along) + turned / rate


def evenly(points_at, places, count):
    """The places, and ``count`` others that divide the length, and the turning, of what they lead to."""
    points = points_at(places).astype(float)
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    directions = steps / np.maximum(lengths, 1e-300)[:, None]
    bends = np.linalg.norm(np.diff(directions, axis=0), axis=1)
    bends = 0.5 * (np.append(bends, 0) + np.append(0, bends))
    whole, turning = lengths.sum(), bends.sum()
    density = (
        lengths / max(whole, 1e-300) + bends / max(turning, 1.0) + 0.1 * np.diff(places) / np.ptp(places)
    )
    total = np.append(0, np.cumsum(density))
    new = np.interp(np.linspace(0, total[-1], count), total, places)
    return np.unique(np.concatenate([places, new]))


@dataclass(frozen=True)
class Track:
    """Samples of a set of points: places (m,), the points there (m, dimension), and how to get more."""

    places: np.ndarray
    points: np.ndarray
    at: object

    def distances(self, points, among=1):
        """The distances of points (n, dimension) from the cubics through neighbouring samples.

        Tried are those at so many nearest samples: where a curve comes back to itself the very nearest may be
        on another branch than the nearest point.
        """
        found = np.full(len(points), np.inf)
        for nearest in self.tree.query(points, range(1, among + 1))[1].T:
            found = np.minimum(found, np.linalg.norm(points - self.points[nearest], axis=1))
            for shift in (-1, 0):
                i = np.clip(nearest + shift, 0, len(self.places) - 2)
                found = np.minimum(found, self._from_cubic(points, i))
        return found

    @cached_property
    def tree(self):
        """For the nearest sample."""
        return cKDTree(self.points)

    def _from_cubic(self, points, i):
        """The distances from the part between samples i and i + 1."""
        first = np.clip(i - 1, 0, len(self.places) - 4)
        nodes = self.places[first[:, None] + np.arange(4)]
        low, width = self.places[i], self.places[i + 1] - self.places[i]
        x = (nodes - low[:, None]) / width[:, None]
        values = self.points[first[:, None] + np.arange(4)] - points[:, None, :]
        table = [values[:, 0]]
        for order in (1, 2, 3):
            gaps = (x[:, order:] - x[:, :-order])[..., None]
            values = np.diff(values, axis=1) / gaps
            table.append(values[:, 0])
        chord = np.einsum("ij,ij->i", self.points[i + 1] - self.points[i], points - self.points[i])
        square = (np.diff(self.points, axis=0) ** 2).sum(1)[i]
        u = np.clip(chord / np.maximum(square, 1e-300), 0, 1)
        for _ in range(3):
            away, slope, bend = newton_form(table, x, u)
            fall, steep = (away * slope).sum(1), (slope * slope).sum(1) + (away * bend).sum(1)
            safe = np.where(steep > 0.1 * (slope * slope).sum(1), steep, (slope * slope).sum(1))
            u = np.clip(u - fall / np.maximum(safe, 1e-300), 0, 1)
        return np.linalg.norm(newton_form(table, x, u)[0], axis=1)


def newton_form(table, x, u):
    """(value, first, second derivative) at u of the cubics with these divided differences at the nodes x."""
    a, b, c = (u - x[:, 0])[:, None], (u - x[:, 1])[:, None], (u - x[:, 2])[:, None]
    f0, f1, f2, f3 = table
    return (
        f0 + a * (f1 + b * (f2 + c * f3)),
        f1 + (a + b) * f2 + (a * b + b * c + a * c) * f3,
        2 * f2 + 2 * (a + b + c) * f3,
    )


def one_sided(one, other):
    """The largest distance of a point of one track from the other."""
    found = other.distances(one.points)
    while True:  # only the largest matter
        high = np.flatnonzero(found >= found.max() / 2)
        nearer = np.minimum(found[high], other.distances(one.points[high], AMONG))
        if (nearer == found[high]).all():
            break
        found[high] = nearer
    top = found.max()
    padded = np.concatenate([[-1.0], found, [-1.0]])
    peaks = np.flatnonzero((found >= padded[:-2]) & (found >= padded[2:]) & (found >= HIGH * top))
    peaks = peaks[np.argsort(-found[peaks])][:MOST_PEAKS]
    low, high = one.places[np.maximum(peaks - 1, 0)], one.places[np.minimum(peaks + 1, len(found) - 1)]
    for _ in range(ROUNDS):
        places = low[:, None] + (high - low)[:, None] * np.linspace(0, 1, AGAIN)
        again = other.distances(one.at(places.ravel()), AMONG).reshape(places.shape)
        best = np.clip(np.argmax(again, axis=1), 1, AGAIN - 2)
        rows = np.arange(len(peaks))
        top = max(top, again.max())
        low, high = places[rows, best - 1], places[rows, best + 1]
        d0, d1, d2 = again[rows, best - 1], again[rows, best], again[rows, best + 1]
        bend = 2 * d1 - d0 - d2
        inside = (d1 >= d0) & (d1 >= d2) & (bend > 0)
        gain = np.where(inside, (d2 - d0) ** 2 / (8 * np.where(bend > 0, bend, 1.0)), 0.0)
        highest = (d1 + gain).max()
        if highest <= top * (1 + GAIN):  # else the peak may be a corner, which no parabola fits
            break
    return max(top, float(highest))


def distance(formula, segment, edges, density=1):
    """The Hausdorff distance of a piece and the arc of the curve that it stands for.

    Args:
        formula: the `Formula`.
        segment: a piece of a spline's JSON.
        edges: of `Formula.parts` of the whole curve, or of the arc.
        density: samples, in multiples of the usual number.
    """
    a, b = segment["interval"]
    origin = formula.points([a])[0]
    inside = np.concatenate([[a], edges[(edges > a) & (edges < b)], [b]])
    fine = np.linspace(0, 1, density * max(INNER, SAMPLES // (2 * len(inside))) + 1)[:-1]
    times = np.append((inside[:-1, None] + np.diff(inside)[:, None] * fine).ravel(), b)

    def on_curve(t):
        return (formula.points(t) - origin).astype(float)

    def on_piece(u):
        return (piece_points(segment, u) - origin).astype(float)

    times = evenly(on_curve, np.unique(times), density * SAMPLES)
    places = evenly(on_piece, np.linspace(0, 1, density * SAMPLES + 1), density * SAMPLES)
    curve, piece = Track(times, on_curve(times), on_curve), Track(places, on_piece(places), on_piece)
    return max(one_sided(curve, piece), one_sided(piece, curve))
