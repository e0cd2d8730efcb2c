"""Claims of section 4.3: the vector from the start to the end of a helix segment.

Symbols as in `osculant.cas.claims.chapter_4.helix_segments`.
"""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_4.segment_frames import (
    RELATION,
    SCALARS,
    SPAN,
    T0,
    T1,
    VECTORS,
    T1xT0,
    V,
    evaluated,
    half_angles,
    k,
    phi,
    s,
    t0,
    tau,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors
from osculant.cas.numbers.signs import sign_between
from osculant.cas.numbers.vectors import add, cross, dot


@claim(
    "section 4.3-2",
    "The vector S±(β, φ) from p₀ to the end of the segment is perpendicular to G: ⟨S±, T₁ − T₀⟩ = 0.",
    method=Method.PROOF,
    form="G",
    wrong=("E", "F", "0*G"),
)
def span_is_perpendicular(form: str) -> Evidence:
    """⟨S±, ·⟩ with S± from corollary 4.2.2 and lemma 4.3.3."""
    (direction,) = read_vectors(form, {}, VECTORS, 1)
    there = Evidence(any(part != 0 for part in direction), (f"the direction is {direction}",))
    return there & vanishes(dot(SPAN, direction), "β⟨S±, ·⟩", [RELATION])


@claim(
    "(4.3)",
    "A helix segment from (p₀, T₀) to (p₁, T₁) has ⟨p₁ − p₀, T₁ − T₀⟩ = 0.",
    method=Method.PROOF,
    form="T1 - T0",
    wrong=("T1 + T0", "T1xT0", "T0", "T0 - T0"),
)
def necessary_condition(form: str) -> Evidence:
    """The inner product of S± with the form's vector vanishes for every turning; it is not 0."""
    return span_is_perpendicular(form)


@claim(
    "(4.7)",
    "β⟨p₁ − p₀, T₁×T₀⟩ = τ̄±(1 − t₀)(φ cot(φ/2) − 2).",
    method=Method.PROOF,
    form="taub*(1 - t0)*(phi*cot(phi/2) - 2)",
    wrong=(
        "-taub*(1 - t0)*(phi*cot(phi/2) - 2)",
        "taub*(1 + t0)*(phi*cot(phi/2) - 2)",
        "taub*(1 - t0)*(phi*cot(phi/2) - 1)",
    ),
)
def sideways(form: str) -> Evidence:
    """The inner product of S± with T₁ × T₀, modulo (4.5)."""
    return vanishes(dot(SPAN, T1xT0) - evaluated(form), "β⟨p₁ − p₀, T₁×T₀⟩", [RELATION])


@claim(
    "(4.8)",
    "sign τ̄± = −sign⟨p₁ − p₀, T₁×T₀⟩, because φ cot(φ/2) − 2 < 0 for 0 < φ < 2π.",
    method=Method.PROOF,
    form="-1",
    wrong=("1", "0"),
)
def sign_of_slope(form: str) -> Evidence:
    """The quotient of (4.7) by τ̄(1 − t₀) times sin(φ/2) > 0 is φ cos(φ/2) − 2 sin(φ/2).

    It is 0 at φ = 0 and its derivative −(φ/2) sin(φ/2) is negative; the sign is also proved in balls.
    """
    bracket = phi * k / s - 2
    linear = vanishes(dot(SPAN, T1xT0) - tau * (1 - t0) * bracket, "quotient by τ̄(1 − t₀)", [RELATION])
    x = sp.Symbol("x", real=True)
    function = x * sp.cos(x / 2) - 2 * sp.sin(x / 2)
    falls = vanishes(sp.diff(function, x) + x * sp.sin(x / 2) / 2, "derivative −(φ/2) sin(φ/2)")
    sign = sign_between(function, x, sp.S.Zero, 2 * sp.pi)
    return linear & falls & Evidence(read(form, {}) == sign, (f"sign of φ cos(φ/2) − 2 sin(φ/2): {sign}",))


@claim(
    "section 4.3-3",
    "The display before (4.9): β⟨p₁ − p₀, T₀ + T₁⟩ = τ̄(φ − sin φ)⟨V, T₀ + T₁⟩ + sin φ⟨T₀, T₀ + T₁⟩ "
    "+ (1 − cos φ)⟨T₀×V, T₀ + T₁⟩.",
    method=Method.PROOF,
    form="taub*(phi - sin(phi))*v + sin(phi)*u + (1 - cos(phi))*w",
    printed="taub*(phi - sin(phi))*v + (1 - cos(phi))*w",
    erratum="The term sin φ⟨T₀, T₀ + T₁⟩ is missing; (4.9) contains it.",
    wrong=(
        "taub*(phi - sin(phi))*v + sin(phi)*u - (1 - cos(phi))*w",
        "taub*(phi + sin(phi))*v + sin(phi)*u + (1 - cos(phi))*w",
    ),
)
def forwards_expanded(form: str) -> Evidence:
    """The inner product of S± with T₀ + T₁; v, u, w stand for the three inner products."""
    total = add(T0, T1)
    products = {"v": dot(V, total), "u": dot(T0, total), "w": dot(cross(T0, V), total)}
    return vanishes(dot(SPAN, total) - evaluated(form, **products), "β⟨p₁ − p₀, T₀ + T₁⟩", [RELATION])


@claim(
    "section 4.3-4",
    "In that display ⟨V±, T₀ + T₁⟩ = 2τ̄± and ⟨T₀×V±, T₀ + T₁⟩ = (1 − t₀)(1 + cos φ)/sin φ; before (4.7) "
    "⟨T₀×V±, T₁×T₀⟩ = −τ̄±(1 − t₀).",
    method=Method.PROOF,
    form="2*taub, (1 - t0)*(1 + cos(phi))/sin(phi), -taub*(1 - t0)",
    wrong=(
        "taub, (1 - t0)*(1 + cos(phi))/sin(phi), -taub*(1 - t0)",
        "2*taub, (1 - t0)*(1 + cos(phi))/sin(phi), taub*(1 - t0)",
    ),
)
def inner_products(form: str) -> Evidence:
    """Components along {E, F, G}."""
    total, across = add(T0, T1), cross(T0, V)
    derived = (dot(V, total), dot(across, total), dot(across, T1xT0))
    evidence = Evidence(True)
    for stated, value in zip(read_tuple(form, SCALARS, 3), derived, strict=True):
        evidence &= vanishes(value - half_angles(stated), "inner product", [RELATION])
    return evidence


@claim(
    "(4.9)",
    "β⟨p₁ − p₀, T₀ + T₁⟩ = 2(φ(t₀ − cos φ) + (1 − t₀) sin φ)/(1 − cos φ).",
    method=Method.PROOF,
    form="2*(phi*(t0 - cos(phi)) + (1 - t0)*sin(phi))/(1 - cos(phi))",
    wrong=(
        "2*(phi*(t0 - cos(phi)) - (1 - t0)*sin(phi))/(1 - cos(phi))",
        "(phi*(t0 - cos(phi)) + (1 - t0)*sin(phi))/(1 - cos(phi))",
        "2*(phi*(t0 - cos(phi)) + (1 + t0)*sin(phi))/(1 - cos(phi))",
    ),
)
def forwards(form: str) -> Evidence:
    """The inner product of S± with T₀ + T₁, modulo (4.5)."""
    return vanishes(dot(SPAN, add(T0, T1)) - evaluated(form), "β⟨p₁ − p₀, T₀ + T₁⟩", [RELATION])
