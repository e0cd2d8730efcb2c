"""Tangent spaces of orbits, for the checker: generators in jets, and the functionals that vanish on them.

Imports nothing of osculant but the checker's own algebra.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from osculant.certificates.check_algebra import (
    Exponents,
    Polynomial,
    Row,
    Vector,
    constant,
    derivative,
    is_prime,
    monomials,
    number,
    pivots,
    rank_below,
    read,
    times,
    weigh,
)
from osculant.certificates.check_text import require

EXTENDED, ORDINARY, UNIPOTENT = 0, 1, 2
#: group: (source fields, target part)
GROUPS = {
    "R": ("all", "none"),
    "L": ("none", "left"),
    "C": ("none", "contact"),
    "K": ("all", "contact"),
    "A": ("all", "left"),
    "R(H)": ("boundary", "none"),
    "K(H)": ("boundary", "contact"),
    "A(H)": ("boundary", "left"),
}


@dataclass(frozen=True)
class Problem:
    """A germ as texts, with a group and the boundary variable."""

    components: tuple[str, ...]
    source: tuple[str, ...]
    boundary: str | None
    group: str
    jets: dict[int, Vector] = field(default_factory=dict, compare=False)

    @property
    def n(self) -> int:
        """The source dimension."""
        return len(self.source)

    @property
    def p(self) -> int:
        """The target dimension."""
        return len(self.components)

    @property
    def parts(self) -> tuple[str, str]:
        """The source and the target part of the group."""
        require(self.group in GROUPS, f"{self.group!r} is no group that the checker knows")
        return GROUPS[self.group]

    @property
    def fixed(self) -> int | None:
        """The number of the boundary variable, where the group preserves it."""
        if self.parts[0] != "boundary":
            return None
        require(self.boundary in self.source, "there is no boundary variable")
        return self.source.index(self.boundary or "")

    def jet(self, order: int) -> Vector:
        """The components up to that degree."""
        if order not in self.jets:
            self.jets[order] = [read(text, self.source, order) for text in self.components]
        return self.jets[order]

    def term(self, text: str) -> tuple[Exponents, int]:
        """The term that a functional's value is given on: "x" of a function, "(0, x)" of a map."""
        parts = [text] if self.p == 1 else text.strip()[1:-1].split(",")
        require(len(parts) == self.p, f"{text!r} is no term")
        read_parts = [read(part, self.source) for part in parts]
        found = [(m, j) for j, f in enumerate(read_parts) for m in f]
        require(len(found) == 1, f"{text!r} is no term")
        return found[0]


@dataclass(frozen=True)
class Annihilated:
    """Functionals proved to be the whole annihilator of a tangent space in the jets of an order."""

    problem: Problem
    functionals: list[dict[tuple[Exponents, int], Any]]
    order: int
    weights: tuple[int, ...]

    def depth(self, weighted: bool = True) -> int:
        """The highest degree, or weight, in which a functional lives; −1 if there is none."""
        used = self.weights if weighted else ()
        return max((weigh(m, used) for f in self.functionals for m, _ in f), default=-1)

    def settles(self, bound: int | None, version: int) -> bool:
        """Whether the tangent space is known beyond the order: see `osculant.cas.germs.codimension`."""
        w = max(self.weights, default=1)
        more = w if bound is None else bound + w - 1
        enough = not self.weights or self.depth() + 1 >= version * w
        return enough and self.order >= self.depth() + max(more, 1)


