"""Reference lists of germs with their codimensions, from the literature and from the thesis as corrected.

The lists are data files beside this module, one a list, each with its source. The text of an entry is a
formula in which ``±`` stands for a sign (each for its own) and k, l, m, alpha, … for parameters; the values
of an entry, such as its codimension, are formulas in the integer parameters.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from importlib import resources
from itertools import product
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ

#: the reference lists, in the order in which they are shown
NAMES = (
    "thom",
    "simple functions",
    "boundary functions",
    "plane curves",
    "rieger",
    "mond",
    "klotz pop rieger",
    "table 6.1",
    "table 6.2",
)
#: the boundary variable u = λ² of germs that are even in λ
BOUNDARY = "u"
#: degree of the polynomials in a list of even germs at most
DEGREE = 30

Value = int | str | Fraction
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


@dataclass(frozen=True)
class Parameter:
    """A parameter of a family: an integer with a ``least`` value, or a modulus (a rational number).

    ``tried`` are values that stand for all in tests, ``excluded`` the values where the family degenerates.
    """

    name: str
    least: int | None
    tried: tuple[Value, ...]
    excluded: tuple[Fraction, ...] = ()

    def text(self, value: Value, family: str) -> str:
        """A value as a formula; raises DomainError for one that the parameter of that family cannot have."""
        try:
            number = Fraction(value)
        except ValueError:
            raise DomainError(f"{self.name} = {value!r} in {family} is not a rational number.") from None
        if self.least is not None and (number.denominator > 1 or number < self.least):
            raise DomainError(
                f"{self.name} = {value} is out of the range of {family}: choose an integer from {self.least} "
                "on."
            )
        if number in self.excluded:
            raise DomainError(f"{family} degenerates at {self.name} = {value}: choose another value.")
        return f"({number})"


@dataclass(frozen=True)
class Entry:
    """A germ or a family of germs in a reference list.

    Args:
        list: the name of its list.
        id: its name there.
        text: its formula, with ``±`` for signs and with the names of parameters.
        group: the group of equivalences of the list.
        variables: the source variables of the formula.
        parameters: integers and moduli.
        values: what is known about it, by name ("cod", "cod_e", "determinacy", …): formulas in the integers.
        boundary: the variable u with H = {u = 0}, if the group wants one.
        even: the variable λ in which the formula is even, if the germ is S(…, λ) = f(…, λ²).
        projection: for secant germs, the projection along the x-axis that belongs to them.
        printed: the formula in the thesis where it prints another.
        note: a remark.
    """

    list: str
    id: str
    text: str
    group: str
    variables: tuple[str, ...]
    parameters: tuple[Parameter, ...]
    values: Mapping[str, str]
    boundary: str | None = None
    even: str | None = None
    projection: str | None = None
    printed: str | None = None
    note: str = ""

    @property
    def signs(self) -> tuple[tuple[int, ...], ...]:
        """Every choice of the signs; one empty choice if there are none."""
        return tuple(product((1, -1), repeat=self.text.count("±")))

    def formula(self, signs: Sequence[int] | None = None, **parameters: Value) -> str:
        """The formula with these signs (all + by default) and values of the parameters.

        Raises DomainError for a wrong number of signs, for parameters that are missing or unknown, and for
        values out of range.

        >>> reference("mond")["S_k"].formula((-1,), k=1)
        'x, y**2, y**3 - x**((1) + 1)*y'
        """
        return instance(self.text, signs, self._texts(parameters))

    def germ(self, signs: Sequence[int] | None = None, **parameters: Value) -> Germ:
        """The germ that the group acts on; for an even formula S that is f with S(…, λ) = f(…, λ²).

        Raises DomainError as `formula` does.

        >>> str(reference("rieger")["4_k"].germ(k=2))
        '(x, y**3 + x**2*y)'
        """
        germ = Germ(self.formula(signs, **parameters), self.variables, self.boundary)
        return germ if self.even is None else halved(germ, self.even)

    def projected(self, signs: Sequence[int] | None = None, **parameters: Value) -> Germ:
        """The projection that belongs to a secant germ; raises DomainError if the list has none.

        >>> str(reference("table 6.1")["3-6"].projected())
        '(y, x**3 + x*y**3)'
        """
        if self.projection is None:
            raise DomainError(f"{self.list} has no projections: they belong to secant germs (table 6.1).")
        count = self.projection.count("±")
        chosen = None if signs is None else tuple(signs)[:count]
        return Germ(instance(self.projection, chosen, self._texts(parameters)), "x y")

    def projected_secant(self, signs: Sequence[int] | None = None, **parameters: Value) -> Germ:
        """The projection made from a secant germ S itself: (x, y) ↦ x·S(x, y, λ = x, v = y/x).

        Raises DomainError if the list has no secant germs.

        >>> reference("table 6.1")["3-2"].projected_secant().text(3)
        ('y', 'x**3 + x*y')
        """
        secant = Germ(self.formula(signs, **parameters), self.variables)
        jet = secant.polynomial(DEGREE) if self.projection is not None else None
        if jet is None:
            raise DomainError(f"{self.id} of {self.list} is no secant germ: only table 6.1 has them.")
        components = []
        for f in jet:
            image: dict[int, poly.Number] = {}
            for m, c in f.items():
                powers = dict(zip(self.variables, poly.exponents_of(m, secant.n)))
                along = 1 + powers["x"] + powers["lambda"] - powers["v"]
                if along < 0:
                    raise DomainError(f"{secant} is no secant germ: it has v alone to a power above 1.")
                moved = poly.monomial((along, powers["y"] + powers["v"]))
                image[moved] = image.get(moved, 0) + c
            components.append(as_node({m: c for m, c in image.items() if c}, ("x", "y")))
        return Germ(components, "x y")

    def value(self, name: str, **parameters: Value) -> int:
        """A value of the entry for these parameters; raises DomainError for one that is not in the list.

        >>> reference("mond")["H_k"].value("cod", k=3)
        5
        """
        if name not in self.values:
            raise DomainError(f"{self.list} has no {name!r} of {self.id}: it has {', '.join(self.values)}.")
        found = Fraction(parse_constant(instance(self.values[name], None, self._texts(parameters))).value)
        if found.denominator > 1:
            raise DomainError(f"The {name} of {self.id} is {found}, not an integer: correct {self.list}.")
        return int(found)

    def tried(self) -> Iterator[tuple[tuple[int, ...], dict[str, Value]]]:
        """(signs, parameters) that stand for the whole family: every choice of signs, small parameters."""
        names = [p.name for p in self.parameters]
        for values in product(*(p.tried for p in self.parameters)):
            for signs in self.signs:
                yield signs, dict(zip(names, values))

    def _texts(self, parameters: Mapping[str, Value]) -> dict[str, str]:
        names = [p.name for p in self.parameters]
        if sorted(parameters) != sorted(names):
            wanted = ", ".join(names) if names else "no parameters"
            given = ", ".join(parameters) if parameters else "none"
            raise DomainError(f"{self.id} of {self.list} takes {wanted}; given: {given}.")
        return {p.name: p.text(parameters[p.name], self.id) for p in self.parameters}


@dataclass(frozen=True)
class Reference:
    """A reference list: its name, title and source (author, title, journal, year), and its entries.

    Raises DomainError for a list without a source, and for two entries of one id.

    >>> rieger = reference("rieger")
    >>> rieger.source[:14], rieger["5"].text
    ('J. H. Rieger, ', 'x, x*y + y**4')
    """

    name: str
    title: str
    source: str
    entries: tuple[Entry, ...]

    def __post_init__(self) -> None:
        if not self.source.strip():
            raise DomainError(f"The reference list {self.name!r} has no source: name one.")
        for i, entry in enumerate(self.entries):
            if any(entry.id == other.id for other in self.entries[:i]):
                raise DomainError(f"{self.name} has two entries {entry.id!r}: rename one.")

    def __getitem__(self, identifier: str) -> Entry:
        for entry in self.entries:
            if entry.id == identifier:
                return entry
        known = ", ".join(entry.id for entry in self.entries)
        raise DomainError(f"{self.name} has no entry {identifier!r}: it has {known}.")


def reference(name: str) -> Reference:
    """The reference list of that name, capitals aside.

    Raises DomainError for a name that is not one of `NAMES`.

    >>> len(reference("Table 6.2").entries)
    23
    """
    plain = " ".join(name.replace("_", " ").replace("-", " ").split()).lower()
    if plain not in NAMES:
        raise DomainError(f"There is no reference list {name!r}: choose one of {', '.join(NAMES)}.")
    return _read(plain)


def entries() -> tuple[Entry, ...]:
    """The entries of all lists."""
    return tuple(entry for name in NAMES for entry in reference(name).entries)


def instance(text: str, signs: Sequence[int] | None, parameters: Mapping[str, str]) -> str:
    """A formula with signs in place of ± and texts in place of the names of parameters.

    Whole names are replaced, so a parameter k leaves a variable k1 alone. All signs are + by default. Raises
    DomainError if the number of signs is not that of ±, or one is not 1 or −1.

    >>> instance("x ± y**k", (-1,), {"k": "(3)"})
    'x - y**(3)'
    """
    parts = text.split("±")
    chosen = (1,) * (len(parts) - 1) if signs is None else tuple(signs)
    if len(chosen) != len(parts) - 1 or not set(chosen) <= {1, -1}:
        raise DomainError(f"{text!r} takes {len(parts) - 1} signs, each 1 or -1; given: {chosen}.")
    whole = parts[0] + "".join(("+" if s > 0 else "-") + part for s, part in zip(chosen, parts[1:]))
    return _NAME.sub(lambda name: parameters.get(name[0], name[0]), whole)


def halved(germ: Germ, even: str) -> Germ:
    """The germ f with f(…, λ²) = S(…, λ), in the boundary variable u = λ².

    Raises DomainError if S is no polynomial, or not even in λ.

    >>> str(halved(Germ("v, l**2 + v*x", "x l v"), "l"))
    '(v, u + x*v)'
    """
    jet, place = germ.polynomial(DEGREE), germ.source.index(even)
    if jet is None:
        raise DomainError(f"{germ} is not a polynomial of degree at most {DEGREE}.")
    source = tuple(BOUNDARY if name == even else name for name in germ.source)
    components = []
    for f in jet:
        folded = {}
        for m, c in f.items():
            exponents = list(poly.exponents_of(m, germ.n))
            exponents[place], odd = divmod(exponents[place], 2)
            if odd:
                raise DomainError(f"{germ} is not even in {even}.")
            folded[poly.monomial(exponents)] = c
        components.append(as_node(folded, source))
    return Germ(components, source, BOUNDARY)


@lru_cache(maxsize=len(NAMES))
def _read(name: str) -> Reference:
    file = re.sub(r"[ .]", "_", name) + ".toml"
    data = tomllib.loads(resources.files(__package__).joinpath("data", file).read_text("utf-8"))
    found = tuple(_entry(name, data, row) for row in data["germ"])
    return Reference(name, data["title"], data["source"], found)


def _entry(name: str, data: Mapping[str, Any], row: Mapping[str, Any]) -> Entry:
    parameters = [_parameter(key, value) for key, value in row.get("integers", {}).items()]
    parameters += [_parameter(key, value) for key, value in row.get("moduli", {}).items()]
    return Entry(
        list=name,
        id=row["id"],
        text=row["text"],
        group=data["group"],
        variables=tuple(data["variables"].split()),
        parameters=tuple(parameters),
        values=dict(row["values"]),
        boundary=data.get("boundary"),
        even=data.get("even"),
        projection=row.get("projection"),
        printed=row.get("printed"),
        note=row.get("note", ""),
    )


def _parameter(name: str, data: Mapping[str, Any]) -> Parameter:
    least = data.get("least")
    return Parameter(name, least, tuple(data["tried"]), tuple(map(Fraction, data.get("excluded", ()))))
