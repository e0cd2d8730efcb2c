"""Space curves and their splines of bihelices: invariants, pieces, counts and errors."""

from __future__ import annotations

import json
import math
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
import sympy
from scipy.spatial import cKDTree

import osculant as osc
from osculant.cas.errors import DomainError, FormulaError, ToleranceError
from osculant.cli.invariants import invariants_data, print_invariants, print_values, values_data
from osculant.cli.splines import print_spline
from osculant.cli.tables import print_counts
from osculant.curves.extent import extent
from osculant.curves.plane import PlaneCurve
from osculant.curves.space import SpaceCurve
from osculant.thesis.count_tables import count_table

CONE = ("t*cos(t), t*sin(t), t", "pi/6", "2*pi")
MOMENT = ("t, t^2, t^3", "0", "1")
#: one of Salkowski's curves: curvature 1, torsion not constant
SALKOWSKI = (
    "(-sin(11*t/5)/22 - 2*sin(t/5) - sin(t)/2)*4/5, "
    "(cos(11*t/5)/22 - 2*cos(t/5) + cos(t)/2)*4/5, 4/15*cos(6*t/5)"
)


def points_of(curve: SpaceCurve, count: int) -> np.ndarray:
    a, b = curve.interval
    return np.array([curve.compiled(t)[:, 0] for t in np.linspace(a, b, count)])


def to_polyline(points: np.ndarray, corners: np.ndarray, tree: cKDTree) -> float:
    """The largest distance from points to a polyline with many more corners, near the nearest corner."""
    _, nearest = tree.query(points)
    best = np.full(len(points), np.inf)
    for shift in (-1, 0):
        i = np.clip(nearest + shift, 0, len(corners) - 2)
        side = corners[i + 1] - corners[i]
        along = np.einsum("ij,ij->i", points - corners[i], side) / np.einsum("ij,ij->i", side, side)
        foot = corners[i] + np.clip(along, 0, 1)[:, None] * side
        best = np.minimum(best, np.linalg.norm(points - foot, axis=1))
    return float(best.max())


