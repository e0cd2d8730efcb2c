"""Proof that a codimension is infinite, by the geometry of a germ, in a process of its own with a time limit.

Gröbner bases are made in C code that cannot be interrupted. So a process beside this one goes through the
loci (`osculant.cas.germs.loci`); each is tried in a child that is ended when its time is over, and those that
were ended are tried again with more time, as long as the process lives.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass
from typing import IO, Any

from osculant.cas.errors import OsculantError
from osculant.cas.formulas.expression import to_text
from osculant.cas.formulas.parser import FILE, parse_tuple
from osculant.cas.germs import polynomials as poly
from osculant.cas.germs.algebraic import NumberField
from osculant.cas.germs.expansion import as_node
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.groups import Group
from osculant.cas.germs.local_dimension import large_zeros
from osculant.cas.germs.loci import Locus, loci
from osculant.cas.germs.model_reading import model_of
from osculant.cas.germs.processes import Cost, counted, question

#: seconds for a locus in the first round; how much more in the next; the longest round
SLICE, MORE, LONGEST = 0.3, 4, 600.0
#: seconds that are needed to look whether there is an answer
SHORT = 0.01
#: bytes of memory of each process
MEMORY = 2 * 2**30


@dataclass(frozen=True)
class Degeneration:
    """The proof that a codimension is infinite: a locus whose zeros have at least a dimension at the origin.

    ``locus`` is what it is as plain data, ``proof`` the certificate of its dimension.

    >>> from osculant.cas.germs.groups import group
    >>> found = Geometry(Germ("x**2*y**2", "x y"), group("R")).result(20)
    >>> print(found)
    the points where the generators do not span have dimension 1 or more
    """

    locus: dict[str, Any]
    least: int
    proof: dict[str, Any]

    def certificate(self) -> dict[str, Any]:
        """What an independent checker needs."""
        return {
            "kind": "locus",
            "sentence": f"{self}.",
            "locus": self.locus,
            "dimension": self.least,
            "zeros": self.proof,
        }

    def __str__(self) -> str:
        kind = self.locus["kind"]
        where = ", restricted to the boundary," if self.locus.get("restricted") else ""
        where = " on the boundary" if self.locus.get("boundary") else where
        parts = ", ".join(map(str, self.locus.get("parts", ())))
        multiple = "singular multiple points" if self.locus.get("singular") else "multiple points"
        texts = {
            "module": "the points where the generators do not span",
            "rank": f"the points{where} where df has rank {self.locus.get('rank')} or less",
            "singular": f"the singular points{where} of the critical set",
            "folds": f"the points{where} where the germ on its critical set is no immersion",
            "double": f"the pairs of points{where} with one image ({self.locus.get('of')})",
            "multiple": f"the {multiple}{where} of type {parts}",
            "together": f"the {multiple} of types {parts} of the branches "
            f"{', '.join(map(str, self.locus.get('branches', ())))} with one image",
        }
        return f"{texts[kind]} have dimension {self.least} or more"


class Geometry:
    """The search for a proof that a codimension is infinite, beside other work.

    Args:
        germ: the germ.
        group: the group.
        kinds: the kinds of loci that are tried; all of them by default.

    It begins when `start` or `result` is called first, and ends with `stop` or with this object.
    """

    #: what the process runs
    module = "osculant.cas.germs.geometry"

    def __init__(self, germ: Germ, group: Group, kinds: tuple[str, ...] = ()) -> None:
        self.germ, self.group, self.kinds = germ, group, kinds
        self.process: subprocess.Popen[bytes] | None = None
        self.answer: Degeneration | None = None
        self.over = False
        self.cost: Cost | None = None
        self.question: IO[bytes] | None = None

    @property
    def running(self) -> bool:
        """Whether the process beside takes time."""
        return self.process is not None and not self.over

    def told(self) -> dict[str, Any] | None:
        """What the process is told, as plain data; None if nothing can be looked for."""
        return told(self.germ, self.group, self.kinds)

    def start(self) -> None:
        """Begin, if it has not begun."""
        if self.process is not None or self.over:
            return
        given = self.told()
        if given is None:
            self.over = True
            return
        path = os.pathsep.join(p for p in sys.path if p)
        self.process = subprocess.Popen(
            [sys.executable, "-m", self.module],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={**os.environ, "PYTHONPATH": path},
            start_new_session=True,  # so that it can be ended together with its child
        )
        self.cost = counted(self.process.pid)
        assert self.process.stdin is not None
        self.question = self.process.stdin
        with suppress(OSError):
            self.question.write(json.dumps(given).encode() + b"\n")
            self.question.flush()
        self.process.stdin = (
            None  # `communicate` shall only read, and it stays open: see `processes.question`
        )

    def result(self, seconds: float) -> Degeneration | None:
        """The proof, if there is one after so many seconds at most; None else, and then `over` tells more.

        ``over`` is True if all loci were tried to the end, or none can be.
        """
        self.start()
        if self.over or self.process is None:
            return self.answer
        with suppress(subprocess.TimeoutExpired):
            text, _ = self.process.communicate(timeout=max(seconds, SHORT))
            self.over = True
            told = json.loads(text) if text.strip() else {"seconds": None, "proof": None}
            if self.cost is not None:
                self.cost.ended(told["seconds"])
            if (found := told["proof"]) is not None:
                self.answer = Degeneration(found["locus"], found["dimension"], found["zeros"])
        return self.answer

    def stop(self) -> None:
        """End the search."""
        if self.process is None:
            return
        if self.cost is not None:
            self.cost.ended()
        if self.process.poll() is None:
            with suppress(ProcessLookupError, PermissionError):
                if hasattr(os, "killpg"):
                    os.killpg(self.process.pid, signal.SIGKILL)  # C code does not hear anything less
                else:
                    self.process.kill()
            self.process.wait()
        for pipe in (self.process.stdout, self.question):
            if pipe is not None:
                with suppress(OSError):
                    pipe.close()

    def __del__(self) -> None:
        with suppress(Exception):
            self.stop()


def told(germ: Germ, group: Group, kinds: tuple[str, ...]) -> dict[str, Any] | None:
    """A germ, a group and kinds of loci as plain data; None for a germ that cannot be told."""
    jet = germ.polynomial(poly.LARGEST)
    nodes = germ.components if jet is None else tuple(as_node(f, germ.source, germ.field) for f in jet)
    try:
        texts = [to_text(node) for node in nodes]
    except OsculantError:
        return None
    polynomials = None
    if jet is not None and germ.field is None:
        polynomials = [[[*poly.exponents_of(m, germ.n), str(c)] for m, c in f.items()] for f in jet]
    return {
        "components": texts,
        "polynomials": polynomials,
        "source": list(germ.source),
        "root": None if germ.field is None else germ.field.text,
        "boundary": germ.boundary,
        "group": [group.name, group.source, group.target, list(group.fields)],
        "kinds": list(kinds),
    }


def prove(germ: Germ, group: Group, kinds: tuple[str, ...] = ()) -> Degeneration | None:
    """The proof, sought in this process for as long as it takes: called in one that can be ended."""
    model = model_of(germ)
    if model is None:
        return None
    boundary = germ.boundary_index if group.source == "boundary" else None
    waiting = list(loci(model, group.source, group.target, boundary, group.generators(germ)))
    return in_rounds([locus for locus in waiting if not kinds or locus.kind["kind"] in kinds], model.field)


def in_rounds(waiting: list[Locus], field: NumberField | None) -> Degeneration | None:
    """The proof by one of the loci, each tried for a short time first and then for longer and longer."""
    seconds = SLICE
    while waiting and seconds < LONGEST:
        late = []
        for locus in waiting:
            zeros, done = _in_a_child(locus, field, seconds)
            if zeros is not None:
                more = {"functions": locus.functions} if locus.functions else {}
                return Degeneration({**locus.kind, **more}, locus.least, zeros)
            if not done:
                late.append(locus)
        waiting, seconds = late, seconds * MORE
    return None


def _zeros(locus: Locus, field: NumberField | None) -> dict[str, Any] | None:
    try:
        context, generators = locus.make()
    except ValueError:
        return None
    return large_zeros(context, generators, locus.least + locus.functions, locus.apart, field)


def _in_a_child(
    locus: Locus, field: NumberField | None, seconds: float
) -> tuple[dict[str, Any] | None, bool]:
    """(the certificate or None, whether it came to an end) for one locus."""
    if not hasattr(os, "fork"):
        return _zeros(locus, field), True
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        signal.setitimer(signal.ITIMER_REAL, seconds)  # its signal ends the child, C code or not
        status = 1
        try:
            with os.fdopen(writing, "w") as pipe:
                json.dump(_zeros(locus, field), pipe)
            status = 0
        finally:
            os._exit(status)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        text = pipe.read()
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return None, os.WTERMSIG(status) != signal.SIGALRM
    return (json.loads(text) if status == 0 and text else None), True


def bounded() -> None:
    """No process here may take much memory, or live on for long."""
    with suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (int(LONGEST), int(LONGEST)))


def main() -> None:
    """Read a germ and a group from standard input; print the processor time taken, and the proof or null."""
    bounded()
    read = question()
    name, source, target, fields = read["group"]
    print_proof(prove(germ_of(read), Group(name, source, target, tuple(fields)), tuple(read["kinds"])))


def print_proof(found: Degeneration | None) -> None:
    """Print the processor time of this process and its children, and the proof or null."""
    proof = None if found is None else found.certificate()
    json.dump({"seconds": sum(os.times()[:4]), "proof": proof}, sys.stdout)


def germ_of(read: dict[str, Any]) -> Germ:
    """The germ that `told` tells."""
    from fractions import Fraction

    if read["polynomials"] is None:
        field = None if read["root"] is None else NumberField.stated(read["root"])
        names = [*read["source"], *(() if field is None else (str(field.name),))]
        nodes = parse_tuple(", ".join(read["components"]), names, FILE)
        return Germ(nodes, read["source"], read["boundary"], field)
    components = [
        as_node({poly.monomial(term[:-1]): Fraction(term[-1]) for term in f}, tuple(read["source"]))
        for f in read["polynomials"]
    ]
    return Germ(components, read["source"], read["boundary"])


if __name__ == "__main__":
    main()
