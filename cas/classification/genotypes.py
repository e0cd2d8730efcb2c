"""The second route (Mather): stable germs are the unfoldings of their genotypes, so count those for K(H).

A germ of codimension at most n − 1 is A(H)-stable, and its class is that of its genotype g, the rest of f
with the components that are coordinates set to 0, for K(H). g: R^m → R^q with m = n − r and q = p − r has
no linear part on H, the codimension of f is that of g, and g occurs for n variables if that is at most n
− 1. So the genotypes are classified by a tree of their own, for another group in fewer variables.
"""

from __future__ import annotations

from dataclasses import dataclass

from osculant.cas.classification.keys import Key, key
from osculant.cas.classification.orbits import Found, Orbit, over
from osculant.cas.classification.starts import OneJet
from osculant.cas.classification.texts import germ_of
from osculant.cas.germs.groups import Group, group


@dataclass(frozen=True)
class SecondRoute:
    """What the genotypes say.

    Attributes:
        codimension: up to which codimension: at most n − 1.
        classes: the number of genotypes; a submersion on H has none and counts as one class.
        forms: the number of their real forms.
        genotypes: for each class its genotype as text; "0" for a submersion on H.
        agrees: whether classes, codimensions and numbers of real forms are those of the first route.
    """

    codimension: int
    classes: int
    forms: int
    genotypes: tuple[str, ...]
    agrees: bool


def second_route(found: tuple[Found, ...], n: int, p: int, bound: int) -> SecondRoute:
    """The genotypes up to a codimension, compared with what the first route found."""
    bound = min(bound, n - 1)
    contact = group("K(H)")
    texts, forms, classes, agrees = [], 0, 0, True
    for r in range(min(n - 1, p), -1, -1):
        theirs = [f for f in found if f.jet.rank == r]
        if r == p:
            texts.append("0")
            classes, forms = classes + 1, forms + 1
            agrees = agrees and [len(o.forms) for f in theirs for o in f.orbits] == [1]
            continue
        for linear in (True, False):
            jet = OneJet(contact, n - r, p - r, 0, linear)
            ours = over(jet, bound) if jet.codimension <= bound else None
            first = [
                (f, o) for f in theirs if f.jet.linear == linear for o in f.orbits if o.codimension <= bound
            ]
            orbits = ours.orbits if ours is not None else ()
            agrees = agrees and _same(ours, first, contact)
            classes += len(orbits)
            forms += sum(len(o.forms) for o in orbits)
            texts += [o.text(o.forms[0]) for o in orbits]
    return SecondRoute(bound, classes, forms, tuple(texts), agrees)


def _same(ours: Found | None, first: list[tuple[Found, Orbit]], contact: Group) -> bool:
    """Whether the genotypes of the classes are those found, each once."""
    orbits = ours.orbits if ours is not None else ()
    if len(orbits) != len(first):
        return False
    if ours is None:
        return True
    order = max([ours.order, *(f.order for f, _ in first)])
    left = {(o.codimension, len(o.forms), key(o.germ, ours.jet, order)) for o in orbits}
    for _, orbit in first:
        left.discard((orbit.codimension, len(orbit.forms), _key(orbit, ours.jet, order)))
    return not left


def _key(orbit: Orbit, jet: OneJet, order: int) -> Key:
    """What tells the genotype of a class apart."""
    r = orbit.leaf.jet.rank
    terms = [(m[r:], j - r) for m, j in orbit.terms if j >= r and not any(m[:r])]
    return key(germ_of(jet, terms), jet, order)
