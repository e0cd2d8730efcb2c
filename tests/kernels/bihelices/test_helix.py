"""The short helix and the nearest point on it, against data made independently and the reference solver."""

import math

import numba
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.geometry.short_helices import short_helix as reference
from osculant.kernels.bihelices import helix as kernels
from osculant.kernels.bihelices.foot import foot, nearest
from osculant.kernels.bihelices.helix import place_at, point_at, short_helix, tangent_at


def turned_frame(rng, count):
    """Random right-handed orthonormal frames, (count, 3, 3)."""
    first = rng.normal(size=(count, 3))
    second = np.cross(first, rng.normal(size=(count, 3)))
    first, second = (v / np.linalg.norm(v, axis=1)[:, None] for v in (first, second))
    return np.stack([first, second, np.cross(first, second)], axis=1)


def helix_data(frames, lead, turning, size):
    """End points and tangents of helical arcs from the origin, in a way of its own: axis = third vector.

    ``lead`` is the angle between tangent and normal plane of the axis: its sign is that of the torsion.
    """
    x, y, z = frames[:, 0], frames[:, 1], frames[:, 2]
    lead, turning, size = (a[:, None] for a in (lead, turning, size))
    t0 = np.cos(lead) * y + np.sin(lead) * z
    t1 = np.cos(lead) * (np.cos(turning) * y - np.sin(turning) * x) + np.sin(lead) * z
    half = np.sin(turning / 2)
    step = np.cos(lead) * (np.sin(turning) * y - 2 * half * half * x) + turning * np.sin(lead) * z
    return t0, size * step, t1, (size * turning)[:, 0]


@numba.njit
def round_trips(p, t0, t1, length):
    """(worst end point over length, worst tangent, helices not found)."""
    worst_point, worst_tangent, missed = 0.0, 0.0, 0
    for i in range(p.shape[0]):
        end = (p[i, 0], p[i, 1], p[i, 2])
        a, b = (t0[i, 0], t0[i, 1], t0[i, 2]), (t1[i, 0], t1[i, 1], t1[i, 2])
        kind, _, arc = short_helix((0.0, 0.0, 0.0), a, end, b, 1e-11, 0.0)
        missed += kind < 0
        q, last, _ = place_at(arc, arc.length)
        first = place_at(arc, 0.0)[1]
        for j in range(3):
            worst_point = max(worst_point, abs(q[j] - end[j]) / length[i])
            worst_tangent = max(worst_tangent, abs(last[j] - b[j]), abs(first[j] - a[j]))
    return worst_point, worst_tangent, missed


