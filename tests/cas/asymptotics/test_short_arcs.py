"""The error series of short arcs against the geometry to many digits, and against closed cases."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.asymptotics.arc_displacement import KAPPA, displacement, optimal_pencil
from osculant.cas.asymptotics.optimal_conic import mean_end_curvature, optimal_curvature
from osculant.cas.asymptotics.short_arcs import arc_error, height_series, peak_height
from osculant.cas.errors import DomainError
from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.derivations import affine
from osculant.cas.jets.derivations.plane import equal
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.next_term import curvatures
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import precision

ORDERS = {"parabola": 4, "conic": 5}
#: a graph x ↦ (x, y(x)) with generic derivatives, and curves in other parameters
CURVES = ("t*cos(t), t*sin(t)", "t, exp(t) + t^3/3", "cos(t) + t^2/9, 2*sin(t)", "t*sin(t), t*cos(t)")


def measured(text, primitive, middle, length):
    """The Hausdorff distance of the arc of Euclidean length ``length`` about a parameter, by the geometry."""
    curve = ReferenceCurve(text)

    def speed(t):
        return curve.frame(t).speed

    def end(direction):
        def rest(t):
            return direction * mpmath.quad(speed, [middle, t]) - length / 2

        return mpmath.findroot(rest, middle + direction * length / 2 / speed(middle))

    pencil = BitangentPencil(curve, end(-1), end(1))
    return pencil.hausdorff(pencil.parabola if primitive == "parabola" else pencil.best())


def series_at(text, primitive, t):
    with precision(300):
        kappa, _ = curvatures(CurveBalls(parse_tuple(text)), arb(str(t)), 6)
        values = arc_error(primitive).at(kappa, lambda n: arb(n).sqrt())
        return [mpmath.mpf(v.str(45, radius=False)) for v in values]


@pytest.mark.parametrize("primitive", ORDERS)
@pytest.mark.parametrize("text", CURVES)
def test_series_against_geometry(primitive, text):
    """E/hᵖ − e₀ − e₂h² is O(h⁴): it falls by 16 when h is halved."""
    with mpmath.workdps(40):
        e0, e2 = series_at(text, primitive, "0.8125")
        rests = []
        for h in (mpmath.mpf(1) / 16, mpmath.mpf(1) / 32):
            error = measured(text, primitive, mpmath.mpf("0.8125"), h) / h ** ORDERS[primitive]
            assert abs((error - e0) / h**2 / e2 - 1) < 0.2
            rests.append(error - e0 - e2 * h * h)
        assert abs(rests[0] / rests[1] / 16 - 1) < 0.1


@given(
    st.lists(st.integers(-12, 12).map(lambda n: n / 8), min_size=4, max_size=4),
    st.sampled_from(sorted(ORDERS)),
)
@settings(max_examples=5, deadline=None)
def test_series_on_random_graphs(coefficients, primitive):
    """y = x² + generic terms: the second term of the series, measured, agrees to the next order."""
    terms = "".join(f" + ({c})*t^{n}" for n, c in enumerate(coefficients, 3))
    text = f"t, t^2{terms}"
    with mpmath.workdps(40):
        e0, e2 = series_at(text, primitive, "0")
        if e0 < 0.01:  # near a zero of k or dk/dr the series needs shorter arcs than these
            return
        h = mpmath.mpf(1) / 1024
        error = measured(text, primitive, mpmath.mpf(0), h) / h ** ORDERS[primitive]
        assert abs((error - e0) / h**2 - e2) < mpmath.mpf("1e-3") * (1 + abs(e2)) * (1 + 1 / e0**3)


def test_leading_terms_are_those_of_the_theorem():
    """e₀ is the error constant times k κ^{5/3} or dk/dr κ², both rational in κ, κ₁ and so on."""
    kappa, *rest = KAPPA
    unit = sp.Symbol("unit")
    x, y = (0, 1, 0, -(kappa**2), -3 * kappa * rest[0]), (0, 0, kappa, rest[0], rest[1] - kappa**3)
    last = (
        -3 * rest[0] ** 2 - 4 * kappa * rest[1] + kappa**4,
        rest[2] - 6 * kappa**2 * rest[0],
    )
    jet = PlaneJet((*x, last[0]), (*y, last[1]), root=lambda value, degree: unit)
    expected = {
        "parabola": jet.parabolic_form / (9 * kappa) / 128,
        "conic": jet.affine_curvature_slope * kappa**2 / 2000 / 5,
    }
    for primitive, form in expected.items():
        assert sp.cancel(arc_error(primitive).leading - form) == 0
    with precision(200):
        assert law_of("conic").ball().overlaps(arb(5).sqrt() / 10000)


def test_the_affine_curvature_used_is_the_derived_one():
    """(9κ⁴ + 3κκ₂ − 5κ₁²)/(9κ^{8/3}) of e₀ is k: at φ³ = κv³ in the algebra of jets."""
    leading = arc_error("parabola").leading.subs(
        dict(zip(KAPPA, (affine.curvature(n) for n in range(3)), strict=False)), simultaneous=True
    )
    assert equal(128 * leading * affine.v**5, affine.affine_curvature() * affine.phi**5)


def test_circles():
    """For a circle the parabola's error is known: k = κ^{4/3}, and conics have no error at all."""
    for radius in (mpmath.mpf(1), mpmath.mpf(3)):
        kappa = [1 / radius] + [mpmath.mpf(0)] * 5
        e0, e2 = arc_error("parabola").at(kappa, mpmath.sqrt)
        with mpmath.workdps(40):
            # half angle a: ends at ±sin a, apex of the parabola at the height (cos a + 1/cos a)/2
            h = mpmath.mpf(1) / 1000
            a = h / 2 / radius
            exact = radius * ((mpmath.cos(a) + 1 / mpmath.cos(a)) / 2 - 1)
            assert abs(exact / h**4 - e0 - e2 * h**2) < h**4
    assert arc_error("conic").leading.subs(dict.fromkeys(KAPPA[1:], 0)) == 0


