"""Jets sampled by kernels."""

import numpy as np

from osculant.kernels.curves.jets import sample_many
from osculant.kernels.curves.plane import JET_SIZE
from tests.kernels.arcs import jet_of


def test_sample_many_is_the_jet():
    spiral = jet_of("t*cos(t), t*sin(t)")
    times = np.linspace(0.5, 6, 7)
    out = np.empty((7, JET_SIZE))
    sample_many(spiral.address, times, out)
    assert (out == [spiral(t).ravel() for t in times]).all()
