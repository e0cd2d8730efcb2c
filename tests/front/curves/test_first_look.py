"""The first look in doubles finds what ball arithmetic finds, and leaves open what it cannot tell."""

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.cas.formulas.parser import parse
from osculant.cas.numbers.balls import PRECISION, FormulaBalls, constant, precision
from osculant.cas.zeros.form_zeros import FormZeros, ZeroForm
from osculant.curves.first_look import FirstLook

NAMES = ("cusp", "inflection", "sextactic", "vertex", "parabolic")

CURVES = [
    ("t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    ("t, sin(t) + sin(3*t)/5", "0", "2*pi"),
    ("exp(t/3)*cos(5*t), log(1+t)*sin(t)", "0", "3"),
    ("2*cos(t) - cos(2*t), 2*sin(t) - sin(2*t)", "0.1", "6"),
    ("t, t^3 - t/1000000", "-1", "1"),
    ("t^2, t^3 - t/100000", "-1", "1"),
    ("1e6 + t, t^4 - t^2", "-1", "1"),
    ("1e-6*cos(t), 1e-6*sin(2*t)", "0.1", "3"),
    ("cos(t), sin(t) + 0.001*exp(-((t-1)/0.001)^2)", "0", "2"),
]


@pytest.mark.parametrize(("text", "low", "high"), CURVES)
@pytest.mark.parametrize("name", NAMES)
def test_the_zeros_of_balls_alone(text, low, high, name):
    curve = osc.curve(text, low, high)
    alone = FormZeros(curve.balls, curve.zeros.forms).within(*curve.ends, [name])
    helped = curve.zeros.within(*curve.ends, [name])
    assert len(alone) == len(helped)
    for one, other in zip(alone, helped, strict=True):
        assert one.kinds == other.kinds and one.decided == other.decided
        assert abs(one.at - other.at) < 1e-9 * (1 if not one.decided else 1e-12)


@pytest.mark.parametrize(("text", "low", "high"), CURVES)
def test_brackets_hold_one_change_of_sign(text, low, high):
    curve = osc.curve(text, low, high)
    with precision(PRECISION):
        found = curve.zeros.look(NAMES, *map(constant, curve.ends))
        for name, brackets in found.brackets.items():
            for start, end in brackets:
                signs = [curve.zeros.series(name, t, 1)[0] for t in (start, end)]
                assert signs[0] * signs[1] < 0
                slope = found.slopes[name, float(start.mid())]
                inside = [curve.zeros.series(name, start + (end - start) * k / 4, 2)[1] for k in range(5)]
                assert all(slope.contains(at) for at in inside) and not slope.contains(0)


@given(st.lists(st.floats(-0.99, 0.99), min_size=1, max_size=4), st.integers(-8, 0))
@settings(max_examples=60, deadline=None)
def test_zeros_of_polynomials(places, exponent):
    # some of them nearly or quite the same
    places = [round(place * 10.0**exponent, 14) for place in places]
    polynomial = parse("*".join(f"(t - ({place!r}))" for place in places))
    form = {"zero": ZeroForm(lambda value: value, 0)}
    with precision(PRECISION):
        look = FirstLook(FormulaBalls([polynomial], lambda rows: rows[0]), form)(["zero"], arb(-1), arb(1))
        exact = [constant(parse(repr(place))) for place in places]
    seen = list(look.brackets["zero"])
    assert all(sum(start <= at <= end for at in exact) == 1 for start, end in seen)
    seen += [(box.low, box.high) for box in look.unresolved]
    assert all(any(start <= at <= end for start, end in seen) for at in exact)


def test_double_zeros_are_open():
    curve = osc.curve("t, (t - 1/3)^4*(1 + t^2)", -1, 1)
    with precision(PRECISION):
        found = curve.zeros.look(("inflection",), arb(-1), arb(1))
        assert any(box.low < arb(1) / 3 < box.high for box in found.unresolved)
        assert all(box.high - box.low < 1e-6 for box in found.unresolved)
    assert [point.decided for point in curve.special_points(["inflection"])] == [True]


def test_zeros_at_the_ends_are_found():
    curve = osc.curve("t, sin(t)", 0, "2*pi")
    points = curve.special_points(["inflection"])
    with precision(PRECISION):
        for point, at in zip(points, (arb(0), arb.pi(), 2 * arb.pi()), strict=True):
            assert point.decided and point.at.overlaps(at)
