"""Differential invariants of a plane curve at many parameter values, in machine code."""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.curves.jets import call_jet
from osculant.kernels.generated.invariants import invariants
from osculant.kernels.jit import kernel

#: derivatives 0…5 of two coordinates
JET_SIZE = 12
#: what the columns of `invariants_at` hold
COLUMNS = (
    "speed",
    "curvature",
    "curvature_slope",
    "affine_speed",
    "affine_curvature",
    "affine_curvature_slope",
)


@kernel
def invariants_at(address: int, times: np.ndarray[Any, Any], out: np.ndarray[Any, Any]) -> None:
    """The invariants of `generated.invariants` at all ``times`` (m,) into the rows of ``out`` (m, 6).

    ``address`` is a compiled jet of order 5.  `COLUMNS` names the columns; infinite or NaN where an
    invariant does not exist.
    """
    jet = np.empty(JET_SIZE)
    for i in range(times.shape[0]):
        call_jet(address, times[i], jet)
        row = invariants(jet[1], jet[2], jet[3], jet[4], jet[5], jet[7], jet[8], jet[9], jet[10], jet[11])
        for j, value in enumerate(row):
            out[i, j] = value
