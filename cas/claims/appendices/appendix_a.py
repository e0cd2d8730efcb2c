"""Claims of appendix A.1: divided differences and the Newton development."""

from __future__ import annotations

from itertools import permutations
from math import factorial
from typing import Any

import sympy as sp

from osculant.cas.claims.appendices.brackets import bracket, coefficients, h, nodes, u, x, xi
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import integer, read, read_tuple, vanishes
from osculant.cas.numbers.divided_differences import divided_difference, hermite_data, newton
from osculant.cas.numbers.division import hermite_genocchi, newton_of_polynomial

#: rational functions of four nodes and of the values there of a function of which nothing else is known
generators = sp.field("x0:4,f0:4", sp.QQ)[1:]
generic_nodes, generic_values = generators[:4], generators[4:]
generic = hermite_data([(node, (value,)) for node, value in zip(generic_nodes, generic_values)])
polynomial = sum(c * x**i for i, c in enumerate(coefficients))


@claim(
    "(A.1)",
    "f(x₀) + (x − x₀)[x₀, x₁]f + … + (x − x₀)⋯(x − xₙ₋₁)[x₀, …, xₙ]f interpolates f at x₀, …, xₙ (n = 3).",
    method=Method.PROOF,
    form="f0 + (x - x0)*d1 + (x - x0)*(x - x1)*d2 + (x - x0)*(x - x1)*(x - x2)*d3",
    wrong=(
        "f0 + (x - x1)*d1 + (x - x0)*(x - x1)*d2 + (x - x0)*(x - x1)*(x - x2)*d3",
        "f0 + (x - x0)*d1 + (x - x0)*(x - x1)*d2 + (x - x0)*(x - x1)*(x - x3)*d3",
    ),
)
def newton_form(form: str) -> Evidence:
    """The recursion gives dₖ = [x₀, …, xₖ]f from values f₀, …, f₃ that are symbols.

    The form is then evaluated at every node: it must give that node's value. It is of degree 3, so it is the
    interpolating polynomial, and d₃ is its leading coefficient, as the definition of [x₀, …, x₃]f demands.
    """
    differences = [c.as_expr() for c in newton(generic, generic_nodes).coefficients]
    symbols = dict(zip(("f0", "d1", "d2", "d3"), differences))
    stated = read(form, {"x": x, **symbols, **{s.name: s for s in nodes[:4]}})
    evidence = Evidence(True)
    for node, value in zip(nodes, generic_values):
        evidence &= vanishes(stated.subs(x, node) - value.as_expr(), f"value at {node}")
    leading = sp.Poly(sp.expand(stated), x).coeff_monomial(x**3)
    return evidence & vanishes(leading - differences[3], "leading coefficient")


@claim(
    "section A.1-1",
    "Hermite and Genocchi: [x₀, …, xₙ]f is the integral of f⁽ⁿ⁾ at t₀x₀ + … + tₙxₙ over the simplex: for n "
    "≤ 4.",
    method=Method.EXACT,
    form="1 - t1 - t2 - t3",
    wrong=("1", "1 + t1 + t2 + t3"),
)
def hermite_genocchi_identity(form: str) -> Evidence:
    """The form is t₀ (n = 3). f is a polynomial of degree 5; coefficients and nodes are symbols.

    f‴(t₀x₀ + … + t₃x₃) is integrated over t₃, then t₂, then t₁, and compared with the remainder that
    division by the x − xᵢ leaves. For n = 0, …, 4 the same is done by the program's own integral, with
    x₀ = x₁ in addition.
    """
    t = sp.symbols("t1:4")
    point = read(form, {s.name: s for s in t}) * nodes[0] + sum(s * node for s, node in zip(t, nodes[1:]))
    integral = sp.Poly(sp.diff(polynomial, x, 3).subs(x, point), *t)
    for i in (2, 1, 0):
        antiderivative = integral.integrate(t[i]).as_expr()
        integral = sp.Poly(antiderivative.subs(t[i], 1 - sum(t[:i])), *t)
    evidence = vanishes(integral.as_expr() - bracket(4), "integral over the simplex, n = 3")
    for n in range(5):
        at = (nodes[0], nodes[0], *nodes[2:5])[: n + 1]
        difference = newton_of_polynomial(coefficients, at).coefficients[-1]
        evidence &= vanishes(hermite_genocchi(coefficients, at) - difference, f"coincident nodes, n = {n}")
    return evidence


