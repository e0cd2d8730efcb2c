"""Germs at other points, moved to the origin: f(a + x) − f(a), exactly."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node, number, variable
from osculant.cas.formulas.graph import substitute
from osculant.cas.germs.algebraic import NumberField
from osculant.cas.germs.expansion import as_node, values_at_origin
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import LARGEST


def moved(
    components: Sequence[Node],
    source: Sequence[str],
    point: Sequence[Fraction],
    boundary: str | None = None,
    field: NumberField | None = None,
) -> Germ:
    """The germ of f at a point as a germ at the origin, x ↦ f(a + x) − f(a); polynomials are expanded.

    Args:
        components: the formulas of f.
        source: the names of the source variables, in order.
        point: the coordinates a of the point, as many.
        boundary: as for `Germ`; the point must lie on H = {u = 0}.
        field: the number field of the coefficients, if it is stated.

    Raises DomainError for a wrong number of coordinates, for a point off H or where f is not analytic or has
    Taylor coefficients that are not rational, and for what `Germ` refuses.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> print(moved(parse_tuple("x, x*y**2", ("x", "y")), ["x", "y"], [Fraction(1), Fraction(0)]))
    (x, x*y**2 + y**2)
    """
    names = tuple(source)
    if len(point) != len(names):
        count = f"{len(point)} coordinate{'s'[: len(point) != 1]}"
        raise DomainError(f"at: {count} for {len(names)} source variables: give one for each.", argument="at")
    origin = Germ([variable(name) for name in names], names, boundary, field)  # refuses the names
    u = origin.boundary
    if u is not None and (height := point[names.index(u)]):
        raise DomainError(
            f"at: the point has {u} = {height} and is off the boundary {u} = 0: give 0 for {u}, or call the "
            "variable otherwise.",
            argument="at",
        )
    shifts = {name: variable(name) + number(a) for name, a in zip(names, point)}
    shifted = tuple(substitute(components, shifts))
    # a function f − f(a) that is written so is 0 at the origin, whatever number f(a) is
    values, field = values_at_origin(shifted, names, field)
    germ = Germ([f - c for f, c in zip(shifted, values)], names, boundary, field)
    jet = germ.polynomial(LARGEST)
    return (
        germ
        if jet is None
        else Germ([as_node(f, names, germ.field) for f in jet], names, boundary, germ.field)
    )
