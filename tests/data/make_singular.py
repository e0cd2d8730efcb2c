"""Writes singular-codimensions.json beside it: what Singular answers for many germs.

    python -m venv /elsewhere/venv
    /elsewhere/venv/bin/pip install passagemath-singular==10.8.13
    python tests/data/make_singular.py /elsewhere/venv/lib/python3.11/site-packages/sage_wheels/bin/Singular

The package carries Singular 4.4.1; it is used here only, the tests read the stored answers. A_e and A come
from coDimMap of classifyMapGerms.lib, A(H)_e and A(H) from its coDim with the module of the fields tangent to
H, everything else from standard bases. coDim may take very long, and never ends where the codimension is
infinite though the germ is K-finite: after `SECONDS` only the other answers are asked for.
"""

from __future__ import annotations

import json
import random
import subprocess
import sys
from itertools import combinations_with_replacement
from pathlib import Path

SECONDS = 10
SEED = 20240607

MODULES = ("R_e", "R", "K_e", "K")
BOUNDARY = ("R(H)_e", "R(H)", "K(H)_e", "K(H)")
LEFT, LEFT_BOUNDARY = ("A_e", "A"), ("A(H)_e", "A(H)")
FUNCTION = (*MODULES, "milnor", "tjurina")

#: (source, what is asked, germs)
LISTS: list[tuple[str, tuple[str, ...], list[str]]] = [
    (
        "x y",  # plane to plane (Rieger), corank 2, and dense ones
        (*LEFT, "K_e", "K", "algebra"),
        [
            "x, y^2",
            "x, x*y+y^3",
            "x, y^3+x^2*y",
            "x, y^3-x^3*y",
            "x, y^3+x^5*y",
            "x, x*y+y^4",
            "x, x*y+y^5+y^7",
            "x, x*y+y^5",
            "x, x*y+y^6",
            "x, x*y+y^6+y^9",
            "x, x*y+y^6+y^8+3/7*y^9",
            "x, x*y^2+y^4+y^5",
            "x, x*y^2+y^4+y^7",
            "x, x*y^2+y^5+y^6",
            "x, x*y^2+y^5",
            "x, x^2*y+y^4+y^5",
            "x, x^2*y+y^4",
            "x^2+y^3, y^2+x^3",
            "x^2+y^3, y^2+x^5",
            "x^2-y^2+x^3, x*y",
            "x^2-y^2+x^5, x*y",
            "x, y^3+1000000007*x*y+x^4",
            "x+y-2*x^2, (x+y^2)*(y-3*x)+(y-x^2)^3",
            "2*x-y+x*y, (x+y)*(x-y+x^2)+7*(x+2*y)^4",
        ],
    ),
    (
        "x y",  # R² → R³ (Mond)
        (*LEFT, "K_e", "K", "algebra", "ramification"),
        [
            "x, y^2, x*y",
            "x, y^2, y^3+x^2*y",
            "x, y^2, y^3-x^4*y",
            "x, y^2, x^2*y+y^5",
            "x, y^2, x^2*y-y^7",
            "x, y^2, x*y^3+x^3*y",
            "x, y^2, x*y^3-x^4*y",
            "x, y^2, x^3*y+y^5",
            "x, x*y+y^5, y^3",
            "x, x*y+y^8, y^3",
            "x+y^2, (y-x)^2+x^3, x*y-5*y^3+(x+y)^3",
        ],
    ),
    (
        "x y",  # R² → R⁴, R² → R⁵
        (*LEFT, "K_e", "K", "algebra"),
        [
            "x, x*y, y^2, y^3",
            "x, x*y, y^2, y^5",
            "x, y^2, y^3, x^2*y",
            "x, y^2, y^3, x^3*y",
            "x, y^2, y^3+x^2*y, x^3*y",
            "x, x*y+y^4, y^2+x^3, y^3-x*y^2",
            "x, y^2, x*y, y^3, 0",
        ],
    ),
    (
        "x",  # curves
        (*LEFT, "R_e", "K_e", "K", "algebra"),
        [
            "x^2, x^3",
            "x^2, x^7",
            "x^3, x^4",
            "x^3, x^5",
            "x^3, x^7",
            "x^3, x^7+x^8",
            "x^3, x^8+x^10",
            "x^4, x^5+x^7",
            "x^4, x^7+x^9",
            "x^4, x^7+x^13",
            "x^3, x^4, x^5",
            "x^3+x^4, x^5-2*x^4, x^7",
            "x^2+x^3, x^4+x^5",
        ],
    ),
    (
        "x y z",  # three variables
        (*LEFT, "K_e", "K", "algebra"),
        [
            "x, y, z^4+x*z+y*z^2",
            "x, y, z^3+x^2*z+y^2*z",
            "x, y, z^3+x*y*z",
            "x, y, z^5+x*z+y*z^2",
            "x, y, z^2, x*z",
            "x, y, z^2, z^3+x^2*z+y^3*z",
            "x, y*z+x*y+z^3, y^2+x*z+z^2",
        ],
    ),
    (
        "x y z",  # onto the plane: no algebra of finite dimension
        (*LEFT, "K_e", "K"),
        ["x, y^2+z^2+x*y", "x, y^3+z^2+x*y", "x, y^4+x*y+z^2", "x, y^3+y*x^2-z^2", "x, y*z+y^4+x*y^2"],
    ),
    (
        "x y",  # functions
        FUNCTION,
        [
            "x^2+y^2",
            "x^3+y^2",
            "x^2*y+y^3",
            "x^2*y-y^6",
            "x^3+y^4",
            "x^3+x*y^3",
            "x^3+y^5",
            "x^4+y^5+x^2*y^3",
            "x^4+y^4+3*x^2*y^2",
            "x^5+y^5+x^3*y^3",
            "x^2*y^2+x^5+y^7",
            "x^2*y^2",
            "(x+2*y-x*y)^3+(x-y)^2*(x+y)^2-5*x*y^4",
            "x^4-2*x^2*y^2+y^4+x^5*y+y^6",
        ],
    ),
    (
        "x y z",
        FUNCTION,
        [
            "x^2+y^2+z^2",
            "x^3+y^3+z^3",
            "x^3+y^3+z^3+7*x*y*z",
            "x*y*z+x^4+y^5+z^6",
            "x^2+y^3+z^7+y^2*z^3",
            "x^2*y+y^2*z+z^4",
            "x*y+z^9+x^3*z^2",
        ],
    ),
    (
        "x u",  # boundary functions (Arnold); genotypes
        BOUNDARY,
        [
            "x^2+u^3",
            "x^2-u^5",
            "x*u+x^4",
            "u^2+x^3",
            "u+x^5",
            "u^2+x*u^2+x^4",
            "x^2*u+u^3+x^5",
            "x^2*u^2",
            "u",
        ],
    ),
    (
        "x u",  # maps with a boundary in the source
        (*LEFT_BOUNDARY, *BOUNDARY[2:]),
        [
            "x, u",
            "x, u^2+x*u",
            "x, u^2+x^2*u",
            "x, u^3+x*u",
            "u, x^2",
            "u+x^2, x^3+x*u",
            "x*u+x^3, u-x^2",
            "x, u^2+x^3*u",
            "x, u^2, x*u",
            "x+u^2, u^2-3*x*u+x^3*u",
            "x, u^2, u^3+x^2*u",
            "u, x^2, x^3+x*u",
        ],
    ),
    (
        "x y u",
        (*LEFT_BOUNDARY, *BOUNDARY[2:]),
        [
            "x, u+y^2",
            "x, u+x*y+y^3",
            "x, u^2+x*u+y^2",
            "x, u^2+x*u-y^3+x^2*y",
            "x, y, u^2+x*u",
            "x, y, u^3+x*u+y*u^2",
            "x, y, u^2+x^2*u-y^2*u",
            "x, y^2, u+x*y",
            "x, u-y^2+x^3, x*y+y^3-u*y",
            "x, y*u+x*y+x^2*y^2+y^3",
        ],
    ),
]

