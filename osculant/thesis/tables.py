"""Tables of the thesis, computed anew beside what it prints.

Tables 3.1 and 3.2 are about the Archimedean spiral (section 3.7.1), tables 3.3 and 3.4 about Cayley's sextic
(3.7.2), which is split at its sextactic point t = 0 for both primitives. In tables 3.2 and 3.4 errors are
areas. The thesis's table 3.4 grants the tolerance to each half of the curve; beside it stands what holds for
the whole curve. Tables whose printed numbers are lost are in `osculant.thesis.count_tables`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

from osculant.cas.errors import DomainError
from osculant.thesis import space_tables
from osculant.thesis.count_tables import CountTable, biarc_table

if TYPE_CHECKING:
    from osculant.approximation.prediction import Complexity
    from osculant.curves.plane import PlaneCurve
    from osculant.curves.space import SpaceCurve

Verdict = Literal["as printed", "corrected", "differs", "computed"]
Quantity = Literal["experiment", "theory"]
#: what the tolerance is granted to; the number of pieces is that of the whole curve in any case
Reading = Literal["whole curve", "each half"]

#: the formulas of the thesis for the number of pieces, by metric
EQUATIONS = {
    "hausdorff": {"parabola": "3.17", "conic": "3.18"},
    "area": {"parabola": "3.25", "conic": "3.26"},
}


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
        metric: of the errors.
        readings: what the tolerance is granted to, first in the numbers printed; of others there are none.
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
    metric: str = "hausdorff"
    readings: tuple[Reading, ...] = ("whole curve",)

    def parts(self, reading: Reading) -> list[tuple[str, str, tuple[str, ...]]]:
        """The parts of the curve that are granted the tolerance: their ends, and where they are split.

        >>> PRINTED["3.4"].parts("each half")
        [('-3*pi/4', '0', ()), ('0', '3*pi/4', ())]
        """
        if reading == "whole curve":
            return [(self.low, self.high, self.split_at)]
        return [(*ends, ()) for ends in pairwise((self.low, *self.split_at, self.high))]


_SPIRAL_CURVE = ("t*cos(t), t*sin(t)", "pi/6", "2*pi", (), "the curve")
_SEXTIC_CURVE = (
    "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)",
    "-3*pi/4",
    "3*pi/4",
    ("0",),
    "one half",
)
_SPIRAL = {"parabola": (5, 9, 15, 26, 46, 82, 145, 257), "conic": (3, 4, 6, 9, 13, 21, 32, 51)}
_SPIRAL_AREA = {"parabola": (9, 15, 26, 46, 82, 146), "conic": (4, 6, 9, 13, 21, 33)}
_SEXTIC_PARABOLA = (6, 8, 14, 24, 44, 76, 134, 238)
_SEXTIC_AREA = {"parabola": (6, 12, 20, 34, 60, 108), "conic": (4, 4, 6, 10, 16, 24)}

PRINTED = {
    "3.1": PrintedTable("3.1", "The spiral, Hausdorff distance", *_SPIRAL_CURVE, _SPIRAL, _SPIRAL, {}),
    "3.2": PrintedTable(
        "3.2",
        "The spiral, symmetric difference (area)",
        *_SPIRAL_CURVE,
        _SPIRAL_AREA,
        _SPIRAL_AREA,
        {},
        "area",
    ),
    "3.3": PrintedTable(
        "3.3",
        "Cayley's sextic split at t = 0, Hausdorff distance",
        *_SEXTIC_CURVE,
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
    "3.4": PrintedTable(
        "3.4",
        "Cayley's sextic split at t = 0, symmetric difference (area)",
        *_SEXTIC_CURVE,
        _SEXTIC_AREA,
        _SEXTIC_AREA,
        {
            ("parabola", 1e-1, "experiment"): Erratum(
                8, "three parabolas on a half have the total area 0.105361, more than 0.1"
            )
        },
        "area",
        ("each half", "whole curve"),
    ),
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
        return LOST[number](progress)
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
