"""The leading constants of the area metric against printed digits, mpmath's quadrature and invariance."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.claims.chapter_3.areas import arc_factor
from osculant.cas.formulas.expression import ONE
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.formulas.sympy_bridge import from_sympy
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.arcs import arc_law
from osculant.cas.laws.complexity import complexity_constant, law_integral
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import PRECISION, constant, precision
from osculant.cas.numbers.quadrature import double_exponential
from tests.cas.constants import SEXTIC, SPIRAL, close, complexity


@pytest.mark.parametrize("bits", [53, 320])
def test_area_constants(bits):
    exact = [law_of(primitive, "area").constant().value for primitive in ("parabola", "conic")]
    assert exact == [Fraction(1, 240), Fraction(1, 7680)]
    with precision(bits):
        for primitive, inverse in (("parabola", 240), ("conic", 7680), ("biarc", 576)):
            c = law_of(primitive, "area").ball()
            assert c.contains(arb(1) / inverse) and c.rel_accuracy_bits() > bits - 10
            assert not c.overlaps(arb(1) / (inverse + 1))


def test_area_constants_by_the_curve_itself():
    """(x² − 1)² and x(x² − 1)² times the factors of k and dk/dr, over the arc of length 2, absolute."""
    x = sp.Symbol("x", real=True)
    for order, primitive, shape in ((5, "parabola", (x**2 - 1) ** 2), (6, "conic", x * (x**2 - 1) ** 2)):
        lobe = 2 * sp.integrate(sp.expand(shape), (x, 0, 1)) * sp.Rational(1, {5: 8, 6: 40}[order])
        assert lobe / 2**order == sp.Rational(law_of(primitive, "area").constant().value)


@pytest.mark.parametrize(
    ("primitive", "curve", "printed"),
    [
        ("parabola", SPIRAL, "4.58989272897455017"),
        ("parabola", SEXTIC, "1.67934089089600706"),
        ("conic", SPIRAL, "2.03777820080992568"),
        ("conic", SEXTIC, "0.708049754584166635"),
    ],
)
def test_printed_constants_of_areas(primitive, curve, printed):
    """(3.25) and (3.26): all 18 digits."""
    assert mpmath.nstr(complexity(primitive, *curve, "area"), 18) == printed


def spiral_area_integrand(primitive):
    """By affine arc length, dr/dt = (t² + 2)^{1/3}; of biarcs by arc length."""
    t = sp.Symbol("t", positive=True)
    k, phi = (9 * t**4 + 58 * t**2 + 120) / (9 * (t**2 + 2) ** sp.Rational(8, 3)), sp.cbrt(t**2 + 2)
    speed = sp.sqrt(t**2 + 1)
    bend = sp.diff((t**2 + 2) / speed**3, t) / speed
    density = {
        "parabola": (abs(k) / 240) ** sp.Rational(1, 5) * phi,
        "conic": (abs(sp.diff(k, t) / phi) / 7680) ** sp.Rational(1, 6) * phi,
        "biarc": (abs(bend) / 576) ** sp.Rational(1, 4) * speed,
    }[primitive]
    return sp.lambdify(t, density, "mpmath")


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
@pytest.mark.parametrize(("low", "high"), [("pi/6", "2*pi"), ("1/100", "1/50"), ("1", "20")])
def test_spiral_areas_by_quadrature(primitive, low, high):
    order = law_of(primitive, "area").order
    with mpmath.workdps(40):
        ends = [mpmath.mpf(sp.N(sp.sympify(end), 40)) for end in (low, high)]
        content = mpmath.quad(spiral_area_integrand(primitive), mpmath.linspace(*ends, 9))
        expected = mpmath.root(content**order, order - 1)
        found = complexity(primitive, SPIRAL[0], low, high, "area")
        assert close(found, expected, 19)
        assert not close(found, content, 2)


def test_areas_of_the_cubic_from_its_inflection():
    """y = x³: k ∝ x^{−8/3}, dk/dr = 20/(81x⁴) and dr = (6x)^{1/3}dx, so both contents are powers of x."""
    with mpmath.workdps(40):
        root, x = mpmath.root, mpmath.mpf("0.7")
        parabola = root(mpmath.mpf(5) / 9 / 6 ** (mpmath.mpf(2) / 3) / 240, 5) * mpmath.cbrt(6) * 5 / 4
        conic = root(mpmath.mpf(20) / 81 / 7680, 6) * mpmath.cbrt(6) * 3 / 2
        expected = {"parabola": root((parabola * x ** (4 / mpmath.mpf(5))) ** 5, 4)}
        expected["conic"] = root((conic * mpmath.cbrt(x) ** 2) ** 6, 5)
        for primitive, value in expected.items():
            assert close(complexity(primitive, "t, t^3", "0", "7/10", "area"), value, 18)
            assert close(complexity(primitive, "t, -t^3", "-7/10", "0", "area"), value, 18)


@given(st.sampled_from(["2", "1/3", "5/4"]), st.sampled_from(["0", "1", "-3/2"]))
@settings(max_examples=4, deadline=None)
def test_areas_of_affine_images(stretch, shear):
    """(3.25), (3.26) are equi-affine; under a map of determinant D areas are D-fold, and so is ε."""
    x, y = "t*cos(t)", "t*sin(t)"
    same = f"{stretch}*({x}) + ({shear})*({y}), ({y})/({stretch})"
    triple = f"3*{stretch}*({x}) + 3*({shear})*({y}), ({y})/({stretch})"
    for primitive in ("parabola", "conic"):
        reference = complexity(primitive, f"{x}, {y}", "1", "2", "area")
        assert close(complexity(primitive, same, "1", "2", "area"), reference, 17)
        with mpmath.workdps(40):
            factor = mpmath.root(3, law_of(primitive, "area").order - 1)
            assert close(complexity(primitive, triple, "1", "2", "area"), reference * factor, 17)


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
def test_areas_add_by_content(primitive):
    """C^{q/p} adds, C does not; a curve λ times as large has λ²-fold areas."""
    q = law_of(primitive, "area").order - 1
    with mpmath.workdps(40):
        power = mpmath.mpf(q) / (q + 1)
        whole = complexity(primitive, *SPIRAL, "area")
        parts = [
            complexity(primitive, SPIRAL[0], *part, "area")
            for part in (("pi/6", "2"), ("2", "2.0001"), ("2.0001", "2*pi"))
        ]
        assert close(sum(c**power for c in parts), whole**power, 18)
        assert not close(sum(parts), whole, 2)
        scaled = complexity(primitive, "10^(-6)*t*cos(t), 10^(-6)*t*sin(t)", *SPIRAL[1:], "area")
        assert close(scaled, whole * mpmath.root(mpmath.mpf(10) ** -12, q), 18)


def test_areas_of_what_is_exact():
    with precision(PRECISION):
        for primitive, text in (("conic", "3*cos(t), sin(t)"), ("parabola", "t, t^2")):
            balls = CurveBalls(parse_tuple(text))
            value, _ = complexity_constant(balls, primitive, arb(0), arb(1), "area")
            assert abs(value) < 1e-15


def test_the_claims_of_section_3_6_derive_the_same():
    """There the areas of γ and of the approximation are expanded; here the displacement's shape."""
    for primitive in ("parabola", "conic"):
        assert sp.Rational(law_of(primitive, "area").constant().value) == arc_factor(primitive)
    curve = CurveBalls(parse_tuple(SPIRAL[0]))
    with precision(PRECISION):
        ends = arb(1), arb(2)
        scale = constant(from_sympy(arc_law("biarc", "area").count_constant(1)))
        law = replace(law_of("biarc", "area"), constant=lambda: ONE)
        value = scale * law_integral(curve, law, *ends)[0]
    assert abs(value - complexity_constant(curve, "biarc", *ends, "area")[0]) < 1e-18


def test_agreement_by_chance_does_not_end_the_quadrature():
    """(|k|/240)^{1/5} dr on [1, 20]: the second and the third step differ by 1e-10, the error is 1e-13."""
    with precision(PRECISION):
        curve, c = CurveBalls(parse_tuple(SPIRAL[0])), law_of("parabola", "area").ball()
        law = law_of("parabola", "area")
        value, change = double_exponential(lambda t: law.density(curve.jet(t, 4), c).mid(), arb(1), arb(20))
    with mpmath.workdps(40):
        exact = mpmath.quad(spiral_area_integrand("parabola"), mpmath.linspace(1, 20, 20))
        assert abs(mpmath.mpf(value.mid().str(40, radius=False)) - exact) < change**2 + 1e-22
