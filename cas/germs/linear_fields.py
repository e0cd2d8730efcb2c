"""Linear vector fields x_a ∂/∂x_b of the source and y_i ∂/∂y_j of the target, and what they do to a germ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import Functional
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.germs.tangent import JetSpace, Vector


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

    def text(self, germ: Germ, moved: bool = False) -> str:
        """The field as written: x∂/∂y or y1∂/∂y2; with capitals in moved coordinates."""
        names = [f"y{j + 1}" for j in range(germ.p)] if self.side == "target" else germ.source
        a, b = (name.upper() if moved else name for name in (names[self.a], names[self.b]))
        return f"{a}∂/∂{b}"


def linear_fields(germ: Germ, group: Group) -> list[LinearField]:
    """All nilpotent linear fields x_a ∂/∂x_b, y_i ∂/∂y_j (a ≠ b, i ≠ j) that belong to the group.

    >>> from osculant.cas.germs.groups import group
    >>> [f.text(Germ("x + u", "x u")) for f in linear_fields(Germ("x + u", "x u"), group("R(H)"))]
    ['u∂/∂x']
    """
    found = all_linear_fields(germ, group)
    return [f for f in found if f.a != f.b and (f.side == "source" or group.target != "none")]


def all_linear_fields(germ: Germ, group: Group) -> list[LinearField]:
    """All linear fields of the group's source part, and all of the target, which scale functions too."""
    found = []
    if group.source in {"all", "boundary"}:
        u = germ.boundary_index if group.source == "boundary" else -1
        pairs = [(a, b) for a in range(germ.n) for b in range(germ.n) if b != u or a == u]
        found += [LinearField("source", a, b) for a, b in pairs]
    return found + [LinearField("target", i, j) for i in range(germ.p) for j in range(germ.p)]


def pairings(
    field: LinearField, germ: Germ, space: JetSpace, functionals: Sequence[Functional]
) -> list[Fraction]:
    """The values of functionals on what a field makes of a germ.

    >>> x = LinearField("source", 0, 0)
    >>> pairings(x, Germ("x**3", "x"), JetSpace(1, 1, 3), [{3: Fraction(1)}])
    [Fraction(3, 1)]
    """
    degree = space.order // min(space.weights, default=1)
    vector = field.image(germ, min(degree, poly.LARGEST))
    if space.weights:
        vector = tuple(poly.weighted(f, space.n, space.weights) for f in vector)
    place = space.place()
    entries = {space.p * place[m] + j: c for j, f in enumerate(vector) for m, c in f.items() if m in place}
    return [sum((v * entries[c] for c, v in f.items() if c in entries), Fraction(0)) for f in functionals]
