"""The command ``osculant germ``."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from typing import Annotated, Any

import typer

from osculant.cli.grammar import FormulaCommand, UsageError
from osculant.cli.options import AsJson, number, whole_number
from osculant.cli.output import WIDEST, Waiting, output_width, print_json, print_rows

Formulas = Annotated[
    str, typer.Argument(metavar="FORMULA", help='The components, such as "x, x*y + y^3"; they vanish at 0.')
]
Source = Annotated[
    str | None, typer.Option("--source", metavar="NAMES", help='The source variables, such as "x y".')
]
GroupOption = Annotated[
    str | None,
    typer.Option(
        "--group",
        metavar="G",
        help="R, L, C, K, A, R(H), K(H) or A(H); by default A, for a function R, with (H) if there is a "
        "boundary variable.",
    ),
]
Boundary = Annotated[
    str | None,
    typer.Option("--boundary", metavar="NAME", help="The variable that is 0 on H; by default u."),
]
Transversal = Annotated[
    str | None,
    typer.Option("--transversal", metavar="K", help="Print a complete (K+1)-transversal of the K-jet."),
]
Order = Annotated[
    str | None,
    typer.Option(
        "--order",
        metavar="NAMES",
        help="For --transversal: coordinates x, y1, ..., the lightest first; nilpotent fields then help.",
    ),
]
Patience = Annotated[
    str,
    typer.Option(
        "--patience",
        metavar="SECONDS",
        help="Processor time after which what is not decided is said to be undecided.",
    ),
]
Certificate = Annotated[
    bool,
    typer.Option("--certificate", help="Print the certificates as well, with --json for `osculant check`."),
]

#: columns of the names in front of the answers
MARGIN = 22


class GermCommand(FormulaCommand):
    """A command without short options: what begins with a single minus is a formula, such as -x or -x-y."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Hide the minus behind a blank, which formulas allow."""
        return super().parse_args(ctx, [f" {a}" if re.match(r"-[^-]", a) else a for a in args])


def germ(
    formula: Formulas,
    source: Source = None,
    group: GroupOption = None,
    boundary: Boundary = None,
    transversal: Transversal = None,
    order: Order = None,
    patience: Patience = "10",
    certificate: Certificate = False,
    as_json: AsJson = False,
) -> None:
    """Print a map-germ's codimension, determinacy, stability, unfolding and algebras, exactly.

    The target coordinates are y1, y2, ...; an unfolding adds parameters times the terms printed.
    """
    if source is None:
        raise UsageError('The source variables are missing: give their names, such as --source "x y".')
    if order is not None and transversal is None:
        raise UsageError("The option --order needs --transversal: it names coordinates for it.")

    from osculant.germs import map_germ
    from osculant.germs.report import report

    given = map_germ.germ(formula, source, boundary, patience=number(patience, "--patience"))
    if transversal is not None:
        k = whole_number(transversal, "--transversal")
        data: dict[str, Any] = {
            "source": list(given.source),
            "target": given.target,
            "components": list(given.components),
            "boundary": given.boundary,
            "group": given.group(group).name,
            "jet": k,
            "transversal": list(given.transversal(k, group, order or ())),
        }
    else:
        with Waiting("computing") as progress:
            data = report(given, group, progress)
    if as_json:
        if certificate and transversal is None:
            data = {"kind": "germ", "version": 1, **data}  # a certificate file
        print_json(data)
        return
    if transversal is not None:
        table = [*_head(data), *_listed(f"{data['jet'] + 1}-transversal", data["transversal"])]
    else:
        table = [*rows(data), *(certificate_rows(data["certificate"]) if certificate else ())]
    print_rows(table, MARGIN, min(output_width(), WIDEST) if sys.stdout.isatty() else None)


def _head(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    yield "germ", ", ".join(data["components"])
    boundary = "" if data["boundary"] is None else f", boundary {data['boundary']} = 0"
    yield "source", " ".join(data["source"]) + boundary
    yield "group", data["group"]


def _listed(name: str, terms: Sequence[str]) -> Iterator[tuple[str, str]]:
    for place, term in enumerate(terms or ["no terms"]):
        yield "" if place else name, term


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
        if key == "codimension":
            return f"undecided: {reasons[key]}"
        return "undecided" if reasons[key] == reasons.get("codimension") else str(reasons[key])

    yield from _head(data)
    yield "rank", told("rank")
    yield "codimension", told("codimension")
    yield "extended codimension", told("extended_codimension")
    sharpness = f", {'sharp: ' if data['sharp'] else ''}{data['sharpness']}" if data["sharpness"] else ""
    yield "determinacy", told("determinacy") + sharpness
    proof = data["certificate"]["determinacy"]
    if proof is not None and proof["kind"] == "criterion":
        fields = f", nilpotent fields {', '.join(proof['fields'])}" if proof["fields"] else ""
        yield "  proof", f"l = {proof['bound']}, jets of order {proof['order']}{fields}"
    yield "stable", told("stable")
    if data["unfolding"] is None:
        yield "unfolding", told("unfolding")
    else:
        yield from _listed("unfolding", data["unfolding"])
    yield "Tjurina number", told("tjurina")
    if "milnor" in data:
        yield "Milnor number", told("milnor")
    hilbert = "" if data["hilbert"] is None else f", Hilbert function {' '.join(map(str, data['hilbert']))}"
    yield "multiplicity", told("multiplicity") + hilbert
    yield "ramification", told("ramification")


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
