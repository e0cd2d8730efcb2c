"""Conjecture 3.1.2 proved: one bitangent conic has the least area, and a linear form finds it."""

from __future__ import annotations

from functools import cache, partial
from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath import mp

from osculant.cas.claims.chapter_3.displacement import displacement_by_q
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import AFFINE_SPIRALS, SEXTIC, SPIRAL
from osculant.cas.claims.proof import integer, read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.moons import imbalance, least_area
from osculant.cas.numbers.roots import root_between

#: the member (2t(1−t)m T₀ + t²P₂)/B, B = (1−t)² + 2cm t(1−t) + t², from P₀ = 0 with T₀ = (1, 0), P₂ = (p, h)
M, T, H, C, P = sp.symbols("m t h c p", real=True)
BELOW = (1 - T) ** 2 + 2 * C * M * T * (1 - T) + T**2
MEMBER = ((2 * T * (1 - T) * M + T**2 * P) / BELOW, T**2 * H / BELOW)
DENSITY = "4*h*t^2*(1 - t)^2/B^3"
#: arcs whose stationary members are counted
ARCS = (*AFFINE_SPIRALS, (SEXTIC, "0", "2"), (SPIRAL, "0.5", "2.5"))


@claim(
    "X3.4-6",
    "With wP₁ = m T₀ from P₀ = 0 and w = cm, m > 0, the bitangent conics sweep the plane with the area 4h "
    "t²(1 − t)²/B³ dm dt, h = [T₀, P₂], B = (1 − t)² + 2cm t(1 − t) + t²: of one sign, and the same at t "
    "and 1 − t.",
    method=Method.PROOF,
    form=DENSITY,
    wrong=(
        "4*h*t^2*(1 - t)^2/B^2",
        "2*h*t^2*(1 - t)^2/B^3",
        "-4*h*t^2*(1 - t)^2/B^3",
        "4*h*t^3*(1 - t)/B^3",
    ),
)
def swept_area(form: str) -> Evidence:
    """The Jacobian of the member's point in m and t; B is symmetric under t ↦ 1 − t, whatever the weight."""
    density = read(form, {"h": H, "t": T, "B": BELOW})
    jacobian = sp.diff(MEMBER[0], M) * sp.diff(MEMBER[1], T) - sp.diff(MEMBER[1], M) * sp.diff(MEMBER[0], T)
    symmetric = vanishes(density - density.subs(T, 1 - T), "at t and 1 − t")
    return vanishes(density - jacobian, "swept area") & symmetric


@claim(
    "X3.4-7",
    "The middle points t = 1/2 of all bitangent conics of an arc are on one line through the middle of the "
    "chord and, if the end tangents meet, their intersection P₁: l₀ sin A = l₂ sin B there.",
    method=Method.PROOF,
    form="l0*sin_A - l2*sin_B",
    wrong=("l0*sin_B - l2*sin_A", "l0 - l2", "l0*sin_A + l2*sin_B", "l0*sin_A - 2*l2*sin_B"),
)
def middle_line(form: str) -> Evidence:
    """The form, linear in l₀ and l₂, is put to the middle points, the middle of the chord and P₁.

    With T₂ = (cos ψ, sin ψ) and L the chord, c = sin ψ/(L sin B) by R3.3-2 and R3.3-3, and L sin B = [P₂,
    T₂], L sin A = h, both times L. On P₁ both l₀ and l₂ vanish, so any linear form does.
    """
    cosine, sine, length = sp.symbols("cos_psi sin_psi L", real=True)
    x, y = sp.symbols("x y", real=True)
    l0, l2 = cosine * (y - H) - sine * (x - P), y
    sines = {"sin_A": H / length, "sin_B": (P * sine - H * cosine) / length}
    linear = read(form, {"l0": l0, "l2": l2, **sines})
    free = Evidence(linear.has(x) or linear.has(y), ("the form is not 0 everywhere",))
    middle = [z.subs(T, sp.Rational(1, 2)).subs(C, sine / (P * sine - H * cosine)) for z in MEMBER]
    return (
        free
        & vanishes(linear.subs({x: P / 2, y: H / 2}), "the form in the middle of the chord")
        & vanishes(linear.subs({x: middle[0], y: middle[1]}), "the form at the points t = 1/2")
    )


@claim(
    "conjecture 3.1.2",
    "Exactly one bitangent conic of a strictly convex affine spiral arc has the least area from it: the one "
    "through the arc's only inner point with l₀ sin A = l₂ sin B.",
    method=Method.PROOF,
    given=("R3.2-2",),
    form="1",
    wrong=("0", "2"),
)
def least_area_unique(form: str) -> Evidence:
    """Theorem C: a proof of what the thesis conjectures. The form is the number of stationary members.

    The members m > 0, m² a multiple of Q, lie side by side (R3.3-7), and each meets the arc once inside at
    most (X3.2-15), say at its own parameter t = τ. As m grows one moon grows by the integral of the density
    of X3.4-6 over (0, τ), the other shrinks by that over (τ, 1), or conversely; there are no boundary terms.
    The density is positive and symmetric, so the area falls with the crossing moving on while τ < 1/2 and
    grows while τ > 1/2. Members with τ = 1/2 cross the arc on the line of X3.4-7, which leaves the convex
    hull of the arc, from the middle of the chord, at one point of the arc: there is one such member, and τ <
    1/2 for the crossings before it. Members that do not meet the arc inside are farther out still. The member
    is proper: its middle point is on the arc's side of the chord, so 1 + w > 0.

    X3.4-6, X3.4-7 and R3.3-7 are proved again here. On five arcs the stationary members and the zeros of the
    linear form are counted, and both crossings are the same.
    """
    count = integer(read(form, {}))
    found = swept_area(DENSITY) & middle_line("l0*sin_A - l2*sin_B") & displacement_by_q("4*f0*f2/root")
    counts, lines = _stationary()
    return found & Evidence(counts == {count}, lines)


@cache
def _stationary() -> tuple[set[int], tuple[str, ...]]:
    """The numbers of stationary members and of zeros of the linear form found on arcs, and where they are.

    Raises DomainError if the two crossings are not the same.
    """
    lines, counts = [], set()
    with mp.workdps(15):
        for text, low, high in ARCS:
            pencil = BitangentPencil(ReferenceCurve(text), low, high)
            places = [pencil.a + (pencil.b - pencil.a) * i / 12 for i in range(1, 12)]
            for of in (imbalance, _balance):
                values = [of(pencil, t) for t in places]
                counts.add(sum(one * two < 0 for one, two in pairwise(values)))
            linear = root_between(partial(_balance, pencil), places[0], places[-1])
            searched = least_area(pencil)
            if abs(linear - searched) > mp.mpf("1e-10"):
                raise DomainError(f"The crossings {linear} and {searched} on {text} differ.")
            lines.append(f"{text} on [{low}, {high}]: both vanish at σ = {mp.nstr(searched, 10)} only")
    return counts, tuple(lines)


def _balance(pencil: BitangentPencil, t: Any) -> Any:
    """l₀ sin A − l₂ sin B at α(t), positive at the start of the arc and negative at its end."""
    l0, _, l2 = pencil.lines(pencil.frame(t).point)
    return pencil.side * (l0 * pencil.sin_a - l2 * pencil.sin_b)
