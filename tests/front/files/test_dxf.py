"""DXF files: audited by ezdxf, and read back by it and, independently, by GDAL."""

from __future__ import annotations

import io
import math
import sys
from itertools import pairwise

import ezdxf
import numpy as np
import pyogrio
import pytest
import shapely

import osculant as osc
from osculant.cas.errors import DomainError, OsculantError
from osculant.files.dxf import dxf
from osculant.pieces.biarcs import Biarc
from osculant.pieces.conics import Piece
from osculant.pieces.helices import HelixArc
from tests.front.approximation.test_approximate import points_of
from tests.front.files.machine import two_sided
from tests.front.files.test_gcode import helix, space_spline
from tests.front.samples import spline_of, written
from tests.oracles import hausdorff

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
ELLIPSE = ("2*cos(t), sin(t)", "0", "2*pi")
INFLECTED = ("t, t**3", "-1", "1")


def audited(text):
    """Return the document as ezdxf reads it, without a complaint of its auditor."""
    document = ezdxf.read(io.StringIO(text))
    audit = document.audit()
    assert not audit.errors and not audit.fixes
    return document


def from_bulges(polyline):
    """Return the arcs of a LWPOLYLINE as pieces."""
    rows = [tuple(map(float, row)) for row in polyline.get_points("xyb")]
    rows += rows[:1] if polyline.closed else []
    found = []
    for i, ((x, y, bulge), (p, q, _)) in enumerate(pairwise(rows)):
        half = 2 * math.atan(bulge)  # a quarter of the turning is atan(bulge)
        ahead = complex(p - x, q - y) / math.dist((x, y), (p, q)) * complex(math.cos(half), -math.sin(half))
        if bulge:
            found.append(Piece.arc((i, i + 1), (x, y), (p, q), (ahead.real, ahead.imag)))
        else:
            found.append(Piece.segment((i, i + 1), (x, y), (p, q)))
    return found


def by_gdal(text, path):
    """Return the geometries that GDAL reads, curves as fine polygons."""
    path.write_text(text, encoding="utf-8")
    pyogrio.set_gdal_config_options({"OGR_ARC_STEPSIZE": 0.05, "OGR_ARC_MAX_GAP": 0})
    table = pyogrio.raw.read(path)
    assert set(table[3][list(table[0]["fields"]).index("Layer")]) == {"spline"}
    return [shapely.from_wkb(wkb) for wkb in table[2]]


@pytest.mark.parametrize("formula", [SPIRAL, ELLIPSE, INFLECTED])
def test_bulges_read_back_within_the_tolerance(formula, tmp_path):
    spline = osc.approximate(osc.curve(*formula), "biarc", 1e-3)
    text = written(spline, dxf, command="osculant approximate")
    document = audited(text)
    (polyline,) = document.modelspace()
    assert polyline.dxftype() == "LWPOLYLINE" and polyline.closed == (formula is ELLIPSE)
    assert dict(document.header.custom_vars.properties) == {
        "osculant": osc.__version__,
        "command": "osculant approximate",
        "curve": spline.curve.text,
        "primitive": f"biarc, {len(spline)} pieces",
        "tolerance": "0.001 (hausdorff)",
        "error": f"{spline.error!r} (estimate)",
    }
    arcs = [arc for piece in spline.pieces for arc in piece.arcs]
    read = from_bulges(polyline)
    assert len(read) == len(arcs)
    for one, other in zip(read, arcs):
        assert np.abs(one.sample(17) - other.sample(17)).max() < 1e-14
    knots = [t for a, b in pairwise(spline.knots) for t in (a, (a + b) / 2)] + spline.knots[-1:]
    assert hausdorff(points_of(spline.curve), read, knots) <= 1e-3

    (line,) = by_gdal(text, tmp_path / "spline.dxf")
    close(line, spline)


def close(line, spline):
    """GDAL's polygon has its vertices on the spline, and leaves nothing of the spline out."""
    dense = shapely.LineString(spline.sample(2001))
    ends = shapely.points(line.coords)
    assert shapely.distance(ends, dense).max() < 1e-6
    assert shapely.distance(shapely.points(spline.sample(33)), line).max() < 1e-5


