"""Areas between arcs and biarcs against Green's theorem in 30 digits, and the search for equal moons."""

import math
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics import arc_splines
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry import biarcs as reference
from osculant.cas.numbers.roots import root_between
from osculant.codegen.jets import compile_jet
from osculant.kernels import search as greedy
from osculant.kernels.biarcs import area_exchange as biarc_area
from osculant.kernels.biarcs import area_scan as biarc_moons
from osculant.kernels.biarcs import family as biarc
from osculant.kernels.biarcs import scan as biarc_scan
from osculant.kernels.conics import scan
from osculant.kernels.curves.plane import JET_SIZE

NOISE = 4 * math.ulp(1.0)
#: units of noise times length to which areas are known
ROUNDING = 4.0


def curve_of(text):
    return compile_jet(parse_tuple(text), 2), sp.sympify(text)


SPIRAL = curve_of("t*cos(t), t*sin(t)")
CIRCLE = curve_of("cos(t), sin(t)")
ELLIPSE = curve_of("2*cos(t), sin(t)")
LINE = curve_of("t, 2*t")
FLAT = curve_of("t, t^3/100000")
WAVY = curve_of("t, t^3/2 + cos(200*t)/1000000")


def arc(curve, a, b, flip=1.0):
    """The source, with the noise of coordinates as large as at b, and the frames."""
    scratch = np.empty(JET_SIZE)
    end = greedy.frame((curve[0].address, (0.0, 0.0, 1.0, flip, NOISE), scratch), b)
    noise = NOISE * max(1.0, math.hypot(*end[:2]))
    source = (curve[0].address, (0.0, 0.0, 1.0, flip, noise), scratch)
    return source, greedy.frame(source, a), end


def best(curve, a, b, flip=1.0):
    source, start, end = arc(curve, a, b, flip)
    return biarc_moons.best(source, a, start, b, end, scan.workspace())


def measured(curve, a, b, mu, points=8):
    source, start, end = arc(curve, a, b)
    m = biarc.member(biarc.family(start, end), mu)
    return biarc_moons.measure(m, source, a, b, points, scan.workspace())


def settled(curve, a, b, flip=1.0, rounds=5):
    """The fast step after some rounds: area, μ, unrest."""
    source, start, end = arc(curve, a, b, flip)
    peaks = biarc_area.FIRST_PEAKS
    for _ in range(rounds):
        area, mu, unrest, peaks = biarc_area.exchange(source, a, start, b, end, peaks)
    return area, mu, unrest


def close(area, exact, length, rel=1e-11):
    return abs(area - exact) <= rel * exact + ROUNDING * NOISE * length


# The reference: points and velocities in mpmath, areas by Green's theorem.


def path_of(curve):
    t = sp.Symbol("t")
    x, y = curve[1]
    at = sp.lambdify(t, (x, y, sp.diff(x, t), sp.diff(y, t)), "mpmath")

    def path(u):
        px, py, vx, vy = at(u)
        return mp.mpc(px, py), mp.mpc(vx, vy)

    return path


def family_of(path, a, b):
    (p, v), (q, w) = path(a), path(b)
    return lambda mu: reference.member(p, v / abs(v), q, mp.arg(w / v), mu)


def exact_best(curve, a, b):
    path, a, b = path_of(curve), mp.mpf(a), mp.mpf(b)
    return reference.equisymmetric(family_of(path, a, b), path, a, b)[:2]


def exact_area(curve, a, b, mu, grid=100):
    """The sum of the regions between the crossings that a grid tells, which is dense at the ends."""
    path, a, b = path_of(curve), mp.mpf(a), mp.mpf(b)
    m = family_of(path, a, b)(mp.mpf(mu))

    def displacement(t):
        point, velocity = path(t)
        return m.displacement(point, velocity / abs(velocity))

    times = [(a + b - (b - a) * mp.cos(mp.pi * i / grid)) / 2 for i in range(1, grid)]
    values = [displacement(t) for t in times]
    cuts = [root_between(displacement, t, u) for (t, d), (u, e) in pairwise(zip(times, values)) if d * e < 0]
    return sum(abs(reference.signed_area(m, path, *ends)) for ends in pairwise([a, *cuts, b]))


ARCS = [
    (SPIRAL, 0.6, 1.0),
    (SPIRAL, 1.0, 3.2),
    (SPIRAL, 2.0, 2.05),
    (SPIRAL, 2.0, 2.2),
    (SPIRAL, 2.0, 3.0),
    (SPIRAL, 5.0, 6.5),
    (ELLIPSE, 0.1, 1.4),
    (FLAT, 0.5, 1.0),
    (FLAT, 1.0, 1.3),
]


