"""Claims of section 4.3: helix segments with constraints; τ̄ is the thesis's, minus the usual one.

Vectors have components along {E, F, G}, so T₀ = cE − hG and T₁ = cE + hG, with the cosine c and the sine h of
θ/2 as rational functions of the tangent of θ/4; k = cos(φ/2) and s = sin(φ/2) likewise. τ̄ is a symbol with
the relation τ̄²s² = c² − k², which is (4.5); φ outside of circular functions is an independent symbol.
"""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_4.segment_frames import (
    RELATION,
    SCALARS,
    T0,
    T1,
    VECTORS,
    G,
    T1xT0,
    a,
    b,
    c,
    evaluated,
    h,
    half_angles,
    k,
    phi,
    s,
    t0,
    tau,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors, same
from osculant.cas.numbers.signs import sign_between
from osculant.cas.numbers.vectors import Vector3, add, cross, dot, scale, subtract


def _turned(axis: Vector3) -> Vector3:
    """T(φ, τ̄, V) of (4.4)."""
    along = subtract(T0, scale(tau, axis))
    return add(T0, scale(k**2 - s**2 - 1, along), scale(2 * k * s, cross(T0, axis)))


@claim(
    "lemma 4.3.1.1",
    "E = (T₁ + T₀)/√(2(1 + t₀)), F = T₁×T₀/√(1 − t₀²), G = (T₁ − T₀)/√(2(1 − t₀)) is an orthonormal basis.",
    method=Method.PROOF,
    form="2*(1 + t0), 1 - t0**2, 2*(1 - t0)",
    wrong=(
        "1 + t0, 1 - t0**2, 1 - t0",
        "2*(1 + t0), (1 - t0)**2, 2*(1 - t0)",
        "2*(1 - t0), 1 - t0**2, 2*(1 + t0)",
    ),
)
def natural_basis(form: str) -> Evidence:
    """Squared lengths of T₁ + T₀, T₁ × T₀, T₁ − T₀, and their inner products, for |T₀| = |T₁| = 1."""
    first, (x, y) = (sp.S.One, sp.S.Zero, sp.S.Zero), sp.symbols("x y", real=True)
    size = x**2 + y**2
    second = ((x**2 - y**2) / size, 2 * x * y / size, sp.S.Zero)  # any unit vector of the plane
    vectors = [add(second, first), cross(second, first), subtract(second, first)]
    squares = read_tuple(form, {"t0": dot(first, second)}, 3)
    evidence = Evidence(True)
    for v, square, name in zip(vectors, squares, "EFG", strict=True):
        evidence &= vanishes(dot(v, v) - square, f"|{name}|² = 1")
    for i, j in ((0, 1), (0, 2), (1, 2)):
        evidence &= vanishes(dot(vectors[i], vectors[j]), f"⟨{'EFG'[i]}, {'EFG'[j]}⟩ = 0")
    return evidence


@claim(
    "lemma 4.3.1.2",
    "Orientation of that basis: E × F = G, and E × G = −F.",
    method=Method.PROOF,
    form="G, -F",
    wrong=("-G, F", "G, F", "-G, -F"),
)
def natural_orientation(form: str) -> Evidence:
    """Cross products in the coordinates of T₀ = (1, 0, 0), T₁ = (cos θ, sin θ, 0), by the tangent of θ/4."""
    first, second = (sp.S.One, sp.S.Zero, sp.S.Zero), (t0, 2 * c * h, sp.S.Zero)
    e, g = scale(1 / (2 * c), add(second, first)), scale(1 / (2 * h), subtract(second, first))
    f = scale(1 / (2 * c * h), cross(second, first))
    stated = read_vectors(form, {}, {"E": e, "F": f, "G": g}, 2)
    return same([cross(e, f), cross(e, g)], stated, "E × F, E × G")


@claim(
    "(4.4)",
    "T(φ, τ̄, V) = T₀ + (cos φ − 1)(T₀ − τ̄V) + sin φ T₀×V is a unit vector if |V| = 1 and ⟨T₀, V⟩ = τ̄.",
    method=Method.PROOF,
    form="T0 + (cos(phi) - 1)*(T0 - taub*V) + sin(phi)*T0xV",
    wrong=(
        "T0 + (cos(phi) + 1)*(T0 - taub*V) + sin(phi)*T0xV",
        "T0 + (cos(phi) - 1)*T0 + sin(phi)*T0xV",
        "T0 - (cos(phi) - 1)*(T0 - taub*V) + sin(phi)*T0xV",
    ),
)
def unit_tangent(form: str) -> Evidence:
    """V = (0, 0, 1), T₀ = (κ̄, 0, τ̄) with κ̄² + τ̄² = 1; length and slope of T, and T = T₀ at φ = 0."""
    start: Vector3 = (2 * a / (1 + a**2), sp.S.Zero, (1 - a**2) / (1 + a**2))
    vectors = {"T0": start, "V": G, "T0xV": cross(start, G)}
    (turned,) = read_vectors(form, {"phi": phi, "taub": start[2]}, vectors, 1)
    turned = tuple(half_angles(x) for x in turned)
    evidence = vanishes(dot(turned, turned) - 1, "|T|² = 1") & vanishes(
        dot(turned, G) - start[2], "⟨T, V⟩ = τ̄"
    )
    at_start = tuple(sp.sympify(x).subs(b, 0) for x in turned)
    return evidence & same([at_start], [start], "T(0) = T₀")


@claim(
    "(4.5)",
    "If T(φ, τ̄, V) = T₁ then τ̄² = (t₀ − cos φ)/(1 − cos φ).",
    method=Method.PROOF,
    form="(t0 - cos(phi))/(1 - cos(phi))",
    wrong=("(t0 + cos(phi))/(1 + cos(phi))", "(1 - t0)/(1 - cos(phi))", "(t0 - cos(phi))/(1 + cos(phi))"),
)
def slope_from_turning(form: str) -> Evidence:
    """⟨T(φ, τ̄, V), T₀⟩ = t₀ is linear in τ̄²: 1 + (cos φ − 1)(1 − τ̄²) = t₀, for V with ⟨T₀, V⟩ = τ̄."""
    square, cosine = sp.symbols("q C", real=True)
    inner = 1 + (cosine - 1) * (1 - square)  # ⟨T₀, T₀ − τ̄V⟩ = 1 − τ̄², ⟨T₀, T₀ × V⟩ = 0
    (root,) = sp.solve(inner - t0, square)
    return vanishes(half_angles(root.subs(cosine, sp.cos(phi))) - evaluated(form), "τ̄²")


@claim(
    "section 4.3-1",
    "In the proof of lemma 4.3.3: V = τ̄/(1 + t₀)(T₀ + T₁) + ⟨V, T₁×T₀⟩/(1 − t₀²) T₁×T₀ for a unit V with "
    "equal inner products τ̄ with T₀ and T₁.",
    method=Method.PROOF,
    form="taub/(1 + t0)*(T0 + T1) + q/(1 - t0**2)*T1xT0",
    wrong=(
        "taub/(1 - t0)*(T0 + T1) + q/(1 - t0**2)*T1xT0",
        "taub/(1 + t0)*(T0 + T1) + q*T1xT0",
    ),
)
def axis_in_basis(form: str) -> Evidence:
    """The vector with these three inner products with T₀, T₁ and T₁ × T₀, which form a basis."""
    q = sp.Symbol("q", real=True)
    (axis,) = read_vectors(form, {**SCALARS, "q": q}, VECTORS, 1)
    evidence = vanishes(dot(axis, T0) - tau, "⟨V, T₀⟩") & vanishes(dot(axis, T1) - tau, "⟨V, T₁⟩")
    return evidence & vanishes(dot(axis, T1xT0) - q, "⟨V, T₁×T₀⟩")


@claim(
    "(4.6)",
    "⟨V, T₁×T₀⟩ = ⟨T₁, T₀×V⟩ = (1 − t₀)(1 + cos φ)/sin φ = (1 − t₀) cot(φ/2).",
    method=Method.PROOF,
    form="(1 - t0)*(1 + cos(phi))/sin(phi), (1 - t0)*cot(phi/2)",
    wrong=(
        "(1 + t0)*(1 + cos(phi))/sin(phi), (1 + t0)*cot(phi/2)",
        "(1 - t0)*(1 - cos(phi))/sin(phi), (1 - t0)*tan(phi/2)",
    ),
)
def axis_product(form: str) -> Evidence:
    """⟨T(φ, τ̄, V), T₁⟩ = 1 solved for ⟨T₁, T₀ × V⟩, with (4.5); ⟨V, T₁×T₀⟩ is the same determinant."""
    q = sp.Symbol("q", real=True)
    square = (c**2 - k**2) / s**2
    inner = t0 + (k**2 - s**2 - 1) * (t0 - square) + 2 * k * s * q
    (root,) = sp.solve(inner - 1, q)
    evidence = Evidence(True)
    for stated in read_tuple(form, SCALARS, 2):
        evidence &= vanishes(root - half_angles(stated), "⟨T₁, T₀×V⟩")
    x, y, z = sp.symbols("x y z", real=True)
    product = dot((x, y, z), T1xT0) - dot(T1, cross(T0, (x, y, z)))
    return evidence & vanishes(product, "⟨V, T₁×T₀⟩ = ⟨T₁, T₀×V⟩")


@claim(
    "lemma 4.3.3.1",
    "T(φ, τ̄, V) = T₁ is solved by τ̄± = ±√((t₀ − cos φ)/(1 − cos φ)), "
    "V± = (τ̄±(T₀ + T₁) + cot(φ/2) T₁×T₀)/(1 + t₀).",
    method=Method.PROOF,
    form="(taub*(T0 + T1) + cot(phi/2)*T1xT0)/(1 + t0)",
    wrong=(
        "(taub*(T0 + T1) - cot(phi/2)*T1xT0)/(1 + t0)",
        "(taub*(T0 + T1) + cot(phi/2)*T1xT0)/(1 - t0)",
        "(taub*(T0 + T1) + tan(phi/2)*T1xT0)/(1 + t0)",
    ),
)
def turning_solutions(form: str) -> Evidence:
    """V is a unit vector, ⟨T₀, V⟩ = ⟨T₁, V⟩ = τ̄, and (4.4) gives T₁; modulo (4.5), either sign of τ̄."""
    (axis,) = read_vectors(form, SCALARS, VECTORS, 1)
    axis = tuple(half_angles(x) for x in axis)
    evidence = vanishes(dot(axis, axis) - 1, "|V|²", [RELATION])
    for end, name in ((T0, "⟨T₀, V⟩"), (T1, "⟨T₁, V⟩")):
        evidence &= vanishes(dot(axis, end) - tau, name, [RELATION])
    return evidence & same([_turned(axis)], [T1], "T(φ, τ̄, V) = T₁", [RELATION])


@claim(
    "lemma 4.3.3.2",
    "These solutions exist exactly for φ in [arccos t₀, 2π − arccos t₀].",
    method=Method.PROOF,
    form="acos(t0), 2*pi - acos(t0)",
    wrong=("acos(t0), pi", "pi - acos(t0), pi + acos(t0)", "0, 2*pi", "2*pi - acos(t0), acos(t0)"),
)
def turning_range(form: str) -> Evidence:
    """t₀ − cos φ vanishes at both ends; cos falls on (0, π) and is symmetric about π, so it is ≥ 0 between.

    Without any further zero in (0, 2π): cos takes each value twice there.
    """
    theta, x = sp.Symbol("theta", positive=True), sp.Symbol("x", real=True)
    low, high = read_tuple(form, {"t0": sp.cos(theta)}, 2)
    low, high = (end.subs(sp.acos(sp.cos(theta)), theta) for end in (low, high))
    ordered = Evidence(bool(low.subs(theta, 1) < high.subs(theta, 1)), (f"from {low} to {high}",))
    evidence = (
        ordered
        & vanishes(sp.cos(theta) - sp.cos(low), "lower end")
        & vanishes(sp.cos(theta) - sp.cos(high), "upper end")
    )
    falls = sign_between(sp.diff(sp.cos(x), x), x, sp.S.Zero, sp.pi)
    evidence &= vanishes(low + high - 2 * sp.pi, "the ends are symmetric about π")
    return evidence & Evidence(falls == -1, (f"sign of cos' on (0, π): {falls}",))


@claim(
    "remark 4.3.4.1",
    "If τ̄ satisfies (4.5) then κ̄² = 1 − τ̄² = (1 − t₀)/(1 − cos φ).",
    method=Method.PROOF,
    form="(1 - t0)/(1 - cos(phi))",
    wrong=("(1 + t0)/(1 - cos(phi))", "(1 - t0)/(1 + cos(phi))"),
)
def curvature_from_turning(form: str) -> Evidence:
    """1 − τ̄² modulo (4.5)."""
    return vanishes(1 - tau**2 - evaluated(form), "κ̄²", [RELATION])


@claim(
    "remark 4.3.4.2",
    "The ranges are 0 ≤ τ̄² ≤ (1 + t₀)/2 and (1 − t₀)/2 ≤ κ̄² ≤ 1.",
    method=Method.PROOF,
    form="0, (1 + t0)/2, (1 - t0)/2, 1",
    wrong=("0, 1 + t0, (1 - t0)/2, 1", "0, (1 - t0)/2, (1 + t0)/2, 1", "0, (1 + t0)/2, 0, 1"),
)
def ranges(form: str) -> Evidence:
    """κ̄² = (1 − t₀)/(1 − u) is monotone in u = cos φ: its derivative is (1 − t₀)/(1 − u)² > 0.

    So the bounds are attained at the ends u = −1 and u = t₀ of the range of lemma 4.3.3.
    """
    u, size = sp.symbols("u t0", real=True)
    kappa_squared = (1 - size) / (1 - u)
    monotone = vanishes(sp.diff(kappa_squared, u) * (1 - u) ** 2 - (1 - size), "d κ̄²/du · (1 − u)²")
    ends = [kappa_squared.subs(u, -1), kappa_squared.subs(u, size)]
    bounds = (1 - ends[1], 1 - ends[0], ends[0], ends[1])
    for stated, bound in zip(read_tuple(form, {"t0": size}, 4), bounds, strict=True):
        monotone &= vanishes(stated - bound, "bound")
    return monotone
