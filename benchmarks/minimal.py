"""What `minimal` says, and why: conics and biarcs on twelve curves at 1e-1 to 1e-8.

    python benchmarks/minimal.py

Each entry is the number of pieces with a letter: p, proved (every stretch between split points takes one); t,
by theory (a theorem's hypotheses are proved in balls for every arc); u, unknown. Reasons for u follow a row.
"""

from __future__ import annotations

import osculant as osc

CURVES = {
    "spiral": ("t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    "Cayley's sextic": ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "-3*pi/4", "3*pi/4"),
    "spiral from its middle": ("t*cos(t), t*sin(t)", "1/5", "2*pi"),
    "logarithmic spiral": ("exp(t/5)*cos(t), exp(t/5)*sin(t)", "0", "4*pi"),
    "cycloid": ("t - sin(t), 1 - cos(t)", "0", "2*pi"),
    "cardioid": ("2*cos(t) - cos(2*t), 2*sin(t) - sin(2*t)", "0", "2*pi"),
    "sine": ("t, sin(t)", "0", "2*pi"),
    "ellipse": ("2*cos(t), sin(t)", "0", "2*pi"),
    "exponential": ("t, exp(t)", "-2", "2"),
    "cubical parabola": ("t, t^3", "-1", "1"),
    "figure eight": ("cos(t), sin(2*t)", "0", "2*pi"),
    "clothoid-like": ("t*cos(t^2), t*sin(t^2)", "1/2", "3"),
}
TOLERANCES = [10.0**-n for n in range(1, 9)]


def why(spline: osc.Spline) -> str:
    """The reason that nothing is said."""
    if spline.error == 0:
        return "the curve is of such arcs itself, and how far one may turn is a choice"
    if spline.undecided:
        return "it was not decided whether there are split points"
    if spline.bridged:
        return "arcs below the tolerance are passed over"
    return "an arc turns too far: for the theorem, or for a piece of it to be proper"


def row(curve: osc.PlaneCurve, primitive: str) -> tuple[list[str], set[str]]:
    """The entries of a row, and the reasons for what is unknown."""
    entries, reasons = [], set()
    for tolerance in TOLERANCES:
        spline = osc.approximate(curve, primitive, tolerance)
        word = spline.minimal
        entries.append(f"{len(spline)}{'t' if word == 'by theory' else word[0]}")
        if word == "unknown":
            reasons.add(f"{tolerance:.0e}: {why(spline)}")
    return entries, reasons


def main() -> None:
    """Print the table."""
    print(f"{'':24}{'':8}" + "".join(f"{tolerance:>8.0e}" for tolerance in TOLERANCES))
    for name, (formula, low, high) in CURVES.items():
        curve = osc.curve(formula, low, high)
        for primitive in ("conic", "biarc"):
            entries, reasons = row(curve, primitive)
            print(f"{name:24}{primitive:8}" + "".join(f"{entry:>8}" for entry in entries), flush=True)
            for reason in sorted(reasons):
                print(f"{'':32}{reason}")


if __name__ == "__main__":
    main()
