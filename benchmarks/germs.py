"""Germs that were slow, undecided or not sharp: answers and CPU seconds, each in a process of its own.

`python -m benchmarks.germs [SECONDS]` prints a table; a germ that takes longer than SECONDS (20) is stopped.
Columns: what is asked, the answer, the right one, CPU seconds without those of importing.
"""

from __future__ import annotations

import json
import resource
import subprocess
import sys
from typing import Any

INFINITE = [
    ("x, x*y, y^3", "x y", "A"),
    ("t^3, t^6", "t", "A"),
    ("t^6, t^9", "t", "A"),
    ("t^3, t^9, t^12", "t", "A"),
    ("(t+t^2)^2, (t+t^2)^4", "t", "A"),
    ("x^2-y^2, x*y", "x y", "A"),
    ("(x^2+y^2)^2", "x y", "R"),
    ("(x^2-2*y^2)^2", "x y", "R"),
    ("(x^2+y^2+z^2)^2", "x y z", "R"),
    ("(y-x-x^2)^2", "x y", "R"),
    ("(y^2-x^3-x^4)^2", "x y", "R"),
    ("(x+y+x^2)^2", "x y", "R"),
    ("x, (y^2-x-x^2)^2", "x y", "A"),
    ("(x^4+y^5)^2", "x y", "R"),
    ("x, x*y+y^5, x*y^2", "x y", "A"),
    ("x, (y-6*x^2)^2, (y-6*x^2)^3", "x y", "A"),
    ("sin(x)^2", "x y", "R"),
    ("x, y^3*exp(x)", "x y", "A"),
    ("x/(1-y), y^3/(1+x)", "x y", "A"),
    ("tan(x)-x, atan(y)", "x y", "A"),
    ("x^3+y^4", "x y", "L"),
    ("x^2+y^2", "x y", "C"),
    ("x^3-3*x^2*y^2+4*y^6", "x y", "R"),
    ("x^3+y^3+z^3-3*x*y*z", "x y z", "R"),
]
S4 = (
    "x+2*y+x^2/3-x*y+y^2-x^3/2+x^2*y+2*x*y^2-y^3/3+x^4-x^3*y/2+x^2*y^2+x*y^3-2*y^4",
    "y-x+2*x^2-x*y/2+y^2/3+x^3+x^2*y/3-x*y^2+y^3/2-x^4/3+x^3*y+2*x^2*y^2-x*y^3/2+y^4",
)
DENSE_S4 = f"{S4[0]}, ({S4[1]})^2, ({S4[1]})^3 + ({S4[0]})^5*({S4[1]})"
#: germ, source, group, question, answer
FINITE: list[tuple[str, str, str, str, Any]] = [
    ("x, y, z^2, z*(z^2+x^2*y+y^4)", "x y z", "A", "A_e", 5),
    ("x, y, z^2, z*(z^2+x^3+y^5)", "x y z", "A", "A_e", 8),
    ("x, y, z^2, z*(z^2+x^4+y^4)", "x y z", "A", "A_e", 9),
    ("x, y, w, z^2, z*(z^2+x^4+y^4+w^4)", "x y w z", "A", "A_e", 27),
    ("a, b, c, d, z^6+a*z+b*z^2+c*z^3+d*z^4", "a b c d z", "A", "determinacy", [6, True]),
    (DENSE_S4, "x y", "A", "A_e", 4),
    (DENSE_S4, "x y", "A", "determinacy", [6, True]),
    ("x^2+y^45", "x y", "R", "R_e", 44),
    ("t^2, t^45", "t", "A", "A_e", 22),
    ("t^7, t^8", "t", "A", "A_e", 21),
    ("x, x*y+y^8", "x y", "A", "A_e", 15),
    ("x, x*y+y^9", "x y", "A", "A_e", 21),
    ("x, x*y+y^10", "x y", "A", "A_e", 28),
    ("y^2+x^60", "x y", "K", "K_e", 59),
    ("x^100", "x", "R", "R_e", 99),
    ("a, b, c, d, z^7+a*z+b*z^2+c*z^3+d*z^4", "a b c d z", "A", "A_e", 1),
    ("(x^6+x*y^2)*(x+23)^6*(y-6)^6", "x y", "K", "K_e", 7),
    ("t^31, t^37", "t", "A", "A_e", None),
    ("x^10+y^11+z^12", "x y z", "R", "R_e", 990),
]
#: germs in coordinates as they are and after a change; the degrees must agree and be sharp
MOVED = [
    ("x^3+y^4", "x y", "R", 4),
    ("x^2*y+y^4", "x y", "R", 4),
    ("x, x*y+y^4", "x y", "A", 4),
    ("x, y^3+x^2*y", "x y", "A", 3),
    ("x, x*y+y^5+y^7", "x y", "A", 7),
    ("x, y^2, y^3+x^3*y", "x y", "A", 4),
    ("x, y^2, x^2*y+y^5", "x y", "A", 5),
    ("x, x*y+y^5, y^3", "x y", "A", 5),
    ("x^3, x^4", "x", "A", 4),
]
CHANGE = {"x": "(x-y/2+x^2-x*y/3+y^2)", "y": "(y+2*x+x*y-x^2/2+y^2/3)"}


