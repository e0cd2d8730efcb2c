"""Complete transversals (Bruce, Kirk and du Plessis): what the next degree can add, up to equivalence.

For a k-jet f and the homogeneous terms H of degree k + 1: if H ⊂ T + (L·f mod M^{k+2}) ∩ H with L the Lie
algebra of G₁, every (k + 1)-jet over f is G₁-equivalent to f + t with t ∈ T. Nilpotent linear fields may join
L if H is filtered by a weight that each of them raises; T is then found weight by weight, and only those l ∈
L are used that do not move the terms chosen before, so that the result is complete for all their
coefficients.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.linear_fields import LinearField, linear_fields
from osculant.cas.germs.tangent import JetSpace, Vector, vectors
from osculant.cas.germs.tangent_space import independent_columns

Term = tuple[int, int]

#: columns of the largest matrix made
CAP = 14000


def transversal(
    germ: Germ, k: int, name: str | Group, order_of_coordinates: str | Sequence[str] = ()
) -> tuple[Term, ...]:
    """A complete (k + 1)-transversal over the k-jet of a germ, as terms (monomial, component).

    Args:
        germ: its k-jet is taken.
        k: the degree of the jet, at least 1.
        name: the group.
        order_of_coordinates: source variables and target coordinates y1, y2, …, the lightest first: fields
            x_a ∂/∂x_b and y_i ∂/∂y_j with a, i after b, j join G₁. None by default.

    Raises DomainError for k < 1 and for names that are no coordinates, UndecidedError above `CAP` columns.

    >>> [poly.exponents_of(m, 2) for m, _ in transversal(Germ("x, x*y", "x y"), 2, "A")]
    [(0, 3)]
    """
    if k < 1:
        raise DomainError(f"A transversal over a {k}-jet was asked for: the degree must be at least 1.")
    g, jet = group(name), germ.truncated(k)
    space = JetSpace(germ.n, germ.p, k + 1)
    fields, source, target = _weights(jet, g, order_of_coordinates)
    weight = {c: _weight(space.term(c), source, target, germ.n) for c in range(space.columns)}
    top = [c for c in range(space.columns) if space.degree(c) == k + 1]
    place = space.place()
    moving = [space.row(f.image(jet, k + 1), place) for f in fields]
    fixed = [row for v in vectors(jet, g, Version.UNIPOTENT, k + 1) if (row := space.row(v, place))]
    chosen: list[int] = []
    for level in sorted({weight[c] for c in top}):
        rows = [_below(row, weight, level, space, k) for row in (*fixed, *moving)]
        for i, column in enumerate(chosen):
            for field, row in zip(fields, rows[len(fixed) :]):
                moved = _moved(field, space.term(column), germ, space, place)
                row |= {space.columns * (i + 1) + c: v for c, v in moved.items() if weight[c] <= level}
        columns = space.columns * (len(chosen) + 1)
        if columns > CAP:
            raise UndecidedError(
                f"The transversal in degree {k + 1} needs matrices of {columns} columns, more than {CAP}: "
                "leave out the order of coordinates or take a lower degree."
            )
        found = annihilator([row for row in rows if row], columns, germ.field)
        here = {c for c in top if weight[c] == level}
        chosen += independent_columns([{c: v for c, v in f.items() if c in here} for f in found.functionals])
    return tuple(space.term(c) for c in chosen)


def _below(
    row: dict[int, int], weight: dict[int, Fraction], level: Fraction, space: JetSpace, k: int
) -> dict[int, int]:
    """The row without terms of degree k + 1 heavier than the level."""
    return {c: v for c, v in row.items() if space.degree(c) <= k or weight[c] <= level}


def _moved(
    field: LinearField, term: Term, germ: Germ, space: JetSpace, place: dict[int, int]
) -> dict[int, int]:
    """What a linear field makes of a term."""
    m, j = term
    vector: Vector = tuple({m: 1} if i == j else {} for i in range(germ.p))
    return space.row(field.applied(vector, germ.n), place)


def _weights(
    germ: Germ, g: Group, order: str | Sequence[str]
) -> tuple[list[LinearField], list[int], list[int]]:
    names = order.split() if isinstance(order, str) else list(order)
    targets = [f"y{j + 1}" for j in range(germ.p)]
    for name in names:
        if name not in germ.source and name not in targets:
            raise DomainError(
                f"{name!r} is no coordinate: the source has {', '.join(germ.source)}, the target "
                f"{', '.join(targets)}."
            )
    place = {name: i for i, name in enumerate(names)}
    source = [place.get(name, 0) for name in germ.source]
    target = [place.get(name, 0) for name in targets]
    kept = []
    for field in linear_fields(germ, g):
        labels = germ.source if field.side == "source" else targets
        a, b = place.get(labels[field.a]), place.get(labels[field.b])
        if a is not None and b is not None and a > b:
            kept.append(field)
    return kept, source, target


def _weight(term: Term, source: Iterable[int], target: Sequence[int], n: int) -> Fraction:
    m, j = term
    return Fraction(sum(w * e for w, e in zip(source, poly.exponents_of(m, n))) - target[j])
