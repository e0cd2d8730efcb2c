"""A curve, the same curve run through backwards, and its mirror images: as many pieces, and the same word."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import osculant as osc

SPIRAL = ("t*cos(t), t*sin(t)", "1/5", "17/5")
POLE = ("t, tan(t)", "0", "pi/2-1e-6")
CURVES = [
    SPIRAL,
    POLE,
    ("t, exp(t)", "-8", "3"),
    ("t, 1/t", "1/1000", "1"),
    ("t^2, t^3", "0", "2"),
    ("exp(t/3)*cos(t), exp(t/3)*sin(t)", "0", "5"),
    ("t, t^2*log(t)", "1/1000", "2"),
    ("t - sin(t), 1 - cos(t)", "0", "2*pi"),
]


def images(formula, low, high):
    """The curve, backwards, mirrored in both axes and in the diagonal."""
    x, y = formula.split(", ")
    backwards = re.sub(r"\bt\b", f"(({low})+({high})-t)", formula)
    return [formula, backwards, f"-({x}), {y}", f"{x}, -({y})", f"{y}, {x}"]


def words(curve, primitive, tolerance):
    formula, low, high = curve
    found = set()
    for image in images(formula, low, high):
        spline = osc.approximate(osc.curve(image, low, high), primitive, tolerance)
        found.add((len(spline), spline.minimal))
    return found


@pytest.mark.parametrize(
    ("curve", "primitive", "tolerance", "count", "word"),
    [
        (POLE, "biarc", 1, 2, "proved"),  # the second piece is of a short arc and one of length 1e6
        (SPIRAL, "biarc", 0.0673949, 2, "by theory"),  # it turns by more than a biarc; from the inner end
        (POLE, "conic", 1, 1, "proved"),
    ],
)
def test_images_of_special_curves(curve, primitive, tolerance, count, word):
    assert words(curve, primitive, tolerance) == {(count, word)}


@settings(max_examples=8, deadline=None)
@given(st.sampled_from(CURVES), st.sampled_from(["conic", "parabola", "biarc"]), st.floats(-5, -0.5))
def test_images_of_curves(curve, primitive, power):
    assert len(words(curve, primitive, 10.0**power)) == 1
