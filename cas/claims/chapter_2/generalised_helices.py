"""Claims of section 2.3.2: generalised helices; the torsion τ is the thesis's, minus the usual one.

Vectors have components along {N₀, W₀, V₀}. A generic generalised helix has generic φ(s) with φ(0) = 0,
φ' = β, and constants κ̄ = 2m/(1 + m²), τ̄ = (1 − m²)/(1 + m²), m > 0: all with κ̄ > 0, κ̄² + τ̄² = 1.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.helix_frames import BETA, KAPPAB, N0, PHI, T0, TAUB, V0, W0, C, S, phis, s
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import positive, read, read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors, same
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.vectors import Vector3, add, cross, dot, scale, subtract

SCALARS = {"kappab": KAPPAB, "taub": TAUB, "phi": PHI, "C": C, "S": S, "s": s, "beta": BETA}
SCALARS["kappa"] = KAPPAB * BETA
VECTORS = {"N0": N0, "W0": W0, "V0": V0, "T0": T0, "T0xV0": cross(T0, V0)}
START = {C: 0, S: 0, s: 0, PHI: 0}


def by_arc_length(function: Any) -> Any:
    """d/ds, where C' = cos φ and S' = sin φ (2.18)."""
    function = sp.sympify(function).subs(BETA, phis[1])
    rates = {**dict(pairwise(phis)), C: sp.cos(PHI), S: sp.sin(PHI), s: 1}
    return sum((sp.diff(function, a) * rate for a, rate in rates.items()), sp.S.Zero)


def rate(vector: Vector3) -> Vector3:
    """d/ds of each component."""
    return tuple(by_arc_length(a) for a in vector)


def rational(expression: Any) -> Any:
    """cos φ, sin φ by the tangent of φ/2, and φ' for β: an identity becomes one of rational functions."""
    half = sp.Symbol("h", real=True)
    circle = {sp.cos(PHI): (1 - half**2) / (1 + half**2), sp.sin(PHI): 2 * half / (1 + half**2)}
    return sp.sympify(expression).subs(BETA, phis[1]).subs(circle).subs(phis[1], BETA)


def _agree(vector: Vector3, expected: Vector3, what: str) -> Evidence:
    return same([tuple(map(rational, vector))], [tuple(map(rational, expected))], what)


def _is_the_helix(curve: Vector3) -> Evidence:
    """Frame {T₀, N₀} at s = 0, unit speed, κ = κ̄β and usual torsion −τ̄β, from the curve's derivatives."""
    jet = [curve]
    for _ in range(3):
        jet.append(rate(jet[-1]))
    start = [tuple(sp.sympify(a).subs(START) for a in v) for v in jet]
    evidence = _agree(start[0], (sp.S.Zero,) * 3, "α(0)")
    evidence &= _agree(start[1], T0, "α'(0) = T₀")
    evidence &= _agree(start[2], scale(KAPPAB * BETA, N0), "α''(0) = κN₀")
    x, y, z = zip(*([rational(a) for a in v] for v in jet))
    forms = SpaceJet(x, y, z)
    bend = (KAPPAB * BETA) ** 2
    evidence &= vanishes(forms.speed_squared - 1, "|α'|² = 1")
    evidence &= vanishes(forms.inflection_form - bend, "curvature κ̄β")
    return evidence & vanishes(forms.torsion_form + TAUB * BETA * bend, "usual torsion −τ̄β")


@claim(
    "remark 2.3.3",
    "For a generalised helix V is constant, since γ = 0; also κ̄ = 1/√(1 + (τ/κ)²) and "
    "τ̄ = (τ/κ)/√(1 + (τ/κ)²) depend on τ/κ alone.",
    method=Method.PROOF,
    form="1/sqrt(1 + r**2), r/sqrt(1 + r**2)",
    printed="1/sqrt(1 + r**2), 1/sqrt(1 + 1/r**2)",
    erratum="The formula 1/√(1 + (κ/τ)²) gives |τ̄|: it is wrong for negative τ and undefined for τ = 0.",
    wrong=("r/sqrt(1 + r**2), 1/sqrt(1 + r**2)", "1/(1 + r**2), r/(1 + r**2)"),
)
def quotients_of_a_generalised_helix(form: str) -> Evidence:
    """κ̄ = κ/β and τ̄ = τ/β with τ = rκ, for r > 0, r = 0 and r < 0; κ > 0."""
    k, size = sp.symbols("kappa r", positive=True)
    evidence = Evidence(True)
    for r, what in ((size, "τ > 0"), (-size, "τ < 0")):
        beta = k * sp.sqrt(1 + r**2)
        for stated, expected in zip(read_tuple(form, {"r": r}, 2), (k / beta, r * k / beta), strict=True):
            evidence &= vanishes(stated - expected, what)
    return evidence


