"""What ``osculant verify`` prints for people."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from osculant.cas.claims import Claim, Judgement, Verdict
from osculant.cli.output import WIDEST, console, output_width, print_rows, printable

if TYPE_CHECKING:
    from osculant.thesis.verification import Verification

#: how verdicts look on a terminal
STYLES: dict[str, str] = {Verdict.FAILS: "bold red", Verdict.OPEN: "yellow", Verdict.CORRECTED: "cyan"}
#: columns of the names in front of a claim's particulars
MARGIN = 13
#: columns that a statement gets in a table, if need be instead of the columns that can be spared
STATEMENT = 30
#: what an uncertain erratum means
UNCERTAIN = "the print is known from a damaged text, which loses large brackets, tall bars and overlines"


def print_verification(verification: Verification, written: str | None = None) -> None:
    """Print a table of claims, why those that fail do so, and the summary.

    Args:
        verification: what was checked.
        written: a file written meanwhile.
    """
    rows = [
        (j.claim.name, j.verdict, _method(j.claim), f"{j.seconds:5.2f} s", j.claim.statement)
        for j in verification
    ]
    _print_table(("claim", "verdict", "method", "time", "statement"), rows, spare=(2, 3))
    print()
    for judgement in verification.failed:
        for line in why(judgement):
            print(f"{judgement.claim.name} fails: {line}")
    if verification.left_out:
        names = ", ".join(claim.name for claim in verification.left_out)
        print(f"left out, for --slow: {names}")
    if written is not None:
        print(f"written: {printable(written)}")
    print(verification.summary)


def why(judgement: Judgement) -> Sequence[str]:
    """The reasons of a failure: the form claimed does not pass, or the printed form of an erratum does."""
    if judgement.evidence.holds:
        return ("the printed form passes the check, and so is no erratum",)
    return judgement.evidence.certificate or ("the form claimed does not pass the check",)


def print_list(claims: Sequence[Claim]) -> None:
    """Print a table of claims without a verdict."""
    rows = []
    for claim in claims:
        notes = {
            "erratum": claim.erratum and not claim.own,
            "own erratum": claim.own,
            "uncertain": claim.uncertain,
            "open": claim.open,
            "slow": claim.slow,
        }
        marks = ", ".join(word for word, applies in notes.items() if applies)
        rows.append((claim.name, _method(claim), marks, claim.statement))
    _print_table(("claim", "method", "remarks", "statement"), rows, spare=(1, 2))
    print(f"\n{len(claims)} claim{'' if len(claims) == 1 else 's'}")


def print_claim(judgement: Judgement) -> None:
    """Print all there is to know of a claim: statement, verdict, forms, method, derivation, certificate."""
    from osculant.thesis.plain import plain

    claim = judgement.claim
    certificates = [("certificate", "\n".join(judgement.evidence.certificate))]
    if judgement.against_printed is not None:
        against = "as claimed" if claim.own else "as printed"
        certificates.append((against, "\n".join(judgement.against_printed.certificate)))
    forms = [("form", plain(claim.form))]
    if claim.printed is not None:
        earlier = "earlier" if claim.own else "printed"
        forms = [(earlier, plain(claim.printed)), ("corrected", plain(claim.form))]
    rows = [
        ("claim", claim.name),
        ("statement", claim.statement),
        ("verdict", f"{judgement.verdict}, {judgement.seconds:.2f} s"),
        *forms,
        ("erratum", claim.erratum),
        ("uncertain", UNCERTAIN if claim.uncertain else ""),
        ("method", _given(str(claim.method), claim)),
        ("reason", claim.reason),
        ("derivation", claim.derivation),
        *certificates,
    ]
    print_rows([(name, text) for name, text in rows if text], MARGIN, min(output_width(), WIDEST))
    print()


def _method(claim: Claim) -> str:
    """The method in a word, and the claims it rests on.

    >>> from osculant.cas.claims import select
    >>> _method(select(["lemma 2.2.1"])[0])
    'proof'
    """
    return _given(claim.method.name.lower(), claim)


def _given(method: str, claim: Claim) -> str:
    return f"{method}, given {', '.join(claim.given)}" if claim.given else method


def _print_table(titles: Sequence[str], rows: Sequence[Sequence[str]], spare: Collection[int]) -> None:
    """Print rows in columns; what does not fit of the last one is left out, so that each row is a line.

    Args:
        titles: of the columns.
        rows: a text for each column.
        spare: places of columns that are left out where the last one would get less than `STATEMENT`.
    """
    from rich.text import Text

    out = console()
    taken = sum(max(map(len, column)) + 2 for column in list(zip(titles, *rows))[:-1])
    if out.width - taken < STATEMENT:
        titles, *rows = ([cell for i, cell in enumerate(row) if i not in spare] for row in (titles, *rows))
    widths = [max(map(len, column)) for column in zip(titles, *rows)]
    for number, row in enumerate((titles, *rows)):
        line = Text()
        for cell, width in zip(row[:-1], widths):
            line.append(f"{cell:<{width}}  ", style=STYLES.get(cell, "") if number else "bold")
        line.append(row[-1], style="" if number else "bold")
        line.truncate(out.width, overflow="ellipsis")
        out.print(line, soft_wrap=True)
