"""What programs in G-code need of a tolerance: how many decimals, and what is kept for rounding to them."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any

from osculant.cas.errors import DomainError, ToleranceError
from osculant.files.dialects import UNITS, dialect_of

LEAST_DECIMALS = {"mm": 3, "inch": 4, None: 3}
#: more decimals than doubles of ordinary size have
MOST_DECIMALS = 17
#: of the tolerance, what the usual decimals cost at most
ROUNDING = 0.1
#: of the tolerance, what is kept for helices that others stand for: of these there are many more than pieces,
#: and their number falls with the root of it
CONVERTED = 0.9
#: of a last unit, what is kept at first for rounding
EXPECTED = 0.25


def needs(tolerance: float, kinds: Collection[str], **options: Any) -> tuple[float, ...]:
    """What to keep for writing, as lengths: each is worth a trial, and the first if nothing is converted.

    Args:
        tolerance: of the spline, as a length.
        kinds: of the arcs that the spline may have.
        options: those of `gcode`.

    Raises:
        ToleranceError: decimals that are too few for the tolerance.
        DomainError: options that make no sense.

    >>> needs(1e-2, ["arc"]), needs(1.0, ["helix"])
    ((0.00025,), (0.00025, 0.9))
    """
    check(**options)
    decimals = options.get("decimals")
    unit = 10.0 ** -(usual_decimals(tolerance, options.get("units")) if decimals is None else decimals)
    if unit / 2 > tolerance:
        raise ToleranceError(
            f"Rounding to {decimals} decimals moves points by {unit / 2:.3g} and more, and the tolerance is "
            f"{tolerance:.3g}: give {max(0, math.ceil(-math.log10(tolerance)))} decimals or more."
        )
    rounding = min(EXPECTED * unit, tolerance / 2)
    return (rounding, CONVERTED * tolerance) if "helix" in kinds else (rounding,)


def usual_decimals(tolerance: float, units: str | None) -> int:
    """The fewest decimals, at least 3, or 4 of inches, that cost at most a tenth of a tolerance.

    >>> usual_decimals(1e-2, "mm"), usual_decimals(1e-3, None), usual_decimals(1.0, "inch")
    (3, 4, 4)
    """
    return max(LEAST_DECIMALS[units], math.ceil(-math.log10(ROUNDING * tolerance) - 1e-9))


def check(
    *,
    decimals: int | None = None,
    units: str | None = None,
    feed: float | None = None,
    dialect: str = "linuxcnc",
    largest_angle: float | None = None,
    smallest_radius: float = 0.0,
    largest_radius: float | None = None,
) -> None:
    """Raises DomainError for options of `gcode` that make no sense."""
    dialect_of(dialect)
    if units not in (None, *UNITS):
        raise DomainError(f"The units of G-code are 'mm' or 'inch', not {units!r}.")
    if decimals is not None and (type(decimals) is not int or not 0 <= decimals <= MOST_DECIMALS):
        raise DomainError(
            f"The number of decimals is {decimals!r}: give a whole number from 0 to {MOST_DECIMALS}."
        )
    for what, value in (
        ("feed rate", feed),
        ("largest angle", largest_angle),
        ("largest radius", largest_radius),
    ):
        if value is not None and not 0 < value < math.inf:
            raise DomainError(f"The {what} is {value!r}: give a positive finite number.")
    if not 0 <= smallest_radius < math.inf:
        raise DomainError(f"The smallest radius is {smallest_radius!r}: give a finite number, 0 or more.")
    if largest_radius is not None and smallest_radius >= largest_radius:
        raise DomainError(
            f"The smallest radius, {smallest_radius!r}, is not below the largest, {largest_radius!r}: that "
            "leaves no arcs; choose others, or polygons."
        )


def most_decimals(largest: float) -> int:
    """The decimals that a double of this size has, so that more would say nothing.

    >>> most_decimals(6.0), most_decimals(1e6)
    (15, 9)
    """
    return max(0, -math.ceil(math.log10(math.ulp(largest)) - 1e-9)) if largest else MOST_DECIMALS
