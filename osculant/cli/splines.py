"""How a spline is printed: what it is, how good, and whether it is the best, one fact a line."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from typing import TYPE_CHECKING

from osculant.cli.output import print_rows, printable
from osculant.files.writing import stands_for_stdout

if TYPE_CHECKING:
    from osculant.files.drafts import Written
    from osculant.spline import Spline

#: angles of tangents where pieces meet, in radians, that are not worth a word
SMOOTH = 1e-9
#: split points that are listed
LISTED = 8
#: what the strokes of a file are called, by its format, if not curves
MOVES = {"G-code": "moves", "JSON": "pieces"}
#: of a spline without the splits that theory wants
UNSPLIT = "never where only theory wants it: errors are measured, but nothing proves the number minimal"
#: of one with them, if there are fewer without
FEWER = "theory forces knots; with --split never {} will do, not proved to be the least"


def print_spline(
    spline: Spline,
    seconds: float,
    files: Sequence[Written],
    pictures: Sequence[str] = (),
    unsplit: int | None = None,
) -> None:
    """Print what was made, how good it is and whether it is the best, one fact a line.

    ``unsplit`` pieces would do without the knots that theory wants, if that is fewer.
    """
    rows = [
        ("curve", spline.curve.text),
        ("interval", f"{spline.knots[0]:.10g} to {spline.knots[-1]:.10g}"),
        *_choice(spline),
        *_size(spline),
        *_error(spline),
        ("minimal", _minimal(spline)),
        *_closing(spline),
        ("split points", _listed(spline.splits)),
        *([("split", UNSPLIT)] if spline.split == "never" and spline.minimal == "unknown" else []),
        *_without(unsplit),
        *([("undecided", _listed(spline.undecided))] if spline.undecided else []),
        *_tangents(spline),
        *([("bridged", _bridged(spline))] if spline.bridged else []),
        ("time", f"{seconds:.3g} s"),
        *(("written", _written(file)) for file in files),
        *(("written", printable(picture)) for picture in pictures),
    ]
    print_rows(rows)


def _without(unsplit: int | None) -> list[tuple[str, str]]:
    """What will do without the knots that theory wants, if that is fewer pieces."""
    if unsplit is None:
        return []
    return [("split", FEWER.format("one piece" if unsplit == 1 else f"{unsplit} pieces"))]


def _written(file: Written) -> str:
    """A file, with the error of what it draws."""
    place = "standard output" if stands_for_stdout(file.path) else printable(file.path)
    return (
        f"{place}: error {file.error:.7g}, {file.moves} {MOVES.get(file.format, 'curves')}, "
        f"{file.numbers} numbers"
    )


def _choice(spline: Spline) -> list[tuple[str, str]]:
    """The primitive, and what else was chosen if it is not the usual; of bihelices the rule in any case."""
    from osculant.primitives.table import METRICS, PRIMITIVES

    rows = [("primitive", spline.primitive)]
    if spline.choice is not None:
        best = (
            "it takes the fewest numbers to store" if len(spline.choice) > 1 else "there is no other in space"
        )
        rows = [("primitive", f"{spline.primitive}, the best: {best}")]
        rows += [(f"  {name}", text) for name, _, text in (other.partition(": ") for other in spline.choice)]
    if spline.metric != METRICS[0]:
        rows.append(("metric", spline.metric))
    plane = PRIMITIVES[2].get(spline.primitive)
    usual = None if plane is None else plane.rules(spline.metric)[0]
    if spline.rule not in (None, usual):
        rows.append(("rule", str(spline.rule)))
    return rows


def _tangents(spline: Spline) -> list[tuple[str, str]]:
    """What tangents are off by where pieces meet, if that is more than it should be."""
    from osculant.primitives.table import PRIMITIVES

    jump = spline.max_tangent_jump()
    if jump <= SMOOTH or not PRIMITIVES[spline.chain.dimension][spline.primitive].smooth:
        return []
    return [
        ("tangents", f"differ by up to {jump:.2g} rad where pieces meet: these are too small for doubles")
    ]


def _bridged(spline: Spline) -> str:
    """The arcs that are passed over, and how large they are."""
    arcs = [f"{a:.10g} to {b:.10g} ({extent:.2g})" for a, b, extent in spline.bridged[:LISTED]]
    more = ", …" if len(spline.bridged) > LISTED else ""
    listed = ", ".join(arcs) + more
    return f"{listed}: below the tolerance, passed over; at an end of the curve its tangent is lost"


def _minimal(spline: Spline) -> str:
    """Whether the number of pieces is the least, or what else is, and among which splines."""
    if spline.minimal == "unknown":
        return spline.minimal
    return f"{spline.minimal} (the largest error of a piece)" if spline.given == "pieces" else spline.minimal


def _size(spline: Spline) -> list[tuple[str, str]]:
    """The number of pieces and the tolerance, of which one was given, and what theory says of the other."""
    from osculant.primitives.table import PRIMITIVES

    unknown = "unknown: the integral of the theory did not settle"
    if spline.given == "pieces":
        error = spline.predicted_error
        theory = unknown if error is None else f"{error:.6g}"
        return [("pieces", f"{_pieces(spline)} (given)"), ("predicted error", theory)]
    theory = unknown
    if spline.predicted is not None:
        theory = f"{spline.predicted:.6g}, in whole pieces {spline.predicted_pieces}"
    among = PRIMITIVES[spline.chain.dimension][spline.primitive].fewest
    kept = f", of which {spline.reserved:.3g} is kept for writing" if spline.reserved else ""
    return [
        ("pieces", f"{_pieces(spline)}, {among}" if among else _pieces(spline)),
        ("predicted", theory),
        ("tolerance", f"{spline.tolerance:g}{kept}"),
    ]


def _pieces(spline: Spline) -> str:
    """The number of pieces, and of arcs where a piece has two."""
    arcs = len(spline.chain.arcs)
    return str(len(spline)) if arcs == len(spline) else f"{len(spline)}, of {arcs} arcs"


def _error(spline: Spline) -> list[tuple[str, str]]:
    """The error, of areas that of the largest piece too, and what was proved of it."""
    kind = "" if spline.error_kind == "exact" else f" ({spline.error_kind})"
    if spline.metric == "area":
        kind = f", the sum of the pieces' areas{kind}"
    proof = spline.certificate
    if proof is None:
        rows = [("error", f"{spline.error:.7g}{kind}")]
    elif math.isinf(proof.upper):
        rows = [
            ("error", f"{spline.error:.7g}{kind}"),
            ("certified", f"at least {_rounded(proof.lower, ROUND_FLOOR)}; no upper bound was proved"),
        ]
    else:
        certified = spline.error_kind == "certified"
        error = _rounded(proof.upper, ROUND_CEILING) if certified else f"{spline.error:.7g}"
        verdict = "within the tolerance" if proof.within else "not proved to be within the tolerance"
        if spline.given == "pieces":
            verdict = "proved"
        rows = [
            ("error", f"{error}{kind}"),
            (
                "certified",
                f"at least {_rounded(proof.lower, ROUND_FLOOR)}, "
                f"at most {_rounded(proof.upper, ROUND_CEILING)}: {verdict}",
            ),
        ]
    if spline.metric == "area":
        rows.append(("largest piece", f"{max(spline.errors):.7g}"))
    return rows


def _rounded(bound: float, direction: str) -> str:
    """A bound to ten digits that is still one.

    >>> _rounded(1 / 3, ROUND_CEILING), _rounded(1 / 3, ROUND_FLOOR)
    ('0.3333333334', '0.3333333333')
    """
    return f"{float(Context(prec=10, rounding=direction).create_decimal(bound)):.10g}"


def _closing(spline: Spline) -> list[tuple[str, str]]:
    """Whether the ends are joined and, where any start would do, how good this one is."""
    from osculant.primitives.table import PRIMITIVES

    if not spline.closed:
        return []
    corner = spline.corner or 0.0
    sharp = corner > SMOOTH and PRIMITIVES[spline.chain.dimension][spline.primitive].smooth
    seam = f", with a corner of {math.degrees(corner):.4g}° at t = {spline.knots[0]:.10g}" if sharp else ""
    rows = [("closed", f"yes{seam}")]
    if spline.gap is not None:
        best = "no other start has a smaller error"
        if spline.gap > 0:
            best = f"from another start the error may be smaller, by at most {spline.gap:.2g} of it"
        rows.append(("start", f"t = {spline.knots[0]:.10g}: {best}"))
    return rows


def _listed(values: Sequence[float]) -> str:
    shown = ", ".join(f"{value:.10g}" for value in values[:LISTED])
    more = f" and {len(values) - LISTED} more" if len(values) > LISTED else ""
    return shown + more if values else "none"
