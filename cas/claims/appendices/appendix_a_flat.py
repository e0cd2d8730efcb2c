"""Claims of appendix A.2: functions with n-fold zeros at both ends of a short interval (Lemma A.2.1)."""

from __future__ import annotations

from typing import Any

import sympy as sp

from osculant.cas.asymptotics.flat_functions import (
    F,
    F_r,
    F_s,
    F_u,
    Model,
    balance_shift,
    flat_constant,
    n,
    slope_by_crossing,
    x,
    y,
)
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import positive, read, read_tuple, vanishes

u, s = sp.symbols("u s", real=True)
r = sp.Symbol("r", positive=True)
half = sp.Rational(1, 2)
#: flatnesses at which what is not polynomial in n is expanded in series
SMALL = (1, 2, 3)


def same_power(stated: Any, derived: Any, what: str) -> Evidence:
    """Equality of two positive expressions with n in exponents, by their logarithms.

    >>> bool(same_power(4**n, sp.Integer(2) ** (2 * n), "4ⁿ"))
    True
    """
    logarithms = (sp.expand_log(sp.log(sp.factor(side)), force=True) for side in (stated, derived))
    difference = next(logarithms) - next(logarithms)
    return vanishes(sp.expand(sp.expand_log(difference, force=True)), f"{what}, logarithms")


@claim(
    "section A.2-1",
    "The model uⁿ(r − u)ⁿF of a function with two n-fold zeros has its extreme value (r/2)²ⁿF at u = r/2.",
    method=Method.PROOF,
    form="(r/2)**(2*n)",
    printed="(1/2)**(2*n)",
    erratum="The proof of Lemma A.2.1 prints the extreme value of uⁿ(r − u)ⁿF as F/2²ⁿ, without the "
    "factor r²ⁿ.",
    wrong=("(r/2)**n", "(r/4)**(2*n)"),
)
def extreme_value_of_the_model(form: str) -> Evidence:
    """The logarithmic derivative n/u − n/(r − u) has one zero, u = r/2, for symbols n and r.

    The form is the value there divided by F, compared by logarithms.
    """
    (place,) = sp.solve(sp.together(n / u - n / (r - u)), u)
    value = (u**n * (r - u) ** n).subs(u, place)
    evidence = vanishes(place / r - Model(n).critical_points[0], "place, against the model on [0, 1]")
    return evidence & same_power(read(form, {"r": r, "n": n}), value, "extreme value")


@claim(
    "lemma A.2.1.1",
    "If u ↦ f(u, r) has n-fold zeros at 0 and r, max |f| = |∂²ⁿf/∂u²ⁿ(0, 0)| r²ⁿ/(2²ⁿ(2n)!) + O(r²ⁿ⁺¹).",
    method=Method.PROOF,
    form="1/(2**(2*n)*factorial)",
    wrong=("1/(2**n*factorial)", "1/2**(2*n)"),
)
def error_without_crossing(form: str) -> Evidence:
    """f = uⁿ(r − u)ⁿF by the division property; ``factorial`` is (2n)!.

    At r = 0, f is (−1)ⁿu²ⁿF, so |∂²ⁿf| = (2n)!|F|: computed for n = 1, 2, 3. On u = rx, f is r²ⁿxⁿ(1 −
    x)ⁿF(rx, r), whose peak at r = 0 is derived for the symbol n. That the rest is O(r²ⁿ⁺¹) is seen in the
    peak's derivative by r, which exists because ∂²/∂x² of the model's logarithm is not 0 there.
    """
    evidence = Evidence(True)
    for number in SMALL:
        at_zero = sp.expand((u**number * (r - u) ** number * (F + F_u * u + F_r * r)).subs(r, 0))
        derivative = sp.diff(at_zero, u, 2 * number).subs(u, 0)
        ratio = sp.sqrt(derivative**2) / sp.sqrt(F**2)
        evidence &= vanishes(ratio - sp.factorial(2 * number), f"|∂²ⁿf|/|F|, n = {number}")
    factorial = sp.Symbol("factorial", positive=True)
    stated = read(form, {"n": n, "factorial": factorial})
    curvature = sp.diff(Model(n).log_slope, x).subs(x, Model(n).critical_points[0])
    regular = Evidence(bool(curvature.is_negative), (f"second derivative of the logarithm: {curvature}",))
    return evidence & regular & same_power(stated * factorial, flat_constant(n, 0), "constant times (2n)!")


