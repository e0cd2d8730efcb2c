"""Claims of section 1.3.3: Ludwig's second term for inscribed polygons, and the remainders printed there."""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_1.polygon_totals import J, K, L, n, total
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.jets.canonical import affine_arc


@cache
def _segment_area() -> tuple[list[Any], Any]:
    """Coefficients of ℓ⁰ … ℓ⁶ in the area of a segment, and the k in them.

    Coefficients of ℓ⁰ … ℓ⁶ in the area between an arc of affine length ℓ about its middle and its chord,
    with k.
    """
    ell = sp.Symbol("ell", positive=True)
    symbols = sp.symbols("k0:5", real=True)
    _, *jet = sp.ring(symbols, sp.QQ)
    X, Y, _ = affine_arc(7, jet)
    # twice the area: ∫[γ, γ′]dr from −ℓ/2 to ℓ/2 minus [γ(−ℓ/2), γ(ℓ/2)], both even or odd in ℓ
    x = sum(c.as_expr() * ell**i for i, c in enumerate(X.coefficients))
    y = sum(c.as_expr() * ell**i for i, c in enumerate(Y.coefficients))
    sector = sp.integrate(sp.expand(x * sp.diff(y, ell) - y * sp.diff(x, ell)), ell)
    ends = [{ell: sign * ell / 2} for sign in (-1, 1)]
    twice = (
        sector.subs(ends[1])
        - sector.subs(ends[0])
        - (x.subs(ends[0]) * y.subs(ends[1]) - y.subs(ends[0]) * x.subs(ends[1]))
    )
    series = sp.Poly(sp.expand(twice / 2), ell)
    return [sp.factor(series.coeff_monomial(ell**i)) for i in range(7)], symbols[0]


def _ludwig() -> Any:
    """Both terms for n arcs of equal affine length λ/n: the k in the middle of each adds up to n·∫k dr/λ."""
    areas, k = _segment_area()
    return n * sum(c * (L / n) ** i for i, c in enumerate(areas)).subs(k, K / L)


@claim(
    "section 1.3.3-2",
    "Ludwig's second term for inscribed polygons: δ_S = λ³/(12n²) − (λ⁴/(2·5!))∫k dr/n⁴ + o(1/n⁴), λ "
    "the affine "
    "length of the closed curve.",
    method=Method.PROOF,
    form="lambda**3/(12*n**2) - lambda**4*K/(240*n**4)",
    wrong=(
        "lambda/(12*n**2) - lambda**4*K/(240*n**4)",
        "lambda**3/(12*n**2) - lambda**4*K/(120*n**4)",
        "lambda**3/(12*n**2) + lambda**4*K/(240*n**4)",
    ),
)
def ludwig_inscribed(form: str) -> Evidence:
    """The area of a segment from the canonical form, summed over n arcs.

    The segment over an arc of affine length ℓ about a point with affine curvature k has area ℓ³/12 − kℓ⁵/240
    + O(ℓ⁷), from the canonical form. For n arcs of length λ/n the first terms add up to λ³/12n², the second
    ones to (λ/n)⁴/240 times a midpoint sum of ∫k dr, which is K up to O(n⁻²). Moving the knots from equal
    affine length by the O(n⁻³) that the best polygon asks for changes the sum of the cubes in second order
    only.
    """
    areas, _ = _segment_area()
    rest = [c for i, c in enumerate(areas) if i % 2 == 0]
    claimed = read(form, {"lambda": L, "K": K, "n": n})
    evidence = vanishes(sum(abs(c) for c in rest), "even orders of the segment's area")
    return evidence & vanishes(claimed - _ludwig(), "two terms of the area")


@claim(
    "section 1.3.3-2.1",
    "The remainder of Ludwig's expansion is smaller than its second term: o(1/n⁴), and O(1/n⁶) for a "
    "smooth curve.",
    method=Method.EXACT,
    form="6",
    printed="4",
    erratum="Ludwig's expansion is printed with remainder O(1/n⁴), which would swallow its second term: it "
    "is "
    "o(1/n⁴).",
    wrong=("5",),
)
def ludwig_remainder(form: str) -> Evidence:
    """On the unit circle the best inscribed polygon is regular.

    On the unit circle the best inscribed polygon is regular, with area (n/2)sin(2π/n): the difference π −
    (n/2)sin(2π/n), as a series in 1/n, minus both terms (λ = 2π, ∫k dr = 2π). The form is the first power of
    1/n that is left.
    """
    u = sp.Symbol("u", positive=True)  # 1/n
    terms = _ludwig()
    exact = sp.pi - sp.series(sp.sin(2 * sp.pi * u), u, 0, 10).removeO() / (2 * u)
    rest = sp.Poly(sp.expand(exact - terms.subs({L: 2 * sp.pi, K: 2 * sp.pi, n: 1 / u})), u)
    lowest = min(m[0] for m in rest.monoms())
    first = rest.coeff_monomial(u**lowest)
    return vanishes(read(form, {}) - lowest, f"first power left on the circle, with coefficient {first}")


@claim(
    "section 1.3.3-2.2",
    "Gruber's expansion δ_S = c/n^(2/(d−1)) has a remainder that tends to 0 faster; for d = 2 it is O(1/n⁴).",
    method=Method.EXACT,
    form="4",
    printed="0",
    erratum="Gruber's asymptotic formulas for polytopes are printed with remainder O(1), which exceeds their "
    "only "
    "term: it is o(n^(−2/(d−1))), for d = 3 o(1/n).",
    wrong=("2", "3"),
)
def gruber_remainder(form: str) -> Evidence:
    """On the unit circle: π − (n/2)sin(2π/n) minus λ³/12n², λ = 2π.

    The form is the first power of 1/n left.
    """
    u = sp.Symbol("u", positive=True)  # 1/n
    exact = sp.pi - sp.series(sp.sin(2 * sp.pi * u), u, 0, 10).removeO() / (2 * u)
    first = total("polygon", "area").subs({J: 2 * sp.pi, n: 1 / u})
    lowest = min(m[0] for m in sp.Poly(sp.expand(exact - first), u).monoms())
    return vanishes(read(form, {}) - lowest, "first power left on the circle")
