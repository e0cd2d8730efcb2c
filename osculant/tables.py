"""Tables of the thesis, computed anew beside what it prints.

Table 3.1 is about the Archimedean spiral (section 3.7.1), table 3.3 about Cayley's sextic (3.7.2), which is
split at its sextactic point t = 0 for both primitives. Tables whose printed numbers are lost are in
`osculant.count_tables`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal

from osculant import space_tables
from osculant.cas.errors import DomainError
from osculant.count_tables import CountTable, biarc_table

Verdict = Literal["as printed", "corrected", "differs"]
Quantity = Literal["experiment", "theory"]

#: the formulas of the thesis for the number of pieces
EQUATIONS = {"parabola": "3.17", "conic": "3.18"}


@dataclass(frozen=True)
class Erratum:
    """A wrong cell of the printed table: the right value, and why."""

    value: int
    reason: str


@dataclass(frozen=True)
class PrintedTable:
    """A table as the thesis prints it.

    Attributes:
        number: of the table.
        caption: what it is about, in our words.
        formula, low, high, split_at: the curve.
        constant_of: what part of the curve the constants belong to.
        experiment, theory: numbers of pieces at the tolerances 1e-1, 1e-2, … by primitive.
        errata: by primitive, tolerance and quantity.
    """

    number: str
    caption: str
    formula: str
    low: str
    high: str
    split_at: tuple[str, ...]
    constant_of: str
    experiment: Mapping[str, tuple[int, ...]]
    theory: Mapping[str, tuple[int, ...]]
    errata: Mapping[tuple[str, float, Quantity], Erratum]


_SPIRAL = {"parabola": (5, 9, 15, 26, 46, 82, 145, 257), "conic": (3, 4, 6, 9, 13, 21, 32, 51)}
_SEXTIC_PARABOLA = (6, 8, 14, 24, 44, 76, 134, 238)

PRINTED = {
    "3.1": PrintedTable(
        "3.1",
        "The spiral, Hausdorff distance",
        "t*cos(t), t*sin(t)",
        "pi/6",
        "2*pi",
        (),
        "the curve",
        _SPIRAL,
        _SPIRAL,
        {},
    ),
    "3.3": PrintedTable(
        "3.3",
        "Cayley's sextic split at t = 0, Hausdorff distance",
        "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)",
        "-3*pi/4",
        "3*pi/4",
        ("0",),
        "one half",
        {"parabola": _SEXTIC_PARABOLA, "conic": (4, 4, 6, 8, 12, 18, 28, 44)},
        {"parabola": _SEXTIC_PARABOLA, "conic": (2, 4, 6, 8, 12, 18, 28, 44)},
        {
            ("conic", 1e-1, "experiment"): Erratum(
                2,
                "two conics do it, with the error 0.0933688: each half turns by exactly pi, so that the end "
                "tangents are parallel and a parameter by the control point where they meet cannot reach "
                "the conic",
            )
        },
    ),
}


@dataclass(frozen=True)
class Cell:
    """One number of a table, as computed and as printed.

    ``note`` is the reason of a correction, or None.
    """

    primitive: str
    tolerance: float
    quantity: Quantity
    computed: int
    printed: int
    verdict: Verdict
    note: str | None = None


@dataclass(frozen=True)
class Constant:
    """The leading constant of one of the formulas (3.17), (3.18), as text with all digits."""

    equation: str
    primitive: str
    of: str
    value: str


@dataclass(frozen=True)
class ComputedTable:
    """A table computed beside the printed one: ``cells`` and ``constants``."""

    printed: PrintedTable
    cells: tuple[Cell, ...]
    constants: tuple[Constant, ...]

    def to_json(self) -> dict[str, Any]:
        """Plain data: table, caption, curve, from, to, split_at, cells, constants."""
        printed = self.printed
        return {
            "table": printed.number,
            "caption": printed.caption,
            "curve": printed.formula,
            "from": printed.low,
            "to": printed.high,
            "split_at": list(printed.split_at),
            "cells": [asdict(cell) for cell in self.cells],
            "constants": [asdict(constant) for constant in self.constants],
        }


def judge(computed: int, printed: int, erratum: Erratum | None) -> Verdict:
    """Say whether a computed number confirms the printed one, corrects a known error, or neither.

    >>> erratum = Erratum(2, "two conics do it")
    >>> judge(5, 5, None), judge(2, 4, erratum), judge(3, 4, erratum), judge(4, 4, erratum)
    ('as printed', 'corrected', 'differs', 'differs')
    """
    if erratum is not None:
        return "corrected" if computed == erratum.value else "differs"
    return "as printed" if computed == printed else "differs"


#: tables without printed numbers
LOST = {**space_tables.LOST, "5": biarc_table}


def compute(number: str, progress: Callable[[float], None] | None = None) -> ComputedTable | CountTable:
    """Compute a table of `PRINTED` or `LOST`: the splines counted, and the theoretical numbers.

    Args:
        number: "3.1", "3.3", "4.1", "4.2", "4.3" or "5".
        progress: called after each row with the part that is done.

    Returns:
        The table; of a printed one cells by primitive, then tolerance.

    Raises:
        DomainError: a table that is not known.

    >>> compute("3.2")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: There is no table '3.2' here: choose 3.1 or 3.3 or 4.1 or 4.2 or 4.3
    or 5.
    """
    from osculant.api import approximate, complexity, curve

    if number in LOST:
        return LOST[number](progress)
    if number not in PRINTED:
        raise DomainError(f"There is no table {number!r} here: choose {' or '.join([*PRINTED, *LOST])}.")
    printed = PRINTED[number]
    subject = curve(printed.formula, printed.low, printed.high)
    cells, constants = [], []
    rows = sum(map(len, printed.theory.values()))
    for primitive, theory in printed.theory.items():
        law = complexity(subject, primitive, split_at=printed.split_at)
        constants.append(Constant(EQUATIONS[primitive], primitive, printed.constant_of, law.constants[0]))
        for place in range(len(theory)):
            tolerance = float(f"1e-{place + 1}")
            spline = approximate(subject, primitive, tolerance, split_at=printed.split_at)
            predicted = law.predicted_pieces(tolerance)
            cells.append(_cell(printed, primitive, place, tolerance, "experiment", len(spline)))
            cells.append(_cell(printed, primitive, place, tolerance, "theory", predicted))
            if progress is not None:
                progress(len(cells) / (2 * rows))
    return ComputedTable(printed, tuple(cells), tuple(constants))


def _cell(
    printed: PrintedTable, primitive: str, place: int, tolerance: float, quantity: Quantity, computed: int
) -> Cell:
    claimed = (printed.experiment if quantity == "experiment" else printed.theory)[primitive][place]
    erratum = printed.errata.get((primitive, tolerance, quantity))
    verdict = judge(computed, claimed, erratum)
    note = erratum.reason if erratum is not None and verdict == "corrected" else None
    return Cell(primitive, tolerance, quantity, computed, claimed, verdict, note)
