"""All peers in one run, as tables of markdown: `python -m benchmarks.peers.table [PYTHON]`.

The peers are those of the extra ``bench`` (``pip install -e '.[bench]'``); one that is not there is called
absent.  SymForce has a fork of symengine that does not go with the original: PYTHON is an interpreter of
another environment, with symforce.
"""

from __future__ import annotations

import platform
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

import osculant as osc
from benchmarks.kurbo import CURVES
from benchmarks.peers import evaluators, fitters
from benchmarks.peers.contest import AbsentError, Job, medians
from benchmarks.peers.splines import error, jump

TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
PACKAGES = ("numpy", "numba", "kurbopy", "fonttools", "cadquery-ocp-novtk", "svgelements", "heyoka", "casadi")
#: an error that is larger by this part is not within the tolerance
MEASURED = 1e-4


def prepared(peers: Mapping[str, Callable[..., Job]], *what: Any) -> tuple[dict[str, Job], dict[str, str]]:
    """(jobs by name, why the others are absent)."""
    jobs, absent = {}, {}
    for name, peer in peers.items():
        try:
            jobs[name] = peer(*what)
        except AbsentError as reason:
            absent[name] = str(reason)
    return jobs, absent


def line(*cells: str) -> None:
    """Print a row."""
    print("| " + " | ".join(cells) + " |", flush=True)


def splines(family: str) -> None:
    """Print the table of one family of pieces."""
    print(f"\n## {family.capitalize()}\n")
    line("curve", "tolerance", "who", family, "error/tolerance", "kept", "largest turn at a knot", "µs")
    line(*["---"] * 8)
    for name, formula in CURVES.items():
        curve = osc.curve(*formula)
        for tolerance in TOLERANCES:
            jobs, absent = prepared(fitters.FAMILIES[family], curve, tolerance)
            seconds = medians(jobs)
            for who, job in jobs.items():
                cubics = job.read(job.run())
                off = error(curve, cubics) / tolerance
                kept = "yes" if off <= 1 + MEASURED else "**no**"
                turn, time = f"{jump(cubics):.1e}", f"{1e6 * seconds[who]:.0f}"
                line(name, f"{tolerance:.0e}", who, str(len(cubics)), f"{off:.4f}", kept, turn, time)
            for who, reason in absent.items():
                line(name, f"{tolerance:.0e}", who, reason, "", "", "", "")


def values(family: str, peers: Mapping[str, Callable[[str], Job]]) -> None:
    """Print the table of who evaluates at many parameters."""
    print(f"\n## {family.capitalize()}, at {evaluators.COUNT} parameters\n")
    line("curve", "who", "largest difference from osculant's, in parts", "ns")
    line(*["---"] * 4)
    for name in evaluators.CURVES:
        jobs, absent = prepared(peers, name)
        for job in jobs.values():
            job.run()
        seconds = medians(jobs)
        own = jobs["osculant"].read(jobs["osculant"].run())
        for who, job in jobs.items():
            other = job.read(job.run())
            off = float((np.abs(other - own) / np.abs(own).max(axis=0)).max())
            line(name, who, f"{off:.1e}", f"{1e9 * seconds[who] / evaluators.COUNT:.1f}")
        for who, reason in absent.items():
            line(name, who, reason, "")


def main(words: Sequence[str]) -> None:
    """Print everything."""
    found = []
    for package in PACKAGES:
        try:
            found.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            found.append(f"{package} absent")
    print(f"Python {platform.python_version()}, {platform.machine()}; {', '.join(found)}.")
    for primitive in ("cubic", "parabola", "biarc", "conic"):  # kernels are compiled before
        fitters.kernel(primitive, osc.curve("t, sin(t)", 0.5, 1), 1e-4).run()
        osc.approximate(osc.curve("t, sin(t)", 0.5, 1), primitive, 1e-4)
    for family in fitters.FAMILIES:
        splines(family)
    symforce = partial(evaluators.symforce, python=words[0] if words else sys.executable)
    for family, peers in evaluators.FAMILIES.items():
        values(family, {**peers, "SymForce": symforce} if family == "invariants" else peers)


if __name__ == "__main__":
    main(sys.argv[1:])
