"""Section 2.2.3: affine curvature for any parameter, step by step, and what determines a curve."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.plane_frames import (
    BRACKETS,
    CURVE,
    GENERIC,
    PHI,
    D,
    euclidean_frame,
    frenet_derivative,
    kappas,
    same_vectors,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, read, read_tuple, vanishes
from osculant.cas.jets.derivations.affine import affine_curvature, by_affine_arc_length
from osculant.cas.jets.derivations.plane import Vector, bracket, derivative, phi, x, y

#: α̇, α̈, α⃛ as a1, a2, a3
JET: dict[str, Any] = {f"a{i}": (x[i], y[i]) for i in (1, 2, 3)}


@claim(
    "(2.12)",
    "k = [α̈, α⃛]/φ⁵ + (φ̈φ − 3φ̇²)/φ⁴ for any parameter.",
    method=Method.PROOF,
    form="b23/phi**5 + (phi2*phi - 3*phi1**2)/phi**4",
    wrong=(
        "b23/phi**5 + (phi2*phi - 2*phi1**2)/phi**4",
        "b23/phi**5 - (phi2*phi - 3*phi1**2)/phi**4",
        "b23/phi**4 + (phi2*phi - 3*phi1**2)/phi**4",
    ),
)
def curvature_of_any_parameter(form: str) -> Evidence:
    """k = [γ″, γ‴] with γ′ = α̇/φ and d/dr = φ⁻¹ d/du, on a generic jet."""
    return vanishes(read(form, BRACKETS | PHI) - affine_curvature(), "k", CURVE)


@claim(
    "proposition 2.2.3",
    "k needs four derivatives: k = (3φ³(4[α̈, α⃛] + [α̇, α⁗]) − 5[α̇, α⃛]²)/(9φ⁸).",
    method=Method.PROOF,
    form="(3*phi**3*(4*b23 + b14) - 5*b13**2)/(9*phi**8)",
    wrong=(
        "(3*phi**3*(4*b23 - b14) - 5*b13**2)/(9*phi**8)",
        "(3*phi**3*(4*b23 + b14) - 4*b13**2)/(9*phi**8)",
        "(3*phi**3*(4*b23 + b14) - 5*b13**2)/(9*phi**7)",
    ),
)
def curvature_in_jets(form: str) -> Evidence:
    """(2.12) with φ̇ = [α̇, α⃛]/(3φ²) and φ̈ by one more differentiation: all derivatives up to the fourth."""
    return vanishes(read(form, BRACKETS | PHI) - affine_curvature(), "k", CURVE)


def _gamma() -> Vector:
    return x[1] / phi, y[1] / phi


def _rate(vector: Vector) -> Vector:
    return derivative(vector[0]), derivative(vector[1])


@claim(
    "proposition 2.2.3-1",
    "In its proof: Γ = α̇/φ has Γ̇ = −(φ̇/φ²)α̇ + α̈/φ.",
    method=Method.PROOF,
    form="-phi1/phi**2*a1 + a2/phi",
    wrong=("phi1/phi**2*a1 + a2/phi", "-phi1/phi**3*a1 + a2/phi"),
)
def first_rate(form: str) -> Evidence:
    """The derivative by the parameter, on a generic jet."""
    return same_vectors(form, JET | PHI, [_rate(_gamma())], ["Γ̇"])


@claim(
    "proposition 2.2.3-2",
    "In its proof: Γ̈ = (2φ̇²/φ³ − φ̈/φ²)α̇ − 2(φ̇/φ²)α̈ + α⃛/φ.",
    method=Method.PROOF,
    form="(2*phi1**2/phi**3 - phi2/phi**2)*a1 - 2*phi1/phi**2*a2 + a3/phi",
    wrong=(
        "(phi1**2/phi**3 - phi2/phi**2)*a1 - 2*phi1/phi**2*a2 + a3/phi",
        "(2*phi1**2/phi**3 - phi2/phi**2)*a1 - phi1/phi**2*a2 + a3/phi",
    ),
)
def second_rate(form: str) -> Evidence:
    """The second derivative by the parameter, on a generic jet."""
    return same_vectors(form, JET | PHI, [_rate(_rate(_gamma()))], ["Γ̈"])


@claim(
    "proposition 2.2.3-3",
    "In its proof: u″(r) = −φ̇/φ³.",
    method=Method.PROOF,
    form="-phi1/phi**3",
    wrong=("-phi1/phi**2", "phi1/phi**3"),
)
def second_derivative_of_the_parameter(form: str) -> Evidence:
    """u′ = 1/φ(u), differentiated once more by r: d/dr = φ⁻¹ d/du."""
    return vanishes(read(form, PHI) - derivative(1 / phi) / phi, "u″", CURVE)


@claim(
    "proposition 2.2.3-4",
    "In its proof: γ″ = −(φ̇/φ³)α̇ + α̈/φ².",
    method=Method.PROOF,
    form="-phi1/phi**3*a1 + a2/phi**2",
    wrong=("-phi1/phi**2*a1 + a2/phi**2", "phi1/phi**3*a1 + a2/phi**2"),
)
def second_derivative(form: str) -> Evidence:
    """d/dr = φ⁻¹ d/du of γ′ = α̇/φ, on a generic jet."""
    return same_vectors(form, JET | PHI, [by_affine_arc_length(2)[1]], ["γ″"])


@claim(
    "proposition 2.2.3-5",
    "In its proof: γ‴ = (3φ̇²/φ⁵ − φ̈/φ⁴)α̇ − 3(φ̇/φ⁴)α̈ + α⃛/φ³.",
    method=Method.PROOF,
    form="(3*phi1**2/phi**5 - phi2/phi**4)*a1 - 3*phi1/phi**4*a2 + a3/phi**3",
    wrong=(
        "(3*phi1**2/phi**5 - phi2/phi**4)*a1 - 3*phi1/phi**3*a2 + a3/phi**3",
        "(2*phi1**2/phi**5 - phi2/phi**4)*a1 - 3*phi1/phi**4*a2 + a3/phi**3",
    ),
)
def third_derivative(form: str) -> Evidence:
    """d/dr = φ⁻¹ d/du of γ″, on a generic jet."""
    return same_vectors(form, JET | PHI, [by_affine_arc_length(3)[2]], ["γ‴"])


@claim(
    "proposition 2.2.3-6",
    "In its proof: k = [γ″, γ‴] = [α̈, α⃛]/φ⁵ − (3φ̇²/φ⁷ − φ̈/φ⁶)[α̇, α̈] + 3(φ̇²/φ⁷)[α̇, α̈] − (φ̇/φ⁶)[α̇, α⃛].",
    method=Method.PROOF,
    form="b23/phi**5 - (3*phi1**2/phi**7 - phi2/phi**6)*b12 + 3*phi1**2/phi**7*b12 - phi1/phi**6*b13",
    wrong=(
        "b23/phi**5 - (3*phi1**2/phi**7 - phi2/phi**6)*b12 + 3*phi1**2/phi**6*b12 - phi1/phi**6*b13",
        "b23/phi**5 - (3*phi1**2/phi**7 - phi2/phi**6)*b12 + 3*phi1**2/phi**7*b12 + phi1/phi**6*b13",
    ),
)
def expanded_bracket(form: str) -> Evidence:
    """γ″ and γ‴ along α̇, α̈, α⃛ with φ, φ̇, φ̈ and the brackets as free symbols, before (2.3) relates them."""
    free = sp.symbols("phi phi1 phi2 b12 b13 b23", real=True)
    f, f1, f2, b12, b13, b23 = free

    def along_r(a: tuple[Any, ...]) -> tuple[Any, ...]:
        rates = [sp.diff(c, f) * f1 + sp.diff(c, f1) * f2 for c in a]
        return tuple((rate + lower) / f for rate, lower in zip(rates, (0, *a[:2]), strict=True))

    second = along_r((1 / f, sp.Integer(0), sp.Integer(0)))
    third = along_r(second)
    pairs = {(0, 1): b12, (0, 2): b13, (1, 2): b23}
    expanded = sum((second[i] * third[j] - second[j] * third[i]) * b for (i, j), b in pairs.items())
    return vanishes(read(form, {s.name: s for s in free}) - expanded, "[γ″, γ‴]")


@claim(
    "proposition 2.2.3-7",
    "In its proof: [α̇, α̈] = φ³ and [α̇, α⃛] = 3φ²φ̇.",
    method=Method.PROOF,
    form="phi**3, 3*phi**2*phi1",
    wrong=("phi**3, phi**2*phi1", "phi**3, 3*phi*phi1"),
)
def brackets_by_phi(form: str) -> Evidence:
    """φ over a jet with φ̇ by the chain rule of the cube root; the derivative of [α̇, α̈] is [α̇, α⃛]."""
    cube, rate = read_tuple(form, {"phi": phi, "phi1": PHI["phi1"]}, 2)
    return vanishes(cube - D, "[α̇, α̈]", CURVE) & vanishes(rate - derivative(D), "[α̇, α⃛]", CURVE)


@claim(
    "remark 2.2.4",
    "k = (9κ⁴ − 5κ̇² + 3κκ̈)/(9κ^(8/3)), with derivatives by Euclidean arc length.",
    method=Method.PROOF,
    form="(9*kappa**4 - 5*kappa1**2 + 3*kappa*kappa2)/(9*kappa**(8/3))",
    wrong=(
        "(9*kappa**4 - 4*kappa1**2 + 3*kappa*kappa2)/(9*kappa**(8/3))",
        "(9*kappa**4 - 5*kappa1**2 - 3*kappa*kappa2)/(9*kappa**(8/3))",
        "(9*kappa**4 - 5*kappa1**2 + 3*kappa*kappa2)/(9*kappa**(5/3))",
    ),
)
def curvature_from_euclidean_curvature(form: str) -> Evidence:
    """k = [n, dn/dr], where n = dt/dr, t = T ds/dr and ds/dr = κ^(-1/3), differentiated by Frenet (2.6)."""
    root = kappas()["kappa"] ** sp.Rational(1, 3)
    _, n = euclidean_frame()
    rate = frenet_derivative(n)
    return vanishes(read(form, kappas()) - bracket(n, (rate[0] / root, rate[1] / root)), "k")


@claim(
    "section 2.2-2",
    "A curve is determined by k(r) up to equi-affine maps: its frame M = (t n) satisfies M′ = MK with "
    "K = (0, −k; 1, 0).",
    method=Method.PROOF,
    form="0, -k, 1, 0",
    wrong=("0, k, 1, 0", "1, -k, 1, 0", "0, -k, 2, 0"),
)
def determined_by_affine_curvature(form: str) -> Evidence:
    """First M′ = MK on a generic jet, then what that equation leaves free.

    Two curves with the same k have frames M, M̃ with (M̃M⁻¹)′ = M̃KM⁻¹ − M̃M⁻¹·MK·M⁻¹ = 0, so M̃ = AM with A
    constant, det A = 1 as both determinants are 1, and γ̃ = Aγ + b since γ′ = t. Both facts are computed
    with generic M, M̃ under the stated K.
    """
    first, second, third = by_affine_arc_length(3)
    entries = read_tuple(form, {"k": affine_curvature()}, 4)
    columns = [
        (entries[j] * first[i] + entries[j + 2] * second[i], (second, third)[j][i], "tn"[j], i + 1)
        for j in range(2)
        for i in range(2)
    ]
    found = [vanishes(a - b, f"{name}′, coordinate {i}", CURVE) for a, b, name, i in columns]
    k = sp.Symbol("k", real=True)
    K = sp.Matrix(2, 2, read_tuple(form, {"k": k}, 4))
    M, N = sp.Matrix(2, 2, sp.symbols("m:4")), sp.Matrix(2, 2, sp.symbols("n:4"))
    inverse = M.inv()
    rate = N * K * inverse - N * inverse * (M * K) * inverse
    found += [vanishes(entry, "(M̃M⁻¹)′") for entry in rate]
    found.append(vanishes(K.trace(), "(det M)′/det M = trace K"))
    return all_of(found)


@claim(
    "section 2.2-3",
    "Mirroring a curve keeps k and changes the sign of dk/dr.",
    method=Method.PROOF,
    form="k, -slope",
    wrong=("-k, -slope", "k, slope"),
)
def mirrored(form: str) -> Evidence:
    """y ↦ −y makes [α̇, α̈] and its cube root φ their negatives; that is put into k and dk/dr on a jet."""
    mirror = {s: -s for s in (*y, phi)}
    derived = (GENERIC.affine_curvature, GENERIC.affine_curvature_slope)
    values = read_tuple(form, dict(zip(("k", "slope"), derived, strict=True)), 2)
    return all_of(
        vanishes(value - d.subs(mirror, simultaneous=True), name)
        for value, d, name in zip(values, derived, ("k", "dk/dr"), strict=True)
    )
