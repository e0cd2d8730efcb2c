"""Reference lists of germs with their codimensions, from the literature and from the thesis as corrected.

The lists are data files beside this module, one a list, each with its source. The text of an entry is a
formula in which ``±`` stands for a sign (each for its own) and k, l, m, alpha, … for parameters; the values
of an entry, such as its codimension, are formulas in the integer parameters. Values that the source does not
print, or that were not seen in print, are marked as computed. Nothing in this room decides anything by these
lists: it is they that are computed again. `osculant.cas.recognition` names germs by them.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from importlib import resources
from typing import Any

from osculant.cas.errors import DomainError
from osculant.cas.germs.entry import Entry, Parameter

#: the reference lists, in the order in which they are shown
NAMES = (
    "thom",
    "simple functions",
    "unimodal functions",
    "boundary functions",
    "simple icis",
    "plane curves",
    "space curves",
    "rieger",
    "goryunov",
    "mond",
    "klotz pop rieger",
    "marar tari",
    "houston kirk",
    "cooper mond wik atique",
    "table 6.1",
    "table 6.2",
)


@dataclass(frozen=True)
class Reference:
    """A reference list: its name, title and source (author, title, journal, year), and its entries.

    Raises DomainError for a list without a source, and for two entries of one id or one name.

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
            if any(entry.name == other.name for other in self.entries[:i]):
                raise DomainError(f"{self.name} has two entries called {entry.name!r}: rename one.")

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
        variables=tuple(row.get("variables", data["variables"]).split()),
        parameters=tuple(parameters),
        values=dict(row["values"]),
        name=row.get("name", row["id"]),
        computed=tuple(row.get("computed", data.get("computed", "")).split()),
        where=tuple(row.get("where", ())),
        rows=tuple(map(tuple, row.get("tried", ()))),
        boundary=data.get("boundary"),
        even=data.get("even"),
        projection=row.get("projection"),
        printed=row.get("printed"),
        printed_values=dict(row.get("printed_values", {})),
        note=row.get("note", ""),
        complex=row.get("complex", ""),
    )


def _parameter(name: str, data: Mapping[str, Any]) -> Parameter:
    least = data.get("least")
    excluded = (tuple(map(Fraction, data.get(key, ()))) for key in ("excluded", "excluded_plus"))
    return Parameter(name, least, tuple(data["tried"]), *excluded)
