"""Rows of bihelices as pieces."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from osculant.kernels.bihelices.helix import HELIX_SIZE
from osculant.kernels.curves.space import Place
from osculant.kernels.curves.vectors import cross
from osculant.kernels.jit import kernel
from osculant.kernels.operations import SHAPE, A, B


class Helices(NamedTuple):
    """Two helical arcs, for the parameters [a, b]; t is the curve's in the junction's normal plane.

    Each has its start p, unit tangent t, axis v (a unit vector), curvature κ, torsion τ and length, and its
    points are α(s) = p + s⟨t,v⟩v + (sin βs/β)(t − ⟨t,v⟩v) + ((1 − cos βs)/β)v×t with β² = κ² + τ²; where β
    is 0 it is a segment.
    """

    a: float
    b: float
    error: float
    t: float
    px0: float
    py0: float
    pz0: float
    tx0: float
    ty0: float
    tz0: float
    vx0: float
    vy0: float
    vz0: float
    curvature0: float
    torsion0: float
    length0: float
    px1: float
    py1: float
    pz1: float
    tx1: float
    ty1: float
    tz1: float
    vx1: float
    vy1: float
    vz1: float
    curvature1: float
    torsion1: float
    length1: float


@kernel
def axis(row: np.ndarray[Any, Any], first: int) -> tuple[float, float, float]:
    """The axis V = T₀×(V×T₀) + ⟨V,T₀⟩T₀ of the helix in a row from ``first`` on; of a segment its tangent."""
    tangent = (row[first + 3], row[first + 4], row[first + 5])
    rate = row[first + 12]
    if rate == 0.0:
        return tangent
    x, y, z = cross(tangent, (row[first + 9], row[first + 10], row[first + 11]))
    part = row[first + 16] / rate
    x, y, z = x + part * tangent[0], y + part * tangent[1], z + part * tangent[2]
    size = math.sqrt(x * x + y * y + z * z)
    return x / size, y / size, z / size


@kernel
def of_bihelix(fit: Any, row: np.ndarray[Any, Any], place: Place, error: float) -> Helices:
    """The piece of a row, which is in the user's coordinates."""
    i = SHAPE + 3
    j = i + HELIX_SIZE
    ux, uy, uz = axis(row, i)
    vx, vy, vz = axis(row, j)
    return Helices(
        row[A], row[B], error, row[SHAPE],
        row[i], row[i + 1], row[i + 2], row[i + 3], row[i + 4], row[i + 5], ux, uy, uz,
        row[i + 15], row[i + 16], row[i + 13],
        row[j], row[j + 1], row[j + 2], row[j + 3], row[j + 4], row[j + 5], vx, vy, vz,
        row[j + 15], row[j + 16], row[j + 13],
    )  # fmt: skip
