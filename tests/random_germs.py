"""Every germ of the reference lists under random dense changes of coordinates: the same numbers.

Source and target are changed as far as the group allows, by polynomials of degree 4 with all coefficients
other than 0 and denominators up to 3; the jet is cut two orders above the degree of determinacy. The
codimensions, the degree of determinacy, its sharpness and stability must be those of the list. Each seed is
one germ, with signs by chance, and one change: the germs in turn, so that as many seeds as there are germs
try each once.

    python -m tests.random_germs tests/data/random-germs.txt 2

goes on with a record, in two processes, those with the fewest terms first, a line for each germ that it does
not have yet, and prints what it says in all; the exit status is 1 if a number differs or is not found.
"""

from __future__ import annotations

import os
import random
import sys
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from multiprocessing import get_context
from pathlib import Path

from osculant.cas.errors import OsculantError
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.codimension import codimension
from osculant.cas.germs.determinacy import determinacy
from osculant.cas.germs.entry import Entry, Value
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.jets_of_maps import map_jet
from osculant.cas.germs.polynomials import Polynomial
from osculant.cas.germs.reference import entries
from osculant.cas.germs.search import Patience
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.germs.unfolding import is_stable

#: the degree of the changes, and how many orders above the degree of determinacy jets are kept
DEGREE, BEYOND = 4, 2
#: numerators and denominators of coefficients
NUMERATORS, DENOMINATORS = (-3, -2, -1, 1, 2, 3), (1, 2, 3)
#: seconds that a number may take, as the machine may be busy
PATIENCE = 60.0
#: dimension of the source up to which both codimensions are computed: one tells the other
PLANE = 2
#: verdicts that are faults
FAILURES = ("DIFFERS", "REFUSED")


@dataclass(frozen=True)
class Case:
    """A germ of a list, up to signs: its entry and parameters."""

    entry: Entry
    parameters: tuple[tuple[str, Value], ...]

    def name(self, signs: tuple[int, ...]) -> str:
        """List and name."""
        return f"{self.entry.list}: {self.entry.called(signs, **dict(self.parameters))}"

    def germ(self, signs: tuple[int, ...]) -> Germ:
        """In the coordinates of the list."""
        return self.entry.germ(signs, **dict(self.parameters))

    def value(self, name: str) -> int:
        """A value of the list."""
        return self.entry.value(name, **dict(self.parameters))


@lru_cache(maxsize=1)
def cases() -> tuple[Case, ...]:
    """The germs of all lists, one for each choice of the parameters that is tried."""
    found = {}
    for entry in entries():
        for _, parameters in entry.tried():
            found[entry.list, entry.id, *parameters.values()] = Case(entry, tuple(parameters.items()))
    return tuple(found.values())


def terms(case: Case) -> int:
    """How many terms the jets have in which a germ is kept."""
    germ = case.germ(case.entry.signs[0])
    return JetSpace(germ.n, germ.p, case.value("determinacy") + BEYOND).columns


class Change:
    """Random signs of a germ and a random element of its group, which acts on jets of that order."""

    def __init__(self, seed: int, order: int) -> None:
        self.chance, self.order = random.Random(seed), order

    def signs(self, case: Case) -> tuple[int, ...]:
        """Signs of a germ of a list."""
        return self.chance.choice(case.entry.signs)

    def coefficient(self) -> Fraction:
        """A number other than 0."""
        return Fraction(self.chance.choice(NUMERATORS), self.chance.choice(DENOMINATORS))

    def dense(self, n: int, least: int, degree: int = DEGREE) -> Polynomial:
        """A polynomial with all terms from a degree on."""
        terms = [m for m in poly.monomials(n, degree) if poly.degree_of(m, n) >= least]
        return {m: self.coefficient() for m in terms}

    def diffeomorphism(self, n: int) -> list[Polynomial]:
        """Dense images of n variables with an invertible derivative."""
        found = [self.dense(n, 2) for _ in range(n)]
        for f, row in zip(found, self.matrix(n)):
            f.update((poly.variable(j, n), c) for j, c in enumerate(row) if c)
        return found

    def matrix(self, size: int) -> list[list[Fraction]]:
        """An invertible matrix: a lower triangular one times an upper one."""
        lower = [[self.coefficient() if j <= i else Fraction(0) for j in range(size)] for i in range(size)]
        upper = [
            [self.coefficient() if j > i else Fraction(i == j) for j in range(size)] for i in range(size)
        ]
        return [
            [sum((lower[i][k] * upper[k][j] for k in range(size)), Fraction(0)) for j in range(size)]
            for i in range(size)
        ]

    def source(self, germ: Germ, boundary: bool) -> list[Polynomial]:
        """Images of the variables; u times a positive function if the boundary u = 0 is to be kept."""
        n = germ.n
        if not boundary:
            return self.diffeomorphism(n)
        place = germ.boundary_index
        u = poly.variable(place, n)
        others = iter(self.matrix(n - 1))
        found = []
        for i in range(n):
            image = self.dense(n, 2)
            if i == place:
                image = {u + m: c for m, c in self.dense(n, 1, DEGREE - 1).items()}
                image[u] = abs(self.coefficient())
            else:
                columns = [j for j in range(n) if j != place]
                image.update((poly.variable(j, n), c) for j, c in zip(columns, next(others)) if c)
                image[u] = self.coefficient()
            found.append(image)
        return found

    def applied(self, germ: Germ, group: str) -> Germ:
        """The germ moved by an element of that group, cut above the order."""
        n, p, order = germ.n, germ.p, self.order
        jet = map_jet(germ.jet(order), n, order)
        jet = jet.compose(map_jet(self.source(germ, "(H)" in group), n, order))
        if group.startswith("A"):
            jet = map_jet(self.diffeomorphism(p), p, order).compose(jet)
        moved = jet.polynomials()
        if group.startswith("K"):
            linear, higher = self.matrix(p), [[self.dense(n, 1) for _ in range(p)] for _ in range(p)]
            rows = []
            for i in range(p):
                total: Polynomial = {}
                for j, f in enumerate(moved):
                    factor = {**higher[i][j], 0: linear[i][j]} if linear[i][j] else higher[i][j]
                    total = poly.plus(total, poly.times(factor, f, n, order))
                rows.append(total)
            moved = tuple(rows)
        return Germ([as_node(f, germ.source) for f in moved], germ.source, germ.boundary)


