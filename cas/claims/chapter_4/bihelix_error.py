"""Claims of sections 4.1 and 4.5, reconstructed: the error of a bihelix, from the true contact conditions."""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.asymptotics.bihelix_series import bihelix_series
from osculant.cas.claims.chapter_4.bihelix_peaks import (
    K2,
    TAU,
    TAU1,
    TAU_L,
    TAU_R,
    TWIST,
    K,
    V,
    X,
    h,
    kappa,
    kappa1,
    kappa2,
    left_peak,
    normal_part,
    sigma,
    spiral,
    tau,
    tau1,
    v,
    x,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes


@claim(
    "R4.5-1",
    "Along a short arc the normal component f of the error of a bihelix has f = f′ = 0 at both ends, and "
    "f″ = aᵢ − κ′s on either side of the junction: f‴ = −κ′ to leading order.",
    method=Method.PROOF,
    form="-kappa1",
    wrong=("kappa1", "-kappa1/2", "-2*kappa1"),
)
def third_derivative(form: str) -> Evidence:
    """The contact conditions of two helices with a generic curve, tangent at both ends and to each other, are
    solved as power series in h = σ/2; f is h³ times a cubic in x = s/h on each side.
    """  # noqa: D205
    claimed = read(form, {"kappa1": kappa1})
    evidence = Evidence(True)
    for side, end in (("left", -1), ("right", 1)):
        f = normal_part(side)
        at_end = f.subs(x, end), sp.diff(f, x).subs(x, end)
        evidence &= vanishes(sp.diff(f, x, 3) - claimed, f"f‴ on the {side} of the junction")
        evidence &= vanishes(at_end[0] ** 2 + at_end[1] ** 2, f"f and f′ at the {side} end")
    return evidence


@claim(
    "R4.5-2",
    "At the junction, at the offset u from the middle, the error's normal component has the slope "
    "f′(u) = −κ′(h²/6 + u²/2).",
    method=Method.PROOF,
    form="-kappa1*(h**2/6 + u**2/2)",
    wrong=("-kappa1*(h**2/3 + u**2/2)", "-kappa1*h**2/6", "kappa1*(h**2/6 + u**2/2)"),
)
def slope_at_junction(form: str) -> Evidence:
    """From both sides: the derivative of h³f₃(s/h) at s = u = vh."""
    claimed = read(form, {"kappa1": kappa1, "h": h, "u": v * h})
    evidence = Evidence(True)
    for side in ("left", "right"):
        slope = h**2 * sp.diff(normal_part(side), x).subs(x, v)
        evidence &= vanishes(slope - claimed, f"f′(u) from the {side}")
    return evidence


@claim(
    "R4.5-3",
    "The largest normal error is (2/81)κ′h³(1 + 2u/(h+u))³ for an offset 0 ≤ u < h and κ′ > 0; the other "
    "signs follow by symmetry.",
    method=Method.PROOF,
    form="2/81*kappa1*h**3*(1 + 2*u/(h+u))**3",
    wrong=(
        "2/81*kappa1*h**3*(1 + u/(h+u))**3",
        "1/81*kappa1*h**3*(1 + 2*u/(h+u))**3",
        "2/81*kappa1*h**3*(1 + 2*u/h)**3",
    ),
)
def largest_error(form: str) -> Evidence:
    """The left cubic has a double zero at −h and its peak at −h + (2/3)h(h+3u)/(h+u) ≤ u, since there
    h²/3 + u² ≥ 0 remains. The right lobe is the left one with −u for u: its peak is lower, as
    (h+3u)² (h−u)² − (h−3u)² (h+u)² = 8hu(h² − 3u²), and for u > h/3 it has no inner peak at all.
    """  # noqa: D205
    peak, height = left_peak()
    claimed = read(form, {"kappa1": kappa1, "h": h, "u": v * h})
    evidence = vanishes(h**3 * height - claimed, "height of the left peak")
    room = sp.factor((v - peak) * (1 + v))
    evidence &= vanishes(room - (sp.Rational(1, 3) + v**2), "room between the left peak and the junction")
    mirrored = vanishes(
        normal_part("right") + normal_part("left").subs({v: -v, x: -x}, simultaneous=True), "f on the right"
    )
    lower = (1 + 3 * v) ** 2 * (1 - v) ** 2 - (1 - 3 * v) ** 2 * (1 + v) ** 2
    evidence &= mirrored & vanishes(lower - 8 * v * (1 - 3 * v**2), "left peak above the right one")
    # for u < h/3 this is positive; beyond, the right zero 2hu/(h−u) and so the lobe lie outside
    zero = [root for root in sp.solve(normal_part("right"), x) if root != 1]
    return evidence & vanishes(zero[0] - 2 * v / (1 - v), "zero of f on the right")


@claim(
    "R4.5-4",
    "The bound of the approximation theorem: the largest normal error is least for u = 0, where it is "
    "κ′σ³/324 (κ′ > 0).",
    method=Method.PROOF,
    form="kappa1*sigma**3/324",
    wrong=("kappa1*sigma**3/162", "kappa1*sigma**3/648", "kappa1*sigma**3/384", "kappa1*sigma**2/324"),
)
def lower_bound(form: str) -> Evidence:
    """The height H as a function of v has H′/H = 6/((1 + v)(1 + 3v)) > 0: it grows with v ≥ 0.
    The distance is at least |f|, and both differ by the binormal part only, which R4.5-6 makes vanish.
    """  # noqa: D205
    _, height = left_peak()
    growth = sp.factor(sp.diff(height, v) / height)
    increasing = vanishes(growth * (1 + v) * (1 + 3 * v) - 6, "relative growth of the height with v")
    claimed = read(form, {"kappa1": kappa1, "sigma": sigma})
    return increasing & vanishes((sigma / 2) ** 3 * height.subs(v, 0) - claimed, "height for u = 0")


@claim(
    "R4.5-5",
    "For the best junction the error peaks at the arc lengths σ/3 and 2σ/3.",
    method=Method.PROOF,
    form="sigma/3, 2*sigma/3",
    wrong=("sigma/4, 3*sigma/4", "sigma/6, 5*sigma/6", "sigma/3, sigma/2"),
)
def positions_of_peaks(form: str) -> Evidence:
    """The zeros of f′ other than the ends, for u = 0, counted from the left end: s = (1 + x)σ/2."""
    claimed = read_tuple(form, {"sigma": sigma}, 2)
    evidence = Evidence(True)
    for side, end, place in zip(("left", "right"), (-1, 1), claimed, strict=True):
        f = normal_part(side).subs(v, 0)
        (peak,) = [root for root in sp.solve(sp.diff(f, x), x) if root != end]
        evidence &= vanishes((1 + peak) * sigma / 2 - place, f"peak on the {side}")
    return evidence


@claim(
    "R4.5-6",
    "The binormal component of the error is of higher order than h³, for every offset, if both helices have "
    "the curve's torsion at the middle.",
    method=Method.PROOF,
    form="tau, tau",
    wrong=("-tau, -tau", "0, 0", "tau, 0"),
)
def binormal_part(form: str) -> Evidence:
    """The coefficient of h³ in g, for generic torsions, at the claimed ones; f does not depend on them."""
    left, right = read_tuple(form, {"tau": tau}, 2)
    torsions = {TAU_L.as_expr(): left, TAU_R.as_expr(): right}
    evidence = Evidence(True)
    for side in ("left", "right"):
        f, g = (part[3].as_expr() for part in spiral().displacement(side, X))
        evidence &= vanishes(g.subs(torsions), f"binormal component on the {side}")
        evidence &= Evidence(not f.free_symbols & set(torsions), ("f is free of both torsions",))
    return evidence


@claim(
    "R4.5-7",
    "Where κ′ = 0 (a vertex) the largest normal error is κ″σ⁴/384 (κ″ > 0), whatever the offset.",
    method=Method.PROOF,
    form="kappa2*sigma**4/384",
    wrong=("kappa2*sigma**4/324", "kappa2*sigma**4/192", "kappa2*sigma**4/768"),
)
def vertex(form: str) -> Evidence:
    """With κ′ = 0 the coefficient of h⁴ is −(κ″/24)(1 − x²)² on both sides, with its peak in the middle."""
    evidence = Evidence(True)
    series = bihelix_series([K, K * 0, K2], [TAU, TAU1], ([TAU], [TAU]), [V], order=4)
    for side in ("left", "right"):
        f = series.displacement(side, X)[0]
        evidence &= vanishes(f[3].as_expr(), f"h³ on the {side}")
        evidence &= vanishes(f[4].as_expr() + kappa2 * (1 - x**2) ** 2 / 24, f"h⁴ on the {side}")
    peak = (sigma / 2) ** 4 * abs(series.displacement("left", X)[0][4].as_expr().subs({x: 0, kappa2: 1}))
    return evidence & vanishes(
        kappa2 * peak - read(form, {"kappa2": kappa2, "sigma": sigma}), "largest error"
    )


@cache
def constant_curvature() -> tuple[Any, Any, Any]:
    """For constant κ, torsions τ ± twist·h and the offset vh³: leading terms (of h⁴) of what decides.

    Returns the normal component of the junction tangent, the binormal component of the junction point, and g
    on the left as a function of x. The twists make the tangent's binormal component vanish.
    """
    zero = K * 0
    twists = [TAU, TWIST], [TAU, -TWIST]
    series = bihelix_series([K], [TAU, TAU1], twists, [zero, zero, zero, V], order=5)
    point, tangent = series.junction("left")
    return tangent[1][4].as_expr(), point[2][4].as_expr(), series.displacement("left", X)[1][4].as_expr()


@claim(
    "R4.5-8",
    "Where κ is constant along the arc, the bihelix of the junction tangent T(mid) and the junction point "
    "nearest to the curve has the error κτ′σ⁴/6144 (τ′ > 0).",
    method=Method.PROOF,
    form="kappa*tau1*sigma**4/6144",
    wrong=("kappa*tau1*sigma**4/5760", "kappa*tau1*sigma**4/384", "tau1*sigma**4/6144"),
)
def constant_curvature_error(form: str) -> Evidence:
    """f is of order h⁵ here, so g decides. The point of the line nearest to the curve is off the curve along
    N alone: the binormal component of the junction is 0, which fixes the torsions. Then
    g = −(κτ′/24)x²(1 + x)² on the left, with its peak at x = −1/2, and its mirror image on the right.
    """  # noqa: D205
    _, binormal, g = constant_curvature()
    twist = TWIST.as_expr()
    (best,) = sp.solve(binormal, twist)
    found = sp.factor(g.subs(twist, best))
    shape = vanishes(found + kappa * tau1 * x**2 * (1 + x) ** 2 / 24, "g on the left")
    peak = -((sigma / 2) ** 4) * found.subs(x, -sp.Rational(1, 2))
    names = {"kappa": kappa, "tau1": tau1, "sigma": sigma}
    return shape & vanishes(peak - read(form, names), "largest error")


@claim(
    "R4.5-9",
    "Where κ is constant, the thesis's rule misses the curve at the junction itself, by "
    "κτ′σ⁴τ²/(2880(κ² + τ²)); for |τ| = κ that is κτ′σ⁴/5760.",
    method=Method.PROOF,
    form="kappa*tau1*sigma**4*tau**2/(2880*(kappa**2 + tau**2))",
    wrong=("kappa*tau1*sigma**4/5760", "kappa*tau1*sigma**4*tau**2/(5760*(kappa**2 + tau**2))", "0"),
)
def constant_curvature_thesis_rule(form: str) -> Evidence:
    """The junction line has the direction τT + κB to leading order. Two conditions fix twist and offset: the
    junction tangent has no normal component, and the junction point, off α(mid) by vh⁴T and by its binormal
    component, is the point of the line nearest to α(mid).
    """  # noqa: D205
    lean, binormal, _ = constant_curvature()
    nearest = tau * v + kappa * binormal
    (found,) = sp.solve([lean, nearest], [TWIST.as_expr(), v], dict=True)
    miss = sp.factor(binormal.subs(found)) * (sigma / 2) ** 4
    names = {"kappa": kappa, "tau": tau, "tau1": tau1, "sigma": sigma}
    return vanishes(miss - read(form, names), "binormal component of the junction")
