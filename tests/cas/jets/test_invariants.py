"""The jets' forms against the definitions, and the transformation laws; proofs reject wrong variants."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import mpmath
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from osculant.cas.jets.canonical import affine_graph
from osculant.cas.jets.derivations import affine
from osculant.cas.jets.derivations.plane import bracket, derivative, equal, phi, v, x, y
from osculant.cas.jets.jet import real_root
from osculant.cas.jets.plane import INVARIANTS, PlaneJet
from tests.cas.jets.all_invariants import invariants_at

GENERIC = PlaneJet(x, y, lambda _, degree: v if degree == 2 else phi)


# The forms are what the definitions give.


def test_the_affine_parameter_is_unimodular():
    first, second, third = affine.by_affine_arc_length(3)
    assert equal(bracket(first, second), 1)  # (2.1)
    assert equal(bracket(first, third), 0)
    for i in range(2):
        assert equal(third[i], -affine.affine_curvature() * first[i])  # (2.5)


def test_affine_frame_and_curvature():
    first, second = affine.by_affine_arc_length(2)
    for i in range(2):
        assert equal(GENERIC.affine_tangent[i], first[i])
        assert equal(GENERIC.affine_normal[i], second[i])
    assert equal(GENERIC.affine_curvature, affine.affine_curvature())
    assert equal(GENERIC.affine_curvature_slope, affine.affine_curvature_slope())


def test_wrong_affine_curvatures_are_rejected():
    k = affine.affine_curvature()
    b = GENERIC.bracket
    for wrong in (
        (3 * phi**3 * (4 * b(2, 3) - b(1, 4)) - 5 * b(1, 3) ** 2) / (9 * phi**8),
        (3 * phi**3 * (4 * b(2, 3) + b(1, 4)) - 4 * b(1, 3) ** 2) / (9 * phi**8),
        GENERIC.affine_curvature * phi,
    ):
        assert not equal(wrong, k)
    assert not equal(
        GENERIC.affine_curvature_slope * phi, affine.affine_curvature_slope()
    )  # dk/dt, not dk/dr


def test_the_formula_for_any_parameter():
    b, slope = GENERIC.bracket, derivative(phi)
    k = b(2, 3) / phi**5 + (derivative(slope) * phi - 3 * slope**2) / phi**4  # (2.12)
    assert equal(GENERIC.affine_curvature, k)


def test_euclidean_curvature_and_its_derivatives():
    assert equal(GENERIC.curvature, affine.curvature(0))
    assert equal(GENERIC.curvature_slope, affine.curvature(1))
    assert equal(GENERIC.curvature_bend, affine.curvature(2))
    assert not equal(GENERIC.curvature_slope * v, affine.curvature(1))  # by t instead of s


def test_affine_curvature_from_the_euclidean():
    kappa, slope, bend = GENERIC.curvature, GENERIC.curvature_slope, GENERIC.curvature_bend
    power = (phi / v) ** 8  # κ^{8/3}
    assert equal(GENERIC.affine_curvature, (9 * kappa**4 - 5 * slope**2 + 3 * kappa * bend) / (9 * power))
    assert not equal(GENERIC.affine_curvature, (9 * kappa**4 - 5 * slope**2 - 3 * kappa * bend) / (9 * power))


def test_affine_frame_from_the_euclidean():
    tangent, normal = (x[1] / v, y[1] / v), (-y[1] / v, x[1] / v)
    third, kappa = phi / v, GENERIC.curvature  # κ^{1/3}
    for i in range(2):  # (2.9)
        n = -GENERIC.curvature_slope / (3 * kappa * third**2) * tangent[i] + third * normal[i]
        assert equal(GENERIC.affine_normal[i], n)


def test_evolute_is_the_centre_of_curvature():
    for i, normal in enumerate((-y[1] / v, x[1] / v)):
        assert equal(GENERIC.evolute[i], GENERIC.point(0)[i] + normal / GENERIC.curvature)


def test_rates_are_derivatives():
    form = GENERIC.parabolic_form
    assert equal(GENERIC.inflection_rate, derivative(GENERIC.inflection_form))
    assert equal(GENERIC.parabolic_rate, derivative(form))
    assert not equal(GENERIC.parabolic_rate + GENERIC.bracket(1, 5), derivative(form))


def test_canonical_form():
    series, (k, slope, *_) = affine_graph(5)
    jet = SimpleNamespace(affine_curvature=k, affine_curvature_slope=slope)
    assert PlaneJet.canonical_form.func(jet) == (series[4], series[5])
    assert series[4] != k / 24


def test_canonical_form_of_the_frame_of_a_graph():
    # y = z²/2 + a z⁴/8 + b z⁵/40 has the trivial affine frame at 0, and k = a, dk/dr = b there.
    a, b = sp.symbols("a b", real=True)
    values = invariants_at((0, 1, 0, 0, 0, 0), (0, 0, sp.Integer(1), 0, 3 * a, 3 * b))
    assert values["affine_tangent"] == (1, 0)
    assert values["affine_normal"] == (0, 1)
    assert values["affine_curvature"] == a
    assert sp.expand(values["affine_curvature_slope"] - b) == 0
    assert sp.expand(values["canonical_form"][1] - b / 40) == 0


# How the invariants transform.


def _reparametrised(column, h, order):
    """Derivatives by u of α(t(u)), where h[i] is the i-th derivative of t."""
    result, current = [column[0]], column[0]
    rates = dict(pairwise(column))
    for _ in range(order):
        inner = sum(sp.diff(current, c) * rates[c] for c in column[:-1]) * h[1]
        outer = sum(sp.diff(current, h[i]) * h[i + 1] for i in range(1, len(h) - 1))
        current = sp.expand(inner + outer)
        result.append(current)
    return result


def test_forms_under_reparametrisation():
    h = sp.symbols("h:7")
    other = PlaneJet(_reparametrised(x, h, 5), _reparametrised(y, h, 5))
    # D, n, m get the factors ṫ³, ṫ⁸, ṫ¹²: so k = n/(9D^{8/3}) and dk/dr = m/(27D⁴) do not change at all.
    weights = {"inflection_form": 3, "parabolic_form": 8, "sextactic_form": 12}
    for form, weight in weights.items():
        ours = getattr(GENERIC, form) * h[1] ** weight
        assert sp.expand(getattr(other, form) - ours) == 0
        assert sp.expand(getattr(other, form) - ours * h[1]) != 0


def test_forms_under_linear_maps():
    a, b, c, d = sp.symbols("a b c d")
    image = PlaneJet([a * p + b * q for p, q in zip(x, y)], [c * p + d * q for p, q in zip(x, y)])
    det = a * d - b * c
    # D, n, m get det, det², det³: so k gets det^{2 − 8/3} = det^{−2/3} and dk/dr gets det^{3 − 4} = 1/det;
    # a mirror (det = −1) keeps k and changes the sign of dk/dr.
    for form, weight in {"inflection_form": 1, "parabolic_form": 2, "sextactic_form": 3}.items():
        ours = getattr(GENERIC, form)
        assert sp.expand(getattr(image, form) - det**weight * ours) == 0
        assert sp.expand(getattr(image, form) - det ** (weight + 1) * ours) != 0


def _conic_jet(a, b, c, d, e):
    """The jet at the origin of ax² + 2bxy + cy² + 2dx + 2ey = 0 as a graph, by comparing coefficients."""
    t = sp.Symbol("t")
    coefficients = sp.symbols("y1:6")
    graph = sum(c_i * t**i for i, c_i in enumerate(coefficients, 1))
    equation = sp.Poly(sp.expand(a * t**2 + 2 * b * t * graph + c * graph**2 + 2 * d * t + 2 * e * graph), t)
    known = {}
    for i, symbol in enumerate(coefficients, 1):
        (value,) = sp.solve(equation.coeff_monomial(t**i).subs(known), symbol)
        known[symbol] = sp.factor(value)
    heights = [known[s] * sp.factorial(i) for i, s in enumerate(coefficients, 1)]
    return PlaneJet((0, 1, 0, 0, 0, 0), (0, *heights))


def test_conics():
    a, b, c, d, e = sp.symbols("a b c d e")
    jet = _conic_jet(a, b, c, d, e)
    # A conic has been moved to pass through the origin, which changes neither S nor T.
    small, large = a * c - b**2, sp.Matrix([[a, b, d], [b, c, e], [d, e, 0]]).det()
    assert sp.simplify(jet.sextactic_form) == 0
    # k = S(T²)^{−1/3}: the cubes agree, and so do the real numbers. k³ = n³/(9³D⁸).
    cube = sp.cancel(jet.parabolic_form**3 / (729 * jet.inflection_form**8))
    assert sp.cancel(cube - small**3 / large**2) == 0
    assert sp.cancel(cube - small**3 / large) != 0


def test_a_parabola_has_no_affine_curvature():
    assert _conic_jet(1, 0, 0, 3, 5).parabolic_form == 0
    assert _conic_jet(1, 0, 2, 3, 5).parabolic_form != 0


# Numbers of any kind.


def _numbers(kind):
    exact = ([3, 2, -1, 4, 1, -2], [1, -3, Fraction(1, 2), 2, -5, 7])
    return [[kind(q) for q in column] for column in exact]


def test_kinds_of_numbers_agree():
    from flint import arb, fmpq

    floats = invariants_at(*_numbers(float))
    with mpmath.workdps(40):
        precise = invariants_at(
            *_numbers(lambda q: mpmath.mpf(Fraction(q).numerator) / Fraction(q).denominator)
        )
    balls = invariants_at(*_numbers(lambda q: arb(fmpq(Fraction(q).numerator, Fraction(q).denominator))))
    exact = invariants_at(*_numbers(lambda q: sp.Rational(Fraction(q).numerator, Fraction(q).denominator)))
    assert list(floats) == [invariant.name for invariant in INVARIANTS]
    for name, value in floats.items():
        for i, number in enumerate(value if isinstance(value, tuple) else (value,)):
            others = [
                other[name][i] if isinstance(value, tuple) else other[name]
                for other in (precise, balls, exact)
            ]
            for other in others:
                assert math.isclose(number, float(other), rel_tol=1e-12)


def test_cube_root_of_a_negative_determinant():
    right_turn = invariants_at((0.0, 1.0, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, -8.0, 0.0, 0.0, 0.0))
    assert right_turn["affine_speed"] == -2.0
    assert real_root(mpmath.mpf(-8), 3) == -2
    assert real_root(sp.Integer(-8), 3) == -2


def test_what_does_not_exist_is_none():
    straight = invariants_at((0, 1, 0, 0, 0, 0), (0, 2, 0, 0, 0, 0))
    assert straight["curvature"] == 0
    assert straight["evolute"] is straight["affine_curvature"] is straight["canonical_form"] is None
    cusp = invariants_at((0, 0, 2, 0, 0, 0), (0, 0, 0, 6, 0, 0))
    assert cusp["speed"] == 0
    assert cusp["curvature"] is cusp["affine_normal"] is None


small = st.integers(-9, 9).map(Fraction)


@given(st.lists(small, min_size=12, max_size=12), st.lists(small, min_size=4, max_size=4))
def test_linear_maps_on_rational_jets(jet, matrix):
    a, b, c, d = matrix
    curve = PlaneJet(jet[:6], jet[6:])
    image = PlaneJet(
        [a * p + b * q for p, q in zip(curve.x, curve.y)], [c * p + d * q for p, q in zip(curve.x, curve.y)]
    )
    det = a * d - b * c
    if det != 0 and curve.inflection_form != 0:
        assert image.affine_curvature_slope == curve.affine_curvature_slope / det
        cubes = [jet.parabolic_form**3 / jet.inflection_form**8 for jet in (image, curve)]
        assert cubes[0] * det**2 == cubes[1]
