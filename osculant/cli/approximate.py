"""The command ``osculant approximate``."""

from __future__ import annotations

import sys
from contextlib import nullcontext, redirect_stdout
from time import perf_counter
from typing import Annotated, Any

import typer

from osculant.cli.grammar import UsageError
from osculant.cli.options import (
    AsJson,
    Formula,
    High,
    Low,
    Metric,
    Primitive,
    SplitAt,
    both_ends,
    check_plot,
    writing_options,
)
from osculant.cli.output import Waiting, announce_compiling, print_json
from osculant.cli.splines import print_spline
from osculant.cli.unsplit import pieces_unsplit
from osculant.files.registry import WRITERS, writers
from osculant.files.writing import listed, stands_for_stdout
from osculant.primitives.table import METRICS, PRIMITIVES

FORMATS = [f"{writer.name} ({listed(writer.suffixes, 'or')})" for writer in WRITERS]


def _rules() -> str:
    """Where there are several rules to choose from, in words."""
    found = []
    for primitive in (entry for table in PRIMITIVES.values() for entry in table.values()):
        for metric in METRICS:
            if len(rules := primitive.rules(metric)) > 1:
                where = "" if metric == METRICS[0] else f"with --metric {metric} "
                found.append(f"{where}for {primitive.plural} {' or '.join(rules)}")
    return "; ".join(found)


def _takers(option: str) -> str:
    """The formats that take an option."""
    return listed([writer.name for writer in writers(option=option)])


Tolerance = Annotated[
    str | None,
    typer.Option(
        "--tolerance",
        metavar="E",
        help="The error allowed, by default 1e-6; with --metric area that of the whole curve.",
    ),
]
Pieces = Annotated[
    str | None,
    typer.Option(
        "--pieces", metavar="N", help="The number of pieces instead of a tolerance, the error then least."
    ),
]
Rule = Annotated[
    str | None,
    typer.Option(
        "--rule",
        metavar="NAME",
        help=f"How a piece is chosen: {_rules()}.",
    ),
]
Closed = Annotated[
    bool | None,
    typer.Option(
        "--closed/--open",
        help="Whether the ends are joined, for any start that is best; found out by default.",
        show_default=False,
    ),
]
Split = Annotated[
    str,
    typer.Option(
        "--split",
        metavar="theory|never",
        help="Where knots are forced: where theory wants them, or at inflections and cusps only.",
    ),
]
Certify = Annotated[
    bool, typer.Option("--certify", help="Prove bounds of the error in ball arithmetic; takes seconds.")
]
Write = Annotated[
    list[str] | None,
    typer.Option(
        "--write",
        metavar="FILE",
        help=f"Write {listed(FORMATS, 'or')}, within the tolerance; repeatable. -.svg is standard output as "
        "SVG, and so for the others; what is told goes to standard error then.",
    ),
]
Decimals = Annotated[
    str | None,
    typer.Option(
        "--decimals",
        metavar="N",
        help=f"Decimals of {_takers('decimals')}; by default the fewest, at least 3, or 4 of inches, that "
        "cost a tenth of the tolerance.",
    ),
]
Units = Annotated[
    str | None,
    typer.Option("--units", metavar="mm|inch", help=f"Units written to {_takers('units')}; by default none."),
]
Feed = Annotated[
    str | None,
    typer.Option(
        "--feed",
        metavar="F",
        help=f"Feed rate of {_takers('feed')}, in units a minute; by default 600 mm or 24 inches.",
    ),
]
Dialect = Annotated[
    str | None,
    typer.Option(
        "--dialect",
        metavar="linuxcnc|grbl|marlin",
        help=f"The controller that {_takers('dialect')} is for, by default linuxcnc.",
    ),
]
LargestAngle = Annotated[
    str | None,
    typer.Option(
        "--largest-angle",
        metavar="A",
        help=f"Arcs of {_takers('largest_angle')} turn by less than so many degrees, such as 180.",
    ),
]
SmallestRadius = Annotated[
    str | None,
    typer.Option(
        "--smallest-radius", metavar="R", help=f"Smaller arcs of {_takers('smallest_radius')} become chords."
    ),
]
LargestRadius = Annotated[
    str | None,
    typer.Option(
        "--largest-radius", metavar="R", help=f"Larger arcs of {_takers('largest_radius')} become chords."
    ),
]
Entities = Annotated[
    str | None,
    typer.Option(
        "--entities",
        metavar="polyline|arcs",
        help=f"What {_takers('entities')} has: few polylines and splines, or an entity for each arc.",
    ),
]
Knots = Annotated[
    bool | None,
    typer.Option(
        "--knots/--no-knots",
        help=f"Whether {_takers('knots')} shows the knots; by default it does.",
        show_default=False,
    ),
]
Plot = Annotated[
    str | None, typer.Option("--plot", metavar="FILE", help="Draw with matplotlib, to .png, .pdf, ...")
]