@claim(
    "(2.18)",
    "C = ∫cos φ and S = ∫sin φ, φ = ∫β: the plane curve (C, S) has unit speed and curvature β = √(κ² + τ²).",
    method=Method.PROOF,
    form="1, beta",
    wrong=("1, kappa", "beta, 1", "1, -beta", "-1, beta"),
)
def base_curve(form: str) -> Evidence:
    """Speed and curvature of the jet (C, S), (cos φ, sin φ), (−β sin φ, β cos φ)."""
    first = by_arc_length(C), by_arc_length(S)
    second = by_arc_length(first[0]), by_arc_length(first[1])
    jet = PlaneJet((C, first[0], second[0]), (S, first[1], second[1]))
    speed, curvature = read_tuple(form, SCALARS, 2)
    unit = positive(speed, "the speed") & vanishes(rational(jet.speed_squared - speed**2), "|(C, S)'|²")
    return unit & vanishes(rational(jet.inflection_form / jet.speed_squared - curvature), "curvature")


@claim(
    "(2.19)",
    "For a generalised helix N' = −βW and W' = βN.",
    method=Method.PROOF,
    form="-beta*W, beta*N",
    wrong=("beta*W, -beta*N", "-beta*W, -beta*N", "-beta*N, beta*W"),
)
def helix_motion(form: str) -> Evidence:
    """The Darboux frame differentiated in the ring of generic κ, τ, then (τ/κ)' = 0 inserted."""
    from osculant.cas.jets.derivations import space

    axis = (space.tau / space.beta, sp.S.Zero, -space.kappa / space.beta)
    companion = cross(axis, space.N)
    straight = {space.taus[1]: space.tau * space.kappas[1] / space.kappa}
    found = [tuple(a.subs(straight) for a in map(sp.sympify, space.moved(v))) for v in (space.N, companion)]
    stated = read_vectors(form, {"beta": space.beta}, {"W": companion, "N": space.N}, 2)
    return same(found, stated, "N', W'", [space.RELATION])


@claim(
    "(2.20)",
    "The solution of (2.19) is W = cos φ W₀ + sin φ N₀, N = −sin φ W₀ + cos φ N₀.",
    method=Method.PROOF,
    form="cos(phi)*W0 + sin(phi)*N0, -sin(phi)*W0 + cos(phi)*N0",
    wrong=(
        "cos(phi)*W0 - sin(phi)*N0, sin(phi)*W0 + cos(phi)*N0",
        "cos(phi)*W0 + sin(phi)*N0, sin(phi)*W0 - cos(phi)*N0",
    ),
)
def frame_along_a_helix(form: str) -> Evidence:
    """Inserted into (2.19), and the initial values; linear differential equations have one solution."""
    w, n = read_vectors(form, SCALARS, VECTORS, 2)
    evidence = _agree(rate(w), scale(phis[1], n), "W' = βN") & _agree(rate(n), scale(-phis[1], w), "N' = −βW")
    for v, expected, name in ((w, W0, "W(0)"), (n, N0, "N(0)")):
        start = tuple(sp.sympify(a).subs(START) for a in v)
        evidence &= _agree(start, expected, name)
    return evidence


@claim(
    "lemma 2.3.4",
    "A generalised helix is α(s) = α(0) + sτ̄V₀ + κ̄(C(s)W₀ + S(s)N₀), with constant V₀, κ̄, τ̄.",
    method=Method.PROOF,
    form="s*taub*V0 + kappab*(C*W0 + S*N0)",
    printed="s*taub*V0 + kappa*C*W0 + S*N0",
    erratum="The factor before C(s)W₀ + S(s)N₀ seems to be the function κ(s), without a bracket; it is the "
    "constant κ̄ = κ/β.",
    uncertain=True,
    wrong=(
        "s*taub*V0 + kappab*(C*W0 - S*N0)",
        "s*taub*V0 + C*W0 + S*N0",
        "s*taub*V0 + kappab*(S*W0 + C*N0)",
        "s*V0 + kappab*(C*W0 + S*N0)",
    ),
)
def generalised_helix(form: str) -> Evidence:
    """The form's curve has the frame {T₀, N₀} at 0, unit speed, κ = κ̄β and τ = τ̄β for generic β(s).

    By the fundamental theorem of space curves there is one such curve.
    """
    (curve,) = read_vectors(form, SCALARS, VECTORS, 1)
    return _is_the_helix(curve)


