"""What a claim is: a numbered statement, the check that could refute it, and forms of it that must fail.

A check is a function of a *form*, a text such as ``"cbrt(kappa)"``. The same check runs on the form that is
claimed, on the form the thesis prints where that is an erratum (it must fail), and, in the tests, on forms
made wrong on purpose (they must fail too): so no claim is one that cannot fail.
"""

from __future__ import annotations

import inspect
import re
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from importlib import import_module
from typing import Any

from osculant.cas.errors import DomainError, UndecidedError


class Method(StrEnum):
    """How a claim is checked, the strongest way first."""

    PROOF = "symbolic proof"
    EXACT = "exact computation"
    ENCLOSURE = "certified enclosure"
    NUMERICAL = "numerical evidence"


class Verdict(StrEnum):
    """The outcome: as printed, as corrected (the printed form fails), open (evidence only), or refuted."""

    HOLDS = "holds"
    CORRECTED = "corrected"
    OPEN = "open"
    FAILS = "fails"


@dataclass(frozen=True)
class Evidence:
    """Whether a form passed its check, and the certificate: lines that say what was computed.

    >>> bool(Evidence(True, ("difference 0",)))
    True
    """

    holds: bool
    certificate: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return self.holds

    def __and__(self, other: Evidence) -> Evidence:
        """Both: the certificates one after the other."""
        return Evidence(self.holds and other.holds, self.certificate + other.certificate)


Check = Callable[[str], Evidence]


@dataclass(frozen=True)
class Claim:
    """A numbered statement of the thesis, or one that goes beyond it, with its check.

    Args:
        name: "lemma 2.2.1", "(2.12)"; reconstructed statements are "R4.5-1", extensions "X3.8-1".
        statement: the statement in one sentence, in our words.
        method: how it is checked.
        check: decides a form; its docstring is the derivation.
        form: the form claimed.
        printed: the form the thesis prints, where that is wrong.
        wrong: forms made wrong on purpose, at least one.
        reason: for numerical evidence, why no proof is given.
        erratum: what is wrong in print, in one sentence; for the list of errata.
        open: whether the statement stays a conjecture even if the evidence supports it.
        slow: whether the check takes more than a few seconds; left out unless asked for.
        uncertain: whether the printed form is the reading of a damaged text, one that loses large brackets,
            tall bars and overlines, so that the erratum may be the damage's and not the thesis's.
        given: the names of the claims that the check takes for granted.
        own: whether the printed form is not the thesis's but what this project claimed earlier.
    """

    name: str
    statement: str
    method: Method
    check: Check
    form: str
    printed: str | None = None
    wrong: tuple[str, ...] = ()
    reason: str = ""
    erratum: str = ""
    open: bool = False
    slow: bool = False
    uncertain: bool = False
    given: tuple[str, ...] = ()
    own: bool = False

    @property
    def chapter(self) -> str:
        """The chapter or appendix: the first number or letter after the kind of statement."""
        found = re.search(r"\d+|[A-Z](?=\.)", self.name)
        return found.group(0) if found else ""

    @property
    def derivation(self) -> str:
        """The docstring of the check, a line for each of its paragraphs."""
        paragraphs = re.split(r"\n\s*\n", inspect.getdoc(self.check) or "")
        return "\n".join(" ".join(paragraph.split()) for paragraph in paragraphs)

    def to_json(self) -> dict[str, Any]:
        """Plain data: what is known before the check is run."""
        return {
            "id": self.name,
            "chapter": self.chapter,
            "statement": self.statement,
            "method": str(self.method),
            "reason": self.reason or None,
            "form": self.form,
            "printed": self.printed,
            "corrected": self.form if self.printed is not None else None,
            "erratum": self.erratum or None,
            "wrong": list(self.wrong),
            "open": self.open,
            "slow": self.slow,
            "uncertain": self.uncertain,
            "given": list(self.given),
            "own": self.own,
            "derivation": self.derivation,
        }

    def __reduce__(self) -> tuple[Callable[[str, str], Claim], tuple[str, str]]:
        """Travel to another process by name: the check is found there again."""
        return _recalled, (self.check.__module__, self.name)


