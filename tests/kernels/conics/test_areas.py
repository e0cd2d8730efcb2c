"""Areas between arcs and conics against the reference in 30 digits, polygons and the laws of short arcs."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp
from osculant.kernels.primitives import AREA_PARABOLA, EQUISYMMETRIC, LEAST_AREA

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry import moons
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.codegen.jets import compile_jet
from osculant.kernels import search as greedy
from osculant.kernels.conics import area_exchange, area_scan, scan, strip_series
from osculant.kernels.conics import pencil as bitangent
from osculant.kernels.conics.minimax import minimax
from osculant.kernels.curves.plane import JET_SIZE, sample

NOISE = 4 * math.ulp(1.0)
CODES = (AREA_PARABOLA, EQUISYMMETRIC, LEAST_AREA)
SPIRAL_TEXT = "t*cos(t), t*sin(t)"
SPIRAL = compile_jet(parse_tuple(SPIRAL_TEXT), 2)


def source_of(jet, flip=1.0, scale=1.0):
    return (jet.address, (0.0, 0.0, scale, flip, NOISE), np.empty(JET_SIZE))


def arc(jet, a, b, flip=1.0, scale=1.0):
    source = source_of(jet, flip, scale)
    return source, greedy.frame(source, a), greedy.frame(source, b)


def careful(code, jet, a, b, flip=1.0, scale=1.0):
    source, start, end = arc(jet, a, b, flip, scale)
    return minimax(code, source, a, start, b, end, scan.workspace())


def fast(code, jet, a, b, calm=1e-11):
    """(area, Q, unrest) once enough nodes are used."""
    source, start, end = arc(jet, a, b)
    level = area_exchange.FIRST_LEVEL
    for _ in range(len(strip_series.NODES)):
        area, q, unrest, level = area_exchange.exchange(
            code, source, a, start, b, end, level, calm, scan.workspace()
        )
        if unrest <= calm:
            break
    return area, q, unrest


def conic_points(pencil, q, u):
    """Points of the member Q at the Bézier parameters u."""
    start, tangent, end = np.array(pencil[0:2]), np.array(pencil[2:4]), np.array(pencil[4:6])
    w, reach = bitangent.generated.weight(q, *pencil[10:14])
    middle = w * start + reach * tangent
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
    top = b0[:, None] * start + b1[:, None] * middle + b2[:, None] * end
    return top / (b0 + w * b1 + b2)[:, None]


def shoelace(points):
    x, y = points.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def polygon_areas(jet, a, b, q, count=20001, flip=1.0):
    """Signed areas of the regions between crossings, by polygons: no normals, no quadrature."""
    source, start, end = arc(jet, a, b, flip)
    pencil = bitangent.pencil(start, end, NOISE)
    times = np.linspace(a, b, count)
    curve = np.array([sample(source, t)[:2] for t in times])
    curve[0], curve[-1] = start[:2], end[:2]
    x0, y0, tx0, ty0, x2, y2, tx2, ty2, cx, cy = pencil[:10]
    l0 = tx2 * (curve[:, 1] - y2) - ty2 * (curve[:, 0] - x2)
    l1 = cx * (curve[:, 1] - y0) - cy * (curve[:, 0] - x0)
    l2 = tx0 * (curve[:, 1] - y0) - ty0 * (curve[:, 0] - x0)
    side = (l1**2 - 4 * q * l0 * l2)[1:-1] / ((times - a) * (b - times))[1:-1] ** 2
    margin = count // 100  # values near the ends are rounding
    changes = [i + 1 for i in range(margin, count - 2 - margin) if side[i] * side[i - 1] < 0]
    conic = conic_points(pencil, q, np.linspace(0, 1, count))
    areas, before, conic_before = [], 0, 0
    for cut in [*changes, count - 1]:
        near = count - 1 if cut == count - 1 else int(np.argmin(np.hypot(*(conic - curve[cut]).T)))
        region = np.concatenate([curve[before : cut + 1], conic[conic_before : near + 1][::-1]])
        areas.append(shoelace(region))
        before, conic_before = cut, near
    return np.array(areas)


@pytest.mark.parametrize("order", [0, 1])
@pytest.mark.parametrize("level", range(len(strip_series.NODES)))
def test_series_integrate_polynomials_exactly(order, level):
    count, m = strip_series.NODES[level], strip_series.ORDERS[order]
    rng = np.random.default_rng(count)
    polynomial = np.polynomial.Polynomial(rng.normal(size=count))
    whole = np.polynomial.Polynomial([1, 0, -1]) ** m * polynomial
    antiderivative = whole.integ(lbnd=-1)
    series = np.zeros(strip_series.MOST)
    nodes = strip_series.POINTS[order, level, :count]
    strip_series.expand(order, level, whole(nodes), series)
    assert strip_series.WEIGHTS[order, level, :count] @ whole(nodes) == pytest.approx(
        antiderivative(1), abs=1e-12
    )
    for x in (-1.0, -0.7, 0.1, 0.95, 1.0):
        value, slope, area = strip_series.evaluate(order, count, series, x)
        assert value == pytest.approx(polynomial(x), abs=1e-10)
        assert slope == pytest.approx(polynomial.deriv()(x), abs=1e-8)
        assert area == pytest.approx(antiderivative(x), abs=1e-11)
    dense = np.linspace(-1, 1, 400001)
    unsigned, _ = strip_series.unsigned(order, level, whole(nodes), series)
    assert unsigned == pytest.approx(np.trapezoid(np.abs(whole(dense)), dense), rel=1e-7)


@pytest.mark.parametrize(("a", "b"), [(2.0, 2.2), (1.0, 2.0), (0.6, 2.2), (5.0, 5.5), (1.0, 3.2)])
def test_areas_are_those_of_the_reference(a, b):
    with mp.workdps(25):
        pencil = BitangentPencil(ReferenceCurve(SPIRAL_TEXT), mp.mpf(a), mp.mpf(b))
        even = moons.equisymmetric(pencil)
        wanted = {
            EQUISYMMETRIC: (float(sum(moons.moons(pencil, even))), float(even)),
            LEAST_AREA: (float(sum(moons.moons(pencil, pencil.through(moons.least_area(pencil))))), None),
        }
        if b - a < 2.0:
            parabola = pencil.parabola
            wanted[AREA_PARABOLA] = float(abs(moons.signed_area(pencil, parabola))), float(parabola)
    for code, (area, q) in wanted.items():
        slack = 1e-11 + 4 * NOISE / area
        found, found_q = careful(code, SPIRAL, a, b)
        assert found == pytest.approx(area, rel=slack)
        if q is not None:
            assert found_q == pytest.approx(q, rel=1e-10)
        quick, _, unrest = fast(code, SPIRAL, a, b)
        if unrest < 1e-3:
            assert quick == pytest.approx(area, rel=slack + unrest)


def test_the_fast_step_reaches_the_careful_ones_digits():
    for code in CODES:
        for a, b in ((2.0, 2.5), (1.0, 2.0), (4.0, 5.0)):
            area, _, unrest = fast(code, SPIRAL, a, b)
            assert unrest <= 1e-11
            assert area == pytest.approx(careful(code, SPIRAL, a, b)[0], rel=1e-10)


@pytest.mark.parametrize("code", CODES)
@pytest.mark.parametrize(("a", "b"), [(0.6, 1.4), (1.0, 3.0), (5.0, 6.2)])
def test_areas_are_those_of_polygons(code, a, b):
    area, q = careful(code, SPIRAL, a, b)
    regions = polygon_areas(SPIRAL, a, b, q)
    assert len(regions) == (1 if code == AREA_PARABOLA else 2)
    assert np.abs(regions).sum() == pytest.approx(area, rel=1e-4)
    if code == EQUISYMMETRIC:
        assert abs(regions.sum()) < 1e-6 * area


@settings(max_examples=30, deadline=None)
@given(st.floats(0.55, 5.0), st.floats(0.1, 1.2), st.floats(-0.3, 0.3))
def test_no_other_member_has_less_area(a, length, off):
    source, start, end = arc(SPIRAL, a, a + length)
    pencil = bitangent.pencil(start, end, NOISE)
    area, q = careful(LEAST_AREA, SPIRAL, a, a + length)
    assert area <= careful(EQUISYMMETRIC, SPIRAL, a, a + length)[0] * (1 + 1e-9) + NOISE
    other = area_scan.measure(pencil, q * (1 + off * length**3), source, a, a + length, scan.workspace())
    assert other >= area * (1 - 1e-9) - NOISE


def test_short_arcs_follow_the_laws():
    k, slope = 0.3, 0.2  # affine curvature and its derivative in the middle of a canonical form
    curve = compile_jet(parse_tuple("t, t^2/2 + 3*t^4/80 + t^5/200"), 2)
    for h in (0.2, 0.1, 0.05):
        area, _ = careful(AREA_PARABOLA, curve, -h, h)
        assert area == pytest.approx(k * (2 * h) ** 5 / 240, rel=2 * h**2)
        for code in (EQUISYMMETRIC, LEAST_AREA):
            area, _ = careful(code, curve, -h, h)
            assert area == pytest.approx(slope * (2 * h) ** 6 / 7680, rel=4 * h**2 + 1e-13 / area * NOISE)


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(CODES), st.floats(0.6, 5.0), st.floats(0.05, 1.5), st.integers(-20, 20))
def test_mirrored_reversed_and_scaled_curves_have_the_same_areas(code, a, length, power):
    b = a + length
    area, q = careful(code, SPIRAL, a, b)
    slack = 1e-10 + 40 * NOISE * length * b / area
    assume(slack < 1e-2)
    mirrored = compile_jet(parse_tuple("t*cos(t), -t*sin(t)"), 2)
    assert careful(code, mirrored, a, b, -1.0) == (area, q)
    backwards = compile_jet(parse_tuple("-t*cos(-t), -t*sin(-t)"), 2)
    assert careful(code, backwards, -b, -a, -1.0)[0] == pytest.approx(area, rel=slack)
    size = 2.0**power
    scaled = compile_jet(parse_tuple(f"{size!r}*t*cos(t), {size!r}*t*sin(t)"), 2)
    assert careful(code, scaled, a, b, 1.0, 1 / size)[0] == pytest.approx(area, rel=slack)


def test_an_arc_about_a_sextactic_point_has_more_crossings():
    # the canonical form with dk/dr = 0 in the middle, symmetric: the equisymmetric conic crosses twice
    curve = compile_jet(parse_tuple("t, t^2/2 + t^6"), 2)
    a, b = -0.5, 0.5
    area, q = careful(EQUISYMMETRIC, curve, a, b)
    regions = polygon_areas(curve, a, b, q)
    assert len(regions) >= 3
    assert abs(regions.sum()) < 1e-6 * area
    assert np.abs(regions).sum() == pytest.approx(area, rel=1e-4)
    assert fast(EQUISYMMETRIC, curve, a, b)[0] == pytest.approx(area, rel=1e-9)
    least, _ = careful(LEAST_AREA, curve, a, b)
    source, start, end = arc(curve, a, b)
    pencil = bitangent.pencil(start, end, NOISE)
    grid = [
        area_scan.measure(pencil, float(other), source, a, b, scan.workspace())
        for other in np.linspace(0.7 * q, 1.3 * q, 2001)
    ]
    assert least <= min(grid) * (1 + 1e-12)
    assert least == pytest.approx(min(grid), rel=1e-4)


def test_arcs_that_begin_at_an_inflection():
    cubic = compile_jet(parse_tuple("t, t^3"), 2)
    for code in (EQUISYMMETRIC, LEAST_AREA, AREA_PARABOLA):
        area, q = careful(code, cubic, 0.0, 0.7)
        assert np.abs(polygon_areas(cubic, 0.0, 0.7, q)).sum() == pytest.approx(area, rel=1e-4)


@pytest.mark.parametrize("turning", [3.0, math.pi - 1e-6, math.pi, 3.3])
def test_conics_turn_by_more_than_parabolas(turning):
    ellipse = compile_jet(parse_tuple("2*cos(t)+t/10, sin(t)"), 2)
    a, b = 0.3, 0.3 + turning
    area, q = careful(EQUISYMMETRIC, ellipse, a, b)
    assert np.abs(polygon_areas(ellipse, a, b, q)).sum() == pytest.approx(area, rel=1e-4)
    least, _ = careful(LEAST_AREA, ellipse, a, b)
    assert 0.9 * area < least <= area
    assert careful(AREA_PARABOLA, SPIRAL, 1.0, 1.0 + math.pi)[0] == math.inf


def test_arcs_without_a_proper_conic():
    s_curve = compile_jet(parse_tuple("t, t^3"), 2)
    for code in CODES:
        assert careful(code, s_curve, -1.0, 1.0)[0] == math.inf
        assert careful(code, SPIRAL, 10.0, 10.0 + 2.5 * math.pi)[0] == math.inf
        assert math.isnan(fast(code, s_curve, -1.0, 1.0)[0])


def test_a_straight_arc_gets_its_chord():
    line = compile_jet(parse_tuple("t, 2*t"), 2)
    for code in CODES:
        area, q = careful(code, line, 0.0, 1.0)
        assert (q, area) == (0.0, pytest.approx(0.0, abs=1e-15))


def test_an_area_below_rounding_is_no_failure():
    circle = compile_jet(parse_tuple("cos(t), sin(t)"), 2)
    for code in (EQUISYMMETRIC, LEAST_AREA):
        for length in (0.01, 1.0, 3.0):
            area, q = careful(code, circle, 0.3, 0.3 + length)
            assert area < 1e-14
            assert q > 0


def test_a_sharp_bend_between_nodes_is_found():
    bend = compile_jet(parse_tuple("(2*t^3+5*t^2-2*t-2)/(1+4*t^2), (5+4*t+t^2-5*t^3)/(1+4*t^2)"), 2)
    a, b = 0.00606, 0.57492
    area, q = careful(EQUISYMMETRIC, bend, a, b, -1.0)
    assert np.abs(polygon_areas(bend, a, b, q, flip=-1.0)).sum() == pytest.approx(area, rel=1e-3)
    # corners rounded off: nearly all of the turning within a tenth or a hundredth of the interval
    corner = compile_jet(parse_tuple("t, sqrt(t^2 + 1e-2) + t^2/40"), 2)
    area, q = careful(EQUISYMMETRIC, corner, -1.0, 0.8)
    assert np.abs(polygon_areas(corner, -1.0, 0.8, q)).sum() == pytest.approx(area, rel=1e-3)
    corner = compile_jet(parse_tuple("t, sqrt(t^2 + 1e-4) + t^2/40"), 2)
    area, q = careful(EQUISYMMETRIC, corner, -1.0, 0.8)  # beyond the curve's centres: an upper bound
    polygons = np.abs(polygon_areas(corner, -1.0, 0.8, q, 100001)).sum()
    assert polygons <= area <= 1.2 * polygons
