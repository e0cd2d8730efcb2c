"""Section 3.6.1: the Hausdorff distance of short parabolic and conic arcs, and the number of pieces."""

from __future__ import annotations

from fractions import Fraction
from math import factorial
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.arc_displacement import KAPPA
from osculant.cas.asymptotics.optimal_conic import mean_end_curvature, optimal_curvature
from osculant.cas.asymptotics.short_arcs import arc_error
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import positive, read, read_tuple, rounding, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.pencil import lobe_shape, lobes
from osculant.cas.jets.canonical import euclidean_arc
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.conics import canonical_coefficients
from osculant.cas.numbers.power_series import PowerSeries, power

#: κ = c³, so that κ^{1/3} is rational
c = sp.Symbol("c", positive=True)
rho, sigma = sp.symbols("rho sigma", positive=True)
D = sp.Symbol("D", positive=True)


def affine_symbols() -> dict[str, Any]:
    """κ, k, dk/dr and dk/ds of a generic curve in κ = c³ and the derivatives κ₁, κ₂, … by arc length."""
    X, Y, _ = euclidean_arc(5, [c**3, *KAPPA[1:4]])
    rows = [[sp.expand(a * factorial(n)) for n, a in enumerate(row.coefficients)] for row in (X, Y)]
    jet = PlaneJet(rows[0], rows[1], root=lambda _, degree: c if degree == 3 else sp.Integer(1))
    slope = jet.affine_curvature_slope
    return {"kappa": c**3, "k": jet.affine_curvature, "dk_dr": slope, "dk_ds": slope * c}


def derived_error(primitive: str) -> Any:
    """e₀ of an arc from the contact conditions, κ = c³."""
    law = arc_error(primitive)
    return (law.leading * sp.sqrt(law.root)).subs(KAPPA[0], c**3)


def equal_error(form: str, primitive: str, exponent: int = 1) -> Evidence:
    """Whether the form, to that power, is e₀ of the primitive, for k or dk/dr positive."""
    k, kappa, dk_dr, dk_ds = (sp.Symbol(s, positive=True) for s in ("k", "kappa", "dk_dr", "dk_ds"))
    text = {"k": k, "kappa": kappa, "dk_dr": dk_dr, "dk_ds": dk_ds}
    stated = read(form, text)
    expression = sp.powsimp(sp.expand_power_base(stated**exponent))
    values = affine_symbols()
    inserted = expression.subs({symbol: values[name] for name, symbol in text.items()}, simultaneous=True)
    identity = vanishes(inserted - derived_error(primitive), f"leading error of a {primitive}")
    return identity & positive(stated, "the form")


@claim(
    "theorem 3.6.1.1",
    "A bitangent parabola of an arc of Euclidean length σ has the Hausdorff distance "
    "|k|κ^(5/3)σ⁴/128 + O(σ⁵).",
    method=Method.PROOF,
    form="k*kappa^(5/3)/128",
    wrong=("k*kappa^(5/3)/120", "k*kappa^(4/3)/128", "dk_dr*kappa^(5/3)/128"),
)
def parabola_error(form: str) -> Evidence:
    """The displacement from F(α + dN) = 0 as a series in the length, Q the parabola's, for a generic curve.

    Its extreme value near the middle has the leading coefficient e₀, a polynomial in κ and its derivatives;
    k is put in from the jet of the arc in its Frenet frame.
    """
    return equal_error(form, "parabola")


@claim(
    "theorem 3.6.1.2",
    "The best bitangent conic of an arc of length σ has the Hausdorff distance |dk/dr|κ²σ⁵/(2000√5) + O(σ⁶), "
    "r being affine arc length.",
    method=Method.PROOF,
    form="dk_dr*kappa^2/(2000*sqrt(5))",
    wrong=("dk_ds*kappa^2/(2000*sqrt(5))", "dk_dr*kappa^2/2000", "dk_dr*kappa^(5/3)/(2000*sqrt(5))"),
)
def conic_error(form: str) -> Evidence:
    """The error as a series in the arc's length, Q being a series that makes both extremes of d opposite."""
    return equal_error(form, "conic")


