"""Speed of the main job, as a table: `make bench`.

Everything is measured in one run: one warm thread for the kernels, compile time excluded; a formula never
seen before in a warm process; a fresh process with warm disk caches.  Medians of repeated runs.
"""

from __future__ import annotations

import ctypes
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

import osculant as osc
from osculant.approximation.arcs import Arcs
from osculant.approximation.division import divide
from osculant.approximation.fitting import Fitting
from osculant.codegen.jets import compile_jet
from osculant.curves.extent import extent
from osculant.kernels import search
from osculant.kernels.curves.jets import sample_many
from osculant.kernels.curves.plane import JET_SIZE
from osculant.primitives.table import PRIMITIVES, choose
from osculant.tolerances import window

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
CONE = ("t*cos(t), t*sin(t), t", "pi/6", "2*pi")
REPEATS = 400
#: what the rows of the kernels are held to
WANTED = {("conic", 1e-8): "2 µs, 30 samples", ("biarc", 1e-6): "10 µs"}


def median_seconds(job: Callable[[], object], repeats: int) -> float:
    """The median time of a job in seconds, after one run to warm it."""
    job()
    times = []
    for _ in range(repeats):
        before = time.perf_counter()
        job()
        times.append(time.perf_counter() - before)
    return statistics.median(times)


class KernelRun:
    """The greedy kernel on the one stretch of a spiral, in the plane or on a cone, as `Fitting` calls it."""

    def __init__(
        self, primitive: str, tolerance: float, metric: str = "hausdorff", dimension: int = 2
    ) -> None:
        self.curve = osc.curve(*(SPIRAL if dimension == 2 else CONE))
        fit, size = choose(primitive, metric, dimension=dimension), extent(self.curve)
        (part,) = Fitting(self.curve, fit, divide(self.curve, primitive), size).parts
        assert isinstance(part, Arcs)
        self.table = np.empty((8192, part.columns))
        self.job = part.job(*window(tolerance, size.rounding(fit.degree)))

    def __call__(self, address: int | None = None) -> int:
        """Run once, on the compiled jet or on another one at ``address``; returns the pieces."""
        count, _, _ = search.spline(*self.job._replace(address=address or self.job.address), self.table)
        return int(count)

    def samples(self) -> int:
        """Evaluations of the curve in one run, counted by a jet that calls back."""
        calls = 0
        compiled = self.curve.compiled

        @ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_void_p)
        def counting(t: float, out: int) -> None:
            nonlocal calls
            calls += 1
            compiled._call(t, out)

        address = ctypes.cast(counting, ctypes.c_void_p).value
        assert address is not None
        self(address)
        return calls


def kernel_rows() -> list[tuple[str, str, str]]:
    """Time and samples per piece of the spiral."""
    rows = []
    for primitive in PRIMITIVES[2]:
        for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
            run = KernelRun(primitive, tolerance)
            pieces = run()
            seconds = median_seconds(run, REPEATS)
            wanted = WANTED.get((primitive, tolerance), "")
            found = f"{1e6 * seconds / pieces:.2f} µs, {run.samples() / pieces:.1f} samples"
            rows.append((f"spiral, {tolerance:g}, {pieces} × {primitive}: per piece", found, wanted))
    return rows


def area_rows() -> list[tuple[str, str, str]]:
    """Time per piece of the spiral for the least n with n pieces of area ε/n, all passes together."""
    rows = []
    curve = osc.curve(*SPIRAL)
    for primitive in PRIMITIVES[2]:
        fit, division = choose(primitive, "area"), divide(curve, primitive)
        fitting = Fitting(curve, fit, division, extent(curve))
        for tolerance in (1e-4, 1e-6):
            pieces = fitting.for_area(tolerance).count
            seconds = median_seconds(partial(fitting.for_area, tolerance), REPEATS)
            wanted = "10 µs" if (primitive, tolerance) == ("conic", 1e-6) else ""
            name = f"spiral, area {tolerance:g} in all, {pieces} × {primitive}: per piece"
            rows.append((name, f"{1e6 * seconds / pieces:.2f} µs", wanted))
    return rows


