"""Features below the tolerance, exact curves under odd parametrisations, and many special points."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import osculant as osc
from osculant.approximation.bridging import width
from osculant.approximation.division import divide
from osculant.pieces.bridges import biarcs, parabolas, space_arcs


def bezier(*points):
    """The formulas of a Bézier curve; coordinates as text, so that every digit counts."""
    degree = len(points) - 1
    rows = zip(*points)
    return ", ".join(
        " + ".join(f"{math.comb(degree, i)}*({c})*t^{i}*(1-t)^{degree - i}" for i, c in enumerate(row))
        for row in rows
    )


def off(spline, formula, low, high, samples=4001):
    """An independent lower bound of the curve's distance from the spline, from dense points of both.

    Parameters crowd at both ends, where the features are.
    """
    crowded = np.concatenate([np.linspace(0, 1, samples), np.geomspace(1e-12, 0.5, samples)])
    times = low + (high - low) * np.concatenate([crowded, 1 - crowded])
    points = osc.curve(formula, low, high).jets(times)[..., 0]
    fine = spline.sample(2001)
    step = np.linalg.norm(np.diff(fine, axis=0), axis=1).max()
    nearest = [np.linalg.norm(fine - point, axis=1).min() for point in points[::7]]
    return max(nearest) - step


HOOKS = [
    (bezier((0, 0), (50, 50), ("100.0000001", 90), (100, 90)), {"conic": 3, "biarc": 4, "parabola": 5}),
    (bezier((0, 0), (50, 50), ("100.000000001", 90), (100, 90)), {"conic": 3, "biarc": 4, "parabola": 5}),
    (bezier((0, 0), (50, 50), ("100.00001", 90), (100, 90)), {"conic": 3, "biarc": 4, "parabola": 5}),
    (bezier((100, 25), ("100.0000001", 25), (110, 100), (150, 195)), {"conic": 4, "biarc": 6, "parabola": 6}),
]


@pytest.mark.parametrize(("formula", "counts"), HOOKS)
def test_a_hook_below_the_tolerance_costs_at_most_a_piece(formula, counts):
    for primitive, count in counts.items():
        spline = osc.approximate(osc.curve(formula, 0, 1), primitive, 1e-3)
        assert count <= len(spline) <= count + 1, primitive
        assert spline.error <= 1e-3 and spline.max_tangent_jump() < 1e-9
        assert off(spline, formula, 0, 1) <= 1e-3
        assert spline.bridged and all(extent <= 1e-3 for *_, extent in spline.bridged)
        assert (spline.knots[0], spline.knots[-1]) == (0.0, 1.0)
        assert spline.minimal == "unknown"


def test_a_hairpin_that_doubles_cannot_follow_is_the_parabola_that_it_is():
    formula = bezier(("339.927", "706.25"), ("243.92700000000002", "806.25"), ("243.927", "806.25"))
    for primitive in ("conic", "parabola"):
        spline = osc.approximate(osc.curve(formula, 0, 1), primitive, 1e-3)
        assert (len(spline), spline.error, spline.minimal) == (1, 0.0, "proved")
    for primitive in ("biarc", "polygon"):
        spline = osc.approximate(osc.curve(formula, 0, 1), primitive, 1e-3)
        assert len(spline) == 1 and spline.error <= 1e-3 and spline.bridged


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("primitive", ["conic", "biarc", "parabola"])
def test_counts_of_nearly_equal_cubics_are_nearly_equal(seed, primitive):
    rng = np.random.default_rng(seed)
    points = rng.uniform(0, 200, (4, 2)) + (0, 100, 1e6)[seed % 3]
    apart = 10.0 ** rng.uniform(-11, -5)
    moved = points.copy()
    points[2] = points[3]
    moved[2] = points[3] + apart * rng.uniform(-1, 1, 2)
    splines = [
        osc.approximate(
            osc.curve(bezier(*([f"{c:.14f}" for c in p] for p in control)), 0, 1), primitive, 1e-2
        )
        for control in (points, moved)
    ]
    assert abs(len(splines[0]) - len(splines[1])) <= 1
    assert all(spline.error <= 1e-2 and spline.max_tangent_jump() < 1e-8 for spline in splines)


def test_a_cubic_that_is_nearly_a_segment_is_one():
    formula = bezier((0, 0), ("0.0000003", "-0.0000002"), ("90.0000001", "40.0000002"), (90, 40))
    for primitive in ("conic", "biarc", "parabola", "polygon"):
        spline = osc.approximate(osc.curve(formula, 0, 1), primitive, 1e-3)
        assert len(spline) == 1 and 0 < spline.error < 1e-6 and spline.minimal == "proved"


def test_a_near_cusp_is_passed_as_a_cusp_is():
    points = [(0.0, 0.0), (100.0, 70.0), (0.0, 70.0), (100.0, 0.0)]
    cusp = osc.approximate(osc.curve(bezier(*points), 0, 1), "conic", 1e-3)
    points[2] = (points[2][0] + 1e-8, points[2][1])
    near = osc.approximate(osc.curve(bezier(*points), 0, 1), "conic", 1e-3)
    assert abs(len(cusp) - len(near)) <= 1 and near.error <= 1e-3 and near.max_tangent_jump() < 1e-9


def test_without_small_arcs_nothing_is_passed_over():
    assert osc.approximate(osc.curve("t, sin(t)", 1, 9), "conic", 1e-4).bridged == ()
    curve = osc.curve("t, t^3", "-1/1000000", 1)
    assert divide(curve, "conic", extent=1e-5).bridged and not divide(curve, "conic", extent=1e-7).bridged
    assert divide(curve, "conic", split_at=["1/10000000"], extent=1e-5).bridged == ()


def test_the_width_of_a_curve_is_bounded():
    assert 1 <= width(osc.curve("t, 4*t*(1-t)", 0, 1)) < 1.01
    assert width(osc.curve("t, t", 0, 1)) < 1e-40


FRAMES = [
    ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)),
    ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)),
    ((0.0, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 0.0)),
    ((0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 0.0)),
    ((0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (0.6, 0.8)),
    ((0.0, 0.0), (-0.6, 0.8), (1.0, 0.0), (-0.6, -0.8)),
]


@pytest.mark.parametrize("make", [parabolas, biarcs])
@pytest.mark.parametrize("frames", FRAMES)
def test_bridges_are_tangent_and_small(make, frames):
    p, u, q, v = frames
    pieces = make((0.0, 1.0), (p, u), (q, v), 0.5)
    assert pieces[0].start == p and pieces[-1].end == q
    arcs = [arc for piece in pieces for arc in piece.arcs]
    assert np.allclose(arcs[0].tangent(0.0), u) and np.allclose(arcs[-1].tangent(1.0), v)
    for before, after in pairwise(arcs):
        assert np.allclose(before.point(1.0), after.point(0.0))
        assert np.allclose(before.tangent(1.0), after.tangent(0.0))
    assert max(np.linalg.norm(arc.sample(50), axis=1).max() for arc in arcs) < 6


@pytest.mark.parametrize("frames", FRAMES)
def test_bridges_in_space_are_tangent(frames):
    (px, py), (ux, uy), (qx, qy), (vx, vy) = frames
    end = (qx, qy, 0.4), (0.8 * vx, 0.8 * vy, 0.6)
    pieces = space_arcs((0.0, 1.0), ((px, py, 0.0), (ux, uy, 0.0)), end, 0.5)
    arcs = [arc for piece in pieces for arc in piece.arcs]
    assert np.allclose(arcs[0].tangent(0.0), (ux, uy, 0)) and np.allclose(arcs[-1].tangent(1.0), end[1])
    assert np.allclose(arcs[-1].point(1.0), end[0])
    for before, after in pairwise(arcs):
        assert np.allclose(before.point(1.0), after.point(0.0))
        assert np.allclose(before.tangent(1.0), after.tangent(0.0))


EXACT = [
    ("tanh(30*t), tanh(30*t)^2", -1, 1, ("parabola", "conic")),
    ("tanh(20*t), tanh(20*t)^2", -1, 1, ("parabola", "conic")),
    ("tanh(300*t), tanh(300*t)^2", -1, 1, ("parabola",)),
    ("100 + tanh(30*t), 1000000 + tanh(30*t)^2", -1, 1, ("parabola", "conic")),
    ("t^3, t^6", -1, 1, ("parabola", "conic")),
    ("sinh(t)^3, sinh(t)^6", -1, 1, ("parabola", "conic")),
    ("exp(30*t), exp(60*t)", -1, 0, ("parabola",)),
    ("1/t, 1/t^2", "0.1", 2, ("parabola",)),
    ("t^3, 2*t^3 + 1", -1, 1, ("conic", "biarc", "polygon")),
    ("cos(tanh(30*t)), sin(tanh(30*t))", -1, 1, ("conic", "biarc")),
    ("cos(t^3), sin(t^3)", -1, 1, ("conic", "biarc")),
    ("tanh(30*t), 1/cosh(30*t)", -1, 1, ("conic", "biarc")),
    ("exp(t^3), exp(-t^3)", -1, 1, ("conic",)),
    ("t^3, 1/t^3", "0.1", 2, ("conic",)),
    ("3*cos(exp(t)), sin(exp(t))", -2, 1, ("conic",)),
]


@pytest.mark.parametrize(("formula", "low", "high", "primitives"), EXACT)
def test_exact_curves_are_found_under_any_parametrisation(formula, low, high, primitives):
    for primitive in primitives:
        curve = osc.curve(formula, low, high)
        spline = osc.approximate(curve, primitive, 1e-6)
        assert (len(spline), spline.error, spline.error_kind) == (1, 0.0, "exact"), primitive
        assert spline.minimal == "proved" and not spline.undecided
        fine, points = spline.sample(20_001), curve.jets(np.linspace(*curve.interval, 41)[1:-1])[..., 0]
        step = np.linalg.norm(np.diff(fine, axis=0), axis=1).max()
        assert max(np.linalg.norm(fine - point, axis=1).min() for point in points) <= step


def test_a_reversal_on_a_conic_stays_a_split():
    assert osc.approximate(osc.curve("cos(t), cos(t)^2", 1, 4), "conic", 1e-3).splits == (math.pi,)


def test_whole_ellipses_are_cut_evenly():
    spline = osc.approximate(osc.curve("3*cos(t + sin(t)/2), sin(t + sin(t)/2)", 0, "2*pi"), "conic", 1e-9)
    angles = np.diff(np.array(spline.knots) + np.sin(spline.knots) / 2)
    assert len(spline) == 3 and np.allclose(angles, 2 * math.pi / 3)
    assert spline.max_tangent_jump() < 1e-12


def test_many_special_points_are_all_decided():
    spline = osc.approximate(osc.curve("t, sin(t)", 0, 400), "biarc", 1e-2)
    assert not spline.undecided and spline.minimal == "by theory"
    assert np.allclose(spline.splits[::2], math.pi * (np.arange(len(spline.splits[::2])) + 0.5))


def test_a_flat_beginning_is_decided():
    spline = osc.approximate(osc.curve("t, exp(-1/t)", "0.001", 1), "conic", 1e-3)
    assert not spline.undecided and spline.splits == pytest.approx([0.2591278876, 0.5])


def test_an_open_enclosure_leaves_the_estimate():
    for tolerance in (1.0, 3.0):
        spline = osc.approximate(osc.curve("t*cos(t), t*sin(t)", "pi/6", "2*pi"), "parabola", tolerance)
        estimate = spline.error
        proof = spline.certify()
        assert spline.error <= tolerance
        if not proof.within:
            assert (spline.error, spline.error_kind) == (estimate, "estimate")


def test_a_corner_at_the_seam_is_told():
    spline = osc.approximate(osc.curve("t^2, t^3 - t", -1, 1), "conic", 1e-3)
    assert spline.closed and spline.corner == pytest.approx(math.pi / 2)
    assert osc.approximate(osc.curve("2*cos(t), sin(t)", 0, "2*pi"), "biarc", 1e-3).corner < 1e-9


def test_the_tangent_on_both_sides_takes_as_many_biarcs():
    formulas = "t, tan(t)", "pi/2-1/1000000-t, tan(pi/2-1/1000000-t)"
    splines = [osc.approximate(osc.curve(f, 0, "pi/2-1/1000000"), "biarc", 1) for f in formulas]
    assert len(splines[0]) == len(splines[1]) and splines[0].minimal == splines[1].minimal


@pytest.mark.parametrize("primitive", ["biarc", "cubic", "conic"])
@pytest.mark.parametrize(
    "formula", ["exp(-t/50)*cos(t), exp(-t/50)*sin(t)", "exp(t/50)*cos(t), exp(t/50)*sin(t)"]
)
def test_many_turns_below_the_tolerance_are_passed_over_at_their_true_size(formula, primitive):
    low, high = (0, "200*pi") if "-" in formula else (-628, 0)
    spline = osc.approximate(osc.curve(formula, low, high), primitive, 1e-2)
    assert spline.error <= 1e-2
    for first, last, extent in spline.bridged:
        t = np.linspace(first, last, 5001)
        points = spline.curve.jets(t)[..., 0]
        size = max(np.linalg.norm(points - point, axis=1).max() for point in points[::50])
        assert size <= extent <= 5e-3
    if primitive == "cubic":  # others may be unable to turn towards the end
        [(first, last, _)] = spline.bridged
        assert last - first > 250 and len(spline) < 120


@pytest.mark.parametrize("primitive", ["conic", "biarc", "cubic"])
def test_sizes_near_the_limits_of_doubles(primitive):
    counts = set()
    for size in ("1", "1e-260", "1e200", "1e300"):
        curve = osc.curve(f"{size}*t, {size}*(t^3 + t^4)", -1, 1)
        spline = osc.approximate(curve, primitive, float(size) * 1e-4)
        assert spline.error <= float(size) * 1e-4
        counts.add(len(spline))
    assert len(counts) == 1
    with pytest.raises(osc.OsculantError, match="too small for double numbers: scale it"):
        osc.approximate(osc.curve("1e-310*t, 1e-310*t^3", -1, 1), primitive, 1e-314)
