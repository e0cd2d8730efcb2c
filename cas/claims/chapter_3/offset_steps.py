"""Section 3.5: the displayed formulas (3.7) to (3.9) and the others inside the proof of Lemma 3.5.1."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.asymptotics.offset_curves import OffsetCurve, bracket
from osculant.cas.claims.chapter_3.offsets import (
    AT_ZERO,
    BASIS,
    CROSSING,
    along_frame,
    contact_derivatives,
    curvature_of_alpha,
    in_class,
    to_order,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, integers, order, read, read_tuple
from osculant.cas.numbers.division import newton_of_polynomial


def _symbols(curve: OffsetCurve, contact: Any) -> dict[str, Any]:
    u = curve.symbols["u"]
    return curve.symbols | contact_derivatives(contact, u) | {"k": curvature_of_alpha(curve, u)}


def _at_zero() -> dict[str, Any]:
    return _symbols(AT_ZERO, AT_ZERO.expression(AT_ZERO.contact))


def _crossing() -> dict[str, Any]:
    s = CROSSING.symbols
    return _symbols(CROSSING, s["u"] ** 5 - (2 * s["rho"] + s["sigma"]) * s["u"] ** 4)


@claim(
    "(3.7)",
    "For ρ = 0 and f = u⁴: β′ = (1 + f′P₀)t + f′Q₀n + O(u⁴), β″ = f″P₀t + (1 + f″Q₀)n + O(u³), "
    "β‴ = (−k + f‴P₀)t + f‴Q₀n + O(u²).",
    method=Method.PROOF,
    form="(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 + f2*Q0)*n, (-k + f3*P0)*t + f3*Q0*n, 4, 3, 2",
    wrong=(
        "(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 + f2*Q0)*n, (k + f3*P0)*t + f3*Q0*n, 4, 3, 2",
        "(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 + f1*Q0)*n, (-k + f3*P0)*t + f3*Q0*n, 4, 3, 2",
        "(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 + f2*Q0)*n, (-k + f3*P0)*t + f3*Q0*n, 5, 3, 2",
    ),
)
def derivatives_at_zero(form: str) -> Evidence:
    """The derivatives of β = α + u⁴(Pt + Qn), P and Q with linear terms, along t(u) and n(u)."""
    found = []
    for axis, basis in enumerate(BASIS):
        *stated, first, second, third = read_tuple(form, _at_zero() | basis, 6)
        for vector, value, last, primes in zip(
            AT_ZERO.derivatives(3), stated, (first, second, third), ("′", "″", "‴"), strict=True
        ):
            series = along_frame(AT_ZERO, vector)[axis]
            found.append(to_order(AT_ZERO, series, value, order(last), f"β{primes} along {'tn'[axis]}"))
    return all_of(found)


@claim(
    "lemma 3.5.1-3",
    "In its proof φ(u, 0) = 1 + 4u²Q₀ + O(u³).",
    method=Method.PROOF,
    form="1 + 4*u**2*Q0, 3",
    wrong=("1 + 12*u**2*Q0, 3", "1 - 4*u**2*Q0, 3", "1 + 4*u**2*Q0, 4"),
)
def speed_at_zero(form: str) -> Evidence:
    """φ = [β′, β″]^(1/3) of β = α + u⁴(Pt + Qn) as a series."""
    stated, last = read_tuple(form, AT_ZERO.symbols, 2)
    return to_order(AT_ZERO, AT_ZERO.affine_speed, stated, order(last), "φ")


@claim(
    "lemma 3.5.1-4",
    "In its proof [β₀″, β₀‴] = k(0) + O(u), and φφ_uu = 8Q₀ + O(u): together (3.4).",
    method=Method.PROOF,
    form="k0, 8*Q0",
    printed="k0 + 8*Q0, 8*Q0",
    erratum="[β₀″, β₀‴] is k(0) + O(u) without 8Q₀, which φφ_uu brings; with both, (3.4) would have 16Q₀.",
    wrong=("k0, 4*Q0", "-k0, 8*Q0"),
)
def bracket_at_zero(form: str) -> Evidence:
    """Both terms of (3.6) at u = 0 for β = α + u⁴(Pt + Qn)."""
    first, second = read_tuple(form, AT_ZERO.symbols, 2)
    _, bend, jerk = AT_ZERO.derivatives(3)
    phi = AT_ZERO.affine_speed
    return to_order(AT_ZERO, bracket(bend, jerk), first, 1, "[β₀″, β₀‴]") & to_order(
        AT_ZERO, AT_ZERO.rate(AT_ZERO.rate(phi)) * phi, second, 1, "φφ_uu"
    )


@claim(
    "(3.8)",
    "β = α + f·(P₀t + Q₀n) + O(u⁶) + O((ρ + σ)u⁵) + O(ρ² + σ²) with f = u⁵ − (2ρ + σ)u⁴.",
    method=Method.PROOF,
    form="u**5 - (2*rho + sigma)*u**4",
    wrong=("u**5 + (2*rho + sigma)*u**4", "u**5 - (rho + 2*sigma)*u**4", "u**5"),
)
def essential_terms(form: str) -> Evidence:
    """β − α along t(u) and n(u), P and Q with linear terms, against f·P₀ and f·Q₀ monomial by monomial."""
    f = read(form, CROSSING.symbols)
    away = (CROSSING.beta[0] - CROSSING.arc[0], CROSSING.beta[1] - CROSSING.arc[1])
    return all_of(
        in_class(CROSSING, series, f * CROSSING.symbols[name], 0, f"β − α − f{name}")
        for series, name in zip(along_frame(CROSSING, away), ("P0", "Q0"), strict=True)
    )


@claim(
    "lemma 3.5.1-5",
    "Of the classes O₀, …, O₄ in its proof, g ∈ Oᵢ has g_u in the next class Oᵢ₊₁ for 0 ≤ i ≤ 3.",
    method=Method.EXACT,
    form="0, 3",
    printed="1, 4",
    erratum="The range is 0 ≤ i ≤ 3, not 1 ≤ i ≤ 4: (3.9) needs i = 0, and O₅ is not defined.",
    wrong=("0, 4", "1, 3"),
)
def classes(form: str) -> Evidence:
    """The generators u⁶⁻ⁱ, ρu⁵⁻ⁱ, σu⁵⁻ⁱ, ρ², ρσ, σ² of Oᵢ as exponents: for which i does d/du lead into Oᵢ₊₁?

    A monomial uᵃρᵇσᶜ lies in Oᵢ if b + c ≥ 2, or b + c = 1 and a ≥ 5 − i, or a ≥ 6 − i. The factor of a
    generator may depend on u: differentiating it leaves the generator itself, so that must lie in Oᵢ₊₁ too.
    """

    def member(a: int, others: int, i: int) -> bool:
        return others >= 2 or a >= 6 - i - others

    low, high = integers(form, 2)
    defined = range(5)
    holds = {
        i
        for i in defined
        if i + 1 in defined
        and all(
            member(a, b, i + 1) and (a == 0 or member(a - 1, b, i + 1))
            for a, b in ((6 - i, 0), (5 - i, 1), (0, 2))
        )
    }
    line = f"d/du leads from Oᵢ to Oᵢ₊₁ with both defined for i in {sorted(holds)}, against {low} to {high}"
    return Evidence(holds == set(range(low, high + 1)), (line,))


@claim(
    "(3.9)",
    "β_u = (1 + f_u P₀)t + f_u Q₀n + O₁, β_uu = f_uu P₀t + (1 + f_uu Q₀)n + O₂, "
    "β_uuu = (−k + f_uuu P₀)t + f_uuu Q₀n + O₃.",
    method=Method.PROOF,
    form="(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 + f2*Q0)*n, (-k + f3*P0)*t + f3*Q0*n",
    wrong=(
        "(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 + f2*Q0)*n, (k + f3*P0)*t + f3*Q0*n",
        "(1 + f1*P0)*t + f1*Q0*n, f2*P0*t + (1 - f2*Q0)*n, (-k + f3*P0)*t + f3*Q0*n",
        "(1 + f1*Q0)*t + f1*P0*n, f2*P0*t + (1 + f2*Q0)*n, (-k + f3*P0)*t + f3*Q0*n",
    ),
)
def derivatives_of_the_crossing_curve(form: str) -> Evidence:
    """The derivatives along t(u) and n(u), P and Q with linear terms, monomial by monomial."""
    found = []
    for axis, basis in enumerate(BASIS):
        stated = read_tuple(form, _crossing() | basis, 3)
        for i, (vector, value) in enumerate(zip(CROSSING.derivatives(3), stated, strict=True), start=1):
            series = along_frame(CROSSING, vector)[axis]
            found.append(in_class(CROSSING, series, value, i, f"β_{'u' * i} along {'tn'[axis]}"))
    return all_of(found)


@claim(
    "lemma 3.5.1-6",
    "In its proof φ = 1 + f_uu Q₀/3 + O₂, so φ = 1 + O₃, φ_u² = O₄ and φ_uu = f_uuuu Q₀/3 + O₄.",
    method=Method.PROOF,
    form="1 + f2*Q0/3, 1, 0, f4*Q0/3",
    wrong=("1 + f2*Q0, 1, 0, f4*Q0/3", "1 + f2*Q0/3, 1, 0, f4*Q0", "1 + f2*Q0/3, 1, 1, f4*Q0/3"),
)
def speed_of_the_crossing_curve(form: str) -> Evidence:
    """φ = [β_u, β_uu]^(1/3) as a series, and its derivatives, monomial by monomial."""
    phi = CROSSING.affine_speed
    slope = CROSSING.rate(phi)
    derived = (phi, phi, slope * slope, CROSSING.rate(slope))
    stated = read_tuple(form, _crossing(), 4)
    what = (("φ", 2), ("φ", 3), ("φ_u²", 4), ("φ_uu", 4))
    return all_of(
        in_class(CROSSING, series, value, i, name)
        for series, value, (name, i) in zip(derived, stated, what, strict=True)
    )


@claim(
    "lemma 3.5.1-7",
    "In its proof [β_uu, β_uuu] = k(u) + O₄ and kβ = k(u) + f_uuuu Q₀/3 + O₄.",
    method=Method.PROOF,
    form="k, k + f4*Q0/3",
    wrong=("k + f4*Q0/3, k + f4*Q0/3", "k, k + f4*Q0", "k, k - f4*Q0/3"),
)
def curvature_of_the_crossing_curve(form: str) -> Evidence:
    """Both as series, monomial by monomial."""
    _, second, third = CROSSING.derivatives(3)
    stated = read_tuple(form, _crossing(), 2)
    derived = (bracket(second, third), CROSSING.affine_curvature)
    return all_of(
        in_class(CROSSING, series, value, 4, name)
        for series, value, name in zip(derived, stated, ("[β_uu, β_uuu]", "kβ"), strict=True)
    )


@claim(
    "lemma 3.5.1-8",
    "In its second part P and Q depend on u, σ and ρ.",
    method=Method.EXACT,
    form="u, sigma, rho",
    printed="u, rho",
    erratum="The second part of Lemma 3.5.1 has P and Q as functions on I × I, but takes them at (u, σ, ρ).",
    wrong=("u, sigma", "u, sigma, rho, k"),
)
def arguments_of_the_offset(form: str) -> Evidence:
    """They are divided differences of the offset at 0, 0, ρ, ρ, σ, u: for x⁶ one with all of these names."""
    names = {name: sp.Symbol(name) for name in ("u", "sigma", "rho", "k")}
    stated = read_tuple(form, names)
    nodes = [sp.S.Zero, sp.S.Zero, *(names[name] for name in ("rho", "rho", "sigma", "u"))]
    sixth = sp.expand(newton_of_polynomial([sp.S.Zero] * 6 + [sp.S.One], nodes).coefficients[-1])
    found = Evidence(sixth.free_symbols == set(stated), (f"[0, 0, ρ, ρ, σ, u]x⁶ = {sixth}",))
    return found & Evidence(len(stated) == len(set(stated)), (f"{len(stated)} arguments",))
