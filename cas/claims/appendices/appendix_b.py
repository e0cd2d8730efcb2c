"""Claims of appendix B.1: H of (4.11) decreases on [arccos t₀, π]."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.appendices.turnings import K0, K1, negative, of_turning, phi
from osculant.cas.claims.chapter_4.segment_frames import H
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.numbers.signs import sign_between

t0 = sp.Symbol("t0", real=True)
k, s = sp.symbols("k s", real=True)  # cos(φ/2), sin(φ/2)
R = sp.Symbol("R", positive=True)  # √(t₀ − cos φ)
ROOT = (R**2 - t0 + 2 * k**2 - 1, t0)  # R² = t₀ − cos φ, solved for t₀
CIRCLE = (s**2 + k**2 - 1, s)

BELOW = "phi*(t0 - cos(phi)) + (1 - t0)*sin(phi)"


def _halved(expression: Any) -> Any:
    """In k = cos(φ/2), s = sin(φ/2)."""
    values = {sp.cos(phi): k**2 - s**2, sp.sin(phi): 2 * k * s, sp.cos(phi / 2): k, sp.sin(phi / 2): s}
    values[sp.cos(2 * phi)] = 2 * (k**2 - s**2) ** 2 - 1
    return sp.sympify(expression).subs(values)


def _slope_of_H() -> Any:
    """H'(φ) by the quotient rule, R' = sin φ/(2R)."""
    function = read(H, {"phi": phi, "t0": t0, "R": R})
    return sp.diff(function, phi) + sp.diff(function, R) * sp.sin(phi) / (2 * R)


@claim(
    "section B.1-1",
    "H'(φ) = (1 + t₀) sin(φ/2)(t₀K₀ + K₁)/(2 D² R), R = √(t₀ − cos φ), for the K₀, K₁ printed.",
    method=Method.PROOF,
    form="(1 + t0)*sin(phi/2)*(t0*K0 + K1)/(2*D**2*R)",
    wrong=(
        "(1 + t0)*sin(phi/2)*(t0*K0 + K1)/(D**2*R)",
        "(1 - t0)*sin(phi/2)*(t0*K0 + K1)/(2*D**2*R)",
        "(1 + t0)*sin(phi/2)*(K0 + t0*K1)/(2*D**2*R)",
    ),
)
def slope(form: str) -> Evidence:
    """(4.11) differentiated; compared modulo R² = t₀ − cos φ and sin² + cos² = 1 of φ/2."""
    values = {"K0": of_turning(K0), "K1": of_turning(K1), "D": read(BELOW, {"phi": phi, "t0": t0})}
    stated = read(form, {**values, "phi": phi, "t0": t0, "R": R})
    return vanishes(_halved(_slope_of_H()) - _halved(stated), "H'", [ROOT, CIRCLE])


@claim(
    "section B.1-2",
    "K₀ = 4 − φ² − 4 cos φ − φ sin φ and K₁ = −1 + cos 2φ + φ sin φ + φ² cos φ.",
    method=Method.PROOF,
    form=f"{K0}, {K1}",
    wrong=(
        f"4 - phi**2 - 4*cos(phi) + phi*sin(phi), {K1}",
        f"{K0}, 1 - cos(2*phi) + phi*sin(phi) + phi**2*cos(phi)",
    ),
)
def brackets(form: str) -> Evidence:
    """2D²R H'/((1 + t₀) sin(φ/2)) from (4.11) is t₀ times the first plus the second."""
    first, second = read_tuple(form, {"phi": phi}, 2)
    below = read(BELOW, {"phi": phi, "t0": t0})
    derived = 2 * below**2 * R * _slope_of_H() / ((1 + t0) * sp.sin(phi / 2))
    return vanishes(_halved(derived - t0 * first - second), "t₀K₀ + K₁", [ROOT, CIRCLE])


