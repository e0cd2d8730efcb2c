"""Inscribed polygons: counts and areas of the theory, errors against a dense independent check, files."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon

import osculant as osc
from osculant.cas.errors import DomainError

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
CONE = ("t*cos(t), t*sin(t), t", "pi/6", "2*pi")


def distance_from_chord(curve, piece, count=4001):
    """The largest distance of the arc's points from the segment between its ends."""
    points = curve.jets(np.linspace(*piece.interval, count))[..., 0]
    start, end = np.array(piece.start), np.array(piece.end)
    step = end - start
    part = np.clip((points - start) @ step / (step @ step), 0.0, 1.0)
    return np.linalg.norm(points - start - part[:, None] * step, axis=1).max()


def check(curve, spline, some=40):
    """Vertices lie on the curve, errors are those of a dense check, and within the tolerance."""
    assert spline.error <= spline.tolerance
    size = max(abs(side) for corner in spline.bounding_box() for side in corner)
    ends = curve.jets(spline.knots)[..., 0]
    vertices = np.array([spline.pieces[0].start, *(piece.end for piece in spline.pieces)])
    assert np.abs(ends - vertices).max() <= 1e-12 * size
    for piece in spline.pieces[:: max(1, len(spline) // some)]:
        assert all(arc.kind == "segment" for arc in piece.arcs)
        assert distance_from_chord(curve, piece) == pytest.approx(piece.error, rel=1e-5, abs=1e-13 * size)


@pytest.mark.parametrize(
    ("tolerance", "theory"), [(1e-2, 39.8), (1e-3, 125.9), (1e-4, 398.3), (1e-5, 1259.4), (1e-6, 3982.7)]
)
def test_counts_on_the_spiral(tolerance, theory):
    curve = osc.curve(*SPIRAL)
    spline = osc.approximate(curve, "polygon", tolerance)
    assert spline.predicted == pytest.approx(theory, abs=0.06)
    assert len(spline) == math.ceil(spline.predicted) == spline.predicted_pieces
    assert spline.minimal == "by theory" and spline.rule == "inscribed" and not spline.splits
    check(curve, spline)


def test_areas_on_the_spiral():
    curve = osc.curve(*SPIRAL)
    assert osc.complexity(curve, "polygon", metric="area").constant == pytest.approx(14.6099, abs=5e-5)
    for tolerance in (1e-1, 1e-3):
        spline = osc.approximate(curve, "polygon", tolerance, metric="area")
        assert len(spline) == math.ceil(14.60991524 / math.sqrt(tolerance))
        for piece in spline.pieces[:5]:
            points = curve.jets(np.linspace(*piece.interval, 20001))[..., 0]
            assert Polygon(points).area == pytest.approx(piece.error, rel=1e-6)


def test_counts_in_space_and_the_law():
    curve = osc.curve(*CONE)
    for tolerance in (1e-2, 1e-4):
        spline = osc.approximate(curve, "polygon", tolerance)
        assert abs(len(spline) - spline.predicted) < 1.0 + 1e-3 * len(spline)
        check(curve, spline)
    with pytest.raises(DomainError, match="metric 'area' is one of plane curves"):
        osc.approximate(curve, "polygon", 1e-2, metric="area")


def test_knots_at_inflections_and_cusps():
    """Across an inflection a chord's error is not monotone: from −1 it is 0.4 to 0.5, and 0.27 to 1."""
    cubic = osc.curve("t, t^3", -1, 1)
    assert osc.approximate(cubic, "polygon", 1e-3).splits == (0.0,)
    assert osc.approximate(osc.curve("t, t^3, 0", -1, 1), "polygon", 1e-3).splits == ()
    cusp = osc.curve("t^2, t^3", -1, 1)
    spline = osc.approximate(cusp, "polygon", 1e-3)
    assert spline.splits == (0.0,)
    check(cusp, spline)


def test_given_pieces_have_equal_errors_and_are_found_again():
    for formula in (SPIRAL, CONE):
        curve = osc.curve(*formula)
        spline = osc.approximate(curve, "polygon", pieces=17)
        assert max(spline.errors) - min(spline.errors) < 1e-8 * spline.error
        assert len(osc.approximate(curve, "polygon", spline.error * (1 + 1e-6))) == 17


def test_closed_curves_begin_anywhere():
    ellipse = osc.curve("2*cos(t), sin(t)", 0, "2*pi")
    spline = osc.approximate(ellipse, "polygon", 1e-3)
    assert spline.closed and spline.pieces[0].start == pytest.approx(spline.pieces[-1].end, abs=1e-12)
    assert len(spline) <= math.ceil(spline.predicted) + 1
    check(ellipse, spline)


def test_circles_turn_by_more_than_half_a_turn_for_large_tolerances():
    circle = osc.curve("cos(t), sin(t)", 0, 40)
    spline = osc.approximate(circle, "polygon", 1.5)
    turning = np.diff(spline.knots)
    assert turning.max() == pytest.approx(4 * math.pi / 3, rel=1e-5)  # 1 − cos(half of it) = 1.5
    check(circle, spline)


def test_a_loop_has_no_chord_of_no_length():
    loop = osc.curve("t^2 - 1, t*(t^2 - 1)", -1, 1)
    for metric in ("hausdorff", "area"):
        spline = osc.approximate(loop, "polygon", 10.0, metric=metric, closed=False)
        assert len(spline) > 1 and spline.error <= 10.0


def test_polygons_are_no_candidates_of_the_best():
    best = osc.approximate(osc.curve(*SPIRAL), "best", 1e-1)
    assert "polygon" not in " ".join(best.choice)


def test_a_line_is_one_piece():
    for text in ("t, 2*t", "t, 2*t, 3*t"):
        spline = osc.approximate(osc.curve(text, 0, 1), "polygon", 1e-6)
        assert (len(spline), spline.error, spline.minimal) == (1, 0.0, "proved")


@settings(max_examples=25)
@given(st.tuples(*[st.integers(-9, 9)] * 4), st.sampled_from([1e-1, 1e-2, 1e-3]), st.booleans())
def test_random_curves(c, tolerance, space):
    text = f"t + {c[0]}*sin(t)/20, {c[1]}*t^2/4 + {c[2]}*cos(3*t)/9" + (f", {c[3]}*t^3/5" if space else "")
    curve = osc.curve(text, 0, 2)
    spline = osc.approximate(curve, "polygon", tolerance)
    check(curve, spline, some=8)
