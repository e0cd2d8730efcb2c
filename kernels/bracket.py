"""The one step of Newton's method within a bracket that all searches for zeros and peaks take."""

from __future__ import annotations

from osculant.kernels.jit import kernel


@kernel
def safeguarded(t: float, step: float, beyond: bool, low: float, high: float) -> tuple[float, float, float]:
    """(next place, low, high) after a visit of t in the bracket [low, high].

    ``beyond`` says that what is sought lies before t, which becomes the bracket's new end.  A ``step`` that
    leads out of the bracket, or is NaN, gives way to bisection.

    >>> safeguarded(0.5, 0.25, False, 0.0, 1.0)
    (0.75, 0.5, 1.0)
    >>> safeguarded(0.5, 0.25, True, 0.0, 1.0)
    (0.25, 0.0, 0.5)
    """
    low, high = (low, t) if beyond else (t, high)
    new = t + step
    if not (new >= low and new <= high):
        new = 0.5 * (low + high)
    return new, low, high
