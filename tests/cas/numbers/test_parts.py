"""Parts on which curves are polynomials: against Taylor polynomials at many digits, down to tiny features."""

from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
from flint import arb

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.parts import FIRST, ORDER, WORK_LIMIT, polynomial_parts

CURVES = [
    ("t^9, t^18", lambda t: (t**9, t**18), 0.1, 1.0),
    (
        "t, exp(-((t-0.3)/0.00001)^2)/1000",
        lambda t: (t, mp.exp(-(((t - mp.mpf("0.3")) / mp.mpf("0.00001")) ** 2)) / 1000),
        0.0,
        1.0,
    ),
    (
        "exp(-t/50)*cos(t), exp(-t/50)*sin(t)",
        lambda t: (mp.exp(-t / 50) * mp.cos(t), mp.exp(-t / 50) * mp.sin(t)),
        0.0,
        300.0,
    ),
]


@pytest.mark.parametrize(("text", "at", "a", "b"), CURVES, ids=[text for text, *_ in CURVES])
@pytest.mark.parametrize("accuracy", [1e-4, 1e-12])
def test_taylor_polynomials_are_near(text, at, a, b, accuracy):
    edges = polynomial_parts(CurveBalls(parse_tuple(text)), a, b, accuracy)
    assert (edges[0], edges[-1]) == (a, b) and (np.diff(edges) > 0).all()
    parts = sorted(pairwise(edges), key=lambda part: part[1] - part[0])
    with mp.workdps(40):
        for low, high in [*parts[:4], *parts[:: len(parts) // 8]]:
            middle = (mp.mpf(low) + mp.mpf(high)) / 2
            for i in (0, 1):
                series = mp.taylor(lambda t, i=i: at(t)[i], middle, ORDER - 1)
                for t in (low, high):
                    found = mp.polyval(series[::-1], mp.mpf(t) - middle)
                    assert abs(found - at(mp.mpf(t))[i]) <= accuracy


@pytest.mark.parametrize("text", ["t^2, t^3 - 10^-6*t", "cos(9*t), sin(9*t)", "t^2, t^3"])
def test_parts_do_not_turn_back_or_are_small(text):
    accuracy, curve = 1e-4, CurveBalls(parse_tuple(text))
    for low, high in pairwise(polynomial_parts(curve, -1.0, 1.1, accuracy)):
        rows = [curve.coefficients(arb(t), 1) for t in np.linspace(low, high, 20)]
        points, velocities = (np.array([[float(c[k]) for c in row] for row in rows]) for k in (0, 1))
        assert (velocities @ velocities.T > 0).all() or np.ptp(points, axis=0).max() <= accuracy


def test_a_tiny_bump_is_found_and_the_rest_left_alone():
    edges = np.array(polynomial_parts(CurveBalls(parse_tuple(CURVES[1][0])), 0.0, 1.0, 1e-9))
    widths = np.diff(edges)
    assert widths.max() == 1 / FIRST and len(edges) < 200
    assert abs(edges[np.argmin(widths)] - 0.3) < 1e-4 and widths.min() < 1e-5


def test_the_work_is_bounded_where_the_curve_is_singular_and_where_it_waves():
    root = polynomial_parts(CurveBalls(parse_tuple("t, sqrt(t)")), 0.0, 1.0, 1e-9)
    assert min(np.diff(root)) < 1e-10 and len(root) < 1000
    waves = polynomial_parts(CurveBalls(parse_tuple("t, sin(10^9*t)")), 0.0, 1.0, 1e-9)
    assert len(waves) <= FIRST + WORK_LIMIT + 1
