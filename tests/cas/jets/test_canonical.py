"""Canonical forms against exact series of other curves and against mpmath's numerical differentiation."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

import mpmath
import pytest
import sympy as sp
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, OsculantError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.canonical import (
    affine_arc,
    affine_graph,
    euclidean_arc,
    graph,
    moving_frame,
    series_of_derivatives,
)
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.fields import Multiprecision
from osculant.cas.numbers.power_series import PowerSeries, identity, power
from osculant.cas.numbers.taylor import program
from tests.graphs import formulas

DIGITS = 50
ORDER = 9
few = settings(max_examples=30, deadline=None)
rationals = st.fractions(-3, 3, max_denominator=5)
tails = st.lists(rationals, min_size=ORDER - 2, max_size=ORDER - 2)


def bracket(a, b):
    return a[0] * b[1] - a[1] * b[0]


def euclidean_graph(order, curvatures=None):
    """The Euclidean canonical form: y(x) where the curve is γ(0) + x·T₀ + y(x)·N₀; (y, (κ₀, κ₁, …))."""
    X, Y, kappa = euclidean_arc(order, curvatures)
    return graph(X, Y), kappa


def rate(curve):
    return curve[0].derivative(), curve[1].derivative()


def by(parameter_rate, function):
    """The derivatives at 0 of a series by the parameter whose rate is a series."""
    inverse = parameter_rate.integral().reversion()
    composed = function.at(inverse.cut(function.length))
    return [c * factorial(i) for i, c in enumerate(composed.coefficients)]


def curvatures(curve, speed):
    """κ and its derivatives by arc length, from the definition κ = [α̇, α̈]/v³."""
    first, second = rate(curve), rate(rate(curve))
    return by(speed, bracket(first, second) * (speed**-3))


def affine_curvatures(curve, phi):
    """k and its derivatives by affine arc length, k by (2.12)."""
    second, third = rate(rate(curve)), rate(rate(rate(curve)))
    slope = phi.derivative()
    return by(phi, bracket(second, third) * phi**-5 + (slope.derivative() * phi - 3 * slope**2) * phi**-4)


# Exact: random polynomial curves through their own parameter.


@given(tails, tails)
@few
def test_graphs_of_random_curves(first, second):
    """α̇(0) = (1, 0) and [α̇, α̈](0) = 1, so that both frames are rational; the rest is random."""
    one = Fraction(1)
    curve = (PowerSeries([0 * one, one, *first, one * 0]), PowerSeries([0 * one, 0 * one, one / 2, *second]))
    speed = power(rate(curve)[0] ** 2 + rate(curve)[1] ** 2, Fraction(1, 2))
    kappa = curvatures(curve, speed)
    assert euclidean_graph(ORDER, kappa)[0] == graph(*curve)

    phi = power(bracket(rate(curve), rate(rate(curve))), Fraction(1, 3))
    k = affine_curvatures(curve, phi)
    normal = curve[0][2] * 2 - phi[1]  # n = (α̈ − φ̇α̇)/φ³ is (this, 1)
    in_frame = (curve[0] - curve[1] * normal, curve[1])
    assert affine_graph(ORDER, k)[0] == graph(*in_frame)


@given(st.lists(rationals, min_size=ORDER - 1, max_size=ORDER - 1))
@few
def test_arcs_have_the_curvatures_given(values):
    one = Fraction(1)
    X, Y, _ = euclidean_arc(ORDER, values)
    speed = rate((X, Y))[0] ** 2 + rate((X, Y))[1] ** 2
    assert speed == speed * 0 + 1
    assert bracket(rate((X, Y)), rate(rate((X, Y)))) == series_of_derivatives(values).cut(ORDER - 1)
    X, Y, _ = affine_arc(ORDER, values)
    second = rate(rate((X, Y)))
    third = rate(second)
    assert bracket(rate((X, Y)), second) == PowerSeries([one, *[one * 0] * (ORDER - 2)])
    assert bracket(second, third) == series_of_derivatives(values).cut(ORDER - 2)


@pytest.mark.parametrize("make", [euclidean_arc, affine_arc, euclidean_graph, affine_graph])
def test_a_lower_order_is_a_cut(make):
    long, short = make(8)[0], make(5)[0]
    assert [str(c) for c in long.coefficients[:6]] == [str(c) for c in short.coefficients]


def test_the_ring_does_not_matter():
    _, *k = sp.ring("k:5", sp.QQ)
    generic, rational = affine_graph(8)[0], affine_graph(8, k)[0]
    for a, b in zip(generic.coefficients, rational.coefficients, strict=True):
        terms = {powers: Fraction(str(c)) for powers, c in a.to_dict().items()}
        assert terms == {powers: Fraction(int(c.numerator), int(c.denominator)) for powers, c in b.terms()}


def test_conics_and_circles():
    one = Fraction(1)
    circle = euclidean_graph(12, [one, *[one * 0] * 10])[0]
    ellipse = affine_graph(12, [one, *[one * 0] * 9])[0]
    root = power(1 - identity(13) ** 2, Fraction(1, 2))
    assert circle == ellipse == 1 - root
    assert affine_graph(12, [one * 0] * 10)[0] == identity(13) ** 2 / 2


def test_an_even_function_stays_even():
    y, k = affine_graph(9)
    symmetric = [g * (1 - i % 2) for i, g in enumerate(k)]  # k′ = k‴ = … = 0
    assert all(c.compose(*symmetric) == 0 for c in y.coefficients[1::2])
    assert any(c != 0 for c in y.coefficients[1::2])


# Numerical: mpmath's differentiation of the curve itself.


def evaluated(nodes):
    values = program(nodes, 0)
    return lambda s: tuple(column[0] for column in values.run(s, Multiprecision()))


def jets(nodes, at, order):
    return program(nodes, order).run(at, Multiprecision())


def close(a, b, scale=1):
    return abs(a - b) < mpmath.mpf(10) ** -25 * max(1, abs(b), abs(scale))


def numerical_columns(nodes, at, order):
    curve = evaluated(nodes)
    return [list(mpmath.diffs(lambda s, i=i: curve(s)[i], at, order)) for i in range(2)]


def agree_with_numerical_differentiation(nodes, at):
    """Jet by numerical differentiation of the curve; κ′, κ″, dk/dr by that of κ(t) and k(t)."""
    x, y = jets(nodes, at, 6)
    numerical_x, numerical_y = numerical_columns(nodes, at, 6)
    size = max(abs(c) for c in (*x, *y))
    for a, b in zip((*x, *y), (*numerical_x, *numerical_y), strict=True):
        assert close(a, b, size)
    jet = PlaneJet(x, y)

    def local(s):
        return PlaneJet(*jets(nodes, s, 4))

    slope = mpmath.diff(lambda s: local(s).curvature, at) / jet.speed
    assert close(jet.curvature_slope, slope, 1e8)
    bend = mpmath.diff(lambda s: local(s).curvature_slope, at) / jet.speed
    assert close(jet.curvature_bend, bend, 1e8)
    phi, phi1, phi2 = mpmath.diffs(lambda s: local(s).affine_speed, at, 2)
    k = jet.bracket(2, 3) / phi**5 + (phi2 * phi - 3 * phi1**2) / phi**4  # (2.12)
    assert close(jet.affine_curvature, k, 1e8)
    assert close(jet.affine_curvature_slope, mpmath.diff(lambda s: local(s).affine_curvature, at) / phi, 1e8)

    # the curve in its frames: Y(t) − y(X(t)) has no derivative at t up to the order of the form
    n = jet.affine_normal
    t = jet.affine_tangent
    k_jet = [jet.affine_curvature, jet.affine_curvature_slope]
    fits = (
        (affine_graph(5, k_jet)[0], (t, n)),
        (
            euclidean_graph(4, [jet.curvature, jet.curvature_slope, jet.curvature_bend])[0],
            ((x[1] / jet.speed, y[1] / jet.speed), (-y[1] / jet.speed, x[1] / jet.speed)),
        ),
    )
    curve = evaluated(nodes)
    for series, (first, second) in fits:

        def residual(s, series=series, first=first, second=second):
            away = [a - c[0] for a, c in zip(curve(s), (x, y), strict=True)]
            along, across = bracket(away, second), bracket(first, away)
            return across - mpmath.polyval(series.coefficients[::-1], along)

        order = series.length - 1
        for i, d in enumerate(mpmath.diffs(residual, at, order)):
            scale = max(abs(c) for c in series.coefficients) * (1 + jet.speed + size) ** (order + 3)
            assert close(d, 0, scale), i


@given(formulas, formulas)
@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.filter_too_much])
def test_random_curves(first, second):
    nodes = (first, second)
    with mpmath.workdps(DIGITS):
        at = mpmath.mpf(1) / 3
        try:
            columns = jets(nodes, at, 6)
            spread = [evaluated(nodes)(at + s) for s in (-0.01, 0.01)]
        except (OsculantError, ValueError, ZeroDivisionError, OverflowError):
            assume(False)
        assume(all(mpmath.isfinite(c) and abs(c) < 100 for column in (*columns, *spread) for c in column))
        jet = PlaneJet(*columns)
        assume(jet.speed_squared > 1e-4 and abs(jet.inflection_form) > 1e-2)
        agree_with_numerical_differentiation(nodes, at)


@pytest.mark.parametrize(
    "text",
    ["t*cos(t), t*sin(t)", "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "exp(t), t**3 - t", "t, 1/(2 - t)"],
)
def test_known_curves(text):
    with mpmath.workdps(DIGITS):
        agree_with_numerical_differentiation(parse_tuple(text), mpmath.mpf(2) / 5)


@pytest.mark.parametrize("text", ["t*cos(t), t*sin(t)", "exp(t), t**3 - 2*t", "t, 1/(2 - t)"])
def test_high_orders_against_numerical_differentiation_of_the_graph(text):
    """x ↦ y(x), found by solving x(t) = x and differentiated by mpmath, against both canonical forms."""
    order = 7
    with mpmath.workdps(DIGITS):
        nodes, at = parse_tuple(text), mpmath.mpf(7) / 5
        curve = evaluated(nodes)
        columns = [
            PowerSeries([d / mpmath.factorial(i) for i, d in enumerate(column)])
            for column in jets(nodes, at, order + 2)
        ]
        velocity = rate(columns)
        speed2 = velocity[0] ** 2 + velocity[1] ** 2
        speed = power(speed2, Fraction(1, 2), mpmath.sqrt(speed2[0]))
        cube = bracket(velocity, rate(velocity))
        root = mpmath.sign(cube[0]) * mpmath.cbrt(abs(cube[0]))
        phi = power(cube, Fraction(1, 3), root)
        first = [c[0] / speed[0] for c in velocity]
        tangent = [c[0] / phi[0] for c in velocity]
        bend = [c[0] for c in rate(velocity)]
        normal = [(b - phi[1] * a) / phi[0] ** 2 for a, b in zip(tangent, bend, strict=True)]
        forms = (
            (euclidean_graph(order, curvatures(columns, speed))[0], first, (-first[1], first[0])),
            (affine_graph(order, affine_curvatures(columns, phi))[0], tangent, normal),
        )
        for series, e1, e2 in forms:

            def place(s, e1=e1, e2=e2):
                away = [a - c[0] for a, c in zip(curve(s), columns, strict=True)]
                return bracket(away, e2), bracket(e1, away)

            def height(value, place=place):
                s = mpmath.findroot(lambda s: place(s)[0] - value, (at - 1e-3, at + 1e-3))
                return place(s)[1]

            for i, d in enumerate(mpmath.diffs(height, mpmath.mpf(0), order)):
                assert close(series[i] * mpmath.factorial(i), d)


# Bad input.


@pytest.mark.parametrize("make", [euclidean_arc, affine_arc, euclidean_graph, affine_graph])
@pytest.mark.parametrize("order", [0, -3])
def test_orders_that_say_nothing(make, order):
    with pytest.raises(DomainError, match=f"order {order} says nothing"):
        make(order)


@pytest.mark.parametrize("make", [euclidean_arc, affine_arc, euclidean_graph, affine_graph])
def test_orders_beyond_reach(make):
    with pytest.raises(DomainError, match=r"whole number, not 2\.5"):
        make(2.5)
    with pytest.raises(DomainError, match="order 40 takes too long: the highest is 20, or 60"):
        make(40)
    with pytest.raises(DomainError, match="order 61 takes too long"):
        make(61, [Fraction(1)] * 61)


@pytest.mark.parametrize(("make", "needed"), [(euclidean_arc, 6), (affine_arc, 5), (affine_graph, 4)])
def test_orders_beyond_the_jets(make, needed):
    one = Fraction(1)
    assert make(7, [one] * needed)[0].length == 8
    with pytest.raises(DomainError, match=f"up to order {needed - 1}, but only {needed - 1} values"):
        make(7, [one] * (needed - 1))
    with pytest.raises(DomainError, match="only 0 values"):
        make(1, [])


def test_no_graph_over_a_normal():
    with pytest.raises(DomainError, match="coefficient of x is 0"):
        graph(PowerSeries([0, 0, 1]), PowerSeries([0, 1, 0]))


def test_frames_need_their_rates():
    one = PowerSeries([Fraction(1)] * 3)
    assert moving_frame(one, one, 4)[0][0].length == 4
    with pytest.raises(DomainError, match="order 3 is not known"):
        moving_frame(one, one, 5)
