"""The commands ``osculant approximate`` and ``osculant complexity``."""

from __future__ import annotations

from time import perf_counter
from typing import Annotated

import typer

from osculant.cli.options import (
    AsJson,
    Formula,
    High,
    Low,
    UsageError,
    both_ends,
    check_files,
    writing_options,
)
from osculant.cli.splines import Waiting, print_complexity, print_json, print_spline

Primitive = Annotated[
    str | None,
    typer.Option(
        "--with",
        metavar="conic|parabola|biarc|bihelix|best",
        help="The kind of pieces; in the plane conic by default, in space bihelix; best is the one with the "
        "fewest numbers to store.",
    ),
]
Metric = Annotated[
    str,
    typer.Option(
        "--metric",
        metavar="hausdorff|area",
        help="What an error is: a distance, or the area between curve and spline.",
    ),
]
SplitAt = Annotated[
    list[str] | None,
    typer.Option("--split-at", metavar="T", help="A parameter that shall be a knot; repeatable."),
]
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
        help="How a piece is chosen: with --metric area for conics equisymmetric or minimal-area; for "
        "bihelices equioscillating or thesis.",
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
    typer.Option("--write", metavar="FILE", help="Write .svg, .json, G-code (.nc) or .dxf; repeatable."),
]
Reserve = Annotated[
    str | None,
    typer.Option(
        "--reserve",
        metavar="R",
        help="How far .svg and G-code may be from the pieces; by default what the tolerance leaves.",
    ),
]
Decimals = Annotated[str | None, typer.Option("--decimals", metavar="N", help="Decimals of G-code.")]
Units = Annotated[
    str | None,
    typer.Option("--units", metavar="mm|inch", help="Units written to G-code and .dxf; by default none."),
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
    reserve: Reserve = None,
    decimals: Decimals = None,
    units: Units = None,
    plot: Plot = None,
    as_json: AsJson = False,
) -> None:
    """Approximate a curve by the spline with the fewest pieces within a tolerance, or the best of N pieces.

    Such as: osculant approximate "t*cos(t), t*sin(t)" --from pi/6 --to 2*pi --metric area --pieces 9
    """
    low, high = both_ends(low, high)
    write = write or []
    check_files(write, plot, primitive)
    options = writing_options(write, reserve=reserve, decimals=decimals, units=units)

    import osculant

    curve = osculant.curve(formula, low, high)
    if certify and (metric != "hausdorff" or len(curve.coordinates) == 3):
        raise UsageError("The option --certify is for distances in the plane only: leave it out.")
    began = perf_counter()
    with Waiting("approximating") as progress:
        spline = osculant.approximate(
            curve,
            primitive,
            tolerance,  # type: ignore[arg-type]  # text is read there, and refused in a sentence
            pieces=pieces,  # type: ignore[arg-type]  # likewise
            rule=rule,
            metric=metric,
            closed=closed,
            split=split,
            split_at=split_at or (),
            progress=progress,
        )
    if certify:
        with Waiting("certifying") as progress:
            spline.certify(progress)
    seconds = perf_counter() - began
    for file in write:
        spline.write(file, command=context.obj, **options[file])
    if plot is not None:
        spline.plot(plot)
    if as_json:
        print_json(spline.to_json())
    else:
        print_spline(spline, seconds, [*write, *([] if plot is None else [plot])])


def complexity(
    formula: Formula,
    low: Low = None,
    high: High = None,
    primitive: Primitive = None,
    tolerance: Annotated[
        str | None, typer.Option("--tolerance", metavar="E", help="Predict the pieces for this tolerance.")
    ] = None,
    pieces: Annotated[
        str | None, typer.Option("--pieces", metavar="N", help="Predict the error of so many pieces.")
    ] = None,
    metric: Metric = "hausdorff",
    split_at: SplitAt = None,
    next_term: Annotated[
        bool, typer.Option("--next-term", help="Also c1 of the second term, C*E^(-1/p) + c1*E^(1/p).")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Print how many pieces theory predicts, and its leading constant."""
    low, high = both_ends(low, high)

    import osculant
    from osculant.approximation.request import requested
    from osculant.tolerances import checked_tolerance

    allowed = None if tolerance is None else checked_tolerance(tolerance)
    count = requested(None, pieces)[1]
    curve = osculant.curve(formula, low, high)
    law = osculant.complexity(curve, primitive, metric=metric, split_at=split_at or (), next_term=next_term)
    if count is not None and count < sum(law.least):
        raise UsageError(
            f"The number of pieces is {count}, and between its split points the curve takes at least "
            f"{sum(law.least)}: ask for {sum(law.least)} or more."
        )
    if not as_json:
        print_complexity(curve, law, allowed, count)
        return
    data = {"curve": curve.text, **law.to_json()}
    if allowed is not None:
        data |= {
            "tolerance": allowed,
            "predicted": law.predicted(allowed),
            "predicted_pieces": law.predicted_pieces(allowed),
        }
        if next_term:
            data["refined"] = law.refined(allowed)
    if count is not None:
        data |= {"pieces": count, "predicted_error": law.predicted_error(count)}
    print_json(data)
