"""The stretches that a curve is divided into, and the frames where they end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

#: where in a stretch or an arc is read off what is the same everywhere: at no special place
INSIDE = 0.4871

#: a coordinate each
Vector = tuple[float, ...]
Kind = Literal["generic", "level", "segment", "exact", "bridge"]


@dataclass(frozen=True)
class Frame:
    """A point of the curve and its unit tangent, at a cusp the limit tangent from the stretch's side.

    ``order`` is that of the first derivative which does not vanish there.
    """

    point: Vector
    tangent: Vector
    order: int = 1


@dataclass(frozen=True)
class Stretch:
    """A part of the interval without special points inside but those that are passed.

    Attributes:
        low, high: its ends, balls.
        a, b: their nearest doubles.
        start, end: the frames there.
        kind: "segment" or "exact" if the curve is a segment or an arc of the primitive itself there, "level"
            if it is not, but the leading term of the primitive's error vanishes (a bihelix's, on a curve of
            constant curvature), "bridge" if it lies below the tolerance and is not followed.
        bend: the sign of the curvature; 1 in space, where it has none.
        passed: the points inside, balls, where theory wants a split and none is to be made.
        reach: so far from its pieces may be what they stand for besides, or a bridge from its arc.
        covers: what its pieces stand for if that is more than [a, b]: small arcs next to it are passed over.
    """

    low: Any
    high: Any
    a: float
    b: float
    start: Frame
    end: Frame
    kind: Kind
    bend: float
    passed: tuple[Any, ...] = ()
    reach: float = 0.0
    covers: tuple[float, float] | None = None
