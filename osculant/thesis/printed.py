"""Tables 3.1 to 3.4 as the thesis prints them, and which of their cells are wrong.

Tables 3.1 and 3.2 are about the Archimedean spiral (section 3.7.1), tables 3.3 and 3.4 about Cayley's sextic
(3.7.2), which is split at its sextactic point t = 0 for both primitives. In tables 3.2 and 3.4 errors are
areas. The thesis's table 3.4 grants the tolerance to each half of the curve.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from osculant.cas.claims.examples import SEXTIC, SPIRAL_ARC

Quantity = Literal["experiment", "theory"]
#: what the tolerance is granted to; the number of pieces is that of the whole curve in any case
Reading = Literal["whole curve", "each half"]


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


_SPIRAL_CURVE = (*SPIRAL_ARC, (), "the curve")
_SEXTIC_CURVE = (SEXTIC, "-3*pi/4", "3*pi/4", ("0",), "one half")
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
