"""Claims of section 4.3: the fundamental equation, theorem 4.3.2 and algorithm 1.

Symbols as in `osculant.cas.claims.chapter_4.helix_segments`; R stands for √(t₀ − cos φ), so that τ̄± = ±R/(√2
sin(φ/2)).
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.claims.chapter_4.helix_parameter import angle
from osculant.cas.claims.chapter_4.helix_points import HELIX, SCALARS, VECTORS, agree
from osculant.cas.claims.chapter_4.segment_frames import (
    RELATION,
    SPAN,
    T0,
    T1,
    H,
    T1xT0,
    c,
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
from osculant.cas.geometry.short_helices import short_helix
from osculant.cas.numbers.vectors import add, cross, dot

R = sp.Symbol("R", positive=True)
ROOT = (sp.numer(sp.together(R**2 - 2 * (c**2 - k**2))), R)


def _with_sign(expression: Any, sign: int) -> Any:
    return sp.sympify(expression).subs(tau, sign * R / (sp.sqrt(2) * s))


def _solves(quotient: str, function: str) -> Evidence:
    """Whether the function of φ is the quotient of inner products q, g at the solutions of both signs.

    βg is 2D/(1 − cos φ) by (4.9), and D > 0 for arccos t₀ < φ ≤ π (B.1-14): so g > 0, and |g| is g.
    """
    q, g = sp.Symbol("q", real=True), sp.Symbol("g", positive=True)
    stated = half_angles(read(function, {"phi": phi, "t0": t0, "R": R}))
    evidence = Evidence(True)
    for sign in (1, -1):
        aside, ahead = (_with_sign(dot(SPAN, v), sign) for v in (T1xT0, add(T0, T1)))
        right = read(quotient, {"t0": t0, "q": q, "g": g})
        right = right.subs(sp.Abs(q), -sign * q).subs({q: aside, g: ahead})  # (4.8): sign q = −sign τ̄
        evidence &= vanishes(stated - right, f"sign of τ̄ = {sign:+d}", [ROOT])
    return evidence


@claim(
    "(4.10)",
    "The turning φ ≤ π solves H(φ) = −(√2/(1 − t₀)) |⟨p₁ − p₀, T₁×T₀⟩ / ⟨p₁ − p₀, T₁ + T₀⟩|.",
    method=Method.PROOF,
    form="-sqrt(2)/(1 - t0)*abs(q/g)",
    printed="-sqrt(2)/(1 - t0)*q/g",
    erratum="The quotient seems to lack the bars of an absolute value: without them the equation has the "
    "wrong sign whenever τ̄ > 0. (For φ ≤ π bars around the numerator only are the same.)",
    uncertain=True,
    wrong=(
        "sqrt(2)/(1 - t0)*abs(q/g)",
        "-2/(1 - t0)*abs(q)/g",
        "-sqrt(2)/(1 + t0)*abs(q)/g",
        "-sqrt(2)/(1 - t0)*q/abs(g)",
    ),
)
def fundamental_equation(form: str) -> Evidence:
    """(4.7) over (4.9), with τ̄± = ±R/(√2 sin(φ/2)), for both signs; q and g are the inner products."""
    return _solves(form, H)


@claim(
    "(4.11)",
    "H(φ) = (φ cos(φ/2) − 2 sin(φ/2)) R/D(φ), R = √(t₀ − cos φ), D(φ) = φ(t₀ − cos φ) + (1 − t₀) sin φ.",
    method=Method.PROOF,
    form=H,
    wrong=(
        "(phi*cos(phi/2) + 2*sin(phi/2))*R/(phi*(t0 - cos(phi)) + (1 - t0)*sin(phi))",
        "(phi*cos(phi/2) - 2*sin(phi/2))*R**2/(phi*(t0 - cos(phi)) + (1 - t0)*sin(phi))",
        "(phi*cos(phi/2) - 2*sin(phi/2))*R/(phi*(t0 - cos(phi)) + (1 + t0)*sin(phi))",
    ),
)
def fundamental_function(form: str) -> Evidence:
    """The quotient −(√2/(1 − t₀))|q|/g of inner products of S± with T₁×T₀ and T₁ + T₀, for both signs."""
    return _solves("-sqrt(2)/(1 - t0)*abs(q)/g", form)


@claim(
    "(4.12)",
    "H(arccos t₀) = 0 and H(π) = −2/(π√(1 + t₀)).",
    method=Method.PROOF,
    form="0, -2/(pi*sqrt(1 + t0))",
    wrong=("0, 2/(pi*sqrt(1 + t0))", "0, -2/(pi*sqrt(1 - t0))", "1, -2/(pi*sqrt(1 + t0))"),
)
def end_values(form: str) -> Evidence:
    """φ = arccos t₀ and φ = π inserted into (4.11)."""
    more = sp.Symbol("w", positive=True)  # 1 + t₀
    x = sp.Symbol("x", positive=True)
    function = read(H, {"phi": x, "t0": more - 1, "R": sp.sqrt(more - 1 - sp.cos(x))})
    evidence = Evidence(True)
    ends = (sp.acos(more - 1), sp.pi)
    for end, stated, name in zip(
        ends, read_tuple(form, {"t0": more - 1}, 2), ("arccos t₀", "π"), strict=True
    ):
        evidence &= vanishes(function.subs(x, end) - stated, f"H({name})")
    return evidence


@claim(
    "theorem 4.3.2",
    "For T₁ ≠ ±T₀, p₁ ≠ p₀ and ⟨p₁ − p₀, T₁ − T₀⟩ = 0 there is exactly one helix through (p₀, T₀), (p₁, T₁) "
    "that turns by less than 2π about its axis.",
    method=Method.PROOF,
    form="2*pi",
    wrong=("pi", "3*pi", "4*pi"),
)
def unique_short_helix(form: str) -> Evidence:
    """With the parameter χ of R4.3-1 the direction of β(p₁ − p₀) in the plane of E, F is that of (X, −Y).

    Its angle grows strictly from 0 to π while χ grows from 0 to π (R4.3-7), and is mirrored for χ < 0, so it
    takes each value once; β follows from the distance. A bound U ≠ 2π on the turning would be wrong: plane
    arcs with ⟨p₁ − p₀, E⟩ > 0 turn by θ + 2πn, those with < 0 by 2π − θ + 2πn, for every θ in (0, π).
    """
    bound = read(form, {})
    if bound == 2 * sp.pi:
        return angle("0, pi")
    theta = sp.Min(abs(2 * sp.pi - bound), 2 * sp.pi) / 4
    backwards = sum(bool(turning < bound) for turning in (2 * sp.pi - theta, 4 * sp.pi - theta))
    forwards = sum(bool(turning < bound) for turning in (theta, 2 * sp.pi + theta))
    line = f"θ = {theta}: {backwards} plane arcs turn by less with ⟨p₁ − p₀, E⟩ < 0, {forwards} with > 0"
    return Evidence(backwards == forwards == 1, (line,))


@claim(
    "theorem 4.3.2.1",
    "The end points of a helix segment with tangents T₁ ≠ T₀ differ: β²|p₁ − p₀|² is 2(1 − t₀) > 0 and "
    "(τ̄φ)², so 2(1 − t₀) at least.",
    method=Method.PROOF,
    form="2*(1 - t0)",
    printed="0",
    erratum="Theorem 4.3.2 does not exclude p₁ = p₀, where condition (4.3) holds but no segment ends, since "
    "β²|p₁ − p₀|² ≥ 2(1 − t₀) > 0.",
    wrong=("2*(1 + t0)", "1 - t0", "-2*(1 - t0)"),
)
def distinct_ends(form: str) -> Evidence:
    """|βS±|² is (τ̄φ)² and the form, modulo (4.5); the least value is attained by plane arcs, τ̄ = 0."""
    return vanishes(dot(SPAN, SPAN) - (tau * phi) ** 2 - read(form, {"t0": t0}), "|βS±|² − (τ̄φ)²", [RELATION])


#: end points (2u, u, w) for algorithm 1, far from its bound
SPREAD = ((8, 1), (4, -1), (2, 1), (1, -1), (1, 3), (0, 1), (-1, -10), (-1, 1))


@claim(
    "algorithm 4.1.1",
    "Algorithm 1 finds the short helix of total turning at most π only; beyond, its c is out of range.",
    method=Method.NUMERICAL,
    form="pi",
    printed="2*pi",
    erratum="Algorithm 1 reports an error (c out of range) for data whose short helix turns by more than π, "
    "although theorem 4.3.2 grants one.",
    wrong=("pi/2", "3*pi/2", "pi + 1/1000", "pi - 1/1000"),
    reason="finitely many rational data; for all data it follows from (4.12) and the monotonicity of H",
)
def reach_of_the_algorithm(form: str) -> Evidence:
    """T₀ = (1, 0, 0), T₁ = (3/5, 4/5, 0) and end points (2u, u, w): c against its bound.

    The algorithm succeeds iff 0 ≤ c ≤ 2/(π√(1 + t₀)); the turning comes from the solver by χ, whose helix is
    checked at the end point to 30 digits. Two end points have a turning within 10⁻⁶ of π, on either side.
    """
    first, second = (Fraction(1), Fraction(0), Fraction(0)), (Fraction(3, 5), Fraction(4, 5), Fraction(0))
    size = dot(first, second)
    lines, holds = [], True
    with mp.workdps(40):
        bound = mp.mpf(str(sp.N(read(form, {}), 40)))
        turn = 4 / (mp.pi * mp.sqrt("3.2"))  # w/u where c is its bound, at a turning of π
        near = [(10**9, int(10**9 * turn) + step) for step in (-100, 100)]
        for u, w in (*SPREAD, *near):
            p = (Fraction(2 * u), Fraction(u), Fraction(w))
            aside, ahead = abs(dot(p, cross(second, first))), dot(p, add(first, second))
            ratio = aside / (1 - size) / ahead if ahead else Fraction(-1)
            found = 0 <= mp.sqrt(2) * ratio.numerator / ratio.denominator <= 2 / (mp.pi * mp.sqrt(1.6))
            arc = short_helix((0, 0, 0), first, p, second)
            gap = max(abs(x - y) for x, y in zip(arc.helix.at(arc.length), map(mp.mpf, (2 * u, u, w))))
            holds = holds and gap < mp.mpf(10) ** -30 and found == (arc.turning <= bound)
            lines.append(
                f"p₁ = ({2 * u}, {u}, {w}): turning {mp.nstr(arc.turning, 8)}, "
                f"the algorithm {'succeeds' if found else 'reports an error'}"
            )
    return Evidence(holds, tuple(lines))


@claim(
    "algorithm 4.1.2",
    "Its constant is c = (√2/(1 − t₀)) |⟨p₁ − p₀, T₁×T₀⟩| / ⟨p₁ − p₀, T₁ + T₀⟩, with H(φ) = −c.",
    method=Method.PROOF,
    form="sqrt(2)/(1 - t0)*abs(q)/g",
    printed="sqrt(2)/(1 - t0)*q/g",
    erratum="The bars of an absolute value seem to be missing, as in (4.10): without them c is negative "
    "whenever τ̄ > 0.",
    uncertain=True,
    wrong=("2/(1 - t0)*abs(q)/g", "-sqrt(2)/(1 - t0)*abs(q)/g"),
)
def constant_of_the_algorithm(form: str) -> Evidence:
    """(4.7) over (4.9) for both signs of τ̄."""
    return _solves(f"-({form})", H)


@claim(
    "algorithm 4.1.3",
    "Its β is √(2(1 − t₀) + (τ̄φ)²)/|p₁ − p₀|.",
    method=Method.PROOF,
    form="2*(1 - t0) + (taub*phi)**2",
    wrong=("2*(1 - t0) - (taub*phi)**2", "(1 - t0) + (taub*phi)**2", "2*(1 + t0) + (taub*phi)**2"),
)
def rate_of_the_algorithm(form: str) -> Evidence:
    """|βS±|², modulo (4.5)."""
    stated = read(form, {"t0": t0, "taub": tau, "phi": phi})
    return vanishes(dot(SPAN, SPAN) - stated, "|βS±|²", [RELATION])


@claim(
    "algorithm 4.1.4",
    "Its output is α(s) = p₀ + (sin βs/β)T₀ + τ̄(s − sin βs/β)V₀ + ((1 − cos βs)/β)T₀×V₀.",
    method=Method.PROOF,
    form="sin(beta*s)/beta*T0 + taub*(s - sin(beta*s)/beta)*V0 + (1 - cos(beta*s))/beta*T0xV0",
    wrong=(
        "sin(beta*s)/beta*T0 + taub*(s + sin(beta*s)/beta)*V0 + (1 - cos(beta*s))/beta*T0xV0",
        "sin(beta*s)/beta*T0 + taub*(s - sin(beta*s)/beta)*V0 - (1 - cos(beta*s))/beta*T0xV0",
    ),
)
def output_of_the_algorithm(form: str) -> Evidence:
    """Against the helix of lemma 4.2.1."""
    return agree(HELIX, read_vectors(form, SCALARS, VECTORS, 1)[0], "α(s)")
