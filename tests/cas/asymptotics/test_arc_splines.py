"""Error laws of polygons, biarcs and triarcs against true primitives on real curves at 40 digits and more."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import mpmath as mp
import pytest
import sympy as sp
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics import arc_splines
from osculant.cas.asymptotics.arc_splines import (
    KAPPA,
    a,
    b,
    biarc,
    biarc_contact,
    triarc,
    triarc_conditions,
    v,
    x,
)
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.formulas.sympy_bridge import from_sympy
from osculant.cas.geometry.biarcs import Biarc, equioscillating, junction_circle, member
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws import arcs as arc_laws
from osculant.cas.laws.arcs import arc_law, at_junction, moons, peak
from osculant.cas.laws.complexity import law_integral
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import PRECISION, precision

DIGITS = 50


class Clothoidal:
    """A curve by arc length with κ(s) = k0 + k1 s + k2 s²/2 about s = 0: complex points by quadrature."""

    def __init__(self, *kappa: float) -> None:
        self.kappa = [mp.mpf(c) for c in kappa]

    def angle(self, s):
        return sum(c * s ** (i + 1) / mp.factorial(i + 1) for i, c in enumerate(self.kappa))

    @cache  # noqa: B019
    def __call__(self, s):
        # short arcs: Gauss–Legendre on one interval is exact to all digits used
        point = mp.quad(lambda u: mp.expj(self.angle(u)), [0, s], method="gauss-legendre")
        return point, mp.expj(self.angle(s))


coefficient = st.floats(0.3, 3)


@settings(max_examples=6, deadline=None)
@given(coefficient, st.floats(-3, 3), coefficient)
def test_chord_and_tangent(k0, k1, k2):
    with mp.workdps(DIGITS):
        h = mp.mpf("1e-8")
        curve = Clothoidal(k0, k1, k2)
        (p, _), (q, _), (m, T) = curve(-h), curve(h), curve(mp.mpf(0))
        sagitta = abs(mp.im(mp.conj(q - p) * (m - p))) / abs(q - p)
        law = arc_law("polygon")
        assert abs(sagitta / (law.constant.p * mp.mpf(k0) * (2 * h) ** 2 / law.constant.q) - 1) < 1e-6
        height = abs(mp.im(mp.conj(T) * (q - m)))
        assert abs(height / (mp.mpf(k0) * (2 * h) ** 2 / 8) - 1) < 1e-6


@settings(max_examples=5, deadline=None)
@given(coefficient, st.floats(0.3, 3), st.floats(-2, 2), st.floats(-0.8, 0.8))
def test_displacement_of_true_biarcs(k0, k1, k2, offset):
    """The true member whose first arc has length (1 + v)h, at points of both arcs, against f(x)h³."""
    with mp.workdps(DIGITS):
        h, place = mp.mpf("1e-7"), mp.mpf(offset)
        curve = Clothoidal(k0, k1, k2)
        (p, T), (q, _) = curve(-h), curve(h)
        turning = curve.angle(h) - curve.angle(-h)

        def excess(mu):
            found = member(p, T, q, turning, mu)
            return mp.arg(found.direction / T) / found.curvatures[0] / h - (1 + place)

        found = member(
            p,
            T,
            q,
            turning,
            mp.findroot(excess, (mp.mpf("0.01"), mp.mpf("0.99")), solver="illinois", tol=mp.mpf(10) ** -35),
        )
        pieces = [sp.lambdify((x, v, KAPPA[1]), f, "mpmath") for _, _, f in biarc().pieces]
        for where in (mp.mpf("-0.9"), mp.mpf("-0.3"), mp.mpf("0.2"), mp.mpf("0.85")):
            if abs(where - place) < 0.05:
                continue
            f = pieces[where > place](where, place, mp.mpf(k1)) * h**3
            scale = mp.mpf(k1) * h**3 / 100
            assert abs(found.displacement(*curve(where * h)) - f) < scale * mp.mpf("1e-3")


def test_curvatures_of_true_biarc_to_third_order():
    with mp.workdps(60):
        k = [mp.mpf(c) for c in ("1.3", "0.7", "-0.9", "1.1")]
        curve = Clothoidal(*k)
        place = mp.mpf(1) / 5
        defects = []
        for h in (mp.mpf("1e-4"), mp.mpf("5e-5")):
            (p, T), (q, _) = curve(-h), curve(h)
            turning = curve.angle(h) - curve.angle(-h)

            def excess(mu, p=p, T=T, q=q, turning=turning, h=h):
                found = member(p, T, q, turning, mu)
                return mp.arg(found.direction / T) / found.curvatures[0] / h - (1 + place)

            found = member(
                p,
                T,
                q,
                turning,
                mp.findroot(
                    excess, (mp.mpf("0.01"), mp.mpf("0.99")), solver="illinois", tol=mp.mpf(10) ** -35
                ),
            )
            predicted = []
            for series in biarc_contact(3)[:2]:
                terms = [
                    sp.lambdify((v, *KAPPA), c.as_expr(), "mpmath")(place, *k) for c in series.coefficients
                ]
                predicted.append(sum(c * h**i for i, c in enumerate(terms)))
            defects.append(max(abs(p - q) for p, q in zip(found.curvatures, predicted)))
        assert 3.8 < mp.log(defects[0] / defects[1], 2) < 4.2  # what is left is O(h⁴)


def test_vertex_error_of_true_biarc():
    with mp.workdps(DIGITS):
        h = mp.mpf("1e-5")
        curve = Clothoidal(1.5, 0, 2)
        (p, T), (q, _) = curve(-h), curve(h)
        b = member(p, T, q, curve.angle(h) - curve.angle(-h), mp.mpf("0.4"))
        error = abs(b.displacement(*curve(mp.mpf(0))))
        assert abs(error * 384 / (2 * (2 * h) ** 4) - 1) < 1e-6


def test_best_of_true_biarcs():
    with mp.workdps(DIGITS):
        h = mp.mpf("1e-6")
        curve = Clothoidal(1.1, -0.8, 0.5)
        (p, T), (q, _) = curve(-h), curve(h)
        turning = curve.angle(h) - curve.angle(-h)
        points = [h * mp.mpf(i) / 12 for i in range(-11, 12)]  # ±1/3 among them
        mu, error = equioscillating(lambda m: member(p, T, q, turning, m), curve, points)
        assert abs(error * 324 / (mp.mpf("0.8") * (2 * h) ** 3) - 1) < 1e-5
        assert abs(mu - 0.5) < 1e-5


def strip(found, curve, h, count=240):
    """(signed, whole) area of a biarc over the arc from −h to h, by the midpoint rule over h⁴."""
    places = [h * (2 * mp.mpf(i) + 1 - count) / count for i in range(count)]
    heights = [found.displacement(*curve(s)) / h**3 for s in places]
    return 2 * mp.fsum(heights) / count, 2 * mp.fsum(map(abs, heights)) / count


def test_areas_of_true_biarcs():
    """Equal moons mean the middle; there the area is least, and that of the law; elsewhere as derived."""
    with mp.workdps(30):
        h = mp.mpf("1e-6")
        curve = Clothoidal(1.3, 0.8, -0.4)
        (p, T), (q, S) = curve(-h), curve(h)
        areas = {}
        for mu in (mp.mpf("0.3"), mp.mpf("0.45"), mp.mpf("0.5"), mp.mpf("0.55"), mp.mpf("0.9")):
            found = member(p, T, q, mp.arg(S / T), mu)
            along = mp.re(found.junction / h)
            signed, areas[mu] = strip(found, curve, h)
            assert abs(signed - mp.mpf(2) / 9 * mp.mpf("0.8") * along) < 1e-4 * (abs(signed) + 1e-2)
            shape = at_junction(biarc(), sp.nsimplify(sp.Float(str(along), 30).n(6), rational=True))
            unit = arc_splines.Displacement(
                3, tuple((low, high, f.subs(KAPPA[1], sp.Rational(4, 5))) for low, high, f in shape.pieces)
            )
            assert abs(areas[mu] / mp.mpf(sp.N(moons(unit), 20)) - 1) < 1e-3
        middle = areas[mp.mpf("0.5")]
        assert middle == min(areas.values())
        assert abs(middle / (mp.mpf("0.8") * 16) * 576 - 1) < 1e-3


def test_true_triarc():
    """The circle tangent to both osculating circles whose curvature is that of the curve in the middle."""
    with mp.workdps(DIGITS):
        h = mp.mpf("1e-6")
        k = [mp.mpf(1), mp.mpf("0.6"), mp.mpf("0.2")]
        curve = Clothoidal(*k)
        (p, T), (q, S) = curve(-h), curve(h)
        outer = [sum(c * s**i / mp.factorial(i) for i, c in enumerate(k)) for s in (-h, h)]
        # K between them: its centre has the distances |1/K − 1/Kᵢ| from theirs, on the side of the curve
        K = k[0]
        c0, c1 = p + 1j * T / outer[0], q + 1j * S / outer[1]
        r0, r1 = abs(1 / K - 1 / outer[0]), abs(1 / K - 1 / outer[1])
        d = abs(c1 - c0)
        along = (r0**2 - r1**2 + d**2) / (2 * d)
        across = mp.sqrt(r0**2 - along**2)
        unit = (c1 - c0) / d
        errors = []
        for side in (1, -1):
            centre = c0 + unit * (along + 1j * side * across)
            gap = [
                abs(abs(curve(s)[0] - centre) - 1 / K) for s in (h * mp.mpf(i) / 100 for i in range(-57, 58))
            ]
            errors.append(max(gap))
        law = arc_law("triarc")
        expected = mp.mpf(sp.N(law.constant, 40)) * k[1] * (2 * h) ** 3
        assert abs(min(errors) / expected - 1) < 1e-3


def test_triarc_is_the_best_of_its_family():
    """Members whose middle arc has the curve's curvature at v ≠ 0 have larger leading errors."""
    best = sp.N(arc_law("triarc").constant) * 8
    for place in (sp.Rational(0), sp.Rational(1, 50), -sp.Rational(1, 50), sp.Rational(1, 10)):
        conditions = [c.subs(v, place) for c in triarc_conditions()]
        solutions = [(sp.N(s[a]), sp.N(s[b])) for s in sp.solve(conditions, [a, b], dict=True)]
        inside = [(left, right) for left, right in solutions if 0 < sp.re(left) < 1 and 0 < sp.re(right) < 1]
        assert len(inside) == 1
        left, right = inside[0]
        # f = −(x + 1)³/6 before −a; then f″ = v − x
        y = x + left
        f = -((1 - left) ** 3) / 6 - (1 - left) ** 2 * y / 2 + (place + left) * y**2 / 2 - y**3 / 6
        assert abs(f.subs(x, right) - (1 - right) ** 3 / 6) < 1e-12
        heights = [abs(f.subs(x, -left + (right + left) * sp.Rational(i, 400))) for i in range(401)]
        assert max(heights) > best * 1.001 if place else abs(max(heights) / best - 1) < 1e-4


