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

from osculant import __version__
from osculant.cas.errors import OsculantError
from osculant.cli.approximate import approximate, complexity
from osculant.cli.germ import GermCommand, germ
from osculant.cli.invariants import invariants_data, print_invariants, print_values, values_data
from osculant.cli.options import (
    AsJson,
    Commands,
    Formula,
    FormulaCommand,
    High,
    Low,
    UsageError,
    whole_number,
)
from osculant.cli.splines import Waiting, print_json, printable
from osculant.cli.verify import verify

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


app.command(cls=FormulaCommand)(approximate)


@app.command(cls=FormulaCommand)
def invariants(
    formula: Formula,
    low: Low = None,
    high: High = None,
    at: Annotated[
        str | None, typer.Option("--at", metavar="T", help="Evaluate at this parameter instead.")
    ] = None,
    digits: Annotated[
        str | None, typer.Option("--digits", metavar="N", help="Digits of the values, by default 15.")
    ] = None,
    latex: Annotated[bool, typer.Option("--latex", help="Print LaTeX.")] = False,
    as_json: AsJson = False,
) -> None:
    """Print a curve's Euclidean and affine invariants exactly, or their values at a parameter.

    With both ends of an interval the arc lengths are definite integrals.
    """
    if digits is not None and at is None:
        raise UsageError("The option --digits needs --at: it tells how many digits of the values to print.")

    import osculant
    from osculant.curves.curve import DIGITS

    wanted = DIGITS if digits is None else whole_number(digits, "--digits")

    curve = osculant.curve(formula, low, high)
    data = invariants_data(curve) if at is None else values_data(curve, at, wanted)
    if as_json:
        print_json(data)
    else:
        show = print_invariants if at is None else print_values
        show(data, latex, curve.dimension)


app.command(cls=FormulaCommand)(complexity)


@app.command(cls=FormulaCommand)
def tables(
    number: Annotated[
        str,
        typer.Argument(
            metavar="TABLE",
            help="The table's number in the thesis: 3.1, 3.2, 3.3, 3.4, 4.1, 4.2, 4.3 or 5.",
        ),
    ],
    as_json: AsJson = False,
) -> None:
    """Compute a table of the thesis beside what it prints, with a verdict for every cell.

    In tables 3.2 and 3.4 errors are areas; 3.4 is computed twice, the tolerance being that of each half, as
    in the thesis, or of the whole curve. The numbers of tables 4.1 to 4.3 and of chapter 5 are lost: counts
    beside theory.
    """
    from osculant.cli.tables import print_table
    from osculant.thesis.count_tables import CountTable
    from osculant.thesis.tables import compute

    with Waiting(f"computing table {number}") as progress:
        table = compute(number, progress)
    if as_json:
        print_json(table.to_json())
    elif isinstance(table, CountTable):
        print(table.text())
    else:
        print_table(table)


app.command(cls=FormulaCommand)(verify)
app.command(cls=GermCommand)(germ)


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
        return _refuse(str(error), USAGE)
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
    if sys.stderr is not None:  # it was closed before the start
        with suppress(OSError):
            print(f"osculant: {printable(sentence)}", file=sys.stderr, flush=True)
    return status


def _forget_output() -> None:
    """Send what is still buffered nowhere, so that the interpreter does not stumble over it at exit."""
    with suppress(OSError, ValueError, AttributeError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


if __name__ == "__main__":
    sys.exit(main())
