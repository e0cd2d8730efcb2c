"""Divided differences with nodes that may coincide, and the Newton development (thesis A.1).

A function enters as a `Taylor`: the coefficients f⁽ʲ⁾(x)/j! at any node, which Hermite data
provide; polynomials have a way of their own, without any division
(`osculant.cas.numbers.division`). Nodes and values are numbers of one kind: rationals, floats, mpmath
numbers, balls, sympy expressions, elements of a fraction field. Different symbols stand for different nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import factorial
from typing import TYPE_CHECKING, Any

import sympy as sp
from flint.utils.flint_exceptions import DomainError as NoQuotient
from sympy.polys.polyerrors import BasePolynomialError

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.numbers.power_series import ratio

if TYPE_CHECKING:
    pass

#: ``f(node, order)`` is the Taylor coefficient f⁽ᵒʳᵈᵉʳ⁾(node)/order!
Taylor = Callable[[Any, int], Any]


def exact(value: Any) -> Any:
    """Integers as rationals, so that they can be divided; every other kind of number as it is."""
    return Fraction(value) if isinstance(value, int) else value


def exact_nodes(nodes: Sequence[Any]) -> list[Any]:
    """Nodes with integers as rationals if all are rational; beside other numbers integers stay, as they mix.

    >>> exact_nodes([1, Fraction(1, 2)]), exact_nodes([1, 0.5])
    ([Fraction(1, 1), Fraction(1, 2)], [1, 0.5])
    """
    rational = all(isinstance(node, (int, Fraction)) for node in nodes)
    return [exact(node) for node in nodes] if rational else list(nodes)


def is_zero(value: Any, what: str = "A number") -> bool:
    """Whether a number is 0: exact kinds decide, floats by comparison, balls where they can.

    Raises UndecidedError, which begins with ``what``, for a ball around 0 and for a sympy expression whose
    vanishing sympy can neither prove nor refute.

    >>> is_zero(sp.sqrt(8) - 2 * sp.sqrt(2)), is_zero(sp.Symbol("a") - sp.Symbol("b"))
    (True, False)
    """
    if isinstance(value, sp.Basic):
        found = True if value == 0 else value.equals(0)
        if found is None:
            raise UndecidedError(f"{what} {value} may be 0 or not: sympy decides neither; simplify it first.")
        return bool(found)
    equal = bool(value == 0)
    if not equal and not bool(value != 0):
        raise UndecidedError(f"{what} {value} may be 0 or not: raise the precision of the balls.")
    return equal


def same_node(a: Any, b: Any) -> bool:
    """Whether two nodes are equal; one ball given twice, as one object, is one node.

    Raises DomainError if they are of kinds that do not mix, UndecidedError as `is_zero`.

    >>> same_node(Fraction(1, 2), 0.5), same_node(sp.Symbol("x0"), sp.Symbol("x1"))
    (True, False)
    """
    if a is b:
        return True
    try:
        difference = a - b
    except (TypeError, ValueError) as error:
        raise DomainError(f"The nodes {a!r} and {b!r} are of kinds that cannot be compared.") from error
    return is_zero(difference, "The distance of two nodes")


def _check(node: Any) -> None:
    """Refuse a node that is not a finite number."""
    try:
        difference = node - node
    except TypeError as error:
        raise DomainError(f"The node {node!r} is not a number.") from error
    if isinstance(difference, sp.Basic):
        finite = not difference.has(sp.nan, sp.zoo, sp.oo, -sp.oo)
    else:
        finite = difference.is_finite() if hasattr(difference, "is_finite") else difference == difference
    if not finite:
        raise DomainError(f"The node {node} is not finite.")


def hermite_data(pairs: Iterable[tuple[Any, Sequence[Any]]]) -> Taylor:
    """The function known by its values and derivatives at some nodes.

    Args:
        pairs: (node, (f, f′, f″, …)) with the derivatives at that node not divided by factorials.

    Raises DomainError for a node given twice. The function returned raises it for a node or an order that is
    not among them.

    >>> divided_difference(hermite_data([(0, (1, 2)), (1, (4,))]), [0, 1, 0])
    Fraction(1, 1)
    """
    known: list[tuple[Any, tuple[Any, ...]]] = []
    for given, derivatives in pairs:
        if any(same_node(at, given) for at, _ in known):
            raise DomainError(f"The node {given} is given twice: list all its derivatives at once.")
        known.append((exact(given), tuple(exact(v) for v in derivatives)))

    def coefficient(node: Any, order: int) -> Any:
        values = next((values for at, values in known if same_node(at, node)), None)
        if values is None:
            raise DomainError(f"No value is given at the node {node}: add one to the data.")
        if order >= len(values):
            raise DomainError(
                f"The node {node} is taken {order + 1} times and needs the derivatives up to order {order}, "
                f"but {len(values)} {'value is' if len(values) == 1 else 'values are'} given there."
            )
        return values[order] * ratio(1, factorial(order), values[order])

    return coefficient


@dataclass(frozen=True)
class NewtonForm:
    """The polynomial Σ cₖ (x − x₀) … (x − xₖ₋₁), which interpolates at x₀ … xₙ (A.1).

    nodes: x₀ … xₙ in the order given; coefficients: cₖ = [x₀, …, xₖ]f.

    >>> line = NewtonForm((Fraction(1), Fraction(2)), (Fraction(5), Fraction(3)))
    >>> line(4), line.polynomial() == (2, 3)
    (Fraction(14, 1), True)
    """

    nodes: tuple[Any, ...]
    coefficients: tuple[Any, ...]

    def __call__(self, x: Any) -> Any:
        """The value at x, a number of the same kind as the nodes."""
        value = self.coefficients[-1]
        for node, c in zip(self.nodes[-2::-1], self.coefficients[-2::-1]):
            value = value * (x - node) + c
        return value

    def polynomial(self) -> tuple[Any, ...]:
        """The interpolating polynomial's coefficients by powers of x, the constant one first."""
        found = [self.coefficients[-1]]
        for node, c in zip(self.nodes[-2::-1], self.coefficients[-2::-1]):
            above = [*found, found[0] * 0]  # the polynomial times x, shifted: times (x − node) below
            found = [c - node * found[0]] + [above[i] - node * above[i + 1] for i in range(len(found))]
        return tuple(found)

    def remainder(self, function: Taylor, x: Any) -> Any:
        """f(x) − p(x) = (x − x₀) … (x − xₙ) [x₀, …, xₙ, x]f (Lemma A.1.1)."""
        value = divided_difference(function, [*self.nodes, x])
        for node in self.nodes:
            value = value * (x - node)
        return value


