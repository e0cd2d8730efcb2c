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
from osculant.cas.geometry import biarcs as reference
from osculant.cas.numbers.roots import root_between
from osculant.kernels.biarcs import area_exchange, area_scan, scan
from osculant.kernels.biarcs.family import Biarc, family, is_short, member
from osculant.kernels.biarcs.records import EquisymmetricBiarc
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import Frame
from tests.kernels import arcs
from tests.kernels.arcs import HERE, MIRRORED, NOISE, jet_of, visit

FIT = EquisymmetricBiarc()
#: units of noise times length to which areas are known
ROUNDING = 4.0
#: a correction of the places, in parts of the area, that is as good as none, and one that is not infinite
NONE, FINITE = 1e-13, 1e300


def curve_of(text):
    return jet_of(text), sp.sympify(text)


SPIRAL = curve_of("t*cos(t), t*sin(t)")
CIRCLE = curve_of("cos(t), sin(t)")
ELLIPSE = curve_of("2*cos(t), sin(t)")
LINE = curve_of("t, 2*t")
FLAT = curve_of("t, t^3/100000")
WAVY = curve_of("t, t^3/2 + cos(200*t)/1000000")


def arc(curve, a, b, place=HERE):
    """The arc, with the noise of coordinates as large as at b."""
    end = arcs.frame_at(curve[0], b, place)
    return arcs.arc(curve[0], a, b, place._replace(noise=NOISE * max(1.0, math.hypot(end.x, end.y))))


def member_of(on, mu):
    """The biarc μ between the ends of an arc."""
    return member(family(on.start, on.end), mu)


def span(on):
    """The distance of the ends of an arc."""
    return math.dist((on.start.x, on.start.y), (on.end.x, on.end.y))


def best(curve, a, b, place=HERE):
    return arcs.best(FIT, arc(curve, a, b, place))


def measured(curve, a, b, mu, points=8):
    on = arc(curve, a, b)
    return area_scan.measure(member_of(on, mu), on.source, a, b, points, workspace(FIT))


def fast(curve, a, b, place=HERE, rounds=5, calm=NONE):
    """The fast step after some rounds: area, μ, whether it has settled."""
    return visit(FIT, arc(curve, a, b, place), calm, rounds)[:3]


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
    length = span(arc(curve, a, b))
    area, mu, settled = fast(curve, a, b)
    careful, careful_mu = best(curve, a, b)
    with mp.workdps(30):
        exact_mu, exact = exact_best(curve, a, b)
    assert settled
    assert close(area, exact, length) and close(careful, exact, length)
    assert close(measured(curve, a, b, mu), exact, length)
    vague = 1e-11 + 10 * NOISE * length / area
    assert (mu, careful_mu) == pytest.approx((float(exact_mu),) * 2, abs=vague)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.6, 5.0), st.floats(0.05, 1.6), st.floats(0.2, 0.8))
@example(1.9853291251739296, 0.4100730219469293, 0.6146794447512975)  # crosses close to an end
def test_areas_of_any_member(a, length, mu):
    b = a + length
    with mp.workdps(25):
        exact = exact_area(SPIRAL, a, b, mu)
    assert close(measured(SPIRAL, a, b, mu), exact, span(arc(SPIRAL, a, b)), 1e-10)


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
    on = arc(curve, a, a + length)
    size = span(on) + math.hypot(on.end.x, on.end.y)
    area, mu, settled = fast(curve, a, a + length, rounds=8)
    careful, careful_mu = best(curve, a, a + length)
    assert settled
    assert close(area, careful, size)
    assert mu == pytest.approx(careful_mu, abs=1e-10 + 10 * NOISE * size / area)


def test_a_cusp_at_the_end_does_no_harm():
    cusp = curve_of("t^2, t^3")
    on = arc(cusp, 0.5, 0.7)._replace(a=0.0, start=Frame(0.0, 0.0, 1.0, 0.0))
    quick, _, settled, _ = visit(FIT, on, NONE, rounds=6)
    area, mu = arcs.best(FIT, on)
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
    assert quick == pytest.approx(area, rel=1e-11) and settled


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
    on = arc(SPIRAL, 2.0, 2.5)
    area, _, _, places = visit(FIT, on, NONE, rounds=6)
    for off in (1e-3, -1e-3):
        for foot, crossing, part in ((off, 0.0, 1e-9), (0.0, off, 1e-7)):
            moved = places._replace(foot=places.foot + foot, crossing=places.crossing + crossing)
            found, _, settled, _ = visit(FIT, on, part, 1, moved)
            assert abs(found / area - 1) < part
            assert not settled


def test_the_signed_area_moves_in_one_direction_with_mu():
    on, space = arc(SPIRAL, 1.0, 3.0), workspace(FIT)
    signed = []
    for mu in np.linspace(0.1, 0.9, 33):
        m = member_of(on, mu)
        count = scan.look(m, on.source, 1.0, 3.0, 40, space)
        both = area_scan.attained(m, on.source, 1.0, 3.0, space, count)
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
    quick, _, settled = fast(SPIRAL, a, b, calm=1e-6)
    assert not settled or abs(quick - law) < vague


