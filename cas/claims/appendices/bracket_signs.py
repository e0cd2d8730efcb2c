"""Claims of appendix B.1: the brackets K₀ and K₁ of H' are negative on (0, π)."""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

from osculant.cas.claims.appendices.turnings import K0, K1, negative, of_turning, phi
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, split, vanishes


def _flat(function: Any, order: int, what: str) -> Evidence:
    """All derivatives below that order vanish at 0, exactly."""
    values = []
    for _ in range(order):
        values.append(sp.simplify(function.subs(phi, 0)))
        function = sp.diff(function, phi)
    return Evidence(not any(values), (f"derivatives 0 to {order - 1} of {what} at 0: {values}",))


@claim(
    "section B.1-3",
    "K₀ < 0 on (0, π): its derivatives 0 to 4 vanish at 0, and K₀⁗ = −φ sin φ < 0.",
    method=Method.PROOF,
    form="-phi*sin(phi)",
    wrong=("phi*sin(phi)", "-phi*cos(phi)", "-sin(phi)"),
)
def first_bracket(form: str) -> Evidence:
    """Four derivatives; −φ sin φ is a product with known signs, and K₀ itself is enclosed too."""
    function, stated = of_turning(K0), of_turning(form)
    evidence = _flat(function, 5, "K₀") & vanishes(sp.diff(function, phi, 4) - stated, "K₀⁗")
    return evidence & negative(stated, 0, sp.pi, "K₀⁗") & negative(function, 0, sp.pi, "K₀")


@claim(
    "section B.1-4",
    "K₁ = −(7/180)φ⁶ + O(φ⁸).",
    method=Method.PROOF,
    form="-7/180",
    printed="-1/360",
    erratum="K₁ begins with −(7/180)φ⁶, not with −φ⁶/360.",
    wrong=("7/180", "-7/360"),
)
def leading_term(form: str) -> Evidence:
    """Taylor's coefficients at 0 by differentiation: orders 0 to 5 and 7 vanish."""
    function = of_turning(K1)
    evidence = _flat(function, 6, "K₁")
    sixth = sp.diff(function, phi, 6).subs(phi, 0) / sp.factorial(6)
    seventh = sp.diff(function, phi, 7).subs(phi, 0)
    return evidence & vanishes(sixth - read(form, {}), "order 6") & vanishes(seventh, "order 7")


def _sum(pattern: str, terms: int) -> Any:
    """The sum over k of a text such as (-1)**k*(2*phi)**(2*k)/f0, where f0 = (2k)! and f1 = (2k+1)!."""
    total = sp.S.Zero
    for k in range(terms):
        factorials = {"f0": sp.factorial(2 * k), "f1": sp.factorial(2 * k + 1)}
        total += read(re.sub(r"\bk\b", str(k), pattern), {"phi": phi, **factorials})
    return total


G1 = sp.cos(2 * phi) - _sum("(-1)**k*(2*phi)**(2*k)/f0", 5)
G2 = phi * (sp.sin(phi) - _sum("(-1)**k*phi**(2*k + 1)/f1", 3))
G3 = phi**2 * (sp.cos(phi) - _sum("(-1)**k*phi**(2*k)/f0", 3))


def _deviation(function: Any, order: int, form: str, name: str) -> Evidence:
    """Flat to that order, with the stated derivative, which is negative on (0, π)."""
    stated = of_turning(form)
    evidence = _flat(function, order, name) & vanishes(
        sp.diff(function, phi, order) - stated, f"{name}⁽{order}⁾"
    )
    return evidence & negative(stated, 0, sp.pi, f"{name}⁽{order}⁾")


