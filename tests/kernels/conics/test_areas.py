"""Areas between arcs and conics against the reference in 30 digits, polygons and the laws of short arcs."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from osculant.cas.geometry import moons
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.kernels.conics import area_scan, strip_series
from osculant.kernels.conics import pencil as pencils
from osculant.kernels.conics.records import EquisymmetricConic, LeastAreaConic, ParabolaArea
from osculant.kernels.curves.peaks import workspace
from osculant.kernels.curves.plane import sample
from osculant.kernels.generated import pencil as generated
from tests.kernels.arcs import HERE, MIRRORED, NOISE, arc, best, jet_of, name_of, visit

#: tuples, and as such equal: they are told apart by their types, or by `is`
PARABOLA, EVEN, LEAST = ParabolaArea(), EquisymmetricConic(), LeastAreaConic()
FITS = (PARABOLA, EVEN, LEAST)
SPIRAL_TEXT = "t*cos(t), t*sin(t)"
SPIRAL = jet_of(SPIRAL_TEXT)


def careful(fit, jet, a, b, place=HERE):
    """(area, Q)."""
    return best(fit, arc(jet, a, b, place))


def fast(fit, jet, a, b, calm=1e-11):
    """(area, Q, settled) once enough nodes are used."""
    on, level = arc(jet, a, b), None
    for _ in range(len(strip_series.NODES)):
        area, q, settled, level = visit(fit, on, calm, 1, level)
        if settled:
            break
    return area, q, settled


def pencil_of(jet, a, b, place=HERE):
    """The source of the arc, and its pencil."""
    on = arc(jet, a, b, place)
    return on.source, pencils.pencil(on.start, on.end, NOISE)


def measured(pencil, q, source, a, b):
    """The area of the member Q."""
    return area_scan.measure(pencil, q, source, a, b, workspace(LEAST))


def conic_points(pencil, q, u):
    """Points of the member Q at the Bézier parameters u."""
    start, tangent, end = np.array(pencil[0:2]), np.array(pencil[2:4]), np.array(pencil[4:6])
    w, reach = generated.weight(q, pencil.chord, pencil.sin_a, pencil.sin_b, pencil.sin_psi)
    middle = w * start + reach * tangent
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
    top = b0[:, None] * start + b1[:, None] * middle + b2[:, None] * end
    return top / (b0 + w * b1 + b2)[:, None]


def shoelace(points):
    x, y = points.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def polygon_areas(jet, a, b, q, count=20001, place=HERE):
    """Signed areas of the regions between crossings, by polygons: no normals, no quadrature."""
    source, pencil = pencil_of(jet, a, b, place)
    times = np.linspace(a, b, count)
    curve = np.array([sample(source, t)[:2] for t in times])
    x0, y0, tx0, ty0, x2, y2, tx2, ty2, cx, cy = pencil[:10]
    curve[0], curve[-1] = (x0, y0), (x2, y2)
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


@settings(max_examples=25, deadline=None)
@given(
    st.sampled_from([SPIRAL_TEXT, "exp(t/3)*cos(t), exp(t/3)*sin(t)", "t, exp(t)", "t, t^5"]),
    st.floats(0.5, 2.0),
    st.floats(0.1, 2.2),
)
def test_the_linear_form_tells_the_least_area(text, a, length):
    """Theorem C: no search among the members finds a smaller area than the root of the linear form."""
    jet, b = jet_of(text), a + length
    on = arc(jet, a, b)
    room = workspace(LEAST)
    pen = pencils.pencil(on.start, on.end, NOISE)
    low, high = area_scan.bracket(pen, on.source, a, b, 40, room)
    assume(low > 0)
    searched, _ = area_scan.least(pen, on.source, a, b, low, high, room)
    found, q = careful(LEAST, jet, a, b)
    slack = NOISE * pen.chord
    assert found == pytest.approx(searched, rel=1e-12, abs=slack)
    for off in (-1e-3, 1e-3):
        assert area_scan.measure(pen, q * (1 + off), on.source, a, b, room) >= found - slack


def test_beyond_an_affine_spiral_the_least_area_is_searched_for():
    """Across a sextactic point members cross more than once: the linear form's is not the best."""
    jet, a, b = jet_of("cos(t) + cos(2*t)/20, sin(t)"), -0.8, 1.4
    on, room = arc(jet, a, b), workspace(LEAST)
    pen = pencils.pencil(on.start, on.end, NOISE)
    found, q = careful(LEAST, jet, a, b)
    for part in np.linspace(0.97, 1.03, 61):
        assert area_scan.measure(pen, q * part, on.source, a, b, room) >= found * (1 - 1e-9)


