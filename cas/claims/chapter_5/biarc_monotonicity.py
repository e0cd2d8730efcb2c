"""Theorem B beyond chapter 5: the error of the best biarc grows with its spiral arc."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from osculant.cas.claims.chapter_5.spiral_samples import ELLIPSE, SPIRALS
from osculant.cas.claims.chapter_5.tangent_circles import circle_velocity, velocity_behind
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError

#: ends of sub-arcs and a fixed crossing, in parts of the whole arc; sub-arcs, each within the next
ENDS, CROSSINGS = ("0.6", "0.8", "1"), ("0.2", "0.4")
NESTED = (("0.3", "0.6"), ("0.2", "0.6"), ("0.2", "0.8"), ("0.05", "0.9"), ("0", "1"))
#: arcs of the ellipse from −1 across its vertex, the longer with the smaller error
FALLS = ("-1", "0.2", "0.3")


def _monotone(form: str) -> bool:
    """Whether arcs with monotone curvature are meant; raises DomainError for an unknown hypothesis."""
    if form not in {"kappa monotone", "kappa > 0"}:
        raise DomainError(f"The hypothesis {form!r} is unknown: use 'kappa monotone' or 'kappa > 0'.")
    return form == "kappa monotone"


def _falling() -> Evidence:
    """That the error grows across the vertex of the ellipse as well: it does not."""
    with mp.workdps(15):
        start, *ends = (mp.mpf(t) for t in FALLS)
        errors = [ELLIPSE.least(start, end) for end in ends]
    shown = " and ".join(mp.nstr(e, 5) for e in errors)
    line = f"(2 cos t, sin t) from −1 to {FALLS[1]} and {FALLS[2]}: errors {shown}"
    return Evidence(bool(errors[0] < errors[1]), (line,))


@claim(
    "X5.3-5",
    "On a strictly convex arc with monotone κ a biarc that keeps its start and its crossing with the arc "
    "moves away from the arc as the end moves on: |d| falls nowhere and grows strictly along the second "
    "arc; the first arc stays if the crossing is on it.",
    method=Method.PROOF,
    given=("R5.3-7", "R5.3-8"),
    form="kappa monotone",
    wrong=("kappa > 0",),
)
def fixed_crossing(form: str) -> Evidence:
    """Let κ increase. The crossing γ(c) makes d > 0 before it and d < 0 beyond, and K₁ > κ(a) ≥ 0, K₂ < κ(s).

    If c is on the first arc this one stays, as the circle tangent at the start through γ(c) is one only. The
    second arc stays tangent to it, so its velocity at the junction is 0. If c is on the second arc, the
    velocity is 0 at γ(c). By X5.3-4, with K₂ > K₁ > 0, it has no other zero behind γ(s), and near γ(s) the
    sign of K₂ − κ(s) < 0: beyond the junction or γ(c) the biarc moves to the right, where d < 0. Between the
    junction and γ(c) it moves to the left, where d > 0, and with it the first arc, by ½|z − p|²K₁′ with the
    same sign at the junction (X5.3-3).

    If κ decreases every inequality is reversed: d from − to +, K₂ > κ(s) ≥ 0, the velocity near γ(s)
    positive; the zero is the same one. X5.3-3 and X5.3-4 are proved again here, and |d| is followed on
    spirals of both kinds.
    """
    if not _monotone(form):
        return _falling()
    found = circle_velocity("K1*rho^2/2 + (kappa - K)*along")
    found &= velocity_behind("l*(K1*sin(alpha)/K - (kappa - K)*cos(alpha))")
    with mp.workdps(15):
        for name, (curve, low, high) in SPIRALS.items():
            a, width, grows = mp.mpf(low), mp.mpf(high) - mp.mpf(low), True
            places = [a + width * mp.mpf(ENDS[0]) * i / 8 for i in range(1, 8)]
            for part in CROSSINGS:
                members = [
                    curve.through(a, a + width * mp.mpf(end), a + width * mp.mpf(part)) for end in ENDS
                ]
                seen = [[abs(b.displacement(*curve.frame(t))) for t in places] for b in members]
                for one, following in pairwise(seen):
                    grows &= all(x <= y * (1 + mp.mpf(10) ** -9) for x, y in zip(one, following))
                    grows &= bool(one[-1] < following[-1])
            line = (
                f"{name}, {len(CROSSINGS)} crossings, {len(ENDS)} ends: |d| {'grows' if grows else 'falls'}"
            )
            found &= Evidence(grows, (line,))
    return found


@claim(
    "X5.3-6",
    "Let h = ⟨γ − P, T⟩ for a point P and the direction φ of T: h″ + h = −κ′/κ³ by φ. So a circle tangent "
    "to a spiral arc at its start has at most one more common normal with it before the arc has turned by π.",
    method=Method.PROOF,
    form="-kappa1/kappa^3",
    wrong=("kappa1/kappa^3", "-kappa1/kappa^2", "-kappa/kappa1^3", "-kappa1/(2*kappa^3)"),
)
def common_normals(form: str) -> Evidence:
    """P is the centre, and h = 0 where the normals are common. By arc length γ′ = T, T′ = κN, φ′ = κ.

    With h = 0 at φ = 0, the start, w = h′ sin φ − h cos φ is 0 there and has the derivative (h″ + h) sin φ,
    of one sign for 0 < φ < π. So h/ sin φ is strictly monotone, as its derivative is w/ sin² φ: one zero at
    most.
    """
    theta, kappa, kappa1, x, y = sp.symbols("theta kappa kappa1 x y", real=True)
    rates = ((theta, kappa), (kappa, kappa1), (x, sp.cos(theta)), (y, sp.sin(theta)))

    def by_direction(expression: Any) -> Any:
        return sum(sp.diff(expression, symbol) * rate for symbol, rate in rates) / kappa

    h = x * sp.cos(theta) + y * sp.sin(theta)
    twice = by_direction(by_direction(h)) + h
    phi = sp.Symbol("phi", real=True)
    general = sp.Function("h")(phi)
    w = general.diff(phi) * sp.sin(phi) - general * sp.cos(phi)
    slope = w.diff(phi) - (general.diff(phi, 2) + general) * sp.sin(phi)
    quotient = (general / sp.sin(phi)).diff(phi) - w / sp.sin(phi) ** 2
    claimed = read(form, {"kappa": kappa, "kappa1": kappa1})
    return (
        vanishes(claimed - twice, "h″ + h")
        & vanishes(slope, "w′ against (h″ + h) sin φ")
        & vanishes(quotient, "(h/ sin φ)′ against w/ sin² φ")
    )


@claim(
    "X5.3-7",
    "The least distance of a biarc from a strictly convex arc with monotone κ is not greater for a sub-arc, "
    "whichever end is moved, and less if the arc turns by at most π; d is the first hit of the normal on "
    "the side where the biarc lies.",
    method=Method.PROOF,
    given=("X5.3-5", "R5.3-9"),
    form="kappa monotone",
    wrong=("kappa > 0",),
)
def biarc_monotone(form: str) -> Evidence:
    """Theorem B. Let L(s) be the least largest |d| for the end s: it is attained by a member with a crossing.

    Let c be the crossing of the best member for the end z, and c < y < z. By X5.3-5 the member through γ(c)
    for the end y has largest |d| ≤ L(z), so L(y) ≤ L(z). If L were not increasing, L(s) > L(s′) for some s <
    s′, the continuous L would have its least value on [s, s′] first at some z > s, and the same value before:
    a contradiction.

    It is strict if the arc turns by at most π: let c be on it, so that it stays. Beyond c it has no common
    normal with the curve, as there is one between the start and c already (X5.3-6). So the largest |d| beyond
    c is on the second arc, and less for y than for z. Then either the member for y does not equioscillate,
    and a better one exists (R5.3-9), or both its lobes are less. For longer arcs strict growth is open;
    counts of pieces do not need it (X3.1-1).

    For the start: reverse and mirror the arc, which makes κ fall with the moving end instead of grow; X5.3-5
    and X5.3-6 have both cases. An inflection or a vertex at an end is allowed. Nested sub-arcs of spirals of
    both kinds agree; across a vertex the error falls.
    """
    if not _monotone(form):
        return _falling()
    found = common_normals("-kappa1/kappa^3")
    with mp.workdps(15):
        for name, (curve, low, high) in SPIRALS.items():
            a, width = mp.mpf(low), mp.mpf(high) - mp.mpf(low)
            errors: list[Any] = [curve.least(*(a + width * mp.mpf(end) for end in ends)) for ends in NESTED]
            line = f"{name}, nested sub-arcs: errors {', '.join(mp.nstr(e, 5) for e in errors)}"
            found &= Evidence(all(x < y for x, y in pairwise(errors)), (line,))
    return found