@dataclass(frozen=True)
class Judgement:
    """A claim's verdict, with the certificates and the time it took."""

    claim: Claim
    verdict: Verdict
    evidence: Evidence
    against_printed: Evidence | None
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """Plain data: that of the claim, and verdict, certificate, against_printed, seconds."""
        against = self.against_printed
        return {
            **self.claim.to_json(),
            "verdict": str(self.verdict),
            "certificate": list(self.evidence.certificate),
            "against_printed": None if against is None else list(against.certificate),
            "seconds": round(self.seconds, 3),
        }


def judge(claim: Claim) -> Judgement:
    """Run a claim's check on the form claimed and, for an erratum, on the printed form, which must fail.

    A check that gives up (UndecidedError) leaves its claim open; one that breaks down fails it, and the
    certificate names the exception.

    >>> five = Claim("(0.1)", "2 + 3 = 5", Method.EXACT, lambda form: Evidence(int(form) == 2 + 3), "5", "6")
    >>> judge(five).verdict
    <Verdict.CORRECTED: 'corrected'>
    """
    start = time.perf_counter()
    against_printed = None
    try:
        evidence = claim.check(claim.form)
        if claim.printed is not None:
            against_printed = claim.check(claim.printed)
        verdict = _verdict(claim, evidence, against_printed)
    except UndecidedError as gave_up:
        evidence, verdict = Evidence(False, (f"undecided: {gave_up}",)), Verdict.OPEN
    except Exception as broken:
        evidence = Evidence(False, (f"the check broke down with {type(broken).__name__}: {broken}",))
        verdict = Verdict.FAILS
    return Judgement(claim, verdict, evidence, against_printed, time.perf_counter() - start)


def _verdict(claim: Claim, evidence: Evidence, against_printed: Evidence | None) -> Verdict:
    if not evidence or against_printed:  # an "erratum" whose printed form passes is no erratum
        return Verdict.FAILS
    if claim.open:
        return Verdict.OPEN
    return Verdict.HOLDS if against_printed is None else Verdict.CORRECTED


_REGISTRY: dict[str, Claim] = {}


def claim(
    name: str,
    statement: str,
    *,
    method: Method,
    form: str,
    wrong: Sequence[str],
    printed: str | None = None,
    reason: str = "",
    erratum: str = "",
    open: bool = False,
    slow: bool = False,
    uncertain: bool = False,
    given: Sequence[str] = (),
    own: bool = False,
) -> Callable[[Check], Check]:
    """Register the decorated check as a claim; the arguments are those of `Claim`.

    Raises DomainError for a claim that could not fail (no wrong form), numerical evidence without a reason,
    an erratum without its sentence, an uncertain print or an earlier form of our own where none is stated, or
    a name used twice.
    """
    if uncertain and printed is None:
        raise DomainError(f"Claim {name!r} is uncertain of a printed form it does not state: add it.")
    if own and printed is None:
        raise DomainError(f"Claim {name!r} states no earlier form of our own: add it as printed.")
    if not wrong or (method is Method.NUMERICAL and not reason) or (printed is not None and not erratum):
        raise DomainError(f"Claim {name!r} lacks a wrong form, its reason or its erratum: add it.")

    def register(check: Check) -> Check:
        if name in _REGISTRY:
            places = f"{_REGISTRY[name].check.__module__} and {check.__module__}"
            raise DomainError(f"Claim {name!r} is registered twice, in {places}: rename one.")
        _REGISTRY[name] = Claim(
            name=name,
            statement=statement,
            method=method,
            check=check,
            form=form,
            printed=printed,
            wrong=tuple(wrong),
            reason=reason,
            erratum=erratum,
            open=open,
            slow=slow,
            uncertain=uncertain,
            given=tuple(given),
            own=own,
        )
        return check

    return register


def registered() -> dict[str, Claim]:
    """The claims of the modules imported so far, by name."""
    return dict(_REGISTRY)


def _recalled(module: str, name: str) -> Claim:
    """A registered claim by name, its module imported if need be."""
    if name not in _REGISTRY:
        import_module(module)
    if name not in _REGISTRY:  # the check was made in another module than the one that registers it
        import_module("osculant.cas.claims").all_claims()
    return _REGISTRY[name]
