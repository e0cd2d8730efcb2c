"""The best cubic of a short arc: constants, contact, residuals, and what they integrate to."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
import sympy as sp
from flint import arb

from osculant.cas.asymptotics import free_cubics
from osculant.cas.asymptotics.free_cubics import Y, a, b, contact, tangent_graph
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.laws.cubics import branch, residuals
from osculant.cas.numbers.algebraic import Algebraic, algebraic
from osculant.cas.numbers.balls import PRECISION, constant, precision


def test_constants():
    assert str(sp.N(1 / free_cubics.distance_constant().number(), 20)) == "604.38627850196813325"
    assert str(sp.N(1 / free_cubics.area_constant().number(), 16)) == "1020.027518441058"
    with precision(200):
        for number in (free_cubics.distance_constant(), free_cubics.area_constant()):
            ball = number.ball()
            value = arb(0)
            for c in number.coefficients:
                value = value * ball + c
            assert value.contains(0) and ball.rel_accuracy_bits() > 150


def test_the_largest_peak_is_least_where_the_peaks_are_equal():
    places = [sp.Rational(i, 400) for i in range(-200, 201)]

    def largest(c):
        height = sp.lambdify(free_cubics.PLACE, free_cubics.profile().subs(free_cubics.SPREAD, c))
        return max(abs(float(height(float(place)))) for place in places)

    best = float(free_cubics.equal_peaks().number())
    assert largest(best) == pytest.approx(float(free_cubics.distance_constant().number()), rel=1e-4)
    assert all(largest(best + step) > largest(best) for step in (-1e-3, -1e-4, 1e-4, 1e-3))


@pytest.mark.parametrize("equation", ["(z**2 - 2)*(z - 3)", "z**4 - 4"])
def test_algebraic_numbers(equation):
    z = sp.Symbol("z")
    assert algebraic(sp.sympify(equation), z, (1, 2)).coefficients == (1, 0, -2)
    for bounds in ((-2, 2), (5, 6)):
        with pytest.raises(DomainError, match="roots between"):
            algebraic(sp.sympify(equation), z, bounds)
    assert Algebraic((1, 0, -2), 0).image(z**2 + z, z).coefficients == (1, -4, 2)


def test_both_orders_give_one_b_where_the_condition_holds():
    first, second = contact().third()
    values = dict(zip(Y, (sp.Rational(1, 2), sp.Rational(1, 3), sp.Rational(-2, 5), 1, 2)))
    (root,) = [r for r in sp.Poly(contact().condition.subs(values), a).nroots(n=40) if r.is_real]
    at = [sp.N(third.subs(values).subs(a, root), 30) for third in (first, second)]
    assert abs(at[0] - at[1]) < 1e-25
    assert abs(contact().fourth.subs(values).subs({a: root, b: at[0]})) < 1e-25


def jet(text, t, order=6):
    return CurveBalls(parse_tuple(text)).jet(constant(parse_constant(t)), order)


def test_residuals():
    with precision(PRECISION):
        (only,) = residuals(jet("t, 3*t^3/10+t^4/10+t^5/5-2*t^6/5", "0"))  # an inflection
        assert float(only) == pytest.approx(-0.5411522634, rel=1e-9)
        three = residuals(jet("t*cos(t), t*sin(t)", "2"))
        assert len(three) == 3 and branch(jet("t*cos(t), t*sin(t)", "2"))[0] == 3
        moved = residuals(jet("3*t, 3*t-t^3", "1/2"))  # a cubic itself
        assert min(abs(float(value)) for value in moved) < 1e-60
        merged = [branch(jet("t, cosh(t)", t))[0] for t in ("1/2", "27/50")]
        assert merged == [3, 1]  # two vanish at 0.516329339


@pytest.mark.parametrize(
    ("text", "low", "high", "value"),
    [
        ("t*cos(t), t*sin(t)", "pi/6", "2*pi", 1.223049744),
        ("t, exp(t)", "-2", "2", 0.330699280),
        ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "0", "3*pi/4", 0.579192258),
        ("2*cos(t), sin(t)", "0", "pi", 0.505318756),
        ("t, log(t)", "1/5", "5", 0.269042796),
        ("t, sin(t)", "-2", "2", 0.48556),
    ],
)
def test_complexities(text, low, high, value):
    with precision(PRECISION):
        ends = constant(parse_constant(low)), constant(parse_constant(high))
    found, error = complexity_constant(CurveBalls(parse_tuple(text)), "cubic", *ends)
    assert float(found) == pytest.approx(value, abs=10.0 ** -(len(str(value)) - 2))
    assert error < 1e-15


def test_a_complexity_adds_over_jumps():
    """Two of three cubics merge and vanish at 0.516…: the integrand jumps there."""
    curve = CurveBalls(parse_tuple("t, cosh(t)"))
    with precision(PRECISION):
        places = [constant(parse_constant(t)) for t in ("1/10", "2/5", "3/5", "9/10")]
    parts = [float(complexity_constant(curve, "cubic", x, y)[0]) for x, y in pairwise(places)]
    whole = float(complexity_constant(curve, "cubic", places[0], places[-1])[0])
    assert whole == pytest.approx(math.fsum(parts), rel=1e-15)


def test_graphs_over_the_tangent():
    with precision(PRECISION):
        rows = CurveBalls(parse_tuple("cos(t), sin(t)")).coefficients(arb(1), 6)
        heights = tangent_graph(*rows, lambda value: value.sqrt())
    assert [float(c) for c in heights] == pytest.approx([1 / 2, 0, 1 / 8, 0, 1 / 16], abs=1e-15)
