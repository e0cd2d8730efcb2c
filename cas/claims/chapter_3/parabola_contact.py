"""Claims about parabolas tangent to an arc with k ≠ 0: they meet it nowhere else. For Remark 3.3.5."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_3.parabolas import CHANGING, E1, E2, PARABOLA, U, X, bitangent_parabola, det
from osculant.cas.claims.chapter_3.sample_arcs import monotone_curvature, zeros_inside
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.jets.plane import PlaneJet

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
