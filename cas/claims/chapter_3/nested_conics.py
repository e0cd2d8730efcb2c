"""Claims beyond section 3.2: osculating conics of affine spirals are nested; corollaries of Theorem A."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integer, read, vanishes
from osculant.cas.jets.canonical import affine_graph

U, V, K, K1 = sp.symbols("u v k dk_dr", real=True)


@claim(
    "X3.2-13",
    "At a fixed point with the coordinates (u, v) in the affine frame at r the osculating conic F = u² + "
    "kv² − 2v changes by dF/dr = (dk/dr) v². So the osculating conics of an affine spiral, however long, "
    "are disjoint.",
    method=Method.PROOF,
    form="dk_dr*v^2",
    wrong=("-dk_dr*v^2", "dk_dr*u^2", "dk_dr*v", "k*v^2", "2*dk_dr*v^2"),
)
def nested(form: str) -> Evidence:
    """The fixed point γ + uγ′ + vγ″ has u′ = kv − 1 and v′ = −u, from γ‴ = −kγ′.

    v is 0 at isolated r only: v = u = 0 gives u′ = −1. So F is strictly monotone in r at every point of the
    plane, and 0 for one r at most: no point lies on two osculating conics.
    """
    # 0 = γ′ + u′γ′ + uγ″ + v′γ″ + vγ‴ along γ′ and γ″
    du, dv = sp.symbols("du dv", real=True)
    motion = sp.solve([1 + du - K * V, U + dv], [du, dv])
    conic = U**2 + K * V**2 - 2 * V
    rate = sp.diff(conic, U) * motion[du] + sp.diff(conic, V) * motion[dv] + sp.diff(conic, K) * K1
    return vanishes(read(form, {"u": U, "v": V, "k": K, "dk_dr": K1}) - rate, "dF/dr")


@claim(
    "X3.2-14",
    "An osculating conic of an affine spiral, however long, meets it at its own point only, with five-fold "
    "contact, and crosses it there.",
    method=Method.PROOF,
    form="5",
    wrong=("3", "4", "6"),
)
def meets_once(form: str) -> Evidence:
    """By X3.2-13 the equation F_r of the conic at r, at γ(s), is strictly monotone in r and 0 for r = s.

    So F_r(γ(s)) ≠ 0 for r ≠ s, with opposite signs for r < s and r > s. The order of contact is that of F
    along the canonical form y = x²/2 + k x⁴/8 + …: the power of the first term, which is odd.
    """
    _, *jet = sp.ring(sp.symbols("k0:4"), sp.QQ)
    y, _ = affine_graph(6, tuple(jet))
    x = sp.Symbol("x")
    graph = sum(c.as_expr() * x**i for i, c in enumerate(y.coefficients))
    along = sp.expand(x**2 + sp.Symbol("k0") * graph**2 - 2 * graph)
    order = next(n for n in range(7) if sp.expand(along.coeff(x, n)) != 0)
    first = sp.factor(along.coeff(x, order))
    line = f"F along the curve begins with {first}·x^{order}"
    odd = Evidence(integer(read(form, {})) == order and order % 2 == 1, (line,))
    return nested("dk_dr*v^2") & odd


@claim(
    "X3.2-15",
    "A bitangent conic meets a strictly convex affine spiral arc at most once inside, then simply, so that "
    "the displacement changes its sign there; it then has another curvature than the arc at both ends.",
    method=Method.PROOF,
    given=("R3.2-2",),
    form="1",
    wrong=("0", "2", "3"),
)
def meets_once_inside(form: str) -> Evidence:
    """Of the five zeros that R3.2-2 leaves, the ends take two each.

    With equal curvature an end takes three, and together with a zero inside that is six. One is possible: the
    member of the pencil through an inner point. At the ends dk/dr = 0, an inflection or a cusp is allowed: no
    end is counted more than twice.
    """
    most, each = 5, 2  # R3.2-2; a tangent end
    inside = most - 2 * each
    line = (
        f"{most} zeros less {each} at either end: {inside} inside; with a triple one at an end {inside - 1}"
    )
    return Evidence(integer(read(form, {})) == inside, (line,))


@claim(
    "X3.2-16",
    "Five places on a strictly convex affine spiral arc, confluent or not, determine one conic, which "
    "depends continuously on them.",
    method=Method.PROOF,
    given=("R3.2-2",),
    form="5",
    wrong=("4", "6"),
)
def determined(form: str) -> Evidence:
    """The form is the number of places at which the conditions on six coefficients are independent.

    If two conics F, G met the arc at the five places, then at a sixth F + λG would vanish for some λ: six
    zeros, against R3.2-2. So the five rows of divided differences are independent (Lemma 3.2.4), and their
    cofactors, the coefficients, are continuous. Five rows of a 5 × 6 matrix leave one solution; four leave a
    pencil, and six rows no conic at all.
    """
    places = integer(read(form, {}))
    x = sp.Symbol("x", real=True)
    graph = x**2 / 2 + x**5 / 400
    image = (x**2, x * graph, graph**2, x, graph, sp.S.One)
    at = [sp.Rational(n, 7) for n in (-6, -3, -1, 2, 4, 6)][: max(places, 0)]
    matrix: Any = sp.Matrix([[e.subs(x, t) for e in image] for t in at])
    left = 6 - matrix.rank()
    line = f"{places} places of y = x²/2 + x⁵/400 leave conics of a linear space of dimension {left}"
    return Evidence(left == 1, (line,))
