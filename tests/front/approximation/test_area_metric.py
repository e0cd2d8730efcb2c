"""The area metric: the tables' counts, and areas against polygons clipped by an independent library."""

from __future__ import annotations

import math

import numpy as np
import pytest
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
    [("parabola", (8, 14, 24, 40, 72, 128)), ("conic", (4, 6, 8, 12, 18, 26))],
)
def test_the_whole_sextic_as_in_table_3_4(primitive, counts):
    for power, count in enumerate(counts, 1):
        spline = osc.approximate(osc.curve(*SEXTIC), primitive, 10.0**-power, metric="area", split_at=[0])
        assert len(spline) == count


@pytest.mark.parametrize(
    ("primitive", "rule"), [("parabola", None), ("conic", "minimal-area"), ("biarc", None)]
)
def test_one_piece_less_does_not_do(primitive, rule):
    curve = osc.curve("exp(t/3)*cos(t), exp(t/3)*sin(t)", 0, 5)
    spline = osc.approximate(curve, primitive, 1e-5, metric="area", rule=rule)
    fewer = osc.approximate(curve, primitive, pieces=len(spline) - 1, metric="area", rule=rule)
    assert len(fewer) * max(fewer.errors) > 1e-5
    assert spline.minimal == "unknown"  # no theorem is about sums


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
