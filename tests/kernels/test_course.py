"""Courses of stretches: turning and length against closed forms, and how many samples resolve an arc."""

import math
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest

from osculant.kernels.bihelices.records import Bihelix
from osculant.kernels.conics.records import Conic
from osculant.kernels.course import (
    MOST,
    MOST_POINTS,
    TIME,
    UNEVEN,
    along,
    farthest,
    lay_out,
    resolving,
    spot,
    spots,
    turns,
)
from osculant.kernels.curves.jets import sample_many
from osculant.kernels.curves.plane import JET_SIZE
from osculant.kernels.operations import TURNING
from tests.kernels.arcs import HERE, PANELS, SPACE, course_of, jet_of

PLANE, IN_SPACE = Conic(), Bihelix()
CIRCLE, FADING, EVEN = "cos(t), sin(t)", "exp(-t/50)*cos(t), exp(-t/50)*sin(t)", "t*cos(t), t*sin(t)"
POWERS, NEAR_CUSP, ROUNDED = "t^9, t^18", "t^2, t^3 + t/100000", "t, sqrt(t^2 + 1/1000000)"


def fading(t):
    """On exp(−t/50)(cos t, sin t) the tangent turns like t."""
    return t, math.hypot(1, 50) * -math.expm1(-t / 50)


def powers(t):
    """(t⁹, t¹⁸) is a parabola."""
    x = t**9
    return math.atan(2 * x), (2 * x * math.hypot(1, 2 * x) + math.asinh(2 * x)) / 4


def near_cusp(t):
    """(t², t³ + εt) from −1: κ changes its sign at ±√(ε/3)."""
    epsilon = 1e-5

    def angle(u):
        return math.atan2(3 * u * u + epsilon, 2 * u)

    flat = math.sqrt(epsilon / 3)
    cuts = [-1.0, *(cut for cut in (-flat, flat) if cut < t), t]
    parts = [-1.0, *(cut for cut in (-0.01, 0.0, 0.01) if cut < t), t]
    path = mp.quad(lambda u: mp.hypot(2 * u, 3 * u * u + epsilon), parts)
    return sum(abs(angle(v) - angle(u)) for u, v in pairwise(cuts)), float(path)


CASES = [
    (CIRCLE, 0.0, 100 * math.pi, lambda t: (t, t)),
    (FADING, 0.0, 200 * math.pi, fading),
    (POWERS, 0.0, 1.0, powers),
    (NEAR_CUSP, -1.0, 1.0, near_cusp),
]


@pytest.mark.parametrize(("text", "a", "b", "exact"), CASES, ids=[case[0] for case in CASES])
def test_turning_and_length_in_the_plane(text, a, b, exact):
    course = course_of(PLANE, jet_of(text), a, b)
    assert (np.diff(course, axis=0)[:, 1:] >= 0).all() and (np.diff(course[:, TIME]) > 0).all()
    assert (course[0, TIME], course[-1, TIME]) == (a, b)
    turned, length = exact(b)
    assert course[-1, 1:] == pytest.approx((turned, length), rel=5e-4)
    # between the rows, too, the turning is as good as `TURNING` leaves room for
    for t in np.linspace(a, b, 101)[1:]:
        found, way = along(course, t)
        assert found == pytest.approx(exact(t)[0], abs=0.05 / 2)
        assert way == pytest.approx(exact(t)[1], abs=0.07 * length)


def test_turning_and_length_in_space():
    course = course_of(IN_SPACE, jet_of("cos(t), sin(t), t/2", 3), 0.0, 300.0, SPACE)
    for t in (1.0, 77.7, 300.0):
        assert along(course, t) == pytest.approx((t / math.sqrt(1.25), t * math.sqrt(1.25)), rel=1e-9)
    course = course_of(IN_SPACE, jet_of(f"{FADING}, 0*t", 3), 0.0, 200 * math.pi, SPACE)
    for t in (1.0, 77.7, 200 * math.pi):
        assert along(course, t) == pytest.approx(fading(t), rel=1e-3)


@pytest.mark.parametrize("at", [0, 100001, 10000001])
@pytest.mark.parametrize("powers", [(2, 3), (9, 18), (3, 4)])
def test_where_the_speed_is_0_the_course_goes_on(at, powers):
    text = ", ".join(f"(t-{at})^{power}" for power in powers)
    last = (
        math.atan2(powers[1], powers[0]),
        float(mp.quad(lambda t: mp.hypot(*(p * t ** (p - 1) for p in powers)), [0, 1])),
    )
    for a, b, times in ((-1.0, 0.0, 1), (0.0, 1.0, 1), (-1.0, 1.0, 2)):
        course = course_of(PLANE, jet_of(text), at + a, at + b, rows=400)
        assert (np.diff(course[:, TIME]) > 0).all()
        assert course[-1, 1:] == pytest.approx([times * x for x in last], rel=1e-3)


@pytest.mark.parametrize(
    ("at", "cusp"), [("1/3", 1 / 3), ("2*pi/3", 2 * math.pi / 3), ("2^(1/3)", 2 ** (1 / 3))]
)
@pytest.mark.parametrize("powers", [(2, 3), (3, 4), (2, 5)])
def test_rounding_at_a_cusp_between_doubles_turns_nothing(at, cusp, powers):
    text = ", ".join(f"(t-{at})^{power}" for power in powers)
    last = math.atan2(powers[1], powers[0])
    for a, b in ((cusp - 1.0, cusp), (cusp, cusp + 1.0)):
        course = course_of(PLANE, jet_of(text), a, b, rows=400)
        assert course[-1, 1] == pytest.approx(last, rel=1e-3)


