"""Circular and helical arcs for formats that have no other curves."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from osculant.cas.errors import DomainError
from osculant.pieces.chain import conic_arcs
from osculant.pieces.helices import HelixArc

if TYPE_CHECKING:
    from osculant.pieces.chain import Chain
    from osculant.pieces.conics import Piece


def circular_arcs(chain: Chain, what: str) -> list[Piece]:
    """The arcs of a chain in the plane, all of circles or lines; none if the chain is in space.

    Args:
        chain: the pieces of a spline.
        what: the format that has no others, as the error begins.

    Raises:
        DomainError: an arc of another kind.
    """
    if chain.dimension == 3:
        return []
    arcs = conic_arcs(chain.pieces)
    for arc in arcs:
        if arc.kind not in ("segment", "arc"):
            raise DomainError(
                f"{what} has lines and circular arcs, and the piece on {arc.interval} is of kind "
                f"{arc.kind!r}: approximate with biarcs."
            )
    return arcs


def helical_arcs(chain: Chain) -> list[HelixArc]:
    """The arcs of a chain in space; none if it is in the plane."""
    return [arc for arc in chain.arcs if isinstance(arc, HelixArc)]


def chords_needed(chord_square: float, tolerance: float) -> int:
    """Return how many equal chords keep a helical arc with this κL² within a tolerance.

    On a chord of arc length h the arc is at most κh²/8 away.

    >>> chords_needed(1.0, 1e-3)
    12
    """
    return max(1, math.ceil(math.sqrt(chord_square / (8 * tolerance))))
