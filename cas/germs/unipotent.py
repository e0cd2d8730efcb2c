"""Unipotent subgroups between G₁ and G: G₁ and nilpotent linear vector fields, triangular for a flag.

For an order of the source coordinates and one of the target coordinates, the fields x_a ∂/∂x_b with a after
b (tangent to the boundary: never x_a ∂/∂u) and y_i ∂/∂y_j with i after j are strictly triangular; with G₁
they span the Lie algebra of a unipotent group. What such a field adds to the tangent space is known by its
values on the annihilator of T G₁ f, so many choices can be tried at the price of small matrices.

Where the coordinates have weights, those of a quasi-homogeneous germ or the eigenvalues of a linear symmetry
(`osculant.cas.germs.adapted`), the fields that raise the weight come first: they do all that G does to terms
of higher weight. Then all orders of the coordinates are tried.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain, islice, permutations
from typing import Any

from flint import nmod_mat

from osculant.cas.germs.adapted import Frame
from osculant.cas.germs.algebraic import Algebraic
from osculant.cas.germs.annihilator import Functional
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.linear_fields import LinearField, all_linear_fields, linear_fields, pairings
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import Tangent, annihilator_certificate, functionals_told

#: orders of the coordinates of one side, and sets of fields in one frame, tried at most
ORDERS, SETS = 720, 2000
#: the prime of quick tests
PRIME = 2**30 - 35

Fields = tuple[LinearField, ...]
#: of linear fields on the functionals
Values = dict[LinearField, list[Any]]
Residues = dict[LinearField, list[int]]


class Choices(ABC):
    """How T G₁ f grows when nilpotent linear fields are added: seen modulo a prime, then proved.

    Attributes:
        space: the jets of the proof.
        prime: the prime.
        exact: whether all of T G₁ f is known, not only its jets.
    """

    space: JetSpace
    prime: int
    exact = False

    def __init__(self) -> None:
        self._far: dict[int, list[list[int]]] = {}

    @abstractmethod
    def residues(self, frame: Frame) -> Residues:
        """The values of the fields of a frame on the functionals, without fields that have only zeros."""

    @abstractmethod
    def beyond(self, k: int) -> list[list[int]]:
        """The functionals' values, modulo the prime, on what has a degree above k: a row for each column."""

    @abstractmethod
    def confirmed(self, frame: Frame, fields: Fields, k: int) -> bool:
        """Whether M^{k+1}θ ⊂ T with the fields; exact."""

    @abstractmethod
    def certificate(self, frame: Frame, fields: Fields) -> dict[str, Any]:
        """Of what is confirmed: the annihilator with the fields, by weights that of T G₁ f first."""

    def settles(self, vectors: Sequence[list[int]], k: int) -> bool:
        """Whether M^{k+1}θ ⊂ T with these vectors, seen modulo the prime: quick, and nearly always right."""
        if k not in self._far:
            self._far[k] = _echelon(self.beyond(k), self.prime)
        return modular_rank([*vectors, *self._far[k]], self.prime) == modular_rank(vectors, self.prime)

    def raising(self, frame: Frame, k: int) -> tuple[Frame, Fields] | None:
        """No fields, or those that raise the weights of the frame, if M^{k+1}θ ⊂ T with them."""
        if self.settles((), k) and self.confirmed(frame, (), k):
            return frame, ()
        return self._found(frame, k, _by_weight)

    def proof(self, frames: Iterator[Frame], k: int) -> tuple[Frame, Fields] | None:
        """Fields with which M^{k+1}θ ⊂ T, few of them, and their frame; None if none were found."""
        for frame in frames:
            found = self._found(frame, k, _triangular)
            if found is not None:
                return found
        return None

    def _found(
        self, frame: Frame, k: int, sets: Callable[[Frame, Iterable[LinearField]], Iterator[Fields]]
    ) -> tuple[Frame, Fields] | None:
        residues = self.residues(frame)

        def enough(fields: Fields) -> bool:
            return self.settles([residues[f] for f in fields], k)

        if not enough(tuple(residues)):
            return None
        for fields in islice(sets(frame, residues), SETS):
            if enough(fields):
                for field in fields:  # leave out what is not needed
                    fewer = tuple(f for f in fields if f != field)
                    fields = fewer if enough(fewer) else fields
                if self.confirmed(frame, fields, k):
                    return frame, fields
        return None


