"""Enclosures of doubles hold what balls of 300 bits compute."""

import math

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.fields import Balls
from osculant.cas.numbers.taylor import program
from osculant.curves.first_look import table_of
from osculant.kernels.enclosures import balls, programs

#: where each function is tried, its singular places among them
DOMAINS = {
    **dict.fromkeys(["sin", "cos", "tan"], (-1e6, 1e6)),
    **dict.fromkeys(["exp", "sinh", "cosh"], (-750.0, 705.0)),
    **dict.fromkeys(["tanh", "atan", "asinh", "cbrt", "sign"], (-40.0, 40.0)),
    **dict.fromkeys(["asin", "acos", "atanh"], (-1.0, 1.0)),
    **dict.fromkeys(["log", "sqrt"], (0.0, 1e9)),
    "acosh": (1.0, 1e9),
}


def holds(found, exact):
    """Whether a ball of doubles encloses a narrow arb."""
    middle, radius = found
    if not abs(middle) + radius < math.inf:
        return True  # nothing is claimed
    return bool(abs(exact - arb(middle)) <= arb(radius))


def test_every_function_is_tried():
    assert set(DOMAINS) == set(balls.NAMES)


@pytest.mark.parametrize("name", balls.NAMES)
@given(
    part=st.floats(0, 1),
    near=st.sampled_from([0.0, 1e-12, 1e-3]),
    radius=st.sampled_from([0.0, 1e-17, 1e-9, 0.1]),
    inside=st.floats(-1, 1),
)
@settings(max_examples=60, deadline=None)
def test_functions(name, part, near, radius, inside):
    low, high = DOMAINS[name]
    middle = low + near if near and part < 0.5 else low + part * (high - low)
    at = middle + inside * radius
    found = balls.function(balls.NAMES.index(name), (middle, abs(at - middle)))
    with precision(300):
        exact = Balls().function(name)(arb(at))
        if exact.is_finite():
            assert holds(found, exact)


def test_a_function_of_a_double_is_known_to_its_last_digits():
    for name, at in (("sin", 1.0), ("exp", 2.0), ("log", 3.0), ("tan", 1.5), ("acosh", 1.5), ("cbrt", -5.0)):
        middle, radius = balls.function(balls.NAMES.index(name), (at, 0.0))
        assert 0 < radius < 20 * math.ulp(middle)


@pytest.mark.parametrize("name", ["log", "sqrt", "asin", "acos", "atanh", "acosh", "sign", "tan"])
def test_beyond_the_domain_nothing_is_claimed(name):
    at = (
        (math.pi / 2, 1e-9)
        if name == "tan"
        else (0.0, 1e-9)
        if name in ("log", "sqrt", "sign")
        else (1.0, 1e-9)
    )
    assert not balls.is_finite(balls.function(balls.NAMES.index(name), at))
    assert not balls.is_finite(balls.function(balls.NAMES.index(name), (math.nan, 0.0)))
    assert not balls.is_finite(balls.function(balls.NAMES.index("sin"), (0.0, math.inf)))


FORMULAS = [
    "t*cos(t), t*sin(t)",
    "exp(t/3)*cos(5*t), log(1+t)*sin(t)",
    "(1+t)^(2/3)*atan(t), t^7/(1+t^2)^3",
    "tanh(3*t), sqrt(1+t^2)*asinh(t)",
    "cbrt(t)*pi, acos(t/9)",
    "sinh(t)/cosh(2*t), 1/3*exp(-((t-1)/0.01)^2)",
]


@pytest.mark.parametrize("text", FORMULAS)
@given(
    at=st.floats(0.05, 4.0), radius=st.sampled_from([0.0, 1e-14, 1e-6, 1e-2, 1.0]), inside=st.floats(-1, 1)
)
@settings(max_examples=40, deadline=None)
def test_taylor_coefficients(text, at, radius, inside):
    written = program(parse_tuple(text), 6, normalised=True)
    values = np.empty((len(written.instructions), 2))
    point = min(max(at + inside * radius, at - radius), at + radius)
    programs.run(table_of(written), at, radius, values)
    with precision(300):
        exact = written.run(arb(point), Balls())
    for row, coefficients in zip(written.outputs, exact, strict=True):
        for index, coefficient in zip(row, coefficients, strict=True):
            with precision(300):
                assert holds(values[index], coefficient)


def test_numbers_that_are_no_doubles():
    values = np.empty((3, 2))
    table = table_of(program([parse("1/3")], 0))
    programs.run(table, 0.0, 0.0, values)
    assert values[0, 0] == 1 / 3 and 0 < values[0, 1] < 1e-16
    programs.run(table_of(program([parse("10^400")], 0)), 0.0, 0.0, values)
    assert not values[0, 1] < math.inf
