"""Chains of bihelices as rows of the kernels' table: made by the search, and looked at anew."""

import math

import numpy as np
import pytest

from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS
from osculant.kernels.bihelices.helix import Helix
from osculant.kernels.bihelices.records import END, LEFT, RIGHT, Bihelix
from osculant.kernels.curves.space import Place
from osculant.kernels.operations import ERROR, A, B
from osculant.tolerances import window
from tests.kernels.arcs import SPACE, jet_of, spline
from tests.kernels.distances import polygon, two_sided

CONICAL, MOMENT = "t*cos(t), t*sin(t), t", "t, t^2, t^3"
BOTH = pytest.mark.parametrize("rule", [THESIS, EQUIOSCILLATING])


def place_of(jet, a, b):
    """The kernel's coordinates for a curve, and its largest coordinate."""
    values = np.array([jet(t)[:, 0] for t in np.linspace(a, b, 33)])
    scale = 2.0 ** -math.frexp(abs(values).max())[1]
    return Place(*map(float, values[0]), scale, SPACE.noise), float(abs(values).max())


def spline_of(text, a, b, tolerance, rule, capacity=1000):
    """(rows of the spline, with errors in the user's units, jet)."""
    jet = jet_of(text, 3)
    place, largest = place_of(jet, a, b)
    errors = tuple(place.scale * error for error in window(tolerance, math.ulp(largest)))
    rows, reached, _ = spline(Bihelix(rule), jet, a, b, errors, place, capacity)
    rows[:, ERROR] /= place.scale
    assert reached == b
    return rows, jet


def helices(row):
    """Both helices of a piece."""
    numbers = row[LEFT:RIGHT], row[RIGHT:END]
    return tuple(Helix(n[0:3], n[3:6], n[6:9], n[9:12], *n[12:]) for n in numbers)


def helix_points(helix, s):
    """Points and tangents of a helix, written anew."""
    p, tangent, along, side, rate = helix[:5]
    if rate == 0:
        return p + s[:, None] * tangent, np.tile(tangent, (len(s), 1))
    out = tangent - along
    x = (rate * s)[:, None]
    points = p + s[:, None] * along + np.sin(x) / rate * out + 2 * np.sin(x / 2) ** 2 / rate * side
    return points, along + np.cos(x) * out + np.sin(x) * side


def independent_error(row, jet, count):
    """The two-sided distance of curve and piece, between polygons of so many corners."""
    pieces = [helix_points(helix, np.linspace(0, helix.length, count // 2))[0] for helix in helices(row)]
    return two_sided(polygon(jet, row[A], row[B], count), np.vstack([pieces[0], pieces[1][1:]]))


def check_chain(table, jet):
    """End to end: points and tangents of curve and helices, in the order of the table."""
    previous = None
    # rounding is that of the whole
    largest = 2 * max(abs(jet(t)[:, 0]).max() for t in table[:, [A, B]].ravel())
    for row in table:
        left, right = helices(row)
        size = left.length + right.length
        # helices between nearly equal tangents are known up to the rounding of those
        tangents = np.array([left.tangent, right.tangent, row[END + 3 : END + 6]])
        change = max(1e-16, np.linalg.norm(np.diff(tangents, axis=0), axis=1).min())
        near = (1e-11 + min(1e-9, 4e-16 / change)) * size + 1e-14 * largest
        ends = [helix_points(h, np.array([0.0, h.length])) for h in (left, right)]
        assert np.linalg.norm(ends[0][0][0] - jet(row[A])[:, 0]) <= near
        assert np.linalg.norm(ends[0][0][1] - ends[1][0][0]) <= near
        assert np.linalg.norm(ends[1][0][1] - jet(row[B])[:, 0]) <= near
        assert np.linalg.norm(ends[0][1][1] - ends[1][1][0]) <= 2e-14
        for (_, tangents), t, k in ((ends[0], row[A], 0), (ends[1], row[B], 1)):
            velocity = jet(t)[:, 1]
            assert np.linalg.norm(tangents[k] - velocity / np.linalg.norm(velocity)) <= 2e-14
        assert left.turning < 2 * math.pi
        assert right.turning < 2 * math.pi
        assert previous is None or row[A] == previous
        previous = row[B]


def smooth_text(c):
    """A regular curve: the speed's x part is at least 1/2."""
    y = f"({c[0]:.6f})*t^2+({c[1]:.6f})*t^3+({c[2]:.6f})*sin(2*t)+({c[3]:.6f})*cos(3*t)"
    z = f"({c[4]:.6f})*t^2+({c[5]:.6f})*t^3+({c[6]:.6f})*sin(3*t)+({c[7]:.6f})*cos(2*t)"
    return f"t+({c[8]:.6f})*sin(t)/2, {y}, {z}"
