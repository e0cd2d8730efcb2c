"""Flat functions: peaks against a search, the constants for all n, and where the best zero lies."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics.flat_functions import (
    F,
    F_u,
    Model,
    balance_shift,
    critical_point_shift,
    flat_constant,
    n,
    slope_by_crossing,
    x,
    y,
)
from osculant.cas.errors import DomainError
from osculant.cas.geometry.pencil import lobes

half = sp.Rational(1, 2)


def highest(function, low, high):
    """The maximum of a function with one peak on an interval, by golden section."""
    low, high = mpmath.mpf(low), mpmath.mpf(high)
    ratio = (mpmath.sqrt(5) - 1) / 2
    while high - low > mpmath.mpf(10) ** -20:
        left, right = high - ratio * (high - low), low + ratio * (high - low)
        if function(left) < function(right):
            low = left
        else:
            high = right
    return (low + high) / 2, function((low + high) / 2)


@settings(deadline=None, max_examples=10)
@given(st.integers(1, 12))
def test_the_constants_are_the_peaks_found_by_search(flatness):
    with mpmath.workdps(45):
        assert flat_constant(flatness, 0) == sp.Rational(1, 4**flatness)
        peak = highest(lambda t: (t * (1 - t)) ** flatness * (t - mpmath.mpf(1) / 2), "0.5", 1)[1]
        assert mpmath.almosteq(mpmath.mpf(str(sp.N(flat_constant(flatness, 1), 45))), peak, 1e-30)


@given(st.integers(1, 9))
def test_the_symbolic_constants_take_the_values_of_the_numbers(flatness):
    for crossings in (0, 1):
        symbolic = flat_constant(n, crossings).subs(n, flatness)
        assert sp.simplify(symbolic - flat_constant(flatness, crossings)) == 0


def test_the_constants_of_the_conic_spline():
    """1/(2000√5) = c₂/40 and 1/128 = 2⁻⁴/8, from the coefficients 1/40 and 1/8 of the canonical form."""
    assert sp.simplify(40 / flat_constant(2, 1)) == 2000 * sp.sqrt(5)
    assert 8 / flat_constant(2, 0) == 128


@settings(deadline=None, max_examples=20)
@given(st.integers(1, 5), st.fractions("1/20", "19/20", max_denominator=20))
def test_critical_points_interlace_and_balance_only_in_the_middle(flatness, crossing):
    crossing = sp.Rational(crossing.numerator, crossing.denominator)
    model = Model(flatness, crossing)
    first, last = model.critical_points
    assert 0 < first < crossing < last < 1
    assert sp.expand(sp.diff(model.shape, x).subs(x, first)) == 0
    total = sp.N(sum(model.critical_values), 40)
    assert (abs(total) < 1e-35) == (crossing == half)
    assert (total > 0) == (crossing < half) or crossing == half


@settings(deadline=None, max_examples=6)
@given(st.integers(1, 3), st.integers(-4, 4).filter(bool), st.integers(-4, 4), st.integers(-4, 4))
def test_shifts_agree_with_the_peaks_of_a_short_function(flatness, a, b, c):
    """f = uⁿ(r − u)ⁿ(5 + au + bs + cr) and the one with the factor u − s, on an interval of length 1e-6."""
    with mpmath.workdps(60):
        r = mpmath.mpf(10) ** -6

        def size(t, s=0):
            return 5 + a * r * t + b * r * s + c * r

        def slope(t):
            return mpmath.diff(lambda v: (v * (1 - v)) ** flatness * size(v), t)

        place = mpmath.findroot(slope, mpmath.mpf("0.5"))
        (shift,) = critical_point_shift()
        expected = mpmath.mpf(str(sp.N(shift.subs({n: flatness, F: 5, F_u: a}), 30)))
        assert abs((place - 0.5) / r - expected) < 1e-4

        def imbalance(s):
            def f(t):
                return (t * (1 - t)) ** flatness * (t - s) * size(t, s)

            reach = 1 / (2 * mpmath.sqrt(2 * flatness + 1))
            peaks = (mpmath.findroot(lambda t: mpmath.diff(f, t), 0.5 + sign * reach) for sign in (-1, 1))
            return sum(f(t) for t in peaks)

        best = mpmath.findroot(imbalance, (mpmath.mpf("0.49999"), mpmath.mpf("0.50001")))
        expected = mpmath.mpf(str(sp.N(balance_shift().subs({n: flatness, F: 5, F_u: a}), 30)))
        assert abs((best - 0.5) / r - expected) < 1e-4


def test_the_kernels_lobes_are_the_case_two():
    assert sorted((lobes(1)["first"], lobes(1)["last"])) == sorted(Model(2, half).critical_points)
    assert lobes(0)["first"] == Model(2).critical_points[0]


def test_the_slope_by_the_crossing_is_negative():
    assert slope_by_crossing().subs({n: 3, x: half, y: half}) == -sp.Rational(1, 64)


@pytest.mark.parametrize("flatness", [0, -1, half, sp.Symbol("m")])
def test_flatness_is_a_positive_integer(flatness):
    with pytest.raises(DomainError, match="flatness"):
        Model(flatness)


def test_unequal_lobes_and_too_many_crossings():
    with pytest.raises(DomainError, match="lobes differ"):
        _ = Model(1, sp.Rational(1, 3)).peak
    with pytest.raises(DomainError, match="0 or 1 crossings"):
        flat_constant(1, 2)
