"""Germs in random dense coordinates, recognised: their names, those beyond the lists, rounded coefficients.

    python -m tests.random_recognitions FILE [COUNT]

goes on with the record FILE by COUNT questions (all by default), in the order of their seeds. A line has the
seed, the verdict, the seconds of processor time and the question. Seeds below `NAMED` are germs of the lists
with dense coordinates of a degree above that of determinacy, two of three of table 6.2; then come `BEYOND`
germs that are on no list, and `ROUNDED` germs of the lists with coefficients of ten digits.
"""

from __future__ import annotations

import random
import sys
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.recognition.recognise import recognise
from osculant.germs.map_germ import MapGerm
from osculant.germs.recognition import recognised
from tests.cas.recognition.test_keys import changed
from tests.cas.recognition.test_recognise import ROWS

NAMED, BEYOND, ROUNDED = 3000, 200, 200
#: verdicts that are faults
FAULTS = ("WRONG", "NAMED")
STABLE = [row.values for row in ROWS if row.values[0].list == "table 6.2"]
OTHERS = [row.values for row in ROWS if row.values[0].list != "table 6.2"]
#: (group, variables, linear components, others with terms of that degree at least) of germs on no list
DEGENERATE = [
    ("A(H)", "x1 x2 x3 u", "x1, x2", 1, 3),
    ("A(H)", "x1 x2 x3 u", "x1, x2, x3", 1, 3),
    ("A(H)", "x1 x2 x3 u", "x1", 1, 3),
    ("A(H)", "x1 x2 x3 u", "x1, x2", 2, 2),
    ("A", "x y", "x", 1, 5),
    ("A", "x y", "x", 2, 4),
    ("R", "x y", "", 1, 5),
    ("R", "x y z", "", 1, 4),
    ("K", "x y", "", 2, 3),
    ("R(H)", "x u", "", 1, 4),
    ("A", "t", "", 2, 5),
]


def question(seed: int) -> tuple[str, str]:
    """(verdict, what was asked) of a seed."""
    draw = random.Random(seed)
    if NAMED <= seed < NAMED + BEYOND:
        return beyond(seed, draw)
    some = OTHERS if seed % 3 == 2 else STABLE
    entry, signs, values = some[seed // 3 % len(some) if seed % 3 == 2 else (seed - seed // 3) % len(some)]
    germ, order = entry.germ(signs, **values), entry.value("determinacy", **values)
    right = recognise(germ, entry.group).name
    if seed < NAMED:
        found = recognise(changed(germ, entry.group, order + 1, seed), entry.group)
    else:
        dense = changed(germ, entry.group, order, seed)
        digits = [{m: Fraction(f"{float(c):.10g}") for m, c in f.items()} for f in dense.jet(order)]
        rounded = Germ([as_node(f, germ.source) for f in digits], germ.source, germ.boundary)
        found = recognised(MapGerm(rounded), entry.group, 1e-8).found
    told = f"{entry.list}: {right}" + (" rounded" if seed >= NAMED else "")
    if right is None or (found.name is None and found.undecided):
        return "undecided", told
    return ("right" if found.name == right else "WRONG"), told


def beyond(seed: int, draw: random.Random) -> tuple[str, str]:
    """The same of a germ that is on no list."""
    name, source, linear, count, least = DEGENERATE[seed % len(DEGENERATE)]
    names = source.split()
    n, texts = len(names), []
    for _ in range(count):
        monomials = [m for m in poly.monomials(n, least + 1) if poly.degree_of(m, n) >= least]
        terms = {m: Fraction(draw.randint(1, 9) * draw.choice((-1, 1))) for m in monomials}
        kept = {m: c for m, c in terms.items() if not ("u" in names and m == poly.variable(n - 1, n))}
        texts.append(str(as_node(kept, tuple(names))))
    text = ", ".join([*([linear] if linear else []), *texts])
    found = recognise(changed(Germ(text, names), name, least + 2, seed), name)
    verdict = "NAMED" if found.name else "undecided" if found.undecided else "refused"
    return verdict, f"{name}: {linear or 0} and {count} of degree {least}"


def line(seed: int) -> str:
    """The line of the record."""
    begun = time.process_time()
    verdict, told = question(seed)
    return f"{seed:6d} {verdict:10s} {time.process_time() - begun:7.2f} {told}"


def recorded(path: Path) -> list[list[str]]:
    """The words of a record's lines."""
    return [text.split(maxsplit=3) for text in path.read_text(encoding="utf-8").splitlines()]


def summary(path: Path) -> str:
    """What a record says in all."""
    rows = recorded(path)
    told = ", ".join(f"{count} {verdict}" for verdict, count in sorted(Counter(r[1] for r in rows).items()))
    seconds = sorted(float(row[2]) for row in rows)
    middle, longest = seconds[len(seconds) // 2], seconds[-1]
    return f"{len(rows)} questions: {told}; median {middle:.2f}, longest {longest:.1f} CPU seconds"


def main(path: Path, count: int) -> int:
    """Go on with the record; returns the exit status."""
    known = {int(row[0]) for row in recorded(path)} if path.exists() else set()
    missing = [seed for seed in range(NAMED + BEYOND + ROUNDED) if seed not in known]
    with path.open("a", encoding="utf-8") as record:
        for seed in missing[:count]:
            print(line(seed), file=record, flush=True)
    print(summary(path))
    return int(any(row[1] in FAULTS for row in recorded(path)))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else NAMED + BEYOND + ROUNDED))
