"""The classes over a 1-jet: which leaves of its tree are kept, and why the others are not.

Let O be an orbit of codimension c in the jets of order k, at most the bound. Over ℂ it meets the jets
over the 1-jet in finitely many orbits of T·N with at most c zeros and parts of closed branches, which are
of larger codimension. One of those is open in it, and its number of zeros is c. So the leaves with as
many zeros as their orbit's codimension make a complete list; a leaf with more zeros is an orbit of the
list in a special position. If all leaves that are kept are k-determined, this is so for germs as well: k
is increased until they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from osculant.cas.classification.keys import Sorted, general_codimension, jet_codimension
from osculant.cas.classification.signs import Signs, real_forms, told_apart
from osculant.cas.classification.starts import OneJet
from osculant.cas.classification.texts import PARAMETERS, family_of, germ_of, germ_text
from osculant.cas.classification.tree import GENERAL, Leaf, Node, tree
from osculant.cas.errors import UndecidedError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import Determinacy, determinacy
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.parameters import codimension_of_family, moduli
from osculant.cas.recognition.forms import Column

#: jets of a higher order are not looked at
HIGHEST = 9


@dataclass(frozen=True)
class Orbit:
    """A class over ℂ.

    Attributes:
        leaf: the leaf whose orbit of T·N is open in it.
        terms: the terms of its representative: the leaf's, or fewer ones of a leaf in a special position.
        germ: the representative, all coefficients 1.
        codimension: the codimension of the orbit.
        determinacy: its degree, proved, and whether it is sharp.
        forms: the signs of the terms, one choice for each real class.
        apart: why these are different real classes; empty if that is not proved.
    """

    leaf: Leaf
    terms: tuple[Column, ...]
    germ: Germ
    codimension: int
    determinacy: Determinacy
    forms: tuple[Signs, ...]
    apart: str

    def text(self, signs: Signs) -> str:
        """A real form."""
        return germ_text(self.leaf.jet, self.terms, {c: -1 for c, s in zip(self.terms, signs) if s})


@dataclass(frozen=True)
class Stratum:
    """A family of orbits: its codimension is at most the bound, that of its orbits is not.

    Attributes:
        leaf: the leaf.
        text: the family, with parameters a, b, ….
        codimension: the codimension of the stratum.
        moduli: the number of moduli: the codimension of the orbits is more by that, in jets of the order.
    """

    leaf: Leaf
    text: str
    codimension: int
    moduli: int


@dataclass(frozen=True)
class Found:
    """What there is over a 1-jet.

    Attributes:
        jet: the 1-jet.
        bound: up to which codimension.
        order: the order of the jets.
        root: the tree.
        orbits: the classes.
        strata: the families with moduli.
        fates: for each leaf of the tree its class or stratum.
    """

    jet: OneJet
    bound: int
    order: int
    root: Node
    orbits: tuple[Orbit, ...]
    strata: tuple[Stratum, ...]
    fates: dict[Leaf, Orbit | Stratum]


def over(jet: OneJet, bound: int) -> Found:
    """The classes over a 1-jet up to a codimension.

    Raises UndecidedError where the tree does, if two classes are not told apart, or if a class is not
    determined by jets of order `HIGHEST`.
    """
    lowest = max([2, *(sum(m) for m, _ in jet.terms)])
    for order in range(lowest, HIGHEST + 1):
        root = tree(jet, bound, order)
        leaves = list(root.leaves())
        sizes = {leaf: _size(leaf) for leaf in leaves}
        kept = [leaf for leaf in leaves if sizes[leaf] == leaf.zeros]
        degrees = _degrees(kept, order)
        if degrees is not None:
            return _found(jet, bound, order, root, sizes, degrees)
    raise UndecidedError(
        f"A class over {germ_text(jet, jet.terms)} is not determined by jets of order {HIGHEST}."
    )


def _size(leaf: Leaf) -> int:
    """The codimension of the orbit of a leaf in its jets, for general values of its parameters."""
    if not leaf.parameters:
        return jet_codimension(_germ(leaf), leaf.jet.group, leaf.order)
    if len(leaf.parameters) > 1:
        raise UndecidedError(f"The codimension of {_family(leaf)} in several parameters is not decided.")
    return general_codimension(leaf.jet, leaf.terms, leaf.parameters[0], leaf.order)


def _family(leaf: Leaf) -> str:
    return germ_text(leaf.jet, leaf.terms, dict(zip(leaf.parameters, PARAMETERS)))


def _germ(leaf: Leaf) -> Germ:
    values = {c: str(GENERAL[i % len(GENERAL)]) for i, c in enumerate(leaf.parameters)}
    return germ_of(leaf.jet, leaf.terms, {c: f"({v})" for c, v in values.items()})


def _degrees(kept: Sequence[Leaf], order: int) -> dict[Leaf, Determinacy] | None:
    """Degrees of determinacy up to the order; None if one is more."""
    found = {}
    for leaf in kept:
        germ = _germ(leaf)
        if leaf.parameters:
            raise UndecidedError(f"Whether the parameters of {germ} can be removed is not decided.")
        if jet_codimension(germ, leaf.jet.group, order + 1) != leaf.zeros:
            return None
        found[leaf] = determinacy(germ, leaf.jet.group)
        degree = found[leaf].degree
        if degree == "infinite" or degree > order:
            return None
    return found


def _found(
    jet: OneJet, bound: int, order: int, root: Node, sizes: dict[Leaf, int], degrees: dict[Leaf, Determinacy]
) -> Found:
    """The classes of the leaves that are kept, and the fates of all leaves."""
    same = Sorted([(leaf.zeros, leaf, _germ(leaf)) for leaf in degrees], jet, order)
    orbits = {leaf: _orbit(leaf, same, degrees[leaf]) for leaf in degrees}
    strata = {leaf: _stratum(leaf, size) for leaf, size in sizes.items() if size > leaf.zeros}
    fates: dict[Leaf, Orbit | Stratum] = {**orbits, **strata}
    for leaf, size in sizes.items():
        if size < leaf.zeros:
            fates[leaf] = orbits[same.of(size, _germ(leaf))]
    return Found(jet, bound, order, root, tuple(orbits.values()), tuple(strata.values()), fates)


def _orbit(leaf: Leaf, same: Sorted[Leaf], degree: Determinacy) -> Orbit:
    jet, terms = leaf.jet, _reduced(leaf)
    # a germ for K is its own genotype
    stable = jet.group.target == "contact" or codimension(_germ(leaf), jet.group, extended=True).value == 0
    forms, apart = real_forms(jet, terms), told_apart(jet, terms, stable)
    if len(forms) == 1:
        terms, apart = _simplified(leaf, terms, same), "there is one only"
        forms = real_forms(jet, terms)
    return Orbit(leaf, terms, germ_of(jet, terms), leaf.zeros, degree, forms, apart)


def _reduced(leaf: Leaf) -> tuple[Column, ...]:
    """The terms of a leaf without those that Mather's lemma removes whatever their coefficient is.

    Along f + aφ the codimension is that of the leaf for all a, real or not, and φ lies in the tangent space;
    so all these germs are equivalent, over ℝ as well.
    """
    jet, terms = leaf.jet, leaf.terms
    for column in leaf.terms:
        fewer = tuple(c for c in terms if c != column)
        if column in jet.terms:
            continue
        if jet_codimension(germ_of(jet, fewer), jet.group, leaf.order) != leaf.zeros:
            continue
        family = family_of(jet, terms, (column,))
        found = codimension_of_family(family, jet.group, curves=False)
        if found.value == leaf.zeros and not found.exceptional and moduli(family, jet.group).number == 0:
            terms = fewer
    return terms


def _simplified(leaf: Leaf, terms: tuple[Column, ...], same: Sorted[Leaf]) -> tuple[Column, ...]:
    """Fewer terms in the same orbit, which has one real form: the complete list tells which orbit it is."""
    jet = leaf.jet
    for column in terms:
        fewer = tuple(c for c in terms if c != column)
        if column in jet.terms or len(real_forms(jet, fewer)) > 1:
            continue
        germ = germ_of(jet, fewer)
        size = jet_codimension(germ, jet.group, leaf.order)
        if size == leaf.zeros and same.of(size, germ) is leaf:
            terms = fewer
    return terms


def _stratum(leaf: Leaf, size: int) -> Stratum:
    return Stratum(leaf, _family(leaf), leaf.zeros, size - leaf.zeros)