def test_weights_and_reversal():
    """Lengths scale; a mirror image and the reversed curve have the same error."""
    mpf = mpmath.mpf
    kappa = [mpf(3) / 2, mpf(1) / 3, mpf(-2) / 5, mpf(1) / 7, mpf(2), mpf(-1)]
    for primitive, order in ORDERS.items():
        law = arc_error(primitive)
        e0, e2 = law.at(kappa, mpmath.sqrt)
        scaled = law.at([k * mpf(2) ** -(n + 1) for n, k in enumerate(kappa)], mpmath.sqrt)
        assert mpmath.almosteq(scaled[0], e0 * mpf(2) ** (1 - order))
        assert mpmath.almosteq(scaled[1], e2 * mpf(2) ** (-1 - order))
        for other in ([-k for k in kappa], [(-1) ** n * k for n, k in enumerate(kappa)]):
            assert law.at(other, mpmath.sqrt) == pytest.approx((e0, e2))


def test_symmetry_comes_out():
    assert height_series("parabola")[2][1] == 0
    assert height_series("conic")[2][1] == 0
    assert optimal_pencil()[3] == 0
    for primitive, order in ORDERS.items():
        parts = displacement(primitive)
        assert not any(c for part in parts[:order] for c in part)
        for part in parts[order:]:  # double zeros at both ends
            assert sum(part) == 0
            assert sum(n * c for n, c in enumerate(part)) == 0
            assert sum((-1) ** n * c for n, c in enumerate(part)) == 0


def test_peak_height():
    """1 − z² + H z peaks at 1 + H²/4, near another place with its sign; a flat top has no peak."""
    height = peak_height([[sp.Rational(1), 0, -1], [0, sp.Rational(1)], [sp.Rational(3)]], 0)
    assert height.coefficients == (1, 0, sp.Rational(13, 4))
    with pytest.raises(DomainError, match="singular"):
        peak_height([[sp.Rational(1)], [0, sp.Rational(1)]], 0)


def test_curvature_of_the_optimal_conic():
    """The mean of the end values to O(h²), and that order as the geometry has it."""
    difference = optimal_curvature() - mean_end_curvature()
    assert difference[0] == 0 and difference[1] == 0 and difference[2] != 0


def test_bad_input():
    with pytest.raises(DomainError, match="'line'"):
        arc_error("line")
    with pytest.raises(DomainError, match="needs the curvature and 5 derivatives"):
        arc_error("conic").at([mpmath.mpf(1)] * 5, mpmath.sqrt)
