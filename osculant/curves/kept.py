"""What is found out about a curve once, and kept on it: curves do not change."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])

#: results of one function that a curve keeps, the last ones
MOST = 128


def kept(function: Function) -> Function:
    """Keep what a function of a curve, its first argument, returns for arguments that can be hashed.

    Whoever gets it must not change it.

    >>> from osculant.curves.plane import PlaneCurve
    >>> @kept
    ... def doubled(curve, number):
    ...     print("computed")
    ...     return 2 * number
    >>> parabola = PlaneCurve("t, t^2")
    >>> doubled(parabola, 2), doubled(parabola, 2)
    computed
    (4, 4)
    """

    @wraps(function)
    def found(curve: Any, *args: Any, **named: Any) -> Any:
        known = curve.__dict__.setdefault("_kept", {}).setdefault(found, {})
        key = (args, tuple(sorted(named.items())))
        try:
            return known[key]
        except KeyError:
            pass
        except TypeError:  # something that has no hash
            return function(curve, *args, **named)
        known[key] = function(curve, *args, **named)
        if len(known) > MOST:
            known.pop(next(iter(known)), None)
        return known[key]

    return cast(Function, found)
