"""Distances and areas between paths and curves, known in closed form."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.files.deviation import area, distance
from osculant.files.strokes import Bezier, Path, Turn, bulged


def circle(t):
    return np.stack([np.cos(t), np.sin(t)], axis=-1)


def turns(radius, angles, centre=(0.0, 0.0)):
    return Path([Turn(centre, 2, (radius, radius), pair) for pair in pairwise(angles)])


@settings(max_examples=50, deadline=None)
@given(st.floats(-9, -1), st.integers(1, 5), st.floats(0.1, 1.4), st.floats(0, 6))
def test_circles_of_another_radius(exponent, count, step, start):
    gap = 10**exponent
    angles = [start + i * step for i in range(count + 1)]
    path = turns(1 + gap, angles)
    assert distance(path, circle, angles) == pytest.approx(gap, rel=1e-6, abs=1e-15)
    strip = ((1 + gap) ** 2 - 1) / 2 * count * step
    assert area(path, circle, angles) == pytest.approx(strip, rel=0.15)


@settings(max_examples=50, deadline=None)
@given(st.floats(-6, -1), st.floats(0, math.tau))
def test_a_shifted_circle(exponent, way):
    """Away by the shift where it goes outwards, whatever the parameters of strokes are."""
    gap = 10**exponent
    angles = np.linspace(0, math.tau, 7).tolist()
    path = turns(1.0, angles, (gap * math.cos(way), gap * math.sin(way)))
    assert distance(path, circle, angles) == pytest.approx(gap, rel=1e-4)


@pytest.mark.parametrize("power", [1, 3, 9])
def test_an_uneven_parameter(power):
    """The sagitta of chords, though most of the parameter's interval is near one end of the curve."""

    def uneven(t):
        return circle(t**power)

    angles = np.linspace(0.1, 2.0, 9)
    path = Path([Bezier((tuple(circle(a)), tuple(circle(b)))) for a, b in pairwise(angles)])
    ends = (angles ** (1 / power)).tolist()
    sagitta = 1 - math.cos((angles[1] - angles[0]) / 2)
    assert distance(path, uneven, ends) == pytest.approx(sagitta, rel=1e-6)


def test_what_a_path_leaves_out_counts():
    """A corner of the curve that a chord cuts off, and a bump that no sample of the path is near."""

    def corner(t):
        return np.stack([np.minimum(t, 1.0), np.maximum(t - 1.0, 0.0)], axis=-1)

    cut = Path([Bezier(((0.0, 0.0), (1.0, 1.0)))])
    assert distance(cut, corner, [0.0, 2.0]) == pytest.approx(0.5**0.5)
    assert area(cut, corner, [0.0, 2.0]) > 0

    def bump(t):
        return np.stack([t, 0.1 * np.exp(-((t - 0.37) ** 2) * 200)], axis=-1)

    straight = Path([Bezier(((0.0, 0.0), (1.0, 0.0)))])
    assert distance(straight, bump, [0.0, 1.0]) == pytest.approx(0.1, rel=1e-4)


def test_where_the_curve_has_no_points_nothing_is_said():
    path = Path([Bezier(((-1.0, 0.0), (1.0, 0.0)))])

    def root(t):
        with np.errstate(invalid="ignore"):
            return np.stack([t, np.sqrt(t)], axis=-1)

    assert distance(path, root, [-1.0, 1.0]) == math.inf


@given(st.floats(-3.0, 3.0), st.floats(0, 1))
def test_strokes(turning, u):
    """A bulge and a turn of one arc; a screw rises evenly."""
    start, end = circle(np.array(0.3)), circle(np.array(0.3 + turning))
    if abs(turning) < 1e-3:
        return
    one = Path([bulged(tuple(start), tuple(end), turning)])
    other = Path([Turn((0.0, 0.0), 2, (1.0, 1.0), (0.3, 0.3 + turning))])
    for path in (one, other):
        assert np.hypot(*path.at(np.array([u]))[0]) == pytest.approx(1.0)
    assert np.allclose(one.at(np.array([0.0, 0.5, 1.0])), other.at(np.array([0.0, 0.5, 1.0])))
    for axis in range(3):
        screw = Path([Turn((0.0, 0.0, 0.0), axis, (1.0, 1.0), (0.3, 0.3 + turning), (2.0, 5.0))])
        x = np.roll(screw.at(np.array([u]))[0], -axis)
        assert x[0] == pytest.approx(2 + 3 * u)
        assert np.allclose(x[1:], circle(np.array(0.3 + u * turning)))
