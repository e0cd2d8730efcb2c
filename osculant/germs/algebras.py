"""Local algebras of map-germs at the front door: "infinite" where their dimension is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from osculant.cas.errors import DomainError

if TYPE_CHECKING:
    from osculant.cas.germs.local_algebra import LocalAlgebra
    from osculant.germs.map_germ import MapGerm


def q_algebra(germ: MapGerm) -> LocalAlgebra | Literal["infinite"]:
    """Q(f) = O/(f₁, …, fₚ).

    >>> from osculant.germs.map_germ import germ
    >>> q_algebra(germ("x**2, y**3", "x y")).hilbert, q_algebra(germ("x*y", "x y"))
    ((1, 2, 2, 1), 'infinite')
    """
    from osculant.cas.germs import local_algebra

    if germ.target < germ.exact.n:
        return "infinite"  # fewer functions than variables have a curve of common zeros
    try:
        return local_algebra.q_algebra(germ.exact, germ.patience)
    except DomainError:
        return "infinite"


def ramification(germ: MapGerm) -> LocalAlgebra | Literal["infinite"]:
    """O/R with R the ideal of the largest minors of df.

    >>> from osculant.germs.map_germ import germ
    >>> ramification(germ("x, y**2, x*y", "x y")).dimension, ramification(germ("x, y", "x y")).dimension
    (1, 0)
    """
    from osculant.cas.germs import local_algebra

    n, p = germ.exact.n, germ.target
    if germ.rank == min(n, p):
        return local_algebra.LocalAlgebra(0, ())
    # Unless it is everything, an ideal of largest minors has height |n − p| + 1 at most.
    if n > abs(n - p) + 1:
        return "infinite"
    try:
        return local_algebra.ramification(germ.exact, germ.patience)
    except DomainError:
        return "infinite"
