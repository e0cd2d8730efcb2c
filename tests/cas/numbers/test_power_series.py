"""Power series: the laws of the ring, and composition, reversion and implicit solutions against mpmath."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import Ordering, arb, fmpq, fmpq_mpoly_ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, OsculantError
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.fields import Multiprecision
from osculant.cas.numbers.power_series import PowerSeries, identity, power, ratio, solve
from osculant.cas.numbers.taylor import program
from tests.graphs import formulas

DIGITS = 50
LENGTH = 6
few = settings(max_examples=30, deadline=None)
GENERATORS = fmpq_mpoly_ctx.get(["a", "b"], Ordering.degrevlex).gens()

rationals = st.fractions(-4, 4, max_denominator=6)
nonzero = rationals.filter(bool)


def series_of(first, length=LENGTH):
    return st.builds(
        lambda c, rest: PowerSeries([c, *rest]),
        first,
        st.lists(rationals, min_size=length - 1, max_size=length - 1),
    )


anything, units, small = series_of(rationals), series_of(nonzero), series_of(st.just(Fraction(0)))
invertible = st.builds(lambda s, c: PowerSeries([s[0], c, *s.coefficients[2:]]), small, nonzero)


@st.composite
def polynomials(draw):
    """Over ℚ[a, b] of flint."""
    a, b = GENERATORS
    zero = a * 0
    parts = [
        zero
        + sum(fmpq(q.numerator, q.denominator) * m for q, m in zip(draw(st.lists(rationals)), (a, b, a * b)))
        for _ in range(4)
    ]
    return PowerSeries(parts)


# The ring.


@given(anything, anything, anything)
@few
def test_commutative_ring(f, g, h):
    assert f + g == g + f
    assert f * g == g * f
    assert (f + g) + h == f + (g + h)
    assert (f * g) * h == f * (g * h)
    assert f * (g + h) == f * g + f * h
    assert f - f == f * 0
    assert f * 1 == f == f + 0
    assert 2 - f == -(f - 2)


@given(polynomials(), polynomials(), polynomials())
@few
def test_commutative_ring_over_polynomials(f, g, h):
    assert f * g == g * f
    assert (f * g) * h == f * (g * h)
    assert f * (g + h) == f * g + f * h
    assert (f * g).derivative() == f.derivative() * g + f * g.derivative()


@given(anything, units)
@few
def test_division_undoes_multiplication(f, g):
    assert f * g / g == f
    assert g * g.reciprocal() == f * 0 + 1
    assert 3 / g == g.reciprocal() * 3
    assert f / Fraction(2, 3) == f * Fraction(3, 2)


@given(units, st.integers(0, 4), st.integers(0, 3))
@few
def test_integer_powers(f, m, n):
    assert f**m * f**n == f ** (m + n)
    assert f**-m == (f**m).reciprocal()


@given(anything, anything)
@few
def test_derivative_is_a_derivation_and_the_integral_undoes_it(f, g):
    assert (f * g).derivative() == f.derivative() * g + f * g.derivative()
    assert f.integral().derivative() == f
    assert f.derivative().integral() + f[0] == f


@given(anything, st.integers(1, LENGTH + 3), st.integers(0, 3))
@few
def test_cut_and_shift(f, length, places):
    assert f.cut(length).length == min(length, f.length)
    assert f.shifted(places).shifted(-places) == f
    assert f.shifted(places).length == f.length + places


@given(anything, anything)
@few
def test_lengths_are_what_is_known(f, g):
    short = g.cut(3)
    assert (f + short).length == (f * short).length == 3
    assert f * short == (f * g).cut(3)


# Composition, reversion, implicit solutions, powers: exact laws.


@given(anything, anything, small)
@few
def test_composition_is_a_homomorphism(f, g, inner):
    assert (f * g).at(inner) == f.at(inner) * g.at(inner)
    assert (f + g).at(inner) == f.at(inner) + g.at(inner)
    assert f.at(identity(LENGTH)) == f


@given(anything, small, small)
@few
def test_composition_is_associative(f, g, h):
    assert f.at(g).at(h) == f.at(g.at(h))


@given(anything, small)
@few
def test_chain_rule(f, inner):
    left, right = f.at(inner).derivative(), f.derivative().at(inner) * inner.derivative()
    assert left == right


@given(anything, nonzero)
@few
def test_scaling_is_composition(f, factor):
    assert f.scaled(factor) == f.at(identity(LENGTH) * factor)


@given(invertible)
@few
def test_reversion_is_the_two_sided_inverse(f):
    assert f.at(f.reversion()) == f.reversion().at(f) == identity(LENGTH)


@given(invertible)
@few
def test_reversion_is_the_implicit_solution(f):
    assert f.reversion() == solve(lambda y: f.at(y) - identity(LENGTH), f[1], LENGTH)


@given(units, st.integers(-4, 4), st.integers(1, 4))
@few
def test_rational_powers(f, p, q):
    root = power(f / f[0], Fraction(p, q))
    assert root**q == (f / f[0]) ** p


# Against mpmath at 50 digits.


def close(a, b):
    return abs(a - b) < mpmath.mpf(10) ** (10 - DIGITS) * max(1, abs(b))


@pytest.mark.parametrize("point", ["1/3", "-5/7"])
def test_elementary_functions_through_composition(point):
    with mpmath.workdps(DIGITS):
        at = mpmath.mpf(Fraction(point).numerator) / Fraction(point).denominator
        inner = PowerSeries(mpmath.taylor(mpmath.sin, at, 8))
        outer = PowerSeries(mpmath.taylor(mpmath.exp, inner[0], 8))
        found = outer.at(inner - inner[0])
        for n, d in enumerate(mpmath.diffs(lambda s: mpmath.exp(mpmath.sin(s)), at, 8)):
            assert close(found[n] * mpmath.factorial(n), d)


def test_reversion_against_mpmath():
    with mpmath.workdps(DIGITS):
        series = PowerSeries([mpmath.mpf(0), *(d / mpmath.factorial(n) for n, d in _diffs(mpmath.tan, 9))])
        for n, d in _diffs(mpmath.atan, 9):
            assert close(series.reversion()[n] * mpmath.factorial(n), d)


def _diffs(f, order):
    return list(enumerate(mpmath.diffs(f, mpmath.mpf(0), order)))[1:]


def test_implicit_solution_against_mpmath():
    """Kepler's equation y − sin(y)/3 = x, solved by a series and by mpmath's Newton method."""
    with mpmath.workdps(DIGITS):
        sine = PowerSeries([c / mpmath.factorial(n) for n, c in enumerate((0, 1, 0, -1, 0, 1, 0, -1, 0, 1))])
        zero, third = mpmath.mpf(0), mpmath.mpf(1) / 3
        x = identity(10, zero)
        y = solve(lambda y: y - sine.at(y) * third - x, 1 - third, 10)

        def kepler(s):
            return mpmath.findroot(lambda v: v - mpmath.sin(v) / 3 - s, s * 3 / 2)

        for n, d in enumerate(mpmath.diffs(kepler, 0, 6)):
            assert close(y[n] * mpmath.factorial(n), d)


@given(formulas)
@few
def test_series_of_random_formulas(node):
    """x ↦ f(1/3 + x + x²) by composition of Taylor series, and by mpmath's numerical differentiation."""
    order = 4
    with mpmath.workdps(DIGITS):
        at = mpmath.mpf(1) / 3
        try:
            (outer,) = program([node], order).run(at, Multiprecision())
            value = program([node], 0)

            def composed(s):
                return value.run(at + s + s * s, Multiprecision())[0][0]

            expected = list(mpmath.diffs(composed, 0, order))
        except (OsculantError, ValueError, ZeroDivisionError, OverflowError, NotImplementedError):
            assume(False)
        assume(all(mpmath.isfinite(d) and abs(d) < 1e30 for d in (*expected, *outer)))
        series = PowerSeries([d / mpmath.factorial(n) for n, d in enumerate(outer)])
        step = PowerSeries([mpmath.mpf(c) for c in (0, 1, 1, 0, 0)])
        for n, d in enumerate(expected):
            scale = max(1, *(abs(c) for c in outer))
            assert abs(series.at(step)[n] * mpmath.factorial(n) - d) < mpmath.mpf(10) ** -25 * scale