@claim(
    "(3.12)",
    "(3.14) and (3.15) with D(0,0) = −kκ^(1/3)/8 give δ = |k|κ^(5/3)σ⁴/128.",
    method=Method.PROOF,
    form="k*kappa^(5/3)/128",
    wrong=("k*kappa^(4/3)/128", "k*kappa^(5/3)/64"),
)
def parabola_by_steps(form: str) -> Evidence:
    """The factor 1/8 of k in the canonical form, the height of x²(1 − x)², ρ = κ^{1/3}σ and N·n = κ^{1/3}."""
    return _by_steps(form, 0, "k")


@claim(
    "(3.13)",
    "(3.15) and (3.16) with D(0,0,0) = −(dk/dr)κ^(1/3)/40 give δ = |dk/dr|κ²σ⁵/(2000√5).",
    method=Method.PROOF,
    form="dk_dr*kappa^2/(2000*sqrt(5))",
    wrong=("dk_dr*kappa^(5/3)/(2000*sqrt(5))", "dk_dr*kappa^2/(1000*sqrt(5))"),
)
def conic_by_steps(form: str) -> Evidence:
    """The factor 1/40 of dk/dr in the canonical form, the height of x²(1 − x)²(x − 1/2), those scales."""
    return _by_steps(form, 1, "dk_dr")


def _by_steps(form: str, crossings: int, name: str) -> Evidence:
    invariant, kappa = sp.symbols(f"{name} kappa", positive=True)
    shape, x = lobe_shape(crossings)
    height = sp.Abs(shape.subs(x, lobes(crossings)["first"]))
    displacement = sp.Rational(canonical_coefficients()[crossings]) * invariant * kappa ** sp.Rational(1, 3)
    affine = _affine_length().subs(c, kappa ** sp.Rational(1, 3))
    derived = height * displacement * affine ** (4 + crossings)
    return vanishes(read(form, {name: invariant, "kappa": kappa}) - derived, "composition of the steps")


def _affine_length() -> Any:
    """ρ/σ of a short arc: the leading coefficient of ∫[α′, α″]^{1/3} ds."""
    X, Y, _ = euclidean_arc(4, [c**3, *KAPPA[1:3]])
    (x1, y1), (x2, y2) = (
        (X.derivative(), Y.derivative()),
        (X.derivative().derivative(), Y.derivative().derivative()),
    )
    content = x1.cut(3) * y2 - y1.cut(3) * x2
    return power(content, Fraction(1, 3), c).integral()[1]


@claim(
    "(3.14)",
    "The displacement u²(ρ − u)²D(u, ρ) has the maximum |D(0,0)|ρ⁴/16 + O(ρ⁵).",
    method=Method.PROOF,
    form="D*rho^4/16",
    wrong=("D*rho^4/12", "D*rho^3/16"),
)
def parabola_lobe(form: str) -> Evidence:
    """All critical points of u²(ρ − u)² on [0, ρ], the largest value there.

    With D(u, ρ) = D + D_u u + D_ρ ρ + … and u = xρ the rest is ρ⁵x²(1 − x)²(xD_u + D_ρ) + …: O(ρ⁵), whatever
    x.
    """
    u, part = sp.symbols("u x")
    slopes = sp.symbols("D_u D_rho")
    general = part**2 * (1 - part) ** 2 * rho**4 * (D + slopes[0] * part * rho + slopes[1] * rho)
    leading = sp.Poly(sp.expand(general), rho)
    rest = vanishes(
        leading.coeff_monomial(rho**4) - part**2 * (1 - part) ** 2 * D, "coefficient of ρ⁴ along the arc"
    ) & Evidence(min(n for (n,) in leading.monoms()) == 4, ("the next power of ρ is 5",))
    shape = u**2 * (rho - u) ** 2
    top = max((sp.expand(shape.subs(u, p)) / rho**4 for p in sp.solve(sp.diff(shape, u), u)), key=float)
    return rest & vanishes(read(form, {"D": D, "rho": rho}) - top * D * rho**4, "height of the lobe")


