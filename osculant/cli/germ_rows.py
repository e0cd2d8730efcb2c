"""The rows in which ``osculant germ`` tells its answers to people."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from osculant.germs.report import tells_ramification


def head(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows that say which germ, with which variables, for which group."""
    yield "germ", ", ".join(data["components"])
    boundary = "" if data["boundary"] is None else f", boundary {data['boundary']} = 0"
    yield "source", " ".join(data["source"]) + boundary
    if "even" in data:
        even = data["even"]
        name = even["variable"]
        yield "as an even germ", f"{', '.join(even['components'])}, with {data['boundary']} = {name}**2"
    if "at" in data:
        yield "moved from", ", ".join(data["at"])
    if "field" in data:
        name, degree = data["field"]["name"], len(data["field"]["polynomial"]) - 1
        yield "number field", f"of degree {degree}" + ("" if name is None else f", by a root {name}")
    told = (
        f", as {data['even']['group']} of germs even in {data['even']['variable']}" if "even" in data else ""
    )
    yield "group", data["group"] + told


def listed(name: str, terms: Sequence[str]) -> Iterator[tuple[str, str]]:
    """A name with terms, one on a line.

    >>> list(listed("unfolding", ["x", "y"]))
    [('unfolding', 'x'), ('', 'y')]
    """
    for place, term in enumerate(terms or ["no terms"]):
        yield "" if place else name, term


def versality_rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of the answer to --versal."""
    yield from head(data)
    yield "parameters", " ".join(data["parameters"])
    yield "extended codimension", str(data["extended_codimension"])
    yield "versal", "yes" if data["versal"] else f"no: the parameters account for {data['reached']}"
    if data["missing"]:
        yield from listed("missing terms", data["missing"])


def rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of a germ's table, from what `osculant.germs.report.report` returns.

    >>> from osculant.germs.map_germ import germ
    >>> from osculant.germs.report import report
    >>> dict(rows(report(germ("x, x*y + y**3", "x y"))))["determinacy"]
    '3, sharp: x, x*y has the same 2-jet and M^3θ not in its tangent space'
    """
    reasons = data["reason"]

    def told(key: str) -> str:
        value = data[key]
        if value is not None:
            return ("no", "yes")[value] if isinstance(value, bool) else str(value)
        same = key != "codimension" and reasons[key] == reasons.get("codimension")
        return "undecided" if same else f"undecided: {reasons[key]}"

    yield from head(data)
    yield "rank", told("rank")
    yield "codimension", told("codimension")
    yield "extended codimension", told("extended_codimension")
    sharpness = f", {'sharp: ' if data['sharp'] else ''}{data['sharpness']}" if data["sharpness"] else ""
    yield "determinacy", told("determinacy") + sharpness
    proof = data["certificate"]["determinacy"]
    if proof is not None and proof["kind"] == "criterion":
        fields = f", nilpotent fields {', '.join(proof['fields'])}" if proof["fields"] else ""
        yield "  proof", f"l = {proof['bound']}, jets of order {proof['order']}{fields}"
    if data["stable"] is not None or "stable" in data["undecided"]:  # not where it has no meaning
        yield "stable", told("stable")
    yield from unfolding_rows(data, told("unfolding") if "unfolding" in data["undecided"] else None)
    yield "Tjurina number", told("tjurina")
    if "milnor" in data:
        yield "Milnor number", told("milnor")
    hilbert = "" if data["hilbert"] is None else f", Hilbert function {' '.join(map(str, data['hilbert']))}"
    yield "multiplicity", told("multiplicity") + hilbert
    if tells_ramification(data):
        yield "ramification", told("ramification")


def unfolding_rows(data: dict[str, Any], undecided: str | None) -> Iterator[tuple[str, str]]:
    """The terms of a miniversal unfolding, and it as a germ that can be given to the command again."""
    if undecided is not None:
        yield "unfolding", undecided
    elif data["unfolding"] is None:
        yield "unfolding", f"none: {data['reason']['unfolding']}"
    else:
        yield from listed("unfolding", data["unfolding"])
        if data["unfolding"]:
            whole = data["unfolding_germ"]
            yield "  as a germ", ", ".join(whole["components"])
            yield "  its source", " ".join(whole["source"])
            if "even" in data:
                yield "  even", ", ".join(data["even"]["unfolding"])


def certificate_rows(certificate: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows that tell the certificates of the codimensions.

    >>> from osculant.germs.map_germ import germ
    >>> from osculant.germs.report import certificate
    >>> for name, text in certificate_rows(certificate(germ("x**2", "x"))):
    ...     print(name, "|", text)
    T G f | rank 1 of 3 in jets of order 2; contains M^2θ (l = 1); 2 functionals vanish on it:
     | 1: 1
     | x: 1
    T G_e f | rank 1 of 2 in jets of order 1; contains M^1θ (l = 1); a functional vanishes on it:
     | 1: 1
    """
    for name, key in (("T G f", "codimension"), ("T G_e f", "extended_codimension")):
        found = certificate[key]
        if found is None:
            continue
        if found["kind"] == "locus":
            yield name, f"of infinite codimension: {found['sentence']}"
            continue
        count = len(found["functionals"])
        if count:
            yield (
                name,
                (
                    f"rank {found['rank']} of {found['columns']} in jets of order {found['order']}; contains "
                    f"M^{found['depth'] + 1}θ (l = {found['bound']}); "
                    f"{'a functional vanishes' if count == 1 else f'{count} functionals vanish'} on it:"
                ),
            )
        else:
            yield name, f"everything in jets of order {found['order']} (l = {found['bound']})"
        for functional in found["functionals"]:
            yield "", ", ".join(f"{term}: {value}" for term, value in functional.items())
