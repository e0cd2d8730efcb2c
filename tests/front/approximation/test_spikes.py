"""Spikes narrower than the tolerance: pieces that turn around them are not nearer than they are."""

import pytest

import osculant as osc
from tests.random_curves import Case, try_out


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc", "cubic"])
@pytest.mark.parametrize("spike", ["exp(-{}*t^2)", "1/(1 + {}*t^2)", "0.1*exp(-{}*(t - 0.1)^2) + t^2"])
def test_errors_of_pieces_around_a_spike_are_the_true_ones(spike, primitive):
    for tolerance in (0.01, 0.004):
        text = f"t, {spike.format('1e6')}"
        outcome = try_out(Case(0, "spike", text, "-1", "1", primitive, tolerance))
        assert outcome.verdict == "within", outcome


def test_what_overflows_on_the_way_is_approximated():
    """cosh(1000) is no double, its reciprocal is 0."""
    spline = osc.approximate(osc.curve("t, 1/cosh(1000*t)", -1, 1), "cubic", 0.01)
    assert len(spline) <= 4
    assert spline.certify().within
