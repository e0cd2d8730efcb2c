"""Claims of section 4.2: circular helices; the torsion τ is the thesis's, minus the usual one.

Vectors have components along {N₀, W₀, V₀}, as for generalised helices, with φ = βs and β constant.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_2.helix_frames import BETA, KAPPAB, N0, T0, TAUB, V0, s
from osculant.cas.claims.chapter_4.helix_points import HELIX, SCALARS, TANGENT, VECTORS, _rational, agree
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import positive, read, read_tuple, split, vanishes
from osculant.cas.claims.vectors import read_vectors
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.vectors import Vector3, cross, dot, scale, subtract

ZERO: Vector3 = (sp.S.Zero, sp.S.Zero, sp.S.Zero)
SCALARS |= {"kappa": KAPPAB * BETA, "tau": TAUB * BETA}


def _rate(vector: Vector3) -> Vector3:
    return tuple(sp.diff(a, s) for a in vector)


def _is_the_helix(curve: Vector3) -> Evidence:
    """α(0) = 0, frame {T₀, N₀} at 0, unit speed, κ = κ̄β, usual torsion −τ̄β."""
    jet = [curve]
    for _ in range(3):
        jet.append(_rate(jet[-1]))
    starts = (ZERO, T0, scale(KAPPAB * BETA, N0))
    evidence = Evidence(True)
    for v, expected, name in zip(jet, starts, ("α(0)", "α'(0) = T₀", "α''(0) = κN₀")):
        evidence &= agree([sp.sympify(a).subs(s, 0) for a in v], expected, name)
    x, y, z = zip(*([_rational(a) for a in v] for v in jet))
    forms = SpaceJet(x, y, z)
    bend = (KAPPAB * BETA) ** 2
    evidence &= vanishes(forms.speed_squared - 1, "|α'|² = 1")
    evidence &= vanishes(forms.inflection_form - bend, "curvature κ")
    return evidence & vanishes(forms.torsion_form + TAUB * BETA * bend, "usual torsion −τ")


@claim(
    "(4.1)",
    "For constant β: C(s) = sin(βs)/β and S(s) = (1 − cos βs)/β.",
    method=Method.PROOF,
    form="sin(beta*s)/beta, (1 - cos(beta*s))/beta",
    wrong=("sin(beta*s)/beta, -cos(beta*s)/beta", "sin(beta*s), 1 - cos(beta*s)"),
)
def integrals(form: str) -> Evidence:
    """∫₀ˢ cos βu du and ∫₀ˢ sin βu du."""
    derived = [sp.integrate(f(BETA * s), (s, 0, s)) for f in (sp.cos, sp.sin)]
    evidence = Evidence(True)
    for a, b, name in zip(read_tuple(form, SCALARS, 2), derived, "CS", strict=True):
        evidence &= vanishes(_rational(a - b), name)
    return evidence


@claim(
    "lemma 4.2.1",
    "The helix with constant κ, τ and frame {T₀, N₀} at p₀ is "
    "α(s) = p₀ + sτ̄V₀ + (κ̄/β)(sin(βs)W₀ + (1 − cos βs)N₀).",
    method=Method.PROOF,
    form="s*taub*V0 + kappab/beta*(sin(beta*s)*W0 + (1 - cos(beta*s))*N0)",
    printed="s*taub*V0 + kappab/beta*sin(beta*s)*W0 + (1 - cos(beta*s))*N0",
    erratum="A bracket seems to be missing: the factor κ̄/β belongs to both terms.",
    uncertain=True,
    wrong=(
        "s*taub*V0 + kappab/beta*(sin(beta*s)*W0 - (1 - cos(beta*s))*N0)",
        "s*taub*V0 + kappa/beta*(sin(beta*s)*W0 + (1 - cos(beta*s))*N0)",
        "s*tau*V0 + kappab/beta*(sin(beta*s)*W0 + (1 - cos(beta*s))*N0)",
    ),
)
def circular_helix(form: str) -> Evidence:
    """Frame at 0, unit speed, κ = κ̄β and usual torsion −τ̄β from the derivatives of the form's curve."""
    return _is_the_helix(read_vectors(form, SCALARS, VECTORS, 1)[0])


