"""Claims on the parameter χ of short helices, which cover theorem 4.3.2 in full: R4.3-1 and following.

Symbols: c, h for θ/2, s = sin(φ/2), u = sin χ, w = cos χ, with h² = 1 − c², u² = 1 − w², s² = 1 − c²w²; the
relations are divided out. Vectors have components along {E, F, G}; τ̄ is the thesis's.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.claims.chapter_4.segment_frames import E, F, G, phi, segment
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, read, read_tuple, vanishes
from osculant.cas.claims.vectors import read_vectors, same
from osculant.cas.geometry.short_helices import SegmentForms, defect_coefficient
from osculant.cas.numbers.signs import sign_between
from osculant.cas.numbers.vectors import dot

c, h, s = sp.symbols("c h s", positive=True)
u, w = sp.symbols("u w", real=True)
RELATIONS = ((s**2 - 1 + c**2 * w**2, s), (h**2 - 1 + c**2, h), (u**2 - 1 + w**2, u))
CHI = sp.Symbol("chi", real=True)
FORMS = SegmentForms(h, c, u, w, s, phi, 2 * s - phi * c * w)
V, SPAN = segment(c, h, c * w, s, c * u / s)  # lemma 4.3.3 with cos(φ/2) = c cos χ, τ̄ = c sin χ/s


def _read(form: str, count: int = 1) -> tuple[Any, ...]:
    parts = read_tuple(form, {"c": c, "h": h, "s": s, "chi": CHI, "phi": phi}, count)
    return tuple(part.subs({sp.sin(CHI): u, sp.cos(CHI): w}) for part in parts)


@claim(
    "R4.3-1",
    "All solutions of lemma 4.3.3 are covered by cos(φ/2) = c cos χ, −π < χ ≤ π, sign χ = sign τ̄; then "
    "sin²(φ/2) = sin²χ + h²cos²χ.",
    method=Method.PROOF,
    form="sin(chi)**2 + h**2*cos(chi)**2",
    wrong=("sin(chi)**2 + c**2*cos(chi)**2", "cos(chi)**2 + h**2*sin(chi)**2"),
)
def parameter(form: str) -> Evidence:
    """1 − c²cos²χ = sin²(φ/2). φ grows with χ in (0, π), as φ'/2·sin(φ/2) = c sin χ, from θ to 2π − θ.

    This is the range of lemma 4.3.3, once for τ̄ > 0 and once, mirrored in χ, for τ̄ < 0.
    """
    (stated,) = _read(form)
    theta = sp.Symbol("theta", positive=True)
    evidence = vanishes(1 - c**2 * w**2 - stated, "sin²(φ/2)", RELATIONS)
    evidence &= vanishes(_rate(phi) * s / 2 - c * u, "φ' sin(φ/2)/2 = c sin χ")
    for flat, end in ((1, theta), (-1, 2 * sp.pi - theta)):
        evidence &= vanishes(sp.cos(end / 2) - flat * sp.cos(theta / 2), f"φ = {end} at cos χ = {flat}")
    return evidence


@claim(
    "R4.3-2",
    "V = (sin χ E + h cos χ F)/s.",
    method=Method.PROOF,
    form="(sin(chi)*E + h*cos(chi)*F)/s",
    wrong=("(sin(chi)*E - h*cos(chi)*F)/s", "(h*sin(chi)*E + cos(chi)*F)/s", "sin(chi)*E + h*cos(chi)*F"),
)
def axis(form: str) -> Evidence:
    """V of lemma 4.3.3, with cos(φ/2) = c cos χ; also the axis of `SegmentForms`, and |V| = 1."""
    scalars = {"h": h, "s": s, "chi": CHI}
    (stated,) = read_vectors(form, scalars, {"E": E, "F": F}, 1)
    vector = tuple(sp.sympify(x).subs({sp.sin(CHI): u, sp.cos(CHI): w}) for x in stated)
    programmed = (*FORMS.axis, sp.S.Zero)
    evidence = same([V, programmed], [vector, vector], "V", RELATIONS)
    return evidence & vanishes(dot(V, V) - 1, "|V|²", RELATIONS)


@claim(
    "R4.3-3",
    "κ̄ = h/s and τ̄ = c sin χ/s.",
    method=Method.PROOF,
    form="h/s, c*sin(chi)/s",
    wrong=("c/s, h*sin(chi)/s", "h/s, sin(chi)/s", "h/s, c*cos(chi)/s"),
)
def quotients(form: str) -> Evidence:
    """The squares against (4.5) and remark 4.3.4 with cos φ = 2c²cos²χ − 1, t₀ = c² − h²; sign τ̄ = sign χ."""
    kappa_bar, tau_bar = _read(form, 2)
    less = 2 - 2 * c**2 * w**2  # 1 − cos φ
    evidence = vanishes(kappa_bar**2 - (1 - c**2 + h**2) / less, "κ̄²", RELATIONS)
    evidence &= vanishes(tau_bar**2 - (c**2 - h**2 + 1 - 2 * c**2 * w**2) / less, "τ̄²", RELATIONS)
    evidence &= vanishes(kappa_bar - FORMS.kappa_bar, "κ̄ of the solver", RELATIONS)
    evidence &= vanishes(tau_bar - FORMS.tau_bar, "τ̄ of the solver", RELATIONS)
    return evidence & Evidence(sp.simplify(tau_bar / u).is_positive is True, ("τ̄/sin χ is positive",))


@claim(
    "R4.3-4",
    "s²β⟨p₁ − p₀, E⟩ = X = φc sin²χ + 2h²s cos χ.",
    method=Method.PROOF,
    form="phi*c*sin(chi)**2 + 2*h**2*s*cos(chi)",
    wrong=("phi*c*sin(chi)**2 - 2*h**2*s*cos(chi)", "phi*c*sin(chi)**2 + h**2*s*cos(chi)"),
)
def ahead(form: str) -> Evidence:
    """⟨βS±, E⟩ from corollary 4.2.2 with lemma 4.3.3; also X of `SegmentForms`."""
    (stated,) = _read(form)
    derived = vanishes(s**2 * dot(SPAN, E) - stated, "s²β⟨p₁ − p₀, E⟩", RELATIONS)
    return derived & vanishes(FORMS.X - stated, "X of the solver", RELATIONS)


@claim(
    "R4.3-5",
    "s²β⟨p₁ − p₀, F⟩ = −Y, Y = h sin χ(2s − φc cos χ); and ⟨p₁ − p₀, G⟩ = 0.",
    method=Method.PROOF,
    form="h*sin(chi)*(2*s - phi*c*cos(chi))",
    wrong=(
        "-h*sin(chi)*(2*s - phi*c*cos(chi))",
        "h*sin(chi)*(2*s + phi*c*cos(chi))",
        "c*sin(chi)*(2*s - phi*c*cos(chi))",
    ),
)
def aside(form: str) -> Evidence:
    """⟨βS±, F⟩ and ⟨βS±, G⟩, as in R4.3-4."""
    (stated,) = _read(form)
    derived = vanishes(s**2 * dot(SPAN, F) + stated, "s²β⟨p₁ − p₀, F⟩", RELATIONS)
    derived &= vanishes(dot(SPAN, G), "⟨p₁ − p₀, G⟩", RELATIONS)
    return derived & vanishes(FORMS.Y - stated, "Y of the solver", RELATIONS)


def _rate(expression: Any) -> Any:
    """d/dχ: s² = 1 − c²cos²χ gives s' = c²uw/s, cos(φ/2) = c cos χ gives φ' = 2cu/s."""
    rates = {u: w, w: -u, s: c**2 * u * w / s, phi: 2 * c * u / s}
    return sum((sp.diff(expression, a) * rate for a, rate in rates.items()), sp.S.Zero)


#: (XY' − YX')/4h with x = φ/2, q = c²
WRONSKIAN = "x**2*(q - cos(x)**2) - (1 - q)*x*sin(x)*cos(x) + sin(x)**2*(1 - 2*q + cos(x)**2)"


@claim(
    "R4.3-6",
    "With x = φ/2: XY' − YX' = 4h(x²(c² − cos²x) − h²x sin x cos x + sin²x(1 − 2c² + cos²x)), affine in c².",
    method=Method.PROOF,
    form=WRONSKIAN,
    wrong=(
        "x**2*(q - cos(x)**2) + (1 - q)*x*sin(x)*cos(x) + sin(x)**2*(1 - 2*q + cos(x)**2)",
        "x**2*(q - cos(x)**2) - (1 - q)*x*sin(x)*cos(x) + sin(x)**2*(1 - q + cos(x)**2)",
    ),
)
def wronskian(form: str) -> Evidence:
    """X, Y differentiated by χ along cos(φ/2) = c cos χ; h² = 1 − c², s² = 1 − c²cos²χ divided out."""
    x = sp.Symbol("x", positive=True)
    stated = read(form, {"x": x, "q": c**2}).subs({sp.sin(x): s, sp.cos(x): c * w}).subs(x, phi / 2)
    derived = FORMS.X * _rate(FORMS.Y) - FORMS.Y * _rate(FORMS.X)
    return vanishes(derived - 4 * h * stated, "XY' − YX'", RELATIONS)


def angle_grows() -> Evidence:
    """XY' − YX' > 0: affine in q = c² and positive at both ends q = cos²x, q = 1 of its range, 0 < x < π."""
    x, q = sp.symbols("x q", real=True)
    form = read(WRONSKIAN, {"x": x, "q": q})
    evidence = wronskian(WRONSKIAN) & vanishes(sp.diff(form, q, 2), "second derivative by c²")
    for end, name in ((sp.cos(x) ** 2, "c² = cos²x"), (sp.S.One, "c² = 1")):
        sign = sign_between(sp.expand(form.subs(q, end)), x, sp.S.Zero, sp.pi)
        evidence &= Evidence(sign == 1, (f"sign on 0 < x < π at {name}: {sign}",))
    return evidence


def one_to_one() -> Evidence:
    """Y = 0 at χ = 0 and π, X > 0 and < 0 there, and Y > 0 between, because 2 sin x − 2x cos x > 0."""
    x = sp.Symbol("x", real=True)
    evidence = Evidence(True)
    for flat, sign in ((1, 1), (-1, -1)):
        at_end = {u: 0, w: flat}
        evidence &= vanishes(FORMS.Y.subs(at_end), f"Y at cos χ = {flat}")
        found = 1 if FORMS.X.subs(at_end).is_positive else -1 if FORMS.X.subs(at_end).is_negative else 0
        evidence &= Evidence(found == sign, (f"sign of X at cos χ = {flat}: {found}",))
    sign = sign_between(2 * sp.sin(x) - 2 * x * sp.cos(x), x, sp.S.Zero, sp.pi)
    return evidence & Evidence(sign == 1, (f"sign of 2s − φ cos(φ/2) on 0 < φ < 2π: {sign}",))


@claim(
    "R4.3-7",
    "The angle of (X, Y) grows strictly from 0 to π while χ grows from 0 to π.",
    method=Method.PROOF,
    form="0, pi",
    wrong=("0, 2*pi", "pi, 0", "0, pi/2"),
)
def angle(form: str) -> Evidence:
    """XY' − YX' > 0 by R4.3-6: affine in c², and sin³x(sin x − x cos x), sin²x(x² − sin²x) at the ends.

    The ends of the angle: Y = 0 with X > 0, then with X < 0, and Y > 0 between, so that no turn is added.
    """
    low, high = read_tuple(form, {}, 2)
    ends = (low, high) == (sp.S.Zero, sp.pi)
    return angle_grows() & one_to_one() & Evidence(ends, (f"from 0 to π, against {low} to {high}",))


@claim(
    "R4.3-8",
    "β = √(4h² + (τ̄φ)²)/|p₁ − p₀|, and the length is φ/β.",
    method=Method.PROOF,
    form="4*h**2 + (c*sin(chi)/s*phi)**2",
    wrong=("h**2 + (c*sin(chi)/s*phi)**2", "4*h**2 + (sin(chi)/s*phi)**2", "4*c**2 + (c*sin(chi)/s*phi)**2"),
)
def rate(form: str) -> Evidence:
    """|βS±|², with τ̄ = c sin χ/s."""
    (stated,) = _read(form)
    return vanishes(dot(SPAN, SPAN) - stated, "|βS±|²", RELATIONS)


@claim(
    "R4.3-9",
    "χ has the sign of −⟨p₁ − p₀, F⟩, F = T₁×T₀/|T₁×T₀|, so the usual torsion has the sign of ⟨p₁ − p₀, F⟩.",
    method=Method.PROOF,
    form="-1, 1",
    wrong=("1, 1", "-1, -1"),
)
def sign_rule(form: str) -> Evidence:
    """−Y/sin χ = −h(2s − φ cos(φ/2)) is negative, τ̄/sin χ positive, and the usual torsion is −τ̄β."""
    x = sp.Symbol("x", real=True)
    defect = sign_between(2 * sp.sin(x) - 2 * x * sp.cos(x), x, sp.S.Zero, sp.pi)
    linear = vanishes(FORMS.Y - h * u * FORMS.defect, "Y/sin χ")
    parameter_sign = -defect
    torsion_sign = -1 * parameter_sign * (1 if (FORMS.tau_bar / u).is_positive else -1)
    stated = integers(form, 2)
    line = f"sign χ = {parameter_sign:+d}·sign⟨p, F⟩, sign τ = {torsion_sign:+d}·sign⟨p, F⟩"
    return linear & Evidence(stated == (parameter_sign, torsion_sign), (line,))


@claim(
    "R4.3-10",
    "For T₁ = −T₀ the short helix is a half circle, β = 2/|p₁ − p₀|, φ = π, with ⟨p₁ − p₀, T₀⟩ = 0.",
    method=Method.PROOF,
    form="pi, 2/p",
    wrong=("pi, 1/p", "pi, pi/p", "2*pi, 2/p"),
)
def opposite_tangents(form: str) -> Evidence:
    """(4.5) with t₀ = −1: τ̄²(1 − cos φ) = −1 − cos φ ≤ 0 forces τ̄ = 0, φ = π; then the circle's chord."""
    x, p = sp.symbols("x p", positive=True)
    turning, beta = read_tuple(form, {"p": p}, 2)
    forced = vanishes(1 + sp.cos(turning), "1 + cos φ = 0")
    inside = Evidence(bool(turning > 0) and bool(turning < 2 * sp.pi), (f"0 < {turning} < 2π",))
    chord = (sp.sin(x), 1 - sp.cos(x))  # of the circle with β = 1, along T₀ and N₀
    evidence = vanishes(chord[0].subs(x, turning), "⟨p₁ − p₀, T₀⟩")
    return forced & inside & evidence & vanishes(chord[1].subs(x, turning) / beta - p, "|p₁ − p₀|")


