"""How the command line is read: formulas may begin with a minus, and every mistake is one sentence."""

from __future__ import annotations

import math
import os
import re
import sys
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup

from osculant.cas.errors import OsculantError
from osculant.cli.splines import printable
from osculant.files.writing import GCODE_SUFFIXES, OPTIONS, SUFFIXES, listed

#: what has the looks of an option; everything else that begins with "-" is a formula or a number
_OPTION = re.compile(r"--?[A-Za-z][A-Za-z0-9-]*(=.*)?", re.DOTALL)
#: what has the looks of an option and is a formula all the same
_MINUS = re.compile(r"-(t|pi|e)")
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


class UsageError(OsculantError):
    """A command line that cannot be understood."""


def arrange(
    arguments: Sequence[str],
    valued: Iterable[str],
    flags: Iterable[str],
    repeated: Iterable[str],
    places: int,
) -> list[str]:
    """Bring a command's arguments into an order that leaves nothing to guess: options, ``--``, the rest.

    Args:
        arguments: as typed, without the command's name.
        valued: names of the options that take a value, ``--from`` and so on.
        flags: names of the options that take none.
        repeated: those of ``valued`` that may be given several times; more than one value may follow them
            once all positional arguments have been given.
        places: the number of positional arguments.

    Returns:
        The same arguments; every value follows its option's name.

    Raises:
        UsageError: an unknown option (the nearest is suggested), an option without its value, or an
            argument too many.

    >>> arrange(["-t, t^2", "--from", "-pi/2"], ["--from"], ["--json"], [], 1)
    ['--from', '-pi/2', '--', '-t, t^2']
    >>> arrange(["t, t^2", "--write", "a.svg", "b.json"], ["--write"], [], ["--write"], 1)
    ['--write', 'a.svg', '--write', 'b.json', '--', 't, t^2']
    """
    valued, flags, repeated = set(valued), set(flags), set(repeated)
    options: list[str] = []
    positional: list[str] = []
    waiting = list(reversed(arguments))
    open_option = ""  # a repeated option whose further values may follow
    while waiting:
        argument = waiting.pop()
        name, equals, value = argument.partition("=")
        if argument == "--":
            positional += reversed(waiting)
            break
        if name in flags:
            if equals:
                raise UsageError(f"The option {name} takes no value.")
            options.append(name)
            open_option = ""
        elif name in valued:
            if not equals:
                value = _value(name, waiting, valued | flags)
            options += [name, value]
            open_option = name if name in repeated else ""
        elif _OPTION.fullmatch(argument) and not _MINUS.fullmatch(argument):
            raise UsageError(_unknown("option", name, valued | flags))
        elif open_option and len(positional) >= places:
            options += [open_option, argument]
        else:
            positional.append(argument)
            open_option = ""
    if len(positional) > places:
        raise UsageError(
            f"The argument {positional[places]!r} is one too many; quote a formula that has spaces."
        )
    return [*options, "--", *positional]


def _value(name: str, waiting: list[str], known: set[str]) -> str:
    """The next argument as the value of an option."""
    if not waiting:
        raise UsageError(f"The option {name} needs a value.")
    value = waiting.pop()
    if value.partition("=")[0] in known:
        raise UsageError(f"The option {name} needs a value, but {value} follows it.")
    return value


def _unknown(what: str, name: str, known: Iterable[str]) -> str:
    """The sentence about a name that does not exist."""
    near = get_close_matches(name, list(known), n=1, cutoff=0.6)
    advice = f"did you mean {near[0]}?" if near else f"choose one of {', '.join(sorted(known))}."
    return f"There is no {what} {name!r}: {advice}"


class FormulaCommand(TyperCommand):
    """A command whose positional arguments and values may begin with a minus."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Arrange the arguments, then let typer read them."""
        options = [parameter for parameter in self.get_params(ctx) if parameter.param_type_name == "option"]
        flags = [option for option in options if getattr(option, "is_flag", False)]
        valued = [option for option in options if option not in flags]
        repeated = [option for option in valued if getattr(option, "multiple", False)]
        rest = [parameter for parameter in self.get_params(ctx) if parameter not in options]
        places = sys.maxsize if any(parameter.nargs < 0 for parameter in rest) else len(rest)
        arranged = arrange(args, _names(valued), _names(flags), _names(repeated), places)
        return super().parse_args(ctx, arranged)


def _names(options: Iterable[Any]) -> list[str]:
    return [name for option in options for name in (*option.opts, *option.secondary_opts)]


class Commands(TyperGroup):
    """The commands; an unknown one is answered with the nearest."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Refuse unknown options before the command."""
        known = _names(self.get_params(ctx))
        if args and _OPTION.fullmatch(args[0]) and args[0] not in known:
            raise UsageError(_unknown("option", args[0], known))
        return super().parse_args(ctx, args)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Find the command by its name."""
        if args[0] not in self.commands:
            raise UsageError(_unknown("command", args[0], self.commands))
        return super().resolve_command(ctx, args)


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
        if Path(file).suffix.lower() not in SUFFIXES:
            raise OsculantError(
                f"Cannot write {printable(file) or 'a file without a name'}: the known suffixes are "
                f"{listed(SUFFIXES)}; --plot makes pictures of other kinds."
            )
        suffix = Path(file).suffix.lower()
        if suffix in {*GCODE_SUFFIXES, ".dxf"} and primitive in {"conic", "parabola", "best"}:
            kind = "may become conic arcs" if primitive == "best" else f"are to be {primitive} arcs"
            raise OsculantError(
                f"Cannot write {printable(file)}: it would hold lines and circular arcs only, and the pieces "
                f"{kind}; choose --with biarc."
            )
        if suffix == ".dxf" and find_spec("ezdxf") is None:
            raise OsculantError(
                "DXF needs ezdxf, which is not installed; `pip install osculant[cad]` adds it."
            )
        check_place(file)
    if plot is not None:
        try:
            from matplotlib.backend_bases import FigureCanvasBase
        except ImportError:
            raise OsculantError(
                "Drawing needs matplotlib, which is not installed; `pip install osculant[plot]` adds it."
            ) from None
        kinds = sorted(FigureCanvasBase.get_supported_filetypes())
        if Path(plot).suffix[1:].lower() not in kinds:
            raise OsculantError(
                f"Cannot draw {printable(plot) or 'a file without a name'}: the known suffixes are "
                f".{', .'.join(kinds)}."
            )
        check_place(plot)


def writing_options(write: Sequence[str], **texts: str | None) -> dict[str, dict[str, Any]]:
    """What `Spline.write` is to be told about each file.

    Args:
        write: the files, of known suffixes.
        texts: "reserve", "decimals" and "units" as typed, None where they are not.

    Raises:
        UsageError: a value that makes no sense, or an option that none of the files can follow.

    >>> writing_options(["a.svg", "b.nc"], reserve="1e-3", decimals="4")
    {'a.svg': {'reserve': 0.001}, 'b.nc': {'decimals': 4, 'reserve': 0.001}}
    """
    values: dict[str, Any] = {name: text for name, text in texts.items() if text is not None}
    for name in values:
        able = [suffix for suffix, names in OPTIONS.items() if name in names]
        if not any(Path(file).suffix.lower() in able for file in write):
            raise UsageError(
                f"The option --{name} needs a file of the kind {listed(able, 'or')}: add --write."
            )
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
        file: {name: values[name] for name in OPTIONS[Path(file).suffix.lower()] if name in values}
        for file in write
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
