"""No error beyond the tolerance: random curves against an independent distance (`tests.random_curves`)."""

import pytest

import osculant as osc
from osculant.approximation.division import divide
from tests.hausdorff import Formula, distance
from tests.random_curves import EXCESS, HONEST, draw, try_out

#: seeds whose curves are looked at in every run, and in slow runs, in groups
FEW, MANY, GROUP = range(12), range(12, 412), 10


def check(seed):
    """The curve of a seed is approximated within the tolerance, the report true, or refused in a sentence."""
    case = draw(seed)
    outcome = try_out(case)
    assert not outcome.fails, f"{case.question}: {outcome}"
    assert outcome.pieces or outcome.sentence


@pytest.mark.parametrize("seed", FEW)
def test_random_curves(seed):
    check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("first", MANY[::GROUP])
def test_many_random_curves(first):
    for seed in range(first, first + GROUP):
        check(seed)


def test_seeds_tell_curves():
    assert draw(7) == draw(7)
    cases = [draw(seed) for seed in range(200)]
    assert len({case.question for case in cases}) == 200
    assert {case.primitive for case in cases} == {
        "parabola",
        "conic",
        "cubic",
        "biarc",
        "bihelix",
        "polygon",
    }


#: what went wrong before the course of a curve began with its parts: features that no sample saw
FEATURES = [
    # a spike in space, a millionth of the interval wide
    ("t + 7*exp(-((t+0.4535)/(6.5*10^-6))^2), t^2, t/10", "-1", "1", "polygon", 0.0087),
    ("t, t^2, t^3 + exp(-((t-0.513)/0.0001)^2)/10", "0", "1", "polygon", 1e-3),
    ("t, t^2, t^3 + exp(-((t-0.513)/0.0001)^2)/10", "0", "1", "bihelix", 1e-3),
    ("cos(t), sin(t), t/3 + 0.003*exp(-((t-1.7)/(2*10^-6))^2)", "0", "3", "bihelix", 1e-3),
    # a bump of just more than the tolerance, and waves of just less
    ("t, t^2, t/10 + 0.0011*exp(-((t-0.24)/0.001)^2)", "-1", "1", "bihelix", 1e-3),
    ("t, t^2, t/10 + 0.0009*sin(50*t)", "-1", "1", "polygon", 1e-3),
    # in the plane, an arc that turns sharply just before its end
    ("cos(t), sin(t) + 0.02*exp(-((t-1.1)/0.001)^2)", "0", "2", "polygon", 0.03),
    ("cos(t), sin(t) + 0.02*exp(-((t-1.1)/0.001)^2)", "0", "2", "polygon", 0.006),
    # uneven parametrisations of the same
    ("t^9, t^18, t^27 + 0.003*exp(-((t^9-0.4)/0.00001)^2)", "0.1", "1", "polygon", 1e-3),
]


@pytest.mark.parametrize(("text", "low", "high", "primitive", "tolerance"), FEATURES)
def test_features_between_samples(text, low, high, primitive, tolerance):
    spline = osc.approximate(osc.curve(text, low, high), primitive, tolerance)
    formula = Formula(text, low, high)
    edges = formula.parts(*spline.chain.knots[:: len(spline)], 1e-3 * tolerance)
    for piece in spline.to_json()["segments"]:
        found = distance(formula, piece, edges, 4)
        assert found <= tolerance * EXCESS
        assert found <= piece["error"] * HONEST + 1e-7 * tolerance


@pytest.mark.parametrize(
    ("text", "primitive", "zeros", "open_points"),
    [
        ("t, 0.3*t*t + 0.04494*exp(-((t-0.806164)/0.0001057)^2)", "parabola", 4, 2),
        ("t, t/2 + 0.003*exp(-((t-0.6)/0.00001)^2)", "polygon", 2, 0),  # from the factors of the form
    ],
)
def test_special_points_of_a_bump_on_a_piece_are_found(text, primitive, zeros, open_points):
    # elsewhere the forms are as good as nothing: exp(-10^7)
    division = divide(osc.curve(text, -1, 1), primitive)
    assert len(division.splits) - len(division.undecided) == zeros
    assert len(division.undecided) == open_points  # where the bump is told from nothing
    assert max(division.splits) - min(division.splits) < 0.01


def test_a_bump_on_a_straight_line_is_not_straight():
    # at 600 digits the bump is nothing but where it is
    line = osc.curve("t, t/2 + 0.003*exp(-((t-0.6)/0.001)^2)", -1, 1)
    assert not line.vanishes("inflection")
    space = osc.curve("cos(t), sin(t), 0.01*exp(-((t-1)/0.0001)^2)", 0, 3)
    assert not space.vanishes("vertex")
    assert osc.curve("t, t/2", -1, 1).vanishes("inflection")
    assert osc.curve("cos(t), sin(t), t/7", 0, 9).vanishes("vertex")