@claim(
    "(3.15)",
    "A short arc of Euclidean length σ has the affine length ρ = κ^(1/3)σ + O(σ²).",
    method=Method.PROOF,
    form="kappa^(1/3)*sigma",
    wrong=("sqrt(kappa)*sigma", "kappa^(2/3)*sigma"),
)
def affine_length(form: str) -> Evidence:
    """The series of [α′, α″]^{1/3} for a generic curve in its Frenet frame, integrated."""
    claimed = read(form, {"kappa": c**3, "sigma": sigma})
    return vanishes(claimed - _affine_length() * sigma, "ρ in terms of σ")


@claim(
    "(3.16)",
    "u²(u − σ)(ρ − u)²D has two lobes, equal exactly for σ = ρ/2 to leading order, and then of height "
    "|D|ρ⁵/(50√5).",
    method=Method.PROOF,
    form="1/(50*sqrt(5)), 1/2",
    wrong=("1/(50*sqrt(5)), 1/3", "1/50, 1/2", "1/(25*sqrt(5)), 1/2"),
)
def conic_lobes(form: str) -> Evidence:
    """Heights of both lobes of x²(1 − x)²(x − z) for the z given, and whether they are equal and as claimed.

    Moving z to the right raises the first lobe and lowers the second, so no other z makes them equal.
    """
    height, crossing = read_tuple(form, {}, 2)
    x = sp.Symbol("x")
    shape = x**2 * (1 - x) ** 2 * (x - crossing)
    peaks = [p for p in sp.solve(sp.diff(shape, x), x) if p not in (0, 1)]
    found = [abs(sp.radsimp(sp.expand(shape.subs(x, p)))) for p in peaks]
    moved = sp.diff(x**2 * (1 - x) ** 2 * (x - D), D)
    monotone = Evidence(sp.expand(moved + x**2 * (1 - x) ** 2) == 0, ("∂/∂z is −x²(1 − x)² < 0 inside",))
    result = monotone
    for value in found:
        result &= vanishes(value - height, f"height of a lobe crossing at {crossing}")
    return result


@claim(
    "remark 3.6.2",
    "The best bitangent conic has the mean of the curve's affine curvatures at the two ends as its "
    "own, up to "
    "O(ρ²).",
    method=Method.PROOF,
    form="mean of the ends",
    wrong=("curvature at the start", "curvature at the end"),
)
def mean_curvature(form: str) -> Evidence:
    """k of the conic from its matrix, as a series in the arc's length with κ = 1, Q from equioscillation.

    The orders 1 and h must agree with those of the claimed value; that of h² differs, so O(ρ²) is sharp.
    """
    mean, optimal = mean_end_curvature(), optimal_curvature()
    if form == "mean of the ends":
        claimed = mean
    elif form in {"curvature at the start", "curvature at the end"}:
        # k(±h/2) = mean ± k₁h/2, k₁ = dk/ds from the leading error of a conic
        sign = 1 if form.endswith("end") else -1
        slope = affine_symbols()["dk_ds"].subs(c, 1)
        zero = 0 * mean[0]
        claimed = mean + PowerSeries([zero, zero.field.from_expr(slope) * sign / 2, zero])
    else:
        raise DomainError(f"No such value of the conic's affine curvature: {form!r}.")
    difference = optimal - claimed
    agree = difference[0] == 0 and difference[1] == 0
    sharp = (
        f"the difference begins with h²·({difference[2]})" if agree else f"they differ by h·({difference[1]})"
    )
    return Evidence(bool(agree), (sharp,))


@claim(
    "(3.17)",
    "N(ε) = 128^(−1/4) ∫|k|^(1/4) κ^(5/12) ds ε^(−1/4), to leading order, for parabolic splines.",
    method=Method.PROOF,
    given=("X3.1-4",),
    form="128^(-1/4)*k^(1/4)*kappa^(5/12)",
    wrong=(
        "128^(-1/4)*k^(1/4)*kappa^(5/3)",
        "128^(-1/5)*k^(1/4)*kappa^(5/12)",
        "128^(-1/4)*k^(1/5)*kappa^(5/12)",
        "-128^(-1/4)*k^(1/4)*kappa^(5/12)",
    ),
)
def parabola_complexity(form: str) -> Evidence:
    """An arc of error ε has the length (ε/e₀)^{1/4}, so the integrand to the power 4 is e₀ (X3.1-4)."""
    return equal_error(form, "parabola", 4)


