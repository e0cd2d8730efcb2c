"""The command ``osculant secant``."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Annotated, Any

import typer

from osculant.cli.germ import MARGIN, Patience, Source
from osculant.cli.germ_rows import listed
from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson, formulas_of, number, whole_number
from osculant.cli.output import WIDEST, Waiting, output_width, print_json, print_rows

Immersion = Annotated[
    str,
    typer.Argument(
        metavar="FORMULA",
        help='The components of an immersion, such as "x, y, x^2 + y^3"; or @FILE, a file that holds them.',
    ),
]
At = Annotated[
    str | None,
    typer.Option(
        "--at", metavar="A,B,...", help="The point, in exact numbers such as 1/2 or sqrt(2); by default 0."
    ),
]
Direction = Annotated[
    str | None,
    typer.Option(
        "--direction", metavar="A,B,...", help="The direction in the source; of a curve there is one."
    ),
]
To = Annotated[
    str | None,
    typer.Option(
        "--to", metavar="A,B,...", help="A second point: the secant through both, in place of --direction."
    ),
]
Order = Annotated[
    str | None,
    typer.Option(
        "--order",
        metavar="K",
        help="The order of the germ's jets: the immersion is expanded to 2K + 1. By default a polynomial is "
        "taken as a whole, and as much of another as determines the germ.",
    ),
]
Variety = Annotated[
    bool, typer.Option("--variety", help="Print the answers about the secant variety as well.")
]

#: the rows of Frenet data
FRENET = (
    ("curvature", "κ"),
    ("torsion", "τ"),
    ("curvature_slope", "κ′"),
    ("torsion_slope", "τ′"),
    ("torsion_second", "τ″"),
    ("condition", "3κτ″ − κ′τ′"),
)
CASES = {
    "fold": "fold (x, y^2)",
    "pitchfork": "pitchfork (x, x*y^2 + y^4)",
    "neither": "neither fold nor pitchfork",
}


def secant(
    formula: Immersion,
    source: Source = None,
    at: At = None,
    direction: Direction = None,
    to: To = None,
    order: Order = None,
    variety: Variety = False,
    patience: Patience = "10",
    as_json: AsJson = False,
) -> None:
    """Print the germ of an immersion's secant map at a point and in a direction, or at two points, exactly.

    At the diagonal it is even in lam, and read as a germ with the boundary u = lam^2; the projection along
    the direction goes with it.
    """
    if source is None:
        raise UsageError('The source variables are missing: give their names, such as --source "x y".')
    if to is not None and (direction is not None or order is not None or variety):
        raise UsageError(
            "The option --to asks for a secant through two points: leave out --direction, --order, --variety."
        )

    from osculant.germs import secant_report, secants

    formulas = formulas_of(formula)
    seconds = number(patience, "--patience")
    with Waiting("computing") as progress:
        if to is not None:
            origin = ",".join("0" * len(source.replace(",", " ").split()))
            apart = secants.secant_apart(formulas, source, at or origin, to, patience=seconds)
            data = secant_report.apart_report(apart, progress)
        else:
            k = None if order is None else whole_number(order, "--order")
            found = secants.secant(formulas, source, at, direction, order=k, patience=seconds)
            data = secant_report.secant_report(found, variety, progress)
    if as_json:
        print_json(data)
        return
    rows = apart_rows(data) if to is not None else secant_rows(data)
    print_rows(rows, MARGIN, min(output_width(), WIDEST) if sys.stdout.isatty() else None)


def secant_rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of what `osculant.germs.secant_report.secant_report` returns.

    >>> from osculant.germs.secant_report import secant_report
    >>> from osculant.germs.secants import secant
    >>> dict(secant_rows(secant_report(secant("t, t^2, t^4 + t^5", "t"))))["Proposition 1.4.5"]
    'pitchfork (x, x*y^2 + y^4)'
    """
    germ, projection = data["germ"], data["projection"]
    yield "immersion", ", ".join(data["immersion"])
    yield "source", " ".join(data["source"])
    yield "at", ", ".join(data["at"])
    yield "direction", ", ".join(data["direction"])
    yield "secant germ", ", ".join(germ["components"])
    if data["order"] is not None:
        yield "  known by", f"jets of order {data['order']}"
    yield "  its source", f"{' '.join(germ['source'])}, boundary {germ['boundary']} = 0"
    yield "  even germ", ", ".join(germ["even"]["components"])
    yield "  group", f"{germ['group']}, as A^Z2 of germs even in {germ['even']['variable']}"
    yield from answers(germ)
    yield "projection", ", ".join(projection["components"])
    yield "  its source", " ".join(projection["source"])
    yield "  group", projection["group"]
    yield from answers(projection)
    yield "remark 6.2.3", f"the germ gives the projection, checked up to degree {data['linked']}"
    if "variety" in data:
        yield "secant variety", ", ".join(data["variety"]["components"])
        yield (
            "  its source",
            f"{' '.join(data['variety']['source'])}, boundary {data['variety']['boundary']} = 0",
        )
        yield from answers(data["variety"])
    if "frenet" in data:
        yield from _frenet_rows(data["frenet"])


