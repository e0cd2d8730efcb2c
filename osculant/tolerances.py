"""What tolerances are accepted, and the window in which the errors of pieces shall lie."""

from __future__ import annotations

import math
from typing import Any

from osculant.cas.errors import ToleranceError

#: tolerances below this many rounding units of the largest coordinate are refused
FLOOR_ULPS = 1000
#: a piece's error shall lie in [ε(1−δ), ε]; δ is the larger of this …
WINDOW = 1e-6
#: … and this many rounding units of the largest coordinate, in parts of ε
WINDOW_ULPS = 32


def checked_tolerance(tolerance: Any) -> float:
    """The tolerance as a float; raises ToleranceError unless it is a positive finite number.

    >>> checked_tolerance("1e-6")
    1e-06
    """
    try:
        value = float(tolerance)
    except (TypeError, ValueError):
        raise ToleranceError(f"The tolerance {tolerance!r} is not a number: give one such as 1e-6.") from None
    if not (value > 0 and math.isfinite(value)):
        raise ToleranceError(f"The tolerance is {value:g}: give a positive finite number such as 1e-6.")
    return value


def check_floor(tolerance: float, rounding: float, largest: float) -> None:
    """Raises ToleranceError if doubles cannot carry the tolerance.

    Args:
        tolerance: a length, or an area.
        rounding: what one rounding unit of the largest coordinate does to it, as `Extent.rounding` says.
        largest: that coordinate.

    >>> check_floor(1e-12, math.ulp(6.28), 6.28)
    """
    floor = FLOOR_ULPS * rounding
    if tolerance < floor:
        raise ToleranceError(
            f"The tolerance {tolerance:g} is below the rounding floor {floor:.3g} of coordinates "
            f"as large as {largest:.6g}: choose at least that."
        )


def writing_share(tolerance: float, rounding: float) -> float:
    """The share of a tolerance kept for writing the pieces: a quarter of the window, δε/4.

    That is 2.5e-7 of the tolerance, or 8 rounding units if they are more.

    >>> writing_share(1e-6, math.ulp(6.0)) == 2.5e-13
    True
    """
    return max(WINDOW * tolerance, WINDOW_ULPS * rounding) / 4


def checked_budget(budget: float, largest: float) -> float:
    """What a writer may round by; raises ToleranceError if coordinates cannot be rounded to within it.

    Args:
        budget: how far what is written may be from the pieces.
        largest: their largest absolute coordinate.

    >>> checked_budget(1e-9, 6.0)
    1e-09
    >>> checked_budget(1e-17, 6.0)
    Traceback (most recent call last):
    ...
    osculant.cas.errors.ToleranceError: The error leaves 1e-17 of the tolerance for rounding coordinates of 6,
    which takes 3.55e-15: name the file when approximating, or choose a larger tolerance.
    """
    least = writing_share(0.0, math.ulp(largest)) / 2
    if least <= budget < math.inf:
        return budget
    raise ToleranceError(
        f"The error leaves {budget:.3g} of the tolerance for rounding coordinates of {largest:.3g}, which "
        f"takes {least:.3g}: name the file when approximating, or choose a larger tolerance."
    )


def window(tolerance: float, rounding: float) -> tuple[float, float]:
    """The errors that the search accepts, (low, high), within [ε(1−δ), ε].

    What is left above is the `writing_share`; what is left below, half of it, for measuring again.

    >>> window(1.0, math.ulp(1.0))
    (0.999999125, 0.99999975)
    """
    kept = writing_share(tolerance, rounding)
    return tolerance - 3.5 * kept, tolerance - kept
