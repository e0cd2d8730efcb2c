"""Theorem A beyond section 3.2: a conic meets a strictly convex affine spiral arc in at most five points.

The arc and the conic are put into a chart in which both are graphs: y″^(−2/3) of the conic is quadratic
there, and the third derivative of the arc's has the sign of −dk/dr. The rest is Rolle's theorem. The claims
before the theorem are the steps of its proof.
"""

from __future__ import annotations

import random
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_3.conic_chart import (
    branch_of_the_conic,
    chart_of_the_arc,
    chart_of_the_conic,
    third_derivative,
)
from osculant.cas.claims.chapter_3.convex_arcs import strictly_convex
from osculant.cas.claims.chapter_3.displacement import wronskian
from osculant.cas.claims.chapter_3.sample_arcs import monotone_curvature, zeros_inside
from osculant.cas.claims.chapter_3.six_zeros import six_zeros
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integer, read, read_tuple, split, vanishes

COORDINATES = (
    "t1*(t3 - t2)*(t2 - t4)/(t2*(t3 - t1)*(t1 - t4)), "
    "t3*(t2 - t1)*(t2 - t4)/(t2*(t3 - t1)*(t3 - t4)), "
    "-t4*(t2 - t1)*(t3 - t2)/(t2*(t1 - t4)*(t3 - t4))"
)


@claim(
    "X3.2-8",
    "Of three points of one branch of a hyperbola and one of the other the middle one of the branch lies "
    "inside the triangle of the rest: on xy = 1 with the abscissas 0 < t₁ < t₂ < t₃, t₄ < 0 its barycentric "
    "coordinates with respect to the points t₁, t₃, t₄ are positive.",
    method=Method.PROOF,
    form=COORDINATES,
    wrong=(
        COORDINATES.replace("t2 - t4", "t2 + t4"),
        COORDINATES.replace("-t4", "t4", 1),
        COORDINATES.replace("t1*(t3", "t2*(t3", 1),
    ),
)
def inside_the_triangle(form: str) -> Evidence:
    """Quotients of the areas of triangles; all factors of the form are positive as t₄ < 0 < t₁ < t₂ < t₃.

    A strictly convex arc therefore meets no hyperbola in three different points of one branch and in one of
    the other: its points are the corners of their convex hull (X3.2-2).
    """
    t1, t2, t3 = sp.symbols("t1:4", positive=True)
    t4 = -sp.Symbol("m4", positive=True)

    def area(*places: Any) -> Any:
        return sp.Matrix([[1, s, 1 / s] for s in places]).det()

    whole, found = area(t1, t3, t4), Evidence(True)
    parts = read_tuple(form, {"t1": t1, "t2": t2, "t3": t3, "t4": t4}, 3)
    derived = ((t2, t3, t4), (t1, t2, t4), (t1, t3, t2))
    for number, part, corners in zip((1, 3, 4), parts, derived, strict=True):
        found &= vanishes(part - area(*corners) / whole, f"coordinate of the point t{number}")
    gaps = sp.symbols("g1 g2", positive=True)
    ordered = {t2: t1 + gaps[0], t3: t1 + gaps[0] + gaps[1]}
    for part in parts:
        numerator, denominator = sp.fraction(sp.factor(sp.together(part.subs(ordered, simultaneous=True))))
        one_sign = all(
            bool(c.is_positive) for e in (numerator, denominator) for c in sp.Add.make_args(sp.expand(e))
        )
        found &= Evidence(one_sign, (f"for 0 < t₁ < t₂ < t₃, t₄ < 0 it is positive: {one_sign}",))
    return found


@claim(
    "X3.2-9",
    "A tangent of a hyperbola separates its branches: on xy = 1 the tangent's equation at (t, 1/t) has the "
    "value (s − t)²/(st) at (s, 1/s), positive on the branch that is touched and negative on the other.",
    method=Method.PROOF,
    form="(s - t)^2/(s*t)",
    wrong=("(s + t)^2/(s*t)", "(s - t)^2/(s^2*t^2)", "(t - s)/(s*t)", "-(s - t)^2/(s*t)"),
)
def tangent_separates(form: str) -> Evidence:
    """x/t + yt − 2, which is negative at the origin, between the branches.

    So an arc that touches one branch at X, and meets it once more or three times at X, is on the same side of
    the tangent as this branch, and has no point on the other. With X3.2-8: a strictly convex arc that meets
    both branches of a hyperbola meets each of them at most twice, both together at most four times.
    """
    s, t = sp.symbols("s t", real=True, nonzero=True)
    x, y = sp.symbols("x y", real=True)
    tangent = x / t + y * t - 2
    touches = vanishes(tangent.subs({x: t, y: 1 / t}), "the tangent at its point")
    slope = vanishes(sp.diff(tangent.subs({x: s, y: 1 / s}), s).subs(s, t), "its slope along the hyperbola")
    return touches & slope & vanishes(read(form, {"s": s, "t": t}) - tangent.subs({x: s, y: 1 / s}), "value")


