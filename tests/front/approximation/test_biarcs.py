"""Biarc splines from outside: counts, errors, splits, exact circles, files."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.cas.errors import DomainError
from osculant.cas.laws.table import law_of
from osculant.cli.main import main
from osculant.files.svg import path_data
from osculant.kernels.operations import registered
from osculant.pieces.biarcs import Biarc
from osculant.primitives.table import PRIMITIVES, choose
from osculant.thesis.tables import compute
from tests.front.approximation.test_approximate import points_of
from tests.front.files.test_svg import read_path
from tests.oracles import hausdorff

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SEXTIC_HALF = ("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "0", "3*pi/4")
ELLIPSE = ("2*cos(t), sin(t)", "0", "2*pi")
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-6, 1e-8)
COUNTS = {SPIRAL: [5, 10, 20, 91, 423], SEXTIC_HALF: [2, 4, 8, 35, 159]}


def check(spline, sample=8):
    """What every biarc spline promises; errors against an independent two-sided distance, piece by piece."""
    curve, tolerance = spline.curve, spline.tolerance
    largest = float(np.abs(spline.sample(3)).max())
    forced = {*spline.splits, *spline.undecided, curve.interval[1]}
    delta = max(1e-6, 32 * math.ulp(largest) / tolerance)
    assert spline.error <= tolerance
    for before, after in zip(spline.pieces, spline.pieces[1:]):
        assert before.end == after.start and before.interval[1] == after.interval[0]
    # directions of stored points are known up to their rounding over the length of an arc
    shortest = min(length for piece in spline.pieces for length in getattr(piece, "lengths", [1.0]) if length)
    assert spline.max_tangent_jump() < max(1e-12, 16 * math.ulp(largest) / shortest)
    points = points_of(curve)
    for place, piece in enumerate(spline.pieces):
        if piece.interval[1] not in forced and spline.minimal != "unknown":
            assert tolerance * (1 - delta) <= piece.error <= tolerance
        if isinstance(piece, Biarc):
            circles(piece, 1e-12 * largest)
        if place % max(1, len(spline) // sample) == 0:
            distance = hausdorff(points, piece.arcs)
            assert distance <= piece.error * (1 + 1e-6) + 64 * math.ulp(largest)
            bends = np.abs(curve.tabulate(np.linspace(*piece.interval, 200))["curvature"])
            if np.nanmax(bends) * tolerance < 0.5:  # else normals meet, and the error is an upper bound
                assert distance == pytest.approx(piece.error, rel=1e-6, abs=64 * math.ulp(largest))


def circles(piece, small):
    """Both arcs are circular, with the radii, curvatures and tangents that the piece tells."""
    turned = [piece.tangent(u) for u in (0.0, piece.share)]
    assert np.allclose(turned, piece.tangents, atol=1e-9)
    inner = piece.arcs[0].tangent(1.0), piece.arcs[1].tangent(0.0)
    assert np.allclose(*inner, atol=1e-9)
    for arc, centre, radius, bend in zip(piece.arcs, piece.centres, piece.radii, piece.curvatures):
        if radius is None or radius > 1e3 * max(1, *map(abs, arc.start)):
            continue
        assert radius == pytest.approx(abs(1 / bend), rel=1e-12)
        away = arc.sample(9) - np.array(centre)
        assert np.abs(np.hypot(*away.T) - radius).max() < small + 1e-9 * radius * small


@pytest.mark.parametrize("formula", COUNTS)
def test_counts(formula):
    curve = osc.curve(*formula)
    splines = [osc.approximate(curve, "biarc", tolerance) for tolerance in TOLERANCES]
    assert [len(spline) for spline in splines] == COUNTS[formula]
    assert {spline.minimal for spline in splines} == {"by theory"}
    # whole theory everywhere, as space.md's ceilings
    assert [spline.predicted_pieces for spline in splines] == COUNTS[formula]
    for spline in splines:
        check(spline)


def test_the_ellipse_splits_at_its_vertices():
    curve = osc.curve(*ELLIPSE)
    counts = []
    for tolerance in (1e-2, 1e-4, 1e-6):
        spline = osc.approximate(curve, "biarc", tolerance)
        assert spline.splits == (math.pi / 2, math.pi, 3 * math.pi / 2)
        check(spline)
        counts.append(len(spline))
    assert counts == [8, 24, 108]


def test_the_table_of_primitives_is_that_of_the_laws_and_the_kernels():
    fits = {name: choose(name, "hausdorff") for name in PRIMITIVES[2]}
    assert {name: fit.order for name, fit in fits.items()} == {n: law_of(n).order for n in fits}
    for fit in fits.values():
        rules = registered()[type(fit.record(fit.order))]["rules"]
        assert rules.order == fit.order


@pytest.mark.parametrize("formula", [SPIRAL, ELLIPSE])
@pytest.mark.parametrize("factor", ["10^6", "10^(-6)"])
def test_scale_changes_nothing(formula, factor):
    text, low, high = formula
    x, y = text.split(",")
    scaled = osc.curve(f"{factor}*({x}), {factor}*({y})", low, high)
    size = 1e6 if factor == "10^6" else 1e-6
    for tolerance in (1e-2, 1e-5):
        spline = osc.approximate(scaled, "biarc", tolerance * size)
        reference = osc.approximate(osc.curve(*formula), "biarc", tolerance)
        assert len(spline) == len(reference)
        assert spline.error == pytest.approx(reference.error * size, rel=2e-6)
        assert spline.predicted == pytest.approx(reference.predicted, rel=1e-6)


@pytest.mark.parametrize(
    "other",
    [
        ("t*cos(t), -t*sin(t)", "pi/6", "2*pi"),
        ("-t*cos(t), t*sin(t)", "-2*pi", "-pi/6"),
        ("exp(t)*cos(exp(t)), exp(t)*sin(exp(t))", "log(pi/6)", "log(2*pi)"),
        ("t*cos(t+1)+10^5, t*sin(t+1)-10^5", "pi/6", "2*pi"),
    ],
)
def test_mirrored_reversed_reparametrised_and_moved(other):
    counts = []
    for tolerance in TOLERANCES[:4]:
        spline = osc.approximate(osc.curve(*other), "biarc", tolerance)
        check(spline, 3)
        counts.append(len(spline))
    assert counts == COUNTS[SPIRAL][:4]


def test_a_circle_is_one_arc_for_less_than_a_turn():
    for high, turning, count in (
        ("1", 1.0, 1),
        ("4", 4.0, 1),
        ("6", 6.0, 1),
        ("2*pi", 2 * math.pi, 2),
        ("8", 8.0, 2),
    ):
        spline = osc.approximate(osc.curve("3*cos(t) + 1, 3*sin(t)", "0", high), "biarc", 1e-9)
        assert len(spline) == count and spline.error == 0.0 and spline.error_kind == "exact"
        assert {piece.kind for piece in spline.pieces} == {"arc"}
        assert spline.minimal == ("proved" if count == 1 else "unknown")
        assert sum(sum(piece.lengths) for piece in spline.pieces) == pytest.approx(3 * turning, rel=1e-13)
        for piece in spline.pieces:
            assert piece.radii == (3.0, 3.0)
            assert np.allclose(piece.centres, (1, 0), atol=1e-14)
            assert np.allclose(np.hypot(*(piece.sample(50) - (1, 0)).T), 3, rtol=1e-14)
        assert spline.predicted == 0 and spline.predicted_pieces == count


def test_a_circle_by_another_formula_is_seen():
    spline = osc.approximate(osc.curve("(1-t^2)/(1+t^2), -2*t/(1+t^2)", "-20", "20"), "biarc", 1e-9)
    assert len(spline) == 1 and spline.error == 0.0
    assert spline.pieces[0].curvatures == pytest.approx((-1, -1), rel=1e-14)


def test_a_line_is_a_segment():
    spline = osc.approximate(osc.curve("1 - t, 2*t", "0", "1"), "biarc", 1e-6)
    assert [piece.kind for piece in spline.pieces] == ["segment"]
    assert spline.error == 0 and spline.minimal == "proved"


@pytest.mark.parametrize(
    ("formula", "splits"),
    [
        (("t, t^3", "-1", "1"), [-(45**-0.25), 0, 45**-0.25]),
        (("t, t^2", "-1", "1"), [0]),
        (("t^2, t^3", "-1", "1"), [0]),
        (("t, sin(t)", "0", "7"), [math.pi / 2, math.pi, 3 * math.pi / 2, 2 * math.pi]),
    ],
)
def test_inflections_vertices_and_cusps_split(formula, splits):
    for tolerance in (1e-2, 1e-5):
        spline = osc.approximate(osc.curve(*formula), "biarc", tolerance)
        assert spline.splits == pytest.approx(splits, abs=1e-15)
        assert spline.undecided == ()
        check(spline)


def test_a_tolerance_larger_than_the_curve_is_met_by_measured_errors():
    spline = osc.approximate(osc.curve("t, exp(t)", "0", "1"), "biarc", 100.0)
    assert len(spline) == 1 and spline.minimal == "proved"
    assert 0 < spline.error < 0.1
    check(replace(spline, tolerance=spline.error))


def test_no_piece_turns_by_a_half_turn():
    spline = osc.approximate(osc.curve("t*cos(t), t*sin(t)", "1", "20"), "biarc", 4.0)
    assert spline.minimal == "unknown"  # turning ended the pieces, not the tolerance
    for piece in spline.pieces:
        a, b = piece.interval
        assert b + math.atan(b) - a - math.atan(a) < math.pi + 1e-6


@settings(max_examples=15)
@given(st.lists(st.integers(-9, 9), min_size=6, max_size=6), st.sampled_from([1e-2, 1e-4, 1e-6]))
def test_random_curves(c, tolerance):
    text = f"{c[0]}*t+{c[1]}*t^2+sin({c[2]}*t)/5, {c[3]}*t+{c[4]}*t^2+cos({c[5]}*t)/5"
    curve = osc.curve(text, 0, 1)
    speeds = curve.tabulate(np.linspace(0, 1, 400))["speed"]
    assume(speeds.min() > 0.05)
    check(osc.approximate(curve, "biarc", tolerance), 3)


def test_evaluate_sample_and_box_follow_the_arcs():
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-3)
    piece = spline.pieces[3]
    t = np.linspace(*piece.interval, 11)
    u = (t - t[0]) / (t[-1] - t[0])
    assert np.allclose(spline.evaluate(t[1:-1]), piece.point(u[1:-1]), atol=1e-13)
    assert np.allclose(spline.evaluate(spline.knots)[:-1], [p.start for p in spline.pieces], atol=0)
    points = spline.sample(33)
    assert points.shape == (32 * len(spline) + 1, 2)
    assert np.allclose(points[96:129], piece.sample(33), atol=1e-13)
    (left, bottom), (right, top) = spline.bounding_box()
    assert (points.min(axis=0) >= (left - 1e-12, bottom - 1e-12)).all()
    assert (points.max(axis=0) <= (right + 1e-12, top + 1e-12)).all()
    assert np.allclose(points.max(axis=0), (right, top), atol=1e-2)
    steps = np.hypot(*np.diff(piece.sample(4001), axis=0).T)
    assert steps.sum() == pytest.approx(sum(piece.lengths), rel=1e-6)


def test_json_names_junction_centres_and_radii():
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-2)
    data = json.loads(json.dumps(spline.to_json(), allow_nan=False))
    assert data["primitive"] == "biarc" and data["pieces"] == 5
    for segment, piece in zip(data["segments"], spline.pieces):
        assert segment["kind"] == "biarc"
        assert segment["points"] == [list(piece.start), list(piece.junction), list(piece.end)]
        for centre, radius, ends in zip(
            segment["centres"], segment["radii"], (segment["points"][:2], segment["points"][1:])
        ):
            assert [math.dist(centre, end) for end in ends] == pytest.approx([radius] * 2, rel=1e-12)


def test_straight_arcs_are_finite():
    flat = Biarc("biarc", (0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (2.0, 0.0), ((1.0, 0.0),) * 2, (0.0, 0.0), 0.0)
    assert flat.radii == flat.centres == (None, None)
    assert flat.lengths == (1.0, 1.0)
    assert np.allclose(flat.point([0, 0.25, 1]), [[0, 0], [0.5, 0], [2, 0]])
    data = json.dumps(flat.to_json(), allow_nan=False)
    assert "null" in data
    nearly = replace(flat, curvatures=(2.0**-1000, 0.0))
    assert nearly.lengths == (1.0, 1.0) and nearly.radii == (2.0**1000, None)


def test_svg_writes_the_arcs():
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-4)
    commands = read_path(path_data(spline.pieces, 1e-9)[0])
    assert [letter for letter, *_ in commands] == ["A"] * (2 * len(spline))
    arcs = [(end, radius) for p in spline.pieces for end, radius in zip((p.junction, p.end), p.radii)]
    for (_, _, (rx, ry, rotation, large, sweep), end), (point, radius) in zip(commands, arcs):
        assert rx == ry == pytest.approx(radius, rel=1e-7)
        assert (rotation, large, sweep) == (0, 0, 1)
        assert end == pytest.approx(point, abs=1e-9)


def test_table_5(capsys):
    table = compute("5")
    names = list(table.constants)
    assert [float(table.constants[name]) for name in names] == pytest.approx([0.909416, 0.342232], abs=1e-6)
    for name, counts in zip(names, COUNTS.values()):
        assert [row.pieces["biarc"] for row in table.rows if row.curve == name] == counts
    theory = [4.22, 9.09, 19.59, 90.94, 422.11, 1.59, 3.42, 7.37, 34.22, 158.85]
    assert [round(row.theory, 2) for row in table.rows] == theory
    assert main(["tables", "5"]) == 0
    assert "91   90.94" in capsys.readouterr().out


def test_command_line(capsys):
    assert (
        main(["complexity", SPIRAL[0], "--from", SPIRAL[1], "--to", SPIRAL[2], "--with", "biarc", "--json"])
        == 0
    )
    data = json.loads(capsys.readouterr().out)
    assert data["order"] == 3 and data["constant"].startswith("0.909416")
    arguments = ["--from", SPIRAL[1], "--to", SPIRAL[2], "--with", "biarc", "--tolerance", "1e-6", "--json"]
    assert main(["approximate", SPIRAL[0], *arguments]) == 0
    assert json.loads(capsys.readouterr().out)["pieces"] == 91


def test_the_next_term_is_refused():
    with pytest.raises(DomainError, match="not for 'biarc'"):
        osc.complexity(osc.curve(*SPIRAL), "biarc", next_term=True)
