"""Immersions at a point and in a direction, brought to a normal position by linear changes, exactly.

In normal position X : (Rⁿ, 0) → (R^{m+1}, 0) has the derivative (1 0)ᵀ, and the direction is that of the
first axis, in the source and in the target.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import ZERO, Node, number, to_text, variable
from osculant.cas.formulas.graph import substitute, variables
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import NumberField, exact
from osculant.cas.germs.even import BOUNDARY
from osculant.cas.germs.expansion import as_node, values_at_origin, with_roots
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import inverse, product, rank
from osculant.cas.germs.polynomials import LARGEST, Polynomial


class Immersion:
    """An immersion X at a point a, in the direction w: the germ p ↦ C·(X(a + B·p) − X(a)).

    Args:
        components: the formulas of X.
        source: the names of the source variables, in order.
        point: the coordinates of a, constants: rational, or roots of numbers.
        direction: the coordinates of w, such constants, not all 0.

    Attributes:
        components, source, point, direction: as given.
        names: the variables p: those of the source, or p1, …, pn if one of these is called u.
        source_frame: B by its rows, constants; w is its first column, the others are axes.
        target_frame: C by its rows.
        moved: the germ p ↦ X(a + B·p) − X(a).
        germ: the germ in normal position, C times that, with m + 1 components.
        n: the dimension of the source.
        field: the number field of its coefficients; None if they are rational.

    Raises DomainError for a wrong number of coordinates, a direction that is 0, a source variable that does
    not occur, a point where X is not analytic or no immersion, and for coefficients that are not algebraic.

    >>> print(Immersion.of("x, y, x*y", "x y", at="1, 0", direction="0, 1").germ)
    (x, y, x*y)
    """

    def __init__(
        self,
        components: Sequence[Node],
        source: Sequence[str],
        point: Sequence[Node],
        direction: Sequence[Node],
    ) -> None:
        self.source = given = tuple(source)
        self.components, self.point, self.direction = tuple(components), tuple(point), tuple(direction)
        Germ([variable(name) for name in given], given)  # refuses the names
        self.n = n = len(given)
        check_count("at", "coordinate", len(point), n)
        check_count("direction", "coordinate", len(direction), n)
        _check_occurring(components, given)
        self.names = tuple(f"p{i + 1}" for i in range(n)) if BOUNDARY in given else given
        _, field = constants("at", point, None)
        w, field = constants("direction", direction, field)
        if not any(w):
            raise DomainError(
                "direction: the direction is 0: give one with a coordinate other than 0.",
                argument="direction",
            )
        pivot = next(i for i, c in enumerate(w) if c)
        axes = [pivot, *(i for i in range(n) if i != pivot)]
        self.source_frame = [[direction[i], *(number(int(i == axis)) for axis in axes[1:])] for i in range(n)]
        p = [variable(name) for name in self.names]
        shifts = {name: combined(row, p) + a for name, row, a in zip(given, self.source_frame, point)}
        where = f"({', '.join(map(to_text, point))})"
        moved, _, self.field = moved_to_origin(substitute(components, shifts), self.names, field, where)
        self._place(moved, where)

    @classmethod
    def of(cls, text: str, source: str, at: str | None = None, direction: str | None = None) -> Immersion:
        """The immersion from formulas, by default at the origin and in the direction of the first variable.

        Raises FormulaError for what is no formula, and DomainError as the class.

        >>> print(Immersion.of("x, y, x**2 + y**3", "x y").germ)
        (x, y, x**2 + y**3)
        """
        names = source.split()
        axis = [number(int(i == 0)) for i in range(len(names))]
        return cls(
            parse_tuple(text, names),
            names,
            [ZERO] * len(names) if at is None else parse_tuple(at, ()),
            axis if direction is None else parse_tuple(direction, ()),
        )

    def _place(self, moved: Sequence[Node], where: str) -> None:
        """Find C, and with it the germ; the coordinates of X that are affine come first."""
        n = self.n
        self.moved = given = Germ(moved, self.names, None, self.field)
        slopes = immersed(given, where)
        affine = [
            f.polynomial(1) is not None for f in (Germ([g], self.names, None, self.field) for g in moved)
        ]
        tangent: list[int] = []
        for j in sorted(range(given.p), key=lambda j: (not affine[j], j)):
            if len(tangent) < n and rank([slopes[i] for i in (*tangent, j)], n) > len(tangent):
                tangent.append(j)
        tangent.sort()
        upper = inverse([slopes[j] for j in tangent])
        unit = [[exact(int(i == j)) for i in range(given.p)] for j in range(given.p)]
        first = product(upper, [unit[j] for j in tangent])
        rest = [j for j in range(given.p) if j not in tangent]
        below = [[exact(a - b) for a, b in zip(unit[j], product([slopes[j]], first)[0])] for j in rest]
        self.target_frame = [[self._node(c) for c in row] for row in (*first, *below)]
        germ = Germ([combined(row, moved) for row in self.target_frame], self.names, None, self.field)
        self.germ = expanded_if_polynomial(germ)
        self.field = self.germ.field

    def _node(self, value: Any) -> Node:
        return number(value) if self.field is None else self.field.expression(value)

    @cached_property
    def polynomial(self) -> tuple[Polynomial, ...] | None:
        """The components if they are polynomials, else None."""
        return self.germ.polynomial(LARGEST)

    @cached_property
    def projection(self) -> Germ:
        """The projection along the direction: all components but the first.

        Raises DomainError for an immersion with one component.
        """
        if self.germ.p < 2:
            raise DomainError("A projection of a map to the line has no component: give two at least.")
        return Germ(self.germ.components[1:], self.names, None, self.field)


def expanded_if_polynomial(germ: Germ) -> Germ:
    """The same germ; with its terms written out if it is a polynomial.

    >>> print(expanded_if_polynomial(Germ("(x + 1)**2 - 1", "x")))
    (2*x + x**2)
    """
    whole = germ.polynomial(LARGEST)
    if whole is None:
        return germ
    return Germ([written(f, germ.source, germ.field) for f in whole], germ.source, germ.boundary, germ.field)


def written(f: Polynomial, names: tuple[str, ...], field: NumberField | None) -> Node:
    """A polynomial as an expression, by degrees.

    >>> print(written({poly.monomial((2,)): 1, poly.monomial((1,)): 2}, ("x",), None))
    2*x + x**2
    """
    return as_node(dict(sorted(f.items())), names, field)


def combined(weights: Sequence[Node], nodes: Sequence[Node]) -> Node:
    """The sum of weights times nodes, without terms that are 0.

    >>> print(combined([number(1), ZERO, number(-2)], [variable("x"), variable("y"), variable("z")]))
    x + -2*z
    """
    total = ZERO
    for weight, node in zip(weights, nodes):
        total = total + weight * node
    return total


def constants(
    argument: str, values: Sequence[Node], field: NumberField | None
) -> tuple[list[Any], NumberField | None]:
    """(the exact values of constants, the field of them, which contains the one given).

    Raises DomainError, naming the argument, for what is neither rational nor made with roots of numbers.

    >>> constants("at", [number(2)], None)
    ([Fraction(2, 1)], None)
    """
    try:
        found, field = with_roots(tuple(values), (), 0, field)
    except DomainError as error:
        raise DomainError(f"{argument}: {error}", argument=argument) from None
    return [exact(f.get(0, 0)) for f in found], field


def immersed(germ: Germ, where: str) -> list[list[Any]]:
    """The derivative of a germ at the origin, by its rows; DomainError if it is no immersion.

    >>> immersed(Germ("x, x**2", "x"), "0")
    [[Fraction(1, 1)], [Fraction(0, 1)]]
    """
    n = germ.n
    slopes = [[exact(f.get(poly.variable(i, n), 0)) for i in range(n)] for f in germ.jet(1)]
    if (found := rank(slopes, n)) < n:
        raise DomainError(
            f"The map is no immersion at {where}: its derivative has rank {found} there, and that of an "
            f"immersion has {n}."
        )
    return slopes


def moved_to_origin(
    components: Sequence[Node],
    names: tuple[str, ...],
    field: NumberField | None,
    where: str,
    argument: str = "at",
) -> tuple[list[Node], list[Node], NumberField | None]:
    """(f − f(0), f(0), the field of these values); a DomainError names the point instead of the origin.

    >>> [list(map(str, nodes)) for nodes in moved_to_origin([variable("x") + 2], ("x",), None, "2")[:2]]
    [['x + 2 - 2'], ['2']]
    """
    try:
        values, field = values_at_origin(components, names, field)
        with_roots(tuple(components), names, 1, field)
    except DomainError as error:
        sentence = str(error).replace("at the origin", f"at {where}")
        raise DomainError(f"{argument}: {sentence}", argument=argument) from None
    return [f - c for f, c in zip(components, values)], values, field


def check_count(argument: str, what: str, count: int, wanted: int) -> None:
    """DomainError, naming the argument, unless there are as many as there are source variables."""
    if count != wanted:
        variables = f"{wanted} source variable{'s'[: wanted != 1]}"
        raise DomainError(
            f"{argument}: {count} {what}{'s'[: count != 1]} for {variables}: give one for each.",
            argument=argument,
        )


def _check_occurring(components: Sequence[Node], source: Sequence[str]) -> None:
    occurring = variables(components)
    for name in source:
        if name not in occurring:
            raise DomainError(
                f"The source variable {name} does not occur in the immersion: leave it out, or use it."
            )
