"""Claims of appendix A.2: where a flat function peaks beyond the leading order, and how smoothly in r."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.asymptotics.flat_functions import (
    F,
    F_r,
    F_s,
    F_u,
    Model,
    balance_shift,
    critical_point_shift,
    n,
    slope_by_crossing,
    x,
    y,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes

r = sp.Symbol("r", positive=True)
half = sp.Rational(1, 2)
#: flatnesses at which the expansions are carried out
SMALL = (1, 2, 3)
#: pairs (m, n) with 2n + 3 ≤ m at which classes of differentiability are determined
CLASSES = ((7, 1), (7, 2), (9, 3))


@claim(
    "XA.2-1",
    "A function with n-fold zeros at 0 and r peaks at u = r/2 + F_u/(8nF) r² + O(r³), F and F_u at the "
    "origin.",
    method=Method.PROOF,
    form="F_u/(8*n*F)",
    wrong=("F_u/(4*n*F)", "F_u/(8*F)", "-F_u/(8*n*F)"),
)
def peak_beyond_leading_order(form: str) -> Evidence:
    """The implicit function theorem for ∂f̃/∂x = 0 with F = F + F_u u + F_r r, for the symbol n.

    For n = 1, 2, 3 the result is put into ∂f̃/∂x, which must then be O(r²).
    """
    (derived,) = critical_point_shift()
    stated = read(form, {"n": n, "F": F, "F_u": F_u})
    evidence = vanishes(stated - derived, "dx/dr at r = 0")
    for number in SMALL:
        slope = sp.diff(x**number * (1 - x) ** number * (F + r * (F_u * x + F_r)), x)
        at_peak = sp.series(slope.subs(x, half + r * stated.subs(n, number)).expand(), r, 0, 2).removeO()
        evidence &= vanishes(at_peak, f"∂f̃/∂x up to O(r²), n = {number}")
    return evidence


@claim(
    "XA.2-2",
    "The best third zero is s₀(r) = r/2 + F_u/(4(2n + 1)F) r² + O(r³), F and F_u at the origin.",
    method=Method.PROOF,
    form="F_u/(4*(2*n + 1)*F)",
    wrong=("F_u/(4*n*F)", "F_u/(2*(2*n + 1)*F)", "-F_u/(4*(2*n + 1)*F)"),
)
def best_third_zero_beyond_leading_order(form: str) -> Evidence:
    """The implicit function theorem for Δ(y, r) = 0, for the symbol n.

    For n = 1, 2, 3 the sum of f̃ at the critical points, moved by r times any amounts, must be O(r²) with
    y = 1/2 + r·form: the amounts drop out, since the slope is 0 there.
    """
    stated = read(form, {"n": n, "F": F, "F_u": F_u})
    evidence = vanishes(stated - balance_shift(), "dy₀/dr at r = 0")
    for number in SMALL:
        crossing = half + r * stated.subs(n, number)
        total: Any = 0
        for i, point in enumerate(Model(number, half).critical_points):
            at = point + r * sp.Symbol(f"amount{i}")
            size = F + r * (F_u * at + F_s * half + F_r)
            value = at**number * (1 - at) ** number * (at - crossing) * size
            total += value.subs(r, 0) + r * sp.diff(value, r).subs(r, 0)
        evidence &= vanishes(sp.expand(total), f"Δ up to O(r²), n = {number}")
    return evidence


def _class_of(power_of_r: Any) -> int:
    """The class of c·r^q with c ≠ 0 for a q that is no integer: as many derivatives as stay below q."""
    return int(sp.floor(power_of_r))


@claim(
    "section A.2-7",
    "The peak's place u/r is a function of r of class Cᵐ⁻²ⁿ, for f of class Cᵐ, and no better in general.",
    method=Method.EXACT,
    form="m - 2*n",
    printed="m - 2*n + 1",
    erratum="The proof of Lemma A.2.1 takes ∂f̃/∂x for a function of class Cᵐ⁻¹ although f̃ is f divided "
    "by r²ⁿ; the peak's "
    "place is of class Cᵐ⁻²ⁿ, in general not Cᵐ⁻²ⁿ⁺¹.",
    wrong=("m - n", "m - 2*n + 2"),
)
def class_of_the_peak(form: str) -> Evidence:
    """At least: ∂f/∂u = uⁿ⁻¹(r − u)ⁿ⁻¹G with G of class Cᵐ⁻²ⁿ⁺¹, and G(rx, r) = nrE: one more division by r.

    At most: F = 1 + u(u² + r²)^((q−1)/2) with q = m − 2n + 1/2. f differs from uⁿ(r − u)ⁿ by a homogeneous
    function of degree m + 1/2, smooth outside 0, so it is Cᵐ. On u = rx, F = 1 + r^q H(x), and the peak moves
    by r^q H′(1/2)/(8n) to leading order (XA.2-1 with r^q H′ in place of rF_u): not zero.
    """
    evidence = Evidence(True)
    for m, number in CLASSES:
        q = sp.Integer(m) + half - 2 * number  # degree of f less that of uⁿ(r − u)ⁿ
        rough = x * (x**2 + 1) ** ((q - 1) / 2)
        moved = critical_point_shift()[0].subs({n: number, F: 1, F_u: sp.diff(rough, x).subs(x, half)})
        evidence &= _smoothness(form, m, number, q, moved, "peak")
    return evidence


@claim(
    "lemma A.2.1.4",
    "The best third zero s₀(r) is of class Cᵐ⁻²ⁿ, for f of class Cᵐ, and no better in general.",
    method=Method.EXACT,
    form="m - 2*n",
    printed="m - 2*n + 1",
    erratum="Lemma A.2.1 gives s₀ the class Cᵐ⁻²ⁿ⁺¹, because its proof overlooks that f̃ is f divided by "
    "r²ⁿ⁺¹; s₀ is of class "
    "Cᵐ⁻²ⁿ, in general no better.",
    wrong=("m - n", "m - 2*n + 2"),
)
def class_of_the_best_zero(form: str) -> Evidence:
    """s₀ = r·y₀, where y₀ solves an equation in F(rx, ry, r).

    At least: F = [0ⁿ, rⁿ, s, u]f is Cᵐ⁻²ⁿ⁻¹, but r·F(rx, ry, r) is a difference of two divided differences of
    order 2n, so Cᵐ⁻²ⁿ, and r·y₀ inherits that.

    At most: F = 1 + u(u² + s² + r²)^((q−1)/2) with q = m − 2n − 1/2, which makes f a Cᵐ function as for the
    peak. On u = rx, s = ry, F = 1 + r^q H(x, y); Δ = 0 moves y₀ by r^q times −Σ (model)H / Σ ∂(model)/∂y,
    over the critical points, which is not zero, and s₀ = r·y₀ by r^(q+1).
    """
    evidence = Evidence(True)
    for m, number in CLASSES:
        q = sp.Integer(m) + half - 2 * number - 1
        rough = x * (x**2 + half**2 + 1) ** ((q - 1) / 2)
        model = Model(number, half)
        slope = slope_by_crossing().subs(n, number)
        raised = sum((model.shape * rough).subs(x, point) for point in model.critical_points)
        lowered = sum(slope.subs({x: point, y: half}) for point in model.critical_points)
        evidence &= _smoothness(form, m, number, q + 1, -raised / lowered, "best zero")
    return evidence


def _smoothness(form: str, m: int, number: int, power_of_r: Any, moved: Any, what: str) -> Evidence:
    stated = read(form, {"m": sp.Integer(m), "n": sp.Integer(number)})
    derived = _class_of(power_of_r)
    size = sp.N(moved, 12)
    line = (
        f"m = {m}, n = {number}: the {what} moves by {size}·r^({power_of_r}), which is of class C^{derived} "
        f"and no better; the form says C^{stated}"
    )
    return Evidence(bool(stated == derived and abs(size) > sp.Float("1e-6")), (line,))
