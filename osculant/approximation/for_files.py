"""Splines that leave room for the files to be written: the tolerance is that of what is written.

What a file needs is known before the search: its writer names sums that are worth keeping, the search gets
the rest, and what would be written is measured by its own numbers. If that leaves the tolerance all the same,
more is kept; of several sums the one with the shortest first file wins.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.approximation.approximate import approximate_curve
from osculant.approximation.request import requested
from osculant.cas.errors import OsculantError, ToleranceError
from osculant.files.output import Drafted, drafted
from osculant.files.registry import Writer, writer_of
from osculant.files.writing import check_place, listed
from osculant.pieces.kinds import KINDS
from osculant.primitives.table import PRIMITIVES, usual_first

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve
    from osculant.primitives.primitive import Primitive
    from osculant.spline import Spline

#: searches for one sum, each of which keeps more than the one before; more than this part is never kept
ROUNDS, MOST = 5, 0.95
#: what is kept anew is so many times what was missing; sums that differ by this part are not told apart
ENOUGH, NEAR = 1.1, 0.2
#: of longer files it is not sought how little is enough
LONG = 300
#: samples for the length of a curve
SAMPLES = 1025


@dataclass(frozen=True)
class Wanted:
    """A file that is to be written."""

    path: str
    options: Mapping[str, Any]
    writer: Writer


def wanted_files(files: Any, dimension: int) -> list[Wanted]:
    """The files that are to be written to, with their options.

    Args:
        files: a path, several, or a mapping of paths to options by name.
        dimension: of the curve.

    Raises:
        DomainError: an option that a format has not.
        OsculantError: an unknown suffix, a place that cannot be written to, a package that is missing.
    """
    if files is None:
        return []
    if isinstance(files, str | os.PathLike):
        files = [files]
    given = files if isinstance(files, Mapping) else {path: {} for path in files}
    found = []
    for path, options in given.items():
        writer = writer_of(path, dimension)
        writer.check_options(options)
        writer.check_installed()
        check_place(path)
        found.append(Wanted(os.fspath(path), dict(options or {}), writer))
    return found


def check_arcs(files: Sequence[Wanted], primitive: Primitive) -> None:
    """Raises OsculantError if a file's format cannot hold the pieces of a primitive."""
    for file in files:
        if file.writer.holds(primitive.arcs):
            continue
        held = listed([KINDS[kind] for kind in KINDS if file.writer.holds([kind])])
        able = [
            name
            for name in usual_first(primitive.dimension)
            if all(other.writer.holds(PRIMITIVES[primitive.dimension][name].arcs) for other in files)
        ]
        raise OsculantError(
            f"Cannot write {file.path}: {file.writer.name} holds {held} only, and the pieces are to be "
            f"{primitive.name} arcs; choose {listed(able, 'or') or 'another format'}.",
            argument="primitive",
        )


def approximate_for(
    curve: FormulaCurve, primitive: str, tolerance: Any, files: Sequence[Wanted], **wanted: Any
) -> Spline:
    """The spline of a primitive that leaves room for files.

    Raises ToleranceError if no spline with them keeps the tolerance, and what `approximate_curve` does.
    """
    found, _ = with_first_file(curve, primitive, tolerance, files, **wanted)
    return found


def with_first_file(
    curve: FormulaCurve, primitive: str, tolerance: Any, files: Sequence[Wanted], **wanted: Any
) -> tuple[Spline, Drafted | None]:
    """The same, with what the first file will hold."""
    entry = PRIMITIVES[curve.dimension].get(primitive)
    if entry is not None:
        check_arcs(files, entry)
    asked, count = requested(tolerance, wanted["pieces"])
    if entry is None or not files or count is not None:
        for file in files:  # of options alone, as there is no tolerance
            file.writer.check(() if entry is None else entry.arcs, 1.0, file.options)
        spline = approximate_curve(curve, primitive, tolerance, **wanted)
        return spline, _drafts(spline, files[:1])[0] if files else None
    width = 1.0
    if wanted["metric"] == "area":
        curve.check_finite()
        width = _length(curve)
    sums = [file.writer.check(entry.arcs, asked / width, file.options) for file in files]
    tried = [width * max(own[min(k, len(own) - 1)] for own in sums) for k in range(max(map(len, sums)))]
    best: tuple[Spline, list[Drafted]] | None = None
    failure: ToleranceError | None = None
    for kept in tried:
        try:
            trial = _within(curve, primitive, asked, files, kept, wanted)
        except ToleranceError as error:
            failure = failure or error
            continue
        if best is None or trial[1][0].draft.numbers < best[1][0].draft.numbers:
            best = trial
        if not any(made.draft.converted for made in trial[1]):
            break
    if best is None:
        assert failure is not None
        raise failure
    return best[0], best[1][0]


def _within(
    curve: FormulaCurve,
    primitive: str,
    tolerance: float,
    files: Sequence[Wanted],
    kept: float,
    wanted: Mapping[str, Any],
) -> tuple[Spline, list[Drafted]]:
    """A spline that leaves room for files if so much is kept, or more: not much more than is enough."""
    best: tuple[Spline, list[Drafted]] | None = None
    too_little, enough = 0.0, MOST * tolerance
    for _ in range(ROUNDS):
        spline = approximate_curve(curve, primitive, tolerance, **wanted, reserved=kept)
        made = _drafts(spline, files)
        worst = max(range(len(files)), key=lambda i: made[i].error)
        if made[worst].keeps(tolerance):
            best, enough = (spline, made), kept
            if too_little == 0.0 or made[0].draft.moves > LONG:
                break
        else:
            too_little = kept
        if too_little >= (1 - NEAR) * enough:
            break
        missing = made[worst].error - tolerance
        kept = (too_little + enough) / 2 if best else min(kept + ENOUGH * missing, enough)
    if best is None:
        raise ToleranceError(
            f"{files[worst].path} would have the error {made[worst].error:.3g}, more than the tolerance "
            f"{tolerance:.3g}: allow more decimals, or a larger tolerance."
        )
    return best


def _drafts(spline: Spline, files: Sequence[Wanted]) -> list[Drafted]:
    facts = spline.facts()
    return [drafted(file.path, spline.chain, facts, spline.follow, file.options) for file in files]


def _length(curve: FormulaCurve) -> float:
    """The length of a curve, from samples."""
    points = curve.jets(np.linspace(*curve.interval, SAMPLES))[..., 0]
    points = points[np.isfinite(points).all(axis=1)]
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
