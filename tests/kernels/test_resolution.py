"""No error is measured on samples that cannot resolve the arc: every piece against dense polygons."""

import math

import numpy as np
import pytest

from osculant.kernels.biarcs import records as biarcs
from osculant.kernels.conics import records as conics
from osculant.kernels.operations import ERROR, SHAPE, A, B
from osculant.kernels.polygons.records import Chord, SpaceChord
from osculant.tolerances import window
from tests.kernels.arcs import HERE, SPACE, jet_of, name_of, spline
from tests.kernels.bihelices.chains import BOTH, independent_error, spline_of
from tests.kernels.distances import polygon, two_sided

UNEVEN = pytest.mark.parametrize(
    ("powers", "tolerance"), [((9, 18, 27), 1e-3), ((9, 18, 27), 1e-5), ((5, 10, 15), 1e-3)]
)
FADING, GROWING = "exp(-t/50)*cos(t), exp(-t/50)*sin(t)", "exp(t/50)*cos(t), exp(t/50)*sin(t)"


def circular(start, tangent, bend, end, count):
    """Points of an arc of a circle, complex; it begins in the direction of the tangent."""
    chord = end - start
    turning = 2 * np.angle(chord / tangent) % (2 * math.pi * math.copysign(1, bend))
    angles = np.linspace(0, turning, count)
    return start + tangent * (np.exp(1j * angles) - 1) / (1j * bend)


def biarc_points(numbers, count):
    """Both arcs of a row, from its junction and curvatures."""
    row = biarcs.Row(*numbers)
    start, tangent = complex(row.x0, row.y0), complex(row.tx0, row.ty0)
    junction, end = complex(row.x1, row.y1), complex(row.x2, row.y2)
    first = circular(start, tangent, row.bend0, junction, count)
    turned = tangent * (1 + 1j * row.bend0 * (first[-1] - start) / tangent)
    points = np.append(first, circular(junction, turned, row.bend1, end, count)[1:])
    assert abs(points[-1] - end) < 1e-12
    return np.stack([points.real, points.imag], axis=1)


def conic_points(numbers, count):
    """The conic of a row, from its weight and control points; of an ellipse equal steps of its angle."""
    row = conics.Row(*numbers)
    start, end = np.array([row.x0, row.y0]), np.array([row.x2, row.y2])
    middle = row.weight * start + row.reach * np.array([row.tx0, row.ty0])
    after = np.linspace(0, 1, count)
    before = 1 - after
    if row.weight < 1:
        angle = math.acos(row.weight)
        after, before = np.sin(after * angle), np.sin(before * angle)
    b0, b1, b2 = before**2, 2 * before * after, after**2
    top = np.outer(b0, start) + np.outer(b1, middle) + np.outer(b2, end)
    return top / (b0 + row.weight * b1 + b2)[:, None]


def chord_points(row, count):
    """The segment of a row, in the plane or in space."""
    start, end = row[SHAPE:].reshape(2, -1)
    return start + np.linspace(0, 1, count)[:, None] * (end - start)


def check(fit, points_of, text, a, b, tolerance, length=None, count=2001, order=2, here=HERE):
    """All pieces have the error that they say, and it is within the tolerance."""
    jet = jet_of(text, order)
    largest = abs(polygon(jet, a, b, count)).max()
    place = here._replace(noise=4 * math.ulp(largest))
    rows, reached, _ = spline(fit, jet, a, b, window(tolerance, math.ulp(largest)), place, length=length)
    assert reached == b
    for row in rows:
        assert row[ERROR] <= tolerance
        curve = polygon(jet, row[A], row[B], count)
        # chords leave circles by an eighth of the square of their angle
        chords = 10 * np.ptp(curve, axis=0).max() / count**2
        found = two_sided(curve, points_of(row, count))
        assert found == pytest.approx(row[ERROR], rel=1e-3, abs=chords)
    return rows


@pytest.mark.parametrize(("a", "length"), [(0.0, None), (100.0, 260.0), (113.1, None)])
def test_spirals_of_many_turns_as_biarcs(a, length):
    rows = check(biarcs.Biarc(), biarc_points, FADING, a, 200 * math.pi, 0.03, length)
    assert (rows[:, B] - rows[:, A]).max() < 2 * math.pi  # the tangent turns like t


@pytest.mark.parametrize("length", [None, 300.0])
def test_spirals_that_grow_as_biarcs(length):
    rows = check(biarcs.Biarc(), biarc_points, GROWING, -628.0, 0.0, 1e-2, length)
    assert (rows[:, B] - rows[:, A]).max() < 2 * math.pi


@pytest.mark.parametrize("fit", [conics.Conic(), conics.Parabola()], ids=name_of)
def test_spirals_of_many_turns_as_conics(fit):
    rows = check(fit, conic_points, FADING, 0.0, 200 * math.pi, 0.03)
    assert (rows[:, B] - rows[:, A]).max() < 2 * math.pi


@UNEVEN
@BOTH
def test_uneven_arcs_as_bihelices(powers, tolerance, rule):
    rows, jet = spline_of(", ".join(f"t^{power}" for power in powers), 0.1, 1.0, tolerance, rule)
    for row in rows:
        assert row[ERROR] <= tolerance
        # the curve's polygon is fine where the curve is fast
        found = independent_error(row, jet, 40001)
        assert found == pytest.approx(row[ERROR], rel=1e-4, abs=1e-8)


@BOTH
def test_spirals_of_many_turns_as_bihelices(rule):
    rows, jet = spline_of(f"{FADING}, t/100", 0.0, 200 * math.pi, 0.03, rule)
    for row in rows:
        assert row[ERROR] <= 0.03
        assert independent_error(row, jet, 8001) == pytest.approx(row[ERROR], rel=1e-3, abs=1e-6)


def test_spirals_of_many_turns_as_polygons():
    rows = check(Chord(), chord_points, FADING, 0.0, 200 * math.pi, 0.03)
    assert (rows[:, B] - rows[:, A]).max() < 2 * math.pi


@UNEVEN
def test_uneven_arcs_as_polygons(powers, tolerance):
    text = ", ".join(f"t^{power}" for power in powers)
    check(SpaceChord(), chord_points, text, 0.1, 1.0, tolerance, count=8001, order=3, here=SPACE)
