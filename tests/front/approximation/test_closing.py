"""Closed curves: how they are told from open ones, and where they are divided."""

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.approximation.closing import closing
from osculant.approximation.division import divide
from osculant.cas.errors import DomainError
from osculant.cas.laws.complexity import complexity_constant
from osculant.curves.plane import PlaneCurve

OVAL = "cos(t) + cos(2*t)/20, sin(t)"
EIGHT = "cos(t), sin(2*t)"
ASTROID = "cos(t)^3, sin(t)^3"


def turn(text, low="0", turns=1):
    return PlaneCurve(text, low, f"{low} + 2*pi*{turns}")


@pytest.mark.parametrize("low", ["0", "1", "-7/3", "1000*pi + 1/7", "sqrt(2)"])
@pytest.mark.parametrize("text", [OVAL, EIGHT, ASTROID, "cos(7*t)*cos(t), cos(7*t)*sin(t)", "3, sin(t)"])
def test_a_period_is_smooth_from_wherever_it_begins(text, low):
    assert closing(turn(text, low)) == closing(turn(text, low), True) == "smooth"
    assert closing(turn(text, low), False) == "open"


@pytest.mark.parametrize(
    ("text", "low", "high", "kind"),
    [
        ("t^2, t^3 - t", "-1", "1", "corner"),  # a loop
        ("(1 - t^2)/(1 + t^2), 2*t/(1 + t^2)", "-1", "1", "open"),
        (EIGHT, "pi/2", "3*pi/2", "corner"),  # half of the eight ends where it crosses itself
        ("cos(t), sin(t) + t*(t - 2*pi)/100", "0", "2*pi", "corner"),
        # as smooth as can be at the seam but no period: all its derivatives agree there but the ninth
        ("cos(t), sin(t) + (t*(t - 2*pi))^9", "0", "2*pi", "corner"),
        # what comes after 2π is another formula, and after 4π too: probes of α(t + T) do not see that
        ("cos(t), sin(t) + abs(t - 12.5) + t - 12.5", "0", "2*pi", "corner"),
        ("cos(t), sin(t) + abs(t - 13) + t - 13", "0", "2*pi", "smooth"),
        ("cos(t)*abs(sin(t) - 2), cbrt(3 + cos(t))*sin(t)", "0", "2*pi", "smooth"),
        ("cos(t), sin(t)", "0", "6.283185307179586", "open"),  # a decimal is no period
        ("cos(t) + 10^(-40)*t, sin(t)", "0", "2*pi", "open"),
    ],
)
def test_kinds_of_seams(text, low, high, kind):
    curve = PlaneCurve(text, low, high)
    curve.check_finite()
    assert closing(curve) == kind
    if kind == "open":
        with pytest.raises(DomainError, match="is not closed"):
            closing(curve, True)


def test_an_open_curve_called_closed_is_told_its_ends():
    with pytest.raises(DomainError, match=r"begins at \(0, 0\) and ends at \(3, 9\), 9\.49 apart"):
        closing(PlaneCurve("t, t^2", 0, 3), True)


@settings(max_examples=8, deadline=None)
@given(st.fractions(-5, 5, max_denominator=50), st.sampled_from([OVAL, EIGHT, ASTROID]))
def test_split_points_do_not_depend_on_where_a_closed_curve_begins(low, text):
    """Nor does an end of the interval beside a split point, or on it, make a second one."""
    for primitive in ("parabola", "conic", "biarc"):
        here = divide(turn(text, str(low)), primitive, closing="smooth")
        there = divide(turn(text), primitive, closing="smooth")
        assert here.free == there.free
        places, wanted = (
            sorted(math.remainder(part.a, 2 * math.pi) for part in division.stretches if not division.free)
            for division in (here, there)
        )
        assert set(here.splits) <= {part.a for part in here.stretches}
        turned = [abs(math.remainder(t - u, 2 * math.pi)) for t, u in zip(places, wanted, strict=True)]
        if max(turned, default=0) > 1e-12:  # −π and π are sorted apart
            turned = [min(abs(math.remainder(t - u, 2 * math.pi)) for u in wanted) for t in places]
        assert max(turned, default=0) < 1e-12


@pytest.mark.parametrize("low", ["0", "pi/2", "1/3"])
@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
@pytest.mark.parametrize("text", [OVAL, EIGHT, ASTROID])
def test_stretches_go_once_round(text, primitive, low):
    division = divide(turn(text, low), primitive, closing="smooth")
    parts = division.stretches
    assert division.free == (len(parts) == 1)
    assert parts[-1].b - parts[0].a == pytest.approx(2 * math.pi, abs=1e-14)
    around = zip(parts, [*parts[1:], parts[0]], strict=True)
    for part, after in around:
        assert part.end.point == after.start.point
        dot = sum(s * t for s, t in zip(part.end.tangent, after.start.tangent, strict=True))
        assert dot == pytest.approx(-1 if text == ASTROID and _is_cusp(part.b) else 1, abs=1e-15)
    for part, after in pairwise(parts):
        assert part.b == after.a


