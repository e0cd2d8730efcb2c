"""Whether a degree of determinacy is the least: a germ with the same (k − 1)-jet that is not equivalent.

Suppose M^kθ ⊂ T G f (else f is not (k − 1)-determined). The k-jets over j = j^{k−1}f are j + h, h of degree
k, and G₁ moves them by L = {Y j : Y ∈ L G₁, Y j ∈ M^k}. So what counts of h is its class q in Q = H^k/L. A
field X = E + Y of L G, E linear, with X j ∈ M^k moves q with the velocity c_E + λ_E q: an affine field, the
same in all coordinates. Where these fields do not span Q, M^kθ ⊄ T G (j + h), which is another orbit. Such a
point is found as a common zero of them, or one of a common eigenfunction of the λ_E; that M^kθ ⊄ T G g +
M^{k+1}θ at it is computed anew.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from osculant.cas.formulas.expression import to_text
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import exact
from osculant.cas.germs.eigenvalues import factors, rational_root
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.linear import null_space, solution
from osculant.cas.germs.linear_fields import LinearField, all_linear_fields, pairings
from osculant.cas.germs.modular_tangent import first_prime, is_dense, modular_tangent
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import Tangent, independent_columns, tangent

Matrix = list[list[Any]]


@dataclass(frozen=True)
class Sharpness:
    """Whether f is not (k − 1)-determined: True, or None if that is not known; why; and the other germ g.

    ``other`` is a polynomial germ with the (k − 1)-jet of f and M^kθ ⊄ T G g, which ``tangent`` shows, its
    jets of order k; None where none is needed, and where this is only seen modulo a prime.
    """

    sharp: bool | None
    reason: str
    other: Germ | None = None
    tangent: Tangent | None = None


def sharpness(germ: Germ, g: Group, k: int, depth: int, quick: bool = False) -> Sharpness:
    """Whether f is not (k − 1)-determined.

    Args:
        germ: the germ f.
        g: the group.
        k: the degree.
        depth: m with M^{m+1}θ ⊂ T G f, no smaller one.
        quick: only the (k − 1)-jet itself is tried, that of a dense germ modulo a prime.

    >>> from osculant.cas.germs.groups import group
    >>> found = sharpness(Germ("x, (y + x**2)**3 + x*y", "x y"), group("A"), 3, 2)
    >>> found.sharp, found.other.text(3)
    (True, ('x', 'x*y'))
    """
    if k == 1:
        return Sharpness(True, "degrees of determinacy are at least 1")
    if depth >= k:
        return Sharpness(True, f"M^{k}θ is not in the tangent space")
    for other in _candidates(germ, g, k, quick):
        seen = None
        if is_dense(other, g, k):
            seen = modular_tangent(other, g, Version.ORDINARY, k, None, first_prime(germ, k))
        if seen is not None and (quick or seen.depth < k):
            if seen.depth >= k:
                return Sharpness(True, "as seen modulo a prime", other)
            continue
        found = tangent(other, g, Version.ORDINARY, k)
        if found.depth >= k:
            shown = ", ".join(map(to_text, other.components))
            why = f"{shown} has the same {k - 1}-jet and M^{k}θ not in its tangent space"
            return Sharpness(True, why, other, found)
    return Sharpness(None, f"whether the germ is {k - 1}-determined is not decided")


def _candidates(germ: Germ, g: Group, k: int, quick: bool) -> Iterator[Germ]:
    """Germs with the (k − 1)-jet at which the affine fields may not span."""
    lower = germ.truncated(k - 1)
    yield lower
    if not quick and g.source != "own":
        yield from _Affine(germ, lower, g, k).degenerate()


class _Affine:
    """The affine fields on Q."""

    def __init__(self, germ: Germ, lower: Germ, g: Group, k: int) -> None:
        self.germ, self.lower, self.group, self.k = germ, lower, g, k
        first = tangent(lower, g, Version.UNIPOTENT, k)
        self.space: JetSpace = first.space
        functionals = first.annihilator.functionals
        top = {c for f in functionals for c in f if self.space.degree(c) == k}
        restricted = [{c: v for c, v in f.items() if c in top} for f in functionals]
        #: columns that are a basis of Q, and the functionals that are coordinates there
        self.columns = independent_columns(restricted)
        self.fields = [
            f
            for f in all_linear_fields(lower, g)
            if f.side == "source" or g.target != "none"  # those of the group only
        ]
        values = [pairings(f, lower, self.space, functionals) for f in self.fields]  # field × functional
        # functionals that vanish on H^k: E belongs to a field that keeps the (k − 1)-jet if they vanish on E
        # j
        rows = [[f.get(c, Fraction(0)) for f in functionals] for c in sorted(top)]
        below = null_space(rows, len(functionals))
        conditions = [[_dot(weights, value) for value in values] for weights in below]
        self.stabiliser = null_space(conditions, len(self.fields))
        # coordinates on Q: combinations of functionals dual to the chosen columns
        matrix = [[f.get(c, Fraction(0)) for f in functionals] for c in self.columns]
        self.dual = _right_inverse(matrix)
        self.functionals, self.values = functionals, values

    def coordinates(self, paired: Sequence[Any]) -> list[Any]:
        """The coordinates on Q of an element of H^k from its values on the functionals."""
        return [_dot(weights, paired) for weights in self.dual]

    def affine(self) -> list[tuple[list[Any], Matrix]]:
        """(c, λ) for every element of a basis of the fields E."""
        size = len(self.columns)
        # field × column × coordinate
        moved = [[self.coordinates(self._pair(field, c)) for c in self.columns] for field in self.fields]
        found = []
        for weights in self.stabiliser:
            paired = [
                sum((w * self.values[i][j] for i, w in enumerate(weights) if w), Fraction(0))
                for j in range(len(self.functionals))
            ]
            linear = [
                [
                    sum((w * moved[i][c][r] for i, w in enumerate(weights) if w), Fraction(0))
                    for c in range(size)
                ]
                for r in range(size)
            ]
            found.append((self.coordinates(paired), linear))
        return found

    def _pair(self, field: LinearField, column: int) -> list[Any]:
        """The functionals on a field applied to a term of degree k."""
        m, j = self.space.term(column)
        vector = field.applied(tuple({m: 1} if i == j else {} for i in range(self.space.p)), self.space.n)
        row = self.space.row(vector, self.space.place())
        return [sum((v * f[c] for c, v in row.items() if c in f), Fraction(0)) for f in self.functionals]

    def here(self) -> list[Any]:
        """The coordinates on Q of f itself."""
        top = tuple(
            {m: c for m, c in f.items() if poly.degree_of(m, self.germ.n) == self.k}
            for f in self.germ.jet(self.k)
        )
        place, p = self.space.place(), self.space.p
        entries = {p * place[m] + j: exact(c) for j, f in enumerate(top) for m, c in f.items()}
        return self.coordinates(
            [
                sum((v * entries[c] for c, v in f.items() if c in entries), Fraction(0))
                for f in self.functionals
            ]
        )

    def degenerate(self) -> list[Germ]:
        """The germs at common zeros of the fields, or of an eigenfunction of them."""
        size, fields = len(self.columns), self.affine()
        if not size or not fields:
            return []
        points = []
        every = solution(
            [row for _, linear in fields for row in linear], [-c for own, _ in fields for c in own], size
        )
        if every is not None:
            points.append(every)
        start = self.here()
        for psi in _eigenfunctions([linear for _, linear in fields], size):
            rows, right = [], []
            for own, linear in fields:
                image = [sum((p * linear[r][c] for r, p in enumerate(psi)), Fraction(0)) for c in range(size)]
                pivot = next(i for i, p in enumerate(psi) if p)
                value = image[pivot] / psi[pivot]
                rows.append([value * p for p in psi])
                right.append(-_dot(psi, own))
            # moved from f along the functions alone
            offsets = [
                b - sum((a * s for a, s in zip(row, start)), Fraction(0)) for row, b in zip(rows, right)
            ]
            step = solution(rows, offsets, size)
            if step is not None:
                points.append([s + d for s, d in zip(start, step)])
        return [self.germ_at(point) for point in points]

    def germ_at(self, point: Sequence[Any]) -> Germ:
        """The germ j + Σ qᵢ tᵢ."""
        jet: list[Polynomial] = [dict(f) for f in self.lower.jet(self.k - 1)]
        for value, column in zip(point, self.columns):
            m, j = self.space.term(column)
            if value:
                jet[j][m] = value
        nodes = [as_node(f, self.germ.source, self.germ.field) for f in jet]
        return Germ(nodes, self.germ.source, self.germ.boundary, self.germ.field)


def _dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return sum((x * y for x, y in zip(a, b) if x and y), Fraction(0))


def _right_inverse(matrix: Matrix) -> Matrix:
    """Weights w with Σ_j w[i][j]·matrix[c][j] = δ_{ic}; the rows of the matrix are independent."""
    if not matrix:
        return []
    width = len(matrix[0])
    found = []
    for i in range(len(matrix)):
        weights = solution(matrix, [Fraction(int(i == c)) for c in range(len(matrix))], width)
        assert weights is not None
        found.append(weights)
    return found


def _eigenfunctions(matrices: Sequence[Matrix], size: int) -> list[list[Any]]:
    """Common eigenvectors ψ of the transposed matrices, with rational eigenvalues."""
    generic = [
        [sum(((7 * n + 3) * m[r][c] for n, m in enumerate(matrices)), Fraction(0)) for r in range(size)]
        for c in range(size)
    ]
    found = []
    for factor, _ in factors(generic):
        value = rational_root(factor)
        if value is None:
            continue
        shifted = [[v - (value if r == c else 0) for c, v in enumerate(row)] for r, row in enumerate(generic)]
        found += [
            psi
            for psi in null_space(shifted, size)
            if all(_proportional(psi, matrix, size) for matrix in matrices)
        ]
    return found


def _proportional(psi: Sequence[Any], matrix: Matrix, size: int) -> bool:
    image = [sum((p * matrix[r][c] for r, p in enumerate(psi)), Fraction(0)) for c in range(size)]
    pivot = next(i for i, p in enumerate(psi) if p)
    return all(v * psi[pivot] == image[pivot] * p for v, p in zip(image, psi))
