"""The pieces in a whole table, in the user's coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np

from osculant.kernels.jit import kernel
from osculant.kernels.operations import shape


@kernel
def shapes(
    fit: Any, table: np.ndarray[Any, Any], place: Any, errors: np.ndarray[Any, Any], out: np.ndarray[Any, Any]
) -> None:
    """Write the piece of each row of ``table`` (n, columns of the family) into one of ``out``.

    Args:
        fit: a record (`osculant.kernels.operations`).
        table: rows that `osculant.kernels.search` or `given_knots` wrote.
        place: of the kernel's coordinates.
        errors: (n,) of the pieces, in the user's units.
        out: (n, numbers of `osculant.kernels.operations.piece_type`).

    >>> from osculant.kernels.curves.plane import Place
    >>> from osculant.kernels.polygons.records import Chord
    >>> row, out = np.array([[0.0, 1.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0]]), np.empty((1, 7))
    >>> shapes(Chord(), row, Place(10.0, 20.0, 0.5, 1.0, 0.0), np.array([0.25]), out)
    >>> out.tolist()
    [[0.0, 1.0, 0.25, 12.0, 24.0, 16.0, 28.0]]
    """
    for i in range(table.shape[0]):
        into = out[i]
        for j, value in enumerate(shape(fit, table[i], place, errors[i])):
            into[j] = value
