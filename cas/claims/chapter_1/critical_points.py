"""Section 1.4: critical points of functions, Thom's seven classes, secant maps of space curves."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import product
from math import factorial
from typing import Any

import sympy as sp

from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integers, read, read_tuple, vanishes
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import milnor_number
from osculant.cas.germs.reference import reference
from osculant.cas.germs.unfolding import is_stable
from osculant.cas.numbers.vectors import cross, det, dot

x, y, u, X = sp.symbols("x y u X")
kappas, taus = sp.symbols("kappa0:4"), sp.symbols("tau0:3")
#: terms of the series of a curve: up to s⁵
ORDER = 5


def _hessian(formula: str) -> Any:
    return sp.hessian(read(formula, {"x": x, "y": y}), (x, y)).subs({x: 0, y: 0})


@claim(
    "section 1.4-1",
    "The pig trough of Figure 1.3, degenerate of corank 1, is the graph of this function of x and y.",
    method=Method.EXACT,
    form="x**2",
    printed="x**2 + y**2",
    wrong=("x**2 - y**2", "x**3 - 3*x*y**2"),
    erratum="The pig trough is printed as x² + y², which has a nondegenerate minimum; it is x².",
)
def pig_trough(form: str) -> Evidence:
    """Corank 2 − rank of the second derivatives; saddle and monkey saddle for comparison."""
    coranks = {f: 2 - _hessian(f).rank() for f in (form, "x**2 - y**2", "x**3 - 3*x*y**2")}
    lines = tuple(f"{f}: corank {corank}" for f, corank in coranks.items())
    known = coranks["x**2 - y**2"] == 0 and coranks["x**3 - 3*x*y**2"] == 2
    return Evidence(known and coranks[form] == 1, lines)


@claim(
    "lemma 1.4.2",
    "Morse: a nondegenerate critical point is equivalent to its terms up to this degree, of codimension 0.",
    method=Method.EXACT,
    form="2",
    wrong=("1", "3"),
)
def morse(form: str) -> Evidence:
    """±x₁² ± … ± xₙ², n ≤ 4: its sharp degree of R-determinacy, and the R_e codimension less 1, μ − 1."""
    evidence = Evidence(True)
    for n in range(1, 5):
        names = [f"x{i + 1}" for i in range(n)]
        for signs in product("+-", repeat=n):
            germ = Germ("".join(f"{s}{name}**2" for s, name in zip(signs, names)).lstrip("+"), names)
            degree = determinacy(germ, "R")
            size = codimension(germ, "R", extended=True).value
            right = (degree.degree,) == integers(form, 1) and degree.sharp is True and size == 1
            line = f"{germ}: {degree.degree}-determined, {degree.reason}; θ/T R_e has dimension {size}"
            evidence = Evidence(evidence.holds and right, (f"all signs, n ≤ {n}; the last: {line}",))
            if not right:
                return evidence
    return evidence


@claim(
    "lemma 1.4.3",
    "Splitting: z² + 2zx² + x³ + 3x⁴ has the residual singularity x³ + cx⁴, with c equal to this.",
    method=Method.EXACT,
    form="2",
    wrong=("3", "4"),
)
def splitting(form: str) -> Evidence:
    """z on the critical set, put in; the Milnor numbers of both agree, also without x³."""
    z = sp.Symbol("z")
    evidence = Evidence(True)
    for cubic in (1, 0):
        f = z**2 + 2 * z * x**2 + cubic * x**3 + 3 * x**4
        (critical,) = sp.solve(sp.diff(f, z), z)
        residual = sp.expand(f.subs(z, critical))
        numbers = milnor_number(Germ(str(f), "x z")), milnor_number(Germ(str(residual), "x"))
        right = residual.coeff(x, 4) == read(form, {}) and numbers[0] == numbers[1]
        evidence &= Evidence(
            bool(right), (f"residual {residual}: Milnor numbers {numbers[0]} and {numbers[1]}",)
        )
    return evidence


@claim(
    "table 1.1",
    "The codimensions of Thom's seven classes A₂, A₃, A₄, D₄⁻, D₄⁺, A₅, D₅.",
    method=Method.EXACT,
    form="1, 2, 3, 3, 3, 4, 4",
    wrong=("2, 3, 4, 4, 4, 5, 5", "1, 2, 3, 3, 3, 4, 5"),
)
def thom(form: str) -> Evidence:
    """dim Mθ/T R_e f = μ − 1: the parameters of a miniversal unfolding, constants aside."""
    names = ("A_2", "A_3", "A_4", "D_4-", "D_4+", "A_5", "D_5")
    found, lines = [], []
    for name in names:
        germ = reference("thom")[name].germ()
        size = codimension(germ, "R", extended=True).value
        milnor = milnor_number(germ)
        found.append(milnor - 1 if size == milnor else None)
        lines.append(f"{name}: {germ}, μ = {milnor}")
    return Evidence(tuple(found) == integers(form, len(names)), tuple(lines))


@claim(
    "table 1.1-D4",
    "In Arnold's notation, x²y ± y³, D₄⁻ (elliptic umbilic) and D₄⁺ (hyperbolic umbilic) are these.",
    method=Method.EXACT,
    form="x**3 - x*y**2, x**3 + x*y**2",
    printed="x**3 + x*y**2, x**3 - x*y**2",
    wrong=("x**3 - x*y**2, x**3 - x*y**2", "x**3 - x*y**2, x**2*y", "x**3 - x*y, x**3 + x*y**2"),
    erratum="Table 1.1 exchanges the labels D₄⁻ and D₄⁺ against Arnold; the names of the umbilics are right.",
)
def umbilics(form: str) -> Evidence:
    """Binary cubics without multiple factors are equivalent if they have as many real linear factors."""
    lines, agree = [], True
    forms = read_tuple(form, {"x": x, "y": y}, 2)
    for f in forms:
        if (
            not f.is_polynomial(x, y)
            or sp.Poly(f, x, y).homogeneous_order() != 3
            or sp.discriminant(f, x) == 0
        ):
            return Evidence(False, (f"{f} is no binary cubic without multiple factors",))
    for name, arnold, f in zip(("D₄⁻", "D₄⁺"), ("x**2*y - y**3", "x**2*y + y**3"), forms, strict=True):
        normal = _real_factors(read(arnold, {"x": x, "y": y}))
        agree = agree and _real_factors(f) == normal
        lines.append(f"{name}: {arnold} has {normal} real factors, {f} has {_real_factors(f)}")
    return Evidence(agree, tuple(lines))


def _real_factors(cubic: Any) -> int:
    """How many different real lines a binary cubic vanishes on."""
    at_infinity = int(sp.Poly(cubic, x, y).eval({x: 1, y: 0}) == 0)
    return at_infinity + int(sp.Poly(cubic.subs(y, 1), x).sqf_part().count_roots())


@claim(
    "section 1.4-2",
    "A small perturbation of a function of codimension r has at most this many critical points: for A₂ … A₅, "
    "D₄ and D₅.",
    method=Method.EXACT,
    form="r + 1",
    printed="r",
    wrong=("r + 2", "2*r"),
    erratum="A function of codimension r has Milnor number r + 1 and perturbations with r + 1 of them.",
)
def critical_points_of_perturbations(form: str) -> Evidence:
    """At most μ, which is r + 1 (table 1.1); attained: functions in the unfoldings with real critical points.

    A_k: the derivative is Π (x − i), i = 1, …, k; the scale does not matter, by quasi-homogeneity.
    """
    r = sp.Symbol("r")
    bound, evidence = read(form, {"r": r}), Evidence(True)
    perturbed = {
        **{f"A_{k}": sp.integrate(sp.prod([x - i for i in range(1, k + 1)]), x) + y**2 for k in range(2, 6)},
        "D_4-": x**3 - x * y**2 + x**2 + y**2,
        "D_5": x**4 + x * y**2 - 3 * x**2 / 2 - y**2 / 2,
    }
    for name, f in perturbed.items():
        germ = reference("thom")[name].germ()
        size = codimension(germ, "R", extended=True).value
        number = _real_critical_points(f)
        right = size != "infinite" and number == size == bound.subs(r, size - 1)
        line = f"{name}: codimension {int(size) - 1}, {number} real critical points of {f}"
        evidence &= Evidence(bool(right), (line,))
    return evidence


def _real_critical_points(f: Any) -> int:
    """The number of real critical points, all nondegenerate: exact, by a lexicographic basis."""
    basis = sp.groebner([sp.diff(f, y), sp.diff(f, x)], y, x, order="lex")
    return sum(1 for point in sp.solve_poly_system(basis.exprs, y, x) if all(c.is_real for c in point))


@claim(
    "section 1.4-3",
    "The torsion of (t, a₂₂t² + a₂₃t³ + …, a₃₂t² + a₃₃t³ + …) at t = 0, in the usual sign.",
    method=Method.PROOF,
    form="3*(a22*a33 - a23*a32)/(a22**2 + a32**2)",
    printed="(a22*a33 - a23*a32)/(a22**2 + a32**2)",
    wrong=("6*(a22*a33 - a23*a32)/(a22**2 + a32**2)", "-3*(a22*a33 - a23*a32)/(a22**2 + a32**2)"),
    erratum="The torsion τ(0) in the proof of Proposition 1.4.5 lacks the factor 3.",
)
def torsion(form: str) -> Evidence:
    """det(γ′, γ″, γ‴)/|γ′ × γ″|²."""
    a = {name: sp.Symbol(name, positive=True) for name in ("a22", "a23", "a32", "a33")}
    first, second = (1, 0, 0), (0, 2 * a["a22"], 2 * a["a32"])
    third = (0, 6 * a["a23"], 6 * a["a33"])
    bend = cross(first, second)
    return vanishes(read(form, a) - det(first, second, third) / dot(bend, bend), "τ(0)")


@claim(
    "section 1.4-4",
    "σ_j = (t₁^j − t₂^j)/(t₁ − t₂) for j = 2, …, 5, in x = (t₁ + t₂)/2 and y = (t₁ − t₂)/2.",
    method=Method.PROOF,
    form="2*x, 3*x**2 + y**2, 4*(x**3 + x*y**2), 5*x**4 + 10*x**2*y**2 + y**4",
    wrong=(
        "2*x, 3*x**2 - y**2, 4*(x**3 + x*y**2), 5*x**4 + 10*x**2*y**2 + y**4",
        "2*x, 3*x**2 + y**2, 4*(x**3 + x*y**2), 5*x**4 + 5*x**2*y**2 + y**4",
    ),
)
def chords(form: str) -> Evidence:
    """t₁ = x + y, t₂ = x − y."""
    evidence = Evidence(True)
    for j, claimed in enumerate(read_tuple(form, {"x": x, "y": y}, 4), start=2):
        evidence &= vanishes(claimed - _sigma(j).subs(u, y**2), f"σ_{j}")
    return evidence


def _sigma(j: int) -> Any:
    """((x + y)^j − (x − y)^j)/(2y), with u for y²."""
    terms = sp.Poly(((x + y) ** j - (x - y) ** j) / (2 * y), x, y).terms()
    return sum(c * x**a * u ** (b // 2) for (a, b), c in terms)


@cache
def _secant_coefficients() -> dict[tuple[int, int], Any]:
    """The second component as a series in X, the first, and u: its terms X^i u^j, i + j ≤ 2.

    The curve by arc length in its Frenet frame at 0: γ′ = T and T′ = κN, N′ = −κT + τB, B′ = −τN,
    differentiated at s = 0. With γ = Σ γ_j s^j the chord is Σ γ_j σ_j, divided by its first coordinate.
    """
    names = ("s", *(str(symbol) for symbol in (*kappas, *taus)))
    jets, s, *symbols = sp.ring(names, sp.QQ)
    kappa, tau = (
        sum((c * s**i / factorial(i) for i, c in enumerate(part)), jets.zero)
        for part in (symbols[: len(kappas)], symbols[len(kappas) :])
    )
    tangent: Sequence[Any] = (jets.one, jets.zero, jets.zero)
    chord = [sp.Integer(0)] * 3
    for j in range(1, ORDER + 1):
        now = [sp.sympify(t.subs(s, 0).as_expr()) / factorial(j) for t in tangent]
        chord = [c + value * _sigma(j) for c, value in zip(chord, now)]
        a, b, c = tangent
        rate = (-kappa * b, kappa * a - tau * c, tau * b)
        tangent = [t.diff(s) + r for t, r in zip(tangent, rate)]
    first, second = (_cut(c * _reciprocal(_cut(chord[0]))) for c in chord[1:])
    inner = X / kappas[0]
    for _ in range(2):  # x as a series in X and u; each step settles one more degree
        inner = _cut(inner - (first.subs(x, inner) - X) / kappas[0], X)
    whole = sp.Poly(_cut(second.subs(x, inner), X), X, u)
    return {(i, j): sp.cancel(c) for (i, j), c in whole.terms()}


def _cut(f: Any, variable: Any = x) -> Any:
    """Without the terms of degree above 2 in the variable and u together."""
    terms = sp.Poly(sp.expand(f), variable, u).terms()
    return sum(c * variable**i * u**j for (i, j), c in terms if i + j <= 2)


def _reciprocal(f: Any) -> Any:
    rest = sp.expand(f - 1)
    return sp.expand(1 - rest + rest**2)


@claim(
    "proposition 1.4.5.1",
    "The secant germ is the fold exactly if τ(0) ≠ 0: with X its first component and u = y², the second one "
    "has this u-coefficient.",
    method=Method.PROOF,
    form="kappa0*tau0/6",
    wrong=("kappa0*tau0/3", "-kappa0*tau0/6", "tau0/6"),
)
def fold(form: str) -> Evidence:
    """From Frenet's equations in the usual sign; (x, u) is A(H)-stable of codimension 0, as κ₀ ≠ 0."""
    names = {"kappa0": kappas[0], "tau0": taus[0]}
    germ = Germ("x, u", "x u")
    stable = codimension(germ, "A(H)").value == 0 and is_stable(germ, "A(H)")
    derived = vanishes(read(form, names) - _secant_coefficients()[0, 1], "coefficient of u")
    return derived & Evidence(stable, ("(x, u): A(H)-codimension 0, stable",))


