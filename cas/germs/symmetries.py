"""Linear parts of symmetries of a germ: combinations D of linear fields with D f ∈ T G₁ f in some jets.

They only propose coordinates. So those of a dense germ are seen modulo primes, and lifted to rational ones
that the next prime agrees with, without a proof.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from osculant.cas.germs.annihilator import MOST_PRIMES
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.lifting import Residues
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.linear_fields import all_linear_fields, pairings
from osculant.cas.germs.modular_span import Array, Span
from osculant.cas.germs.modular_tangent import first_prime, is_dense, modular_tangent
from osculant.cas.germs.search import GRADED
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import tangent

Matrix = list[list[Any]]


def symmetries(germ: Germ, group: Group, order: int) -> Matrix:
    """A basis of these combinations, by the coefficients of all linear fields of the group.

    >>> from osculant.cas.germs.groups import group
    >>> symmetries(Germ("x**3", "x"), group("R"), 4)  # 3f is the derivative along x ∂/∂x
    [[Fraction(-1, 3), Fraction(1, 1)]]
    """
    fields = all_linear_fields(germ, group)
    if is_dense(germ, group, order) and (found := _lifted(germ, group, order)) is not None:
        return found
    first = tangent(germ, group, Version.UNIPOTENT, order)
    values = [pairings(field, germ, first.space, first.annihilator.functionals) for field in fields]
    return null_space(list(map(list, zip(*values))), len(fields))


def telling_orders(germ: Germ, group: Group, order: int) -> list[int]:
    """Orders up to that one, the highest first, in which there may be other symmetries.

    Those of a jet are among those of a lower jet; of orders with as many, which is seen modulo a prime, the
    lowest is enough.

    >>> from osculant.cas.germs.groups import group
    >>> telling_orders(Germ("x**3 + y**4", "x y"), group("R"), 4)
    [4, 3, 2]
    """
    orders = [k for k in range(2, order + 1) if JetSpace(germ.n, germ.p, k).columns <= GRADED]
    if not orders or not is_dense(germ, group, orders[-1]):
        return orders[::-1]
    found: list[int] = []
    last = -1
    for k in orders:
        seen = _modulo(germ, group, k, first_prime(germ, k))
        if seen is None:
            return orders[::-1]
        count = len(seen[1])
        if count and count != last:
            found.append(k)
        last = count
    return found[::-1]


def _modulo(germ: Germ, group: Group, order: int, start: int) -> tuple[int, tuple[int, ...], Array] | None:
    """(prime, free fields, combinations as columns) modulo the next prime; None if jets are too large."""
    seen = modular_tangent(germ, group, Version.UNIPOTENT, order, None, start)
    if seen is None:
        return None
    values = np.array(list(seen.pairings(germ, group).values()), dtype=np.int64)
    span = Span(len(values), seen.prime)
    span.add(values.T)
    free, found = span.annihilator()
    return seen.prime, tuple(map(int, free)), found


def _lifted(germ: Germ, group: Group, order: int) -> Matrix | None:
    """Rational combinations with the residues modulo several primes, one of which only agrees."""
    known: dict[tuple[int, ...], Residues] = {}
    proposed, start = None, first_prime(germ, order)
    for _ in range(MOST_PRIMES):
        seen = _modulo(germ, group, order, start)
        if seen is None:
            return None
        start, free, found = seen
        residues = known.setdefault(free, Residues())
        residues.add(found, start)
        vectors = residues.lifted()
        if vectors is not None and vectors == proposed:
            return [[v.get(i, Fraction(0)) for i in range(len(found))] for v in vectors]
        proposed = vectors
    return None
