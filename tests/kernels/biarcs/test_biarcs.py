"""The kernels of biarcs against the reference geometry in 30 digits, and against brute force."""

import cmath
import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.geometry import biarcs as reference
from osculant.kernels.biarcs import family as biarc
from osculant.kernels.biarcs import scan
from osculant.kernels.biarcs.records import Biarc
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import Frame, sample
from tests.kernels.arcs import HERE, MIRRORED, arc, jet_of, spline, visit
from tests.kernels.arcs import best as best_of

FIT = Biarc()
SPIRAL = jet_of("t*cos(t), t*sin(t)")
CIRCLE = jet_of("cos(t), sin(t)")
LINE = jet_of("t, 2*t")


def best(jet, a, b, place=HERE):
    """(error, μ)."""
    return best_of(FIT, arc(jet, a, b, place))


def member(on, mu):
    """The biarc μ between the ends of an arc."""
    return biarc.member(biarc.family(on.start, on.end), mu)


def follow(x, y, tx, ty, bend, chord):
    """Where an arc with that curvature and chord length ends: point and tangent, complex."""
    half = math.asin(max(-1.0, min(1.0, bend * chord / 2)))
    tangent = complex(tx, ty)
    return complex(x, y) + chord * tangent * cmath.exp(1j * half), tangent * cmath.exp(2j * half)


angles = st.floats(0, math.pi - 1e-3)


@settings(max_examples=100)
@given(angles, angles, st.floats(0.02, 0.98), st.floats(0, 6.3), st.floats(-6, 2))
def test_members_are_two_arcs_between_the_frames(alpha, beta, mu, turn, size):
    omega = alpha + beta
    assume(omega < math.pi - 1e-3)
    assume(max(2 * alpha - (1 - mu) * omega, 2 * beta - mu * omega) < math.pi - 1e-3)
    length = 10.0**size
    end = length * cmath.exp(1j * (turn + alpha))
    first, last = cmath.exp(1j * turn), cmath.exp(1j * (turn + alpha + beta))
    start, stop = Frame(0.0, 0.0, first.real, first.imag), Frame(end.real, end.imag, last.real, last.imag)
    fam = biarc.family(start, stop)
    assert biarc.is_proper(fam)
    m = biarc.member(fam, mu)
    assert biarc.is_short(m)
    junction, direction = complex(m.x1, m.y1), complex(m.tx1, m.ty1)
    point, tangent = follow(m.x0, m.y0, m.tx0, m.ty0, m.bend0, abs(junction))
    assert abs(point - junction) < 1e-13 * length and abs(tangent - direction) < 1e-13
    point, tangent = follow(m.x1, m.y1, m.tx1, m.ty1, m.bend1, abs(end - junction))
    assert abs(point - end) < 1e-13 * length and abs(tangent - last) < 1e-13
    if alpha + beta > 1e-3:
        with mp.workdps(30):
            exact = reference.member(
                mp.mpc(0), mp.mpc(first), mp.mpc(end), mp.arg(mp.mpc(last) / mp.mpc(first)), mp.mpf(mu)
            )
            assert abs(exact.junction - junction) < 1e-12 * length
            for bend, other in zip((m.bend0, m.bend1), exact.curvatures):
                assert abs(bend - other) * length < 1e-12 / min(mu, 1 - mu)


def test_equal_tangents_give_a_line_of_junctions():
    start = Frame(0.0, 0.0, 1.0, 0.0)
    m = biarc.member(biarc.family(start, Frame(2.0, 0.5, 1.0, 0.0)), 0.25)
    assert (m.x1, m.y1) == pytest.approx((0.5, 0.125), rel=1e-15)
    m = biarc.member(biarc.family(start, Frame(2.0, 0.0, 1.0, 0.0)), 0.5)
    assert (m.x1, m.y1, m.tx1, m.ty1) == (1.0, 0.0, 1.0, 0.0)
    assert (m.bend0, m.bend1) == (0.0, 0.0)