@pytest.mark.parametrize(("a", "b"), [(2.0, 2.2), (1.0, 2.0), (0.6, 2.2), (5.0, 5.5), (1.0, 3.2)])
def test_areas_are_those_of_the_reference(a, b):
    with mp.workdps(25):
        pencil = BitangentPencil(ReferenceCurve(SPIRAL_TEXT), mp.mpf(a), mp.mpf(b))
        even = moons.equisymmetric(pencil)
        wanted = [
            (EVEN, float(sum(moons.moons(pencil, even))), float(even)),
            (LEAST, float(sum(moons.moons(pencil, pencil.through(moons.least_area(pencil))))), None),
        ]
        if b - a < 2.0:
            q = pencil.parabola
            wanted.append((PARABOLA, float(abs(moons.signed_area(pencil, q))), float(q)))
    for fit, area, q in wanted:
        slack = 1e-11 + 4 * NOISE / area
        found, found_q = careful(fit, SPIRAL, a, b)
        assert found == pytest.approx(area, rel=slack)
        if q is not None:
            assert found_q == pytest.approx(q, rel=1e-10)
        for calm in (1e-11, 1e-7, 1e-3):
            quick, _, settled = fast(fit, SPIRAL, a, b, calm)
            if settled:
                assert quick == pytest.approx(area, rel=slack + calm)


def test_the_fast_step_reaches_the_careful_ones_digits():
    for fit in FITS:
        for a, b in ((2.0, 2.5), (1.0, 2.0), (4.0, 5.0)):
            area, _, settled = fast(fit, SPIRAL, a, b)
            assert settled
            assert area == pytest.approx(careful(fit, SPIRAL, a, b)[0], rel=1e-10)


@pytest.mark.parametrize("fit", FITS, ids=name_of)
@pytest.mark.parametrize(("a", "b"), [(0.6, 1.4), (1.0, 3.0), (5.0, 6.2)])
def test_areas_are_those_of_polygons(fit, a, b):
    area, q = careful(fit, SPIRAL, a, b)
    regions = polygon_areas(SPIRAL, a, b, q)
    assert len(regions) == (1 if fit is PARABOLA else 2)
    assert np.abs(regions).sum() == pytest.approx(area, rel=1e-4)
    if fit is EVEN:
        assert abs(regions.sum()) < 1e-6 * area


@settings(max_examples=30, deadline=None)
@given(st.floats(0.55, 5.0), st.floats(0.1, 1.2), st.floats(-0.3, 0.3))
def test_no_other_member_has_less_area(a, length, off):
    source, pencil = pencil_of(SPIRAL, a, a + length)
    area, q = careful(LEAST, SPIRAL, a, a + length)
    assert area <= careful(EVEN, SPIRAL, a, a + length)[0] * (1 + 1e-9) + NOISE
    other = measured(pencil, q * (1 + off * length**3), source, a, a + length)
    assert other >= area * (1 - 1e-9) - NOISE


def test_short_arcs_follow_the_laws():
    k, slope = 0.3, 0.2  # affine curvature and its derivative in the middle of a canonical form
    curve = jet_of("t, t^2/2 + 3*t^4/80 + t^5/200")
    for h in (0.2, 0.1, 0.05):
        area, _ = careful(PARABOLA, curve, -h, h)
        assert area == pytest.approx(k * (2 * h) ** 5 / 240, rel=2 * h**2)
        for fit in (EVEN, LEAST):
            area, _ = careful(fit, curve, -h, h)
            assert area == pytest.approx(slope * (2 * h) ** 6 / 7680, rel=4 * h**2 + 1e-13 / area * NOISE)


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(FITS), st.floats(0.6, 5.0), st.floats(0.05, 1.5), st.integers(-20, 20))
def test_mirrored_reversed_and_scaled_curves_have_the_same_areas(fit, a, length, power):
    b = a + length
    area, q = careful(fit, SPIRAL, a, b)
    slack = 1e-10 + 40 * NOISE * length * b / area
    assume(slack < 1e-2)
    mirrored = jet_of("t*cos(t), -t*sin(t)")
    assert careful(fit, mirrored, a, b, MIRRORED) == (area, q)
    backwards = jet_of("-t*cos(-t), -t*sin(-t)")
    assert careful(fit, backwards, -b, -a, MIRRORED)[0] == pytest.approx(area, rel=slack)
    size = 2.0**power
    scaled = jet_of(f"{size!r}*t*cos(t), {size!r}*t*sin(t)")
    assert careful(fit, scaled, a, b, HERE._replace(scale=1 / size))[0] == pytest.approx(area, rel=slack)