def _is_cusp(t):
    return abs(math.remainder(t, math.pi / 2)) < 1e-9


def test_what_a_user_asks_for_on_a_closed_curve():
    oval = turn(OVAL)
    for seam in (0, "2*pi"):
        at_seam = divide(oval, "parabola", [seam], "smooth")
        assert not at_seam.free
        assert [(part.a, part.b) for part in at_seam.stretches] == [(0, 2 * math.pi)]
        assert at_seam.splits == ()  # it is an end of the interval
        with pytest.raises(DomainError, match=r"split point .* is not inside"):
            divide(oval, "parabola", [seam])
    both = divide(oval, "parabola", [1, 0, "2*pi"], "smooth")
    assert [(part.a, part.b) for part in both.stretches] == [(0, 1), (1, 2 * math.pi)]
    inside = divide(oval, "parabola", [1, 2], "smooth")
    assert [(part.a, part.b) for part in inside.stretches] == [(1, 2), (2, 1 + 2 * math.pi)]
    with pytest.raises(DomainError, match="split point 7 is not inside"):
        divide(oval, "parabola", [7], "smooth")


def test_a_split_asked_for_at_a_cusp_leaves_it_a_cusp():
    astroid = turn(ASTROID)
    plain, asked = divide(astroid, "conic"), divide(astroid, "conic", ["pi/2", "pi"])
    assert [part.start for part in asked.stretches] == [part.start for part in plain.stretches]
    closed = divide(astroid, "conic", [0, "pi"], "smooth")
    assert [part.start for part in closed.stretches] == [part.start for part in plain.stretches]


@pytest.mark.parametrize(
    ("text", "primitive", "how", "splits", "unsplit"),
    [
        (OVAL, "conic", "open", 0, 5),  # the sextactic point at 0 is an end
        (OVAL, "conic", "smooth", 0, 6),
        (EIGHT, "conic", "smooth", 2, 2),
        (EIGHT, "parabola", "smooth", 2, 4),
        (EIGHT, "biarc", "open", 2, 5),  # besides a vertex at 0
        (EIGHT, "biarc", "smooth", 2, 6),
        (ASTROID, "conic", "smooth", 3, 4),  # and the cusp where it begins
        (ASTROID, "conic", "open", 3, 4),
    ],
)
def test_never_splitting_keeps_cusps_and_inflections(text, primitive, how, splits, unsplit):
    always = divide(turn(text), primitive, (), how)
    division = divide(turn(text), primitive, (), how, "never")
    assert (len(division.splits), len(division.unsplit)) == (splits, unsplit)
    for at in division.unsplit:
        assert min(abs(math.remainder(at - t, 2 * math.pi)) for t in (*always.splits, 0)) < 1e-14
        holding = [part for part in division.stretches if part.a < at < part.b or (division.free and at == 0)]
        assert len(holding) == 1
    assert always.unsplit == ()


def test_unsplit_points_beyond_the_interval_lie_in_the_last_stretch():
    division = divide(turn(EIGHT), "parabola", (), "smooth", "never")
    last = division.stretches[-1]
    assert last.b == pytest.approx(5 * math.pi / 2)
    assert [at for at in division.unsplit if at > 2 * math.pi] == [pytest.approx(9 * math.pi / 4)]


def test_never_splitting_still_splits_where_asked():
    division = divide(turn(OVAL), "conic", [0, Fraction(5, 2)], "smooth", "never")
    assert (division.splits, division.stretches[0].a) == ((2.5,), 0.0)
    assert len(division.unsplit) == 5
    with pytest.raises(DomainError, match="'always' is unknown: choose theory or never"):
        divide(turn(OVAL), "conic", split="always")


def test_exact_curves_stay_exact():
    circle = divide(turn("cos(t), sin(t)"), "conic", (), "smooth", "never")
    assert (circle.free, circle.stretches[0].kind, circle.unsplit) == (True, "exact", ())


def test_complexity_is_the_same_beyond_the_interval():
    """The last stretch of the eight, from 7π/4 to 9π/4 for parabolas, by the formula of the curve."""
    eight = turn(EIGHT)
    closed, opened = (divide(eight, "parabola", (), how) for how in ("smooth", "open"))
    contents = [
        sum(complexity_constant(eight.balls, "parabola", part.low, part.high)[0] for part in parts)
        for parts in (closed.stretches, opened.stretches)
    ]
    assert len(closed.stretches) == len(opened.stretches) - 1  # no knot at the seam
    assert float(contents[0]) == pytest.approx(float(contents[1]), rel=1e-12)
