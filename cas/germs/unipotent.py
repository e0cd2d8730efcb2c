"""Unipotent subgroups between G₁ and G: G₁ and nilpotent linear vector fields, by orders of coordinates.

For an order of the source coordinates and one of the target coordinates, the fields x_a ∂/∂x_b with a after
b (tangent to the boundary: never x_a ∂/∂u) and y_i ∂/∂y_j with i after j are strictly triangular; with G₁
they span the Lie algebra of a unipotent group. What such a field adds to the tangent space is known by its
values on the annihilator of T G₁ f, so many choices can be tried at the price of small matrices.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from itertools import islice, permutations

from flint import nmod_mat

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import Functional, Row
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.tangent import JetSpace, Vector

#: pairs of orders of the coordinates tried at most
CHOICES = 20000
#: the prime of quick tests
PRIME = 2**31 - 1


@dataclass(frozen=True)
class LinearField:
    """x_a ∂/∂x_b in the source, or y_a ∂/∂y_b in the target (for C: the matrix unit f_a e_b)."""

    side: str
    a: int
    b: int

    def image(self, germ: Germ, order: int) -> Vector:
        """What the field contributes to the tangent space at a germ."""
        return self.applied(germ.jet(order), germ.n)

    def applied(self, vector: Vector, n: int) -> Vector:
        """The field applied to a vector of polynomials in n variables; it keeps the degree."""
        if self.side == "target":
            return tuple(vector[self.a] if j == self.b else {} for j in range(len(vector)))
        found = []
        for f in vector:
            image = poly.derivative(f, self.b, n)
            found.append({m + poly.variable(self.a, n): c for m, c in image.items()})
        return tuple(found)

    def text(self, germ: Germ) -> str:
        """The field as written: x∂/∂y or y1∂/∂y2."""
        if self.side == "target":
            return f"y{self.a + 1}∂/∂y{self.b + 1}"
        return f"{germ.source[self.a]}∂/∂{germ.source[self.b]}"


def linear_fields(germ: Germ, group: Group) -> list[LinearField]:
    """All nilpotent linear fields x_a ∂/∂x_b, y_i ∂/∂y_j (a ≠ b, i ≠ j) that belong to the group.

    >>> from osculant.cas.germs.groups import group
    >>> [f.text(Germ("x + u", "x u")) for f in linear_fields(Germ("x + u", "x u"), group("R(H)"))]
    ['u∂/∂x']
    """
    found = []
    if group.source in {"all", "boundary"}:
        fixed = germ.boundary_index if group.source == "boundary" else -1
        found += [
            LinearField("source", a, b) for a in range(germ.n) for b in range(germ.n) if a != b and b != fixed
        ]
    if group.target != "none":
        found += [LinearField("target", i, j) for i in range(germ.p) for j in range(germ.p) if i != j]
    return found


class Choices:
    """The annihilator of T G₁ f, and how it shrinks when nilpotent linear fields are added.

    Args:
        space: the jets the functionals live on.
        functionals: a basis of the annihilator of T G₁ f there.
        rows: the row of each linear field.
    """

    def __init__(
        self, space: JetSpace, functionals: Sequence[Functional], rows: dict[LinearField, Row]
    ) -> None:
        self.space, self.functionals = space, functionals
        values = {
            field: [
                sum((value * row[c] for c, value in f.items() if c in row), Fraction(0)) for f in functionals
            ]
            for field, row in rows.items()
        }
        #: the fields that are not in T G₁ f already, with their values on the functionals
        self.useful = {field: v for field, v in values.items() if any(v)}

    def depth(self, fields: Sequence[LinearField]) -> int:
        """m with M^{m+1}θ ⊂ T + M^{order+1}θ for T = T G₁ f and these fields, and no smaller m."""
        conditions = [self.useful[f] for f in fields if f in self.useful]
        kernel = null_space(conditions, len(self.functionals))
        columns = {c for vector in kernel for c in _combined(vector, self.functionals)}
        return max((self.space.degree(c) for c in columns), default=-1)

    def settles(self, fields: Sequence[LinearField], k: int) -> bool:
        """Whether the depth is at most k, seen modulo a prime: quick, and nearly always right."""
        conditions = [self._residues[f] for f in fields if f in self._residues]
        return _rank(conditions + self._beyond(k)) == _rank(conditions)

    @cached_property
    def _residues(self) -> dict[LinearField, list[int]]:
        return {f: [_residue(v) for v in values] for f, values in self.useful.items()}

    @cache  # noqa: B019  (an instance lives as long as one search)
    def _beyond(self, k: int) -> list[list[int]]:
        """A basis, modulo a prime, of the functionals' entries on the columns of degree above k."""
        columns = {c for f in self.functionals for c in f if self.space.degree(c) > k}
        rows = [[_residue(f.get(c, Fraction(0))) for f in self.functionals] for c in sorted(columns)]
        if not rows:
            return []
        form, rank = nmod_mat(len(rows), len(rows[0]), [v for row in rows for v in row], PRIME).rref()
        width = len(rows[0])
        return [[int(form[i, j]) for j in range(width)] for i in range(rank)]

    def triangular(self) -> Iterator[tuple[LinearField, ...]]:
        """The largest sets of useful fields that some order of the coordinates makes triangular."""
        sides = []
        for side in ("source", "target"):
            fields = [f for f in self.useful if f.side == side]
            moved = sorted({i for f in fields for i in (f.a, f.b)})
            sets: dict[frozenset[LinearField], None] = {}
            for order in islice(permutations(moved), CHOICES):
                place = {coordinate: i for i, coordinate in enumerate(order)}
                sets[frozenset(f for f in fields if place[f.a] > place[f.b])] = None
            sides.append([s for s in sets if not any(s < other for other in sets)])
        for source in sides[0]:
            for target in sides[1]:
                yield tuple(sorted(source | target, key=lambda f: (f.side, f.a, f.b)))


def _residue(value: Fraction) -> int:
    return value.numerator * pow(value.denominator, -1, PRIME) % PRIME if value.denominator % PRIME else 0


def _rank(rows: Sequence[Sequence[int]]) -> int:
    if not rows or not rows[0]:
        return 0
    return int(nmod_mat(len(rows), len(rows[0]), [v for row in rows for v in row], PRIME).rank())


def _combined(weights: Sequence[Fraction], functionals: Sequence[Functional]) -> Functional:
    total: Functional = {}
    for weight, functional in zip(weights, functionals):
        if weight:
            for c, value in functional.items():
                total[c] = total.get(c, Fraction(0)) + weight * value
    return {c: v for c, v in total.items() if v}


def choices(germ: Germ, group: Group, order: int) -> Choices:
    """The choices for a germ in the jets of one order."""
    from osculant.cas.germs.codimension import tangent

    first = tangent(germ, group, Version.UNIPOTENT, order)
    place = first.space.place()
    fields: dict[LinearField, Row] = {
        f: first.space.row(f.image(germ, order), place) for f in linear_fields(germ, group)
    }
    return Choices(first.space, first.annihilator.functionals, fields)
