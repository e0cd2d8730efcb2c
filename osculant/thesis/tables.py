"""Tables of the thesis, computed anew beside what it prints.

Where the thesis grants the tolerance of a table to each half of the curve, what holds for the whole curve is
beside it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import to_text
from osculant.cas.formulas.parser import parse_tuple
from osculant.thesis.count_tables import LOST, CountTable, count_table
from osculant.thesis.printed import PRINTED, Erratum, PrintedTable, Quantity, Reading

if TYPE_CHECKING:
    from osculant.approximation.prediction import Complexity
    from osculant.curves.plane import PlaneCurve
    from osculant.curves.space import SpaceCurve

Verdict = Literal["as printed", "corrected", "differs", "computed"]

#: the formulas of the thesis for the number of pieces, by metric
EQUATIONS = {
    "hausdorff": {"parabola": "3.17", "conic": "3.18"},
    "area": {"parabola": "3.25", "conic": "3.26"},
}


@dataclass(frozen=True)
class Cell:
    """One number of a table, as computed and as printed.

    ``reading`` is what the tolerance is granted to; ``printed`` is None, and the verdict "computed", if the
    thesis has no such number; ``note`` is the reason of a correction, or None.
    """

    primitive: str
    tolerance: float
    quantity: Quantity
    computed: int
    printed: int | None
    verdict: Verdict
    note: str | None = None
    reading: Reading = "whole curve"


@dataclass(frozen=True)
class Constant:
    """The leading constant of one of the formulas in `EQUATIONS`, as text with all digits."""

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
        """Plain data: table, caption, metric, curve, from, to, split_at, cells, constants."""
        printed = self.printed
        return {
            "table": printed.number,
            "caption": printed.caption,
            "metric": printed.metric,
            "curve": ", ".join(map(to_text, parse_tuple(printed.formula))),
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


def compute(number: str, progress: Callable[[float], None] | None = None) -> ComputedTable | CountTable:
    """Compute a table of `PRINTED` or `LOST`: the splines counted, and the theoretical numbers.

    Args:
        number: "3.1", "3.2", "3.3", "3.4", "4.1", "4.2", "4.3" or "5".
        progress: called after each row with the part that is done.

    Returns:
        The table; of a printed one cells by reading, then primitive, then tolerance.

    Raises:
        DomainError: a table that is not known.

    >>> compute("2.7")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: There is no table '2.7' here: choose 3.1 or 3.2 or 3.3 or 3.4 or 4.1 or
    4.2 or 4.3 or 5.
    """
    from osculant.api import complexity, curve

    if number in LOST:
        return count_table(number, progress)
    if number not in PRINTED:
        raise DomainError(f"There is no table {number!r} here: choose {' or '.join([*PRINTED, *LOST])}.")
    printed = PRINTED[number]
    cells: list[Cell] = []
    constants: dict[str, Constant] = {}
    every = len(printed.readings) * sum(map(len, printed.theory.values())) * 2
    for reading in printed.readings:
        ends = printed.parts(reading)
        subjects = [curve(printed.formula, low, high) for low, high, _ in ends]
        splits = [split_at for _, _, split_at in ends]
        for primitive, theory in printed.theory.items():
            laws = [
                complexity(subject, primitive, metric=printed.metric, split_at=split_at)
                for subject, split_at in zip(subjects, splits)
            ]
            equation, constant = EQUATIONS[printed.metric][primitive], laws[0].constants[0]
            constants.setdefault(equation, Constant(equation, primitive, printed.constant_of, constant))
            for place in range(len(theory)):
                cells += _row(printed, reading, primitive, place, list(zip(subjects, splits, laws)))
                if progress is not None:
                    progress(len(cells) / every)
    return ComputedTable(printed, tuple(cells), tuple(constants.values()))


def _row(
    printed: PrintedTable,
    reading: Reading,
    primitive: str,
    place: int,
    parts: list[tuple[PlaneCurve | SpaceCurve, tuple[str, ...], Complexity]],
) -> list[Cell]:
    """Experiment and theory at the tolerance in that place, granted to each of the parts."""
    from osculant.api import approximate

    tolerance = float(f"1e-{place + 1}")
    computed: dict[Quantity, int] = {
        "experiment": sum(
            len(approximate(subject, primitive, tolerance, metric=printed.metric, split_at=split_at))
            for subject, split_at, _ in parts
        ),
        "theory": sum(law.predicted_pieces(tolerance) for _, _, law in parts),
    }
    if reading != printed.readings[0]:
        return [
            Cell(primitive, tolerance, quantity, count, None, "computed", None, reading)
            for quantity, count in computed.items()
        ]
    cells = []
    for quantity, count in computed.items():
        claimed = (printed.experiment if quantity == "experiment" else printed.theory)[primitive][place]
        erratum = printed.errata.get((primitive, tolerance, quantity))
        verdict = judge(count, claimed, erratum)
        note = erratum.reason if erratum is not None and verdict == "corrected" else None
        cells.append(Cell(primitive, tolerance, quantity, count, claimed, verdict, note, reading))
    return cells
