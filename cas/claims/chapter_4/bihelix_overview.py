"""Errata of section 4.1: what its overview says of near-optimal bihelices, against the derived series."""

from __future__ import annotations

import sympy as sp

from osculant.cas.claims.chapter_4.bihelix_peaks import h, kappa1, left_peak, sigma, spiral, v
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes


@claim(
    "section 4.1-1",
    "The near-optimal junction tangent (its components along T and N) is a unit vector that leans by "
    "f′(0) = −κ′σ²/24 to leading order.",
    method=Method.PROOF,
    form="1/sqrt(1 + (kappa1*sigma**2/24)**2), -kappa1*sigma**2/24/sqrt(1 + (kappa1*sigma**2/24)**2)",
    printed="1, -kappa1*sigma**2/24",
    wrong=(
        "1/sqrt(1 + (kappa1*sigma**2/12)**2), -kappa1*sigma**2/12/sqrt(1 + (kappa1*sigma**2/12)**2)",
        "1/sqrt(1 + (kappa1*sigma**2/24)**2), kappa1*sigma**2/24/sqrt(1 + (kappa1*sigma**2/24)**2)",
    ),
    erratum="Section 4.1.2 defines T* = T − κ′σ²N/24, which is not a unit vector: it must be normalised.",
)
def unit_junction_tangent(form: str) -> Evidence:
    """The length is computed; the slope N/T is compared with that of the derived junction tangent, to σ²."""
    along, across = read_tuple(form, {"kappa1": kappa1, "sigma": sigma}, 2)
    if along == 0:
        return Evidence(False, ("the tangent has no component along T",))
    unit = vanishes(along**2 + across**2 - 1, "squared length minus 1")
    tangent = spiral().junction()[1]
    derived = tangent[1][2].as_expr().subs(v, 0) * (sigma / 2) ** 2
    leading = sp.series(across / along, sigma, 0, 4).removeO()
    return unit & vanishes(leading - derived, "slope of the junction tangent")


@claim(
    "section 4.1-2",
    "A bihelix is optimal to leading order if its junction tangent deviates from the curve's at the middle "
    "by the normal component −κ′σ²/24.",
    method=Method.PROOF,
    form="-kappa1*sigma**2/24",
    printed="-kappa1/24",
    wrong=("-kappa1*sigma/24", "-kappa1*sigma**2/12"),
    erratum="The overview of section 4.1 prints the deviation of the junction tangent without the factor σ².",
)
def lean_of_junction_tangent(form: str) -> Evidence:
    """The normal component of the derived junction tangent for u = 0."""
    derived = spiral().junction()[1][1][2].as_expr().subs(v, 0) * (sigma / 2) ** 2
    return vanishes(
        derived - read(form, {"kappa1": kappa1, "sigma": sigma}), "normal component of T₀ − T(mid)"
    )


@claim(
    "section 4.1-3",
    "At the left end an optimal bihelix has more curvature than the curve, by κ′σ/6; the right end has less.",
    method=Method.PROOF,
    form="kappa1*sigma/6",
    printed="0",
    wrong=("kappa1*sigma/2", "-kappa1*sigma/6", "kappa1*sigma/3"),
    erratum="The overview of section 4.1 has the curvatures of curve and spline at common ends agree up to "
    "terms quadratic in the length; they differ by κ′σ/6, which is linear.",
)
def curvature_at_the_ends(form: str) -> Evidence:
    """The curvatures of the helices for u = 0 are κ ∓ κ′σ/3 to first order; the curve's are κ ∓ κ′σ/2."""
    claimed = read(form, {"kappa1": kappa1, "sigma": sigma})
    evidence = Evidence(True)
    for what, helix in (("left", spiral().left), ("right", spiral().right)):
        change = helix.curvature[1].as_expr().subs(v, 0) - helix.end * kappa1
        difference = change * sigma / 2 + helix.end * claimed
        evidence &= vanishes(difference, f"curvature of helix and curve at the {what} end")
    return evidence


@claim(
    "section 4.1-4",
    "A bihelix stays optimal to leading order if its junction is off the middle by o(σᵉ) along the curve, "
    "e = 1.",
    method=Method.PROOF,
    form="1",
    printed="4",
    wrong=("2", "3", "0", "0.9", "0.51"),
    erratum="The overview of section 4.1 calls a spline optimal only if its junction is within O(σ⁴) of the "
    "middle; along the curve o(σ) is enough (the equioscillating rule moves it by a multiple of σ²).",
)
def necessary_offset(form: str) -> Evidence:
    """An offset u = c·hᵖ means v = c·hᵖ⁻¹. The leading error over its least value is a function of v that is
    continuous with the value 1 at v = 0. So it must tend to 1 for p = e + δ with every δ > 0, where v = c·hᵗ
    must have t > 0; and it must not for p = e.
    """  # noqa: D205
    least, delta = read(form, {}), sp.Symbol("delta", positive=True)
    _, height = left_peak()
    ratio = sp.factor(height / height.subs(v, 0))
    power = sp.nsimplify(least) - 1 + delta
    smaller = vanishes(ratio.subs(v, 0) - 1, "relative error at v = 0, minus 1")
    enough = Evidence(bool(power.is_positive), (f"offsets h^(e + δ): v is a multiple of h^({power})",))
    at_least = sp.limit(ratio.subs(v, h ** (power - delta) / 2), h, 0)
    line = f"limit of the relative error for the offset h^e/2: {at_least}"
    return smaller & enough & Evidence(bool(at_least != 1), (line,))