def approximate(
    context: typer.Context,
    formula: Formula,
    low: Low = None,
    high: High = None,
    primitive: Primitive = None,
    tolerance: Tolerance = None,
    pieces: Pieces = None,
    metric: Metric = "hausdorff",
    rule: Rule = None,
    closed: Closed = None,
    split: Split = "theory",
    split_at: SplitAt = None,
    certify: Certify = False,
    write: Write = None,
    decimals: Decimals = None,
    units: Units = None,
    feed: Feed = None,
    dialect: Dialect = None,
    largest_angle: LargestAngle = None,
    smallest_radius: SmallestRadius = None,
    largest_radius: LargestRadius = None,
    entities: Entities = None,
    knots: Knots = None,
    plot: Plot = None,
    as_json: AsJson = False,
) -> None:
    """Approximate a curve by the spline with the fewest pieces within a tolerance, or the best of N pieces.

    Minimal is said among splines with knots at the split points whose pieces are tangent to the curve at
    both ends and each lie over a strictly convex arc.

    Such as: osculant approximate "t*cos(t), t*sin(t)" --from pi/6 --to 2*pi --metric area --pieces 9
    """
    low, high = both_ends(low, high)
    files = writing_options(
        write or [],
        decimals=decimals,
        units=units,
        feed=feed,
        dialect=dialect,
        largest_angle=largest_angle,
        smallest_radius=smallest_radius,
        largest_radius=largest_radius,
        entities=entities,
        knots=knots,
    )
    check_plot(plot)
    piped = [file for file in files if stands_for_stdout(file)]
    if len(piped) + as_json > 1:
        others = [*piped, *(["--json"] if as_json else [])]
        raise UsageError(f"Only one of {listed(others)} can be standard output: leave the others out.")

    from osculant import api

    curve = api.curve(formula, low, high)
    if certify and (metric != "hausdorff" or len(curve.coordinates) == 3):
        raise UsageError("The option --certify is for distances in the plane only: leave it out.")
    began = perf_counter()
    announce_compiling()
    with Waiting("approximating") as progress:
        spline = api.approximate(
            curve,
            primitive,
            tolerance,  # type: ignore[arg-type]  # text is read there, and refused in a sentence
            pieces=pieces,  # type: ignore[arg-type]  # likewise
            rule=rule,
            metric=metric,
            closed=closed,
            split=split,
            split_at=split_at or (),
            files=files,
            progress=progress,
        )
    if certify:
        with Waiting("certifying") as progress:
            spline.certify(progress)
    seconds = perf_counter() - began
    written = [spline.write(file, command=context.obj, **options) for file, options in files.items()]
    if plot is not None:
        spline.plot(plot)
    if as_json:
        print_json(spline.to_json() | {"files": [file.to_json() for file in written]})
        return
    wanted: dict[str, Any] = {"rule": rule, "metric": metric, "closed": closed, "split_at": split_at or ()}
    without = pieces_unsplit(curve, spline, **wanted)
    with redirect_stdout(sys.stderr) if piped else nullcontext():
        print_spline(spline, seconds, written, [] if plot is None else [plot], without)
