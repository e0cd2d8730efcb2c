"""Tangent spaces in jets of one order, exactly: by their annihilators."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from osculant.cas.germs.annihilator import Annihilator, Functional, annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.tangent import JetSpace, rows, vectors


@dataclass(frozen=True)
class Tangent:
    """A tangent space in the jets of one order, by its annihilator, and the seconds that it took.

    >>> from osculant.cas.germs.groups import group
    >>> t = tangent(Germ("x**3", "x"), group("R"), Version.EXTENDED, 4)
    >>> t.annihilator.codimension, t.depth
    (2, 1)
    """

    germ: Germ
    group: Group
    version: Version
    space: JetSpace
    annihilator: Annihilator
    seconds: float = field(default=0.0, compare=False)

    @property
    def depth(self) -> int:
        """m: the highest degree of a column on which a functional is not 0; −1 if there is none.

        M^{m+1}θ ⊂ T + M^{order+1}θ, and no smaller power of M is; with weights the same of W.
        """
        return max((self.space.degree(c) for f in self.annihilator.functionals for c in f), default=-1)

    @property
    def plain_depth(self) -> int:
        """The depth by degrees without weights."""
        return max((self.space.plain_degree(c) for f in self.annihilator.functionals for c in f), default=-1)

    def settled(self, bound: int) -> bool:
        """Whether W_{depth+1}θ ⊂ T by the criterion, where W_bound θ ⊂ T K_e f (1 for modules)."""
        w = max(self.space.weights, default=1)
        # with weights the unipotent fields must have all multiples that lie in W_{depth+1}
        enough = self.depth + 1 >= self.version * w or not self.space.weights
        return enough and self.space.order >= self.least_order(bound)

    def least_order(self, bound: int) -> int:
        """The order that settles it if the depth stays as it is; in jets of higher orders it is no less."""
        w = max(self.space.weights, default=1)
        more = bound + w - 1 if self.group.target == "left" else w
        return self.depth + max(more, 1)

    @property
    def codimension(self) -> int:
        """The codimension modulo M^{order+1}: in θ for the extended version, else in Mθ."""
        return self.annihilator.codimension - (0 if self.version is Version.EXTENDED else self.germ.p)

    def complement(self) -> tuple[tuple[int, int], ...]:
        """Terms (monomial, component) that form a basis of θ modulo T, of the lowest degrees possible."""
        return tuple(self.space.term(c) for c in independent_columns(self.annihilator.functionals))


def tangent(
    germ: Germ, group_: Group, version: Version, order: int, weights: tuple[int, ...] = ()
) -> Tangent:
    """The tangent space of that version of the group, modulo M^{order+1} (with weights modulo W); kept."""
    key = group_, version, order, weights
    if key not in germ.known:
        begun = time.process_time()
        space = JetSpace(germ.n, germ.p, order, weights)
        spanning = rows(vectors(germ, group_, version, order, weights), space)
        found = annihilator(spanning, space.columns, germ.field)
        germ.known[key] = Tangent(germ, group_, version, space, found, time.process_time() - begun)
    made: Tangent = germ.known[key]
    return made


def independent_columns(functionals: Sequence[Functional]) -> list[int]:
    """Columns on which functionals are independent, greedily from the first (lowest degree).

    >>> independent_columns([{0: Fraction(1), 1: Fraction(1)}, {0: Fraction(2), 1: Fraction(2)}])
    [0]
    """
    pivots: dict[int, dict[int, Fraction]] = {}
    by_column: dict[int, dict[int, Fraction]] = {}
    for i, functional in enumerate(functionals):
        for column, value in functional.items():
            by_column.setdefault(column, {})[i] = value
    chosen = []
    for column in sorted(by_column):
        vector = dict(by_column[column])
        for lead, pivot in pivots.items():
            if factor := vector.get(lead, Fraction(0)):
                for i, value in pivot.items():
                    vector[i] = vector.get(i, Fraction(0)) - factor * value
        vector = {i: v for i, v in vector.items() if v}
        if vector:
            lead = min(vector)
            pivots[lead] = {i: v / vector[lead] for i, v in vector.items()}
            chosen.append(column)
    return chosen


def annihilator_certificate(t: Tangent) -> dict[str, Any]:
    """The annihilator of a tangent space as plain data: functionals by their values on columns."""
    told = {
        "order": t.space.order,
        "depth": t.depth,
        "rank": t.annihilator.rank,
        "columns": t.annihilator.columns,
        "prime": t.annihilator.prime,
        "functionals": functionals_told(t.annihilator.functionals),
    }
    return {**told, "weights": list(t.space.weights)} if t.space.weights else told


def functionals_told(functionals: Sequence[Functional]) -> list[dict[int, str]]:
    """Functionals as plain data.

    >>> functionals_told([{2: Fraction(1, 2)}])
    [{2: '1/2'}]
    """
    return [{c: str(v) for c, v in f.items()} for f in functionals]
