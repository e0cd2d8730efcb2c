"""Equivalences of the lists' germs under random dense changes, as certificates: checked, and tampered with.

Each seed is one germ, with signs by chance, and one dense change of its group (`tests.random_germs`), cut at
the degree of determinacy; the germs in turn. The equivalence with the normal form of its row is written as a
certificate, which the independent checker must accept; then it is tampered with in every way of `TAMPERED`,
and each time must be refused.

    python -m tests.random_equivalences tests/data/random-equivalences.txt 2

goes on with a record, in two processes, a line for each of the first `SEEDS` seeds that it does not have yet,
and prints what it says in all; the exit status is 1 if one is a fault. A row whose equivalences are not built
is told to be undecided.
"""

from __future__ import annotations

import json
import sys
import time
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor, as_completed
from copy import deepcopy
from dataclasses import dataclass
from functools import lru_cache
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from osculant.cas.errors import OsculantError, UndecidedError
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.tangent import JetSpace
from osculant.cas.recognition.equivalence import NotEquivalent, equivalence
from osculant.cas.recognition.forms import Form, form
from osculant.certificates.check_algebra import read
from osculant.certificates.check_text import RejectedError
from osculant.certificates.checker import check
from osculant.germs.equivalence_file import equivalence_file
from osculant.germs.map_germ import MapGerm
from tests import random_germs

#: seeds of the record
SEEDS = 600
#: terms of the jets in which a germ is kept at most
TERMS = 1200
#: verdicts that are faults
FAILURES = ("REFUSED", "TAMPERED", "NOT_EQUIVALENT", "ERROR")


@dataclass(frozen=True)
class Case:
    """A germ of a list, up to signs, with its normal form."""

    germ: random_germs.Case
    form: Form

    def name(self, signs: tuple[int, ...]) -> str:
        """List, row, parameters and signs."""
        told = [f"{name}={value}" for name, value in self.germ.parameters]
        told += ["".join("+" if s > 0 else "-" for s in signs)] if signs else []
        return " ".join([f"{self.germ.entry.list}: {self.germ.entry.id}", *told])

    @property
    def terms(self) -> int:
        """How many terms its jets have."""
        return JetSpace(self.form.n, self.form.p, self.form.order).columns


@lru_cache(maxsize=1)
def cases() -> tuple[Case, ...]:
    """The germs of all lists, one for each choice of the parameters that is tried, small jets only."""
    found = []
    for case in random_germs.cases():
        moduli = {p.name for p in case.entry.parameters if p.least is None}
        integers = {name: int(value) for name, value in case.parameters if name not in moduli}
        made = Case(case, form(case.entry, **integers))
        if made.terms <= TERMS:
            found.append(made)
    return tuple(found)


def moved(seed: int) -> tuple[Case, str, Germ]:
    """The germ of a seed, its name, and what it is after the change of that seed."""
    case = cases()[seed % len(cases())]
    change = random_germs.Change(seed, case.form.order)
    signs = change.signs(case.germ)
    return case, case.name(signs), change.applied(case.germ.germ(signs), case.form.group.name)


@lru_cache(maxsize=8)
def written(seed: int) -> str:
    """The certificate of the equivalence of a seed, as it is in its file."""
    case, _, germ = moved(seed)
    found = equivalence(germ, case.form)
    return json.dumps(equivalence_file(MapGerm(germ), found, determined=False))


def accepted(seed: int) -> tuple[str, str]:
    """(verdict, what was found) about the equivalence of a seed and its certificate."""
    try:
        data = json.loads(written(seed))
    except NotEquivalent as obstruction:
        return "NOT_EQUIVALENT", str(obstruction)
    except UndecidedError as error:
        return "UNDECIDED", str(error)
    except (OsculantError, ArithmeticError) as error:
        return "ERROR", str(error)
    try:
        check(data)
    except RejectedError as error:
        return "REFUSED", str(error)
    survived = kept(seed)
    return ("ACCEPTED", "") if survived is None else ("TAMPERED", survived)


def kept(seed: int) -> str | None:
    """The name of a way to tamper with the certificate of a seed that the checker does not notice."""
    for name, tamper in TAMPERED.items():
        data = json.loads(written(seed))
        if not tamper(data):
            continue
        try:
            check(data)
        except RejectedError:
            continue
        return name
    return None


Data = dict[str, Any]