@claim(
    "section B.1-5",
    "K₁ = g₁ + g₂ + g₃ + p, with g₁ = cos 2φ − Σ₀⁴(−1)ᵏ(2φ)²ᵏ/(2k)!, g₂ = φ(sin φ − Σ₀²(−1)ᵏφ²ᵏ⁺¹/(2k+1)!), "
    "g₃ = φ²(cos φ − Σ₀²(−1)ᵏφ²ᵏ/(2k)!), p = −(7/180)φ⁶ + (2/315)φ⁸.",
    method=Method.PROOF,
    form="(-1)**k*(2*phi)**(2*k)/f0, (-1)**k*phi**(2*k + 1)/f1, (-1)**k*phi**(2*k)/f0",
    printed="(2*phi)**(2*k)/f0, phi**(2*k + 1)/f1, (2*phi)**(2*k)/f0",
    erratum="The sums in g₁, g₂, g₃ lack the factor (−1)ᵏ, and g₃ has (2φ)²ᵏ where φ²ᵏ belongs.",
    wrong=(
        "(-1)**k*(2*phi)**(2*k)/f0, (-1)**k*phi**(2*k + 1)/f1, (-1)**k*(2*phi)**(2*k)/f0",
        "(-1)**k*(2*phi)**(2*k)/f0, phi**(2*k + 1)/f1, (-1)**k*phi**(2*k)/f0",
    ),
)
def decomposition(form: str) -> Evidence:
    """The sums of the form's terms (f0 = (2k)!, f1 = (2k+1)!), put together; each gᵢ is flat at 0."""
    first, second, third = split(form, 3)
    g = (
        sp.cos(2 * phi) - _sum(first, 5),
        phi * (sp.sin(phi) - _sum(second, 3)),
        phi**2 * (sp.cos(phi) - _sum(third, 3)),
    )
    p = -sp.Rational(7, 180) * phi**6 + sp.Rational(2, 315) * phi**8
    evidence = vanishes(of_turning(K1) - sum(g) - p, "K₁ − g₁ − g₂ − g₃ − p")
    for function, order, name in zip(g, (10, 8, 8), ("g₁", "g₂", "g₃")):
        evidence &= _flat(function, order, name)
    return evidence


@claim(
    "section B.1-6",
    "g₁ < 0 on (0, π): its derivatives 0 to 7 vanish at 0, and g₁⁽⁸⁾ = 2⁸(cos 2φ − 1) < 0.",
    method=Method.PROOF,
    form="2**8*(cos(2*phi) - 1)",
    wrong=("2**8*(1 - cos(2*phi))", "2**7*(cos(2*phi) - 1)", "2**8*(cos(phi) - 1)"),
)
def first_deviation(form: str) -> Evidence:
    """Eight derivatives; 2⁸(cos 2φ − 1) = −2⁹ sin²φ, and it is negative inside (0, π)."""
    return _deviation(G1, 8, form, "g₁")


@claim(
    "section B.1-7",
    "g₂ < 0 on (0, π): its derivatives 0 to 5 vanish at 0, and g₂⁽⁶⁾ = −6(1 − cos φ) − φ sin φ < 0.",
    method=Method.PROOF,
    form="-6*(1 - cos(phi)) - phi*sin(phi)",
    printed="-1 + cos(phi) - phi*sin(phi)",
    erratum="The sixth derivative of g₂ is −6(1 − cos φ) − φ sin φ; a factor 6 is lost in print.",
    wrong=("-6*(1 - cos(phi)) + phi*sin(phi)", "-5*(1 - cos(phi)) - phi*sin(phi)"),
)
def second_deviation(form: str) -> Evidence:
    """Six derivatives of g₂."""
    return _deviation(G2, 6, form, "g₂")


@claim(
    "section B.1-8",
    "g₃ < 0 on (0, π): its derivatives 0 to 5 vanish at 0, and g₃⁽⁶⁾ = −30(1 − cos φ) "
    "− φ² cos φ − 12φ sin φ, which is negative.",
    method=Method.PROOF,
    form="-30*(1 - cos(phi)) - phi**2*cos(phi) - 12*phi*sin(phi)",
    wrong=(
        "-30*(1 - cos(phi)) + phi**2*cos(phi) - 12*phi*sin(phi)",
        "-30*(1 - cos(phi)) - phi**2*cos(phi) - 6*phi*sin(phi)",
    ),
)
def third_deviation(form: str) -> Evidence:
    """Six derivatives of g₃; the sign on the whole of (0, π) in balls."""
    return _deviation(G3, 6, form, "g₃")


