"""Suprema of rational functions and distances of arcs, against 40-digit sampling."""

import math

import mpmath
import pytest
from flint import arb, arb_poly
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry import arc_distance
from osculant.cas.geometry.arc_distance import distance, parting
from osculant.cas.geometry.conic_arcs import ConicArc
from osculant.cas.geometry.point_distance import from_arc, from_point
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.enclosures import shortened, supremum

numbers = st.floats(-10, 10, allow_subnormal=False)
polynomials = st.lists(numbers, min_size=1, max_size=8)


def value(coefficients, s):
    return sum(mpmath.mpf(c) * s**k for k, c in enumerate(coefficients))


def close(attained):
    return attained + arb(1e-9) * (1 + abs(attained))


@given(polynomials, polynomials)
@settings(deadline=None)
def test_the_supremum_is_above_all_samples_and_not_far_above(top, bottom):
    bottom = [sum(map(abs, bottom)) + 0.5, *bottom]  # positive on [−1, 1]
    with precision(128), mpmath.workdps(40):
        found = supremum(arb_poly(top), arb_poly(bottom), close, work=400)
        samples = [mpmath.mpf(k) / 100 for k in range(-100, 101)]
        largest = max(value(top, s) / value(bottom, s) for s in samples)
        assert largest <= mpmath.mpf(found.upper.str(35, radius=False)) + mpmath.mpf(10) ** -30
        assert found.attained <= found.upper <= close(found.attained)
        at = mpmath.mpf(found.at.str(35, radius=False))
        assert abs(value(top, at) / value(bottom, at) - float(found.attained)) <= 1e-9 * (1 + abs(largest))


@given(st.lists(st.integers(-99, 99), min_size=4, max_size=12), st.integers(1, 4), st.integers(-64, 64))
def test_shortened_polynomials_cover_the_whole_ones(coefficients, degree, k):
    s = arb(k) / 64
    with precision(128):
        short = shortened([arb(c) for c in coefficients], degree)
        assert len(short) == min(degree + 1, len(coefficients))
        whole = arb_poly(coefficients)(s)
        assert whole.is_exact()
        assert arb_poly(short)(s).contains(whole)


def test_a_wide_coefficient_is_any_function_between_its_bounds():
    with precision(64):
        found = supremum(arb_poly([0, 0, arb(0, 1)]), arb_poly([1]), close, work=100)
        assert 1 <= found.upper < 1.01
        assert found.attained <= 0  # of all functions


def test_no_bound_where_the_denominator_has_a_zero():
    with precision(64):
        assert not supremum(arb_poly([1]), arb_poly([0, 1]), close, work=50).upper.is_finite()
        unknown = arb_poly([1, 0, 0, arb("nan")])  # what is not known is not taken for small
        assert not supremum(unknown, arb_poly([1]), close, work=50).upper.is_finite()


def test_work_is_bounded_and_what_is_left_is_still_a_bound():
    with precision(64):
        wave = arb_poly([0.3, 1, -3, 2, 1, -5])
        rough = supremum(wave, arb_poly([1]), close, work=2)
        fine = supremum(wave, arb_poly([1]), close, work=200)
        assert rough.upper > close(rough.attained)
        assert rough.upper >= fine.upper


UNIT_ARCS = {  # weight cos(θ/2) of arcs of the unit circle around (−1, 0) that turn by θ
    angle: ConicArc(
        (math.cos(angle / 2), -math.sin(angle / 2)),
        (1.0, 0.0),
        (math.cos(angle / 2), math.sin(angle / 2)),
        math.cos(angle / 2),
    )
    for angle in (0.5, 3.0, math.pi, 3.3, 6.0)
}


@pytest.mark.parametrize("angle", UNIT_ARCS)
def test_arcs_of_a_circle_near_and_beyond_half_of_it(angle):
    curve = CurveBalls(parse_tuple("(1+1/1000)*cos(t), (1+1/1000)*sin(t)")).coefficients
    with precision(128):
        found = distance(curve, arb(-angle / 2), arb(angle / 2), UNIT_ARCS[angle], 1e-3)
        assert abs(found.lower - 1e-3) < 3e-9
        assert abs(found.upper - 1e-3) < 3e-9
        assert found.lower <= found.upper


@pytest.mark.parametrize("angle", UNIT_ARCS)
def test_points_away_from_a_circle(angle):
    with precision(128):
        for formula, apart in (("0, 0", 1.0), ("3, 0", 2.0), ("1/2, 1/1000000", 0.5 - 1e-12)):
            point = CurveBalls(parse_tuple(formula)).coefficients
            below = from_point(point, arb(0), UNIT_ARCS[angle])
            nearest = min(apart, *(math.hypot(float(point(arb(0), 0)[0][0]) - x, y) for x, y in ends(angle)))
            assert nearest * (1 - 1e-5) <= below <= nearest * (1 + 1e-12)


@pytest.mark.parametrize("angle", UNIT_ARCS)
@pytest.mark.parametrize(
    ("formula", "low", "high", "apart"),
    [
        ("2 + t, 3*t", -5, 5, 3 / math.sqrt(10)),  # a line, nearest at an inner point
        ("2 + t, 3*t", 0, 5, 1.0),  # at its beginning
        ("1 + t^2, t", -1, 1, 0.0),  # it passes through the point
        ("3 + 4*cos(t), 4*sin(t)", 0, 6, 2.0),  # opposite to it
        ("1 + 2*cos(t), 2*sin(t)", 0, 40, 2.0),  # all around, many times
    ],
)
def test_a_curve_away_from_a_point_of_a_circle(angle, formula, low, high, apart):
    curve = CurveBalls(parse_tuple(formula)).coefficients
    with precision(128):
        below = from_arc(curve, arb(low), arb(high), UNIT_ARCS[angle], 0.5)  # from (1, 0)
        assert apart * (1 - 1e-5) <= below <= apart * (1 + 1e-12)


def ends(angle):
    return [UNIT_ARCS[angle].start, UNIT_ARCS[angle].end]


@pytest.mark.parametrize("parts", [0, 1, 3, 400])
def test_few_parts_give_a_bound_nonetheless(monkeypatch, parts):
    monkeypatch.setattr(arc_distance, "PARTS", parts)
    chord = ConicArc((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 1.0)  # a point: the distance is the curve's radius
    for degree in (12, 13, 14, 15, 20, 40):  # beyond the Taylor polynomials, too
        power = CurveBalls(parse_tuple(f"0, t^{degree}")).coefficients
        with precision(128):
            found = distance(power, arb(0), arb(1.5), chord)
            exact = arb(1.5) ** degree
            assert found.upper >= exact
            assert found.lower <= exact
            assert parts < 400 or found.upper < 1.001 * exact


def test_a_pole_gives_no_bound():
    curve = CurveBalls(parse_tuple("t, 1/t")).coefficients
    with precision(128):
        found = distance(curve, arb(-1), arb(2), ConicArc((-1.0, -1.0), (0.0, 0.0), (2.0, 0.5), 1.0), 1.0)
        assert not found.upper.is_finite()
        assert found.worst.overlaps(arb(0))


def test_where_a_curve_passes_a_normal():
    curve = CurveBalls(parse_tuple("t, t^3")).coefficients
    with precision(128):
        for tangent in ((1.0, 0.0), (0.0, 1.0), (0.6, 0.8)):
            at = parting(curve, arb(0), arb(2), 0.1, (1.0, 1.0), tangent)
            assert abs(at - 1) < 1e-12
        # nothing passes: any number inside
        assert 0 < parting(curve, arb(0), arb(2), 0.5, (5.0, 5.0), (1.0, 0.0)) < 2
