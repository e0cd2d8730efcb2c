"""Tangent spaces of dense germs, exactly: what they are not is seen modulo a prime, what they are is proved.

Modulo a prime p let T have codimension c and contain M^{d+1}θ. In jets of every order rank_ℚ ≥ rank_p, so
that T over ℚ has codimension c at most; if in the jets of order d, far smaller, c rational functionals vanish
on it, it has codimension c and contains M^{d+1}θ.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version
from osculant.cas.germs.modular_tangent import is_dense, modular_tangent
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import Tangent, tangent


@dataclass(frozen=True)
class Unsettled:
    """The codimension seen in jets that do not settle it, and the degree of what has to be seen yet."""

    codimension: int
    depth: int


def seen_first(
    germ: Germ, group: Group, version: Version, order: int, bound: int
) -> Tangent | Unsettled | None:
    """The tangent space in jets that settle it, if jets of that order do; else what is seen in them.

    Args:
        germ: the germ.
        group: the group.
        version: of it.
        order: the order.
        bound: l, where M^lθ ⊂ T K_e f; 1 for the groups that need none.

    None for germs that are not dense, and if the prime misleads.

    >>> from osculant.cas.germs.groups import group
    >>> cusp = Germ("x + 2*y + x*y - y**2 + x**2, (x - y + x**2)**3 + (x + y)*(x - 2*y)", "x y")
    >>> seen_first(cusp, group("A"), Version.EXTENDED, 3, 2).codimension
    0
    """
    if order < version or not is_dense(germ, group, order):
        return None
    begun = time.process_time()
    seen = modular_tangent(germ, group, version, order, bound)
    if seen is None:
        return None
    if seen.depth >= order:
        return Unsettled(seen.codimension - (0 if version is Version.EXTENDED else germ.p), seen.depth)
    low = max(seen.depth, 1)
    exact = tangent(germ, group, version, low)
    if exact.annihilator.codimension != seen.codimension:
        return None
    germ.known["prime"] = seen.prime
    space = JetSpace(germ.n, germ.p, low + max(bound, 1))
    rank = space.columns - seen.codimension
    found = replace(exact.annihilator, columns=space.columns, rank=rank, prime=seen.prime)
    return replace(exact, space=space, annihilator=found, seconds=time.process_time() - begun)
