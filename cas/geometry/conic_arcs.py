"""Arcs of conics as exact rational curves: differences from them as polynomials."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb

from osculant.cas.geometry.feet import Pair


@dataclass(frozen=True)
class ConicArc:
    """X(v) = (b₀P₀ + b₁M + b₂P₂)/W(v), W = b₀ + w b₁ + b₂, 0 ≤ v ≤ 1, with quadratic Bernstein polynomials.

    Attributes:
        start: the first end point P₀; doubles, here and below, are what they are exactly.
        middle: the homogeneous control point M.
        end: the last end point P₂.
        weight: w > −1.
    """

    start: Pair
    middle: Pair
    end: Pair
    weight: float

    def legs(self) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
        """The vectors A = M − wP₀ and C = P₂ − P₀ as balls: X − P₀ = (b₁A + b₂C)/W."""
        w = arb(self.weight)
        (ax, cx), (ay, cy) = (
            (arb(m) - w * p, arb(q) - p) for p, m, q in zip(self.start, self.middle, self.end)
        )
        return (ax, ay), (cx, cy)

    @cached_property
    def size(self) -> float:
        """The largest coordinate of the legs, rounded."""
        return max(abs(c) for leg in self._rounded for c in leg)

    @cached_property
    def _rounded(self) -> tuple[Pair, Pair]:
        (ax, ay), (cx, cy) = self.legs()
        return (float(ax), float(ay)), (float(cx), float(cy))

    def off(self, v: Any, point: tuple[Any, Any]) -> tuple[Any, Any, Any]:
        """W·(p − X(v)) and W² for polynomials v and p − P₀: its x, its y, and W².

        >>> from flint import arb_poly
        >>> chord = ConicArc((0.0, 0.0), (1.0, 0.0), (2.0, 0.0), 1.0)
        >>> chord.off(arb_poly([0, 1]), (arb_poly([3]), arb_poly([4])))
        ((-2.00000000000000)*x + 3.00000000000000, 4.00000000000000, 1.00000000000000)
        """
        rest = 1 - v
        one, two = 2 * v * rest, v * v
        total = rest * rest + arb(self.weight) * one + two
        x, y = (total * p - one * a - two * c for a, c, p in zip(*self.legs(), point))
        return x, y, total * total

    def at(self, v: float) -> tuple[Pair, Pair]:
        """X(v) − P₀ and X′(v), rounded.

        >>> ConicArc((0.0, 0.0), (1.0, 0.0), (2.0, 0.0), 1.0).at(0.25)
        ((0.5, 0.0), (2.0, 0.0))
        """
        w, (a, c) = self.weight, self._rounded
        r = 1 - v
        total = (r - v) ** 2 + (1 + w) * 2 * r * v
        x, y = ((2 * v * r * a[i] + v * v * c[i]) / total for i in (0, 1))
        # X′ = 2(r²A + rvC + v²B)/W² with B = wC − A
        dx, dy = (2 * ((r * r - v * v) * a[i] + (r * v + v * v * w) * c[i]) / total**2 for i in (0, 1))
        return (x, y), (dx, dy)

    def near_ends(self, beyond: Any) -> Any:
        """A bound of |X(v) − P₀| for |v| ≤ beyond, and of |X(v) − P₂| for |v − 1| ≤ beyond."""
        v = (-beyond).union(beyond)
        bounds = []
        for arc in (self, ConicArc(self.end, self.middle, self.start, self.weight)):
            a, c = arc.legs()
            total = (1 - v) ** 2 + arb(arc.weight) * 2 * v * (1 - v) + v * v
            x, y = ((2 * v * (1 - v) * a[i] + v * v * c[i]) / total for i in (0, 1))
            bounds.append((x * x + y * y).upper().sqrt().upper())
        return bounds[0].max(bounds[1])
