"""Invariants and frames of a curve at many parameters, for compiled libraries."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.curves.vectors import cross
from osculant.kernels.generated.invariants import invariants
from osculant.kernels.generated.space import frenet
from osculant.kernels.jit import kernel

#: derivatives that they take, in the plane and in space
PLANE_ORDER, SPACE_ORDER = 5, 3


class PlaneInvariants(NamedTuple):
    """The point (x, y), the unit tangent (tx, ty) and the invariants of a plane curve at t.

    speed is ds/dt, curvature κ, positive where the curve turns left, curvature_slope dκ/ds, affine_speed
    dr/dt, affine_curvature k and affine_curvature_slope dk/dr; infinite or NaN where they do not exist.
    """

    t: float
    x: float
    y: float
    tx: float
    ty: float
    speed: float
    curvature: float
    curvature_slope: float
    affine_speed: float
    affine_curvature: float
    affine_curvature_slope: float


class SpaceInvariants(NamedTuple):
    """The point, the Frenet frame T, N, B and the invariants of a space curve at t.

    speed is ds/dt, curvature κ, torsion τ, positive for a right-handed helix, and curvature_slope dκ/ds;
    infinite or NaN where they do not exist.
    """

    t: float
    x: float
    y: float
    z: float
    tx: float
    ty: float
    tz: float
    nx: float
    ny: float
    nz: float
    bx: float
    by: float
    bz: float
    speed: float
    curvature: float
    torsion: float
    curvature_slope: float


@kernel
def in_the_plane(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> int:
    """The invariants at all ``times`` (m,) into the rows of ``out``, from a jet of order `PLANE_ORDER`."""
    jet = np.empty(2 * (PLANE_ORDER + 1))
    for i in range(times.shape[0]):
        t = times[i]
        call_jet(address, t, jet)
        speed, bend, slope, affine, k, rate = invariants(
            jet[1], jet[2], jet[3], jet[4], jet[5], jet[7], jet[8], jet[9], jet[10], jet[11]
        )
        found = PlaneInvariants(
            t, jet[0], jet[6], jet[1] / speed, jet[7] / speed, speed, bend, slope, affine, k, rate
        )
        row = out[i]
        for j, value in enumerate(found):
            row[j] = value
    return 0


@kernel
def in_space(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> int:
    """The invariants at all ``times`` (m,) into the rows of ``out``, from a jet of order `SPACE_ORDER`."""
    jet = np.empty(3 * (SPACE_ORDER + 1))
    for i in range(times.shape[0]):
        t = times[i]
        call_jet(address, t, jet)
        speed, bend, slope, torsion, tx, ty, tz, nx, ny, nz = frenet(
            jet[1], jet[2], jet[3], jet[5], jet[6], jet[7], jet[9], jet[10], jet[11]
        )
        bx, by, bz = cross((tx, ty, tz), (nx, ny, nz))
        found = SpaceInvariants(
            t, jet[0], jet[4], jet[8], tx, ty, tz, nx, ny, nz, bx, by, bz, speed, bend, torsion, slope
        )
        row = out[i]
        for j, value in enumerate(found):
            row[j] = value
    return 0