def _germ(data: Data) -> bool:
    """Another germ: one component has a term more."""
    data["components"][-1] += f" + {data['source'][0]}**{data['order']}"
    return True


def _change(key: str, names: str) -> Callable[[Data], bool]:
    """A change of coordinates that has a linear term more."""

    def tamper(data: Data) -> bool:
        if data[key] is None:
            return False
        variables = data["form"]["variables"] if names == "form" else data["target"]
        data[key][0] += f" + 7*{variables[-1]}"
        return True

    return tamper


def _matrix(data: Data) -> bool:
    if data["matrix"] is None:
        return False
    data["matrix"][0][0] += " + 7"
    return True


def _scale(side: str) -> Callable[[Data], bool]:
    """A larger scale; for variables that are not in the jets of the form it may be anything."""

    def tamper(data: Data) -> bool:
        form = data["form"]
        jets = [read(text, (*form["variables"], *form["moduli"])) for text in form["components"]]
        terms = [m for m in jets[0] if sum(m[: len(form["variables"])]) <= data["order"]]
        if not terms or (side == "source" and not any(m[0] for m in terms)):
            return False
        value = data["scales"][side][0]
        told = deepcopy(value) if isinstance(value, dict) else {"factor": value, "powers": []}
        told["powers"].append(["2", "1/3"])
        data["scales"][side][0] = told
        return True

    return tamper


def _coefficient(data: Data) -> bool:
    """A coefficient of the form three times as large."""
    shown = data["form"]["components"][0]
    if shown == "0":
        return False
    data["form"]["components"][0] = f"3*({shown})"
    return True


def _modulus(data: Data) -> bool:
    for name in data["form"]["moduli"]:
        data["form"]["moduli"][name] = "1234567/7654321"
        return True
    return False


def _order(data: Data) -> bool:
    """Jets of an order that the changes do not reach."""
    data["order"] = 0
    return True


def _boundary(data: Data) -> bool:
    """A change that moves the boundary."""
    if data["form"]["boundary"] is None:
        return False
    place = data["source"].index(data["boundary"])
    other = next((name for name in data["form"]["variables"] if name != data["form"]["boundary"]), None)
    if other is None:
        return False
    data["phi"][place] += f" + {other}"
    return True


#: ways to tamper with a certificate, by name; each tells whether there was anything to change
TAMPERED: dict[str, Callable[[Data], bool]] = {
    "germ": _germ,
    "source change": _change("phi", "form"),
    "target change": _change("psi", "target"),
    "matrix": _matrix,
    "source scale": _scale("source"),
    "target scale": _scale("target"),
    "form": _coefficient,
    "modulus": _modulus,
    "order": _order,
    "boundary": _boundary,
}


def tried(seed: int) -> str:
    """The line of a seed in the record."""
    began = time.process_time()
    verdict, told = accepted(seed)
    name = moved(seed)[1]
    shown = f"{seed:6d} {verdict:14s} {time.process_time() - began:7.2f} {name}"
    return f"{shown}: {told}" if told else shown


def summary(path: Path) -> str:
    """What a record says in all."""
    rows = random_germs.recorded(path)
    told = ", ".join(
        f"{count} {verdict}" for verdict, count in sorted(Counter(row[1] for row in rows).items())
    )
    seconds = sorted(float(row[2]) for row in rows)
    return (
        f"{len(rows)} equivalences: {told}; {sum(seconds):.0f} CPU seconds, the median "
        f"{seconds[len(seconds) // 2]:.2f}, the longest {seconds[-1]:.1f}"
    )


def main(path: Path, processes: int = 1, seeds: int = SEEDS) -> int:
    """Go on with the record; returns the exit status."""
    known = {int(row[0]) for row in random_germs.recorded(path)} if path.exists() else set()
    missing = sorted(set(range(seeds)) - known, key=lambda seed: (cases()[seed % len(cases())].terms, seed))
    workers = ProcessPoolExecutor(processes, get_context("spawn"))
    with path.open("a", encoding="utf-8") as record, workers as pool:
        for done in as_completed([pool.submit(tried, seed) for seed in missing]):
            record.write(done.result() + "\n")
            record.flush()
    lines = path.read_text(encoding="utf-8").splitlines()
    path.write_text("\n".join(sorted(lines)) + "\n", encoding="utf-8")
    print(summary(path))
    return int(any(row[1] in FAILURES for row in random_germs.recorded(path)))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), *map(int, sys.argv[2:])))
