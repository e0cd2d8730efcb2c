"""The next term of the number of pieces: its formula, the values measured, greedy splines, and refusals."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from flint import arb

from osculant.cas.asymptotics.short_arcs import arc_error
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.geometry.bitangent import ReferenceCurve
from osculant.cas.geometry.greedy import greedy_knots
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.laws.next_term import curvatures, density_terms, next_constant, next_density
from osculant.cas.numbers.balls import PRECISION, constant, precision
from osculant.cas.numbers.quadrature import integral

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
ORDERS = {"parabola": 4, "conic": 5}


def number(ball):
    return mpmath.mpf(ball.str(30, radius=False))


def following(primitive, text, low, high):
    with precision(PRECISION):
        ends = [constant(parse_constant(end)) for end in (low, high)]
    return number(next_constant(CurveBalls(parse_tuple(text)), primitive, *ends)[0])


@pytest.mark.parametrize(("primitive", "known"), [("parabola", 0.3672), ("conic", 0.4468)])
def test_measured_values(primitive, known):
    assert abs(following(primitive, *SPIRAL) - known) < 5e-5


def test_deep_greedy_counts():
    """The fractional counts of the spiral at 30 digits: conics at 1e-9, …, 1e-12."""
    with precision(PRECISION):
        ends = arb.pi() / 6, 2 * arb.pi()
    leading = number(complexity_constant(CurveBalls(parse_tuple(SPIRAL[0])), "conic", *ends)[0])
    c1 = following("conic", *SPIRAL)
    for digits, count in ((9, "80.113"), (10, "126.963"), (11, "201.219"), (12, "318.908")):
        unit = mpmath.mpf(10) ** (-mpmath.mpf(digits) / 5)
        assert abs(leading / unit + c1 * unit - mpmath.mpf(count)) < 6e-4


@pytest.mark.parametrize("primitive", ORDERS)
def test_density_solves_both_conditions(primitive):
    """Numerically: with ρ from the terms, content and error of an arc hold to the next order."""
    order = ORDERS[primitive]
    leading, rho1 = density_terms(order)
    (a,) = rho1.atoms(sp.Function("a"))
    (s,) = a.args
    e0 = (2 + sp.sin(s)) ** order
    e2 = sp.cos(s) + 3
    shape = 1 / (2 + sp.sin(s))
    inserted = rho1.subs({sp.Symbol("e0"): e0, sp.Symbol("e2"): e2}).subs(a, shape).doit()
    rho0 = leading.subs(a, shape)
    rests = []
    with mpmath.workdps(40):
        density = sp.lambdify(
            (s, sp.Symbol("unit")), rho0 / sp.Symbol("unit") + sp.Symbol("unit") * inserted, "mpmath"
        )
        error = sp.lambdify((s, sp.Symbol("h")), e0 + e2 * sp.Symbol("h") ** 2, "mpmath")
        middle = mpmath.mpf("0.7")
        for unit in (mpmath.mpf(1) / 32, mpmath.mpf(1) / 64):  # ε^{1/p}
            h = mpmath.findroot(
                lambda h, unit=unit: h * mpmath.root(error(middle, h), order) - unit, unit / 2
            )
            content = mpmath.quad(lambda t, unit=unit: density(t, unit), [middle - h / 2, middle + h / 2])
            rests.append(content - 1)
    assert abs(rests[0] / rests[1] / 16 - 1) < 0.05  # O(ε^{4/p})


@pytest.mark.parametrize(
    ("primitive", "text", "low", "tolerance", "guess", "count"),
    [
        ("parabola", SPIRAL[0], "pi/6", "1e-5", "0.12", 4),
        ("parabola", "t, exp(t)", "0", "1e-6", "0.1", 4),
        ("conic", SPIRAL[0], "pi/6", "1e-6", "0.25", 3),
        ("conic", "t, exp(t)", "1/2", "1e-8", "0.3", 3),
    ],
)
def test_greedy_splines(primitive, text, low, tolerance, guess, count):
    """n − Cε^{−1/p} − c₁ε^{1/p} at the n-th knot falls by 8 for ε/2ᵖ and 2n: it is O(ε^{3/p})."""
    order, rests = ORDERS[primitive], []
    curve = CurveBalls(parse_tuple(text))
    with precision(PRECISION):
        start = constant(parse_constant(low))
    with mpmath.workdps(25):
        for factor in (1, 2):
            eps = mpmath.mpf(tolerance) / factor**order
            knots = greedy_knots(
                ReferenceCurve(text),
                primitive,
                number(start),
                eps,
                mpmath.mpf(guess) / factor,
                factor * count,
            )
            with precision(PRECISION):
                end = arb(mpmath.nstr(knots[-1], 25))
            unit = mpmath.root(eps, order)
            leading = number(complexity_constant(curve, primitive, start, end)[0]) / unit
            c1 = number(next_constant(curve, primitive, start, end)[0]) * unit
            assert abs(factor * count - leading - c1) < abs(c1) / 4
            rests.append(factor * count - leading - c1)
    assert 6 < rests[0] / rests[1] < 10


def test_circle_has_equal_parabolas():
    """On a circle all arcs are equal, and c₁ follows from the error of one, (cos a + 1/cos a)/2 − 1."""
    with mpmath.workdps(30):
        angle = mpmath.mpf(1)
        rate = following("parabola", "cos(t), sin(t)", "0", "1")
        for n in (40, 80):
            a = angle / n / 2
            unit = mpmath.root((mpmath.cos(a) + 1 / mpmath.cos(a)) / 2 - 1, 4)
            leading = angle * mpmath.root(mpmath.mpf(1) / 128, 4) / unit
            assert abs((n - leading) / unit - rate) < 2 * unit**2


@pytest.mark.parametrize("primitive", ORDERS)
def test_similarities_and_parameters(primitive):
    reference = following(primitive, "t*cos(t), t*sin(t)", "1", "3")
    for text, low, high in (
        ("t*cos(t + 1) - 5, t*sin(t + 1) + 10^6", "1", "3"),
        ("t*sin(t), t*cos(t)", "1", "3"),
        ("(4 - t)*cos(4 - t), (4 - t)*sin(4 - t)", "1", "3"),
        ("exp(t)*cos(exp(t)), exp(t)*sin(exp(t))", "0", "log(3)"),
    ):
        assert abs(following(primitive, text, low, high) / reference - 1) < 1e-15
    # a length like ε: N(ε) is the same for the curve and ε doubled, so c₁ has the weight −1/p
    doubled = following(primitive, "2*t*cos(t), 2*t*sin(t)", "1", "3")
    assert abs(doubled * mpmath.root(2, ORDERS[primitive]) / reference - 1) < 1e-15
    parts = following(primitive, *SPIRAL[:1], "1", "2") + following(primitive, *SPIRAL[:1], "2", "3")
    assert abs(parts / reference - 1) < 1e-15


def test_curvatures():
    """Against the invariants of the jet, which are written out by hand."""
    with precision(200):
        curve = CurveBalls(parse_tuple("t*cos(t), t^2 + exp(t)"))
        kappa, speed = curvatures(curve, arb("0.7"), 6)
        jet: PlaneJet = curve.jet(arb("0.7"), 4)
        for value, expected in zip(
            (speed, *kappa), (jet.speed, jet.curvature, jet.curvature_slope, jet.curvature_bend), strict=False
        ):
            assert value.overlaps(expected)
            assert value.rel_accuracy_bits() > 150


@pytest.mark.parametrize(
    ("primitive", "text", "low", "high", "what"),
    [
        ("conic", "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "0", "1", "sextactic"),
        ("conic", "2*cos(t), sin(t)", "1/10", "1", "sextactic"),  # an ellipse: dk/dr vanishes identically
        ("conic", "t, t^3", "0", "1", "curvature is 0"),
        ("parabola", "t, t^3", "-1", "1", "curvature is 0"),
        ("parabola", "t, t^2/2 + t^5", "0", "1/20", "affine curvature k is 0"),
        ("parabola", "t^2, t^3", "0", "1", "singular"),
    ],
)
def test_refusals(primitive, text, low, high, what):
    with pytest.raises(DomainError, match=what):
        following(primitive, text, low, high)


@pytest.mark.parametrize(
    ("primitive", "text", "low", "high", "says"),
    [
        ("conic", "t, t^2/2 + t^6", "0", "1/20", r"at t = 0: .* costs 0\.048366 .*\^\(-1/5\)"),
        ("conic", "t, (t - 1)^2/2 + (t - 1)^6", "19/20", "1", r"at t = 1: .* costs 0\.048366"),
        ("parabola", "t, t^2/2 + t^5", "0", "1/20", r"at t = 0: .* costs 0\.055030 .*\^\(-1/4\)"),
        (
            "parabola",
            "t, t^2/2 + t^5",
            "-1/20",
            "1/30",
            r"at or near t = [^:]*: take a stretch that [a-z ]*\.",
        ),
        ("conic", "t, t^3", "0", "1", r"at t = 0: take a stretch that [a-z ]*\."),
    ],
)
def test_refusals_name_the_end_and_its_cost(primitive, text, low, high, says):
    with pytest.raises(DomainError, match=says):
        following(primitive, text, low, high)


@pytest.mark.parametrize("order", [0, -3, 2.5])
def test_orders_of_no_arc(order):
    with pytest.raises(DomainError, match="positive whole order"):
        density_terms(order)


def test_other_refusals():
    with pytest.raises(DomainError, match="'biarc'"):
        following("biarc", *SPIRAL)
    with pytest.raises(DomainError, match="'biarc'"):
        greedy_knots(ReferenceCurve(SPIRAL[0]), "biarc", 1, 1, 1, 1)
    with pytest.raises(UndecidedError, match="take a smaller tolerance"):
        greedy_knots(ReferenceCurve("cos(t), sin(t)"), "parabola", 0, mpmath.mpf(1000), mpmath.mpf(1), 1)
    with precision(64), pytest.raises(UndecidedError, match="did not settle"):
        integral(lambda t: 1 / t, arb(0), arb(1))


def test_density_is_even_under_mirrors():
    with precision(100):
        kappa = [arb(3) / 2, arb(1) / 3, arb(-2) / 5, arb(1) / 7, arb(2), arb(-1)]
        for primitive in ORDERS:
            assert arc_error(primitive).order == ORDERS[primitive]
            value = next_density(primitive, kappa)
            assert value.overlaps(next_density(primitive, [-k for k in kappa]))
            assert value.overlaps(next_density(primitive, [k * (-1) ** n for n, k in enumerate(kappa)]))
