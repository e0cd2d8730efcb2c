"""Invariants of space curves against numerical differentiation at 50 digits; transformation laws."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath as mp
import pytest
import sympy as sp
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.jets.derivations.space import GENERIC as JET
from osculant.cas.jets.derivations.space import (
    T,
    by_arc_length,
    combine,
    derivative,
    kappa,
    moved,
    speed,
    turned,
)
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.signs import sign_between
from osculant.cas.numbers.vectors import add, cross, det, dot, scale, subtract

coefficients = st.lists(st.integers(-6, 6), min_size=15, max_size=15)


def curve(numbers):
    """A cubic with a circular part in each coordinate, as functions of mpmath numbers."""
    rows = [[mp.mpf(n) / 5 for n in numbers[i : i + 5]] for i in (0, 5, 10)]
    return [
        lambda t, r=row: r[0] * t + r[1] * t**2 + r[2] * t**3 + r[3] * mp.sin(t) + r[4] * mp.cos(2 * t)
        for row in rows
    ]


def jet_at(coordinates, t, order=4):
    return SpaceJet(*(list(mp.diffs(f, t, order)) for f in coordinates))


def regular(coordinates, t):
    jet = jet_at(coordinates, t)
    assume(jet.speed_squared > 0.05 and jet.inflection_form > 0.05)
    return jet


def by_definition(coordinates, t):
    """κ, τ from the derivatives of the unit tangent and of the binormal, by arc length, numerically."""

    def tangent(u):
        v = [mp.diff(f, u) for f in coordinates]
        return scale(1 / mp.sqrt(dot(v, v)), v)

    def binormal(u):
        v, a = ([mp.diff(f, u, n) for f in coordinates] for n in (1, 2))
        c = cross(v, a)
        return scale(1 / mp.sqrt(dot(c, c)), c)

    rate = mp.sqrt(sum(mp.diff(f, t) ** 2 for f in coordinates))
    turn = [mp.diff(lambda u, i=i: tangent(u)[i], t) / rate for i in range(3)]
    twist = [mp.diff(lambda u, i=i: binormal(u)[i], t) / rate for i in range(3)]
    bend = mp.sqrt(dot(turn, turn))
    return bend, -dot(twist, scale(1 / bend, turn))


@settings(max_examples=15)
@given(coefficients, st.integers(-10, 10))
def test_curvature_and_torsion_by_definition(numbers, at):
    with mp.workdps(50):
        t, coordinates = mp.mpf(at) / 7, curve(numbers)
        jet = regular(coordinates, t)
        bend, twist = by_definition(coordinates, t)
        assert mp.almosteq(jet.curvature, bend, 1e-20, 1e-20)
        assert mp.almosteq(jet.torsion, twist, 1e-18, 1e-18)


@settings(max_examples=15)
@given(coefficients, st.integers(-10, 10))
def test_slopes_are_derivatives_by_arc_length(numbers, at):
    with mp.workdps(50):
        t, coordinates = mp.mpf(at) / 7, curve(numbers)
        jet = regular(coordinates, t)
        for name, slope in (("curvature", jet.curvature_slope), ("torsion", jet.torsion_slope)):
            rate = mp.diff(lambda u, name=name: getattr(jet_at(coordinates, u), name), t) / jet.speed
            assert mp.almosteq(slope, rate, 1e-14, 1e-14)
        ratio = mp.diff(lambda u: (j := jet_at(coordinates, u)).torsion / j.curvature, t) / jet.speed
        assert mp.almosteq(jet.ratio_slope, ratio, 1e-14, 1e-14)


@settings(max_examples=30)
@given(coefficients, st.integers(-10, 10))
def test_frames(numbers, at):
    with mp.workdps(50):
        jet = regular(curve(numbers), mp.mpf(at) / 7)
        for frame in (jet.frenet_frame, jet.darboux_frame):
            assert mp.almosteq(det(*frame), 1, 1e-40)
            for i in range(3):
                for j in range(i + 1):
                    assert abs(dot(frame[i], frame[j]) - (i == j)) < mp.mpf(10) ** -40
        _, companion, axis = jet.darboux_frame
        assert abs(dot(jet.normal, cross(companion, axis)) - 1) < mp.mpf(10) ** -40
        gap = add(scale(jet.frame_rate, axis), jet.darboux_vector)
        assert max(map(abs, gap)) < mp.mpf(10) ** -35 * (1 + jet.frame_rate)


@settings(max_examples=30)
@given(coefficients, st.integers(-10, 10))
def test_mirror_and_reversal(numbers, at):
    """A mirror changes the sign of τ and not κ; reversing the parameter changes neither."""
    with mp.workdps(30):
        jet = regular(curve(numbers), mp.mpf(at) / 7)
        mirrored = SpaceJet([-a for a in jet.x], jet.y, jet.z)
        reversed_jet = SpaceJet(*([(-1) ** n * a for n, a in enumerate(c)] for c in (jet.x, jet.y, jet.z)))
        assert mirrored.curvature == jet.curvature
        assert mirrored.torsion == -jet.torsion
        assert mp.almosteq(reversed_jet.torsion, jet.torsion)
        assert mp.almosteq(reversed_jet.curvature_slope, -jet.curvature_slope, 1e-20, 1e-20)


def test_a_right_handed_helix_has_positive_torsion():
    jet = SpaceJet((1.0, 0.0, -1.0, 0.0, 1.0), (0.0, 1.0, 0.0, -1.0, 0.0), (0.0, 2.0, 0.0, 0.0, 0.0))
    assert math.isclose(jet.torsion, 0.4)
    assert jet.ratio_slope == jet.curvature_slope == jet.torsion_slope == jet.axis_rate == 0
    assert dot(jet.axis, (0, 0, 1)) == pytest.approx(-1)  # the thesis's V: minus the usual direction
    assert dot(jet.darboux_vector, (0, 0, 1)) > 0


def test_balls_enclose_and_sympy_stays_exact():
    t = sp.Symbol("t", positive=True)
    moment = SpaceJet((t, 1, 0, 0, 0), (t**2, 2 * t, 2, 0, 0), (t**3, 3 * t**2, 6 * t, 6, 0))
    exact = moment.torsion.subs(t, sp.Rational(1, 3))
    with precision(200):
        a = arb(1) / 3
        ball = SpaceJet((a, 1, 0, 0), (a * a, 2 * a, arb(2), 0), (a * a * a, 3 * a * a, 6 * a, arb(6)))
        assert ball.torsion.contains(arb(int(exact.p)) / int(exact.q))
        assert ball.curvature.rad() < 1e-50


def test_derivations_are_derivations():
    """d/dt of forms in the jet, against sympy's derivative along a concrete curve."""
    t = sp.Symbol("t")
    concrete = (t + t**3, t**2 - t**4, t**3 + 2 * t)
    values = {}
    for column, function in zip((JET.x, JET.y, JET.z), concrete):
        values |= {symbol: sp.diff(function, t, n) for n, symbol in enumerate(column)}
    form = JET.torsion_form / JET.inflection_form
    along = derivative(form).subs(values) - sp.diff(form.subs(values), t)
    assert all(along.subs(t, sp.Rational(n, 7)) == 0 for n in (1, 3, -5))
    assert moved(T) == (0, kappa, 0)
    assert by_arc_length(1) == 0
    assert sp.simplify(turned(derivative(JET.curvature) / speed - JET.curvature_slope)) == 0


