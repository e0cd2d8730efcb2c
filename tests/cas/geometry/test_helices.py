"""Helices from their frames, short helices through two points: round trips, degenerate cases, bad input."""

from __future__ import annotations

from fractions import Fraction

import mpmath as mp
import pytest
import sympy as sp
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError
from osculant.cas.geometry.helices import (
    CircularHelix,
    GeneralisedHelix,
    Integrals,
    circular_integrals,
)
from osculant.cas.geometry.short_helices import defect_coefficient, segment_forms, short_helix, turning_defect
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.vectors import cross, dot, scale, subtract

numbers = st.integers(-9, 9)
triples = st.tuples(numbers, numbers, numbers)


def unit(a):
    return scale(1 / mp.sqrt(dot(a, a)), a)


def frame(first, second):
    """T, N from two vectors that are not parallel."""
    first, second = (tuple(mp.mpf(x) for x in v) for v in (first, second))
    binormal = cross(first, second)
    assume(dot(binormal, binormal) > 0)
    T, B = unit(first), unit(binormal)
    return T, cross(B, T)


def gap(a, b):
    return max(abs(x) for x in subtract(a, b))


def numeric_integrals(angle):
    """The four functions for a φ with φ(0) = 0, by mpmath's quadrature."""
    return lambda s: Integrals(
        mp.cos(angle(s)),
        mp.sin(angle(s)),
        mp.quad(lambda u: mp.cos(angle(u)), [0, s]),
        mp.quad(lambda u: mp.sin(angle(u)), [0, s]),
    )


def symbolic_integrals(angle, variable):
    """The four functions for a φ that is a sympy expression, 0 at 0."""

    def at(s):
        u = sp.Dummy("u", positive=True)
        cosine, sine = sp.cos(angle.subs(variable, u)), sp.sin(angle.subs(variable, u))
        return Integrals(
            cosine.subs(u, s), sine.subs(u, s), sp.integrate(cosine, (u, 0, s)), sp.integrate(sine, (u, 0, s))
        )

    return at


# Helices from a frame.


@settings(max_examples=20)
@given(triples, triples, triples, st.integers(1, 20), st.integers(-20, 20))
def test_a_helix_has_its_curvature_and_torsion(point, first, second, k, t):
    with mp.workdps(50):
        T, N = frame(first, second)
        helix = CircularHelix(tuple(map(mp.mpf, point)), T, N, mp.mpf(k) / 7, mp.mpf(t) / 7)
        assert gap(helix.at(mp.mpf(0)), point) < mp.mpf(10) ** -45
        for s in (mp.mpf(0), mp.mpf(2)):
            jet = SpaceJet(*(list(mp.diffs(lambda u, i=i: helix.at(u)[i], s, 3)) for i in range(3)))
            assert mp.almosteq(jet.speed, 1, 1e-20)
            assert mp.almosteq(jet.curvature, helix.curvature, 1e-18)
            assert abs(jet.torsion - helix.torsion) < mp.mpf(10) ** -15
            assert gap(jet.tangent, helix.tangent_at(s)) < mp.mpf(10) ** -20
            assert gap(jet.axis, helix.axis) < mp.mpf(10) ** -12
        arm = subtract(helix.at(mp.mpf(3)), helix.centre)
        across = subtract(arm, scale(dot(arm, helix.axis), helix.axis))
        assert mp.almosteq(mp.sqrt(dot(across, across)), helix.radius, 1e-40)


