"""Codimension of the orbit of a germ, exactly, with a certificate or the answer "infinite".

One annihilator in the jets of order K tells the codimension modulo M^{K+1}. Let m be the highest degree in
which a functional of it lives: M^{m+1}θ ⊂ T + M^{K+1}θ, exactly over ℚ. The codimension is that of the germ
itself, M^{m+1}θ ⊂ T, if

* T is a module over the source functions (R, C, K …) and K > m (Nakayama), or
* T has the target part of L (A …) and K ≥ m + l, where M^lθ ⊂ T K_e f (Malgrange's preparation theorem).

The same holds for the ideals W_d of monomials of weight d or more, if the variables have weights of at most
w: in the jets up to weight K, W_{m+1}θ ⊂ T if K ≥ m + w (modules) or K ≥ m + l + w − 1, where W_lθ ⊂ T K_e f.
For a quasi-homogeneous germ such jets are far smaller.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.geometry import Degeneration, Geometry
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import FIELD_ORDER, Group, Version, group
from osculant.cas.germs.modular_first import Unsettled, seen_first
from osculant.cas.germs.polynomials import LARGEST
from osculant.cas.germs.search import COLUMNS, GRADED, Patience, Search
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.tangent_space import Tangent, annihilator_certificate, tangent
from osculant.cas.germs.weights import graded_by


@dataclass(frozen=True)
class Codimension:
    """The codimension of an orbit: ``value`` is a number or "infinite".

    Finite: proved by ``tangent`` (exact modulo M^{order+1}) and ``bound`` = l, which for A and L the tangent
    space ``contact`` T K_e f tells. Infinite: by ``proof``.
    """

    value: int | Literal["infinite"]
    tangent: Tangent | None
    bound: int
    proof: Degeneration | None = None
    contact: Tangent | None = None

    @property
    def finite(self) -> bool:
        """Whether it is a number."""
        return self.value != "infinite"

    def certificate(self) -> dict[str, Any]:
        """What an independent checker needs: orders, bound, prime and functionals; or the locus."""
        if self.tangent is None:
            assert self.proof is not None
            return self.proof.certificate()
        told = {"kind": "annihilator", **annihilator_certificate(self.tangent), "bound": self.bound}
        if self.contact is not None:
            told["contact"] = annihilator_certificate(self.contact)
        return told


def codimension(
    germ: Germ, name: str | Group, extended: bool = False, patience: Patience | None = None
) -> Codimension:
    """The codimension of T G f in Mθ, or of T G_e f in θ; exact.

    Args:
        germ: the germ.
        name: the group.
        extended: which of the two.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises UndecidedError if neither a finite codimension nor a proof of "infinite" is found in that time and
    with `search.COLUMNS`.

    >>> codimension(Germ("x, x*y + y**6", "x y"), "A", extended=True).value
    6
    >>> codimension(Germ("x, y**2, 0", "x y"), "A").value
    'infinite'
    """
    g, patience = group(name), patience or Patience()
    version = Version.EXTENDED if extended else Version.ORDINARY
    geometry = Geometry(germ, g)
    try:
        found = _settled(germ, g, version, geometry, patience)
        if isinstance(found, Degeneration):
            return Codimension("infinite", None, 1, found)
        made, contact = found
        bound = 1 if contact is None else contact.depth + 1
        return Codimension(made.codimension, made, bound, None, contact)
    finally:
        geometry.stop()


def contact_bound(germ: Germ, g: Group, patience: Patience | None = None) -> int | Degeneration:
    """The least l with M^lθ ⊂ T K_e f, with the source fields of the group; if there is none, the proof.

    Raises UndecidedError if that is not settled in time.
    """
    geometry = Geometry(germ, Group(g.name, g.source, "contact", g.fields))
    try:
        found = _contact(germ, g, geometry, patience or Patience(), ())
        return found if isinstance(found, Degeneration) else found.depth + 1
    finally:
        geometry.stop()


def tangent_of_contact(germ: Germ, g: Group, patience: Patience) -> Tangent:
    """T K_e f of a germ that is known to be K-finite, in jets that count degrees."""
    found = _contact(germ, g, Geometry(germ, g), patience, ())
    assert isinstance(found, Tangent)
    return found


def _settled(
    germ: Germ, g: Group, version: Version, geometry: Geometry, patience: Patience
) -> tuple[Tangent, Tangent | None] | Degeneration:
    """A tangent space known exactly, for A and L with T K_e f; or the proof that there is none."""
    plain = Search(germ.n, germ.p, geometry, patience)
    contact = _contact(germ, g, geometry, patience, ()) if g.target == "left" else None
    if isinstance(contact, Degeneration):
        return contact
    found = _tangent(germ, plain, g, version, contact, GRADED)
    if found is None and g.source != "own" and (graded := graded_by(germ)):
        other = _contact(germ, g, geometry, patience, graded) if g.target == "left" else None
        if not isinstance(other, Degeneration):
            light = Search(germ.n, germ.p, geometry, patience, graded)
            found = _tangent(germ, light, g, version, other)
            if isinstance(found, Tangent):
                return found, other
    if found is None:
        found = _tangent(germ, plain, g, version, contact)
    if found is not None:
        return found if isinstance(found, Degeneration) else (found, contact)
    proof = patience.wait(geometry)
    if proof is None:
        raise UndecidedError(
            f"The {g.name} codimension of {germ} is not settled by jets of order {plain.order} (where it is "
            f"{plain.last}) within {patience.seconds:.3g} seconds."
        )
    return proof


def _tangent(
    germ: Germ, search: Search, g: Group, version: Version, contact: Tangent | None, limit: int = COLUMNS
) -> Tangent | Degeneration | None:
    """The tangent space at the first order of the search at which it is known exactly."""
    bound = 1 if contact is None else contact.depth + 1
    for order in search.orders(limit, FIELD_ORDER if g.source == "own" else LARGEST):
        seen = None if search.weights else seen_first(germ, g, version, order, bound)
        search.light = seen is not None
        if isinstance(seen, Unsettled):
            search.least = seen.depth + 1
            if search.grown(seen.codimension):
                return search.proof
            continue
        found = seen or tangent(germ, g, version, order, search.weights)
        search.cost = found.seconds
        if found.settled(bound):
            return found
        if search.grown(found.codimension):
            return search.proof
    return None


def _contact(
    germ: Germ, g: Group, geometry: Geometry, patience: Patience, weights: tuple[int, ...]
) -> Tangent | Degeneration:
    """T K_e f, which tells the least l with W_lθ ⊂ T K_e f."""
    contact = Group(g.name, g.source, "contact", g.fields)
    search = Search(germ.n, germ.p, geometry, patience, weights)
    found = _tangent(germ, search, contact, Version.EXTENDED, None)
    if found is None:
        proof = patience.wait(geometry)
        if proof is None:
            raise UndecidedError(
                f"Whether {germ} is K-finite is not settled by jets of order {search.order}."
            )
        return proof
    return found


def last_order(germ: Germ) -> int:
    """The highest order of jets within the bound on columns."""
    order = 1
    while JetSpace(germ.n, germ.p, order + 1).columns <= COLUMNS and order < 400:
        order += 1
    return order
