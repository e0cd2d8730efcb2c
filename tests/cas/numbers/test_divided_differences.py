"""Divided differences: confluent nodes against limits, exactness, symmetry, the integral, and bad input."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import arb, fmpq, fmpq_mpoly_ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.divided_differences import (
    divided_difference,
    exact,
    hermite_data,
    newton,
    same_node,
)
from osculant.cas.numbers.division import (
    difference_quotient,
    hermite_genocchi,
    newton_of_polynomial,
    scaled_difference,
    simplex_moment,
)
from osculant.cas.numbers.fields import Balls, Multiprecision
from osculant.cas.numbers.power_series import PowerSeries
from osculant.cas.numbers.taylor import program
from tests.cas.numbers.rationals import Rationals

rationals = st.fractions(-5, 5, max_denominator=7)
#: few values, so that nodes coincide often
nodes = st.lists(st.sampled_from([Fraction(n, 2) for n in range(-3, 4)]), min_size=1, max_size=6)
polynomials = st.lists(rationals, min_size=1, max_size=8)


def of_expression(expression, symbol):
    """A sympy expression as a function of one of its symbols."""

    def coefficient(node, order):
        value = sp.diff(expression, symbol, order).subs(symbol, node) / math.factorial(order)
        if value.has(sp.nan, sp.zoo, sp.oo, -sp.oo):
            raise DomainError(f"{expression} has no derivative of order {order} at the node {node}.")
        return value

    return coefficient


def of_formula(formula, field):
    """A parsed formula as a function over a field of numbers, by Taylor arithmetic."""

    def coefficient(node, order):
        return exact(program([formula], order, normalised=True).run(node, field)[0][order])

    return coefficient


def taylor_of(polynomial):
    """The polynomial as a Taylor, by binomials: independent of synthetic division."""

    def coefficient(node, order):
        terms = (
            c * math.comb(i, order) * node ** (i - order) for i, c in enumerate(polynomial) if i >= order
        )
        return sum(terms, Fraction(0))

    return coefficient


def value(polynomial, x):
    return sum((c * x**i for i, c in enumerate(polynomial)), Fraction(0))


# Exactness on rationals.


@given(polynomials, nodes)
def test_recursion_division_and_integral_agree(polynomial, at):
    by_recursion = newton(taylor_of(polynomial), at)
    assert by_recursion.coefficients == newton_of_polynomial(polynomial, at).coefficients
    assert by_recursion.coefficients[-1] == hermite_genocchi(polynomial, at)


@given(polynomials, nodes, st.randoms(use_true_random=False))
def test_a_difference_does_not_depend_on_the_order_of_its_nodes(polynomial, at, source):
    shuffled = list(at)
    source.shuffle(shuffled)
    f = taylor_of(polynomial)
    assert divided_difference(f, at) == divided_difference(f, shuffled)
    assert newton(f, at).polynomial() == newton(f, shuffled).polynomial()


@given(polynomials, nodes)
def test_the_newton_form_has_the_derivatives_that_multiplicities_ask_for(polynomial, at):
    f, form = taylor_of(polynomial), newton(taylor_of(polynomial), at)
    interpolating = taylor_of(form.polynomial())
    for node in set(at):
        for order in range(at.count(node)):
            assert interpolating(node, order) == f(node, order)
    assert len(form.polynomial()) == len(at)


@given(polynomials, nodes, rationals)
def test_evaluation_and_remainder_add_up(polynomial, at, x):
    f, form = taylor_of(polynomial), newton(taylor_of(polynomial), at)
    assert form(x) == value(form.polynomial(), x)
    assert form(x) + form.remainder(f, x) == value(polynomial, x)


@given(polynomials, nodes)
def test_a_product_is_divided_by_its_zeros(polynomial, zeros):
    product = list(polynomial)
    for zero in zeros:
        product = [a - zero * b for a, b in zip([0, *product], [*product, 0])]
    quotient = difference_quotient(product, zeros)
    assert list(quotient) == polynomial
    x = Fraction(11, 3)  # none of the zeros
    assert divided_difference(taylor_of(product), [*zeros, x]) == value(polynomial, x)


@given(polynomials, st.lists(st.integers(-3, 3), min_size=1, max_size=4), st.integers(0, 2))
def test_the_series_of_scaled_nodes(polynomial, multiples, extra):
    assume(len(polynomial) >= len(multiples))
    series = scaled_difference(PowerSeries(polynomial), multiples)
    for rho in (Fraction(0), Fraction(1, 3), Fraction(-2)):
        exact = divided_difference(taylor_of(polynomial), [rho * a for a in multiples])
        assert value(series.coefficients, rho) == exact


@pytest.mark.parametrize("exponents", [(0, 0), (2, 0, 1), (1, 1, 1, 1), (3,), (0, 4, 2)])
def test_moments_of_the_simplex_are_dirichlets(exponents):
    top = math.prod(math.factorial(e) for e in exponents)
    assert simplex_moment(exponents) == Fraction(top, math.factorial(sum(exponents) + len(exponents) - 1))


# Other kinds of numbers.


def test_symbolic_nodes_coefficients_and_coincidences():
    a, b, x = sp.symbols("a b x")
    difference = divided_difference(of_expression(sp.exp(x), x), [a, b, a])
    assert sp.simplify(difference - (sp.exp(b) - sp.exp(a) - sp.exp(a) * (b - a)) / (b - a) ** 2) == 0
    assert sp.limit(difference.subs(a, 0), b, 0) == sp.Rational(1, 2)
    root = sp.sqrt(5 + 2 * sp.sqrt(6))
    assert divided_difference(of_expression(x**2, x), [root, sp.sqrt(2) + sp.sqrt(3)]) == 2 * root


def test_polynomials_over_a_ring_of_polynomials_need_no_quotients():
    p, q, c = fmpq_mpoly_ctx.get(["p", "q", "c"], "lex").gens()
    assert newton_of_polynomial([p * 0, p * 0, p * 0, c], [p, q, p]).coefficients[-1] == c * (2 * p + q)
    assert hermite_genocchi([p * 0, p * 0, p * 0, c], [p, q, p]) == c * (2 * p + q)
    with pytest.raises(DomainError, match="cannot be divided"):
        divided_difference(hermite_data([(p, [c]), (q, [c + 1])]), [p, q])


def test_flints_rationals_and_balls():
    table = hermite_data([(fmpq(1, 2), [fmpq(1), fmpq(3)]), (fmpq(2), [fmpq(4)])])
    assert divided_difference(table, [fmpq(1, 2), fmpq(2), fmpq(1, 2)]) == fmpq(-2, 3)
    with precision(200):
        sine = of_formula(parse("sin(t)", ("t",)), Balls())
        narrow = divided_difference(sine, [arb("0.1"), arb("0.2"), arb("0.3")])
        exact = (arb("0.3").sin() - 2 * arb("0.2").sin() + arb("0.1").sin()) / arb("0.02")
        assert narrow.overlaps(exact) and narrow.rad() < 1e-50
        third = arb(1) / 3
        tripled = divided_difference(sine, [third, third, third])  # one ball is one node
        assert tripled.overlaps(-third.sin() / 2)
        with pytest.raises(UndecidedError, match="precision"):
            divided_difference(sine, [third, arb(1) / 3])


@settings(deadline=None, max_examples=25)
@given(st.lists(st.integers(-2, 2), min_size=2, max_size=5), st.integers(6, 8))
def test_close_nodes_tend_to_the_confluent_difference(multiples, digits):
    """At 50 digits; the difference is O(h), with h small enough to see but not to cancel all digits."""
    with mpmath.workdps(50):
        h = mpmath.mpf(10) ** -digits
        f = of_formula(parse("exp(t)*cos(2*t)", ("t",)), Multiprecision())
        centre = mpmath.mpf(3) / 7
        distinct = [centre + h * (a + mpmath.mpf(i) / 100) for i, a in enumerate(multiples)]
        order = len(multiples) - 1
        limit = divided_difference(f, [centre] * (order + 1))
        derivative = mpmath.diff(lambda t: mpmath.exp(t) * mpmath.cos(2 * t), centre, order)
        oracle = derivative / mpmath.factorial(order)
        assert abs(limit - oracle) < mpmath.mpf(10) ** -25
        assert abs(divided_difference(f, distinct) - limit) < 100 * h
        pairs = divided_difference(f, [centre] * order + [centre + h])
        assert abs(pairs - limit) < 100 * h


def test_floats_agree_with_fractions():
    at = [0.5, 2.0, 0.5, -1.0]
    exact = divided_difference(taylor_of([1, 0, 0, 0, 1]), [Fraction(x) for x in at])
    assert divided_difference(taylor_of([1.0, 0.0, 0.0, 0.0, 1.0]), at) == pytest.approx(
        float(exact), rel=1e-14
    )


def test_a_formula_over_the_rationals():
    inverse = of_formula(parse("1/(1 + t)", ("t",)), Rationals())
    # [x₀, …, xₙ](1/(1 + t)) = (−1)ⁿ/∏(1 + xᵢ)
    assert divided_difference(inverse, [0, 1, 1, 3]) == Fraction(-1, 16)


# Bad input.


def test_no_nodes():
    with pytest.raises(DomainError, match="at least one node"):
        newton(taylor_of([1]), [])
    with pytest.raises(DomainError, match="at least one node"):
        newton_of_polynomial([1], [])
    with pytest.raises(DomainError, match="at least one"):
        hermite_genocchi([], [1])
    with pytest.raises(DomainError, match="at least one node"):
        scaled_difference(PowerSeries([1]), [])


def test_missing_derivatives_name_the_node():
    table = hermite_data([(0, (1, 2)), (5, (3,))])
    with pytest.raises(DomainError, match="node 5 is taken 2 times and needs the derivatives up to order 1"):
        divided_difference(table, [5, 0, 5])
    with pytest.raises(DomainError, match="No value is given at the node 7"):
        divided_difference(table, [0, 7])


@pytest.mark.parametrize("node", [float("nan"), float("inf"), mpmath.inf, sp.oo, sp.nan, arb("nan")])
def test_nodes_must_be_finite(node):
    with pytest.raises(DomainError, match="not finite"):
        divided_difference(taylor_of([1, 2]), [node])


@pytest.mark.parametrize("node", [None, "1", (1, 2)])
def test_nodes_must_be_numbers(node):
    with pytest.raises(DomainError, match="not a number"):
        divided_difference(taylor_of([1, 2]), [node])


def test_kinds_of_nodes_that_do_not_mix():
    with pytest.raises(DomainError, match="cannot be compared"):
        same_node(arb(1), Fraction(1))


def test_a_pole_and_a_node_that_is_no_zero():
    x = sp.Symbol("x")
    with pytest.raises(DomainError, match="node 0"):
        divided_difference(of_expression(1 / x, x), [1, 0])
    with pytest.raises(DomainError, match="number 2, is not a zero"):
        difference_quotient((0, 1, 1), (0, 0))


def test_a_series_too_short():
    with pytest.raises(DomainError, match="3 nodes needs the coefficient of order 2"):
        scaled_difference(PowerSeries([1, 2]), [0, 1, 2])


@pytest.mark.parametrize(
    "twice", [(0, 0), (1, Fraction(1)), (sp.sqrt(8), 2 * sp.sqrt(2)), (0.5, Fraction(1, 2))]
)
def test_a_node_given_twice(twice):
    first, second = twice
    with pytest.raises(DomainError, match="is given twice"):
        hermite_data([(first, (1,)), (7, (3,)), (second, (2,))])


def test_integrals_with_too_many_monomials():
    with pytest.raises(DomainError, match="125970 monomials"):
        hermite_genocchi([1] * 20, range(12))
    assert hermite_genocchi([1] * 14, range(12)) == newton_of_polynomial([1] * 14, range(12)).coefficients[-1]


@pytest.mark.parametrize("exponents", [(), (-1, 2), (1, 0.5), (Fraction(3, 2), 1)])
def test_moments_with_other_exponents(exponents):
    with pytest.raises(DomainError, match="whole numbers"):
        simplex_moment(exponents)
