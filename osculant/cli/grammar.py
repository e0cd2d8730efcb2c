"""How a command line is read: formulas may begin with a minus, and every mistake is one sentence."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Any

from typer.core import TyperCommand, TyperGroup

from osculant.cas.errors import OsculantError

#: what has the looks of an option; everything else that begins with "-" is a formula or a number
_OPTION = re.compile(r"--?[A-Za-z][A-Za-z0-9-]*(=.*)?", re.DOTALL)
#: what has the looks of an option and is a formula all the same
_MINUS = re.compile(r"-(t|pi|e)")


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
            raise UsageError(unknown("option", name, valued | flags))
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


def unknown(what: str, name: str, known: Iterable[str]) -> str:
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
            raise UsageError(unknown("option", args[0], known))
        return super().parse_args(ctx, args)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Find the command by its name."""
        if args[0] not in self.commands:
            raise UsageError(unknown("command", args[0], self.commands))
        return super().resolve_command(ctx, args)
