"""Claims of sections 1.5 and 4.6, reconstructed: how many bihelices a curve needs, and the rules for them."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp
from flint import arb

from osculant.cas.asymptotics.bihelix_series import leading_constant
from osculant.cas.asymptotics.space_complexity import curvature_slope_integral
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.examples import CONICAL, MOMENT
from osculant.cas.claims.proof import agrees, positive, read, read_tuple, rounding, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.formulas.sympy_bridge import cbrt
from osculant.cas.geometry.bihelices import Bihelix
from osculant.cas.geometry.bihelix_rules import (
    SpaceArc,
    equioscillating_bihelix,
    peaks,
    shifted_bihelix,
    thesis_bihelix,
)
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.balls import constant
from osculant.cas.numbers.vectors import Vector3

#: digits of the runs of the approximation theorem, digits asked for, first half width and number of halvings
DIGITS, WANTED, WIDTH, HALVINGS = 80, 40, Fraction(1, 4096), 7


@claim(
    "section 1.5-2",
    "A bihelix spline needs ∫(κ′/324)^(1/3) ds ε^(−1/3) pieces to leading order (κ′ > 0): the integrand.",
    method=Method.PROOF,
    form="cbrt(kappa1/324)",
    printed="sqrt(kappa1)/cbrt(324)",
    wrong=("cbrt(kappa1/162)", "kappa1/cbrt(324)", "cbrt(kappa1)/324"),
    erratum="Section 1.5 prints the exponent 1/2 for |κ′| in the constant of the bihelix spline: it is 1/3.",
)
def complexity_density(form: str) -> Evidence:
    """The error c·κ′σ³ of one arc, c from the contact conditions, is put to ε = 1 for the σ whose
    inverse, the number of pieces for a unit of length, is claimed.
    """  # noqa: D205
    slope = sp.Symbol("kappa1", positive=True)
    c = leading_constant()
    pieces = read(form, {"kappa1": slope}).replace(
        cbrt, lambda x: x ** sp.Rational(1, 3)
    )  # of positive numbers
    length = 1 / pieces
    error = sp.Rational(c.numerator, c.denominator) * slope * length**3
    return vanishes(error - 1, "error of an arc of the claimed length, minus ε = 1")


def _rounds_to(form: str, curve: str, low: str, high: str) -> Evidence:
    ball = curvature_slope_integral(
        parse_tuple(curve), constant(parse_constant(low)), constant(parse_constant(high))
    )
    c = leading_constant()
    ball *= (arb(c.numerator) / c.denominator).root(3)
    shown, half = rounding(form, 6)
    low_end, high_end = (arb(q.numerator) / q.denominator for q in (shown - half, shown + half))
    line = f"the constant of ({curve}) on [{low}, {high}] is {ball.str(9)}, rounded to {form}"
    return Evidence(bool(low_end <= ball <= high_end), (line,))


@claim(
    "R4.6-1.1",
    "The conical spiral (t cos t, t sin t, t) on [π/6, 2π] has the complexity constant 0.851459.",
    method=Method.ENCLOSURE,
    form="0.851459",
    wrong=("0.851460", "1.072771"),
)
def conical_constant(form: str) -> Evidence:
    """324^{−1/3} ∫|κ′|^{1/3} ds by integration in complex balls; the form must be its rounding."""
    return _rounds_to(form, CONICAL, "pi/6", "2*pi")


@claim(
    "R4.6-1.2",
    "The moment curve (t, t², t³) on [0, 1] has the complexity constant 0.248087.",
    method=Method.ENCLOSURE,
    form="0.248087",
    wrong=("0.248086", "0.257807", "0.312569"),
)
def moment_constant(form: str) -> Evidence:
    """The same integral; κ′ has a zero at t = 0, where the ball of the cube root includes 0."""
    return _rounds_to(form, MOMENT, "0", "1")


@claim(
    "R4.6-1.3",
    "The moment curve (t, t², t³) on [1, 2] has the complexity constant 0.257807.",
    method=Method.ENCLOSURE,
    form="0.257807",
    wrong=("0.257808", "0.248087", "0.324816"),
)
def second_moment_constant(form: str) -> Evidence:
    """The same integral between 1 and 2."""
    return _rounds_to(form, MOMENT, "1", "2")


def _limits(curve: str, law: str) -> Evidence:
    """The limits, for arcs about t = 1 that shrink, of both peaks divided by the law.

    Half widths δ, δ/2, δ/4, …: exchanging the ends changes the sign of δ and exchanges the peaks, so their
    mean divided by the law is a series in δ², and their difference δ times one: extrapolated so.
    """
    coordinates = parse_tuple(curve)
    slope, length = sp.symbols("kappa1 sigma", positive=True)
    stated = read(law, {"kappa1": slope, "sigma": length})
    if stated == 0:
        raise DomainError("A law that is 0 has no peaks divided by it.")
    scale = sp.lambdify((slope, length), stated, "mpmath")
    means, differences = [], []
    with mp.workdps(DIGITS):
        for k in range(HALVINGS):
            delta = mp.mpf(WIDTH.numerator) / WIDTH.denominator / 2**k
            arc = SpaceArc(coordinates, 1 - delta, 1 + delta)
            middle = arc.jet(arc.after(arc.sigma / 2))
            unit = scale(abs(middle.curvature_slope), arc.sigma)
            left, right = (peak / unit for peak in peaks(arc, thesis_bihelix(arc)))
            means.append((left + right) / 2)
            differences.append(left - right)
        mean, gap = _extrapolated(means, 4, 4), _extrapolated(differences, 2, 4)
        evidence = agrees(mean, 1, WANTED, f"limit of the mean of both peaks on ({curve}) by the law")
        line = f"limit of the difference of the peaks: {mp.nstr(gap, 3)}"
        return evidence & Evidence(bool(abs(gap) <= mp.mpf(10) ** -(WANTED // 2)), (line,))


def _extrapolated(values: list[Any], factor: int, growth: int) -> Any:
    """Richardson's limit of values whose errors fall by factor, factor·growth, … at each halving."""
    while len(values) > 1:
        values = [(factor * b - a) / (factor - 1) for a, b in pairwise(values)]
        factor *= growth
    return values[0]