@pytest.mark.parametrize("formula", [SPIRAL, ELLIPSE, INFLECTED])
def test_arcs_read_back(formula, tmp_path):
    spline = osc.approximate(osc.curve(*formula), "biarc", 1e-2)
    text = written(spline, dxf, entities="arcs")
    arcs = [arc for piece in spline.pieces for arc in piece.arcs]
    found = list(audited(text).modelspace())
    assert [entity.dxftype() for entity in found] == ["ARC"] * len(arcs)
    for entity, arc in zip(found, arcs):
        ends = [entity.start_point, entity.end_point]
        gaps = [[math.dist((p.x, p.y), q) for q in (arc.start, arc.end)] for p in ends]
        assert min(gaps[0][0] + gaps[1][1], gaps[0][1] + gaps[1][0]) < 1e-13
        centre = np.array([entity.dxf.center.x, entity.dxf.center.y])
        assert np.abs(np.hypot(*(arc.sample(9) - centre).T) - entity.dxf.radius).max() < 1e-13
        assert (entity.dxf.end_angle - entity.dxf.start_angle) % 360 < 180
    lines = by_gdal(text, tmp_path / "arcs.dxf")
    assert len(lines) == len(arcs)
    close(shapely.line_merge(shapely.set_precision(shapely.MultiLineString(lines), 1e-10)), spline)


def test_segments_and_straight_arcs():
    """Where the digits of centre and radius would not carry the arc, bulges do."""
    pieces = [
        Piece.segment((0, 1), (0.0, 0.0), (1.0, 0.0)),
        Piece.arc((1, 2), (1.0, 0.0), (2.0, 0.0), (math.cos(5e-8), -math.sin(5e-8))),
        Biarc("arc", (2, 3), (2.0, 0.0), (2.5, 0.5), (3.0, 1.0), ((1.0, 0.0), (0.0, 1.0)), (2.0, -2.0), 0.0),
    ]
    entities = list(audited(written(spline_of(pieces), dxf, entities="arcs")).modelspace())
    assert [entity.dxftype() for entity in entities] == ["LINE", "LWPOLYLINE", "ARC", "ARC"]
    assert entities[1].get_points("xyb")[0][2] == pytest.approx(2.5e-8, rel=1e-6)
    (polyline,) = audited(written(spline_of(pieces), dxf)).modelspace()
    bulges = [row[0] for row in polyline.get_points("b")]
    assert bulges == pytest.approx([0, 2.5e-8, math.tan(math.pi / 8), -math.tan(math.pi / 8), 0], abs=1e-14)


def test_nearly_a_full_turn_has_a_vertex_more():
    arc = Piece.arc((0, 1), (1.0, 0.0), (math.cos(6.0), math.sin(6.0)), (0.0, 1.0))
    (polyline,) = audited(written(spline_of([arc]), dxf)).modelspace()
    rows = polyline.get_points("xyb")
    assert np.allclose(rows[1][:2], [math.cos(3.0), math.sin(3.0)])
    assert [row[2] for row in rows[:2]] == pytest.approx([math.tan(0.75)] * 2)


def test_units():
    for units, code in ((None, 0), ("inch", 1), ("mm", 4)):
        text = written(spline_of([Piece.segment((0, 1), (0.0, 0.0), (1.0, 0.0))]), dxf, units=units)
        assert audited(text).header["$INSUNITS"] == code


@pytest.mark.parametrize("room", [1e-3, 3e-4, 1.2e-4])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_chords_of_helices(room, count, tmp_path):
    """On both sides of the helices, fewer than inscribed chords would be."""
    arcs = [helix(2, 1, 0.5, 0.3, 4.0, tilt=0.4)]
    while len(arcs) < count:
        arc = arcs[-1]
        ahead = tuple(arc.tangent(1.0).tolist())
        axis = np.cross(ahead, np.cross(arc.axis, ahead)) + 0.1 * np.array(ahead)
        axis = tuple((axis / np.linalg.norm(axis)).tolist())
        rate = 1.2 * arc.rate
        cosine = float(np.dot(axis, ahead))
        sine = math.sqrt(1 - cosine**2)
        arcs.append(HelixArc(arc.end, ahead, axis, rate * sine, rate * cosine, 3.0))
    spline = space_spline(arcs)
    text = written(spline, dxf, room=room)
    document = audited(text)
    (polyline,) = document.modelspace()
    assert polyline.get_mode() == "AcDb3dPolyline"
    points = np.array([tuple(vertex.dxf.location) for vertex in polyline.vertices])
    inscribed = math.ceil(sum(arc.length * math.sqrt(arc.curvature / (8 * room)) for arc in arcs))
    assert len(points) - 1 < max(3, 0.8 * inscribed)
    f = np.linspace(0, 1, 201)[:, None]
    fine = np.concatenate([a + f * (b - a) for a, b in pairwise(points)])
    helices = np.concatenate([arc.point(np.linspace(0, 1, 4001)) for arc in arcs])
    assert 0.85 * room < two_sided(fine, helices) <= room * 1.05
    assert dict(document.header.custom_vars.properties)["chords"] == f"for {count} helical arcs"
    (line,) = by_gdal(text, tmp_path / "helix.dxf")
    assert np.allclose(shapely.get_coordinates(line, include_z=True), points, atol=1e-14)


