"""Families with several parameters: the codimension for general values, and the strata where it is larger.

The generic codimension c is settled at a value by jets of order K, as for one parameter (`parameters`), and
elimination over ℚ[a] (`elimination`) tells polynomials off whose zeros the ranks at K are the generic ones;
there the codimension is c. On the zeros of each of their irreducible factors q the question is asked again: a
q that is linear in a parameter, u·aᵢ + v, is solved for it. Where u is not 0 the germs are a family of the
other parameters (times a power of u, which changes no orbit); where u is 0 on q = 0, v is 0 too, and the
family is restricted to u = v = 0. With one parameter left the values are complete (`codimension_of_family`).
So every value off the strata that are told has the codimension c, over ℂ; a stratum where q is not linear in
any parameter, or for which time is over, is told without a codimension: no more than that it may be larger.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from osculant.cas.errors import UndecidedError
from osculant.cas.germs.codimension import Codimension, codimension, contact_bound
from osculant.cas.germs.elimination import generic_rank
from osculant.cas.germs.family import Family, GenericGerm
from osculant.cas.germs.geometry import Degeneration
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.model import ring
from osculant.cas.germs.parameters import SAMPLES, ExceptionalValue, codimension_of_family
from osculant.cas.germs.restriction import (
    ManyGerm,
    factors_at,
    independent,
    linear,
    restricted,
    scalings,
    text,
    without_idle,
)
from osculant.cas.germs.roots import codimension_at_root, rational_root, real_roots
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import JetSpace, vectors

#: order of jets with which the codimension at an algebraic point is begun
START = 3
#: values of a parameter for which a rational point is looked for
SMALL = tuple(sign * k for k in range(1, 13) for sign in (1, -1))
Size = int | Literal["infinite"]
Real = int | Literal["infinite"] | None


@dataclass(frozen=True)
class Stratum:
    """Values of the parameters: the zeros of ``conditions``, but for the smaller strata that are told.

    Attributes:
        conditions: polynomials in the parameters, as formulas that are 0 there.
        codimension: of the germs there; None if it is not known.
        at_least: what it is at least.
        real: how many real points it has, a number or "infinite"; None if it is not known.
    """

    conditions: tuple[str, ...]
    codimension: Size | None
    at_least: int
    real: Real

    def within(self, other: Stratum) -> bool:
        """Whether it is part of another one by its conditions, with the same codimension."""
        same = self.codimension == other.codimension is not None
        return same and set(self.conditions) > set(other.conditions)

    def __str__(self) -> str:
        size = f"at least {self.at_least}" if self.codimension is None else str(self.codimension)
        return f"{', '.join(c + ' = 0' for c in self.conditions)}: {size}"


@dataclass(frozen=True)
class Stratification:
    """The codimension ``value`` of general members, and all strata where it is or may be larger."""

    value: Size
    exceptional: tuple[Stratum, ...]

    def __str__(self) -> str:
        return "; ".join([str(self.value), *map(str, self.exceptional)])


def stratification(
    family: Family, name: str | Group, extended: bool = False, patience: Patience | None = None
) -> Stratification:
    """The codimension of the members of a family by the values of its parameters, over ℂ.

    Args:
        family: with one parameter or more.
        name: the group.
        extended: whether T G_e f in θ is meant instead of T G f in Mθ.
        patience: the time that it may take; `search.SECONDS` by default.

    Raises UndecidedError if the codimension is not finite and settled at some value of the parameters.

    >>> print(stratification(Family("x, x*y + y**3, x*y**2 + c*y**4", "x y", "c"), "A", True))
    4; 2*c - 3 = 0: infinite; c - 1 = 0: infinite; 2*c - 1 = 0: infinite; c = 0: infinite
    >>> print(stratification(Family("a*x**2 + b*x**3", "x", "a b"), "R"))
    1; a = 0: 2; a = 0, b = 0: infinite
    """
    return _Strata(group(name), extended, patience or Patience()).of(family)


class _Strata:
    """The recursion over families of fewer and fewer parameters."""

    def __init__(self, g: Group, extended: bool, patience: Patience) -> None:
        self.group, self.extended, self.patience = g, extended, patience
        self.version = Version.EXTENDED if extended else Version.ORDINARY

    def of(self, family: Family) -> Stratification:
        """All strata of a family that depends on each of its parameters."""
        m = len(family.parameters)
        if self.torus(family) == m:  # one orbit where no parameter is 0
            value = self.size_at(family.at(**dict.fromkeys(family.parameters, 1)))
            conditions = list(ring(family.parameters).gens()) if value != "infinite" else []
        elif m == 1:
            found = codimension_of_family(family, self.group, self.extended, patience=self.patience)
            return Stratification(found.value, tuple(map(_stratum, found.exceptional)))
        else:
            value, conditions = self.generic(family)
        strata: dict[tuple[str, ...], Stratum] = {}
        for q in conditions:
            for stratum in self.on(family, [q], (), value):
                key = tuple(sorted(stratum.conditions))
                if key not in strata or strata[key].codimension is None:
                    strata[key] = stratum
        left = [s for s in strata.values() if not any(s.within(other) for other in strata.values())]
        order = sorted(left, key=lambda s: (len(s.conditions), s.conditions))
        return Stratification(value, tuple(order))

    def torus(self, family: Family) -> int:
        """The dimension of the orbits of scalings among the parameters."""
        return 0 if self.group.source == "own" else len(scalings(family))

    def size_at(self, germ: Germ) -> Size:
        return codimension(germ, self.group, self.extended, self.patience).value

    def generic(self, family: Family) -> tuple[int, list[Any]]:
        """The codimension for general values, and the polynomials on whose zeros it may be larger."""
        g, germ = self.group, ManyGerm(family)
        for value, found, bound in self.samples(family):
            assert found.tangent is not None
            order, depth = found.tangent.space.order, max(found.tangent.depth, 0)
            if found.tangent.space.weights:  # jets that count degrees
                order, depth = found.tangent.plain_depth + max(bound, 1), max(found.tangent.plain_depth, 0)
            high = generic_rank(germ.rows(vectors(germ, g, self.version, order), order), self.patience)
            low = generic_rank(germ.rows(vectors(germ, g, self.version, depth), depth), self.patience)
            sizes = {self.size(germ, order, high.rank), self.size(germ, depth, low.rank), value}
            if len(sizes) > 1:
                continue  # the sample was exceptional
            candidates = {str(q): q for q in high.candidates}
            if g.target == "left":
                contact = Group(g.name, g.source, "contact", g.fields)
                spanning = vectors(germ, contact, Version.EXTENDED, bound)
                ranks = generic_rank(germ.rows(spanning, bound), self.patience)
                candidates |= {str(q): q for q in ranks.candidates}
            return value, list(candidates.values())
        raise UndecidedError(
            f"The {g.name} codimension of {family} is not finite and generic at the values tried."
        )

    def size(self, germ: ManyGerm, order: int, rank: int) -> int:
        constants = 0 if self.extended else germ.p
        return JetSpace(germ.n, germ.p, order).columns - rank - constants

    def samples(self, family: Family) -> list[tuple[int, Codimension, int]]:
        """(value, codimension, l) at some values of the parameters, the least first."""
        found = []
        for i, number in enumerate(SAMPLES):
            point = {name: number * (j + 1) + i + j * j for j, name in enumerate(family.parameters)}
            germ = family.at(**point)
            here = codimension(germ, self.group, self.extended, self.patience)
            if here.value != "infinite":
                bound = contact_bound(germ, self.group, self.patience) if self.group.target == "left" else 1
                assert not isinstance(bound, Degeneration)
                found.append((here.value, here, bound))
        return sorted(found, key=lambda sample: sample[0])

    def on(
        self, family: Family | Germ, conditions: Sequence[Any], here: tuple[str, ...], least: Size
    ) -> list[Stratum]:
        """The strata on the common zeros of polynomials in the parameters where it is more than ``least``.

        ``here`` are the conditions that led to the family.
        """
        left = [q for q in conditions if not q.is_zero()]
        if any(q.is_constant() for q in left):
            return []
        if not left:
            return self.within(family, here, least)
        assert isinstance(family, Family)
        factors = [(i, [w for w, _ in q.factor()[1]]) for i, q in enumerate(left)]
        split = next(((i, found) for i, found in factors if len(found) > 1), None)
        if split is not None:
            i, found = split
            return [s for w in found for s in self.on(family, [*left[:i], w, *left[i + 1 :]], here, least)]
        left = [found[0] for _, found in factors]
        place = next((i for i, q in enumerate(left) if linear(q) is not None), -1)
        if self.patience.left() < 0 or (place < 0 and len(left) > 1):
            return [Stratum((*here, *map(text, left)), None, _number(least), None)]
        if place < 0:
            return self.orbit(family, left[0], here, least)
        return self.solved(family, left[place], [*left[:place], *left[place + 1 :]], here, least)

    def solved(
        self, family: Family, q: Any, rest: Sequence[Any], here: tuple[str, ...], least: Size
    ) -> list[Stratum]:
        """On the zeros of q = u·aᵢ + v and of the rest: where u is not 0, and where it is."""
        found = linear(q)
        assert found is not None
        _, u, v = found
        smaller, moved = restricted(family, q, rest)
        strata = self.on(smaller, moved, (*here, text(q)), least)
        units = [] if u.is_constant() else [w for w, _ in u.factor()[1]]
        strata = [s for s in strata if not {text(w) for w in units} & set(s.conditions)]
        for w in units:
            strata += self.on(family, [w, v, *rest], here, least)
        return strata

    def within(self, family: Family | Germ, here: tuple[str, ...], least: Size) -> list[Stratum]:
        """The strata of a family, that as a whole is one."""
        real: Real = 1
        try:
            if isinstance(family, Family):
                family, real = without_idle(family), "infinite"
            found = Stratification(self.size_at(family), ()) if isinstance(family, Germ) else self.of(family)
        except UndecidedError:
            return [Stratum(here, None, _number(least), real)]
        own = [Stratum(here, found.value, _number(found.value, least), real)]
        more = [Stratum((*here, *s.conditions), s.codimension, s.at_least, s.real) for s in found.exceptional]
        return (own if found.value != least else []) + more

    def orbit(self, family: Family, q: Any, here: tuple[str, ...], least: Size) -> list[Stratum]:
        """On the zeros of a q that is linear in no parameter, if scalings move all its general points."""
        names, basis = family.parameters, scalings(family) if self.group.source != "own" else []
        conditions = (*here, text(q))
        unknown = [Stratum(conditions, None, _number(least), None)]
        moving = [i for i in independent(basis) if i is not None]
        others = [i for i in range(len(names)) if i not in moving]
        if len(others) != 1 or not q.degrees()[others[0]]:
            return unknown
        value, real = self.at_orbit(family, q, moving, others[0])
        if value is None:
            return unknown
        strata = [] if value == least else [Stratum(conditions, value, _number(value, least), real)]
        if value == "infinite":
            return strata
        gens = q.context().gens()
        moved = [i for i in range(len(names)) if any(w[i] for w in basis)]
        return strata + [s for i in moved for s in self.on(family, [gens[i], q], here, least)]

    def at_orbit(self, family: Family, q: Any, moving: Sequence[int], other: int) -> tuple[Size | None, Real]:
        """(codimension, real points) at a point of q = 0 where no parameter that scalings move is 0."""
        names = family.parameters
        for number in (*SMALL, 1):
            fixed = {names[i]: number if k == 0 else 1 for k, i in enumerate(moving)}
            roots = [c for c in factors_at(q, fixed, names[other]) if c[0]]
            rational = next((r for c in roots if (r := rational_root(c)) is not None), None)
            if rational is not None:
                try:
                    value = self.size_at(family.at(**fixed, **{names[other]: rational}))
                except UndecidedError:
                    return None, None
                return value, "infinite" if moving else 1
        if not roots:
            return None, None
        one = family.restricted(**fixed) if fixed else family
        found = codimension_at_root(GenericGerm(one), self.group, self.extended, roots[0], START)
        alone = not any(degree for i, degree in enumerate(q.degrees()) if i != other)
        real: Real = "infinite" if any(map(real_roots, roots)) else 0 if alone else None
        return found.at_least if found.settled else None, real


def _number(value: Size, otherwise: Size = 0) -> int:
    """The value, or the other one, if it is a number."""
    return value if value != "infinite" else otherwise if otherwise != "infinite" else 0


def _stratum(e: ExceptionalValue) -> Stratum:
    return Stratum((e.polynomial,), e.codimension, e.at_least, e.real)