@pytest.mark.parametrize(("curve", "a", "b"), ARCS)
def test_the_member_with_equal_moons_is_that_of_the_reference(curve, a, b):
    _, start, end = arc(curve, a, b)
    length = math.dist(start[:2], end[:2])
    area, mu, unrest = settled(curve, a, b)
    careful, careful_mu = best(curve, a, b)
    with mp.workdps(30):
        exact_mu, exact = exact_best(curve, a, b)
    assert unrest < 1e-13
    assert close(area, exact, length) and close(careful, exact, length)
    assert close(measured(curve, a, b, mu), exact, length)
    vague = 1e-11 + 10 * NOISE * length / area
    assert (mu, careful_mu) == pytest.approx((float(exact_mu),) * 2, abs=vague)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.6, 5.0), st.floats(0.05, 1.6), st.floats(0.2, 0.8))
@example(1.9853291251739296, 0.4100730219469293, 0.6146794447512975)  # crosses close to an end
def test_areas_of_any_member(a, length, mu):
    b = a + length
    _, start, end = arc(SPIRAL, a, b)
    with mp.workdps(25):
        exact = exact_area(SPIRAL, a, b, mu)
    assert close(measured(SPIRAL, a, b, mu), exact, math.dist(start[:2], end[:2]), 1e-10)


SPIRALS = [
    SPIRAL,
    curve_of("cos(t) + t*sin(t), sin(t) - t*cos(t)"),
    curve_of("exp(t/5)*cos(t), exp(t/5)*sin(t)"),
    curve_of("exp(3*t)*cos(t), exp(3*t)*sin(t)"),
    curve_of("t, t^2"),
    curve_of("t, exp(t)"),
    curve_of("t^2, t^3"),
]


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(SPIRALS), st.floats(0.3, 2.0), st.floats(0.05, 1.0))
def test_fast_and_careful_agree(curve, a, length):
    _, start, end = arc(curve, a, a + length)
    size = math.dist(start[:2], end[:2]) + math.hypot(*end[:2])
    area, mu, unrest = settled(curve, a, a + length, rounds=8)
    careful, careful_mu = best(curve, a, a + length)
    assert unrest < 1e-13
    assert close(area, careful, size)
    assert mu == pytest.approx(careful_mu, abs=1e-10 + 10 * NOISE * size / area)


def test_a_cusp_at_the_end_does_no_harm():
    cusp = curve_of("t^2, t^3")
    source, _, end = arc(cusp, 0.5, 0.7)
    start, peaks = (0.0, 0.0, 1.0, 0.0), biarc_area.FIRST_PEAKS
    for _ in range(6):
        fast, _, unrest, peaks = biarc_area.exchange(source, 0.0, start, 0.7, end, peaks)
    area, mu = biarc_moons.best(source, 0.0, start, 0.7, end, scan.workspace())
    path = path_of(cusp)
    with mp.workdps(30):
        v = path(mp.mpf(0.7))[1]
        exact = reference.equisymmetric(
            lambda mu: reference.member(mp.mpc(0), mp.mpc(1), path(mp.mpf(0.7))[0], mp.arg(v), mu),
            lambda t: path(max(t, mp.mpf("1e-40"))),
            mp.mpf(0),
            mp.mpf(0.7),
        )
    assert (area, mu) == pytest.approx((float(exact[1]), float(exact[0])), rel=1e-11)
    assert fast == pytest.approx(area, rel=1e-11) and unrest < 1e-13


@settings(max_examples=30, deadline=None)
@given(st.sampled_from(SPIRALS[:6]), st.floats(0.1, 1.0), st.floats(0.2, 2.0))
def test_areas_grow_with_the_arc(curve, first, length):
    """A scan for violations of the monotonicity that greedy splines rest on."""
    last = first + length
    ends = np.linspace(first, last, 25)
    longer = [best(curve, first, b)[0] for b in ends[6:]]
    shorter = [best(curve, a, last)[0] for a in ends[:-6]]
    assert all(x < y or x == y == math.inf for x, y in pairwise(longer))
    assert all(x > y or x == y == math.inf for x, y in pairwise(shorter))


