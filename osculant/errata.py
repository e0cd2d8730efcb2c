"""The errata of the thesis as a LaTeX document: printed and correct form, how checked, verdict."""

from __future__ import annotations

import os
import re

from osculant.cas.claims import Claim
from osculant.files import write_whole
from osculant.latex import latex
from osculant.verification import Verification

_HEAD = r"""\documentclass[a4paper]{article}
\usepackage[margin=25mm]{geometry}
\setlength{\parindent}{0pt}
\begin{document}
\raggedright
\section*{Errata}
to S.~Ghosh, \emph{Geometric Approximation of Curves and Singularities of Secant Maps}, Groningen 2010, as
checked by osculant (\texttt{osculant verify}). An erratum is \emph{corrected} if the same check passes on the
correct form and fails on the printed one. Formulas are written as osculant reads them.

"""
_OPENING = r"\begin{description}\setlength{\itemsep}{0pt}\setlength{\parskip}{0pt}"
_TAIL = "\\end{document}\n"


def errata_document(verification: Verification) -> str:
    """A complete LaTeX document, plain ASCII, of the errata among the claims of a verification.

    Args:
        verification: claims without an erratum are passed over; slow ones left out are listed as not checked.

    Returns the text: for each erratum its number, what is wrong, the printed and the correct form, how it was
    checked and the verdict, in the order of the thesis, those not checked last.
    """
    entries = [_entry(judgement.claim, judgement.verdict) for judgement in verification]
    entries += [_entry(claim, "not checked") for claim in verification.left_out]
    return _HEAD + ("\n".join(filter(None, entries)) or "None.\n") + _TAIL


def write_errata(path: str | os.PathLike[str], verification: Verification) -> None:
    """Write `errata_document` to a file; raises OsculantError if it cannot be written."""
    write_whole(path, errata_document(verification))


def _entry(claim: Claim, verdict: str) -> str:
    if not claim.erratum:
        return ""
    rows = [
        ("Stated", latex(claim.statement)),
        ("Erratum", latex(claim.erratum)),
        *([] if claim.printed is None else [("Printed", _formula(claim.printed))]),
        ("Correct", _formula(claim.form)),
        ("Checked by", latex(claim.method + (f": {claim.reason}" if claim.reason else ""))),
        ("Verdict", rf"\textbf{{{verdict}}}"),
    ]
    lines = [rf"\item[{name}] {text}" for name, text in rows]
    title = latex(claim.name[0].upper() + claim.name[1:])
    return "\n".join([rf"\subsection*{{{title}}}", _OPENING, *lines, r"\end{description}", ""])


def _formula(form: str) -> str:
    r"""A form as typed, which may be broken after a sign.

    >>> print(_formula("-k*x**2"))
    \texttt{-\allowbreak{}k*\allowbreak{}x**\allowbreak{}2}
    """
    parts = re.split(r"(?<=[-+/*,])(?!\*)", form)
    broken = r"\allowbreak{}".join(map(latex, parts))
    return rf"\texttt{{{broken}}}"