def two_sided(curve: SpaceCurve, spline, count: int = 40_001) -> float:
    """The Hausdorff distance of fine polylines."""
    on_curve = points_of(curve, count)
    on_spline = spline.sample(max(3, count // len(spline)))
    return max(
        to_polyline(on_spline, on_curve, cKDTree(on_curve)),
        to_polyline(on_curve, on_spline, cKDTree(on_spline)),
    )


# The curve and its invariants.


def test_a_curve_from_text_and_from_sympy():
    t = sympy.Symbol("t")
    curve = SpaceCurve((t, t**2, sympy.exp(t)), 0, sympy.pi)
    assert curve.text == "t, t**2, exp(t)"
    assert curve.interval == (0.0, math.pi)
    assert repr(SpaceCurve("t, t, 1")) == "<SpaceCurve t, t, 1>"
    assert repr(SpaceCurve(*MOMENT)) == "<SpaceCurve t, t**2, t**3, t from 0 to 1>"


def test_the_number_of_coordinates_is_checked():
    with pytest.raises(FormulaError, match=r"A space curve has three coordinates, .*; this formula has 2\."):
        SpaceCurve("t, t^2")
    with pytest.raises(FormulaError, match="has two coordinates"):
        PlaneCurve("t, t^2, t^3")
    with pytest.raises(DomainError, match=r"Bihelices approximate curves in space and t, t\*\*2 has two"):
        osc.approximate(PlaneCurve("t, t^2", 0, 1), "bihelix")


@pytest.mark.parametrize(("low", "high"), [(1, 1), (2, 1), (0, None)])
def test_bad_intervals_are_refused(low, high):
    with pytest.raises(DomainError):
        SpaceCurve("t + 1, t, t^2", low, high)


def test_exact_attributes():
    curve = SpaceCurve("3*cos(t), 3*sin(t), 4*t")
    assert (curve.curvature, curve.torsion) == (sympy.Rational(3, 25), sympy.Rational(4, 25))
    assert curve.frame[2] == curve.binormal
    assert curve.darboux_vector == (0, 0, sympy.Rational(1, 5))
    assert set(curve.invariants()) >= {"curvature", "torsion", "arc_length", "darboux_frame"}
    with pytest.raises(AttributeError, match="affine_curvature"):
        _ = curve.affine_curvature


def test_values_to_fifty_digits():
    values = SpaceCurve(CONE[0]).at("1", 50)
    with mp.workdps(50):
        assert mp.almosteq(values["torsion"], mp.mpf(7) / 14)
        assert abs(values["curvature"] - mp.sqrt(mp.mpf(14) / 27)) < mp.mpf(10) ** -49
        for vector in values["darboux_frame"]:
            assert abs(mp.fdot(vector, vector) - 1) < mp.mpf(10) ** -48


def test_values_where_the_curvature_vanishes():
    values = SpaceCurve("t, sin(t), 0").at("pi", 20)
    assert values["curvature"] == 0
    assert values["torsion"] is None and values["normal"] is None
    assert abs(values["tangent"][1] + mp.sqrt(mp.mpf(1) / 2)) < 1e-15
    with pytest.raises(DomainError, match="no finite derivatives"):
        SpaceCurve("t, 1/t, t").at(0)


def test_tabulated_doubles_are_the_values():
    curve = SpaceCurve(CONE[0])
    table = curve.tabulate([0.5, 1.0, 4.0])
    for i, t in enumerate((0.5, 1.0, 4.0)):
        values = curve.at(t)
        assert all(table[name][i] == pytest.approx(float(values[name]), rel=1e-12) for name in table)


def test_reports(capsys):
    curve = SpaceCurve(*CONE)
    data = invariants_data(curve)
    json.dumps(data)
    print_invariants(data, latex=False, dimension=3)
    print_invariants(data, latex=True, dimension=3)
    values = values_data(curve, "1", 12)
    json.dumps(values)
    print_values(values, latex=False, dimension=3)
    shown = capsys.readouterr().out
    assert "torsion                      tau = (t**2 + 6)/(t**4 + 5*t**2 + 8)" in shown
    assert r"\tau = \frac{t^{2} + 6}{t^{4} + 5 t^{2} + 8}" in shown
    assert "torsion                      tau = 0.5\n" in shown
    print_spline(osc.approximate(curve, tolerance=1e-3), 0.1, [])
    assert "rule          equioscillating\n" in capsys.readouterr().out


# Splines.


@pytest.mark.parametrize(
    ("curve", "tolerance", "ours", "thesis"),
    [
        (CONE, 1e-2, 4, 5),
        (CONE, 1e-4, 19, 20),
        (CONE, 1e-6, 86, 87),
        (MOMENT, 1e-4, 6, 7),
        (MOMENT, 1e-6, 25, 27),
        (("t, t^2, t^3", 1, 2), 1e-6, 26, 28),
    ],
)
def test_counts(curve, tolerance, ours, thesis):
    subject = SpaceCurve(*curve)
    spline = osc.approximate(subject, "bihelix", tolerance)
    assert len(spline) == spline.predicted_pieces == ours
    assert len(osc.approximate(subject, "bihelix", tolerance, rule="thesis")) == thesis
    assert tolerance * (1 - 1e-4) < max(spline.errors[:-1]) <= spline.error <= tolerance


@pytest.mark.parametrize("rule", ["equioscillating", "thesis"])
def test_the_error_is_the_hausdorff_distance(rule):
    curve = SpaceCurve(*CONE)
    spline = osc.approximate(curve, tolerance=1e-3, rule=rule)
    assert two_sided(curve, spline) == pytest.approx(spline.error, rel=1e-3)


@pytest.mark.parametrize("text", ["2*cos(t), sin(t), t/5", "t*cos(t), t*sin(t), 2*t*cos(t) - t*sin(t)"])
def test_splines_are_tangent_continuous_and_meet_the_curve(text):
    curve = SpaceCurve(text, "1/2", "5")
    spline = osc.approximate(curve, tolerance=1e-4)
    assert spline.max_tangent_jump() < 1e-14
    arcs = [arc for piece in spline.pieces for arc in piece.arcs]
    size = extent(curve).size
    assert all(math.dist(a.end, b.start) < 1e-14 * size for a, b in pairwise(arcs))
    assert np.allclose([p.start for p in spline.pieces], [curve.compiled(k)[:, 0] for k in spline.knots[:-1]])
    assert spline.knots[0] == 0.5 and spline.knots[-1] == 5.0
    assert two_sided(curve, spline) < 1.01e-4


def test_a_planar_curve_becomes_biarcs():
    spline = osc.approximate(SpaceCurve("t*cos(t), t*sin(t), 0", "pi/6", "2*pi"), tolerance=1e-6)
    assert len(spline) == 91
    assert all(abs(arc.torsion) < 1e-9 * arc.curvature for piece in spline.pieces for arc in piece.arcs)


@pytest.mark.parametrize("factor", ["10^6", "10^(-6)"])
def test_the_scale_does_not_matter(factor):
    size = float(sympy.sympify(factor.replace("^", "**")))
    curve = SpaceCurve(f"{factor}*t*cos(t), {factor}*t*sin(t), {factor}*t", *CONE[1:])
    spline = osc.approximate(curve, tolerance=1e-4 * size)
    assert len(spline) == 19
    assert spline.predicted == pytest.approx(18.344131794711, rel=1e-10)


@pytest.mark.parametrize(
    ("text", "high", "kind", "pieces"),
    [
        ("2*cos(t), 2*sin(t), 1", "2*pi", "arc", 2),
        ("2*cos(t), 2*sin(t), 1", "6", "arc", 1),
        ("3*cos(t), 3*sin(t), 4*t", "4*pi", "helix", 3),
        ("3*cos(t^2 + t), 3*sin(t^2 + t), -4*t^2 - 4*t", "7/2", "helix", 3),
        ("t, 2*t, 3*t + 1", "5", "segment", 1),
    ],
)
def test_helices_circles_and_lines_are_exact(text, high, kind, pieces):
    curve = SpaceCurve(text, 0, high)
    spline = osc.approximate(curve, tolerance=1e-6)
    assert [piece.kind for piece in spline.pieces] == [kind] * pieces
    assert (spline.error, spline.error_kind, spline.predicted) == (0.0, "exact", 0.0)
    assert all(piece.arcs[0].turning < math.tau for piece in spline.pieces)
    assert two_sided(curve, spline, 20_001) < 1e-5 * extent(curve).size  # of the polylines
    last = curve.compiled(curve.interval[1])[:, 0]
    assert np.allclose(spline.pieces[-1].end, last, rtol=0, atol=2e-14 * extent(curve).size)
    assert osc.complexity(curve).predicted_pieces(1e-6) == pieces


def test_constant_curvature_has_a_law_of_its_own():
    curve = SpaceCurve(SALKOWSKI, "1/2", "2")
    assert curve.curvature == 1
    law = osc.complexity(curve)
    assert law.order == 4
    assert len(osc.approximate(curve, tolerance=1e-8)) == law.predicted_pieces(1e-8) == 12


def test_vertices_inflections_and_cusps_split():
    spline = osc.approximate(SpaceCurve("t, t^3, 0", -1, 1), tolerance=1e-4)
    assert spline.splits == pytest.approx((-((1 / 45) ** 0.25), 0.0, (1 / 45) ** 0.25))
    assert spline.undecided == ()
    cusp = osc.approximate(SpaceCurve("t^2, t^3, t^4", -1, 1), tolerance=1e-4)
    assert cusp.splits == (0.0,) == tuple(cusp.cusps)
    asked = osc.approximate(SpaceCurve(*MOMENT), tolerance=1e-2, split_at=["1/3"])
    assert asked.splits == (1 / 3,)


def test_a_large_tolerance_is_measured_all_the_same():
    curve = SpaceCurve(*CONE)
    spline = osc.approximate(SpaceCurve("t, t^2, t^3", 0, 1), tolerance=1e3)
    assert (len(spline), spline.minimal) == (1, "proved")
    assert two_sided(SpaceCurve(*MOMENT), spline) == pytest.approx(spline.error, rel=1e-4)
    assert osc.approximate(curve, tolerance=1.0).error <= 1.0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("t, 1/(t - 1), t", "undefined or infinite at t = 1 "),
        ("t, t^2, abs(t - 1)", "at t = 1 "),
        ("t, t^2, sqrt(t)", "no finite derivatives at t = 0 "),
        ("1, 2, 3", "is a single point"),
    ],
)
def test_undefined_curves_are_refused(text, message):
    with pytest.raises(DomainError, match=message):
        osc.approximate(SpaceCurve(text, 0, 2))


