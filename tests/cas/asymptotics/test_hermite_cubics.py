"""G² cubics and polynomial curves on conics against true ones found with many digits."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics.conic_hermite import (
    A,
    circle_interpolant,
    conic_constant,
    contact_factor,
    speed,
    t,
)
from osculant.cas.asymptotics.g2_cubics import bezier, complexity, displacement, error_coefficient, g2_cubics
from osculant.cas.asymptotics.hermite_cubics import (
    a,
    affine_jet,
    branches,
    contact_cubic,
    k,
    k1,
    k2,
    middle_is_best,
)
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.balls import CurveBalls

DIGITS = 80


def spiral(s):
    """Archimedes' spiral with its derivatives."""
    c, q = mp.cos(s), mp.sin(s)
    return (s * c, s * q), (c - s * q, q + s * c), (-2 * q - s * c, 2 * c - s * q)


def exponential(s):
    e = mp.exp(s)
    return (s, e), (mp.mpf(1), e), (mp.mpf(0), e)


def ellipse(s):
    c, q = mp.cos(s), mp.sin(s)
    return (3 * c, q), (-3 * q, c), (-3 * c, -q)


def invariants(curve, s):
    """(k, k′, k″) and κ from mpmath's derivatives of the coordinates, by the definitions."""

    def bracket(i, j, u):
        rows = [[mp.diff(lambda w, n=n: curve(w)[0][n], u, m) for n in (0, 1)] for m in (i, j)]
        return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]

    def phi(u):
        return mp.cbrt(bracket(1, 2, u))

    def affine(u):  # (2.12) without its expansion: [α″α‴]/φ⁵ + (φ̈φ − 3φ̇²)/φ⁴
        f, f1, f2 = phi(u), mp.diff(phi, u), mp.diff(phi, u, 2)
        return bracket(2, 3, u) / f**5 + (f2 * f - 3 * f1 * f1) / f**4

    def slope(u):
        return mp.diff(affine, u) / phi(u)

    _, q, r = curve(s)
    kappa = (q[0] * r[1] - q[1] * r[0]) / mp.hypot(*q) ** 3
    return affine(s), slope(s), mp.diff(slope, s) / phi(s), kappa


@pytest.mark.parametrize(("curve", "at"), [(spiral, 2), (exponential, 0), (ellipse, 1), (spiral, 5)])
def test_error_of_true_cubics(curve, at):
    with mp.workdps(40):
        *jet, kappa = invariants(curve, mp.mpf(at))
    with mp.workdps(DIGITS):
        half = mp.mpf("1e-5")
        middle = mp.mpf(at)
        length = mp.quad(lambda s: mp.hypot(*curve(s)[1]), [middle - half, middle + half])
        cubics = g2_cubics(curve, middle - half, middle + half)
        expected = sorted(b.residual * mp.cbrt(kappa) ** 7 * length**6 / 64 for b in branches(*jet))
        found = sorted(displacement(curve, c, middle, mp.mpf(1) / 2) for c in cubics)
        assert len(found) == len(expected)
        for value, stated in zip(found, expected):
            assert abs(value / stated - 1) < 1e-3
        best = error_coefficient(*jet) * mp.cbrt(kappa) ** 7 * length**6
        assert abs(min(map(abs, found)) / best - 1) < 1e-3


def test_cubics_meet_their_data():
    with mp.workdps(40):
        for cubic in g2_cubics(spiral, mp.mpf(2), mp.mpf("2.2")):
            for end, s in ((0, 2), (1, mp.mpf("2.2"))):
                p, q, r = spiral(mp.mpf(s))
                first = [mp.diff(lambda u, n=n, cubic=cubic: bezier(cubic, u)[n], end) for n in (0, 1)]
                second = [mp.diff(lambda u, n=n, cubic=cubic: bezier(cubic, u)[n], end, 2) for n in (0, 1)]
                kappa = (q[0] * r[1] - q[1] * r[0]) / mp.hypot(*q) ** 3
                curvature = (first[0] * second[1] - first[1] * second[0]) / mp.hypot(*first) ** 3
                assert abs(curvature / kappa - 1) < 1e-15
                assert abs(first[0] * q[1] - first[1] * q[0]) < 1e-15 and bezier(cubic, end) == pytest.approx(
                    p
                )


jets = st.tuples(st.floats(-3, 3), st.floats(-10, 10), st.floats(-10, 10))


@settings(max_examples=60, deadline=None)
@given(jets)
def test_branches_satisfy_the_six_contacts(jet):
    """Independent of the reduction: x and y as polynomials, the defect of y − Y(x) by plain expansion."""
    curvature, slope, bend = (mp.mpf(c) for c in jet)
    if abs(25 * curvature**3 - slope**2) < 1e-3:
        return
    with mp.workdps(40):
        found = branches(curvature, slope, bend)
        assert len(found) == (3 if slope**2 < 25 * curvature**3 else 1)
        for branch in found:
            b, d = -(branch.a**2) / 2 - curvature / 8, branch.a

            def defect(u, q=branch.a, b=b, d=d):
                X = u + q * u**2 + b * u**3
                sextic = curvature**2 / 16 + bend / 240
                Y = X**2 / 2 + curvature * X**4 / 8 + slope * X**5 / 40 + sextic * X**6
                return Y - u**2 / 2 - d * u**3

            u = mp.mpf("1e-6")
            assert abs(defect(u) / u**6 - branch.residual) < 1e-3 * (1 + abs(branch.residual))


