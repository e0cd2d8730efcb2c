"""The command ``osculant invariants``: exact invariants of a curve, or their values at a parameter."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson, Formula, High, Low, whole_number
from osculant.cli.output import print_json, print_rows

if TYPE_CHECKING:
    from osculant.curves.plane import PlaneCurve
    from osculant.curves.space import SpaceCurve

#: by dimension, the names of the coordinates and the highest of their derivatives in a formula over jets
JETS = {2: ("xy", 5), 3: ("xyz", 4)}


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

    from osculant import api
    from osculant.curves.curve import DIGITS

    wanted = DIGITS if digits is None else whole_number(digits, "--digits")

    curve = api.curve(formula, low, high)
    data = invariants_data(curve) if at is None else values_data(curve, at, wanted)
    if as_json:
        print_json(data)
    else:
        show = print_invariants if at is None else print_values
        show(data, latex, curve.dimension)


def invariants_data(curve: PlaneCurve | SpaceCurve) -> dict[str, Any]:
    """The exact invariants as plain data: per name title, symbol, text, latex, over_jets.

    >>> from osculant.curves.space import SpaceCurve
    >>> data = invariants_data(SpaceCurve("3*cos(t), 3*sin(t), 4*t"))
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
            for invariant in all_invariants(curve.dimension)
        ],
    }


def values_data(curve: PlaneCurve | SpaceCurve, at: str, digits: int) -> dict[str, Any]:
    """The invariants at a parameter as plain data; numbers are text with all their digits."""
    import mpmath

    def written(value: Any) -> Any:
        if value is None:
            return None
        return [written(part) for part in value] if isinstance(value, tuple) else mpmath.nstr(value, digits)

    values = curve.at(at, digits)
    return {
        "curve": curve.text,
        "at": at,
        "digits": digits,
        "values": {name: written(value) for name, value in values.items()},
    }


def print_invariants(data: dict[str, Any], latex: bool, dimension: int) -> None:
    """Print what `invariants_data` returns, each invariant an equation on its own line."""
    if latex:
        for row in data["invariants"]:
            print(f"{row['latex_symbol']} = {row['latex']}")
    else:
        print_rows([(row["title"], f"{row['symbol']} = {row['text']}") for row in data["invariants"]])
    if any(row["over_jets"] for row in data["invariants"]):
        names, highest = JETS[dimension]
        listed = ", ".join(f"{name}1 ... {name}{highest}" for name in names)
        print(f"{listed} are the derivatives of the coordinates, where a formula would be too long.")


def print_values(data: dict[str, Any], latex: bool, dimension: int) -> None:
    """Print what `values_data` returns."""
    rows = []
    for invariant in all_invariants(dimension):
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


def all_invariants(dimension: int) -> list[Any]:
    """The invariants of curves in the plane (2) or in space (3), the lengths last.

    >>> [invariant.name for invariant in all_invariants(3)][:3]
    ['speed', 'curvature', 'torsion']
    """
    if dimension == 3:
        from osculant.cas.invariants.space import SPACE_LENGTHS
        from osculant.cas.jets.space import SPACE_INVARIANTS

        return [*SPACE_INVARIANTS, *(length for length, _ in SPACE_LENGTHS)]
    from osculant.cas.invariants.plane import LENGTHS
    from osculant.cas.jets.plane import INVARIANTS

    return [*INVARIANTS, *(length for length, _ in LENGTHS)]
