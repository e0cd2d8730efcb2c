"""The command ``osculant compile``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson, High, Low, Metric, SplitAt
from osculant.cli.output import print_json, print_rows
from osculant.primitives.table import USUAL, usual_first

if TYPE_CHECKING:
    from osculant.compiled.approximator import Compiled

#: what can be compiled, and the dimension of a jet of one's own
WHAT, JETS = ("pieces", "invariants", "distance"), {"plane": 2, "space": 3}
#: version of what --json prints
JSON_VERSION = 1


def compile_curve(
    formula: Annotated[
        str | None,
        typer.Argument(
            metavar="FORMULA",
            help='The coordinates, such as "t*cos(t), t*sin(t)"; left out with --jet.',
            show_default=False,
        ),
    ] = None,
    low: Low = None,
    high: High = None,
    primitive: Annotated[
        str | None,
        typer.Option(
            "--with",
            metavar="|".join(dict.fromkeys([*usual_first(2), *usual_first(3)])),
            help=f"The kind of pieces; in the plane {USUAL[2]} by default, in space {USUAL[3]}.",
        ),
    ] = None,
    out: Annotated[
        str | None, typer.Option("--out", metavar="DIR", help="The folder to write to, made if missing.")
    ] = None,
    name: Annotated[
        str, typer.Option("--name", metavar="NAME", help="What the files and functions are called after.")
    ] = "curve",
    what: Annotated[
        str,
        typer.Option(
            "--what",
            metavar="|".join(WHAT),
            help="What the library computes: pieces for a tolerance or a number, invariants at many "
            "parameters, or the distances of many points from the curve.",
        ),
    ] = "pieces",
    parameters: Annotated[
        str | None,
        typer.Option("--parameters", metavar="NAMES", help='Constants given at run time, such as "a b".'),
    ] = None,
    jet: Annotated[
        str | None,
        typer.Option(
            "--jet", metavar="plane|space", help="For a function of the caller's own in place of a formula."
        ),
    ] = None,
    metric: Metric = "hausdorff",
    rule: Annotated[
        str | None, typer.Option("--rule", metavar="NAME", help="How a piece is chosen, as for approximate.")
    ] = None,
    split: Annotated[
        str,
        typer.Option("--split", metavar="theory|never", help="Where knots are forced, as for approximate."),
    ] = "theory",
    split_at: SplitAt = None,
    language: Annotated[
        str,
        typer.Option(
            "--language", metavar="c|python", help="Whether a module for numpy and ctypes is written as well."
        ),
    ] = "c",
    cpu: Annotated[
        str | None,
        typer.Option(
            "--cpu", metavar="NAME", help="The processor, as the compiler calls it; any by default."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Compile a curve's approximation to a library of its own: C that needs libm alone.

    Without --from and --to the interval is given at run time. Such as: osculant compile "a*cos(t), b*sin(t)"
    --parameters "a b" --with biarc --out ellipse
    """
    if out is None:
        raise UsageError("The folder is missing: give --out DIR.")
    if what not in WHAT:
        raise UsageError(f"There is nothing like --what {what}: choose {', '.join(WHAT[:-1])} or {WHAT[-1]}.")
    if jet is not None and jet not in JETS:
        raise UsageError(f"The option --jet needs plane or space, and {jet!r} is neither.")
    common: dict[str, Any] = {
        "parameters": parameters or (), "folder": out, "name": name, "language": language, "cpu": cpu,
        "jet": JETS[jet] if jet else 0,
    }  # fmt: skip

    from osculant.compiled.approximator import compile_approximator, compile_evaluator

    if what == "pieces":
        made = compile_approximator(
            formula,
            primitive,
            low,
            high,
            metric=metric,
            rule=rule,
            split=split,
            split_at=split_at or (),
            **common,
        )
    else:
        _check_alone(what, primitive, metric, rule, split, split_at)
        made = compile_evaluator(formula, what, low, high, **common)
    _tell(made, as_json)


def _check_alone(
    what: str, primitive: str | None, metric: str, rule: str | None, split: str, split_at: list[str] | None
) -> None:
    """Refuse what only approximations take."""
    options = {"--with": primitive, "--rule": rule, "--split-at": split_at or None}
    options |= {
        "--metric": metric if metric != "hausdorff" else None,
        "--split": split if split != "theory" else None,
    }
    for option, value in options.items():
        if value is not None:
            raise UsageError(f"The option {option} is for pieces, and --what {what} has none: leave it out.")


def _tell(made: Compiled, as_json: bool) -> None:
    splits = None if made.splits is None else list(made.splits)
    if as_json:
        print_json(
            {
                "version": JSON_VERSION,
                "name": made.name,
                "folder": str(made.folder),
                "files": [path.name for path in made.files],
                "splits": splits,
                "undecided": list(made.undecided),
            }
        )
        return
    rows = [("library", str(made.library)), ("files", ", ".join(path.name for path in made.files))]
    if splits:
        rows.append(("split at", ", ".join(f"{at:.15g}" for at in splits)))
    if made.undecided:
        rows.append(("undecided", ", ".join(f"{at:.15g}" for at in made.undecided)))
    print_rows(rows)
