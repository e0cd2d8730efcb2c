"""Classification of germs from nothing, with two routes where there are two."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from osculant.cas.classification.adjacency import adjacencies
from osculant.cas.classification.functions import critical_points
from osculant.cas.classification.genotypes import SecondRoute, second_route
from osculant.cas.classification.orbits import Found, Orbit, over
from osculant.cas.classification.reach import check
from osculant.cas.classification.starts import one_jets
from osculant.cas.germs.groups import group

#: is told the part of the work that is done, 0…1
Progress = Callable[[float], None]


@dataclass(frozen=True)
class Classified:
    """All classes up to a codimension.

    Attributes:
        found: the classes over each 1-jet, with their trees.
        orbits: the classes, by codimension.
        adjacencies: pairs (B, A) of names, B in the closure of A; those that follow from others are left out.
        second: what the genotypes say, for A(H).
    """

    found: tuple[Found, ...]
    orbits: tuple[Orbit, ...]
    adjacencies: tuple[tuple[str, str], ...]
    second: SecondRoute | None

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the classes: "2.1" is the first one of codimension 2."""
        return _names(self.orbits)

    def name(self, orbit: Orbit) -> str:
        """The name of a class."""
        return next(name for name, other in zip(self.names, self.orbits) if other is orbit)


def classified(
    n: int, p: int, name: str, codimension: int, progress: Progress = lambda part: None
) -> Classified:
    """All classes of germs Rⁿ → Rᵖ whose orbits have at most that codimension in the jets without constants.

    Args:
        n: the number of variables.
        p: the number of components.
        name: the group.
        codimension: the bound.
        progress: is told the part of the work that is done.

    Raises DomainError beyond the reach, UndecidedError where a step cannot be proved.

    >>> [str(orbit.germ) for orbit in classified(4, 5, "A(H)", 1).orbits]
    ['(x1, x2, x3, u, 0)']
    """
    check(n, p, name, codimension)
    g = group(name)
    functions = g.target == "none"
    jets = critical_points(g, n, codimension) if functions else one_jets(g, n, p, codimension)
    found = []
    for i, jet in enumerate(jets):
        progress(0.6 * i / len(jets))
        found.append(over(jet, codimension))
    orbits = tuple(sorted((o for f in found for o in f.orbits), key=lambda o: o.codimension))
    progress(0.6)
    second = second_route(tuple(found), n, p, codimension) if g.source == "boundary" else None
    progress(0.7)
    names = dict(zip(map(id, orbits), _names(orbits)))
    pairs = tuple((names[id(b)], names[id(a)]) for b, a in adjacencies(found))
    progress(1.0)
    return Classified(tuple(found), orbits, pairs, second)


def _names(orbits: Sequence[Orbit]) -> tuple[str, ...]:
    found: list[str] = []
    for orbit in orbits:
        before = sum(name.startswith(f"{orbit.codimension}.") for name in found)
        found.append(f"{orbit.codimension}.{before + 1}")
    return tuple(found)