@claim(
    "lemma 2.3.4.1",
    "A generalised helix lies on a cylinder with ruling V₀: T makes a constant angle with V₀, ⟨T, V₀⟩ = τ̄.",
    method=Method.PROOF,
    form="taub",
    wrong=("kappab", "-taub", "1"),
)
def constant_slope(form: str) -> Evidence:
    """⟨T, V⟩ in the ring of generic κ, τ is τ/β; and V' = 0 when (τ/κ)' = 0."""
    from osculant.cas.jets.derivations import space

    axis = (space.tau / space.beta, sp.S.Zero, -space.kappa / space.beta)
    straight = {space.taus[1]: space.tau * space.kappas[1] / space.kappa}
    rest = [tuple(a.subs(straight) for a in map(sp.sympify, space.moved(axis)))]
    fixed = same(rest, [(sp.S.Zero,) * 3], "V' for (τ/κ)' = 0", [space.RELATION])
    stated = read(form, {"taub": space.tau / space.beta, "kappab": space.kappa / space.beta})
    return fixed & vanishes(dot(space.T, axis) - stated, "⟨T, V⟩", [space.RELATION])


@claim(
    "corollary 2.3.5.1",
    "A generalised helix is α(s) = α(0) + sτ̄V₀ + C(s)(T₀ − τ̄V₀) + S(s)T₀×V₀.",
    method=Method.PROOF,
    form="s*taub*V0 + C*(T0 - taub*V0) + S*T0xV0",
    wrong=("s*taub*V0 + C*(T0 - taub*V0) - S*T0xV0", "s*taub*V0 + C*T0 + S*T0xV0"),
)
def generalised_helix_from_tangent(form: str) -> Evidence:
    """As lemma 2.3.4, with T₀ = τ̄V₀ + κ̄W₀; also the base curve lies in the plane perpendicular to V₀."""
    (curve,) = read_vectors(form, SCALARS, VECTORS, 1)
    base = vanishes(dot(subtract(curve, scale(s * TAUB, V0)), V0), "⟨γ(s) − α(0), V₀⟩")
    return _is_the_helix(curve) & base


@claim(
    "corollary 2.3.5.2",
    "Its unit tangent vector is T(s) = T₀ + (cos φ − 1)(T₀ − τ̄V₀) + sin φ T₀×V₀.",
    method=Method.PROOF,
    form="T0 + (cos(phi) - 1)*(T0 - taub*V0) + sin(phi)*T0xV0",
    wrong=(
        "T0 + (cos(phi) + 1)*(T0 - taub*V0) + sin(phi)*T0xV0",
        "T0 + (cos(phi) - 1)*(T0 - taub*V0) - sin(phi)*T0xV0",
    ),
)
def tangent_of_a_generalised_helix(form: str) -> Evidence:
    """The derivative of the curve of corollary 2.3.5.1."""
    curve = add(scale(s * TAUB, V0), scale(C, subtract(T0, scale(TAUB, V0))), scale(S, cross(T0, V0)))
    return _agree(rate(curve), read_vectors(form, SCALARS, VECTORS, 1)[0], "T(s)")


@claim(
    "remark 2.3.6",
    "T₀ − τ̄V₀ = κ̄W₀ and T₀×V₀ = κ̄N₀, so {V₀, T₀ − τ̄V₀, T₀×V₀} is orthogonal.",
    method=Method.PROOF,
    form="kappab*W0, kappab*N0",
    wrong=("kappab*W0, -kappab*N0", "W0, N0", "kappab*N0, kappab*W0"),
)
def helix_frame(form: str) -> Evidence:
    """Components along {N₀, W₀, V₀}, and the three inner products."""
    along, across = subtract(T0, scale(TAUB, V0)), cross(T0, V0)
    evidence = same([along, across], read_vectors(form, SCALARS, VECTORS, 2), "T₀ − τ̄V₀, T₀×V₀")
    for a, b in ((V0, along), (V0, across), (along, across)):
        evidence &= vanishes(dot(a, b), "inner product")
    return evidence