@settings(max_examples=60, deadline=None)
@given(st.floats(0.1, 4), st.floats(-0.99, 0.99), st.floats(-60, 60))
def test_criterion_decides_the_best_branch(curvature, cosine, bend):
    slope = 5 * curvature**1.5 * cosine
    found = branches(curvature, slope, bend)
    assert len(found) == 3
    largest = max(found, key=lambda branch: abs(branch.a))
    smallest = min(found, key=lambda branch: abs(branch.a))
    criterion = middle_is_best().subs({k: curvature, k1: slope, k2: bend, a: float(largest.a)})
    if abs(criterion) > 1e-6:
        assert (found[0].a == smallest.a) == (criterion > 0)


def test_affine_jet_against_definitions():
    with mp.workdps(40):
        s = mp.mpf("1.7")
        x, y = (mp.taylor(lambda u, n=n: spiral(u)[0][n], s, 6) for n in (0, 1))
        expected = invariants(spiral, s)[:3]
        for value, stated in zip(affine_jet(x, y), expected):
            assert abs(value / stated - 1) < 1e-10


def test_complexity_of_conics_and_of_a_spiral():
    """On a circle E = k²/128; on the spiral the sum over short arcs is Riemann's."""
    from flint import arb

    with mp.workdps(30):
        circle = complexity(CurveBalls(parse_tuple("2*cos(t), 2*sin(t)")), 0, 1)
        assert abs(circle - mp.root(mp.mpf(2) / (64 * 128), 6)) < 1e-12
        value = complexity(CurveBalls(parse_tuple("t*cos(t), t*sin(t)")), arb(3), arb(4))
        total, n = mp.mpf(0), 6
        for i in range(n):
            s = 3 + (mp.mpf(i) + 0.5) / n
            *jet, kappa = invariants(spiral, s)
            total += mp.root(error_coefficient(*jet) * mp.cbrt(kappa) ** 7, 6) * mp.sqrt(1 + s * s) / n
        assert abs(total / value - 1) < 1e-2


@pytest.mark.parametrize("degree", [1, 3, 5, 7])
def test_true_conic_interpolants(degree):
    """Distance from the unit circle at 50 digits, against the constant; contacts counted by the zeros."""
    with mp.workdps(50):
        x, y = (sp.lambdify((t, A), c, "mpmath") for c in circle_interpolant(degree))
        half = mp.mpf("1e-2")
        places = [half * i / 400 for i in range(-400, 401)]
        error = max(abs(mp.hypot(x(s, half), y(s, half)) - 1) for s in places)
        if degree > 1:
            angle = 2 * mp.atan2(y(half, half), x(half, half))
            c = conic_constant(degree)
            assert abs(error / (mp.mpf(c.p) / c.q * angle ** (2 * degree)) - 1) < 2e-3
        square = sp.factor_list(sp.expand(contact_factor(degree) ** 2))[1]
        assert sum(power * sp.degree(factor, t) for factor, power in square) == 2 * degree


def test_other_choices_of_roots():
    assert speed((-1, 1, 1, 1, -1)) == 2
    assert sp.N(speed((1,) * 5) - 1 / sp.sin(sp.pi / 10), 40) == pytest.approx(0, abs=1e-35)
    assert conic_constant(5, speed((1,) * 5)) < conic_constant(5)


@pytest.mark.parametrize("bad", [mp.nan, mp.inf, -mp.inf])
def test_branches_at_no_number(bad):
    for jet in ((bad, 0, 1), (1, bad, 1), (1, 0, bad)):
        with pytest.raises(DomainError, match="finite numbers"):
            branches(*jet)
    with pytest.raises(DomainError, match="real numbers"):
        branches("x", 0, 1)


def test_singular_contacts():
    with pytest.raises(DomainError, match="coincide"):
        branches(1, 5, 2)
    with pytest.raises(DomainError, match="coincide"):
        branches(0, 0, 1)
    with pytest.raises(DomainError, match="curvature is 0"):
        affine_jet([mp.mpf(c) for c in (0, 1, 0, 0, 0, 0, 0)], [mp.mpf(c) for c in (0, 0, 0, 1, 0, 0, 0)])
    with pytest.raises(DomainError, match="order 6"):
        affine_jet([mp.mpf(0), mp.mpf(1)], [mp.mpf(0), mp.mpf(0)])
    line = lambda s: ((s, s), (mp.mpf(1), mp.mpf(1)), (mp.mpf(0), mp.mpf(0)))  # noqa: E731
    with pytest.raises(DomainError, match="singular"):
        g2_cubics(line, mp.mpf(0), mp.mpf(1))
    for degree in (0, 2, -1):
        with pytest.raises(DomainError, match="odd degree"):
            circle_interpolant(degree)
    assert contact_cubic().c == sp.Rational(1, 2)