def test_a_hundred_thousand_round_trips():
    rng = np.random.default_rng(5)
    count = 100_000
    # turnings from 1e-6 to nearly 2π, leads from nearly plane to nearly straight, both hands
    turning = 2 * np.pi * np.concatenate([rng.random(count // 2), rng.random(count // 2) ** 6])
    near = 10.0 ** -rng.uniform(0, 6, count)
    lead = np.where(rng.random(count) < 0.5, rng.uniform(-1, 1, count), 1 - near) * np.pi / 2
    lead *= np.sign(rng.random(count) - 0.5)
    t0, p, t1, length = helix_data(turned_frame(rng, count), lead, turning, 10.0 ** rng.uniform(-6, 6, count))
    point, tangent, missed = round_trips(p, t0, t1, length)
    assert missed == 0
    assert point < 1e-11
    assert tangent < 1e-14


def one(lead, turning, size=1.0, seed=0):
    frame = turned_frame(np.random.default_rng(seed), 1)
    t0, p, t1, length = helix_data(frame, *(np.array([float(a)]) for a in (lead, turning, size)))
    return tuple(map(float, t0[0])), tuple(map(float, p[0])), tuple(map(float, t1[0])), float(length[0])


ZERO = (0.0, 0.0, 0.0)


@settings(max_examples=60, deadline=None)
@given(st.floats(-1.4, 1.4), st.floats(0.3, 6.2), st.floats(1e-6, 1e6), st.integers(0, 99))
def test_parameters_of_helices_that_turn_enough(lead, turning, size, seed):
    t0, p, t1, length = one(lead, turning, size, seed)
    _, residual, arc = short_helix(ZERO, t0, p, t1, 1e-11, 0.0)
    assert residual < 1e-12
    assert arc.length == pytest.approx(length, rel=1e-9)
    assert arc.turning == pytest.approx(turning, rel=1e-7)
    assert arc.curvature == pytest.approx(math.cos(lead) / size, rel=1e-7, abs=1e-9 / size)
    assert arc.torsion == pytest.approx(math.sin(lead) / size, rel=1e-7, abs=1e-9 / size)


@settings(max_examples=40, deadline=None)
@given(st.floats(-1.4, 1.4), st.floats(0.3, 6.0), st.floats(-0.5, 1.5), st.integers(0, 99))
def test_points_and_derivatives(lead, turning, where, seed):
    t0, p, t1, _ = one(lead, turning, 1.0, seed)
    arc = short_helix(ZERO, t0, p, t1, 1e-11, 0.0)[2]
    s, step = where * arc.length, 1e-4
    point, tangent, bend = (np.array(v) for v in place_at(arc, s))
    before, after = (place_at(arc, s + sign * step) for sign in (-1, 1))
    assert np.allclose(np.subtract(after[0], before[0]) / (2 * step), tangent, atol=1e-7)
    assert np.allclose(np.subtract(after[1], before[1]) / (2 * step), bend, atol=1e-7)
    assert np.linalg.norm(tangent) == pytest.approx(1, abs=1e-14)
    assert np.linalg.norm(bend) == pytest.approx(arc.curvature, abs=1e-12)
    assert tuple(point) == point_at(arc, s)
    assert tuple(tangent) == tangent_at(arc, s)


@settings(max_examples=15, deadline=None)
@given(st.floats(-1.3, 1.3), st.floats(0.05, 6.0), st.integers(0, 99))
def test_the_reference_solver_agrees(lead, turning, seed):
    t0, p, t1, _ = one(lead, turning, 1.0, seed)
    arc = short_helix(ZERO, t0, p, t1, 1e-11, 0.0)[2]
    other = reference(ZERO, t0, p, t1)
    for part in (0.3, 0.5, 0.8):
        there = other.helix.at(part * other.length)
        assert np.allclose(point_at(arc, part * arc.length), [float(x) for x in there], atol=1e-12 * turning)
    assert arc.length == pytest.approx(float(other.length), rel=1e-10)


def test_arcs_shorter_than_their_rounding_are_still_followed():
    for turning in (1e-3, 1e-6, 1e-9):
        t0, p, t1, length = one(0.7, turning)
        kind, _, arc = short_helix(ZERO, t0, p, t1, 1e-11, 0.0)
        assert kind >= 0
        assert np.linalg.norm(np.subtract(point_at(arc, arc.length), p)) < 1e-14 * length


def test_degenerate_data():
    up, ahead = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)
    kind, _, arc = short_helix(ZERO, up, (0.0, 0.0, 5.0), up, 1e-11, 0.0)
    assert (kind, arc[4:]) == (kernels.SEGMENT, (0.0, 5.0, 0.0, 0.0, 0.0))
    assert point_at(arc, 2.0) == (0.0, 0.0, 2.0)
    assert short_helix(ZERO, up, (0.0, 0.0, -5.0), up, 1e-11, 0.0)[0] == kernels.ASKEW
    assert short_helix(ZERO, up, (1.0, 0.0, 5.0), up, 1e-11, 0.0)[0] == kernels.ASKEW
    assert short_helix(ZERO, up, ZERO, ahead, 1e-11, 0.0)[0] == kernels.COINCIDENT
    assert short_helix(ZERO, up, (math.nan, 0.0, 0.0), ahead, 1e-11, 0.0)[0] == kernels.UNDEFINED
    kind, residual, _ = short_helix(ZERO, up, (1.0, 0.0, 0.0), ahead, 1e-11, 0.0)
    assert (kind, residual) == (kernels.NOT_COPLANAR, 1.0)
    kind, _, arc = short_helix(ZERO, up, (4.0, 0.0, 0.0), (0.0, 0.0, -1.0), 1e-11, 0.0)
    assert kind == kernels.HALF_CIRCLE
    assert arc[5:] == pytest.approx((2 * math.pi, math.pi, 0.5, 0.0), abs=1e-15)
    assert point_at(arc, math.pi) == pytest.approx((2.0, 0.0, 2.0))


@pytest.mark.parametrize("turning", [0.01, 1.0, 3.0, math.pi, 3.3, 6.2])
@pytest.mark.parametrize("seed", range(5))
def test_plane_data_give_exactly_no_torsion(turning, seed):
    t0, p, t1, length = one(0.0, turning, 1.0, seed)
    kind, _, arc = short_helix(ZERO, t0, p, t1, 1e-11, 0.0)
    assert kind in (kernels.PLANE, kernels.HALF_CIRCLE)
    assert arc.torsion == 0.0
    assert arc.turning == pytest.approx(turning, rel=1e-12)
    assert arc.length == pytest.approx(length, rel=1e-12)


@settings(max_examples=40, deadline=None)
@given(st.floats(-1.4, 1.4), st.floats(0.3, 6.0), st.integers(0, 99))
def test_mirrored_and_reversed(lead, turning, seed):
    t0, p, t1, _ = one(lead, turning, 1.0, seed)
    arc = short_helix(ZERO, t0, p, t1, 1e-11, 0.0)[2]
    mirrored = [(a[0], a[1], -a[2]) for a in (t0, p, t1)]
    other = short_helix(ZERO, mirrored[0], mirrored[1], mirrored[2], 1e-11, 0.0)[2]
    assert other.torsion == pytest.approx(-arc.torsion, abs=1e-9)
    assert other.length == pytest.approx(arc.length, rel=1e-12)
    back = short_helix(p, tuple(-x for x in t1), ZERO, tuple(-x for x in t0), 1e-11, 0.0)[2]
    assert back.torsion == pytest.approx(arc.torsion, abs=1e-9)
    assert np.allclose(point_at(back, 0.3 * back.length), point_at(arc, 0.7 * arc.length), atol=1e-11)


@settings(max_examples=60, deadline=None)
@given(
    st.floats(-1.57, 1.57), st.floats(0.01, 6.2), st.tuples(*[st.floats(-3, 3)] * 3), st.integers(0, 99)
)  # fmt: skip
def test_nearest_points_against_many_samples(lead, turning, p, seed):
    t0, end, t1, _ = one(lead, turning, 1.0, seed)
    kind, _, arc = short_helix(ZERO, t0, end, t1, 1e-11, 0.0)
    assume(kind >= 0)
    places = np.linspace(0, arc.length, 2001)
    distances = [math.dist(point_at(arc, s), p) for s in places]
    found, s = nearest(arc, p)
    assert math.dist(point_at(arc, s), p) == pytest.approx(found, abs=1e-9)
    assert 0 <= s <= arc.length
    assert found <= min(distances) + 1e-12
    assert found >= min(distances) - arc.length / 2000


def test_feet_on_lines_and_circles():
    line = kernels.straight((0.0, 0.0, 1.0), (0.0, 1.0, 0.0), 10.0)
    assert nearest(line, (3.0, 5.0, 5.0)) == pytest.approx((5.0, 5.0))
    assert nearest(line, (0.0, 13.0, 5.0)) == pytest.approx((5.0, 10.0))
    circle = short_helix((2.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -2.0, 0.0), (1.0, 0.0, 0.0), 1e-11, 0.0)[2]
    assert circle.turning == pytest.approx(1.5 * math.pi)
    for angle in (0.2, 1.0, 3.0, 4.5):
        p = (5 * math.cos(angle), 5 * math.sin(angle), 4.0)
        s, away, tangent, stiff = foot(circle, p, 2 * angle + 0.3, 0.0, circle.length)
        assert s == pytest.approx(2 * angle, abs=1e-9)
        assert math.hypot(*away) == pytest.approx(5.0)
        assert np.dot(away, tangent) == pytest.approx(0, abs=1e-12)
        assert stiff > 0
