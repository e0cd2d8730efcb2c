"""One piece of a spline: a bounded arc of a conic with given end tangents, or a straight segment.

The arc is the rational quadratic Bézier curve

    X(u) = (b₀P₀ + b₁M + b₂P₂) / (b₀ + w b₁ + b₂),   b₀ = (1−u)², b₁ = 2u(1−u), b₂ = u²,

with homogeneous control point M = wP₁. Keeping M instead of P₁ makes parallel end tangents (w = 0, P₁ at
infinity) and turning beyond π (w < 0) ordinary cases. With the vectors A = M − wP₀ along the first tangent,
B = wP₂ − M along the last one and C = P₂ − P₀ (so that A + B = wC) the derivative is

    X′(u) = 2((1−u)²A + u(1−u)C + u²B) / (b₀ + w b₁ + b₂)²,

whose direction is finite for every w > −1. Source: thesis, section 3.3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from osculant.cas.errors import DomainError
from osculant.pieces.kinds import ConicKind

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike

    from osculant.pieces.piece import Floats

Point = tuple[float, float]

CONIC_KINDS = get_args(ConicKind)
#: a weight that is so near to 1 is a parabola's
SAME_WEIGHT = 4 * math.ulp(0.5)


def classify(weight: float) -> ConicKind:
    """Name the conic that has this weight.

    Args:
        weight: weight w > −1 of the middle control point, the outer weights being 1.

    Returns:
        "ellipse" for w < 1, "hyperbola" for w > 1, "parabola" within four rounding units of 1.

    >>> [classify(w) for w in (-0.5, 1.0, 3.0)]
    ['ellipse', 'parabola', 'hyperbola']
    """
    if abs(weight - 1.0) <= SAME_WEIGHT:
        return "parabola"
    return "ellipse" if weight < 1 else "hyperbola"


def require_bounded(*weights: float) -> None:
    """Raises DomainError if a conic arc of one of the weights is not bounded."""
    for weight in weights:
        if not -1 < weight < math.inf:
            raise DomainError(
                f"A conic arc is bounded only for a weight above -1 and finite; this one has {weight!r}."
            )


@dataclass(frozen=True)
class Piece:
    """A conic arc, or a segment, that stands for the curve on one parameter interval.

    Attributes:
        kind: "ellipse", "parabola", "hyperbola", "segment", or "arc" of a circle.
        interval: the curve's parameters at both ends.
        start: first end point P₀.
        end: last end point P₂.
        middle: homogeneous control point M = wP₁; of a segment its midpoint.
        weight: w > −1; of a parabola or a segment 1.
        error: Hausdorff distance to the curve, or the area between, as estimated; 0 if the piece is exact.

    Raises:
        DomainError: a weight at which the arc is not bounded.

    >>> half = Piece("ellipse", (0.0, 3.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), 0.0, 0.0)
    >>> half.point(0.5), half.tangent(0.5), half.control_point
    (array([0., 1.]), array([-1.,  0.]), None)
    """

    kind: ConicKind
    interval: tuple[float, float]
    start: Point
    end: Point
    middle: Point
    weight: float
    error: float

    def __post_init__(self) -> None:
        if self.kind not in CONIC_KINDS:
            raise DomainError(f"A piece is an {', '.join(CONIC_KINDS)}; {self.kind!r} is none of them.")
        require_bounded(self.weight)

    @classmethod
    def segment(cls, interval: tuple[float, float], start: Point, end: Point, error: float = 0.0) -> Piece:
        """Return the straight piece between two points.

        >>> Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 4.0)).middle
        (1.0, 2.0)
        """
        middle = (start[0] / 2 + end[0] / 2, start[1] / 2 + end[1] / 2)
        return cls("segment", interval, start, end, middle, 1.0, error)

    @classmethod
    def arc(
        cls, interval: tuple[float, float], start: Point, end: Point, tangent: Point, error: float = 0.0
    ) -> Piece:
        """Return the circular arc between two points with that unit tangent at the first.

        It must turn by less than 2π; near that its points are ill-conditioned.

        >>> Piece.arc((0.0, 3.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0)).bounding_box()
        ((-1.0, 0.0), (1.0, 1.0))
        """
        dx, dy = end[0] - start[0], end[1] - start[1]
        chord = math.hypot(dx, dy)
        weight = (tangent[0] * dx + tangent[1] * dy) / chord
        if weight > 1 - 1e-3:  # from the sine: an arc is no hyperbola
            sine = (tangent[0] * dy - tangent[1] * dx) / chord
            weight = math.sqrt((1 - sine) * (1 + sine))
        reach = chord / 2
        middle = (weight * start[0] + reach * tangent[0], weight * start[1] + reach * tangent[1])
        return cls("arc", interval, start, end, middle, weight, error)

    @cached_property
    def arcs(self) -> tuple[Piece]:
        """The conic arcs it is made of: itself."""
        return (self,)

    @property
    def share(self) -> float:
        """The part of the piece that belongs to the first of `arcs`: all."""
        return 1.0

    @property
    def arc_ends(self) -> tuple[float, float]:
        """The curve's parameters where `arcs` begin and end: the interval."""
        return self.interval

    @staticmethod
    def together(arcs: Sequence[Piece]) -> Callable[[Any, Floats], Floats]:
        """Return a function that evaluates many arcs at once, for arrays of their indices and of u."""
        weights = np.array([[arc.weight] for arc in arcs])
        rows = [(arc.start, arc.end, *arc.legs) for arc in arcs]
        vectors = np.moveaxis(np.array(rows, dtype=np.float64), 1, 0)  # P₀, P₂, A, B, C
        return lambda i, u: combine(u[..., None], weights[i], *(vector[i] for vector in vectors))

    @property
    def numbers(self) -> int:
        """How many numbers store it if its start is known: end, bulge of an arc, control point, weight.

        >>> Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 4.0)).numbers
        2
        """
        return {"segment": 2, "arc": 3, "parabola": 4}.get(self.kind, 5)

    @cached_property
    def legs(self) -> tuple[Point, Point, Point]:
        """The vectors A = M − wP₀, B = wP₂ − M and C = P₂ − P₀, each rounded once from the exact value."""
        w = Fraction(self.weight)
        a, b, c = [], [], []
        for p0, m, p2 in zip(self.start, self.middle, self.end):
            start, middle, end = Fraction(p0), Fraction(m), Fraction(p2)
            a.append(float(middle - w * start))
            b.append(float(w * end - middle))
            c.append(float(end - start))
        return (a[0], a[1]), (b[0], b[1]), (c[0], c[1])

    @property
    def turning(self) -> float:
        """The angle by which the tangent turns from start to end, of an arc or a segment; positive leftwards.

        >>> Piece.arc((0.0, 3.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0)).turning == math.pi
        True
        """
        (ax, ay), _, (cx, cy) = self.legs
        return 2 * math.atan2(ax * cy - ay * cx, ax * cx + ay * cy)

    @cached_property
    def bulge(self) -> Point:
        """The vector E = M − w(P₀+P₂)/2, rounded once; E/(1+w) leads from the chord's middle to X(1/2)."""
        w = Fraction(self.weight)
        x, y = (
            float(Fraction(m) - w * (Fraction(p0) + Fraction(p2)) / 2)
            for p0, m, p2 in zip(self.start, self.middle, self.end)
        )
        return x, y

    @property
    def control_point(self) -> Point | None:
        """P₁ = M/w, where the end tangents meet; None if they are parallel (w = 0) or P₁ overflows."""
        if self.weight == 0:
            return None
        x, y = self.middle[0] / self.weight, self.middle[1] / self.weight
        return (x, y) if math.isfinite(x) and math.isfinite(y) else None

    def point(self, u: ArrayLike) -> Floats:
        """Return X(u); exactly the end points at u = 0 and u = 1.

        Args:
            u: the conic's own parameter in [0, 1], an array of any shape.

        Returns:
            Points, of u's shape with a last axis of length 2.
        """
        u = np.asarray(u, dtype=np.float64)[..., None]
        return combine(u, self.weight, np.array(self.start), np.array(self.end), *map(np.array, self.legs))

    def tangent(self, u: ArrayLike) -> Floats:
        """Return the unit tangent at X(u), of u's shape with a last axis of length 2.

        >>> Piece("parabola", (0, 1), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0), 1.0, 0.0).tangent([0, 0.5])
        array([[0.70710678, 0.70710678],
               [1.        , 0.        ]])
        """
        u = np.asarray(u, dtype=np.float64)[..., None]
        a, b, c = map(np.array, self.legs)
        v = 1 - u
        direction: Floats = v * v * a + u * v * c + u * u * b
        direction = direction / np.abs(direction).max(axis=-1, keepdims=True)  # squares must not underflow
        return direction / np.hypot(direction[..., :1], direction[..., 1:])

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points X(u) with u equally spaced and both ends included; shape (n, 2)."""
        return self.point(np.linspace(0.0, 1.0, n))

    def bounding_box(self) -> tuple[Point, Point]:
        """Return the lower and upper corners from the arc's extreme points themselves, not from samples.

        >>> Piece("ellipse", (0, 3), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), 0.0, 0.0).bounding_box()
        ((-1.0, 0.0), (1.0, 1.0))
        """
        sides = []
        for axis in (0, 1):
            values = [self.start[axis], self.end[axis]]
            if self.kind != "segment":
                a, b, c = (vector[axis] for vector in self.legs)
                values += [float(self.point(r / (1 + r))[axis]) for r in _positive_roots(a, c, b)]
            sides.append((min(values), max(values)))
        (left, right), (bottom, top) = sides
        return (left, bottom), (right, top)

    def to_json(self) -> dict[str, Any]:
        """Return the piece as plain lists and numbers, as in the JSON of a spline.

        >>> Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 0.0)).to_json()["points"]
        [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]
        """
        middle = self.control_point
        return {
            "kind": self.kind,
            "interval": _floats(self.interval),
            "points": [_floats(self.start), None if middle is None else _floats(middle), _floats(self.end)],
            "middle": _floats(self.middle),
            "weight": float(self.weight),
            "error": float(self.error),
        }


def combine(u: Floats, w: Floats | float, p0: Floats, p2: Floats, a: Floats, b: Floats, c: Floats) -> Floats:
    """Evaluate conic arcs from their nearer end, so that a distant origin costs no figures.

    Args:
        u: parameters in [0, 1], with a last axis of length 1.
        w: weights, broadcast against u.
        p0: first end points, last axis of length 2 as of all that follow.
        p2: last end points.
        a: vectors A = M − wP₀.
        b: vectors B = wP₂ − M.
        c: vectors C = P₂ − P₀.

    Returns:
        The points X(u), with a last axis of length 2.
    """
    v = 1 - u
    product = 2 * u * v
    total = (v - u) ** 2 + (1 + w) * product  # = b₀ + w b₁ + b₂, without cancellation as w nears −1
    from_start = p0 + (product * a + u * u * c) / total
    from_end = p2 - (product * b + v * v * c) / total
    return np.where(u <= 0.5, from_start, from_end)


def _positive_roots(a: float, b: float, c: float) -> list[float]:
    """Return the positive roots r of a + br + cr² = 0, each computed without cancellation."""
    size = max(abs(a), abs(b), abs(c))
    if size == 0:
        return []
    a, b, c = a / size, b / size, c / size
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return []
    q = -(b + math.copysign(math.sqrt(discriminant), b)) / 2
    roots = [a / q if q else 0.0, q / c if c else 0.0]
    return [r for r in roots if 0 < r < math.inf]


def _floats(values: tuple[float, float]) -> list[float]:
    return [float(value) for value in values]
