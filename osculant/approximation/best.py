"""The primitive that takes the fewest numbers: of the file that is asked for, or of the pieces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from osculant.approximation.for_files import Wanted, check_arcs, with_first_file
from osculant.cas.errors import DomainError, OsculantError, ToleranceError, UndecidedError
from osculant.files.writing import listed
from osculant.primitives.table import PRIMITIVES, candidates

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve
    from osculant.spline import Spline


def approximate_best(
    curve: FormulaCurve,
    tolerance: Any,
    files: Sequence[Wanted],
    *,
    pieces: int | None,
    rule: str | None,
    **wanted: Any,
) -> Spline:
    """The spline of the primitive that takes the fewest numbers to store; `Spline.choice` tells of all.

    The numbers are those of the first file, with what stands there for pieces that its format cannot hold, or
    of the pieces if there is none. Primitives that a format cannot hold at all are left out.

    Raises DomainError with a number of pieces or a rule if there are several, as these belong to one
    primitive, and whatever the last primitive raises if none can approximate the curve.
    """
    names = candidates(curve.dimension)
    for name, value in (("number of pieces", pieces), ("rule", rule)):
        if value is not None and len(names) > 1:
            raise DomainError(
                f"The {name} {value!r} belongs to one primitive: name that and not 'best', or leave it out."
            )
    found: list[tuple[int, Spline]] = []
    reasons: list[str] = []
    failure: OsculantError | None = None
    for primitive in names:
        try:
            check_arcs(files, PRIMITIVES[curve.dimension][primitive])
        except OsculantError as error:
            failure = failure or error
            arcs = PRIMITIVES[curve.dimension][primitive].arcs
            unable = dict.fromkeys(file.writer.name for file in files if not file.writer.holds(arcs))
            reasons.append(f"{primitive}: not for {listed(list(unable))}")
            continue
        try:
            spline, first = with_first_file(
                curve, primitive, tolerance, files, pieces=pieces, rule=rule, **wanted
            )
        except UndecidedError as error:
            reasons.append(f"{primitive}: {error}")
            failure = error
            continue
        except ToleranceError as error:
            if not files:
                raise
            reasons.append(f"{primitive}: {error}")
            failure = error
            continue
        numbers = spline.numbers if first is None else first.draft.numbers
        where = "" if first is None else f" in {first.writer.name}"
        found.append((numbers, spline))
        reasons.append(f"{primitive}: {len(spline)} pieces, {numbers} numbers{where}")
    if not found:
        assert failure is not None
        raise failure
    _, best = min(found, key=lambda pair: pair[0])
    return replace(best, choice=tuple(reasons))
