"""Map-germs (Kⁿ,0) → (Kᵖ,0) with rational coefficients: polynomial, or analytic and expanded as asked."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import Any, NamedTuple

from osculant.cas.errors import DomainError, FormulaError
from osculant.cas.formulas.expression import ZERO, Node, call, number, power, to_text, variable
from osculant.cas.formulas.graph import fold, topological, variables
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.polynomials import LARGEST, Number, Polynomial
from osculant.cas.numbers.fields import ExactNumbers
from osculant.cas.numbers.taylor import program

#: products of terms that may be made to expand a polynomial as a whole
EXPANSION = 2_000_000


class Germ:
    """A map-germ f = (f₁, …, fₚ) with f(0) = 0.

    Args:
        components: the formulas of f₁, …, fₚ, separated by commas, or their expression nodes.
        source: the names of the source variables, in order, separated by spaces.
        boundary: the name of the variable u with H = {u = 0}, for the groups that preserve H; by default the
            variable called ``u`` if there is one.

    Raises FormulaError for text that is no formula, DomainError for a germ that is not analytic at 0, does
    not vanish there or has coefficients that are not rational, and for a boundary that is no variable.

    >>> fold = Germ("x, y**2", "x y")
    >>> fold.n, fold.p, fold.rank
    (2, 2, 1)
    >>> Germ("sin(x) + y", "x y").text(3)
    ('-x**3/6 + x + y',)
    """

    def __init__(
        self, components: str | Sequence[Node], source: str | Sequence[str], boundary: str | None = None
    ) -> None:
        self.source = tuple(source.replace(",", " ").split() if isinstance(source, str) else source)
        if not self.source or len(set(self.source)) < len(self.source):
            raise DomainError(
                f"The source variables {' '.join(self.source)!r} must be one or more, all different."
            )
        nodes = parse_tuple(components, self.source) if isinstance(components, str) else tuple(components)
        if not nodes:
            raise DomainError("A germ has at least one component: give a formula.")
        unknown = sorted(variables(nodes) - set(self.source))
        if unknown:
            raise FormulaError(
                f"The germ uses {', '.join(unknown)}, not among its source variables: add them."
            )
        self.components = nodes
        #: what was computed of this germ, by those who did
        self.known: dict[Hashable, Any] = {}
        if boundary is None and "u" in self.source:
            boundary = "u"
        if boundary is not None and boundary not in self.source:
            raise DomainError(
                f"The boundary variable {boundary!r} is not a source variable: choose one of "
                f"{', '.join(self.source)}."
            )
        self.boundary = boundary
        for i, f in enumerate(self.jet(1), start=1):
            if f.get(0, 0):
                raise DomainError(f"Component {i} of the germ is {f[0]} at the origin, not 0: subtract it.")

    @property
    def n(self) -> int:
        """The source dimension."""
        return len(self.source)

    @property
    def p(self) -> int:
        """The target dimension."""
        return len(self.components)

    @property
    def boundary_index(self) -> int:
        """The place of u among the source variables; raises DomainError if there is no boundary."""
        if self.boundary is None:
            raise DomainError(
                "An (H) group needs the boundary variable u of H = {u = 0}: name one of "
                f"{', '.join(self.source)} as the boundary."
            )
        return self.source.index(self.boundary)

    @property
    def rank(self) -> int:
        """The rank of df at 0."""
        from flint import fmpq, fmpq_mat

        rows = [[f.get(poly.variable(i, self.n), 0) for i in range(self.n)] for f in self.jet(1)]
        entries = [fmpq(Fraction(c).numerator, Fraction(c).denominator) for row in rows for c in row]
        return int(fmpq_mat(self.p, self.n, entries).rank())

    def jet(self, order: int) -> tuple[Polynomial, ...]:
        """The components up to that degree; raises DomainError above degree 63 or off the analytic domain."""
        return expanded(self.components, self.source, order)

    def polynomial(self, degree: int) -> tuple[Polynomial, ...] | None:
        """The components as polynomials, if they are polynomials of at most that degree; else None.

        None too if the work of expanding them is not bounded by `EXPANSION` beforehand.

        >>> Germ("exp(x) - 1", "x").polynomial(10) is None
        True
        >>> Germ("x*(1 + x + y)**3000", "x y").polynomial(LARGEST) is None
        True
        """
        kinds = {"number", "variable", "add", "sub", "neg", "mul", "div", "pow"}
        for node in topological(self.components):
            whole = node.kind != "pow" or (node.value.denominator == 1 and node.value >= 0)
            if node.kind not in kinds or not whole or (node.kind == "div" and variables(node.args[1:])):
                return None
        sizes = [_size(node, self.n) for node in self.components]
        bound = max(size.degree for size in sizes)
        return None if bound > degree or sum(s.work for s in sizes) > EXPANSION else self.jet(bound)

    def truncated(self, order: int) -> Germ:
        """The jet of that order, as a polynomial germ.

        >>> str(Germ("sin(x)", "x").truncated(3))
        '((-1/6)*x**3 + x)'
        """
        return Germ([as_node(f, self.source) for f in self.jet(order)], self.source, self.boundary)

    def text(self, order: int) -> tuple[str, ...]:
        """The components of the jet as text, to show."""
        import sympy

        symbols = sympy.symbols(self.source)
        return tuple(
            str(
                sympy.Add(
                    *(
                        sympy.Rational(Fraction(c).numerator, Fraction(c).denominator)
                        * sympy.prod(s**e for s, e in zip(symbols, poly.exponents_of(m, self.n)))
                        for m, c in f.items()
                    )
                )
            )
            for f in self.jet(order)
        )

    def __str__(self) -> str:
        return f"({', '.join(to_text(node) for node in self.components)})"

    def __repr__(self) -> str:
        return f"Germ({', '.join(to_text(node) for node in self.components)!r}, {' '.join(self.source)!r})"


@lru_cache(maxsize=256)
def expanded(components: tuple[Node, ...], source: tuple[str, ...], order: int) -> tuple[Polynomial, ...]:
    """Expressions in the source variables as polynomials cut above degree ``order``; errors as for `Germ`.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> expanded(parse_tuple("1 + x", ("x",)), ("x",), 2) == ({0: 1, poly.variable(0, 1): 1},)
    True
    """
    if not 0 <= order <= LARGEST:
        raise DomainError(f"A jet of order {order} was asked for; orders 0 to {LARGEST} are possible.")
    expand = _Expansion(source, order)
    values: dict[Node, Polynomial] = {}
    for node in topological(components):
        values[node] = expand.node(node, [values[a] for a in node.args])
    return tuple(values[node] for node in components)


def as_node(f: Polynomial, source: tuple[str, ...]) -> Node:
    """A polynomial as an expression in the source variables.

    >>> print(as_node({poly.monomial((1,)): 2, poly.monomial((2,)): -1}, ("x",)))
    2*x - x**2
    """
    total = number(0)
    for m, c in f.items():
        term = number(1)
        for name, e in zip(source, poly.exponents_of(m, len(source))):
            term = term * variable(name) ** e
        negative = c < 0 and total is not ZERO
        total = total - number(-c) * term if negative else total + number(c) * term
    return total


class _Size(NamedTuple):
    """Upper bounds of a polynomial expression: degree, terms, and products of terms that make it."""

    degree: int
    terms: int
    work: int


def _size(root: Node, n: int) -> _Size:
    """The size of a polynomial expression in n variables."""

    def most(degree: int) -> int:
        return comb(n + degree, n)

    def rule(node: Node, args: list[_Size]) -> _Size:
        work = sum(a.work for a in args)
        if node.kind == "variable":
            return _Size(1, 1, 0)
        if node.kind == "mul":
            degree, products = args[0].degree + args[1].degree, args[0].terms * args[1].terms
            return _Size(degree, min(products, most(degree)), work + products)
        if node.kind == "pow":
            e, (degree, terms, _) = int(node.value), args[0]
            if terms == 1:
                return _Size(degree * e, 1, work)
            half = comb(terms - 1 + e // 2, min(terms - 1, e // 2)) if terms + e < LARGEST else EXPANSION
            half = min(half, most(degree * (e // 2)))
            return _Size(degree * e, most(degree * e), work + 2 * half * half)  # the last squaring and before
        return _Size(max((a.degree for a in args), default=0), sum(a.terms for a in args) or 1, work)

    return fold([root], rule)[0]


class _Expansion:
    """The rules by which the nodes of an expression become polynomials cut above a degree."""

    def __init__(self, source: tuple[str, ...], order: int) -> None:
        self.source, self.n, self.order = source, len(source), order

    def node(self, node: Node, args: list[Polynomial]) -> Polynomial:
        if node.kind == "number":
            return {0: _plain(node.value)} if node.value else {}
        if node.kind == "variable":
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
        raise DomainError(f"{to_text(node)} is not rational: the coefficients of a germ must be.")

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
        coefficients = self.taylor(Fraction(inner.get(0, 0)), order, node, function)
        result: Polynomial = {}
        for c in reversed(coefficients):
            result = poly.times(result, rest, self.n, self.order)
            result = poly.plus(result, {0: c})
        return result

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


def _plain(value: Fraction) -> Number:
    return int(value) if value.denominator == 1 else value
