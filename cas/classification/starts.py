"""Where a classification starts: the orbits of 1-jets, and the group that remains over each of them.

Over a fixed 1-jet g₀ the group is S ⋉ G₁, with S the linear maps that keep g₀. A Borel subgroup of S is a
torus T, that of all coordinates as far as it keeps g₀, and a unipotent group U, triangular for the
weights below; N = U ⋉ G₁ raises levels. Coordinates that are components (x) and those of the target that
are 0 on g₀ (h) lie above the kernel of the derivative on H (z); u lies above all x if it is a component,
else between z and x.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from flint import fmpq

from osculant.cas.germs.groups import Group
from osculant.cas.recognition.elimination import Echelon, Vector, echelon
from osculant.cas.recognition.forms import Column
from osculant.cas.recognition.levels import Columns, Weights, flagged
from osculant.cas.recognition.moves import Field, source_fields, source_row
from osculant.cas.recognition.targets import TARGETS

#: between the flags of coordinates
STEP = 2
#: terms of a germ and their coefficients
Base = Mapping[Column, Any]


@dataclass(frozen=True)
class OneJet:
    """An orbit of 1-jets: x₁, …, x_r are components, and u is one if ``linear``; the rest is 0.

    Attributes:
        group: the group: with H = {u = 0}, u the last variable, if its source is "boundary".
        n: the number of variables.
        p: the number of components.
        rank: r, the rank of the derivative, for a group with H that of the restriction to H.
        linear: whether u is a component.

    >>> from osculant.cas.germs.groups import group
    >>> [(j.rank, j.linear, j.codimension) for j in one_jets(group("A(H)"), 4, 3, 3)]
    [(3, False, 0), (2, True, 1), (2, False, 2)]
    """

    group: Group
    n: int
    p: int
    rank: int
    linear: bool

    @property
    def boundary(self) -> int | None:
        """The place of u; None without H."""
        return self.n - 1 if self.group.source == "boundary" else None

    @property
    def own(self) -> int:
        """The number of variables besides u."""
        return self.n if self.boundary is None else self.n - 1

    @property
    def codimension(self) -> int:
        """The codimension of the orbit in the linear maps."""
        rest = self.p - self.rank
        missing = rest if self.boundary is not None and not self.linear else 0
        return (self.own - self.rank) * rest + missing

    @property
    def kernel(self) -> range:
        """z: the variables that are no components, without u."""
        return range(self.rank, self.own)

    @property
    def free(self) -> range:
        """h: the components that are 0."""
        return range(self.rank + self.linear, self.p)

    @property
    def component_of(self) -> dict[int, int]:
        """For the variables that are components: the place of the component."""
        found = {i: i for i in range(self.rank)}
        if self.linear:
            found[self.n - 1] = self.rank
        return found

    @property
    def terms(self) -> dict[Column, Any]:
        """The 1-jet."""
        return {(unit(i, self.n), j): fmpq(1) for i, j in self.component_of.items()}

    @property
    def split(self) -> bool:
        """Whether squares are split off, and linear maps triangular but for a torus and a finite group."""
        return False

    def fixed(self, column: Column) -> bool:
        """Whether a term is one of those that are prescribed: here the linear ones."""
        return sum(column[0]) <= 1

    @property
    def weights(self) -> Weights:
        """Weights for which N raises levels."""
        source = [0] * self.n
        for place, i in enumerate(reversed(self.kernel), start=1):
            source[i] = STEP * place
        top = STEP * (len(self.kernel) + 1)
        if self.boundary is not None and not self.linear:
            source[self.boundary] = top
            top += STEP
        for place, i in enumerate(range(self.rank)):
            source[i] = top + STEP * place
        top += STEP * self.rank
        if self.linear:
            source[self.n - 1] = top
            top += STEP
        target = [0] * self.p
        for i, j in self.component_of.items():
            target[j] = source[i]
        for place, j in enumerate(self.free):
            target[j] = top + STEP * place
        return flagged(source, target)

    def columns(self, order: int) -> Columns:
        """The terms of jets of an order, by level."""
        return Columns(self.weights, order)

    def eliminated(self, base: Base, columns: Columns) -> Echelon:
        """The echelon form of what the Lie algebra of N does to a germ over this 1-jet."""
        return echelon((label, row) for label, row in self._rows(base, columns) if row)

    def _rows(self, base: Base, columns: Columns) -> Iterator[tuple[Field, Vector]]:
        for field in source_fields(columns, self.boundary):
            if sum(field.exponents) > 1:
                yield field, source_row(field, columns, base)
        least = 1 if self.group.target == "contact" else 2
        for field, row in TARGETS[self.group.target].fields(columns, base):
            if sum(field.exponents) >= least:
                yield field, row
        yield from self._linear(base, columns)

    def _linear(self, base: Base, columns: Columns) -> Iterator[tuple[Field, Vector]]:
        """The linear fields of U: they raise levels and keep the 1-jet, with a target part if need be."""
        zero, weights, place = (0,) * self.n, columns.weights, self.component_of
        for a in range(self.n):
            for b in range(self.n):
                raises = weights.source[a] > weights.source[b] and b != self.boundary
                if not raises or (b in place and (a not in place or self.group.target == "none")):
                    continue
                field = Field("source", b, unit(a, self.n))
                row = source_row(field, columns, base)
                if b in place:
                    for at, v in _multiplied(base, zero, place[a], place[b], columns).items():
                        rest = row.pop(at, fmpq(0)) - v
                        if rest != 0:
                            row[at] = rest
                yield field, row
        if self.group.target == "none":
            return
        for i in self.free:
            for j in range(self.p):
                if weights.target[i] > weights.target[j]:
                    yield Field("left", j, unit(i, self.p)), _multiplied(base, zero, i, j, columns)


def _multiplied(base: Base, m: tuple[int, ...], i: int, j: int, columns: Columns) -> Vector:
    """x^m f_i e_j."""
    found: Vector = {}
    for (own, component), c in base.items():
        if component == i:
            at = columns.place.get((tuple(a + b for a, b in zip(own, m)), j))
            if at is not None:
                found[at] = c
    return found


def unit(i: int, n: int) -> tuple[int, ...]:
    """The exponents of the variable in place i."""
    return tuple(int(k == i) for k in range(n))


def one_jets(group: Group, n: int, p: int, codimension: int) -> list[OneJet]:
    """The orbits of 1-jets up to a codimension, the largest rank first."""
    own = n - 1 if group.source == "boundary" else n
    found = [
        OneJet(group, n, p, r, linear)
        for r in range(min(own, p) + 1)
        for linear in ((True, False) if group.source == "boundary" and r < p else (False,))
    ]
    kept = [jet for jet in found if jet.codimension <= codimension]
    return sorted(kept, key=lambda jet: (jet.codimension, -jet.rank))