@settings(max_examples=60)
@given(st.floats(0.6, 5.0), st.floats(0.05, 1.5), st.floats(0.05, 0.95), st.floats(0.1, 0.9))
def test_distance_and_its_derivatives(a, length, x, mu):
    on = arc(SPIRAL, a, a + length)
    m = member(on, mu)
    t = a + x * length

    px, py, sx, sy, speed, bend = sample(on.source, t)
    d, slope, second = biarc.distance(m, px, py, sx, sy, bend)
    ahead = complex(px, py) - complex(m.x1, m.y1)
    base, circle = (0, m.bend0) if ahead.real * m.tx1 + ahead.imag * m.ty1 <= 0 else (8, m.bend1)
    centre = complex(m[base], m[base + 1]) + 1j * complex(m[base + 2], m[base + 3]) / circle
    radial = (1 / abs(circle) - abs(complex(px, py) - centre)) * math.copysign(1, circle)
    assert d == pytest.approx(radial, abs=1e-12 * (1 + 1 / abs(circle)))

    def beside(t):
        return biarc.to_circle(*m[base : base + 4], circle, *np.delete(sample(on.source, t), 4))

    step = 1e-4
    before, after = beside(t - step), beside(t + step)
    assert slope * speed == pytest.approx((after[0] - before[0]) / (2 * step), rel=1e-5, abs=1e-7)
    assert second * speed == pytest.approx((after[1] - before[1]) / (2 * step), rel=1e-5, abs=1e-7)


def test_the_distance_bends_smoothly_over_the_junction():
    m = member(arc(SPIRAL, 2.0, 3.0), 0.45)
    ends = [
        biarc.to_circle(*m[k : k + 4], bend, m.x1 - 0.1 * m.ty1, m.y1 + 0.1 * m.tx1, 0.6, 0.8, 0.3)
        for k, bend in ((0, m.bend0), (4, m.bend1))
    ]
    assert ends[0][:2] == pytest.approx(ends[1][:2], abs=1e-14)


def reference_best(low, high, peaks):
    """(μ, error) of the reference with samples close around the peaks."""

    def curve(t):
        velocity = mp.expj(t) * (1 + 1j * t)
        return t * mp.expj(t), velocity / abs(velocity)

    (p, T), (q, _) = curve(mp.mpf(low)), curve(mp.mpf(high))
    turning = high + mp.atan(high) - low - mp.atan(low)
    parameters = [low + mp.mpf(x) * (high - low) + i * mp.mpf("1e-4") for x in peaks for i in range(-2, 3)]
    return reference.equioscillating(lambda mu: reference.member(p, T, q, turning, mu), curve, parameters)


@pytest.mark.parametrize(("a", "b"), [(0.6, 1.0), (2.0, 3.0), (5.0, 5.1), (1.0, 3.2)])
def test_the_best_member_is_that_of_the_reference(a, b):
    error, mu = best(SPIRAL, a, b)
    fast, fast_mu, settled, peaks = visit(FIT, arc(SPIRAL, a, b), 1e-10)
    assert settled
    assert (fast, fast_mu) == pytest.approx((error, mu), rel=1e-8)
    with mp.workdps(30):
        exact_mu, exact = reference_best(mp.mpf(a), mp.mpf(b), (peaks.first, peaks.last))
        assert float(exact) == pytest.approx(error, rel=1e-6)
        assert float(exact_mu) == pytest.approx(mu, rel=1e-6)


@settings(max_examples=25)
@given(st.floats(0.6, 5.0), st.floats(0.1, 1.0), st.sampled_from([-1e-3, 1e-3, 0.05, -0.05]))
def test_no_other_member_is_better(a, length, off):
    error, mu = best(SPIRAL, a, a + length)
    on = arc(SPIRAL, a, a + length)
    assert scan.measure(member(on, mu + off), on.source, a, a + length, 40, workspace(FIT)) > error
    m = member(on, mu)
    grid = []
    for t in np.linspace(a, a + length, 2001)[1:-1]:
        px, py, sx, sy, _, bend = sample(on.source, t)
        grid.append(biarc.distance(m, px, py, sx, sy, bend)[0])
    assert max(grid) == pytest.approx(error, rel=1e-5)
    assert -min(grid) == pytest.approx(error, rel=1e-5)


