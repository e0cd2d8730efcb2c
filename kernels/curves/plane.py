"""Sampling the user's curve inside kernels.

The compiled jet arrives as the address of ``void(double t, double *out)`` writing
x, x′, x″, y, y′, y″.  Coordinates are taken relative to an origin, scaled by a power of two and, where the
curve bends to the right, mirrored, so that every kernel sees a curve of size about 1 that bends to
the left; a `Place` says so.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.jit import kernel
from osculant.kernels.operations import NOISE, ORIGIN, SCALE

#: doubles a jet of order 2 of a plane curve fills
JET_SIZE = 6


class Place(NamedTuple):
    """The kernel's coordinates.

    Attributes:
        x, y: their origin, in the user's coordinates.
        scale: of both, a power of two.
        side: 1, or −1 where y is mirrored as the curve bends to the right.
        noise: the absolute error of the scaled coordinates.
    """

    x: float
    y: float
    scale: float
    side: float
    noise: float


class Source(NamedTuple):
    """What samples the curve: the compiled jet's address, the place, room for one jet, and its course.

    The course (`osculant.kernels.course`) tells where to look; it has no rows where that does not matter.
    """

    address: int
    place: Place
    jet: np.ndarray[Any, Any]
    course: np.ndarray[Any, Any]


class Frame(NamedTuple):
    """A point of the curve and its unit tangent."""

    x: float
    y: float
    tx: float
    ty: float


class Sample(NamedTuple):
    """Position, unit tangent, speed |α′| and curvature."""

    x: float
    y: float
    tx: float
    ty: float
    speed: float
    curvature: float


@kernel
def sample(source: Source, t: float) -> Sample:
    """The curve at t, in the kernel's coordinates."""
    place, jet = source.place, source.jet
    call_jet(source.address, t, jet)
    scale = place.scale
    rise = scale * place.side
    x, y = (jet[0] - place.x) * scale, (jet[3] - place.y) * rise
    dx, dy = jet[1] * scale, jet[4] * rise
    speed = math.sqrt(dx * dx + dy * dy)
    curvature = (dx * jet[5] * rise - dy * jet[2] * scale) / (speed * speed * speed)
    return Sample(x, y, dx / speed, dy / speed, speed, curvature)


@kernel
def frame(source: Source, t: float) -> Frame:
    """The frame of the curve at t."""
    at = sample(source, t)
    return Frame(at.x, at.y, at.tx, at.ty)


@kernel
def source_of(fit: Any, address: int, place: Place, course: np.ndarray[Any, Any]) -> Source:
    """What samples a curve in the plane, for any fit."""
    return Source(address, place, np.empty(JET_SIZE), course)


@kernel
def alone(address: int, place: Place) -> Source:
    """What samples a curve without a course."""
    return Source(address, place, np.empty(JET_SIZE), np.empty((0, 3)))


@kernel
def frame_at(address: int, place: Place, t: float) -> Frame:
    """The frame at t of the curve whose compiled jet is at the address."""
    return frame(alone(address, place), t)


@kernel
def frame_of(fit: Any, source: Source, t: float) -> Frame:
    """`frame` for any fit."""
    return frame(source, t)


@kernel
def pace(fit: Any, source: Source, t: float) -> tuple[float, float]:
    """(speed, turning of the tangent per unit of the parameter) at t."""
    at = sample(source, t)
    return at.speed, abs(at.curvature) * at.speed


@kernel
def place_in(fit: Any, size: np.ndarray[Any, Any], side: float) -> Place:
    """`osculant.kernels.operations.place_in` for any fit."""
    return Place(size[ORIGIN], size[ORIGIN + 1], size[SCALE], side, size[NOISE])


@kernel
def frame_in(fit: Any, place: Place, row: np.ndarray[Any, Any], first: int) -> Frame:
    """`osculant.kernels.operations.frame_in` for any fit."""
    x, y = (row[first] - place.x) * place.scale, (row[first + 1] - place.y) * place.scale
    return Frame(x, y * place.side, row[first + 2], row[first + 3] * place.side)


@kernel
def user_point(place: Place, x: float, y: float) -> tuple[float, float]:
    """A point in the user's coordinates."""
    back = 1.0 / place.scale
    return x * back + place.x, y * back * place.side + place.y


#: what all fits in the plane do alike (`osculant.kernels.operations`)
IN_THE_PLANE = {
    "source": source_of,
    "frame": frame_of,
    "pace": pace,
    "dimension": 2,
    "place_in": place_in,
    "frame_in": frame_in,
}
