"""Claims beyond chapter 5: circles tangent to a spiral arc, which the proofs on its biarcs rest on.

κ > 0 increases along a strictly convex arc; A, B are the angles of its end tangents with the chord, of length
ℓ. A circle of curvature K tangent to the curve at γ(s) is f = K|z − γ|²/2 − [T, z − γ] = 0, with f < 0 to its
left.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_5.biarc_geometry import vogt
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integer, read, read_tuple, vanishes

A, B, L = sp.symbols("A B l", positive=True)
#: rates of the chord's angles and its length by arc length, as the end moves on and as the start does
END = ((A, sp.sin(B) / L), (L, sp.cos(B)))
START = ((B, -sp.sin(A) / L), (L, -sp.cos(A)))


def _rate(expression: Any, rates: tuple[tuple[Any, Any], ...]) -> Any:
    return sum(sp.diff(expression, symbol) * rate for symbol, rate in rates)


@claim(
    "X5.3-1",
    "The circle tangent to a curve at the start of an arc and through its end has the curvature K = 2 sin "
    "A/ℓ, and the one tangent at the end and through the start 2 sin B/ℓ. The first grows with the end by 2 "
    "sin(B − A)/ℓ², the second with the start by the same.",
    method=Method.PROOF,
    form="2*sin(B - A)/l^2, 2*sin(B - A)/l^2",
    wrong=(
        "2*sin(A - B)/l^2, 2*sin(B - A)/l^2",
        "2*sin(B - A)/l^2, -2*sin(B - A)/l^2",
        "sin(B - A)/l^2, sin(B - A)/l^2",
        "2*sin(B + A)/l^2, 2*sin(B + A)/l^2",
        "2*sin(B - A)/l, 2*sin(B - A)/l",
    ),
)
def tangent_circle_curvatures(form: str) -> Evidence:
    """As the end moves on, A′ = sin B/ℓ and ℓ′ = cos B; as the start does, B′ = −sin A/ℓ and ℓ′ = −cos A.

    That the circle is 2 sin A/ℓ is the theorem of the tangent and the chord: f = 0 at the end.
    """
    parts = read_tuple(form, {"A": A, "B": B, "l": L}, 2)
    curvature = sp.Symbol("K")
    on_it = sp.solve(curvature * L**2 / 2 - L * sp.sin(A), curvature)[0]
    found = vanishes(on_it - 2 * sp.sin(A) / L, "curvature of the circle through the end")
    for part, angle, rates in ((parts[0], A, END), (parts[1], B, START)):
        found &= vanishes(part - _rate(2 * sp.sin(angle) / L, rates), f"derivative of 2 sin {angle}/ℓ")
    return found


@claim(
    "X5.3-2",
    "A circle tangent to a strictly convex spiral arc at one of its ends meets it at most once more, and "
    "crosses it there.",
    method=Method.PROOF,
    given=("X3.2-2",),
    form="1",
    wrong=("0", "2"),
)
def meets_once_more(form: str) -> Evidence:
    """γ(u) is on the circle of curvature K tangent at the start exactly if K is that of X5.3-1 for [a, u].

    This K grows strictly with u: A < B on every sub-arc by Vogt (R5.3-6), both in (0, π) by X3.2-2, so 0 < B
    − A < π and the sine is positive. A strictly monotone function takes a value once at most; the form is
    that number: the zeros that the sine leaves on (0, π), and one by Rolle. On the circle f = ℓ²(K − K(u))/2,
    so γ(u) is to the right of the circle exactly if K(u) < K. At the end likewise.
    """
    found = tangent_circle_curvatures("2*sin(B - A)/l^2, 2*sin(B - A)/l^2") & vogt("cos(theta) + kappa*y")
    gap = sp.Symbol("gap", positive=True)
    inside = sp.solveset(sp.sin(gap), gap, sp.Interval.open(0, sp.pi))
    most = len(list(inside)) + 1
    line = f"zeros of sin(B − A) for 0 < B − A < π: {most - 1}; a curvature is taken {most} time at most"
    return found & Evidence(integer(read(form, {})) == most, (line,))


@claim(
    "X5.3-3",
    "A circle of curvature K(s) tangent to the curve at γ(s) moves to the left with the velocity "
    "∂f/∂s = K′ϱ²/2 + (κ − K)⟨T, z − γ⟩, ϱ = |z − γ|, at a point z of it, as |∇f| = 1 there.",
    method=Method.PROOF,
    form="K1*rho^2/2 + (kappa - K)*along",
    wrong=(
        "K1*rho^2/2 - (kappa - K)*along",
        "K1*rho^2 + (kappa - K)*along",
        "K1*rho^2/2 + (kappa + K)*along",
        "K1*rho^2/2 + (K - kappa)*across",
    ),
)
def circle_velocity(form: str) -> Evidence:
    """∂f/∂s for fixed z = (zx, zy), with γ′ = T, T′ = κN; and |∇f|² = 1 + 2Kf."""
    s = sp.Symbol("s", real=True)
    zx, zy, kappa = sp.symbols("zx zy kappa", real=True)
    gx, gy, angle, curvature = (sp.Function(name)(s) for name in ("gx", "gy", "theta", "K"))
    dx, dy = zx - gx, zy - gy
    along, across = sp.cos(angle) * dx + sp.sin(angle) * dy, sp.cos(angle) * dy - sp.sin(angle) * dx
    f = curvature * (dx**2 + dy**2) / 2 - across
    motion = {angle.diff(s): kappa, gx.diff(s): sp.cos(angle), gy.diff(s): sp.sin(angle)}
    rate = sp.diff(f, s).subs(motion)
    names = {"K": curvature, "K1": curvature.diff(s), "kappa": kappa, "along": along, "across": across}
    claimed = read(form, {**names, "rho": sp.sqrt(dx**2 + dy**2)})
    gradient = sp.diff(f, zx) ** 2 + sp.diff(f, zy) ** 2
    return vanishes(claimed - rate, "∂f/∂s") & vanishes(gradient - 1 - 2 * curvature * f, "|∇f|² − 1 − 2Kf")


@claim(
    "X5.3-4",
    "If a circle tangent at γ(s) moves with s, its velocity at the point with the chord angle α behind γ(s) "
    "is ℓ(K′ sin α/K − (κ − K) cos α), ℓ the chord: for K > 0 and κ ≠ K it has one zero for 0 < α < π, and "
    "near γ(s) the sign of K − κ.",
    method=Method.PROOF,
    form="l*(K1*sin(alpha)/K - (kappa - K)*cos(alpha))",
    wrong=(
        "l*(K1*sin(alpha)/K + (kappa - K)*cos(alpha))",
        "l*(K1*cos(alpha)/K - (kappa - K)*sin(alpha))",
        "l*(K1*sin(alpha) - (kappa - K)*cos(alpha))",
        "-l*(K1*sin(alpha)/K - (kappa - K)*cos(alpha))",
    ),
)
def velocity_behind(form: str) -> Evidence:
    """X5.3-3 with ϱ = ℓ = 2 sin α/K and ⟨T, z − γ⟩ = −ℓ cos α.

    It is ℓ times a combination of sin α and cos α, so ℓ sin α times a strictly monotone function of cot α,
    which takes all values on (0, π): one zero. At α = 0 the combination is K − κ.
    """
    alpha, kappa, curvature, slope = sp.symbols("alpha kappa K K1", positive=True)
    chord = 2 * sp.sin(alpha) / curvature
    derived = slope * chord**2 / 2 - (kappa - curvature) * chord * sp.cos(alpha)
    names = {"alpha": alpha, "kappa": kappa, "K": curvature, "K1": slope, "l": chord}
    claimed, cot = read(form, names), sp.Symbol("cot")
    near = sp.limit(claimed / chord, alpha, 0) - (curvature - kappa)
    combination = sp.expand(sp.expand(derived / chord) / sp.sin(alpha)).subs(
        sp.cos(alpha), cot * sp.sin(alpha)
    )
    linear = sp.degree(sp.expand(sp.simplify(combination)), cot) == 1
    found = circle_velocity("K1*rho^2/2 + (kappa - K)*along")
    return (
        found
        & Evidence(bool(linear), ("over ℓ sin α it is linear in cot α",))
        & vanishes(claimed - derived, "velocity")
        & vanishes(near, "at α = 0, against K − κ")
    )
