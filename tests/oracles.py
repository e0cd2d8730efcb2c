"""Independent checks, dense and slow on purpose: they share no code with what they check."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

Curve = Callable[[np.ndarray], Any]  # t -> (x, y), vectorised

NEWTON_STEPS = 12
GOLDEN_STEPS = 26  # of (√5−1)/2 each: a bracket shrinks by 4e-6, a value near its maximum is good to 1e-11
CANDIDATES = 24  # local maxima refined, the largest first


@dataclass(frozen=True)
class Track:
    """A curve over [0, N], smooth between integers.

    Attributes:
        at: parameters (m,) to points (m, 2).
        parameters: the sampled ones.
        points: their points.
        tree: for the nearest of them.
    """

    at: Callable[[np.ndarray], np.ndarray]
    parameters: np.ndarray
    points: np.ndarray
    tree: cKDTree


def hausdorff(
    curve: Curve, pieces: Sequence[Any], knots: Sequence[float] | None = None, density: int = 128
) -> float:
    """Return the two-sided Hausdorff distance between a curve and a chain of conic pieces.

    Both are sampled densely on each piece's interval; each sample's nearest point on the other one is found
    by a k-d tree and then Newton's method along it (golden section where that does not settle, as at cusps);
    the largest local maxima of the distances are refined by golden section. Good to about 1e-6 of the result
    or to the rounding of coordinates, as long as the distance has no maximum narrower than 1/density of a
    piece.

    Args:
        curve: t -> (x, y), for arrays t; a coordinate may be a constant.
        pieces: objects with `interval`, `start`, `end`, `middle` and `weight`, as in
            `osculant.pieces.conics`.
        knots: N+1 parameters; by default those of the pieces. They only steer the sampling.
        density: samples on each piece, of both curves.
    """
    if knots is None:
        knots = [pieces[0].interval[0], *(piece.interval[1] for piece in pieces)]
    first = _track(_by_knots(curve, np.array(knots, dtype=float)), len(pieces), density)
    second = _track(_conics(pieces), len(pieces), density)
    return max(directed(first, second), directed(second, first))


def directed(one: Track, other: Track) -> float:
    """Return the largest distance from a point of one track to the other."""
    t = one.parameters
    distance, foot = project(one.points, other, None)
    rises = np.r_[True, distance[1:] >= distance[:-1]]
    falls = np.r_[distance[:-1] >= distance[1:], True]
    peaks = np.flatnonzero(rises & falls)
    peaks = peaks[np.argsort(-distance[peaks])][:CANDIDATES]
    low, high = t[np.maximum(peaks - 1, 0)], t[np.minimum(peaks + 1, len(t) - 1)]

    def at(s: np.ndarray) -> np.ndarray:
        points = one.at(s)
        near = project(points, other, foot[peaks])[0]
        return np.minimum(near, project(points, other, None)[0])

    return max(float(distance.max()), float(golden(at, low, high).max()))


def project(points: np.ndarray, track: Track, start: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """Return the distance of points to a track, and the parameters of the feet.

    Gauss–Newton along the track from the nearest sample (or from given parameters), keeping the best point
    seen; golden section around it for points that have not settled. Never below the true distance.
    """
    s = track.parameters[track.tree.query(points)[1]] if start is None else start.copy()
    end = track.parameters[-1]
    step = 1e-6
    best, foot, slip = np.full(len(points), np.inf), s.copy(), np.zeros(len(points))
    for _ in range(NEWTON_STEPS):
        here = track.at(s)
        gap = points - here
        distance = np.hypot(gap[:, 0], gap[:, 1])
        better = distance < best
        best[better], foot[better] = distance[better], s[better]
        back, forth = np.maximum(s - step, 0), np.minimum(s + step, end)
        speed = (track.at(forth) - track.at(back)) / (forth - back)[:, None]
        fast = np.maximum(np.hypot(speed[:, 0], speed[:, 1]), 1e-150)
        move = (gap * speed).sum(axis=1) / fast**2
        target = np.clip(s + np.clip(move, -0.1, 0.1), 0, end)
        slip, s = np.abs(target - s) * fast, target
    loose = np.flatnonzero(slip > 1e-4 * best + 1e-14 * np.abs(points).max())
    if len(loose):
        width = track.parameters[1]

        def nearness(s: np.ndarray) -> np.ndarray:
            gap = points[loose] - track.at(s)
            return -np.hypot(gap[:, 0], gap[:, 1])

        low, high = np.maximum(foot[loose] - width, 0), np.minimum(foot[loose] + width, end)
        best[loose] = np.minimum(best[loose], -golden(nearness, low, high))
    return best, foot


def golden(function: Callable[[np.ndarray], np.ndarray], low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Return the greatest values that golden section finds in brackets, all at once."""
    ratio = (5**0.5 - 1) / 2
    left, right = high - ratio * (high - low), low + ratio * (high - low)
    at_left, at_right = function(left), function(right)
    best = np.maximum(at_left, at_right)
    for _ in range(GOLDEN_STEPS):
        lower = at_left < at_right  # the maximum is on the right
        low, high = np.where(lower, left, low), np.where(lower, high, right)
        left, right = (
            np.where(lower, right, high - ratio * (high - low)),
            np.where(lower, low + ratio * (high - low), left),
        )
        new = function(np.where(lower, right, left))
        at_left, at_right = np.where(lower, at_right, new), np.where(lower, new, at_left)
        best = np.maximum(best, new)
    return best


def _track(at: Callable[[np.ndarray], np.ndarray], n: int, density: int) -> Track:
    parameters = np.linspace(0, n, n * density + 1)
    points = at(parameters)
    return Track(at, parameters, points, cKDTree(points))


def _by_knots(curve: Curve, knots: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Return the curve over [0, N], affine between its knots."""

    def at(s: np.ndarray) -> np.ndarray:
        x, y = curve(np.interp(s, np.arange(len(knots)), knots))
        return np.stack([np.broadcast_to(x, s.shape), np.broadcast_to(y, s.shape)], axis=-1).astype(float)

    return at


def _conics(pieces: Sequence[Any]) -> Callable[[np.ndarray], np.ndarray]:
    """Return the chain of conics over [0, N], each in its own Bézier parameter."""
    start, middle, end = (np.array([getattr(p, name) for p in pieces]) for name in ("start", "middle", "end"))
    weight = np.array([p.weight for p in pieces])[:, None]
    # Reckoned from each piece's first point, so that a distant origin costs no figures.
    middle, end = middle - weight * start, end - start

    def at(s: np.ndarray) -> np.ndarray:
        i = np.clip(s.astype(int), 0, len(pieces) - 1)
        u = (s - i)[:, None]
        b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
        return start[i] + (b1 * middle[i] + b2 * end[i]) / (b0 + weight[i] * b1 + b2)

    return at
