"""Options that several commands share, and what their values must be."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from osculant.cas.errors import OsculantError
from osculant.cli.grammar import UsageError
from osculant.cli.output import printable
from osculant.files.registry import suffixes, writer_of
from osculant.files.writing import check_place, listed, not_installed
from osculant.primitives.table import METRICS, USUAL, usual_first

#: what the command line calls that which the library's sentences call otherwise
NAMES = {
    "low": "--from",
    "high": "--to",
    "t": "--at",
    "at": "--at",
    "to": "--to",
    "direction": "--direction",
    "order": "--order",
    "even": "--even",
    "split_at": "--split-at",
    "plot()": "--plot",
    "patience": "--patience",
    "tolerance": "--tolerance",
    "source": "--source",
    "target": "--target",
    "group": "--group",
    "codimension": "--codimension",
    "osculant.cas.claims.all_claims()": "`osculant verify --list`",
}

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
        "with the fewest numbers to store, in the first file if one is written.",
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


def number(text: str, option: str) -> float:
    """Return an option's value as a finite number; raise UsageError if it is none."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise UsageError(f"The option {option} needs a finite number, and {text!r} is none.")
    return value


def check_plot(plot: str | None) -> None:
    """Refuse before the work what could not be drawn after it; touches nothing.

    Args:
        plot: a file for `Spline.plot`, or None.

    Raises:
        OsculantError: a suffix that is not known, a place that cannot be written to, no matplotlib.
    """
    if plot is None:
        return
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


#: options of writers that are numbers, and what reads them
NUMBERS = {
    "decimals": whole_number,
    "feed": number,
    "largest_angle": number,
    "smallest_radius": number,
    "largest_radius": number,
}


def writing_options(write: Sequence[str], **given: Any) -> dict[str, dict[str, Any]]:
    """What `Spline.write` is to be told about each file.

    Args:
        write: the files.
        given: options of writers as typed, None where they are not.

    Raises:
        UsageError: a number that is none, or an option that none of the files can follow.
        OsculantError: a suffix that is not known.

    >>> writing_options(["a.svg", "b.nc"], decimals="4", units=None)
    {'a.svg': {}, 'b.nc': {'decimals': 4}}
    """
    names = [name for name in given if given[name] is not None]
    takers = {file: writer_of(printable(file)).options for file in write}
    for name in names:
        if not any(name in options for options in takers.values()):
            able = listed(suffixes(option=name), "or")
            raise UsageError(f"The option {dashed(name)} needs a file of the kind {able}: add --write.")
    values = {
        name: NUMBERS[name](given[name], dashed(name)) if name in NUMBERS else given[name] for name in names
    }
    return {
        file: {name: value for name, value in values.items() if name in options}
        for file, options in takers.items()
    }


def dashed(name: str) -> str:
    """The option of the command line for an argument.

    >>> dashed("largest_angle")
    '--largest-angle'
    """
    return f"--{name.replace('_', '-')}"


def formulas_of(formula: str) -> Any:
    """The text of formulas, or the path of the file that is named after @; UsageError without a name.

    >>> formulas_of(" x, y"), str(formulas_of("@germ.txt"))
    ('x, y', 'germ.txt')
    """
    text = formula.strip()
    if not text.startswith("@"):
        return text
    if not text[1:].strip():
        raise UsageError("The name of the file is missing after @: write for instance @germ.txt.")
    return Path(text[1:].strip())
