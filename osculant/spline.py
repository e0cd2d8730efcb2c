"""Splines of conic arcs or biarcs: the result of an approximation, to be evaluated, written, drawn."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from osculant import tolerances
from osculant.cas.errors import DomainError, OsculantError
from osculant.files.figures import DRAWN_POINTS, draw
from osculant.files.writing import GCODE_SUFFIXES, SUFFIXES, listed, write_whole
from osculant.pieces.biarcs import Biarc
from osculant.pieces.chain import Chain
from osculant.pieces.conics import Kind, Piece
from osculant.spline_facts import CurveText, Prediction, SplineFacts

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike

    from osculant.certificates.splines import Certificate
    from osculant.pieces.conics import Floats

__all__ = ["Biarc", "Kind", "Piece", "Spline"]


@dataclass(frozen=True, repr=False)
class Spline(SplineFacts):
    """A tangent-continuous chain of pieces that stands for a curve within a tolerance.

    Attributes:
        curve: the curve approximated.
        primitive: "parabola", "conic" or "biarc".
        metric: "hausdorff", where errors are distances, or "area", where each error is the area between a
            piece and its arc of the curve (all regions counted positive), and `error` is their sum.
        tolerance: the largest error allowed; for a given number of pieces, what is sure to be kept.
        pieces: the pieces in order; each starts where the one before ends.
        minimal: whether no spline of this primitive with a knot at every split has fewer pieces (for a given
            number of pieces: a smaller error): "proved", "by theory" (no check of its hypotheses beyond the
            isolation of special points) or "unknown". In the metric "area" among those of n pieces with
            areas of at most tolerance/n each.
        undecided: parameters of knots where it could not be decided whether theory demands a split.
        splits: parameters inside the interval where theory, or the user, demanded a knot.
        complexity: called at most once, when `predicted` or `predicted_pieces` is first asked for.
        rule: how a piece is chosen among those tangent at both ends, as `osculant.approximate` names it.
        closed: whether it returns to where it began.
        split: "theory", or "never" if no knot was demanded where theory wants one to prove that the number
            is minimal.
        given: what was asked for, "tolerance" or "pieces".
        gap: of a given number of pieces on a closed curve that may begin anywhere: by what part of itself the
            error might be smaller from another start. Else None; by tolerance ``minimal`` says all.
        choice: what each primitive takes, if the choice was left to `osculant.approximate`.

    >>> pieces = (
    ...     Piece("parabola", (0.0, 1.0), (0.0, 0.0), (1.0, 1.0), (0.5, 0.0), 1.0, 1e-3),
    ...     Piece.segment((1.0, 2.0), (1.0, 1.0), (2.0, 3.0)),
    ... )
    >>> from types import SimpleNamespace
    >>> spline = Spline(SimpleNamespace(text="t, t**2"), "parabola", "hausdorff", 0.1, pieces, "unknown")
    >>> len(spline), spline.knots, spline.error, spline.error_kind
    (2, [0.0, 1.0, 2.0], 0.001, 'estimate')
    >>> spline.evaluate([0.5, 1.5]).tolist()
    [[0.5, 0.25], [1.5, 2.0]]
    """

    curve: CurveText = field(compare=False)
    primitive: str
    metric: str
    tolerance: float
    pieces: tuple[Piece | Biarc, ...]
    minimal: Literal["proved", "by theory", "unknown"]
    undecided: tuple[float, ...] = ()
    splits: tuple[float, ...] = ()
    complexity: Callable[[], Prediction] | None = field(default=None, compare=False)
    rule: str | None = None
    closed: bool = False
    split: str = "theory"
    given: Literal["tolerance", "pieces"] = "tolerance"
    gap: float | None = None
    choice: tuple[str, ...] | None = None
    _proofs: list[Certificate] = field(default_factory=list, init=False, compare=False)

    @property
    def certificate(self) -> Certificate | None:
        """What `certify` proved; None if it was not called."""
        return self._proofs[0] if self._proofs else None

    def certify(self, progress: Callable[[float], None] | None = None) -> Certificate:
        """Enclose the error of every piece in ball arithmetic, as `osculant.certificates.splines` says.

        The certificate is remembered: `certificate` and `to_json` have it, and `error` is its upper bound,
        with the `error_kind` "certified", if there is one.

        Args:
            progress: called with the part of the pieces done, 0…1.

        Raises:
            DomainError: the metric "area", for which there are no certificates; a curve without formula.

        >>> import osculant as osc
        >>> spline = osc.approximate(osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "conic", 1e-4)
        >>> proof = spline.certify()
        >>> proof.within, spline.error_kind, proof.upper < (1 + 1e-5) * proof.lower
        (True, 'certified', True)
        """
        if not self._proofs:
            from osculant.certificates.splines import certify
            from osculant.curves.plane import PlaneCurve

            if self.metric != "hausdorff":
                raise DomainError(
                    f"Errors in the metric {self.metric!r} cannot be certified: choose 'hausdorff'."
                )
            if not isinstance(self.curve, PlaneCurve):
                raise DomainError(
                    f"Of {self.curve.text} only the text is known: certify what approximate returns."
                )
            self._proofs.append(certify(self.curve, self.pieces, self.tolerance, progress))
        return self._proofs[0]

    @cached_property
    def _chain(self) -> Chain:
        return Chain(self.pieces)

    def evaluate(self, t: ArrayLike) -> Floats:
        """Return the spline's points at parameters of the curve.

        Within a piece the conic's own parameter is the affine fraction of the piece's interval; a biarc's
        interval is divided by the lengths of its arcs. So the result
        is on the spline, but in general not the foot of the curve's point at t; it may be farther from that
        than the error.

        Args:
            t: parameters from the first knot to the last, an array of shape (m,), or of any other.

        Returns:
            Points of shape (m, 2): t's shape with a last axis of length 2.

        Raises:
            DomainError: a parameter outside.
        """
        at, knots, i = self._places(t)
        return self._chain.points(i, (at - knots[i]) / (knots[i + 1] - knots[i]))

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points on each piece, as `Piece.sample`, knots once; shape (N(n−1)+1, 2)."""
        i, u = np.broadcast_arrays(np.arange(len(self))[:, None], np.linspace(0.0, 1.0, n)[None, 1:])
        points = self._chain.points(i, u)
        return np.concatenate([np.array([self.pieces[0].start]), points.reshape(-1, 2)])

    def bounding_box(self) -> tuple[float, float, float, float]:
        """Return (left, bottom, right, top) of the pieces, from the extreme points themselves."""
        boxes = [piece.bounding_box() for piece in self.pieces]
        left, bottom, right, top = zip(*boxes)
        return min(left), min(bottom), max(right), max(top)

    def max_tangent_jump(self) -> float:
        """Return the largest angle in radians between the tangent lines of consecutive pieces at their knot.

        Lines have no direction: a cusp, where the tangent is reversed, counts as continuous here, and is
        listed by `cusps`.
        """
        return max((math.atan2(abs(cross), abs(dot)) for _, cross, dot in self._turns()), default=0.0)

    @property
    def cusps(self) -> list[float]:
        """The knots where the direction of the tangent is reversed."""
        return [knot for knot, _, dot in self._turns() if dot < 0]

    def _turns(self) -> list[tuple[float, float, float]]:
        """Return each inner knot with the sine and cosine of the tangent's angle there."""
        result = []
        for before, after in zip(self.pieces, self.pieces[1:]):
            (ax, ay), (bx, by) = before.tangent(1.0).tolist(), after.tangent(0.0).tolist()
            result.append((float(after.interval[0]), ax * by - ay * bx, ax * bx + ay * by))
        return result

    def to_json(self) -> dict[str, Any]:
        """Return the spline as plain dictionaries, lists and numbers.

        Keys: "primitive", "rule", "closed", "split", "given", "gap", "choice" (null where they do not apply),
        "metric", "tolerance", "pieces" (their number), "knots", "error", "error_kind", "errors", "predicted",
        "predicted_pieces", "predicted_error" (null where unknown or not finite), "minimal", "undecided",
        "segments" (the pieces: "kind", "interval", "points" with null for a control point at infinity,
        "weight", "error", and "middle", the homogeneous control point; of biarcs what `Biarc.to_json` says),
        "certificate" (`Certificate.to_json`; null: none was asked for); further "curve" (the formula),
        "splits" and "cusps" (parameters).
        """
        return self._json(self.cusps)

    @property
    def numbers(self) -> int:
        """How many numbers store it: two for where it begins, and those of each piece from there on.

        A segment takes 2, an arc of a circle 3 (its end and a bulge), a parabola 4 (two control points), a
        conic 5 (a weight besides), a biarc 6.
        """
        return 2 + sum(piece.numbers for piece in self.pieces)

    @property
    def reserve(self) -> float:
        """How far what is written may be from the pieces: what the tolerance leaves, if it is little."""
        rounding = math.ulp(max(map(abs, self.bounding_box())))
        length = 1.0
        if self.metric == "area":  # of a strip along both curves
            length = 2 * float(np.hypot(*np.diff(self.sample(DRAWN_POINTS), axis=0).T).sum())
        left = max(0.0, self.tolerance - self.error)
        return min(tolerances.reserve(self.tolerance, rounding * length), left) / length

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
            path: ".svg" writes a picture (`files.svg`), ".json" what `to_json` returns; of biarcs also
                G-code (".nc", ".gcode" or ".ngc", `osculant.files.gcode`) and ".dxf" (`osculant.files.dxf`).
            reserve: how far what is written may be from the pieces; by default as `osculant.files.svg` and
                `osculant.files.gcode` say. JSON and DXF hold every number exactly.
            decimals: of G-code.
            units: of G-code and DXF; by default none are written.
            command: the command line that made the spline, recorded in a picture's description.

        Raises:
            OsculantError: an unknown suffix, or a file that cannot be written.
            ToleranceError: a reserve too small for the digits, or decimals too few for the reserve.

        >>> Spline.write(None, "spiral.png")
        Traceback (most recent call last):
        ...
        osculant.cas.errors.OsculantError: Cannot write spiral.png: the known suffixes are .svg, .json, .nc,
        .gcode, .ngc and .dxf; plot() makes pictures of other kinds.
        """
        suffix = Path(path).suffix.lower()
        if suffix == ".svg":
            from osculant.files.svg import svg

            write_whole(path, svg(self, reserve=reserve, command=command))
        elif suffix in GCODE_SUFFIXES:
            from osculant.files.gcode import gcode

            write_whole(path, gcode(self, decimals=decimals, reserve=reserve, units=units, command=command))
        elif suffix == ".dxf":
            from osculant.files.dxf import dxf

            write_whole(path, dxf(self, units=units, command=command))
        elif suffix == ".json":
            write_whole(path, json.dumps(self.to_json(), indent=1, allow_nan=False) + "\n")
        else:
            raise OsculantError(
                f"Cannot write {Path(path)}: the known suffixes are {listed(SUFFIXES)}; "
                "plot() makes pictures of other kinds."
            )

    def plot(self, path: str | os.PathLike[str] | None = None, axes: Any = None) -> Any:
        """Draw the pieces in alternating colours with the knots marked, by means of matplotlib.

        Args:
            path: a file to draw to, of any kind that matplotlib knows by its suffix.
            axes: matplotlib axes to draw in; new ones by default.

        Returns:
            The axes.

        Raises:
            OsculantError: matplotlib is not installed, or does not know the suffix, or cannot write the file.
        """
        return draw(self.sample(DRAWN_POINTS), self._title, path, axes)
