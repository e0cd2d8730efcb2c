"""How far a path is from a curve, and the area between: measured on the path's own numbers.

Both are sampled along each stroke and the arc of the curve it stands for, every sample's foot on the other
one is found nearby, and the largest distances are looked at again between the samples. A foot that is not
the nearest makes a distance larger, never smaller, so that a path is not called nearer than its samples are.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from osculant.files.strokes import Path
    from osculant.pieces.piece import Floats

#: samples of a stroke, and of the arc of the curve it stands for
STROKE, ARC = 17, 33
#: steps towards a foot, peaks that are looked at again, and how often
STEPS, PEAKS, LOOKS = 12, 12, 3
#: relative to the window of a foot: the step of a derivative, and a step that is none
DIFFERENCE, SETTLED = 1e-5, 1e-7
#: a stroke beside the nearest one is looked at if its samples are not farther by this
FARTHER = 3.0
#: the largest distances are made sure of: so many at once, so often at most, by so many samples of a stroke
BATCH, BATCHES, FINE = 16, 100, 259

Follow = Callable[["Floats"], "Floats"]
Whole = np.ndarray[Any, np.dtype[np.integer[Any]]]


class _Side(NamedTuple):
    """One of both curves, with samples by rows: a row is a stroke, or its arc."""

    at: Follow
    parameters: Floats
    points: Floats


def distance(path: Path, follow: Follow, ends: Sequence[float]) -> float:
    """The two-sided distance of a path and the curve it stands for.

    Args:
        path: the strokes.
        follow: the curve's points at parameters.
        ends: the parameters where strokes begin and end, one more than there are strokes.

    Infinite if the curve has no points at some of its parameters.
    """
    drawn, curve = _sides(path, follow, ends)
    if not np.isfinite(curve.points).all():
        return math.inf
    return max(_directed(drawn, curve), _directed(curve, drawn))


def area(path: Path, follow: Follow, ends: Sequence[float]) -> float:
    """The area between a path and the curve it stands for, all of it positive: no less, up to quadrature.

    Arguments are those of `distance`.
    """
    drawn, curve = _sides(path, follow, ends)
    rows = np.arange(path.count).repeat(STROKE)
    gaps, _ = _feet(drawn.points.reshape(-1, path.dimension), rows, curve)
    steps = np.linalg.norm(np.diff(drawn.points, axis=1), axis=2)
    heights = gaps.reshape(path.count, STROKE)
    return float((np.maximum(heights[:, 1:], heights[:, :-1]) * steps).sum())


def _sides(path: Path, follow: Follow, ends: Sequence[float]) -> tuple[_Side, _Side]:
    """The path and the curve, with samples."""
    firsts = np.arange(path.count, dtype=float)[:, None]
    bounds = np.asarray(ends, dtype=float)
    drawn = firsts + np.linspace(0, 1, STROKE)
    along = bounds[:-1, None] + np.linspace(0, 1, ARC) * np.diff(bounds)[:, None]
    on_path = path.on(np.arange(path.count).repeat(STROKE), np.tile(np.linspace(0, 1, STROKE), path.count))
    return (
        _Side(path.at, drawn, on_path.reshape(path.count, STROKE, -1)),
        _Side(follow, along, follow(along.ravel()).reshape(path.count, ARC, -1)),
    )


def _directed(one: _Side, other: _Side) -> float:
    """The largest distance of a point of one side from the other."""
    count, samples, dimension = one.points.shape
    rows = np.arange(count).repeat(samples)
    gaps, _ = _feet(one.points.reshape(-1, dimension), rows, other)
    best = float(gaps.max())
    gaps = gaps.reshape(count, samples)
    peaks = gaps.argmax(axis=1)
    chosen = np.argsort(gaps.max(axis=1))[-PEAKS:]
    middle = one.parameters[chosen, peaks[chosen]]
    width = (one.parameters[chosen, -1] - one.parameters[chosen, 0]) / (samples - 1)
    for _ in range(LOOKS):
        around = middle[:, None] + np.linspace(-1, 1, samples) * width[:, None]
        around = np.clip(around, one.parameters[chosen, :1], one.parameters[chosen, -1:])
        points = one.at(around.ravel())
        gaps, _ = _feet(points, chosen.repeat(samples), other)
        gaps = gaps.reshape(len(chosen), samples)
        best = max(best, float(np.nanmax(gaps)))
        middle = around[np.arange(len(chosen)), gaps.argmax(axis=1)]
        width = width * 2 / (samples - 1)
    return best


def _feet(points: Floats, rows: Whole, other: _Side) -> tuple[Floats, Floats]:
    """The distances of points from the other side, and the parameters of the feet.

    Args:
        points: of shape (m, dimension).
        rows: the stroke each belongs to; feet are sought on it and its neighbours.
        other: the side where the feet are.
    """
    count, _, _ = other.points.shape
    best, feet = np.full(len(points), np.inf), np.empty(len(points))
    nearest = np.full(len(points), np.inf)

    def look(chosen: Whole, start: Floats, near: Whole, gap: Floats) -> None:
        """Descend to feet on those strokes from parameters that are so far away."""
        low, high = other.parameters[near][:, [0, -1]].T
        gap, foot = _descend(points[chosen], other.at, start, low, high, gap)
        closer = np.flatnonzero(gap < best[chosen])
        closer = closer[np.argsort(-gap[closer])]  # a point may be there several times: the least is last
        best[chosen[closer]], feet[chosen[closer]] = gap[closer], foot[closer]

    for shift in (0, -1, 1) if count > 1 else (0,):
        near = np.clip(rows + shift, 0, count - 1)
        gaps = np.linalg.norm(other.points[near] - points[:, None], axis=2)
        sample = gaps.argmin(axis=1)
        gap, start = gaps[np.arange(len(points)), sample], other.parameters[near, sample]
        nearest = np.minimum(nearest, gap)
        worth = np.flatnonzero(gap <= FARTHER * nearest)
        look(worth, start[worth], near[worth], gap[worth])
    sure = np.zeros(len(points), dtype=bool)
    for _ in range(BATCHES):
        chosen = np.argsort(best)[-BATCH:]
        chosen = chosen[~sure[chosen]]
        if not len(chosen) or sure[best.argmax()]:
            break
        for shift in (0, -1, 1) if count > 1 else (0,):
            near = np.clip(rows[chosen] + shift, 0, count - 1)
            which, start, gap = _valleys(points[chosen], best[chosen], near, other)
            look(chosen[which], start, near[which], gap)
        sure[chosen] = True
    return best, feet


def _valleys(points: Floats, best: Floats, near: Whole, other: _Side) -> tuple[Whole, Floats, Floats]:
    """Where else feet may be: (which point, parameter, distance) at and beside the minima of many samples.

    Where a curve turns sharply, the nearest of few samples may lie on another branch than the foot.

    Args:
        points: of shape (m, dimension).
        best: how near feet are known; only what may be nearer is told.
        near: a stroke for each point.
        other: the side where feet are sought.
    """
    low, high = other.parameters[near][:, [0, -1]].T
    times = low[:, None] + np.linspace(0, 1, FINE)[1:-1] * (high - low)[:, None]
    places = other.at(times.ravel()).reshape(len(points), FINE - 2, -1)
    gaps = np.linalg.norm(places - points[:, None], axis=2)
    steps = np.linalg.norm(np.diff(places, axis=1), axis=2)
    reach = np.maximum(np.pad(steps, ((0, 0), (1, 0))), np.pad(steps, ((0, 0), (0, 1))))
    beyond = np.pad(gaps, ((0, 0), (1, 1)), constant_values=np.inf)
    minima = (gaps <= beyond[:, :-2]) & (gaps <= beyond[:, 2:]) & (gaps - reach < best[:, None])
    which, sample = np.nonzero(minima)
    which = which.repeat(3)
    sample = np.clip(sample[:, None] + (-1, 0, 1), 0, FINE - 3).ravel()
    return which, times[which, sample], gaps[which, sample]


def _descend(
    points: Floats, at: Follow, start: Floats, low: Floats, high: Floats, gaps: Floats
) -> tuple[Floats, Floats]:
    """Gauss–Newton's steps towards feet in [low, high], shorter ones where they lead away.

    Args:
        points: of shape (m, dimension).
        at: the other curve.
        start: parameters on it, one for each point.
        low: the least parameters of the feet.
        high: the largest.
        gaps: the distances at the start.
    """
    best, feet = gaps.copy(), start.copy()
    h, least = DIFFERENCE * (high - low), SETTLED * (high - low)
    # a parameter that is a whole number belongs to the next stroke: stay on this one
    low, high = low + 1e-12 * (high - low), high - 1e-12 * (high - low)
    going = np.arange(len(points))
    damping, move, fresh = np.ones(len(points)), np.zeros(len(points)), np.ones(len(points), dtype=bool)
    for _ in range(STEPS):
        if not len(going):
            break
        s, p, a, b = feet[going], points[going], low[going], high[going]
        new = fresh[going]
        back, forth = np.clip(s - h[going], a, b), np.clip(s + h[going], a, b)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            speed = (at(forth) - at(back)) / (forth - back)[:, None]
            newton = ((p - at(s)) * speed).sum(axis=1) / (speed * speed).sum(axis=1)
        move[going] = np.where(new, np.nan_to_num(newton, nan=0.0, posinf=0.0, neginf=0.0), move[going])
        trial = np.clip(s + damping[going] * move[going], a, b)
        gap = np.linalg.norm(p - at(trial), axis=1)
        better = gap < best[going]
        steps = np.where(better, np.abs(trial - s), damping[going] * np.abs(move[going]) / 4)
        best[going], feet[going] = np.where(better, gap, best[going]), np.where(better, trial, s)
        fresh[going], damping[going] = better, np.where(better, 1.0, damping[going] / 4)
        going = going[steps > least[going]]
    return best, feet
