"""The tree of complete transversals over a 1-jet.

A node is a germ known up to a level, with the terms met so far. What the Lie algebra of N does to it
tells which terms of the next levels can be removed; the first that cannot is either 0 or not. If not, the
torus makes it 1 (a sign over ℝ): its exponents are independent of those of the terms before. So the jets
over the 1-jet fall into orbits of T·N (over ℂ), one for each leaf; the codimension of such an orbit is
that of the 1-jet and one for each zero. Branches with more zeros than the codimension asked for are
closed.

A coefficient that the torus does not reach is a parameter, and the leaf a family of orbits of T·N.
Special values of a parameter make one codimension more. So if the codimension asked for is reached
already, a general value will do, and the ranks at an arbitrary one are at most those at a general one;
before, the tree gives up.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from flint import fmpq, fmpz_mat

from osculant.cas.classification.starts import Base, OneJet
from osculant.cas.errors import UndecidedError
from osculant.cas.recognition.forms import Column
from osculant.cas.recognition.levels import Columns

#: values of the parameters, arbitrary ones
GENERAL = (fmpq(101, 37), fmpq(-211, 73), fmpq(307, 29))


@dataclass(frozen=True)
class Leaf:
    """An orbit of T·N.

    Attributes:
        jet: the 1-jet.
        terms: its terms, each with the coefficient 1, those of the 1-jet included.
        parameters: those of them whose coefficients are parameters instead, general ones.
        zeros: the codimension of the orbit of T·N in the jets.
        order: the order of the jets.
    """

    jet: OneJet
    terms: tuple[Column, ...]
    parameters: tuple[Column, ...]
    zeros: int
    order: int


@dataclass
class Node:
    """A place in the tree: what is done at the term, the first that cannot be removed.

    Attributes:
        column: the term; None at a leaf.
        zeros: the codimension so far.
        nonzero: the branch where the term is there.
        zero: the branch where it is 0; None if that is closed, since the codimension is too large.
        leaf: the orbit, at a leaf.
        parameter: whether the coefficient is a parameter then: the torus does not make it 1.
    """

    column: Column | None
    zeros: int
    nonzero: Node | None = None
    zero: Node | None = None
    leaf: Leaf | None = None
    parameter: bool = False

    def leaves(self) -> Iterator[Leaf]:
        """The leaves below."""
        if self.leaf is not None:
            yield self.leaf
        for branch in (self.nonzero, self.zero):
            if branch is not None:
                yield from branch.leaves()

    def size(self) -> int:
        """The number of nodes."""
        return 1 + sum(branch.size() for branch in (self.nonzero, self.zero) if branch is not None)


@dataclass
class _Growth:
    """One tree while it grows."""

    jet: OneJet
    codimension: int
    columns: Columns = field(repr=False)

    def node(self, base: Base, after: int, zeros: int) -> Node:
        """The node of a germ whose terms up to a place are known."""
        rows = self.jet.eliminated(base, self.columns)
        for at, column in enumerate(self.columns.order_of):
            if at > after and at not in rows and not self.jet.fixed(column):
                return self.branched(base, at, column, zeros)
        found = tuple(column for column, c in base.items() if c != 1)
        leaf = Leaf(self.jet, tuple(base), found, zeros, self.columns.order)
        return Node(None, zeros, leaf=leaf)

    def branched(self, base: Base, at: int, column: Column, zeros: int) -> Node:
        """The node at a term that cannot be removed."""
        value = fmpq(1)
        if not independent(list(base), column, self.jet):
            if zeros < self.codimension:
                raise UndecidedError(
                    f"Special values of a coefficient of {column[0]} in component {column[1] + 1} may hide "
                    f"orbits of codimension {zeros + 1} or more: branching on them is not built."
                )
            value = GENERAL[sum(c != 1 for c in base.values()) % len(GENERAL)]
        found = Node(column, zeros, parameter=value != 1)
        found.nonzero = self.node({**base, column: value}, at, zeros)
        if zeros < self.codimension:
            found.zero = self.node(base, at, zeros + 1)
        return found


def tree(jet: OneJet, codimension: int, order: int) -> Node:
    """The tree over a 1-jet, of jets of an order, closed above a codimension.

    >>> from osculant.cas.germs.groups import group
    >>> from osculant.cas.classification.starts import one_jets
    >>> found = tree(one_jets(group("A(H)"), 4, 3, 1)[1], 1, 2)
    >>> found.size(), [leaf.terms[-1] for leaf in found.leaves()]
    (2, [((0, 0, 2, 0), 2)])
    """
    return _Growth(jet, codimension, jet.columns(order)).node(jet.terms, -1, jet.codimension)


def exponents(column: Column, jet: OneJet) -> list[int]:
    """How the torus of all coordinates scales the coefficient of a term."""
    m, j = column
    return [*m, *([] if jet.group.target == "none" else [int(j == k) for k in range(jet.p)])]


def independent(columns: Sequence[Column], column: Column, jet: OneJet) -> bool:
    """Whether the torus makes the coefficient of another term 1 without changing those of the first."""
    rows = [exponents(c, jet) for c in columns]
    before = fmpz_mat(rows).rank() if rows else 0
    return bool(fmpz_mat([*rows, exponents(column, jet)]).rank() > before)