def newton(function: Taylor, nodes: Sequence[Any]) -> NewtonForm:
    """The Newton development of a function at nodes x₀ … xₙ, in any order and with any coincidences.

    At a node taken m times the polynomial has the function's value and first m − 1 derivatives.

    Raises DomainError without nodes, for nodes that cannot be compared, and where the function does not know
    the derivatives that a node's multiplicity needs; UndecidedError where two nodes may be equal or not.

    >>> cube = hermite_data([(0, (0, 0)), (1, (1, 3))])
    >>> [str(c) for c in newton(cube, [0, 1, 1, 0]).coefficients]
    ['0', '1', '2', '1']
    """
    places, groups = _grouped(nodes)
    known: dict[tuple[int, ...], Any] = {}
    multiplicities = [0] * len(groups)
    coefficients = []
    for place in places:
        multiplicities[place] += 1
        coefficients.append(_difference(function, groups, tuple(multiplicities), known))
    return NewtonForm(tuple(groups[place] for place in places), tuple(coefficients))


def divided_difference(function: Taylor, nodes: Sequence[Any]) -> Any:
    """[x₀, …, xₙ]f, the coefficient of xⁿ in the polynomial that interpolates f at the nodes.

    Raises as `newton`.

    >>> divided_difference(hermite_data([(1, (1,)), (2, (8,)), (4, (64,))]), [4, 1, 2])
    Fraction(7, 1)
    """
    places, groups = _grouped(nodes)
    multiplicities = tuple(places.count(i) for i in range(len(groups)))
    return _difference(function, groups, multiplicities, {})


def _grouped(nodes: Sequence[Any]) -> tuple[list[int], list[Any]]:
    """For each node its place among the different ones, and these."""
    if not nodes:
        raise DomainError("A divided difference needs at least one node.")
    groups: list[Any] = []
    places = []
    for node in exact_nodes(nodes):
        _check(node)
        place = next((i for i, other in enumerate(groups) if same_node(other, node)), len(groups))
        if place == len(groups):
            groups.append(node)
        places.append(place)
    return places, groups


def _difference(
    function: Taylor, groups: list[Any], multiplicities: tuple[int, ...], known: dict[tuple[int, ...], Any]
) -> Any:
    """The divided difference with each node of ``groups`` as often as ``multiplicities`` says.

    It is symmetric in the nodes, so the recursion may part any two different ones: the first and the last,
    which keeps the differences met few.
    """
    if multiplicities not in known:
        present = [i for i, m in enumerate(multiplicities) if m > 0]
        first, last = present[0], present[-1]
        if first == last:
            value = exact(function(groups[first], multiplicities[first] - 1))
        else:
            without = [
                _difference(function, groups, _less(multiplicities, place), known) for place in (first, last)
            ]
            value = quotient(without[0] - without[1], groups[last] - groups[first])
        known[multiplicities] = value
    return known[multiplicities]


def _less(multiplicities: tuple[int, ...], place: int) -> tuple[int, ...]:
    return tuple(m - (i == place) for i, m in enumerate(multiplicities))


def quotient(value: Any, by: Any) -> Any:
    """value/by; raises DomainError where the ring of the values has no such quotient."""
    try:
        return value / by
    except (ArithmeticError, TypeError, NoQuotient, BasePolynomialError) as error:
        raise DomainError(
            f"{value} cannot be divided by {by} in its ring: take the fraction field, or give a polynomial."
        ) from error
