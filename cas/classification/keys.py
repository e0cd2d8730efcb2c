"""Which of the classes of a complete list a germ belongs to: told by codimensions, and by keys if need be.

See `osculant.cas.recognition.keys`: numbers that do not depend on coordinates.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable
from typing import Generic, TypeVar

from osculant.cas.classification.starts import OneJet
from osculant.cas.classification.texts import family_of
from osculant.cas.errors import UndecidedError
from osculant.cas.germs.diagonal import diagonal_form
from osculant.cas.germs.family import GenericGerm
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.parameters import rows_over_polynomials
from osculant.cas.germs.tangent import JetSpace, vectors
from osculant.cas.germs.tangent_space import tangent
from osculant.cas.recognition.forms import Column
from osculant.cas.recognition.keys import part, parts

#: what tells orbits of one codimension apart
Key = tuple[tuple[int, ...], ...]
Label = TypeVar("Label")


def jet_codimension(germ: Germ, g: Group, order: int) -> int:
    """The codimension of the orbit in the jets of an order without constants."""
    return tangent(germ, g, Version.ORDINARY, order).codimension


def general_codimension(jet: OneJet, terms: Collection[Column], parameter: Column, order: int) -> int:
    """The same if the coefficient of one of the terms is indeterminate, the others 1."""
    germ = GenericGerm(family_of(jet, terms, (parameter,)))
    spanning = vectors(germ, jet.group, Version.ORDINARY, order)
    rank = len(diagonal_form(rows_over_polynomials(germ, spanning, order)))
    return JetSpace(jet.n, jet.p, order).columns - rank - jet.p


class Sorted(Generic[Label]):
    """Classes over a 1-jet, to be found again; keys are computed only where codimensions do not tell.

    Args:
        classes: codimension, label and germ of each.
        jet: the 1-jet.
        order: the order of the jets.

    Raises UndecidedError if two classes have one key.
    """

    def __init__(self, classes: Iterable[tuple[int, Label, Germ]], jet: OneJet, order: int) -> None:
        self.jet, self.order = jet, order
        self.known: dict[int, dict[Key, Label]] = {}
        groups: dict[int, list[tuple[Label, Germ]]] = defaultdict(list)
        for size, label, germ in classes:
            groups[size].append((label, germ))
        for size, members in groups.items():
            if len(members) == 1:
                self.known[size] = {(): members[0][0]}
                continue
            self.known[size] = {key(germ, jet, order): label for label, germ in members}
            if len(self.known[size]) < len(members):
                raise UndecidedError(
                    f"Two of {len(members)} classes of codimension {size} like {members[0][1]} are not told "
                    "apart."
                )

    def of(self, size: int, germ: Germ) -> Label:
        """The class of a jet over the 1-jet with an orbit of that codimension, if the list is complete."""
        members = self.known[size]
        if len(members) == 1:
            return next(iter(members.values()))
        return members[key(germ, self.jet, self.order)]


def key(germ: Germ, jet: OneJet, order: int) -> Key:
    """The parts of the germ's key that linear algebra in jets makes."""
    titles = [title for title in parts(germ, jet.group) if title != "double points"]
    return tuple(part(germ, jet.group, title, order) for title in titles)