def moved(seed: int) -> tuple[Case, str, Germ]:
    """The germ of a seed, its name, and what it is after the change of that seed."""
    case = cases()[seed % len(cases())]
    change = Change(seed, case.value("determinacy") + BEYOND)
    signs = change.signs(case)
    return case, case.name(signs), change.applied(case.germ(signs), case.entry.group)


def difference(case: Case, germ: Germ) -> str:
    """In which number a germ differs from the list; empty if in none."""
    group = case.entry.group
    for name in ("cod", "cod_e")[: 2 if germ.n <= PLANE else 1]:
        found = codimension(germ, group, name == "cod_e", Patience(PATIENCE)).value
        if found != case.value(name):
            return f"{name} {found} instead of {case.value(name)}"
    if group.startswith("A") and is_stable(germ, group) != case.entry.stable(**dict(case.parameters)):
        return "stability"
    degree = determinacy(germ, group, Patience(PATIENCE))
    if degree.degree != case.value("determinacy"):
        return f"determinacy {degree.degree} instead of {case.value('determinacy')}"
    return "" if degree.sharp else "not sharp"


def tried(seed: int) -> str:
    """The line of a seed in the record."""
    began = time.process_time()
    case, name, germ = moved(seed)
    try:
        told = difference(case, germ)
        verdict = "DIFFERS" if told else "same"
    except OsculantError as error:
        verdict, told = "REFUSED", str(error).replace(str(germ), "the germ")
    shown = f"{seed:6d} {verdict:8s} {time.process_time() - began:7.2f} {name}"
    return f"{shown}: {told}" if told else shown


def recorded(path: Path) -> list[list[str]]:
    """The words of a record's lines, one line for each germ."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return [line.split(maxsplit=3) for line in lines if line[:6].strip().isdigit()]


def summary(path: Path) -> str:
    """What a record says in all."""
    rows = recorded(path)
    told = ", ".join(f"{count} {verdict}" for verdict, count in Counter(row[1] for row in rows).items())
    seconds = [float(row[2]) for row in rows]
    return f"{len(rows)} germs: {told}; {sum(seconds):.0f} CPU seconds, the longest {max(seconds):.1f}"


def main(path: Path, processes: int = 1) -> int:
    """Go on with the record of one change of each germ; returns the exit status."""
    known = {int(row[0]) for row in recorded(path)} if path.exists() else set()
    missing = sorted(set(range(len(cases()))) - known, key=lambda seed: (terms(cases()[seed]), seed))
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # each process has its own germ to think of
    workers = ProcessPoolExecutor(processes, get_context("spawn"))
    with path.open("a", encoding="utf-8") as record, workers as pool:
        for done in as_completed([pool.submit(tried, seed) for seed in missing]):
            record.write(done.result() + "\n")
            record.flush()
    lines = path.read_text(encoding="utf-8").splitlines()
    path.write_text("\n".join(sorted(lines)) + "\n", encoding="utf-8")
    print(summary(path))
    return int(any(row[1] in FAILURES for row in recorded(path)))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), *map(int, sys.argv[2:])))
