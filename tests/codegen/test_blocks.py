"""Derivatives at many parameters at once, and the elementary functions in them, against mpmath and libm."""

import math

import mpmath
import numpy as np
import pytest
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.fields import Balls
from osculant.cas.numbers.taylor import program
from osculant.codegen.blocks import compile_blocks
from osculant.codegen.jets import compile_jet
from osculant.codegen.vectors import FARTHEST, LARGEST, LEAST, MOST
from tests.codegen.test_jets import assert_accurate
from tests.graphs import formulas

RNG = np.random.default_rng(3)
#: multiples of π/2, next to which sine and cosine are hard, and powers of two, next to which logarithms are
QUARTERS = np.concatenate([np.arange(1, 400), RNG.integers(400, 660_000, 800)]) * (math.pi / 2)
AROUND_1 = 1 + np.concatenate([RNG.uniform(-1e-9, 1e-9, 200), RNG.uniform(-0.4, 0.6, 600)])
ANGLES = np.concatenate(
    [RNG.uniform(-8, 8, 800), RNG.uniform(-FARTHEST, FARTHEST, 800), QUARTERS, np.nextafter(QUARTERS, 0)]
)
SIZES = np.concatenate([2.0 ** RNG.uniform(-1020, 1022, 1500), AROUND_1, [LEAST, MOST, 1.0, 2.0]])
CASES = {
    "sin": (ANGLES, mpmath.sin),
    "cos": (ANGLES, mpmath.cos),
    "exp": (np.concatenate([RNG.uniform(-LARGEST, LARGEST, 1500), RNG.uniform(-1, 1, 800)]), mpmath.exp),
    "log": (SIZES, mpmath.log),
    "cbrt": (SIZES * RNG.choice([-1.0, 1.0], SIZES.size), lambda x: mpmath.sign(x) * mpmath.cbrt(abs(x))),
}


@pytest.mark.parametrize("name", CASES)
def test_functions_are_right_to_two_units_in_the_last_place(name):
    points, exact = CASES[name]
    found = compile_blocks([parse(f"{name}(t)")], 0)(points)[0, 0]
    with mpmath.workprec(250):
        for x, value in zip(points.tolist(), found.tolist(), strict=True):
            wanted = exact(mpmath.mpf(x))
            assert abs(value - wanted) <= 1.2 * math.ulp(float(wanted)), x  # 2 are promised


def test_where_a_function_does_not_take_its_argument_libm_is_asked():
    inputs = {
        "sin": [1e300, -(FARTHEST + 1), 0.0, 1.0],
        "exp": [710.0, -720.0, -1e4, math.inf, 1.0],
        "log": [0.0, -1.0, 5e-324, math.inf, 1.0],
        "cbrt": [0.0, 5e-324, -1e-310, 1.7e308, 8.0],
    }
    for name, points in inputs.items():
        formula = [parse(f"{name}(t)")]
        found, jet = compile_blocks(formula, 1)(np.array(points)), compile_jet(formula, 1)
        for i, x in enumerate(points[:-1]):
            np.testing.assert_array_equal(found[..., i], jet(x))
        np.testing.assert_allclose(found[..., -1], jet(points[-1]), rtol=1e-15)


@given(formulas, st.floats(-4, 4))
@settings(max_examples=40, deadline=None)
def test_random_formulas(node, at):
    with precision(53):
        trace = program([node], 4).trace(arb(at), Balls())
    assume(all(x.is_finite() and float(abs(x).upper()) < 1e60 for x in trace))
    blocks = compile_blocks([node], 4)
    assert assert_accurate([node], 4, at, lambda t: blocks(np.array([t]))[..., 0]) == 5


def test_results_do_not_depend_on_where_a_parameter_stands():
    blocks = compile_blocks(parse_tuple("t*cos(t), exp(-t)*atan(t)^(1/3)"), 3)
    times = np.linspace(0.1, 9, 37)
    whole = blocks(times)
    assert whole.shape == (2, 4, 37)
    for start, stop in ((0, 1), (3, 8), (5, 37), (36, 37), (4, 4)):
        np.testing.assert_array_equal(blocks(times[start:stop]), whole[..., start:stop])


def test_derivatives_of_a_curve():
    curve = osc.curve("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "-3*pi/4", "3*pi/4")
    times = np.linspace(*curve.interval, 1001)
    found = curve.derivatives(times, 2)
    np.testing.assert_allclose(found.transpose(2, 0, 1), curve.jets(times), rtol=1e-14, atol=1e-14)
    space = osc.curve("t, t^2, t^3").derivatives([2.0, 3.0], 3)
    assert space[2].tolist() == [[8.0, 27.0], [12.0, 27.0], [12.0, 18.0], [6.0, 6.0]]
    for order in (-1, 31, 1.5):
        with pytest.raises(osc.DomainError, match="whole number from 0 to 30"):
            curve.derivatives(times, order)