def test_bad_choices_are_refused():
    curve = SpaceCurve(*MOMENT)
    for tolerance in (0, -1, math.nan, "x", 1e-16):
        with pytest.raises(ToleranceError):
            osc.approximate(curve, tolerance=tolerance)
    with pytest.raises(DomainError, match="not 'conic'"):
        osc.approximate(curve, "conic")
    with pytest.raises(DomainError, match="rule 'best' is unknown"):
        osc.approximate(curve, rule="best")
    with pytest.raises(DomainError, match="metric 'area' is one of plane curves, and t, "):
        osc.complexity(curve, metric="area")
    with pytest.raises(DomainError, match="metric 'taxi' is unknown"):
        osc.approximate(curve, metric="taxi")
    with pytest.raises(DomainError, match="way to split 'often' is unknown"):
        osc.approximate(curve, split="often")
    with pytest.raises(DomainError, match="split point 2 is not inside"):
        osc.approximate(curve, split_at=[2])
    with pytest.raises(DomainError, match="has no interval"):
        osc.approximate(SpaceCurve(MOMENT[0]))


def test_constants_against_mpmath():
    def density(t):  # |κ′|^(1/3) ds/dt of (t, t², t³), by mpmath's differentiation
        def kappa(u):
            size = mp.sqrt((6 * u**2) ** 2 + (6 * u) ** 2 + 4)
            return size / mp.sqrt(1 + 4 * u**2 + 9 * u**4) ** 3

        speed = mp.sqrt(1 + 4 * t**2 + 9 * t**4)
        return mp.cbrt(abs(mp.diff(kappa, t)) / speed / 324) * speed

    with mp.workdps(30):
        expected = mp.quad(density, mp.linspace(1, 2, 5))
    [constant] = osc.complexity(SpaceCurve("t, t^2, t^3", 1, 2)).constants
    assert abs(mp.mpf(constant) - expected) < 1e-15


def test_tables(capsys):
    table = count_table("4.2")
    rows = {row.tolerance: row for row in table.rows}
    assert rows[1e-6].pieces == {"thesis rule": 27, "our rule": 25}
    assert rows[1e-6].theory == pytest.approx(24.8087, abs=1e-4)
    assert table.caption == "Bihelices of t, t**2, t**3, Hausdorff distance: pieces found and theory"
    print_counts(table)
    assert "moment curve" in capsys.readouterr().out
    json.dumps(table.to_json())
