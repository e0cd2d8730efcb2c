"""Splines of bihelices: the tables of the theory, and an independent distance."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.kernels import search
from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS
from osculant.kernels.bihelices.records import COLUMNS, PEAKS, Bihelix
from osculant.kernels.curves.space import Frame
from osculant.kernels.operations import ERROR, REASON, B
from osculant.kernels.search import ENDS_AT_STRETCH, ENDS_AT_TOLERANCE
from osculant.tolerances import window
from tests.kernels.arcs import SPACE, frame_at, jet_of, spline
from tests.kernels.bihelices.chains import (
    BOTH,
    CONICAL,
    MOMENT,
    check_chain,
    helices,
    independent_error,
    place_of,
    smooth_text,
    spline_of,
)

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
        assert independent_error(row, jet, 20001) == pytest.approx(row[ERROR], rel=1e-6, abs=3e-10)
        assert row[ERROR] == pytest.approx(max(row[PEAKS], row[PEAKS + 1]), rel=1e-15)
    assert independent_error(table[0], jet, 200001) == pytest.approx(table[0, ERROR], rel=1e-6)
    inner = table[table[:, REASON] == ENDS_AT_TOLERANCE]
    assert len(inner) >= len(table) - 1
    assert inner[:, ERROR].max() <= tolerance
    assert inner[:, ERROR].min() >= tolerance * (1 - 1e-6)
    if rule == EQUIOSCILLATING:
        assert np.allclose(inner[:, PEAKS], inner[:, PEAKS + 1], rtol=2e-3)


coefficients = st.tuples(*[st.floats(-1, 1)] * 9)


@settings(max_examples=15, deadline=None)
@given(coefficients, st.sampled_from([1e-1, 1e-2, 1e-3]), st.sampled_from([THESIS, EQUIOSCILLATING]))
def test_random_smooth_curves(c, tolerance, rule):
    table, jet = spline_of(smooth_text(c), 0.0, 2.0, tolerance, rule)
    check_chain(table, jet)
    assert table[:, ERROR].max() <= tolerance
    for row in table[:: max(1, len(table) // 4)]:
        found = independent_error(row, jet, 4001)
        chords = max(
            h.curvature * (h.length / 2000) ** 2 / 8 for h in helices(row)
        )  # of the oracle's polygons
        assert found == pytest.approx(row[ERROR], rel=1e-4, abs=1e-9 + 2 * chords)


@BOTH
def test_chords_of_unevenly_run_lines(rule):
    table, jet = spline_of("t^3+t, 2*t^3+2*t, 1+0*t", -0.5, 2.0, 1e-6, rule)
    check_chain(table, jet)
    assert len(table) == 1
    assert table[0, ERROR] < 1e-14


def test_a_peak_next_to_the_junction_is_seen():
    c = (0.3746852, 0.9359453, -0.2919761, 0.3704396, -0.1440259, 0.9853371, -0.0332468, 0.492025, -0.7594254)
    table, jet = spline_of(smooth_text(c), 0.0, 2.0, 0.0106, EQUIOSCILLATING)
    for row in table:
        assert independent_error(row, jet, 8001) == pytest.approx(row[ERROR], rel=1e-5)


@settings(max_examples=10, deadline=None)
@given(st.floats(0.2, 3), st.floats(-3, 3), st.floats(3, 40), st.sampled_from([THESIS, EQUIOSCILLATING]))
def test_random_helices_are_their_own_splines(radius, pitch, turning, rule):
    table, jet = spline_of(
        f"{radius:.6f}*cos(t), {radius:.6f}*sin(t), ({pitch:.6f})*t", 0.0, turning, 1e-6, rule
    )
    check_chain(table, jet)
    assert len(table) == math.ceil(turning / (1.98 * math.pi))
    assert table[:, ERROR].max() < 1e-12
    hand = [0.0 if abs(pitch) < 1e-6 else math.copysign(1, pitch)]
    assert all(np.sign(h.torsion) in (*hand, 0.0) for row in table for h in helices(row))


@BOTH
def test_scales_mirrors_and_reversed_curves(rule):
    table, _ = spline_of(CONICAL, 1.0, 5.0, 1e-4, rule)
    for factor in (1e-6, 1e6):
        text = f"{factor:.0e}*t*cos(t), {factor:.0e}*t*sin(t), {factor:.0e}*t".replace("e-06", "e-6")
        other, _ = spline_of(text, 1.0, 5.0, 1e-4 * factor, rule)
        assert len(other) == len(table)
        assert other[:-1, B] == pytest.approx(table[:-1, B], rel=1e-6)
    other, jet = spline_of("t*cos(t), t*sin(t), -t", 1.0, 5.0, 1e-4, rule)
    check_chain(other, jet)
    assert other[:-1, B] == pytest.approx(table[:-1, B], rel=1e-6)
    for row, mirrored in zip(table, other):
        for h, g in zip(helices(row), helices(mirrored)):
            assert g.torsion == pytest.approx(-h.torsion, rel=1e-3)
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
        assert all(h.torsion == 0.0 for h in helices(row))
        assert independent_error(row, jet, 4001) == pytest.approx(row[ERROR], rel=1e-3, abs=1e-10)


@BOTH
def test_lines_and_circles(rule):
    table, jet = spline_of("t, 2*t-1, 3*t^2/3-t^2", -1.0, 4.0, 1e-6, rule)
    check_chain(table, jet)
    assert len(table) == 1
    assert table[0, ERROR] < 1e-14
    table, jet = spline_of("2*cos(t), 2*sin(t), 1+0*t", 0.0, 6.0, 1e-6, rule)
    check_chain(table, jet)
    assert len(table) == 1
    assert table[0, ERROR] < 1e-13
    assert [h.curvature for h in helices(table[0])] == pytest.approx([0.5, 0.5])


@BOTH
def test_a_tolerance_larger_than_the_curve_gives_one_measured_piece(rule):
    table, jet = spline_of(CONICAL, math.pi / 6, math.pi, 50.0, rule)
    assert len(table) == 1
    assert table[0, REASON] == ENDS_AT_STRETCH
    assert independent_error(table[0], jet, 8001) == pytest.approx(table[0, ERROR], rel=1e-5)


@BOTH
def test_vertices_and_inflections_inside(rule):
    for text in ("2*cos(t), sin(t), 0*t", "t, t^3, 0*t", "t, t^3, t^5", "t, sin(t), t^4"):
        table, jet = spline_of(text, -1.5, 2.0, 1e-4, rule)
        check_chain(table, jet)
        assert table[:, ERROR].max() <= 1e-4
        for row in table:
            assert independent_error(row, jet, 4001) == pytest.approx(row[ERROR], rel=1e-3, abs=1e-9)


def test_a_full_table_is_continued():
    whole, jet = spline_of(MOMENT, 0.0, 1.0, 1e-4, EQUIOSCILLATING)
    place, largest = place_of(jet, 0.0, 1.0)
    errors = tuple(place.scale * error for error in window(1e-4, math.ulp(largest)))
    part, reached, _ = spline(Bihelix(EQUIOSCILLATING), jet, 0.0, 1.0, errors, place, 2)
    assert (len(part), reached) == (2, part[1, B])
    assert part[:, B] == pytest.approx(whole[:2, B], rel=1e-12)


def test_nothing_is_found_where_the_curve_is_undefined():
    jet = jet_of("t, sqrt(t-1/2), t^2", 3)
    start, last = Frame((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)), frame_at(jet, 1.0, SPACE)
    table, course = np.empty((9, COLUMNS)), np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 1.0]])
    count, reached, _ = search.spline(
        Bihelix(THESIS), jet.address, SPACE, 0.0, start, 1.0, last, 0.9e-3, 1e-3, 0.1, course, table
    )
    assert (count, reached) == (0, 0.0)
