"""Claims on polynomial curves with 2n contacts with a conic: Floater's scheme (thesis 1.3.3, 3.8)."""

from __future__ import annotations

from itertools import product

import sympy as sp

from osculant.cas.asymptotics.conic_hermite import (
    A,
    circle_interpolant,
    conic_constant,
    contact_factor,
    peak,
    rational_speed,
    speed,
    t,
)
from osculant.cas.asymptotics.hermite_cubics import a, contact_cubic, k, k1, k2
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import agrees, positive, read, vanishes

#: the degrees at which statements on all odd n are checked
DEGREES = (1, 3, 5, 7, 9)


@claim(
    "X3.8-10",
    "Floater's contacts, n − 1 at each end and 2 in the middle: for n = 1, 3, 5, 7, 9 the curve "
    "(1 + it)/(1 − it)·(1 − g(t)/g(−i)), g = t(t² − A²)^((n−1)/2), is polynomial of degree n, and "
    "has them with the circle.",
    method=Method.EXACT,
    form="A**2 + 1",
    wrong=("A**2 - 1", "A + 1", "2*A**2 + 1", "-A**2 - 1"),
)
def floater_contacts(form: str) -> Evidence:
    """The pole is divided out exactly, for n = 1, 3, 5, 7, 9.

    For n = 1, 3, 5, 7, 9: the pole is divided out exactly, and x² + y² − 1 must be g²/(form)^{n−1}: a square
    with the zeros asked for. Every conic that is no parabola is an affine image of the circle or of xy = 1,
    for which t is replaced by it.
    """
    base = read(form, {"A": A})
    evidence = positive(base, "the form")  # its even powers do not tell
    for n in DEGREES if evidence else ():
        x, y = circle_interpolant(n)
        degree = max(sp.degree(x, t), sp.degree(y, t))
        defect = sp.expand(x**2 + y**2 - 1) - sp.expand(contact_factor(n) ** 2) / base ** (n - 1)
        evidence &= vanishes(defect, f"n = {n}, degree {degree}") & Evidence(degree == n)
    return evidence


@claim(
    "X3.8-11",
    "With Floater's contacts this curve has, for n = 3, 5, 7, 9, on one short arc of a conic the error "
    "(n − 1)^(n−1)/(2nⁿ)·|k|^(n−1)κ^(1/3)(ℓ/4)^(2n), ℓ = κ^(1/3)σ its affine length (odd n ≥ 3).",
    method=Method.EXACT,
    form="(n - 1)**(n - 1)/(2*n**n)/4**(2*n)",
    wrong=("(n - 1)**(n - 1)/n**n/4**(2*n)", "(n - 1)**(n - 1)/(2*n**n)/2**(2*n)", "1/(2*n**n)/4**(2*n)"),
)
def floater_constant(form: str) -> Evidence:
    """The largest displacement on the unit circle, for n = 3, 5, 7, 9.

    On the unit circle, k = κ = 1: displacement g²/2(1 + A²)^{n−1}, with the largest g² at t² = A²/n, over
    the angle ℓ = 4·atan A, so A → ℓ/4. Each n = 3, 5, 7, 9 is expanded; the powers of k and κ restore the
    scale.
    """
    widening = sp.diff(4 * sp.atan(A), A).subs(A, 0)
    evidence = Evidence(True)
    for n in DEGREES[1:]:
        x, y = circle_interpolant(n)
        height = sp.cancel(sp.expand(x**2 + y**2 - 1).subs(t, A / sp.sqrt(n)) / A ** (2 * n)) / 2
        exact = height.subs(A, 0) / widening ** (2 * n)
        stated = read(form, {"n": sp.Integer(n)})
        evidence &= vanishes(stated - exact, f"n = {n}") & vanishes(
            exact - conic_constant(n), "by the speed S = 2"
        )
    return evidence


@claim(
    "X3.8-12",
    "Among the polynomial curves of odd degree n with 2n contacts with a short arc of a conic the "
    "least error has "
    "that with all roots in one half plane: speed S = 1/sin(π/2n) and displacement (u/S)^(2n)/2.",
    method=Method.NUMERICAL,
    reason="all sines are positive, so equal signs are best for every n; the closed form of their sum is "
    "compared with 25 digits for n = 1, 3, 5, 7",
    form="1/sin(pi/(2*n))",
    wrong=("2", "1/tan(pi/(2*n))", "n/sin(pi/(2*n))"),
)
def best_conic_interpolant(form: str) -> Evidence:
    """All 2ⁿ choices of roots for n = 1, 3, 5, 7, compared by S.

    |P|² = 1 + t^{2n} has one root of each conjugate pair in P; all 2ⁿ choices of n = 1, 3, 5, 7 are compared
    by S. That of Floater's contacts is among them.
    """
    evidence = Evidence(True)
    for n in DEGREES[:-1]:
        sines = [sp.N(sp.sin(sp.pi * (2 * j + 1) / (2 * n)), 30) for j in range(n)]
        speeds = {
            signs: abs(sum(s * q for s, q in zip(signs, sines))) for signs in product((1, -1), repeat=n)
        }
        best = max(speeds.values())
        stated = sp.N(read(form, {"n": sp.Integer(n)}), 30)
        floater = rational_speed(n)
        among = min(abs(value - floater) for value in speeds.values()) < sp.Float("1e-25")
        evidence &= agrees(stated, best, 25, f"n = {n}, best of {len(speeds)} choices") & Evidence(
            bool(among), (f"n = {n}: Floater's contacts have S = {floater}",)
        )
    return evidence


@claim(
    "X3.8-13",
    "For cubics, n = 3, the curve with Floater's contacts is the best of the curves with six "
    "contacts, and agrees with "
    "E = k²/128 of the "
    "G² cubic with a = 0 on conics.",
    method=Method.PROOF,
    form="1/128",
    wrong=("1/64", "1/2", "1/55296"),
)
def cubics_agree(form: str) -> Evidence:
    """Three ways to the constant of cubics on conics.

    E of X1.3-3 on a conic (k′ = k″ = 0) at a = 0 and k = 1; and the constant of X3.8-11 over the height of
    its displacement, u²(ℓ − u)²(u − ℓ/2)²; and S of all roots in one half plane, which is 2.
    """
    stated = read(form, {})
    residual = contact_cubic().residual.subs({a: 0, k: 1, k1: 0, k2: 0})
    height = sp.Rational(*peak(3).as_integer_ratio()) / 2 ** (2 * 3)
    best = vanishes(speed((1, 1, 1)) - rational_speed(3), "speeds")
    return (
        best
        & vanishes(stated - residual, "G² cubic")
        & vanishes(stated - conic_constant(3) / height, "Floater's")
    )