def test_combinations_must_be_linear():
    a, b = sp.symbols("A B")
    assert combine(2 * a - b, {a: (1, 0, 0), b: (0, 1, 0)}) == (2, -1, 0)
    for bad in (a * b, a + 1, a**2):
        with pytest.raises(DomainError, match="linear combination"):
            combine(bad, {a: (1, 0, 0), b: (0, 1, 0)})


def test_signs_between():
    x = sp.Symbol("x", real=True)
    assert sign_between(x**2 * (1 - sp.cos(x)), x, sp.S.Zero, 2 * sp.pi) == 1
    assert sign_between(sp.sin(x) - x, x, sp.S.Zero, sp.Integer(50)) == -1
    assert sign_between(x - sp.Rational(1, 10**6), x, sp.S.Zero, sp.S.One) == 0
    assert sign_between((x - 1) * (x - 1 - sp.Rational(1, 1000)), x, sp.S.Zero, sp.Integer(3)) == 0
    with pytest.raises(DomainError, match="empty"):
        sign_between(x, x, sp.S.One, sp.S.Zero)
    with pytest.raises(UndecidedError, match="halvings"):
        sign_between((x - 1) ** 2, x, sp.S.Zero, sp.Integer(3))
    with pytest.raises(UndecidedError, match="derivatives"):
        sign_between(x * 0, x, sp.S.Zero, sp.S.One)


