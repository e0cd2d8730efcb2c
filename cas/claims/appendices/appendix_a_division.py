"""Claims of appendix A.1: how smooth divided differences are, and the division property."""

from __future__ import annotations

from collections.abc import Callable
from math import factorial
from typing import Any

import sympy as sp

from osculant.cas.claims.appendices.brackets import bracket, coefficients, nodes, x
from osculant.cas.claims.claim import Evidence, Method, claim
from osculant.cas.claims.proof import read, vanishes
from osculant.cas.errors import DomainError
from osculant.cas.numbers.division import difference_quotient, newton_of_polynomial


@claim(
    "section A.1-3",
    "For f of class Cᵐ, m ≥ n, [x₀, …, xₙ]f is of class Cᵐ⁻ⁿ in its nodes, and no better in general: for m "
    "≤ 6.",
    method=Method.EXACT,
    form="m - n",
    wrong=("m", "m - n + 1", "m - n - 1"),
)
def smoothness_in_all_nodes(form: str) -> Evidence:
    """Differentiating by a node doubles it: ∂/∂x₀ [x₀, …, xₙ]f = [x₀, x₀, x₁, …, xₙ]f.

    So j derivatives need the nodes x₀, …, xₙ and j more, and by Hermite and Genocchi as many derivatives of f
    as there are nodes, less one: those are counted, for m ≤ 6. That there are no more is seen on f = xᵐ|x|,
    of class Cᵐ: on the diagonal, where all nodes are ξ, its difference is f⁽ⁿ⁾(ξ)/n!.
    """
    evidence = Evidence(True)
    for count in (1, 2, 3):
        doubled = bracket(count + 1, nodes[0])
        evidence &= vanishes(sp.diff(bracket(count + 1), nodes[0]) - doubled, f"∂/∂x₀, n = {count}")

    def diagonal(side: Any, n: int) -> Any:
        return sp.diff(side, x, n) / factorial(n)

    return evidence & _classes(form, lambda n, j: n + 1 + j, diagonal)


def _classes(
    form: str, nodes_needed: Callable[[int, int], int], difference: Callable[[Any, int], Any]
) -> Evidence:
    """The form as a class, for f = xᵐ|x| and all n ≤ m ≤ 6.

    From below: the last j for which the j-th derivative of the difference needs at most m derivatives of f,
    given how many nodes it has. From above: the class of the difference of xᵐ|x|, whose sides are ±xᵐ⁺¹.
    """
    evidence = Evidence(True)
    for m in range(1, 7):
        sides = (x ** (m + 1), -(x ** (m + 1)))
        for n in range(1, m + 1):
            stated = read(form, {"m": sp.Integer(_class(*sides)), "n": sp.Integer(n)})
            granted = max(j for j in range(-1, m + 1) if nodes_needed(n, j) - 1 <= m)
            reached = _class(*(difference(side, n) for side in sides))
            line = f"xᵐ|x|, m = {m}, n = {n}: class {granted} granted, {reached} found, {stated} in the form"
            if not granted == reached == stated:
                return Evidence(False, (line,))
            evidence = Evidence(True, (f"all n ≤ m ≤ 6; the last: {line}",))
    return evidence


def _class(right: Any, left: Any) -> int:
    """The class at 0 of the function with these polynomials to the right and to the left."""
    jump = sp.Poly(sp.expand(right - left), x)
    return int(min(power for (power,) in jump.monoms())) - 1


@claim(
    "lemma A.1.1.2",
    "If f is of class Cᵐ, m ≥ n, then [x₀, …, xₙ₋₁, x]f is a function of class Cᵐ⁻ⁿ of x: for m ≤ 6.",
    method=Method.EXACT,
    form="m - n",
    printed="n - m",
    erratum="Lemma A.1.1 prints the class of the last divided difference as C^(n−m); it is C^(m−n).",
    wrong=("m - n + 1", "m"),
)
def class_of_the_remainder(form: str) -> Evidence:
    """dʲ/dxʲ [x₀, …, xₙ₋₁, x]f = j! [x₀, …, xₙ₋₁, x, …, x]f with j + 1 nodes x.

    Its n + j + 1 nodes want n + j continuous derivatives of f; they are counted for m ≤ 6. That there are no
    more is seen on f = xᵐ|x| with all nodes at 0, whose sides are divided by the program.
    """
    evidence = Evidence(True)
    for count in (1, 2, 3):
        free = bracket(count, x)
        for j in (1, 2):
            multiple = factorial(j) * bracket(count, *[x] * (j + 1))
            evidence &= vanishes(sp.diff(free, x, j) - multiple, f"derivative {j}, n = {count}")

    def difference(side: Any, n: int) -> Any:
        return newton_of_polynomial(_ascending(side), [sp.S.Zero] * n + [x]).coefficients[-1]

    return evidence & _classes(form, lambda n, j: n + j + 1, difference)


def _ascending(polynomial: Any) -> list[Any]:
    return list(reversed(sp.Poly(polynomial, x).all_coeffs()))


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
    "The quotient [x₁, …, xₙ, x]f of a function of class Cᵐ by its n zeros is of class Cᵐ⁻ⁿ: for m ≤ 6.",
    method=Method.EXACT,
    form="m - n",
    wrong=("n - m", "m - n - 1", "m - n + 1"),
)
def class_of_the_quotient(form: str) -> Evidence:
    """The quotient is the divided difference of Lemma A.1.1.2, which grants the class Cᵐ⁻ⁿ: nodes counted.

    That it is no better in general is seen on (1 + x)xᵐ|x|, divided by the program by its zero 0, n times:
    both sides of the quotient against each other. Where f has no zero the quotient is as smooth as f.
    """

    def quotient(side: Any, n: int) -> Any:
        divided = difference_quotient(_ascending(sp.expand((1 + x) * side)), [sp.S.Zero] * n)
        return sum(c * x**i for i, c in enumerate(divided))

    return _classes(form, lambda n, j: n + 1 + j, quotient)