class ExactChoices(Choices):
    """By the annihilator of T G₁ f.

    Args:
        first: the tangent space T G₁ f.
        exact: whether all of T G₁ f is known by it, not only its jets.
    """

    def __init__(self, first: Tangent, exact: bool = False) -> None:
        super().__init__()
        self.first, self.space, self.exact = first, first.space, exact
        self.functionals = first.annihilator.functionals
        self._degrees = [self.space.plain_degree(c) for c in range(self.space.columns)]
        field = first.germ.field
        self.prime = PRIME if field is None else field.split[0]

    @cached_property
    def values(self) -> Values:
        """The values of the linear fields of the group, in the coordinates given, on the functionals."""
        t = self.first
        return {
            field: pairings(field, t.germ, self.space, self.functionals)
            for field in all_linear_fields(t.germ, t.group)
        }

    def moved(self, frame: Frame) -> Values:
        """The values of the fields of a frame; those that are 0 are left out."""
        found = {}
        for field in linear_fields(self.first.germ, self.first.group):
            if frame.moved:
                total = [Fraction(0)] * len(self.functionals)
                for part, entry in frame.parts(field):
                    total = [a + entry * b for a, b in zip(total, self.values[part])]
            else:
                total = self.values[field]
            if any(total):
                found[field] = total
        return found

    def residues(self, frame: Frame) -> Residues:
        """See `Choices`."""
        return {f: [residue(v, self.prime) for v in vector] for f, vector in self.moved(frame).items()}

    def beyond(self, k: int) -> list[list[int]]:
        """See `Choices`."""
        columns = {c for f in self.functionals for c in f if self._degrees[c] > k}
        return [
            [residue(f.get(c, Fraction(0)), self.prime) for f in self.functionals] for c in sorted(columns)
        ]

    def annihilator(self, frame: Frame, fields: Fields) -> list[Functional]:
        """A basis of the functionals that vanish on T G₁ f and on the fields."""
        values = self.moved(frame) if fields else {}
        kernel = null_space([values[f] for f in fields if f in values], len(self.functionals))
        return [_combined(vector, self.functionals) for vector in kernel]

    def confirmed(self, frame: Frame, fields: Fields, k: int) -> bool:
        """See `Choices`."""
        return all(self._degrees[c] <= k for f in self.annihilator(frame, fields) for c in f)

    def certificate(self, frame: Frame, fields: Fields) -> dict[str, Any]:
        """See `Choices`."""
        whole = annihilator_certificate(self.first)
        told: dict[str, Any] = {
            key: whole[key] for key in ("order", "columns", "prime", "weights") if key in whole
        }
        told["functionals"] = functionals_told(self.annihilator(frame, fields))
        return {"annihilator": told, **({"first": whole} if self.space.weights else {})}


def _triangular(frame: Frame, values: Iterable[LinearField]) -> Iterator[Fields]:
    """Sets of fields that are triangular together: by the weights, and by all orders of the coordinates."""
    seen = set()
    for fields in chain(_by_weight(frame, values), _by_order(values)):
        if fields and fields not in seen:
            seen.add(fields)
            yield fields


def _by_weight(frame: Frame, values: Iterable[LinearField]) -> Iterator[Fields]:
    """The fields that raise the weights, or lower them, on either side."""
    own, theirs = frame.source_weights, frame.target_weights
    if own is None or theirs is None:
        return
    height = {"source": [(w, i) for i, w in enumerate(own)], "target": [(w, i) for i, w in enumerate(theirs)]}
    for source, target in ((True, True), (False, False), (True, False)):
        up = {"source": source, "target": target}
        yield tuple(f for f in values if (height[f.side][f.a] > height[f.side][f.b]) == up[f.side])


def _by_order(values: Iterable[LinearField]) -> Iterator[Fields]:
    """The largest sets of fields that some order of the coordinates makes triangular."""
    sides = []
    for side in ("source", "target"):
        fields = [f for f in values if f.side == side]
        bits = {f: 1 << i for i, f in enumerate(fields)}
        touched = sorted({i for f in fields for i in (f.a, f.b)})
        sets: dict[int, None] = {}
        for order in islice(permutations(touched), ORDERS):
            place = {coordinate: i for i, coordinate in enumerate(order)}
            sets[sum(bit for f, bit in bits.items() if place[f.a] > place[f.b])] = None
        largest = [s for s in sets if not any(s != other and s & other == s for other in sets)]
        sides.append([tuple(f for f, bit in bits.items() if s & bit) for s in largest])
    for one in sides[0]:
        for other in sides[1]:
            yield tuple(sorted((*one, *other), key=lambda f: (f.side, f.a, f.b)))


def residue(value: Any, prime: int) -> int:
    """A number modulo a prime, that of its field if it is not rational; 0 for one in its denominator."""
    if isinstance(value, Algebraic):
        return value.residue()
    return value.numerator * pow(value.denominator, -1, prime) % prime if value.denominator % prime else 0


def _echelon(rows: Sequence[Sequence[int]], prime: int) -> list[list[int]]:
    if not rows:
        return []
    width = len(rows[0])
    form, rank = nmod_mat(len(rows), width, [v for row in rows for v in row], prime).rref()
    return [[int(form[i, j]) for j in range(width)] for i in range(rank)]


def modular_rank(rows: Sequence[Sequence[int]], prime: int) -> int:
    """The rank of rows of residues."""
    if not rows or not rows[0]:
        return 0
    return int(nmod_mat(len(rows), len(rows[0]), [v for row in rows for v in row], prime).rank())


def _combined(weights: Sequence[Any], functionals: Sequence[Functional]) -> Functional:
    total: Functional = {}
    for weight, functional in zip(weights, functionals):
        if weight:
            for c, value in functional.items():
                total[c] = total.get(c, Fraction(0)) + weight * value
    return {c: v for c, v in total.items() if v}
