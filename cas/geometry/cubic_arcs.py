"""Cubic Bézier curves as exact polynomials: differences from them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb

from osculant.cas.geometry.feet import Pair


@dataclass(frozen=True)
class CubicArc:
    """X(v) = b₀P₀ + b₁P₁ + b₂P₂ + b₃P₃, 0 ≤ v ≤ 1, with cubic Bernstein polynomials.

    What `osculant.cas.geometry.arc_distance` asks of an arc, as `ConicArc` answers it.

    Attributes:
        start: the first control point P₀; doubles, here and below, are what they are exactly.
        controls: P₁ and P₂.
        end: P₃.
    """

    start: Pair
    controls: tuple[Pair, Pair]
    end: Pair

    def steps(self) -> tuple[tuple[Any, Any], ...]:
        """The vectors P₁ − P₀, P₂ − P₀ and P₃ − P₀ as balls."""
        x, y = self.start
        return tuple((arb(p) - x, arb(q) - y) for p, q in (*self.controls, self.end))

    @cached_property
    def size(self) -> float:
        """The largest coordinate of the control points from the start, rounded."""
        return max(abs(c) for step in self._rounded for c in step)

    @cached_property
    def _rounded(self) -> tuple[Pair, ...]:
        return tuple((float(x), float(y)) for x, y in self.steps())

    def off(self, v: Any, point: tuple[Any, Any]) -> tuple[Any, Any, Any]:
        """p − X(v) for polynomials v and p − P₀: its x, its y, and 1, the square of the weight.

        >>> from flint import arb_poly
        >>> line = CubicArc((0.0, 0.0), ((1.0, 0.0), (2.0, 0.0)), (3.0, 0.0))
        >>> line.off(arb_poly([0, 1]), (arb_poly([3]), arb_poly([4])))[0]
        (-3.00000000000000)*x + 3.00000000000000
        """
        rest = 1 - v
        basis = 3 * v * rest * rest, 3 * v * v * rest, v * v * v
        x, y = (
            p - sum((b * step[axis] for b, step in zip(basis, self.steps())), 0 * v)
            for axis, p in enumerate(point)
        )
        return x, y, 0 * v + 1

    def at(self, v: float) -> tuple[Pair, Pair]:
        """X(v) − P₀ and X′(v), rounded.

        >>> CubicArc((0.0, 0.0), ((1.0, 0.0), (2.0, 0.0)), (3.0, 0.0)).at(0.25)
        ((0.75, 0.0), (3.0, 0.0))
        """
        (px, py), (qx, qy), (sx, sy) = self._rounded
        r = 1 - v
        one, two, three = 3 * v * r * r, 3 * v * v * r, v**3
        first, second, third = 3 * r * r, 6 * r * v, 3 * v * v
        point = one * px + two * qx + three * sx, one * py + two * qy + three * sy
        rate = (
            first * px + second * (qx - px) + third * (sx - qx),
            first * py + second * (qy - py) + third * (sy - qy),
        )
        return point, rate

    def near_ends(self, beyond: Any) -> Any:
        """A bound of |X(v) − P₀| for |v| ≤ beyond, and of |X(v) − P₃| for |v − 1| ≤ beyond."""
        v = (-beyond).union(beyond)
        bounds = []
        for arc in (self, CubicArc(self.end, (self.controls[1], self.controls[0]), self.start)):
            basis = 3 * v * (1 - v) * (1 - v), 3 * v * v * (1 - v), v * v * v
            x, y = (sum((b * step[i] for b, step in zip(basis, arc.steps())), arb(0)) for i in (0, 1))
            bounds.append((x * x + y * y).upper().sqrt().upper())
        return bounds[0].max(bounds[1])