@claim(
    "R4.3-11",
    "For T₁ = T₀ the only short helix is the straight segment: κ̄ = 0.",
    method=Method.PROOF,
    form="0",
    wrong=("1", "1/2"),
)
def equal_tangents(form: str) -> Evidence:
    """Remark 4.3.4 with t₀ = 1: κ̄²(1 − cos φ) = 0, and 1 − cos φ > 0 for 0 < φ < 2π."""
    x, square = sp.symbols("x q", real=True)
    sign = sign_between(1 - sp.cos(x), x, sp.S.Zero, 2 * sp.pi)
    (root,) = sp.solve(1 + (sp.cos(x) - 1) * square - 1, square)  # ⟨T, T₀⟩ = 1 − (1 − cos φ)κ̄² = t₀ = 1
    positive = Evidence(sign == 1, (f"sign of 1 − cos φ on (0, 2π): {sign}",))
    return positive & vanishes(root - read(form, {}) ** 2, "κ̄²")


@claim(
    "R4.3-12",
    "If ⟨p₁ − p₀, F⟩ = 0 the arc is plane, with φ = θ for ⟨p₁ − p₀, E⟩ > 0 and φ = 2π − θ for < 0.",
    method=Method.PROOF,
    form="theta, 2*pi - theta",
    wrong=(
        "2*pi - theta, theta",
        "theta, pi - theta",
        "theta, theta",
        "theta, 2*pi + theta",
        "theta + 4*pi, 2*pi - theta",
        "-theta, 2*pi - theta",
    ),
)
def plane_arcs(form: str) -> Evidence:
    """χ = 0 and χ = π in cos(φ/2) = cos(θ/2) cos χ, in τ̄ and in X; 0 < φ < 2π, tried at θ = π/3.

    Any other solution of the identity in θ differs by a multiple of 4π or in sign, so one θ tells.
    """
    theta = sp.Symbol("theta", positive=True)
    evidence = Evidence(True)
    for flat, turning in zip((1, -1), read_tuple(form, {"theta": theta}, 2), strict=True):
        evidence &= vanishes(sp.cos(turning / 2) - flat * sp.cos(theta / 2), f"cos(φ/2) for cos χ = {flat}")
        there = turning.subs(theta, sp.pi / 3)
        evidence &= Evidence(bool(0 < there < 2 * sp.pi), (f"φ = {there} at θ = π/3",))
        evidence &= vanishes(FORMS.tau_bar.subs({u: 0, w: flat}), "τ̄")
        forwards = FORMS.X.subs({u: 0, w: flat})
        right = forwards.is_positive if flat == 1 else forwards.is_negative
        evidence &= Evidence(bool(right), (f"sign of ⟨p₁ − p₀, E⟩ is that of {forwards}",))
    return evidence


