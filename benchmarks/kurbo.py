"""Cubics beside kurbo's: `python -m benchmarks.kurbo`, where kurbopy is installed (``pip install kurbopy``).

kurbo's `fit_to_bezpath` halves the interval until each cubic is within the tolerance; it calls the curve, a
Python function here, so its times are mostly those of Python. Both errors are measured in the same way: dense
points of every piece and of its arc, both ways. kurbo's better fit, `fit_to_bezpath_opt`, has no Python form.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from importlib import import_module
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import cKDTree

import osculant as osc

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

CURVES: dict[str, tuple[str, Any, Any]] = {
    "spiral": ("t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    "exponential": ("t, exp(t)", -2, 2),
    "sine": ("t, sin(t)", -2, 2),
    "catenary": ("t, cosh(t)", -3, 3),
}
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
REPEATS = 5
#: points of a whole curve, and of its approximation
POINTS = 200_000


class Sampled:
    """A curve as kurbopy asks for one."""

    def __init__(self, curve: Any, kurbo: Any) -> None:
        self.low, self.high = curve.interval
        self.compiled, self.kurbo = curve.compiled, kurbo

    def sample_pt_deriv(self, part: float) -> tuple[Any, Any]:
        """Point and derivative at a part of the interval."""
        size = self.high - self.low
        (x, dx, _), (y, dy, _) = self.compiled(self.low + size * part)
        return self.kurbo.Point(x, y), self.kurbo.Vec2(size * dx, size * dy)

    def sample_pt_tangent(self, part: float, _sign: float) -> tuple[Any, Any]:
        """Point and tangent there."""
        return self.sample_pt_deriv(part)

    def break_cusp(self, *_ends: float) -> None:
        """There are no cusps."""


def median(job: Callable[[], Any]) -> tuple[float, Any]:
    """(median of the times of a job in seconds, its result), after one run to warm it."""
    result, times = job(), []
    for _ in range(REPEATS):
        before = time.perf_counter()
        job()
        times.append(time.perf_counter() - before)
    return statistics.median(times), result


def distance(one: Floats, other: Floats) -> float:
    """The larger of the distances of either polygon's corners from the other polygon."""
    return max(_away(one, other), _away(other, one))


def _away(points: Floats, line: Floats) -> float:
    near = cKDTree(line).query(points)[1]
    found = np.full(len(points), np.inf)
    for shift in (-1, 0):
        i = np.clip(near + shift, 0, len(line) - 2)
        step = line[i + 1] - line[i]
        part = np.clip(((points - line[i]) * step).sum(1) / (step * step).sum(1), 0, 1)
        found = np.minimum(found, np.hypot(*(points - line[i] - part[:, None] * step).T))
    return float(found.max())


def points_of(path: Any, count: int) -> Floats:
    """Points of a path of kurbo's cubics."""
    cubics = list(path.segments())
    u = np.linspace(0, 1, count // len(cubics) + 1)[1:, None]
    parts = [np.array([[cubics[0].p0.x, cubics[0].p0.y]])]
    for cubic in cubics:
        p0, p1, p2, p3 = (np.array([p.x, p.y]) for p in (cubic.p0, cubic.p1, cubic.p2, cubic.p3))
        steps = [(b - a) for a, b in pairwise((p0, p1, p2, p3))]
        v = 1 - u
        parts.append(p0 + steps[0] * (1 - v**3) + steps[1] * (3 * v * u * u + u**3) + steps[2] * u**3)
    return np.concatenate(parts)


def main() -> int:
    """Print a line for every curve and tolerance."""
    try:
        kurbo = import_module("kurbopy")
    except ImportError:
        print("kurbopy is not installed: pip install kurbopy.", file=sys.stderr)
        return 2
    print("curve        tolerance | osculant pieces error/tol    ms | kurbo pieces error/tol     ms")
    for name, formula in CURVES.items():
        curve = osc.curve(*formula)
        dense = curve.jets(np.linspace(*curve.interval, POINTS))[..., 0]
        for tolerance in TOLERANCES:
            seconds, spline = median(lambda: osc.approximate(curve, "cubic", tolerance))  # noqa: B023
            theirs, path = median(lambda: kurbo.fit_to_bezpath(Sampled(curve, kurbo), tolerance))  # noqa: B023
            own = distance(dense, spline.sample(POINTS // len(spline))) / tolerance
            other = points_of(path, POINTS)
            off = distance(dense, other) / tolerance
            print(
                f"{name:12} {tolerance:9.0e} | {len(spline):15d} {own:9.4f} {1e3 * seconds:5.1f} |"
                f" {len(list(path.segments())):12d} {off:9.4f} {1e3 * theirs:6.1f}"
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
