"""Where a curve winds about a point within its tolerance it is not followed, whatever the primitive is."""

import pytest

import osculant as osc
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
