"""The pencil of one arc, its distances and the best conics and parabolas, against brute force."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.kernels.conics import pencil as pencils
from osculant.kernels.conics import scan
from osculant.kernels.conics.records import Conic, Parabola
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import sample
from tests.kernels.arcs import HERE, MIRRORED, NOISE, arc, best, jet_of, name_of, spline, visit

SPIRAL = jet_of("t*cos(t), t*sin(t)")
#: most of its turning happens within a hundredth of the interval, where equidistant samples are blind
BEND = jet_of("(2*t^3+5*t^2-2*t-2)/(1+4*t^2), (5+4*t+t^2-5*t^3)/(1+4*t^2)")


def seen(jet, a, b, place=HERE):
    """The arc, its source and its pencil."""
    on = arc(jet, a, b, place)
    return on, on.source, pencils.pencil(on.start, on.end, NOISE)


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
    _, source, pencil = seen(SPIRAL, a, a + length)
    through = pencils.through(pencils.view(pencil, source, a + 0.4 * length))
    q = through * (1 + off * length**2)
    t = a + x * length
    d, by_q, slope = pencils.displacement(pencil, q, pencils.view(pencil, source, t))
    assert d == pytest.approx(brute_displacement(pencil, q, source, t), rel=1e-6, abs=1e-13)
    step = 1e-6
    around = [
        pencils.displacement(pencil, q * (1 + s), pencils.view(pencil, source, t))[0] for s in (-step, step)
    ]
    assert by_q == pytest.approx((around[1] - around[0]) / (2 * step * q), rel=1e-4, abs=1e-8)
    around = [pencils.displacement(pencil, q, pencils.view(pencil, source, t + s))[0] for s in (-step, step)]
    assert slope == pytest.approx((around[1] - around[0]) / (2 * step), rel=1e-3, abs=1e-7)


def grid_error(source, pencil, q, a, b, n=4001):
    d = [
        pencils.displacement(pencil, q, pencils.view(pencil, source, t))[0]
        for t in np.linspace(a, b, n)[1:-1]
    ]
    return max(d), min(d)


@pytest.mark.parametrize(("a", "b"), [(0.6, 1.0), (0.6, 3.6), (1.0, 4.7), (5.0, 5.2)])
def test_the_best_conic_is_the_best_of_the_pencil(a, b):
    on, source, pencil = seen(SPIRAL, a, b)
    error, q = best(Conic(), on)
    top, bottom = grid_error(source, pencil, q, a, b)
    assert top == pytest.approx(error, rel=1e-5)
    assert bottom == pytest.approx(-error, rel=1e-5)
    for factor in (1 - 1e-3, 1 + 1e-3):
        other = max(abs(v) for v in grid_error(source, pencil, q * (1 + (factor - 1) * (b - a) ** 3), a, b))
        assert other > error


@pytest.mark.parametrize("fit", [Conic(), Parabola()], ids=name_of)
@pytest.mark.parametrize(("a", "b"), [(0.6, 1.0), (2.0, 3.5), (5.0, 5.2)])
def test_fast_and_careful_steps_agree(fit, a, b):
    on = arc(SPIRAL, a, b)
    error, q = best(fit, on)
    fast, fast_q, settled, _ = visit(fit, on, 1e-9)
    assert settled
    assert fast == pytest.approx(error, rel=1e-7)
    assert fast_q == pytest.approx(q, rel=1e-7)


def test_mirrored_curves_have_the_same_errors():
    mirrored = jet_of("t*cos(t), -t*sin(t)")
    assert best(Conic(), arc(mirrored, 1.0, 2.0, MIRRORED)) == best(Conic(), arc(SPIRAL, 1.0, 2.0))


def test_a_sharp_bend_between_samples_is_found():
    a, b = 0.00606, 0.57492
    on, source, pencil = seen(BEND, a, b, MIRRORED)
    q = pencils.parabola(pencil)
    assert max(map(abs, grid_error(source, pencil, q, a, b, 40001))) > 0.44
    assert max(map(abs, grid_error(source, pencil, q, a, b, 10))) < 0.1
    assert scan.measure(pencil, q, source, a, b, 8, workspace(Parabola())) > 0.44
    assert best(Parabola(), on)[0] > 0.44


def test_arcs_without_a_proper_conic():
    on, _, pencil = seen(jet_of("t, t^3"), -1.0, 1.0)
    assert not pencils.is_proper(pencil)
    assert best(Conic(), on)[0] == math.inf
    on, _, pencil = seen(jet_of("t, 2*t"), 0.0, 1.0)
    assert pencils.is_flat(pencil)
    error, q = best(Conic(), on)
    assert (q, error) == (0.0, pytest.approx(0.0, abs=1e-15))
    # more than one turn: the end points and tangents alone would not show it
    assert best(Conic(), arc(SPIRAL, 10.0, 10.0 + 2.5 * math.pi))[0] == math.inf
    # a parabola does not turn by π
    assert best(Parabola(), arc(SPIRAL, 1.0, 1.0 + math.pi))[0] == math.inf


def test_an_error_below_rounding_is_no_failure():
    error, q = best(Conic(), arc(jet_of("cos(t), sin(t)"), 0.3, 0.31))
    assert error < 1e-15
    assert q > 0


def test_a_table_too_small_is_filled_and_continued():
    a, b = math.pi / 6, 2 * math.pi
    window = 1e-8 * (1 - 2e-6), 1e-8 * (1 - 1e-7)
    whole, reached, _ = spline(Conic(), SPIRAL, a, b, window, length=0.1)
    assert (len(whole), reached) == (51, b)
    part, reached, _ = spline(Conic(), SPIRAL, a, b, window, capacity=20, length=0.1)
    assert len(part) == 20
    assert reached == whole[19, 1]