def test_a_line_is_a_helix_without_curvature():
    line = CircularHelix((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.0, 3.0)
    assert line.at(2.0) == (2.0, 0.0, 0.0)
    assert line.tangent_at(2.0) == (1.0, 0.0, 0.0)
    for name in ("radius", "axis", "centre"):
        with pytest.raises(DomainError, match="straight line"):
            getattr(line, name)


def test_symbolic_helix():
    """An exact helix: 3-4-5 triangle."""
    s = sp.Symbol("s", positive=True)
    zero, one = sp.S.Zero, sp.S.One
    T, N = (zero, sp.Rational(3, 5), sp.Rational(4, 5)), (-one, zero, zero)
    helix = CircularHelix((sp.Integer(3), zero, zero), T, N, sp.Rational(3, 25), sp.Rational(4, 25))
    expected = (3 * sp.cos(s / 5), 3 * sp.sin(s / 5), 4 * s / 5)
    assert all(sp.simplify(a - b) == 0 for a, b in zip(helix.at(s), expected))


def test_balls_enclose_a_helix():
    with precision(200):
        zero, one = arb(0), arb(1)
        helix = CircularHelix((zero,) * 3, (one, zero, zero), (zero, one, zero), one, zero)
        x, y, _ = helix.at(arb(1))
        assert x.overlaps(arb(1).sin()) and y.overlaps(1 - arb(1).cos()) and x.rad() < 1e-50


@settings(max_examples=3)
@given(triples, triples, st.integers(-10, 10))
def test_a_generalised_helix_has_a_constant_ratio(first, second, ratio):
    """φ = s + s³/10, so κ = φ'/√(1 + r²) and τ = rκ."""
    with mp.workdps(30):
        T, N = frame(first, second)
        r = mp.mpf(ratio) / 4
        integrals = numeric_integrals(lambda u: u + u**3 / 10)
        helix = GeneralisedHelix((mp.mpf(0),) * 3, T, N, r, integrals)
        s = mp.mpf(1) / 2
        first_derivative = helix.tangent_at(s)
        derivatives = [
            [a, b, *list(mp.diffs(lambda u, i=i: helix.tangent_at(u)[i], s, 2))[1:]]
            for i, (a, b) in enumerate(zip(helix.at(s), first_derivative))
        ]
        jet = SpaceJet(*derivatives)
        assert mp.almosteq(jet.curvature, (1 + 3 * s**2 / 10) / mp.sqrt(1 + r * r), 1e-15)
        assert abs(jet.torsion - r * jet.curvature) < mp.mpf(10) ** -12
        assert gap([mp.diff(lambda u, i=i: helix.at(u)[i], s) for i in range(3)], first_derivative) < 1e-9
        assert abs(dot(first_derivative, helix.axis) - helix.slope) < mp.mpf(10) ** -25


def test_integrals_of_three_kinds_agree():
    s = sp.Symbol("s", positive=True)
    with mp.workdps(30):
        exact = symbolic_integrals(3 * s, s)(sp.Rational(2, 5))
        direct = circular_integrals(mp.mpf(3))(mp.mpf(2) / 5)
        numeric = numeric_integrals(lambda u: 3 * u)(mp.mpf(2) / 5)
        for name in ("cosine", "sine", "C", "S"):
            reference = mp.mpf(str(sp.N(getattr(exact, name), 30)))
            assert mp.almosteq(getattr(direct, name), reference, 1e-27)
            assert mp.almosteq(getattr(numeric, name), reference, 1e-25)


# Short helices.


@settings(max_examples=40)
@given(
    triples,
    triples,
    triples,
    st.integers(0, 30),
    st.integers(-30, 30),
    st.integers(1, 99),
    st.integers(-9, 9),
)
def test_round_trip(point, first, second, k, t, share, exponent):
    """A random helix arc of turning below 2π is found again from its end points and tangents."""
    with mp.workdps(50):
        assume(k or t)
        T, N = frame(first, second)
        size = mp.mpf(10) ** exponent
        p0 = tuple(x * size for x in point)  # farther away the points' rounding would be the error
        helix = CircularHelix(p0, T, N, mp.mpf(k) / size, mp.mpf(t) / size)
        turning = 2 * mp.pi * share / 100
        length = turning / helix.rate
        arc = short_helix(p0, T, helix.at(length), helix.tangent_at(length))
        if k == 0:
            assert arc.helix.curvature == 0
            return
        assert gap(arc.helix.at(arc.length), helix.at(length)) < mp.mpf(10) ** -40 * length
        assert gap(arc.helix.tangent_at(arc.length), helix.tangent_at(length)) < mp.mpf(10) ** -40
        assert mp.almosteq(arc.turning, turning, 1e-25)
        assert mp.almosteq(arc.helix.curvature, helix.curvature, 1e-25)
        assert abs(arc.helix.torsion - helix.torsion) < mp.mpf(10) ** -25 * helix.rate


@settings(max_examples=40)
@given(triples, triples, st.integers(-20, 20), st.integers(-20, 20))
def test_every_admissible_end_point_is_reached(first, second, ahead, aside):
    """p₁ anywhere in the plane of E and F."""
    with mp.workdps(40):
        T0, T1 = (tuple(mp.mpf(x) for x in v) for v in (first, second))
        F = cross(T1, T0)
        assume(dot(F, F) > 0 and (ahead or aside))
        T0, T1 = unit(T0), unit(T1)
        E = tuple(a + b for a, b in zip(T0, T1))
        p1 = tuple(mp.mpf(ahead) * e + mp.mpf(aside) * f for e, f in zip(E, cross(T1, T0)))
        arc = short_helix((0, 0, 0), T0, p1, T1)
        assert gap(arc.helix.at(arc.length), p1) < mp.mpf(10) ** -35 * (1 + mp.sqrt(dot(p1, p1)))
        assert gap(arc.helix.tangent_at(arc.length), T1) < mp.mpf(10) ** -35
        assert 0 < arc.turning < 2 * mp.pi
        if aside:
            assert mp.sign(arc.helix.torsion) == mp.sign(aside)  # usual sign
        else:
            assert arc.helix.torsion == 0


@pytest.mark.parametrize("angle", ["1e-3", "1e-9", "1e-20"])
def test_nearly_straight(angle):
    with mp.workdps(50):
        rate = mp.mpf(angle)
        T, N = (mp.mpf(3) / 5, mp.mpf(4) / 5, mp.mpf(0)), (mp.mpf(0), mp.mpf(0), mp.mpf(1))
        helix = CircularHelix((mp.mpf(0),) * 3, T, N, rate, rate / 3)
        end, tangent = helix.at(mp.mpf(1)), helix.tangent_at(mp.mpf(1))
        arc = short_helix(helix.point, helix.tangent, end, tangent)
        assert gap(arc.helix.at(arc.length), end) < mp.mpf(10) ** -45
        assert gap(arc.helix.tangent_at(arc.length), tangent) < mp.mpf(10) ** -45


def test_nearly_opposite_tangents():
    with mp.workdps(80):
        x = mp.mpf("1e-20")
        T0, T1 = (mp.mpf(0), mp.mpf(1), mp.mpf(0)), (mp.sin(x), -mp.cos(x), mp.mpf(0))
        E = tuple(a + b for a, b in zip(T0, T1))
        p1 = tuple(e / mp.sin(x) for e in E)
    with mp.workdps(50):
        arc = short_helix((0, 0, 0), T0, p1, T1)
        assert gap(arc.helix.at(arc.length), p1) < mp.mpf(10) ** -25


def test_segment_half_circle_and_plane_arcs():
    segment = short_helix((1, 0, 0), (0, 0, 2), (1, 0, 5), (0, 0, 1))
    assert segment.length == 5 and segment.turning == 0 and segment.helix.curvature == 0
    assert segment.helix.at(mp.mpf(5)) == (1, 0, 5)
    assert dot(segment.helix.normal, segment.helix.tangent) == 0
    half = short_helix((0, 0, 0), (0, 1, 0), (2, 0, 0), (0, -1, 0))
    assert mp.almosteq(half.length, mp.pi) and half.helix.curvature == 1 and half.helix.torsion == 0
    quarter = short_helix((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0))
    assert mp.almosteq(quarter.turning, mp.pi / 2) and quarter.helix.torsion == 0
    rest = short_helix((0, 0, 0), (0, 1, 0), (-1, -1, 0), (1, 0, 0))
    assert mp.almosteq(rest.turning, 3 * mp.pi / 2)
    assert gap(rest.helix.at(rest.length), (-1, -1, 0)) < 1e-12


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (((0, 0, 0), (1, 0, 0), (0, 0, 0), (0, 1, 0)), "coincide"),
        (((0, 0, 0), (0, 0, 0), (1, 0, 0), (0, 1, 0)), "start is the zero vector"),
        (((0, 0, 0), (1, 0, 0), (1, 0, 0), (0, 0, 0)), "end is the zero vector"),
        (
            ((0, 0, 0), (1, 0, 0), (1, 0, 0), (0, 1, 0)),
            r"⟨p₁−p₀, T₁−T₀⟩ = 0 .* residual is -1\.0",
        ),
        (((0, 0, 0), (1, 0, 0), (-1, 0, 0), (1, 0, 0)), "straight segment"),
        (((0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 0, 0)), "straight segment"),
        (((0, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 0, 0)), "residual is -2"),
    ],
)
def test_what_cannot_be_joined(data, message):
    with pytest.raises(DomainError, match=message):
        short_helix(*data)