def test_what_does_not_fit_is_told():
    jet = jet_of(CIRCLE)
    whole = course_of(PLANE, jet, 0.0, 100.0)
    edges = np.linspace(0.0, 100.0, PANELS + 1)
    assert lay_out(PLANE, jet.address, HERE, edges, np.empty((len(whole), 3))) == len(whole)
    assert lay_out(PLANE, jet.address, HERE, edges, np.empty((len(whole) - 1, 3))) == -1
    undefined = jet_of("t, sqrt(t - 1/2)")
    assert lay_out(PLANE, undefined.address, HERE, np.array([0.0, 1.0]), np.empty((MOST, 3))) == -1


def test_the_farthest_arc_turns_as_far_as_is_allowed():
    course = course_of(PLANE, jet_of(FADING), 0.0, 200 * math.pi)
    for a in (0.0, 1.0, 123.4, 600.0):
        assert farthest(course, a, 200 * math.pi, TURNING) == pytest.approx(a + TURNING, abs=1e-6)
        assert farthest(course, a, a + 1.0, TURNING) == a + 1.0
    near = 200 * math.pi - 1.0
    assert farthest(course, near, 200 * math.pi, TURNING) == 200 * math.pi
    course = course_of(PLANE, jet_of(NEAR_CUSP), -1.0, 1.0)
    for a in (-1.0, -0.2, -1e-4):
        for turning in (0.1, 1.0, 3.0):
            b = farthest(course, a, 1.0, turning)
            assert b == 1.0 or turns(course, a, b) == pytest.approx(turning, abs=1e-9)
            assert turns(course, a, b) <= turning + 1e-9


def gaps(jet, a, b, count):
    """The largest parts of the turning and of the length of an arc between equidistant samples."""
    times = np.linspace(a, b, 200 * (count + 1) + 1)
    rows = np.empty((len(times), JET_SIZE))
    sample_many(jet.address, times, rows)
    points, tangents = rows[:, [0, 3]], rows[:, 1] + 1j * rows[:, 4]
    turned = np.cumsum(np.append(0, abs(np.angle(tangents[1:] / tangents[:-1]))))
    length = np.cumsum(np.append(0, np.linalg.norm(np.diff(points, axis=0), axis=1)))
    return turned[-1], *(np.diff(way[::200]).max() / way[-1] for way in (turned, length))


@pytest.mark.parametrize(
    ("text", "a", "b"), [(CIRCLE, 0.0, 50.0), (EVEN, 0.5, 6.0), (FADING, 0.0, 600.0), ("t, t^2", -1.0, 1.0)]
)
def test_even_arcs_are_resolved_by_as_many_points_as_asked_for(text, a, b):
    course = course_of(PLANE, jet_of(text), a, b)
    for points in (1, 8, 40, 1000):
        for start in np.linspace(a, b, 20)[:-1]:
            for end in (start + 1e-3 * (b - start), min(b, start + 5.0)):
                assert resolving(course, start, end, points) == points


@pytest.mark.parametrize(
    ("text", "a", "b"),
    [
        (POWERS, 0.1, 1.0),
        (POWERS, -1.0, -0.01),
        (NEAR_CUSP, -1.0, 1.0),
        (ROUNDED, -1.0, 1.0),
        ("exp(8*t)*cos(t), exp(8*t)*sin(t)", 0.0, 1.0),
    ],
)
def test_uneven_arcs_are_given_more_points(text, a, b):
    jet = jet_of(text)
    course = course_of(PLANE, jet, a, b)
    rng, more, most = np.random.default_rng(4), 0, 0
    for start, end in [(a, b), *np.sort(rng.uniform(a, b, (150, 2)))]:
        count = resolving(course, start, end, 8)
        assert 8 <= count <= MOST_POINTS
        turned, turning, length = gaps(jet, start, end, count)
        more, most = more + (count > 8), most + (count == MOST_POINTS)
        if count < MOST_POINTS:
            # panels say how uneven an arc is on the average: twice as much may be hidden in them
            assert length <= 2 * UNEVEN / 8
            assert turned <= 1.0 or turning <= 2 * UNEVEN / 8
    assert more >= 5
    assert most == 0 or text in (NEAR_CUSP, ROUNDED)


def test_points_are_no_more_than_the_most_unless_asked_for():
    course = course_of(PLANE, jet_of(ROUNDED), -1.0, 1.0)
    assert resolving(course, -1.0, 1.0, 8) == MOST_POINTS
    assert resolving(course, -1.0, 1.0, MOST_POINTS + 7) == MOST_POINTS + 7


def all_spots(course, a, b, points):
    """The parameters of all samples of an arc."""
    at = spots(course, a, b, points)
    return [spot(course, at, i) for i in range(at.steps + 1)]


def test_spots_are_equidistant_without_a_course_and_between_two_rows():
    for course in (np.empty((0, 3)), np.array([[-1.0, 0.0, 0.0], [5.0, 0.1, 6.0]])):
        assert all_spots(course, 1.0, 2.0, 3) == pytest.approx([1.0, 1.25, 1.5, 1.75, 2.0], abs=1e-15)


@pytest.mark.parametrize("ends", [(-1.0, 1.0), (-0.4, 1e-5), (-1e-6, 2e-6), (0.3, 0.30001)])
def test_spots_see_every_row_of_a_course(ends):
    course = course_of(PLANE, jet_of(NEAR_CUSP), -1.0, 1.0)
    for points in (0, 8, 40):
        times = all_spots(course, *ends, points)
        assert (times[0], times[-1]) == ends and len(times) >= points + 2
        assert (np.diff(times) > 0).all()
        inside = course[(course[:, TIME] >= ends[0]) & (course[:, TIME] <= ends[1]), TIME]
        assert all(any(low <= t <= high for t in times) for low, high in pairwise(inside))