@claim(
    "proposition 1.4.5.2",
    "At τ(0) = 0, by arc length, the second component has these coefficients of Xu and u²; if both are not "
    "0, the germ is the pitchfork (x, xy² + y⁴).",
    method=Method.PROOF,
    form="tau1/6, (3*kappa0*tau2 - kappa1*tau1)/360",
    wrong=(
        "tau1/6, (3*kappa0*tau2 + kappa1*tau1)/360",
        "tau1/6, (kappa0*tau2 - kappa1*tau1)/360",
        "tau1/3, (3*kappa0*tau2 - kappa1*tau1)/360",
    ),
)
def pitchfork(form: str) -> Evidence:
    """The same series; (x, axu + bu²) is A(H)-stable of codimension 1 for a, b ≠ 0, not otherwise."""
    names = {"kappa0": kappas[0], "kappa1": kappas[1], "tau1": taus[1], "tau2": taus[2]}
    evidence = Evidence(True)
    for claimed, place in zip(read_tuple(form, names, 2), ((1, 1), (0, 2)), strict=True):
        derived = _secant_coefficients()[place].subs(taus[0], 0)
        evidence &= vanishes(claimed - derived, f"coefficient of X^{place[0]}u^{place[1]}")
    for a, b, stable in ((1, 1, True), (-2, 3, True), (1, 0, False), (0, 1, False)):
        germ = Germ(f"x, {a}*x*u + {b}*u**2", "x u")
        size = codimension(germ, "A(H)").value
        right = is_stable(germ, "A(H)") == stable and (size == 1) == stable
        evidence &= Evidence(right, (f"{germ}: A(H)-codimension {size}, {'' if stable else 'not '}stable",))
    return evidence
