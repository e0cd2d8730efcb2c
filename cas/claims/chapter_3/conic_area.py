"""Section 3.6.2: the symmetric difference distance of short arcs, and splines by it."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_3.areas import Q, area_at, areas, c, chord_area, k, k1, moons, rho, u, x
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.laws.conics import canonical_coefficients


@claim(
    "(3.20)",
    "The area between a convex arc and its chord from α(σ) to α(τ) is ½∫[α(u) − α(σ), α′(u)] du.",
    method=Method.PROOF,
    form="1/2",
    wrong=("1", "1/3"),
)
def area_formula(form: str) -> Evidence:
    """For a graph with a generic polynomial of degree 7 against ∫(chord − curve) between generic ends.

    Both sides are linear in the graph, so the identity of their Taylor coefficients is what is checked.
    """
    coefficients = sp.symbols("a0:8")
    low, high = sp.symbols("low high")
    graph = sum(q * u**i for i, q in enumerate(coefficients))
    slope = sp.cancel((graph.subs(u, high) - graph.subs(u, low)) / (high - low))
    between = sp.integrate(sp.expand(graph.subs(u, low) + slope * (u - low) - graph), (u, low, high))
    return vanishes(2 * read(form, {}) * chord_area(u, graph, u, low, high) - between, "area above the chord")


@claim(
    "(3.21)",
    "δ = |A_β − A_γ| with A_γ = ρ³/12 − kρ⁵/240 and A_β = ρ³/12 + (−k − 8Q)ρ⁵/240, to O(ρ⁶), "
    "β = γ + u²(ρ − u)²(Pt + Qn).",
    method=Method.PROOF,
    form="rho^3/12 - k*rho^5/240, rho^3/12 + (-k - 8*Q)*rho^5/240",
    wrong=(
        "rho^3/12 + k*rho^5/240, rho^3/12 + (-k - 8*Q)*rho^5/240",
        "rho^3/12 - k*rho^5/240, rho^3/12 + 8*Q*rho^5",
    ),
)
def area_displays(form: str) -> Evidence:
    """(3.20) for the series of γ in its affine frame, and for β with the offset added; P drops out."""
    claimed = read_tuple(form, {"rho": rho, "k": k, "Q": Q}, 2)
    gamma, beta = areas()
    return vanishes(claimed[0] - gamma, "A_γ") & vanishes(claimed[1] - beta, "A_β")


@claim(
    "(3.22)",
    "δ = |Q(0,0)|ρ⁵/30 + O(ρ⁶).",
    method=Method.PROOF,
    form="Q*rho^5/30",
    wrong=("Q*rho^5/15", "Q*rho^4/30"),
)
def offset_area(form: str) -> Evidence:
    """The difference of the two areas, and the same from ∫u²(ρ − u)² du."""
    gamma, beta = areas()
    claimed = read(form, {"rho": rho, "Q": Q})
    direct = sp.integrate(sp.expand(u**2 * (rho - u) ** 2), (u, 0, rho)) * Q
    return vanishes(gamma - beta - claimed, "A_γ − A_β") & vanishes(direct - claimed, "∫ of the offset")


@claim(
    "theorem 3.6.4.1",
    "A bitangent parabola of an arc of affine length ρ has the symmetric difference |k|ρ⁵/240 + O(ρ⁶).",
    method=Method.PROOF,
    form="k*rho^5/240",
    wrong=("k*rho^5/120", "k*rho^4/240"),
)
def parabola_area(form: str) -> Evidence:
    """(3.22) with |Q| the factor of k in the canonical form, since a parabola has none."""
    gamma, beta = areas()
    lost = sp.Rational(canonical_coefficients()[0]) * k
    return vanishes((gamma - beta).subs(Q, lost) - read(form, {"rho": rho, "k": k}), "area of a parabola")


@claim(
    "(3.23)",
    "A conic that crosses at γ(σ) leaves two moons, δ = |A_β(0,σ) − A_γ(0,σ)| + |A_γ(σ,ρ) − "
    "A_β(σ,ρ)|: the areas "
    "add, they do not cancel.",
    method=Method.PROOF,
    form="sum",
    wrong=("difference", "whole chord"),
)
def two_moons(form: str) -> Evidence:
    """Against ∫|u²(1 − u)²(u − c)| du for c = 1/3, exactly; the whole chord gives only the difference."""
    crossing = sp.Rational(1, 3)
    first, second = moons(crossing)
    total = sp.integrate(sp.expand(x**2 * (1 - x) ** 2 * (crossing - x)), (x, 0, 1))
    claims = {
        "sum": abs(first) + abs(second),
        "difference": abs(abs(first) - abs(second)),
        "whole chord": abs(total),
    }
    if form not in claims:
        raise DomainError(f"No such way to put the two moons together: {form!r}.")
    # the integrand changes its sign once, at c
    direct = sum(
        abs(sp.integrate(sp.expand(x**2 * (1 - x) ** 2 * (x - crossing)), (x, *ends)))
        for ends in ((0, crossing), (crossing, 1))
    )
    return Evidence(claims[form] == direct, (f"∫|·| = {direct}, {form} = {claims[form]}",))


@claim(
    "(3.24)",
    "The moons of a conic crossing at σ = cρ are (5c⁴ − 6c⁵ + 2c⁶)|Q|ρ⁶/60 and (1 − 2c + 5c⁴ − 6c⁵ "
    "+ 2c⁶)|Q|ρ⁶/60.",
    method=Method.PROOF,
    form="5*c^4 - 6*c^5 + 2*c^6, 1 - 2*c + 5*c^4 - 6*c^5 + 2*c^6",
    wrong=(
        "5*c^4 - 6*c^5 + 3*c^6, 1 - 2*c + 5*c^4 - 6*c^5 + 2*c^6",
        "5*c^4 - 6*c^5 + 2*c^6, 1 + 5*c^4 - 6*c^5 + 2*c^6",
    ),
)
def moon_polynomials(form: str) -> Evidence:
    """∫x²(1 − x)²(c − x) dx from 0 to c, and of the opposite from c to 1."""
    claimed = read_tuple(form, {"c": c}, 2)
    result = Evidence(True)
    for value, derived, name in zip(claimed, moons(c), ("first", "second"), strict=True):
        result &= vanishes(value / 60 - derived, f"{name} moon")
    return result


@claim(
    "(3.19)",
    "The least symmetric difference of a bitangent conic is |dk/dr|ρ⁶/7680 + O(ρ⁷).",
    method=Method.PROOF,
    form="k1*rho^6/7680",
    wrong=("k1*rho^6/3840", "k1*rho^5/7680"),
)
def conic_area(form: str) -> Evidence:
    """The moons at c = 1/2 add up to |Q|ρ⁶/192, and |Q| is |dk/dr|/40 by the canonical form."""
    claimed = read(form, {"rho": rho, "k1": k1})
    half = vanishes(sum(moons(sp.Rational(1, 2))) - sp.Rational(1, 192), "both moons at c = 1/2 are 1/192")
    return half & vanishes(area_at(sp.Rational(1, 2)) - claimed, "area of a conic")


@claim(
    "theorem 3.6.4.2",
    "Among bitangent conics the symmetric difference is least for the crossing c = 1/2, to leading order.",
    method=Method.EXACT,
    form="1/2",
    wrong=("2/5", "0"),
)
def least_area(form: str) -> Evidence:
    """The second derivative of the sum by c is 2c²(1 − c)² > 0 inside; the first vanishes there."""
    total = sp.expand(sum(moons(c)))
    convex = vanishes(sp.diff(total, c, 2) - 2 * c**2 * (1 - c) ** 2, "second derivative 2c²(1 − c)²")
    return convex & vanishes(sp.diff(total, c).subs(c, read(form, {})), f"first derivative at c = {form}")


@claim(
    "theorem 3.6.4.3",
    "The equisymmetric conic crosses at c = 1/2 to leading order, so (3.19) is its area too.",
    method=Method.EXACT,
    form="1/2",
    wrong=("1/3", "2/5"),
)
def equal_moons(form: str) -> Evidence:
    """The moons differ by (1 − 2c)/60, which has one zero; the area there is the least one."""
    first, second = moons(c)
    crossing = read(form, {})
    least = area_at(crossing) - area_at(sp.Rational(1, 2))
    return vanishes((second - first).subs(c, crossing), f"difference of the moons at c = {form}") & vanishes(
        least, "area less the least area"
    )


@claim(
    "theorem 3.6.4-1",
    "In its proof Q(σ, σ, ρ), σ = cρ, is Q(0, 0, 0) + ρ(cQ_u + cQ_σ + Q_ρ) + O(ρ²).",
    method=Method.PROOF,
    form="c*Q_u + c*Q_sigma + Q_rho",
    printed="c*Q_u",
    erratum="The proof of Theorem 3.6.4 expands Q(σ, σ, ρ) without the terms of Q_σ and Q_ρ: they are of the "
    "order ρ as well, and harmless, since only Q(0, 0, 0) is used.",
    wrong=("c*Q_u + c*Q_sigma", "Q_u + Q_sigma + Q_rho"),
)
def expansion_of_the_offset(form: str) -> Evidence:
    """d/dρ of Q(cρ, cρ, ρ) at ρ = 0 for a Q with generic terms of order 1 and 2."""
    first = sp.symbols("Q_u Q_sigma Q_rho", real=True)
    place = (c * rho, c * rho, rho)
    second = [sp.Symbol(f"Q{i}{j}") * place[i] * place[j] for i in range(3) for j in range(i, 3)]
    along = sum(q * x for q, x in zip(first, place, strict=True)) + sum(second)
    stated = read(form, {"c": c, **{s.name: s for s in first}})
    return vanishes(sp.diff(along, rho).subs(rho, 0) - stated, "the coefficient of ρ")