@claim(
    "section A.2-2",
    "After scaling u = rx, ∂f̃/∂x has its (n − 1)-fold zeros at x = 0 and x = 1.",
    method=Method.PROOF,
    form="0, 1",
    printed="0, r",
    erratum="The proof of Lemma A.2.1 places a zero of the scaled derivative ∂f̃/∂x at x = r; it is at x = 1.",
    wrong=("0, 1/2", "0, 2", "0, 0", "1, 1"),
)
def zeros_of_the_scaled_derivative(form: str) -> Evidence:
    """f̃ = xⁿ(1 − x)ⁿF with F(rx, r) any function: the form gives both zeros that do not depend on F.

    The slope is (x(1 − x))ⁿ⁻¹ times n(1 − 2x)F + x(1 − x)∂F/∂x, for a symbolic n; at x = 0 and 1 the factor
    is ±nF, not 0.
    """
    n = sp.Symbol("n", positive=True, integer=True)
    general = sp.Function("F")(x)
    logarithm = sp.expand_log(sp.log(x**n * (1 - x) ** n * general), force=True)
    inner = n * (1 - 2 * x) * general + x * (1 - x) * sp.diff(general, x)
    places = read_tuple(form, {"r": r}, 2)
    evidence = Evidence(places[0] != places[1], (f"zeros at {places[0]} and {places[1]}",))
    # the slope over xⁿ(1 − x)ⁿF is the derivative of the logarithm
    quotient = sp.diff(logarithm, x) * x * (1 - x) * general
    evidence &= vanishes(quotient - inner, "∂f̃/∂x over (x(1 − x))ⁿ⁻¹")
    for place in places:
        evidence &= vanishes(sp.expand(place * (1 - place)), f"x(1 − x) at x = {place}")
    return evidence


@claim(
    "section A.2-3",
    "The derivative of the model uⁿ(r − u)ⁿ(s − u) is uⁿ⁻¹(r − u)ⁿ⁻¹((2n+1)u² − (2ns + (n+1)r)u + nrs).",
    method=Method.PROOF,
    form="(2*n + 1)*u**2 - (2*n*s + (n + 1)*r)*u + n*r*s",
    printed="-(2*n + 1)*u**2 + (2*n*s + n + 1)*u - n*s",
    erratum="The proof of Lemma A.2.1 prints the derivative of uⁿ(r − u)ⁿ(s − u) as if r were 1 and the "
    "last factor "
    "u − s; it is uⁿ⁻¹(r − u)ⁿ⁻¹((2n+1)u² − (2ns + (n+1)r)u + nrs).",
    wrong=("(2*n + 1)*u**2 - (2*n*s + n + 1)*u + n*s", "(2*n + 1)*u**2 - (2*n*s + n*r)*u + n*r*s"),
)
def derivative_of_the_model(form: str) -> Evidence:
    """u(r − u)(s − u) times the logarithmic derivative n/u − n/(r − u) − 1/(s − u), for the symbol n."""
    log_slope = n / u - n / (r - u) - 1 / (s - u)
    quadratic = sp.cancel(u * (r - u) * (s - u) * log_slope)
    stated = read(form, {"n": n, "u": u, "r": r, "s": s})
    return vanishes(stated - quadratic, "quadratic factor")


@claim(
    "section A.2-4",
    "f = uⁿ(r − u)ⁿ(s − u)F scales with u = rx, s = ry to r²ⁿ⁺¹ xⁿ(1 − x)ⁿ(y − x)F.",
    method=Method.PROOF,
    form="y - x",
    printed="x - y",
    erratum="The proof of Lemma A.2.1 writes f with the factor s − u and the scaled f̃ with x − y; one "
    "needs the other "
    "sign (what follows, with (A.5), is right for u − s).",
    wrong=("y - r*x",),
)
def scaled_function(form: str) -> Evidence:
    """The quotient of both sides by uⁿ(r − u)ⁿF = r²ⁿxⁿ(1 − x)ⁿF is linear: (s − u)/r against the form."""
    powers = sp.expand_log(sp.log((r * x) * (r - r * x) / (r**2 * x * (1 - x))), force=True)
    evidence = vanishes(sp.cancel(sp.exp(powers)) - 1, "nth roots of the common factors")
    return evidence & vanishes(
        read(form, {"x": x, "y": y, "r": r}) - sp.cancel((r * y - r * x) / r), "linear factor"
    )


@claim(
    "(A.5)",
    "∂f̃/∂x = xⁿ⁻¹(1 − x)ⁿ⁻¹Q with Q = (−(2n+1)x² + (2ny+n+1)x − ny)F + O(r), f̃ = xⁿ(1 − x)ⁿ(x − "
    "y)F(rx, ry, r).",
    method=Method.PROOF,
    form="-(2*n + 1)*x**2 + (2*n*y + n + 1)*x - n*y",
    wrong=("-(2*n + 1)*x**2 + (2*n*y + n)*x - n*y", "(2*n + 1)*x**2 - (2*n*y + n + 1)*x + n*y"),
)
def critical_equation(form: str) -> Evidence:
    """x(1 − x)(x − y) times the logarithmic derivative n/x − n/(1 − x) + 1/(x − y) of the model.

    With F linear, ∂F(rx, ry, r)/∂x = rF_u adds r·x(1 − x)(x − y)F_u, and F itself is F + O(r): both O(r).
    """
    values = F + r * (F_u * x + F_s * y + F_r)
    whole = sp.expand(Model(n, y).critical_form * values + x * (1 - x) * (x - y) * sp.diff(values, x))
    stated = read(form, {"n": n, "x": x, "y": y})
    return vanishes(stated - whole.coeff(r, 0) / F, "Q/F at r = 0")


