"""What is asked of an approximation, in the plane or in space: tolerance or number, and where to split."""

from __future__ import annotations

from typing import Any

from osculant.cas.errors import DomainError
from osculant.tolerances import checked_tolerance

#: the tolerance if neither it nor a number of pieces is given
DEFAULT_TOLERANCE = 1e-6
#: whether to split also where only theory wants it: at parabolic points, sextactic points or vertices
SPLITS = ("theory", "never")
#: pieces that can be asked for; the errors of more were rounding
MOST_PIECES = 100_000


def requested(tolerance: Any, pieces: Any) -> tuple[float, int | None]:
    """(the tolerance, the number of pieces or None); without either, the tolerance is 1e-6.

    Raises DomainError if both are given, or a number of pieces that is not a positive whole number, and
    ToleranceError for a tolerance that is not a positive finite number.

    >>> requested("1e-4", None), requested(None, "12"), requested(None, None)
    ((0.0001, None), (1e-06, 12), (1e-06, None))
    """
    if tolerance is not None and pieces is not None:
        raise DomainError(
            f"Both a tolerance, {tolerance}, and a number of pieces, {pieces}, are given: leave one out."
        )
    count = None if pieces is None else _checked_pieces(pieces)
    return checked_tolerance(DEFAULT_TOLERANCE if tolerance is None else tolerance), count


def _checked_pieces(pieces: Any) -> int:
    """The number of pieces as an int."""
    try:
        count = 0 if isinstance(pieces, bool) else int(str(pieces))
    except ValueError:
        count = 0
    if not 1 <= count <= MOST_PIECES:
        given = pieces if str(pieces).strip() else repr(pieces)
        raise DomainError(f"The number of pieces is {given}: give a whole number from 1 to {MOST_PIECES}.")
    return count


def check_split(split: str) -> None:
    """Raises DomainError unless the way to split is one of `SPLITS`.

    >>> check_split("often")
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: The way to split 'often' is unknown: choose theory or never.
    """
    if split not in SPLITS:
        raise DomainError(f"The way to split {split!r} is unknown: choose {' or '.join(SPLITS)}.")
