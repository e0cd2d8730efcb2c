"""The command ``osculant germ``."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Annotated, Any

import typer

from osculant.cli import germ_kinds
from osculant.cli.germ_rows import certificate_rows, head, listed, rows, versality_rows
from osculant.cli.grammar import FormulaCommand, UsageError
from osculant.cli.options import AsJson, formulas_of, number, whole_number
from osculant.cli.output import WIDEST, Waiting, output_width, print_json, print_rows

if TYPE_CHECKING:
    from osculant.germs.map_germ import MapGerm

Formulas = Annotated[
    str,
    typer.Argument(
        metavar="FORMULA",
        help='The components, such as "x, x*y + y^3", which vanish at 0; or @FILE, a file that holds them. '
        "Branches of a multigerm stand between semicolons.",
    ),
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
Root = Annotated[
    str | None,
    typer.Option(
        "--root",
        metavar="POLYNOMIAL",
        help='A polynomial such as "a^2 - a - 1": a is a root of it in the formulas, any one.',
    ),
]
Certificate = Annotated[
    bool,
    typer.Option("--certificate", help="Print the certificates as well, with --json for `osculant check`."),
]

At = Annotated[
    str | None,
    typer.Option(
        "--at", metavar="A,B,...", help='The point of the germ, if not 0, such as "1,-1/2"; moved to 0.'
    ),
]
Versal = Annotated[
    str | None,
    typer.Option(
        "--versal",
        metavar="NAMES",
        help="Read the germ as an unfolding with these parameters, and tell whether it is versal.",
    ),
]
Parameters = Annotated[
    str | None,
    typer.Option(
        "--parameters",
        metavar="NAMES",
        help="Read the germ as a family with these parameters: the codimension by their values.",
    ),
]
Preserving = Annotated[
    str | None,
    typer.Option(
        "--preserving",
        metavar="H",
        help="Source changes preserve the hypersurface H = 0: the group R(V), K(V) or A(V), by --group; by "
        "default R(V) for a function, else K(V).",
    ),
]
WithInvariants = Annotated[
    bool,
    typer.Option(
        "--invariants", help="Print δ, cusps, cross-caps, triple points, Milnor numbers and the like."
    ),
]
Even = Annotated[
    str | None,
    typer.Option(
        "--even",
        metavar="NAME",
        help="A variable in which the germ is even: its square is the boundary variable u, and A, R, K are "
        "those of even germs.",
    ),
]
Latex = Annotated[bool, typer.Option("--latex", help="Print LaTeX.")]

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
    at: At = None,
    root: Root = None,
    even: Even = None,
    transversal: Transversal = None,
    order: Order = None,
    versal: Versal = None,
    parameters: Parameters = None,
    preserving: Preserving = None,
    with_invariants: WithInvariants = False,
    patience: Patience = "10",
    certificate: Certificate = False,
    latex: Latex = False,
    as_json: AsJson = False,
) -> None:
    """Print a map-germ's codimension, determinacy, stability, unfolding and algebras, exactly.

    The target coordinates are y1, y2, ...; an unfolding adds parameters times the terms printed.
    """
    if source is None:
        raise UsageError('The source variables are missing: give their names, such as --source "x y".')
    if order is not None and transversal is None:
        raise UsageError("The option --order needs --transversal: it names coordinates for it.")
    if versal is not None and transversal is not None:
        raise UsageError("The options --versal and --transversal ask two things: leave out one of them.")
    if latex and (versal is not None or transversal is not None or certificate):
        raise UsageError(
            "The option --latex writes the answers alone: leave out --certificate, --versal, --transversal."
        )

    from osculant.germs import map_germ

    formulas = formulas_of(formula)
    seconds = number(patience, "--patience")
    special = {
        "--preserving": preserving,
        "--at": at,
        "--root": root,
        "--even": even,
        "--transversal": transversal,
        "--versal": versal,
        "--certificate": certificate,
    }
    special |= {"--latex": latex, "--invariants": with_invariants}
    if parameters is not None:
        with Waiting("computing"):
            data = germ_kinds.of_family(formulas, source, parameters, boundary, group, seconds, special)
        _print(data, germ_kinds.family_rows(data), as_json)
        return
    if germ_kinds.branched(formulas):
        special |= {"--group": group, "--boundary": boundary}
        with Waiting("computing"):
            data = germ_kinds.of_multigerm(formulas, source, seconds, special)
        _print(data, germ_kinds.multigerm_rows(data), as_json)
        return
    given = map_germ.germ(formulas, source, boundary, at=at, root=root, even=even, patience=seconds)
    acting: Any = group
    if preserving is not None:
        germ_kinds.refuse(
            {"--certificate": certificate, "--even": even}, "The group of a hypersurface (--preserving)"
        )
        from osculant.germs.hypersurface import preserving as of_hypersurface

        kind = group or ("R" if given.target == 1 else "K")
        acting = of_hypersurface(preserving, source, kind, patience=seconds)
    if transversal is not None:
        data = _transversal(given, whole_number(transversal, "--transversal"), acting, order or ())
        table = [*head(data), *listed(f"{data['jet'] + 1}-transversal", data["transversal"])]
    elif versal is not None:
        data = _versality(given, versal, acting)
        table = list(versality_rows(data))
    else:
        from osculant.germs.report import report

        with Waiting("computing") as progress:
            data = report(given, acting, progress)
        if as_json and certificate:
            data = {"kind": "germ", "version": 1, **data}  # a certificate file
        table = [*rows(data), *(certificate_rows(data["certificate"]) if certificate else ())]
        if with_invariants:
            data["invariants"] = given.invariants()
            table += germ_kinds.invariant_rows(data["invariants"])
    if latex:
        from osculant.germs.latex import report_latex

        print("\n".join(report_latex(given, data)))
    else:
        _print(data, table, as_json)


def _print(data: dict[str, Any], table: Iterable[tuple[str, str]], as_json: bool) -> None:
    if as_json:
        print_json(data)
    else:
        print_rows(table, MARGIN, min(output_width(), WIDEST) if sys.stdout.isatty() else None)


def _described(given: MapGerm, group: Any) -> dict[str, Any]:
    from osculant.germs.even import even_data

    described = {
        "source": list(given.source),
        "target": given.target,
        "components": list(given.components),
        "boundary": given.boundary,
        "group": given.group(group).name,
    }
    if given.even is not None:
        described["even"] = even_data(given, given.group(group))
    return described if given.at is None else {**described, "at": list(given.at)}


def _transversal(given: MapGerm, k: int, group: Any, order: Any) -> dict[str, Any]:
    found = list(given.transversal(k, group, order))
    return {**_described(given, group), "jet": k, "transversal": found}


def _versality(given: MapGerm, parameters: str, group: Any) -> dict[str, Any]:
    f, found = given.versality(parameters, group)
    return {
        **_described(f, group),
        "parameters": parameters.replace(",", " ").split(),
        "extended_codimension": found.codimension,
        "versal": found.versal,
        "reached": found.reached,
        "missing": [f.term(term) for term in found.missing],
    }
