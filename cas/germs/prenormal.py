"""A germ modulo a prime in coordinates in which some components are coordinates: f = (x₁, …, x_r, g).

If r components have independent derivatives at the origin (along the boundary u = 0, if it is to be kept),
they and n − r of the old coordinates are new ones. Tangent spaces are moved by such a change, so codimensions
and the powers of M that they contain are the same; in the new coordinates g alone tells a tangent space.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from osculant.cas.germs.germ import Germ
from osculant.cas.germs.modular_ring import ModularRing, residues
from osculant.cas.germs.modular_span import Array, Span, product

Residues = dict[tuple[int, ...], int]


@dataclass(frozen=True)
class Prenormal:
    """The germ in new coordinates z, by the powers of the old ones: x = ``source``·z + ….

    Attributes:
        ring: where the components are known.
        components: f in the new coordinates, as rows, in the order of ``order``: the first r are z₁, …, z_r.
        rank: r.
        order: the numbers of the components, those that are coordinates first.
        source: the matrix of the linear part of the old coordinates in the new ones.
        back: its inverse.
        boundary: the place of u among the new coordinates, or None.
    """

    ring: ModularRing
    components: Array
    rank: int
    order: tuple[int, ...]
    source: Array
    back: Array
    boundary: int | None


def linear_rank(jet: Sequence[Residues], n: int, fixed: int | None, prime: int) -> list[tuple[int, int]]:
    """(component, variable) that may be taken for each other, one by one, the variable never ``fixed``."""
    found: list[tuple[int, int]] = []
    free = [i for i in range(n) if i != fixed]
    span = Span(len(free), prime)
    for j, f in enumerate(jet):
        row = [[f.get(tuple(int(a == i) for a in range(n)), 0) for i in free]]
        before = len(span.pivots)
        span.add(np.array(row, dtype=np.int64).reshape(1, len(free)))
        if len(span.pivots) > before:
            found.append((j, free[span.pivots[-1]]))
    return found


def modular_jet(germ: Germ, order: int, prime: int) -> list[Residues] | None:
    """The components up to a degree modulo a prime; None if it divides a denominator."""
    found = [residues(f, germ.n, prime) for f in germ.jet(order)]
    return None if any(f is None for f in found) else [f for f in found if f is not None]


def prenormal(
    jet: Sequence[Residues], n: int, boundary: int | None, low: int, high: int, prime: int
) -> Prenormal:
    """The germ of a jet of order ``high`` in new coordinates, in a ring with these degrees.

    Args:
        jet: the components modulo the prime, without constant terms.
        n: the number of variables.
        boundary: the place of u, if u = 0 is to be kept.
        low: degree of the monomials kept.
        high: of those in the last coordinates alone.
        prime: the prime.

    >>> found = prenormal([{(1, 0): 1, (0, 2): 6}, {(1, 1): 1}], 2, None, 3, 3, 7)
    >>> found.rank, found.components[1].nonzero()[0].tolist()  # x - y², x·y in coordinates x and y
    (1, [4, 9])
    """
    pairs = linear_rank(jet, n, boundary, prime)
    first, r = [j for j, _ in pairs], len(pairs)
    taken = [i for _, i in pairs]
    kept = [i for i in range(n) if i not in taken]
    order = (*first, *(j for j in range(len(jet)) if j not in first))
    ring = ModularRing(n, low, high, r, prime)
    unit = np.eye(n, dtype=np.int64)
    forward = unit.copy()  # z = forward·x, to first order
    for t, j in enumerate(first):
        forward[t] = [jet[j].get(tuple(unit[i]), 0) for i in range(n)]
    for t, i in enumerate(kept):
        forward[r + t] = unit[i]
    source = _inverse(forward, prime)
    gens = np.array([ring.variable(i) for i in range(n)])
    images = product(source, gens, prime)
    if r:
        _correct(ring, [jet[j] for j in first], images, gens[:r])
    components = np.zeros((len(jet), ring.size), dtype=np.int64)
    components[:r] = gens[:r]
    if order[r:]:
        components[r:] = ring.evaluated([jet[j] for j in order[r:]], list(images))
    place = None if boundary is None else r + kept.index(boundary)
    return Prenormal(ring, components, r, order, source, forward, place)


def _correct(ring: ModularRing, functions: Sequence[Residues], images: Array, wanted: Array) -> None:
    """Change the images of the old coordinates until functions of them are those wanted (Newton)."""
    right = 1  # degree up to which they are right
    while True:
        right = min(2 * right, ring.high)
        known = [{m: c for m, c in f.items() if sum(m) <= right} for f in functions]
        error = (ring.evaluated(known, list(images)) - wanted) % ring.prime
        error[:, ring.degrees > right] = 0
        if right == ring.high and not error.any():
            return
        moved = images.copy()
        for t, e in enumerate(error):
            slopes = np.array([ring.derivative(image, t) for image in images])
            moved = (moved - ring.times(slopes, e)) % ring.prime
        images[:] = moved


def _inverse(matrix: Array, prime: int) -> Array:
    """The inverse of an invertible matrix."""
    n = len(matrix)
    span = Span(2 * n, prime)
    span.add(np.concatenate([matrix, np.eye(n, dtype=np.int64)], axis=1))
    return span.rows[np.argsort(span.pivots), n:]
