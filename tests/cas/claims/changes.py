"""Forms changed by machine: an integer one more, a part's sign, 0, twice it, a thousandth more."""

from __future__ import annotations

import re
from collections.abc import Iterator

from osculant.cas.claims import Claim, Evidence
from osculant.cas.errors import OsculantError
from osculant.cas.formulas.parser import parse_tuple

INTEGER = re.compile(r"(?<![\w.])\d+(?![\w.])")
NAME = re.compile(r"[A-Za-z_]\w*")
FUNCTIONS = {"sqrt", "cbrt", "abs", "exp", "log", "pi", "e"} | {
    kind + name for kind in ("", "a") for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "cot", "atan")
}


def changes(form: str) -> Iterator[tuple[str, str]]:
    """Changed forms, each with the name of the change; of a text that is no formula the integers only.

    >>> [changed for _, changed in changes("a/2")]
    ['a/3', '-(a/2)', '0', '2*(a/2)', '(a/2) + 1/1000']
    """
    for number, found in enumerate(INTEGER.finditer(form)):
        yield f"integer {number}", form[: found.start()] + str(int(found.group()) + 1) + form[found.end() :]
    parts = _parts(form)
    if not _is_formula(form):
        return
    for number, part in enumerate(parts):
        for kind, changed in (
            ("sign", f"-({part})"),
            ("zero", "0"),
            ("twice", f"2*({part})"),
            ("thousandth", f"({part}) + 1/1000"),
        ):
            if part == "0" and kind != "thousandth":
                continue
            yield f"{kind} {number}", ", ".join([*parts[:number], changed, *parts[number + 1 :]])


def accepted(claim: Claim) -> list[str]:
    """The names of the changes that the claim's check lets pass."""
    found = []
    for name, form in changes(claim.form):
        try:
            evidence = claim.check(form)
        except OsculantError:
            continue
        assert isinstance(evidence, Evidence)
        if evidence:
            found.append(name)
    return found


def _parts(form: str) -> list[str]:
    """The texts between commas outside parentheses."""
    parts, depth = [""], 0
    for letter in form:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def _is_formula(form: str) -> bool:
    """Whether the form reads as formulas in whatever names stand in it."""
    names = dict.fromkeys(name for name in NAME.findall(form) if name not in FUNCTIONS)
    try:
        parse_tuple(form, tuple(names))
    except OsculantError:
        return False
    return True
