"""The command ``osculant classify``."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated

import typer

from osculant.cas.errors import OsculantError
from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson, whole_number
from osculant.cli.output import WIDEST, Waiting, output_width, print_json, print_rows, printable
from osculant.files.writing import check_place

if TYPE_CHECKING:
    from osculant.germs.classification import Classification, GermClass

Source = Annotated[str | None, typer.Option("--source", metavar="N", help="The number of variables.")]
Target = Annotated[str | None, typer.Option("--target", metavar="P", help="The number of components.")]
GroupOption = Annotated[str, typer.Option("--group", metavar="G", help="The group.")]
Codimension = Annotated[
    str,
    typer.Option(
        "--codimension",
        metavar="C",
        help="The largest codimension of an orbit in the jets without constants.",
    ),
]
Tree = Annotated[
    str | None, typer.Option("--tree", metavar="FILE.svg", help="Draw the tree: what became of each branch.")
]

#: columns of the names in front of the answers
MARGIN = 14


def classify(
    source: Source = None,
    target: Target = None,
    group: GroupOption = "A(H)",
    codimension: Codimension = "3",
    tree: Tree = None,
    as_json: AsJson = False,
) -> None:
    """Classify germs up to a codimension from nothing: all classes, real forms, adjacencies.

    The variables are x1, x2, ... and u, the last one, where u = 0 is preserved.
    """
    missing = [name for name, value in (("--source", source), ("--target", target)) if value is None]
    if missing or source is None or target is None:
        raise UsageError(
            f"The dimensions are missing: give {' and '.join(missing)}, such as --source 4 --target 3."
        )
    n, p = whole_number(source, "--source"), whole_number(target, "--target")
    bound = whole_number(codimension, "--codimension")
    if tree is not None:
        from osculant.germs.tree_drawing import SUFFIX

        if not tree.lower().endswith(SUFFIX):
            shown = printable(tree) or "a file without a name"
            raise OsculantError(f"Cannot draw {shown}: its suffix must be {SUFFIX}.")
        check_place(tree)

    from osculant.germs.classification import classify as classified

    with Waiting("classifying", lines=True) as progress:
        found = classified(n, p, group, bound, progress)
    if tree is not None:
        found.draw(tree)
    if as_json:
        print_json(found.data())
    else:
        print_rows(_rows(found), MARGIN, min(output_width(), WIDEST) if sys.stdout.isatty() else None)


def _rows(found: Classification) -> Iterator[tuple[str, str]]:
    yield "germs", f"{found.source} to {found.target} dimensions, group {found.group}"
    forms = sum(len(c.real_forms) for c in found.classes)
    yield (
        "classes",
        f"{len(found.classes)} up to codimension {found.codimension}, complete and different over ℂ; "
        f"{'' if all(c.different for c in found.classes) else 'at most '}{_counted(forms)}",
    )
    for c in found.classes:
        yield from _class_rows(c)
    for stratum in found.strata:
        yield (
            "stratum",
            f"{', '.join(stratum.germ)}: codimension {stratum.codimension}, moduli {stratum.moduli}; its "
            "orbits are beyond the bound",
        )
    yield "adjacencies", ", ".join(f"{b} → {a}" for b, a in found.adjacencies) or "none"
    second = found.exact.second
    if second is not None:
        verdict = "agree" if second.agrees else "DISAGREE"
        yield (
            "genotypes",
            f"{second.classes} up to codimension {second.codimension}, {_counted(second.forms)}: the two "
            f"routes {verdict}",
        )


def _class_rows(c: GermClass) -> Iterator[tuple[str, str]]:
    sharp = "sharp" if c.sharp else "an upper bound"
    yield c.id, f"{', '.join(c.germ)}"
    yield "", f"codimension {c.codimension}, determinacy {c.determinacy} ({sharp})"
    for form in c.real_forms[1:]:
        yield "", f"real form {', '.join(form)}"
    if not c.different:
        yield "", "that these real forms are different classes is not proved"


def _counted(forms: int) -> str:
    return "1 real form" if forms == 1 else f"{forms} real forms"
