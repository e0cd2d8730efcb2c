"""Exact algebra of the checker: polynomials are dictionaries {exponents: Fraction}; text is never run.

Nothing of osculant is imported here: what the checker says does not rest on what it checks.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from math import comb, isqrt, lcm
from typing import Any

from osculant.certificates.check_numbers import Algebraic, current, exact, restricted
from osculant.certificates.check_taylor import taylor
from osculant.certificates.check_text import RATIONAL, ROOT, RejectedError, parsed, rational, require, spend

Exponents = tuple[int, ...]
Polynomial = dict[Exponents, Any]
Vector = list[Polynomial]
Row = dict[int, Any]

#: exponents of sums at most
HIGHEST = 10_000


def constant(value: Fraction | int, n: int) -> Polynomial:
    """A number as a polynomial in n variables."""
    return {(0,) * n: exact(value)} if value else {}


def plus(a: Polynomial, b: Polynomial, factor: Fraction | int = 1) -> Polynomial:
    """a + factor·b."""
    found = dict(a)
    for m, c in b.items():
        value = found.get(m, 0) + factor * c
        if value:
            found[m] = exact(value)
        else:
            found.pop(m, None)
    return found


def times(a: Polynomial, b: Polynomial, order: int | None = None) -> Polynomial:
    """a·b, without the terms above a degree if one is given.

    >>> times({(1,): Fraction(1)}, {(2,): Fraction(3)}) == {(3,): Fraction(3)}
    True
    """
    spend(len(a) * len(b))
    found: Polynomial = {}
    for m, c in a.items():
        room = None if order is None else order - sum(m)
        for k, d in b.items():
            if room is None or sum(k) <= room:
                e = tuple(x + y for x, y in zip(m, k))
                found[e] = found.get(e, Fraction(0)) + c * d
    return {m: c for m, c in found.items() if c}


def power(a: Polynomial, e: int, n: int, order: int | None = None) -> Polynomial:
    """a^e for e ≥ 0."""
    require(order is not None or len(a) < 2 or e <= HIGHEST, "a power that is too high")
    if order is not None and a and min(map(sum, a)) * e > order:
        return {}
    found = constant(1, n)
    while e:
        found = times(found, a, order) if e & 1 else found
        e >>= 1
        a = times(a, a, order) if e else a
    return found


def derivative(f: Polynomial, i: int) -> Polynomial:
    """∂f/∂xᵢ."""
    return {(*m[:i], m[i] - 1, *m[i + 1 :]): c * m[i] for m, c in f.items() if m[i]}


def composed(f: Polynomial, images: Sequence[Polynomial], n: int) -> Polynomial:
    """f(images), the images in n variables."""
    found: Polynomial = {}
    for m, c in f.items():
        term = constant(c, n)
        for image, e in zip(images, m):
            if e:
                term = times(term, power(image, e, n))
        found = plus(found, term)
    return found


def monomials(n: int, order: int, weights: Sequence[int] = ()) -> list[Exponents]:
    """All exponents of degree, or weight, at most ``order``."""
    require(isinstance(order, int) and order >= 0, f"{str(order)[:60]!r} is no order of jets")
    if not weights:
        spend(n * comb(n + order, n))
        return [
            tuple(chosen.count(i) for i in range(n))
            for d in range(order + 1)
            for chosen in combinations_with_replacement(range(n), d)
        ]
    found: list[Exponents] = [()]
    for i in range(n):
        spend(len(found) * (order // weights[i] + 1))
        found = [
            (*m, e) for m in found for e in range(order // weights[i] + 1) if weigh((*m, e), weights) <= order
        ]
    return found


def weigh(m: Exponents, weights: Sequence[int]) -> int:
    """The degree, with weights if there are some."""
    return sum(w * e for w, e in zip(weights, m)) if weights else sum(m)


def pivots(rows: Iterable[Mapping[int, Any]], prime: int | None = None) -> set[int]:
    """The leading columns of an echelon form, over ℚ or modulo a prime.

    >>> sorted(pivots([{0: Fraction(1), 1: Fraction(1)}, {0: Fraction(2), 1: Fraction(2)}]))
    [0]
    """
    found: dict[int, Row] = {}
    for given in rows:
        row: Row = dict(given)
        if prime is not None:  # whole multiples have no larger rank modulo the prime than over ℚ
            common = lcm(*(v.denominator for v in row.values()))
            row = {c: int(v * common) % prime for c, v in row.items()}
            row = {c: v for c, v in row.items() if v}
        while row:
            lead = min(row)
            if lead not in found:
                inverse = 1 / row[lead] if prime is None else pow(row[lead], -1, prime)
                found[lead] = {
                    c: v * inverse if prime is None else v * inverse % prime for c, v in row.items()
                }
                break
            factor = row[lead]
            spend(len(found[lead]))
            for c, v in found[lead].items():
                value = row.get(c, 0) - factor * v
                value = value if prime is None else value % prime
                if value:
                    row[c] = value
                else:
                    row.pop(c, None)
    return set(found)


def is_prime(p: Any) -> bool:
    """Whether a number below 2³² is a prime."""
    return isinstance(p, int) and 1 < p < 2**32 and all(p % d for d in range(2, isqrt(p) + 1))


def read(text: str, names: Sequence[str], order: int | None = None) -> Polynomial:
    """A formula in variables of these names as a polynomial; of an analytic one the jet of that order.

    Raises RejectedError for what is no such formula.

    >>> read("(x + 1/2)^2 - 1/4", ["x"]) == {(2,): Fraction(1), (1,): Fraction(1)}
    True
    >>> read("sin(x)", ["x"], 3) == {(1,): Fraction(1), (3,): Fraction(-1, 6)}
    True
    """
    field = current()
    return _Reader(len(names), order).value(parsed(text, names, None if field is None else field.name))


def number(value: Any) -> Any:
    """A number of a certificate: whole, the text of a quotient, or of a number of the field, not 0 then.

    >>> number("-3/6")
    Fraction(-1, 2)
    """
    if current() is None or not isinstance(value, str) or RATIONAL.fullmatch(value):
        return rational(value)
    found = read(value, (), 0).get((), Fraction(0))
    if isinstance(found, Algebraic):
        found.inverse()  # so it is not 0 whatever root generates the field
    return found


def rank_below(rows: Sequence[Mapping[int, Any]], prime: int) -> int:
    """A number that the rank is not less than: that modulo a prime, of a number field over ℚ."""
    field = current()
    if field is None:
        return len(pivots(rows, prime))
    return len(pivots(restricted(rows, field), prime)) // field.degree


class _Reader:
    """From a syntax tree to a polynomial; nothing is run."""

    def __init__(self, n: int, order: int | None) -> None:
        self.names, self.n, self.order = [f"v{i}" for i in range(n)], n, order

    def value(self, node: ast.expr) -> Polynomial:
        if isinstance(node, ast.Constant) and type(node.value) is int:
            return constant(node.value, self.n)
        if isinstance(node, ast.Name) and node.id == ROOT:
            return constant(generator(), self.n)
        if isinstance(node, ast.Name) and node.id in self.names:
            m = tuple(int(name == node.id) for name in self.names)
            return {} if self.order == 0 else {m: Fraction(1)}
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
            inner = self.value(node.operand)
            return plus({}, inner, -1) if isinstance(node.op, ast.USub) else inner
        if isinstance(node, ast.BinOp):
            return self.operation(node)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and len(node.args) == 1:
            return self.series(node.func.id, self.value(node.args[0]))
        raise RejectedError(f"{ast.unparse(node)[:60]!r} is no formula that the checker reads")

    def sum(self, node: ast.BinOp) -> Polynomial:
        """A sum, however many terms it has: its left operands are followed without recursion."""
        terms: list[tuple[int, ast.expr]] = []
        rest: ast.expr = node
        while isinstance(rest, ast.BinOp) and isinstance(rest.op, ast.Add | ast.Sub):
            terms.append((1 if isinstance(rest.op, ast.Add) else -1, rest.right))
            rest = rest.left
        found = self.value(rest)
        for sign, term in reversed(terms):
            found = plus(found, self.value(term), sign)
        return found

    def operation(self, node: ast.BinOp) -> Polynomial:
        if isinstance(node.op, ast.Add | ast.Sub):
            return self.sum(node)
        left, right = self.value(node.left), self.value(node.right)
        if isinstance(node.op, ast.Mult):
            return times(left, right, self.order)
        if isinstance(node.op, ast.Div):
            return times(left, self.series("^-1", right), self.order)
        require(isinstance(node.op, ast.Pow), "an operation that the checker does not read")
        require(set(right) <= {(0,) * self.n}, "an exponent that is no number")
        e = right.get((0,) * self.n, Fraction(0))
        if e.denominator == 1 and e >= 0:
            return power(left, int(e), self.n, self.order)
        return self.series(f"^{e}", left)

    def series(self, name: str, inner: Polynomial) -> Polynomial:
        """A function of a polynomial, by its Taylor series at the constant term."""
        at = inner.get((0,) * self.n, Fraction(0))
        rest = {m: c for m, c in inner.items() if any(m)}
        require(not rest or self.order is not None, f"{name} of a variable is no polynomial")
        found: Polynomial = {}
        for c in reversed(taylor(name, at, self.order if rest and self.order else 0)):
            found = plus(times(found, rest, self.order), constant(c, self.n))
        return found


def generator() -> Any:
    """The root that generates the number field; RejectedError if there is none."""
    field = current()
    if field is None:
        raise RejectedError("there is no number field")
    return field.generator
