"""A number of pieces instead of a tolerance: equal errors, monotone, and the inverse of the tolerance."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import KDTree

import osculant as osc
from osculant.cas.errors import DomainError, ToleranceError

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SEXTIC_HALF = ("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", 0, "3*pi/4")
CURVES = [
    SPIRAL,
    SEXTIC_HALF,
    ("t, log(t)", 1, 4),
    ("t, exp(t)", 0, 1.5),
    ("exp(t/4)*cos(t), exp(t/4)*sin(t)", 0, 3),
]
#: (primitive, metric)
KINDS = [
    ("conic", "hausdorff"),
    ("parabola", "hausdorff"),
    ("biarc", "hausdorff"),
    ("conic", "area"),
    ("parabola", "area"),
    ("biarc", "area"),
]


def inverse(curve, primitive, metric, count):
    """Approximate with a number of pieces, and with the error found: both splines, None below the floor."""
    first = osc.approximate(curve, primitive, pieces=count, metric=metric)
    assert len(first) == count
    try:
        return first, osc.approximate(curve, primitive, first.error * (1 + 1e-9), metric=metric)
    except ToleranceError:
        return first, None


def least(curve, primitive, metric):
    """The least number of pieces, as the refusal of a smaller one says."""
    try:
        osc.approximate(curve, primitive, pieces=1, metric=metric)
    except DomainError as error:
        return int(str(error).split("at least ")[1].split(",")[0])
    return 1


def check_inverse(formula, primitive, metric, counts):
    curve = osc.curve(*formula)
    before, seen = math.inf, 0
    lowest = least(curve, primitive, metric)
    for count in (n for n in counts if n >= lowest):
        first, second = inverse(curve, primitive, metric, count)
        assert first.error < before
        before = first.error
        if second is None:
            break
        assert len(second) == count, (count, first.error)
        assert second.error <= first.error * (1 + 1e-9)
        seen += 1
    assert seen >= 4


@pytest.mark.parametrize("formula", CURVES, ids=lambda formula: formula[0])
@pytest.mark.parametrize(("primitive", "metric"), KINDS)
def test_number_and_tolerance_are_inverse(formula, primitive, metric):
    check_inverse(formula, primitive, metric, [1, 2, 3, 4, 5, 6, 7, 12, 29, 77])


@pytest.mark.slow
@pytest.mark.parametrize("formula", CURVES, ids=lambda formula: formula[0])
@pytest.mark.parametrize(("primitive", "metric"), KINDS)
def test_number_and_tolerance_are_inverse_up_to_200(formula, primitive, metric):
    check_inverse(formula, primitive, metric, range(1, 201))


@pytest.mark.parametrize("formula", CURVES, ids=lambda formula: formula[0])
@pytest.mark.parametrize(("primitive", "metric"), KINDS)
def test_errors_are_equal_and_near_the_prediction(formula, primitive, metric):
    curve = osc.curve(*formula)
    spline = osc.approximate(curve, primitive, pieces=40, metric=metric)
    if len(spline.splits) == 0:
        rounding = 100 * np.spacing(10.0) / max(spline.errors)
        assert max(spline.errors) <= min(spline.errors) * (1 + 1e-9 + rounding)
    assert spline.error == pytest.approx(spline.predicted_error, rel=0.05)
    assert spline.given == "pieces"
    assert spline.error < spline.tolerance <= spline.error * (1 + 1e-6) + 1e-12


def test_stretches_share_the_pieces_by_their_errors():
    curve = osc.curve("t, t^3", -1, 3)  # an inflection at 0, and the part after it is much larger
    spline = osc.approximate(curve, "conic", pieces=12)
    cut = spline.knots.index(0.0)
    for errors in (spline.errors[:cut], spline.errors[cut:]):
        assert max(errors) <= min(errors) * (1 + 1e-8)
    # one piece from the better stretch for the worse one would not help
    worse = osc.approximate(osc.curve("t, t^3", -1, 0), "conic", pieces=max(cut - 1, 1)).error
    assert cut == 1 or worse >= spline.error


def test_of_two_equal_halves_one_gets_the_odd_piece():
    curve = osc.curve("4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "-3*pi/4", "3*pi/4")
    seven, six = (osc.approximate(curve, "conic", pieces=n) for n in (7, 6))
    assert len(seven) == 7
    assert seven.error == pytest.approx(six.error, rel=1e-9)
    assert min(seven.errors) < 0.5 * seven.error


@pytest.mark.parametrize(
    ("pieces", "sentence"),
    [
        (0, "number of pieces is 0: give a whole number"),
        (-2, "number of pieces is -2"),
        (2.5, "number of pieces is 2.5"),
        ("many", "number of pieces is many"),
        (True, "number of pieces is True"),
        (3, "takes at least 4, as it is split into 4 parts"),
    ],
)
def test_bad_numbers(pieces, sentence):
    with pytest.raises(DomainError, match=sentence):
        osc.approximate(osc.curve("t, sin(t)", 0, "2*pi"), "conic", pieces=pieces)


def test_a_tolerance_and_a_number_are_one_too_many():
    with pytest.raises(DomainError, match="leave one out"):
        osc.approximate(osc.curve(*SPIRAL), "conic", 1e-3, pieces=3)


@pytest.mark.parametrize("count", [1, 2, 7])
def test_the_curve_itself_in_any_number_of_pieces(count):
    ellipse = osc.approximate(osc.curve("3*cos(t), 2*sin(t)", 0, 2), "conic", pieces=count)
    assert (len(ellipse), ellipse.error, ellipse.error_kind) == (count, 0.0, "exact")
    line = osc.approximate(osc.curve("t^3, 2*t^3", 1, 2), "parabola", pieces=count)
    assert (len(line), line.error) == (count, 0.0)
    lengths = [math.dist(piece.start, piece.end) for piece in line.pieces]
    assert max(lengths) <= min(lengths) * 1.02
    circle = osc.approximate(osc.curve("cos(t), sin(t)", 0, 5), "biarc", pieces=count)
    assert (len(circle), circle.error) == (count, 0.0)


@settings(max_examples=15, deadline=None)
@given(
    st.floats(-3, 3).map(lambda x: round(x, 3)),
    st.integers(2, 30),
    st.sampled_from(KINDS),
    st.floats(-100, 100),
)
def test_scaling_and_number(bend, count, kind, exponent):
    """The same knots at any scale; the error scales as a length or an area."""
    primitive, metric = kind
    scale = 2.0 ** round(exponent)
    formula = f"t, t^2 + ({bend})*t^3/20 + exp(t)/9"
    x, y = formula.split(", ")
    small = osc.approximate(osc.curve(formula, 0, 1), primitive, pieces=count, metric=metric)
    large = osc.approximate(
        osc.curve(f"{scale!r}*({x}), {scale!r}*({y})", 0, 1), primitive, pieces=count, metric=metric
    )
    power = 2 if metric == "area" else 1
    rounding = 1e3 * np.spacing(4.0) / small.error
    assert large.error == pytest.approx(small.error * scale**power, rel=1e-8 + rounding)
    assert large.knots == pytest.approx(small.knots, abs=1e-4)


def test_errors_that_rounding_made_prove_nothing():
    spline = osc.approximate(osc.curve(*SPIRAL), "conic", pieces=1500)
    assert (len(spline), spline.minimal) == (1500, "unknown")
    assert spline.error < 1e-13


def test_what_is_no_curve_is_refused():
    for curve in ("t, t^2", None, 3):
        with pytest.raises(DomainError, match="of formulas and the ends of an interval"):
            osc.approximate(curve, "conic")
    assert osc.approximate(osc.curve(*SPIRAL), "conic", 1e-3, split_at=2).splits == (2.0,)
    assert osc.approximate(osc.curve(*SPIRAL), "conic", 1e-3, split_at="3/2").splits == (1.5,)


@pytest.mark.parametrize(
    ("formula", "primitive", "metric", "counts"),
    [
        (("exp(-t/5)*cos(t), exp(-t/5)*sin(t)", 0, 20), "parabola", "hausdorff", (7, 8, 9)),
        (("exp(-t/5)*cos(t), exp(-t/5)*sin(t)", 0, 20), "conic", "hausdorff", (5, 6)),
        (("exp(-t/5)*cos(t), exp(-t/5)*sin(t)", 0, 20), "conic", "area", (5, 6, 7)),
        (("exp(-t/5)*cos(t), exp(-t/5)*sin(t)", 0, 20), "biarc", "hausdorff", (9, 10, 11)),
        (("t*cos(t), t*sin(t)", 0.5, 20), "parabola", "hausdorff", (9, 10)),
        (("exp(t/10)*cos(t), exp(t/10)*sin(t)", 0, 12), "parabola", "hausdorff", (4, 5)),
    ],
)
def test_few_pieces_that_turn_far(formula, primitive, metric, counts):
    """Knots at equal content leave arcs without a proper piece here; greedy pieces do not."""
    curve = osc.curve(*formula)
    for count in counts:
        spline = osc.approximate(curve, primitive, pieces=count, metric=metric)
        assert (len(spline), math.isfinite(spline.error)) == (count, True)
        if metric == "area":  # where turning limits pieces they cannot all have the same area
            continue
        again = osc.approximate(curve, primitive, spline.error * (1 + 1e-6), metric=metric)
        assert len(again) <= count
        fewer = osc.approximate(curve, primitive, spline.error * 0.97, metric=metric)
        assert len(fewer) > count


def test_the_least_number_is_told_at_once():
    loop = osc.curve("(1 + 2*cos(t))*cos(t), (1 + 2*cos(t))*sin(t)", 0.1, 6)
    lowest = least(loop, "conic", "hausdorff")
    assert len(osc.approximate(loop, "conic", pieces=lowest)) == lowest
    with pytest.raises(DomainError, match=f"at least {lowest},"):
        osc.approximate(loop, "conic", pieces=lowest - 1)


def test_long_conics_are_not_taken_for_better_than_they_are():
    """Pieces turning far beyond π, whose far side no normal of the curve met by continuity."""
    for rate, high, tolerance in ((0.2, 5, 1.74036569), (1, 6, 21.2), (1 / 3, 6, 4.112), (2, 5, 4243.0)):
        growth = f"exp({rate!r}*t)"
        curve = osc.curve(f"{growth}*cos(t), {growth}*sin(t)", 0, high)
        spline = osc.approximate(curve, "conic", tolerance)
        times = np.linspace(0, high, 200_001)
        points = np.exp(rate * times)[:, None] * np.column_stack([np.cos(times), np.sin(times)])
        assert KDTree(points).query(spline.sample(2001))[0].max() <= tolerance * (1 + 1e-4)
