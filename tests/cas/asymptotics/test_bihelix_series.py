"""The series of the contact conditions against Frenet's equations and against bihelices in numbers."""

from fractions import Fraction

import mpmath as mp
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics.bihelix_series import bihelix_series, frenet_series, leading_constant
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bihelix_rules import SpaceArc, peaks, shifted_bihelix, thesis_bihelix

small = st.fractions(min_value=-2, max_value=2, max_denominator=6)
positive = st.fractions(min_value=Fraction(1, 4), max_value=3, max_denominator=6)
offsets = st.fractions(min_value=Fraction(-4, 5), max_value=Fraction(4, 5), max_denominator=6)


@given(positive, small, small, small)
def test_frenet_series_against_the_equations(k, k1, t, t1):
    curve = frenet_series([k, k1], [t, t1], 6)
    kappa, tau = ([Fraction(a), Fraction(b), 0, 0, 0] for a, b in ((k, k1), (t, t1)))

    def times(row, series):
        return [sum(row[i] * series[n - i] for i in range(n + 1)) for n in range(5)]

    for T, N, B in zip(curve.T, curve.N, curve.B):
        assert list(T.derivative().coefficients) == times(kappa, N)
        assert list(B.derivative().coefficients) == [-c for c in times(tau, N)]
        bent = [b - a for a, b in zip(times(kappa, T), times(tau, B))]
        assert list(N.derivative().coefficients) == bent
    norm = sum((c * c for c in curve.T), curve.T[0] * 0)
    assert list(norm.coefficients) == [1, 0, 0, 0, 0, 0]


@settings(max_examples=15, deadline=None)
@given(positive, small, small, small, small, small, offsets)
def test_both_sides_meet_with_one_tangent(k, k1, k2, t, left, right, v):
    series = bihelix_series([k, k1, k2], [t], ([left], [right]), [v], order=5)
    assert series.junction("left") == series.junction("right")
    for a, b in zip(series.displacement("left", v), series.displacement("right", v)):
        assert a.coefficients[:5] == b.coefficients[:5]
    for side, x in (("left", Fraction(-1)), ("right", Fraction(1))):
        for part in series.displacement(side, x):
            assert not any(part.coefficients)


@settings(max_examples=15, deadline=None)
@given(positive, small, small, offsets)
def test_planar_curve_has_the_normal_error_of_biarcs(k, k1, x, v):
    """For τ = 0 the helices are circles, and nothing leaves the plane."""
    zero = Fraction(0)
    series = bihelix_series([k, k1], [zero], ([zero], [zero]), [v], order=4)
    for side in ("left", "right"):
        assert not any(series.displacement(side, x)[1].coefficients)
        assert not any(series.left.angle.coefficients + series.right.angle.coefficients)


def test_a_helix_is_its_own_bihelix():
    k, t, zero = Fraction(2), Fraction(3, 2), Fraction(0)
    series = bihelix_series([k], [t], ([t], [t]), [zero], order=6)
    for side in ("left", "right"):
        for part in series.displacement(side, Fraction(1, 3)):
            assert not any(part.coefficients)


def test_leading_constant_is_the_peak_of_the_cubic():
    steps = [Fraction(i, 600) for i in range(-600, 1)]
    top = max(abs(x * (1 + x) ** 2 / 6) for x in steps)  # −1/3 is one of them
    assert leading_constant() == top / 8


