"""The formats that splines are written in: a record each, and the one table that knows them all."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import OsculantError
from osculant.files.writing import listed, not_installed
from osculant.pieces.kinds import KINDS

if TYPE_CHECKING:
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain


@dataclass(frozen=True, kw_only=True)
class Writer:
    """A format that splines are written in.

    Attributes:
        name: of the format.
        suffixes: of its files, in small letters with their point.
        function: "module:function" of what makes a file's text of a `Chain`, its `Facts` and a budget, which
            is how far what is written may be from the chain, and of ``options`` by keyword.
        dimensions: of the splines it takes, 2, 3 or both.
        exact: the kinds of arcs (`KINDS`) that it holds as they are, up to the rounding of numbers.
        replaced: the kinds that other curves stand for, within the budget or a tolerance of the function's.
        options: what the function can be told besides.
        rounds: whether it rounds numbers and so needs a budget.
        extra: the package that it needs and the extra of osculant that brings it, or None.
    """

    name: str
    suffixes: tuple[str, ...]
    function: str
    dimensions: tuple[int, ...]
    exact: tuple[str, ...]
    replaced: tuple[str, ...] = ()
    options: tuple[str, ...] = ()
    rounds: bool = False
    extra: tuple[str, str] | None = None

    def takes(self, option: str) -> bool:
        """Whether `Spline.write` can tell it that: one of ``options``, or "reserve" if it rounds.

        >>> writer_of("a.svg").takes("reserve"), writer_of("a.svg").takes("units")
        (True, False)
        """
        return option in self.options or (option == "reserve" and self.rounds)

    def holds(self, kinds: Iterable[str]) -> bool:
        """Whether it can write arcs of these kinds, exactly or otherwise.

        >>> writer_of("a.dxf").holds(["segment", "helix"]), writer_of("a.dxf").holds(["parabola"])
        (True, False)
        """
        return set(kinds) <= {*self.exact, *self.replaced}

    def check_installed(self) -> None:
        """Raises OsculantError if the package that it needs is missing."""
        if self.extra is not None and find_spec(self.extra[0]) is None:
            raise not_installed(self.name, *self.extra)

    def text(self, chain: Chain, facts: Facts, budget: float, **options: Any) -> str:
        """What a file of it says.

        Args:
            chain: the pieces of a spline.
            facts: about it.
            budget: how far what is written may be from the chain.
            options: those of ``options`` that are not the usual.

        Raises what the format's own function does.
        """
        module, _, function = self.function.partition(":")
        made: str = getattr(import_module(module), function)(chain, facts, budget, **options)
        return made


def register(*writers: Writer) -> tuple[Writer, ...]:
    """The writers; raises ValueError if two have a suffix or a name in common.

    >>> register(WRITERS[0], WRITERS[0])
    Traceback (most recent call last):
    ...
    ValueError: Two writers are called '.svg'.
    """
    seen: set[str] = set()
    for writer in writers:
        for word in (*writer.suffixes, writer.name):
            if word in seen:
                raise ValueError(f"Two writers are called {word!r}.")
            seen.add(word)
    return writers


#: the formats, in the order in which they are listed
WRITERS = register(
    Writer(
        name="SVG",
        suffixes=(".svg",),
        function="osculant.files.svg:svg",
        dimensions=(2,),
        exact=("segment", "arc", "parabola", "ellipse", "cubic"),
        replaced=("hyperbola",),  # by cubics
        options=("knots",),
        rounds=True,
    ),
    Writer(
        name="JSON",
        suffixes=(".json",),
        function="osculant.files.json:json",
        dimensions=(2, 3),
        exact=tuple(KINDS),
    ),
    Writer(
        name="G-code",
        suffixes=(".nc", ".gcode", ".ngc"),
        function="osculant.files.gcode:gcode",
        dimensions=(2, 3),
        exact=("segment", "arc"),
        replaced=("helix",),  # by chords, unless its axis is one of the coordinates'
        options=("decimals", "straight_radius", "chord_tolerance", "units", "feed"),
        rounds=True,
    ),
    Writer(
        name="DXF",
        suffixes=(".dxf",),
        function="osculant.files.dxf:dxf",
        dimensions=(2, 3),
        exact=("segment", "arc"),
        replaced=("helix",),  # by chords
        options=("entities", "chord_tolerance", "units"),
        extra=("ezdxf", "cad"),
    ),
)


def writers(dimension: int | None = None, option: str | None = None) -> list[Writer]:
    """All formats, or those for splines of a dimension, or those that take an option of `Spline.write`.

    >>> [writer.name for writer in writers(3)], [writer.name for writer in writers(option="reserve")]
    (['JSON', 'G-code', 'DXF'], ['SVG', 'G-code'])
    """
    chosen = (writer for writer in WRITERS if dimension in (None, *writer.dimensions))
    return [writer for writer in chosen if option is None or writer.takes(option)]


def suffixes(dimension: int | None = None, option: str | None = None) -> list[str]:
    """The suffixes of `writers`.

    >>> suffixes(), suffixes(option="units")
    (['.svg', '.json', '.nc', '.gcode', '.ngc', '.dxf'], ['.nc', '.gcode', '.ngc', '.dxf'])
    """
    return [suffix for writer in writers(dimension, option) for suffix in writer.suffixes]


def writer_of(path: str | os.PathLike[str], dimension: int | None = None) -> Writer:
    """The writer for a file, by its suffix.

    Args:
        path: the file.
        dimension: of the spline, if it is known.

    Raises:
        OsculantError: a suffix that no format has, or none for splines of that dimension.

    >>> writer_of("spiral.GCODE").name
    'G-code'
    >>> writer_of("spiral.png")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.OsculantError: Cannot write spiral.png: the known suffixes are .svg, .json, .nc,
    .gcode, .ngc and .dxf; plot() makes pictures of other kinds.
    """
    suffix = Path(path).suffix.lower()
    for writer in writers(dimension):
        if suffix in writer.suffixes:
            return writer
    known = "a spline in space is written as" if dimension == 3 else "the known suffixes are"
    raise OsculantError(
        f"Cannot write {os.fspath(path) or 'a file without a name'}: {known} "
        f"{listed(suffixes(dimension))}; plot() makes pictures of other kinds.",
        argument="plot()",
    )