@claim(
    "X3.2-10",
    "A polynomial of degree ≤ 2 that is not 0 and whose zeros are lines, one point or nothing has at most "
    "four zeros on a strictly convex arc.",
    method=Method.PROOF,
    form="4",
    wrong=("2", "3", "5"),
)
def degenerate_conics(form: str) -> Evidence:
    """Two lines take two points each. A definite F has its zero at a point, of order 2 along the arc.

    F = (pξ + qη)² + (sη)², p, s ≠ 0, up to a factor, in coordinates about that point: along a regular arc the
    order is computed. Of degree 1 it takes two, of degree 0 none.
    """
    p, q, s, m, t = sp.symbols("p q s m t", positive=True)
    bend = sp.Symbol("kappa", positive=True)
    along = sp.Poly(
        sp.expand((p * t + q * (m * t + bend * t**2)) ** 2 + s**2 * (m * t + bend * t**2) ** 2), t
    )
    order = min(n for (n,) in along.monoms())
    most = {"two lines": 2 + 2, "a line": 2, "a point": order, "nothing": 0}
    line = ", ".join(f"{kind}: {count}" for kind, count in most.items())
    return Evidence(integer(read(form, {})) == max(most.values()), (f"zeros at most, {line}",))


@claim(
    "X3.2-11",
    "If (y″^(−2/3))‴ has no zero for a convex graph y and u″^(−2/3) is quadratic for a convex graph u, then "
    "y − u has at most five zeros with multiplicity.",
    method=Method.PROOF,
    form="5",
    wrong=("4", "6", "3"),
)
def rolle(form: str) -> Evidence:
    """Rolle's theorem, with multiplicity: a derivative has at most one zero less than the function.

    y″ and u″ agree exactly where g = y″^(−2/3) − u″^(−2/3) vanishes, with the same multiplicity, as p ↦
    p^(−2/3) is a diffeomorphism of p > 0. g‴ = (y″^(−2/3))‴ has no zero, so g has three at most and y − u two
    more. The orders are computed: those of the derivative that kills a quadratic, and of y″. Five are
    possible: y″^(−2/3) = (1 + εz(x))² with z a cubic and u = x²/2 differ, to first order in ε, by a
    polynomial of degree five with any zeros.
    """
    x, small = sp.symbols("x epsilon")
    b = sp.symbols("b0:3")
    quadratic, killed = sum(c * x**i for i, c in enumerate(b)), 0
    while quadratic != 0:
        quadratic, killed = sp.diff(quadratic, x), killed + 1
    bound = killed + 2
    # to first order y − u is the double integral of a cubic: −3ε·z
    z = sum(sp.Symbol(f"z{i}") * x**i for i in range(killed + 1))
    second = ((1 + small * z) ** 2) ** sp.Rational(-3, 2)
    first = sp.diff(second, small).subs(small, 0)
    gap = sp.Poly(sp.integrate(sp.integrate(sp.expand(sp.simplify(first)), x), x), x)
    line = f"{killed} derivatives of g, 2 of y: at most {bound}; differences have degree {gap.degree()}"
    return Evidence(integer(read(form, {})) == bound == gap.degree(), (line,))


#: curves with certainly monotone affine curvature on [−1, 1]: graphs over x
GRAPHS = ("x**2/2 + x**5/400", "1/(3 - x)**2", "(x + 2)**4")
TRIALS = 5


