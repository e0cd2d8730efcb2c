"""What `--split never` would take, said where that is fewer pieces than the knots of theory allow."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from osculant.spline import Spline

#: seconds that it may take
LONG = 3.0
#: seconds between looks at the time: one may be lost in a callback
TICK = 0.25
#: with more pieces it is not asked how many there are without the knots
MOST = 2000


class _TooLongError(BaseException):
    """The search without knots is given up; as an interrupt, nothing on the way catches it."""


def pieces_unsplit(curve: Any, spline: Spline, seconds: float = LONG, **wanted: Any) -> int | None:
    """How many pieces `--split never` takes; None if that is not fewer, or takes too long to find out.

    It can only be fewer if a knot is there because theory wants it: at a sextactic point for conics, a zero
    of the affine curvature for parabolas, a vertex for biarcs.

    Args:
        curve: that is approximated.
        spline: with the knots that theory wants.
        seconds: that it may take, without what compiling kernels takes, which happens once on a machine.
        wanted: the other arguments of `osculant.approximate`.

    >>> import osculant as osc
    >>> curve = osc.curve("t, cosh(t)", -1, 2)
    >>> spline = osc.approximate(curve, "conic", 1e-2)
    >>> len(spline), pieces_unsplit(curve, spline, 60)
    (3, 2)
    """
    from osculant import api
    from osculant.approximation.division import divide
    from osculant.cas.errors import OsculantError

    asked = spline.given == "tolerance" and spline.split == "theory"
    if not (asked and 1 < len(spline) <= MOST and divide(curve, spline.primitive, split="never").unsplit):
        return None
    tolerance = spline.tolerance - spline.reserved
    try:
        with _within(seconds):
            other = api.approximate(curve, spline.primitive, tolerance, split="never", **wanted)
    except (OsculantError, _TooLongError):
        return None
    return len(other) if len(other) < len(spline) else None


@contextmanager
def _within(seconds: float) -> Iterator[None]:
    """Raises `_TooLongError` in what takes longer; at once where there is no way to stop that."""
    from osculant.kernels.jit import CompileClock, watching

    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        raise _TooLongError
    began, compiling = perf_counter(), CompileClock()

    def look(*_: object) -> None:
        if not compiling.running and perf_counter() - began - compiling.seconds >= seconds:
            raise _TooLongError

    before = signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, min(seconds, TICK), TICK)
    try:
        with watching(compiling):
            yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
