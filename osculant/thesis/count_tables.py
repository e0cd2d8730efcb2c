"""Tables whose printed numbers are lost: piece counts computed beside what theory predicts.

Table 5 is about biarcs; the thesis's chapter 5 breaks off before its numbers, so the curves are those of its
tables 3.1 and 3.3, of the sextic one half.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

#: tolerances of the rows
TOLERANCES = ("1e-2", "1e-3", "1e-4", "1e-6", "1e-8")
#: name, formula and interval of the curves of table 5
PLANE_CURVES = (
    ("spiral", "t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    ("Cayley's sextic, one half", "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "0", "3*pi/4"),
)


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

    def text(self) -> str:
        """The table in words.

        >>> row = CountRow("spiral", 0.01, {"biarc": 5}, 4.22114)
        >>> print(CountTable("5", "Biarcs", (row,), {"spiral": "0.909416"}).text())
        Table 5. Biarcs
        <BLANKLINE>
        curve   tolerance  biarc  theory
        spiral      1e-02      5    4.22
        <BLANKLINE>
        constant, spiral  0.909416
        """
        rules = list(self.rows[0].pieces)
        width = max(len("curve"), *(len(row.curve) for row in self.rows))
        sizes = [max(6, len(rule) + 1) for rule in rules]
        head = "".join(f"{rule:>{size + 1}}" for rule, size in zip(rules, sizes))
        lines = [f"Table {self.number}. {self.caption}", "", f"{'curve':<{width}}  tolerance{head}  theory"]
        for row in self.rows:
            counts = "".join(f"{row.pieces[rule]:>{size + 1}}" for rule, size in zip(rules, sizes))
            lines.append(f"{row.curve:<{width}}  {row.tolerance:>9.0e}{counts}  {row.theory:>6.2f}")
        longest = max(map(len, self.constants))
        lines += ["", *(f"constant, {name:<{longest}}  {value}" for name, value in self.constants.items())]
        return "\n".join(lines)


def biarc_table(progress: Callable[[float], None] | None = None) -> CountTable:
    """Compute table 5: biarcs of the spiral and of one half of Cayley's sextic.

    Args:
        progress: called after each row with the part that is done.
    """
    from osculant.api import approximate, complexity, curve

    rows, constants = [], {}
    for name, *formula in PLANE_CURVES:
        subject = curve(*formula)
        law = complexity(subject, "biarc")
        constants[name] = law.constants[0]
        for tolerance in map(float, TOLERANCES):
            spline = approximate(subject, "biarc", tolerance)
            rows.append(CountRow(name, tolerance, {"biarc": len(spline)}, law.predicted(tolerance)))
            if progress is not None:
                progress(len(rows) / (len(PLANE_CURVES) * len(TOLERANCES)))
    return CountTable("5", "Biarcs, Hausdorff distance: pieces found and theory", tuple(rows), constants)
