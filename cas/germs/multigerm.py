"""Multigerms (Kⁿ, S) → (Kᵖ, 0): several germs with one target, for A-equivalence.

θ is the sum of the θᵢ of the branches fᵢ, and T A_e f that of the dfᵢ(ξᵢ), for a vector field ξᵢ at each
point, and of (η∘f₁, …, η∘f_r) for one η of the target. The proofs are those of germs: T K_e f is the sum of
the T K_e fᵢ; if M^lθ lies in it, M^{m+1}θ ⊂ T A_e f + M^{K+1}θ and K ≥ m + l, then M^{m+1}θ ⊂ T A_e f.

"Infinite": one branch has infinite codimension, or the points of several branches with one image are too many
(`osculant.cas.germs.multiple_loci`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, islice, permutations, product
from operator import mul
from typing import Literal

from osculant.cas.errors import DomainError, FormulaError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import Annihilator, annihilator
from osculant.cas.germs.codimension import codimension as single
from osculant.cas.germs.codimension import contact_bound
from osculant.cas.germs.geometry import Degeneration
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Version, group
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.multiple_loci import MultiGeometry
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.search import COLUMNS, Patience, Search
from osculant.cas.germs.tangent import JetSpace, Vector, along

#: choices of nilpotent linear fields that are tried for the degree of determinacy
CHOICES = 150


class MultiGerm:
    """Germs fᵢ with the same source variables and one target.

    Args:
        branches: the germs, one at least.

    Raises DomainError for branches with different source or target dimensions.

    >>> planes = MultiGerm([Germ("x, y, 0", "x y"), Germ("x, 0, y", "x y"), Germ("0, x, y", "x y")])
    >>> codimension(planes, extended=True).value
    0
    """

    def __init__(self, branches: Sequence[Germ]) -> None:
        if not branches:
            raise FormulaError("A multigerm has no branch: give at least one germ.")
        self.branches = tuple(branches)
        first = self.branches[0]
        self.n, self.p = first.n, first.p
        for i, branch in enumerate(self.branches, start=1):
            if branch.field is not None:
                raise DomainError(
                    f"Branch {i} of the multigerm has irrational coefficients: give rational ones."
                )
        for i, branch in enumerate(self.branches[1:], start=2):
            if (branch.n, branch.p) != (self.n, self.p):
                raise DomainError(
                    f"Branch {i} goes from dimension {branch.n} to {branch.p}, branch 1 from {self.n} to "
                    f"{self.p}: the branches of a multigerm have one source and one target dimension."
                )

    @property
    def columns(self) -> int:
        """The number of components of all branches together."""
        return self.p * len(self.branches)

    def __str__(self) -> str:
        return "; ".join(map(str, self.branches))


@dataclass(frozen=True)
class MultiTangent:
    """T A f in the jets of an order, by its annihilator; component j of branch i has number p·i + j."""

    space: JetSpace
    annihilator: Annihilator

    @property
    def depth(self) -> int:
        """The highest degree of a column on which a functional is not 0; −1 if there is none."""
        return max((self.space.degree(c) for f in self.annihilator.functionals for c in f), default=-1)


@dataclass(frozen=True)
class MultiCodimension:
    """The codimension: ``value`` is a number, proved by ``tangent`` and ``bound`` = l, or "infinite".

    Infinite: by ``proof``, and ``branch`` is the number of the branch that it is about, from 1, if it is one.
    """

    value: int | Literal["infinite"]
    tangent: MultiTangent | None = None
    bound: int = 1
    proof: Degeneration | None = None
    branch: int | None = None

    @property
    def reason(self) -> str:
        """Why it is infinite; nothing for a number."""
        if self.proof is None:
            return ""
        return f"{self.proof}" if self.branch is None else f"of branch {self.branch}, {self.proof}"


def codimension(
    germ: MultiGerm, extended: bool = False, patience: Patience | None = None
) -> MultiCodimension:
    """The codimension of T A f in Mθ, or with ``extended`` of T A_e f in θ; exact.

    Raises UndecidedError if neither a number nor a proof of "infinite" is found in time.

    >>> tangent_planes = MultiGerm([Germ("x, y, 0", "x y"), Germ("x, y, x**2 + y**3", "x y")])
    >>> codimension(tangent_planes, extended=True).value
    2
    """
    patience = patience or Patience()
    version = Version.EXTENDED if extended else Version.ORDINARY
    bound = _bound(germ, patience)
    if isinstance(bound, MultiCodimension):
        return bound
    geometry = MultiGeometry(germ.branches)
    try:
        search = Search(germ.n, germ.columns, geometry, patience)
        for order in search.orders(COLUMNS):
            found = tangent(germ, version, order)
            if order >= found.depth + max(bound, 1):
                constants = 0 if extended else germ.columns
                return MultiCodimension(found.annihilator.codimension - constants, found, bound)
            if search.grown(found.annihilator.codimension):
                break
        proof = search.proof or patience.wait(geometry)
    finally:
        geometry.stop()
    if proof is None:
        raise UndecidedError(
            f"The A codimension of the multigerm {germ} is not settled by jets of order {search.order} "
            f"within {patience.seconds:.3g} seconds."
        )
    return MultiCodimension("infinite", proof=proof)


def _bound(germ: MultiGerm, patience: Patience) -> int | MultiCodimension:
    """The least l with M^lθ ⊂ T K_e f, or the proof that a branch is of infinite codimension."""
    bound = 0
    for i, branch in enumerate(germ.branches, start=1):
        found = contact_bound(branch, group("A"), patience)
        alone = None if isinstance(found, Degeneration) else single(branch, "A", True, patience)
        proof = found if isinstance(found, Degeneration) else alone.proof if alone is not None else None
        if proof is not None or isinstance(found, Degeneration):
            return MultiCodimension("infinite", proof=proof, branch=i)
        bound = max(bound, found)
    return bound


def tangent(germ: MultiGerm, version: Version, order: int, more: Sequence[Vector] = ()) -> MultiTangent:
    """The tangent space of that version of A modulo M^{order+1}, with more vectors if they are given."""
    space = JetSpace(germ.n, germ.columns, order)
    place = space.place()
    rows = [row for v in (*vectors(germ, version, order), *more) if (row := space.row(v, place))]
    return MultiTangent(space, annihilator(rows, space.columns))


def vectors(germ: MultiGerm, version: Version, order: int) -> Iterator[Vector]:
    """Spanning vectors of the tangent space, with the components of one branch after those of another."""
    n, p = germ.n, germ.p
    every = poly.monomials(n, order)
    for i, branch in enumerate(germ.branches):
        jet = branch.jet(order + 1)
        for a in range(n):
            slope = tuple(poly.derivative(f, a, n) for f in jet)
            for m in every:
                if poly.degree_of(m, n) >= version:
                    yield _placed(germ, i, tuple(poly.times(f, {m: 1}, n, order) for f in slope))
    on = [dict(poly.powers(branch.jet(order), n, order)) for branch in germ.branches]
    for beta in dict.fromkeys(beta for powers in on for beta in powers):
        if sum(beta) >= version:
            values = [powers.get(beta, {}) for powers in on]
            for j in range(p):
                yield tuple(values[i] if k == j else {} for i in range(len(on)) for k in range(p))


def _placed(germ: MultiGerm, i: int, vector: Vector) -> Vector:
    p = germ.p
    return tuple(vector[k - p * i] if p * i <= k < p * (i + 1) else {} for k in range(germ.columns))


@dataclass(frozen=True)
class MultiDeterminacy:
    """``degree`` k: the multigerm is k-determined, by jets of order ``order`` = k + l; or "infinite".

    ``sharp`` is True if (k − 1)-determinacy is refuted, with ``reason``, else None; k ≥ 1.
    """

    degree: int | Literal["infinite"]
    order: int
    sharp: bool | None
    reason: str


def determinacy(germ: MultiGerm, patience: Patience | None = None) -> MultiDeterminacy:
    """A degree k of determinacy for A: M^{k+1}θ ⊂ T U f + M^{k+l+1}θ with M^lθ ⊂ T K_e f, U unipotent.

    U is G₁ with nilpotent linear fields: triangular ones for orders of the coordinates of the sources and of
    the target. Raises UndecidedError if no degree is proved in time.

    >>> determinacy(MultiGerm([Germ("x, y, 0", "x y"), Germ("x, y, x**2 + y**3", "x y")])).degree
    3
    """
    patience = patience or Patience()
    whole = codimension(germ, patience=patience)
    if whole.tangent is None:
        return MultiDeterminacy("infinite", 0, None, f"not finitely determined: {whole.reason}")
    depth = whole.tangent.depth
    k = least = max(1, depth)  # M^{k+1}θ ⊂ T A f is necessary
    while True:
        order = k + max(whole.bound, 1)
        if k > least and patience.left() < 0:
            raise UndecidedError(f"No degree of determinacy of the multigerm {germ} below {k} is proved.")
        first = tangent(germ, Version.UNIPOTENT, order)
        if first.depth <= k or _raised(germ, first, k, patience):
            reason = f"M^{k}θ is not in its tangent space" if depth >= k > 1 else ""
            reason = reason or (_refuted(germ, k, patience) if k > 1 else "")
            return MultiDeterminacy(k, order, True if reason or k == 1 else None, reason)
        k += 1


def _refuted(germ: MultiGerm, k: int, patience: Patience) -> str:
    """Why the multigerm is not (k − 1)-determined: its (k − 1)-jet has another codimension; else nothing."""
    jet = MultiGerm([branch.truncated(k - 1) for branch in germ.branches])
    try:
        own = codimension(germ, True, patience).value
        other = codimension(jet, True, patience).value
    except UndecidedError:
        return ""
    return "" if own == other else f"its {k - 1}-jet has extended codimension {other}, not {own}"


def _raised(germ: MultiGerm, first: MultiTangent, k: int, patience: Patience) -> bool:
    """Whether some choice of nilpotent linear fields gives M^{k+1}θ."""
    functionals, space = first.annihilator.functionals, first.space
    moved = _linear_moves(germ, first)
    high = {c for f in functionals for c in f if space.degree(c) > k}
    wanted = [[f.get(c, Fraction(0)) for f in functionals] for c in high]
    orders = [list(permutations(range(germ.n)))] * len(germ.branches)
    every = product(permutations(range(germ.p)), *orders)
    for target, *sources in islice(every, CHOICES):
        if patience.left() < 0:
            return False
        chosen = [moved[-1, a, b] for a, b in combinations(target, 2)]
        for i, source in enumerate(sources):
            chosen += [moved[i, a, b] for a, b in combinations(source, 2)]
        missing = null_space(chosen, len(functionals))
        if all(sum(map(mul, column, vector)) == 0 for vector in missing for column in wanted):
            return True
    return False


def _linear_moves(germ: MultiGerm, first: MultiTangent) -> dict[tuple[int, int, int], list[Fraction]]:
    """The functionals on x_a ∂/∂x_b at point i, key (i, a, b), and on y_a ∂/∂y_b, key (−1, a, b)."""
    space, n, p = first.space, germ.n, germ.p
    place, order = space.place(), space.order
    jets = [branch.jet(order + 1) for branch in germ.branches]

    def values(vector: Vector) -> list[Fraction]:
        row = space.row(vector, place)
        return [
            sum((v * row[c] for c, v in f.items() if c in row), Fraction(0))
            for f in first.annihilator.functionals
        ]

    moved = {}
    for i, (a, b) in product(range(len(jets)), permutations(range(n), 2)):
        field: tuple[Polynomial, ...] = tuple({poly.variable(a, n): 1} if c == b else {} for c in range(n))
        moved[i, a, b] = values(_placed(germ, i, along(jets[i], field, n, order)))
    for a, b in permutations(range(p), 2):
        vector = [poly.cut(jet[a], n, order) if c == b else {} for jet in jets for c in range(p)]
        moved[-1, a, b] = values(tuple(vector))
    return moved