#: places on [−1, 1] at which a leading displacement is summed
SAMPLES = 400


def _samples(shape):
    places = [sp.Rational(2 * i + 1, SAMPLES) - 1 for i in range(SAMPLES)]
    return [(s, next(f for low, high, f in shape.pieces if low <= s <= high)) for s in places]


def test_laws_match_closed_forms():
    triarc_constant = ((2 * sp.sqrt(3) - 3) / 3) ** sp.Rational(3, 2) / 24
    assert abs(sp.N(arc_law("triarc").constant - triarc_constant, 60)) < sp.Float("1e-55")
    # a biarc's displacement −κ′x(1 − |x|)²/6, by hand
    by_hand = 2 * sp.integrate(x * (1 - x) ** 2 / 6, (x, 0, 1)) / 2**4
    assert arc_law("biarc", "area").constant == by_hand == sp.Rational(1, 576)
    assert arc_law("biarc", "area").order == 4 and arc_law("biarc", "area").rate == sp.Rational(1, 3)
    triarc_area = sum(abs(sp.N(f.subs({KAPPA[1]: 1, x: s}))) for s, f in _samples(triarc())) / SAMPLES
    assert abs(triarc_area / 2**3 / sp.N(arc_law("triarc", "area").constant) - 1) < 1e-3
    assert [arc_law(p, "area").constant for p in ("polygon", "circumscribed polygon")] == [
        sp.Rational(1, 12),
        sp.Rational(1, 24),
    ]


