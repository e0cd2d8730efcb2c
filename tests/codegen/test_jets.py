"""Compiled jets against the same programs in 50 digits; the lives of handles; threads."""

from __future__ import annotations

import ctypes
import gc
import math
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import chain

import mpmath
import numpy as np
import pytest
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import FormulaError
from osculant.cas.formulas.expression import FUNCTIONS, call, number
from osculant.cas.formulas.parser import parse, parse_tuple
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.fields import Balls, Multiprecision
from osculant.cas.numbers.taylor import program
from osculant.codegen.jets import compile_jet
from tests.graphs import formulas, t

EPSILON = 2.0**-52


def assert_accurate(formulas, order, at, jet=None):
    """Every derivative is as near to the 50-digit one as rounding after each operation allows.

    What rounding may do is told by the radii of the same program in balls of 53 bits.  Returns how many
    derivatives could be compared.
    """
    jet = jet or compile_jet(formulas, order)
    compiled = program(formulas, order)
    with precision(53):
        balls = compiled.run(arb(at), Balls())
    with mpmath.workdps(50):
        exact = compiled.run(mpmath.mpf(at), Multiprecision())
        compared = 0
        for got, enclosure, x in zip(jet(at).ravel(), chain(*balls), chain(*exact), strict=True):
            if not enclosure.is_finite() or float(abs(enclosure).upper()) > 1e300:
                continue
            allowed = 4 * float(enclosure.rad()) + 4 * EPSILON * abs(x) + 1e-290
            assert abs(mpmath.mpf(float(got)) - x) <= allowed, (got, x, allowed)
            compared += 1
    return compared


# Accuracy.


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
@pytest.mark.parametrize("at", [0.37, -0.99999999, 1e-9, 12.5, 1.0000001, -1e5])
def test_functions(name, at):
    assert_accurate([call(name, t + t**2 / 3)], 6, at)
    inside = 1.7 if name == "acosh" else 0.37
    assert assert_accurate([call(name, t)], 6, inside) == 7


@pytest.mark.parametrize(
    "text",
    [
        *("t*cos(t), t*sin(t)", "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "t, t^7 - 3*t", "t, 1/(1 + t^2)"),
        *("cbrt(t - 5), t^(2/3)", "exp(-t)*pi, log(t)^2", "t^(-5/4), sqrt(t + e)", "tan(t), atan(t/(1 + t))"),
    ],
)
def test_well_conditioned_curves_lose_few_digits(text):
    formulas = parse_tuple(text)
    jet = compile_jet(formulas, 5)
    for at in (0.3, 1.1, 2.9):
        assert assert_accurate(formulas, 5, at, jet) == 12
        with mpmath.workdps(50):
            exact = program(formulas, 5).run(mpmath.mpf(at), Multiprecision())
        for got, row in zip(jet(at), exact, strict=True):
            size = max(1.0, *(abs(float(x)) for x in row))
            assert all(abs(float(x) - y) < 60 * EPSILON * size for x, y in zip(row, got, strict=True))


@given(formulas, st.floats(-4, 4))
@settings(max_examples=80, deadline=None)
def test_random_formulas(node, at):
    with precision(53):
        trace = program([node], 4).trace(arb(at), Balls())
    assume(all(x.is_finite() and float(abs(x).upper()) < 1e60 for x in trace))
    assert assert_accurate([node], 4, at) == 5


def test_the_comparison_tells_neighbours_apart():
    with pytest.raises(AssertionError):
        assert_accurate([parse("sin(t)")], 3, 0.7, jet=compile_jet([parse("sin(t) + t/10^14")], 3))
    with pytest.raises(AssertionError):
        assert_accurate([parse("cos(t)")], 1, 0.7, jet=compile_jet([parse("cos(t) + cos(t*10^4)/10^18")], 1))


def test_layout():
    jet = compile_jet(parse_tuple("t^2, t^3, 5"), 2)
    assert (jet.formulas, jet.order, jet.size) == (3, 2, 9)
    assert jet(2.0).tolist() == [[4, 4, 2], [8, 12, 12], [5, 0, 0]]
    out = np.full(10, -7.0)  # what the address writes, and nothing beyond
    ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_void_p)(jet.address)(2.0, out.ctypes.data)
    assert out.tolist() == [4, 4, 2, 8, 12, 12, 5, 0, 0, -7]


# The edges of floating point.


OUTSIDE = {
    "log(t)": -1.0,
    "sqrt(t)": -1e-300,
    "asin(t)": 1.0000001,
    "acos(t)": -2.0,
    "acosh(t)": 0.5,
    "atanh(t)": 1.5,
    "t^(1/3)": -8.0,
    "t^(-3/2)": -1.0,
    "t + 0.5*sqrt(t - 1)": 0.0,
    "sin(t)": math.inf,
}


@pytest.mark.parametrize("text", OUTSIDE)
def test_nan_outside_the_domain(text):
    assert np.isnan(compile_jet([parse(text)], 3)(OUTSIDE[text])[0, 0])


@pytest.mark.parametrize("text", ["sqrt(t)", "cbrt(t)", "t^(2/3)", "abs(t)", "1/t", "log(t)", "t^(-1/2)"])
def test_at_a_singularity_the_derivative_is_not_finite(text):
    assert not np.isfinite(compile_jet([parse(text)], 3)(0.0)[0, 1])


