"""Section 4.5 as reconstructed: what two arcs that meet tangentially can achieve; bihelices among them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import MOMENT
from osculant.cas.claims.proof import read_tuple, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bihelix_rules import (
    SpaceArc,
    equioscillating_bihelix,
    peaks,
    shifted_bihelix,
    thesis_bihelix,
)

#: half the arc is 1; x along it, v the junction; the derivative of the curvature
X, V = sp.symbols("x v", real=True)
SLOPE = sp.Symbol("kappa1", positive=True)


def _two_arcs() -> tuple[Any, Any]:
    """f on both sides of v with f″ = aᵢ − κ′x, f = f′ = 0 at ±1, and f, f′ continuous at v."""
    a = sp.symbols("a1 a2")
    sides = []
    for second, end in zip(a, (-1, 1), strict=True):
        first = sp.integrate(second - SLOPE * X, X)
        first -= first.subs(X, end)
        height = sp.integrate(sp.expand(first), X)
        sides.append(height - height.subs(X, end))
    gap = sides[0] - sides[1]
    (solution,) = sp.solve([gap.subs(X, V), sp.diff(gap, X).subs(X, V)], a, dict=True)
    left, right = (sp.factor(side.subs(solution)) for side in sides)
    return left, right


@claim(
    "R4.5-12",
    "Approximation theorem: let a spline of two smooth arcs join with a common tangent, touch the curve at "
    "both ends of an arc of length σ, and have curvature with derivative 0 there. Its Hausdorff distance is "
    "|κ′|σ³/324 at least, to leading order, and that only with the junction in the middle, where its "
    "tangent deviates by the normal component −κ′σ²/24.",
    method=Method.PROOF,
    form="kappa1*sigma^3/324, -kappa1*sigma^2/24",
    wrong=(
        "kappa1*sigma^3/324, kappa1*sigma^2/24",
        "kappa1*sigma^3/384, -kappa1*sigma^2/24",
        "kappa1*sigma^3/162, -kappa1*sigma^2/24",
        "kappa1*sigma^3/324, -kappa1*sigma^2/12",
    ),
)
def approximation_theorem(form: str) -> Evidence:
    """With half the arc as unit the normal component has f″ = aᵢ − κ′x on either side, to leading order.

    The curvature of each arc is constant up to the second order, as its derivative is 0 at the end. f = f′ =
    0 at ±1 and a common tangent at the junction v determine a₁, a₂. For v ≥ 0 the left arc has the peak p(v),
    found from f′ = 0, and p′ > 0: so the least is at v = 0, where both peaks have the same size. (The
    binormal component can be of higher order.) It is a bound to leading order only. A helix or circular arc
    has constant curvature, so bihelices and biarcs are among these splines, and reach it (section 4.1-2,
    R5.2-3).
    """
    sigma = sp.Symbol("sigma", positive=True)
    least, lean = read_tuple(form, {"kappa1": SLOPE, "sigma": sigma}, 2)
    left, right = _two_arcs()
    inner = [z for z in sp.solve(sp.diff(left, X), X) if sp.simplify(z + 1) != 0]
    peak = sp.factor(left.subs(X, inner[0]))
    w = sp.Symbol("w", positive=True)
    growth = sp.fraction(sp.factor(sp.diff(sp.log(peak**2), V).subs(V, w)))
    signs = [all(c > 0 for c in sp.Poly(sp.expand(part), w).coeffs()) for part in growth]
    opposite = [all(c < 0 for c in sp.Poly(sp.expand(part), w).coeffs()) for part in growth]
    grows = signs == [True, True] or opposite == [True, True]
    line = f"peak of the left arc {peak}: it grows with v > 0: {grows}"
    found = len(inner) == 1 and grows
    half = sigma / 2
    return (
        Evidence(bool(found), (line,))
        & vanishes(left.subs(X, -X).subs(V, -V) + right, "f is odd under reflection")
        & vanishes(sp.Abs(peak.subs(V, 0)) * half**3 - least, "least peak")
        & vanishes(sp.diff(left, X).subs({X: V}).subs(V, 0) * half**2 - lean, "f′ at the junction")
    )


#: an arc of the moment curve, offsets of the junction from that of equal peaks in parts of the arc
ARC, OFFSETS = ("1", "1.25"), ("-0.04", "-0.01", "0.01", "0.04")


@claim(
    "R4.6-6",
    "Of the bihelices of an arc whose junction is shifted along the curve the one with equal peaks has the "
    "least error. Whether a bihelix that is best among all exists, is unique and has equal peaks is open.",
    method=Method.NUMERICAL,
    form="equal peaks",
    wrong=("nearest to the middle", "nearest to the curve"),
    reason="no theorem is known: R4.5-12 bounds the error to leading order only, the family of all "
    "bihelices of an arc has three parameters, and on long arcs the error does not even grow "
    "(R4.6-3).",
    open=True,
)
def best_bihelix(form: str) -> Evidence:
    """Errors of the member the form names and of neighbours, on [1, 5/4] of the moment curve."""
    arc = SpaceArc(parse_tuple(MOMENT), *(mp.mpf(end) for end in ARC))
    choices: dict[str, Callable[[], Any]] = {
        "equal peaks": lambda: equioscillating_bihelix(arc),
        "nearest to the middle": lambda: thesis_bihelix(arc),
        "nearest to the curve": lambda: shifted_bihelix(arc, mp.mpf(0)),
    }
    if form not in choices:
        raise DomainError(f"The rule {form!r} is unknown: use one of {', '.join(choices)}.")
    errors = {name: max(peaks(arc, rule())) for name, rule in choices.items()}
    shifted = [max(peaks(arc, shifted_bihelix(arc, arc.sigma * mp.mpf(part)))) for part in OFFSETS]
    least = min(*errors.values(), *shifted)
    line = f"{form}: error {mp.nstr(errors[form], 6)}; least of all tried: {mp.nstr(least, 6)}"
    return Evidence(bool(errors[form] <= least), (line,))
