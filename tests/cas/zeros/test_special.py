"""Special points against polynomials' roots and known curves; what cannot be decided is said to be so."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_series, ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.numbers.balls import PRECISION, constant, padded, precision
from osculant.cas.zeros import isolate
from osculant.cas.zeros import plane as special
from osculant.cas.zeros.form_zeros import FormZeros
from osculant.cas.zeros.multiplicity import order_of_zero, simple_rational
from osculant.cas.zeros.plane import FORMS, zeros

X = sp.Symbol("t")
CONIC = ("cusp", "inflection", "sextactic")
PARABOLA = ("cusp", "inflection", "parabolic")


def require_finite(curve, low, high):
    zeros(curve).require_finite(low, high, tuple(FORMS))


def points(text, low, high, names=CONIC):
    curve, ends = CurveBalls(parse_tuple(text)), (parse_constant(low), parse_constant(high))
    require_finite(curve, *ends)
    return zeros(curve).within(*ends, names)


def places(found, kind):
    """Where decided points of a kind are, as floats."""
    return [float(p.at.mid()) for p in found if kind in p.kinds and p.decided]


def assert_at(found, kind, expected, tolerance=1e-15):
    assert all(p.decided for p in found)
    assert places(found, kind) == pytest.approx(expected, abs=tolerance, rel=tolerance)


# Graphs: with u = y″, κ = 0 where u = 0, k = 0 where (u^{−2/3})″ = 0, and dk/dr = 0 where (u^{−2/3})‴ = 0
# (Monge's equation).


def conditions(u):
    first, second, third = (sp.diff(u, X, n) for n in (1, 2, 3))
    return {
        "inflection": u,
        "parabolic": 5 * first**2 - 3 * u * second,
        "sextactic": 40 * first**3 - 45 * u * first * second + 9 * u**2 * third,
    }


def graph_of(u):
    """The curve (t, y) with that second derivative, as text."""
    return f"t, {sp.integrate(sp.integrate(u, X), X)}".replace("**", "^")


def real_roots(polynomial, low, high):
    """[(root, multiplicity)] by Sturm sequences."""
    found = sp.Poly(polynomial, X).intervals(eps=sp.Rational(1, 10**18), inf=low, sup=high)
    return [(float((a + b) / 2), multiplicity) for (a, b), multiplicity in found]


@given(st.lists(st.integers(-9, 9), min_size=2, max_size=6), st.sampled_from([PARABOLA, CONIC]))
@settings(max_examples=40, deadline=None)
def test_random_polynomial_graphs(coefficients, names):
    u = sp.Poly(coefficients, X).as_expr()
    forms = conditions(u)
    assume(all(forms[name] != 0 for name in names[1:]))
    found = points(graph_of(u), "-2", "3", names)
    assert not places(found, "cusp")
    for name in names[1:]:
        expected = real_roots(forms[name], -2, 3)
        ours = [p for p in found if name in p.kinds]
        assert [float(p.at.mid()) for p in ours] == pytest.approx([x for x, _ in expected], abs=1e-9)
        for point, (root, multiplicity) in zip(ours, expected, strict=True):
            others = [x for x, _ in expected if x != root]
            if multiplicity == 1 and point.kinds == {name} and all(abs(x - root) > 1e-6 for x in others):
                assert point.decided
                assert point.at.rad() < 1e-40
            if not point.decided:
                assert multiplicity > 1 or len(point.kinds) > 1


rationals = st.fractions(-2, 2, max_denominator=12)


@given(st.dictionaries(rationals, st.integers(1, 4), min_size=1, max_size=4))
@settings(max_examples=20, deadline=None)
def test_multiple_zeros_at_rationals_are_decided(roots):
    u = sp.prod((X - sp.Rational(r.numerator, r.denominator)) ** m for r, m in roots.items())
    found = points(graph_of(sp.expand(u)), "-2", "2", ("cusp", "inflection"))
    assert_at(found, "inflection", sorted(map(float, roots)))


@given(st.lists(st.integers(-5, 5), min_size=3, max_size=9))
@settings(max_examples=30, deadline=None)
def test_random_trigonometric_graphs(coefficients):
    level, waves = coefficients[0], list(zip(coefficients[1::2], coefficients[2::2], strict=False))
    assume(any(map(any, waves)))
    # u = level + Σ a cos kt + b sin kt: its zeros are those of a polynomial on the unit circle
    halves = [complex(a, -b) / 2 for a, b in waves]
    roots = np.roots([*reversed(halves), level, *(c.conjugate() for c in halves)])
    off = np.abs(np.abs(roots) - 1)
    assume(all(x < 1e-9 or x > 1e-3 for x in off))  # a pair off the circle shows in numpy as one on it
    expected = np.sort((np.angle(roots[off < 1e-9]) + 1 / 7) % (2 * math.pi))
    around = np.r_[expected, expected[:1] + 2 * math.pi]
    assume(len(expected) == 0 or np.min(np.diff(around)) > 1e-3)
    terms = [f"{-a}/{k**2}*cos({k}*t) + {-b}/{k**2}*sin({k}*t)" for k, (a, b) in enumerate(waves, 1)]
    text = f"t, {level}/2*t^2 + " + " + ".join(terms)
    found = points(text.replace("+ -", "- "), "-1/7", "2*pi - 1/7", ("cusp", "inflection"))
    assert all(p.decided for p in found)
    ours = np.array(places(found, "inflection")) + 1 / 7
    assert ours == pytest.approx(expected, abs=1e-8)


def test_zeros_close_together_are_told_apart():
    r = Fraction(1, 3) + Fraction(1, 10**9)
    found = points(
        graph_of((X - sp.Rational(1, 3)) * (X - sp.Rational(r.numerator, r.denominator))), "0", "2"
    )
    assert len(places(found, "inflection")) == 2
    assert all(p.decided for p in found)


def test_a_zero_that_is_missed_by_little_is_never_a_decided_zero():
    for small, decided in ((10**-18, True), (10**-24, True), (10**-42, False)):
        gap = sp.Rational(f"{small:.0e}")
        found = points(
            graph_of(sp.expand((X - sp.Rational(1, 3)) ** 2 + gap)), "0", "2", ("cusp", "inflection")
        )
        assert not places(found, "inflection")
        assert (not found) is decided
        assert all(abs(float(p.at) - 1 / 3) < 1e-9 for p in found)


# Curves whose special points are known.


def test_semicubical_cusp():
    found = points("t^2, t^3", "-1", "1")
    assert_at(found, "cusp", [0])
    assert len(found) == 1


@pytest.mark.parametrize("move", ["t - 1/7", "t - pi/5", "2*t - 3", "t^3 - 1/8"])
def test_cusps_at_simple_numbers(move):
    at = {"t - 1/7": 1 / 7, "t - pi/5": math.pi / 5, "2*t - 3": 1.5, "t^3 - 1/8": 0.5}[move]
    found = points(f"({move})^2, ({move})^3 + ({move})^4", "1/10", "2", ("cusp",))
    assert_at(found, "cusp", [at])


def test_cycloid():
    found = points("t - sin(t), 1 - cos(t)", "0", "4*pi")
    assert_at(found, "cusp", [0, 2 * math.pi, 4 * math.pi])
    assert_at(found, "sextactic", [k * math.pi for k in range(5)])


def test_astroid():
    found = points("cos(t)^3, sin(t)^3", "0", "2*pi")
    assert_at(found, "cusp", [k * math.pi / 2 for k in range(5)])
    assert_at(found, "sextactic", [k * math.pi / 4 for k in range(9)])


@pytest.mark.parametrize("cusps", [2, 5, 7])
def test_epicycloids(cusps):
    """Cusps at multiples of 2π/n, of which sine and cosine may have no radicals that sympy knows."""
    n = cusps + 1
    found = points(f"{n}*cos(t) - cos({n}*t), {n}*sin(t) - sin({n}*t)", "0", "2*pi")
    assert_at(found, "cusp", [2 * math.pi * k / cusps for k in range(cusps + 1)])
    assert_at(found, "sextactic", [math.pi * k / cusps for k in range(2 * cusps + 1)])


def test_undulation():
    for names, kind in ((PARABOLA, "parabolic"), (CONIC, "sextactic")):
        [point] = points("t, t^4", "-1", "2", names)
        assert point.decided
        assert point.at == 0
        assert point.kinds == {"inflection", kind}


def test_a_curve_traversed_there_and_back():
    for names, kind in ((PARABOLA, "parabolic"), (CONIC, "sextactic")):
        found = points("cos(2*t), sin(3*t)", "0", "2*pi", names)
        assert_at(found, "cusp", [math.pi / 2, 3 * math.pi / 2])  # where it turns back
        assert {math.pi / 2, 3 * math.pi / 2} <= set(places(found, kind))


def test_cubic_parabola_and_its_square_root():
    assert_at(points("t, t^3", "-1", "1"), "inflection", [0])
    found = points("t^(3/2), t", "1/10", "2", PARABOLA)
    assert found == []


def test_conics_vanish_identically_and_nothing_else_does():
    curves = {
        "2*cos(t), sin(t + 1)": (False, False, True),
        "t + t^2, t - t^2": (False, True, True),
        "t + sin(t), 2*t + 2*sin(t)": (True, True, True),
        "t, t^2 + 10^(-30)*sin(t)": (False, False, False),
        "t, 10^(-40)*t^3": (False, False, False),
    }
    with precision(PRECISION):
        for text, expected in curves.items():
            curve = CurveBalls(parse_tuple(text))
            names = ("inflection", "parabolic", "sextactic")
            got = [zeros(curve).vanishes(name, arb(0), arb(1)) for name in names]
            assert tuple(got) == expected, text
            assert not zeros(curve).vanishes("cusp", arb(0), arb(1))


def test_zeros_at_the_ends():
    assert_at(points("t, sin(t)", "0", "pi", ("cusp", "inflection")), "inflection", [0, math.pi])
    assert_at(points("t, sin(t)", "pi/2", "3*pi/2"), "sextactic", [math.pi / 2, 3 * math.pi / 2])
    assert_at(points("t - sin(t), 1 - cos(t)", "0", "2*pi"), "cusp", [0, 2 * math.pi])
    root = "2^(1/3)"  # as an end it is a candidate, though not simple
    for low, high in ((root, "2"), ("1", root)):
        found = points("(t^3 - 2)^2, (t^3 - 2)^3", low, high, ("cusp",))
        assert len(found) == 1
        assert abs(float(found[0].at) - 2 ** (1 / 3)) < 1e-10
    sextic = "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"
    assert_at(points(sextic, "0", "3*pi/4"), "sextactic", [0], 1e-60)
    assert points(sextic, "1/100", "3*pi/4") == []


# Multiple zeros at irrational places.


@pytest.mark.parametrize(("low", "high"), [("1", "2"), ("1.2", "1.3"), ("1/2", "40")])
@pytest.mark.parametrize("powers", [(2, 3), (2, 5), (4, 6)])
def test_a_cusp_at_an_irrational_place_is_undecided(low, high, powers):
    text = ", ".join(f"(t^3 - 2)^{n}" for n in powers)
    [point] = points(text, low, high)
    assert not point.decided
    assert "cusp" in point.kinds
    assert abs(float(point.at) - 2 ** (1 / 3)) < 1e-9 * float(constant(parse_constant(high)))


def test_a_double_zero_at_an_irrational_place_is_undecided():
    h = "(t^3 - 2)"  # y = h²/2 + h⁷: in h = 0 the osculating parabola has contact so high that n ~ h³, m ~ h²
    for names, kind in ((PARABOLA, "parabolic"), (CONIC, "sextactic")):
        found = points(f"{h}, {h}^2/2 + {h}^7", "1", "2", names)
        [open_point] = [p for p in found if not p.decided]
        assert open_point.kinds == {kind}
        assert abs(float(open_point.at) - 2 ** (1 / 3)) < 1e-9
        assert 2 ** (1 / 3) not in [pytest.approx(x, abs=1e-6) for x in places(found, kind)]
        # the simple zeros beside it are found: where 2y″y⁗… of the graph over h has its other real roots
        second = sp.diff(X**2 / 2 + X**7, X, 2)
        others = [x for x, m in real_roots(conditions(second)[kind], -1, 6) if m == 1]
        assert places(found, kind) == pytest.approx([(2 + x) ** (1 / 3) for x in others], abs=1e-9)


def test_a_simple_zero_at_an_irrational_place_is_decided():
    [point] = points("t^3 - 2, (t^3 - 2)^3", "1", "2", ("cusp", "inflection"))
    assert point.decided
    with precision(PRECISION):
        assert abs(point.at - arb(2).root(3)) < 1e-45


def test_undecided_and_decided_points_stay_apart():
    found = points("(t^2 - 2)^2*(t - 1)^2, (t^2 - 2)^3*(t - 1)^2", "0", "2", ("cusp",))
    assert [(round(float(p.at), 9), p.decided) for p in found] == [(1.0, True), (1.414213562, False)]


def test_a_proof_near_a_simple_number_does_not_reach_too_far():
    # the forms vanish to a high order at 0, outside the interval, and at 2^(1/3), which is not far from there
    [point] = points("(t^3 - 2)^2, (t^3 - 2)^3", "1/2", "40")
    assert not point.decided
    assert point.kinds == set(CONIC)
    assert abs(float(point.at) - 2 ** (1 / 3)) < 1e-7


@pytest.mark.parametrize("name", CONIC)
def test_long_series_of_forms_lose_no_term(name):
    form, order = special.FORMS[name].form, special.FORMS[name].order
    jets = [[sp.diff(f, X, i) for i in range(order + 1)] for f in (sp.sin(X), sp.exp(X / 2))]
    last = sp.diff(sp.expand(form(PlaneJet(*jets))), X, 24).subs(X, 0) / sp.factorial(24)
    assert last != 0
    with precision(PRECISION):
        curve = CurveBalls(parse_tuple("sin(t), exp(t/2)"))
        at_zero = curve.form_series(form, arb(0), order, 25)
        around = curve.form_series(form, arb(0, 0.01), order, 25)
        assert at_zero[24].overlaps(arb(int(last.p)) / int(last.q))
        assert at_zero[24].rel_accuracy_bits() > 200
        assert all(wide.contains(point) for wide, point in zip(around, at_zero, strict=True))


def test_a_series_that_is_too_short_is_unknown():
    assert padded(arb_series([1, 2], 3), 3) == [1, 2, 0]
    assert padded(arb_series([1, 2], 2), 3)[2].is_nan()


# Steep graphs have horizontal tangents without being singular.


def test_extrema_of_steep_graphs_are_no_cusps():
    found = points("t, sin(1/t)", "1/200", "1", ("cusp", "inflection"))
    assert all(p.decided for p in found)
    assert not places(found, "cusp")
    # y″ = 0 where tan(1/t) = 2t: about one zero for each half turn of 1/t
    assert len(places(found, "inflection")) == pytest.approx((200 - 1) / math.pi, abs=2)
    assert points("t, 10^12*cos(t) + t^2", "-1", "1", ("cusp",)) == []


# Where a curve has no finite derivatives.


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("t, 1/(t - 1)", "t = 1 ", "infinite .*division by zero"),
        ("t, 1/(t^3 - 2)", "t = 1.25992105 ", "infinite .*division by zero"),
        ("t, tan(t)", "t = 1.570796327 ", "infinite .*pole of tan"),
        ("t, log(t - 1/3)", "t = 0 ", "undefined .*logarithm"),
        ("t, sqrt(t)", "t = 0 ", "no finite derivatives .*root"),
        ("t, sqrt(2 - t^3)", "t = 1.25992105 ", "undefined .*root"),
        ("t, cbrt(t - 1/7)", "t = 0.1428571429 ", "no finite derivatives .*division by zero"),
        ("t, cbrt(t^3 - 2)", "t = 1.25992105 ", "no finite derivatives .*division by zero"),
        ("t, abs(t - pi/4)", "t = 0.7853981634 ", "abs has no derivative at 0"),
        ("t, asin(t)", "t = 1 ", "division by zero|root|asin"),
        ("t, acosh(t + 1/2)", "t = 0 ", "acosh|root|logarithm"),
        ("t, t^(5/2)", "t = 0 ", "no finite derivatives .*root|division"),
        ("exp(1/t), t", "t = 0 ", "division by zero"),
    ],
)
def test_the_place_is_named(text, place, reason):
    with pytest.raises(DomainError, match=reason) as error:
        require_finite(CurveBalls(parse_tuple(text)), parse_constant("0"), parse_constant("2"))
    assert place in str(error.value)
    assert "\n" not in str(error.value)


def test_finite_curves_are_let_through():
    for text in (
        "t, sqrt(t^2 + 10^(-12))",
        "t, 1/(1 + t^2)",
        "cbrt(t - 3), abs(t + 1)",
        "t, log(1 + t)*exp(t)",
    ):
        require_finite(CurveBalls(parse_tuple(text)), parse_constant("0"), parse_constant("2"))


# Bounded work.


@pytest.fixture
def counted(monkeypatch):
    """How often series over a ball are evaluated."""
    calls = []
    evaluate = FormZeros.evaluate
    monkeypatch.setattr(
        FormZeros,
        "evaluate",
        lambda self, t, names, terms: calls.append(t) or evaluate(self, t, names, terms),
    )
    return calls


def test_what_the_work_limit_leaves_is_undecided(monkeypatch, counted):
    monkeypatch.setattr(isolate, "WORK_LIMIT", 25)
    wave = zeros(CurveBalls(parse_tuple("t, sin(40*t)")))
    found = wave.within(parse_constant("0"), parse_constant("6"), ("cusp", "inflection"))
    assert len(counted) <= 50
    undecided = [float(p.at.mid()) for p in found if not p.decided]
    assert len(undecided) >= 2
    for k in range(1, int(40 * 6 / math.pi) + 1):
        zero = k * math.pi / 40
        known = any(abs(x - zero) < 1e-12 for x in places(found, "inflection"))
        assert known or min(undecided) <= zero <= max(undecided)


def test_a_formula_that_cancels_too_much_is_refused(monkeypatch, counted):
    curve = CurveBalls(parse_tuple("t, sqrt(t^4 - 4*t^3 + 6*t^2 - 4*t + 1 + 10^(-9))"))  # √((t−1)⁴ + 1e-9)
    monkeypatch.setattr(isolate, "WORK_LIMIT", 500)
    with pytest.raises(UndecidedError, match=r"finite near t = 0\.\d+ could not be told"):
        require_finite(curve, parse_constant("0"), parse_constant("2"))
    assert len(counted) <= 500


@pytest.mark.parametrize(
    "text",
    [
        "(t^3 - 2)^4, (t^3 - 2)^7",
        "8*cos(t) - cos(8*t), 8*sin(t) - sin(8*t)",
        "t, (t - 3/2)^15",
        "t, exp(-t^2)",
    ],
)
def test_ordinary_work_is_far_below_the_limit(text, counted):
    zeros(CurveBalls(parse_tuple(text))).within(parse_constant("1"), parse_constant("2"), CONIC)
    assert len(counted) < isolate.WORK_LIMIT  # two for each interval


# The parts.


@given(st.fractions(-50, 50), st.fractions(0, 1))
def test_simple_rational_is_the_simplest(low, width):
    high = low + width
    q = simple_rational(low, high)
    assert low <= q <= high
    if q.denominator < 60:
        assert all(math.ceil(low * d) > math.floor(high * d) for d in range(1, q.denominator))


@pytest.mark.parametrize(
    ("text", "form", "at", "order"),
    [
        ("t - sin(t), 1 - cos(t)", "cusp", "2*pi", 2),
        ("t^2, t^3", "cusp", "0", 2),
        ("t, t^5", "inflection", "0", 3),
        ("t, sin(t)", "inflection", "7*pi", 1),
        ("(t - sqrt(2))^2, (t - sqrt(2))^3", "cusp", "sqrt(2)", 2),
        ("8*cos(t) - cos(8*t), 8*sin(t) - sin(8*t)", "inflection", "2*pi/7", 2),
        ("log(t)^2, log(t)^3", "cusp", "1", 2),
    ],
)
def test_order_of_zero(text, form, at, order):
    zero, curve = (special.FORMS[form].form, special.FORMS[form].order), CurveBalls(parse_tuple(text))
    for multiplicity in range(1, order + 1):
        assert order_of_zero(curve, *zero, parse_constant(at), multiplicity)
    assert not order_of_zero(curve, *zero, parse_constant(at), order + 1)
    assert not order_of_zero(curve, *zero, parse_constant(f"{at} + 10^(-200)"), 1)


def isolated(function, low, high, calls=None):
    """Zeros of an mpmath-free function of power series, by `isolate` alone."""

    def evaluate(t, names, terms):
        if calls is not None:
            calls.append(terms)
        old, ctx.cap = ctx.cap, terms
        series = function(arb_series([t, 1], terms)).coeffs()
        ctx.cap = old
        return {name: [[*series, *[arb(0)] * (terms - len(series))]] for name in names}

    return isolate.isolate(evaluate, lambda *_: None, ["f"], arb(low), arb(high))


@pytest.mark.parametrize("bits", [60, 400, 900])
def test_what_is_left_where_large_functions_cancel_takes_terms_and_not_boxes(bits):
    def function(t):
        return t.sin() * t.sin() + t.cos() * t.cos() - 1 + (t - arb(1) / 3) * arb(2) ** -bits

    calls = []
    with precision(1100):
        found = isolated(function, 0, 2, calls)
    [(low, high)] = found.brackets["f"]
    assert low < arb(1) / 3 and arb(1) / 3 < high and not found.unresolved
    assert len(calls) < 250 and max(calls) <= isolate.LONGER[-1]


@given(st.lists(st.integers(-40, 40), min_size=1, max_size=5, unique=True))
@settings(max_examples=25, deadline=None)
def test_isolation_of_simple_zeros(numerators):
    roots = sorted(arb(n) / 7 for n in numerators)

    def function(x):
        product = x * 0 + 1
        for root in roots:
            product = product * (x - root)
        return product

    with precision(PRECISION):
        found = isolated(function, -6, 6)
        assert found.unresolved == []
        inside = [r for r in roots if abs(r) < 6]
        brackets = sorted(found.brackets["f"], key=lambda b: float(b[0]))
        holding = [[b for b in brackets if b[0] <= r and r <= b[1]] for r in inside]
        assert all(len(b) == 1 for b in holding)


def test_a_double_zero_stays_unresolved():
    with precision(PRECISION):
        found = isolated(lambda x: (x - arb(2).sqrt()) ** 2, 0, 2)
        assert not any(low <= arb(2).sqrt() and high >= arb(2).sqrt() for low, high in found.brackets["f"])
        assert found.unresolved
        assert all(abs(box.low - arb(2).sqrt()) < 1e-9 for box in found.unresolved)


@given(st.floats(-1.9, 1.9))
@settings(max_examples=30, deadline=None)
def test_refine(root):
    with precision(PRECISION):
        r = arb(root)
        value, slope = (lambda t: (t - r) * (3 + t * t)), (lambda t: 3 + t * t + 2 * t * (t - r))
        zero = isolate.refine(value, slope, arb(-2), arb(2), arb(2) ** -150)
        assert zero.contains(r)
        assert zero.rad() < 1e-40
        assert isolate.refine(value, slope, r + arb(1) / 100, arb(3), arb(2) ** -150) is None


@pytest.mark.parametrize("width", [1e-3, 1e-9, 1e-15])
def test_refine_takes_one_look_where_newton_proves_the_zero(width):
    looks = []
    with precision(PRECISION):
        r = arb(2).sqrt()

        def value(t):
            looks.append(t)
            return t * t - 2

        def wrong(t):  # never inside: its zero is not there
            return t * t - 2 + 3 * arb(width)

        low, high = arb((r - width).mid()), arb((r + width / 2).mid())
        zero = isolate.refine(value, lambda t: 2 * t, low, high, arb(width) / 1000)
        assert zero.overlaps(r) and zero.rad() < width / 1000
        assert len(looks) <= 3
        assert isolate.refine(wrong, lambda t: 2 * t, low, high, arb(width) / 1000) is None


def test_refine_at_an_end():
    with precision(PRECISION):
        pi = arb.pi()
        zero = isolate.refine(lambda t: t.sin(), lambda t: t.cos(), arb(3), pi, arb(2) ** -150)
        assert zero.overlaps(pi)
        with mpmath.workdps(90):
            assert abs(mpmath.mpf(zero.mid().str(90, radius=False)) - mpmath.pi) < mpmath.mpf(10) ** -80