@pytest.mark.parametrize("bad", [mp.nan, mp.inf, float("nan"), sp.Symbol("a"), "b", None, 1j])
@pytest.mark.parametrize("place", range(4))
def test_what_is_no_number(bad, place):
    data = [(0, 0, 0), (0, 1, 0), (2, 0, 0), (0, -1, 0)]
    data[place] = (bad, *data[place][1:])
    with pytest.raises(DomainError, match=r"finite numbers|three real numbers"):
        short_helix(*data)


def test_what_is_no_vector_or_tolerance():
    data = [(0, 1, 0), (2, 0, 0), (0, -1, 0)]
    for point in ((0, 0), (0, 0, 0, 0), 5):
        with pytest.raises(DomainError, match="three real numbers"):
            short_helix(point, *data)
    for tolerance in (-1, mp.nan):
        with pytest.raises(DomainError, match="tolerance"):
            short_helix((0, 0, 0), *data, tolerance=tolerance)


def test_tolerance_lets_rounded_data_in():
    p1 = (1.0, 1.0 + 1e-9, 0.3)
    with pytest.raises(DomainError, match="residual"), mp.workdps(30):
        short_helix((0, 0, 0), (0, 1, 0), p1, (1, 0, 0))
    with mp.workdps(30):
        arc = short_helix((0, 0, 0), (0, 1, 0), p1, (1, 0, 0), tolerance=1e-8)
        assert gap(arc.helix.at(arc.length), p1) < 1e-8


