"""dim O/(f*O_p + I): how far functions on a source, or on a curve I in it, are from functions of f.

For n = 1 and I = 0 this is δ of the image curve, of one branch or of several together; for n = p = 2 and the
ideal of the critical set Σ it is δ of the discriminant less that of Σ, the number of cusps and double folds
together. Let M^l ⊂ I + f*M_p·O. If M^{m+1} lies in the span modulo M^{K+1} and K ≥ m + l, it lies in it
(Nakayama over the target's functions), so jets of order K tell the dimension exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.annihilator import annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.local_algebra import local_algebra
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.search import Patience, Search
from osculant.cas.germs.tangent import JetSpace


def relative_delta(
    branches: Sequence[Germ],
    ideal: Callable[[int], Sequence[Polynomial]] = lambda order: (),
    patience: Patience | None = None,
) -> int:
    """The dimension of ⊕O modulo I and the functions of f, for branches fᵢ with one target.

    Args:
        branches: germs with one source and one target dimension; I is in the source of a single one.
        ideal: ideal(k) are generators of I, cut above degree k.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises UndecidedError if it is not settled in that time: it may be infinite.

    >>> relative_delta([Germ("t^3, t^4", "t")]), relative_delta([Germ("t, 0", "t"), Germ("t, t^3", "t")])
    (3, 3)
    """
    patience, first = patience or Patience(), branches[0]
    n, count = first.n, len(branches)
    bound = max(_contact(branch, ideal, patience) for branch in branches)
    search = Search(n, count, None, patience)
    for order in search.orders():
        space = JetSpace(n, count, order)
        place = space.place()
        every = poly.monomials(n, order)
        vectors: list[tuple[Polynomial, ...]]
        vectors = [(poly.times(f, {m: 1}, n, order),) for f in ideal(order) for m in every]
        vectors += _functions(branches, order)
        rows = [row for v in vectors if (row := space.row(v, place))]
        found = annihilator(rows, space.columns)
        depth = max((space.degree(c) for f in found.functionals for c in f), default=-1)
        if order >= depth + max(bound, 1):
            return found.codimension
        search.grown(found.codimension)
    raise UndecidedError(
        f"The dimension δ of {first} does not settle in jets of order {search.order}: it may be infinite."
    )


def _contact(branch: Germ, ideal: Callable[[int], Sequence[Polynomial]], patience: Patience) -> int:
    """The least l with M^l ⊂ I + f*M_p·O."""
    found = local_algebra(
        lambda order: [*branch.jet(order), *ideal(order)], branch.n, "algebra of f", None, patience
    )
    assert found is not None  # no proof of "infinite" was sought
    return len(found.hilbert)


def _functions(branches: Sequence[Germ], order: int) -> list[tuple[Polynomial, ...]]:
    """The functions y^β of the target on all branches, up to that degree, none 0 on all."""
    n, p = branches[0].n, branches[0].p
    on = [dict(poly.powers(branch.jet(order), n, order)) for branch in branches]
    exponents = dict.fromkeys(beta for powers in on for beta in powers)
    assert all(len(beta) == p for beta in exponents)
    return [tuple(powers.get(beta, {}) for powers in on) for beta in exponents]


@dataclass(frozen=True)
class Semigroup:
    """The orders of the functions on a curve with one branch: ``generators``, ``gaps``, ``conductor``.

    δ is the number of gaps; for a plane curve the conductor is μ = 2δ.
    """

    generators: tuple[int, ...]
    gaps: tuple[int, ...]

    @property
    def delta(self) -> int:
        """δ, the number of gaps."""
        return len(self.gaps)

    @property
    def conductor(self) -> int:
        """The least c from which on all numbers are orders."""
        return max(self.gaps, default=-1) + 1


def semigroup(curve: Germ, patience: Patience | None = None) -> Semigroup:
    """The semigroup of a parametrised curve that is one to one.

    Elimination of the functions of f in the jets of order K gives orders of functions; as soon as there are
    as many one after the other as the least order, all later ones are orders, and those below are known.

    Raises DomainError for a germ of more variables, UndecidedError if it is not settled in time: the curve
    may be a multiple covering of its image, which has no such semigroup.

    >>> semigroup(Germ("t^4, t^6 + t^7", "t"))
    Semigroup(generators=(4, 6, 13), gaps=(1, 2, 3, 5, 7, 9, 11, 15))
    """
    if curve.n != 1:
        raise DomainError(f"The semigroup is that of a curve; this germ has {curve.n} source variables.")
    search = Search(1, 1, None, patience or Patience())
    for order in search.orders():
        orders = _orders(curve, order)
        least = next((k for k in sorted(orders) if k), None)
        if least is not None:
            start = next((c for c in range(order) if all(c + i in orders for i in range(least))), None)
            if start is not None:
                gaps = tuple(k for k in range(start) if k not in orders)
                return Semigroup(_generators(orders, start, least), gaps)
        search.grown(order)
    raise UndecidedError(f"The semigroup of {curve} does not settle in jets of order {search.order}.")


def _orders(curve: Germ, order: int) -> set[int]:
    """The orders of the functions of f below the order of the jets, by elimination."""
    space = JetSpace(1, 1, order)
    rows = [space.row((power,), space.place()) for _, power in poly.powers(curve.jet(order), 1, order)]
    found = annihilator(rows, space.columns)
    return set(range(order + 1)) - set(found.free)  # a free column is the last one of its functional


def _generators(orders: set[int], conductor: int, least: int) -> tuple[int, ...]:
    """The elements that are no sums of smaller ones."""
    reach = conductor + least
    elements = {k for k in range(1, reach) if k >= conductor or k in orders}
    return tuple(sorted(k for k in elements if not any(k - e in elements for e in elements if e < k)))