@settings(max_examples=20, deadline=None)
@given(st.fractions(Fraction(-9, 10), Fraction(9, 10), max_denominator=40))
def test_peak_by_offset(offset):
    place = sp.Rational(offset.numerator, offset.denominator)
    shape = at_junction(biarc(), place)
    height = peak(arc_splines.Displacement(3, tuple((p, q, f.subs(KAPPA[1], 1)) for p, q, f in shape.pieces)))
    formula = sp.Rational(2, 81) * (1 + 2 * abs(place) / (1 + abs(place))) ** 3
    assert sp.simplify(height - formula) == 0


def test_area_complexity_of_a_circle():
    """n chords of the unit circle leave π − (n/2)sin(2π/n)."""
    circle = CurveBalls(parse_tuple("cos(t), sin(t)"))
    with precision(PRECISION):
        law = replace(
            law_of("biarc", "area"),
            order=arc_law("polygon", "area").order,
            constant=lambda: from_sympy(arc_law("polygon", "area").constant),
            invariant=lambda jet: abs(jet.curvature),
        )
        constant = float(law_integral(circle, law, arb(0), 2 * arb.pi())[0])
    n = 10**4
    with mp.workdps(40):
        epsilon = mp.pi - n * mp.sin(2 * mp.pi / n) / 2
        assert abs(constant / mp.sqrt(epsilon) / n - 1) < 1e-6


@pytest.mark.parametrize(
    ("primitive", "metric"), [("spline", "hausdorff"), ("spline", "area"), ("polygon", "l2")]
)
def test_unknown_laws(primitive, metric):
    with pytest.raises(DomainError):
        arc_law(primitive, metric)


def test_bad_input():
    with pytest.raises(DomainError, match="Contact of order 4"):
        biarc_contact(4)
    with pytest.raises(DomainError, match="outside"):
        at_junction(biarc(), sp.Integer(1))
    with pytest.raises(DomainError, match="tangents are equal"):
        junction_circle(mp.mpc(0), mp.mpc(1), mp.mpc(1), mp.mpc(1))
    for turning, mu in ((0, 0.5), (7, 0.5), (1, 0), (1, 1)):
        with pytest.raises(DomainError, match="No biarc"):
            member(mp.mpc(0), mp.mpc(1), mp.mpc(1), mp.mpf(turning), mp.mpf(mu))
    far = Biarc(mp.mpc(0), mp.expj(-0.5), mp.mpc(0.5, -0.1), mp.mpc(1), mp.mpc(1))
    with pytest.raises(DomainError, match="misses"):
        far.displacement(mp.mpc(100, 1), mp.mpc(1))
    assert arc_laws.arc_law("biarc").rate == sp.Rational(1, 3)
    assert triarc().order == 3