def test_an_arc_about_a_sextactic_point_has_more_crossings():
    # the canonical form with dk/dr = 0 in the middle, symmetric: the equisymmetric conic crosses twice
    curve = jet_of("t, t^2/2 + t^6")
    a, b = -0.5, 0.5
    area, q = careful(EVEN, curve, a, b)
    regions = polygon_areas(curve, a, b, q)
    assert len(regions) >= 3
    assert abs(regions.sum()) < 1e-6 * area
    assert np.abs(regions).sum() == pytest.approx(area, rel=1e-4)
    assert fast(EVEN, curve, a, b)[0] == pytest.approx(area, rel=1e-9)
    least, _ = careful(LEAST, curve, a, b)
    source, pencil = pencil_of(curve, a, b)
    grid = [measured(pencil, float(other), source, a, b) for other in np.linspace(0.7 * q, 1.3 * q, 2001)]
    assert least <= min(grid) * (1 + 1e-12)
    assert least == pytest.approx(min(grid), rel=1e-4)


def test_arcs_that_begin_at_an_inflection():
    cubic = jet_of("t, t^3")
    for fit in (EVEN, LEAST, PARABOLA):
        area, q = careful(fit, cubic, 0.0, 0.7)
        assert np.abs(polygon_areas(cubic, 0.0, 0.7, q)).sum() == pytest.approx(area, rel=1e-4)


@pytest.mark.parametrize("turning", [3.0, math.pi - 1e-6, math.pi, 3.3])
def test_conics_turn_by_more_than_parabolas(turning):
    ellipse = jet_of("2*cos(t)+t/10, sin(t)")
    a, b = 0.3, 0.3 + turning
    area, q = careful(EVEN, ellipse, a, b)
    assert np.abs(polygon_areas(ellipse, a, b, q)).sum() == pytest.approx(area, rel=1e-4)
    least, _ = careful(LEAST, ellipse, a, b)
    assert 0.9 * area < least <= area
    assert careful(PARABOLA, SPIRAL, 1.0, 1.0 + math.pi)[0] == math.inf


def test_arcs_without_a_proper_conic():
    s_curve = jet_of("t, t^3")
    for fit in FITS:
        assert careful(fit, s_curve, -1.0, 1.0)[0] == math.inf
        assert careful(fit, SPIRAL, 10.0, 10.0 + 2.5 * math.pi)[0] == math.inf
        assert math.isnan(fast(fit, s_curve, -1.0, 1.0)[0])


def test_a_straight_arc_gets_its_chord():
    line = jet_of("t, 2*t")
    for fit in FITS:
        area, q = careful(fit, line, 0.0, 1.0)
        assert (q, area) == (0.0, pytest.approx(0.0, abs=1e-15))


def test_an_area_below_rounding_is_no_failure():
    circle = jet_of("cos(t), sin(t)")
    for fit in (EVEN, LEAST):
        for length in (0.01, 1.0, 3.0):
            area, q = careful(fit, circle, 0.3, 0.3 + length)
            assert area < 1e-14
            assert q > 0


def test_a_sharp_bend_between_nodes_is_found():
    bend = jet_of("(2*t^3+5*t^2-2*t-2)/(1+4*t^2), (5+4*t+t^2-5*t^3)/(1+4*t^2)")
    a, b = 0.00606, 0.57492
    area, q = careful(EVEN, bend, a, b, MIRRORED)
    assert np.abs(polygon_areas(bend, a, b, q, place=MIRRORED)).sum() == pytest.approx(area, rel=1e-3)
    # corners rounded off: nearly all of the turning within a tenth or a hundredth of the interval
    corner = jet_of("t, sqrt(t^2 + 1e-2) + t^2/40")
    area, q = careful(EVEN, corner, -1.0, 0.8)
    assert np.abs(polygon_areas(corner, -1.0, 0.8, q)).sum() == pytest.approx(area, rel=1e-3)
    corner = jet_of("t, sqrt(t^2 + 1e-4) + t^2/40")
    area, q = careful(EVEN, corner, -1.0, 0.8)  # beyond the curve's centres: an upper bound
    polygons = np.abs(polygon_areas(corner, -1.0, 0.8, q, 100001)).sum()
    assert polygons <= area <= 1.2 * polygons
