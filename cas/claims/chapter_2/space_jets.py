"""Claims beyond section 2.3: the forms over jets that programs run, any parameter, usual torsion."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.space_frames import GAMMA, V, W
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors, same
from osculant.cas.jets.derivations.space import (
    GENERIC,
    N,
    beta,
    derivative,
    kappa,
    kappas,
    speed,
    tau,
    taus,
    turned,
    turned_rate,
    turned_vector,
)
from osculant.cas.numbers.vectors import add, cross, dot, scale


@claim(
    "X2.3-1",
    "In the usual sign of the torsion τ: the Darboux vector Ω = τT + κB gives "
    "T' = Ω × T, N' = Ω × N, B' = Ω × B.",
    method=Method.PROOF,
    form="tau*T + kappa*B",
    wrong=("tau*T - kappa*B", "-tau*T - kappa*B"),
)
def usual_darboux_vector(form: str) -> Evidence:
    """The frame of a generic jet, differentiated, against cross products; compared in turned coordinates."""
    frame = {name: turned_vector(v) for name, v in zip("TNB", GENERIC.frenet_frame)}
    scalars = {"kappa": turned(GENERIC.curvature), "tau": turned(GENERIC.torsion)}
    (omega,) = read_vectors(form, scalars, frame, 1)
    products = [cross(omega, v) for v in frame.values()]
    return same(products, [turned_rate(v) for v in GENERIC.frenet_frame], "Ω × X against X'")


@claim(
    "X2.3-2",
    "In the usual sign of the torsion and any parameter, with c = α̇ × α̈, c₁ = α̇ × α⃛: (τ/κ)' = "
    "([124]|α̇|²|c|² + 3[123](⟨12⟩|c|² − |α̇|²⟨c, c₁⟩))/|c|⁵; by arc length det(α'', α''', α'''')/κ⁵.",
    method=Method.PROOF,
    form="(d124*v**2*w**2 + 3*d123*(p12*w**2 - v**2*q))/w**5",
    wrong=(
        "-(d124*v**2*w**2 + 3*d123*(p12*w**2 - v**2*q))/w**5",
        "(d124*v**2*w**2 + 3*d123*(p12*w**2 + v**2*q))/w**5",
        "(d124*v**2*w**2 + 2*d123*(p12*w**2 - v**2*q))/w**5",
    ),
)
def usual_ratio_slope(form: str) -> Evidence:
    """d(τ/κ)/dt of a generic jet over |α̇|; the same as `SpaceJet.ratio_slope`, which programs run."""
    jet = GENERIC
    names = {
        "d123": jet.det(1, 2, 3),
        "d124": jet.det(1, 2, 4),
        "p12": jet.dot(1, 2),
        "q": dot(jet.cross(1, 2), jet.cross(1, 3)),
        "v": jet.speed,
        "w": jet.root(jet.inflection_form, 2),
    }
    derived = turned(derivative(jet.torsion / jet.curvature) / speed)
    stated = vanishes(derived - turned(read(form, names)), "(τ/κ)' of a jet")
    return stated & vanishes(derived - turned(jet.ratio_slope), "SpaceJet.ratio_slope")


@claim(
    "X2.3-3",
    "In any parameter, usual sign: κ' = (⟨c, c₁⟩v² − 3w²⟨12⟩)/(w v⁶), τ' = ([124]w² − 2[123]⟨c, c₁⟩)/(v w⁴), "
    "v = |α̇|, w = |c|.",
    method=Method.PROOF,
    form="(q*v**2 - 3*w**2*p12)/(w*v**6), (d124*w**2 - 2*d123*q)/(v*w**4)",
    wrong=(
        "(q*v**2 - 2*w**2*p12)/(w*v**6), (d124*w**2 - 2*d123*q)/(v*w**4)",
        "(q*v**2 - 3*w**2*p12)/(w*v**6), (d124*w**2 - d123*q)/(v*w**4)",
    ),
)
def slopes(form: str) -> Evidence:
    """κ and τ of a generic jet differentiated by t, over |α̇|; compared in turned coordinates."""
    jet = GENERIC
    names: dict[str, Any] = {
        "d123": jet.det(1, 2, 3),
        "d124": jet.det(1, 2, 4),
        "p12": jet.dot(1, 2),
        "q": dot(jet.cross(1, 2), jet.cross(1, 3)),
        "v": jet.speed,
        "w": jet.root(jet.inflection_form, 2),
    }
    evidence = Evidence(True)
    programmed = (jet.curvature_slope, jet.torsion_slope)
    for name, function, stated, run in zip(
        "κτ", (jet.curvature, jet.torsion), read_tuple(form, names, 2), programmed, strict=True
    ):
        derived = turned(derivative(function) / speed)
        evidence &= vanishes(derived - turned(stated), f"{name}' of a jet")
        evidence &= vanishes(derived - turned(run), f"{name}' of SpaceJet")
    return evidence


@claim(
    "X2.3-4",
    "The Darboux frame {N, W, V} that programs compute from a jet is the thesis's; in the usual sign of τ it "
    "moves by (2.17) with γ = −(τ/κ)'/(1 + (τ/κ)²).",
    method=Method.PROOF,
    form="-slope/(1 + ratio**2)",
    wrong=("slope/(1 + ratio**2)", "-slope/(1 + ratio**2)**2"),
)
def darboux_frame_of_jets(form: str) -> Evidence:
    """V, W of (2.14), (2.15) and γ = ⟨V', W⟩, with −τ, −τ' of a generic jet inserted for τ, τ'."""
    jet = GENERIC
    values = {
        kappa: turned(jet.curvature),
        tau: -turned(jet.torsion),
        kappas[1]: turned(jet.curvature_slope),
        taus[1]: -turned(jet.torsion_slope),
    }
    values[beta] = sp.sqrt(values[kappa] ** 2 + values[tau] ** 2)

    def inserted(function: Any) -> Any:
        return sp.sympify(function).subs(values, simultaneous=True)

    frenet_frame = [turned_vector(v) for v in jet.frenet_frame]
    frame = [add(*(scale(inserted(a), v) for a, v in zip(u, frenet_frame))) for u in (N, W, V)]
    slope = turned(jet.ratio_slope)
    stated = read(form, {"slope": slope, "ratio": turned(jet.torsion / jet.curvature)})
    rate = vanishes(turned(jet.axis_rate) - stated, "SpaceJet.axis_rate")
    derived = vanishes(inserted(GAMMA) - stated, "⟨V', W⟩")
    return (
        rate & derived & same([turned_vector(v) for v in jet.darboux_frame], frame, "SpaceJet.darboux_frame")
    )
