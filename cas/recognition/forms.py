"""Normal forms of the lists with their integers fixed: monomials with numbers, open signs and open moduli."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from osculant.cas.errors import DomainError
from osculant.cas.germs import groups
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.entry import Entry, instance
from osculant.cas.germs.even import BOUNDARY
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group

#: exponents of the variables
Exponents = tuple[int, ...]
#: a monomial of a component: the coordinates of jets of maps
Column = tuple[Exponents, int]

#: degree of a normal form at most
DEGREE = 63


@dataclass(frozen=True)
class Term:
    """A monomial of a normal form.

    Attributes:
        monomial: its exponents, one for each variable.
        component: the place of its component.
        coefficient: the number that stands there; its sign and its modulus are left out.
        sign: the index of the ± that governs it, in the order of the text; None for none.
        modulus: the name of the modulus that multiplies it; None for none.
    """

    monomial: Exponents
    component: int
    coefficient: Fraction
    sign: int | None = None
    modulus: str | None = None

    @property
    def column(self) -> Column:
        """The monomial with its component."""
        return self.monomial, self.component


@dataclass(frozen=True, eq=False)
class Form:
    """A row of a list with its integers fixed; its signs and its moduli are open.

    Attributes:
        entry: the row.
        integers: the integers of the row, by name, in the order of the row.
        group: the group of the list.
        variables: the names of the source variables, the u of an even germ in place of its λ.
        p: the number of components.
        boundary: the place of u with H = {u = 0}; None for groups without H.
        terms: the monomials, in the order of the components.
        order: the degree of determinacy of the row.
        signs: how many ± there are, those of squares that were added included.

    Two forms are equal if they are the same row for one group, with the same integers, variables and number
    of components.

    >>> from osculant.cas.germs.reference import reference
    >>> found = form(reference("rieger")["4_k"], k=2)
    >>> [(t.monomial, t.component, t.sign) for t in found.terms], found.order
    ([((1, 0), 0, None), ((0, 3), 1, None), ((2, 1), 1, 0)], 3)
    """

    entry: Entry
    integers: tuple[tuple[str, int], ...]
    group: Group
    variables: tuple[str, ...]
    p: int
    boundary: int | None
    terms: tuple[Term, ...]
    order: int
    signs: int

    @property
    def n(self) -> int:
        """The number of source variables."""
        return len(self.variables)

    @property
    def moduli(self) -> tuple[str, ...]:
        """The names of the moduli."""
        return tuple(p.name for p in self.entry.moduli)

    @cached_property
    def core(self) -> tuple[Term, ...]:
        """The terms of degree at most the order: determinacy removes the others, such as y³ of S₀."""
        return tuple(term for term in self.terms if sum(term.monomial) <= self.order)

    @cached_property
    def columns(self) -> dict[Column, Term]:
        """The terms of the core by their monomial and component."""
        return {term.column: term for term in self.core}

    def _key(self) -> tuple[object, ...]:
        return (
            self.entry.list,
            self.entry.id,
            self.entry.text,
            self.integers,
            self.variables,
            self.p,
            self.terms,
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Form) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def __str__(self) -> str:
        shown = ", ".join(f"{name} = {value}" for name, value in self.integers)
        return f"{self.entry.id} of {self.entry.list}" + (f" with {shown}" if shown else "")


def form(entry: Entry, **integers: int) -> Form:
    """The normal form of a row for these integers.

    Raises DomainError for integers that are missing, unknown or out of range, and for a text whose terms
    are not monomials with a number, at most one sign and at most one modulus.

    >>> from osculant.cas.germs.reference import reference
    >>> found = form(reference("mond")["P_3"])
    >>> [(t.monomial, t.modulus) for t in found.terms if t.component == 2], found.moduli
    ([((1, 2), None), ((0, 4), 'c')], ('c',))
    """
    order = entry.value("determinacy", **integers, **entry.usual)
    names = tuple(BOUNDARY if name == entry.even else name for name in entry.variables)
    boundary = BOUNDARY if entry.even else entry.boundary
    found = _terms(entry, integers)
    return Form(
        entry=entry,
        integers=tuple((p.name, int(integers[p.name])) for p in entry.integers),
        group=groups.group(entry.group),
        variables=names,
        p=len(entry.text.split(",")),
        boundary=None if boundary is None else names.index(boundary),
        terms=found,
        order=order,
        signs=entry.text.count("±"),
    )


def stabilised(found: Form, n: int) -> Form:
    """The form of a function in n variables: squares ±z² are added, or those of the last variables dropped.

    Every square that is added has a sign of its own, after those of the text. Raises DomainError for a form
    with several components, and for one whose last variables have more than a square.

    >>> from osculant.cas.germs.reference import reference
    >>> cusp = form(reference("simple functions")["A_k"], k=2)
    >>> [t.monomial for t in stabilised(cusp, 3).terms], [t.monomial for t in stabilised(cusp, 1).terms]
    ([(0, 2, 0), (3, 0, 0), (0, 0, 2)], [(3,)])
    """
    if found.p != 1:
        raise DomainError(f"{found} has {found.p} components: only functions are stabilised by squares.")
    if n < found.n:
        last = found.n - 1
        square = tuple(2 * int(i == last) for i in range(found.n))
        kept = [term for term in found.terms if not term.monomial[last]]
        superfluous = (square, 0) in found.columns and len(found.terms) == len(kept) + 1
        if found.boundary == last or not kept or not superfluous:
            raise DomainError(f"{found} has no superfluous square: it needs {found.n} variables.")
        terms = tuple(replace(term, monomial=term.monomial[:last]) for term in kept)
        signs = max([found.entry.text.count("±"), *(t.sign + 1 for t in terms if t.sign is not None)])
        return stabilised(replace(found, variables=found.variables[:last], terms=terms, signs=signs), n)
    more, total = n - found.n, found.signs
    padded = [replace(term, monomial=(*term.monomial, *(0,) * more)) for term in found.terms]
    for i in range(found.n, n):
        square = tuple(2 * int(j == i) for j in range(n))
        padded.append(Term(square, 0, Fraction(1), total))
        total += 1
    names = [*found.variables]
    while len(names) < n:
        names.append(next(z for i in range(1, n + 1) if (z := f"z{i}") not in names))
    return replace(found, variables=tuple(names), terms=tuple(padded), signs=total)


def widened(found: Form, p: int) -> Form:
    """The form with components 0 added, up to p of them: immersions into higher dimensions.

    Raises DomainError for a form that has a component which is not linear or 0, and for a smaller p.

    >>> from osculant.cas.germs.reference import reference
    >>> widened(form(reference("table 6.2")["7a"]), 9).p
    9
    """
    if p < found.p or any(sum(term.monomial) > 1 for term in found.core):
        raise DomainError(f"{found} is no immersion into {p} dimensions: it has {found.p} components.")
    return replace(found, p=p)


def _terms(entry: Entry, integers: Mapping[str, int]) -> tuple[Term, ...]:
    """The terms of the text: its signs and moduli are read as variables."""
    moduli = [p.name for p in entry.moduli]
    count = entry.text.count("±")
    signs = [f"sign_{i}" for i in range(count)]
    parts = entry.text.split("±")
    text = parts[0] + "".join(f"+{sign}*{part.lstrip()}" for sign, part in zip(signs, parts[1:]))
    texts = {p.name: f"({integers[p.name]})" for p in entry.integers}
    n, names = len(entry.variables), (*entry.variables, *signs, *moduli)
    germ = Germ(instance(text, None, texts), names, names[0])
    jet = germ.polynomial(DEGREE)
    if jet is None:
        raise DomainError(f"{entry.id} of {entry.list} is no polynomial of degree at most {DEGREE}.")
    even = None if entry.even is None else entry.variables.index(entry.even)
    found = []
    for j, f in enumerate(jet):
        for m in sorted(f, key=lambda m: (poly.degree_of(m, len(names)), -m)):
            exponents = poly.exponents_of(m, len(names))
            own, over = list(exponents[:n]), exponents[n:]
            sign = [i for i, e in enumerate(over[:count]) if e]
            modulus = [name for name, e in zip(moduli, over[count:]) if e]
            if max(over, default=0) > 1 or len(sign) > 1 or len(modulus) > 1:
                raise DomainError(
                    f"{entry.id} of {entry.list} has a term that is no monomial with a number, a sign and a "
                    "modulus."
                )
            if even is not None:
                own[even] //= 2
            found.append(
                Term(
                    tuple(own),
                    j,
                    Fraction(f[m]),
                    sign[0] if sign else None,
                    modulus[0] if modulus else None,
                )
            )
    return tuple(found)