def test_exact_input_stays_exact():
    third = Fraction(1, 3)
    with mp.workdps(40):
        arc = short_helix((third, 0, 0), (0, 1, 0), (third + 1, 1, 0), (1, 0, 0))
        assert abs(arc.helix.point[0] - mp.mpf(1) / 3) < mp.mpf(10) ** -39


def test_the_defect_by_series_and_in_closed_form():
    with mp.workdps(60):
        for text in ("1e-20", "1e-3", "0.7", "1", "1.2", "6"):
            phi = mp.mpf(text)
            with mp.workdps(150):
                reference = 2 * mp.sin(phi / 2) - phi * mp.cos(phi / 2)
            assert mp.almosteq(turning_defect(phi), reference, mp.mpf(10) ** -56)
    assert turning_defect(mp.mpf(0)) == 0
    assert defect_coefficient(1) == Fraction(1, 12)


@settings(max_examples=50)
@given(st.floats(0.01, 0.99), st.floats(0.001, 3.13))
def test_the_angle_grows_with_the_parameter(h, chi):
    h = mp.mpf(h)
    c = mp.sqrt(1 - h * h)
    here, further = (
        segment_forms(h, c, mp.sin(chi + step), mp.cos(chi + step)) for step in (0, mp.mpf("1e-3"))
    )
    assert here.X * further.Y - here.Y * further.X > 0
    assert mp.almosteq(here.kappa_bar**2 + here.tau_bar**2, 1)
