"""Running claims: two processes, a verdict for each claim, whatever happens to a check."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from dataclasses import dataclass
from queue import SimpleQueue
from time import perf_counter
from typing import Any, overload

from osculant.cas.claims import (
    Claim,
    Evidence,
    Judgement,
    Method,
    Verdict,
    judge,
    means,
    registered,
    select,
)
from osculant.cas.errors import DomainError

#: processes that check claims at the same time
PROCESSES = 2
#: seconds in which a process that closed its output may end by itself
PARTING = 5.0
#: how a worker is started; -P keeps the current folder off its path
WORKER = ("-P", "-c", "from osculant.thesis.verification import serve; serve()")


@dataclass(frozen=True)
class Verification(Sequence[Judgement]):
    """Judgements in the order of the thesis, and what was left out because it is slow.

    >>> from osculant.cas.claims import Method
    >>> five = Claim("(0.1)", "2 + 3 = 5", Method.EXACT, lambda form: Evidence(form == str(2 + 3)), "5")
    >>> done = Verification((judge(five),), (), 0.25)
    >>> done, done.failed, done[0].verdict
    (<Verification: 1 hold, 0 corrected, 0 open, 0 fail; 0.25 s>, (), <Verdict.HOLDS: 'holds'>)
    """

    judgements: tuple[Judgement, ...]
    left_out: tuple[Claim, ...]
    seconds: float

    @overload
    def __getitem__(self, index: int) -> Judgement: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Judgement]: ...
    def __getitem__(self, index: int | slice) -> Judgement | Sequence[Judgement]:
        return self.judgements[index]

    def __len__(self) -> int:
        return len(self.judgements)

    def __iter__(self) -> Iterator[Judgement]:
        return iter(self.judgements)

    def __repr__(self) -> str:
        return f"<Verification: {self.summary}>"

    @property
    def counts(self) -> dict[Verdict, int]:
        """How many claims got each verdict."""
        found = Counter(judgement.verdict for judgement in self)
        return {verdict: found[verdict] for verdict in Verdict}

    @property
    def failed(self) -> tuple[Judgement, ...]:
        """The claims refuted, or whose check broke down."""
        return tuple(judgement for judgement in self if judgement.verdict is Verdict.FAILS)

    @property
    def summary(self) -> str:
        """The counts, how many of those that hold rest on numerical evidence, and the time, in one line."""
        words = {Verdict.HOLDS: "hold", Verdict.FAILS: "fail"}
        parts = [
            f"{count} {words.get(verdict, verdict)}{self._by_evidence(verdict)}"
            for verdict, count in self.counts.items()
        ]
        slow = f"; {len(self.left_out)} slow left out" if self.left_out else ""
        return f"{', '.join(parts)}{slow}; {self.seconds:.3g} s"

    def _by_evidence(self, verdict: Verdict) -> str:
        found = sum(rests_on_evidence(j.claim) for j in self if j.verdict is verdict)
        established = verdict in (Verdict.HOLDS, Verdict.CORRECTED)
        return f" ({found} by numerical evidence)" if found and established else ""

    def to_json(self) -> list[dict[str, Any]]:
        """Plain data, a claim each: id, statement, verdict, method, printed, corrected, seconds and more."""
        return [judgement.to_json() for judgement in self]


def rests_on_evidence(claim: Claim) -> bool:
    """Whether a claim is checked by numerical evidence, or takes one for granted that is.

    >>> rests_on_evidence(Claim("(0.1)", "", Method.PROOF, lambda form: Evidence(True), "5"))
    False
    """
    known, waiting, seen = registered(), [claim], set()
    while waiting:
        one = waiting.pop()
        if one.method is Method.NUMERICAL:
            return True
        seen.add(one.name)
        waiting += [known[name] for name in one.given if name in known and name not in seen]
    return False


def verify(
    *names: str,
    chapter: str | int | None = None,
    slow: bool = False,
    progress: Callable[[float], None] | None = None,
) -> Verification:
    """Check numbered statements of the thesis, and those beyond it, by machine.

    Every claim is checked in the form that is claimed and, where the thesis is wrong in print, in the printed
    form, which must fail.  A check that crashes, raises or takes its process with it fails its claim alone.

    Args:
        names: "lemma 3.5.1" or "3.5.1", "(3.17)", "R4.5-1", sections such as "3.5"; nothing or "all" for all.
        chapter: only claims of this chapter or appendix: 3, "A".
        slow: also check claims marked slow; without it only those that are named in full.
        progress: called after each claim with the part that is done, 0…1.

    Returns the judgements in the order of the thesis.

    Raises DomainError for a name or chapter that selects nothing, and for a section given as a chapter.

    >>> import osculant as osc
    >>> osc.verify("Riemann")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: No claim is called 'Riemann': osculant.cas.claims.all_claims() shows the
    names.
    """
    return check(*chosen(names, chapter, slow), progress)


def chosen(
    names: Sequence[str], chapter: str | int | None, slow: bool
) -> tuple[tuple[Claim, ...], tuple[Claim, ...]]:
    """The claims selected, in two lots: those to check and the slow ones to leave out; "all" wins."""
    wanted = None if chapter is None else str(chapter).strip()
    if wanted is not None and "." in wanted:
        raise DomainError(f"{wanted} is a section, not a chapter: name it alone, `osculant verify {wanted}`.")
    everything = any(name.strip().lower() == "all" for name in names)
    selected = select(() if everything else names, wanted)
    left_out = tuple(c for c in selected if c.slow and not slow and not any(means(n, c) for n in names))
    return tuple(claim for claim in selected if claim not in left_out), left_out


def check(
    claims: Sequence[Claim], left_out: Sequence[Claim] = (), progress: Callable[[float], None] | None = None
) -> Verification:
    """Check claims in `PROCESSES` worker processes; the judgements come in the order of the claims."""
    began = perf_counter()
    judgements = _judged(claims, progress)
    return Verification(judgements, tuple(left_out), perf_counter() - began)


def _judged(claims: Sequence[Claim], progress: Callable[[float], None] | None) -> tuple[Judgement, ...]:
    workers = [_Worker() for _ in range(min(PROCESSES, len(claims)))]
    idle: SimpleQueue[_Worker] = SimpleQueue()
    for worker in workers:
        idle.put(worker)

    def task(claim: Claim) -> Judgement:
        worker = idle.get()
        try:
            return worker.judge(claim)
        finally:
            idle.put(worker)

    pool = ThreadPoolExecutor(PROCESSES)  # a thread waits for each worker
    try:
        futures = [pool.submit(task, claim) for claim in claims]
        for done, _ in enumerate(as_completed(futures), 1):
            if progress is not None:
                progress(done / len(futures))
        return tuple(future.result() for future in futures)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for worker in workers:
            worker.end()


class _Worker:
    """A process that checks one claim after another; started when needed, and again after it died.

    Not a `ProcessPoolExecutor`: that cannot say which claim killed a process, gives all others up with it,
    and runs the caller's script again in each process.
    """

    def __init__(self) -> None:
        self.process: subprocess.Popen[bytes] | None = None

    def judge(self, claim: Claim) -> Judgement:
        """The worker's judgement; if the process dies over it, the claim fails."""
        began = perf_counter()
        if self.process is None:
            self.process = _start()
        process = self.process
        assert process.stdin is not None and process.stdout is not None
        try:
            pickle.dump(claim, process.stdin)
            process.stdin.flush()
            judgement: Judgement = pickle.load(process.stdout)
            return judgement
        except (EOFError, OSError, pickle.PickleError):
            with suppress(subprocess.TimeoutExpired):
                process.wait(PARTING)
            self.end()
            line = f"the process that checked it ended {_manner(process.returncode)}"
            return Judgement(claim, Verdict.FAILS, Evidence(False, (line,)), None, perf_counter() - began)

    def end(self) -> None:
        """End the process, working or not."""
        process, self.process = self.process, None
        if process is not None:
            with suppress(OSError):
                process.kill()
            process.wait()
            for pipe in (process.stdin, process.stdout):
                with suppress(OSError):
                    pipe.close()  # type: ignore[union-attr]


def _manner(status: int) -> str:
    """How a process ended.

    >>> _manner(3), _manner(-11)
    ('with status 3', 'by signal 11')
    """
    return f"by signal {-status}" if status < 0 else f"with status {status}"


def _start() -> subprocess.Popen[bytes]:
    path = os.pathsep.join(entry or os.getcwd() for entry in sys.path)
    quiet = None if os.environ.get("OSCULANT_DEBUG") else subprocess.DEVNULL
    return subprocess.Popen(
        [sys.executable, *WORKER],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=quiet,
        env={**os.environ, "PYTHONPATH": path},
        start_new_session=True,  # Ctrl-C is the parent's to handle
    )


def serve() -> None:
    """Be a worker: read claims from stdin, write judgements to stdout, until stdin ends."""
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what a check prints must not mix with answers
    with suppress(EOFError):
        while True:
            claim = pickle.load(sys.stdin.buffer)
            pickle.dump(judge(claim), answers)
            answers.flush()
