"""Writes the golden files beside it: what commands print with --json.

    python tests/data/make_golden.py

Run it after an intended change of the output, and read the difference before committing it.
"""

from __future__ import annotations

import io
import json
from contextlib import redirect_stdout
from pathlib import Path

from osculant.cli.main import main

SPIRAL = ["t*cos(t), t*sin(t)", "--from", "pi/6", "--to", "2*pi"]
SEXTIC = "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)"
ELLIPSE = ["2*cos(t), sin(t)", "--from", "0", "--to", "2*pi"]

#: the golden files' names and their commands
COMMANDS = {
    "approximate-spiral": ["approximate", *SPIRAL, "--with", "conic", "--tolerance", "1e-4"],
    "approximate-spiral-parabola": ["approximate", *SPIRAL, "--with", "parabola", "--tolerance", "1e-2"],
    "approximate-inflection": ["approximate", "t, t^3", "--from", "-1", "--to", "1", "--tolerance", "1e-5"],
    "approximate-cusp": ["approximate", "t^2, t^3", "--from", "-1", "--to", "1", "--tolerance", "1e-3"],
    "approximate-ellipse": ["approximate", *ELLIPSE],
    "approximate-line": ["approximate", "1-t, 2*t", "--from", "0", "--to", "1", "--split-at", "1/2"],
    "approximate-minus": [
        *["approximate", "-t, -exp(t)", "--from", "-1", "--to", "-1/2", "--tolerance", "1e-3"],
        *["--with", "parabola", "--split-at", "-0.6", "-0.7"],
    ],
    "complexity-spiral": ["complexity", *SPIRAL, "--tolerance", "1e-8"],
    "complexity-sextic": [
        *["complexity", SEXTIC, "--from", "-3*pi/4", "--to", "3*pi/4"],
        *["--with", "parabola", "--split-at", "0"],
    ],
    "complexity-area": [
        *["complexity", SEXTIC, "--from", "-3*pi/4", "--to", "3*pi/4"],
        *["--metric", "area", "--tolerance", "1e-6", "--pieces", "26"],
    ],
    "invariants-sextic": ["invariants", SEXTIC],
    "invariants-arc": ["invariants", "t, cosh(t)", "--from", "0", "--to", "log(2)"],
    "invariants-line": ["invariants", "t, 2*t"],
    "invariants-values": ["invariants", *SPIRAL[:1], "--at", "1.2", "--digits", "40"],
    "tables-3.1": ["tables", "3.1"],
    "tables-3.2": ["tables", "3.2"],
    "tables-3.3": ["tables", "3.3"],
    "tables-3.4": ["tables", "3.4"],
}


def write() -> None:
    """Run every command and write its golden file."""
    for name, command in COMMANDS.items():
        with redirect_stdout(io.StringIO()) as output:
            if main([*command, "--json"]):
                raise SystemExit(f"{name} failed")
        golden = {"command": command, "output": json.loads(output.getvalue())}
        path = Path(__file__).with_name(f"golden-{name}.json")
        path.write_text(json.dumps(golden, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write()
