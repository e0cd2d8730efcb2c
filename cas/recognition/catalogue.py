"""Which lists name germs of given dimensions for a group, and their rows with an orbit of a given size.

Functions are named by lists for functions of fewer variables, with squares added, and of more, without the
squares that are superfluous there. The lists of functions for R serve K, that of functions on a manifold with
boundary serves R(H) and K(H).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.entry import Entry
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group, group
from osculant.cas.germs.reference import reference
from osculant.cas.recognition.forms import DEGREE, Form, form, stabilised

#: lists of functions by group, and which value of a row is dim θ/T G_e f
FUNCTIONS = {
    "R": (("simple functions", "unimodal functions"), "cod_e"),
    "K": (("simple functions",), "tjurina"),
    "R(H)": (("boundary functions",), "cod_e"),
    "K(H)": (("boundary functions",), "tjurina"),
}
#: lists of maps by group; the first that has a class names it
MAPS = {
    "A": (
        "plane curves",
        "space curves",
        "rieger",
        "mond",
        "klotz pop rieger",
        "goryunov",
        "marar tari",
        "houston kirk",
        "cooper mond wik atique",
        "table 6.1",
    ),
    "K": ("simple icis",),
    "A(H)": ("table 6.2",),
}
#: rows of one entry that are looked through at most
MOST = 400
#: rows by list, group, number of components, size and number of variables
_LISTED: dict[tuple[str, str, int, int, int], tuple[Form, ...]] = {}
#: forms made, by row, group, integers and number of variables
_FORMS: dict[tuple[str, str, str, tuple[tuple[str, int], ...], int], Form | None] = {}


@dataclass(frozen=True)
class Listing:
    """A list as it serves a group: rows, with the value that is the size of their orbits in a key.

    >>> [found.name for found in catalogue("A", 2, 3)], [found.name for found in catalogue("R", 5, 1)]
    (['mond'], ['simple functions', 'unimodal functions'])
    """

    name: str
    entries: tuple[Entry, ...]
    size: str

    def forms(self, size: int, n: int) -> tuple[Form, ...]:
        """The rows, with their integers fixed, whose orbits have that size, for germs of n variables.

        Raises UndecidedError if one has a degree that is out of reach.

        >>> (listing,) = catalogue("A", 2, 3)
        >>> [str(found) for found in listing.forms(4, 2)]
        ['S_k of mond with k = 2', 'B_k of mond with k = 2', 'H_k of mond with k = 2']
        """
        known = self.name, self.entries[0].group, _target(self.entries[0]), size, n
        if known not in _LISTED:
            _LISTED[known] = tuple(
                found
                for entry in self.entries
                for integers in _integers(entry, self.size, size)
                if (found := _form(entry, integers, n)) is not None
            )
        return _LISTED[known]

    @property
    def finite(self) -> bool:
        """Whether no row has integers or moduli."""
        return not any(entry.parameters for entry in self.entries)


def catalogue(name: str | Group, n: int, p: int) -> tuple[Listing, ...]:
    """The lists that name germs of n variables with p components for a group, in order.

    >>> catalogue("A", 7, 2)
    ()
    """
    return _catalogue(group(name).name, n, p)


@lru_cache(maxsize=256)
def _catalogue(name: str, n: int, p: int) -> tuple[Listing, ...]:
    names, size = FUNCTIONS.get(name, ((), "")) if p == 1 else (MAPS.get(name, ()), "cod")
    if p == 1 and name == "A":
        names, size = ("cooper mond wik atique",), "cod"
    found: list[Listing] = []
    for title in names:
        entries = tuple(
            entry
            for row in reference(title).entries
            for entry in _served(row, name)
            if (name in FUNCTIONS and p == 1) or (len(entry.variables), _target(entry)) == (n, p)
        )
        if entries and not (found and title in {"cooper mond wik atique", "table 6.1"}):  # the same classes
            found.append(Listing(title, entries, size))
    return tuple(found)


def listed(title: str) -> tuple[Entry, ...]:
    """The rows of a list by which germs are named.

    >>> [entry.name for entry in listed("table 6.1")][:2]
    ['6-1', '6-2']
    """
    return tuple(entry for row in reference(title).entries for entry in _served(row, _home(row)))


def _home(row: Entry) -> str:
    return "A" if row.projection is not None else row.group


def forms_up_to(entry: Entry, order: int, n: int) -> list[Form] | None:
    """The rows of an entry with all different jets of an order, in n variables; None if they are too many.

    >>> (listing,) = catalogue("A", 2, 3)
    >>> len(forms_up_to(listing.entries[0], 4, 2))
    7
    """
    whole = entry.integers
    if (order + 3) ** len(whole) > MOST:
        return None
    found = []
    for steps in product(range(order + 3), repeat=len(whole)):
        try:
            made = _form(entry, {p.name: int(p.least or 0) + step for p, step in zip(whole, steps)}, n)
        except DomainError:  # out of the range of the row
            continue
        if made is not None:
            found.append(made)
    return found


def _served(row: Entry, name: str) -> Iterator[Entry]:
    """The row as one for the group; of a secant germ its projection, to spaces for which there is no list."""
    if row.projection is not None:
        if name == "A" and row.projection.count(",") >= 4:
            values = {"cod": row.values["cod_projection"], "determinacy": str(_degree(row.projection))}
            yield replace(
                row,
                text=row.projection,
                group="A",
                variables=("x", "y"),
                values=values,
                boundary=None,
                even=None,
                projection=None,
            )
    elif name in FUNCTIONS and row.values.get("tjurina") is not None:
        yield replace(row, group=name)
    elif row.group == name:
        yield row


def _degree(text: str) -> int:
    """The degree of the projections: they are determined by it (a test proves that)."""
    jet = Germ(text, "x y").polynomial(20)
    assert jet is not None
    return max(poly.degree_of(m, 2) for f in jet for m in f)


def _target(entry: Entry) -> int:
    return entry.text.count(",") + 1


def _form(entry: Entry, integers: Mapping[str, int], n: int) -> Form | None:
    """The form in n variables; None if it needs more. UndecidedError for one of a degree beyond reach."""
    known = entry.list, entry.id, entry.group, tuple(integers.items()), n
    if known not in _FORMS:
        if (degree := entry.value("determinacy", **integers, **entry.usual)) > DEGREE:
            raise UndecidedError(f"{entry.id} of {entry.list} of degree {degree} is out of reach.")
        try:
            found = form(entry, **integers)
        except DomainError as error:
            raise UndecidedError(str(error)) from None
        try:
            _FORMS[known] = found if found.n == n or found.p > 1 else stabilised(found, n)
        except DomainError:
            _FORMS[known] = None
    return _FORMS[known]


def _integers(entry: Entry, name: str, size: int) -> Iterator[dict[str, int]]:
    """The integers of a row for which that value of it is ``size``; the value grows by each integer."""
    whole = entry.integers
    least = {p.name: int(p.least or 0) for p in whole}
    for steps in _steps(entry, name, size):
        integers = {key: start + step for (key, start), step in zip(least.items(), steps)}
        try:
            if entry.value(name, **integers, **entry.usual) == size:
                yield integers
        except DomainError:  # out of the range of the row
            continue


def _steps(entry: Entry, name: str, size: int) -> Iterator[tuple[int, ...]]:
    """How far the integers may be above the least: the values of rows are linear in them."""
    whole = entry.integers
    loose = replace(entry, where=())
    least = {p.name: int(p.least or 0) for p in whole}
    start = loose.value(name, **least, **entry.usual)
    slopes = [loose.value(name, **{**least, p.name: least[p.name] + 1}, **entry.usual) - start for p in whole]
    if start > size:
        return
    if any(slope < 1 for slope in slopes):
        raise DomainError(f"The {name} of {entry.id} of {entry.list} does not grow by its integers.")
    for steps in product(*(range((size - start) // slope + 1) for slope in slopes)):
        if start + sum(slope * step for slope, step in zip(slopes, steps)) == size:
            yield steps
