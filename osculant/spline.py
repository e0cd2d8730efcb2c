"""Splines: the result of an approximation, to be evaluated, certified, written and drawn."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, TypeAlias

from osculant.cas.errors import DomainError, ToleranceError, UndecidedError
from osculant.certificates.splines import Certificate, certify
from osculant.files.facts import Facts
from osculant.files.figures import DRAWN_POINTS, draw
from osculant.files.json import data_of
from osculant.files.output import write_file
from osculant.pieces.chain import Chain

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike

    from osculant.files.deviation import Follow
    from osculant.files.drafts import Written
    from osculant.pieces.piece import Box, Floats, PieceLike


#: whether a number of pieces is the least among splines with knots at the split points whose pieces are
#: tangent to the curve at both ends and each lie over a strictly convex arc
Minimal: TypeAlias = Literal["proved", "by theory", "unknown"]
#: errors are measured to this part of the tolerance
MEASURED = 1e-6


class CurveText(Protocol):
    """A curve as far as a spline needs it: something with a formula."""

    @property
    def text(self) -> str:
        """The formula."""


class Prediction(NamedTuple):
    """What theory says: how many pieces, how many in whole ones on each stretch, the error of so many."""

    predicted: float
    predicted_pieces: int
    predicted_error: float


@dataclass(frozen=True, kw_only=True, repr=False)
class Spline:
    """A chain of pieces that stands for a curve within a tolerance, tangent-continuous but for polygons.

    Attributes:
        curve: the curve approximated, in the plane or in space.
        primitive: "parabola", "conic", "biarc", "cubic", in space "bihelix", or in both "polygon".
        metric: "hausdorff", where errors are distances, or "area", where each error is the area between a
            piece and its arc of the curve (all regions counted positive), and `error` is their sum.
        rule: how a piece is chosen among those tangent at both ends, as `osculant.approximate` names it;
            None where there is nothing to choose.
        tolerance: the largest error allowed; for a given number of pieces, what is sure to be kept.
        pieces: the pieces in order; each starts where the one before ends.
        judge: called at most once, when `minimal` is first asked for.
        undecided: parameters of knots where it could not be decided whether theory demands a split.
        bridged: arcs that lie below the tolerance and are passed over, each as (first parameter, last one,
            extent); at an end of the curve the spline has not its tangent there.
        splits: parameters inside the interval where theory, or the user, demanded a knot.
        closed: whether it returns to where it began.
        split: "theory", or "never" if no knot was demanded where theory wants one to prove that the number
            is minimal.
        given: what was asked for, "tolerance" or "pieces".
        gap: of a given number of pieces on a closed curve that may begin anywhere: by what part of itself the
            error might be smaller from another start. Else None; by tolerance ``minimal`` says all.
        reserved: what of the tolerance the search left for writing files.
        choice: what each primitive takes, if the choice was left to `osculant.approximate`.
        predict: called at most once, when `predicted` or its like is first asked for.
        certificate: what `certify` proved; None until it is called, which alone sets it.

    >>> from types import SimpleNamespace
    >>> from osculant.pieces.conics import Piece
    >>> pieces = (
    ...     Piece("parabola", (0.0, 1.0), (0.0, 0.0), (1.0, 1.0), (0.5, 0.0), 1.0, 1e-3),
    ...     Piece.segment((1.0, 2.0), (1.0, 1.0), (2.0, 3.0)),
    ... )
    >>> spline = Spline(
    ...     curve=SimpleNamespace(text="t, t**2"), primitive="parabola", metric="hausdorff", rule=None,
    ...     tolerance=0.1, pieces=pieces, judge=lambda: "unknown",
    ... )
    >>> len(spline), spline.knots, spline.error, spline.error_kind
    (2, [0.0, 1.0, 2.0], 0.001, 'estimate')
    >>> spline.evaluate([0.5, 1.5]).tolist()
    [[0.5, 0.25], [1.5, 2.0]]
    """

    curve: CurveText = field(compare=False)
    primitive: str
    metric: str
    rule: str | None
    tolerance: float
    pieces: tuple[PieceLike, ...]
    judge: Callable[[], Minimal] = field(compare=False)
    undecided: tuple[float, ...] = ()
    bridged: tuple[tuple[float, float, float], ...] = ()
    splits: tuple[float, ...] = ()
    closed: bool = False
    split: str = "theory"
    given: Literal["tolerance", "pieces"] = "tolerance"
    gap: float | None = None
    reserved: float = 0.0
    choice: tuple[str, ...] | None = None
    predict: Callable[[], Prediction] | None = field(default=None, compare=False)
    certificate: Certificate | None = field(default=None, init=False, compare=False)

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.pieces)

    def __repr__(self) -> str:
        return (
            f"<Spline of {self.curve.text}: {self.primitive}, {len(self)} pieces, "
            f"error {self.error:.6g}, tolerance {self.tolerance:.6g}>"
        )

    @cached_property
    def chain(self) -> Chain:
        """The pieces as one curve."""
        return Chain(self.pieces)

    @property
    def knots(self) -> list[float]:
        """The parameters where pieces begin and end, one more than there are pieces."""
        return self.chain.knots

    def evaluate(self, t: ArrayLike) -> Floats:
        """Return the spline's points at parameters of the curve.

        On each arc the arc's own parameter is affine in t: a conic's, and the length of circles and helices.
        So the result is on the spline, but in general not the foot of the curve's point at t; it may be
        farther from that than the error.

        Args:
            t: parameters from the first knot to the last, an array of shape (m,), or of any other.

        Returns:
            Points of shape (m, dimension): t's shape with a last axis for the coordinates.

        Raises:
            DomainError: a parameter outside.
        """
        return self.chain.evaluate(t)

    def sample(self, n: int) -> Floats:
        """Return n >= 2 points on each piece, knots once; shape (N(n−1)+1, dimension) for N pieces."""
        return self.chain.sample(n)

    def bounding_box(self) -> Box:
        """Return the lower and upper corners of the box around the pieces, from the extreme points."""
        return self.chain.bounding_box()

    def max_tangent_jump(self) -> float:
        """Return the largest angle in radians between tangent lines where arcs meet, at cusps 0 too."""
        return self.chain.max_tangent_jump()

    @property
    def corner(self) -> float | None:
        """The angle in radians between its tangents at the seam, 0 if it is smooth there; None if open."""
        return self.chain.corner() if self.closed else None

    @property
    def cusps(self) -> list[float]:
        """The knots where the direction of the tangent is reversed."""
        return self.chain.cusps

    @property
    def numbers(self) -> int:
        """How many numbers store it: the coordinates of its start, and those of each piece from there on.

        In the plane a segment takes 2, an arc of a circle 3 (its end and a bulge), a parabola 4 (two control
        points), a conic 5 (a weight besides), a biarc or a cubic 6; in space a segment takes 3, an arc of a
        circle 5, a helix 6, a bihelix 12.
        """
        return self.chain.numbers

    @property
    def errors(self) -> list[float]:
        """The error of each piece, as estimated: those far below the tolerance to 1e-5 of it only."""
        return [float(piece.error) for piece in self.pieces]

    @property
    def _proved(self) -> float | None:
        """The certified upper bound of the error, None if there is none, or none within the tolerance."""
        if self.certificate is None or not self.certificate.within:
            return None
        return self.certificate.upper

    @property
    def error(self) -> float:
        """The largest error of a piece, in the metric "area" the sum; certified, the proved upper bound.

        An upper bound above the tolerance proves nothing that was asked for: the estimate stays, and the
        `certificate` has the enclosure.
        """
        if self._proved is not None:
            return self._proved
        return math.fsum(self.errors) if self.metric == "area" else max(self.errors)

    @property
    def error_kind(self) -> Literal["estimate", "exact", "certified"]:
        """What `error` is: "certified" if it is a proved upper bound, else an "estimate".

        It is "exact" if every piece is a part of the curve itself, to the rounding of its numbers.
        """
        if self._proved is not None:
            return "certified"
        return "estimate" if self.error > 0 else "exact"

    def certify(self, progress: Callable[[float], None] | None = None) -> Certificate:
        """Enclose the error of every piece in ball arithmetic, as `osculant.certificates.splines` says.

        The first call sets `certificate`, the one thing about a spline that changes: from then on `error` is
        the proved upper bound, with the `error_kind` "certified", if that is within the tolerance, and
        `to_json` has it.

        Args:
            progress: called with the part of the pieces done, 0…1.

        Raises:
            DomainError: the metric "area" or a curve in space, for which there are no certificates; a curve
                without formula.
            ToleranceError: an error is proved to be beyond the tolerance, by more than `MEASURED` of it.

        >>> import osculant as osc
        >>> spline = osc.approximate(osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "conic", 1e-4)
        >>> proof = spline.certify()
        >>> proof.within, spline.error_kind, proof.upper < (1 + 1e-5) * proof.lower
        (True, 'certified', True)
        """
        if self.certificate is None:
            if self.metric != "hausdorff":
                raise DomainError(
                    f"Errors in the metric {self.metric!r} cannot be certified: choose 'hausdorff'."
                )
            proof = certify(self.curve, self.pieces, self.tolerance, progress)
            if self.given == "tolerance" and proof.lower > (1 + MEASURED) * self.tolerance:
                raise ToleranceError(
                    f"The error is proved to be at least {proof.lower:.7g}, beyond the tolerance "
                    f"{self.tolerance:.7g}, though {self.error:.7g} was found: ask for a smaller tolerance."
                )
            object.__setattr__(self, "certificate", proof)  # frozen to all others
            return proof
        return self.certificate

    @cached_property
    def minimal(self) -> Minimal:
        """Whether no such spline has fewer pieces, or for a given number of pieces a smaller largest error.

        Such splines are those of the primitive with a knot at every split point, tangent to the curve at
        their knots (polygons: inscribed), whose pieces lie over strictly convex arcs. "proved" is said where
        less is impossible; "by theory" if a theorem's hypotheses are proved in ball arithmetic for the arc of
        every piece, and then the number is as right as the measured errors; else "unknown", as of bihelices,
        whose errors need not grow with their arcs, and of sums of areas.
        """
        return self.judge()

    @cached_property
    def _prediction(self) -> Prediction | None:
        if self.predict is None:
            return None
        try:
            return self.predict()
        except UndecidedError:  # an integral that did not settle is no reason to lose the spline
            return None

    @property
    def predicted(self) -> float | None:
        """The number of pieces that theory predicts, as a real number; None if that is unknown."""
        return None if self._prediction is None else self._prediction.predicted

    @property
    def predicted_pieces(self) -> int | None:
        """The same in whole pieces, rounded up on each stretch; None if that is unknown."""
        return None if self._prediction is None else self._prediction.predicted_pieces

    @property
    def predicted_error(self) -> float | None:
        """The error that theory predicts for so many pieces; None if that is unknown."""
        return None if self._prediction is None else self._prediction.predicted_error

    def to_json(self) -> dict[str, Any]:
        """Return the spline as plain data: `osculant.files.json.data_of` lists the keys."""
        return data_of(self)

    def facts(self, command: str | None = None) -> Facts:
        """What its files tell about it.

        Args:
            command: the command line that made it, to be recorded.
        """
        return Facts(
            curve=self.curve.text,
            primitive=self.primitive,
            pieces=len(self),
            tolerance=self.tolerance,
            metric=self.metric,
            error=self.error,
            error_kind=self.error_kind,
            closed=self.closed,
            given=self.given,
            data=self.to_json,
            command=command,
        )

    def write(self, path: str | os.PathLike[str], *, command: str | None = None, **options: Any) -> Written:
        """Write the spline to a file, whole or not at all; its suffix says how.

        What is written is measured by its own numbers, as rounded, and refused if it leaves the tolerance. A
        spline that was approximated with ``files`` has room for those; another one has no more than its error
        leaves, which suffices for many digits but not for few, nor for curves that stand for others. If a
        number of pieces was given nothing is refused, as no tolerance was.

        Args:
            path: the suffix is one of `osculant.files.registry`, of a format for splines of its dimension;
                "-" and a suffix, such as "-.svg", is standard output.
            command: the command line that made the spline, recorded in the file.
            options: of the format, by the names of its function: `osculant.files.svg.svg` ("knots"),
                `osculant.files.gcode.gcode` ("decimals", "units", "feed", "dialect", "largest_angle",
                "smallest_radius", "largest_radius"), `osculant.files.dxf.dxf` ("entities", "units").

        Returns:
            What was written: its path, format, error, moves and numbers.

        Raises:
            OsculantError: an unknown suffix, or a file that cannot be written.
            DomainError: pieces that the format cannot hold; an option that it has not.
            ToleranceError: a file that would leave the tolerance.
        """
        facts = self.facts(command)
        return write_file(path, self.chain, facts, self.follow, options, kept=self.given == "tolerance")

    @property
    def follow(self) -> Follow | None:
        """What computes the curve's points at parameters, shape (m, dimension); None of no known formula."""
        jets = getattr(self.curve, "jets", None)
        return None if jets is None else lambda t: jets(t)[..., 0]

    def plot(self, path: str | os.PathLike[str] | None = None, axes: Any = None) -> Any:
        """Draw the pieces in alternating colours with the knots marked, by means of matplotlib.

        Args:
            path: a file to draw to, of any kind that matplotlib knows by its suffix.
            axes: matplotlib axes to draw in, for a spline in space of the projection "3d"; new by default.

        Returns:
            The axes.

        Raises:
            OsculantError: matplotlib is not installed, or does not know the suffix, or cannot write the file.
        """
        title = f"{self.curve.text}\n{len(self)} pieces ({self.primitive}), error {self.error:.3g}"
        return draw(self.sample(DRAWN_POINTS), title, path, axes)
