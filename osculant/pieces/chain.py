"""Many pieces evaluated at once: chains of conic arcs and biarcs as arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.pieces.conics import combine

if TYPE_CHECKING:
    from osculant.pieces.biarcs import Biarc
    from osculant.pieces.conics import Floats, Piece


class Chain:
    """The conic arcs of a spline's pieces.

    Args:
        pieces: the pieces in order.

    >>> from osculant.pieces.conics import Piece
    >>> chain = Chain([Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 4.0))])
    >>> chain.points(np.array([0]), np.array([0.25])).tolist()
    [[0.5, 1.0]]
    """

    def __init__(self, pieces: Sequence[Piece | Biarc]) -> None:
        arcs = [arc for piece in pieces for arc in piece.arcs]
        counts = [len(piece.arcs) for piece in pieces]
        self._firsts = np.cumsum([0, *counts[:-1]])  # index of each piece's first arc
        self._shares = np.array([piece.share for piece in pieces])  # what of the piece that arc is
        self._weights = np.array([[arc.weight] for arc in arcs])
        rows = [(arc.start, arc.end, *arc.legs) for arc in arcs]
        self._vectors = np.moveaxis(np.array(rows, dtype=np.float64), 1, 0)  # P₀, P₂, A, B, C

    def points(self, i: Any, u: Floats) -> Floats:
        """Return the points of the pieces with indices i at their parameters u in [0, 1].

        Args:
            i: indices, an array of any shape.
            u: parameters, of the same shape.

        Returns:
            Points, of their shape with a last axis of length 2.
        """
        share = self._shares[i]
        later = u > share
        with np.errstate(divide="ignore", invalid="ignore"):  # pieces of one arc have nothing later
            u = np.where(later, (u - share) / (1 - share), u / share)
        j = self._firsts[i] + later
        return combine(u[..., None], self._weights[j], *(vector[j] for vector in self._vectors))
