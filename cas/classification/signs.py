"""Real forms: which signs of the terms of a germ remain, and when they are known to be different classes.

Signs of the coordinates (not of u, which keeps its side of H) change those of the terms; so do exchanges
of coordinates that keep the set of terms. What is left are all real forms of a germ whose orbit of T·N is
open in its orbit, perhaps some of them twice.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations, product

from osculant.cas.classification.starts import OneJet
from osculant.cas.classification.tree import exponents
from osculant.cas.recognition.forms import Column
from osculant.cas.recognition.smith import solutions_mod_2

#: for each term whether its sign is minus
Signs = tuple[int, ...]


def real_forms(jet: OneJet, terms: Sequence[Column]) -> tuple[Signs, ...]:
    """The signs of the real forms, one choice for each, with the fewest minus signs, the last terms first.

    >>> from osculant.cas.germs.groups import group
    >>> jet = OneJet(group("A(H)"), 4, 2, 1, True)
    >>> terms = [*jet.terms, ((0, 0, 2, 0), 1), ((0, 2, 0, 0), 1)]
    >>> real_forms(jet, terms)
    ((0, 0, 0, 0), (0, 0, 0, 1), (0, 0, 1, 1))
    """
    rows = [_row(column, jet) for column in terms]
    fixed = [sum(column[0]) == 1 for column in terms]
    orders = list(_exchanges(jet, terms)) if len(terms) > sum(fixed) else [tuple(range(len(terms)))]
    found: list[Signs] = []
    choices = product(*((0,) if f else (0, 1) for f in fixed))
    for signs in sorted(choices, key=lambda s: (sum(s), s)):
        turned = {tuple(signs[i] for i in order) for order in orders}
        if not any(_equivalent(rows, other, s) for other in found for s in turned):
            found.append(signs)
    return tuple(found)


def told_apart(jet: OneJet, terms: Sequence[Column], stable: bool) -> str:
    """Why the real forms of a germ are different classes; empty if that is not proved.

    If the linear maps that keep the 1-jet, of the germ or, if it is stable, of its genotype, are triangular
    but for the torus, orbits are those of T·N. Variables of the kernel that have nothing but a square in the
    only component can be split off: their signs count by Sylvester's law of inertia.
    """
    if jet.split:
        return "squares are split off (Sylvester), and the other linear maps are triangular or a finite group"
    triangular = jet.rank <= 1 and len(jet.free) <= 1
    if not (stable or triangular) or len(jet.free) > 1:
        return ""
    squares = [z for z in jet.kernel if _only_square(z, terms)]
    if len(jet.kernel) <= 1:
        return "only triangular linear maps are left over the 1-jet"
    if stable and jet.p - jet.rank == 1 and len(jet.kernel) - len(squares) <= 1:
        return "triangular linear maps, and squares that are split off (Sylvester)"
    return ""


def _only_square(z: int, terms: Sequence[Column]) -> bool:
    own = [m for m, _ in terms if m[z]]
    return len(own) == 1 and own[0][z] == sum(own[0]) == 2


def _row(column: Column, jet: OneJet) -> list[int]:
    row = exponents(column, jet)
    if jet.boundary is not None:
        row[jet.boundary] = 0
    return row


def _equivalent(rows: Sequence[Sequence[int]], a: Sequence[int], b: Sequence[int]) -> bool:
    """Whether signs of coordinates make one choice of signs from another."""
    return not rows or solutions_mod_2(rows, [x ^ y for x, y in zip(a, b)], len(rows[0])) is not None


def _exchanges(jet: OneJet, terms: Sequence[Column]) -> Iterator[tuple[int, ...]]:
    """Permutations of the terms that exchanges of coordinates make: x with its components, z, h."""
    place = {column: i for i, column in enumerate(terms)}
    for xs in permutations(range(jet.rank)):
        for zs in permutations(jet.kernel):
            variables = [*xs, *zs, *range(jet.own, jet.n)]
            for hs in permutations(jet.free):
                components = [*xs, *range(jet.rank, jet.rank + jet.linear), *hs]
                moved = [
                    (tuple(m[variables[i]] for i in range(jet.n)), components.index(j)) for m, j in terms
                ]
                if all(column in place for column in moved):
                    yield tuple(place[column] for column in moved)
