"""Pieces end to end, as one curve: points, samples, the box around them, tangents where they meet."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.cas.errors import DomainError
from osculant.pieces.conics import Piece
from osculant.pieces.cubics import Cubic
from osculant.pieces.piece import around, largest_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from numpy.typing import ArrayLike

    from osculant.pieces.piece import Arc, Box, Floats, Geometry, PieceLike


class Chain:
    """The geometry of a spline, in the plane or in space.

    Args:
        pieces: in order, each beginning where the one before ends; their arcs are of one class.

    Attributes:
        pieces: these.
        arcs: what they are made of, in order.
        dimension: 2 or 3.

    >>> from osculant.pieces.conics import Piece
    >>> chain = Chain([Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 4.0))])
    >>> chain.evaluate([0.25]).tolist(), chain.bounding_box(), chain.numbers
    ([[0.5, 1.0]], ((0.0, 0.0), (2.0, 4.0)), 4)
    """

    def __init__(self, pieces: Sequence[PieceLike]) -> None:
        self.pieces = tuple(pieces)
        self.arcs: tuple[Arc, ...] = tuple(arc for piece in self.pieces for arc in piece.arcs)
        self.dimension = len(self.pieces[0].start)

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.pieces)

    @property
    def knots(self) -> list[float]:
        """The parameters where pieces begin and end, one more than there are pieces."""
        return [float(self.pieces[0].interval[0]), *(float(piece.interval[1]) for piece in self.pieces)]

    @property
    def numbers(self) -> int:
        """How many numbers store it: the coordinates of its start, and those of each piece from there on."""
        return self.dimension + sum(piece.numbers for piece in self.pieces)

    @cached_property
    def _evaluated(self) -> Callable[[Any, Floats], Floats]:
        """The points of arcs by their indices and own parameters, all at once."""
        found: Callable[[Any, Floats], Floats] = self.arcs[0].together(self.arcs)
        return found

    @cached_property
    def ends(self) -> Floats:
        """The curve's parameters where arcs begin and end."""
        begun = [t for piece in self.pieces for t in piece.arc_ends[:-1]]
        return np.array([*begun, self.pieces[-1].interval[1]], dtype=np.float64)

    def evaluate(self, t: ArrayLike) -> Floats:
        """Return the points at parameters of the curve; each arc's own parameter is affine in them.

        Args:
            t: parameters from the first knot to the last, an array of any shape.

        Returns:
            Points, of t's shape with a last axis for the coordinates.

        Raises:
            DomainError: a parameter outside.
        """
        t = np.asarray(t, dtype=np.float64)
        ends = self.ends
        outside = ~((t >= ends[0]) & (t <= ends[-1]))
        if outside.any():
            raise DomainError(
                f"The spline has no point at t = {float(t[outside].flat[0])!r}; "
                f"its parameters go from {ends[0].item()!r} to {ends[-1].item()!r}."
            )
        i = np.clip(np.searchsorted(ends, t, side="right") - 1, 0, len(self.arcs) - 1)
        return self._evaluated(i, (t - ends[i]) / (ends[i + 1] - ends[i]))

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points on each piece, its parameter equally spaced, knots once.

        The shape is (N(n−1) + 1, dimension) for N pieces.
        """
        counts = [len(piece.arcs) for piece in self.pieces]
        firsts = np.cumsum([0, *counts[:-1]])[:, None]  # index of each piece's first arc
        share = np.array([[piece.share] for piece in self.pieces])
        u = np.linspace(0.0, 1.0, n)[None, 1:]
        later = u > share
        with np.errstate(divide="ignore", invalid="ignore"):  # pieces of one arc have nothing later
            own = np.where(later, (u - share) / (1 - share), u / share)
        points = self._evaluated(firsts + later, own).reshape(-1, self.dimension)
        return np.concatenate([np.array([self.pieces[0].start]), points])

    def bounding_box(self) -> Box:
        """Return the lower and upper corners of the box around the pieces, from the extreme points."""
        return around(piece.bounding_box() for piece in self.pieces)

    @property
    def largest(self) -> float:
        """The largest absolute value of a coordinate."""
        return largest_of([self.bounding_box()])

    def max_tangent_jump(self) -> float:
        """Return the largest angle in radians between the tangent lines of consecutive arcs where they meet.

        Lines have no direction: a cusp, where the tangent is reversed, counts as continuous here, and is
        listed by `cusps`.
        """
        return max((2 * math.atan2(*sorted(_parted(*pair))) for pair in pairwise(self.arcs)), default=0.0)

    def corner(self) -> float:
        """Return the angle in radians, 0…π, from the tangent at the end to that at the start.

        >>> from osculant.pieces.conics import Piece
        >>> there, back = ((0.0, 0.0), (1.0, 0.0)), ((1.0, 0.0), (0.0, 0.0))
        >>> Chain([Piece.segment((0.0, 1.0), *there), Piece.segment((1.0, 2.0), *back)]).corner() == math.pi
        True
        """
        return 2 * math.atan2(*_parted(self.pieces[-1], self.pieces[0]))

    @property
    def cusps(self) -> list[float]:
        """The knots where the direction of the tangent is reversed."""
        pairs = ((after.interval[0], _parted(before, after)) for before, after in pairwise(self.pieces))
        return [float(knot) for knot, (difference, total) in pairs if difference > total]


def _parted(before: Geometry, after: Geometry) -> tuple[float, float]:
    """The lengths of difference and sum of the tangents where arcs meet: 2 sin and 2 cos of half an angle."""
    a, b = before.tangent(1.0), after.tangent(0.0)
    return float(np.linalg.norm(a - b)), float(np.linalg.norm(a + b))


def plane_arcs(pieces: Iterable[PieceLike]) -> list[Piece | Cubic]:
    """The arcs of pieces in the plane, conics and cubics, in order.

    Raises:
        DomainError: a piece of other arcs.
    """
    arcs = [(piece, arc) for piece in pieces for arc in piece.arcs]
    return [arc if isinstance(arc, Cubic) else conic_arc(piece, arc) for piece, arc in arcs]


def conic_arcs(pieces: Iterable[PieceLike]) -> list[Piece]:
    """The arcs of pieces in the plane, in order.

    Raises:
        DomainError: a piece of other arcs.

    >>> len(conic_arcs([Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 0.0))]))
    1
    """
    return [conic_arc(piece, arc) for piece in pieces for arc in piece.arcs]


def conic_arc(piece: PieceLike, arc: Arc) -> Piece:
    """An arc of a piece, which has to be one of a conic; raises DomainError if it is not."""
    if isinstance(arc, Piece):
        return arc
    raise DomainError(
        f"The piece on {piece.interval} is of kind {piece.kind!r}, which is no "
        "arc of a conic in the plane: approximate a curve in the plane."
    )
