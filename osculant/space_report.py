"""What the commands print about space curves: tables for people, plain data for programs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.report import all_invariants, print_rows

if TYPE_CHECKING:
    pass


def print_space_invariants(data: dict[str, Any], latex: bool) -> None:
    """Print what `report.invariants_data` returns, each invariant an equation on its own line."""
    if latex:
        for row in data["invariants"]:
            print(f"{row['latex_symbol']} = {row['latex']}")
    else:
        print_rows([(row["title"], f"{row['symbol']} = {row['text']}") for row in data["invariants"]])
    if any(row["over_jets"] for row in data["invariants"]):
        print(
            "x1 ... x4, y1 ... y4, z1 ... z4 are the derivatives of the coordinates, where a formula would "
            "be too long."
        )


def print_space_values(data: dict[str, Any], latex: bool) -> None:
    """Print what `report.values_data` returns."""
    rows = []
    for invariant in all_invariants(3):
        if invariant.name in data["values"]:
            symbol = invariant.latex if latex else invariant.text
            rows.append((invariant.title, f"{symbol} = {_written(data['values'][invariant.name])}"))
    if latex:
        print("\n".join(text for _, text in rows))
    else:
        print_rows(rows)


def _written(value: Any) -> str:
    if value is None:
        return "undefined here"
    return f"({', '.join(map(_written, value))})" if isinstance(value, list) else str(value)
