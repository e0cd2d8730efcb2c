"""Numbers of functions by other ways than the engine's, to hold it against."""

from __future__ import annotations

from fractions import Fraction
from math import prod

from osculant.cas.errors import DomainError
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.weights import weights


def tjurina_number(germ: Germ) -> int:
    """dim θ/T K_e f: dim O/(f, ∂f) for a function. Raises DomainError if it is infinite."""
    found = codimension(germ, "K", extended=True)
    if found.value == "infinite":
        raise DomainError(f"The Tjurina number of {germ} is infinite: {found.proof}.")
    return found.value


def milnor_orlik(germ: Germ) -> Fraction:
    """Π (d − wᵢ)/wᵢ: the Milnor number of a quasi-homogeneous function, if its critical point is isolated.

    Raises DomainError for p > 1 and for a function that is not quasi-homogeneous.
    """
    found = weights(germ) if germ.p == 1 else None
    if found is None:
        raise DomainError(f"{germ} is no quasi-homogeneous function in these coordinates.")
    degree = found.target[0]
    return prod((Fraction(degree - w, w) for w in found.source), start=Fraction(1))