def annihilated(
    problem: Problem,
    version: int,
    told: Mapping[str, Any],
    target: str | None = None,
    more: Sequence[Vector] = (),
) -> Annihilated:
    """Check that functionals vanish on a tangent space, and that there are no more; raises RejectedError.

    Args:
        problem: the germ and the group.
        version: of the group.
        told: "order", "prime", "functionals", and "weights" if degrees count them.
        target: of the group, another one for T K_e f.
        more: what linear fields add.
    """
    order, prime = told["order"], told["prime"]
    weights = tuple(told.get("weights", ()))
    require(isinstance(order, int) and 0 <= order <= 4000, "the order of the jets is no number")
    require(not weights or (len(weights) == problem.n and min(weights) > 0), "these are no weights")
    require(is_prime(prime), f"{prime} is no prime")
    place = {m: i for i, m in enumerate(sorted(monomials(problem.n, order, weights), key=_low(weights)))}
    vectors = list(spanning(problem, version, order, weights, target))
    vectors += more
    rows = [row for v in vectors if (row := _row(v, place, problem.p))]
    functionals = []
    for given in told["functionals"]:
        functional = {problem.term(t): number(v) for t, v in given.items()}
        require(all(m in place for m, _ in functional), "a functional lives beyond the jets")
        functionals.append({k: v for k, v in functional.items() if v})
    numbered: list[Row] = [{problem.p * place[m] + j: v for (m, j), v in f.items()} for f in functionals]
    by_column: dict[int, list[tuple[int, Fraction]]] = {}
    for i, f in enumerate(numbered):
        for c, v in f.items():
            by_column.setdefault(c, []).append((i, v))
    for row in rows:
        sums: dict[int, Fraction] = {}
        for c, v in row.items():
            for i, w in by_column.get(c, ()):
                sums[i] = sums.get(i, Fraction(0)) + v * w
        require(not any(sums.values()), "a functional is not 0 on the tangent space")
    require(len(pivots(numbered)) == len(numbered), "the functionals depend on each other")
    missing = problem.p * len(place) - rank_below(rows, prime)
    require(len(numbered) == missing, f"there are {len(numbered)} functionals, {missing} are needed")
    return Annihilated(problem, functionals, order, weights)


def spanning(
    problem: Problem, version: int, order: int, weights: tuple[int, ...] = (), target: str | None = None
) -> Iterator[Vector]:
    """Vectors that span a tangent space, modulo terms above the order."""
    n, p = problem.n, problem.p
    source, own = problem.parts
    kind = target or own
    every = monomials(n, order, weights)
    top = order + max(weights, default=1)
    jet = [cut(f, top, weights) for f in problem.jet(top // min(weights, default=1))]
    for i in range(n) if source != "none" else ():
        shift = int(i == problem.fixed)
        image = [derivative(f, i) for f in jet]
        if shift:
            image = [{moved(m, i): c for m, c in f.items()} for f in image]
        for e in every:
            if sum(e) >= version - shift:
                yield [_shifted(f, e, order, weights) for f in image]
    jet = [cut(f, order, weights) for f in jet]
    multipliers: list[Polynomial] = []
    if kind == "left":
        multipliers = [f for f, beta in _powers(jet, n, order, weights) if beta >= version]
    elif kind == "contact":
        multipliers = [_shifted(f, e, order, weights) for f in jet for e in every if sum(e) >= version - 1]
    for f in multipliers:
        for j in range(p):
            yield [f if i == j else {} for i in range(p)]


def cut(f: Polynomial, order: int, weights: tuple[int, ...]) -> Polynomial:
    """The terms up to that degree."""
    return {m: c for m, c in f.items() if weigh(m, weights) <= order}


def moved(m: Exponents, i: int) -> Exponents:
    """One more of the exponent number i."""
    return (*m[:i], m[i] + 1, *m[i + 1 :])


def added(a: Polynomial, b: Polynomial, factor: Fraction) -> Polynomial:
    """a + factor·b."""
    found = dict(a)
    for m, c in b.items():
        found[m] = found.get(m, Fraction(0)) + factor * c
    return {m: c for m, c in found.items() if c}


def _low(weights: tuple[int, ...]) -> Any:
    return lambda m: (weigh(m, weights), m)


def _shifted(f: Polynomial, e: Exponents, order: int, weights: tuple[int, ...]) -> Polynomial:
    room = order - weigh(e, weights)
    return {tuple(a + b for a, b in zip(m, e)): c for m, c in f.items() if weigh(m, weights) <= room}


def _powers(jet: Vector, n: int, order: int, weights: tuple[int, ...]) -> Iterator[tuple[Polynomial, int]]:
    """(f^β, |β|) for all β with f^β not 0 up to the order."""
    level: list[tuple[Polynomial, int]] = [(constant(1, n), 0)]
    size = 0
    while level:
        yield from ((f, size) for f, _ in level)
        following = []
        for f, last in level:
            for i in range(last, len(jet)):
                product = times(f, jet[i]) if weights else times(f, jet[i], order)
                product = cut(product, order, weights)
                if product:
                    following.append((product, i))
        level, size = following, size + 1


def _row(vector: Vector, place: Mapping[Exponents, int], p: int) -> Row:
    return {p * place[m] + j: c for j, f in enumerate(vector) for m, c in f.items() if c and m in place}