@claim(
    "(A.6)",
    "f̃ has for 0 < y < 1 one extremum in (0, y), one in (y, 1) and no other: Q(0) = −ny, Q(y) = y(1 − y), "
    "Q(1) = −n(1 − y); so max |f̃| is the larger of the two.",
    method=Method.PROOF,
    form="-n*y, y*(1 - y), -n*(1 - y)",
    wrong=("n*y, y*(1 - y), -n*(1 - y)", "-n*y, n*y*(1 - y), -n*(1 - y)", "-n*y, y*(1 - y), 0"),
)
def interlacing(form: str) -> Evidence:
    """The quadratic Q of (A.5) at 0, y and 1, for the symbol n.

    The signs there are −, +, − for 0 < y < 1, so each interval holds exactly one of its two zeros: a minimum
    in (0, y), where f̃ < 0, and a maximum in (y, 1). The discriminant is 4n²(y − 1/2)² + 2n + 1 > 0.
    """
    Q, inside = Model(n, y).critical_form, sp.Symbol("q", positive=True)
    evidence = Evidence(True)
    for place, stated, sign in zip(
        (0, y, 1), read_tuple(form, {"n": n, "y": y}, 3), (-1, 1, -1), strict=True
    ):
        evidence &= vanishes(stated - Q.subs(x, place), f"Q({place})")
        positive = sp.factor((sign * stated).subs(y, inside / (1 + inside)))  # all y between 0 and 1
        evidence &= Evidence(
            bool(positive.is_positive), (f"{'+' if sign > 0 else '−'}Q({place}) = {positive}",)
        )
    return evidence & vanishes(sp.discriminant(Q, x) - 4 * n**2 * (y - half) ** 2 - 2 * n - 1, "discriminant")


@claim(
    "section A.2-5",
    "The critical values of uⁿ(r − u)ⁿ(s − u) are opposite (equal in size) exactly for s = r/2.",
    method=Method.PROOF,
    form="r/2",
    printed="1/2",
    erratum="The proof of Lemma A.2.1 says that the critical values are equal iff s = 1/2; they have "
    "opposite signs, and "
    "their sum vanishes iff s = r/2.",
    wrong=("r/3",),
)
def balanced_position(form: str) -> Evidence:
    """The form is s; with y = s/r the model is xⁿ(1 − x)ⁿ(x − y), and Δ(y) the sum of its critical values.

    Exchanging x and 1 − x maps Δ(y) to −Δ(1 − y), so Δ(1/2) = 0. At critical points dΔ/dy is the sum of
    ∂(model)/∂y = −xⁿ(1 − x)ⁿ over both, negative by (A.6): Δ has no other zero. So y − 1/2 must vanish.
    """
    mirrored = Model(n, y).shape.subs({x: 1 - x, y: 1 - y}, simultaneous=True)
    slope = slope_by_crossing() / (x**n * (1 - x) ** n)
    evidence = vanishes(sp.cancel(mirrored / Model(n, y).shape) + 1, "model under x ↦ 1 − x")
    evidence &= vanishes(sp.cancel(slope) + 1, "∂(model)/∂y over −xⁿ(1 − x)ⁿ")
    fixed = sp.solve(sp.Eq(y, 1 - y), y)[0]
    return evidence & vanishes(read(form, {"r": r}) / r - fixed, "place of the zero over r")


@claim(
    "(A.4)",
    "The constant is cₙ = max |xⁿ(1 − x)ⁿ(x − 1/2)| = nⁿ/(2ⁿ⁺¹(2n + 1)^(n + 1/2)), for every n.",
    method=Method.PROOF,
    form="n**n/(2**(n + 1)*(2*n + 1)**(n + 1/2))",
    wrong=(
        "n**n/(2**n*(2*n + 1)**(n + 1/2))",
        "n**n/(2**(n + 1)*(2*n + 1)**n)",
        "n**n/(2**(n + 1)*(2*n + 1)**(n + 1))",
    ),
)
def constant_with_crossing(form: str) -> Evidence:
    """The zeros of Q at y = 1/2 are x = 1/2 ± 1/(2√(2n + 1)), where x(1 − x) = n/(2(2n + 1)).

    Hence the value (n/(2(2n + 1)))ⁿ/(2√(2n + 1)), for the symbol n, compared with the form by logarithms; and
    for n = 1, 2, 3 the square of the largest critical value, exactly.
    """
    stated = read(form, {"n": n})
    evidence = same_power(stated, flat_constant(n, 1), "cₙ for the symbol n")
    for number in SMALL:
        largest = max(value**2 for value in Model(number, half).critical_values)
        evidence &= vanishes(sp.nsimplify(stated.subs(n, number) ** 2) - sp.expand(largest), f"n = {number}")
    return evidence


