"""Claims of appendix A.1: how smooth divided differences are, and the division property."""

from __future__ import annotations

from math import factorial

import sympy as sp

from osculant.cas.claims.appendix_a import bracket, coefficients, nodes, x
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.division import difference_quotient, newton_of_polynomial
from osculant.cas.errors import DomainError


@claim(
    "section A.1-3",
    "For f of class Cᵐ, m ≥ n, [x₀, …, xₙ]f is of class Cᵐ⁻ⁿ in its nodes, and no better in general.",
    method=Method.PROOF,
    form="m - n",
    wrong=("m", "m - n + 1", "m - n - 1"),
)
def smoothness_in_all_nodes(form: str) -> Evidence:
    """Differentiating by a node doubles it: ∂/∂x₀ [x₀, …, xₙ]f = [x₀, x₀, x₁, …, xₙ]f.

    So j derivatives need n + j + 1 nodes, and by Hermite and Genocchi n + j derivatives of f, which are
    continuous for j ≤ m − n. On the diagonal, where all nodes are ξ, the difference is f⁽ⁿ⁾(ξ)/n!, which has
    exactly m − n continuous derivatives if f has exactly m.
    """
    evidence = Evidence(True)
    for count in (1, 2, 3):
        doubled = bracket(count + 1, nodes[0])
        evidence &= vanishes(sp.diff(bracket(count + 1), nodes[0]) - doubled, f"∂/∂x₀, n = {count}")
    return evidence & _last_derivative(form)


def _last_derivative(form: str) -> Evidence:
    """The last j for which j derivatives of a difference of order n, of order n + j, need at most m of f."""
    m, n, j = sp.symbols("m n j", integer=True)
    (last,) = sp.solve(n + j - m, j)
    return vanishes(read(form, {"m": m, "n": n}) - last, "class")


def _class_in_one_node(form: str) -> Evidence:
    evidence = Evidence(True)
    for count in (1, 2, 3):
        free = bracket(count, x)
        for j in (1, 2):
            multiple = factorial(j) * bracket(count, *[x] * (j + 1))
            evidence &= vanishes(sp.diff(free, x, j) - multiple, f"derivative {j}, n = {count}")
    m, n = 5, 2
    whole, divided = (_class_of_truncated_power(exponent) for exponent in (m + 1, m + 1 - n))
    stated = read(form, {"m": sp.Integer(whole), "n": sp.Integer(n)})
    line = (
        f"max(x, 0)^{m + 1} is of class C^{whole}, divided by x^{n} of class C^{divided} and no better; "
        f"the form says C^{stated}"
    )
    return evidence & _last_derivative(form) & Evidence(stated == divided, (line,))


def _class_of_truncated_power(exponent: int) -> int:
    """The class of max(x, 0)^exponent: the last derivative that tends to 0 at 0 from the right."""
    last = -1
    while sp.diff(x**exponent, x, last + 1).subs(x, 0) == 0:
        last += 1
    return last


@claim(
    "lemma A.1.1.2",
    "If f is of class Cᵐ, m ≥ n, then [x₀, …, xₙ₋₁, x]f is a function of class Cᵐ⁻ⁿ of x.",
    method=Method.PROOF,
    form="m - n",
    printed="n - m",
    erratum="Lemma A.1.1 prints the class of the last divided difference as C^(n−m); it is C^(m−n).",
    wrong=("m - n + 1", "m"),
)
def class_of_the_remainder(form: str) -> Evidence:
    """dʲ/dxʲ [x₀, …, xₙ₋₁, x]f = j! [x₀, …, xₙ₋₁, x, …, x]f with j + 1 nodes x.

    It has n + j + 1 nodes, so it is continuous as long as f has n + j continuous derivatives: j = m − n. That
    is sharp: the function max(x, 0)ᵐ⁺¹, divided by xⁿ.
    """
    return _class_in_one_node(form)


@claim(
    "lemma A.1.2.1",
    "A function with zeros x₁, …, xₙ, each with its multiplicity, is (x−x₁)⋯(x−xₙ)[x₁, …, xₙ, x]f.",
    method=Method.PROOF,
    form="a zero as often as it is given",
    wrong=("a zero once",),
)
def division_property(form: str) -> Evidence:
    """f is a polynomial with symbolic coefficients times x − z for the zeros z that the form allows.

    Zeros are given as (x₀, x₁, x₂), (x₀, x₀, x₁) and (x₀, x₀, x₀). Division must leave nothing, the quotient
    must be the divided difference with x as a further node, and times the factors it must be f again.
    """
    evidence = Evidence(True)
    for given in ((0, 1, 2), (0, 0, 1), (0, 0, 0)):
        zeros = [nodes[i] for i in given]
        match form:
            case "a zero as often as it is given":
                factors = zeros
            case "a zero once":
                factors = sorted(set(zeros), key=str)
            case _:
                raise DomainError(
                    f"The division property has no form {form!r}: zeros count once or as given."
                )
        f = sp.Poly(sum(c * x**i for i, c in enumerate(coefficients[:4])), x)
        for zero in factors:
            f *= sp.Poly(x - zero, x)
        ascending = [sp.expand(c) for c in reversed(f.all_coeffs())]
        free = newton_of_polynomial(ascending, [*zeros, x]).coefficients[-1]
        product = sp.prod([x - zero for zero in zeros]) * free
        evidence &= vanishes(product - f.as_expr(), f"zeros {zeros}")
        if not evidence:
            return evidence
        quotient = difference_quotient(ascending, zeros)
        divided = sum(c * x**i for i, c in enumerate(quotient))
        evidence &= vanishes(divided - free, f"quotient by zeros {zeros}")
    return evidence


@claim(
    "lemma A.1.2.2",
    "The quotient [x₁, …, xₙ, x]f of a function of class Cᵐ by its n zeros is of class Cᵐ⁻ⁿ.",
    method=Method.PROOF,
    form="m - n",
    wrong=("n - m", "m - n - 1", "m - n + 1"),
)
def class_of_the_quotient(form: str) -> Evidence:
    """The derivation of Lemma A.1.1.2, with the zeros as nodes."""
    return _class_in_one_node(form)
