"""What a file tells about the spline in it, how it was made and how good it is, and what writing may add."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from osculant.version import __version__

if TYPE_CHECKING:
    from osculant.pieces.chain import Chain

#: points on each piece for the length of a spline
POINTS = 65
#: of the error of a given number of pieces, what writing may add
SHARE = 0.25


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
        given: what was asked for, "tolerance" or "pieces".
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
    given: str = "tolerance"
    command: str | None = None
    version: str = __version__

    def length_tolerance(self, chain: Chain) -> float:
        """The tolerance as a distance: that of an area is the width of a strip so large along the spline."""
        return self.tolerance / width_of(self.metric, chain)

    def room(self, chain: Chain) -> float:
        """How far what is written may be from the pieces if the tolerance is to be kept.

        If a number of pieces was given there is none to keep: a part of their error.

        >>> from osculant.pieces.chain import Chain
        >>> from osculant.pieces.conics import Piece
        >>> chord = Chain([Piece.segment((0.0, 1.0), (0.0, 0.0), (3.0, 4.0))])
        >>> facts = Facts(
        ...     curve="t, t**2", primitive="conic", pieces=1, tolerance=0.1, metric="area", error=0.05,
        ...     error_kind="estimate", closed=False, data=dict,
        ... )
        >>> round(facts.room(chord), 12)
        0.01
        """
        left = max(0.0, self.tolerance - self.error)
        if self.given == "pieces":
            left = max(left, SHARE * self.error)
        return left / width_of(self.metric, chain)


def width_of(metric: str, chain: Chain) -> float:
    """What a unit of length costs: 1, or in the metric "area" the length of the spline."""
    if metric != "area":
        return 1.0
    return float(np.linalg.norm(np.diff(chain.sample(POINTS), axis=0), axis=1).sum())


def header(facts: Facts, written: str | None = None, **more: str | None) -> dict[str, str]:
    """What stands at the head of a file, by names.

    Args:
        facts: of the spline.
        written: what is known of the error of the file.
        more: further facts of the format; None leaves one out.

    >>> facts = Facts(
    ...     curve="t, t**2", primitive="conic", pieces=1, tolerance=0.1, metric="hausdorff", error=0.0,
    ...     error_kind="exact", closed=False, data=dict, version="1",
    ... )
    >>> header_lines(header(facts, "1e-3", decimals="4"))[3:]
    ['tolerance: 0.1 (hausdorff)', 'error: 0.0 (exact)', 'error of this file: 1e-3', 'decimals: 4']
    """
    rows = {
        "osculant": facts.version,
        "command": facts.command,
        "curve": facts.curve,
        "primitive": f"{facts.primitive}, {facts.pieces} pieces",
        "tolerance": f"{facts.tolerance!r} ({facts.metric})",
        "error": f"{facts.error!r} ({facts.error_kind})",
        "error of this file": written,
        **more,
    }
    return {name: text for name, text in rows.items() if text is not None}


def header_lines(rows: dict[str, str]) -> list[str]:
    """A `header` in lines, the name of the program and its version first."""
    (program, version), *others = rows.items()
    return [f"{program} {version}", *(f"{name}: {text}" for name, text in others)]
