"""Claims on the geometry of biarcs, chapter 5 as reconstructed: junction circle, nested circles, Vogt.

A unit complex number's conjugate is its inverse, so statements on points and tangents are identities between
rational functions of p, q, z, …, their conjugates P, Q, Z, …, the tangents and exponentials of half angles.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, read_tuple, vanishes

_p, _q, _z, _P, _Q, _Z, _T, _rho = sp.symbols("p q z P Q Z T rho")
#: e^{iω/2}, e^{iμω/2}, e^{iδ}: half the turning, the junction's part of it, δ as in R5.3-4
_w, _m, _e = sp.symbols("w m e")
_omega = sp.Symbol("omega", real=True)


@claim(
    "R5.3-1",
    "The junctions of all biarcs with given ends and end tangents lie on the circle through p_L and p_R with "
    "centre (p_R − ρp_L)/(1 − ρ), ρ = T_R/T_L.",
    method=Method.PROOF,
    form="(q - rho*p)/(1 - rho)",
    wrong=("(q + rho*p)/(1 + rho)", "(p - rho*q)/(1 - rho)", "(q - rho*p)/(1 + rho)"),
)
def junction_circle_centre(form: str) -> Evidence:
    """An arc with chord d turns the tangent T into conj(T)d/conj(d).

    From both ends the junction's tangent is the same if ρd₁conj(d₂) = d₂conj(d₁), d₁ = z − p, d₂ = q − z.
    That is (1 − ρ) times the circle's equation |z − c|² = |p − c|².
    """
    condition = _rho * (_z - _p) * (_Q - _Z) - (_q - _z) * (_Z - _P)
    centre = read(form, {"p": _p, "q": _q, "rho": _rho})
    conjugate = centre.subs({_p: _P, _q: _Q, _rho: 1 / _rho}, simultaneous=True)
    circle = (_z - centre) * (_Z - conjugate) - (_p - centre) * (_P - conjugate)
    return vanishes(condition - (1 - _rho) * circle, "equal tangents against (1 − ρ)·circle")


@claim(
    "R5.3-1.1",
    "If the end tangents are equal the junctions lie on the line through p_L and p_R; for other "
    "tangents on no line.",
    method=Method.PROOF,
    form="1",
    wrong=("-1", "2"),
)
def junction_line(form: str) -> Evidence:
    """The form is the ρ at which the circle's equation becomes linear.

    The form is the ρ at which the condition of R5.3-1 loses its term z·conj(z); there it holds at both ends.
    """
    condition = sp.expand(_rho * (_z - _p) * (_Q - _Z) - (_q - _z) * (_Z - _P))
    value = read(form, {})
    square = condition.coeff(_z, 1).coeff(_Z, 1).subs(_rho, value)
    ends = [condition.subs(_rho, value).subs({_z: a, _Z: A}) for a, A in ((_p, _P), (_q, _Q))]
    return vanishes(square, "quadratic term") & vanishes(ends[0], "at p") & vanishes(ends[1], "at q")


@claim(
    "R5.3-2",
    "The junction circle meets T_L at p_L and T_R at p_R at equal angles.",
    method=Method.PROOF,
    form="rho",
    wrong=("1/rho", "-rho", "1"),
)
def equal_angles(form: str) -> Evidence:
    """Radii turn as tangents do.

    The circle's tangents are orthogonal to the radii, so they turn by (p_R − c)/(p_L − c) from one end to
    the other; the form is that ratio, and the curve's tangents turn by ρ.
    """
    centre = (_q - _rho * _p) / (1 - _rho)
    return vanishes(read(form, {"rho": _rho}) - (_q - centre) / (_p - centre), "ratio of the radii")


@claim(
    "R5.3-3",
    "The junction p₀ = c + (p_L − c)e^{iμω} has the junction tangent conj(T_L)d²/|d|², d = p₀ − p_L, "
    "and the second "
    "arc arrives with T_R.",
    method=Method.PROOF,
    form="d/(T*D)",
    wrong=("d*T/D", "D/(T*d)", "-d/(T*D)"),
)
def junction_family(form: str) -> Evidence:
    """conj(T) = 1/T, D = conj(d), so d²/|d|² = d/D.

    The arc from p₀ with the form's tangent to q must end with ρT, for every junction M = e^{iμω}.
    """
    M = sp.Symbol("M")
    centre, conjugate = (_q - _rho * _p) / (1 - _rho), (_Q - _P / _rho) / (1 - 1 / _rho)
    d, D = (centre - _p) * (1 - M), (conjugate - _P) * (1 - 1 / M)
    tangent = read(form, {"d": d, "D": D, "T": _T})
    second, conjugated = _q - _p - d, _Q - _P - D
    return vanishes(second / (tangent * conjugated) - _rho * _T, "tangent at p_R")


@claim(
    "R5.3-4",
    "Both curvatures of the biarcs of one family are monotone in μ, in the same direction: with A − "
    "B = 2δ the "
    "difference of the chord's angles, dK/dμ has the sign of −sin δ for both (turning 0 < ω < 2π).",
    method=Method.PROOF,
    form="-omega*S*D/s1**2, -omega*S*D/s2**2",
    wrong=(
        "-omega*S*D/s1**2, omega*S*D/s2**2",
        "omega*S*D/s1**2, omega*S*D/s2**2",
        "-omega*D/s1**2, -omega*D/s2**2",
    ),
)
def monotone_curvatures(form: str) -> Evidence:
    """Chord from 0 to 1, T_L = e^{−iA}, T_R = e^{iB}, ω = A + B, δ = (A − B)/2.

    The curvature of an arc with chord d is 2[T, d]/|d|². In the form S = sin(ω/2) > 0, s1 = sin(μω/2), s2 =
    sin((1 − μ)ω/2), D = sin δ.
    """
    T, rho = 1 / (_w * _e), _w**2
    centre = 1 / (1 - rho)
    d1, d2 = centre * (1 - _m**2), centre * (_m**2 - rho)
    junction = d1 / _conjugate(d1) / T
    derived = []
    for tangent, d in ((T, d1), (junction, d2)):
        bracket = (d / tangent - _conjugate(d) * tangent) / (2 * sp.I)
        curvature = sp.factor(2 * bracket / (d * _conjugate(d)))
        derived.append(sp.I * _omega / 2 * _m * sp.diff(curvature, _m))  # d/dμ: m = e^{iμω/2}
    sines = {"S": _sine(_w), "s1": _sine(_m), "s2": _sine(_w / _m), "D": _sine(_e), "omega": _omega}
    evidence = Evidence(True)
    for what, stated, found in zip(("first", "second"), read_tuple(form, sines, 2), derived, strict=True):
        evidence &= vanishes(stated - found, f"dK/dμ of the {what} arc")
    return evidence


def _sine(exponential: Any) -> Any:
    return (exponential - 1 / exponential) / (2 * sp.I)


def _conjugate(expression: Any) -> Any:
    """The conjugate of a rational function with real coefficients of unit complex numbers."""
    return expression.subs({_w: 1 / _w, _m: 1 / _m, _e: 1 / _e}, simultaneous=True)


@claim(
    "R5.3-5",
    "Kneser: the osculating circles of a spiral arc are nested. The centre moves along the normal "
    "with speed (1/κ)′, "
    "so that two centres are nearer than the difference of the radii.",
    method=Method.PROOF,
    form="-kappa1/kappa**2",
    wrong=("kappa1/kappa**2", "-kappa1/kappa", "-kappa1*kappa**2"),
)
def kneser(form: str) -> Evidence:
    """c = α + N/κ has c′ = T − κT/κ + (1/κ)′N.

    The evolute's length between two points is ∫|(1/κ)′| ds, for monotone κ the difference of the radii; N
    turns, so the chord between the centres is shorter: one circle lies in the other.
    """
    cosine, sine, kappa, kappa1 = sp.symbols("c s kappa kappa1", real=True)
    rates = ((cosine, -kappa * sine), (sine, kappa * cosine), (kappa, kappa1))  # by arc length

    def rate(expression: Any) -> Any:
        return sum(sp.diff(expression, symbol) * r for symbol, r in rates)

    centre = [T + rate(N / kappa) for T, N in ((cosine, -sine), (sine, cosine))]
    along = centre[0] * cosine + centre[1] * sine
    across = -centre[0] * sine + centre[1] * cosine
    claimed = read(form, {"kappa": kappa, "kappa1": kappa1})
    unit = [(cosine**2 + sine**2 - 1, cosine)]
    return vanishes(along, "speed of the centre along T", unit) & vanishes(across - claimed, "along N", unit)


@claim(
    "R5.3-6",
    "Vogt: on a convex arc with increasing curvature the chord makes the smaller angle A at the start: "
    "cos A − cos B = −∫κ′y ds > 0, y the height over the chord (negative for an arc turning left).",
    method=Method.PROOF,
    form="cos(theta) + kappa*y",
    wrong=("cos(theta) - kappa*y", "cos(theta) + kappa*y/2", "sin(theta) + kappa*y"),
)
def vogt(form: str) -> Evidence:
    """With the chord as axis the derivative of the form is κ′y.

    With the chord as axis, tangent (cos θ, sin θ), θ′ = κ, y′ = sin θ: the derivative of the form is κ′y.
    Integrate over the arc, where y = 0 at both ends and θ runs from −A to B; y < 0 inside since the arc is
    convex. So cos B − cos A = ∫κ′y ds < 0 for κ′ > 0, hence A < B.
    """
    theta, kappa, kappa1, y = sp.symbols("theta kappa kappa1 y", real=True)
    quantity = read(form, {"theta": theta, "kappa": kappa, "y": y})
    rates = ((theta, kappa), (kappa, kappa1), (y, sp.sin(theta)))  # by arc length
    rate = sum(sp.diff(quantity, symbol) * r for symbol, r in rates)
    return vanishes(rate - kappa1 * y, "derivative of cos θ + κy minus κ′y")
