"""Options that several commands share, and what their values must be."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, get_args

import typer

from osculant.cas.errors import OsculantError
from osculant.cli.grammar import UsageError
from osculant.cli.output import printable
from osculant.files.registry import Writer, suffixes, writer_of
from osculant.files.writing import listed, not_installed
from osculant.pieces.kinds import KINDS, ConicKind
from osculant.primitives.table import METRICS, USUAL, may_become, usual_first

#: what the command line calls that which the library's sentences call otherwise
NAMES = {
    "low": "--from",
    "high": "--to",
    "t": "--at",
    "split_at": "--split-at",
    "plot()": "--plot",
    "osculant.cas.claims.all_claims()": "`osculant verify --list`",
}
#: units that can be written, and digits after the point that still mean something
UNITS, MOST_DECIMALS = ("mm", "inch"), 17

Formula = Annotated[
    str,
    typer.Argument(
        metavar="FORMULA", help='The coordinates, such as "t*cos(t), t*sin(t)", or three in space.'
    ),
]
Low = Annotated[str | None, typer.Option("--from", metavar="A", help="First end of the interval, a formula.")]
High = Annotated[str | None, typer.Option("--to", metavar="B", help="Last end of the interval, a formula.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON and nothing else.")]
Primitive = Annotated[
    str | None,
    typer.Option(
        "--with",
        metavar="|".join(dict.fromkeys([*usual_first(2), *usual_first(3), "best"])),
        help=f"The kind of pieces; in the plane {USUAL[2]} by default, in space {USUAL[3]}; best is the one "
        "with the fewest numbers to store.",
    ),
]
Metric = Annotated[
    str,
    typer.Option(
        "--metric",
        metavar="|".join(METRICS),
        help="What an error is: a distance, or the area between curve and spline.",
    ),
]
SplitAt = Annotated[
    list[str] | None,
    typer.Option("--split-at", metavar="T", help="A parameter that shall be a knot; repeatable."),
]


def both_ends(low: str | None, high: str | None) -> tuple[str, str]:
    """Return the ends of an interval; raise UsageError if one is missing."""
    if low is None or high is None:
        missing = [name for name, end in (("--from", low), ("--to", high)) if end is None]
        raise UsageError(
            f"The interval is missing: give {' and '.join(missing)}, such as --from 0 --to 2*pi."
        )
    return low, high


def whole_number(text: str, option: str) -> int:
    """Return an option's value as an integer; raise UsageError if it is none."""
    try:
        return int(text)
    except ValueError:
        raise UsageError(f"The option {option} needs a whole number, and {text!r} is none.") from None


def check_files(write: Sequence[str], plot: str | None, primitive: str | None = None) -> None:
    """Refuse before the work what could not be written after it; touches nothing.

    Args:
        write: files for `Spline.write`.
        plot: a file for `Spline.plot`, or None.
        primitive: the kind of pieces, where the user has chosen one.

    Raises:
        OsculantError: a suffix that is not known or not for such pieces, a place that cannot be written to,
            no matplotlib or ezdxf.
    """
    for file in write:
        writer = writer_of(printable(file))
        _check_arcs(file, writer, primitive)
        writer.check_installed()
        check_place(file)
    if plot is not None:
        try:
            from matplotlib.backend_bases import FigureCanvasBase
        except ImportError:
            raise not_installed("Drawing", "matplotlib", "plot") from None
        kinds = sorted(FigureCanvasBase.get_supported_filetypes())
        if Path(plot).suffix[1:].lower() not in kinds:
            raise OsculantError(
                f"Cannot draw {printable(plot) or 'a file without a name'}: the known suffixes are "
                f".{', .'.join(kinds)}."
            )
        check_place(plot)


def _check_arcs(file: str, writer: Writer, primitive: str | None) -> None:
    """Refuse a format that cannot hold the pieces of a primitive."""
    unfit = [entry for entry in may_become(primitive) if not writer.holds(entry.arcs)]
    if unfit:
        most_general = max(unfit, key=lambda entry: len(entry.arcs)).name
        verb = "are to be" if most_general == primitive else "may become"
        held = listed([KINDS[kind] for kind in KINDS if kind in get_args(ConicKind) and writer.holds([kind])])
        able = [entry.name for entry in may_become("best") if writer.holds(entry.arcs)]
        raise OsculantError(
            f"Cannot write {printable(file)}: it would hold {held} only, and the pieces {verb} "
            f"{most_general} arcs; choose --with {listed(able, 'or')}."
        )


def writing_options(write: Sequence[str], **texts: str | None) -> dict[str, dict[str, Any]]:
    """What `Spline.write` is to be told about each file.

    Args:
        write: the files, of known suffixes.
        texts: "reserve", "decimals" and "units" as typed, None where they are not.

    Raises:
        UsageError: a value that makes no sense, or an option that none of the files can follow.

    >>> writing_options(["a.svg", "b.nc"], reserve="1e-3", decimals="4")
    {'a.svg': {'reserve': 0.001}, 'b.nc': {'reserve': 0.001, 'decimals': 4}}
    """
    values: dict[str, Any] = {name: text for name, text in texts.items() if text is not None}
    for name in values:
        if not any(writer_of(file).takes(name) for file in write):
            able = listed(suffixes(option=name), "or")
            raise UsageError(f"The option --{name} needs a file of the kind {able}: add --write.")
    if "reserve" in values:
        values["reserve"] = _positive(values["reserve"], "--reserve")
    if "decimals" in values:
        values["decimals"] = whole_number(values["decimals"], "--decimals")
        if not 0 <= values["decimals"] <= MOST_DECIMALS:
            raise UsageError(
                f"The option --decimals is {values['decimals']}: give a number from 0 to {MOST_DECIMALS}."
            )
    if values.get("units", "mm") not in UNITS:
        raise UsageError(f"The units {values['units']!r} are unknown: choose {listed(UNITS, 'or')}.")
    return {
        file: {name: value for name, value in values.items() if writer_of(file).takes(name)} for file in write
    }


def _positive(text: str, option: str) -> float:
    """Return an option's value as a positive finite number; raise UsageError if it is none."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise UsageError(f"The option {option} needs a positive finite number, and {text!r} is none.")
    return value


def check_place(file: str) -> None:
    """Refuse a file that could not be written where it is to be; raises OsculantError, touches nothing."""
    target = Path(os.path.realpath(file))
    folder = target.parent
    if os.path.isdir(target):
        reason = "it is a folder"
    elif not os.path.exists(folder):
        reason = f"there is no folder {folder}; make it first"
    elif not os.path.isdir(folder):
        reason = f"{folder} is not a folder"
    elif not os.access(folder, os.W_OK | os.X_OK):
        reason = f"nothing may be written in the folder {folder}"
    else:
        return
    raise OsculantError(printable(f"Cannot write {file}: {reason}."))
