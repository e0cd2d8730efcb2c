"""The one checker for all: splines as rational cubics, how far they are from a curve, how smooth they are.

Arcs of circles and of conics, parabolas, segments and cubics are all rational Bézier cubics, exactly but for
rounding.  Errors are distances both ways, of dense points of the curve and of the spline, by Newton's method.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import cKDTree

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: points of a whole curve, and of its approximation
POINTS = 20_000
#: steps towards a nearest point
STEPS = 4
#: parameters (m,) → points and two derivatives at least, shape (3, 2, m)
Jets = Callable[["Floats"], "Floats"]
Point = Sequence[float]


def bezier(*controls: Point) -> Floats:
    """A polynomial Bézier curve of degree 1 to 3 as a rational cubic, shape (4, 3): (wx, wy, w)."""
    return elevated(np.array([(x, y, 1.0) for x, y in controls]))


def elevated(controls: Floats) -> Floats:
    """Homogeneous controls (k + 1, 3), k ≤ 3, of the same curve as a cubic."""
    while len(controls) < 4:
        k = len(controls)
        part = np.arange(1, k)[:, None] / k
        inner = part * controls[:-1] + (1 - part) * controls[1:]
        controls = np.concatenate([controls[:1], inner, controls[-1:]])
    return controls


def arc(start: Point, middle: Point, end: Point) -> Floats:
    """The arc of a circle from one point to another whose middle is given."""
    (x0, y0), (x, y), (x2, y2) = start, middle, end
    chord = math.dist(start, end)
    rise = 2 * math.dist(middle, ((x0 + x2) / 2, (y0 + y2) / 2)) / chord  # tan of a quarter of its turning
    w = (1 - rise * rise) / (1 + rise * rise)
    control = ((1 + w) * x - (x0 + x2) / 2, (1 + w) * y - (y0 + y2) / 2, w)
    return elevated(np.array([(x0, y0, 1.0), control, (x2, y2, 1.0)]))


def of_pieces(pieces: Sequence[Any]) -> Floats:
    """Pieces of osculant's splines in the plane as rational cubics, shape (arcs, 4, 3)."""
    made = []
    for one in (own for piece in pieces for own in piece.arcs):
        if one.kind == "cubic":
            made.append(bezier(one.start, *one.controls, one.end))
        else:
            rows = [(*one.start, 1.0), (*one.middle, one.weight), (*one.end, 1.0)]
            made.append(elevated(np.array(rows)))
    return np.array(made)


def jets(cubics: Floats, at: Floats, piece: Any = None) -> Floats:
    """Points and two derivatives, (3, 2, m), of consecutive rational cubics, the i-th from i to i + 1."""
    piece = np.clip(at.astype(int), 0, len(cubics) - 1) if piece is None else piece
    u, (p, q, r, s) = (at - piece)[:, None], cubics[piece].transpose(1, 0, 2)
    one, two, three = q - p, r - q, s - r
    v = 1 - u
    point = p + one * (1 - v**3) + two * (3 * v * u * u + u**3) + three * u**3
    rate = 3 * (one * v * v + 2 * two * u * v + three * u * u)
    bend = 6 * ((two - one) * v + (three - two) * u)
    w, dw, ddw = point[:, 2:], rate[:, 2:], bend[:, 2:]
    x = point[:, :2] / w
    dx = (rate[:, :2] - x * dw) / w
    ddx = (bend[:, :2] - 2 * dx * dw - x * ddw) / w
    return np.stack([x.T, dx.T, ddx.T])


def error(curve: Any, cubics: Floats) -> float:
    """The larger of the distances of points of either, a curve and a spline (n, 4, 3), from the other."""
    t, u = np.linspace(*curve.interval, POINTS), np.linspace(0, len(cubics), POINTS)
    there: list[Jets] = [lambda at: curve.jets(at).transpose(2, 1, 0), lambda at: jets(cubics, at)]
    return max(_away(*there, u, t), _away(*reversed(there), t, u))


def _away(onto: Jets, source: Jets, at: Floats, near: Floats) -> float:
    """The largest distance of a source's points from their nearest ones, by Newton's method from samples."""
    points, low, high = source(at)[0].T, near[0], near[-1]
    t = near[cKDTree(onto(near)[0].T).query(points)[1]]
    for _ in range(STEPS):
        p, rate, bend = onto(t)[:3]
        off = p - points.T
        slope = (rate * rate).sum(0) + (off * bend).sum(0)
        t = np.clip(t - (off * rate).sum(0) / np.where(slope > 0, slope, np.inf), low, high)
    return float(np.hypot(*(onto(t)[0] - points.T)).max())


def jump(cubics: Floats) -> float:
    """The largest angle between tangents where two curves meet, in radians."""
    if len(cubics) < 2:
        return 0.0
    before = np.arange(len(cubics) - 1)
    (x, y), (u, v) = jets(cubics, before + 1.0, before)[1], jets(cubics, before + 1.0, before + 1)[1]
    return float(np.abs(np.arctan2(x * v - y * u, x * u + y * v)).max())
