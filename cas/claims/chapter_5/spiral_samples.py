"""Biarcs of arcs of plane curves in many digits: families, best members, members with a given crossing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp

from osculant.cas.geometry.biarcs import Biarc, extremes, member
from osculant.cas.numbers.roots import root_between

#: samples along an arc, and the part of the family at both its ends where no best member is looked for
SAMPLES, NEAR = 16, 6


class Sample:
    """A curve by its velocity's direction, for arcs whose turning is known in closed form.

    Args:
        point: the point, complex.
        angle: the direction of the tangent, continuous along the curve.

    >>> circle = Sample(lambda t: mp.expj(t), lambda t: t + mp.pi / 2)
    >>> mp.nstr(circle.family(0, 1)(mp.mpf(1) / 2).curvatures[0], 6)
    '1.0'
    """

    def __init__(self, point: Callable[[Any], Any], angle: Callable[[Any], Any]) -> None:
        self.point, self.angle = point, angle

    def frame(self, t: Any) -> tuple[Any, Any]:
        """The point and the unit tangent."""
        return self.point(t), mp.expj(self.angle(t))

    def family(self, low: Any, high: Any) -> Callable[[Any], Biarc]:
        """μ to the biarcs of an arc."""
        (p, heading), (q, _) = self.frame(low), self.frame(high)
        turning = self.angle(high) - self.angle(low)
        return lambda mu: member(p, heading, q, turning, mu)

    def places(self, low: Any, high: Any) -> list[Any]:
        """Inner parameters of an arc."""
        return [low + (high - low) * mp.mpf(i) / SAMPLES for i in range(1, SAMPLES)]

    def least(self, low: Any, high: Any) -> Any:
        """The error of the equioscillating member at the samples."""
        family, places = self.family(low, high), self.places(low, high)
        ends = mp.mpf(1) / NEAR, 1 - mp.mpf(1) / NEAR
        mu = root_between(lambda mu: sum(extremes(family(mu), self.frame, places)), *ends)
        return max(abs(d) for d in extremes(family(mu), self.frame, places))

    def through(self, low: Any, high: Any, crossing: Any) -> Biarc:
        """The member through an inner point of the arc."""
        family, at = self.family(low, high), self.frame(crossing)
        ends = mp.mpf(1) / 16, mp.mpf(15) / 16
        return family(root_between(lambda mu: family(mu).displacement(*at), *ends))


def _log_spiral(growth: Any) -> Sample:
    """exp((g + i)t): its curvature falls for g > 0 and grows for g < 0."""
    factor = mp.mpc(growth, 1)
    return Sample(lambda t: mp.exp(factor * t), lambda t: t + mp.arg(factor))


#: curves with monotone κ, by name, each with an arc; the first two have falling κ, the last growing κ
SPIRALS = {
    "Archimedes' spiral": (Sample(lambda t: t * mp.expj(t), lambda t: t + mp.atan(t)), "2", "3"),
    "exp((1/5 + i)t)": (_log_spiral("0.2"), "0", "3.2"),
    "exp((−1/4 + i)t)": (_log_spiral("-0.25"), "0", "2"),
}
#: κ > 0 with a vertex at t = 0
ELLIPSE = Sample(
    lambda t: mp.mpc(2 * mp.cos(t), mp.sin(t)), lambda t: mp.pi / 2 + mp.atan2(2 * mp.sin(t), mp.cos(t))
)
