"""What all pieces of splines have in common, whatever they are made of, in the plane or in space."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]

Record = TypeVar("Record")
#: a point or a vector, with two or three coordinates
Coordinates = tuple[float, ...]
#: the lower and the upper corner
Box = tuple[Coordinates, Coordinates]


class Geometry(Protocol):
    """A curve with a parameter u from 0 at its start to 1 at its end."""

    @property
    def kind(self) -> str:
        """What curve it is, such as "segment", "arc" (of a circle), "helix" or "biarc"."""

    @property
    def start(self) -> Coordinates:
        """The first point."""

    @property
    def end(self) -> Coordinates:
        """The last point."""

    @property
    def numbers(self) -> int:
        """How many numbers store it if its start is known."""

    def point(self, u: ArrayLike) -> Floats:
        """The points at u, of u's shape with a last axis for the coordinates."""

    def tangent(self, u: ArrayLike) -> Floats:
        """The unit tangents there, likewise."""

    def bounding_box(self) -> Box:
        """The smallest box around it, from the extreme points themselves."""


class Arc(Geometry, Protocol):
    """A smooth arc of one curve."""

    @staticmethod
    def together(arcs: Sequence[Any]) -> Callable[[Any, Floats], Floats]:
        """A function that evaluates many arcs of this class at once, for arrays of their indices and of u."""


class PieceLike(Geometry, Protocol):
    """What stands for the curve between two knots: an arc, or two with a common tangent where they meet."""

    @property
    def interval(self) -> tuple[float, float]:
        """The curve's parameters at both ends."""

    @property
    def error(self) -> float:
        """How far it is from the curve, or the area between; 0 if it is a part of the curve."""

    @property
    def arcs(self) -> tuple[Arc, ...]:
        """What it is made of, in order."""

    @property
    def share(self) -> float:
        """The part of the piece's parameter u that belongs to the first of ``arcs``."""

    @property
    def arc_ends(self) -> tuple[float, ...]:
        """The curve's parameters where ``arcs`` begin and end, one more than there are arcs."""

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points with u equally spaced, both ends included."""

    def to_json(self) -> dict[str, Any]:
        """The piece as plain data, "kind", "interval" and "error" among it."""


class OfArcs:
    """What a piece of one arc or two has from its ``arcs`` and their ``share``."""

    def point(self: PieceLike, u: ArrayLike) -> Floats:
        """Return the points at u in [0, 1], of u's shape with a last axis for the coordinates."""
        return _on_arcs(self, u, "point")

    def tangent(self: PieceLike, u: ArrayLike) -> Floats:
        """Return the unit tangents there, likewise."""
        return _on_arcs(self, u, "tangent")

    def sample(self: PieceLike, n: int) -> Floats:
        """Return n >= 2 points with u equally spaced and both ends included."""
        return self.point(np.linspace(0.0, 1.0, n))

    def bounding_box(self: PieceLike) -> Box:
        """Return the lower and upper corners of the smallest box around the arcs."""
        return around(arc.bounding_box() for arc in self.arcs)


def from_columns(record: type[Record], *columns: Iterable[Any]) -> list[Record]:
    """Frozen records from a column for each of their fields, as their constructor makes them one by one.

    What ``__post_init__`` would check has to be sure for all of them.

    >>> from osculant.pieces.cubics import Cubic
    >>> inner = ((0.0, 2.0), (2.0, 2.0))
    >>> made = from_columns(Cubic, [(0.0, 1.0)], [(0.0, 0.0)], [inner], [(2.0, 0.0)], [1e-3])
    >>> made == [Cubic((0.0, 1.0), (0.0, 0.0), inner, (2.0, 0.0), 1e-3)]
    True
    """
    names = tuple(record.__dataclass_fields__)  # type: ignore[attr-defined]
    first, *others = zip(names, columns, strict=True)
    made = []
    for value in first[1]:
        made.append(object.__new__(record))
        made[-1].__dict__[first[0]] = value
    values = [piece.__dict__ for piece in made]
    for name, column in others:
        for filled, value in zip(values, column, strict=True):
            filled[name] = value
    return made


def largest_of(boxes: Iterable[Box]) -> float:
    """The largest absolute value of a coordinate in boxes.

    >>> largest_of([((0.0, -3.0), (1.0, 1.0))])
    3.0
    """
    return max(abs(side) for box in boxes for corner in box for side in corner)


def around(boxes: Iterable[Box]) -> Box:
    """The smallest box around boxes.

    >>> around([((0.0, 0.0), (1.0, 1.0)), ((0.5, -1.0), (2.0, 0.0))])
    ((0.0, -1.0), (2.0, 1.0))
    """
    lows, highs = zip(*boxes, strict=True)
    return tuple(map(min, zip(*lows, strict=True))), tuple(map(max, zip(*highs, strict=True)))


def _on_arcs(piece: PieceLike, u: ArrayLike, what: str) -> Floats:
    """The arcs' points or tangents at the piece's own parameter."""
    u = np.asarray(u, dtype=np.float64)
    first, *later = piece.arcs
    found: Floats = getattr(first, what)(np.minimum(u / piece.share, 1.0))
    for last in later:
        beyond = getattr(last, what)(np.clip((u - piece.share) / (1 - piece.share), 0.0, 1.0))
        found = np.where((u > piece.share)[..., None], beyond, found)
    return found
