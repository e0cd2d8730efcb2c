"""Contents in doubles against the same integrals in balls, and against closed forms."""

import math

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.complexity import complexity_constant
from osculant.cas.laws.table import law_of
from osculant.cas.numbers.balls import PRECISION, precision
from osculant.kernels.biarcs.records import Biarc, EquisymmetricBiarc
from osculant.kernels.conics.records import (
    Conic,
    EquisymmetricConic,
    LeastAreaConic,
    Parabola,
    ParabolaArea,
)
from osculant.kernels.cubics.records import Cubic, CubicArea
from osculant.kernels.polygons.records import Chord, ChordArea
from osculant.kernels.quadrature import contents, predicted
from tests.kernels.arcs import PLANE, jet_of, name_of

LAWS = {
    Parabola: ("parabola", "hausdorff"),
    Conic: ("conic", "hausdorff"),
    Biarc: ("biarc", "hausdorff"),
    ParabolaArea: ("parabola", "area"),
    EquisymmetricConic: ("conic", "area"),
    LeastAreaConic: ("conic", "area"),
    EquisymmetricBiarc: ("biarc", "area"),
    Chord: ("polygon", "hausdorff"),
    ChordArea: ("polygon", "area"),
    Cubic: ("cubic", "hausdorff"),
    CubicArea: ("cubic", "area"),
}
ALL = pytest.mark.parametrize("fit", PLANE, ids=name_of)
SPIRAL = "t*cos(t), t*sin(t)"
JETS = {text: jet_of(text, 5) for text in (SPIRAL, "t, t^3", "t^2, t^3", "3*cos(t), sin(t)")}
LONGER = {text: jet_of(text, 6) for text in (SPIRAL, "t, t^3", "t^2, t^3", "t^(5/2), t^4")}
#: no cubics, with a singular end each
OTHERS = {"t, t^3": "t^(5/2), t^4", "t^2, t^3": "t^(5/2), t^4"}


def address_of(fit, text):
    """Of the compiled jet that the density of a fit takes."""
    return (LONGER if law_of(*LAWS[type(fit)]).jet == 6 else JETS)[text].address


def no_cubic(fit, text):
    """The curve, or for cubics, which have no error on cubics, another one."""
    return OTHERS.get(text, text) if law_of(*LAWS[type(fit)]).jet == 6 else text


def content(text, record, low, high):
    """∫ (cJ)^{1/p} ds in balls: the constant itself, or that of the area to the power (p − 1)/p."""
    primitive, metric = LAWS[record]
    with precision(PRECISION):
        ends = arb(low), arb(high)
    value, _ = complexity_constant(CurveBalls(parse_tuple(text)), primitive, *ends, metric)
    order = law_of(primitive, metric).order
    return float(value) ** ((order - 1) / order if metric == "area" else 1)


@ALL
@pytest.mark.parametrize(
    ("text", "low", "high"), [(SPIRAL, 0.5, 6.25), ("t, t^3", 0.0, 0.25), ("t^2, t^3", 0.0, 1.0)]
)
def test_predicted(fit, text, low, high):
    text = no_cubic(fit, text)
    expected = content(text, type(fit), low, high)
    got = predicted(fit, address_of(fit, text), 1.0, low, high)
    assert got == pytest.approx(expected, rel=1e-9)
    assert got != pytest.approx(expected * (1 + 1e-6), rel=1e-9)
    if law_of(*LAWS[type(fit)]).jet == 6:
        return
    kinds = [record for record in LAWS if law_of(*LAWS[record]).jet < 6 and LAWS[record] != LAWS[type(fit)]]
    others = [content(text, other, low, high) for other in kinds]
    assert all(abs(other - expected) > 1e-3 * expected for other in others)