def space_rows() -> list[tuple[str, str, str]]:
    """Time and samples per piece of the spiral on a cone."""
    rows = []
    for primitive in PRIMITIVES[3]:
        run = KernelRun(primitive, 1e-6, dimension=3)
        pieces = run()
        seconds = median_seconds(run, REPEATS // 4)
        found = f"{1e6 * seconds / pieces:.2f} µs, {run.samples() / pieces:.1f} samples"
        wanted = "50 µs" if primitive == "bihelix" else ""
        rows.append((f"spiral on a cone, 1e-06, {pieces} × {primitive}: per piece", found, wanted))
    return rows


def jet_rows() -> list[tuple[str, str, str]]:
    """The jet compiler on the spiral: compile time, and time per evaluation from a kernel."""
    curve = osc.curve(*SPIRAL)
    compiling = median_seconds(lambda: compile_jet(curve.coordinates, 5), 30)
    times = np.linspace(*curve.interval, 100_000)
    out = np.empty((len(times), JET_SIZE))
    calling = median_seconds(lambda: sample_many(curve.compiled.address, times, out), 30) / len(times)
    return [
        ("the spiral's jet of order 5 to machine code", f"{1e3 * compiling:.1f} ms", ""),
        ("one evaluation of its jet of order 2 in a kernel", f"{1e9 * calling:.0f} ns", ""),
    ]


#: families of formulas in n: one without special points, one with ten and more
NEW_FORMULAS = {
    "plain": "(t+{n}/9)*cos(t), (t+1/{n})*sin(t)+t/{n}",
    "wiggly, 10 to 60 split points": "t*cos(t)+sin({n}*t)/({n}*{n}+40), t*sin(t)+t^2/({n}+17)",
}


def again_rows() -> list[tuple[str, str, str]]:
    """The same curve object again, through the API."""
    rows = []
    for primitive, tolerance, wanted in (("conic", 1e-8, "250 µs"), ("biarc", 1e-6, ""), ("cubic", 1e-6, "")):
        curve = osc.curve(*SPIRAL)
        count = len(osc.approximate(curve, primitive, tolerance))
        seconds = median_seconds(partial(osc.approximate, curve, primitive, tolerance), REPEATS)
        name = f"`osculant.approximate`, the same curve again, {count} × {primitive}"
        rows.append((name, f"{1e6 * seconds:.0f} µs", wanted))
    return rows


def new_formula_rows() -> list[tuple[str, str, str]]:
    """Formulas never seen before, from text to the first spline, in a warm process."""
    rows = []
    for name, family in NEW_FORMULAS.items():
        times = []
        for n in range(2, 22):
            before = time.perf_counter()
            osc.approximate(osc.curve(family.replace("{n}", str(n)), "pi/6", "2*pi"), "conic", 1e-6)
            times.append(time.perf_counter() - before)
        found = f"{1e3 * statistics.median(times):.0f} ms (worst of 20: {1e3 * max(times):.0f} ms)"
        wanted = "10 ms" if name == "plain" else "15 ms"
        rows.append((f"a new formula ({name}) to its first spline, warm process", found, wanted))
    return rows


def fresh_process_row() -> tuple[str, str, str]:
    """The command line as a new process, disk caches warm."""
    command = [str(Path(sys.executable).with_name("osculant")), "approximate", SPIRAL[0]]
    command += ["--from", SPIRAL[1], "--to", SPIRAL[2], "--with", "conic", "--tolerance", "1e-6", "--json"]
    seconds = median_seconds(lambda: subprocess.run(command, check=True, capture_output=True), 7)
    return "`osculant approximate`, fresh process, warm disk caches", f"{seconds:.2f} s", "0.4 s"


def main() -> None:
    """Print the table."""
    table = Table("what", "measured", "wanted", title="osculant, one thread")
    for row in (
        *kernel_rows(),
        *area_rows(),
        *space_rows(),
        *jet_rows(),
        *again_rows(),
        *new_formula_rows(),
        fresh_process_row(),
    ):
        table.add_row(*row)
    Console(width=130).print(table)


if __name__ == "__main__":
    main()
