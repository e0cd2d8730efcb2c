"""What ``osculant tables`` prints of a table whose printed numbers are known."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from osculant.cli.splines import ENDLESS, print_rows

if TYPE_CHECKING:
    from osculant.thesis.tables import ComputedTable


def print_table(table: ComputedTable) -> None:
    """Print a table of the thesis: computed beside printed, a verdict for every cell.

    Where the thesis leaves open what the tolerance is granted to there is a part for each reading.
    """
    from rich.console import Console
    from rich.table import Table

    printed = table.printed
    print(f"Table {printed.number}. {printed.caption}: pieces computed and printed\n")
    console = Console(
        width=None if sys.stdout.isatty() else ENDLESS, markup=False, emoji=False, highlight=False
    )
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
        console.print(shown)
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
