"""Germs of the tree as text and as germs."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from osculant.cas.classification.starts import OneJet
from osculant.cas.germs.family import Family
from osculant.cas.germs.germ import Germ
from osculant.cas.germs.polynomials import Number
from osculant.cas.recognition.forms import Column

#: what stands before a term: a number, or the name of a parameter
Coefficients = Mapping[Column, "Number | str"]


#: the names of parameters
PARAMETERS = ("a", "b", "c", "d")


def variables(jet: OneJet) -> tuple[str, ...]:
    """The names of the variables: x1, x2, … and u."""
    names = [f"x{i + 1}" for i in range(jet.own)]
    return (*names, "u") if jet.boundary is not None else tuple(names)


def monomial_text(column: Column, names: Sequence[str]) -> str:
    """The monomial of a term.

    >>> monomial_text(((0, 2, 1), 0), ("x1", "x2", "u"))
    'x2**2*u'
    """
    return "*".join(f"{name}**{e}" if e > 1 else name for name, e in zip(names, column[0]) if e)


def germ_text(jet: OneJet, terms: Collection[Column], coefficients: Coefficients | None = None) -> str:
    """The germ with these terms; their coefficients are 1 where none is given."""
    names, given = variables(jet), coefficients or {}
    parts = [""] * jet.p
    for column in sorted(terms, key=lambda c: (c[1], sum(c[0]))):
        c, j = given.get(column, 1), column[1]
        shown = monomial_text(column, names)
        if c in (1, -1):
            sign = "-" if c == -1 else "+"
        else:
            sign, shown = "+", f"({c})*{shown}" if not isinstance(c, str) else f"{c}*{shown}"
        before = f" {sign} " if parts[j] else sign.replace("+", "")
        parts[j] += before + shown
    return ", ".join(part or "0" for part in parts)


def germ_of(jet: OneJet, terms: Collection[Column], coefficients: Coefficients | None = None) -> Germ:
    """The same as a germ."""
    boundary = "u" if jet.boundary is not None else None
    return Germ(germ_text(jet, terms, coefficients), variables(jet), boundary)


def family_of(jet: OneJet, terms: Collection[Column], parameters: Sequence[Column]) -> Family:
    """The family of germs with these terms; some of their coefficients are parameters, the others 1."""
    names = PARAMETERS[: len(parameters)]
    boundary = "u" if jet.boundary is not None else None
    return Family(germ_text(jet, terms, dict(zip(parameters, names))), variables(jet), names, boundary)