CONIC_ERRATUM = (
    "k′ has to be the derivative by affine arc length, dk/dr, though the curve is parametrised by "
    "Euclidean arc "
    "length s; dk/ds puts the integrand wrong by the factor κ^(1/15)."
)


@claim(
    "(3.18)",
    "N(ε) = (2000√5)^(−1/5) ∫|dk/dr|^(1/5) κ^(2/5) ds ε^(−1/5), to leading order, for conic splines.",
    method=Method.PROOF,
    given=("X3.1-4",),
    form="(2000*sqrt(5))^(-1/5)*dk_dr^(1/5)*kappa^(2/5)",
    printed="(2000*sqrt(5))^(-1/5)*dk_ds^(1/5)*kappa^(2/5)",
    erratum=CONIC_ERRATUM,
    wrong=("(2000*sqrt(5))^(-1/5)*dk_dr^(1/5)*kappa^(1/3)", "2000^(-1/5)*dk_dr^(1/5)*kappa^(2/5)"),
)
def conic_complexity(form: str) -> Evidence:
    """An arc of error ε has the length (ε/e₀)^{1/5}, so the integrand to the power 5 is e₀ (X3.1-4)."""
    return equal_error(form, "conic", 5)


@claim(
    "section 1.5-1",
    "In the constant of conic splines the affine curvature is differentiated by affine arc length.",
    method=Method.PROOF,
    form="dk_dr",
    printed="dk_ds",
    erratum="Section 1.5 writes k′(s); the error over |dk/ds|κ²σ⁵/(2000√5) tends to κ^(−1/3), not to 1.",
    wrong=("dk_dr*kappa^(1/3)",),
)
def which_derivative(form: str) -> Evidence:
    """The derived e₀ over form·κ²/(2000√5) must be 1; for dk/ds it is κ^{−1/3}, as on the spiral at t = 2."""
    symbols = affine_symbols()
    ratio = sp.cancel(
        derived_error("conic") * 2000 * sp.sqrt(5) / (read(form, symbols) * symbols["kappa"] ** 2)
    )
    spiral = sp.Rational(6) / sp.Rational(5) ** sp.Rational(3, 2)  # κ = (t² + 2)/(t² + 1)^{3/2} at t = 2
    there = sp.N(ratio.subs(c, sp.cbrt(spiral)), 6)
    return Evidence(
        ratio == 1, (f"error/prediction → {ratio} with c = κ^(1/3): {there} on the spiral at t = 2",)
    )


@claim(
    "corollary 3.6.3.1",
    "The constant of a parabolic spline's number of pieces is c₁ = 128^(−1/4) ≈ 0.297.",
    method=Method.ENCLOSURE,
    form="0.297",
    wrong=("0.298", "0.296"),
)
def parabola_constant(form: str) -> Evidence:
    """e₀^{1/4} for k = κ = 1, in balls, rounded to the digits given."""
    return _rounds_to(form, "parabola", 4)


@claim(
    "corollary 3.6.3.2",
    "The constant of a conic spline's number of pieces is c₂ = (2000√5)^(−1/5) ≈ 0.186.",
    method=Method.ENCLOSURE,
    form="0.186",
    wrong=("0.187", "0.185"),
)
def conic_constant(form: str) -> Evidence:
    """e₀^{1/5} for dk/dr = κ = 1, in balls, rounded to the digits given."""
    return _rounds_to(form, "conic", 5)


def _rounds_to(form: str, primitive: str, order: int) -> Evidence:
    from flint import arb

    from osculant.cas.laws.table import law_of

    value = law_of(primitive).ball().root(order)
    shown, half_unit = ((arb(q.numerator) / q.denominator) for q in rounding(form, 3))
    return Evidence(bool(abs(value - shown) < half_unit), (f"the constant is {value.str(12)}",))