@claim(
    "section A.1-2",
    "Divided differences do not depend on the order of their nodes.",
    method=Method.PROOF,
    form="1",
    wrong=("sign", "-1"),
)
def symmetry(form: str) -> Evidence:
    """The recursion is run on all 24 orders of four nodes with symbolic values.

    The form is the factor by which a permutation changes the difference; ``sign`` is that of the permutation.
    """
    first = divided_difference(generic, generic_nodes)
    for order in permutations(range(4)):
        factor = integer(read(form, {"sign": sp.LeviCivita(*order)}))
        moved = divided_difference(generic, [generic_nodes[i] for i in order])
        if moved != first * sp.QQ(factor):
            return Evidence(False, (f"nodes in the order {order}: the factor is not {factor}",))
    return Evidence(True, ("24 orders of x₀, x₁, x₂, x₃ give the same reduced rational function",))


@claim(
    "(A.2)",
    "If all n + 1 nodes are ξ, the divided difference is f⁽ⁿ⁾(ξ)/n!: for n ≤ 4.",
    method=Method.EXACT,
    form="derivative/factorial",
    wrong=("derivative", "n*derivative/factorial", "derivative/(n*factorial)"),
)
def confluent_difference(form: str) -> Evidence:
    """The recursion at the distinct nodes ξ, ξ + h, …, ξ + nh, for f of degree 5 with symbolic coefficients.

    The result is a polynomial in h; at h = 0 it must be the form. n = 1, 2, 3, 4 in turn; that the limit is
    the same along every way to coincidence is the continuity that Hermite and Genocchi give.
    """
    evidence = Evidence(True)
    for n in (1, 2, 3, 4):
        apart = [xi + i * h for i in range(n + 1)]
        table = hermite_data([(node, (polynomial.subs(x, node),)) for node in apart])
        limit = sp.cancel(divided_difference(table, apart)).subs(h, 0)
        derivative = sp.diff(polynomial, x, n).subs(x, xi)
        stated = read(form, {"derivative": derivative, "factorial": sp.Integer(factorial(n)), "n": n})
        evidence &= vanishes(stated - limit, f"limit of distinct nodes, n = {n}")
    return evidence


def _integrals(form: str, n: int) -> Any:
    """∫₀¹ (first part of the form)·f⁽ⁿ⁾(second part) du for the polynomial with symbolic coefficients."""
    weight, point = read_tuple(form, {"u": u, "x": x, "xi": xi, "n": sp.Integer(n)}, 2)
    derivative = sp.diff(polynomial, x, n).subs(x, point)
    return sp.integrate(sp.expand(weight * derivative), (u, 0, 1))


@claim(
    "(A.3)",
    "[ξ, …, ξ, x]f with n nodes ξ is 1/(n−1)! ∫₀¹ (1−u)ⁿ⁻¹ f⁽ⁿ⁾((1−u)ξ + ux) du.",
    method=Method.PROOF,
    form="(1 - u)**(n - 1), (1 - u)*xi + u*x",
    wrong=(
        "u**(n - 1), (1 - u)*xi + u*x",
        "(1 - u)**n, (1 - u)*xi + u*x",
        "(1 - u)**(n - 1), u*xi + (1 - u)*x",
    ),
)
def difference_with_one_free_node(form: str) -> Evidence:
    """The form is the weight and the point at which f⁽ⁿ⁾ is taken; f has degree 5, symbolic coefficients.

    The left side is the remainder of dividing f n times by x − ξ and once by the free node.
    """
    evidence = Evidence(True)
    for n in (1, 2, 3, 4):
        left = newton_of_polynomial(coefficients, [xi] * n + [x]).coefficients[-1]
        evidence &= vanishes(left - _integrals(form, n) / factorial(n - 1), f"n = {n}")
    return evidence


