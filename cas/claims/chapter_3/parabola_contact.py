"""Claims about parabolas tangent to an arc with k ≠ 0: they meet it nowhere else. For Remark 3.3.5."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_3.displacement import monotone_curvature, zeros_inside
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.jets.plane import PlaneJet

X = sp.Symbol("x", real=True)
#: an affine spiral whose k changes sign at 0
CHANGING = "x**2/2 + x**5/400"
#: graphs with k ≠ 0 on [−1, 1], the first with a sextactic point inside
CURVED = ("x**2/2 + x**4/40", "1/(3 - x)**2", "(x + 2)**4")


@claim(
    "R3.3-10",
    "A graph y(x) with y″ > 0 has the affine curvature k = −½ (y″^(−2/3))″.",
    method=Method.PROOF,
    form="-1/2",
    wrong=("1/2", "-1/3", "-1"),
)
def curvature_of_graph(form: str) -> Evidence:
    """k of the jet (x, y), (1, y′), (0, y″), (0, y‴), (0, y⁗) against the second derivative."""
    y = sp.symbols("y0:5", real=True)
    bend = sp.Symbol("b", positive=True)  # y″ = b³
    third, fourth = y[3], y[4]
    jet = PlaneJet((X, 1, 0, 0, 0), (y[0], y[1], bend**3, third, fourth), lambda v, _: bend)
    second = sp.Function("second")(X)
    rate = sp.diff(second ** sp.Rational(-2, 3), X, 2)
    fixed = rate.subs(second.diff(X, 2), fourth).subs(second.diff(X), third).subs(second, bend**3)
    return vanishes(jet.affine_curvature - read(form, {}) * fixed, "k of a graph")


@claim(
    "R3.3-11",
    "A graph with y″ > 0 and k ≠ 0 meets a parabola whose axis is nowhere tangent to it in at most four "
    "points, "
    "counted with multiplicity; so a bitangent parabola meets it at the end points only, with different "
    "curvature.",
    method=Method.PROOF,
    form="k != 0",
    wrong=("k monotone",),
)
def four_points(form: str) -> Evidence:
    """Equi-affine coordinates make the parabola y = x²/2 and the curve a graph over its x.

    Let q = y″^(−2/3) > 0. By R3.3-10 k ≠ 0 makes q strictly convex or concave, so q = 1 at two points at most
    (three would give, by Rolle, a zero of q″). Then f = y − x²/2 has f″ = q^(−3/2) − 1 with ≤ 2 zeros,
    and f four at most, by Rolle twice. A bitangent parabola has two double zeros: f″ ≠ 0 there, and no
    others. The hypothesis is tried on graphs for which it is decided exactly, with zeros counted exactly.
    """
    q = sp.Symbol("q", positive=True)
    second = q ** sp.Rational(-3, 2)
    found = vanishes(sp.powdenest(second ** sp.Rational(-2, 3), force=True) - q, "q = y″^(−2/3)")
    found &= curvature_of_graph("-1/2")
    graphs = {"k != 0": CURVED, "k monotone": (*CURVED[1:], CHANGING)}.get(form)
    if graphs is None:
        raise DomainError(f"The hypothesis {form!r} is unknown: use 'k != 0' or 'k monotone'.")
    most, count = 0, 0
    for text in graphs:
        graph = read(text, {"x": X})
        decided = nonzero_curvature(graph) if form == "k != 0" else monotone_curvature(graph, X, -1, 1)
        found &= Evidence(decided, () if decided else (f"{form} does not hold for {text}",))
        for low in (-50, -37, 5):
            for high in range(low + 13, 51, 16):
                ends = sp.Rational(low, 50), sp.Rational(high, 50)
                most = max(most, zeros_inside(bitangent_parabola(graph, *ends), X, *ends))
                count += 1
    line = (
        f"{form}: {count} bitangent parabolas on {len(graphs)} graphs meet the arc in at most {most} points"
    )
    return found & Evidence(most == 4, (line,))


def nonzero_curvature(graph: Any) -> bool:
    """Whether k has no zero on a graph y(x) over [−1, 1] with rational y, and y″ none: decided exactly.

    >>> nonzero_curvature(X**2 + X**4 / 40), nonzero_curvature(X**2 + X**5)
    (True, False)
    """
    y2, y3, y4 = (sp.diff(graph, X, n) for n in (2, 3, 4))
    form = sp.together(3 * y2 * y4 - 5 * y3**2)
    return form != 0 and zeros_inside(y2, X, -1, 1) == 0 and zeros_inside(form, X, -1, 1) == 0


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


U = sp.Symbol("u", positive=True)
#: legs e₁ = P₁ − P₀ and e₂ = P₂ − P₁ of a bitangent parabola, E = [e₁, e₂]
E1, E2 = sp.symbols("e11 e12", real=True), sp.symbols("e21 e22", real=True)
#: β with P₁ = 0
PARABOLA = [-((1 - U) ** 2) * v + U**2 * w for v, w in zip(E1, E2)]


def det(v: Sequence[Any], w: Sequence[Any]) -> Any:
    """The determinant [v, w] of symbolic vectors, expanded.

    >>> det((1, X), (X, 2))
    2 - x**2
    """
    return sp.expand(v[0] * w[1] - v[1] * w[0])


@claim(
    "R3.3-12",
    "The axis of the parabola tangent to a convex arc at both ends is tangent to the arc nowhere, if the "
    "arc turns by "
    "less than π.",
    method=Method.PROOF,
    form="-(a + b)*E",
    wrong=("-(a - b)*E", "(a + b)*E"),
)
def axis(form: str) -> Evidence:
    """The axis has the direction e₂ − e₁ of β″; tangents of the arc are a·e₁ + b·e₂ with a, b ≥ 0, not 0.

    Their determinant is the form, E = [e₁, e₂] ≠ 0: it cannot vanish.
    """
    a, b = sp.symbols("a b", positive=True)
    direction = [sp.diff(z, U, 2) for z in PARABOLA]
    tangent = [a * v + b * w for v, w in zip(E1, E2)]
    claimed = read(form, {"a": a, "b": b, "E": det(E1, E2)})
    return vanishes(2 * claimed - det(direction, tangent), "[axis, tangent]")
