"""Leading constants and complexity integrals against printed digits, mpmath's quadrature and invariance."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.errors import UndecidedError
from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.geometry.pencil import lobe_shape
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.laws.conics import canonical_coefficients
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import PRECISION, constant, precision
from osculant.cas.numbers.quadrature import double_exponential, nodes
from tests.cas.constants import SEXTIC, SPIRAL, close, complexity

# Constants of one short arc.


def test_canonical_coefficients():
    assert canonical_coefficients() == (Fraction(1, 8), Fraction(1, 40))


@pytest.mark.parametrize("bits", [53, 320, 1000])
def test_error_constants(bits):
    with precision(bits):
        parabola, conic = law_of("parabola").ball(), law_of("conic").ball()
        assert parabola.contains(arb(1) / 128)
        assert conic.overlaps(1 / (2000 * arb(5).sqrt()))
        for c in (parabola, conic):
            assert c.rel_accuracy_bits() > bits - 20
        assert not conic.overlaps(1 / (2000 * arb(5)))


def test_error_constant_of_a_parabola_by_hand():
    """The parabola that touches y = x²/2 + kx⁴/8 at ±h is off by kh⁴/8 = k(2h)⁴/128 at 0."""
    x, h, k, a, b = sp.symbols("x h k a b")
    curve, parabola = x**2 / 2 + k * x**4 / 8, a * x**2 + b
    touching = [(curve - parabola).subs(x, h), sp.diff(curve - parabola, x).subs(x, h)]
    [member] = sp.solve(touching, [a, b], dict=True)
    assert sp.expand(-member[b] - k * (2 * h) ** 4 / 128) == 0
    assert sp.expand(-member[b] - k * (2 * h) ** 4 / 64) != 0


def test_error_constant_of_a_conic_by_its_lobes():
    """x⁵/40 less a quartic: with double zeros at ±h the remainder is x(x² − h²)²/40."""
    x = sp.Symbol("x")
    peaks = [abs(x * (x**2 - 1) ** 2 / 40).subs(x, p) for p in sp.solve(sp.diff(x * (x**2 - 1) ** 2, x), x)]
    assert sp.simplify(max(peaks) - sp.Rational(2**5, 2000) / sp.sqrt(5)) == 0
    shape, s = lobe_shape(1)
    assert sp.expand(32 * shape.subs(s, (x + 1) / 2) - x * (x**2 - 1) ** 2) == 0


# The integrals.


@pytest.mark.parametrize(
    ("primitive", "curve", "printed"),
    [
        ("parabola", SPIRAL, "2.56677413266675333"),
        ("parabola", SEXTIC, "1.18187030003858798"),
        ("conic", SPIRAL, "1.26959011703699553"),
        ("conic", SEXTIC, "0.529300817502150973"),
    ],
)
def test_printed_constants(primitive, curve, printed):
    """(3.17) and (3.18): all 18 digits, and not one more or less in the last."""
    value = complexity(primitive, *curve)
    assert mpmath.nstr(value, 18) == printed


def spiral_integrand(primitive, slope_by=lambda kappa, phi, speed: phi):
    """The integrand of the spiral from its printed κ and k; dk/dr is k′(t)/φ."""
    t = sp.Symbol("t", positive=True)
    k = (9 * t**4 + 58 * t**2 + 120) / (9 * (t**2 + 2) ** sp.Rational(8, 3))
    kappa, speed = (t**2 + 2) / (t**2 + 1) ** sp.Rational(3, 2), sp.sqrt(t**2 + 1)
    slope = sp.diff(k, t) / slope_by(kappa, sp.cbrt(t**2 + 2), speed)
    if primitive == "biarc":
        density = (abs(sp.diff(kappa, t)) / speed / 324) ** sp.Rational(1, 3) * speed
    elif primitive == "parabola":
        density = (abs(k) * kappa ** sp.Rational(5, 3) / 128) ** sp.Rational(1, 4) * speed
    else:
        density = (abs(slope) * kappa**2 / (2000 * sp.sqrt(5))) ** sp.Rational(1, 5) * speed
    return sp.lambdify(t, density, "mpmath")


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
@pytest.mark.parametrize(("low", "high"), [("pi/6", "2*pi"), ("1/100", "1/50"), ("1", "20")])
def test_spiral_by_quadrature(primitive, low, high):
    with mpmath.workdps(40):
        ends = [mpmath.mpf(sp.N(sp.sympify(end), 40)) for end in (low, high)]
        expected = mpmath.quad(spiral_integrand(primitive), mpmath.linspace(*ends, 9))
        assert close(complexity(primitive, SPIRAL[0], low, high), expected, 19)


def test_the_slope_is_by_affine_arc_length():
    """The thesis prints k′(s), with which the constant would be another one (erratum)."""
    with mpmath.workdps(30):
        wrong = mpmath.quad(
            spiral_integrand("conic", lambda kappa, phi, speed: speed),
            [mpmath.pi / 6, mpmath.pi, 2 * mpmath.pi],
        )
        assert not close(wrong, complexity("conic", *SPIRAL), 2)


@given(st.floats(0.2, 1.5), st.floats(-1, 1), st.floats(-1, 1))
@settings(max_examples=5, deadline=None)
def test_graphs_by_quadrature(scale, cubic, wave):
    """y″ = u: k = −(u^{−2/3})″/2 and dk/dr = −(u^{−2/3})‴/(2u^{1/3}), κ = u/(1 + y′²)^{3/2}."""
    a, b, c = (Fraction(x).limit_denominator(50) for x in (scale, cubic, wave))
    t = sp.Symbol("t", real=True)
    y = 2 * t**2 + sp.Rational(b) * t**3 / 12 + sp.Rational(c) * sp.sin(sp.Rational(a) * t)
    u = sp.diff(y, t, 2)
    k, slope = (-sp.diff(u ** sp.Rational(-2, 3), t, n) / 2 for n in (2, 3))
    kappa, speed = u / (1 + sp.diff(y, t) ** 2) ** sp.Rational(3, 2), sp.sqrt(1 + sp.diff(y, t) ** 2)
    parabola = (abs(k) * kappa ** sp.Rational(5, 3) / 128) ** sp.Rational(1, 4) * speed
    conic = (abs(slope) / sp.cbrt(u) * kappa**2 / (2000 * sp.sqrt(5))) ** sp.Rational(1, 5) * speed
    for primitive, density, factor in (("parabola", parabola, k), ("conic", conic, slope)):
        density, factor = (sp.lambdify(t, e, "mpmath") for e in (density, factor))
        # next to a zero of k or dk/dr neither quadrature would be fast: take a short interval clear of them
        with mpmath.workdps(30):
            values = [density(mpmath.mpf(x) / 100) for x in range(50, 61)]
            signs = {mpmath.sign(factor(mpmath.mpf(x) / 100)) for x in range(50, 61)}
            if min(values) > 0.4 * max(values) and len(signs) == 1:
                expected = mpmath.quad(density, mpmath.linspace(mpmath.mpf("0.5"), mpmath.mpf("0.6"), 5))
                text = f"t, {y}".replace("**", "^")
                assert close(complexity(primitive, text, "1/2", "3/5"), expected, 9)


# Ends at special points.


def test_cubic_from_its_inflection():
    """y = x³ on [0, 1]: dk/dr = 20/(81x⁴), so the integrand is a constant times x^{−2/5}(1 + 9x⁴)^{−1/10}."""
    with mpmath.workdps(40):
        root = 2000 * mpmath.sqrt(5)
        factor = (mpmath.mpf(20) / 81 * 36 / root) ** (mpmath.mpf(1) / 5)
        exponents = mpmath.mpf(1) / 10, mpmath.mpf(3) / 20, mpmath.mpf(23) / 20
        expected = factor / mpmath.mpf("0.6") * mpmath.hyp2f1(*exponents, -9)
        assert close(complexity("conic", "t, t^3", "0", "1"), expected, 18)
        # the same from the other side, mirrored, and with another parameter
        for text, low, high in (
            ("t, t^3", "-1", "0"),
            ("t, -t^3", "0", "1"),
            ("sin(t), sin(t)^3", "0", "pi/2"),
        ):
            assert close(complexity("conic", text, low, high), expected, 17)
        pieces = [mpmath.ceil(expected * mpmath.mpf(10) ** (mpmath.mpf(n) / 5)) for n in (3, 6, 9)]
        assert pieces == [2, 8, 29]  # per side, as known


def test_cubic_as_parabolas():
    """k = −(u^{−2/3})″/2 with u = 6x: the integrand is a constant times x^{−1/4}(1 + 9x⁴)^{−1/8}."""
    with mpmath.workdps(40):
        k = mpmath.mpf(5) / 9 * mpmath.mpf(6) ** (-mpmath.mpf(2) / 3)
        factor = (k * mpmath.mpf(6) ** (mpmath.mpf(5) / 3) / 128) ** (mpmath.mpf(1) / 4)
        quarter = mpmath.mpf(1) / 4
        exponents = quarter / 2, 3 * quarter / 4, 1 + 3 * quarter / 4
        expected = factor / (1 - quarter) * mpmath.hyp2f1(*exponents, -9)
        assert close(complexity("parabola", "t, t^3", "0", "1"), expected, 18)


def test_semicubical_cusp():
    """(t², t³) on [0, 1]: an integrand like t^{−2/5} and one like t^{−1/4}, as graphs of x^{3/2}."""
    t = sp.Symbol("t", positive=True)
    y = t ** sp.Rational(3, 2)  # the graph over x = t²
    u = sp.diff(y, t, 2)
    speed = sp.sqrt(1 + sp.diff(y, t) ** 2)
    kappa = u / speed**3
    k, slope = (sp.simplify(-sp.diff(u ** sp.Rational(-2, 3), t, n) / 2) for n in (2, 3))
    assert k != 0
    densities = {
        "parabola": (abs(k) * kappa ** sp.Rational(5, 3) / 128) ** sp.Rational(1, 4) * speed,
        "conic": (abs(slope) / sp.cbrt(u) * kappa**2 / (2000 * sp.sqrt(5))) ** sp.Rational(1, 5) * speed,
    }
    for primitive, density in densities.items():
        integrand = sp.simplify(density.subs(t, t**2) * 2 * t)  # back to the parameter of (t², t³)
        with mpmath.workdps(40):
            expected = mpmath.quad(sp.lambdify(t, integrand, "mpmath"), [0, 0.01, 0.2, 1])
            assert close(complexity(primitive, "t^2, t^3", "0", "1"), expected, 17)


def test_a_sextactic_end_costs_no_digits():
    with mpmath.workdps(40):
        both = complexity("conic", SEXTIC[0], "0", "1") + complexity("conic", SEXTIC[0], "1", "3*pi/4")
    assert close(both, complexity("conic", *SEXTIC), 18)
    assert close(complexity("conic", SEXTIC[0], "-3*pi/4", "0"), complexity("conic", *SEXTIC), 19)


def test_special_points_inside_are_not_got_wrong():
    """The function is meant for stretches between them: a zero inside costs time, a pole is an error."""
    whole = complexity("conic", SEXTIC[0], "-1", "3*pi/4")
    parts = complexity("conic", SEXTIC[0], "0", "3*pi/4") + complexity("conic", SEXTIC[0], "0", "1")
    assert close(whole, parts, 9)
    with pytest.raises(UndecidedError, match=r"near t = .*: split there"):
        complexity("conic", "t, t^3", "-1", "7/10")


def test_conics_and_parabolas_need_nothing():
    with precision(PRECISION):
        for primitive, text in (("conic", "3*cos(t), sin(t)"), ("parabola", "t, t^2"), ("conic", "t, t^2")):
            value, _ = complexity_constant(CurveBalls(parse_tuple(text)), primitive, arb(0), arb(1))
            assert abs(value) < 1e-15


# Invariance.


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
def test_similarities_and_parameters(primitive):
    reference = complexity(primitive, "t*cos(t), t*sin(t)", "1", "3")
    same = [
        ("t*cos(t + 1) - 5, t*sin(t + 1) + 10^6", "1", "3"),
        ("t*sin(t), t*cos(t)", "1", "3"),
        ("-t*cos(t), t*sin(t)", "-3", "-1"),
        ("(4 - t)*cos(4 - t), (4 - t)*sin(4 - t)", "1", "3"),
        ("exp(t)*cos(exp(t)), exp(t)*sin(exp(t))", "0", "log(3)"),
    ]
    for curve in same:
        assert close(complexity(primitive, *curve), reference, 18)
    with mpmath.workdps(40):
        root = mpmath.mpf(1) / law_of(primitive).order
        for scale in ("10^6", "10^(-6)", "3"):
            scaled = complexity(primitive, f"{scale}*t*cos(t), {scale}*t*sin(t)", "1", "3")
            factor = mpmath.mpf(sp.N(sp.sympify(scale.replace("^", "**")), 40)) ** root
            assert close(scaled, reference * factor, 18)
    assert not close(complexity(primitive, "t*cos(t), t*sin(t)", "1", "3.0001"), reference, 5)


@given(st.sampled_from(["2", "1/3", "5/4"]), st.sampled_from(["0", "1", "-3/2"]))
@settings(max_examples=6, deadline=None)
def test_equi_affine_maps(stretch, shear):
    """k, dk/dr and r stay: C = ∫(c|dk/dr|)^{1/5} κ^{1/15} dr, where only κ is the image's own.

    For the spiral under x ↦ (px + qy, y/p), in the preimage's affine arc length.
    """
    p, q = (sp.Rational(x) for x in (stretch, shear))
    t = sp.Symbol("t", positive=True)
    x, y = p * t * sp.cos(t) + q * t * sp.sin(t), t * sp.sin(t) / p
    phi = sp.cbrt(t**2 + 2)
    k = (9 * t**4 + 58 * t**2 + 120) / (9 * (t**2 + 2) ** sp.Rational(8, 3))
    kappa = (t**2 + 2) / (sp.diff(x, t) ** 2 + sp.diff(y, t) ** 2) ** sp.Rational(3, 2)
    laws = {
        "parabola": (abs(k) / 128) ** sp.Rational(1, 4) * kappa ** sp.Rational(1, 12) * phi,
        "conic": (abs(sp.diff(k, t)) / phi / (2000 * sp.sqrt(5))) ** sp.Rational(1, 5)
        * kappa ** sp.Rational(1, 15)
        * phi,
    }
    text = f"{x}, {y}".replace("**", "^")
    for primitive, density in laws.items():
        with mpmath.workdps(30):
            expected = mpmath.quad(sp.lambdify(t, density, "mpmath"), mpmath.linspace(1, 2, 5))
            assert close(complexity(primitive, text, "1", "2"), expected, 16)


def test_the_constant_is_additive():
    whole = complexity("parabola", *SPIRAL)
    parts = [("pi/6", "2"), ("2", "2.0001"), ("2.0001", "2*pi")]
    with mpmath.workdps(40):
        assert close(sum(complexity("parabola", SPIRAL[0], *part) for part in parts), whole, 18)


# The quadrature.


@pytest.mark.parametrize(
    ("density", "exact", "digits"),
    [
        (lambda t: t * 0 + 1, "1", 28),
        (lambda t: t**5, "1/6", 28),
        (lambda t: 1 / t.root(5) ** 2, "5/3", 18),
        (lambda t: (1 - t).root(5), "5/6", 28),
        (lambda t: t.log(), "-1", 28),
        (lambda t: 1 / (1 + t * t), "pi/4", 28),
    ],
)
def test_double_exponential(density, exact, digits):
    with precision(PRECISION):
        value, change = double_exponential(density, arb(0), arb(1))
        expected = constant(parse_constant(exact))
        assert abs(value - expected) < arb(10) ** -digits * abs(expected)
        assert change < 1e-10
        shifted, _ = double_exponential(lambda t: density((t - 3) / 2), arb(3), arb(5))
        assert abs(shifted - 2 * expected) < arb(10) ** -digits * 4


def test_a_rough_integrand_shows_in_the_change():
    with precision(PRECISION):
        _, change = double_exponential(lambda t: abs(t - arb(1) / 3).root(5), arb(0), arb(1))
    assert change > 1e-10


def test_nodes():
    with precision(PRECISION):
        seen = [near for level in range(2, 6) for near, _ in nodes(level)]
        assert len({near.str(60) for near in seen}) == len(seen)  # a finer step adds new ones only
        assert all(near > 0 and near < 0.500001 for near in seen)


def test_laws():
    """The densities at a jet of which everything is known: the spiral at t = 2 in plain mpmath numbers."""
    with precision(PRECISION):
        jet = CurveBalls(parse_tuple(SPIRAL[0])).jet(arb(2), 5)
        for primitive in ("parabola", "conic", "biarc"):
            law = law_of(primitive)
            density = law.density(jet, law.ball())
            with mpmath.workdps(40):
                expected = spiral_integrand(primitive)(mpmath.mpf(2))
                assert close(mpmath.mpf(density.mid().str(40, radius=False)), expected, 35)
        nothing = replace(law, invariant=lambda _: arb(0))
        assert nothing.density(jet, arb(1)) == 0
