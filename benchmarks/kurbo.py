"""Cubics beside kurbo's: `python -m benchmarks.kurbo PROGRAM`.

The program is that of `benchmarks/kurbo_fits`, made by ``cargo build --release`` there.  It has both fits of
the crate kurbo, compiled with the curves: `fit_to_bezpath` halves the interval until each cubic is within the
tolerance, `fit_to_bezpath_opt` seeks the fewest.  Without a program the first is called by kurbopy
(``pip install kurbopy``), with a Python function for the curve, which then takes most of its time.  Errors
are measured in the same way (`benchmarks.peers.splines`).
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

import osculant as osc
from benchmarks.peers.splines import bezier, error

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
#: what a rival makes: name, seconds, control points (n, 4, 2)
Fit = tuple[str, float, "Floats"]


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


def by_kurbopy(curve: Any, tolerance: float) -> tuple[Callable[[], Any], Callable[[Any], list[Any]]]:
    """The one fit that Python can call, and what reads its control points."""
    kurbo = import_module("kurbopy")
    sampled = Sampled(curve, kurbo)

    def read(path: Any) -> list[Any]:
        fours = [(c.p0, c.p1, c.p2, c.p3) for c in path.segments()]
        return [[(p.x, p.y) for p in four] for four in fours]

    return lambda: kurbo.fit_to_bezpath(sampled, tolerance), read


def timed_kurbopy(_name: str, curve: Any, tolerance: float) -> list[Fit]:
    """The same, timed."""
    fit, read = by_kurbopy(curve, tolerance)
    seconds, path = fastest(fit)
    return [("plain", seconds, np.array(read(path)))]


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
        rivals = partial(by_program, words[0]) if words else timed_kurbopy
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
                off = error(curve, np.array([bezier(*four) for four in cubics])) / tolerance
                each = 1e6 * seconds / len(cubics)
                print(
                    f"| {name} | {tolerance:.0e} | {who} | {len(cubics)} | {off:.4f} | {each:.1f} |",
                    flush=True,
                )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
