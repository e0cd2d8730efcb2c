"""The formats that splines are written in: a record each, and the one table that knows them all."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from osculant.cas.errors import DomainError, OsculantError
from osculant.files.writing import STDOUT, listed, not_installed, stands_for_stdout
from osculant.pieces.kinds import KINDS

if TYPE_CHECKING:
    from osculant.files.drafts import Draft
    from osculant.files.facts import Facts
    from osculant.pieces.chain import Chain


@dataclass(frozen=True, kw_only=True)
class Writer:
    """A format that splines are written in.

    Attributes:
        name: of the format.
        suffixes: of its files, in small letters with their point.
        function: "module:function" of what makes a `Draft` of a `Chain`, its `Facts` and a room, which is how
            far what is written may be from the chain, and of ``options`` by keyword.
        dimensions: of the splines it takes, 2, 3 or both.
        exact: the kinds of arcs (`KINDS`) that it holds as they are, up to the rounding of numbers.
        replaced: the kinds that other curves stand for, within the room.
        options: what the function can be told besides.
        needs: "module:function" of what it needs of a tolerance, by the kinds of arcs and the options: sums
            that are worth a trial, the first of them enough where nothing is replaced; None needs nothing.
        extra: the package that it needs and the extra of osculant that brings it, or None.
    """

    name: str
    suffixes: tuple[str, ...]
    function: str
    dimensions: tuple[int, ...]
    exact: tuple[str, ...]
    replaced: tuple[str, ...] = ()
    options: tuple[str, ...] = ()
    needs: str | None = None
    extra: tuple[str, str] | None = None

    def holds(self, kinds: Iterable[str]) -> bool:
        """Whether it can write arcs of these kinds, exactly or otherwise.

        >>> writer_of("a.nc").holds(["segment", "helix"]), writer_of("a.nc").holds(["parabola"])
        (True, False)
        """
        return set(kinds) <= {*self.exact, *self.replaced}

    def check(
        self, kinds: Collection[str], tolerance: float, options: Mapping[str, Any]
    ) -> tuple[float, ...]:
        """What of a tolerance to keep for a file, or several sums to try; all that can be refused is now.

        Args:
            kinds: of the arcs that will be written.
            tolerance: as a length.
            options: for the writer's function.

        Raises:
            DomainError: an option that it has not, or of no meaning.
            ToleranceError: options that the tolerance does not allow.
            OsculantError: a package that is missing.
        """
        self.check_options(options)
        self.check_installed()
        if self.needs is None:
            return (0.0,)
        found: tuple[float, ...] = _loaded(self.needs)(tolerance, kinds, **options)
        return found

    def check_options(self, options: Iterable[str]) -> None:
        """Raises DomainError for an option that it has not."""
        for option in options:
            if option not in self.options:
                able = [writer.name for writer in WRITERS if option in writer.options]
                has = f"it is one of {listed(able)}" if able else f"it has {listed(self.options) or 'none'}"
                raise DomainError(f"{self.name} has no option {option!r}: {has}.", argument=option)

    def check_installed(self) -> None:
        """Raises OsculantError if the package that it needs is missing."""
        if self.extra is not None and find_spec(self.extra[0]) is None:
            raise not_installed(self.name, *self.extra)

    def draft(self, chain: Chain, facts: Facts, room: float, options: Mapping[str, Any]) -> Draft:
        """A file before it is written.

        Args:
            chain: the pieces of a spline.
            facts: about it.
            room: how far what is written may be from the chain if the tolerance is to be kept.
            options: those of ``options`` that are not the usual.

        Raises what the format's own function does.
        """
        self.check_options(options)
        made: Draft = _loaded(self.function)(chain, facts, room, **options)
        return made


def _loaded(name: str) -> Any:
    """What "module:function" names."""
    module, _, function = name.partition(":")
    return getattr(import_module(module), function)


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
        needs="osculant.files.svg:needs",
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
        options=(
            "decimals",
            "units",
            "feed",
            "dialect",
            "largest_angle",
            "smallest_radius",
            "largest_radius",
        ),
        needs="osculant.files.decimals:needs",
    ),
    Writer(
        name="DXF",
        suffixes=(".dxf",),
        function="osculant.files.dxf:dxf",
        dimensions=(2, 3),
        exact=("segment", "arc", "parabola", "ellipse", "hyperbola", "cubic"),
        replaced=("helix",),  # by chords
        options=("entities", "units"),
        needs="osculant.files.dxf:needs",
        extra=("ezdxf", "cad"),
    ),
)


def writers(dimension: int | None = None, option: str | None = None) -> list[Writer]:
    """All formats, or those for splines of a dimension, or those that take an option of `Spline.write`.

    >>> [writer.name for writer in writers(3)], [writer.name for writer in writers(option="units")]
    (['JSON', 'G-code', 'DXF'], ['G-code', 'DXF'])
    """
    chosen = (writer for writer in WRITERS if dimension in (None, *writer.dimensions))
    return [writer for writer in chosen if option is None or option in writer.options]


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
    if os.fspath(path) == STDOUT:
        raise OsculantError(
            f"Cannot write {STDOUT}: name the format of standard output too, such as "
            f"{STDOUT}{WRITERS[0].suffixes[0]}."
        )
    if stands_for_stdout(path):
        suffix = os.fspath(path)[len(STDOUT) :].lower()
    for writer in writers(dimension):
        if suffix in writer.suffixes:
            return writer
    known = "a spline in space is written as" if dimension == 3 else "the known suffixes are"
    raise OsculantError(
        f"Cannot write {os.fspath(path) or 'a file without a name'}: {known} "
        f"{listed(suffixes(dimension))}; plot() makes pictures of other kinds.",
        argument="plot()",
    )
