"""Adjacencies: which classes have others in the closure of their orbits.

B is adjacent to A if germs of class A come arbitrarily near to those of B. Witnesses are B with one or two
terms of its normal space added. If the torus scales the coefficients of all terms independently, what holds
for the coefficient 1 holds for arbitrarily small ones; else the codimension at 1 must be that for all
coefficients but finitely many. A germ of codimension at most the bound is one of the list, since that is
complete. So every adjacency listed is proved; others, which need more terms, may be missing.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import combinations

from osculant.cas.classification.keys import Sorted, general_codimension, jet_codimension
from osculant.cas.classification.orbits import Found, Orbit
from osculant.cas.classification.starts import OneJet
from osculant.cas.classification.texts import germ_of
from osculant.cas.classification.tree import independent
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.linear import rank
from osculant.cas.recognition.forms import Column

#: a class and one in whose closure it lies
Pair = tuple[Orbit, Orbit]


def adjacencies(found: Sequence[Found]) -> list[Pair]:
    """Pairs (B, A) of classes with B in the closure of A, those that follow from others left out."""
    if not found:
        return []
    lists = _Lists(found)
    orbits = sorted((o for f in found for o in f.orbits), key=lambda o: o.codimension)
    above: dict[int, set[int]] = {}
    place = {id(o): i for i, o in enumerate(orbits)}
    for i, orbit in enumerate(orbits):
        met: set[int] = set()
        for terms, special in _near(orbit):
            near = lists.class_of(terms, special, orbit)
            if near is not None:
                met |= {place[id(near)], *above[place[id(near)]]}
        above[i] = met
    return [
        (orbits[i], orbits[j])
        for i in above
        for j in sorted(above[i])
        if not any(j in above[k] for k in above[i])
    ]


class _Lists:
    """The lists by ranks of 1-jets, on H and as a whole, to look germs up."""

    def __init__(self, found: Sequence[Found]) -> None:
        self.order = max(f.order for f in found)
        over: dict[tuple[int, int], list[Found]] = defaultdict(list)
        for f in found:
            over[f.jet.rank, f.jet.rank + f.jet.linear].append(f)
        self.lists = {ranks: self._sorted(same) for ranks, same in over.items()}

    def _sorted(self, found: Sequence[Found]) -> Sorted[Orbit]:
        classes = [(o.codimension, o, o.germ) for f in found for o in f.orbits]
        return Sorted(classes, found[0].jet, self.order)

    def class_of(self, terms: Sequence[Column], special: Column | None, orbit: Orbit) -> Orbit | None:
        """The class of these terms, of a codimension below that of an orbit; None if it is not, or not told.

        The coefficient of the special one, if there is one, is a general number, the others are 1.
        """
        jet = orbit.leaf.jet
        germ = germ_of(jet, terms)
        if special is None:
            size = jet_codimension(germ, jet.group, self.order)
        else:
            size = general_codimension(jet, terms, special, self.order)
        if size >= orbit.codimension:
            return None
        # orbits of one size are closed in their union: a curve of such germs lies in one
        usual = special is None or jet_codimension(germ, jet.group, self.order) == size
        return self.lists[_ranks(germ, jet)].of(size, germ) if usual else None


def _ranks(germ: Germ, jet: OneJet) -> tuple[int, int]:
    """The rank of the derivative on H, and the whole rank; without H both are the same."""
    from fractions import Fraction

    rows = [[Fraction(f.get(poly.variable(i, jet.n), 0)) for i in range(jet.n)] for f in germ.jet(1)]
    return rank([row[: jet.own] for row in rows], jet.own), rank(rows, jet.n)


def _near(orbit: Orbit) -> Iterator[tuple[list[Column], Column | None]]:
    """Terms of germs near those of the class, and which of them must have a general coefficient, if one."""
    jet, n = orbit.leaf.jet, orbit.leaf.jet.n
    space = codimension(orbit.germ, jet.group).tangent
    assert space is not None  # the codimension is finite
    normal: list[Column] = [(poly.exponents_of(m, n), j) for m, j in space.complement() if m]
    for size in (1, 2):
        for added in combinations(normal, size):
            terms = list(orbit.terms)
            bound: list[Column] = []
            for column in added:
                if column not in terms:
                    bound += [] if independent(terms, column, jet) else [column]
                    terms.append(column)
            if len(terms) == len(orbit.terms) + size and len(bound) <= (size == 1):
                yield terms, bound[0] if bound else None
