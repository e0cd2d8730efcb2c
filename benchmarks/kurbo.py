"""Cubics beside kurbo's: `python -m benchmarks.kurbo PROGRAM`.

The program is that of `benchmarks/kurbo_fits`, made by ``cargo build --release`` there.  It has both fits of
the crate kurbo, compiled with the curves: `fit_to_bezpath` halves the interval until each cubic is within the
tolerance, `fit_to_bezpath_opt` seeks the fewest.  Without a program the first is called by kurbopy
(``pip install kurbopy``), with a Python function for the curve, which then takes most of its time.  Errors
are measured in the same way: dense points of every piece and of its arc, both ways.
"""

from __future__ import annotations

import math
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
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
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
#: so long is a job repeated, in seconds
ENOUGH = 0.3
#: points of a whole curve, and of its approximation
POINTS = 20_000
#: steps towards a nearest point
STEPS = 4
#: what a rival makes: name, seconds, control points (n, 4, 2)
Fit = tuple[str, float, "Floats"]
#: parameters (m,) → points and two derivatives at least, shape (3, 2, m)
Jets = Callable[["Floats"], "Floats"]


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


def fastest(job: Callable[[], Any]) -> tuple[float, Any]:
    """(the least of the times of a job in seconds, its result), after one run to warm it."""
    result, least, began = job(), math.inf, time.perf_counter()
    while time.perf_counter() - began < ENOUGH:
        before = time.perf_counter()
        job()
        least = min(least, time.perf_counter() - before)
    return least, result


def distance(curve: Any, cubics: Floats) -> float:
    """The larger of the distances of points of either, curve and cubics (n, 4, 2), from the other."""
    t, u = np.linspace(*curve.interval, POINTS), np.linspace(0, len(cubics), POINTS)
    there = [lambda at: curve.jets(at).transpose(2, 1, 0), lambda at: path(cubics, at)]
    return max(_away(*there, u, t), _away(*reversed(there), t, u))


def _away(onto: Jets, source: Jets, at: Floats, near: Floats) -> float:
    """The largest distance of a source's points from their nearest ones, by Newton's method from samples."""
    points, low, high = source(at)[0].T, near[0], near[-1]
    t = near[cKDTree(onto(near)[0].T).query(points)[1]]
    for _ in range(STEPS):
        p, rate, bend = onto(t)[:3]
        off = p - points.T
        slope = (rate * rate).sum(0) + (off * bend).sum(0)
        t = np.clip(t - (off * rate).sum(0) / np.where(slope > 0, slope, np.inf), low, high)
    return float(np.hypot(*(onto(t)[0] - points.T)).max())


def path(cubics: Floats, at: Floats) -> Floats:
    """Points and two derivatives of consecutive cubics, the i-th from i to i + 1, shape (3, 2, m)."""
    piece = np.clip(at.astype(int), 0, len(cubics) - 1)
    u, (p, q, r, s) = (at - piece)[:, None], cubics[piece].transpose(1, 0, 2)
    one, two, three = q - p, r - q, s - r
    v = 1 - u
    point = p + one * (1 - v**3) + two * (3 * v * u * u + u**3) + three * u**3
    rate = 3 * (one * v * v + 2 * two * u * v + three * u * u)
    bend = 6 * ((two - one) * v + (three - two) * u)
    return np.stack([point.T, rate.T, bend.T])


def by_program(program: str, name: str, curve: Any, tolerance: float) -> list[Fit]:
    """Both fits of the compiled kurbo."""
    words = [program, name, *map(repr, curve.interval), repr(tolerance)]
    lines = subprocess.run(words, check=True, capture_output=True, text=True).stdout.splitlines()
    found: list[Fit] = []
    while lines:
        fit, microseconds, count = lines[0].split()
        rows, lines = lines[1 : int(count) + 1], lines[int(count) + 1 :]
        cubics = np.array([row.split() for row in rows], dtype=float).reshape(-1, 4, 2)
        found.append((fit, float(microseconds) * 1e-6, cubics))
    return found


def by_kurbopy(_name: str, curve: Any, tolerance: float) -> list[Fit]:
    """The one fit that Python can call."""
    kurbo = import_module("kurbopy")
    seconds, path = fastest(lambda: kurbo.fit_to_bezpath(Sampled(curve, kurbo), tolerance))
    points = [[(p.x, p.y) for p in (c.p0, c.p1, c.p2, c.p3)] for c in path.segments()]
    return [("plain", seconds, np.array(points))]


def kernel_seconds(curve: Any, tolerance: float) -> float:
    """How long the warm search for the pieces takes, without what is done once for a formula."""
    from osculant.approximation.division import divide
    from osculant.approximation.fitting import Fitting
    from osculant.curves.extent import extent
    from osculant.primitives.table import choose
    from osculant.tolerances import window

    fit = choose("cubic", "hausdorff", None, dimension=2, curve=curve.text)
    fitting = Fitting(curve, fit, divide(curve, "cubic"), extent(curve), tolerance)

    def search() -> None:
        for part in fitting.parts:
            part.greedy(*window(tolerance, fitting.rounding))

    return fastest(search)[0]


def main(words: Sequence[str]) -> int:
    """Print a line for every curve, tolerance and rival."""
    try:
        rivals = partial(by_program, words[0]) if words else by_kurbopy
        if not words:
            import_module("kurbopy")
    except ImportError:
        print("Name the program of benchmarks/kurbo_fits, or: pip install kurbopy.", file=sys.stderr)
        return 2
    print("| curve | tolerance | who | cubics | error/tolerance | microseconds a piece |")
    print("|---|---|---|---|---|---|")
    for name, formula in CURVES.items():
        curve = osc.curve(*formula)
        for tolerance in TOLERANCES:
            spline = osc.approximate(curve, "cubic", tolerance)
            own = np.array([[p.start, *p.controls, p.end] for p in spline.pieces])
            fits = [("osculant", kernel_seconds(curve, tolerance), own), *rivals(name, curve, tolerance)]
            for who, seconds, cubics in fits:
                error = distance(curve, cubics) / tolerance
                each = 1e6 * seconds / len(cubics)
                print(
                    f"| {name} | {tolerance:.0e} | {who} | {len(cubics)} | {error:.4f} | {each:.1f} |",
                    flush=True,
                )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
