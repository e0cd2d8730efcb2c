"""Strict convexity in balls, against samples of tangents and chords in doubles."""

import math

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.convex_arcs import End, is_strictly_convex, turning
from osculant.cas.jets.balls import CurveBalls

#: formula, the same in numpy, and an interval without inflections or cusps inside
CURVES = {
    "t*cos(t), t*sin(t)": (lambda t: (t * np.cos(t), t * np.sin(t)), 0.05, 40.0),
    "exp(t), 3*t": (lambda t: (np.exp(t), 3 * t), -3.0, 3.0),
    "sinh(t)*cos(9*t), sinh(t)*sin(9*t)": (
        lambda t: (np.sinh(t) * np.cos(9 * t), np.sinh(t) * np.sin(9 * t)),
        0.1,
        2.0,
    ),
    "t - sin(t), 1 - cos(t)": (lambda t: (t - np.sin(t), 1 - np.cos(t)), 0.001, 6.28),
}


def is_convex(curve, low, high):
    return is_strictly_convex(curve, low, high, turning(curve, low, high))


def balls(text):
    return CurveBalls(parse_tuple(text)).coefficients


def sampled(function, a, b):
    """(turning, sin A, sin B) of an arc, from many points."""
    t = np.linspace(a, b, 20001)
    points = np.array(function(t)).T
    steps = np.diff(points, axis=0)
    angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    turned = angles[-1] - angles[0]
    chord = math.atan2(*(points[-1] - points[0])[::-1])
    side = math.copysign(1.0, turned)
    return turned, side * math.sin(chord - angles[0]), side * math.sin(angles[-1] - chord)


@settings(deadline=None, max_examples=80)
@given(st.sampled_from(sorted(CURVES)), st.floats(0, 1), st.floats(0.001, 1))
def test_arcs_are_as_convex_as_their_samples(text, start, part):
    function, low, high = CURVES[text]
    a = low + start * (high - low) * 0.99
    b = a + part * (high - a)
    turned, sine_a, sine_b = sampled(function, a, b)
    found = turning(balls(text), End(arb(a)), End(arb(b)))
    assert float(found) == pytest.approx(turned, abs=0.02)
    if min(abs(sine_a), abs(sine_b), abs(abs(turned) - 2 * math.pi)) > 0.02:
        convex = abs(turned) < 2 * math.pi and sine_a > 0 and sine_b > 0
        assert is_convex(balls(text), End(arb(a)), End(arb(b))) == convex


def test_whole_turns_count():
    spiral = balls("exp(t/50)*cos(t), exp(t/50)*sin(t)")
    for turns in (1, 5, 60):
        found = turning(spiral, End(arb(0)), End(arb.pi() * 2 * turns))
        assert abs(found - 2 * turns * arb.pi()) < 1e-9
        assert not is_convex(spiral, End(arb(0)), End(arb.pi() * 2 * turns + arb("0.3")))


def test_cusps_have_limit_tangents():
    cycloid, end = balls("t - sin(t), 1 - cos(t)"), 2 * arb.pi()
    half = turning(cycloid, End(arb(0), 2), End(arb.pi()))
    assert abs(half + arb.pi() / 2) < 1e-9
    other = turning(cycloid, End(arb.pi()), End(end, 2))
    assert abs(other + arb.pi() / 2) < 1e-9
    assert is_convex(cycloid, End(arb(0), 2), End(arb.pi()))
    # a whole arch: half a turn
    assert abs(turning(cycloid, End(arb(0), 2), End(end, 2)) + arb.pi()) < 1e-9


def test_lines_are_not_strictly_convex_and_balls_may_be_too_wide():
    assert not is_convex(balls("t, 2*t"), End(arb(0)), End(arb(1)))
    assert turning(balls("t, 1/t"), End(arb(-1)), End(arb(1))) is None
    assert not is_convex(balls("t, 1/t"), End(arb(-1)), End(arb(1)))
    assert not is_convex(balls("t, abs(t)"), End(arb(-1)), End(arb(1)))
