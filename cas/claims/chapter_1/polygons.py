"""Claims on inscribed and circumscribed polygons (thesis 1.3.3, 3.1.1): Fejes Tóth, Ludwig, Gruber."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.claims.chapter_1.polygon_totals import J, n, total
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import agrees, integers, read, vanishes
from osculant.cas.jets.canonical import affine_graph
from osculant.cas.laws.arcs import arc_law

#: numbers of chords of the measured polygons, digits, and Newton steps to the next knot
COARSE, FINE, DIGITS, STEPS = 10, 20, 25, 4


@claim(
    "section 1.3.3-1",
    "δ_H(C, Pₙ) = (1/8)(∫√κ ds)²/n² + o(1/n²) for best inscribed and best circumscribed polygons.",
    method=Method.PROOF,
    form="I**2/(8*n**2)",
    wrong=("I**2/(4*n**2)", "I/(8*n**2)", "I**2/(8*n)"),
)
def hausdorff_polygons(form: str) -> Evidence:
    """The chord of an arc of length σ, as a series: displacement κ(1 − x²)h²/2, h = σ/2, so κσ²/8.

    Tangents touching σ apart meet over the middle at the same distance, κσ²/8. With equal errors
    n = ∫√(κ/8ε) ds, so ε = (∫√κ ds)²/8n². The integral I stands for ∫√κ ds.
    """
    claimed = read(form, {"I": J, "n": n})
    return vanishes(claimed - total("polygon", "hausdorff"), "inscribed") & vanishes(
        claimed - total("circumscribed polygon", "hausdorff"), "circumscribed"
    )


@claim(
    "(3.1)",
    "The best inscribed n-gon has δ_H = (1/8)(∫√κ ds)²/n², remainder O(1/n⁴) on closed curves: "
    "for an ellipse with axes 2 and 1 as measured.",
    method=Method.NUMERICAL,
    reason="the coefficient is proved in section 1.3.3-1; the order of the remainder is measured on one "
    "curve",
    form="2, 4",
    wrong=("2, 3", "3, 4"),
)
def fejes_toth(form: str) -> Evidence:
    """n chords with equal share of ∫√κ ds on an ellipse; the largest of their errors, maximised along each.

    The form holds the powers of 1/n of the first term and of the remainder, both found from n and 2n.
    """
    first, following = integers(form, 2)
    with mp.workdps(DIGITS):
        content, errors = _ellipse_polygons()
        leading = mp.mpf(arc_law("polygon").constant.p) / arc_law("polygon").constant.q * content**2
        ratio = mp.log(errors[COARSE] / errors[FINE], 2)
        rest = [errors[m] - leading / mp.mpf(m) ** first for m in (COARSE, FINE)]
        slope = mp.log(abs(rest[0] / rest[1]), 2)
        return agrees(ratio, first, 2, "order of the error") & agrees(
            slope, following, 1.5, "of the remainder"
        )


@cache
def _ellipse_polygons() -> tuple[Any, dict[int, Any]]:
    """∫√κ ds of the quarter ellipse (2cos t, sin t), and the largest error of each number of chords on it."""

    def density(t: Any) -> Any:
        return mp.sqrt(2) / mp.root(4 * mp.sin(t) ** 2 + mp.cos(t) ** 2, 4)

    content = mp.quad(density, mp.linspace(0, mp.pi / 2, 5))
    errors = {}
    for count in (COARSE, FINE):
        knots, share = [mp.mpf(0)], content / count
        for _ in range(count):
            start, end = knots[-1], knots[-1] + share / density(knots[-1])
            for _ in range(STEPS):
                end -= (mp.quad(density, [start, end]) - share) / density(end)
            knots.append(end)
        errors[count] = max(_sagitta(p, q) for p, q in pairwise(knots))
    return content, errors


def _sagitta(start: Any, end: Any) -> Any:
    """The largest distance of a chord from the ellipse.

    The chord's distance is largest where the tangent is parallel to it: the middle parameter of an ellipse.
    """
    p, q, m = ((2 * mp.cos(t), mp.sin(t)) for t in (start, end, (start + end) / 2))
    dx, dy = q[0] - p[0], q[1] - p[1]
    return abs(dx * (m[1] - p[1]) - dy * (m[0] - p[0])) / mp.hypot(dx, dy)


@claim(
    "section 3.1.1-1",
    "A polygon within ε needs c·ε^(−1/2) chords with c = (1/(2√2))∫√κ ds.",
    method=Method.PROOF,
    form="I/(2*sqrt(2))",
    wrong=("I/(4*sqrt(2))", "I/2", "I/8"),
)
def polygon_complexity(form: str) -> Evidence:
    """Solve ε = (∫√κ ds)²/8n² for n."""
    law = arc_law("polygon")
    return vanishes(read(form, {"I": J}) - law.count_constant(J), "number of chords times √ε")


@claim(
    "section 3.1.1-2",
    "The first relative correction to the number of chords, c·ε^(−1/2)(1 + O(ε)): from ε = A/n² + B/n⁴ the "
    "correction is of order ε.",
    method=Method.PROOF,
    form="1",
    wrong=("1/2", "2"),
)
def polygon_complexity_remainder(form: str) -> Evidence:
    """n²ε = A + B/n², and 1/n² = ε/A + …, so n = √(A/ε)·(1 + Bε/2A² + …): the power of ε in the bracket."""
    A, B, e = sp.symbols("A B e", positive=True)
    square = (A + sp.sqrt(A**2 + 4 * B * e)) / (2 * e)  # the solution n² of ε n⁴ = A n² + B near A/ε
    relative = sp.series(sp.sqrt(square * e / A), e, 0, 2).removeO() - 1
    order = sp.degree(sp.expand(relative), e)
    lowest = min(m[0] for m in sp.Poly(relative, e).monoms())
    return vanishes(
        read(form, {}) - lowest, f"order of the correction {sp.factor(relative)} (degree {order})"
    )


@claim(
    "(1.4.1)",
    "δ_S(C, Pₙ) = (1/12)(∫κ^(1/3) ds)³/n² for best inscribed polygons, to first order.",
    method=Method.PROOF,
    form="I**3/(12*n**2)",
    wrong=("I**3/(24*n**2)", "I**2/(12*n**2)", "I**3/(6*n**2)"),
)
def area_inscribed(form: str) -> Evidence:
    """Integrate the chord's displacement, then place the knots.

    The area between an arc and its chord is κσ³/12 (integral of the displacement); ∫κσ³… is minimised under
    ∫ν ds = n by a knot density ν proportional to κ^{1/3}. I stands for ∫κ^{1/3} ds.
    """
    return (
        vanishes(read(form, {"I": J, "n": n}) - total("polygon", "area"), "inscribed polygons") & _density()
    )


@claim(
    "(1.4.2)",
    "δ_S(C, Pₙ) = (1/24)(∫κ^(1/3) ds)³/n² for best circumscribed polygons, to first order.",
    method=Method.PROOF,
    form="I**3/(24*n**2)",
    wrong=("I**3/(12*n**2)", "I**3/(48*n**2)"),
)
def area_circumscribed(form: str) -> Evidence:
    """The same with the area κσ³/24 between the tangent in the middle and the arc."""
    return (
        vanishes(
            read(form, {"I": J, "n": n}) - total("circumscribed polygon", "area"), "circumscribed polygons"
        )
        & _density()
    )


def _density() -> Evidence:
    """The Euler–Lagrange equation of ∫ gν^{1−p} ds with ∫ν ds fixed, and the total it gives."""
    p = arc_law("polygon", "area").order
    g, nu, multiplier = sp.symbols("g nu m", positive=True)
    stationary = sp.solve(sp.diff(g * nu ** (1 - p) + multiplier * nu, nu), nu)
    best = next(s for s in stationary if s.is_positive)
    # ν = g^{1/p}·(a constant): so ν = n g^{1/p}/∫g^{1/p}, and the density of the total is g^{1/p} too
    return vanishes(
        sp.diff(sp.log(best), g) * g - sp.Rational(1, p), "exponent of the knot density"
    ) & vanishes(
        sp.diff(sp.log((g * nu ** (1 - p)).subs(nu, best)), g) * g - sp.Rational(1, p),
        "exponent of the total",
    )


@claim(
    "section 3.1.1-3",
    "Ludwig's parabolic splines: δ_S(C, Qₙ) = (1/240)(∫|k|^(1/5) dr)⁵/n⁴ + o(1/n⁴), k the affine "
    "curvature over "
    "affine arc length r; so one arc of affine length ℓ costs |k|ℓ⁵/240.",
    method=Method.PROOF,
    form="k*l**5/240",
    printed="kappa*l**5/240",
    erratum="Ludwig's formula for parabolic splines prints the Euclidean curvature κ^(1/5) under the "
    "integral: it is "
    "the affine curvature |k|^(1/5).",
    wrong=("k*l**5/120", "k*l**4/240"),
)
def ludwig_parabolic(form: str) -> Evidence:
    """Integrate the displacement of a bitangent parabola in the affine frame.

    A bitangent parabola lacks the x⁴ term of the canonical form, so it lies at that coefficient times x²(ℓ −
    x)² from the curve. In affine coordinates areas are areas: integrate from 0 to ℓ. (Affine curvature and
    curvature are independent: k = 0 on every parabola.)
    """
    k, kappa, ell = sp.symbols("k kappa l", positive=True)
    ring, *jet = sp.ring([k, *sp.symbols("k1:3")], sp.QQ)
    y, _ = affine_graph(5, (*jet, ring.zero))
    at = sp.Symbol("x")
    area = sp.integrate(sp.expand(y[4].as_expr() * at**2 * (ell - at) ** 2), (at, 0, ell))
    return vanishes(read(form, {"k": k, "kappa": kappa, "l": ell}) - area, "area between parabola and curve")