def answers(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of the answers in a report that matter here, or why there are none.

    >>> list(answers({"rank": 1, "codimension": None, "reason": {"codimension": "No time."}}))
    [('  rank', '1'), ('  answers', 'undecided: No time.')]
    """
    yield "  rank", str(data["rank"])
    if data["codimension"] is None:
        yield "  answers", f"undecided: {data['reason']['codimension']}"
        return
    for key in ("codimension", "extended_codimension", "determinacy", "stable"):
        value = data[key]
        told = f"undecided: {data['reason'][key]}" if value is None else str(value)
        if isinstance(value, bool):
            told = ("no", "yes")[value]
        yield f"  {key.replace('_', ' ')}", told
    if data.get("name") is not None:
        yield "  class", f"{data['name']} of {data['table']}"


def _frenet_rows(data: dict[str, Any] | None) -> Iterator[tuple[str, str]]:
    if data is None:
        yield "curvature", "0: the curve has no Frenet data here, and Proposition 1.4.5 says nothing"
        return
    yield "Frenet data", ", ".join(f"{symbol} = {data[key]}" for key, symbol in FRENET)
    yield "Proposition 1.4.5", CASES[data["case"]]


def apart_rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows of what `osculant.germs.secant_report.apart_report` returns.

    >>> from osculant.germs.secant_report import apart_report
    >>> from osculant.germs.secants import secant_apart
    >>> dict(apart_rows(apart_report(secant_apart("t, t^2, t^3", "t", 0, 1))))["versal"]
    'yes'
    """
    germ, versality, bigerm = data["germ"], data["versality"], data["bigerm"]
    yield "immersion", ", ".join(data["immersion"])
    yield "source", " ".join(data["source"])
    yield "at", ", ".join(data["at"])
    yield "to", ", ".join(data["to"])
    yield "secant germ", ", ".join(germ["components"])
    yield "  its source", " ".join(germ["source"])
    yield "  group", germ["group"]
    yield from answers(germ)
    yield "parameters", " ".join(data["parameters"])
    if versality is None:
        yield "versal", f"no answer: {data['reason']['versality']}"
    else:
        yield "germ unfolded", ", ".join(versality["components"])
        yield "extended codimension", str(versality["extended_codimension"])
        reached = f"no: the parameters account for {versality['reached']}"
        yield "versal", "yes" if versality["versal"] else reached
        if versality["missing"]:
            yield from listed("missing terms", versality["missing"])
    size = bigerm["extended_codimension"]
    told = f"undecided: {data['reason']['bigerm']}" if size is None else f"extended codimension {size}"
    yield "bigerm", f"{told}, of the branches with the points in either order"
