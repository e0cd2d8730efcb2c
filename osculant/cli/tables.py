"""The command ``osculant tables``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from osculant.cli.options import AsJson
from osculant.cli.output import Waiting, announce_compiling, console, print_json, print_rows

if TYPE_CHECKING:
    from osculant.thesis.count_tables import CountTable
    from osculant.thesis.tables import ComputedTable


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
    from osculant.thesis.count_tables import CountTable
    from osculant.thesis.tables import compute

    announce_compiling()
    with Waiting(f"computing table {number}") as progress:
        table = compute(number, progress)
    if as_json:
        print_json(table.to_json())
    elif isinstance(table, CountTable):
        print_counts(table)
    else:
        print_table(table)


def print_table(table: ComputedTable) -> None:
    """Print a table of the thesis: computed beside printed, a verdict for every cell.

    Where the thesis leaves open what the tolerance is granted to there is a part for each reading.
    """
    from rich.table import Table

    printed = table.printed
    print(f"Table {printed.number}. {printed.caption}: pieces computed and printed\n")
    out = console()
    for reading in printed.readings:
        if len(printed.readings) > 1:
            by = "as the thesis reads it" if reading == printed.readings[0] else "not printed"
            print(f"The tolerance holds for {'the ' * (reading == 'whole curve')}{reading} ({by})\n")
        shown = Table("primitive", "tolerance", box=None, pad_edge=False, padding=(0, 1))
        for quantity in ("experiment", "theory"):
            shown.add_column(quantity, justify="right")
            shown.add_column("printed", justify="right")
            shown.add_column("verdict")
        rows: dict[tuple[str, float], list[str]] = {}
        for cell in table.cells:  # experiment before theory
            if cell.reading == reading:
                row = rows.setdefault(
                    (cell.primitive, cell.tolerance), [cell.primitive, f"{cell.tolerance:.0e}"]
                )
                row += [str(cell.computed), "" if cell.printed is None else str(cell.printed), cell.verdict]
        for row in rows.values():
            shown.add_row(*row)
        out.print(shown)
        print()
    for cell in table.cells:
        if cell.note is not None:
            print(f"{cell.primitive}, {cell.quantity} at {cell.tolerance:.0e}: {cell.note}.\n")
    print_rows(
        [
            (f"constant ({constant.equation}), {constant.primitive}, {constant.of}", constant.value)
            for constant in table.constants
        ]
    )


def print_counts(table: CountTable) -> None:
    """Print a table of counts beside theory.

    >>> from osculant.thesis.count_tables import CountRow, CountTable
    >>> row = CountRow("spiral", 0.01, {"biarc": 5}, 4.22114)
    >>> print_counts(CountTable("5", "Biarcs", (row,), {"spiral": "0.909416"}))
    Table 5. Biarcs
    <BLANKLINE>
    curve   tolerance  biarc  theory
    spiral      1e-02      5    4.22
    <BLANKLINE>
    constant, spiral  0.909416
    """
    rules = list(table.rows[0].pieces)
    width = max(len("curve"), *(len(row.curve) for row in table.rows))
    sizes = [max(6, len(rule) + 1) for rule in rules]
    head = "".join(f"{rule:>{size + 1}}" for rule, size in zip(rules, sizes))
    print(f"Table {table.number}. {table.caption}\n\n{'curve':<{width}}  tolerance{head}  theory")
    for row in table.rows:
        counts = "".join(f"{row.pieces[rule]:>{size + 1}}" for rule, size in zip(rules, sizes))
        print(f"{row.curve:<{width}}  {row.tolerance:>9.0e}{counts}  {row.theory:>6.2f}")
    print()
    print_rows([(f"constant, {name}", value) for name, value in table.constants.items()])