def test_places_that_are_off_cost_little():
    """The corrections for the junction's foot and the crossing leave errors of third order or less."""
    source, start, end = arc(SPIRAL, 2.0, 2.5)
    peaks = biarc_area.FIRST_PEAKS
    for _ in range(6):
        area, _, _, peaks = biarc_area.exchange(source, 2.0, start, 2.5, end, peaks)
    for off in (1e-3, -1e-3):
        for foot, crossing, part in ((off, 0.0, 1e-9), (0.0, off, 1e-7)):
            moved = peaks[0] + foot, peaks[1] + crossing, *peaks[2:]
            found, _, unrest, _ = biarc_area.exchange(source, 2.0, start, 2.5, end, moved)
            assert abs(found / area - 1) < part < unrest


def test_the_signed_area_moves_in_one_direction_with_mu():
    source, start, end = arc(SPIRAL, 1.0, 3.0)
    fam, space = biarc.family(start, end), scan.workspace()
    signed = []
    for mu in np.linspace(0.1, 0.9, 33):
        m = biarc.member(fam, mu)
        count = biarc_scan.look(m, source, 1.0, 3.0, 40, space)
        both = biarc_moons.attained(m, source, 1.0, 3.0, space, count)
        assert abs(both[0]) <= both[1]
        signed.append(both[0])
    steps = np.diff(signed)
    assert (steps > 0).all() or (steps < 0).all()
    assert signed[0] * signed[-1] < 0


def constant_of_the_law():
    """The area of a short arc over |κ′|σ⁴: both moons of the biarc whose junction is in the middle."""
    found = arc_splines.biarc()
    moons = [
        sp.integrate(f, (arc_splines.x, low, high)).subs(arc_splines.v, 0) for low, high, f in found.pieces
    ]
    assert sum(moons) == 0
    return float(abs(moons[0] * 2 / arc_splines.KAPPA[1]) / 2 ** (found.order + 1))


def slope_of_curvature(t):
    """dκ/ds of the spiral."""
    return (2 * t * (1 + t * t) - 3 * t * (t * t + 2)) / (1 + t * t) ** 3


def test_the_area_is_that_of_the_theory():
    constant = constant_of_the_law()
    for length in (0.2, 0.1, 0.05, 0.025):
        area, _ = best(SPIRAL, 2.0, 2.0 + length)
        t = 2.0 + length / 2
        law = constant * abs(slope_of_curvature(t)) * (length * math.hypot(1, t)) ** 4
        assert area == pytest.approx(law, rel=length**2 / 50)


@pytest.mark.parametrize("length", [1e-2, 3e-3, 1e-3, 1e-4, 1e-6])
def test_tiny_arcs_are_good_to_rounding(length):
    """A hundredth is well above it, 1e-4 far below."""
    a, b = 2.0, 2.0 + length
    law = constant_of_the_law() * abs(slope_of_curvature(2.0)) * (length * math.hypot(1, 2.0)) ** 4
    vague = ROUNDING * NOISE * 2.3 * length + length * law
    for mu in (0.3, 0.5):
        with mp.workdps(40):
            exact = exact_area(SPIRAL, a, b, mu)
        assert abs(measured(SPIRAL, a, b, mu) - exact) < ROUNDING * NOISE * 2.3 * length
    careful, _ = best(SPIRAL, a, b)
    assert abs(careful - law) < vague
    fast, _, unrest = settled(SPIRAL, a, b)
    assert not unrest < 1e-6 or abs(fast - law) < vague


def test_mirrored_and_reversed_arcs_have_the_same_area():
    mirrored, backwards = curve_of("t*cos(t), -t*sin(t)"), curve_of("-t*cos(t), t*sin(t)")
    area, mu, _ = settled(SPIRAL, 1.0, 2.0)
    assert settled(mirrored, 1.0, 2.0, -1.0)[:2] == (area, mu)
    assert settled(backwards, -2.0, -1.0, -1.0)[:2] == pytest.approx((area, 1 - mu), rel=1e-11)
    assert best(mirrored, 1.0, 2.0, -1.0) == best(SPIRAL, 1.0, 2.0)
    assert best(backwards, -2.0, -1.0, -1.0) == pytest.approx((area, 1 - mu), rel=1e-11)


def test_circles_and_lines_have_no_area():
    for curve, b in ((CIRCLE, 3.1), (CIRCLE, 0.1), (LINE, 1.0)):
        assert best(curve, 0.0, b)[0] <= ROUNDING * NOISE * b
        for mu in (0.2, 0.5, 0.9):
            assert measured(curve, 0.0, b, mu) <= ROUNDING * NOISE * b
        area, _, _ = settled(curve, 0.0, b)
        assert math.isnan(area) or area <= ROUNDING * NOISE * b