@claim(
    "lemma 4.2.1.1",
    "The axis is the line through p₀ + κ/(κ² + τ²) N₀ with direction V₀.",
    method=Method.PROOF,
    form="kappa/(kappa**2 + tau**2)*N0, V0",
    wrong=(
        "-kappa/(kappa**2 + tau**2)*N0, V0",
        "N0/kappa, V0",
        "kappa/(kappa**2 + tau**2)*N0, W0",
        "kappa/(kappa**2 + tau**2)*N0, 0*V0",
    ),
)
def axis(form: str) -> Evidence:
    """The distance of α(s) from the line does not depend on s."""
    point, direction = read_vectors(form, SCALARS, VECTORS, 2)
    arm, size = subtract(HELIX, point), dot(direction, direction)
    if size == 0:
        return Evidence(False, ("the direction is 0",))
    distance = dot(arm, arm) - dot(arm, direction) ** 2 / size
    return vanishes(_rational(sp.diff(distance, s)), "d/ds of the squared distance from the line")


@claim(
    "lemma 4.2.1.2",
    "The radius of the cylinder that carries the helix is κ/(κ² + τ²).",
    method=Method.PROOF,
    form="kappa/(kappa**2 + tau**2)",
    wrong=(
        "1/kappa",
        "kappa/sqrt(kappa**2 + tau**2)",
        "tau/(kappa**2 + tau**2)",
        "-kappa/(kappa**2 + tau**2)",
    ),
)
def radius(form: str) -> Evidence:
    """The projection along V₀ is a circle of constant curvature: its radius is 1/curvature."""
    plane = [subtract(v, scale(dot(v, V0), V0)) for v in (TANGENT, _rate(TANGENT))]
    turn = cross(*plane)
    squared = dot(plane[0], plane[0]) ** 3 / dot(turn, turn)
    stated = read(form, SCALARS)
    return positive(stated, "the radius") & vanishes(_rational(stated**2 - squared), "radius²")


@claim(
    "corollary 4.2.2.1",
    "In the frame {T₀, V₀, T₀×V₀}: α(s) = p₀ + sτ̄V₀ + (1/β)(sin(βs)(T₀ − τ̄V₀) + (1 − cos βs)T₀×V₀).",
    method=Method.PROOF,
    form="s*taub*V0 + (sin(beta*s)*(T0 - taub*V0) + (1 - cos(beta*s))*T0xV0)/beta",
    wrong=(
        "s*taub*V0 + (sin(beta*s)*(T0 - taub*V0) - (1 - cos(beta*s))*T0xV0)/beta",
        "s*taub*V0 + (sin(beta*s)*T0 + (1 - cos(beta*s))*T0xV0)/beta",
        "s*taub*V0 + kappab/beta*(sin(beta*s)*(T0 - taub*V0) + (1 - cos(beta*s))*T0xV0)",
    ),
)
def helix_from_tangent(form: str) -> Evidence:
    """As lemma 4.2.1, with T₀ = τ̄V₀ + κ̄W₀ and T₀×V₀ = κ̄N₀."""
    return _is_the_helix(read_vectors(form, SCALARS, VECTORS, 1)[0])


@claim(
    "corollary 4.2.2.2",
    "Its unit tangent vector is T(s) = T₀ + (cos βs − 1)(T₀ − τ̄V₀) + sin βs T₀×V₀.",
    method=Method.PROOF,
    form="T0 + (cos(beta*s) - 1)*(T0 - taub*V0) + sin(beta*s)*T0xV0",
    wrong=(
        "T0 + (cos(beta*s) - 1)*(T0 + taub*V0) + sin(beta*s)*T0xV0",
        "T0 + (cos(beta*s) - 1)*(T0 - taub*V0) - sin(beta*s)*T0xV0",
    ),
)
def tangent(form: str) -> Evidence:
    """The derivative of the helix of lemma 4.2.1."""
    return agree(_rate(HELIX), read_vectors(form, SCALARS, VECTORS, 1)[0], "T(s)")


@claim(
    "(4.2)",
    "T(s) = τ̄V₀ + κ̄(cos βs W₀ + sin βs N₀).",
    method=Method.PROOF,
    form="taub*V0 + kappab*(cos(beta*s)*W0 + sin(beta*s)*N0)",
    wrong=(
        "taub*V0 + kappab*(cos(beta*s)*N0 + sin(beta*s)*W0)",
        "tau*V0 + kappa*(cos(beta*s)*W0 + sin(beta*s)*N0)",
    ),
)
def tangent_in_frame(form: str) -> Evidence:
    """The derivative of lemma 4.2.1, which has frame {T₀, N₀} at 0; unit length; constant angle with V₀."""
    (stated,) = read_vectors(form, SCALARS, VECTORS, 1)
    evidence = agree(_rate(HELIX), stated, "α'(s)") & vanishes(_rational(dot(stated, stated) - 1), "|T|²")
    return evidence & _is_the_helix(HELIX)