HEAD = """LIB "classifyMapGerms.lib";
ring r = 0, ({variables}), (c, ds);
ideal I = {germ};
int p = {p};
ideal m = maxideal(1);
module J = jacob(I);
module B = {bent};
module C = {clean};
module F = freemodule(p);
list L; int i;
"""

QUESTIONS = {
    "A_e": "L = coDimMap(I); print(L[2]);",
    "A": "L = coDimMap(I, 1); print(L[2] - (p - nvars(r)));",
    "A(H)_e": "L = coDim(B, F, I, 10, 0); print(L[2]);",
    "A(H)": "L = coDim(C, I * F, I, 10, 0); print(L[2] - p);",
    "R_e": "print(vdim(std(J)));",
    "R": "i = vdim(std(m * J)); if (i < 0) { i = p - 1; } print(i - p);",
    "K_e": "print(vdim(std(J + I * F)));",
    "K": "i = vdim(std(m * J + I * F)); if (i < 0) { i = p - 1; } print(i - p);",
    "R(H)_e": "print(vdim(std(B)));",
    "R(H)": "i = vdim(std(C)); if (i < 0) { i = p - 1; } print(i - p);",
    "K(H)_e": "print(vdim(std(B + I * F)));",
    "K(H)": "i = vdim(std(C + I * F)); if (i < 0) { i = p - 1; } print(i - p);",
    "milnor": "print(vdim(std(ideal(J))));",
    "tjurina": "print(vdim(std(ideal(J) + I)));",
    "ramification": "print(vdim(std(minor(J, min(p, nvars(r))))));",
    # the standard monomials of a local ordering by degree count (Mⁱ + I)/(Mⁱ⁺¹ + I)
    "algebra": "ideal Q = kbase(std(I)); for (i = 1; i <= ncols(Q); i++) { print(deg(Q[i])); }",
}


