"""The command ``osculant verify``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson
from osculant.cli.output import Waiting, print_json, printable, tell
from osculant.files.writing import check_place

#: exit status if a claim fails
FAILED = 1

Names = Annotated[
    list[str] | None,
    typer.Argument(metavar="ID|all", help='Claims or sections, such as "lemma 2.2.1", 3.17 or 4.3.'),
]
Chapter = Annotated[str | None, typer.Option("--chapter", metavar="N", help="Only this chapter or appendix.")]
Show = Annotated[
    list[str] | None,
    typer.Option("--show", metavar="ID", help="Print a claim's derivation and certificate; repeatable."),
]
Slow = Annotated[bool, typer.Option("--slow", help="Check also what takes more than a few seconds.")]
Listing = Annotated[bool, typer.Option("--list", help="List the claims and check nothing.")]
Errata = Annotated[
    str | None, typer.Option("--errata", metavar="FILE", help="Write the errata as LaTeX (.tex).")
]


def verify(
    names: Names = None,
    chapter: Chapter = None,
    show: Show = None,
    slow: Slow = False,
    listing: Listing = False,
    errata: Errata = None,
    as_json: AsJson = False,
) -> int:
    """Check the statements of the thesis by machine: a verdict for each, status 1 if one fails.

    Without an ID all claims are checked; with --errata alone, those with an erratum.
    """
    wanted = joined([*(names or []), *(show or [])])
    if errata is not None:
        _check_errata(errata)

    from osculant.cli.claims import print_claim, print_list, print_verification
    from osculant.thesis.verification import check, chosen

    claims, left_out = chosen(wanted, chapter, slow or listing)
    if listing:
        if as_json:
            print_json([claim.to_json() for claim in claims])
        else:
            print_list(claims)
        return 0
    if errata is not None and not wanted and chapter is None:
        claims, left_out = (tuple(c for c in some if c.erratum) for some in (claims, left_out))
    if errata is not None and not any(claim.erratum for claim in (*claims, *left_out)):
        raise UsageError(f"Did not write {printable(errata)}: there is no erratum among the selected claims.")
    try:
        with Waiting("verifying", lines=errata is not None) as progress:
            done = check(claims, left_out, progress)
    except KeyboardInterrupt:
        tell("interrupted")
        raise
    if errata is not None:
        from osculant.thesis.errata import write_errata

        write_errata(errata, done)
    if as_json:
        print_json(done.to_json())
    elif show:
        for judgement in done:
            print_claim(judgement)
    else:
        print_verification(done, errata)
    return FAILED if done.failed else 0


def _check_errata(file: str) -> None:
    """Refuse before the work what could not be written after it."""
    if Path(file).suffix.lower() != ".tex":
        raise UsageError(f"Cannot write {file or 'a file without a name'}: the errata need a name in .tex.")
    check_place(file)


def joined(names: Sequence[str]) -> list[str]:
    """Names whose kind of statement came as an argument of its own, put together.

    >>> joined(["lemma", "2.2.1", "(3.17)", "theorem 3.6.1"])
    ['lemma 2.2.1', '(3.17)', 'theorem 3.6.1']
    """
    result: list[str] = []
    kind = ""
    for name in names:
        kind = f"{kind} {name}".strip()
        if re.search(r"\d", name) or len(name) < 2 or kind.lower() == "all":
            result.append(kind)
            kind = ""
    return [*result, kind] if kind else result
