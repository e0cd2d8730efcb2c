"""Tables whose printed numbers are lost: piece counts computed beside what theory predicts.

Tables 4.1, 4.2 and 4.3 are about bihelices, by the thesis's rule and by ours; the thesis breaks off before
their numbers. Its conical spiral and moment curve are known; of the third curve only that it is a helix of
constant slope on a sphere. Here it is the epicycloid of a rolling circle of one third of the radius, lifted
to the sphere of radius 5 with the slope 3:4: its plane projection (4 cos t − cos 4t, 4 sin t − sin 4t) has
|x|² = 17 − 8 cos 3t, so z² = 8 + 8 cos 3t = (4 cos(3t/2))². Table 5 is about biarcs; chapter 5 breaks off
before its numbers, too, so the curves are those of tables 3.1 and 3.3, of the sextic one half.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from osculant.cas.claims.examples import CONICAL, HALF_SEXTIC, MOMENT, SPIRAL_ARC

#: a formula and the ends of its interval
Curve = tuple[str, str, str]


@dataclass(frozen=True)
class LostTable:
    """What is counted in a table.

    Attributes:
        subject: the pieces, as the caption names them; ``{}`` is the curve.
        primitive: likewise, as `osculant.approximate` calls them.
        curves: by name.
        tolerances: of the rows.
        rules: by the name of their column.
    """

    subject: str
    primitive: str
    curves: Mapping[str, Curve]
    tolerances: tuple[float, ...]
    rules: Mapping[str, str | None]


def _in_space(name: str, curve: Curve) -> LostTable:
    return LostTable(
        "Bihelices of {}",
        "bihelix",
        {name: curve},
        (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8),
        {"thesis rule": "thesis", "our rule": "equioscillating"},
    )


LOST = {
    "4.1": _in_space("conical spiral", (CONICAL, "pi/6", "2*pi")),
    "4.2": _in_space("moment curve", (MOMENT, "0", "1")),
    "4.3": _in_space(
        "spherical helix",
        ("4*cos(t) - cos(4*t), 4*sin(t) - sin(4*t), 4*cos(3*t/2)", "pi/12", "7*pi/12"),
    ),
    "5": LostTable(
        "Biarcs",
        "biarc",
        {"spiral": SPIRAL_ARC, "Cayley's sextic, one half": HALF_SEXTIC},
        (1e-2, 1e-3, 1e-4, 1e-6, 1e-8),
        {"biarc": None},
    ),
}


@dataclass(frozen=True)
class CountRow:
    """One curve and tolerance: pieces found, by rule if there are several, and the theory's real number."""

    curve: str
    tolerance: float
    pieces: dict[str, int]
    theory: float


@dataclass(frozen=True)
class CountTable:
    """A table of counts: rows, and by curve the constant C in N = C·ε^(−1/3), as text with all its digits."""

    number: str
    caption: str
    rows: tuple[CountRow, ...]
    constants: dict[str, str]

    def to_json(self) -> dict[str, Any]:
        """Plain data: table, caption, rows, constants."""
        return {
            "table": self.number,
            "caption": self.caption,
            "rows": [asdict(row) for row in self.rows],
            "constants": self.constants,
        }


def count_table(number: str, progress: Callable[[float], None] | None = None) -> CountTable:
    """Compute a table of `LOST`.

    Args:
        number: "4.1", "4.2", "4.3" or "5".
        progress: called after each row with the part that is done.
    """
    from osculant.api import approximate, complexity, curve

    lost = LOST[number]
    rows, constants = [], {}
    for name, formula in lost.curves.items():
        subject = curve(*formula)
        law = complexity(subject, lost.primitive)
        constants[name] = law.constants[0]
        for tolerance in lost.tolerances:
            pieces = {
                column: len(approximate(subject, lost.primitive, tolerance, rule=rule))
                for column, rule in lost.rules.items()
            }
            rows.append(CountRow(name, tolerance, pieces, law.predicted(tolerance)))
            if progress is not None:
                progress(len(rows) / (len(lost.curves) * len(lost.tolerances)))
    caption = f"{lost.subject.format(subject.text)}, Hausdorff distance: pieces found and theory"
    return CountTable(number, caption, tuple(rows), constants)
