"""Codimension of the orbit of a germ, exactly, with a certificate or the answer "infinite".

One annihilator in the jets of order K tells the codimension modulo M^{K+1}. Let m be the highest degree in
which a functional of it lives: M^{m+1}θ ⊂ T + M^{K+1}θ, exactly over ℚ. The codimension is that of the germ
itself, M^{m+1}θ ⊂ T, if

* T is a module over the source functions (R, C, K …) and K > m (Nakayama), or
* T has the target part of L (A …) and K ≥ m + l, where M^lθ ⊂ T K_e f (Malgrange's preparation theorem).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.annihilator import Annihilator, Functional, annihilator
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.infinite import DEGREE, Curve, degenerate_curve
from osculant.cas.germs.tangent import JetSpace, rows, vectors

#: largest order of jets and largest number of columns tried before the answer is "undecided"
ORDER, COLUMNS = 40, 7000
#: a curve of bad points is looked for when the codimension has grown in so many orders one after the other,
#: or is not settled after so many orders
GROWTH, PATIENCE = 4, 8


@dataclass(frozen=True)
class Tangent:
    """A tangent space in the jets of one order, by its annihilator.

    >>> t = tangent(Germ("x**3", "x"), group("R"), Version.EXTENDED, 4)
    >>> t.annihilator.codimension, t.depth
    (2, 1)
    """

    germ: Germ
    group: Group
    version: Version
    space: JetSpace
    annihilator: Annihilator

    @property
    def depth(self) -> int:
        """m: the highest degree of a column on which a functional is not 0; −1 if there is none.

        M^{m+1}θ ⊂ T + M^{order+1}θ, and no smaller power of M is.
        """
        return max((self.space.degree(c) for f in self.annihilator.functionals for c in f), default=-1)

    @property
    def codimension(self) -> int:
        """The codimension modulo M^{order+1}: in θ for the extended version, else in Mθ."""
        return self.annihilator.codimension - (0 if self.version is Version.EXTENDED else self.germ.p)

    def complement(self) -> tuple[tuple[int, int], ...]:
        """Terms (monomial, component) that form a basis of θ modulo T, of the lowest degrees possible."""
        return tuple(self.space.term(c) for c in independent_columns(self.annihilator.functionals))


def tangent(germ: Germ, group_: Group, version: Version, order: int) -> Tangent:
    """The tangent space of that version of the group, modulo M^{order+1}."""
    space = JetSpace(germ.n, germ.p, order)
    found = annihilator(rows(vectors(germ, group_, version, order), space), space.columns)
    return Tangent(germ, group_, version, space, found)


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

    Finite: proved by ``tangent`` (exact modulo M^{order+1}) and ``bound`` = l. Infinite: by ``curve``.
    """

    value: int | Literal["infinite"]
    tangent: Tangent | None
    bound: int
    curve: Curve | None = None

    @property
    def finite(self) -> bool:
        """Whether it is a number."""
        return self.value != "infinite"

    def certificate(self) -> dict[str, Any]:
        """What an independent checker needs: orders, bound, prime and functionals; or the curve."""
        if self.tangent is None:
            return {"kind": "curve", "curve": str(self.curve)}
        t = self.tangent
        return {
            "kind": "annihilator",
            "order": t.space.order,
            "depth": t.depth,
            "bound": self.bound,
            "rank": t.annihilator.rank,
            "columns": t.annihilator.columns,
            "prime": t.annihilator.prime,
            "functionals": [{c: str(v) for c, v in f.items()} for f in t.annihilator.functionals],
        }


def codimension(germ: Germ, name: str | Group, extended: bool = False) -> Codimension:
    """The codimension of T G f in Mθ, or of T G_e f in θ; exact.

    Raises UndecidedError if neither a finite codimension nor a curve of bad points is found within `ORDER`
    and `COLUMNS`.

    >>> codimension(Germ("x, x*y + y**6", "x y"), "A", extended=True).value
    6
    >>> codimension(Germ("x, y**2, 0", "x y"), "A").value
    'infinite'
    """
    g = group(name)
    version = Version.EXTENDED if extended else Version.ORDINARY
    bound = contact_bound(germ, g) if g.target == "left" else 1
    if isinstance(bound, Curve):
        return Codimension("infinite", None, 0, bound)
    growth = _Growth()
    for order in orders(germ):
        found = tangent(germ, g, version, order)
        if order >= found.depth + max(bound, 1):
            return Codimension(found.codimension, found, bound)
        if growth.suspicious(found.codimension):
            curve = degenerate_curve(germ, g)
            if curve is not None:
                return Codimension("infinite", None, bound, curve)
    raise UndecidedError(
        f"The {g.name} codimension of {germ} is not settled by jets of order {last_order(germ)} (where it is "
        f"{found.codimension}){_curves_skipped(germ)}."
    )


def contact_bound(germ: Germ, g: Group) -> int | Curve:
    """The least l with M^lθ ⊂ T K_e f, with the source fields of the group; a curve if there is none."""
    contact = Group(g.name, g.source, "contact", g.fields)
    growth = _Growth()
    for order in orders(germ):
        found = tangent(germ, contact, Version.EXTENDED, order)
        if order > found.depth:
            return found.depth + 1
        if growth.suspicious(found.codimension):
            curve = degenerate_curve(germ, contact)
            if curve is not None:
                return curve
    raise UndecidedError(f"Whether {germ} is K-finite is not settled by jets of order {last_order(germ)}.")


def _curves_skipped(germ: Germ) -> str:
    return "" if germ.polynomial(DEGREE) else ', and no proof of "infinite" is looked for off polynomials'


class _Growth:
    """Says, once, that a codimension looks infinite: see `GROWTH` and `PATIENCE`."""

    def __init__(self) -> None:
        self.last, self.times, self.seen, self.told = -1, 0, 0, False

    def suspicious(self, codimension_: int) -> bool:
        self.times = self.times + 1 if codimension_ > self.last else 0
        self.last, self.seen = codimension_, self.seen + 1
        if self.told or (self.times < GROWTH and self.seen < PATIENCE):
            return False
        self.told = True
        return True


def last_order(germ: Germ) -> int:
    """The highest order of jets within the caps."""
    order = 1
    while order < ORDER and JetSpace(germ.n, germ.p, order + 1).columns <= COLUMNS:
        order += 1
    return order


def orders(germ: Germ) -> range:
    """The orders of jets tried, one after the other."""
    return range(1, last_order(germ) + 1)
