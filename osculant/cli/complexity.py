"""The command ``osculant complexity``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson, Formula, High, Low, Metric, Primitive, SplitAt, both_ends
from osculant.cli.output import print_json, print_rows

if TYPE_CHECKING:
    from osculant.approximation.prediction import Complexity
    from osculant.curves.curve import FormulaCurve


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

    from osculant import api
    from osculant.approximation.request import requested
    from osculant.tolerances import checked_tolerance

    allowed = None if tolerance is None else checked_tolerance(tolerance)
    count = requested(None, pieces)[1]
    curve = api.curve(formula, low, high)
    law = api.complexity(curve, primitive, metric=metric, split_at=split_at or (), next_term=next_term)
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


def print_complexity(
    curve: FormulaCurve, law: Complexity, tolerance: float | None, pieces: int | None
) -> None:
    """Print the law with its constant, the pieces predicted for a tolerance, and the error for a number."""
    constants = law.to_json()
    rows = [
        ("curve", curve.text),
        ("primitive", law.primitive),
        *([("metric", law.metric)] if law.metric != "hausdorff" else []),
        ("pieces", f"C*tolerance^(-1/{law.order})"),
        ("C", constants["constant"]),
    ]
    if len(law.constants) > 1:
        power = f"^({law.order}/{law.order + 1})" if law.metric == "area" else ""
        terms = " + ".join(f"C{place}{power}" for place in (1, 2))
        more = " + ..." if len(law.constants) > 2 else ""
        rows.append(("stretches", f"{len(law.constants)} between split points: C{power} = {terms}{more}"))
        rows += [(f"  C{place}", value) for place, value in enumerate(law.constants, 1)]
    if law.next_constant is not None:
        rows += [("next term", f"c1*tolerance^(1/{law.order})"), ("c1", f"{law.next_constant:.12g}")]
    if tolerance is not None:
        rows += [
            ("tolerance", f"{tolerance:g}"),
            ("predicted", f"{law.predicted(tolerance):.10g}"),
            *([("both terms", f"{law.refined(tolerance):.10g}")] if law.next_constant is not None else []),
            ("whole pieces", str(law.predicted_pieces(tolerance))),
        ]
    if pieces is not None:
        rows += [
            ("given pieces", str(pieces)),
            ("predicted error", f"{law.predicted_error(pieces):.10g}"),
        ]
    print_rows(rows)
