"""Claims of section 3.2.3 and Remark 3.5.3: the conic through five points of a curve."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import cache
from itertools import combinations
from typing import Any

import sympy as sp
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.five_points import POINTS, Conic, five_point_conic, orthogonal_conic, veronese
from osculant.cas.jets.canonical import affine_arc
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.division import hermite_genocchi, newton_of_polynomial, scaled_difference
from osculant.cas.numbers.power_series import PowerSeries, power

k = sp.symbols("k0:6", real=True)
places = sp.symbols("a1:6", real=True)
X, Y, t = sp.symbols("x y t", real=True)


@cache
def conic_curvature(order: int) -> PowerSeries:
    """k of the conic through a curve's points at r = ρa₁, …, ρa₅, as a series in ρ with order − 3 terms.

    The curve is given by affine arc length r in its affine frame at 0 up to r^order; k0, k1, … are k and its
    derivatives at 0.
    """
    names = [str(s) for s in (*k[: order - 2], *places)]
    symbols = fmpq_mpoly_ctx.get(names, Ordering.degrevlex).gens()
    jets, at = symbols[: order - 2], symbols[order - 2 :]
    image = veronese(*affine_arc(order, jets)[:2])
    rows = [[scaled_difference(entry, at[: i + 1]) for entry in image] for i in range(POINTS)]
    conic = orthogonal_conic(rows)
    scaled = Conic(*(c * (1 / conic.a[0]) for c in conic))  # x² − 2y + … = 0, so that T begins with −1
    curvature: PowerSeries = scaled.S * power(scaled.T * scaled.T, Fraction(-1, 3))
    return curvature


def _expression(element: Any) -> Any:
    return sp.sympify(str(element).replace("^", "**"), locals={str(s): s for s in (*k, *places)})


@claim(
    "(3.2)",
    "det(Ψ(x, y), Ψ(p₁), …, Ψ(p₅)) = 0 with Ψ = (x², xy, y², x, y, 1) is the conic through p₁, …, p₅.",
    method=Method.EXACT,
    form="x**2, x*y, y**2, x, y, 1",
    wrong=("x**2, x*y, y**2, x, y, x + y", "x**2, x*y, y**3, x, y, 1", "x**2, x*y, y**2, x, y, y"),
)
def veronese_determinant(form: str) -> Evidence:
    """The form is Ψ. The determinant is expanded along Ψ(x, y) for three random choices of rational points.

    It must be a polynomial of degree at most 2, not 0 identically, and 0 at the five points.
    """
    source, evidence = random.Random(32), Evidence(True)
    image = read_tuple(form, {"x": X, "y": Y}, 6)
    for _ in range(3):
        points = [tuple(sp.Rational(source.randint(-30, 30), 7) for _ in "xy") for _ in range(POINTS)]
        rows = sp.Matrix([[e.subs({X: p, Y: q}, simultaneous=True) for e in image] for p, q in points])
        minors = [rows.extract(range(POINTS), [i for i in range(6) if i != j]).det() for j in range(6)]
        equation = sp.Poly(
            sum((-1) ** j * e * minor for j, (e, minor) in enumerate(zip(image, minors))), X, Y
        )
        degree = -1 if equation.is_zero else equation.total_degree()
        missed = [point for point in points if equation.eval(point) != 0]
        line = f"five points from {points[0]} to {points[-1]}: degree {degree}, {len(missed)} points missed"
        evidence &= Evidence(0 < degree <= 2 and not missed, (line,))
    return evidence


FACTORS = "*".join(f"(s{j} - s{i})" for i, j in combinations(range(1, POINTS + 1), 2))


@claim(
    "lemma 3.2.4.1",
    "det(Ψ(x), Ψ(α(s₁)), …, Ψ(α(s₅))) is the product of sₖ − sⱼ, j < k, times the determinant with the "
    "divided "
    "differences [s₁, …, sₖ](Ψ∘α) as rows.",
    method=Method.PROOF,
    form=FACTORS,
    wrong=(FACTORS.replace("s2 - s1", "s1 - s2"), FACTORS.replace("(s2 - s1)*", ""), f"3/2*{FACTORS}"),
)
def division_by_differences(form: str) -> Evidence:
    """The cofactors of the first row, polynomials: once with values as rows and once with differences.

    First for (1, t, …, t⁵) in place of Ψ∘α, of which every polynomial map of degree 5 is a linear image; then
    for Ψ on α = (t, c₂t² + c₃t³). c₂, c₃ and s₁, …, s₅ are symbols; the form must be the quotient.
    """
    s = sp.symbols("s1:6")
    stated = sp.Poly(sp.expand(read(form, {symbol.name: symbol for symbol in s})), *s)
    context = fmpq_mpoly_ctx.get(["c2", "c3", *(symbol.name for symbol in s)], Ordering.degrevlex)
    product = context.from_dict({(0, 0, *e): fmpq(int(c.p), int(c.q)) for e, c in stated.as_dict().items()})
    c2, c3, *at = context.gens()
    zero, one = context.constant(0), context.constant(1)
    moments = [[zero] * i + [one] for i in range(6)]
    image = veronese(PowerSeries([zero, one, *[zero] * 5]), PowerSeries([zero, zero, c2, c3, *[zero] * 3]))
    evidence = Evidence(True)
    for what, map_ in (("(1, t, …, t⁵)", moments), ("Ψ", [list(e.coefficients) for e in image])):
        developed = [newton_of_polynomial(coordinate, at) for coordinate in map_]
        apart = orthogonal_conic([[coordinate(node) for coordinate in developed] for node in at])
        divided = orthogonal_conic(list(zip(*(coordinate.coefficients for coordinate in developed))))
        same = all(left == product * right for left, right in zip(apart, divided))
        relation = "are" if same else "are not"
        evidence &= Evidence(
            same, (f"{what}: cofactors of values {relation} the form times those of differences",)
        )
    return evidence


@claim(
    "lemma 3.2.4.2",
    "For a curve of class Cᵐ, m ≥ 4, the coefficients of the five-point conic are functions of class Cᵐ⁻⁴ of "
    "(s₁, …, s₅), and no better in general.",
    method=Method.PROOF,
    form="m - 4",
    wrong=("m - 5", "m - 3"),
)
def class_of_the_conic(form: str) -> Evidence:
    """[s₁, …, s₅](Ψ∘α) is of order 4, hence of class Cᵐ⁻⁴ (section A.1-3), and so are the cofactors.

    It is sharp where all points coincide: there the conic is that of the jet, of which derivatives are the
    last ones its coefficients contain. They are listed for a graph with symbols for the derivatives up to
    order 7; the first coefficient does not contain that order, so that no factor common to all can remove it.
    """
    m, order = sp.Symbol("m"), 7
    heights = sp.symbols(f"y2:{order + 1}")
    jet = PlaneJet((0, 1, *[0] * (order - 1)), (sp.S.Zero, sp.S.Zero, *heights))
    conic = five_point_conic(lambda _, __: jet, (0,) * POINTS)
    present = [sp.expand(c).free_symbols for c in conic]
    last = max(i for i, symbol in enumerate(heights, 2) if any(symbol in found for found in present))
    line = f"derivatives in the coefficients of the osculating conic: up to order {last} of {order}"
    common = heights[last - 2] in sp.expand(conic.e).free_symbols
    return Evidence(not common, (line,)) & vanishes(read(form, {"m": m}) - (m - last), "class")


@claim(
    "section 3.2-4",
    "Five distinct points of a strictly convex arc determine their conic; those of a curve without sextactic "
    "points need not.",
    method=Method.EXACT,
    form="strictly convex",
    printed="without sextactic points",
    erratum="Section 3.2.3 takes the five-point conic of a curve without sextactic points for unique; "
    "the spiral "
    "(t cos t, t sin t), t > 0, has none but has four and more points on a line: strict convexity is "
    "what it takes.",
    wrong=("regular",),
)
def uniqueness(form: str) -> Evidence:
    """Strictly convex: no three points lie on a line. An affine map takes three to (0, 0), (1, 0), (0, 1).

    Through these pass px(x − 1) + qxy + sy(y − 1) = 0; two more points (a, b) and (c, d) give two equations
    for p, q, s, dependent only if bd(a(d − 1) − c(b − 1)) = 0: if one lies on a line through two of the
    three, or both on a line with (0, 1). Otherwise: dk/dr of the spiral is computed in the frame that turns
    with t, where its jet is polynomial in t, and five of its points are taken, four of them on the x-axis.
    """
    if form == "strictly convex":
        a, b, c, d = sp.symbols("a b c d")
        equations = [(p * (p - 1), p * q, q * (q - 1)) for p, q in ((a, b), (c, d))]
        minor = equations[0][1] * equations[1][2] - equations[0][2] * equations[1][1]
        lines = (
            b * d * sp.Matrix([[0, 1, 1], [a, b, 1], [c, d, 1]]).det()
        )  # the points (0, 1), (a, b), (c, d)
        return vanishes(minor - lines, "minor of the two equations, and the lines")
    if form == "regular":
        graph = PlaneJet([0, 1, *[0] * 4], [sp.Integer(i) for i in (0, 0, 0, 0, 1, 0)])
        return _determined(lambda _, __: graph, (0,) * POINTS)
    if form != "without sextactic points":
        raise DomainError(f"No form {form!r}: 'strictly convex', 'without sextactic points' or 'regular'.")
    turned = [sp.I**j * t + j * sp.I ** (j - 1) for j in range(6)]  # dʲ(t eⁱᵗ)/dtʲ · e⁻ⁱᵗ
    frame = PlaneJet([sp.re(z) for z in turned], [sp.im(z) for z in turned])
    sextactic = sp.Poly(sp.expand(frame.sextactic_form), t)
    signs = {sp.sign(c) for c in sextactic.coeffs()}
    none = Evidence(len(signs) == 1, (f"27D⁴ dk/dr = {sextactic.as_expr()}: no zero for t > 0",))

    def spiral(at: Any, order: int) -> PlaneJet:
        x, y = (
            [sp.diff(e, t, i).subs(t, at) for i in range(order + 1)] for e in (t * sp.cos(t), t * sp.sin(t))
        )
        return PlaneJet(x, y)

    return none & _determined(spiral, [sp.pi * i for i in (1, 2, 3, 4)] + [sp.pi / 2])


def _determined(curve: Any, parameters: Any) -> Evidence:
    try:
        conic = five_point_conic(curve, parameters)
    except DomainError as error:
        return Evidence(False, (str(error),))
    return Evidence(True, (f"the conic {tuple(conic)} is determined",))


@claim(
    "remark 3.5.3.1",
    "The affine curvature of the conic through five points of a curve is the mean of k at these points, "
    "up to "
    "quadratic terms in the affine length.",
    method=Method.PROOF,
    form="(k(a1) + k(a2) + k(a3) + k(a4) + k(a5))/5",
    wrong=("(2*k(a1) + k(a3) + 2*k(a5))/5", "(k(a1) + k(a2) + k(a3) + k(a4) + k(a5))/4", "k(a3)"),
)
def mean_of_curvatures(form: str) -> Evidence:
    """The points are at r = ρa₁, …, ρa₅ of a curve with k = k₀ + k₁r + k₂r²/2 + ….

    The conic of the divided differences (scaled by ρ) is a series in ρ with coefficients in ℚ[k₀, …, a₁, …],
    and so is its k = S·(T²)^(−1/3). It must agree with the form up to ρ, whatever the places, coincident ones
    included; at ρ² it must not, or more would be true than is claimed.
    """
    found = conic_curvature(6)
    symbols = {f"m{i}": k[0] + k[1] * t * a + k[2] * (t * a) ** 2 / 2 for i, a in enumerate(places, 1)}
    text = form
    for i in range(1, POINTS + 1):
        text = text.replace(f"k(a{i})", f"m{i}")
    stated = sp.Poly(read(text, symbols), t)
    evidence = Evidence(True)
    for i in (0, 1):
        evidence &= vanishes(stated.coeff_monomial(t**i) - _expression(found[i]), f"coefficient of ρ^{i}")
    beyond = sp.factor(stated.coeff_monomial(t**2) - _expression(found[2]))
    return evidence & Evidence(beyond != 0, (f"difference at ρ²: {beyond}",))


@claim(
    "X3.2-1",
    "Up to cubic terms that affine curvature is 4! times the integral of k(t₁r₁ + … + t₅r₅) over the "
    "simplex, the "
    "mean of k weighted with the B-spline of the five points.",
    method=Method.PROOF,
    form="24",
    wrong=("1", "120", "5"),
)
def spline_mean_of_curvatures(form: str) -> Evidence:
    """The form is the factor before the integral, which is [r₁, …, r₅]K with K⁗ = k (Hermite–Genocchi).

    Both are series in ρ for the points r = ρaᵢ: the integral is computed over the simplex for a polynomial k,
    the conic's k as for the remark. They agree at 1, ρ and ρ², and differ at ρ³.
    """
    found, factor = conic_curvature(7), read(form, {})
    evidence = Evidence(True)
    for i in range(4):
        # K with K⁗ = kᵢrⁱ/i!, homogeneous, so that its integral is the coefficient of ρⁱ
        antiderivative = [sp.S.Zero] * (i + 4) + [k[i] / sp.factorial(i + 4)]
        difference = sp.expand(factor * hermite_genocchi(antiderivative, places) - _expression(found[i]))
        if i < 3:
            evidence &= vanishes(difference, f"coefficient of ρ^{i}")
        else:
            example = difference.subs(dict(zip(places, (1, 0, 0, 0, 0))))
            evidence &= Evidence(example != 0, (f"difference at ρ³ for a = (1, 0, 0, 0, 0): {example}",))
    return evidence
