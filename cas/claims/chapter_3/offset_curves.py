"""Section 3.5, Lemma 3.5.1: the affine curvature of a curve beside another, with the steps of its proof.

α has generic k, P and Q are generic functions, and every small quantity has weight 1.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp
from flint import Ordering, fmpq_mpoly_ctx

from osculant.cas.asymptotics.offset_curves import Pair, bracket
from osculant.cas.claims.chapter_3.offsets import AT_ZERO, CROSSING, TANGENT, to_order
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, order, read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.jets.canonical import affine_arc, series_of_derivatives
from osculant.cas.numbers.power_series import PowerSeries, power


@claim(
    "(3.3)",
    "If β and β_u agree with α and α_u at u = 0 and u = ρ, then β = α + d·(Pt + Qn) with d = u²(u − ρ)².",
    method=Method.PROOF,
    form="u**2*(u - rho)**2",
    wrong=("u*(u - rho)**2", "u**3*(u - rho)**2", "u**2*(u + rho)**2"),
)
def tangent_offset(form: str) -> Evidence:
    """The division property takes out the zeros of [β − α, n] and [t, β − α]: two at each end, no others.

    So d is the monic polynomial in u of least degree with those zeros, found by its linear conditions.
    """
    u, rho = sp.symbols("u rho", real=True)
    return vanishes(read(form, {"u": u, "rho": rho}) - _least(u, {sp.Integer(0): 2, rho: 2}), "d")


@claim(
    "(3.5)",
    "If β also meets α at u = σ, then β = α + d·(Pt + Qn) with d = u²(u − ρ)²(u − σ).",
    method=Method.PROOF,
    form="u**2*(u - rho)**2*(u - sigma)",
    wrong=("u**2*(u - rho)*(u - sigma)**2", "u**2*(u - rho)**2*(u - sigma)**2", "u**2*(u - rho)**2"),
)
def crossing_offset(form: str) -> Evidence:
    """As for (3.3), with one simple zero more."""
    u, rho, sigma = sp.symbols("u rho sigma", real=True)
    stated = read(form, {"u": u, "rho": rho, "sigma": sigma})
    return vanishes(stated - _least(u, {sp.Integer(0): 2, rho: 2, sigma: 1}), "d")


def _least(u: Any, zeros: dict[Any, int]) -> Any:
    """The monic polynomial with these zeros, from the linear equations for its coefficients."""
    degree = sum(zeros.values())
    c = sp.symbols(f"c:{degree}")
    d = u**degree + sum(c[i] * u**i for i in range(degree))
    equations = [sp.diff(d, u, i).subs(u, zero) for zero, m in zeros.items() for i in range(m)]
    (solution,) = sp.linsolve(equations, c)
    return d.subs(dict(zip(c, solution, strict=True)))


@claim(
    "lemma 3.5.1-1",
    "The zeros in the proof of (3.3) are double if β has the derivative of α there, not only its tangent.",
    method=Method.PROOF,
    form="equal derivatives",
    printed="parallel derivatives",
    erratum="If β is only tangent to α at the ends, [β − α, n] has simple zeros: β_u = α_u is needed there.",
    wrong=("any derivatives",),
)
def double_zeros(form: str) -> Evidence:
    """At an end β − α = 0, so the derivatives of [β − α, t], [β − α, n] are those brackets of β_u − t.

    With β_u = λt + μn these are −μ and λ − 1; "equal" puts λ = 1 and μ = 0, "parallel" only μ = 0.
    """
    stretch, turn = sp.symbols("lambda mu", real=True)
    conditions = {
        "equal derivatives": {stretch: 1, turn: 0},
        "parallel derivatives": {turn: 0},
        "any derivatives": {},
    }
    if form not in conditions:
        raise DomainError(f"The condition at the ends is one of {', '.join(conditions)}, not {form!r}.")
    difference = sp.Matrix([stretch - 1, turn]).subs(conditions[form])
    t, n = sp.Matrix([1, 0]), sp.Matrix([0, 1])
    rates = [sp.Matrix.hstack(difference, w).det() for w in (t, n)]
    return all_of(vanishes(r, f"derivative of [β − α, {w}]") for r, w in zip(rates, "tn", strict=True))


@claim(
    "lemma 3.5.1-2",
    "In its proof [β − α, n] = dP and [β − α, t] = −dQ, where β − α = d(Pt + Qn).",
    method=Method.PROOF,
    form="d*P, -d*Q",
    printed="d*P, d*Q",
    erratum="[β − α, t] = −dQ, since [n, t] = −1: the proof prints dQ.",
    wrong=("-d*P, -d*Q", "d*Q, -d*P"),
)
def brackets_of_the_offset(form: str) -> Evidence:
    """Both brackets of the generic offset curve, as series, against the series of d, P and Q."""
    curve = TANGENT
    t, n = curve.frame
    away = (curve.beta[0] - curve.arc[0], curve.beta[1] - curve.arc[1])
    s = curve.symbols
    linear = {f: s[f"{f}0"] + sum(s[f"{f}{p}"] * s[p] for p in curve.places) for f in "PQ"}
    stated = read_tuple(form, linear | {"d": curve.expression(curve.contact)}, 2)
    first = to_order(curve, bracket(away, n), stated[0], curve.length, "[β − α, n]")
    return first & to_order(curve, bracket(away, t), stated[1], curve.length, "[β − α, t]")


@claim(
    "lemma 3.5.1.1",
    "An offset curve tangent at both ends has kβ(u, ρ) = k(0) + 8Q(0, 0) + O(ρ), 0 ≤ u ≤ ρ.",
    method=Method.PROOF,
    form="k0 + 8*Q0, 1",
    wrong=("k0 + 4*Q0, 1", "k0 - 8*Q0, 1", "k0 + 16*Q0, 1", "k0 + 8*Q0, 2"),
)
def tangent_curvature(form: str) -> Evidence:
    """kβ of β = α + u²(u − ρ)²(Pt + Qn) by (2.12), as a series; P drops out.

    The form ends with the order of the remainder.
    """
    stated, last = read_tuple(form, TANGENT.symbols, 2)
    return to_order(TANGENT, TANGENT.affine_curvature, stated, order(last), "kβ")


@claim(
    "(3.4)",
    "kβ = k(0) + 8Q(0, 0) + O(ρ), by the proof's way: ρ = 0, where all four contacts fall together.",
    method=Method.PROOF,
    form="k0 + 8*Q0, 1",
    wrong=("k0 + 4*Q0, 1", "k0 + 12*Q0, 1", "k0 + 8*P0, 1"),
)
def curvature_at_zero(form: str) -> Evidence:
    """kβ of β = α + u⁴(Pt + Qn) by (2.12), at u = 0: the orders 0 to 4 of β determine it."""
    stated, last = read_tuple(form, AT_ZERO.symbols, 2)
    return to_order(AT_ZERO, AT_ZERO.affine_curvature, stated, order(last), "kβ")


@claim(
    "lemma 3.5.1.2",
    "An offset curve that also crosses at u = σ has kβ = k(0) + k′(0)u + 8(5u − σ − 2ρ)Q(0, 0, 0) + O(ρ²).",
    method=Method.PROOF,
    form="k0 + k1*u + 8*(5*u - sigma - 2*rho)*Q0, 2",
    wrong=(
        "k0 + k1*u + 8*(5*u + sigma + 2*rho)*Q0, 2",
        "k0 + k1*u + 8*(5*u - 2*sigma - rho)*Q0, 2",
        "k0 + k1*u + 4*(5*u - sigma - 2*rho)*Q0, 2",
        "k0 + k1*u + 8*(5*u - sigma - 2*rho)*Q0, 3",
    ),
)
def crossing_curvature(form: str) -> Evidence:
    """kβ of β = α + u²(u − ρ)²(u − σ)(Pt + Qn) by (2.12), as a series; P drops out."""
    stated, last = read_tuple(form, CROSSING.symbols, 2)
    return to_order(CROSSING, CROSSING.affine_curvature, stated, order(last), "kβ")


@claim(
    "(3.6)",
    "kβ = [β_uu, β_uuu]/φ⁵ + (φ_uu φ − 3φ_u²)/φ⁴ with φ = [β_u, β_uu]^(1/3), along β(·, ρ).",
    method=Method.PROOF,
    form="b23/phi**5 + (phi_uu*phi - 3*phi_u**2)/phi**4",
    wrong=(
        "b23/phi**5 + (phi_uu*phi + 3*phi_u**2)/phi**4",
        "b23/phi**5 - phi_uu/phi**3",
        "b23/phi**4 + (phi_uu*phi - 3*phi_u**2)/phi**4",
    ),
)
def offset_curvature(form: str) -> Evidence:
    """β is α with a generic parameter, β(u) = α(h(u)): then its affine curvature at u is k at h(u).

    As series in u with generic k, k′, … and generic coefficients of h(u) = u + h₂u² + h₃u³ + …
    """
    length = 8
    names = [f"{name}{i}" for name in "kh" for i in range(length)]
    generators = fmpq_mpoly_ctx.get(names, Ordering.degrevlex).gens()
    k, h = generators[:length], generators[length:]
    along, across, _ = affine_arc(length - 1, k)
    inner = PowerSeries([h[0] * 0, h[0] * 0 + 1, *h[2:]])
    beta = (along.at(inner), across.at(inner))
    first, second, third = (_derivative(beta, i) for i in (1, 2, 3))
    phi = power(bracket(first, second), Fraction(1, 3))
    slope = phi.derivative()
    values = {"b23": bracket(second, third), "phi": phi, "phi_u": slope, "phi_uu": slope.derivative()}
    symbols = [sp.Symbol(name, real=True) for name in values]
    formula = read(form, dict(zip(values, symbols, strict=True)))
    if any(not number.is_Integer for number in formula.atoms(sp.Number)):
        raise DomainError(f"The form {form!r} is put into series: write it without fractions.")
    stated = sp.lambdify(symbols, formula)(*values.values())
    difference = stated - series_of_derivatives(k).at(inner)
    left = [n for n, c in enumerate(difference.coefficients) if c != 0]
    line = f"kβ(u) − k(h(u)) vanishes up to order {difference.length - 1}" + (
        f" except at the orders {left}" if left else ""
    )
    return Evidence(not left, (line,))


def _derivative(curve: Pair, order: int) -> Pair:
    for _ in range(order):
        curve = (curve[0].derivative(), curve[1].derivative())
    return curve