@claim(
    "R3.2-2",
    "A conic meets a strictly convex affine spiral arc in at most five points, counted with multiplicity; "
    "five are possible.",
    method=Method.PROOF,
    form="5, strictly convex",
    printed="5, k monotone",
    wrong=("4, strictly convex", "6, strictly convex", "5, turning < 2*pi"),
    erratum="An earlier version claimed this for all affine spirals, on numerical evidence: Archimedes' "
    "spiral on [π/6, 2π] meets a hyperbola six times. The arc must be strictly convex: it turns by "
    "less than 2π and makes angles A, B with its chord with sin A > 0, sin B > 0; a turning of at "
    "most π is enough.",
    own=True,
)
def five_points(form: str) -> Evidence:
    """Theorem A. Let F ≠ 0 be of degree ≤ 2, κ > 0 and dk/dr ≠ 0 on a strictly convex arc of class C⁵.

    1. If F = 0 is no ellipse, parabola or hyperbola, F has at most four zeros (X3.2-10). 2. If there are
    zeros on both branches of a hyperbola there are at most four (X3.2-8, X3.2-9): so let all be on one
    branch, or on the ellipse or parabola. 3. Six at one point are impossible by the Wronskian (X3.3-1). 4.
    Otherwise let P be the point of X3.2-4 for the sub-arc from the first to the last of six zeros: it is
    inside the conic, as the chord's middle is. In its chart the arc is a convex graph with (y″^(−2/3))‴ ≠ 0
    (X3.2-5). 5. The conic is two graphs there (X3.2-6), of which one contains all six zeros: the part of the
    branch on the arc's side of Y = 0 is connected in the projective plane. The concave one meets a convex
    graph twice at most; so it is the convex one, with u″^(−2/3) quadratic (X3.2-7). 6. By X3.2-11 there are
    five zeros at most.

    Ends: there dk/dr = 0 is allowed unless the osculating conic has six-fold contact. Where κ = 0 or in a
    cusp with a limit tangent the count holds with zeros at this end counted at most twice: y − u is
    continuously differentiable there, and Rolle's theorem puts the four zeros of y″ − u″ inside. Isolated
    zeros of dk/dr inside without a change of sign are allowed with the same exception, as g″ is strictly
    monotone still.

    All steps are proved again here. That five are possible: conics through five random rational points of
    rational graphs, all zeros counted exactly. Without strict convexity six zeros are certified (X3.2-12).
    """
    count, hypothesis = split(form, 2)
    stated = integer(read(count, {}))
    if hypothesis != "strictly convex":
        found, certain = six_zeros(hypothesis)
        return certain & Evidence(stated >= found, (f"zeros for the hypothesis {hypothesis}: {found}",))
    steps = strictly_convex("2*pi") & degenerate_conics("4") & inside_the_triangle(COORDINATES)
    steps &= tangent_separates("(s - t)^2/(s*t)") & chart_of_the_arc("w/Y^2, -(Y/w)^3")
    steps &= third_derivative("-2*dk_dr*Y^4/w") & chart_of_the_conic("(d^2 - a*f)/f^2")
    steps &= branch_of_the_conic("(4*b0*b2 - b1^2)/(4*B^(3/2))") & wronskian("-108*dk")
    most, line = _five_met()
    return steps & rolle(count) & Evidence(most == stated, (line,))


@cache
def _five_met() -> tuple[int, str]:
    """The most zeros found on conics through five points, and on what."""
    x = sp.Symbol("x")
    source = random.Random(32)
    most, conics = 0, 0
    for text in GRAPHS:
        graph = read(text, {"x": x})
        if not monotone_curvature(graph, x, sp.Rational(-1), sp.Rational(1)):
            return 0, f"k is not monotone on [−1, 1] for y = {text}"
        for _ in range(TRIALS):
            places = sorted(sp.Rational(n, 50) for n in source.sample(range(-50, 51), 5))
            rows = [[v.subs(x, at) for v in _monomials(x, graph)] for at in places]
            (conic,) = sp.Matrix(rows).nullspace()
            along = sum(c * v for c, v in zip(conic, _monomials(x, graph)))
            most = max(most, zeros_inside(along, x, sp.Rational(-1), sp.Rational(1)))
            conics += 1
    return (
        most,
        f"{conics} conics through five points of {len(GRAPHS)} graphs on [−1, 1]: at most {most} zeros",
    )


def _monomials(x: Any, y: Any) -> list[Any]:
    return [x * x, x * y, y * y, x, y, sp.S.One]
