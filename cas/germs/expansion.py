"""Expressions as polynomials cut above a degree, with coefficients in ℚ or a number field."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import Any, NamedTuple

from flint import fmpz

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import ZERO, Node, call, number, power, to_text, variable
from osculant.cas.formulas.graph import fold, topological, variables
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import Algebraic, NumberField, exact
from osculant.cas.germs.polynomials import LARGEST, Number, Polynomial
from osculant.cas.germs.radicals import extended, positive
from osculant.cas.numbers.fields import ExactNumbers
from osculant.cas.numbers.taylor import program

#: products of terms that may be made to expand a polynomial as a whole
EXPANSION = 2_000_000


class UnknownRootError(DomainError):
    """The positive root of that ``degree`` ``of`` a number is irrational, and not known."""

    def __init__(self, degree: int, of: Any) -> None:
        super().__init__(f"The root of degree {degree} of {of} is irrational.")
        self.degree, self.of = degree, of


@lru_cache(maxsize=256)
def expanded(
    components: tuple[Node, ...], source: tuple[str, ...], order: int, field: NumberField | None = None
) -> tuple[Polynomial, ...]:
    """Expressions in the source variables as polynomials cut above degree ``order``; errors as for `Germ`.

    Raises UnknownRootError, a DomainError, for an irrational root of a number that the field does not know.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> expanded(parse_tuple("1 + x", ("x",)), ("x",), 2) == ({0: 1, poly.variable(0, 1): 1},)
    True
    """
    if not 0 <= order <= LARGEST:
        raise DomainError(f"A jet of order {order} was asked for; orders 0 to {LARGEST} are possible.")
    expand = _Expansion(source, order, field)
    values: dict[Node, Polynomial] = {}
    for node in topological(components):
        values[node] = expand.node(node, [values[a] for a in node.args])
    return tuple(values[node] for node in components)


def moving_nodes(components: Sequence[Node], source: Sequence[str]) -> set[Node]:
    """The nodes of expressions that depend on the source variables; the others are numbers."""
    found: set[Node] = set()
    for node in topological(components):
        if node.value in source if node.kind == "variable" else any(a in found for a in node.args):
            found.add(node)
    return found


def with_roots(
    components: tuple[Node, ...], source: tuple[str, ...], order: int, field: NumberField | None
) -> tuple[tuple[Polynomial, ...], NumberField | None]:
    """(the expansion, the field): extended by the roots that are met."""
    while True:
        try:
            return expanded(components, source, order, field), field
        except UnknownRootError as root:
            field = extended(field, root.degree, root.of)


def values_at_origin(
    components: Sequence[Node], source: tuple[str, ...], field: NumberField | None = None
) -> tuple[list[Node], NumberField | None]:
    """(the values at the origin as expressions, the field of them, which contains the one given)."""
    jet, field = with_roots(tuple(components), source, 0, field)
    values = [exact(f.get(0, 0)) for f in jet]
    return [number(c) if field is None else field.expression(c) for c in values], field


def as_node(f: Polynomial, source: tuple[str, ...], field: NumberField | None = None) -> Node:
    """A polynomial as an expression in the source variables, with coefficients that may be of the field.

    >>> print(as_node({poly.monomial((1,)): 2, poly.monomial((2,)): -1}, ("x",)))
    2*x - x**2
    """
    total = number(0)
    for m, c in f.items():
        term = number(1)
        for name, e in zip(source, poly.exponents_of(m, len(source))):
            term = term * variable(name) ** e
        if isinstance(c, Algebraic):
            assert field is not None
            total = total + field.expression(c) * term
            continue
        negative = c < 0 and total is not ZERO
        total = total - number(-c) * term if negative else total + number(c) * term
    return total


class Size(NamedTuple):
    """Upper bounds of a polynomial expression: degree, terms, and products of terms that make it."""

    degree: int
    terms: int
    work: int


def size_of(root: Node, source: tuple[str, ...]) -> Size:
    """The size of a polynomial expression in the source variables; others are numbers."""
    n = len(source)

    def most(degree: int) -> int:
        return comb(n + degree, n)

    def rule(node: Node, args: list[Size]) -> Size:
        work = sum(a.work for a in args)
        if node.kind == "variable":
            return Size(int(node.value in source), 1, 0)
        if not any(a.degree for a in args):
            return Size(0, 1, work)
        if node.kind == "mul":
            degree, products = args[0].degree + args[1].degree, args[0].terms * args[1].terms
            return Size(degree, min(products, most(degree)), work + products)
        if node.kind == "pow":
            e, (degree, terms, _) = int(node.value), args[0]
            if terms == 1:
                return Size(degree * e, 1, work)
            half = comb(terms - 1 + e // 2, min(terms - 1, e // 2)) if terms + e < LARGEST else EXPANSION
            half = min(half, most(degree * (e // 2)))
            return Size(degree * e, most(degree * e), work + 2 * half * half)  # the last squaring and before
        return Size(max((a.degree for a in args), default=0), sum(a.terms for a in args) or 1, work)

    return fold([root], rule)[0]


class _Expansion:
    """The rules by which the nodes of an expression become polynomials cut above a degree."""

    def __init__(self, source: tuple[str, ...], order: int, field: NumberField | None) -> None:
        self.source, self.n, self.order, self.field = source, len(source), order, field

    def node(self, node: Node, args: list[Polynomial]) -> Polynomial:
        if node.kind == "number":
            return {0: _plain(node.value)} if node.value else {}
        if node.kind == "variable":
            if self.field is not None and node.value == self.field.name:
                return {0: self.field.generator}
            m = poly.variable(self.source.index(node.value), self.n)
            return poly.cut({m: 1}, self.n, self.order)
        if node.kind in {"add", "sub"}:
            return poly.plus(args[0], args[1], 1 if node.kind == "add" else -1)
        if node.kind == "neg":
            return poly.plus({}, args[0], -1)
        if node.kind == "mul":
            return poly.times(args[0], args[1], self.n, self.order)
        if node.kind == "div":
            inverse = self.composed(args[1], node, lambda x: power(x, number(-1)))
            return poly.times(args[0], inverse, self.n, self.order)
        if node.kind == "pow" and node.value.denominator == 1 and node.value >= 0:
            return self.whole_power(args[0], int(node.value))
        if node.kind == "pow":
            return self.composed(args[0], node, lambda x: power(x, number(node.value)))
        if node.kind == "call":
            return self.composed(args[0], node, lambda x: call(node.value, x))
        raise DomainError(
            f"{to_text(node)} is neither rational nor algebraic: the coefficients of a germ must be."
        )

    def whole_power(self, base: Polynomial, exponent: int) -> Polynomial:
        if poly.order_of(base, self.n) * exponent > self.order:
            return {}
        result: Polynomial = {0: 1}
        while exponent:
            if exponent & 1:
                result = poly.times(result, base, self.n, self.order)
            exponent >>= 1
            if exponent:
                base = poly.times(base, base, self.n, self.order)
        return result

    def composed(self, inner: Polynomial, node: Node, function: Any) -> Polynomial:
        """function(inner), from the Taylor coefficients of the function at inner's constant term."""
        rest = {m: c for m, c in inner.items() if m}
        order = self.order if variables(node.args[-1:]) else 0  # a number has no series
        at = exact(inner.get(0, 0))
        exponent = {"sqrt": Fraction(1, 2), "cbrt": Fraction(1, 3)}.get(node.value)
        if node.kind in {"pow", "div"}:
            exponent = Fraction(-1) if node.kind == "div" else node.value
        if at and exponent is not None and (isinstance(at, Algebraic) or exponent.denominator > 1):
            coefficients = self.binomial(at, exponent, order, node)
        elif isinstance(at, Algebraic):
            raise DomainError(f"{to_text(node)} has an irrational Taylor coefficient at the origin.")
        else:
            coefficients = self.taylor(at, order, node, function)
        result: Polynomial = {}
        for c in reversed(coefficients):
            result = poly.times(result, rest, self.n, self.order)
            result = poly.plus(result, {0: c})
        return result

    def binomial(self, at: Any, exponent: Fraction, order: int, node: Node) -> list[Number]:
        """The Taylor coefficients of a power at a number that is not 0."""
        q = exponent.denominator
        sign = 1 if node.value != "cbrt" or positive(at) else -1  # a cube root is real
        known = {} if self.field is None else self.field.roots
        root = at if q == 1 else _rational_root(at * sign, q) or known.get((q, at * sign))
        if root is None and not positive(at * sign):
            raise DomainError(f"{to_text(node)} is not analytic at the origin.")
        if root is None:
            raise UnknownRootError(q, at * sign)
        found = [exact((root * sign if q > 1 else root) ** exponent.numerator)]
        for k in range(order):
            found.append(found[-1] * (exponent - k) / (k + 1) / at)
        return [_plain(c) for c in found]

    def taylor(self, at: Fraction, order: int, node: Node, function: Any) -> list[Number]:
        t = variable("t")
        try:
            values = program([function(number(at) + t)], order, normalised=True).run(
                ExactNumbers().number(Fraction(0)), ExactNumbers()
            )[0]
        except (DomainError, ZeroDivisionError) as error:
            raise DomainError(f"{to_text(node)} is not analytic at the origin.") from error
        if any(not getattr(v, "is_finite", False) for v in values):
            raise DomainError(f"{to_text(node)} is not analytic at the origin.")
        if any(not v.is_Rational for v in values):
            raise DomainError(f"{to_text(node)} has an irrational Taylor coefficient at the origin.")
        return [_plain(Fraction(int(v.p), int(v.q))) for v in values]


def _plain(value: Any) -> Number:
    return int(value) if not isinstance(value, Algebraic) and value.denominator == 1 else value


def _rational_root(value: Any, degree: int) -> Fraction | None:
    """The positive rational root of a number; None if there is none."""
    if isinstance(value, Algebraic) or value <= 0:
        return None
    parts = [fmpz(value.numerator).root(degree), fmpz(value.denominator).root(degree)]
    root = Fraction(*map(int, parts))
    return root if root**degree == value else None
