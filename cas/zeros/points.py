"""The special points of a curve: zeros of forms along it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

#: two zeros nearer than this, in parts of the interval, are one knot
SAME = 2.0**-60


@dataclass(frozen=True)
class SpecialPoint:
    """A zero of one or more forms.

    ``at`` is a ball around the parameter value; ``kinds`` are the forms' names; ``decided`` is False where a
    zero could be neither proved nor excluded.
    """

    at: Any
    kinds: frozenset[str]
    decided: bool = True


def merged(points: Sequence[SpecialPoint], size: Any) -> list[SpecialPoint]:
    """Points in order, as one where they coincide to `SAME` of the interval's size."""
    found: list[SpecialPoint] = []
    for point in sorted(points, key=lambda point: float(point.at.mid())):
        if found and not abs(point.at - found[-1].at) > size * SAME:
            last = found.pop()
            sharper = min(point, last, key=lambda p: float(p.at.rad()))
            point = SpecialPoint(sharper.at, last.kinds | point.kinds, last.decided and point.decided)
        found.append(point)
    return found
