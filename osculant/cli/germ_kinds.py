"""What ``osculant germ`` tells of multigerms, of families and of invariants: data, and rows for people."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from osculant.cli.germ_rows import listed
from osculant.cli.grammar import UsageError
from osculant.germs.invariants import title
from osculant.germs.reading import text_of


def branched(formulas: Any) -> bool:
    """Whether a germ, or the file that holds it, has branches.

    >>> branched("x, y"), branched("t, 0; 0, t")
    (False, True)
    """
    text = text_of(formulas) if isinstance(formulas, Path) else str(formulas)
    return ";" in text


def of_multigerm(formulas: Any, source: str, patience: float, unwanted: dict[str, Any]) -> dict[str, Any]:
    """The answers about a multigerm; UsageError for options that are not about one."""
    refuse(unwanted, "A multigerm (branches between semicolons)")
    from osculant.germs.multi import multigerm

    if isinstance(formulas, Path):
        formulas = text_of(formulas)
    return multigerm(formulas, source, patience=patience).report()


def of_family(
    formulas: Any,
    source: str,
    parameters: str,
    boundary: str | None,
    group: str | None,
    patience: float,
    unwanted: dict[str, Any],
) -> dict[str, Any]:
    """The answers about a family; UsageError for options that are not about one."""
    refuse(unwanted, "A family (--parameters)")
    from osculant.germs.families import germ_family

    return germ_family(formulas, source, parameters, boundary, patience=patience).report(group)


def refuse(unwanted: dict[str, Any], what: str) -> None:
    """UsageError if one of the options has a value.

    >>> refuse({"--at": None}, "A family")
    """
    for option, value in unwanted.items():
        if value is not None and value is not False:
            raise UsageError(f"{what} has no answer to {option}: leave out that option.")


def multigerm_rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of a multigerm's answers.

    >>> from osculant.germs.multi import multigerm
    >>> dict(multigerm_rows(multigerm("t, 0; t, t^2", "t").report()))["branch 2"]
    't, t**2'
    """
    for i, branch in enumerate(data["branches"], start=1):
        yield f"branch {i}", ", ".join(branch)
    yield "source", " ".join(data["source"])
    yield "group", data["group"]
    yield "ranks", " ".join(map(str, data["ranks"]))
    for key in ("codimension", "extended_codimension"):
        yield key.replace("_", " "), value(data, key)
    sharp = f", sharp: {data['sharpness']}" if data["sharpness"] else ""
    yield "determinacy", value(data, "determinacy") + sharp
    yield "stable", value(data, "stable")
    for key in ("delta", "image_milnor"):
        if key in data:
            yield title(key), value(data, key)


def family_rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of a family's answers: codimensions of general members, then one row a stratum.

    >>> from osculant.germs.families import germ_family
    >>> for row in family_rows(germ_family("a*x^2 + x^3", "x", "a").report()):
    ...     print(*row, sep=" | ")
    family | a*x**2 + x**3
    source | x
    parameters | a
    group | R
    codimension | 1
      where a = 0 | 2
    extended codimension | 1
      where a = 0 | 2
    """
    yield "family", data["components"]
    yield "source", " ".join(data["source"])
    yield "parameters", " ".join(data["parameters"])
    yield "group", data["group"]
    for prefix in ("", "extended_"):
        yield f"{prefix}codimension".replace("_", " "), value(data, f"{prefix}codimension")
        for stratum in data[f"{prefix}exceptional"] or ():
            fixed = [f"{name} = {number}" for name, number in stratum["values"].items()]
            others = [f"{condition} = 0" for condition in stratum["conditions"]][len(fixed) :]
            where = ", ".join([*fixed, *others])
            size = stratum["codimension"]
            told = f"undecided, {stratum['at_least']} or more" if size is None else str(size)
            real = "" if stratum["real"] != 0 else ", no real values"
            yield f"  where {where}", told + real


def invariant_rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of a germ's invariants.

    >>> list(invariant_rows({"cusps": 2, "reason": {}, "undecided": []}))
    [('cusps', '2')]
    """
    names = [name for name in data if name not in {"reason", "undecided"}]
    if not names:
        yield "invariants", "none for these dimensions: they need n at most p, and p at least 2"
    for name in names:
        if name == "liftable" and data[name]:
            yield from listed(title(name), data[name])
        else:
            yield title(name), value(data, name)


def value(data: dict[str, Any], key: str) -> str:
    """An answer as text, or why there is none.

    >>> value({"delta": None, "reason": {"delta": "No time."}, "undecided": ["delta"]}, "delta")
    'undecided: No time.'
    """
    found = data[key]
    if found is None:
        return f"{'undecided' if key in data['undecided'] else 'none'}: {data['reason'][key]}"
    if isinstance(found, bool):
        return ("no", "yes")[found]
    return " ".join(map(str, found)) if isinstance(found, list) else f"{found}"
