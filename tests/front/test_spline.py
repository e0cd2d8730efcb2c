"""Pieces and splines: geometry, evaluation, files."""

from __future__ import annotations

import json
import math
import sys
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError, OsculantError
from osculant.pieces.conics import Piece, classify
from tests.front.samples import circle, pieces, spline_of
from tests.oracles import hausdorff


@given(pieces())
def test_the_point_satisfies_the_rational_bezier_form(piece):
    u = np.linspace(0, 1, 33)
    b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
    p0, m, p2 = map(np.array, (piece.start, piece.middle, piece.end))
    expected = (b0[:, None] * p0 + b1[:, None] * m + b2[:, None] * p2) / (b0 + piece.weight * b1 + b2)[
        :, None
    ]
    scale = np.abs([p0, m, p2]).max() / (1 + min(piece.weight, 0))
    assert piece.sample(33) == pytest.approx(expected, abs=1e-13 * scale)
    assert tuple(piece.point(0.0)) == piece.start
    assert tuple(piece.point(1.0)) == piece.end


@given(pieces())
def test_the_tangent_is_the_direction_of_the_derivative(piece):
    u = np.linspace(0.05, 0.95, 19)
    step = 1e-6
    secant = piece.point(u + step) - piece.point(u - step)
    secant /= np.hypot(*secant.T)[:, None]
    assert piece.tangent(u) == pytest.approx(secant, abs=1e-4)
    assert np.hypot(*piece.tangent(u).T) == pytest.approx(1)


@given(pieces())
def test_the_first_tangent_leads_to_the_control_point(piece):
    v = np.array(piece.middle) - piece.weight * np.array(piece.start)
    assert piece.tangent(0.0) == pytest.approx(v / math.hypot(*v), abs=1e-8)


@given(pieces())
def test_the_box_touches_the_arc_and_holds_it(piece):
    (left, bottom), (right, top) = piece.bounding_box()
    points = piece.sample(4001)
    size = max(right - left, top - bottom)
    low, high = points.min(axis=0), points.max(axis=0)
    slack = 1e-12 * np.abs(points).max()
    assert np.all(low >= np.array([left, bottom]) - slack)
    assert np.all(high <= np.array([right, top]) + slack)
    assert low == pytest.approx([left, bottom], abs=1e-3 * size)
    assert high == pytest.approx([right, top], abs=1e-3 * size)


def test_an_arc_beyond_half_a_turn_is_ordinary():
    piece = circle(0.0, 1.9 * math.pi)
    assert piece.weight < 0
    assert np.hypot(*piece.sample(100).T) == pytest.approx(1, abs=1e-14)
    assert np.ravel(piece.bounding_box()) == pytest.approx([-1, -1, 1, 1], abs=1e-14)
    assert piece.control_point == pytest.approx((1, math.tan(0.95 * math.pi)))


def test_parallel_end_tangents_have_no_control_point():
    piece = Piece("ellipse", (0, 1), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), 0.0, 0.0)
    assert piece.control_point is None
    assert piece.to_json()["points"][1] is None
    assert piece.tangent([0.0, 1.0]) == pytest.approx(np.array([[0, 1], [0, -1]]))


def test_figures_survive_a_distant_origin():
    near, far = circle(0.3, 0.9), circle(0.3, 0.9, shift=2.0**20)
    u = np.linspace(0, 1, 9)
    assert far.point(u) - 2.0**20 == pytest.approx(near.point(u), abs=4 * math.ulp(2.0**20))


@pytest.mark.parametrize("weight", [-1.0, -2.0, math.nan, math.inf])
def test_unbounded_arcs_are_refused(weight):
    with pytest.raises(DomainError, match="weight above -1"):
        Piece("hyperbola", (0, 1), (0.0, 0.0), (1.0, 0.0), (0.5, 1.0), weight, 0.0)


def test_kinds():
    assert classify(1.0) == classify(math.nextafter(1, 2)) == classify(math.nextafter(1, 0)) == "parabola"
    assert (classify(1 - 1e-14), classify(1 + 1e-14)) == ("ellipse", "hyperbola")
    with pytest.raises(DomainError, match="'circle'"):
        Piece("circle", (0, 1), (0.0, 0.0), (1.0, 0.0), (0.5, 1.0), 1.0, 0.0)


