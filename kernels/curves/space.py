"""Sampling the user's space curve inside kernels.

The compiled jet of order 3 arrives as the address of ``void(double t, double *out)`` writing
x, x′, x″, x‴, y, …, z‴.  Coordinates are taken relative to an origin and scaled by a power of two, so that
every kernel sees a curve of size about 1; ``place`` = (origin x, y, z, scale, noise) says so, noise being
what rounding does to the scaled coordinates.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.curves.plane import call_jet
from osculant.kernels.curves.vectors import Vector, unit
from osculant.kernels.generated.space import frenet
from osculant.kernels.jit import kernel

#: doubles a jet of order 3 of a space curve fills
JET_SIZE = 12

#: (origin x, origin y, origin z, scale, absolute error of the scaled coordinates)
Place = tuple[float, float, float, float, float]
#: (address of the compiled jet, place, scratch space for one jet: `JET_SIZE` doubles)
Source = tuple[int, Place, np.ndarray[Any, Any]]
#: (x, y, z, unit tangent x, y, z)
Frame = tuple[float, float, float, float, float, float]


@kernel
def sample(source: Source, t: float) -> tuple[Vector, Vector, Vector]:
    """α, dα/dt and d²α/dt² at t, in the kernel's coordinates."""
    address, place, jet = source
    call_jet(address, t, jet)
    scale = place[3]
    return (
        ((jet[0] - place[0]) * scale, (jet[4] - place[1]) * scale, (jet[8] - place[2]) * scale),
        (jet[1] * scale, jet[5] * scale, jet[9] * scale),
        (jet[2] * scale, jet[6] * scale, jet[10] * scale),
    )


@kernel
def frenet_at(source: Source, t: float) -> tuple[float, ...]:
    """Speed, κ, κ′ (by arc length), τ, T and N at t, in the kernel's units; leaves the jet in place."""
    address, place, jet = source
    call_jet(address, t, jet)
    k = place[3]
    return frenet(
        jet[1] * k, jet[2] * k, jet[3] * k, jet[5] * k, jet[6] * k, jet[7] * k,
        jet[9] * k, jet[10] * k, jet[11] * k,
    )  # fmt: skip


@kernel
def bends(source: Source, t: float) -> tuple[Vector, Vector, Vector, float, float, float]:
    """α, T, κ′N, the speed, κ and κ′ (by arc length) at t, in the kernel's coordinates.

    Where κ = 0, κ′N is 0.
    """
    found = frenet_at(source, t)
    place, jet, k = source[1], source[2], source[1][3]
    speed, curvature, slope = found[0], found[1], found[2]
    point = ((jet[0] - place[0]) * k, (jet[4] - place[1]) * k, (jet[8] - place[2]) * k)
    lean = (0.0, 0.0, 0.0)
    if curvature > 0.0:
        lean = (slope * found[7], slope * found[8], slope * found[9])
    else:
        slope = 0.0
    return point, (found[4], found[5], found[6]), lean, speed, curvature, slope


@kernel
def frame(source: Source, t: float) -> tuple[Vector, Vector]:
    """Point and unit tangent at t, in the kernel's coordinates."""
    point, velocity, _ = sample(source, t)
    return point, unit(velocity)


@kernel
def placed(place: Place, given: Frame) -> tuple[Vector, Vector]:
    """A frame in the user's coordinates as point and tangent in the kernel's."""
    k = place[3]
    point = ((given[0] - place[0]) * k, (given[1] - place[1]) * k, (given[2] - place[2]) * k)
    return point, (given[3], given[4], given[5])


@kernel
def sample_many(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> None:
    """Jets at all ``times`` (m,) into the rows of ``out`` (m, `JET_SIZE`), in the user's coordinates."""
    for i in range(times.shape[0]):
        call_jet(address, times[i], out[i])