@claim(
    "R4.3-13",
    "2 sin(φ/2) − φ cos(φ/2) = φ³/12 − φ⁵/480 + φ⁷/53760 − …, which the solver uses for small φ.",
    method=Method.PROOF,
    form="1/12, -1/480, 1/53760",
    wrong=("1/12, 1/480, 1/53760", "1/24, -1/480, 1/53760"),
)
def defect_series(form: str) -> Evidence:
    """Taylor's coefficients by differentiation at 0; the even ones vanish; also those of the solver."""
    x = sp.Symbol("x", real=True)
    function = 2 * sp.sin(x / 2) - x * sp.cos(x / 2)
    derivatives = [function]
    for _ in range(7):
        derivatives.append(sp.diff(derivatives[-1], x))
    taylor = [d.subs(x, 0) / sp.factorial(n) for n, d in enumerate(derivatives)]
    evidence = Evidence(not any(taylor[n] for n in (0, 1, 2, 4, 6)), ("orders 0, 1, 2, 4, 6 vanish",))
    for order, stated in zip((3, 5, 7), read_tuple(form, {}, 3), strict=True):
        programmed = defect_coefficient((order - 1) // 2)
        evidence &= vanishes(taylor[order] - stated, f"order {order}")
        evidence &= vanishes(stated - sp.Rational(programmed.numerator, programmed.denominator), "solver")
    return evidence