def test_next_order_against_solved_bihelices():
    """The h⁴ term for the moment curve about t = 1: the series sees what the distances of short arcs do."""
    with mp.workdps(40):
        coordinates = parse_tuple("t, t^2, t^3")
        delta = mp.mpf(1) / 512
        arc = SpaceArc(coordinates, 1 - delta, 1 + delta)
        jet = arc.jet(arc.after(arc.sigma / 2))
        near = arc.jet(arc.after(arc.sigma * mp.mpf("0.5001")))
        second = (near.curvature_slope - jet.curvature_slope) / (arc.sigma * mp.mpf("0.0001"))
        left, right = peaks(arc, shifted_bihelix(arc, mp.mpf(0)))
        h = arc.sigma / 2
        field, k, k1, k2, t, t1, e, x = sp.field("k, k1, k2, t, t1, e, x", sp.QQ)
        series = bihelix_series([k, k1, k2], [t, t1], ([t, e], [t, -e]), [field(0)], order=4)
        values = jet.curvature, jet.curvature_slope, second, jet.torsion
        third = mp.mpf(1) / 3
        names = sp.symbols("k k1 k2 t x")
        for at, peak in ((-third, left), (third, right)):
            f = series.displacement("left" if at < 0 else "right", x)[0]
            f3, f4 = (sp.lambdify(names, f[n].as_expr().subs({"t1": 0, "e": 0}), "mpmath") for n in (3, 4))
            predicted = f3(*values, at) * h**3 + f4(*values, at) * h**4
            assert abs(abs(predicted) - peak) < 60 * h**5
            assert abs(abs(f3(*values, at)) * h**3 - peak) > 2 * abs(abs(predicted) - peak)


#: Salkowski's curve: constant curvature 1 and torsion tan(3t/5), with m = 3/4
SALKOWSKI = (
    "0.8*(-(1-0.6)/(4*2.2)*sin(2.2*t) - 1.6/(4*(-0.2))*sin(-0.2*t) - sin(t)/2),"
    "0.8*((1-0.6)/(4*2.2)*cos(2.2*t) + 1.6/(4*(-0.2))*cos(-0.2*t) + cos(t)/2),"
    "0.8*cos(1.2*t)/3"
)


def test_constant_curvature_both_rules():
    """σ⁴/6144 for the junction nearest to the curve; the thesis's rule is off by σ⁴/2880·τ²/(κ²+τ²) at it."""
    with mp.workdps(40):
        coordinates = parse_tuple(SALKOWSKI)
        arc = SpaceArc(coordinates, mp.mpf(1) - mp.mpf(1) / 1024, mp.mpf(1) + mp.mpf(1) / 1024)
        jet = arc.jet(arc.after(arc.sigma / 2))
        assert mp.almosteq(jet.curvature, 1, mp.mpf("1e-30"))
        torsion = abs(jet.torsion)
        assert mp.almosteq(torsion, mp.tan(mp.mpf(3) / 5 * arc.after(arc.sigma / 2)), mp.mpf("1e-30"))
        step = mp.mpf("1e-12")
        slope = abs(arc.jet(1 + step).torsion - arc.jet(1 - step).torsion) / (2 * step * arc.jet(1).speed)
        unit = slope * arc.sigma**4
        top = max(peaks(arc, shifted_bihelix(arc, mp.mpf(0))))
        assert float(unit / top) == pytest.approx(6144, rel=5e-3)
        junction = thesis_bihelix(arc).junction.point
        middle = jet.point(0)
        gap = [a - b for a, b in zip(junction, middle)]
        across = abs(sum(a * b for a, b in zip(gap, jet.binormal)))
        assert float(unit / across) == pytest.approx(float(2880 * (1 + torsion**2) / torsion**2), rel=5e-3)


@pytest.mark.parametrize(
    "arguments",
    [
        {"kappa": [Fraction(0)]},
        {"offset": [Fraction(1)]},
        {"offset": [Fraction(-1)]},
        {"order": 2},
    ],
)
def test_singular_conditions_are_refused(arguments):
    zero, one = Fraction(0), Fraction(1)
    data = {"kappa": [one], "tau": [zero], "torsions": ([zero], [zero]), "offset": [zero]} | arguments
    with pytest.raises(DomainError):
        bihelix_series(**data)


def test_unknown_side_is_refused():
    zero, one = Fraction(0), Fraction(1)
    series = bihelix_series([one], [zero], ([zero], [zero]), [zero])
    with pytest.raises(DomainError, match="left"):
        series.displacement("middle", zero)
    with pytest.raises(DomainError, match="orders 0 to"):
        series.displacement("left", zero)[0][9]