@claim(
    "R4.5-10",
    "On the conical spiral both peaks of the near-optimal bihelix, divided by |κ′|σ³/324, tend to 1 as the "
    "arc shrinks to t = 1.",
    method=Method.NUMERICAL,
    form="kappa1*sigma**3/324",
    wrong=("kappa1*sigma**3/162", "kappa1*sigma**2/324"),
    reason="The limit is proved (R4.5-3, R4.5-6); here the proof is held against the distances of one curve.",
)
def ratio_on_conical_spiral(form: str) -> Evidence:
    """Junction by the thesis's rule, both short helices solved and the distances maximised in 80 digits."""
    return _limits(CONICAL, form)


@claim(
    "R4.5-11",
    "On the moment curve both peaks of the near-optimal bihelix, divided by |κ′|σ³/324, tend to 1 as the "
    "arc shrinks to t = 1.",
    method=Method.NUMERICAL,
    form="kappa1*sigma**3/324",
    wrong=("kappa1*sigma**3/648", "kappa1*sigma**4/324"),
    reason="The limit is proved (R4.5-3, R4.5-6); here the proof is held against the distances of one curve.",
)
def ratio_on_moment_curve(form: str) -> Evidence:
    """As on the conical spiral."""
    return _limits(MOMENT, form)


def _error(curve: str, low: Any, high: Any, rule: Callable[[SpaceArc], Bihelix]) -> Any:
    arc = SpaceArc(parse_tuple(curve), mp.mpf(low), mp.mpf(high))
    return max(peaks(arc, rule(arc)))


@claim(
    "R4.6-2",
    "On long arcs the choice of the junction matters: on [1, 3/2] of the moment curve the errors of the "
    "thesis's rule (junction nearest to the middle), of the junction nearest to the curve, and of equal "
    "peaks are 8.90, 2.66 and 0.992 times (∫|κ′|^{1/3} ds)³/324.",
    method=Method.NUMERICAL,
    form="8.90, 2.66, 0.992",
    wrong=("1, 1, 1", "8.90, 8.90, 0.992", "2.66, 8.90, 0.992"),
    reason="A comparison of two constructions on one arc: numbers, not a theorem.",
)
def rules_compared(form: str) -> Evidence:
    """Three bihelices of the same arc; their largest distances over the ideal error of one piece."""
    low, high = Fraction(1), Fraction(3, 2)
    whole = curvature_slope_integral(parse_tuple(MOMENT), arb(1), arb(3) / 2)
    ideal = float(whole) ** 3 * float(leading_constant())
    rules: tuple[tuple[str, Callable[[SpaceArc], Bihelix]], ...] = (
        ("nearest to the middle", thesis_bihelix),
        ("nearest to the curve", lambda arc: shifted_bihelix(arc, mp.mpf(0))),
        ("equal peaks", lambda arc: equioscillating_bihelix(arc, 4)),
    )
    evidence = Evidence(True)
    for (what, rule), claimed in zip(rules, read_tuple(form, {}, 3), strict=True):
        value = _error(MOMENT, float(low), float(high), rule) / ideal
        evidence &= agrees(value, sp.Float(claimed), 2.5, f"{what}, over the ideal error")
    return evidence


#: right ends of arcs of the conical spiral from π/6 on: short ones, and the longest the thesis takes
ENDS = {"short": ("0.7", "0.9", "1.2", "1.6"), "long": ("5.4", "5.8", "2*pi")}