@claim(
    "section A.2-6",
    "min over y of max |f̃| = cₙ|F(0, 0, 0)| + O(r), f̃ = xⁿ(1 − x)ⁿ(x − y)F(rx, ry, r): for n ≤ 3.",
    method=Method.EXACT,
    form="constant*F",
    printed="constant",
    erratum="The last displays of the proof of Lemma A.2.1 leave out the factor |F(0, 0, 0)|, so that "
    "the error would not "
    "depend on f.",
    wrong=("constant/F", "2*constant*F", "-constant*F"),
)
def balanced_error(form: str) -> Evidence:
    """The peak of the model times F > 0 at r = 0, with ``constant`` = cₙ, for n = 1, 2, 3."""
    evidence = Evidence(True)
    size = sp.Symbol("F", positive=True)
    for number in SMALL:
        peaks = [sp.sqrt(sp.expand(v**2)) * size for v in Model(number, half).critical_values]
        stated = read(form, {"constant": flat_constant(number, 1), "F": size})
        evidence &= positive(stated, f"the error, n = {number}")
        for side, peak in zip(("left", "right"), peaks, strict=True):
            evidence &= vanishes(stated**2 - sp.expand(peak**2), f"{side} peak, squared, n = {number}")
    return evidence


@claim(
    "lemma A.2.1.2",
    "With an additional zero s, min over s of max |f| = cₙ|∂²ⁿ⁺¹f/∂u²ⁿ⁺¹(0, 0, 0)| r²ⁿ⁺¹/(2n + 1)! + "
    "O(r²ⁿ⁺²): for n ≤ 3.",
    method=Method.EXACT,
    form="constant/factorial",
    wrong=("constant", "constant/(2*factorial)", "-constant/factorial"),
)
def error_with_crossing(form: str) -> Evidence:
    """f = uⁿ(r − u)ⁿ(u − s)F; ``constant`` is cₙ and ``factorial`` (2n + 1)!, n = 1, 2, 3.

    At r = s = 0, f is (−1)ⁿu²ⁿ⁺¹F, which gives |∂²ⁿ⁺¹f| in terms of |F|; the balanced peak is cₙ|F|r²ⁿ⁺¹ by
    the scaling u = rx, s = ry, and both peaks of the model at y = 1/2 have that size.
    """
    evidence = Evidence(True)
    for number in SMALL:
        f = u**number * (r - u) ** number * (u - s) * (F + F_u * u + F_s * s + F_r * r)
        derivative = sp.diff(sp.expand(f.subs({r: 0, s: 0})), u, 2 * number + 1).subs(u, 0)
        scaled = sp.expand(f.subs({u: r * x, s: r / 2}, simultaneous=True))
        leading = sp.factor(scaled.coeff(r, 2 * number + 1))
        peaks = [leading.subs(x, point) for point in Model(number, half).critical_points]
        symbols = {"constant": flat_constant(number, 1), "factorial": sp.factorial(2 * number + 1)}
        factor = read(form, symbols)
        evidence &= positive(factor, f"the factor of |∂²ⁿ⁺¹f|r²ⁿ⁺¹, n = {number}")
        stated = (factor * derivative) ** 2
        for peak in peaks:
            evidence &= vanishes(sp.expand(peak**2) - sp.expand(stated), f"squared peak, n = {number}")
    return evidence


@claim(
    "lemma A.2.1.3",
    "The best third zero is s₀(r) = r/2 + O(r²): s₀(0) = 0 and s₀′(0) = 1/2.",
    method=Method.PROOF,
    form="0",
    printed="1/2",
    erratum="Lemma A.2.1 states s₀(0) = 1/2; its proof gives s₀(r) = r·y₀(r) with y₀(0) = 1/2, so s₀(0) "
    "= 0 and "
    "s₀′(0) = 1/2.",
    wrong=("1", "r"),
)
def best_third_zero(form: str) -> Evidence:
    """y₀ = 1/2 + (dy₀/dr) r + … by the implicit function theorem, then s₀ = r·y₀; the form is s₀(0)."""
    best = r * (half + balance_shift() * r)
    slope = sp.diff(best, r).subs(r, 0)
    return vanishes(read(form, {"r": r}) - best.subs(r, 0), "s₀(0)") & vanishes(slope - half, "s₀′(0)")
