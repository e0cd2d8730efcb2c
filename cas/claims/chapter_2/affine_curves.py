"""Section 2.2: affine arc length and the affine frame.

The checks run over the jets of a generic curve: v is its speed, and φ³ = [α̇, α̈].
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.plane_frames import (
    BRACKETS,
    CURVE,
    GENERIC,
    PHI,
    D,
    W,
    euclidean_frame,
    frenet_derivative,
    kappas,
    same_vectors,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, positive, read, read_tuple, vanishes
from osculant.cas.formulas.sympy_bridge import cbrt
from osculant.cas.jets.derivations.affine import by_affine_arc_length, curvature
from osculant.cas.jets.derivations.plane import along, bracket, derivative, phi, v, x, y


@claim(
    "(2.1)",
    "With du/dr = 1/φ, φ = [α̇, α̈]^(1/3), the reparametrised curve γ(r) = α(u(r)) has [γ′, γ″] = 1.",
    method=Method.PROOF,
    form="1",
    wrong=("-1", "phi"),
)
def unimodular(form: str) -> Evidence:
    """γ′ = α̇/φ and γ″ = (dγ′/du)/φ on a generic jet; φ̇ = [α̇, α⃛]/(3φ²) follows from φ³ = [α̇, α̈]."""
    first, second = by_affine_arc_length(2)
    return vanishes(bracket(first, second) - read(form, PHI), "[γ′, γ″]", CURVE)


@claim(
    "(2.2)",
    "For any change of parameter, [γ′, γ″] = [α̇, α̈]·(u′)³; so affine arc length has [α̇, α̈](u′)³ = 1.",
    method=Method.PROOF,
    form="b12*u1**3",
    wrong=("b12*u1**2", "b12*u1**3 + u2"),
)
def change_of_parameter(form: str) -> Evidence:
    """γ′ = u′α̇, γ″ = u′²α̈ + u″α̇ for a generic u; the second term of γ″ is parallel to γ′."""
    u1, u2 = sp.symbols("u1 u2", real=True)
    first = (u1 * x[1], u1 * y[1])
    second = (u1**2 * x[2] + u2 * x[1], u1**2 * y[2] + u2 * y[1])
    stated = read(form, BRACKETS | {"u1": u1, "u2": u2})
    return vanishes(bracket(first, second) - stated, "[γ′, γ″]")


@claim(
    "(2.3)",
    "φ = [α̇, α̈]^(1/3) is dr/du for affine arc length r, so r does not depend on the parameter of α.",
    method=Method.PROOF,
    form="cbrt(b12)",
    wrong=("b12**(1/2)", "cbrt(abs(b12))", "b12**(2/3)", "2*cbrt(b12)", "-cbrt(b12)", "0"),
)
def affine_speed(form: str) -> Evidence:
    """Under u = u(τ) the bracket becomes [α̇, α̈]u′³ by (2.2), and φ dτ must become φ du: φ ↦ φu′.

    With [α̇, α̈] = w³, w > 0, and u′ > 0 that is an identity for multiples of the cube root and for no other
    power; with −w³ it must be −φ, as the real cube root is. The factor: γ′ = α̇/f and γ″ = (dγ′/du)/f have
    [γ′, γ″] = [α̇, α̈]/f³ for a generic f, and that is 1 for f = φ.
    """
    w, rate = sp.symbols("w u1", positive=True)
    f, slope = sp.symbols("f f1", real=True)

    def speed(value: Any) -> Any:  # cbrt is odd, so what is left under it is positive
        return read(form, {"b12": value}).replace(cbrt, lambda inner: inner ** sp.Rational(1, 3))

    stated = speed(w**3)
    first = (x[1] / f, y[1] / f)
    second = tuple((z[2] / f - z[1] * slope / f**2) / f for z in (x, y))
    scale = vanishes(bracket(first, second) - D / f**3, "[γ′, γ″] − [α̇, α̈]/f³")
    unit = vanishes(w**3 - stated**3, "[α̇, α̈] − φ³") & positive(stated, "φ for [α̇, α̈] > 0")
    unit &= vanishes(speed(-(w**3)) + w, "φ for [α̇, α̈] = −w³ against −w")
    return scale & unit & vanishes(speed(w**3 * rate**3) - stated * rate, "φ(τ) − φ(u)u′")


@claim(
    "(2.4)",
    "du/dr = 1/φ.",
    method=Method.PROOF,
    form="1/phi",
    wrong=("phi", "1/phi**2", "-1/phi"),
)
def parameter_rate(form: str) -> Evidence:
    """The equation [α̇, α̈](u′)³ = 1 of (2.2) with [α̇, α̈] = φ³."""
    rate = read(form, PHI)
    return vanishes(D * rate**3 - 1, "[α̇, α̈](u′)³ − 1", CURVE)


@claim(
    "(2.5)",
    "γ‴ = −kγ′ by affine arc length, with k = [γ″, γ‴].",
    method=Method.PROOF,
    form="-k*t",
    wrong=("k*t", "-k*n", "-k*t + n"),
)
def structure_equation(form: str) -> Evidence:
    """γ‴ computed on a generic jet is compared with −[γ″, γ‴]γ′, coordinate by coordinate."""
    first, second, third = by_affine_arc_length(3)
    symbols = {"k": bracket(second, third), "t": first, "n": second}
    return same_vectors(form, symbols, [third], ["γ‴"])


@claim(
    "(2.6)",
    "α′ = T, T′ = κN, N′ = −κT by Euclidean arc length.",
    method=Method.PROOF,
    form="T, kappa*N, -kappa*T",
    wrong=("T, -kappa*N, kappa*T", "T, kappa*N, kappa*T", "T, N, -kappa*T"),
)
def frenet(form: str) -> Evidence:
    """T = α̇/v and N, T turned by 90° to the left, are differentiated on a generic jet; κ = [α̇, α̈]/v³."""
    tangent, normal = (x[1] / v, y[1] / v), (-y[1] / v, x[1] / v)
    derived = [(x[1] / v, y[1] / v), along(tangent, v), along(normal, v)]
    symbols = {"T": tangent, "N": normal, "kappa": GENERIC.curvature}
    return same_vectors(form, symbols, derived, ["α′", "T′", "N′"])


@claim(
    "(2.7)",
    "α′ = t, t′ = n, n′ = −kt by affine arc length.",
    method=Method.PROOF,
    form="t, n, -k*t",
    wrong=("t, n, k*t", "t, n, -k*n", "t, -n, -k*t"),
)
def affine_frame_equations(form: str) -> Evidence:
    """The closed forms of t, n, k over jets that the programs evaluate, against d/dr of α, t and n."""
    t, n = GENERIC.affine_tangent, GENERIC.affine_normal
    symbols = {"t": t, "n": n, "k": GENERIC.affine_curvature}
    derived = [(x[1] / phi, y[1] / phi), along(t, phi), along(n, phi)]
    return same_vectors(form, symbols, derived, ["α′", "t′", "n′"])


@claim(
    "lemma 2.2.1.1",
    "Affine arc length r and Euclidean arc length s satisfy dr/ds = κ^(1/3).",
    method=Method.PROOF,
    form="kappa**(1/3)",
    wrong=("kappa**(1/2)", "kappa**(2/3)", "kappa"),
)
def affine_arc_length(form: str) -> Evidence:
    """By arc length α̇ = T and α̈ = κN, so φ³ = [T, κN] = κ, and φ = dr/ds by (2.4)."""
    kappa = kappas()
    T = (sp.Integer(1), sp.Integer(0))
    return vanishes(read(form, kappa) ** 3 - bracket(T, frenet_derivative(T)), "(dr/ds)³ − [α̇, α̈]")


@claim(
    "(2.8)",
    "dr/ds = κ^(1/3), from the frames: [T, N] = 1 and [t, n] = 1.",
    method=Method.PROOF,
    form="kappa**(1/3)",
    wrong=("kappa**(1/2)", "-kappa**(1/3)", "kappa**(-1/3)"),
)
def affine_arc_length_from_frames(form: str) -> Evidence:
    """T = ṙt and κN = r̈t + ṙ²n give 1 = [T, N] = ṙ³/κ: (2.10) with r̈ generic."""
    rate, bend = read(form, kappas()), sp.Symbol("r2", real=True)
    tangent, normal = (rate, 0), (bend / W[0] ** 3, rate**2 / W[0] ** 3)
    return vanishes(bracket(tangent, normal) - 1, "[T, N] − 1")


@claim(
    "lemma 2.2.1.2",
    "t = κ^(-1/3) T and n = −(1/3) κ^(-5/3) κ̇ T + κ^(1/3) N.",
    method=Method.PROOF,
    form="kappa**(-1/3)*T, -1/3*kappa**(-5/3)*kappa1*T + kappa**(1/3)*N",
    wrong=(
        "kappa**(-1/3)*T, 1/3*kappa**(-5/3)*kappa1*T + kappa**(1/3)*N",
        "kappa**(-1/3)*T, -1/3*kappa**(-4/3)*kappa1*T + kappa**(1/3)*N",
        "kappa**(1/3)*T, -1/3*kappa**(-5/3)*kappa1*T + kappa**(1/3)*N",
    ),
)
def frames(form: str) -> Evidence:
    """t = T ds/dr and n = (dt/ds) ds/dr with ds/dr = κ^(-1/3), differentiated by (2.6)."""
    found = []
    for i, axis in enumerate("TN"):
        basis = {"T": 1 - i, "N": i}
        stated = read_tuple(form, kappas() | basis, 2)
        for value, derived, name in zip(stated, euclidean_frame(), "tn", strict=True):
            found.append(vanishes(value - derived[i], f"{name} along {axis}"))
    return all_of(found)


@claim(
    "(2.9)",
    "The frames of Lemma 2.2.1 for any parameter: t = T/κ^(1/3), n = −κ̇T/(3κ^(5/3)) + κ^(1/3)N.",
    method=Method.PROOF,
    form="T/root, -kappa1*T/(3*root**5) + root*N",
    wrong=("T/root, -kappa1*T/(3*root**4) + root*N", "T/root, -kappa1*T/root**5 + root*N"),
)
def frames_of_any_parameter(form: str) -> Evidence:
    """On a generic jet ``root`` = φ/v, the real cube root of κ also where κ < 0; κ̇ = (dκ/du)/v."""
    first, second = by_affine_arc_length(2)
    symbols = {
        "T": (x[1] / v, y[1] / v),
        "N": (-y[1] / v, x[1] / v),
        "root": phi / v,
        "kappa1": curvature(1),
    }
    return same_vectors(form, symbols, [first, second], ["t", "n"])


@claim(
    "(2.10)",
    "T = ṙt and N = κ⁻¹(r̈t + ṙ²n).",
    method=Method.PROOF,
    form="r1*t, (r2*t + r1**2*n)/kappa",
    wrong=("r1*t, (r2*t + r1*n)/kappa", "r1*t, (r1**2*t + r2*n)/kappa", "r1*t, (r2*t + r1**2*n)*kappa"),
)
def euclidean_from_affine(form: str) -> Evidence:
    """ṙ = φ/v and r̈ = (dṙ/du)/v on a generic jet, with t and n by definition."""
    t, n = by_affine_arc_length(2)
    rate = phi / v
    symbols = {"t": t, "n": n, "r1": rate, "r2": derivative(rate) / v, "kappa": GENERIC.curvature}
    return same_vectors(form, symbols, [(x[1] / v, y[1] / v), (-y[1] / v, x[1] / v)], ["T", "N"])
