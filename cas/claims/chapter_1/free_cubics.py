"""Claims beyond section 1.3.3: the cubics that are tangent at both ends and of least error."""

from __future__ import annotations

from itertools import pairwise

import sympy as sp

from osculant.cas.asymptotics import free_cubics, hermite_cubics
from osculant.cas.asymptotics.free_cubics import Y2, Y3, Y4, Y5, Y6, Y, a, b
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes

_NAMES = {str(symbol): symbol for symbol in (a, b, *Y)}


@claim(
    "X1.3-7",
    "A cubic x = t + at² + bt³, y = ct² + dt³ has six-fold contact with y = Y₂x² + … + Y₆x⁶ + … if and only "
    "if (C) 2Y₂²a³ + 3Y₂Y₃a² + (9Y₃² − 6Y₂Y₄)a + 3Y₃Y₄ − 2Y₂Y₅ = 0, for Y₂ ≠ 0; t⁶ leaves (D).",
    method=Method.PROOF,
    form="2*Y2**2*a**3 + 3*Y2*Y3*a**2 + (9*Y3**2 - 6*Y2*Y4)*a + 3*Y3*Y4 - 2*Y2*Y5, "
    "Y2*b**2 + Y3*(a**3 + 6*a*b) + Y4*(6*a**2 + 4*b) + 5*a*Y5 + Y6",
    wrong=(
        "2*Y2**2*a**3 + 3*Y2*Y3*a**2 + (9*Y3**2 - 6*Y2*Y4)*a + 3*Y3*Y4 + 2*Y2*Y5, "
        "Y2*b**2 + Y3*(a**3 + 6*a*b) + Y4*(6*a**2 + 4*b) + 5*a*Y5 + Y6",
        "2*Y2**2*a**3 + 3*Y2*Y3*a**2 + (9*Y3**2 + 6*Y2*Y4)*a + 3*Y3*Y4 - 2*Y2*Y5, "
        "Y2*b**2 + Y3*(a**3 + 6*a*b) + Y4*(6*a**2 + 4*b) + 5*a*Y5 + Y6",
        "2*Y2**2*a**3 + 3*Y2*Y3*a**2 + (9*Y3**2 - 6*Y2*Y4)*a + 3*Y3*Y4 - 2*Y2*Y5, "
        "Y2*b**2 + Y3*(a**3 + 3*a*b) + Y4*(6*a**2 + 4*b) + 5*a*Y5 + Y6",
    ),
)
def six_contacts(form: str) -> Evidence:
    """Orders t⁴ and t⁵ of Σ Yₙxⁿ − y, both linear in b, have a common b exactly where (C) holds.

    Orders t² and t³ determine c and d. The resultant of the other two by b is (C); it is compared up to a
    constant, the order t⁶ as it is.
    """
    condition, residual = read_tuple(form, _NAMES, 2)
    t = sp.Symbol("t")
    x = t + a * t**2 + b * t**3
    series = sp.Poly(sp.expand(sum(y * x**n for n, y in enumerate(Y, 2))), t)
    fourth, fifth, sixth = (series.coeff_monomial(t**n) for n in (4, 5, 6))
    common = sp.expand(sp.resultant(fourth, fifth, b))
    unit = sp.Poly(common, a, Y2).coeff_monomial(a**3 * Y2**2) / 2
    used = free_cubics.contact()
    return (
        vanishes(sp.expand(common / unit - condition), "(C)")
        & vanishes(sp.expand(sixth - residual), "(D)")
        & vanishes(sp.expand(used.condition - condition), "(C) as the law uses it")
        & vanishes(sp.expand(used.residual - residual), "(D) as the law uses it")
    )