def test_vectors():
    assert subtract((1, 2, 3), (1, 1, 1)) == (0, 1, 2)
    assert cross((1, 2, 3), (4, 5, 6)) == (-3, 6, -3)


@pytest.mark.parametrize(
    "attempt",
    [
        lambda: cross([1, 2], [3, 4]),
        lambda: dot((1, 2, 3), (1, 2)),
        lambda: subtract((1, 2, 3), (1, 2, 3, 4)),
        lambda: scale(2, ()),
        lambda: add((1, 2, 3), (1,)),
    ],
)
def test_vectors_have_three_coordinates(attempt):
    with pytest.raises(DomainError, match="three coordinates"):
        attempt()


def test_a_sum_of_nothing():
    with pytest.raises(DomainError, match="at least one vector"):
        add()


@pytest.mark.parametrize(
    ("name", "order"),
    [
        ("tangent", 1),
        ("curvature", 2),
        ("normal", 2),
        ("torsion", 3),
        ("curvature_slope", 3),
        ("darboux_frame", 3),
        ("torsion_slope", 4),
        ("ratio_slope", 4),
        ("axis_rate", 4),
    ],
)
def test_a_jet_too_short_says_what_is_needed(name, order):
    rows = [(1.0, 2.0, 0.5, 3.0, 1.0), (0.0, 1.0, 2.0, 1.0, 5.0), (3.0, 0.0, 1.0, 1.5, 2.0)]
    assert getattr(SpaceJet(*(row[: order + 1] for row in rows)), name) is not None
    with pytest.raises(DomainError, match=f"order {order - 1}, and the derivative of order {order} is"):
        getattr(SpaceJet(*(row[:order] for row in rows)), name)


def test_coordinates_of_unequal_orders():
    with pytest.raises(DomainError, match="not 3, 1, 2"):
        SpaceJet((0, 1, 0, 0), (0, 1), (0, 0, 1))


INVARIANTS = ("torsion", "curvature_slope", "torsion_slope", "ratio_slope", "normal", "axis", "axis_rate")


@pytest.mark.parametrize("number", [float, Fraction, mp.mpf])
@pytest.mark.parametrize("name", INVARIANTS)
def test_no_curvature_and_no_speed(number, name):
    def root(value, _):
        return number(math.isqrt(int(value)))

    zero = [number(0)] * 5
    straight = SpaceJet([number(n) for n in (0, 1, 0, 0, 0)], zero, zero, root)
    assert straight.curvature == 0
    with pytest.raises(DomainError, match="the curvature is 0"):
        getattr(straight, name)
    cusp = SpaceJet(*([number(n) for n in row] for row in ((0, 0, 1, 0, 0), (0, 0, 0, 1, 0))), zero, root)
    with pytest.raises(DomainError, match="the speed is 0"):
        getattr(cusp, name)
    with pytest.raises(DomainError, match="the speed is 0"):
        _ = cusp.curvature
