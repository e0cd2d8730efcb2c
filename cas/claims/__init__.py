"""The statements of the thesis, and those beyond it, as claims a machine checks: one module a section."""

from __future__ import annotations

import re
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from osculant.cas.claims.claim import Claim, Evidence, Judgement, Method, Verdict, judge, registered
from osculant.cas.errors import DomainError

__all__ = ["Claim", "Evidence", "Judgement", "Method", "Verdict", "all_claims", "judge", "select"]

#: modules of this package that hold no claims
TOOLS = {"claim", "proof"}


@cache
def all_claims() -> tuple[Claim, ...]:
    """Every claim of every module here, in the order of the thesis.

    >>> all(claim.wrong for claim in all_claims())
    True
    """
    for module in iter_modules(__path__):
        if module.name not in TOOLS:
            import_module(f"{__name__}.{module.name}")
    return tuple(sorted(registered().values(), key=_place))


def select(names: list[str], chapter: str | None = None) -> list[Claim]:
    """The claims named, in the order of the thesis; no names or "all" means all of them.

    A name may leave out the kind ("3.5.1" for "lemma 3.5.1", "2.12" for "(2.12)") and capitals; the start of
    a number takes all claims below it ("3.5"). Raises DomainError for a name or chapter that selects nothing.

    >>> [claim.name for claim in select(["2.2.1"])]
    ['lemma 2.2.1']
    """
    chosen = list(all_claims())
    if chapter is not None:
        chosen = [c for c in chosen if c.chapter.lower() == chapter.strip().lower()]
        if not chosen:
            known = ", ".join(sorted({c.chapter for c in all_claims()}))
            raise DomainError(f"No claim belongs to chapter {chapter!r}: choose one of {known}.")
    if not names or [_plain(n) for n in names] == ["all"]:
        return chosen
    found: set[str] = set()
    for name in names:
        matching = {c.name for c in chosen if _matches(c.name, name)}
        if not matching:
            raise DomainError(f"No claim is called {name!r}: `osculant verify --list` shows the names.")
        found |= matching
    return [c for c in chosen if c.name in found]


def _plain(name: str) -> str:
    return re.sub(r"[()\s]+", " ", name).strip().lower()


def _matches(name: str, wanted: str) -> bool:
    full, wanted = _plain(name), _plain(wanted)
    number = full.split()[-1]
    if wanted in {full, number}:
        return True
    below = number.startswith((wanted + ".", wanted + "-")) or number.lstrip("rx").startswith(
        (wanted + ".", wanted + "-")
    )
    return bool(wanted) and below


def _place(claim: Claim) -> tuple[tuple[int, ...], str]:
    number = _plain(claim.name).split()[-1].lstrip("rx")
    parts = [ord(p) if p.isalpha() else int(p) for p in re.findall(r"\d+|[a-z]", number)]
    return tuple(parts), claim.name