def test_mirrored_and_reversed_arcs_have_the_same_area():
    mirrored, backwards = curve_of("t*cos(t), -t*sin(t)"), curve_of("-t*cos(t), t*sin(t)")
    area, mu, _ = fast(SPIRAL, 1.0, 2.0)
    assert fast(mirrored, 1.0, 2.0, MIRRORED)[:2] == (area, mu)
    assert fast(backwards, -2.0, -1.0, MIRRORED)[:2] == pytest.approx((area, 1 - mu), rel=1e-11)
    assert best(mirrored, 1.0, 2.0, MIRRORED) == best(SPIRAL, 1.0, 2.0)
    assert best(backwards, -2.0, -1.0, MIRRORED) == pytest.approx((area, 1 - mu), rel=1e-11)


def test_circles_and_lines_have_no_area():
    for curve, b in ((CIRCLE, 3.1), (CIRCLE, 0.1), (LINE, 1.0)):
        assert best(curve, 0.0, b)[0] <= ROUNDING * NOISE * b
        for mu in (0.2, 0.5, 0.9):
            assert measured(curve, 0.0, b, mu) <= ROUNDING * NOISE * b
        area, _, _ = fast(curve, 0.0, b)
        assert math.isnan(area) or area <= ROUNDING * NOISE * b


def test_arcs_that_turn_by_almost_pi():
    """t + atan t from 1 to the end is a little less than π."""
    with mp.workdps(30):
        end = mp.findroot(lambda t: t + mp.atan(t) - 1 - mp.atan(1) - mp.pi + mp.mpf("0.02"), 3.5)
        _, exact = exact_best(SPIRAL, 1.0, float(end))
    area, mu = best(SPIRAL, 1.0, float(end))
    assert area == pytest.approx(float(exact), rel=1e-11)
    quick, quick_mu, settled = fast(SPIRAL, 1.0, float(end), rounds=8)
    assert (quick, quick_mu) == pytest.approx((area, mu), rel=1e-11) and settled


def test_there_is_none():
    assert best(CIRCLE, 0.0, 3.2)[0] == math.inf
    assert best(SPIRAL, 10.0, 10.0 + 2.5 * math.pi)[0] == math.inf
    assert math.isnan(fast(CIRCLE, 0.0, 3.2)[0])


def test_without_equal_moons_the_least_area_is_taken():
    # about a vertex all members are one circle, and it lies on one side of the curve
    area, mu = best(ELLIPSE, -0.5, 0.5)
    assert close(area, exact_area(ELLIPSE, -0.5, 0.5, mu), 1.0)
    assert not fast(ELLIPSE, -0.5, 0.5, calm=FINITE)[2]
    assert close(measured(ELLIPSE, -0.5, 0.5, 0.5), exact_area(ELLIPSE, -0.5, 0.5, 0.5), 1.0)


def test_arcs_that_are_not_beside_the_biarc_are_seen():
    on = arc(SPIRAL, 2.0, 3.0)
    shorter = member(family(arcs.frame_at(SPIRAL[0], 2.2), on.end), 0.5)
    assert area_scan.measure(shorter, on.source, 2.0, 3.0, 8, workspace(FIT)) == math.inf
    wide = Frame(0.0, 0.0, 1.0, 0.0), Frame(math.cos(3.0), math.sin(3.0), math.cos(3.0), math.sin(3.0))
    long = member(family(*wide), 0.5)
    assert not is_short(long)
    assert area_scan.measure(long, on.source, 2.0, 3.0, 8, workspace(FIT)) == math.inf


def test_crossings_between_the_samples_are_found():
    """One sample in the middle, and a biarc that crosses the waves several times."""
    with mp.workdps(25):
        for a, b, mu, points in ((0.5, 1.0, 0.45, 8), (0.5, 0.55, 0.5, 1)):
            exact = exact_area(WAVY, a, b, mu, grid=1000)
            assert measured(WAVY, a, b, mu, points) == pytest.approx(float(exact), rel=1e-9)


def test_the_fast_step_knows_when_its_nodes_are_too_few():
    wild = curve_of("t, t^3/2 + sin(1000*t)/100000000")
    assert not fast(wild, 0.5, 0.7, calm=FINITE)[2]
    assert math.isfinite(best(wild, 0.5, 0.7)[0])


def test_the_settled_fast_step_is_reproducible():
    """From other first places it ends at the same area to eleven digits, of an arc well above rounding."""
    on, found = arc(SPIRAL, 2.0, 2.5), []
    for foot, crossing, mu in ((0.5, 0.5, 0.5), (0.45, 0.55, 0.4), (0.55, 0.45, 0.6)):
        places = area_exchange.Places(foot, crossing, mu, 0.0)
        area, _, settled, _ = visit(FIT, on, NONE, 6, places)
        assert settled
        found.append(area)
    assert max(found) - min(found) < 1e-12 * max(found)


def test_strips_are_sectors_of_the_annulus():
    """A curve point that moves along a circle about the centre of the arc sweeps ½(R² − ρ²) per radian."""
    for bend in (0.5, -0.25):
        radius = 1 / bend
        both = Biarc(0.0, 0.0, 1.0, 0.0, 9.0, 9.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, bend, bend)
        for off, angle in ((0.1, 0.3), (-0.2, 0.7)):
            turned, rho = angle * math.copysign(1, bend), radius - off
            x, y = rho * math.sin(turned), radius - rho * math.cos(turned)
            per_length = area_exchange.strip(both, False, x, y, math.cos(turned), math.sin(turned))
            assert per_length * rho == pytest.approx((radius**2 - rho**2) / 2, rel=1e-14)