@claim(
    "section B.1-9",
    "p = −(7/180)φ⁶ + (2/315)φ⁸ is negative for 0 < φ < (7/4)√2 = 2.4748…, beyond 3π/4.",
    method=Method.PROOF,
    form="7/4*sqrt(2)",
    wrong=("7/2*sqrt(2)", "5/3*sqrt(2)", "7/4"),
)
def polynomial_part(form: str) -> Evidence:
    """The positive root of p, whose coefficients are those of order 6 and 8 of K₁ − g₂ − g₃; against 3π/4."""
    rest = sp.expand(of_turning(K1) - G1 - G2 - G3)
    p = sum(sp.diff(rest, phi, n).subs(phi, 0) / sp.factorial(n) * phi**n for n in (6, 8))
    end = read(form, {})
    evidence = vanishes(rest - p, "K₁ − g₁ − g₂ − g₃ is this polynomial")
    evidence &= vanishes(p.subs(phi, end), "p at the end") & negative(p, 0, sp.Rational(12, 5), "p")
    beyond = bool(end > 3 * sp.pi / 4) and bool(sp.diff(p / phi**6, phi).subs(phi, 1) > 0)
    return evidence & Evidence(
        beyond, (f"{sp.N(end, 8)} against 3π/4 = {sp.N(3 * sp.pi / 4, 8)}; p/φ⁶ grows",)
    )


@claim(
    "section B.1-10",
    "K₁ ≤ φh with h = φ cos φ + sin φ, as φh − K₁ = 2 sin²φ; h' = 2 cos φ − φ sin φ < 0 on (3π/4, π), "
    "h(3π/4) = (4 − 3π)/(4√2) < 0; so K₁ < 0 there.",
    method=Method.PROOF,
    form="2*sin(phi)**2, 2*cos(phi) - phi*sin(phi), (4 - 3*pi)/(4*sqrt(2))",
    wrong=(
        "sin(phi)**2, 2*cos(phi) - phi*sin(phi), (4 - 3*pi)/(4*sqrt(2))",
        "2*sin(phi)**2, 2*cos(phi) + phi*sin(phi), (4 - 3*pi)/(4*sqrt(2))",
        "2*sin(phi)**2, 2*cos(phi) - phi*sin(phi), (3 - 4*pi)/(4*sqrt(2))",
    ),
)
def second_bracket_near_the_end(form: str) -> Evidence:
    """Difference, derivative and value computed from h and K₁; signs in balls."""
    gap, rate, value = read_tuple(form, {"phi": phi}, 3)
    function, low = phi * sp.cos(phi) + sp.sin(phi), 3 * sp.pi / 4
    evidence = vanishes(phi * function - of_turning(K1) - gap, "φh − K₁")
    evidence &= vanishes(sp.diff(function, phi) - rate, "h'") & negative(rate, low, sp.pi, "h'")
    evidence &= vanishes(function.subs(phi, low) - value, "h(3π/4)")
    return evidence & Evidence(bool(value < 0), ("h(3π/4) < 0",))


@claim(
    "section B.1-11",
    "K₁ < 0 on (0, π).",
    method=Method.ENCLOSURE,
    form="0, pi",
    wrong=("0, 5*pi/2", "-pi, 5*pi/2"),
)
def second_bracket(form: str) -> Evidence:
    """In balls on the whole interval; near 0 by the sixth derivative."""
    low, high = read_tuple(form, {}, 2)
    return negative(of_turning(K1), low, high, "K₁")
