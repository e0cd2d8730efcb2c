"""Compiled approximators find what the kernels find through numba, bit for bit."""

import numpy as np
import pytest

import osculant as osc
from tests.front.compiled.fixed import greedy, knots_of, needs_cc

pytestmark = needs_cc

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SINE = ("t, sin(t)", 1, 4)
CUSP = ("t^2, t^3", -1, 1)
UNEVEN = ("t, 1/(1+25*t^2)", -1, 1)
EIGHT = ("cos(t), sin(2*t)", "1/3", 5)
CONE = ("t*cos(t), t*sin(t), t", "pi/6", "2*pi")
TUBE = ("2*cos(t), sin(t), t/5", 1, 4)
DELTOID = ("2*cos(t)+cos(2*t), 2*sin(t)-sin(2*t)", 0, "2*pi")
CUSPS = ("(t-1/3)^3, (t-1/3)^4, (t-1/3)^5", -1, 1)
TOLERANCES = (1e-2, 1e-4, 1e-7)

#: curve, primitive, metric, rule
CASES = [
    *((curve, "conic", "hausdorff", None) for curve in (SPIRAL, SINE, CUSP, UNEVEN)),
    *((DELTOID, name, "hausdorff", None) for name in ("parabola", "conic", "biarc", "cubic", "polygon")),
    *((CUSPS, name, "hausdorff", None) for name in ("bihelix", "polygon")),
    *((curve, "parabola", "hausdorff", None) for curve in (SPIRAL, SINE)),
    *((curve, "biarc", "hausdorff", None) for curve in (SPIRAL, EIGHT)),
    *((curve, "polygon", "hausdorff", None) for curve in (UNEVEN, CONE)),
    *((curve, "bihelix", "hausdorff", None) for curve in (CONE, TUBE)),
    (CONE, "bihelix", "hausdorff", "thesis"),
    (SINE, "cubic", "hausdorff", None),
    (SINE, "conic", "area", "equisymmetric"),
]
#: those that take longer, as their kernels do
MORE = [
    *((curve, "cubic", "hausdorff", None) for curve in (SPIRAL, UNEVEN)),
    *((curve, "conic", "area", "minimal-area") for curve in (SPIRAL, CUSP)),
    (SPIRAL, "parabola", "area", None),
    (EIGHT, "biarc", "area", None),
    (UNEVEN, "polygon", "area", None),
    (SINE, "cubic", "area", None),
]


def compared(folder, curve, primitive, metric, rule):
    made = osc.compile_approximator(
        curve[0], primitive, *curve[1:], metric=metric, rule=rule, folder=folder, name="made"
    )
    module = made.load()
    for tolerance in TOLERANCES:
        pieces = module.approximate(tolerance)
        knots, errors = greedy(curve, primitive, tolerance, metric, rule)
        assert knots_of(pieces).tolist() == knots.tolist()
        assert pieces["error"].tolist() == errors.tolist()
    return module


@pytest.mark.parametrize(("curve", "primitive", "metric", "rule"), CASES)
def test_knots_and_errors_are_those_of_the_kernels(tmp_path, curve, primitive, metric, rule):
    compared(tmp_path, curve, primitive, metric, rule)


@pytest.mark.slow
@pytest.mark.parametrize(("curve", "primitive", "metric", "rule"), MORE)
def test_knots_and_errors_of_the_others(tmp_path, curve, primitive, metric, rule):
    compared(tmp_path, curve, primitive, metric, rule)


def shape(pieces, *names):
    """Columns side by side."""
    return np.stack([pieces[name] for name in names], axis=1)


def test_shapes_are_those_of_splines(tmp_path):
    curve = osc.curve(*SPIRAL)
    made = {
        name: osc.compile_approximator(
            SPIRAL[0], name, *SPIRAL[1:], folder=tmp_path, name=name
        ).load().approximate(1e-5)
        for name in ("conic", "biarc", "polygon")
    }  # fmt: skip
    conics = osc.approximate(curve, "conic", 1e-5).pieces
    assert shape(made["conic"], "x0", "y0", "mx", "my", "x2", "y2", "weight").tolist() == [
        [*piece.start, *piece.middle, *piece.end, piece.weight] for piece in conics
    ]
    segments = osc.approximate(curve, "polygon", 1e-5).pieces
    assert shape(made["polygon"], "x0", "y0", "x1", "y1").tolist() == [
        [*piece.start, *piece.end] for piece in segments
    ]
    biarcs = osc.approximate(curve, "biarc", 1e-5).pieces
    found = shape(made["biarc"], "x0", "y0", "x1", "y1", "x2", "y2", "tx0", "ty0", "bend0", "bend1")
    assert found.tolist() == [
        [*piece.start, *piece.junction, *piece.end, *piece.tangents[0], *piece.curvatures] for piece in biarcs
    ]
    turned = np.array([piece.tangents[1] for piece in biarcs])  # Python's hypot is not libm's
    assert np.abs(shape(made["biarc"], "tx1", "ty1") - turned).max() < 4e-16


def test_more_pieces_than_the_search_keeps_its_state_for(tmp_path):
    module = osc.compile_approximator(SINE[0], "polygon", *SINE[1:], folder=tmp_path).load()
    knots, errors = greedy(SINE, "polygon", 3e-9)
    pieces = module.approximate(3e-9)
    assert len(pieces) > 3 * 4096
    assert knots_of(pieces).tolist() == knots.tolist() and pieces["error"].tolist() == errors.tolist()


def test_so_many_pieces_have_about_the_least_error(tmp_path):
    module = osc.compile_approximator(SPIRAL[0], "conic", *SPIRAL[1:], folder=tmp_path).load()
    for number in (4, 9, 30):
        pieces = module.approximate(pieces=number)
        least = osc.approximate(osc.curve(*SPIRAL), "conic", pieces=number).error
        assert len(pieces) == number
        assert pieces["error"].max() == pytest.approx(least, rel=1e-6)


def test_what_a_spline_says_holds_of_the_compiled_one(tmp_path):
    """Where nothing is to be gained or passed over, `approximate` has the same knots."""
    made = osc.compile_approximator(SINE[0], "conic", *SINE[1:], folder=tmp_path)
    spline = osc.approximate(osc.curve(*SINE), "conic", 1e-6)
    assert knots_of(made.load().approximate(1e-6)).tolist() == list(spline.knots)
    assert made.splits == spline.splits
