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


def check_floor(tolerance: float, largest: float) -> None:
    """Raises ToleranceError if doubles as large as ``largest`` cannot carry the tolerance.

    >>> check_floor(1e-12, 6.28)
    """
    floor = FLOOR_ULPS * math.ulp(largest)
    if tolerance < floor:
        raise ToleranceError(
            f"The tolerance {tolerance:g} is below the rounding floor {floor:.3g} of coordinates "
            f"as large as {largest:.6g}: choose at least that."
        )


def writing_reserve(tolerance: float, largest: float) -> float:
    """The share of a tolerance kept for writing the pieces: a quarter of the window, δε/4.

    That is 2.5e-7 of the tolerance, or 8 rounding units of the largest absolute coordinate if they are more.

    >>> writing_reserve(1e-6, 6.0) == 2.5e-13
    True
    """
    return max(WINDOW * tolerance, WINDOW_ULPS * math.ulp(largest)) / 4


def window(tolerance: float, largest: float) -> tuple[float, float]:
    """The errors that the search accepts, (low, high), within [ε(1−δ), ε].

    What is left above is the `writing_reserve`; what is left below, half of it, for measuring again.

    >>> window(1.0, 1.0)
    (0.999999125, 0.99999975)
    """
    reserve = writing_reserve(tolerance, largest)
    return tolerance - 3.5 * reserve, tolerance - reserve