@claim(
    "section 4.2-1",
    "The tangent indicatrix of a helix is a circle on the unit sphere with centre τ̄V₀ and radius κ̄.",
    method=Method.PROOF,
    form="taub*V0, kappab",
    wrong=("taub*V0, kappa", "kappab*V0, taub", "-taub*V0, kappab", "taub*V0, -kappab"),
)
def indicatrix(form: str) -> Evidence:
    """|T(s) − centre| is the radius for all s, and T(s) − centre stays perpendicular to V₀."""
    centre_text, radius_text = split(form, 2)
    (centre,) = read_vectors(centre_text, SCALARS, VECTORS, 1)
    arm = subtract(TANGENT, centre)
    size = read(radius_text, SCALARS)
    on_circle = positive(size, "the radius") & vanishes(
        _rational(dot(arm, arm) - size**2), "|T(s) − centre|²"
    )
    return on_circle & vanishes(_rational(dot(arm, V0)), "⟨T(s) − centre, V₀⟩")


@claim(
    "section 4.2-2",
    "The tangent indicatrix is cut from the unit sphere by the plane through T₀ with normal V₀.",
    method=Method.PROOF,
    form="V0",
    printed="N0",
    erratum="The plane through T₀ is called one with direction N₀; its normal is V₀, and containing the "
    "direction N₀ does not determine it.",
    wrong=("W0", "T0", "V0 + N0", "0*V0"),
)
def indicatrix_plane(form: str) -> Evidence:
    """⟨T(s) − T₀, normal⟩ = 0 for all s, for the form's normal."""
    (normal,) = read_vectors(form, SCALARS, VECTORS, 1)
    there = Evidence(any(sp.simplify(part) != 0 for part in normal), (f"the normal is {normal}",))
    return there & vanishes(_rational(dot(subtract(TANGENT, T0), normal)), "⟨T(s) − T₀, normal⟩")


@claim(
    "section 4.2-3",
    "For τ = 0 the indicatrix is the great circle T(s) = cos βs T₀ + sin βs N₀, the helix a plane circle.",
    method=Method.PROOF,
    form="cos(beta*s)*T0 + sin(beta*s)*N0",
    wrong=("cos(beta*s)*T0 - sin(beta*s)*N0", "cos(beta*s)*N0 + sin(beta*s)*T0"),
)
def plane_circle(form: str) -> Evidence:
    """(4.2) with τ̄ = 0, κ̄ = 1."""
    flat = {sp.Symbol("m", positive=True): 1}  # κ̄ = 1, τ̄ = 0
    (stated,) = read_vectors(form, SCALARS, VECTORS, 1)
    found, expected = ([sp.sympify(a).subs(flat) for a in v] for v in (TANGENT, stated))
    return agree(found, expected, "T(s) for τ̄ = 0")


@claim(
    "corollary 4.2.3",
    "The unit tangents at two points of a helix make equal angles with the chord: "
    "⟨α(t) − α(s), T(t) − T(s)⟩ = 0.",
    method=Method.PROOF,
    form="end - start",
    wrong=("end + start", "end - 2*start", "start - start"),
)
def equal_angles(form: str) -> Evidence:
    """⟨α(t) − α(s), T(t)⟩ and ⟨α(t) − α(s), T(s)⟩ for the helix of lemma 4.2.1."""
    a, b = sp.symbols("a b", real=True)  # tangents of βs/2 and βt/2
    t = sp.Symbol("t", real=True)
    rational: dict[Any, Any] = {}
    for u, half in ((s, a), (t, b)):
        rational |= {sp.cos(BETA * u): (1 - half**2) / (1 + half**2)}
        rational |= {sp.sin(BETA * u): 2 * half / (1 + half**2)}
    curve, direction = ([sp.sympify(e).subs(s, t) for e in v] for v in (HELIX, TANGENT))
    chord = subtract(curve, HELIX)
    values = {"end": dot(chord, direction), "start": dot(chord, TANGENT)}
    symbols = {name: sp.Symbol(name) for name in values}
    form_itself = read(form, symbols)
    says = Evidence(sp.expand(form_itself) != 0, (f"a relation of both products: {form_itself} = 0",))
    return says & vanishes(read(form, values).subs(rational), "⟨α(t) − α(s), T(t) − T(s)⟩")
