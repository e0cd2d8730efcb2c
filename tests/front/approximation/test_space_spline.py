"""Helical arcs, pieces and splines of bihelices as objects: points, boxes, files."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import osculant as osc
from osculant.cas.errors import DomainError, OsculantError
from osculant.curves.space import SpaceCurve
from osculant.pieces.helices import HelixArc, SpacePiece

CONE = ("t*cos(t), t*sin(t), t", "pi/6", "2*pi")
#: fields of an arc's JSON that are numbers
NUMBERS = ("curvature", "torsion", "length")


def test_evaluate_sample_and_box():
    spline = osc.approximate(SpaceCurve(*CONE), tolerance=1e-3)
    times = np.linspace(spline.knots[0], spline.knots[-1], 50).reshape(5, 10)
    points = spline.evaluate(times)
    assert points.shape == (5, 10, 3)
    exact = np.array([spline.curve.compiled(t)[:, 0] for t in times.ravel()]).reshape(5, 10, 3)
    assert np.abs(points - exact).max() < 0.05
    low, high = spline.bounding_box()
    samples = spline.sample(2001)
    assert np.allclose(low, samples.min(axis=0), atol=1e-6)
    assert np.allclose(high, samples.max(axis=0), atol=1e-6)
    with pytest.raises(DomainError, match=r"no point at t = 9\.0"):
        spline.evaluate(9.0)


def test_json_and_files(tmp_path):
    spline = osc.approximate(SpaceCurve(*CONE), tolerance=1e-3)
    path = tmp_path / "cone.json"
    spline.write(path, command="osculant approximate")
    data = json.loads(path.read_text())
    assert (data["pieces"], data["rule"], data["command"]) == (9, "equioscillating", "osculant approximate")
    for piece, segment in zip(spline.pieces, data["segments"], strict=True):
        arcs = tuple(
            HelixArc(*(tuple(arc[k]) for k in ("start", "tangent", "axis")), *(arc[k] for k in NUMBERS))
            for arc in segment["arcs"]
        )
        again = SpacePiece(tuple(segment["interval"]), arcs, segment["error"], segment["junction"])
        assert again == piece
    with pytest.raises(OsculantError, match=r"written as \.json"):
        spline.write(tmp_path / "cone.svg")
    spline.plot(tmp_path / "cone.png")
    assert (tmp_path / "cone.png").read_bytes()[:4] == b"\x89PNG"


def test_arcs_obey_their_curvature_and_torsion():
    for arc in osc.approximate(SpaceCurve(*CONE), tolerance=1e-2).pieces[1].arcs:
        u = 0.3
        assert arc.turning < math.tau
        step = 1e-3 * arc.length
        p = arc.point(u + 1e-3 * np.arange(-2, 3))
        first = (p[0] - 8 * p[1] + 8 * p[3] - p[4]) / (12 * step)
        second = (-p[0] + 16 * p[1] - 30 * p[2] + 16 * p[3] - p[4]) / (12 * step**2)
        third = (-p[0] + 2 * p[1] - 2 * p[3] + p[4]) / (2 * step**3)
        bend = np.cross(first, second)
        assert np.allclose(first, arc.tangent(u), atol=1e-9)
        assert np.linalg.norm(bend) == pytest.approx(arc.curvature, rel=1e-5)
        assert bend @ third / (bend @ bend) == pytest.approx(arc.torsion, rel=1e-4)
        assert np.linalg.norm(p[2] - np.array(arc.centre)) >= arc.radius * (1 - 1e-9)


def test_bad_pieces_are_refused():
    line = HelixArc((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 0.0, 0.0), 0.0, 0.0, 1.0)
    with pytest.raises(DomainError, match="one arc, or two and a junction"):
        SpacePiece((0.0, 1.0), (line, line), 0.0)
    with pytest.raises(DomainError, match="positive length"):
        HelixArc((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 0.0, 0.0), 0.0, 0.0, 0.0)
