"""Claims on geometric Hermite interpolation: its order, and the G² cubic (thesis 1.3.3)."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.asymptotics.contacts import CONTACTS
from osculant.cas.asymptotics.g2_cubics import displacement, g2_cubics
from osculant.cas.asymptotics.hermite_cubics import (
    a,
    blown_up_system,
    branches,
    contact_cubic,
    discriminant,
    k,
    k1,
    k2,
    limit_system,
    middle_is_best,
    z,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import agrees, integers, read, vanishes
from osculant.cas.jets.canonical import affine_graph

#: digits and affine length of the true G² cubics
DIGITS, LENGTH = 70, "1e-5"


@claim(
    "section 1.3.3-5",
    "Höllig and Koch's order m = d + 1 + ⌊(d − 1)/(n − 1)⌋ for curves of degree d in n dimensions: 4 and 6 "
    "for parabolas and cubics in the plane, 3 and 5 in space.",
    method=Method.EXACT,
    form="(d - 1)/(n - 1)",
    wrong=("0", "d - 1", "(d - 1)*(n - 1)", "d/(n - 1)", "(d - 1)/n", "(d - 2)/(n - 1)"),
)
def hoellig_koch(form: str) -> Evidence:
    """The order is the first power of t that no choice of coefficients removes.

    Polynomial curves x = t + …, y = … of degree d against the canonical form: the order is the first power
    of t that is left when the coefficients are chosen so that as many as possible vanish; for d = 2 the
    parabola y = x²/2 leaves kx⁴/8, for d = 3 six-fold contact leaves E(a)t⁶. In space the same with a graph
    (x, f(x), g(x)), f = x²/2 + …, g = cx³ + …. The form is what the floor is taken of.
    """
    y, _ = affine_graph(CONTACTS)
    parabola = next(i for i in range(3, CONTACTS) if y[i] != 0)
    cubic = CONTACTS if contact_cubic().residual != 0 else CONTACTS + 1
    evidence = Evidence(True)
    orders = {(2, 2): parabola, (2, 3): cubic} | {(3, d): _order_in_space(d) for d in (2, 3)}
    for (dimension, degree), order in orders.items():
        quotient = read(form, {"d": sp.Integer(degree), "n": sp.Integer(dimension)})
        stated = degree + 1 + sp.floor(quotient)
        evidence &= vanishes(
            stated - order, f"order of degree {degree} in dimension {dimension}, {order} from the contact"
        )
    return evidence


def _order_in_space(degree: int) -> int:
    """The first order in which no curve of that degree meets a space curve (x, f(x), g(x)).

    The curve is x = t + a₂t² + …; its other coordinates take care of the orders up to the degree. f and g
    have prime numbers for coefficients: no order is met by accident.
    """
    t, *free = sp.symbols(f"t a2:{degree + 1}")
    f, g = (2, 3, 5, 7, 11), (13, 17, 19, 23)
    x = t + sum(c * t**i for i, c in enumerate(free, start=2))
    rows = [sum(c * x**i for i, c in enumerate(row, start=start)) for row, start in ((f, 2), (g, 3))]
    rest = [sp.Poly(sp.expand(row), t) for row in rows]
    order, conditions = degree + 1, []
    while True:
        conditions += [row.coeff_monomial(t**order) for row in rest]
        if not sp.solve(conditions, free, dict=True):
            return order
        order += 1


@claim(
    "X1.3-1",
    "In the limit of a short arc the G² cubics have six-fold contact x = t + at² + bt³, y = t²/2 + at³ with "
    "a³ − (3/4)ka − k′/20 = 0, b = −a²/2 − k/8, k the affine curvature.",
    method=Method.PROOF,
    form="a**3 - 3/4*k*a - k1/20",
    wrong=("a**3 - 3/4*k*a + k1/20", "a**3 - 3/4*k*a - k1/40", "a**3 + 3/4*k*a - k1/20"),
)
def contact_condition(form: str) -> Evidence:
    """y − x²/2 − kx⁴/8 − k′x⁵/40 is inserted; t², t³, t⁴ give c, d, b and t⁵ the condition.

    The quadratic system for the tangent lengths, blown up at its triple root, gives the same cubic
    polynomial for z = −a/3.
    """
    stated = read(form, {"a": a, "k": k, "k1": k1})
    from_system = sp.expand(blown_up_system().subs(z, -a / 3) / sp.Rational(-1, 27))
    return vanishes(stated - contact_cubic().condition, "six-fold contact") & vanishes(
        stated - from_system, "curvature conditions at h³"
    )


@claim(
    "X1.3-2",
    "At h = 0 the system of de Boor, Höllig and Sabin for the tangent lengths δ/h has the triple "
    "solution 1/3.",
    method=Method.PROOF,
    form="(xi - 1/3)**3*(xi + 1)",
    wrong=("(xi - 1/3)**2*(xi + 1)**2", "(xi - 1/3)*(xi + 1)**3", "(xi - 1/2)**3*(xi + 1)"),
)
def triple_root(form: str) -> Evidence:
    """The two curvature conditions as series in h: the term h⁰.

    ξ₁ is taken from the first curvature condition and inserted into the second, as series in h: the term h⁰.
    """
    xi = sp.Symbol("xi")
    return vanishes(read(form, {"xi": xi}) - limit_system(), "polynomial for ξ₀ at h = 0")


@claim(
    "X1.3-3",
    "A G² cubic's Hausdorff error is |E|κ^(7/3)σ⁶/64 with E = (21/32)ka² + (21/160)k′a + k²/128 + k″/240.",
    method=Method.PROOF,
    form="(21/32*k*a**2 + 21/160*k1*a + k**2/128 + k2/240)/64",
    wrong=(
        "(21/32*k*a**2 + 21/160*k1*a - k**2/128 + k2/240)/64",
        "(21/32*k*a**2 + 21/160*k1*a + k**2/128 + k2/720)/64",
        "(21/32*k*a**2 + k**2/128 + k2/240)/64",
        "(21/32*k*a**2 + 21/160*k1*a + k**2/128 + k2/240)/32",
    ),
)
def cubic_error(form: str) -> Evidence:
    """E is what is left at t⁶, reduced by the condition on a.

    With three contacts at each end the displacement in the affine frame is E·u³(ℓ − u)³, largest in the
    middle; the normal is κ^{1/3} times the affine one and ℓ = κ^{1/3}σ.
    """
    u = sp.Symbol("u", real=True)
    shape = u ** (CONTACTS // 2) * (1 - u) ** (CONTACTS // 2)
    heights = [shape.subs(u, r) for r in sp.roots(sp.diff(shape, u), u)]
    stated = read(form, {"a": a, "k": k, "k1": k1, "k2": k2})
    left = sp.rem(sp.expand(stated), contact_cubic().condition, a)
    return vanishes(left - contact_cubic().residual * max(heights), "E times the height of the displacement")


@claim(
    "X1.3-4",
    "A short arc has three G² cubics if k′² < 25k³ and one if k′² > 25k³ (k affine curvature, by "
    "affine arc length).",
    method=Method.PROOF,
    form="25*k**3 - k1**2",
    wrong=("25*k**3 + k1**2", "16*k**3 - k1**2", "k**3 - 25*k1**2"),
)
def number_of_solutions(form: str) -> Evidence:
    """The discriminant of the condition on a.

    A real cubic polynomial without double root has three real roots exactly if its discriminant is positive.
    Simple roots persist for small h by the implicit function theorem. The form may differ by a positive
    factor.
    """
    stated = read(form, {"k": k, "k1": k1})
    if stated.subs({k: 1, k1: 0}) == 0:
        return Evidence(False, ("the form is 0 for k = 1, k′ = 0, the discriminant is not",))
    factor = discriminant().subs({k: 1, k1: 0}) / stated.subs({k: 1, k1: 0})
    positive = Evidence(bool(factor.is_positive), (f"discriminant = {factor}·(form)",))
    return positive & vanishes(discriminant() - factor * stated, "discriminant")


@claim(
    "X1.3-5",
    "Which of three G² cubics is best (open problem 1 of section 1.3.3): the one of least |a|, as long as "
    "k″/120 + k² ≥ (21/32)(ka² + k′a/5) for the a of largest modulus.",
    method=Method.PROOF,
    form="k2/120 + k**2 - 21/32*(k*a**2 + k1*a/5)",
    wrong=("k2/120 - k**2 - 21/32*(k*a**2 + k1*a/5)", "k2/120 + k**2 - 21/32*(k*a**2 - k1*a/5)",
           "k2/120 + k**2 - 21/64*(k*a**2 + k1*a/5)"),
)  # fmt: skip
def criterion(form: str) -> Evidence:
    """Compare E at the three real solutions.

    a = √k cos ϑ with cos 3ϑ = C = k′/(5k^{3/2}) solves the condition, and E = (21/32)k²(c² + Cc) + …, c =
    cos ϑ. Let C ≥ 0 (else mirror), c₀ ≥ C > 0 ≥ c₂ ≥ c₁ the solutions, whose sum is 0. Then E(c₀) − E(c₁) ~
    (c₀ − c₁)(C − c₂) > 0 and E(c₁) − E(c₂) ~ (c₁ − c₂)(C − c₀) ≥ 0, so E is least for the middle solution
    c₂, the one of least modulus, and |E| is least there exactly if E(c₁) + E(c₂) ≥ 0. That sum, by c₁ + c₂ =
    −c₀, is a polynomial in c₀.
    """
    angle = sp.Symbol("angle", real=True)
    stated = read(form, {"a": a, "k": k, "k1": k1, "k2": k2})
    inserted = contact_cubic().condition.subs({a: sp.cos(angle), k: 1, k1: 5 * sp.cos(3 * angle)})
    solution = vanishes(sp.expand(sp.expand_trig(inserted)), "a = √k cos ϑ in the condition, k = 1")
    p, q, r, C = sp.symbols("p q r C", real=True)
    residual = contact_cubic().residual.subs({k: 1, k1: 5 * C})
    gap = residual.subs(a, p) - residual.subs(a, q) - sp.Rational(21, 32) * (p - q) * (C - r)
    order = vanishes(sp.expand(gap.subs(r, -p - q)), "differences of E between two solutions")
    return solution & order & vanishes(sp.expand(stated - middle_is_best()), "E(c₁) + E(c₂)")


@claim(
    "X1.3-6",
    "All G² cubics of a short arc, three or one, have the signed displacement Eκ^(7/3)σ⁶/64 in the middle: "
    "for curves with (k, k′, k″) = (1, 2, 3), (1, 7, 3), (−1, 1, 1).",
    method=Method.NUMERICAL,
    reason="X1.3-3 proves the limit; here true cubics are found with 70 digits and measured",
    form="64",
    wrong=("63", "32", "128"),
)
def true_cubics(form: str) -> Evidence:
    """The curve is its canonical form cut after x⁶.

    The solutions of the quadratic system are matched with the real solutions a of the condition in the order
    of the displacement in the middle.
    """
    (count,) = integers(form, 1)
    with mp.workdps(DIGITS):
        evidence, factor = Evidence(True), mp.mpf(1) / count if count else mp.inf
        for what, jet in (("three solutions", (1, 2, 3)), ("one solution", (1, 7, 3)), ("k < 0", (-1, 1, 1))):
            evidence &= _measure(what, jet, factor)
        return evidence


def _measure(what: str, jet: tuple[int, int, int], factor: Any) -> Evidence:
    heights = _polynomial(jet)
    half = mp.mpf(LENGTH) / 2

    def curve(x: Any) -> tuple[Any, Any, Any]:
        values = [mp.polyval([mp.mpf(c) for c in row], x) for row in heights]
        return (x, values[0]), (mp.mpf(1), values[1]), (mp.mpf(0), values[2])

    cubics = g2_cubics(curve, -half, half)
    found = sorted(displacement(curve, c, mp.mpf(0), mp.mpf(1) / 2) for c in cubics)
    # y″ = 1 and y′ = 0 in the middle: κ = 1, so σ is the affine length up to O(h²). The displacement of the
    # cubic is minus the defect of the curve, and E u³(ℓ − u)³ is negative there.
    expected = sorted(branch.residual * factor * (2 * half) ** CONTACTS for branch in branches(*jet))
    same = Evidence(len(found) == len(expected), (f"{what}: {len(found)} cubics, {len(expected)} expected",))
    for value, stated in zip(found, expected):
        same &= agrees(value, stated, 3, what)
    return same


@cache
def _polynomial(jet: tuple[int, int, int]) -> list[list[mp.mpf]]:
    y, _ = affine_graph(CONTACTS, (*(sp.Rational(c) for c in jet), sp.Integer(0)))
    x = sp.Symbol("x")
    value = sum(c * x**i for i, c in enumerate(y.coefficients))
    return [
        [mp.mpf(int(c.p)) / int(c.q) for c in sp.Poly(sp.diff(value, x, i), x).all_coeffs()] for i in range(3)
    ]
