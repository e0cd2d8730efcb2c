"""Whether a curve is closed, and whether its seam is smooth."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Literal

from osculant.approximation.split_points import as_float
from osculant.cas.errors import DomainError, UndecidedError
from osculant.curves.kept import kept

if TYPE_CHECKING:
    from osculant.curves.curve import FormulaCurve

#: "corner": the ends meet, but the seam stays a knot; "smooth": the formula is periodic, the seam is no knot
Closing = Literal["open", "corner", "smooth"]

#: numbers agree if they cannot be told apart and are known to this part of the curve's size
AGREED = 2.0**-200
#: derivatives compared at the seam
ORDER = 8


@kept
def closing(curve: FormulaCurve, asked: bool | None = None, seam: bool = False) -> Closing:
    """How a curve that is finite on its interval (`FormulaCurve.check_finite`) shall be closed.

    Args:
        curve: with its interval.
        asked: whether it is to be closed; None means that it is if its ends meet.
        seam: whether its ends are a knot in any case, so that there is nothing to be asked.

    Returns:
        "smooth" if `is_periodic`, "corner" if only `is_closed` or the seam is a knot, "open" if not, or if
        asked not to close it.

    Raises:
        DomainError: it is to be closed and its ends do not meet.

    >>> from osculant.curves.plane import PlaneCurve
    >>> [closing(PlaneCurve("cos(t), sin(2*t)", 0, end)) for end in ("pi", "2*pi")]
    ['open', 'smooth']
    >>> closing(PlaneCurve("t^2, t^3 - t", -1, 1))
    'corner'
    >>> closing(PlaneCurve("cos(t), sin(t)", 0, 6.2832), True)
    Traceback (most recent call last):
    ...
    osculant.cas.errors.DomainError: The curve cos(t), sin(t) is not closed: it begins at (1, 0) and ends at
    (0.9999999999, 1.469282041e-05), 1.47e-05 apart: do not ask to close it, or give ends at which it is at
    the same point exactly (2*pi rather than 6.2832).
    """
    if asked is False and not seam:
        return "open"
    if not is_closed(curve):
        if asked:
            raise DomainError(_apart(curve))
        return "open"
    return "smooth" if not seam and is_periodic(curve) else "corner"


def is_closed(curve: FormulaCurve) -> bool:
    """Whether the curve ends where it begins: False is a proof, or the formula loses most of its digits.

    True means that the ends cannot be told apart in ball arithmetic of 320 bits (at least 60 digits of the
    curve's size).

    >>> from osculant.curves.plane import PlaneCurve
    >>> is_closed(PlaneCurve("cos(t), sin(t)", "pi/7", "15*pi/7"))
    True
    """
    from osculant.cas.numbers.balls import PRECISION, precision

    with precision(PRECISION):
        low, high, _ = _interval(curve)
        return _agree(curve, low, high, 0, _size(curve))


def is_periodic(curve: FormulaCurve) -> bool:
    """Whether the formula goes on with period T = b − a beyond the curve's interval [a, b].

    The curve has to be finite on its interval.

    Returns:
        False if the curve is seen to differ one period later, or the formula is not seen to be analytic on
        [b, b + T] (abs, sign or roots may make it another one there). True means that it is analytic on
        [a, b + T], and that α(t + T) and α(t) cannot be told apart, to at least 60 digits, at a with 8
        derivatives and at five points inside: evidence, not a proof.

    >>> from osculant.curves.plane import PlaneCurve
    >>> is_periodic(PlaneCurve("cos(t), sin(t)", 0, "2*pi"))
    True
    >>> is_periodic(PlaneCurve("cos(t), sin(t) + abs(t - 12) + t - 12", 0, "2*pi"))  # is sin(t) for t < 12
    False
    """
    from flint import arb

    from osculant.cas.numbers.balls import PRECISION, precision
    from osculant.cas.zeros.form_zeros import PROBES

    with precision(PRECISION):
        low, high, period = _interval(curve)
        size = _size(curve)
        inside = [arb((low + period * arb(probe)).mid()) for probe in PROBES]
        return (
            _agree(curve, low, high, ORDER, size)
            and all(_agree(curve, at, at + period, 0, size) for at in inside)
            and _analytic(curve, high, high + period)
        )


def _interval(curve: FormulaCurve) -> tuple[Any, Any, Any]:
    """Balls around a, b and T = b − a."""
    from osculant.cas.numbers.balls import constant

    low, high = (constant(end) for end in curve.ends)
    return low, high, high - low


def _size(curve: FormulaCurve) -> Any:
    """How far the curve goes from its first point, by a few samples."""
    from flint import arb

    from osculant.cas.zeros.form_zeros import PROBES

    low, _, period = _interval(curve)
    begin = curve.balls.coefficients(low, 0)
    far = arb(0)
    for probe in PROBES:
        point = curve.balls.coefficients(arb((low + period * arb(probe)).mid()), 0)
        for row, first in zip(point, begin, strict=True):
            far = far.max(abs(row[0] - first[0]))
    return arb(far.mid())


def _agree(curve: FormulaCurve, first: Any, second: Any, order: int, size: Any) -> bool:
    """Whether position and derivatives up to the order cannot be told apart, and are known well enough."""
    period = _interval(curve)[2]
    rows = zip(curve.balls.coefficients(first, order), curve.balls.coefficients(second, order), strict=True)
    for row, other in rows:
        for k, (c, d) in enumerate(zip(row, other, strict=True)):
            unlike = (c - d) * period**k
            if not (unlike.is_finite() and unlike.contains(0) and unlike.rad() <= size * AGREED):
                return False
    return True


def _analytic(curve: FormulaCurve, low: Any, high: Any) -> bool:
    """Whether the formula's Taylor series are seen to be finite on [low, high]."""
    from osculant.cas.zeros.isolate import first_infinite

    try:
        return first_infinite(curve.zeros.evaluate, ("cusp",), low, high) is None
    except UndecidedError:
        return False


def _apart(curve: FormulaCurve) -> str:
    """The sentence for a curve that is not closed."""
    from osculant.cas.numbers.balls import PRECISION, precision

    with precision(PRECISION):
        low, high, _ = _interval(curve)
        ends = [[as_float(row[0]) for row in curve.balls.coefficients(t, 0)] for t in (low, high)]
    begin, end = (", ".join(f"{value:.10g}" for value in point) for point in ends)
    return (
        f"The curve {curve.text} is not closed: it begins at ({begin}) and ends at ({end}), "
        f"{math.dist(*ends):.3g} apart: do not ask to close it, or give ends at which it is at the same "
        "point exactly (2*pi rather than 6.2832)."
    )
