"""What theory says about one spline, computed when it is first asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from osculant.approximation.prediction import Complexity


@dataclass(frozen=True)
class Prediction:
    """A complexity at one tolerance and one number of pieces.

    >>> from osculant.approximation.prediction import Complexity
    >>> Prediction.of(Complexity("conic", "hausdorff", 5, ("1.5",), (1,), 15), 1e-5, 15).predicted_pieces
    15
    """

    predicted: float
    predicted_pieces: int
    predicted_error: float

    @classmethod
    def of(cls, law: Complexity, tolerance: float, pieces: int) -> Prediction:
        """The numbers of pieces for the tolerance, and the error of so many pieces."""
        return cls(law.predicted(tolerance), law.predicted_pieces(tolerance), law.predicted_error(pieces))
