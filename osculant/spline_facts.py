"""What splines in the plane and in space have in common: knots, errors, predictions."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, Protocol

import numpy as np

from osculant.cas.errors import DomainError, UndecidedError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class PieceFacts(Protocol):
    """A piece as far as a spline's facts need it."""

    @property
    def interval(self) -> tuple[float, float]:
        """The interval of the curve's parameter."""

    @property
    def error(self) -> float:
        """Its error: a distance, or an area."""

    def to_json(self) -> dict[str, Any]:
        """The piece as plain data."""


class CurveText(Protocol):
    """A curve as far as a spline needs it: something with a formula."""

    @property
    def text(self) -> str:
        """The formula."""


class Prediction(Protocol):
    """What theory says about the number of pieces."""

    @property
    def predicted(self) -> float:
        """The real number of the asymptotic formula."""

    @property
    def predicted_pieces(self) -> int:
        """The same in whole pieces, rounded up on each stretch."""

    @property
    def predicted_error(self) -> float:
        """The error of so many pieces as the spline has, by the same formula."""


class Proof(Protocol):
    """A certificate as far as a spline's facts need it."""

    @property
    def lower(self) -> float:
        """What the error is at least."""

    @property
    def upper(self) -> float:
        """What the error is at most, infinite if nothing was proved."""

    @property
    def within(self) -> bool:
        """Whether it is proved that the error is within the tolerance."""

    def to_json(self) -> dict[str, Any]:
        """The certificate as plain data."""


class SplineFacts:
    """The facts of a chain of pieces; `osculant.spline` and `osculant.space_spline` add the geometry."""

    curve: CurveText
    primitive: str
    rule: str | None
    metric: str
    tolerance: float
    minimal: str
    undecided: tuple[float, ...]
    splits: tuple[float, ...]
    pieces: Sequence[PieceFacts]
    complexity: Callable[[], Prediction] | None
    closed: bool = False
    split: str = "theory"
    given: Literal["tolerance", "pieces"] = "tolerance"
    gap: float | None = None
    choice: tuple[str, ...] | None = None

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.pieces)

    def __repr__(self) -> str:
        return (
            f"<{type(self).__name__} of {self.curve.text}: {self.primitive}, {len(self)} pieces, "
            f"error {self.error:.6g}, tolerance {self.tolerance:.6g}>"
        )

    @property
    def knots(self) -> list[float]:
        """The parameters where pieces begin and end, one more than there are pieces."""
        return [float(self.pieces[0].interval[0]), *(float(piece.interval[1]) for piece in self.pieces)]

    def _places(self, t: ArrayLike) -> tuple[Any, Any, Any]:
        """Parameters and knots as arrays, and in which piece each parameter is; DomainError if in none."""
        t = np.asarray(t, dtype=np.float64)
        knots = np.array(self.knots)
        outside = ~((t >= knots[0]) & (t <= knots[-1]))
        if outside.any():
            raise DomainError(
                f"The spline has no point at t = {float(t[outside].flat[0])!r}; "
                f"its parameters go from {knots[0].item()!r} to {knots[-1].item()!r}."
            )
        return t, knots, np.clip(np.searchsorted(knots, t, side="right") - 1, 0, len(self) - 1)

    @property
    def errors(self) -> list[float]:
        """The error of each piece."""
        return [float(piece.error) for piece in self.pieces]

    @property
    def certificate(self) -> Proof | None:
        """The proved bounds of the error; None if none was asked for, as here."""
        return None

    @property
    def error(self) -> float:
        """The largest error of a piece, in the metric "area" the sum; certified, the proved upper bound."""
        if self.certificate is not None and math.isfinite(self.certificate.upper):
            return self.certificate.upper
        return math.fsum(self.errors) if self.metric == "area" else max(self.errors)

    @property
    def error_kind(self) -> Literal["estimate", "exact", "certified"]:
        """What `error` is: "certified" if it is a proved upper bound, else an "estimate".

        It is "exact" if every piece is a part of the curve itself, to the rounding of its numbers.
        """
        if self.certificate is not None and math.isfinite(self.certificate.upper):
            return "certified"
        return "estimate" if self.error > 0 else "exact"

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

    @cached_property
    def _prediction(self) -> Prediction | None:
        if self.complexity is None:
            return None
        try:
            return self.complexity()
        except UndecidedError:  # an integral that did not settle is no reason to lose the spline
            return None

    @property
    def _title(self) -> str:
        """What stands above a picture of it."""
        return f"{self.curve.text}\n{len(self)} pieces ({self.primitive}), error {self.error:.3g}"

    def _json(self, cusps: list[float]) -> dict[str, Any]:
        """Plain data of the spline."""
        predicted = self.predicted
        finite = predicted is not None and math.isfinite(predicted)
        return {
            "curve": self.curve.text,
            "primitive": self.primitive,
            "rule": self.rule,
            "closed": self.closed,
            "split": self.split,
            "given": self.given,
            "gap": self.gap,
            "choice": None if self.choice is None else list(self.choice),
            "metric": self.metric,
            "tolerance": float(self.tolerance),
            "pieces": len(self),
            "knots": self.knots,
            "error": self.error,
            "error_kind": self.error_kind,
            "errors": self.errors,
            "predicted": predicted if finite else None,
            "predicted_pieces": self.predicted_pieces if finite else None,
            "predicted_error": self.predicted_error if finite else None,
            "minimal": self.minimal,
            "undecided": list(map(float, self.undecided)),
            "splits": list(map(float, self.splits)),
            "cusps": cusps,
            "segments": [piece.to_json() for piece in self.pieces],
            "certificate": None if self.certificate is None else self.certificate.to_json(),
        }
