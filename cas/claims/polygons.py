"""Claims on inscribed and circumscribed polygons (thesis 1.3.3, 3.1.1): Fejes Tóth, Ludwig, Gruber."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.asymptotics.arc_laws import arc_law
from osculant.cas.canonical import affine_arc, affine_graph
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import agrees, integers, read, vanishes

n, J, L, K = sp.symbols("n I lambda K", positive=True)

#: numbers of chords of the measured polygons, digits, and Newton steps to the next knot
COARSE, FINE, DIGITS, STEPS = 10, 20, 25, 4


def _total(primitive: str, metric: str) -> Any:
    """ε for n pieces, given the integral I of (|κ|)^{1/p} ds."""
    law = arc_law(primitive, metric)
    # ε = (c^{1/p} J)ᵖ n^{−1/rate}
    return law.constant * J**law.order / n ** (1 / law.rate)


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
    return vanishes(claimed - _total("polygon", "hausdorff"), "inscribed") & vanishes(
        claimed - _total("circumscribed polygon", "hausdorff"), "circumscribed"
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
        vanishes(read(form, {"I": J, "n": n}) - _total("polygon", "area"), "inscribed polygons") & _density()
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
            read(form, {"I": J, "n": n}) - _total("circumscribed polygon", "area"), "circumscribed polygons"
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


@cache
def _segment_area() -> tuple[list[Any], Any]:
    """Coefficients of ℓ⁰ … ℓ⁶ in the area of a segment, and the k in them.

    Coefficients of ℓ⁰ … ℓ⁶ in the area between an arc of affine length ℓ about its middle and its chord,
    with k.
    """
    ell = sp.Symbol("ell", positive=True)
    symbols = sp.symbols("k0:5", real=True)
    _, *jet = sp.ring(symbols, sp.QQ)
    X, Y, _ = affine_arc(7, jet)
    # twice the area: ∫[γ, γ′]dr from −ℓ/2 to ℓ/2 minus [γ(−ℓ/2), γ(ℓ/2)], both even or odd in ℓ
    x = sum(c.as_expr() * ell**i for i, c in enumerate(X.coefficients))
    y = sum(c.as_expr() * ell**i for i, c in enumerate(Y.coefficients))
    sector = sp.integrate(sp.expand(x * sp.diff(y, ell) - y * sp.diff(x, ell)), ell)
    ends = [{ell: sign * ell / 2} for sign in (-1, 1)]
    twice = (
        sector.subs(ends[1])
        - sector.subs(ends[0])
        - (x.subs(ends[0]) * y.subs(ends[1]) - y.subs(ends[0]) * x.subs(ends[1]))
    )
    series = sp.Poly(sp.expand(twice / 2), ell)
    return [sp.factor(series.coeff_monomial(ell**i)) for i in range(7)], symbols[0]


def _ludwig() -> Any:
    """Both terms for n arcs of equal affine length λ/n: the k in the middle of each adds up to n·∫k dr/λ."""
    areas, k = _segment_area()
    return n * sum(c * (L / n) ** i for i, c in enumerate(areas)).subs(k, K / L)


@claim(
    "section 1.3.3-2",
    "Ludwig's second term for inscribed polygons: δ_S = λ³/(12n²) − (λ⁴/(2·5!))∫k dr/n⁴ + o(1/n⁴), λ "
    "the affine "
    "length of the closed curve.",
    method=Method.PROOF,
    form="lambda**3/(12*n**2) - lambda**4*K/(240*n**4)",
    wrong=(
        "lambda/(12*n**2) - lambda**4*K/(240*n**4)",
        "lambda**3/(12*n**2) - lambda**4*K/(120*n**4)",
        "lambda**3/(12*n**2) + lambda**4*K/(240*n**4)",
    ),
)
def ludwig_inscribed(form: str) -> Evidence:
    """The area of a segment from the canonical form, summed over n arcs.

    The segment over an arc of affine length ℓ about a point with affine curvature k has area ℓ³/12 − kℓ⁵/240
    + O(ℓ⁷), from the canonical form. For n arcs of length λ/n the first terms add up to λ³/12n², the second
    ones to (λ/n)⁴/240 times a midpoint sum of ∫k dr, which is K up to O(n⁻²). Moving the knots from equal
    affine length by the O(n⁻³) that the best polygon asks for changes the sum of the cubes in second order
    only.
    """
    areas, _ = _segment_area()
    rest = [c for i, c in enumerate(areas) if i % 2 == 0]
    claimed = read(form, {"lambda": L, "K": K, "n": n})
    evidence = vanishes(sum(abs(c) for c in rest), "even orders of the segment's area")
    return evidence & vanishes(claimed - _ludwig(), "two terms of the area")


@claim(
    "section 1.3.3-2.1",
    "The remainder of Ludwig's expansion is smaller than its second term: o(1/n⁴), and O(1/n⁶) for a "
    "smooth curve.",
    method=Method.EXACT,
    form="6",
    printed="4",
    erratum="Ludwig's expansion is printed with remainder O(1/n⁴), which would swallow its second term: it "
    "is "
    "o(1/n⁴).",
    wrong=("5",),
)
def ludwig_remainder(form: str) -> Evidence:
    """On the unit circle the best inscribed polygon is regular.

    On the unit circle the best inscribed polygon is regular, with area (n/2)sin(2π/n): the difference π −
    (n/2)sin(2π/n), as a series in 1/n, minus both terms (λ = 2π, ∫k dr = 2π). The form is the first power of
    1/n that is left.
    """
    u = sp.Symbol("u", positive=True)  # 1/n
    terms = _ludwig()
    exact = sp.pi - sp.series(sp.sin(2 * sp.pi * u), u, 0, 10).removeO() / (2 * u)
    rest = sp.Poly(sp.expand(exact - terms.subs({L: 2 * sp.pi, K: 2 * sp.pi, n: 1 / u})), u)
    lowest = min(m[0] for m in rest.monoms())
    first = rest.coeff_monomial(u**lowest)
    return vanishes(read(form, {}) - lowest, f"first power left on the circle, with coefficient {first}")


@claim(
    "section 1.3.3-2.2",
    "Gruber's expansion δ_S = c/n^(2/(d−1)) has a remainder that tends to 0 faster; for d = 2 it is O(1/n⁴).",
    method=Method.EXACT,
    form="4",
    printed="0",
    erratum="Gruber's asymptotic formulas for polytopes are printed with remainder O(1), which exceeds their "
    "only "
    "term: it is o(n^(−2/(d−1))), for d = 3 o(1/n).",
    wrong=("2", "3"),
)
def gruber_remainder(form: str) -> Evidence:
    """On the unit circle: π − (n/2)sin(2π/n) minus λ³/12n², λ = 2π.

    The form is the first power of 1/n left.
    """
    u = sp.Symbol("u", positive=True)  # 1/n
    exact = sp.pi - sp.series(sp.sin(2 * sp.pi * u), u, 0, 10).removeO() / (2 * u)
    first = _total("polygon", "area").subs({J: 2 * sp.pi, n: 1 / u})
    lowest = min(m[0] for m in sp.Poly(sp.expand(exact - first), u).monoms())
    return vanishes(read(form, {}) - lowest, "first power left on the circle")


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
