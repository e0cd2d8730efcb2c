"""The bitangent parabola of a graph, and in its own affine coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

X = sp.Symbol("x", real=True)
#: an affine spiral whose k changes sign at 0
CHANGING = "x**2/2 + x**5/400"
U = sp.Symbol("u", positive=True)
#: legs e₁ = P₁ − P₀ and e₂ = P₂ − P₁ of a bitangent parabola, E = [e₁, e₂]
E1, E2 = sp.symbols("e11 e12", real=True), sp.symbols("e21 e22", real=True)
#: β with P₁ = 0
PARABOLA = [-((1 - U) ** 2) * v + U**2 * w for v, w in zip(E1, E2)]


def bitangent_parabola(graph: Any, low: Any, high: Any, point: Any = None) -> Any:
    """F for the parabola tangent to the graph at both ends: along the graph, or at a given point.

    >>> sp.expand(bitangent_parabola(X**2, -1, 1))
    0
    """
    x, y = (X, graph) if point is None else point
    slope = sp.diff(graph, X)
    (x0, y0, s0), (x2, y2, s2) = ((at, graph.subs(X, at), slope.subs(X, at)) for at in (low, high))
    chord = (x2 - x0, y2 - y0)
    # [v, w] with the tangents (1, s): Q makes the determinant of the quadratic part 0
    q = (chord[1] - s0 * chord[0]) * (chord[0] * s2 - chord[1]) / (s2 - s0) ** 2
    l0, l2 = (y - y2) - s2 * (x - x2), (y - y0) - s0 * (x - x0)
    l1 = chord[0] * (y - y0) - chord[1] * (x - x0)
    return l1**2 - 4 * q * l0 * l2


def det(v: Sequence[Any], w: Sequence[Any]) -> Any:
    """The determinant [v, w] of symbolic vectors, expanded.

    >>> det((1, X), (X, 2))
    2 - x**2
    """
    return sp.expand(v[0] * w[1] - v[1] * w[0])
