"""The area metric: the tables' counts, and areas against polygons clipped by an independent library."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString
from shapely.ops import polygonize, unary_union

import osculant as osc
from osculant.cas.errors import DomainError, ToleranceError

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SEXTIC = ("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "-3*pi/4", "3*pi/4")
#: points on each piece and on its arc
POINTS = 4001


def clipped(curve, piece, points=POINTS):
    """(area between an arc and its piece, what polygons leave out at most), by polygons of many points."""
    a, b = piece.interval
    times = np.linspace(a, b, points)
    jets = np.array([[float(v) for v in curve(t)] for t in times])
    arcs = [arc.sample(points) for arc in piece.arcs]
    other = np.concatenate([arcs[0], *(arc[1:] for arc in arcs[1:])])
    jets[0], jets[-1] = other[0], other[-1]
    ring = unary_union([LineString(jets), LineString(other)])
    # chords cut off segments of the area κs³/12 each
    turning = math.acos(max(-1.0, min(1.0, float(piece.tangent(0.0) @ piece.tangent(1.0)))))
    length = float(np.hypot(*np.diff(jets, axis=0).T).sum())
    return sum(part.area for part in polygonize(ring)), 2 * (turning + 0.1) * length**2 / 12 / points**2


def spiral_point(t):
    return t * math.cos(t), t * math.sin(t)


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
@pytest.mark.parametrize("tolerance", [1e-1, 1e-3])
def test_areas_are_those_of_clipped_polygons(primitive, tolerance):
    spline = osc.approximate(osc.curve(*SPIRAL), primitive, tolerance, metric="area")
    assert spline.error == math.fsum(spline.errors) <= tolerance
    assert max(spline.errors) <= tolerance / len(spline)
    for piece in spline.pieces:
        area, resolution = clipped(spiral_point, piece)
        assert piece.error == pytest.approx(area, abs=2 * resolution, rel=1e-5)


@pytest.mark.parametrize("rule", ["equisymmetric", "minimal-area"])
def test_the_minimal_area_is_not_larger_and_its_moons_differ(rule):
    """On a long arc from a sextactic point on the rules differ by about 1.7e-3 (plane.md)."""
    half = osc.curve(*SEXTIC[:1], 0, "pi/2")
    pieces = {
        name: osc.approximate(half, "conic", pieces=1, metric="area", rule=name).pieces[0]
        for name in ("equisymmetric", "minimal-area")
    }
    piece = pieces[rule]

    def point(t):
        size = 4 * math.cos(t / 3) ** 3
        return size * math.cos(t), size * math.sin(t)

    area, resolution = clipped(point, piece, 40001)
    assert piece.error == pytest.approx(area, abs=2 * resolution, rel=1e-6)
    gain = pieces["equisymmetric"].error / pieces["minimal-area"].error - 1
    assert 3e-4 < gain < 1e-2


@pytest.mark.parametrize(
    ("primitive", "counts"),
    [("parabola", (9, 15, 26, 46, 82, 146)), ("conic", (4, 6, 9, 13, 21, 33))],
)
def test_the_spiral_as_in_table_3_2(primitive, counts):
    for power, count in enumerate(counts, 1):
        spline = osc.approximate(osc.curve(*SPIRAL), primitive, 10.0**-power, metric="area")
        assert (len(spline), spline.predicted_pieces, spline.minimal) == (count, count, "unknown")


@pytest.mark.parametrize(
    ("primitive", "counts"),
    [("parabola", (8, 13, 23, 40, 72, 127)), ("conic", (4, 5, 8, 11, 17, 26))],
)
def test_the_whole_sextic_as_in_table_3_4(primitive, counts):
    """With the same area for every piece both halves had the same number, up to 14, 24, 128 and 6, 12, 18."""
    curve = osc.curve(*SEXTIC)
    for power, count in enumerate(counts, 1):
        spline = osc.approximate(curve, primitive, 10.0**-power, metric="area", split_at=[0])
        assert len(spline) == count and spline.error <= 10.0**-power
        less = osc.approximate(curve, primitive, pieces=count - 1, metric="area", split_at=[0])
        assert less.error > 10.0**-power


@pytest.mark.parametrize(
    ("primitive", "rule"), [("parabola", None), ("conic", "minimal-area"), ("biarc", None)]
)
def test_one_piece_less_does_not_do(primitive, rule):
    curve = osc.curve("exp(t/3)*cos(t), exp(t/3)*sin(t)", 0, 5)
    spline = osc.approximate(curve, primitive, 1e-5, metric="area", rule=rule)
    fewer = osc.approximate(curve, primitive, pieces=len(spline) - 1, metric="area", rule=rule)
    assert len(fewer) * max(fewer.errors) > 1e-5
    assert spline.minimal == "unknown"  # no theorem is about sums


LEAST = [
    ("2*cos(t) - cos(2*t), 2*sin(t) - sin(2*t)", 0, "2*pi", "biarc", 1e-4),
    ("2*cos(t) - cos(2*t), 2*sin(t) - sin(2*t)", 0, "2*pi", "conic", 1e-3),
    ("cos(t), sin(2*t)", 0, "2*pi", "conic", 1e-6),
    ("cos(t), sin(2*t)", 0, "2*pi", "parabola", 1e-4),
    ("cos(t)^3, sin(t)^3", 0, "2*pi", "polygon", 1e-2),
    ("t, sin(t) + sin(3*t)/5", 0, 7, "biarc", 1e-3),
    ("2*cos(t), sin(t)", 0, "2*pi", "parabola", 1e-3),
    ("t, t^3 - t^2", "-1", 2, "polygon", 1e-2),
    ("t, sin(t)", 0, 7, "cubic", 1e-3),
]


@pytest.mark.parametrize(("formula", "low", "high", "primitive", "tolerance"), LEAST)
def test_the_number_is_the_least_whose_best_spline_is_within_the_area(
    formula, low, high, primitive, tolerance
):
    """Of so many pieces, and of one less, as they are found when their number is given."""
    curve = osc.curve(formula, low, high)
    spline = osc.approximate(curve, primitive, tolerance, metric="area")
    assert spline.error <= tolerance
    same, less = (
        osc.approximate(curve, primitive, pieces=len(spline) - k, metric="area").error for k in (0, 1)
    )
    assert same <= tolerance < less


def test_stretches_do_not_share_the_area_equally():
    """With the tolerance/n each the cardioid takes 46."""
    cardioid = osc.curve("2*cos(t) - cos(2*t), 2*sin(t) - sin(2*t)", 0, "2*pi")
    spline = osc.approximate(cardioid, "biarc", 1e-4, metric="area")
    assert (len(spline), spline.minimal) == (45, "unknown")
    assert max(spline.errors) > 1e-4 / 45


@settings(max_examples=10, deadline=None)
@given(
    st.floats(0.05, 0.9),
    st.integers(2, 4),
    st.floats(-5, -1.5),
    st.sampled_from(["conic", "parabola", "biarc", "polygon"]),
)
def test_it_is_so_on_other_closed_curves(depth, waves, power, primitive):
    curve = osc.curve(
        f"(1 + {depth!r}*cos({waves}*t))*cos(t), (1 + {depth!r}*cos({waves}*t))*sin(t)", 0, "2*pi"
    )
    tolerance = 10.0**power
    spline = osc.approximate(curve, primitive, tolerance, metric="area")
    assert spline.error <= tolerance
    if len(spline) > len(spline.splits) + 1:  # there is one less to ask for
        try:
            less = osc.approximate(curve, primitive, pieces=len(spline) - 1, metric="area")
        except DomainError as error:
            assert "takes at least" in str(error)
        else:
            assert less.error > tolerance


def test_a_curve_that_crosses_itself_counts_arc_by_arc():
    """A loop: the area is that between each arc and its own piece, whatever else is near."""
    curve = osc.curve("t^2 - 1, t^3 - t", -1.5, 1.5)
    spline = osc.approximate(curve, "conic", 1e-4, metric="area")
    for piece in spline.pieces:
        area, resolution = clipped(lambda t: (t * t - 1, t**3 - t), piece)
        assert piece.error == pytest.approx(area, abs=2 * resolution + 1e-12, rel=1e-4)


@pytest.mark.parametrize("scale", ["2^-300", "2^300"])
def test_areas_scale_with_the_square(scale):
    wide = osc.curve(f"{scale}*t*cos(t), {scale}*t*sin(t)", "pi/6", "2*pi")
    size = 2.0 ** int(scale[2:])
    spline = osc.approximate(wide, "conic", 1e-4 * size**2, metric="area")
    assert len(spline) == 13
    usual = osc.approximate(osc.curve(*SPIRAL), "conic", 1e-4, metric="area")
    assert spline.error == pytest.approx(usual.error * size**2, rel=1e-6)


@pytest.mark.parametrize("scale", ["1e-200", "1e200"])
def test_areas_beyond_doubles_are_refused(scale):
    for primitive in ("parabola", "conic", "biarc"):
        with pytest.raises(DomainError, match="leave the range of double numbers: scale it"):
            osc.approximate(osc.curve(f"{scale}*cos(t), {scale}*t", 0, 1), primitive, pieces=8, metric="area")


def test_bad_choices():
    curve = osc.curve(*SPIRAL)
    with pytest.raises(DomainError, match="metric 'volume' is unknown: choose one of hausdorff, area"):
        osc.approximate(curve, "conic", metric="volume")
    with pytest.raises(DomainError, match="choose equisymmetric or minimal-area"):
        osc.approximate(curve, "conic", metric="area", rule="thesis")
    with pytest.raises(
        DomainError, match="rule 'equisymmetric' is unknown for conic and the metric hausdorff"
    ):
        osc.approximate(curve, "conic", rule="equisymmetric")
    with pytest.raises(ToleranceError, match="below the rounding floor"):
        osc.approximate(curve, "conic", 1e-15, metric="area")
