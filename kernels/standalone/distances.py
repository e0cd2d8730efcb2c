"""Distances of points from a curve, and their feet, for compiled libraries.

The curve is sampled where its course has rows; each sign change of the slope of the distance between two
samples is followed to the nearest point there, if that can be nearer than what is known.  Nothing is proved:
of two nearest points between neighbouring samples one is found.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.bracket import safeguarded
from osculant.kernels.course import LENGTH, TIME, lay_out
from osculant.kernels.curves.jets import call_jet
from osculant.kernels.jit import kernel
from osculant.kernels.operations import dimension, place_in
from osculant.kernels.standalone.divide import measured
from osculant.kernels.standalone.free import SIZE
from osculant.kernels.standalone.precise import Jets
from osculant.kernels.standalone.special import JET
from osculant.kernels.standalone.stretches import DONE, TOO_MUCH, UNDEFINED, WRONG

#: panels at first, rows of the course at most, and samples for each
PANELS, COURSE, PER_ROW = 64, 2048, 2
#: columns of a sample: its parameter, the length up to it, then the point and the velocity
WAY, POINT = 1, 2
COLUMNS = 8
#: Newton steps to one foot, their size that ends them in parts of the parameter, and by how much lengths may
#: be wrong
STEPS, SETTLED, LONGER = 60, 2.0**-52, 1.1
#: what rounding does to a position, in parts of its coordinates
FLAT = 2.0**-48


class Foot(NamedTuple):
    """The distance of a point from the curve in the plane, and the nearest point of the curve, at t."""

    distance: float
    t: float
    x: float
    y: float


class SpaceFoot(NamedTuple):
    """The distance of a point from the curve in space, and the nearest point of the curve, at t."""

    distance: float
    t: float
    x: float
    y: float
    z: float


@kernel
def see(fit: Any, jets: Jets, p: np.ndarray[Any, Any], t: float) -> tuple[float, float, float]:
    """(squared distance of p from the curve at t, half its derivative, half its second derivative)."""
    k = dimension(fit) + 1
    call_jet(jets.address, t, jets.jet)
    square, slope, bend = 0.0, 0.0, 0.0
    for i in range(dimension(fit)):
        away, velocity = jets.jet[k * i] - p[i], jets.jet[k * i + 1]
        square += away * away
        slope += away * velocity
        bend += velocity * velocity + away * jets.jet[k * i + 2]
    return square, slope, bend


@kernel
def slack(square: float, reach: float) -> float:
    """What rounding does to the squared distance of a point whose coordinates add up to ``reach``."""
    distance = math.sqrt(square)
    moved = FLAT * (reach + distance)
    return moved * (distance + moved)


@kernel
def followed(
    fit: Any, jets: Jets, p: np.ndarray[Any, Any], reach: float, low: float, high: float
) -> tuple[float, float]:
    """(squared distance, parameter) of the nearest point between two places, by safeguarded Newton steps.

    Near the foot squares are flat: of places with the same one that with the least slope is the better known.
    """
    t, settled = 0.5 * (low + high), SETTLED * max(abs(low), abs(high))
    least, least_slope, place = math.inf, math.inf, t
    for _ in range(STEPS):
        square, slope, bend = see(fit, jets, p, t)
        equal = abs(square - least) <= slack(square, reach)
        if (not equal and square < least) or (equal and abs(slope) < least_slope):
            least, least_slope, place = square, abs(slope), t
        step = -slope / bend if bend > 0.0 else math.nan
        if abs(step) <= settled or high - low <= settled:
            break
        t, low, high = safeguarded(t, step, slope > 0.0, low, high)
    return least, place


@kernel
def sampled(fit: Any, jets: Jets, course: np.ndarray[Any, Any], samples: np.ndarray[Any, Any]) -> int:
    """Fill ``samples`` from the rows of a course; returns how many there are."""
    k, count = dimension(fit) + 1, 0
    for i in range(course.shape[0]):
        parts = 1 if i == 0 else PER_ROW
        for part in range(1, parts + 1):
            t, way = course[i, TIME], course[i, LENGTH]
            if part < parts:
                share = part / parts
                t = course[i - 1, TIME] + (t - course[i - 1, TIME]) * share
                way = course[i - 1, LENGTH] + (way - course[i - 1, LENGTH]) * share
            call_jet(jets.address, t, jets.jet)
            row = samples[count]
            row[0], row[WAY] = t, way
            for j in range(dimension(fit)):
                row[POINT + j], row[POINT + dimension(fit) + j] = jets.jet[k * j], jets.jet[k * j + 1]
            count += 1
    return count


@kernel
def nearest(
    fit: Any, jets: Jets, p: np.ndarray[Any, Any], samples: np.ndarray[Any, Any]
) -> tuple[float, float]:
    """(squared distance, parameter) of the nearest point that is found from the samples."""
    n = dimension(fit)
    reach = 0.0
    for j in range(n):
        reach += abs(p[j])
    least, place = math.inf, samples[0, 0]
    for i in range(samples.shape[0]):
        square = 0.0
        for j in range(n):
            square += (samples[i, POINT + j] - p[j]) ** 2
        if square < least:
            least, place = square, samples[i, 0]
    square_before, slope_before = math.inf, 0.0
    for i in range(samples.shape[0]):
        square, slope = 0.0, 0.0
        for j in range(n):
            away = samples[i, POINT + j] - p[j]
            square += away * away
            slope += away * samples[i, POINT + n + j]
        if i > 0 and slope_before <= 0.0 and slope >= 0.0:
            way = LONGER * (samples[i, WAY] - samples[i - 1, WAY])
            if math.sqrt(min(square, square_before)) - way <= math.sqrt(least):
                found, t = followed(fit, jets, p, reach, samples[i - 1, 0], samples[i, 0])
                if found <= least + slack(found, reach):
                    least, place = found, t
        square_before, slope_before = square, slope
    return least, place


@kernel
def distances(
    fit: Any, address: int, low: float, high: float, units: np.ndarray[Any, Any],
    points: np.ndarray[Any, Any], out: np.ndarray[Any, Any],
) -> int:  # fmt: skip
    """The distances of all ``points`` (m, dimension) and their feet into ``out``; returns how it went.

    Args:
        fit: the record of chords in the curve's dimension.
        address: of the jet that kernels take.
        low: one end of the interval,
        high: and the other.
        units: see `osculant.kernels.standalone.divide.measured`.
        points: in the user's coordinates.
        out: (m, 2 + dimension).
    """
    if not (high - low > 0.0 and high - low < math.inf):
        return WRONG
    jets = Jets(address, address, dimension(fit), address, False, np.empty(JET), np.empty(1))
    size, edges, room = np.empty(SIZE), np.empty(PANELS + 1), np.empty((COURSE, 3))
    if not measured(fit, jets, low, high, units, 1, size):
        return UNDEFINED
    for i in range(PANELS + 1):
        edges[i] = high if i == PANELS else low + (high - low) * i / PANELS
    rows = lay_out(fit, address, place_in(fit, size, 1.0), edges, room)
    if rows < 0:
        return TOO_MUCH
    samples_room = np.empty((COURSE * PER_ROW, COLUMNS))
    course = room[:rows]
    for i in range(rows):
        course[i, LENGTH] /= size[0]
    samples = samples_room[: sampled(fit, jets, course, samples_room)]
    k = dimension(fit) + 1
    for i in range(points.shape[0]):
        square, t = nearest(fit, jets, points[i], samples)
        call_jet(address, t, jets.jet)
        out[i, 0], out[i, 1] = math.sqrt(square), t
        for j in range(dimension(fit)):
            out[i, 2 + j] = jets.jet[k * j]
    return DONE