def test_a_spline_in_space(tmp_path):
    curve = osc.curve("t*cos(t), t*sin(t), t", "0", "2*pi")
    spline = osc.approximate(curve, "bihelix", "1e-2", files=tmp_path / "space.dxf")
    (line,) = by_gdal(written(spline, dxf), tmp_path / "space.dxf")
    points = shapely.get_coordinates(line, include_z=True)
    assert np.allclose(points[[0, -1]], [spline.pieces[0].start, spline.pieces[-1].end])
    dense = spline.sample(400)
    gaps = np.linalg.norm(points[:, None] - dense[None], axis=2)
    assert gaps.min(axis=1).max() < 1e-2


@pytest.mark.parametrize(
    ("weight", "kind"),
    [
        (-0.9, "ellipse"),
        (-0.5, "ellipse"),
        (0.0, "ellipse"),
        (0.7, "ellipse"),
        (1.5, "hyperbola"),
        (20.0, "hyperbola"),
        (1.0, "parabola"),
    ],
)
def test_conics_are_exact(weight, kind, tmp_path):
    piece = Piece(kind, (0, 1), (2.0, 1.0), (3.0, -1.0), (3.0 * weight + 0.5, 0.5 + weight), weight, 0.0)
    for entities in ("polyline", "arcs"):
        text = written(spline_of([piece]), dxf, entities=entities)
        (entity,) = audited(text).modelspace()
        expected = "ELLIPSE" if kind == "ellipse" and entities == "arcs" else "SPLINE"
        assert entity.dxftype() == expected
        if expected == "SPLINE":
            tool = entity.construction_tool()
            points = np.array([tuple(p)[:2] for p in tool.points(np.linspace(0, tool.max_t, 201))])
        else:
            points = np.array([tuple(p)[:2] for p in entity.flattening(1e-5)])
        for x, y in points:  # on the conic, by its equation in the control triangle's homogeneous coordinates
            assert abs(implicit(piece, x, y)) < 1e-11
        ends = {tuple(np.round(points[i], 12)) for i in (0, -1)}
        assert ends == {piece.start, piece.end}
        (line,) = by_gdal(text, tmp_path / f"{entities}.dxf")
        dense = shapely.LineString(piece.sample(20_001))
        assert shapely.distance(shapely.points(line.coords), dense).max() < 1e-3 * dense.length
        assert shapely.distance(shapely.points(piece.sample(33)), line).max() < 2e-2 * dense.length


def implicit(piece, x, y):
    """The quadratic form of a conic at a point."""
    (a, b), (c, d), w = piece.legs[0], piece.legs[2], piece.weight
    # X = (b₀P₀ + b₁M + b₂P₂)/(b₀ + wb₁ + b₂): X − P₀ = (b₁A + b₂C)/(…), 4b₀b₂ = b₁²
    u, v = np.linalg.solve(np.array([[a, c], [b, d]]), [x - piece.start[0], y - piece.start[1]])
    rest = 1 - w * u - v  # b₀ of the sum 1, u = b₁, v = b₂
    return 4 * rest * v - u * u


def test_refusals(monkeypatch):
    half = spline_of([Piece.arc((0, 3), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0))])
    with pytest.raises(DomainError, match="'polyline' or 'arcs', not 'splines'"):
        written(half, dxf, entities="splines")
    with pytest.raises(DomainError, match="'mm' or 'inch', not 'm'"):
        written(half, dxf, units="m")
    monkeypatch.setitem(sys.modules, "ezdxf.filemanagement", None)
    with pytest.raises(OsculantError, match=r"`pip install osculant\[cad\]` adds it"):
        written(half, dxf)
