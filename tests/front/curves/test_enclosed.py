"""Where curves are finite, and polynomials nearly: enclosures of doubles against ball arithmetic."""

from itertools import pairwise

import numpy as np
import pytest
from flint import arb

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.parts import ORDER, clearness, polynomial_parts
from osculant.curves.enclosed import Enclosed, joined

CURVES = [
    ("t*cos(t), t*sin(t)", 0.5, 6.0, 1e-9),
    ("t, exp(-((t - 1/3)/10^-5)^2)/1000", 0.0, 1.0, 1e-9),
    ("t, tanh(300*t)", -1.0, 1.0, 1e-6),
    ("t, sqrt(t)", 0.0, 1.0, 1e-9),
    ("1e6 + t^9, 1/(1 + 1e4*t^2)", -1.0, 1.0, 1e-3),
]


@pytest.mark.parametrize(("text", "low", "high", "accuracy"), CURVES)
def test_parts_are_those_of_balls(text, low, high, accuracy):
    curve = CurveBalls(parse_tuple(text))
    edges = Enclosed(curve).parts(low, high, accuracy)
    assert edges[0] == low and edges[-1] == high and (np.diff(edges) > 0).all()
    # velocities are enclosed more widely where the curve bends much
    of_balls = len(polynomial_parts(curve, low, high, accuracy))
    assert of_balls - 2 <= len(edges) <= 4 / 3 * of_balls
    with precision(200):
        for a, b in pairwise(edges):
            assert b - a < 1e-12 or clearness(curve, (a + b) / 2, (b - a) / 2) <= accuracy


@pytest.mark.parametrize(("text", "low", "high", "accuracy"), CURVES)
def test_outside_of_what_is_unclear_a_curve_is_finite(text, low, high, accuracy):
    curve = CurveBalls(parse_tuple(text))
    unclear = Enclosed(curve).unclear(low, high)
    assert len(unclear) == ("sqrt" in text)
    for t in np.linspace(low, high, 50):
        with precision(200):
            rows = curve.coefficients(arb(float(t)), ORDER)
        assert all(c.is_finite() for row in rows for c in row) or any(a <= t <= b for a, b in unclear)


@pytest.mark.parametrize("text", ["t, 1/(t - 1/3)", "t, log(t - 1/3)", "t, abs(t - 1/3)", "t, tan(t*3*pi/2)"])
def test_singular_places_are_unclear(text):
    unclear = Enclosed(CurveBalls(parse_tuple(text))).unclear(-0.9, 0.9)
    assert unclear is None or any(a <= 1 / 3 <= b for a, b in unclear)
    if "log" not in text:  # which has no values at all on the left
        assert sum(b - a for a, b in unclear) < 1e-9


def test_too_many_singular_places_are_not_listed():
    assert Enclosed(CurveBalls(parse_tuple("t, 1/sin(1000*t)"))).unclear(0.1, 1.0) is None


def test_joined():
    assert joined([]) == [] and joined([(0.0, 1.0), (0.5, 0.7), (0.9, 2.0), (3.0, 4.0)]) == [
        (0.0, 2.0),
        (3.0, 4.0),
    ]