@claim(
    "section B.1-12",
    "K₀ < 0 and K₁ < 0 alone imply t₀K₀ + K₁ < 0 for t₀ ≥ 0 only.",
    method=Method.EXACT,
    form="0",
    printed="-1",
    erratum="The proof concludes t₀K₀ + K₁ < 0 for all t₀ in (−1, 1) from the signs of K₀ and K₁, which only "
    "suffice for t₀ ≥ 0: see B.1-13 for a repair.",
    wrong=("-1/2", "1/10"),
)
def reach_of_the_argument(form: str) -> Evidence:
    """The form is the least t₀ from which negative K₀, K₁ always give a negative sum.

    At the form, and beyond it, −t₀a − b must be negative for all a, b > 0; and just below it there must be a
    pair K₀, K₁ < 0 with a sum that is not: K₀ = 2/t₀, K₁ = −1, if that is such a pair.
    """
    least = read(form, {})
    if not least.is_real:
        raise DomainError(f"A real number is expected, not {form!r}.")
    a, b, step = sp.symbols("a b delta", positive=True)
    enough = all((-t * a - b).is_negative for t in (least, least + step))
    below = least / 2 if least > 0 else least - step
    pair = 2 / below, sp.Integer(-1)
    total = sp.cancel(below * pair[0] + pair[1])
    sharp = all(part.is_negative for part in pair) and total.is_positive
    lines = (
        f"t₀ = {least} and t₀ = {least + step}: −t₀a − b is {'' if enough else 'not '}negative for all "
        "a, b, delta > 0",
        f"t₀ = {below}, K₀ = {pair[0]}, K₁ = {pair[1]}: t₀K₀ + K₁ = {total}"
        + ("" if sharp else f", but K₀ < 0 is wanted and fails: {least} is not the least value"),
    )
    return Evidence(bool(enough and sharp), lines)


@claim(
    "section B.1-13",
    "t₀K₀ + K₁ is affine in t₀, and negative at both ends of cos φ ≤ t₀ ≤ 1: it is "
    "(1 − cos φ)(φ sin φ − 2(1 − cos φ)) and (1 − cos φ)(2(1 − cos φ) − φ²) there; "
    "so the claim holds for all t₀ in (−1, 1).",
    method=Method.PROOF,
    form="(1 - cos(phi))*(phi*sin(phi) - 2*(1 - cos(phi))), (1 - cos(phi))*(2*(1 - cos(phi)) - phi**2)",
    wrong=(
        "(1 - cos(phi))*(phi*sin(phi) + 2*(1 - cos(phi))), (1 - cos(phi))*(2*(1 - cos(phi)) - phi**2)",
        "(1 - cos(phi))*(phi*sin(phi) - 2*(1 - cos(phi))), (1 - cos(phi))*((1 - cos(phi)) - phi**2)",
    ),
)
def repair(form: str) -> Evidence:
    """K₀ and K₁ inserted; signs of the second factors in balls, even on (0, 2π)."""
    affine = t0 * of_turning(K0) + of_turning(K1)
    evidence = Evidence(True)
    for end, stated, name in zip(
        (sp.cos(phi), sp.S.One), read_tuple(form, {"phi": phi}, 2), ("cos φ", "1"), strict=True
    ):
        evidence &= vanishes(_halved(affine.subs(t0, end) - stated), f"t₀ = {name}", [CIRCLE])
        factor = sp.cancel(stated / (1 - sp.cos(phi)))
        evidence &= negative(factor, 0, 2 * sp.pi, f"the factor at t₀ = {name}")
    return evidence


@claim(
    "section B.1-14",
    "H decreases strictly on [arccos t₀, π], for every t₀ in (−1, 1).",
    method=Method.PROOF,
    form="-1",
    wrong=("1", "0"),
)
def decreasing(form: str) -> Evidence:
    """The sign of H' is that of t₀K₀ + K₁ (B.1-1), found as in B.1-13 on (0, π).

    D is affine in t₀ too and positive at both ends, so H has no pole; at π itself H is continuous.
    """
    affine = t0 * of_turning(K0) + of_turning(K1)
    linear = vanishes(sp.diff(affine, t0, 2), "second derivative by t₀")
    signs = [
        sign_between(sp.expand(affine.subs(t0, end)), phi, sp.S.Zero, sp.pi)
        for end in (sp.cos(phi), sp.S.One)
    ]
    stated = read(form, {})
    same_sign = Evidence(signs == [stated, stated], (f"signs of t₀K₀ + K₁ at t₀ = cos φ and at 1: {signs}",))
    below = read(BELOW, {"phi": phi, "t0": t0})
    ends = [
        sign_between(sp.expand(below.subs(t0, end)), phi, sp.S.Zero, sp.pi) for end in (sp.cos(phi), sp.S.One)
    ]
    return linear & same_sign & Evidence(ends == [1, 1], (f"signs of D at t₀ = cos φ and at 1: {ends}",))
