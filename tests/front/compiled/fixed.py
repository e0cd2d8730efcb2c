"""What compiled approximators are compared with: the greedy pieces of the front door's own kernels."""

import shutil
import subprocess

import numpy as np
import pytest

import osculant as osc
from osculant.approximation.division import divide
from osculant.approximation.fitting import Fitting
from osculant.curves.extent import extent
from osculant.primitives.table import choose
from osculant.tolerances import window

#: tests that need a C compiler, and those that need one for C++
needs_cc = pytest.mark.skipif(shutil.which("cc") is None, reason="there is no C compiler cc")
needs_cxx = pytest.mark.skipif(shutil.which("c++") is None, reason="there is no C++ compiler c++")


def greedy(formula, primitive, tolerance, metric="hausdorff", rule=None):
    """(knots, errors) of the pieces that the kernels find through numba, no piece less tried for."""
    curve = osc.curve(*formula)
    fit = choose(primitive, metric, rule, dimension=curve.dimension)
    division, size = divide(curve, primitive, (), "open"), extent(curve)
    fitting = Fitting(curve, fit, division, size, tolerance)
    low, high = window(tolerance, fitting.rounding)
    if metric == "hausdorff":
        runs = [part.greedy(low, high) for part in fitting.parts]
    else:
        count = len(fitting.parts)
        while True:
            runs = [part.greedy(low / count, high / count) for part in fitting.parts]
            if sum(map(len, runs)) <= count:
                break
            count = sum(map(len, runs))
    knots = [*(run.knots[:-1] for run in runs), runs[-1].knots[-1:]]
    return np.concatenate(knots), np.concatenate([run.errors for run in runs])


def knots_of(pieces):
    """The knots of an array of pieces, which have to follow one another."""
    assert (pieces["b"][:-1] == pieces["a"][1:]).all()
    return np.append(pieces["a"], pieces["b"][-1])


def listed(*command):
    """The lines that a command prints."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()


def needs_libm_alone(library):
    """Assert that a library needs functions of libm and of memory alone, and keeps no data of its own."""
    names = {line.split()[-1].split("@")[0] for line in listed("nm", "-D", "-u", library) if " U " in line}
    libm = {"sin", "cos", "tan", "sincos", "atan2", "exp", "log", "pow", "cbrt", "hypot", "floor", "ceil"}
    libm |= {
        name + suffix for name in ("asin", "acos", "atan", "sinh", "cosh", "tanh") for suffix in ("", "h")
    }
    assert names <= libm | {"memcpy", "memset", "memmove", "__stack_chk_fail"}
    symbols = [line.split() for line in listed("nm", library)]
    own = [symbol[-1] for symbol in symbols if symbol[-2] in "dDbBcC"]
    tools = ("_", "completed.")  # what compilers and linkers add
    assert [name for name in own if not name.startswith(tools)] == []
    loaded = [line.split()[0].rsplit("/")[-1] for line in listed("ldd", library)]
    allowed = ("linux-vdso", "linux-gate", "ld-linux", "libm.", "libc.", "statically")
    assert [name for name in loaded if not name.startswith(allowed)] == []
