"""What the commands print about space curves: tables for people, plain data for programs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from osculant.report import print_rows

if TYPE_CHECKING:
    from osculant.cas.invariants import Invariant
    from osculant.space import SpaceCurve


def space_invariants_data(curve: SpaceCurve) -> dict[str, Any]:
    """The exact invariants as plain data: per name title, symbol, text, latex, over_jets.

    >>> from osculant.space import SpaceCurve
    >>> data = space_invariants_data(SpaceCurve("3*cos(t), 3*sin(t), 4*t"))
    >>> [(row["symbol"], row["text"]) for row in data["invariants"][:3]]
    [('ds/dt', '5'), ('kappa', '3/25'), ('tau', '4/25')]
    """
    exact = curve.exact
    return {
        "curve": curve.text,
        "invariants": [
            {
                "name": invariant.name,
                "title": invariant.title,
                "symbol": invariant.text,
                "latex_symbol": invariant.latex,
                "text": exact.text(invariant.name),
                "latex": exact.latex(invariant.name),
                "over_jets": invariant.name in exact.over_jets,
            }
            for invariant in _all_invariants()
        ],
    }


def print_space_invariants(data: dict[str, Any], latex: bool) -> None:
    """Print what `space_invariants_data` returns, each invariant an equation on its own line."""
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
    for invariant in _all_invariants():
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


def _all_invariants() -> list[Invariant]:
    from osculant.cas.space_exact import SPACE_INVARIANTS, SPACE_LENGTHS

    return [*SPACE_INVARIANTS, *(length for length, _ in SPACE_LENGTHS)]
