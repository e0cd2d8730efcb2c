"""Tables 4.1, 4.2 and 4.3: bihelices of a conical spiral, of the moment curve and of a spherical helix.

The thesis breaks off before their numbers. Its conical spiral and moment curve are known; of the third curve
only that it is a helix of constant slope on a sphere. Here it is the epicycloid of a rolling circle of one
third of the radius, lifted to the sphere of radius 5 with the slope 3:4: its plane projection
(4 cos t − cos 4t, 4 sin t − sin 4t) has |x|² = 17 − 8 cos 3t, so z² = 8 + 8 cos 3t = (4 cos(3t/2))².
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from osculant.thesis.count_tables import CountRow, CountTable

#: tolerances of the rows
TOLERANCES = ("1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8")
#: name, formula and interval of each table's curve
SPACE_TABLES = {
    "4.1": ("conical spiral", "t*cos(t), t*sin(t), t", "pi/6", "2*pi"),
    "4.2": ("moment curve", "t, t^2, t^3", "0", "1"),
    "4.3": (
        "spherical helix",
        "4*cos(t) - cos(4*t), 4*sin(t) - sin(4*t), 4*cos(3*t/2)",
        "pi/12",
        "7*pi/12",
    ),
}


def space_table(number: str, progress: Callable[[float], None] | None = None) -> CountTable:
    """Compute table 4.1, 4.2 or 4.3: bihelices by the thesis's rule and by ours, beside the theory.

    Args:
        number: of the table, a key of `SPACE_TABLES`.
        progress: called after each row with the part that is done.
    """
    from osculant.api import approximate, complexity
    from osculant.curves.space import SpaceCurve

    name, *formula = SPACE_TABLES[number]
    curve = SpaceCurve(*formula)
    law = complexity(curve)
    rows = []
    for tolerance in map(float, TOLERANCES):
        counts = {
            "thesis rule" if rule == "thesis" else "our rule": len(
                approximate(curve, "bihelix", tolerance, rule=rule)
            )
            for rule in ("thesis", "equioscillating")
        }
        rows.append(CountRow(name, tolerance, counts, law.predicted(tolerance)))
        if progress is not None:
            progress(len(rows) / len(TOLERANCES))
    caption = f"Bihelices of {curve.text}, Hausdorff distance: pieces found and theory"
    return CountTable(number, caption, tuple(rows), {name: law.constants[0]})


#: tables without printed numbers, by number
LOST: dict[str, Callable[[Callable[[float], None] | None], CountTable]] = {
    number: partial(space_table, number) for number in SPACE_TABLES
}
