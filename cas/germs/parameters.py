"""Families of germs: codimension as a function of a parameter, the values where it jumps, moduli.

Let c_k(a) be the codimension of T G f_a modulo M^{k+1}, in the jets of order k. It increases with k, and for
fixed k it is least for all a but finitely many: those where the rank of a matrix over ℚ[a] drops, which its
diagonal form tells exactly (`diagonal_form`). Suppose that for a indeterminate

    c_m = c_K with K > m for R, C, K, or K ≥ m + l for A, L, where M^lθ ⊂ T K_e f_a,

and that c_K(a₀) is no more than this c. Then c = c_m ≤ c_m(a₀) ≤ c_K(a₀) = c: the same criterion holds at a₀,
and the codimension of f_{a₀} is exactly c. If c_K(a₀) > c, it is more than c. So the exceptional values are
exactly the zeros of the diagonal entries at order K; for A and L the condition on l is of the same kind, and
where it fails the codimension is found separately. This needs no primes and leaves out no value, real or
complex.

Mather's lemma: if the codimension is constant along a connected set of parameters and ∂f_a/∂a ∈ T G f_a
there, all these germs are equivalent. Membership for a indeterminate implies it at every value that is not
exceptional, because adding ∂f_a/∂a to the rows cannot raise the rank at one value above that over ℚ(a).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

from flint import fmpq_poly

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs.codimension import Codimension, codimension, contact_bound
from osculant.cas.germs.diagonal import diagonal_form
from osculant.cas.germs.family import Family, GenericGerm
from osculant.cas.germs.geometry import Degeneration, Geometry
from osculant.cas.germs.groups import Group, Version, group
from osculant.cas.germs.linear import null_space
from osculant.cas.germs.roots import (
    Coefficients,
    codimension_at_root,
    polynomial_text,
    rational_root,
    real_roots,
)
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import JetSpace, Vector, vectors

#: seconds for the proof that the codimension at an exceptional value is infinite
SECONDS = 5.0
#: values of the parameters that are tried for a germ of the least codimension
SAMPLES = (Fraction(101, 3), Fraction(-211, 7), Fraction(307, 2))


@dataclass(frozen=True)
class ExceptionalValue:
    """Values of the parameter with a larger codimension: a rational one, or the roots of a polynomial.

    ``polynomial`` is irreducible over ℚ, ``value`` its root if that is rational, ``real`` how many of its
    roots are real. ``codimension`` is that at each root, exact; None if it was not settled: then it is at
    least ``at_least``, and may be infinite.
    """

    polynomial: str
    value: Fraction | None
    real: int
    codimension: int | Literal["infinite"] | None
    at_least: int

    def __str__(self) -> str:
        size = f"at least {self.at_least}" if self.codimension is None else str(self.codimension)
        return f"{self.polynomial} = 0: {size}"


@dataclass(frozen=True)
class FamilyCodimension:
    """The codimension of f_a: ``value`` for all a but the ``exceptional`` ones; exact, all of them.

    ``order`` and ``bound`` are K and l of the proof, ``sample`` a value of a with the generic codimension.
    """

    value: int
    exceptional: tuple[ExceptionalValue, ...]
    order: int
    bound: int
    sample: Fraction

    def at(self, value: Fraction) -> int | Literal["infinite"] | None:
        """The codimension at a rational value of the parameter; None if it was not settled."""
        for e in self.exceptional:
            if e.value == value:
                return e.codimension
        return self.value

    def __str__(self) -> str:
        return "; ".join([str(self.value), *map(str, self.exceptional)])


def codimension_of_family(
    family: Family,
    name: str | Group,
    extended: bool = False,
    curves: bool = True,
    patience: Patience | None = None,
) -> FamilyCodimension:
    """The codimension of the orbit of f_a in a family of one parameter a, and where it jumps.

    Args:
        family: f_a, with one parameter.
        name: the group.
        extended: whether T G_e f in θ is meant instead of T G f in Mθ.
        curves: whether "infinite" is to be proved at rational exceptional values that are not settled, by
            looking for too many bad points, which may take seconds; without, they count as not settled.
        patience: the time for the samples and that proof; without, each has `search.SECONDS` or `SECONDS`.

    Raises DomainError for another number of parameters, UndecidedError if the codimension is infinite or not
    settled at the sample values of a.

    >>> print(codimension_of_family(Family("x**4 + a*x**2*y**2 + y**4", "x y", "a"), "R"))
    10; a - 2 = 0: infinite; a + 2 = 0: infinite
    """
    g = group(name)
    germ = GenericGerm(family)
    if any(isinstance(c, Fraction) for field in g.generators(germ) for f in field for c in f.values()):
        raise DomainError(
            f"A vector field of {g.name} has a fraction as coefficient: multiply it by an integer."
        )
    version = Version.EXTENDED if extended else Version.ORDINARY
    for value, found, bound in _samples(family, g, extended, patience):
        assert found.tangent is not None
        order, depth = found.tangent.space.order, max(found.tangent.depth, 0)
        entries = diagonal_form(rows_over_polynomials(germ, vectors(germ, g, version, order), order))
        generic = _codimension(germ, version, order, len(entries))
        low = diagonal_form(rows_over_polynomials(germ, vectors(germ, g, version, depth), depth))
        if not generic == _codimension(germ, version, depth, len(low)) == found.value:
            continue  # the sample was exceptional
        candidates = _factors(entries)
        if g.target == "left":
            others = _contact_candidates(germ, g, bound)
            if others is None:
                continue
            candidates += [q for q in others if q not in candidates]
        jumps = (_exceptional(family, g, extended, q, order, curves, patience) for q in candidates)
        exceptional = tuple(e for e in jumps if e.codimension != generic)
        return FamilyCodimension(generic, _sorted(exceptional), order, bound, value)
    raise UndecidedError(
        f"The {g.name} codimension of {family} is not finite and generic at {_shown(SAMPLES)}."
    )


def rows_over_polynomials(germ: GenericGerm, vectors_: Iterable[Vector], order: int) -> list[dict[int, Any]]:
    """Vectors with coefficients in ℚ[a] as rows of fmpq_poly, in the columns of `JetSpace`."""
    space = JetSpace(germ.n, germ.p, order)
    place, p = space.place(), germ.p
    rows = []
    for v in vectors_:
        row = {p * place[m] + j: _polynomial(c) for j, f in enumerate(v) for m, c in f.items()}
        if row:
            rows.append(row)
    return rows


@dataclass(frozen=True)
class Moduli:
    """How many parameters of a family are moduli, and the codimensions of orbit and stratum.

    ``number`` is the rank of ∂f/∂aᵢ modulo T G f. ``proved`` is True for one parameter: then all is so for
    every value that is not exceptional. For more parameters it is so at ``point``, an arbitrary rational one:
    the generic codimension is at most ``codimension``, and equal unless the point is special.
    """

    number: int
    codimension: int
    proved: bool
    point: dict[str, Fraction]

    @property
    def stratum(self) -> int:
        """The codimension of the union of the orbits of the family."""
        return self.codimension - self.number


def moduli(family: Family, name: str | Group) -> Moduli:
    """The number of moduli among the parameters of a family, at a generic member.

    Raises UndecidedError as `codimension_of_family`.

    >>> moduli(Family("x**4 + a*x**2*y**2 + y**4", "x y", "a"), "R").number
    1
    >>> moduli(Family("x**3 + a*x**4", "x", "a"), "R").number
    0
    """
    g = group(name)
    if len(family.parameters) == 1:
        return _modulus(family, g)
    found = min(_points(family, g), key=lambda pair: _value(pair[1]), default=None)
    if found is None:
        raise UndecidedError(f"The {g.name} codimension of {family} is infinite at the points tried.")
    point, here = found
    assert here.tangent is not None
    space = here.tangent.space
    values = []
    for parameter in family.parameters:
        row = space.row(family.velocity(parameter, space.order, **point), space.place())
        values.append([_pairing(f, row) for f in here.tangent.annihilator.functionals])
    number = len(values[0]) - len(null_space(values, len(values[0])))
    return Moduli(number, _value(here), False, point)


def _modulus(family: Family, g: Group) -> Moduli:
    found = codimension_of_family(family, g, curves=False)
    germ = GenericGerm(family)
    order = found.order
    rows = rows_over_polynomials(germ, vectors(germ, g, Version.ORDINARY, order), order)
    more = rows_over_polynomials(germ, [germ.velocity(order)], order)
    number = len(diagonal_form([*rows, *more])) - len(diagonal_form(rows))
    return Moduli(number, found.value, True, {family.parameters[0]: found.sample})


def _samples(
    family: Family, g: Group, extended: bool, patience: Patience | None
) -> list[tuple[Fraction, Codimension, int]]:
    """(value, codimension, l) at the samples where it is finite, the least codimension first."""
    found = []
    for value in SAMPLES:
        germ = family.at(**{family.parameters[0]: value})
        here = codimension(germ, g, extended, patience)
        if here.finite:
            bound = contact_bound(germ, g, patience) if g.target == "left" else 1
            assert not isinstance(bound, Degeneration)  # the codimension is finite
            found.append((value, here, bound))
    return sorted(found, key=lambda triple: _value(triple[1]))


def _points(family: Family, g: Group) -> Iterable[tuple[dict[str, Fraction], Codimension]]:
    for i, value in enumerate(SAMPLES):
        point = {name: value * (j + 1) + i + j * j for j, name in enumerate(family.parameters)}
        here = codimension(family.at(**point), g)
        if here.finite:
            yield point, here


def _value(found: Codimension) -> int:
    assert found.value != "infinite"
    return found.value


def _codimension(germ: GenericGerm, version: Version, order: int, rank: int) -> int:
    return JetSpace(germ.n, germ.p, order).columns - rank - (0 if version is Version.EXTENDED else germ.p)


def _contact_candidates(germ: GenericGerm, g: Group, bound: int) -> list[Coefficients] | None:
    """Where M^lθ ⊂ T K_e f_a may fail; None if it fails for a indeterminate."""
    contact = Group(g.name, g.source, "contact", g.fields)
    forms = []
    for order in (bound - 1, bound):
        if order >= 0:
            spanning = vectors(germ, contact, Version.EXTENDED, order)
            entries = diagonal_form(rows_over_polynomials(germ, spanning, order))
            forms.append((_codimension(germ, Version.EXTENDED, order, len(entries)), entries))
    if len(forms) == 2 and forms[0][0] != forms[1][0]:
        return None
    return _factors(forms[-1][1])


def _factors(entries: Iterable[Any]) -> list[Coefficients]:
    """The irreducible factors of the entries, each once."""
    found: dict[Coefficients, None] = {}
    for entry in entries:
        if entry.degree() > 0:
            for q, _ in entry.numer().factor()[1]:
                found[tuple(int(c) for c in q.coeffs())] = None
    return list(found)


def _exceptional(
    family: Family,
    g: Group,
    extended: bool,
    q: Coefficients,
    order: int,
    curves: bool,
    patience: Patience | None,
) -> ExceptionalValue:
    found = codimension_at_root(GenericGerm(family), g, extended, q, order)
    root, parameter = rational_root(q), family.parameters[0]
    value: int | Literal["infinite"] | None = found.at_least if found.settled else None
    if value is None and root is not None:
        member = family.at(**{parameter: root})
        geometry = Geometry(member, g)
        seconds = SECONDS if patience is None else max(min(SECONDS, patience.left()), 0.0)
        if curves and geometry.result(seconds) is not None:
            value = "infinite"
        geometry.stop()
    return ExceptionalValue(polynomial_text(q, parameter), root, real_roots(q), value, found.at_least)


def _sorted(values: Iterable[ExceptionalValue]) -> tuple[ExceptionalValue, ...]:
    def key(e: ExceptionalValue) -> tuple[bool, Fraction, str]:
        return e.value is None, -(e.value or Fraction(0)), e.polynomial

    return tuple(sorted(values, key=key))


def _pairing(functional: dict[int, Fraction], row: dict[int, int]) -> Fraction:
    return sum((value * row[c] for c, value in functional.items() if c in row), Fraction(0))


def _polynomial(c: Any) -> Any:
    return c if isinstance(c, fmpq_poly) else fmpq_poly([c])


def _shown(values: Iterable[Fraction]) -> str:
    return ", ".join(f"a = {v}" for v in values)
