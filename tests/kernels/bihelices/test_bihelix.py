"""Bihelices and their splines: the tables of the theory, the reference in mpmath, an independent distance."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry import bihelix_rules as reference
from osculant.codegen.jets import compile_jet
from osculant.kernels import bihelix_spline
from osculant.kernels.bihelices.balance import best
from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS, bihelix, offset
from osculant.kernels.bihelices.hausdorff import two_sided
from osculant.kernels.bihelices.scan import peaks
from osculant.kernels.curves import arc_length
from osculant.kernels.curves.space import JET_SIZE, frame, sample_many
from osculant.tolerances import window

CONICAL, MOMENT = "t*cos(t), t*sin(t), t", "t, t^2, t^3"
NOISE = 4 * math.ulp(0.5)
BOTH = pytest.mark.parametrize("rule", [THESIS, EQUIOSCILLATING])


def end_frame(jet, t):
    values = jet(t)
    tangent = values[:, 1] / np.linalg.norm(values[:, 1])
    return tuple(map(float, (*values[:, 0], *tangent)))


def place_of(jet, a, b):
    values = np.array([jet(t)[:, 0] for t in np.linspace(a, b, 33)])
    scale = 2.0 ** -math.frexp(abs(values).max())[1]
    return (*map(float, values[0]), scale, NOISE), float(abs(values).max())


def spline_of(text, a, b, tolerance, rule, capacity=1000):
    """(table of pieces, jet)."""
    jet = compile_jet(parse_tuple(text), 3)
    place, largest = place_of(jet, a, b)
    table = np.empty((capacity, bihelix_spline.COLUMNS))
    count, reached, _ = bihelix_spline.spline(
        rule, jet.address, place, a, end_frame(jet, a), b, end_frame(jet, b),
        *window(tolerance, math.ulp(largest)), 0.0, table,
    )  # fmt: skip
    assert reached == b
    return table[:count], jet


def helix_points(row, s):
    """Points and tangents of a helix of the table, written anew."""
    p, tangent, along, side = (row[3 * i : 3 * i + 3] for i in range(4))
    rate = row[12]
    if rate == 0:
        return p + s[:, None] * tangent, np.tile(tangent, (len(s), 1))
    out = tangent - along
    x = (rate * s)[:, None]
    points = p + s[:, None] * along + np.sin(x) / rate * out + 2 * np.sin(x / 2) ** 2 / rate * side
    return points, along + np.cos(x) * out + np.sin(x) * side


def helices(row):
    return row[bihelix_spline.LEFT : bihelix_spline.RIGHT], row[bihelix_spline.RIGHT : bihelix_spline.END]


def distances(points, line):
    """Distances of points from a polygon, through a tree of its corners."""
    near = cKDTree(line).query(points)[1]
    found = np.full(len(points), np.inf)
    for shift in (-1, 0):
        i = np.clip(near + shift, 0, len(line) - 2)
        step = line[i + 1] - line[i]
        along = np.clip(((points - line[i]) * step).sum(1) / (step * step).sum(1), 0, 1)
        found = np.minimum(found, np.linalg.norm(points - line[i] - along[:, None] * step, axis=1))
    return found


def independent_error(row, jet, count):
    times = np.linspace(row[0], row[1], count)
    rows = np.empty((count, JET_SIZE))
    sample_many(jet.address, times, rows)
    curve = rows[:, ::4].copy()
    pieces = [helix_points(helix, np.linspace(0, helix[13], count // 2))[0] for helix in helices(row)]
    line = np.vstack([pieces[0], pieces[1][1:]])
    return max(distances(curve, line).max(), distances(line, curve).max())


def check_chain(table, jet):
    """End to end: points and tangents of curve and helices, in the order of the table."""
    previous = None
    largest = 2 * max(abs(jet(t)[:, 0]).max() for t in table[:, :2].ravel())  # rounding is that of the whole
    for row in table:
        left, right = helices(row)
        size = left[13] + right[13]
        # helices between nearly equal tangents are known up to the rounding of those
        tangents = np.array([left[3:6], right[3:6], row[44:47]])
        change = max(1e-16, np.linalg.norm(np.diff(tangents, axis=0), axis=1).min())
        near = (1e-11 + min(1e-9, 4e-16 / change)) * size + 1e-14 * largest
        ends = [helix_points(h, np.array([0.0, h[13]])) for h in (left, right)]
        assert np.linalg.norm(ends[0][0][0] - jet(row[0])[:, 0]) <= near
        assert np.linalg.norm(ends[0][0][1] - ends[1][0][0]) <= near
        assert np.linalg.norm(ends[1][0][1] - jet(row[1])[:, 0]) <= near
        assert np.linalg.norm(ends[0][1][1] - ends[1][1][0]) <= 2e-14
        for (_, tangents), t, k in ((ends[0], row[0], 0), (ends[1], row[1], 1)):
            velocity = jet(t)[:, 1]
            assert np.linalg.norm(tangents[k] - velocity / np.linalg.norm(velocity)) <= 2e-14
        assert left[14] < 2 * math.pi
        assert right[14] < 2 * math.pi
        assert previous is None or row[0] == previous
        previous = row[1]


COUNTS = [
    (
        CONICAL, math.pi / 6, 2 * math.pi, 0.851459,
        {1e-2: (5, 4), 1e-4: (20, 19), 1e-6: (87, 86), 1e-8: (397, 396)},
    ),
    (MOMENT, 0.0, 1.0, 0.248087, {1e-2: (2, 2), 1e-4: (7, 6), 1e-6: (27, 25), 1e-8: (117, 116)}),
    (MOMENT, 1.0, 2.0, 0.257807, {1e-2: (3, 2), 1e-4: (8, 6), 1e-6: (28, 26), 1e-8: (121, 120)}),
]  # fmt: skip


@pytest.mark.parametrize("text, a, b, c, counts", COUNTS, ids=["conical", "moment 0", "moment 1"])
def test_counts_of_the_theory(text, a, b, c, counts):
    for tolerance, expected in counts.items():
        found = tuple(len(spline_of(text, a, b, tolerance, rule)[0]) for rule in (THESIS, EQUIOSCILLATING))
        assert found == expected
        if tolerance <= 1e-3:
            assert found[1] == math.ceil(c * tolerance ** (-1 / 3))


@pytest.mark.parametrize("tolerance", [1e-3, 1e-5, 1e-7])
@pytest.mark.parametrize(
    "text, a, b, c", [case[:4] for case in COUNTS], ids=["conical", "moment 0", "moment 1"]
)
def test_the_equioscillating_rule_attains_the_law(text, a, b, c, tolerance):
    assert len(spline_of(text, a, b, tolerance, EQUIOSCILLATING)[0]) == math.ceil(c * tolerance ** (-1 / 3))


@BOTH
@pytest.mark.parametrize("text, a, b", [case[:3] for case in COUNTS], ids=["conical", "moment 0", "moment 1"])
def test_pieces_are_joined_and_their_errors_true(text, a, b, rule):
    tolerance = 1e-4
    table, jet = spline_of(text, a, b, tolerance, rule)
    check_chain(table, jet)
    for row in table:  # chords leave the curve by up to 3e-10
        assert independent_error(row, jet, 20001) == pytest.approx(row[2], rel=1e-6, abs=3e-10)
        assert row[2] == max(row[5], row[6])
    assert independent_error(table[0], jet, 200001) == pytest.approx(table[0, 2], rel=1e-6)
    inner = table[table[:, bihelix_spline.REASON] == bihelix_spline.ENDS_AT_TOLERANCE]
    assert len(inner) >= len(table) - 1
    assert inner[:, 2].max() <= tolerance
    assert inner[:, 2].min() >= tolerance * (1 - 1e-6)
    if rule == EQUIOSCILLATING:
        assert np.allclose(inner[:, 5], inner[:, 6], rtol=2e-3)


def one_arc(text, a, b):
    jet = compile_jet(parse_tuple(text), 3)
    source = (jet.address, (0.0, 0.0, 0.0, 1.0, NOISE), np.empty(JET_SIZE))
    return jet, source, frame(source, a), frame(source, b), arc_length.workspace()


@pytest.mark.parametrize("text, a, b", [(MOMENT, 1.0, 1.1), (CONICAL, 2.0, 2.5), ("t, t^2, t^3", 0.2, 0.5)])
def test_the_reference_has_the_same_peaks(text, a, b):
    jet, source, left, right, lengths = one_arc(text, a, b)
    sigma = arc_length.measure_lengths(source, a, b, lengths)
    exact = reference.SpaceArc(parse_tuple(text), mp.mpf(a), mp.mpf(b))
    assert jet.address == source[0]  # the code lives as long as the jet
    assert sigma == pytest.approx(float(exact.sigma), rel=1e-12)
    for part in (0.1, 0.5, 0.77):
        t = arc_length.after(lengths, a, b, part * sigma, sigma)
        assert t == pytest.approx(float(exact.after(part * exact.sigma)), rel=1e-10)
    found, two = bihelix(THESIS, source, a, left, b, right, sigma, 0.0, lengths)
    expected = [float(x) for x in reference.peaks(exact, reference.thesis_bihelix(exact))]
    assert found
    assert peaks(source, a, b, two, 8)[:2] == pytest.approx(expected, rel=1e-7)
    first, second, _, trusted, two = best(EQUIOSCILLATING, source, a, left, b, right, 0.0, 1e-7, 8, lengths)
    equal = max(reference.peaks(exact, reference.equioscillating_bihelix(exact)))
    assert trusted
    assert (first, second) == pytest.approx((float(equal),) * 2, rel=1e-5)
    assert two_sided(source, a, b, sigma, two) == pytest.approx(max(first, second), rel=1e-7)


def test_the_junction_point_is_in_both_planes():
    rng = np.random.default_rng(3)
    for _ in range(20):
        points = [tuple(map(float, p)) for p in rng.normal(size=(3, 3))]
        t_left, t_right, tangent = (tuple(map(float, v / np.linalg.norm(v))) for v in rng.normal(size=(3, 3)))
        left, right = (points[0], t_left), (points[1], t_right)
        step, w = offset(left, right, tangent, points[2])
        p = np.add(points[2], step)
        assert abs(np.dot(p - points[0], np.subtract(tangent, t_left))) < 1e-12
        assert abs(np.dot(points[1] - p, np.subtract(t_right, tangent))) < 1e-12
        assert abs(np.dot(step, w)) < 1e-12  # nearest


coefficients = st.tuples(*[st.floats(-1, 1)] * 9)


def smooth_text(c):
    """A regular curve: the speed's x part is at least 1/2."""
    y = f"({c[0]:.6f})*t^2+({c[1]:.6f})*t^3+({c[2]:.6f})*sin(2*t)+({c[3]:.6f})*cos(3*t)"
    z = f"({c[4]:.6f})*t^2+({c[5]:.6f})*t^3+({c[6]:.6f})*sin(3*t)+({c[7]:.6f})*cos(2*t)"
    return f"t+({c[8]:.6f})*sin(t)/2, {y}, {z}"