@pytest.fixture
def arcs():
    """Four arcs of the unit circle, of different turning."""
    angles = [0.0, 0.5, 2.0, 5.5, 6.0]
    return spline_of([circle(a, b) for a, b in pairwise(angles)], text="cos(t), sin(t)")


def test_what_a_spline_says_of_itself(arcs):
    assert len(arcs) == 4
    assert arcs.knots == [0.0, 0.5, 2.0, 5.5, 6.0]
    assert arcs.errors == [0.0] * 4
    assert (arcs.error, arcs.error_kind) == (0.0, "exact")
    assert repr(arcs) == "<Spline of cos(t), sin(t): conic, 4 pieces, error 0, tolerance 1e-06>"
    assert np.ravel(arcs.bounding_box()) == pytest.approx([-1, -1, 1, 1], abs=1e-14)
    assert spline_of([circle(0, 1, error=1e-9)]).error_kind == "estimate"


def test_the_prediction_is_computed_once_and_late():
    calls = []

    def predict():
        calls.append(1)
        return SimpleNamespace(predicted=3.25, predicted_pieces=5)

    spline = spline_of([circle(0, 1)], predict=predict)
    assert not calls
    assert (spline.predicted, spline.predicted_pieces, spline.predicted) == (3.25, 5, 3.25)
    assert len(calls) == 1
    assert spline_of([circle(0, 1)]).predicted is None


def test_evaluation_joins_the_pieces(arcs):
    t = np.linspace(0, 6, 601)
    points = arcs.evaluate(t)
    assert points.shape == (601, 2)
    assert np.hypot(*points.T) == pytest.approx(1, abs=1e-14)
    # An arc's own parameter, symmetric in its middle, is the affine one.
    assert arcs.evaluate(1.25) == pytest.approx([math.cos(1.25), math.sin(1.25)])
    assert arcs.evaluate([[0.0, 6.0]]).tolist() == [[list(arcs.pieces[0].start), list(arcs.pieces[-1].end)]]
    for piece in arcs.pieces:
        a, b = piece.interval
        assert arcs.evaluate(a + 0.3 * (b - a)) == pytest.approx(piece.point(0.3), abs=1e-15)


@pytest.mark.parametrize("t", [-1e-9, 6.1, math.nan])
def test_evaluation_outside_is_an_error(arcs, t):
    with pytest.raises(DomainError, match=f"t = {t!r}"):
        arcs.evaluate([1.0, t])


def test_samples_have_the_knots_once(arcs):
    points = arcs.sample(5)
    assert points.shape == (17, 2)
    assert points[4::4].tolist() == [list(piece.end) for piece in arcs.pieces]
    assert points[4:9] == pytest.approx(arcs.pieces[1].sample(5))


def test_tangents_jump_only_where_they_should(arcs):
    assert arcs.max_tangent_jump() < 1e-14
    assert arcs.cusps == []
    kinked = spline_of([circle(0, 1), Piece.segment((1, 2), circle(0, 1).end, (2.0, 2.0))])
    assert kinked.max_tangent_jump() > 0.1
    # Two arcs of the parabola y = x², there and back.
    there = Piece("parabola", (0, 1), (0.0, 0.0), (1.0, 1.0), (0.5, 0.0), 1.0, 0.0)
    back = Piece("parabola", (1, 2), (1.0, 1.0), (0.0, 0.0), (0.5, 0.0), 1.0, 0.0)
    cusped = spline_of([there, back])
    assert cusped.max_tangent_jump() < 1e-15
    assert cusped.cusps == [1.0]


