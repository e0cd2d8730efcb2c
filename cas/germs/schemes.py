"""Multiple-point schemes of a germ (x, g(x, y)) of corank 1 by divided differences (Marar and Mond).

For a partition (k₁, …, k_s) of N the scheme has the unknowns x, y₁, …, y_s, where yᵢ counts kᵢ times, and as
equations the divided differences of orders 1, …, N − 1 of every component of g. Its dimension is e = n − 1 +
s − (p − n + 1)(N − 1) or more. A stable germ has only smooth ones of dimension e, and none if e < 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from osculant.cas.germs.algebraic import NumberField
from osculant.cas.germs.model import ring

#: the largest N, and the most unknowns, that are tried
POINTS, UNKNOWNS = 6, 8


def partitions(n: int, p: int, multiplicity: int = POINTS) -> Iterator[tuple[int, ...]]:
    """The partitions that decide, the fewest unknowns first: of N up to the first N points that are isolated.

    For n = p every part is 2 at least: points where the germ is a submersion put no condition.

    >>> list(partitions(2, 2)), list(partitions(2, 3))
    ([(2,), (3,), (2, 2)], [(2,), (1, 1), (1, 1, 1)])
    """
    least = 2 if n == p else 1
    found = [
        parts
        for size in range(2, min(POINTS, multiplicity) + 1)
        for parts in _partitions(size, size)
        if min(parts) >= least and n - 1 + len(parts) <= UNKNOWNS and not _follows(n, p, parts, least)
    ]
    yield from sorted(found, key=lambda parts: (len(parts), sum(parts)))


def expected(n: int, p: int, parts: Sequence[int]) -> int:
    """The dimension e that the scheme of a stable germ has."""
    return n - 1 + len(parts) - (p - n + 1) * (sum(parts) - 1)


def _follows(n: int, p: int, parts: tuple[int, ...], least: int) -> bool:
    """Whether one point less is isolated already: this scheme lies finitely over that one."""
    for i, k in enumerate(parts):
        fewer = tuple(sorted((*parts[:i], *((k - 1,) if k > least else ()), *parts[i + 1 :]), reverse=True))
        if sum(fewer) >= 2 and expected(n, p, fewer) <= 0:
            return True
    return False


def cycles(size: int) -> Iterator[tuple[int, ...]]:
    """The partitions of a number, the largest parts first: the types of permutations by their cycles.

    >>> list(cycles(3))
    [(3,), (2, 1), (1, 1, 1)]
    """
    return _partitions(size, size)


def _partitions(size: int, largest: int) -> Iterator[tuple[int, ...]]:
    if not size:
        yield ()
    for k in range(min(size, largest), 0, -1):
        for rest in _partitions(size - k, k):
            yield (k, *rest)


def divided_differences(
    functions: Sequence[tuple[Any, Any]],
    names: Sequence[str],
    parts: Sequence[int],
    field: NumberField | None = None,
) -> tuple[Any, list[Any]]:
    """(the ring of x, y₁, …, y_s; the equations) for functions g = a/b of x and y, names the old variables'.

    Over a number field its generator is the last variable of all rings.

    >>> R = ring(["x", "y"])
    >>> x, y = R.gens()
    >>> [str(f) for f in divided_differences([(x*y + y**3, R.constant(1))], ["x", "y"], (2,))[1]]
    ['3*y1^2 + x']
    """
    size, m = sum(parts), len(names) - 1
    free = ring([*names[:m], *(f"y{i + 1}" for i in range(size))], field)
    gens = list(free.gens())
    x, nodes, last = gens[:m], gens[m : m + size], gens[m + size :]
    small = ring([*names[:m], *(f"y{i + 1}" for i in range(len(parts)))], field)
    short = list(small.gens())
    merged_last = short[m + len(parts) :]
    merged = [short[m + i] for i, k in enumerate(parts) for _ in range(k)]
    equations = []
    for above, below in functions:
        values = [
            (above.compose(*x, y, *last, ctx=free), below.compose(*x, y, *last, ctx=free)) for y in nodes
        ]
        for order in range(1, size):
            values = [
                ((b * c - a * d) // (nodes[i + order] - nodes[i]), c2)
                for i, ((a, c), (b, d)) in enumerate(pairwise(values))
                for c2 in [c * d]
            ]
            equation = values[0][0].compose(*short[:m], *merged, *merged_last, ctx=small)
            if not equation.is_zero():
                equations.append(equation)
    return small, equations
