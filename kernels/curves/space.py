"""Sampling the user's space curve inside kernels.

The compiled jet of order 3 arrives as the address of ``void(double t, double *out)`` writing
x, x′, x″, x‴, y, …, z‴.  Coordinates are taken relative to an origin and scaled by a power of two, so that
every kernel sees a curve of size about 1; a `Place` says so.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.curves.vectors import Vector, cross, dot, norm, unit
from osculant.kernels.generated.space import frenet
from osculant.kernels.jit import kernel
from osculant.kernels.operations import NOISE, ORIGIN, SCALE

#: doubles a jet of order 3 of a space curve fills
JET_SIZE = 12


class Place(NamedTuple):
    """The kernel's coordinates.

    Attributes:
        x, y, z: their origin, in the user's coordinates.
        scale: of all three, a power of two.
        noise: the absolute error of the scaled coordinates.
    """

    x: float
    y: float
    z: float
    scale: float
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

    point: Vector
    tangent: Vector


class Sample(NamedTuple):
    """α, dα/dt and d²α/dt²."""

    point: Vector
    velocity: Vector
    acceleration: Vector


class Bend(NamedTuple):
    """α, T, κ′N, the speed, κ and κ′ (by arc length); where κ = 0, κ′N is 0."""

    point: Vector
    tangent: Vector
    lean: Vector
    speed: float
    curvature: float
    slope: float


@kernel
def sample(source: Source, t: float) -> Sample:
    """The curve at t, in the kernel's coordinates."""
    place, jet = source.place, source.jet
    call_jet(source.address, t, jet)
    scale = place.scale
    return Sample(
        ((jet[0] - place.x) * scale, (jet[4] - place.y) * scale, (jet[8] - place.z) * scale),
        (jet[1] * scale, jet[5] * scale, jet[9] * scale),
        (jet[2] * scale, jet[6] * scale, jet[10] * scale),
    )


@kernel
def frenet_at(address: int, scale: float, jet: np.ndarray[Any, Any], t: float) -> tuple[float, ...]:
    """Speed, κ, κ′ (by arc length), τ, T and N of the curve times ``scale``; leaves its jet in ``jet``."""
    call_jet(address, t, jet)
    k = scale
    return frenet(
        jet[1] * k, jet[2] * k, jet[3] * k, jet[5] * k, jet[6] * k, jet[7] * k,
        jet[9] * k, jet[10] * k, jet[11] * k,
    )  # fmt: skip


@kernel
def bends(source: Source, t: float) -> Bend:
    """How the curve bends at t, in the kernel's coordinates."""
    place, jet = source.place, source.jet
    k = place.scale
    speed, curvature, slope, _, tx, ty, tz, nx, ny, nz = frenet_at(source.address, k, jet, t)
    point = ((jet[0] - place.x) * k, (jet[4] - place.y) * k, (jet[8] - place.z) * k)
    lean = (0.0, 0.0, 0.0)
    if curvature > 0.0:
        lean = (slope * nx, slope * ny, slope * nz)
    else:
        slope = 0.0
    return Bend(point, (tx, ty, tz), lean, speed, curvature, slope)


@kernel
def frame(source: Source, t: float) -> Frame:
    """Point and unit tangent at t, in the kernel's coordinates."""
    at = sample(source, t)
    return Frame(at.point, unit(at.velocity))


@kernel
def source_of(fit: Any, address: int, place: Place, course: np.ndarray[Any, Any]) -> Source:
    """What samples a curve in space, for any fit."""
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
    square = dot(at.velocity, at.velocity)
    return math.sqrt(square), norm(cross(at.velocity, at.acceleration)) / square


@kernel
def place_in(fit: Any, size: np.ndarray[Any, Any], side: float) -> Place:
    """`osculant.kernels.operations.place_in` for any fit."""
    return Place(size[ORIGIN], size[ORIGIN + 1], size[ORIGIN + 2], size[SCALE], size[NOISE])


@kernel
def frame_in(fit: Any, place: Place, row: np.ndarray[Any, Any], first: int) -> Frame:
    """`osculant.kernels.operations.frame_in` for any fit."""
    k = place.scale
    point = ((row[first] - place.x) * k, (row[first + 1] - place.y) * k, (row[first + 2] - place.z) * k)
    return Frame(point, (row[first + 3], row[first + 4], row[first + 5]))


#: what all fits in space do alike (`osculant.kernels.operations`)
IN_SPACE = {
    "source": source_of,
    "frame": frame_of,
    "pace": pace,
    "dimension": 3,
    "place_in": place_in,
    "frame_in": frame_in,
}
