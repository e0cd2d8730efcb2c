"""Splines of bihelices: the result of approximating a space curve, to be evaluated, written, drawn."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from osculant.cas.errors import OsculantError
from osculant.files.figures import DRAWN_POINTS, draw
from osculant.files.writing import GCODE_SUFFIXES, SUFFIXES, listed, write_whole
from osculant.pieces.helices import SpacePiece, Vector
from osculant.spline_facts import CurveText, Prediction, SplineFacts
from osculant.tolerances import writing_reserve

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike

    from osculant.pieces.helices import Floats

#: how many numbers an arc takes, given where it begins
NUMBERS = {"segment": 3, "arc": 5, "helix": 6}


@dataclass(frozen=True, repr=False)
class SpaceSpline(SplineFacts):
    """A tangent-continuous chain of bihelices that stands for a space curve within a tolerance.

    Attributes:
        curve: the curve approximated.
        primitive: "bihelix".
        rule: how the junctions are chosen, "equioscillating" or "thesis".
        metric: "hausdorff".
        tolerance: the largest error allowed; for a given number of pieces, what is sure to be kept.
        pieces: the pieces in order; each starts where the one before ends.
        minimal: "proved" if every stretch between split points is one piece, else "unknown": the error of a
            bihelix is not monotone in the length of the arc.
        undecided: parameters of knots where it could not be decided whether theory demands a split.
        splits: parameters inside the interval where theory, or the user, demanded a knot.
        complexity: called at most once, when `predicted` or `predicted_pieces` is first asked for.
        closed: whether it returns to where it began, which is a knot.
        split: "theory", or "never" if vertices did not split.
        given: what was asked for, "tolerance" or "pieces".
        gap: None; as of a spline in the plane.
        choice: why this primitive, if the choice was left to `osculant.approximate`.

    >>> from types import SimpleNamespace
    >>> from osculant.pieces.helices import HelixArc
    >>> line = HelixArc((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 1.0), 0.0, 0.0, 2.0)
    >>> curve, pieces = SimpleNamespace(text="0, 0, t"), (SpacePiece((0.0, 2.0), (line,), 0.0),)
    >>> spline = SpaceSpline(curve, "bihelix", "thesis", "hausdorff", 0.1, pieces, "proved")
    >>> len(spline), spline.knots, spline.error, spline.error_kind
    (1, [0.0, 2.0], 0.0, 'exact')
    >>> spline.evaluate([0.5, 1.5]).tolist()
    [[0.0, 0.0, 0.5], [0.0, 0.0, 1.5]]
    """

    curve: CurveText = field(compare=False)
    primitive: str
    rule: str
    metric: str
    tolerance: float
    pieces: tuple[SpacePiece, ...]
    minimal: Literal["proved", "by theory", "unknown"]
    undecided: tuple[float, ...] = ()
    splits: tuple[float, ...] = ()
    complexity: Callable[[], Prediction] | None = field(default=None, compare=False)
    closed: bool = False
    split: str = "theory"
    given: Literal["tolerance", "pieces"] = "tolerance"
    gap: float | None = None
    choice: tuple[str, ...] | None = None

    def evaluate(self, t: ArrayLike) -> Floats:
        """Return the spline's points at parameters of the curve.

        On each helical arc the arc length is affine in the parameter. So the result is on the spline, but in
        general not the foot of the curve's point at t; it may be farther from that than the error.

        Args:
            t: parameters from the first knot to the last, an array of shape (m,), or of any other.

        Returns:
            Points of shape (m, 3): t's shape with a last axis of length 3.

        Raises:
            DomainError: a parameter outside.
        """
        at, _, place = self._places(t)
        points = np.empty((*at.shape, 3))
        for index in np.unique(place):
            here = place == index
            points[here] = self.pieces[index].at_parameter(at[here])
        return points

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points on each piece, equally spaced on it, knots once; shape (N(n−1)+1, 3)."""
        parts = [self.pieces[0].sample(n), *(piece.sample(n)[1:] for piece in self.pieces[1:])]
        return np.concatenate(parts)

    def bounding_box(self) -> tuple[Vector, Vector]:
        """Return the lower and upper corners of the box around the pieces, from the extreme points."""
        boxes = [piece.bounding_box() for piece in self.pieces]
        x, y, z = np.min([low for low, _ in boxes], axis=0).tolist()
        u, v, w = np.max([high for _, high in boxes], axis=0).tolist()
        return (x, y, z), (u, v, w)

    def max_tangent_jump(self) -> float:
        """Return the largest angle in radians between the tangent lines of consecutive arcs where they meet.

        Lines have no direction: a cusp, where the tangent is reversed, counts as continuous here, and is
        listed by `cusps`.
        """
        arcs = [arc for piece in self.pieces for arc in piece.arcs]
        pairs = ((a.tangent_at(a.length), np.array(b.tangent)) for a, b in pairwise(arcs))
        return max(
            (math.atan2(float(np.linalg.norm(np.cross(a, b))), abs(float(a @ b))) for a, b in pairs),
            default=0.0,
        )

    @property
    def cusps(self) -> list[float]:
        """The knots where the direction of the tangent is reversed."""
        pairs = pairwise(self.pieces)
        return [float(b.interval[0]) for a, b in pairs if float(a.tangent(1.0) @ b.tangent(0.0)) < 0]

    def to_json(self) -> dict[str, Any]:
        """Return the spline as plain dictionaries, lists and numbers.

        Keys: "curve" (the formula), "primitive", "rule", "closed", "split", "given", "gap", "choice" (null
        where they do not apply), "metric", "tolerance", "pieces" (their number), "knots", "error",
        "error_kind", "errors", "predicted", "predicted_pieces", "predicted_error" (null where unknown or not
        finite), "minimal", "undecided", "splits" and "cusps" (parameters), "segments" (the pieces:
        `SpacePiece.to_json`), "certificate" (null: none was asked for).
        """
        return self._json(self.cusps)

    @property
    def numbers(self) -> int:
        """How many numbers store it: three for where it begins, and those of each arc from there on.

        A segment takes 3 (its end). An arc of a circle takes 5: the tangent (2) and the direction of the
        centre (1), which are its frame, the curvature and the length. A helix takes its torsion besides, 6,
        and a bihelix is two of them, 12. As in the plane, each arc can be drawn by itself.
        """
        return 3 + sum(NUMBERS[arc.kind] for piece in self.pieces for arc in piece.arcs)

    @property
    def reserve(self) -> float:
        """How far what is written may be from the pieces."""
        low, high = self.bounding_box()
        return writing_reserve(self.tolerance, max(map(abs, (*low, *high))))

    def write(
        self,
        path: str | os.PathLike[str],
        *,
        reserve: float | None = None,
        decimals: int | None = None,
        units: Literal["mm", "inch"] | None = None,
        command: str | None = None,
    ) -> None:
        """Write the spline to a file, whole or not at all; its suffix says how.

        Args:
            path: ".json" for what `to_json` returns, ".nc", ".gcode" or ".ngc" for G-code (`files.gcode`),
                ".dxf" for a polyline of chords (`osculant.files.dxf`).
            reserve: how far G-code may be from the pieces, chords aside.
            decimals: of G-code.
            units: of G-code and DXF; by default none are written.
            command: the command line that made the spline, recorded in the file.

        Raises:
            OsculantError: another suffix, or a file that cannot be written.
            ToleranceError: a reserve too small for the digits, or decimals too few for the reserve.
        """
        suffix = Path(path).suffix.lower()
        if suffix in GCODE_SUFFIXES:
            from osculant.files.gcode import gcode

            text = gcode(self, decimals=decimals, reserve=reserve, units=units, command=command)
            return write_whole(path, text)
        if suffix == ".dxf":
            from osculant.files.dxf import dxf

            return write_whole(path, dxf(self, units=units, command=command))
        if suffix != ".json":
            raise OsculantError(
                f"Cannot write {Path(path)}: a spline in space is written as "
                f"{listed([s for s in SUFFIXES if s != '.svg'])}; plot() makes pictures of other kinds."
            )
        data = self.to_json() | ({} if command is None else {"command": command})
        return write_whole(path, json.dumps(data, indent=1, allow_nan=False) + "\n")

    def plot(self, path: str | os.PathLike[str] | None = None, axes: Any = None) -> Any:
        """Draw the pieces in alternating colours with the knots marked, by means of matplotlib.

        Args:
            path: a file to draw to, of any kind that matplotlib knows by its suffix.
            axes: matplotlib axes to draw in, of the projection "3d"; new ones by default.

        Returns:
            The axes.

        Raises:
            OsculantError: matplotlib is not installed, or does not know the suffix, or cannot write the file.
        """
        return draw(self.sample(DRAWN_POINTS), self._title, path, axes)
