"""The five-point conic: on conics, near coincidence, at the osculating conic, in every kind of number."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import mpmath
import pytest
import sympy as sp
from flint import arb, fmpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.five_points import (
    Conic,
    conic_affine_curvature,
    five_point_conic,
    osculating_conic,
)
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.fields import Multiprecision
from osculant.cas.numbers.taylor import program

SPIRAL = parse_tuple("t*cos(t), t*sin(t)", ("t",))
small = st.fractions(-4, 4, max_denominator=5)


def polynomial_curve(x, y):
    """The curve with those coefficients, the constant ones first, as jets over any numbers."""

    def derivatives(coefficients, at, order):
        found = []
        for _ in range(order + 1):
            total = at * 0
            for c in reversed(coefficients):
                total = total * at + c
            found.append(total)
            coefficients = [i * c for i, c in enumerate(coefficients)][1:] or [coefficients[0] * 0]
        return found

    return lambda at, order: PlaneJet(derivatives(x, at, order), derivatives(y, at, order))


def multiprecision(at, order):
    return PlaneJet(*program(SPIRAL, order).run(at, Multiprecision()))


def proportional(one, other):
    return all(a * d == b * c for (a, b), (c, d) in product(zip(one, other), repeat=2))


CUBIC = polynomial_curve([Fraction(0), Fraction(1)], [Fraction(1), Fraction(-2), Fraction(3), Fraction(1)])


@given(st.lists(st.sampled_from([Fraction(i, 3) for i in range(6)]), min_size=5, max_size=5))
def test_contact_has_the_multiplicity_of_the_parameters(parameters):
    """On y = 1 − 2t + 3t² + t³, convex for t ≥ 0: the equation along the curve is divisible by ∏(t − sᵢ)."""
    conic = five_point_conic(CUBIC, parameters)
    t = sp.Symbol("t")
    along = sp.Poly(conic(t, 1 - 2 * t + 3 * t**2 + t**3), t)
    assert not along.is_zero
    for parameter in parameters:
        along, remainder = sp.div(along, sp.Poly(t - sp.Rational(str(parameter)), t))
        assert remainder.is_zero


@given(
    st.lists(st.sampled_from([Fraction(i, 3) for i in range(6)]), min_size=5, max_size=5),
    st.permutations(range(5)),
)
def test_the_order_of_the_parameters_does_not_matter(parameters, order):
    shuffled = [parameters[i] for i in order]
    assert proportional(five_point_conic(CUBIC, parameters), five_point_conic(CUBIC, shuffled))


@given(st.lists(small, min_size=6, max_size=6), st.lists(st.integers(-3, 3), min_size=5, max_size=5))
def test_points_of_a_parabola_give_it_back(coefficients, parameters):
    x, y = coefficients[:3], coefficients[3:]
    assume(x[1] * y[2] != x[2] * y[1])
    conic = five_point_conic(polynomial_curve(x, y), parameters)
    assert conic_affine_curvature(conic) == 0
    for at in (Fraction(7), Fraction(-9, 2)):
        assert conic(*polynomial_curve(x, y)(at, 0).point(0)) == 0


@settings(deadline=None, max_examples=15)
@given(st.lists(st.integers(-3, 3), min_size=5, max_size=5), st.integers(8, 10))
def test_close_points_tend_to_coincident_ones(multiples, digits):
    with mpmath.workdps(60):
        h, centre = mpmath.mpf(10) ** -digits, mpmath.mpf(2)
        near = [centre + h * (a + mpmath.mpf(i) / 50) for i, a in enumerate(multiples)]
        limit = osculating_conic(multiprecision(centre, 4))
        conic = five_point_conic(multiprecision, near)
        for a, b in zip(conic, limit):
            assert abs(a / conic.a - b / limit.a) < 1000 * h
        k = conic_affine_curvature(conic)
        assert abs(k - multiprecision(centre, 4).affine_curvature) < 100 * h


@settings(deadline=None, max_examples=10)
@given(st.integers(20, 60))
def test_the_osculating_conic_has_the_curves_affine_curvature(tenths):
    with mpmath.workdps(50):
        jet = multiprecision(mpmath.mpf(tenths) / 10, 4)
        assert mpmath.almosteq(conic_affine_curvature(osculating_conic(jet)), jet.affine_curvature, 1e-40)


def test_the_mean_of_affine_curvatures_with_its_quadratic_error():
    """Remark 3.5.3: halving the arc quarters the difference."""
    with mpmath.workdps(50):
        errors = []
        for h in (mpmath.mpf("1e-3"), mpmath.mpf("5e-4")):
            at = [2 + h * a for a in (0, 0, 2, 3, 5)]
            mean = sum(multiprecision(s, 4).affine_curvature for s in at) / 5
            errors.append(conic_affine_curvature(five_point_conic(multiprecision, at)) - mean)
        assert abs(errors[0] / errors[1] - 4) < 0.01


def test_balls_enclose_what_mpmath_finds():
    with precision(200), mpmath.workdps(50):
        curve = CurveBalls(SPIRAL)
        end = arb(3)
        conic = five_point_conic(curve.jet, [arb(2), end, end, arb("2.5"), arb(2)])
        k = conic_affine_curvature(conic)
        same = conic_affine_curvature(five_point_conic(multiprecision, [2, 3, 3, mpmath.mpf("2.5"), 2]))
        assert k.rad() < 1e-40 and abs(k - arb(mpmath.nstr(same, 48))) < 1e-38


@pytest.mark.parametrize("number", [Fraction, fmpq, lambda n: sp.Rational(n), float, mpmath.mpf])
def test_a_circle_in_every_kind_of_number(number):
    """(4t, 2 − 2t²)/(1 + t²), as derivatives at t = 0: radius 2, k = 2^(−4/3)."""
    x = [number(v) for v in (0, 4, 0, -24, 0)]
    y = [number(v) for v in (2, 0, -8, 0, 96)]
    conic = osculating_conic(PlaneJet(x, y))
    assert conic.S * conic.S * conic.S * 16 == conic.T * conic.T
    k = conic_affine_curvature(conic)
    assert abs(float(k) - 2 ** (-4 / 3)) < 1e-15


def test_symbolic_jets_and_symbolic_parameters():
    a = sp.Symbol("a")
    jet = PlaneJet((0, 1, 0, 0, 0), (0, 0, 1, 0, 3 * a))  # y = x²/2 + ax⁴/8
    conic = osculating_conic(jet)
    assert sp.simplify(conic.c / conic.a - a) == 0  # x² + ay² = 2y
    s = sp.field("s1:5", sp.QQ)[1:]
    conic = five_point_conic(polynomial_curve([0, 1], [0, 0, 0, 1]), (*s, s[0]))
    for node in s:
        assert conic(node, node**3) == 0
    # a double zero at s1
    node = s[0]
    assert conic.a * node + conic.d + 3 * node**2 * (conic.c * node**3 + conic.e) + 4 * conic.b * node**3 == 0


# Bad input.


def test_another_number_of_points():
    with pytest.raises(DomainError, match="5 parameters, not by 4"):
        five_point_conic(CUBIC, [0, 1, 2, 3])


@pytest.mark.parametrize(
    ("x", "y", "parameters"),
    [
        ([0, 1], [0, 0, 0, 0, 1], [0, 0, 0, 0, 5]),  # contact of order 3 with the tangent
        ([0, 1], [0, 0, 0, 0, 1], [0, 0, 0, 0, 0]),
        ([0, 1], [0, -1, 0, 1, 0, 0], [0, 0, 0, 0, 0]),  # the next one is a line: see below
        ([0, 1], [2, 3], [0, 1, 2, 2, 3]),
        ([0, 0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 0]),  # a cusp
    ],
)
def test_singular_contact_conditions(x, y, parameters):
    curve = polynomial_curve([Fraction(c) for c in x], [Fraction(c) for c in y])
    if y == [0, -1, 0, 1, 0, 0]:  # at an ordinary inflection the conic is the tangent taken twice
        conic = five_point_conic(curve, parameters)
        assert conic.S == conic.T == 0
        with pytest.raises(DomainError, match="pair of lines"):
            conic_affine_curvature(conic)
        return
    with pytest.raises(DomainError, match="Singular contact conditions"):
        five_point_conic(curve, parameters)


@pytest.mark.parametrize("number", [float, mpmath.mpf])
def test_singular_contact_conditions_in_floats(number):
    curve = polynomial_curve([number(0), number(1)], [number("0.1"), number("0.7")])
    with pytest.raises(DomainError, match="Singular contact conditions"):
        five_point_conic(curve, [number(i) / 3 for i in range(5)])


def test_balls_that_cannot_decide():
    flat = [arb(0)] * 3
    wide = PlaneJet([arb(0), arb(1), *flat], [arb(0), arb(0), arb(0, 1), arb(0, 1), arb(0)])
    with pytest.raises(UndecidedError, match="singular"):
        osculating_conic(wide)
    with pytest.raises(UndecidedError, match="two nodes"):
        five_point_conic(CurveBalls(SPIRAL).jet, [arb(1, 1e-3), arb(1), arb(2), arb(3), arb(4)])


def test_a_jet_too_short():
    with pytest.raises(DomainError, match="needs the curve's derivatives up to order 3"):
        osculating_conic(PlaneJet((0, 1, 0), (0, 0, 1)))


def test_a_pair_of_lines_has_no_affine_curvature():
    with pytest.raises(DomainError, match="pair of lines"):
        conic_affine_curvature(Conic(1, 0, -1, 0, 0, 0))


def test_symbols_are_refused_instead_of_swelling():
    a, b = sp.symbols("a b")
    with pytest.raises(DomainError, match=r"sympy\.field"):
        five_point_conic(lambda t, order: PlaneJet((t, 1, 0, 0, 0), (t * t, 2 * t, 2, 0, 0)), (a, b, 0, 1, 2))