def cases() -> list[tuple[str, str, str, str, Any]]:
    found: list[tuple[str, str, str, str, Any]] = [(*case, "cod", "infinite") for case in INFINITE]
    found += FINITE
    for germ, source, group, degree in MOVED:
        found.append((germ, source, group, "determinacy", [degree, True]))
        found.append((moved(germ, source, group), source, group, "determinacy", [degree, True]))
    return found


def moved(germ: str, source: str, group: str) -> str:
    for name in source.split():
        change = CHANGE[name] if source != "x" else "(2*x-x^2+x^3/3)"
        germ = germ.replace(name, change.replace("x", "X").replace("y", "Y"))
    components = [c.strip() for c in germ.replace("X", "x").replace("Y", "y").split(",")]
    if group == "A":  # a change of the target
        components[-1] = f"{components[-1]} - ({components[0]})/3 + ({components[0]})*({components[-1]})"
        components[0] = f"{components[0]} + 2*({components[-1]}) - ({components[0]})^2"
    return ", ".join(components)


def answer(germ: str, source: str, group: str, question: str) -> Any:
    from osculant.cas.errors import UndecidedError
    from osculant.cas.germs.codimension import codimension
    from osculant.cas.germs.determinacy import determinacy
    from osculant.cas.germs.germ import Germ

    begun = _cpu()
    try:
        given = Germ(germ, source)
        if question == "determinacy":
            found = determinacy(given, group)
            value: Any = [found.degree, found.sharp]
        else:
            value = codimension(given, group, extended=question.endswith("_e")).value
    except UndecidedError as error:
        value = f"undecided: {error}"
    return value, _cpu() - begun


def _cpu() -> float:
    """CPU seconds of this process and of those it waited for."""
    own, children = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def main(limit: float) -> None:
    wrong = 0
    for case in cases():
        command = [sys.executable, "-m", "benchmarks.germs", "--one", json.dumps(case[:4])]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=True)
            value, seconds = json.loads(done.stdout)
            shown = f"{seconds:6.2f}"
        except subprocess.TimeoutExpired:
            value, shown = "stopped", f">{limit:5.0f}"
        except subprocess.CalledProcessError as error:
            value, shown = error.stderr.strip().splitlines()[-1], ""
        right = case[4] is None or value == case[4]
        wrong += not right
        mark = " " if right else "✗"
        print(f"{mark} {shown}  {case[3]:11} {value!s:12.60} {case[2]} {case[0]:.60}", flush=True)
    print(f"{wrong} of {len(cases())} not as they should be")


if __name__ == "__main__":
    if "--one" in sys.argv:
        print(json.dumps(answer(*json.loads(sys.argv[-1]))))
    else:
        main(float(sys.argv[1]) if len(sys.argv) > 1 else 20.0)