@pytest.mark.parametrize("fit", [Cubic(), CubicArea()], ids=name_of)
@pytest.mark.parametrize("text", ["t, t^3", "t^2, t^3"])
def test_cubics_have_no_error_on_cubics(fit, text):
    value = predicted(fit, LONGER[text].address, 1.0, 0.1, 1.0)
    assert math.isnan(value) or value < 0.02


def test_what_is_only_rounding_does_not_settle():
    """The content of a conic as conics is 0: roots of rounding errors."""
    value = predicted(EquisymmetricConic(), JETS["3*cos(t), sin(t)"].address, 1.0, 0.0, 1.5)
    assert math.isnan(value) or value < 1e-2
    assert predicted(ParabolaArea(), JETS["3*cos(t), sin(t)"].address, 1.0, 0.0, 1.5) > 0.1


@ALL
@pytest.mark.parametrize(
    ("text", "low", "high"), [(SPIRAL, 0.5, 6.25), ("t, t^3", 0.0, 0.25), ("t^2, t^3", 0.0, 1.0)]
)
def test_contents(fit, text, low, high):
    text = no_cubic(fit, text)
    address = address_of(fit, text)
    times = low + (high - low) * np.linspace(0, 1, 65)
    out = np.full(65, np.nan)
    contents(fit, address, 1.0, times, out)
    assert out[0] == 0 and np.all(np.diff(out) > 0)
    for j in (1, 2, 7, 40, 63, 64):
        assert out[j] == pytest.approx(predicted(fit, address, 1.0, low, times[j]), rel=2e-3)
    # away from singular ends the panels are smooth, and the values good
    if text == SPIRAL:
        assert out[-1] == pytest.approx(content(text, type(fit), low, high), rel=1e-9)


def test_contents_of_one_panel_and_of_uneven_ones():
    address, fit = JETS["t, t^3"].address, EquisymmetricConic()
    whole = predicted(fit, address, 1.0, 0.0, 0.25)
    for times in ([0.0, 0.25], [0.0, 1e-9, 0.25], [0.0, 1e-6, 1e-4, 0.01, 0.1, 0.25]):
        out = np.empty(len(times))
        contents(fit, address, 1.0, np.array(times), out)
        assert out[-1] == pytest.approx(whole, rel=1e-2 if len(times) > 3 else 1e-6)


@ALL
@settings(max_examples=10, deadline=None)
@given(st.floats(-40, 40), st.floats(0.6, 6.0))
def test_scale_and_additivity(fit, exponent, middle):
    """Errors are lengths or areas, so the content of λα is λ^{1/p} or λ^{2/p} times that of α."""
    primitive, metric = LAWS[type(fit)]
    address, scale = address_of(fit, SPIRAL), 2.0**exponent
    power = (2 if metric == "area" else 1) / law_of(primitive, metric).order
    whole = predicted(fit, address, 1.0, 0.5, 6.25)
    assert predicted(fit, address, scale, 0.5, 6.25) == pytest.approx(whole * scale**power, rel=1e-9)
    parts = [predicted(fit, address, 1.0, *ends) for ends in ((0.5, middle), (middle, 6.25))]
    assert math.fsum(parts) == pytest.approx(whole, rel=1e-9)
    assert math.fsum(parts) != pytest.approx(whole * (1 + 1e-6), rel=1e-9)


def test_the_cubic_by_hand():
    """y = x³ has dk/dr = 20/(81x⁴) and dr = (6x)^{1/3}dx: a content of conics like x^{2/3}."""
    factor = (20 / 81 / 7680) ** (1 / 6) * 6 ** (1 / 3) * 1.5
    times = np.linspace(0, 1, 200)
    out = np.empty(200)
    contents(EquisymmetricConic(), JETS["t, t^3"].address, 1.0, times, out)
    assert out == pytest.approx(factor * times ** (2 / 3), rel=1e-3)
    knots = np.interp(out[-1] * np.linspace(0, 1, 9), out, times)
    assert knots == pytest.approx(np.linspace(0, 1, 9) ** 1.5, abs=2e-4)