def programme(source: str, germ: str, questions: tuple[str, ...]) -> str:
    """The Singular programme that answers the questions about a germ, one a line."""
    names = source.split()
    bent = [f"{'u*' if v == 'u' else ''}J[{i}]" for i, v in enumerate(names, start=1)]
    clean = [f"{w}*J[{i}]" for i, v in enumerate(names, start=1) for w in (["u"] if v == "u" else names)]
    head = HEAD.format(
        variables=", ".join(names),
        germ=germ,
        p=germ.count(",") + 1,
        bent=", ".join(bent),
        clean=", ".join(clean),
    )
    asked = [f'print("{name}"); {QUESTIONS[name]}' for name in questions]
    return "\n".join([head, *asked, "quit;"])


def ask(program: str, source: str, germ: str, questions: tuple[str, ...]) -> dict[str, object]:
    """Singular's answers; raises RuntimeError for an error, TimeoutExpired where it takes too long."""
    done = subprocess.run(
        [program, "-q"],
        input=programme(source, germ, questions),
        capture_output=True,
        text=True,
        timeout=SECONDS,
    )
    lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
    lines = [line for line in lines if not line.startswith("//")]
    if "?" in done.stdout:
        raise RuntimeError(f"{germ}: {done.stdout}")
    answers: dict[str, list[int]] = {}
    for line in lines:
        if line in QUESTIONS:
            numbers = answers.setdefault(line, [])
        else:
            numbers.append(int(line))
    return {
        name: _hilbert(numbers) if name == "algebra" else ("infinite" if numbers[0] < 0 else numbers[0])
        for name, numbers in answers.items()
    }


def _hilbert(degrees: list[int]) -> list[int]:
    return [degrees.count(d) for d in range(max(degrees) + 1)]


def _dense() -> list[tuple[str, tuple[str, ...], str]]:
    """Random germs with all monomials of some degrees."""
    numbers = random.Random(SEED)

    def form(names: list[str], degrees: range) -> str:
        monomials = [m for d in degrees for m in _monomials(names, d)]
        return "+".join(f"{numbers.choice([2, 3, 5, 7, 11])}*{m}" for m in monomials).replace("+3*", "-3*")

    found = [
        ("x y", FUNCTION, form(["x", "y"], degrees))
        for degrees in (range(2, 4), range(2, 5), range(3, 5), range(4, 6))
    ]
    found.append(("x y z", FUNCTION, form(["x", "y", "z"], range(3, 5))))
    for degrees, p in ((range(1, 4), 2), (range(2, 4), 2), (range(2, 4), 3), (range(2, 5), 4)):
        germ = ", ".join(form(["x", "y"], degrees) for _ in range(p))
        found.append(("x y", (*LEFT, "K_e", "K", "algebra"), germ))
    found.append(
        ("x y z", ("K_e", "K", "algebra"), ", ".join(form(["x", "y", "z"], range(2, 3)) for _ in "abc"))
    )
    for _ in range(3):
        germ = ", ".join(["x+" + form(["x", "u"], range(2, 4)), form(["x", "u"], range(2, 4))])
        found.append(("x u", (*LEFT_BOUNDARY, *BOUNDARY[2:]), germ))
    found.append(("x y u", BOUNDARY, form(["x", "y", "u"], range(2, 4))))
    return found


def _monomials(names: list[str], degree: int) -> list[str]:
    return ["*".join(chosen) for chosen in combinations_with_replacement(names, degree)]


def write(program: str) -> None:
    """Ask Singular about every germ and write the answers."""
    cases = [(source, asked, germ) for source, asked, germs in LISTS for germ in germs] + _dense()
    records = []
    for source, asked, germ in cases:
        answers: dict[str, object] = {}
        try:
            answers = ask(program, source, germ, asked)
        except subprocess.TimeoutExpired:
            print(f"no answer to everything in {SECONDS} s: {source}: {germ}")
            for question in asked:
                if "coDim" not in QUESTIONS[question]:
                    answers |= ask(program, source, germ, (question,))
        records.append({"source": source, "germ": germ, "answers": answers})
    lines = ",\n".join(json.dumps(record) for record in records)
    path = Path(__file__).with_name("singular-codimensions.json")
    path.write_text(f"[\n{lines}\n]\n", encoding="utf-8")
    print(f"{len(records)} germs, {sum(len(r['answers']) for r in records)} answers")


if __name__ == "__main__":
    write(sys.argv[1])
