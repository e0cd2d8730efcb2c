"""The command ``osculant recognise``."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Annotated, Any

import typer

from osculant.cli.germ import MARGIN, At, Boundary, Even, GroupOption, Patience, Root, Source
from osculant.cli.germ_rows import head
from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson, formulas_of, number
from osculant.cli.output import WIDEST, Waiting, output_width, print_json, print_rows

Formulas = Annotated[
    str | None,
    typer.Argument(
        metavar="GERM",
        help='The components, such as "x, x*y + y^3", which vanish at 0; or @FILE, a file that holds them.',
    ),
]
Certificate = Annotated[
    bool,
    typer.Option(
        "--certificate", help="Print a certificate file of the equivalence, for `osculant check`: JSON."
    ),
]
Tolerance = Annotated[
    str | None,
    typer.Option(
        "--tolerance",
        metavar="E",
        help="To which coefficients that are no integers are known: ranks must be the same within it.",
    ),
]
List = Annotated[
    str | None,
    typer.Option("--list", metavar="NAME", help="Show a list instead, such as mond: its rows as a table."),
]
WithEquivalence = Annotated[
    bool,
    typer.Option("--equivalence", help="Print the changes of coordinates that make the normal form."),
]


def recognise(
    formula: Formulas = None,
    source: Source = None,
    group: GroupOption = None,
    boundary: Boundary = None,
    at: At = None,
    root: Root = None,
    even: Even = None,
    equivalence: WithEquivalence = False,
    certificate: Certificate = False,
    tolerance: Tolerance = None,
    name: List = None,
    patience: Patience = "10",
    as_json: AsJson = False,
) -> None:
    """Tell the class of a map-germ in the lists of the literature, with an equivalence as proof.

    A germ that is proved to be in none of them is told so; what is not decided is said to be undecided.
    """
    if name is not None:
        given = {"--source": source, "--group": group, "--boundary": boundary, "--at": at, "--root": root}
        given["--even"] = even
        _show_list(
            name,
            {
                "GERM": formula,
                "--equivalence": equivalence,
                "--certificate": certificate,
                "--tolerance": tolerance,
                **given,
            },
            as_json,
        )
        return
    if formula is None:
        raise UsageError('The germ is missing: give its components, such as "x, x*y + y^3", or a --list.')
    if source is None:
        raise UsageError('The source variables are missing: give their names, such as --source "x y".')

    from osculant.germs.recognise import recognise as recognised

    seconds = number(patience, "--patience")
    width = None if tolerance is None else number(tolerance, "--tolerance")
    with Waiting("recognising"):
        found = recognised(
            formulas_of(formula),
            source,
            boundary,
            group=group,
            tolerance=width,
            at=at,
            root=root,
            even=even,
            patience=seconds,
        )
        data = found.certificate() if certificate else found.told()
        if equivalence and not certificate:
            data["equivalence"] = found.equivalence_data()
    if as_json or certificate:
        print_json(data)
    else:
        print_rows(rows(data), MARGIN, min(output_width(), WIDEST) if sys.stdout.isatty() else None)


def rows(data: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The rows in which the answer is told to people, from `Recognised.told`.

    >>> from osculant.germs.recognise import recognise as asked
    >>> found = dict(rows(asked("x, y^2, y^3 - x^2*y", "x y").told()))
    >>> found["class"], found["normal form"], found["codimension"]
    ('S1-, over ℂ S1', 'x, y**2, y**3 - x**2*y', '3')
    """
    yield from head(data)
    if data["name"] is None:
        yield "class", f"{'undecided' if data['undecided'] else 'on none of the lists'}: {data['reason']}"
        if data["lists"]:
            yield "lists", ", ".join(data["lists"])
        if data["alike"]:
            yield "not excluded", ", ".join(data["alike"])
    else:
        over = "" if data["complex"] == data["name"] else f", over ℂ {data['complex']}"
        yield "class", data["name"] + over
        integers = ", ".join(f"{name} = {value}" for name, value in data["integers"].items())
        yield "list", f"{data['table']}, row {data['id']}" + (f" with {integers}" if integers else "")
        if data["normal_form"] is not None:
            yield "normal form", ", ".join(data["normal_form"])
        if data["moduli"]:
            yield "moduli", ", ".join(_modulus(name, data) for name in data["moduli"])
        if (field := data["real_field"]) is not None:
            yield f"  {field['name']}", f"the root near {field['near']:.6g} of {field['polynomial']}"
    if data["codimension"] is not None:
        yield "codimension", str(data["codimension"])
    if data["name"] is not None:
        yield "determinacy", str(data["determinacy"])
        if data["proof"] == "key":
            yield "proof", f"its key; signs and moduli are not known: {data['reason']}"
        else:
            yield "proof", f"an equivalence of jets of order {data['determinacy']}, verified by substitution"
    elif data["key"]:
        for title, numbers in data["key"].items():
            yield f"  {title}", " ".join(map(str, numbers))
    if "tolerance" in data:
        yield "germ nearby", ", ".join(data["nearby"])
    if data.get("margin"):
        kept, dropped, noise = (f"{data['margin'][key]:.1e}" for key in ("kept", "dropped", "noise"))
        yield "margin", f"singular values from {kept} count, to {dropped} do not; the tolerance moves {noise}"
    if data.get("secants"):
        yield "secant germs", f"of table 6.1: {', '.join(data['secants'])}"
    if data["unused"]:
        yield "unused variables", " ".join(data["unused"])
    yield from equivalence_rows(data.get("equivalence"))