@claim(
    "lemma A.1.1.1",
    "Newton development: f(x) = f(x₀) + Σ (x−x₀)⋯(x−xₖ₋₁)[x₀, …, xₖ]f + (x−x₀)⋯(x−xₙ₋₁)[x₀, …, xₙ₋₁, x]f "
    "with k = 1, …, n − 1 (checked for n = 3).",
    method=Method.PROOF,
    form="f0 + (x - x0)*d1 + (x - x0)*(x - x1)*d2 + (x - x0)*(x - x1)*(x - x2)*free",
    wrong=(
        "f0 + (x - x0)*d1 + (x - x0)*(x - x1)*d2 + (x - x0)*(x - x1)*free",
        "f0 + (x - x0)*d1 + (x - x0)*(x - x1)*d2 + (x - x0)*(x - x1)*(x - x2)*d3",
    ),
)
def newton_development(form: str) -> Evidence:
    """free = [x₀, x₁, x₂, x]f, and d₃ = [x₀, x₁, x₂, x₂]f as a decoy.

    f is a polynomial of degree 5 with symbolic coefficients; the nodes are distinct, then x₁ = x₀, then all
    equal. Polynomials of that degree take all values and derivatives at the nodes and x, so the identity
    holds for every function.
    """
    evidence = Evidence(True)
    for name, at in (("distinct nodes", (0, 1, 2)), ("x₁ = x₀", (0, 0, 2)), ("x₂ = x₁ = x₀", (0, 0, 0))):
        x0, x1, x2 = (nodes[i] for i in at)
        d = newton_of_polynomial(coefficients, (x0, x1, x2, x2)).coefficients
        free = newton_of_polynomial(coefficients, (x0, x1, x2, x)).coefficients[-1]
        symbols = {"x": x, "x0": x0, "x1": x1, "x2": x2, "f0": d[0], "d1": d[1], "d2": d[2], "d3": d[3]}
        evidence &= vanishes(read(form, {**symbols, "free": free}) - polynomial, name)
    return evidence


@claim(
    "lemma A.1.1.3",
    "With all nodes at ξ the Newton development is Taylor's, with remainder "
    "(x−ξ)ⁿ/(n−1)! ∫₀¹ (1−u)ⁿ⁻¹ f⁽ⁿ⁾(ux + (1−u)ξ) du: for n ≤ 4.",
    method=Method.EXACT,
    form="(1 - u)**(n - 1), u*x + (1 - u)*xi",
    wrong=(
        "(1 - u)**n, u*x + (1 - u)*xi",
        "(1 - u)**(n - 1), x + (1 - u)*xi",
        "u**(n - 1), u*x + (1 - u)*xi",
    ),
)
def taylor_expansion(form: str) -> Evidence:
    """The Newton development at n nodes ξ gives the polynomial, whose kᵗʰ term must be f⁽ᵏ⁾(ξ)(x−ξ)ᵏ/k!.

    With the integral of the form times (x−ξ)ⁿ/(n−1)! it must add up to f, a polynomial of degree 5 with
    symbolic coefficients; n = 2, 3, 4.
    """
    evidence = Evidence(True)
    for n in (2, 3, 4):
        start = newton_of_polynomial(coefficients, [xi] * n)
        for k, c in enumerate(start.coefficients):
            derivative = sp.diff(polynomial, x, k).subs(x, xi)
            evidence &= vanishes(c - derivative / factorial(k), f"term {k}, n = {n}")
        remainder = (x - xi) ** n / factorial(n - 1) * _integrals(form, n)
        evidence &= vanishes(start(x) + remainder - polynomial, f"remainder, n = {n}")
    return evidence