def test_the_error_is_that_of_the_theory():
    for length in (0.1, 0.05, 0.025):
        error, _ = best(SPIRAL, 2.0, 2.0 + length)
        t = 2.0 + length / 2
        speed = math.sqrt(1 + t * t)
        slope = (2 * t * (1 + t * t) - 3 * t * (t * t + 2)) / (1 + t * t) ** 2.5 / speed
        assert error == pytest.approx(abs(slope) * (length * speed) ** 3 / 324, rel=length**2)


@settings(max_examples=40)
@given(
    st.sampled_from(
        [
            "t*cos(t), t*sin(t)",
            "cos(t) + t*sin(t), sin(t) - t*cos(t)",
            "exp(t/5)*cos(t), exp(t/5)*sin(t)",
            "exp(3*t)*cos(t), exp(3*t)*sin(t)",
            "t, t^2",
            "t, exp(t)",
        ]
    ),
    st.floats(0.1, 1.0),
    st.floats(0.2, 2.0),
)
def test_errors_grow_with_the_arc(text, first, length):
    """A scan for violations of the monotonicity that greedy splines rest on."""
    jet, last = jet_of(text), first + length
    ends = np.linspace(first, last, 41)
    longer = [best(jet, first, b)[0] for b in ends[5:]]
    shorter = [best(jet, a, last)[0] for a in ends[:-5]]
    assert (np.diff(longer) > 0).all() and (np.diff(shorter) < 0).all()


def test_mirrored_and_reversed_arcs_have_the_same_error():
    mirrored = jet_of("t*cos(t), -t*sin(t)")
    assert best(mirrored, 1.0, 2.0, MIRRORED) == best(SPIRAL, 1.0, 2.0)
    backwards = jet_of("-t*cos(t), t*sin(t)")
    error, mu = best(SPIRAL, 1.0, 2.0)
    assert best(backwards, -2.0, -1.0, MIRRORED) == pytest.approx((error, 1 - mu), rel=1e-9)


def test_arcs_that_turn_too_far_have_no_biarc():
    assert best(CIRCLE, 0.0, 3.1)[0] < 1e-15
    assert best(CIRCLE, 0.0, 3.2)[0] == math.inf
    assert best(SPIRAL, 10.0, 10.0 + 2.5 * math.pi)[0] == math.inf
    error, _, settled, _ = visit(FIT, arc(CIRCLE, 0.0, 3.2), 1e-9, rounds=1)
    assert math.isnan(error) and not settled


def test_arcs_of_a_member_that_turn_too_far_are_seen():
    frames = Frame(0.0, 0.0, 1.0, 0.0), Frame(math.cos(3.0), math.sin(3.0), math.cos(3.0), math.sin(3.0))
    assert [biarc.is_short(biarc.member(biarc.family(*frames), mu)) for mu in (0.02, 0.5)] == [True, False]


def test_straight_arcs_are_finite():
    error, _ = best(LINE, 0.0, 1.0)
    assert error < 1e-15


def test_a_table_too_small_is_filled_and_continued():
    a, b = math.pi / 6, 2 * math.pi
    window = 1e-6 * (1 - 2e-6), 1e-6 * (1 - 1e-7)
    whole, reached, careful = spline(FIT, SPIRAL, a, b, window, length=0.1)
    assert (len(whole), reached, careful) == (91, b, 0)
    part, reached, _ = spline(FIT, SPIRAL, a, b, window, capacity=20, length=0.1)
    assert len(part) == 20
    assert reached == whole[19, 1]