@claim(
    "X1.3-8",
    "The cubic of least distance from a short arc of length σ, tangent at both ends, is off by |D|σ⁶c/16, "
    "c = 1/4 − w, 64w³ + 27w = 27/4: w = (3/8)(∛(√2 + 1) − ∛(√2 − 1)), so that 16/c = 604.386….",
    method=Method.PROOF,
    form="64*w**3 + 27*w - 27/4",
    wrong=("64*w**3 - 27*w - 27/4", "64*w**3 + 27*w - 27/8", "32*w**3 + 27*w - 27/4"),
)
def equal_peaks(form: str) -> Evidence:
    """The peaks of (1/4 − y²)²(y² − c) at 0 and at y² = (1/4 + 2c)/3 are −c/16 and 4w³/27.

    A smaller c makes the middle peak smaller and the others larger, so the largest is least where they are
    equal. The closed form of w is a root of the polynomial, which is increasing and has one.
    """
    w, c = sp.symbols("w c", positive=True)
    stated = read(form, {"w": w})
    y = sp.Symbol("y", real=True)
    height = (sp.Rational(1, 4) - y**2) ** 2 * (y**2 - c)
    outer = (sp.Rational(1, 4) + 2 * c) / 3
    slope = sp.expand(sp.diff(height, y) / y).subs(y, sp.sqrt(outer))
    middle, beside = height.subs(y, 0), sp.expand(height).subs(y, sp.sqrt(outer))
    balance = sp.expand((middle + beside).subs(c, sp.Rational(1, 4) - w))
    root = sp.Rational(3, 8) * (sp.cbrt(sp.sqrt(2) + 1) - sp.cbrt(sp.sqrt(2) - 1))
    near = free_cubics.equal_peaks().number()
    value = sp.Abs(sp.N(sp.Rational(1, 4) - root - near, 40)) < sp.Float("1e-35")
    return (
        vanishes(sp.expand(slope), "the places of the outer peaks")
        & vanishes(sp.expand(27 * 16 * balance - stated), "equal peaks")
        & vanishes(sp.expand(root**3 * 64 + 27 * root - sp.Rational(27, 4)), "the closed form of w")
        & Evidence(bool(value), ("c of the law is 1/4 − w to 35 digits",))
    )


@claim(
    "X1.3-9",
    "The cubic of least area crosses a short arc at σ(1/2 ± z), 48z⁵ − 40z³ + 15z − 2 = 0, and the area is "
    "|D|σ⁷/1020.027….",
    method=Method.PROOF,
    form="48*z**5 - 40*z**3 + 15*z - 2",
    wrong=("48*z**5 - 40*z**3 + 15*z - 1", "48*z**5 + 40*z**3 + 15*z - 2", "3*z**5 - 10*z**3 + 15*z - 4"),
)
def canonical_points(form: str) -> Evidence:
    """The derivative by c of ∫ (1/4 − y²)²|y² − c| dy is 0 where sign (y² − c) is orthogonal to the weight.

    That is twice the weight's integral from 0 to z = √c against that from 0 to 1/2; the area is convex in c.
    """
    z, y = sp.symbols("z y", positive=True)
    stated = read(form, {"z": z})
    half = sp.Rational(1, 2)
    weight = (sp.Rational(1, 4) - y**2) ** 2
    signed = 2 * sp.integrate(sp.expand(weight), (y, 0, z)) - sp.integrate(sp.expand(weight), (y, 0, half))
    parts = pairwise((sp.Integer(0), z, half))
    area = sum(
        sp.Abs(side) * sp.integrate(sp.expand(side * weight * (y**2 - z**2)), (y, *ends))
        for side, ends in zip((-1, 1), parts)
    )
    root = free_cubics.least_area().number()
    same = sp.Abs(sp.N(2 * area.subs(z, root) - free_cubics.area_constant().number(), 40))
    return vanishes(sp.expand(signed * 120 - stated), "canonical points") & Evidence(
        bool(same < sp.Float("1e-35")), ("the area at that z is the law's constant to 35 digits",)
    )


@claim(
    "X1.3-10",
    "On a circle (C) has the roots a = 0 and a² = (3/4)k, with D = κ⁵/128 and 64 times as much.",
    method=Method.PROOF,
    form="1/128, 64",
    wrong=("1/64, 64", "1/128, 32", "1/128, -64"),
)
def circles(form: str) -> Evidence:
    """The circle of curvature 1 is y = 1 − √(1 − x²) = x²/2 + x⁴/8 + x⁶/16 + …; D scales like κ⁵.

    Both are E of X1.3-3, too, at k = 1, k′ = k″ = 0.
    """
    least, factor = read_tuple(form, {}, 2)
    x = sp.Symbol("x")
    graph = sp.series(1 - sp.sqrt(1 - x**2), x, 0, 7).removeO()
    circle = {y: graph.coeff(x, n) for n, y in enumerate((Y2, Y3, Y4, Y5, Y6), 2)}
    contact = free_cubics.contact()
    third, _ = contact.third()
    residual = sp.expand(contact.residual.subs(b, third).subs(circle))
    roots = sp.roots(contact.condition.subs(circle), a)
    affine = hermite_cubics.contact_cubic().residual
    affine = affine.subs({hermite_cubics.k: 1, hermite_cubics.k1: 0, hermite_cubics.k2: 0})
    evidence = Evidence(len(roots) == 3, (f"{len(roots)} roots",))
    for root in roots:
        expected = least if root == 0 else least * factor
        evidence &= vanishes(residual.subs(a, root) - expected, f"D at a = {root}")
    for root in (sp.Integer(0), sp.sqrt(3) / 2):
        expected = least if root == 0 else least * factor
        evidence &= vanishes(sp.expand(affine.subs(hermite_cubics.a, root)) - expected, f"E at a = {root}")
    return evidence