@settings(max_examples=15, deadline=None)
@given(coefficients, st.sampled_from([1e-1, 1e-2, 1e-3]), st.sampled_from([THESIS, EQUIOSCILLATING]))
def test_random_smooth_curves(c, tolerance, rule):
    table, jet = spline_of(smooth_text(c), 0.0, 2.0, tolerance, rule)
    check_chain(table, jet)
    assert table[:, 2].max() <= tolerance
    for row in table[:: max(1, len(table) // 4)]:
        found = independent_error(row, jet, 4001)
        chords = max(h[15] * (h[13] / 2000) ** 2 / 8 for h in helices(row))  # of the oracle's polygons
        assert found == pytest.approx(row[2], rel=1e-4, abs=1e-9 + 2 * chords)


@BOTH
def test_short_arcs_from_an_inflection_have_a_bihelix(rule):
    text = "t, sin(2*t), t^3+sin(3*t)"  # κ = 0 with torsion at 0: the junction planes are nearly parallel
    jet, source, left, _, lengths = one_arc(text, 0.0, 1.0)
    slope = 829**0.5 / 14**2  # κ′ at 0
    for b in (0.004, 0.01, 0.02, 0.05):
        right = frame(source, b)
        sigma = arc_length.measure_lengths(source, 0.0, b, lengths)
        first, second, _, trusted, _ = best(rule, source, 0.0, left, b, right, 0.0, 1e-6, 8, lengths)
        assert trusted
        law = slope * sigma**3 / 324
        assert 0.9 * law <= max(first, second) <= (1.1 if rule == EQUIOSCILLATING else 2.0) * law
    assert jet.address == source[0]
    for tolerance in (1e-1, 1e-2, 1e-4, 1e-6):
        table, jet = spline_of(text, 0.0, 2.0, tolerance, rule)
        check_chain(table, jet)
        for row in table[:3]:
            assert row[2] <= tolerance
            assert independent_error(row, jet, 8001) == pytest.approx(row[2], rel=1e-4, abs=1e-9)
            assert row[1] - row[0] > 0.2 * tolerance ** (1 / 3)


def test_a_helix_that_no_point_of_the_curve_sees_is_not_trusted():
    text = smooth_text((0, 0, 0, 0, 0, 0, 1, 1, 0))
    a, b = 0.590424034, 1.29040685
    jet, source, left, right, lengths = one_arc(text, a, b)
    sigma = arc_length.measure_lengths(source, a, b, lengths)
    found, two = bihelix(THESIS, source, a, left, b, right, sigma, 0.0, lengths)
    assert found
    assert two[2] - a < 1e-8  # the junction is behind the left end, and the left helix turns by 6 radians
    first, second, trusted = peaks(source, a, b, two, 8)
    careful = two_sided(source, a, b, sigma, two)
    assert careful > 3 * max(first, second)
    assert not trusted
    table = np.empty((1, bihelix_spline.COLUMNS))
    place = (0.0, 0.0, 0.0, 1.0, NOISE)
    start, last = end_frame(jet, a), end_frame(jet, b)
    bihelix_spline.spline(THESIS, jet.address, place, a, start, b, last, 0.9, 1.0, 0.0, table)
    assert table[0, 2] == pytest.approx(independent_error(table[0], jet, 8001), rel=1e-5)


@BOTH
def test_chords_of_unevenly_run_lines(rule):
    table, jet = spline_of("t^3+t, 2*t^3+2*t, 1+0*t", -0.5, 2.0, 1e-6, rule)
    check_chain(table, jet)
    assert len(table) == 1
    assert table[0, 2] < 1e-14


def test_a_peak_next_to_the_junction_is_seen():
    c = (0.3746852, 0.9359453, -0.2919761, 0.3704396, -0.1440259, 0.9853371, -0.0332468, 0.492025, -0.7594254)
    table, jet = spline_of(smooth_text(c), 0.0, 2.0, 0.0106, EQUIOSCILLATING)
    for row in table:
        assert independent_error(row, jet, 8001) == pytest.approx(row[2], rel=1e-5)


@settings(max_examples=10, deadline=None)
@given(st.floats(0.2, 3), st.floats(-3, 3), st.floats(3, 40), st.sampled_from([THESIS, EQUIOSCILLATING]))
def test_random_helices_are_their_own_splines(radius, pitch, turning, rule):
    table, jet = spline_of(
        f"{radius:.6f}*cos(t), {radius:.6f}*sin(t), ({pitch:.6f})*t", 0.0, turning, 1e-6, rule
    )
    check_chain(table, jet)
    assert len(table) == math.ceil(turning / (1.98 * math.pi))
    assert table[:, 2].max() < 1e-12
    hand = [0.0 if abs(pitch) < 1e-6 else math.copysign(1, pitch)]
    assert all(np.sign(h[16]) in (*hand, 0.0) for row in table for h in helices(row))


@BOTH
def test_scales_mirrors_and_reversed_curves(rule):
    table, _ = spline_of(CONICAL, 1.0, 5.0, 1e-4, rule)
    for factor in (1e-6, 1e6):
        text = f"{factor:.0e}*t*cos(t), {factor:.0e}*t*sin(t), {factor:.0e}*t".replace("e-06", "e-6")
        other, _ = spline_of(text, 1.0, 5.0, 1e-4 * factor, rule)
        assert len(other) == len(table)
        assert other[:-1, 1] == pytest.approx(table[:-1, 1], rel=1e-6)
    other, jet = spline_of("t*cos(t), t*sin(t), -t", 1.0, 5.0, 1e-4, rule)
    check_chain(other, jet)
    assert other[:-1, 1] == pytest.approx(table[:-1, 1], rel=1e-6)
    for row, mirrored in zip(table, other):
        for h, g in zip(helices(row), helices(mirrored)):
            assert g[16] == pytest.approx(-h[16], rel=1e-3)
    text = "(6-t)*cos(6-t), (6-t)*sin(6-t), 6-t"
    other, jet = spline_of(text, 1.0, 5.0, 1e-4, rule)
    check_chain(other, jet)
    assert abs(len(other) - len(table)) <= 1


@BOTH
@pytest.mark.parametrize(
    "text",
    ["t, t^2, 0*t", "t^2, 3, t", "t+t^2, t^2-t, t^2+2*t+1", "(3*cos(t)+4*sin(t))/5, 2*sin(t)*3/5, t^2*0"],
)
def test_plane_curves_have_plane_biarcs(text, rule):
    table, jet = spline_of(text, -1.0, 2.0, 1e-5, rule)
    check_chain(table, jet)
    for row in table:
        assert all(h[16] == 0.0 for h in helices(row))
        assert independent_error(row, jet, 4001) == pytest.approx(row[2], rel=1e-3, abs=1e-10)


@BOTH
def test_lines_and_circles(rule):
    table, jet = spline_of("t, 2*t-1, 3*t^2/3-t^2", -1.0, 4.0, 1e-6, rule)
    check_chain(table, jet)
    assert len(table) == 1
    assert table[0, 2] < 1e-14
    table, jet = spline_of("2*cos(t), 2*sin(t), 1+0*t", 0.0, 6.0, 1e-6, rule)
    check_chain(table, jet)
    assert len(table) == 1
    assert table[0, 2] < 1e-13
    assert [h[15] for h in helices(table[0])] == pytest.approx([0.5, 0.5])


@BOTH
def test_a_tolerance_larger_than_the_curve_gives_one_measured_piece(rule):
    table, jet = spline_of(CONICAL, math.pi / 6, math.pi, 50.0, rule)
    assert len(table) == 1
    assert table[0, bihelix_spline.REASON] == bihelix_spline.ENDS_AT_STRETCH
    assert independent_error(table[0], jet, 8001) == pytest.approx(table[0, 2], rel=1e-5)


@BOTH
def test_vertices_and_inflections_inside(rule):
    for text in ("2*cos(t), sin(t), 0*t", "t, t^3, 0*t", "t, t^3, t^5", "t, sin(t), t^4"):
        table, jet = spline_of(text, -1.5, 2.0, 1e-4, rule)
        check_chain(table, jet)
        assert table[:, 2].max() <= 1e-4
        for row in table:
            assert independent_error(row, jet, 4001) == pytest.approx(row[2], rel=1e-3, abs=1e-9)


def test_a_full_table_is_continued():
    whole, jet = spline_of(MOMENT, 0.0, 1.0, 1e-4, EQUIOSCILLATING)
    place, largest = place_of(jet, 0.0, 1.0)
    table = np.empty((2, bihelix_spline.COLUMNS))
    count, reached, _ = bihelix_spline.spline(
        EQUIOSCILLATING, jet.address, place, 0.0, end_frame(jet, 0.0), 1.0, end_frame(jet, 1.0),
        *window(1e-4, math.ulp(largest)), 0.0, table,
    )  # fmt: skip
    assert (count, reached) == (2, table[1, 1])
    assert table[:, 1] == pytest.approx(whole[:2, 1], rel=1e-12)


def test_nothing_is_found_where_the_curve_is_undefined():
    jet = compile_jet(parse_tuple("t, sqrt(t-1/2), t^2"), 3)
    table = np.empty((9, bihelix_spline.COLUMNS))
    place = (0.0, 0.0, 0.0, 1.0, NOISE)
    count, reached, _ = bihelix_spline.spline(
        THESIS, jet.address, place, 0.0, (0.0, 0.0, 0.0, 1.0, 0.0, 0.0), 1.0, end_frame(jet, 1.0),
        0.9e-3, 1e-3, 0.0, table,
    )  # fmt: skip
    assert (count, reached) == (0, 0.0)