def test_nan_in_nan_out():
    assert np.isnan(compile_jet(parse_tuple("t, sin(t) + t^2"), 3)(math.nan)[1, :3]).all()


def test_roots_of_negative_numbers():
    values = compile_jet([parse("cbrt(t)")], 1)(-8.0)[0]
    assert values == pytest.approx([-2, 1 / 12], rel=1e-15)


def test_constants_beyond_double_range():
    jet = compile_jet(parse_tuple("10^400*t, t/10^400, 1 + t/10^400, -(10^400)*t"), 1)
    assert jet(2.0).tolist() == [
        [math.inf, math.inf],
        [0.0, 0.0],
        [1.0, 0.0],
        [-math.inf, -math.inf],
    ]


def test_exact_constants_are_rounded_once():
    q = Fraction(10**400 + 1, 3 * 10**400)
    assert compile_jet([number(q) * t], 1)(1.0)[0, 1] == 1 / 3
    assert compile_jet([parse("pi*t"), parse("e*t")], 1)(1.0).tolist() == [[math.pi] * 2, [math.e] * 2]


def test_overflow_goes_to_infinity():
    assert compile_jet([parse("exp(t)")], 2)(1000.0).tolist() == [[math.inf] * 3]
    assert compile_jet([parse("exp(-t)")], 2)(1000.0)[0].tolist() == [0.0, -0.0, 0.0]


# Large formulas.


def test_deep_formula():
    node = t
    for _ in range(30):
        node = call("sin", node)
    assert assert_accurate([node], 5, 0.8) == 6


def test_long_formula():
    series = number(0)
    for k in range(1, 120):
        series = series + call("sin", t * k) * call("exp", -t / k) / number(k)
    assert assert_accurate([series, t * series], 5, 0.4) == 12


def test_shared_formula():
    node = t
    for _ in range(25):
        node = (node * node + 1) / 2  # 2^25 leaves as a tree
    assert assert_accurate([node], 4, 0.9) == 5


# Handles.


def test_two_handles_at_once():
    first, second = compile_jet([parse("sin(t)")], 2), compile_jet([parse("cos(t)")], 2)
    assert first.address != second.address
    for at in (0.1, 2.0):
        assert first(at)[0, 0] == pytest.approx(math.sin(at), rel=1e-15)
        assert second(at)[0, 0] == pytest.approx(math.cos(at), rel=1e-15)
    del first
    gc.collect()
    assert second(1.0)[0] == pytest.approx([math.cos(1), -math.sin(1), -math.cos(1)], rel=1e-15)


def test_many_handles_come_and_go():
    kept = {}
    for k in range(120):
        jet = compile_jet([parse(f"{k}*t + exp(t)")], 3)
        assert jet(0.0)[0].tolist() == [1, k + 1, 1, 1]
        if k % 12 == 0:
            kept[k] = jet
    gc.collect()
    for k, jet in kept.items():
        assert jet(0.0)[0].tolist() == [1, k + 1, 1, 1]


def test_results_outlive_the_handle():
    values = compile_jet([parse("t^2")], 2)(3.0)
    gc.collect()
    assert values.tolist() == [[9, 6, 2]]


def test_threads():
    shared = compile_jet(parse_tuple("t*cos(t), t*sin(t)"), 5)
    places = np.linspace(0.1, 6, 50)
    expected = [shared(t) for t in places]

    def work(k):
        own = compile_jet([parse(f"sin({k}*t)/{k}")], 4)
        alike = all(np.array_equal(shared(t), e) for t, e in zip(places, expected, strict=True))
        return alike and own(0.0)[0, 1] == 1 and own(0.0)[0, 3] == pytest.approx(-k * k)

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(work, range(1, 41)))


def test_another_variable():
    assert compile_jet([parse("u^2", ("u",))], 1, "u")(3.0).tolist() == [[9, 6]]
    with pytest.raises(FormulaError):
        compile_jet([parse("u^2", ("u",))], 1)


# Overflow on the way.


@pytest.mark.parametrize(
    "text",
    [
        "1/cosh(1000*t)",
        "exp(1500*t)/(1 + exp(1500*t))",
        "t/(1 + t^4000)",
        "exp(900*t)*exp(-899*t)",
        "sinh(800*t)^-2",
    ],
)
@pytest.mark.parametrize("at", [0.9, 1.1, 1.5])
def test_where_doubles_overflow_on_the_way_balls_are_asked(text, at):
    """Against the program in 60 digits."""
    compiled = program([parse(text)], 3)
    with mpmath.workdps(60):
        exact = compiled.run(mpmath.mpf(at), Multiprecision())[0]
    for got, x in zip(compile_jet([parse(text)], 3)(at)[0], exact, strict=True):
        assert float(got) == pytest.approx(float(x), rel=1e-12, abs=1e-300)


def test_outside_the_domain_there_is_still_no_value():
    jet = compile_jet([parse("exp(t)*log(t)")], 2)
    assert np.isnan(jet(-1.0)).all()
    assert math.isinf(compile_jet([parse("exp(t)")], 0)(1e3)[0, 0])
