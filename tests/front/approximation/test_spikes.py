"""Spikes narrower than the tolerance: pieces that turn around them are not nearer than they are."""

import pytest

from tests.random_curves import Case, try_out


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc", "cubic"])
@pytest.mark.parametrize("spike", ["exp(-{}*t^2)", "1/(1 + {}*t^2)", "0.1*exp(-{}*(t - 0.1)^2) + t^2"])
def test_errors_of_pieces_around_a_spike_are_the_true_ones(spike, primitive):
    for tolerance in (0.01, 0.004):
        text = f"t, {spike.format('1e6')}"
        outcome = try_out(Case(0, "spike", text, "-1", "1", primitive, tolerance))
        assert outcome.verdict == "within", outcome
