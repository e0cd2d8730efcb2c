"""The errata of the thesis as a LaTeX document: printed and correct form, how checked, verdict."""

from __future__ import annotations

import os

from osculant.cas.claims import Claim
from osculant.cas.errors import DomainError
from osculant.files.writing import write_whole
from osculant.thesis.latex import formula_latex, latex
from osculant.thesis.verification import Verification

_HEAD = r"""\documentclass[a4paper]{article}
\usepackage[margin=25mm]{geometry}
\setlength{\parindent}{0pt}
\begin{document}
\raggedright
\section*{Errata}
to S.~Ghosh, \emph{Geometric Approximation of Curves and Singularities of Secant Maps}, Groningen 2010, as
checked by osculant (\texttt{osculant verify}). An erratum is \emph{corrected} if the same check passes on the
correct form and fails on the printed one.

"""
_DAMAGED = r"""\section*{Readings of a damaged text}
The text of the thesis at hand lost large brackets, tall bars and overlines. What is wrong in the following
may be wrong in that text alone, and right in the thesis.

"""
_OWN = r"""\section*{Errata of osculant}
These are not of the thesis: osculant itself claimed the form printed here in an earlier version.

"""
_OPENING = r"\begin{description}\setlength{\itemsep}{0pt}\setlength{\parskip}{0pt}"
#: what the wrong form is called, by whether it is our own
_PRINTED = {False: "Form printed", True: "Form claimed earlier"}
_TAIL = "\\end{document}\n"


def errata_document(verification: Verification) -> str:
    """A complete LaTeX document, plain ASCII, of the errata among the claims of a verification.

    Args:
        verification: claims without an erratum are passed over; slow ones left out are listed as not checked.

    Returns the text: for each erratum its number, what is wrong, the printed and the correct form, how it was
    checked and the verdict, in the order of the thesis, those not checked last. Those whose print is
    uncertain have a section of their own, and so have those that are not of the thesis but of osculant.

    Raises DomainError if there is no erratum among the claims.
    """
    found = [(judgement.claim, str(judgement.verdict)) for judgement in verification]
    found += [(claim, "not checked") for claim in verification.left_out]
    found = [(claim, verdict) for claim, verdict in found if claim.erratum]
    if not found:
        raise DomainError("There is no erratum among the selected claims: select others.")
    certain, uncertain, own = (
        "\n".join(_entry(claim, verdict) for claim, verdict in found if _kind(claim) == kind)
        for kind in ("certain", "uncertain", "own")
    )
    parts = [certain, f"{_DAMAGED}{uncertain}" if uncertain else "", f"{_OWN}{own}" if own else ""]
    return _HEAD + "\n".join(part for part in parts if part) + _TAIL


def _kind(claim: Claim) -> str:
    """Whose erratum it is, and whether the print is certain."""
    return "own" if claim.own else "uncertain" if claim.uncertain else "certain"


def write_errata(path: str | os.PathLike[str], verification: Verification) -> None:
    """Write `errata_document` to a file; raises OsculantError as that does, and if it cannot be written."""
    write_whole(path, errata_document(verification))


def _entry(claim: Claim, verdict: str) -> str:
    given = f", given {', '.join(claim.given)}" if claim.given else ""
    rows = [
        ("Correct", latex(claim.statement)),
        ("Erratum", latex(claim.erratum)),
        *([] if claim.printed is None else [(_PRINTED[claim.own], _formula(claim.printed))]),
        ("Form correct", _formula(claim.form)),
        ("Checked by", latex(claim.method + given + (f": {claim.reason}" if claim.reason else ""))),
        ("Verdict", rf"\textbf{{{verdict}}}"),
    ]
    lines = [rf"\item[{name}] {text}" for name, text in rows]
    title = latex(claim.name[0].upper() + claim.name[1:])
    return "\n".join([rf"\subsection*{{{title}}}", _OPENING, *lines, r"\end{description}", ""])


def _formula(form: str) -> str:
    r"""A form as mathematics; one that is no formula as text.

    >>> print(_formula("-k*x**2"), _formula("k monotone"))
    \ensuremath{-k\,x^{2}} k monotone
    """
    return formula_latex(form) or latex(form)
