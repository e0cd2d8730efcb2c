"""Curves: what they are made from, and their invariants in exact, certified and double arithmetic."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import symengine
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import osculant as osc

T = sp.Symbol("t", real=True)


@pytest.mark.parametrize(
    "given_as",
    [
        "t*cos(t), t*sin(t)",
        ("t*cos(t)", "t*sin(t)"),
        (T * sp.cos(T), T * sp.sin(T)),
        (sp.Symbol("t") * sp.cos(sp.Symbol("t")), "t*sin(t)"),
        (symengine.sympify("t*cos(t)"), symengine.sympify("t*sin(t)")),
    ],
)
def test_ways_to_give_a_curve(given_as):
    curve = osc.curve(given_as, sp.pi / 6, 2 * sp.pi)
    assert len(osc.approximate(curve, "conic", 1e-4)) == 9


@pytest.mark.parametrize("end", ["3/4", 0.75, Fraction(3, 4), sp.Rational(3, 4), symengine.Rational(3, 4)])
def test_ways_to_give_an_end(end):
    assert osc.curve("t, t^3", 0, end).interval == (0.0, 0.75)


@pytest.mark.parametrize(
    ("formulas", "low", "high", "error", "words"),
    [
        ("t", 0, 1, osc.FormulaError, "two coordinates"),
        ("t, t, t, t", 0, 1, osc.FormulaError, "two coordinates"),
        (("t",), 0, 1, osc.FormulaError, "two coordinates"),
        (7, 0, 1, osc.FormulaError, "two or three formulas"),
        ("t, u", 0, 1, osc.FormulaError, "u"),
        ("t, t^3", 1, 1, osc.DomainError, "empty or reversed"),
        ("t, t^3", 2, "sqrt(2)", osc.DomainError, "empty or reversed"),
        ("t, t^3", "2*pi", "pi+pi", osc.DomainError, "empty or reversed"),
        ("t, t^3", 0, math.inf, osc.FormulaError, "inf"),
        ("t, t^3", math.nan, 1, osc.FormulaError, "^low is nan: "),
        ("t, t^3", 0, "sqrt(-1)", osc.FormulaError, "sqrt"),
        ("t, t^3", 0, None, osc.DomainError, "both ends"),
        ("t, t^3", 0, "t", osc.FormulaError, "^high: "),
        ("t, t^3", "1/x", 1, osc.FormulaError, "^low: "),
        ("t, t^3", 0, "1/0", osc.FormulaError, "^high"),
    ],
)
def test_refused_curves(formulas, low, high, error, words):
    with pytest.raises(error, match=words):
        osc.curve(formulas, low, high)


def test_exact_invariants_are_attributes():
    spiral = osc.curve("t*cos(t), t*sin(t)")
    assert spiral.curvature == (T**2 + 2) / (T**2 + 1) ** sp.Rational(3, 2)
    assert set(spiral.invariants()) >= {"speed", "affine_curvature", "arc_length", "canonical_form"}
    with pytest.raises(AttributeError, match="no attribute 'colour'"):
        _ = spiral.colour


def curvature_by_hand(x, y, t):
    dx, ddx, dy, ddy = (mpmath.diff(f, t, n) for f in (x, y) for n in (1, 2))
    return (dx * ddy - dy * ddx) / (dx**2 + dy**2) ** mpmath.mpf(1.5)


@pytest.mark.parametrize("digits", [5, 50, 300])
def test_values_to_any_number_of_digits(digits):
    values = osc.curve("exp(t/2)*cos(t), log(2 + t)").at("sqrt(2)", digits)
    with mpmath.workdps(2 * digits + 30):
        expected = curvature_by_hand(
            lambda t: mpmath.exp(t / 2) * mpmath.cos(t), lambda t: mpmath.log(2 + t), mpmath.sqrt(2)
        )
        assert abs(values["curvature"] / expected - 1) < mpmath.mpf(10) ** (1 - digits)


def test_values_where_they_do_not_exist():
    at_inflection = osc.curve("t, t^3").at(0)
    assert at_inflection["curvature"] == 0
    assert at_inflection["affine_curvature"] is None
    assert at_inflection["evolute"] is None
    with pytest.raises(osc.DomainError, match="t = 0"):
        osc.curve("t, sqrt(t)").at(0)
    with pytest.raises(osc.DomainError, match="0 digits"):
        osc.curve("t, t^3").at(1, 0)
    with pytest.raises(osc.DomainError, match="5000 digits"):
        osc.curve("t, t^3").at(1, 5000)


@settings(max_examples=12, deadline=None)
@given(st.integers(-3, 3), st.integers(1, 3), st.integers(1, 3), st.floats(0.1, 2))
def test_three_arithmetics_agree(a, b, c, t):
    curve = osc.curve(f"t + {a}*cos({b}*t)/7, t^2 + exp(t/{c})")
    table = curve.tabulate([t])
    certain = curve.at(t, 30)
    symbols = curve.invariants()
    for name, column in table.items():
        value = certain[name]
        assert float(column[0]) == pytest.approx(float(value), rel=1e-9, abs=1e-12)
        if name in curve.exact.over_jets:  # too long to be written in t
            continue
        exact = symbols[name].evalf(40, subs={T: sp.Float(repr(t), 60)})
        with mpmath.workdps(40):
            assert abs(mpmath.mpf(str(exact)) - value) <= mpmath.mpf(10) ** -25 * (1 + abs(value))


def test_a_wrong_variant_is_seen():
    # the same comparison rejects κ of the mirrored curve
    value = osc.curve("t, t^3").at(1, 20)["curvature"]
    assert osc.curve("t, -t^3").tabulate([1.0])["curvature"][0] == pytest.approx(-float(value))
    assert not np.isclose(osc.curve("t, -t^3").tabulate([1.0])["curvature"][0], float(value))


def test_complexity_refuses_a_bad_tolerance():
    law = osc.complexity(osc.curve("t, t^3", 0, 1), "conic")
    assert law.count(1e-9) == 29
    for tolerance in (0, -1, math.inf):
        with pytest.raises(osc.ToleranceError, match="positive"):
            law.predicted(tolerance)


def test_the_next_term_of_the_number_of_pieces():
    spiral = osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    law = osc.complexity(spiral, "conic", next_term=True)
    assert law.next_constants == ("0.446788453234",)
    # fractional greedy counts measured with 30 digits
    for tolerance, measured in ((1e-9, 80.113), (1e-10, 126.963), (1e-11, 201.219), (1e-12, 318.908)):
        assert abs(law.refined(tolerance) - measured) < 1e-3
    plain = osc.complexity(spiral, "conic")
    assert plain.next_constant is None and plain.refined(1e-9) is None
    assert "next_constant" not in plain.to_json() and law.to_json()["next_constant"] == "0.446788453234"
    with pytest.raises(osc.DomainError, match="sextactic"):
        osc.complexity(osc.curve("t, t^4 + t^2", "-1", "1"), "conic", next_term=True)