def test_json_has_the_promised_keys_and_exact_numbers(arcs, tmp_path):
    path = tmp_path / "arcs.JSON"
    arcs.write(path)
    data = json.loads(path.read_text())
    assert list(data) == [
        "curve", "primitive", "rule", "closed", "corner", "split", "given", "gap", "choice", "metric",
        "tolerance", "reserved", "pieces", "arcs", "knots", "error", "error_kind", "errors", "predicted",
        "predicted_pieces", "predicted_error", "minimal", "undecided", "bridged", "max_tangent_jump",
        "splits", "cusps", "segments",
        "certificate",
    ]  # fmt: skip
    assert (data["pieces"], data["knots"], data["certificate"]) == (4, arcs.knots, None)
    for segment, piece in zip(data["segments"], arcs.pieces):
        assert list(segment) == ["kind", "interval", "points", "middle", "weight", "error"]
        assert tuple(segment["middle"]) == piece.middle
        assert tuple(segment["points"][2]) == piece.end
        assert segment["weight"] == piece.weight


def test_an_infinite_prediction_is_null():
    spline = spline_of(
        [circle(0, 1)], predict=lambda: SimpleNamespace(predicted=math.inf, predicted_pieces=0)
    )
    assert spline.to_json()["predicted"] is None


def test_files_are_whole_or_absent(arcs, tmp_path):
    for name in ("a.svg", "a.json"):
        arcs.write(tmp_path / name)
    arcs.write(tmp_path / "a.svg")  # replaced
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.svg"]
    (tmp_path / "folder.svg").mkdir()
    with pytest.raises(OsculantError, match=r"folder\.svg: Is a directory"):
        arcs.write(tmp_path / "folder.svg")
    with pytest.raises(OsculantError, match=r"missing/a\.svg: No such file or directory"):
        arcs.write(tmp_path / "missing" / "a.svg")
    with pytest.raises(OsculantError, match=r"a\.step: the known suffixes are \.svg, \.json, "):
        arcs.write(tmp_path / "a.step")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.svg", "folder.svg"]


def test_a_link_is_written_through(arcs, tmp_path):
    (tmp_path / "real.svg").write_text("old")
    (tmp_path / "link.svg").symlink_to("real.svg")
    arcs.write(tmp_path / "link.svg")
    assert (tmp_path / "link.svg").is_symlink()
    assert (tmp_path / "real.svg").read_text().startswith("<?xml")


def test_plots(arcs, tmp_path):
    pytest.importorskip("matplotlib")
    axes = arcs.plot(tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert len(axes.lines) == 5
    assert arcs.plot(axes=axes) is axes
    assert len(axes.lines) == 10
    with pytest.raises(OsculantError, match=r"Cannot draw to .*\.xyz"):
        arcs.plot(tmp_path / "a.xyz")


def test_plotting_without_matplotlib_says_what_to_install(arcs, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(OsculantError, match=r"pip install osculant\[plot\]"):
        arcs.plot()


@given(st.floats(0.2, 5.5), st.floats(-9, -2), st.floats(0, 6))
@settings(max_examples=12, deadline=None)
def test_the_oracle_measures_known_distances(angle, exponent, start):
    """A circle against arcs of a larger one, shifted: distances known in closed form."""
    gap = 10**exponent
    angles = np.linspace(start, start + angle, 4)
    arcs = [circle(a, b, radius=1 + gap) for a, b in pairwise(angles)]
    distance = hausdorff(lambda t: (np.cos(t), np.sin(t)), arcs)
    assert distance == pytest.approx(gap, rel=1e-6, abs=1e-15)


def test_the_oracle_sees_both_sides():
    """The parabola y = x² against its chord: the farthest point is on the parabola, 1/(4√2) away."""
    chord = [Piece.segment((0, 1), (0.0, 0.0), (1.0, 1.0))]
    assert hausdorff(lambda t: (t, t * t), chord) == pytest.approx(0.25 / 2**0.5, rel=1e-9)
    long_chord = [Piece.segment((0, 1), (0.0, 0.0), (2.0, 2.0))]
    assert hausdorff(lambda t: (t, t * t), long_chord) == pytest.approx(2**0.5, rel=1e-9)
    # A cusp of the curve, met by the end of a segment.
    assert hausdorff(
        lambda t: (t**2, t**3), [Piece.segment((0, 1), (0.0, 0.0), (1.0, 1.0))]
    ) == pytest.approx(max((t**2 - t**3) / 2**0.5 for t in np.linspace(0, 1, 30001)), rel=1e-6)
