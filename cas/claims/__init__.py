"""The statements of the thesis, and those beyond it, as claims a machine checks: one module a section."""

from __future__ import annotations

import re
from collections.abc import Sequence
from difflib import get_close_matches
from importlib import import_module
from pkgutil import walk_packages

from osculant.cas.claims.claim import Claim, Evidence, Judgement, Method, Verdict, judge, registered
from osculant.cas.errors import DomainError

__all__ = [
    "Claim",
    "Evidence",
    "Judgement",
    "Method",
    "Verdict",
    "all_claims",
    "judge",
    "means",
    "registered",
    "select",
]

#: near names offered for one that is unknown, and what has all
OFFERED, LISTING = 3, "osculant.cas.claims.all_claims()"


def all_claims() -> tuple[Claim, ...]:
    """Every claim of every module here, in the order of the thesis.

    That is by chapter, appendices last; in a chapter the statements by section, what is reconstructed (R…)
    and what goes beyond (X…) after the printed ones of their section, then the displayed formulas by number.

    >>> all(claim.wrong for claim in all_claims())
    True
    """
    for module in walk_packages(__path__, f"{__name__}."):
        import_module(module.name)  # registers its claims, once
    return tuple(sorted(registered().values(), key=lambda claim: _place(claim.name)))


def select(names: Sequence[str], chapter: str | None = None) -> list[Claim]:
    """The claims named, in the order of the thesis; no names or "all" means all of them.

    A name may leave out the kind ("3.5.1" for "lemma 3.5.1", "2.12" for "(2.12)"), the letter R or X, and
    capitals; the start of a number takes all claims below it ("3.5").

    Args:
        names: of claims or sections.
        chapter: only those of this chapter or appendix, "3" or "A".

    Raises DomainError for a name or chapter that selects nothing; the message offers the nearest names.

    >>> select(["2.2.1"])[0].chapter
    '2'
    >>> select(["Riemann"])
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: No claim is called 'Riemann': osculant.cas.claims.all_claims() shows the
    names.
    """
    known = all_claims()
    chosen = list(known)
    if chapter is not None:
        chosen = [claim for claim in known if claim.chapter.lower() == chapter.strip().lower()]
        if not chosen:
            chapters = ", ".join(dict.fromkeys(claim.chapter for claim in known))
            raise DomainError(f"No claim belongs to chapter {chapter!r}: choose one of {chapters}.")
    if not names or [_plain(name) for name in names] == ["all"]:
        return chosen
    found: set[str] = set()
    for name in names:
        matching = {claim.name for claim in chosen if means(name, claim, below=True)}
        if not matching:
            within = "" if chapter is None else f" in chapter {chapter}"
            raise DomainError(
                f"No claim{within} is called {name!r}: {_offer(name, chosen)}", argument=LISTING
            )
        found |= matching
    return [claim for claim in chosen if claim.name in found]


def means(name: str, claim: Claim, below: bool = False) -> bool:
    """Whether a name, perhaps shortened, denotes a claim, or (``below``) a section or statement around it.

    >>> lemma = Claim("lemma 3.5.1.2", "", Method.PROOF, lambda form: Evidence(True), "")
    >>> means("3.5.1.2", lemma), means("3.5", lemma), means("3.5", lemma, below=True)
    (True, False, True)
    """
    wanted, full = _plain(name), _plain(claim.name)
    number = _number(full)
    aliases = {full, number, number.lstrip("rx")}
    aliases |= {alias.strip("()") for alias in aliases}
    if wanted in aliases:
        return True
    return below and bool(wanted) and any(re.match(rf"{re.escape(wanted)}[.\- ]", alias) for alias in aliases)


def _offer(name: str, claims: Sequence[Claim]) -> str:
    wanted = _plain(name)
    names = {_plain(claim.name): claim.name for claim in claims}
    numbers = {_number(plain): full for plain, full in names.items()}
    near = [claim.name for claim in claims if means(_number(wanted), claim)]  # of another kind
    near += [names[plain] for plain in get_close_matches(wanted, names, OFFERED)]
    near += [numbers[plain] for plain in get_close_matches(_number(wanted), numbers, OFFERED)]
    nearest = [repr(full) for full in dict.fromkeys(near)][:OFFERED]
    return f"did you mean {' or '.join(nearest)}?" if nearest else f"{LISTING} shows the names."


def _plain(name: str) -> str:
    return " ".join(name.split()).lower()


def _number(plain: str) -> str:
    """What follows the kind of statement: from the first word with a digit on."""
    found = re.search(r"\S*\d.*", plain)
    return found.group(0) if found else plain


def _place(name: str) -> tuple[object, ...]:
    """A key that sorts names in the order of the thesis, whatever they are."""
    number = _number(_plain(name))
    origin = "rx".find(number[:1]) + 1 if number else 0  # printed, reconstructed, beyond
    section, _, rest = number.strip("()").lstrip("rx").partition("-")
    parts = [_natural(section), _natural(rest)]
    chapter, *below = parts[0] or ((2, 0, ""),)
    after = ((2, origin, ""),) if origin else ()  # R3.3-1 comes after 3.3.5, before 3.4
    return chapter, name.startswith("("), (*below, *after), parts[1], _plain(name)


def _natural(text: str) -> tuple[tuple[int, int, str], ...]:
    """Numbers by value, before letters."""
    parts = re.findall(r"\d+|[a-z]+", text)
    return tuple((0, int(part), "") if part.isdigit() else (1, 0, part) for part in parts)
