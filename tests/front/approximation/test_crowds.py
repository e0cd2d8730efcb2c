"""Where a curve winds about a point within its tolerance it is not followed, whatever the primitive is."""

import numpy as np
import pytest

import osculant as osc
from osculant.approximation.bridging import CROWD, crowded
from osculant.approximation.runs import Run
from tests.hausdorff import Formula, distance
from tests.random_curves import RESOLVED

#: curve, interval, tolerance; where it is wide enough to be followed
WINDING = [
    ("exp(-t/50)*cos(t), exp(-t/50)*sin(t)", "0", "200*pi", 0.03, (0, 270)),
    ("exp(t/20)*cos(t), exp(t/20)*sin(t)", "-300", "0", 0.01, (-115, 0)),
    ("exp(-t^2/50)*cos(10*t), exp(-t^2/50)*sin(10*t)", "-25", "25", 0.03, (-16.6, 16.6)),
]


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc", "cubic", "polygon"])
@pytest.mark.parametrize(("text", "low", "high", "tolerance", "wide"), WINDING)
def test_whatever_winds_within_the_tolerance_is_passed_over(text, low, high, tolerance, wide, primitive):
    spline = osc.approximate(osc.curve(text, low, high), primitive, tolerance)
    alone = osc.approximate(osc.curve(text, *wide), primitive, tolerance)
    assert spline.bridged and len(spline.pieces) <= len(alone.pieces) + 8
    assert primitive == "polygon" or spline.max_tangent_jump() < 1e-9
    assert spline.knots[0] == float(spline.curve.interval[0])
    assert spline.knots[-1] == float(spline.curve.interval[1])


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
@pytest.mark.parametrize(("text", "low", "high", "tolerance", "wide"), WINDING)
def test_the_tolerance_is_kept_there(text, low, high, tolerance, wide, primitive):
    segments = osc.approximate(osc.curve(text, low, high), primitive, tolerance).to_json()["segments"]
    formula = Formula(text, low, high)
    edges = formula.parts(segments[0]["interval"][0], segments[-1]["interval"][1], RESOLVED * tolerance)
    for segment in [*segments[:4], *segments[-4:]]:
        found = distance(formula, segment, edges, 6)
        assert found <= segment["error"] * (1 + 1e-5) + 1e-7 * tolerance and segment["error"] <= tolerance


def plainly_crowded(points, knots, extent):
    """What `crowded` says, from all distances."""
    found, first = [], 0
    while first + CROWD < len(points):
        away = np.linalg.norm(points[first:] - points[first], axis=1) > extent / 2
        last = first + int(np.argmax(away) if away.any() else len(away)) - 1
        if last - first >= CROWD:
            found += [float(knots[first]), float(knots[last])]
        first = max(last, first + 1)
    return found


@pytest.mark.parametrize("extent", [1e-9, 1e-3, 0.02, 0.3, 5.0])
@pytest.mark.parametrize("count", [2, 4, 5, 6, 60, 400])
def test_crowds_are_found_without_looking_at_all_distances(count, extent):
    curve = osc.curve("exp(-t)*cos(20*t), exp(-t)*sin(20*t)", 0, 12)
    knots = np.sort(np.random.default_rng(count).uniform(0, 12, count + 1))
    run = Run(knots, np.zeros(count), np.empty((count, 0)))
    assert crowded(curve, [run], extent) == plainly_crowded(curve.jets(knots)[..., 0], knots, extent)


def test_so_many_pieces_are_looked_through_at_once():
    """All distances would be 4e10."""
    count = 200_000
    run = Run(np.linspace(0, 12, count + 1), np.zeros(count), np.empty((count, 0)))
    curve = osc.curve("exp(-t)*cos(20*t), exp(-t)*sin(20*t)", 0, 12)
    found = crowded(curve, [run], 1e-3)
    assert len(found) > 2 and found[-1] == 12.0 and found == sorted(found)
