"""What the commands print: small tables for people, JSON for programs, a bar for those who wait."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from time import perf_counter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import TracebackType

    from rich.progress import Progress

    from osculant.asymptotics import Complexity
    from osculant.formula_curve import FormulaCurve
    from osculant.plane import PlaneCurve
    from osculant.space import SpaceCurve
    from osculant.spline import Spline
    from osculant.tables import ComputedTable

#: seconds before a progress bar appears
PATIENCE = 1.0
#: columns of an output that is no terminal
ENDLESS = 200
#: split points that are listed
LISTED = 8


class Waiting:
    """A progress bar on stderr, shown only on a terminal and after `PATIENCE` seconds.

    Call it with the part that is done, 0…1; use it as a context manager, so that it goes away.

    >>> with Waiting("counting") as progress:
    ...     progress(0.5)
    """

    def __init__(self, what: str) -> None:
        self.what, self.began = what, perf_counter()
        self.bar: Progress | None = None

    def __enter__(self) -> Waiting:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.bar is not None:
            self.bar.stop()

    def __call__(self, part: float) -> None:
        """Show the part that is done."""
        if self.bar is None:
            if not sys.stderr.isatty() or perf_counter() - self.began < PATIENCE:
                return
            from rich.console import Console
            from rich.progress import Progress

            self.bar = Progress(console=Console(stderr=True), transient=True)
            self.bar.add_task(self.what, total=1.0)
            self.bar.start()
        self.bar.update(self.bar.task_ids[0], completed=part)


def print_json(data: Any) -> None:
    """Print plain data as JSON."""
    print(json.dumps(data, indent=1, allow_nan=False))


def printable(text: str) -> str:
    r"""Text fit for any output: what is no valid Unicode (in a file's name) as an escape.

    >>> printable("a\udcff.svg")
    'a\\udcff.svg'
    """
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def print_spline(spline: Spline, seconds: float, files: Sequence[str]) -> None:
    """Print pieces, predicted pieces, error, time, whether the number is minimal, and split points."""
    predicted = "unknown: the integral of the theory did not settle"
    if spline.predicted is not None:
        predicted = f"{spline.predicted:.6g}, in whole pieces {spline.predicted_pieces}"
    error_kind = "" if spline.error_kind == "exact" else f" ({spline.error_kind})"
    rows = [
        ("curve", spline.curve.text),
        ("interval", f"{spline.knots[0]:.10g} to {spline.knots[-1]:.10g}"),
        ("primitive", spline.primitive),
        ("pieces", str(len(spline))),
        ("predicted", predicted),
        ("tolerance", f"{spline.tolerance:g}"),
        ("error", f"{spline.error:.7g}{error_kind}"),
        ("minimal", spline.minimal),
        ("split points", _listed(spline.splits)),
        *([("undecided", _listed(spline.undecided))] if spline.undecided else []),
        ("time", f"{seconds:.3g} s"),
        *(("written", printable(file)) for file in files),
    ]
    _print_rows(rows)


def _listed(values: Sequence[float]) -> str:
    shown = ", ".join(f"{value:.10g}" for value in values[:LISTED])
    more = f" and {len(values) - LISTED} more" if len(values) > LISTED else ""
    return shown + more if values else "none"


def print_complexity(curve: FormulaCurve, law: Complexity, tolerance: float | None) -> None:
    """Print the leading constant, the order, and the pieces predicted for a tolerance."""
    constants = law.to_json()
    rows = [
        ("curve", curve.text),
        ("primitive", law.primitive),
        ("pieces", f"C*tolerance^(-1/{law.order})"),
        ("C", constants["constant"]),
    ]
    if len(law.constants) > 1:
        rows += [(f"  stretch {place}", value) for place, value in enumerate(law.constants, 1)]
    if law.next_constant is not None:
        rows += [("next term", f"c1*tolerance^(1/{law.order})"), ("c1", f"{law.next_constant:.12g}")]
    if tolerance is not None:
        rows += [
            ("tolerance", f"{tolerance:g}"),
            ("predicted", f"{law.predicted(tolerance):.10g}"),
            *([("both terms", f"{law.refined(tolerance):.10g}")] if law.next_constant is not None else []),
            ("whole pieces", str(law.predicted_pieces(tolerance))),
        ]
    _print_rows(rows)


def invariants_data(curve: PlaneCurve) -> dict[str, Any]:
    """The exact invariants as plain data: per name title, symbol, text, latex, over_jets."""
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


def print_invariants(data: dict[str, Any], latex: bool) -> None:
    """Print what `invariants_data` returns, each invariant an equation on its own line."""
    if latex:
        for row in data["invariants"]:
            print(f"{row['latex_symbol']} = {row['latex']}")
    else:
        _print_rows([(row["title"], f"{row['symbol']} = {row['text']}") for row in data["invariants"]])
    if any(row["over_jets"] for row in data["invariants"]):
        print(
            "x1 ... x5, y1 ... y5 are the derivatives of the coordinates, where a formula would be too long."
        )


def print_values(data: dict[str, Any], latex: bool) -> None:
    """Print what `values_data` returns."""
    rows = []
    for invariant in _all_invariants():
        if invariant.name in data["values"]:
            value = data["values"][invariant.name]
            text = f"({', '.join(value)})" if isinstance(value, list) else value or "undefined here"
            rows.append((invariant.title, f"{invariant.latex if latex else invariant.text} = {text}"))
    if latex:
        print("\n".join(text for _, text in rows))
    else:
        _print_rows(rows)


def _all_invariants() -> list[Any]:
    from osculant.cas.invariants import INVARIANTS
    from osculant.cas.plane_exact import LENGTHS

    return [*INVARIANTS, *(length for length, _ in LENGTHS)]


def print_table(table: ComputedTable) -> None:
    """Print a table of the thesis: computed beside printed, a verdict for every cell."""
    from rich.console import Console
    from rich.table import Table

    print(f"Table {table.printed.number}. {table.printed.caption}: pieces computed and printed\n")
    shown = Table("primitive", "tolerance", box=None, pad_edge=False, padding=(0, 1))
    for quantity in ("experiment", "theory"):
        shown.add_column(quantity, justify="right")
        shown.add_column("printed", justify="right")
        shown.add_column("verdict")
    rows: dict[tuple[str, float], list[str]] = {}
    for cell in table.cells:  # experiment before theory
        row = rows.setdefault((cell.primitive, cell.tolerance), [cell.primitive, f"{cell.tolerance:.0e}"])
        row += [str(cell.computed), str(cell.printed), cell.verdict]
    for row in rows.values():
        shown.add_row(*row)
    width = None if sys.stdout.isatty() else ENDLESS
    Console(width=width, markup=False, emoji=False, highlight=False).print(shown)
    for cell in table.cells:
        if cell.note is not None:
            print(f"\n{cell.primitive}, {cell.quantity} at {cell.tolerance:.0e}: {cell.note}.")
    print()
    _print_rows(
        [
            (f"constant ({constant.equation}), {constant.primitive}, {constant.of}", constant.value)
            for constant in table.constants
        ]
    )


def _print_rows(rows: Sequence[tuple[str, str]]) -> None:
    width = max(len(name) for name, _ in rows)
    print("\n".join(f"{name:<{width}}  {text}" for name, text in rows))
