"""Section 3.6.2, continued: splines of least area, and the number of their pieces."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_3.areas import (
    ORDERS,
    arc_factor,
    area_at,
    c,
    constant_of,
    moons,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import HALF_SEXTIC, SPIRAL_ARC
from osculant.cas.claims.proof import agrees, positive, read, read_tuple, split, vanishes

a, b, n, eps, content = sp.symbols("a b n eps content", positive=True)


def spline_area(form: str, primitive: str) -> Evidence:
    """Whether the form in ``content`` and n is the least area of n pieces, to leading order.

    Two stretches of unit affine length with |k| = a^p, b^p (p = 5; dk/dr and 6 for conics) stand for any step
    function: the share s of the n pieces on the first gives the area c(a^p s^{1−p} + b^p (1 −
    s)^{1−p})/n^{p−1}, convex in s, stationary where the pieces have equal content.
    """
    order, share = ORDERS[primitive], sp.Symbol("share", positive=True)
    total = a**order * share ** (1 - order) + b**order * (1 - share) ** (1 - order)
    best = a / (a + b)
    bends = order * (order - 1) * (a**order / share ** (order + 1) + b**order / (1 - share) ** (order + 1))
    value = arc_factor(primitive) * total.subs(share, best) / n ** (order - 1)
    return (
        vanishes(sp.diff(total, share).subs(share, best), "slope at equal content")
        & vanishes(sp.diff(total, share, 2) - bends, "second derivative, a sum of positive terms")
        & vanishes(value - read(form, {"content": a + b, "n": n}), "area at equal content")
    )


def pieces(form: str, primitive: str) -> Evidence:
    """Whether the form in ``content`` and ε is the n for which the spline's area is ε."""
    order = ORDERS[primitive]
    area = arc_factor(primitive) * content**order / n ** (order - 1)
    stated = read(form, {"content": content, "eps": eps})
    solves = vanishes(area.subs(n, stated) - eps, "area of N(ε) pieces less ε")
    return positive(stated, "N(ε)") & solves


@claim(
    "corollary 3.6.5.1",
    "The best parabolic spline with n pieces has the area (∫|k|^(1/5) dr)⁵/(240 n⁴), to leading order.",
    method=Method.PROOF,
    form="content^5/(240*n^4)",
    wrong=("content^5/(240*n^5)", "content^4/(240*n^4)"),
)
def parabolic_spline(form: str) -> Evidence:
    """One arc costs |k|ρ⁵/240; n pieces are shared between two stretches so that the sum is least.

    The areas of refined step functions converge to the integral.
    """
    return spline_area(form, "parabola")


@claim(
    "corollary 3.6.5.2",
    "The best conic spline with n pieces has the area (∫|dk/dr|^(1/6) dr)⁶/(7680 n⁵), to leading order.",
    method=Method.PROOF,
    form="content^6/(7680*n^5)",
    wrong=("content^6/(7680*n^6)", "content^5/(7680*n^5)"),
)
def conic_spline(form: str) -> Evidence:
    """As for parabolas, with |dk/dr|ρ⁶/7680 of the conic of least area."""
    return spline_area(form, "conic")


@claim(
    "corollary 3.6.6",
    "The equisymmetric conic spline with n pieces has the same leading area, (∫|dk/dr|^(1/6) dr)⁶/(7680 n⁵).",
    method=Method.PROOF,
    form="content^6/(7680*n^5)",
    wrong=("content^6/(3840*n^5)", "content^6/(7680*n^4)"),
)
def equisymmetric_spline(form: str) -> Evidence:
    """It crosses where the moons' difference vanishes; its area goes into the same sum."""
    first, second = moons(c)
    (crossing,) = sp.solve(sp.expand(second - first), c)
    same = vanishes(
        area_at(crossing) - area_at(sp.Rational(1, 2)), f"area at the equisymmetric c = {crossing}"
    )
    return same & spline_area(form, "conic")


