"""No error is measured on samples that cannot resolve the arc: every piece against dense polygons."""

import math

import numpy as np
import pytest

from osculant.kernels.biarcs import records as biarcs
from osculant.kernels.conics import records as conics
from osculant.kernels.operations import ERROR, A, B
from osculant.tolerances import window
from tests.kernels.arcs import HERE, jet_of, name_of, spline
from tests.kernels.bihelices.chains import BOTH, independent_error, spline_of
from tests.kernels.distances import polygon, two_sided

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
    """The conic of a row, from its weight and control points; equidistant in the angle between tangents."""
    row = conics.Row(*numbers)
    start, end = np.array([row.x0, row.y0]), np.array([row.x2, row.y2])
    middle = row.weight * start + row.reach * np.array([row.tx0, row.ty0])
    u = 0.5 - 0.5 * np.cos(np.linspace(0, math.pi, count))
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
    return (np.outer(b0, start) + np.outer(b1, middle) + np.outer(b2, end)) / (b0 + row.weight * b1 + b2)[
        :, None
    ]


def check(fit, points_of, text, a, b, tolerance, count=4001):
    """All pieces have the error that they say, and it is within the tolerance."""
    jet, high = jet_of(text), tolerance
    largest = abs(polygon(jet, a, b, 2001)).max()
    place = HERE._replace(noise=4 * math.ulp(largest))
    rows, reached, _ = spline(fit, jet, a, b, window(high, math.ulp(largest)), place)
    assert reached == b
    for row in rows:
        assert row[ERROR] <= tolerance
        # chords leave circles by an eighth of the square of their angle
        found = two_sided(polygon(jet, row[A], row[B], count), points_of(row, 2 * count))
        assert found == pytest.approx(row[ERROR], rel=1e-3, abs=largest * 10 / count**2)
    return rows


def test_spirals_of_many_turns_as_biarcs():
    rows = check(biarcs.Biarc(), biarc_points, FADING, 0.0, 200 * math.pi, 0.03)
    assert (rows[:, B] - rows[:, A]).max() < 2 * math.pi  # the tangent turns like t
    check(biarcs.Biarc(), biarc_points, GROWING, -628.0, 0.0, 1e-2)


@pytest.mark.parametrize("fit", [conics.Conic(), conics.Parabola()], ids=name_of)
def test_spirals_of_many_turns_as_conics(fit):
    rows = check(fit, conic_points, FADING, 0.0, 200 * math.pi, 0.03)
    assert (rows[:, B] - rows[:, A]).max() < 2 * math.pi


@pytest.mark.parametrize(
    ("powers", "tolerance"), [((9, 18, 27), 1e-3), ((9, 18, 27), 1e-5), ((5, 10, 15), 1e-3)]
)
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
