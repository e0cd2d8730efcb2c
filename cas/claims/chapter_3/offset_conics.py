"""Section 3.5, Corollary 3.5.2 and its remarks: what the offset lemma says of bitangent conics."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.arc_displacement import KAPPA, displacement
from osculant.cas.asymptotics.offset_curves import OffsetCurve
from osculant.cas.claims.chapter_2.plane_frames import W, euclidean_frame, frenet_derivative, kappas
from osculant.cas.claims.chapter_3.offsets import AT_ZERO, CROSSING, TANGENT, curvature_of_alpha
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import all_of, integers, read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.jets.derivations.plane import bracket


def least_q(curve: OffsetCurve, order: int, condition: Any) -> Any:
    """Q₀ from a linear condition on the order-th part of kβ, an expression that should be 0."""
    part = curve.expression(curve.affine_curvature[order])
    (solution,) = sp.solve(condition(part), curve.symbols["Q0"])
    return solution


def parabola_q() -> Any:
    """Q(0, 0) of a parabola: kβ = 0."""
    return least_q(TANGENT, 0, lambda part: part)


def conic_q() -> Any:
    """Q(0, 0, 0) of a conic: kβ does not depend on u."""
    return least_q(CROSSING, 1, lambda part: sp.diff(part, CROSSING.symbols["u"]))


def curvature_slopes() -> tuple[Any, Any]:
    """k and dk/dr over κ = w³ and its derivatives, by Frenet: k = [n, dn/dr] and dr = w ds."""
    _, n = euclidean_frame()
    rate = frenet_derivative(n)
    k = bracket(n, (rate[0] / W[0], rate[1] / W[0]))
    return k, sum(sp.diff(k, a) * b for a, b in pairwise(W)) / W[0]


def _normal_part(q: Any) -> Any:
    """D = [T, Pt + Qn] = Q[T, n]: the part along N of an offset Pt + Qn that is along N."""
    _, n = euclidean_frame()
    return q * bracket((sp.Integer(1), sp.Integer(0)), n)


def _displaced(primitive: str, order: int, shape: Any, D: Any) -> Evidence:
    """D against the displacement series of the bitangent conic itself, for κ = 1 and arcs of length h.

    With u = (1 + x)ρ/2, ρ = h + O(h²), the displacement is hᵖ·shape(x)·D(0) + O(hᵖ⁺¹).
    """
    x = sp.Symbol("x", real=True)
    column = [W[0] ** 3]
    while len(column) < 4:
        column.append(sum(sp.diff(column[-1], a) * b for a, b in pairwise(W)))
    unit = {W[0]: 1}
    series = sum(c.as_expr() * x**i for i, c in enumerate(displacement(primitive)[order]))
    series = series.subs(dict(zip(KAPPA, column)), simultaneous=True).subs(unit)
    what = f"leading displacement of the bitangent {primitive}, from its contact conditions"
    return vanishes(series - shape(x) * D.subs(unit), what)


@claim(
    "(3.10)",
    "β = α + u²(ρ − u)²·D·N for a parabola, with D = Q[T, n] = κ^(1/3)Q.",
    method=Method.PROOF,
    form="u**2*(rho - u)**2, kappa**(1/3)*Q",
    wrong=(
        "u**2*(rho - u)**2, kappa**(-1/3)*Q",
        "u**2*(rho - u)**2, kappa*Q",
        "u*(rho - u)**2, kappa**(1/3)*Q",
    ),
)
def parabola_offset(form: str) -> Evidence:
    """d is that of (3.3); along the normal only Q counts, [T, t] = 0, and [T, n] comes from Lemma 2.2.1."""
    Q = sp.Symbol("Q", real=True)
    d, D = read_tuple(form, TANGENT.symbols | kappas() | {"Q": Q}, 2)
    contact = TANGENT.expression(TANGENT.contact)
    return vanishes(d - contact, "d") & vanishes(D - _normal_part(Q), "D")


@claim(
    "(3.11)",
    "β = α + u²(ρ − u)²(u − σ)·D·N for a conic that also meets the curve at u = σ, with D = κ^(1/3)Q.",
    method=Method.PROOF,
    form="u**2*(rho - u)**2*(u - sigma), kappa**(1/3)*Q",
    wrong=(
        "u**2*(rho - u)**2*(sigma - u), kappa**(1/3)*Q",
        "u**2*(rho - u)*(u - sigma)**2, kappa**(1/3)*Q",
        "u**2*(rho - u)**2*(u - sigma), kappa**(2/3)*Q",
    ),
)
def conic_offset(form: str) -> Evidence:
    """As (3.10), with the d of (3.5)."""
    Q = sp.Symbol("Q", real=True)
    d, D = read_tuple(form, CROSSING.symbols | kappas() | {"Q": Q}, 2)
    contact = CROSSING.expression(CROSSING.contact)
    return vanishes(d - contact, "d") & vanishes(D - _normal_part(Q), "D")


@claim(
    "corollary 3.5.2.1",
    "The bitangent parabola has D(0, 0) = −k κ^(1/3)/8.",
    method=Method.PROOF,
    form="-k*kappa**(1/3)/8",
    wrong=("k*kappa**(1/3)/8", "-k*kappa**(1/3)/4", "-k*kappa**(2/3)/8", "-k/8"),
)
def parabola_displacement(form: str) -> Evidence:
    """A parabola has kβ = 0, so Lemma 3.5.1 gives Q(0, 0), and D = κ^(1/3)Q.

    Independently: the displacement of the parabola tangent at both ends of an arc, from its equation as a
    series in the length.
    """
    k, _ = curvature_slopes()
    generic = sp.Symbol("k0", real=True)
    stated = read(form, kappas() | {"k": generic})
    derived = _normal_part(parabola_q())
    D = read(form, kappas() | {"k": k})
    return vanishes(stated - derived, "D(0, 0)") & _displaced(
        "parabola", 4, lambda x: (1 + x) ** 2 * (1 - x) ** 2 / 16, D
    )


@claim(
    "corollary 3.5.2.2",
    "The bitangent conic through α(σ) has D(0, 0, 0) = −k′ κ^(1/3)/40, where k′ = dk/dr (kr; ks is dk/ds).",
    method=Method.PROOF,
    form="-kr*kappa**(1/3)/40",
    wrong=("kr*kappa**(1/3)/40", "-kr*kappa**(1/3)/20", "-ks*kappa**(1/3)/40", "-kr*kappa**(1/3)/8"),
)
def conic_displacement(form: str) -> Evidence:
    """kβ of a conic is constant, so in Lemma 3.5.1 the coefficient of u vanishes: that gives Q(0, 0, 0).

    Independently: the displacement of the best bitangent conic, which crosses in the middle (σ = ρ/2 + …),
    from its equation as a series in the length.
    """
    _, slope = curvature_slopes()
    generic = sp.Symbol("k1", real=True)
    stated = read(form, kappas() | {"kr": generic, "ks": generic * W[0]})
    derived = _normal_part(conic_q())
    D = read(form, kappas() | {"kr": slope, "ks": slope * W[0]})
    return vanishes(stated - derived, "D(0, 0, 0)") & _displaced(
        "conic", 5, lambda x: (1 + x) ** 2 * (1 - x) ** 2 * x / 32, D
    )


def _conic_curvature() -> Any:
    """kβ of the conic to first order, as an expression in ρ and σ."""
    parts = [CROSSING.expression(CROSSING.affine_curvature[n]) for n in range(2)]
    return sp.expand(sum(parts).subs(CROSSING.symbols["Q0"], conic_q()))


@claim(
    "corollary 3.5.2.3",
    "The affine curvature of that conic is kβ = (2k(0) + k(σ) + 2k(ρ))/5 + O(ρ²).",
    method=Method.PROOF,
    form="(2*k_0 + k_sigma + 2*k_rho)/5",
    wrong=("(k_0 + k_sigma + k_rho)/3", "(k_0 + 2*k_sigma + 2*k_rho)/5", "(k_0 + k_rho)/2"),
)
def mean_of_curvatures(form: str) -> Evidence:
    """kβ of Lemma 3.5.1 with Q(0, 0, 0) = −k′/40 put in, against the mean of k(0), k(σ), k(ρ) as series."""
    s = CROSSING.symbols
    places = {"k_0": sp.Integer(0), "k_sigma": s["sigma"], "k_rho": s["rho"]}
    stated = read(form, {name: curvature_of_alpha(CROSSING, place) for name, place in places.items()})
    derived = _conic_curvature()
    return all_of(
        vanishes(CROSSING.order(stated, n) - CROSSING.order(derived, n), f"kβ, order {n}") for n in range(2)
    )


@claim(
    "corollary 3.5.2-1",
    "In its proof kβ = k(0) + (σ + 2ρ)k′(0)/5 + O(ρ²) follows from the second part of Lemma 3.5.1.",
    method=Method.PROOF,
    form="lemma 3.5.1.2",
    printed="(3.4)",
    erratum="The proof cites (3.4), which knows kβ to O(ρ) only and for another curve: it needs the formula "
    "of the lemma's second part.",
    wrong=("lemma 3.5.1.1",),
)
def cited_formula(form: str) -> Evidence:
    """The formula cited, with the Q(0, 0, 0) that makes kβ constant, must be known to the orders 0 and 1."""
    formulas = {"lemma 3.5.1.1": (TANGENT, 0), "(3.4)": (AT_ZERO, 0), "lemma 3.5.1.2": (CROSSING, 1)}
    if form not in formulas:
        raise DomainError(f"The formulas for kβ are {', '.join(formulas)}, not {form!r}.")
    curve, last = formulas[form]
    s = CROSSING.symbols
    wanted = s["k0"] + (s["sigma"] + 2 * s["rho"]) * s["k1"] / 5
    known = sum(curve.expression(curve.affine_curvature[n]) for n in range(last + 1))
    return vanishes(sp.expand(known.subs(s["Q0"], conic_q())) - wanted, f"kβ by {form}")


#: the example's α is of class C^m for these m
CLASSES = (5, 8, 11)


@claim(
    "remark 3.5.3.2",
    "D is of class C^(m−4) for a bitangent parabola and C^(m−5) for a bitangent conic if α is of class C^m.",
    method=Method.EXACT,
    form="4, 5",
    wrong=("3, 4", "5, 6", "4, 4"),
    open=True,
)
def loss_of_differentiability(form: str) -> Evidence:
    """A conjecture. For y = x²/2 + xᵐ|x|, which is C^m and not C^(m+1), the loss is exactly 4 and 5.

    To leading order D is the divided difference of f = xᵐ|x| at 0, 0, ρ, ρ, u (and σ = ρ/2): homogeneous of
    degree m + 1 minus the number of zeros of d, and rational on each side of the lines u = 0 and ρ = 0. Where
    pieces meet on a line they differ by a function with a zero of finite order on it; at the origin a
    homogeneous function of degree g that is no polynomial is C^(g−1) and no better.
    """
    stated = integers(form, 2)
    u, rho = sp.symbols("u rho", real=True)
    found = []
    for loss, zeros in zip(stated, ((0, 0, rho, rho), (0, 0, rho, rho, rho / 2)), strict=True):
        d = sp.prod(u - z for z in zeros)
        for m in CLASSES:
            # jumps of (f(u) − H(u))/d, H the interpolant, where the sign of f changes with u and with ρ
            interpolant = sp.rem(u ** (m + 1), d, u)
            across_u = _valuation(u ** (m + 1) / d, u)
            across_rho = _valuation(interpolant / d, rho)
            smooth = min(across_u - 1, across_rho - 1, m + 1 - len(zeros) - 1)
            line = f"m = {m}, {len(zeros)} zeros of d: D is C^{smooth}, a loss of {m - smooth}"
            found.append(Evidence(smooth == m - loss, (line,)))
    return all_of(found)


def _valuation(quotient: Any, place: Any) -> int:
    """The order of the zero at place = 0 of a rational function."""
    numerator, denominator = sp.fraction(sp.cancel(quotient))

    def least(polynomial: Any) -> int:
        return int(min(power for (power,) in sp.Poly(polynomial, place).monoms()))

    return least(numerator) - least(denominator)