# Other rings, and bad input.


def test_sympy_rings_expressions_and_balls():
    _, a = sp.ring("a", sp.QQ)
    assert PowerSeries([a**0, a, a * 0]).reciprocal() == PowerSeries([a**0, -a, a**2])
    b = sp.Symbol("b")
    assert PowerSeries([sp.Integer(1), b, sp.Integer(0)]).reciprocal()[2] == b**2
    with precision(120):
        root = power(PowerSeries([arb(2), arb(1), arb(0)]), Fraction(1, 2), arb(2).sqrt())
        assert (root * root - PowerSeries([arb(2), arb(1), arb(0)]))[1].contains(0)


@pytest.mark.parametrize(
    ("attempt", "words"),
    [
        (lambda: PowerSeries([]), "length 0"),
        (lambda: PowerSeries([1, 2])[2], "orders 0 to 1"),
        (lambda: PowerSeries([1, 2])[-1], "order -1"),
        (lambda: PowerSeries([Fraction(0), 1]).reciprocal(), "constant coefficient is 0"),
        (lambda: PowerSeries([Fraction(0), 1]) ** -1, "constant coefficient is 0"),
        (lambda: PowerSeries([Fraction(1)]) / 0, "Division by 0"),
        (lambda: PowerSeries([1]).derivative(), "length 1"),
        (lambda: PowerSeries([1, 2]).at(PowerSeries([1, 1])), "without constant coefficient"),
        (lambda: PowerSeries([1, 2]).reversion(), "without constant coefficient"),
        (lambda: PowerSeries([0, 0, 1]).reversion(), "coefficient of x is 0"),
        (lambda: PowerSeries([0]).reversion(), "order 1 is not known"),
        (lambda: PowerSeries([1, 2]).shifted(-1), "not divisible"),
        (lambda: PowerSeries([0, 0]).shifted(-2), "not divisible"),
        (lambda: solve(lambda y: y - 1, Fraction(1), 3), "does not hold at the origin"),
        (lambda: solve(lambda y: y * y, Fraction(0), 3), "is 0 is singular"),
        (lambda: power(PowerSeries([2, 1]), Fraction(1, 2)), "must be given"),
        (lambda: power(PowerSeries([Fraction(0), 1]), Fraction(1, 2), Fraction(0)), "is 0 is singular"),
        (lambda: power(PowerSeries([1, Fraction(1)]), 0.5), "exponent 0.5 .* Fraction"),
        (lambda: PowerSeries([1, Fraction(1)]) ** 0.5, r"\*\* takes integers, not 0.5"),
        (lambda: PowerSeries([GENERATORS[0], GENERATORS[1]]).reciprocal(), "cannot be inverted"),
        (lambda: PowerSeries([arb(0, 1e-9), arb(1)]).reciprocal(), "may be 0"),
        (lambda: PowerSeries([arb(1), arb(1)]).at(PowerSeries([arb(0, 1e-9), arb(1)])), "without constant"),
    ],
)
def test_bad_input(attempt, words):
    with pytest.raises(DomainError, match=words):
        attempt()


def test_exponents_of_three_kinds():
    f = PowerSeries([1, Fraction(1), 0, 0])
    assert power(f, 2) == power(f, Fraction(2)) == f * f
    assert power(f, sp.Rational(1, 3)) == power(f, Fraction(1, 3))


def test_ratio_belongs_to_the_ring():
    assert ratio(1, 3, GENERATORS[0]) * 3 == 1
    assert ratio(2, 4, sp.Symbol("x")) == sp.Rational(1, 2)
    assert ratio(1, 2, mpmath.mpf(1)) == mpmath.mpf("0.5")
    assert ratio(1, 3, 5) == Fraction(1, 3)
