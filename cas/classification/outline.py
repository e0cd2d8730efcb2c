"""The trees as an outline: for every branch its term, its codimension and what became of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from osculant.cas.classification.classify import Classified
from osculant.cas.classification.orbits import Found, Orbit, Stratum
from osculant.cas.classification.texts import germ_text, monomial_text, variables
from osculant.cas.classification.tree import Leaf, Node


@dataclass(frozen=True)
class Line:
    """A branch: how deep it is, what is decided there, the codimension so far, and its fate.

    ``kind`` is "branch", "class" (kept), "merged" (a class in a special position), "stratum" or "closed".
    """

    depth: int
    text: str
    codimension: int
    kind: str
    fate: str = ""


def outline(made: Classified) -> list[Line]:
    """The branches of all trees, those that are closed included.

    >>> from osculant.cas.classification.classify import classified
    >>> for line in outline(classified(4, 3, "A(H)", 1)):
    ...     print("  " * line.depth + line.text, line.codimension, line.kind, line.fate)
    start x1, x2, x3 0 class 0.1: x1, x2, x3
    start x1, x2, u 1 branch
      x3**2 in component 3 is there 1 class 1.1: x1, x2, u + x3**2
      x3**2 in component 3 is 0 2 closed codimension 2 > 1
    """
    bound = max((f.bound for f in made.found), default=0)
    found: list[Line] = []
    for f in made.found:
        found += _lines(made, f, f.root, 0, f"start {germ_text(f.jet, f.jet.terms)}", bound)
    return found


def _lines(made: Classified, f: Found, node: Node, depth: int, text: str, bound: int) -> Iterator[Line]:
    if node.leaf is not None:
        yield _leaf(made, f, node.leaf, depth, text)
        return
    yield Line(depth, text, node.zeros, "branch")
    assert node.column is not None and node.nonzero is not None
    term = f"{monomial_text(node.column, variables(f.jet))} in component {node.column[1] + 1}"
    there = f"{term} is a parameter" if node.parameter else f"{term} is there"
    yield from _lines(made, f, node.nonzero, depth + 1, there, bound)
    if node.zero is not None:
        yield from _lines(made, f, node.zero, depth + 1, f"{term} is 0", bound)
    else:
        size = node.zeros + 1
        special = ", or the parameter is special" if node.parameter else ""
        yield Line(depth + 1, f"{term} is 0{special}", size, "closed", f"codimension {size} > {bound}")


def _leaf(made: Classified, f: Found, leaf: Leaf, depth: int, text: str) -> Line:
    fate = f.fates[leaf]
    if isinstance(fate, Stratum):
        told = f"stratum with {fate.moduli} moduli: {fate.text}"
        return Line(depth, text, leaf.zeros, "stratum", told)
    assert isinstance(fate, Orbit)
    name = made.name(fate)
    if fate.leaf is leaf:
        return Line(depth, text, leaf.zeros, "class", f"{name}: {germ_text(f.jet, leaf.terms)}")
    shown = germ_text(f.jet, leaf.terms)
    told = f"{shown}, orbit of codimension {fate.codimension}: {name} in a special position"
    return Line(depth, text, leaf.zeros, "merged", told)
