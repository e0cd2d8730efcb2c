"""The kernels of one arc against brute force."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.formulas.parser import parse_tuple
from osculant.codegen.jets import compile_jet
from osculant.kernels import search as greedy
from osculant.kernels.conics import exchange, scan
from osculant.kernels.conics import pencil as bitangent
from osculant.kernels.conics.minimax import minimax
from osculant.kernels.curves.plane import JET_SIZE, sample, sample_many

NOISE = 4 * math.ulp(1.0)
SPIRAL = compile_jet(parse_tuple("t*cos(t), t*sin(t)"), 2)


def source_of(jet, flip=1.0):
    return (jet.address, (0.0, 0.0, 1.0, flip, NOISE), np.empty(JET_SIZE))


def arc(jet, a, b, flip=1.0):
    source = source_of(jet, flip)
    start, end = greedy.frame(source, a), greedy.frame(source, b)
    return source, start, end, bitangent.pencil(start, end, NOISE)


def brute_displacement(pencil, q, source, t):
    """The nearest root of F(α + dN) = 0, F evaluated from scratch."""
    x, y, tx, ty, _, _ = sample(source, t)
    x0, y0, tx0, ty0, x2, y2, tx2, ty2, cx, cy = pencil[:10]

    def f(d):
        px, py = x - d * ty, y + d * tx
        line0 = tx2 * (py - y2) - ty2 * (px - x2)
        line2 = tx0 * (py - y0) - ty0 * (px - x0)
        line1 = cx * (py - y0) - cy * (px - x0)
        return line1**2 - 4 * q * line0 * line2

    values = [f(d) for d in (-1.0, 0.0, 1.0)]
    a, b, c = (values[0] + values[2]) / 2 - values[1], (values[2] - values[0]) / 2, values[1]
    return min(np.roots([a, b, c]), key=abs)


@settings(max_examples=60, deadline=None)
@given(st.floats(0.6, 5.0), st.floats(0.05, 1.2), st.floats(0.05, 0.95), st.floats(-0.05, 0.05))
def test_displacement_and_its_derivatives(a, length, x, off):
    source, _, _, pencil = arc(SPIRAL, a, a + length)
    through = bitangent.through(bitangent.view(pencil, source, a + 0.4 * length))
    q = through * (1 + off * length**2)
    t = a + x * length
    d, by_q, slope = bitangent.displacement(pencil, q, bitangent.view(pencil, source, t))
    assert d == pytest.approx(brute_displacement(pencil, q, source, t), rel=1e-6, abs=1e-13)
    step = 1e-6
    around = [
        bitangent.displacement(pencil, q * (1 + s), bitangent.view(pencil, source, t))[0]
        for s in (-step, step)
    ]
    assert by_q == pytest.approx((around[1] - around[0]) / (2 * step * q), rel=1e-4, abs=1e-8)
    around = [
        bitangent.displacement(pencil, q, bitangent.view(pencil, source, t + s))[0] for s in (-step, step)
    ]
    assert slope == pytest.approx((around[1] - around[0]) / (2 * step), rel=1e-3, abs=1e-7)


def grid_error(source, pencil, q, a, b, n=4001):
    d = [
        bitangent.displacement(pencil, q, bitangent.view(pencil, source, t))[0]
        for t in np.linspace(a, b, n)[1:-1]
    ]
    return max(d), min(d)


@pytest.mark.parametrize(("a", "b"), [(0.6, 1.0), (0.6, 3.6), (1.0, 4.7), (5.0, 5.2)])
def test_minimax_is_the_best_of_the_pencil(a, b):
    source, start, end, pencil = arc(SPIRAL, a, b)
    error, q = minimax(exchange.CONIC, source, a, start, b, end, scan.workspace())
    top, bottom = grid_error(source, pencil, q, a, b)
    assert top == pytest.approx(error, rel=1e-5)
    assert bottom == pytest.approx(-error, rel=1e-5)
    for factor in (1 - 1e-3, 1 + 1e-3):
        other = max(abs(v) for v in grid_error(source, pencil, q * (1 + (factor - 1) * (b - a) ** 3), a, b))
        assert other > error


@pytest.mark.parametrize("primitive", [exchange.CONIC, exchange.PARABOLA])
@pytest.mark.parametrize(("a", "b"), [(0.6, 1.0), (2.0, 3.5), (5.0, 5.2)])
def test_fast_and_careful_steps_agree(primitive, a, b):
    source, start, end, _ = arc(SPIRAL, a, b)
    error, q = minimax(primitive, source, a, start, b, end, scan.workspace())
    peaks, nan = exchange.first_peaks(primitive), math.nan
    steeps, before = (nan, nan), (nan, nan)
    for _ in range(8):
        places = peaks[:2]
        fast, fast_q, unrest, peaks, steeps = exchange.exchange(
            primitive, source, a, start, b, end, peaks, steeps, before
        )
        before = places
    assert unrest < 1e-9
    assert fast == pytest.approx(error, rel=1e-7)
    assert fast_q == pytest.approx(q, rel=1e-7)


def test_mirrored_curves_have_the_same_errors():
    mirrored = compile_jet(parse_tuple("t*cos(t), -t*sin(t)"), 2)
    results = []
    for jet, flip in ((SPIRAL, 1.0), (mirrored, -1.0)):
        source, start, end, _ = arc(jet, 1.0, 2.0, flip)
        results.append(minimax(exchange.CONIC, source, 1.0, start, 2.0, end, scan.workspace()))
    assert results[0] == results[1]


def test_a_sharp_bend_between_samples_is_found():
    # most of the turning happens within a hundredth of the interval, where equidistant samples are blind
    bend = compile_jet(parse_tuple("(2*t^3+5*t^2-2*t-2)/(1+4*t^2), (5+4*t+t^2-5*t^3)/(1+4*t^2)"), 2)
    a, b = 0.00606, 0.57492
    source, start, end, pencil = arc(bend, a, b, -1.0)
    q = bitangent.generated.parabola(*pencil[11:14])
    assert max(map(abs, grid_error(source, pencil, q, a, b, 40001))) > 0.44
    assert max(map(abs, grid_error(source, pencil, q, a, b, 10))) < 0.1
    assert scan.measure(pencil, q, source, a, b, 8, scan.workspace()) > 0.44
    assert minimax(exchange.PARABOLA, source, a, start, b, end, scan.workspace())[0] > 0.44


def test_arcs_without_a_proper_conic():
    line = compile_jet(parse_tuple("t, 2*t"), 2)
    s_curve = compile_jet(parse_tuple("t, t^3"), 2)
    source, start, end, pencil = arc(s_curve, -1.0, 1.0)
    assert not bitangent.is_proper(pencil)
    assert minimax(exchange.CONIC, source, -1.0, start, 1.0, end, scan.workspace())[0] == math.inf
    source, start, end, pencil = arc(line, 0.0, 1.0)
    assert bitangent.is_flat(pencil)
    error, q = minimax(exchange.CONIC, source, 0.0, start, 1.0, end, scan.workspace())
    assert (q, error) == (0.0, pytest.approx(0.0, abs=1e-15))
    # more than one turn: the end points and tangents alone would not show it
    source, start, end, pencil = arc(SPIRAL, 10.0, 10.0 + 2.5 * math.pi)
    assert (
        minimax(exchange.CONIC, source, 10.0, start, 10.0 + 2.5 * math.pi, end, scan.workspace())[0]
        == math.inf
    )
    # a parabola does not turn by π
    source, start, end, _ = arc(SPIRAL, 1.0, 1.0 + math.pi)
    assert minimax(exchange.PARABOLA, source, 1.0, start, 1.0 + math.pi, end, scan.workspace())[0] == math.inf


def test_an_error_below_rounding_is_no_failure():
    circle = compile_jet(parse_tuple("cos(t), sin(t)"), 2)
    source, start, end, _ = arc(circle, 0.3, 0.31)
    error, q = minimax(exchange.CONIC, source, 0.3, start, 0.31, end, scan.workspace())
    assert error < 1e-15
    assert q > 0


def test_a_table_too_small_is_filled_and_continued():
    source = source_of(SPIRAL)
    a, b = math.pi / 6, 2 * math.pi
    frames = greedy.frame(source, a), greedy.frame(source, b)
    window = 1e-8 * (1 - 2e-6), 1e-8 * (1 - 1e-7)
    whole, part = np.empty((100, greedy.COLUMNS)), np.empty((20, greedy.COLUMNS))
    call = (exchange.CONIC, *source[:2])
    count, reached, _ = greedy.spline(*call, a, frames[0], b, frames[1], *window, 0.1, whole)
    assert (count, reached) == (51, b)
    count, reached, _ = greedy.spline(*call, a, frames[0], b, frames[1], *window, 0.1, part)
    assert count == 20
    assert reached == whole[19, 1]


def test_sample_many_is_the_jet():
    times = np.linspace(0.5, 6, 7)
    out = np.empty((7, JET_SIZE))
    sample_many(SPIRAL.address, times, out)
    assert (out == [SPIRAL(t).ravel() for t in times]).all()