def _modulus(name: str, data: dict[str, Any]) -> str:
    near = data["estimates"].get(name)
    return f"{name} = {data['moduli'][name]}" + ("" if near is None else f", about {near:.6g}")


def equivalence_rows(told: dict[str, Any] | None) -> Iterator[tuple[str, str]]:
    """The rows of an equivalence, from `osculant.germs.equivalence_file`; none without one."""
    if told is None:
        return
    names = told["form"]["variables"]
    for place, (name, text) in enumerate(zip(told["source"], told["phi"])):
        yield "" if place else f"source, in {' '.join(names)}", f"{name} = {text}"
    for place, text in enumerate(told["psi"] or ()):
        yield "" if place else f"target, in {' '.join(told['target'])}", text
    for i, row in enumerate(told["matrix"] or ()):
        yield "" if i else "matrix", ", ".join(row)
    for side, scales in told["scales"].items():
        if any(scale != "1" for scale in scales):
            yield f"scales of the {side}", ", ".join(map(scale_text, scales))


def scale_text(scale: Any) -> str:
    """A number by which a coordinate is multiplied.

    >>> scale_text("-2/3"), scale_text({"factor": "-1", "powers": [["3", "1/2"]]})
    ('-2/3', '-3**(1/2)')
    """
    if isinstance(scale, str):
        return scale
    powers = "*".join(f"{base if base.isalnum() else f'({base})'}**({e})" for base, e in scale["powers"])
    factor = scale["factor"]
    return powers if factor == "1" else f"-{powers}" if factor == "-1" else f"{factor}*{powers}"


def _show_list(name: str, unwanted: dict[str, Any], as_json: bool) -> None:
    from osculant.cli.germ_kinds import refuse
    from osculant.germs.lists import listed

    refuse(unwanted, "A list (--list)")
    data = listed(name)
    if as_json:
        print_json(data)
        return
    print(f"{data['title']}\n{data['source']}\n")
    table = [("row", "name", "normal form", "codimension", "determinacy")]
    for row in data["rows"]:
        form = ", ".join(row["normal_form"])
        table.append((row["id"], row["name"], form, row["codimension"] or "", row["determinacy"] or ""))
    widths = [max(map(len, column)) for column in zip(*table)]
    for cells in table:
        print("  ".join(f"{cell:<{width}}" for cell, width in zip(cells, widths)).rstrip())
