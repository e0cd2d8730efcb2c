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

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Literal

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.annihilator import Annihilator, Functional, annihilator
from osculant.cas.germs.geometry import Degeneration, Geometry
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import FIELD_ORDER, Group, Version, group
from osculant.cas.germs.polynomials import LARGEST
from osculant.cas.germs.search import COLUMNS, GRADED, Patience, Search
from osculant.cas.germs.tangent import JetSpace, rows, vectors
from osculant.cas.germs.weights import graded_by


@dataclass(frozen=True)
class Tangent:
    """A tangent space in the jets of one order, by its annihilator, and the seconds that it took.

    >>> t = tangent(Germ("x**3", "x"), group("R"), Version.EXTENDED, 4)
    >>> t.annihilator.codimension, t.depth
    (2, 1)
    """

    germ: Germ
    group: Group
    version: Version
    space: JetSpace
    annihilator: Annihilator
    seconds: float = field(default=0.0, compare=False)

    @property
    def depth(self) -> int:
        """m: the highest degree of a column on which a functional is not 0; −1 if there is none.

        M^{m+1}θ ⊂ T + M^{order+1}θ, and no smaller power of M is; with weights the same of W.
        """
        return max((self.space.degree(c) for f in self.annihilator.functionals for c in f), default=-1)

    @property
    def plain_depth(self) -> int:
        """The depth by degrees without weights."""
        return max((self.space.plain_degree(c) for f in self.annihilator.functionals for c in f), default=-1)

    def settled(self, bound: int) -> bool:
        """Whether W_{depth+1}θ ⊂ T by the criterion, where W_bound θ ⊂ T K_e f (1 for modules)."""
        w = max(self.space.weights, default=1)
        more = bound + w - 1 if self.group.target == "left" else w
        # with weights the unipotent fields must have all multiples that lie in W_{depth+1}
        enough = self.depth + 1 >= self.version * w or not self.space.weights
        return enough and self.space.order >= self.depth + max(more, 1)

    @property
    def codimension(self) -> int:
        """The codimension modulo M^{order+1}: in θ for the extended version, else in Mθ."""
        return self.annihilator.codimension - (0 if self.version is Version.EXTENDED else self.germ.p)

    def complement(self) -> tuple[tuple[int, int], ...]:
        """Terms (monomial, component) that form a basis of θ modulo T, of the lowest degrees possible."""
        return tuple(self.space.term(c) for c in independent_columns(self.annihilator.functionals))


def tangent(
    germ: Germ, group_: Group, version: Version, order: int, weights: tuple[int, ...] = ()
) -> Tangent:
    """The tangent space of that version of the group, modulo M^{order+1} (with weights modulo W); kept."""
    key = group_, version, order, weights
    if key not in germ.known:
        begun = time.process_time()
        space = JetSpace(germ.n, germ.p, order, weights)
        spanning = rows(vectors(germ, group_, version, order, weights), space)
        found = annihilator(spanning, space.columns, germ.field)
        germ.known[key] = Tangent(germ, group_, version, space, found, time.process_time() - begun)
    made: Tangent = germ.known[key]
    return made


def independent_columns(functionals: Sequence[Functional]) -> list[int]:
    """Columns on which functionals are independent, greedily from the first (lowest degree).

    >>> independent_columns([{0: Fraction(1), 1: Fraction(1)}, {0: Fraction(2), 1: Fraction(2)}])
    [0]
    """
    pivots: dict[int, dict[int, Fraction]] = {}
    by_column: dict[int, dict[int, Fraction]] = {}
    for i, functional in enumerate(functionals):
        for column, value in functional.items():
            by_column.setdefault(column, {})[i] = value
    chosen = []
    for column in sorted(by_column):
        vector = dict(by_column[column])
        for lead, pivot in pivots.items():
            if factor := vector.get(lead, Fraction(0)):
                for i, value in pivot.items():
                    vector[i] = vector.get(i, Fraction(0)) - factor * value
        vector = {i: v for i, v in vector.items() if v}
        if vector:
            lead = min(vector)
            pivots[lead] = {i: v / vector[lead] for i, v in vector.items()}
            chosen.append(column)
    return chosen


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


def annihilator_certificate(t: Tangent) -> dict[str, Any]:
    """The annihilator of a tangent space as plain data: functionals by their values on columns."""
    told = {
        "order": t.space.order,
        "depth": t.depth,
        "rank": t.annihilator.rank,
        "columns": t.annihilator.columns,
        "prime": t.annihilator.prime,
        "functionals": [{c: str(v) for c, v in f.items()} for f in t.annihilator.functionals],
    }
    return {**told, "weights": list(t.space.weights)} if t.space.weights else told


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
        found = tangent(germ, g, version, order, search.weights)
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