@claim(
    "remark 3.6.7",
    "Knots equally spaced in ∫|k|^(1/5) dr, or ∫|dk/dr|^(1/6) dr, give arcs of equal area, to leading order.",
    method=Method.PROOF,
    form="1/5, 1/6",
    wrong=("1/4, 1/5", "1/5, 1/5"),
)
def equal_content(form: str) -> Evidence:
    """An arc of content λ has the length λ/|k|^x and an area like |k|^{1 − px}: free of k iff x = 1/p."""
    result = Evidence(True)
    for (primitive, order), exponent in zip(ORDERS.items(), read_tuple(form, {}, 2), strict=True):
        area = arc_factor(primitive) * a * (content / a**exponent) ** order
        result &= vanishes(sp.diff(area, a) * a / area, f"area by the invariant, {primitive}")
    return result


@claim(
    "(3.25)",
    "N(ε) = 240^(−1/4) (∫|k|^(1/5) dr)^(5/4) ε^(−1/4) parabolas have the area ε, to leading order.",
    method=Method.PROOF,
    form="240^(-1/4)*content^(5/4)*eps^(-1/4)",
    wrong=(
        "240^(-1/4)*content*eps^(-1/4)",
        "240^(-1/5)*content^(5/4)*eps^(-1/4)",
        "-240^(-1/4)*content^(5/4)*eps^(-1/4)",
    ),
)
def parabola_pieces(form: str) -> Evidence:
    """Corollary 3.6.5 solved for n."""
    return pieces(form, "parabola")


@claim(
    "(3.26)",
    "N(ε) = 7680^(−1/5) (∫|dk/dr|^(1/6) dr)^(6/5) ε^(−1/5) conics have the area ε, to leading order.",
    method=Method.PROOF,
    form="7680^(-1/5)*content^(6/5)*eps^(-1/5)",
    wrong=("7680^(-1/5)*content*eps^(-1/5)", "7680^(-1/6)*content^(6/5)*eps^(-1/5)"),
)
def conic_pieces(form: str) -> Evidence:
    """Corollary 3.6.5, or 3.6.6, solved for n."""
    return pieces(form, "conic")


@claim(
    "corollary 3.6.8.1",
    "The constants of (3.25) are 4.58989272897455017 for the spiral and 1.67934089089600706 for "
    "half of Cayley's "
    "sextic.",
    method=Method.NUMERICAL,
    reason="the quadrature converges doubly exponentially, but its error is estimated, not enclosed",
    form="4.58989272897455017, 1.67934089089600706",
    wrong=("4.58989272897456, 1.67934089089600706", "4.58989272897455017, 1.679341"),
)
def parabola_constants(form: str) -> Evidence:
    """∫|k|^{1/5} dr from jets in 320-bit balls, to the power 5/4, over 240^{1/4}, to 17 digits."""
    return _constants(form, "parabola")


@claim(
    "corollary 3.6.8.2",
    "The constants of (3.26) are 2.03777820080992568 for the spiral and 0.708049754584166635 for half of "
    "Cayley's sextic.",
    method=Method.NUMERICAL,
    reason="the quadrature converges doubly exponentially, but its error is estimated, not enclosed",
    form="2.03777820080992568, 0.708049754584166635",
    wrong=("2.0377782008099, 0.708049754584166635", "2.03777820080992568, 0.70805"),
)
def conic_constants(form: str) -> Evidence:
    """∫|dk/dr|^{1/6} dr from jets in 320-bit balls, to the power 6/5, over 7680^{1/5}, to 17 digits."""
    return _constants(form, "conic")


def _constants(form: str, primitive: str) -> Evidence:
    result = Evidence(True)
    for claimed, example in zip(split(form, 2), (SPIRAL_ARC, HALF_SEXTIC), strict=True):
        value = constant_of(example, primitive)
        result &= agrees(value.str(30, radius=False), claimed, 17, f"constant of ({example[0]})")
    return result
