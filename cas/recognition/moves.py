"""Germs that are moved by changes of coordinates, the changes kept: vector fields, their flows, linear maps.

What a group does in the target is a `TargetPart`; the rest of this room does not know which.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from flint import fmpq, fmpq_mat

from osculant.cas.germs.jets_of_maps import MapJet
from osculant.cas.recognition.elimination import Vector
from osculant.cas.recognition.forms import Column, Exponents
from osculant.cas.recognition.jets import identity_jet, jet_of, matrix_jet, terms_of
from osculant.cas.recognition.left import composed
from osculant.cas.recognition.levels import Columns


@dataclass(frozen=True)
class Field:
    """x^α ∂/∂x_a ("source"), Y^β ∂/∂Y_j ("left"), or x^α f_i e_j ("contact", i the ``row``)."""

    side: str
    index: int
    exponents: Exponents
    row: int = 0


#: terms of a germ with numbers of flint's
Terms = Mapping[Column, Any]
#: a sum of fields
Sum = Mapping[Field, Any]


@dataclass(frozen=True)
class Moved:
    """A germ f with the changes that made it of f₀: source changes first, then those of the target.

    ``target`` is what its part keeps of the change in the target: for L the maps, in the order in which they
    were done.
    """

    f: MapJet
    source: MapJet
    target: Any
    part: TargetPart

    @property
    def n(self) -> int:
        """The number of source variables."""
        return self.f.source

    @property
    def p(self) -> int:
        """The number of components."""
        return len(self.f.components)

    @property
    def order(self) -> int:
        """The order of the jets."""
        return self.f.order

    def flowed(self, fields: Sum) -> Moved:
        """The germ after the flow of a sum of fields at time 1, that of the source first."""
        moved = self
        own = {f: c for f, c in fields.items() if f.side == "source"}
        theirs = {f: c for f, c in fields.items() if f.side != "source"}
        if own:
            n, p = self.n, self.p
            field = jet_of((((f.exponents, f.index), c) for f, c in own.items()), n, n, self.order)
            along = self.target.components if self.part.along and self.target is not None else ()
            all_ = field.flow(MapJet(self.order, (*self.f.components, *self.source.components, *along)))
            moved = replace(
                moved,
                f=MapJet(self.order, all_.components[:p]),
                source=MapJet(self.order, all_.components[p : p + n]),
                target=MapJet(self.order, all_.components[p + n :]) if along else self.target,
            )
        return self.part.flowed(moved, theirs) if theirs else moved

    def substituted(self, inner: MapJet) -> Moved:
        """The germ after a change of the source."""
        along = self.part.along and self.target is not None
        target = self.target.compose(inner) if along else self.target
        return replace(self, f=self.f.compose(inner), source=self.source.compose(inner), target=target)

    def changed(self, source: fmpq_mat | None = None, target: fmpq_mat | None = None) -> Moved:
        """The germ after linear maps: f ↦ T·f∘S; the rows of S are the old coordinates in the new ones."""
        moved = self
        if source is not None:
            moved = self.substituted(matrix_jet(source, self.order))
        return moved if target is None else self.part.mapped(moved, target)


@dataclass(frozen=True)
class TargetPart:
    """What a group does in the target.

    Attributes:
        identity: the change that does nothing.
        fields: the fields that raise levels, each with what it adds to a germ with these terms.
        flowed: a germ after the flow of a sum of such fields.
        mapped: a germ after a linear map of the target.
        change: the change of a moved germ, as `Equivalence.target` has it.
        applied: such a change and a germ → the germ changed, by substitution only.
        scales: whether target coordinates may be scaled.
        along: whether the change is a jet of functions of the source, which moves with it.
    """

    identity: Any
    fields: Callable[[Columns, Terms], Iterator[tuple[Field, Vector]]]
    flowed: Callable[[Moved, Sum], Moved]
    mapped: Callable[[Moved, fmpq_mat], Moved]
    change: Callable[[Moved], Any]
    applied: Callable[[Any, MapJet], MapJet]
    scales: bool
    along: bool = False


def source_fields(columns: Columns, boundary: int | None) -> list[Field]:
    """The source fields that raise levels, tangent to the boundary."""
    n, weights = len(columns.weights.source), columns.weights
    return [
        Field("source", a, m)
        for m in columns.monomials
        for a in range(n)
        if weights.source_gain(m, a) > 0 and (a != boundary or m[a])
    ]


def source_row(field: Field, columns: Columns, terms: Terms) -> Vector:
    """What a source field makes of a germ."""
    found: Vector = {}
    a, place = field.index, columns.place
    for (m, j), c in terms.items():
        if e := m[a]:
            image = tuple(x + y - (i == a) for i, (x, y) in enumerate(zip(m, field.exponents)))
            if (at := place.get((image, j))) is not None:
                found[at] = c * e
    return found


def _no_fields(columns: Columns, terms: Terms) -> Iterator[tuple[Field, Vector]]:
    return iter(())


def _left_fields(columns: Columns, terms: Terms) -> Iterator[tuple[Field, Vector]]:
    weights, n, p = columns.weights, len(columns.weights.source), len(columns.weights.target)
    for beta, product in jet_of(terms.items(), n, p, columns.order).powers():
        gained = [j for j in range(p) if weights.target_gain(beta, j) > 0]
        entries = [(tuple(map(int, m)), c) for part in product for m, c in part.to_dict().items()]
        for j in gained:
            yield Field("left", j, beta), {columns.place[m, j]: c for m, c in entries}


def _left_flowed(moved: Moved, fields: Sum) -> Moved:
    p, order = moved.p, moved.order
    field = jet_of((((f.exponents, f.index), c) for f, c in fields.items()), p, p, order)
    return _left_composed(moved, field.flow(identity_jet(p, order)))


def _left_mapped(moved: Moved, matrix: fmpq_mat) -> Moved:
    return _left_composed(moved, matrix_jet(matrix, moved.order))


def _left_composed(moved: Moved, change: MapJet) -> Moved:
    return replace(moved, f=change.compose(moved.f), target=(*moved.target, change))


def _no_map(moved: Moved, matrix: fmpq_mat) -> Moved:
    raise ValueError("the group has no target part")


def _applied(change: MapJet, f: MapJet) -> MapJet:
    return change.compose(f)


#: no target part, as for R
NONE = TargetPart(
    None,
    _no_fields,
    lambda moved, _: moved,
    _no_map,
    lambda moved: identity_jet(moved.p, moved.order),
    _applied,
    scales=False,
)
#: L: diffeomorphisms of the target
LEFT = TargetPart(
    (),
    _left_fields,
    _left_flowed,
    _left_mapped,
    lambda moved: composed(moved.target, moved.f),
    _applied,
    scales=True,
)


def difference(a: MapJet, terms: Terms, columns: Columns) -> Vector:
    """A jet less a germ of few terms, as entries by the places of columns."""
    found: Vector = {columns.place[column]: c for column, c in terms_of(a).items()}
    for column, c in terms.items():
        at = columns.place[column]
        value = found.get(at, fmpq(0)) - c
        if value == 0:
            found.pop(at, None)
        else:
            found[at] = value
    return found