def test_arcs_that_turn_by_almost_pi():
    """t + atan t from 1 to the end is a little less than π."""
    with mp.workdps(30):
        end = mp.findroot(lambda t: t + mp.atan(t) - 1 - mp.atan(1) - mp.pi + mp.mpf("0.02"), 3.5)
        _, exact = exact_best(SPIRAL, 1.0, float(end))
    area, mu = best(SPIRAL, 1.0, float(end))
    assert area == pytest.approx(float(exact), rel=1e-11)
    fast, fast_mu, unrest = settled(SPIRAL, 1.0, float(end), rounds=8)
    assert (fast, fast_mu) == pytest.approx((area, mu), rel=1e-11) and unrest < 1e-13


def test_there_is_none():
    assert best(CIRCLE, 0.0, 3.2)[0] == math.inf
    assert best(SPIRAL, 10.0, 10.0 + 2.5 * math.pi)[0] == math.inf
    assert math.isnan(settled(CIRCLE, 0.0, 3.2)[0])


def test_without_equal_moons_the_least_area_is_taken():
    # about a vertex all members are one circle, and it lies on one side of the curve
    area, mu = best(ELLIPSE, -0.5, 0.5)
    assert close(area, exact_area(ELLIPSE, -0.5, 0.5, mu), 1.0)
    assert settled(ELLIPSE, -0.5, 0.5)[2] == math.inf
    assert close(measured(ELLIPSE, -0.5, 0.5, 0.5), exact_area(ELLIPSE, -0.5, 0.5, 0.5), 1.0)


def test_arcs_that_are_not_beside_the_biarc_are_seen():
    source, _, end = arc(SPIRAL, 2.0, 3.0)
    shorter = biarc.member(biarc.family(greedy.frame(source, 2.2), end), 0.5)
    assert biarc_moons.measure(shorter, source, 2.0, 3.0, 8, scan.workspace()) == math.inf
    wide = (0.0, 0.0, 1.0, 0.0), (math.cos(3.0), math.sin(3.0), math.cos(3.0), math.sin(3.0))
    long = biarc.member(biarc.family(*wide), 0.5)
    assert not biarc.is_short(long)
    assert biarc_moons.measure(long, source, 2.0, 3.0, 8, scan.workspace()) == math.inf


def test_crossings_between_the_samples_are_found():
    """One sample in the middle, and a biarc that crosses the waves several times."""
    with mp.workdps(25):
        for a, b, mu, points in ((0.5, 1.0, 0.45, 8), (0.5, 0.55, 0.5, 1)):
            exact = exact_area(WAVY, a, b, mu, grid=1000)
            assert measured(WAVY, a, b, mu, points) == pytest.approx(float(exact), rel=1e-9)


def test_the_fast_step_knows_when_its_nodes_are_too_few():
    wild = curve_of("t, t^3/2 + sin(1000*t)/100000000")
    assert settled(wild, 0.5, 0.7)[2] == math.inf
    assert math.isfinite(best(wild, 0.5, 0.7)[0])


def test_the_settled_fast_step_is_reproducible():
    """From other first places it ends at the same area to eleven digits, of an arc well above rounding."""
    source, start, end = arc(SPIRAL, 2.0, 2.5)
    found = []
    for foot, crossing, mu in ((0.5, 0.5, 0.5), (0.45, 0.55, 0.4), (0.55, 0.45, 0.6)):
        peaks = (foot, crossing, mu, 0.0)
        for _ in range(6):
            area, _, unrest, peaks = biarc_area.exchange(source, 2.0, start, 2.5, end, peaks)
        assert unrest < 1e-13
        found.append(area)
    assert max(found) - min(found) < 1e-12 * max(found)


def test_strips_are_sectors_of_the_annulus():
    """A curve point that moves along a circle about the centre of the arc sweeps ½(R² − ρ²) per radian."""
    for bend in (0.5, -0.25):
        radius = 1 / bend
        arcs = (0.0, 0.0, 1.0, 0.0, 9.0, 9.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, bend, bend)
        for off, angle in ((0.1, 0.3), (-0.2, 0.7)):
            turned, rho = angle * math.copysign(1, bend), radius - off
            x, y = rho * math.sin(turned), radius - rho * math.cos(turned)
            per_length = biarc_area.strip(arcs, False, x, y, math.cos(turned), math.sin(turned))
            assert per_length * rho == pytest.approx((radius**2 - rho**2) / 2, rel=1e-14)