def _growth(ends: tuple[str, ...]) -> tuple[list[bool], str]:
    rights = [mp.mpf(constant(parse_constant(end)).mid().str(30, radius=False)) for end in ends]
    errors = [_error(CONICAL, mp.pi / 6, right, thesis_bihelix) for right in rights]
    shown = ", ".join(f"{mp.nstr(e, 5)} to t = {end}" for e, end in zip(errors, ends))
    return [b > a for a, b in pairwise(errors)], f"errors of arcs from π/6: {shown}"


def _monotone(form: str, ends: tuple[str, ...]) -> Evidence:
    grows, line = _growth(ends)
    wanted = {
        "increases": all(grows),
        "decreases": not any(grows),
        "does not always increase": not all(grows),
    }
    if form not in wanted:
        raise DomainError(f"{form!r} is none of {', '.join(wanted)}.")
    return Evidence(wanted[form], (line,))


@claim(
    "R4.6-3",
    "On long arcs of the conical spiral, whose curvature is monotone, the error of the near-optimal bihelix "
    "does not always increase with the arc.",
    method=Method.NUMERICAL,
    form="does not always increase",
    printed="increases",
    wrong=("decreases",),
    reason="One pair of nested arcs with errors that differ by a tenth refutes the assumption.",
    erratum="Section 4.1.2 assumes that the error of the near-optimal bihelix is monotone in the arc; on the "
    "thesis's own conical spiral it falls from 4.42 to 3.98 as the arc from π/6 grows from t = 5.8 to 2π.",
)
def error_on_long_arcs(form: str) -> Evidence:
    """Thesis rule on arcs that begin at π/6; the last two are the counterexample."""
    return _monotone(form, ENDS["long"])


@claim(
    "R4.6-4",
    "While it is small, the error of the near-optimal bihelix increases with the arc.",
    method=Method.NUMERICAL,
    form="increases",
    wrong=("decreases", "does not always increase"),
    reason="No proof is known, and R4.6-3 shows that one must use that the arc is short.",
    open=True,
)
def error_on_short_arcs(form: str) -> Evidence:
    """Thesis rule on short arcs of the conical spiral that begin at π/6."""
    return _monotone(form, ENDS["short"])


@claim(
    "R4.6-5",
    "On a spherical helix, a curve of constant slope c = ⟨T, e₃⟩ on the unit sphere, at the height z: "
    "κ = √(1−c²)/√(1−c²−z²) and |τ|/κ = c/√(1−c²).",
    method=Method.PROOF,
    form="sqrt(1-c**2)/sqrt(1-c**2-z**2), c/sqrt(1-c**2)",
    wrong=(
        "1/sqrt(1-c**2-z**2), c/sqrt(1-c**2)",
        "sqrt(1-c**2)/sqrt(1-c**2-z**2), sqrt(1-c**2)/c",
        "sqrt(1-c**2)/sqrt(1-z**2), c/sqrt(1-c**2)",
    ),
)
def spherical_helix(form: str) -> Evidence:
    """With T = (r cos θ, r sin θ, c), r² = 1 − c², and ′ = d/dθ: T′ = rN, N′ = −rT + cB, B′ = −cN. A point of
    the unit sphere whose tangent is T is −ρN + μB there with ρ′ = −cμ, μ′ = cρ and ρ² + μ² = 1, at the height
    z = rμ. Its derivatives in the frame give κ and τ, squared.
    """  # noqa: D205
    rho, mu, r, c = sp.symbols("rho mu r c", real=True)

    def rate(x: Any) -> Any:
        return sp.diff(x, mu) * c * rho - sp.diff(x, rho) * c * mu

    def derivative(v: Vector3) -> Vector3:
        t, n, b = v
        return rate(t) - r * n, rate(n) + r * t - c * b, rate(b) + c * n

    rows = [(sp.Integer(0), -rho, mu)]
    for _ in range(3):
        rows.append(derivative(rows[-1]))
    first, second, third = zip(*rows)
    jet = SpaceJet(first, second, third)
    claimed, ratio = read_tuple(form, {"c": c, "z": r * mu}, 2)
    relations = [(r**2 + c**2 - 1, r), (rho**2 + mu**2 - 1, mu)]
    speed = jet.speed_squared * jet.speed_squared * jet.speed_squared
    curvature = vanishes(jet.inflection_form - claimed**2 * speed, "κ²", relations)
    twist = jet.torsion_form**2 * speed - ratio**2 * jet.inflection_form**3
    at = {c: sp.Rational(3, 5), r: sp.Rational(4, 5), mu: sp.Rational(1, 2)}
    signs = positive(claimed.subs(at), "κ") & positive(ratio.subs(at), "|τ|/κ")
    return signs & curvature & vanishes(twist, "τ²/κ²", relations)
