"""What compiled approximators are compared with: the greedy pieces of the front door's own kernels."""

import shutil

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
