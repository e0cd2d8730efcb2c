"""The command line: one thin command for each public function.

Exit statuses: 0; 2 for anything that the user can put right, told in one sentence; 130 after Ctrl-C; 141 if
the reader of the output went away; 1 for a claim that fails and for a defect of osculant.
"""

from __future__ import annotations

import os
import shlex
import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import Annotated

import typer

from osculant.cas.errors import OsculantError
from osculant.cli.approximate import approximate
from osculant.cli.cache import cache
from osculant.cli.check import check
from osculant.cli.classify import classify
from osculant.cli.compile import compile_curve
from osculant.cli.complexity import complexity
from osculant.cli.germ import GermCommand, germ
from osculant.cli.grammar import Commands, FormulaCommand
from osculant.cli.invariants import invariants
from osculant.cli.options import NAMES
from osculant.cli.output import lenient, printable, tell
from osculant.cli.recognise import recognise
from osculant.cli.secant import secant
from osculant.cli.tables import tables
from osculant.cli.verify import verify
from osculant.version import __version__

USAGE, INTERRUPTED, BROKEN_PIPE, DEFECT = 2, 130, 141, 1
#: set, it lets a defect's traceback through
DEBUG = "OSCULANT_DEBUG"

app = typer.Typer(
    cls=Commands,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    invoke_without_command=True,
    help="Curves approximated with the fewest pieces, from their formula.",
    epilog="Formulas are written like t*cos(t), 2^(1/3) or -pi/6; give them in quotation marks.",
)


def _version(wanted: bool) -> None:
    if wanted:
        print(f"osculant {__version__}")
        raise typer.Exit


@app.callback()
def _door(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    if context.invoked_subcommand is None:
        print(context.get_help())


for command in (approximate, invariants, complexity, classify, tables, verify, check, cache):
    app.command(cls=FormulaCommand)(command)
app.command("compile", cls=FormulaCommand)(compile_curve)
app.command(cls=GermCommand)(germ)
app.command(cls=GermCommand)(secant)
app.command(cls=GermCommand)(recognise)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line and return its exit status.

    Args:
        arguments: without the program's name; those of the process by default.

    >>> main(["--version"])
    osculant 0.1.0
    0
    """
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    command = printable(shlex.join(["osculant", *arguments]))
    lenient()
    # Matrices of germs are small: threads of numpy, which is not loaded yet, would wait for each other.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        status = app(args=arguments, prog_name="osculant", standalone_mode=False, obj=command)
        print(end="", flush=True)  # a closed pipe or a full disk shall be seen here, not at exit
        return status or 0
    except (BrokenPipeError, SystemExit):  # typer makes the second of the first
        _forget_output()
        return BROKEN_PIPE
    except (KeyboardInterrupt, typer.Abort):
        return INTERRUPTED
    except OsculantError as error:
        return _refuse(error.told(NAMES), USAGE)
    except OSError as error:
        _forget_output()
        return _refuse(f"Cannot write {error.filename or 'the output'}: {error.strerror or error}.", USAGE)
    except Exception as error:
        usage = typer.BadParameter.mro()[1]  # not exported by all versions of typer
        if isinstance(error, usage):
            return _refuse(error.format_message(), USAGE)  # type: ignore[attr-defined]
        if os.environ.get(DEBUG):
            raise
        return _refuse(
            f"This is a defect of osculant ({type(error).__name__}: {error}): please report it; "
            f"{DEBUG}=1 shows where it happened.",
            DEFECT,
        )


def _refuse(sentence: str, status: int) -> int:
    tell(sentence)
    return status


def _forget_output() -> None:
    """Send what is still buffered nowhere, so that the interpreter does not stumble over it at exit."""
    with suppress(OSError, ValueError, AttributeError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
