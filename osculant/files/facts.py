"""What a file tells about the spline in it, how it was made and how good it is, and what writing may add."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.tolerances import writing_share
from osculant.version import __version__

if TYPE_CHECKING:
    from osculant.pieces.chain import Chain

#: points on each piece for the length of a spline
POINTS = 65


@dataclass(frozen=True, kw_only=True)
class Facts:
    """What is recorded in a file beside the geometry.

    Attributes:
        curve: the formula of the curve.
        primitive: the name of its kind of pieces.
        pieces: their number.
        tolerance: the error allowed.
        metric: what errors are, "hausdorff" or "area".
        error: the spline's.
        error_kind: "estimate", "exact" or "certified".
        closed: whether the spline returns to where it began.
        data: called for all that is known about the spline, as plain data (`Spline.to_json`).
        command: the command line that made it, or None.
        version: of osculant.
    """

    curve: str
    primitive: str
    pieces: int
    tolerance: float
    metric: str
    error: float
    error_kind: str
    closed: bool
    data: Callable[[], dict[str, Any]]
    command: str | None = None
    version: str = __version__


def header(facts: Facts, budget: float | None = None, **more: str | None) -> dict[str, str]:
    """What stands at the head of a file, by names.

    Args:
        facts: of the spline.
        budget: by how much writing may have moved it, if at all.
        more: further facts of the format; None leaves one out.

    >>> facts = Facts(
    ...     curve="t, t**2", primitive="conic", pieces=1, tolerance=0.1, metric="hausdorff", error=0.0,
    ...     error_kind="exact", closed=False, data=dict, version="1",
    ... )
    >>> header_lines(header(facts, 1e-3, decimals="4"))[3:]
    ['tolerance: 0.1 (hausdorff)', 'error: 0.0 (exact), of writing at most 0.001 more', 'decimals: 4']
    """
    writing = "" if budget is None else f", of writing at most {budget!r} more"
    rows = {
        "osculant": facts.version,
        "command": facts.command,
        "curve": facts.curve,
        "primitive": f"{facts.primitive}, {facts.pieces} pieces",
        "tolerance": f"{facts.tolerance!r} ({facts.metric})",
        "error": f"{facts.error!r} ({facts.error_kind}){writing}",
        **more,
    }
    return {name: text for name, text in rows.items() if text is not None}


def header_lines(rows: dict[str, str]) -> list[str]:
    """A `header` in lines, the name of the program and its version first."""
    (program, version), *others = rows.items()
    return [f"{program} {version}", *(f"{name}: {text}" for name, text in others)]


def usual_budget(chain: Chain, facts: Facts) -> float:
    """How far what is written may be from a spline's pieces: what the tolerance leaves, if it is little.

    Args:
        chain: the pieces.
        facts: with the tolerance and the error.

    >>> from osculant.pieces.chain import Chain
    >>> from osculant.pieces.conics import Piece
    >>> chord = Chain([Piece.segment((0.0, 1.0), (0.0, 0.0), (2.0, 4.0))])
    >>> facts = Facts(
    ...     curve="t, t**2", primitive="conic", pieces=1, tolerance=0.1, metric="hausdorff", error=0.0,
    ...     error_kind="exact", closed=False, data=dict,
    ... )
    >>> usual_budget(chord, facts) == 0.1 * 2.5e-7
    True
    """
    rounding = math.ulp(chain.largest)
    length = 1.0
    if facts.metric == "area":  # of a strip along both curves
        length = 2 * float(np.linalg.norm(np.diff(chain.sample(POINTS), axis=0), axis=1).sum())
    left = max(0.0, facts.tolerance - facts.error)
    return min(writing_share(facts.tolerance, rounding * length), left) / length
