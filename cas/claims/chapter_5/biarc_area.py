"""Areas between a short arc and its bitangent biarcs: what section 3.6.2 shows of conics, for biarcs."""

from __future__ import annotations

import sympy as sp

from osculant.cas.asymptotics.arc_splines import KAPPA, biarc, v, x
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.laws.arcs import arc_law

_k1 = KAPPA[1]
_sigma = sp.Symbol("sigma", positive=True)


def _moons(junction: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """∫f/(κ′h³) over x of a biarc before and after it crosses the curve, for 0 ≤ junction < 1/3.

    Positive and negative: the left arc does not cross, the right arc does where f has its simple zero.
    """
    left, right = (sp.factor(f.subs({_k1: 1, v: junction})) for _, _, f in biarc().pieces)
    crossing = next(r for r in sp.solve(right, x) if sp.simplify(r - 1) != 0)
    first = sp.integrate(sp.expand(left), (x, -1, junction)) + sp.integrate(
        sp.expand(right), (x, junction, crossing)
    )
    return sp.factor(first), sp.factor(sp.integrate(sp.expand(right), (x, crossing, 1)))


@claim(
    "X5.2-1",
    "The area between a short arc and its best bitangent biarc is |κ′|σ⁴/576 + O(σ⁵).",
    method=Method.PROOF,
    form="kappa1*sigma**4/576",
    wrong=("kappa1*sigma**4/288", "kappa1*sigma**3/576", "kappa1*sigma**4/1152"),
)
def biarc_area(form: str) -> Evidence:
    """Both moons of the junction in the middle, −κ′x(1 − |x|)²h⁴/6 integrated to 1, are κ′h⁴/72; h = σ/2.

    That this junction is the best is X5.2-3.
    """
    first, second = (abs(moon) * _k1 * (_sigma / 2) ** 4 for moon in _moons(sp.Integer(0)))
    law = arc_law("biarc", "area")
    claimed = read(form, {"kappa1": _k1, "sigma": _sigma})
    same = vanishes(first + second - law.constant * _k1 * _sigma**law.order, "both moons less the area's law")
    return same & vanishes(claimed - first - second, "area of the best biarc")


@claim(
    "X5.2-2",
    "The moons of a bitangent biarc with junction vh differ by (2/9)κ′vh⁴, to leading order: they are equal "
    "only for the junction in the middle.",
    method=Method.PROOF,
    form="2/9*v*kappa1",
    wrong=("1/9*v*kappa1", "2/9*v**2*kappa1", "2/9*(v - 1/10)*kappa1"),
)
def moons_differ(form: str) -> Evidence:
    """The signed area, ∫f over both arcs, for a symbolic v."""
    first, second = _moons(v)
    claimed = read(form, {"kappa1": _k1, "v": v})
    return vanishes(first + second - claimed / _k1, "signed area over κ′h⁴")


@claim(
    "X5.2-3",
    "Among bitangent biarcs the area is least for the junction v = 0 in the middle, to leading order: those "
    "of least area and of equal moons have the same law.",
    method=Method.PROOF,
    form="0",
    wrong=("1/10", "-1/3", "1/3"),
)
def least_area_junction(form: str) -> Evidence:
    """By v ≥ 0, since reflecting the arc changes v to −v; for v ≥ 1/3 there is one moon, of area 2κ′vh⁴/9.

    For less there are two, and the derivative of their sum has no zero for 0 < v ≤ 1/3, and the sign of v.
    It vanishes at v = 0, so junctions O(h) from there give areas a relative O(h²) apart.
    """
    left, right = (f for _, _, f in biarc().pieces)
    reflected = vanishes(
        left.subs({x: -x, v: -v}, simultaneous=True) + right, "the reflected arc's displacement"
    )
    first, second = _moons(v)
    slope = sp.cancel(sp.diff(first - second, v))
    inside = sp.Poly(sp.cancel(sp.numer(slope) / v), v)
    zeros = inside.count_roots(0, sp.Rational(1, 3))
    rises = slope.subs(v, sp.Rational(1, 4)) > 0
    lines = (f"d area/dv for 0 < v ≤ 1/3: {zeros} zeros, positive: {rises}",)
    one_moon = vanishes(second.subs(v, sp.Rational(1, 3)), "second moon at v = 1/3")
    growth = sp.cancel(sp.diff(first + second, v))
    alone = Evidence(bool(growth.is_positive), (f"beyond, the area of the one moon grows by {growth} v",))
    stated = vanishes(slope.subs(v, abs(read(form, {}))), f"derivative of the area at the junction {form}")
    return Evidence(bool(zeros == 0 and rises), lines) & reflected & one_moon & alone & stated
