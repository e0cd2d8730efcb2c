"""Splines round closed curves: the best start against brute force over many starts."""

import math

import numpy as np
import pytest

from osculant.approximation.circuits import Circuit
from osculant.approximation.coordinates import Coordinates
from osculant.approximation.division import divide
from osculant.curves.extent import extent
from osculant.curves.plane import PlaneCurve
from osculant.primitives.table import choose
from osculant.tolerances import window

CIRCLE, ELLIPSE, OVAL = "cos(t), sin(t)", "2*cos(t), sin(t)", "cos(t) + cos(2*t)/20, sin(t)"
#: measured errors are this sharp
WINDOW = 2e-6


def circuit(text, primitive="parabola", metric="hausdorff", low="0"):
    curve = PlaneCurve(text, low, f"{low} + 2*pi")
    division = divide(curve, primitive, closing="smooth", split="never")
    return Circuit(Coordinates(curve, extent(curve)), choose(primitive, metric), division)


def error_by_bisection(around, start, count):
    """The tolerance at which so many greedy pieces just go round."""
    low, high = 1e-12, 2.0
    while high > low * (1 + 1e-9):
        middle = math.sqrt(low * high)
        low, high = (
            (low, middle)
            if around.end_within(middle, start, count) >= start + around.period
            else (middle, high)
        )
    return high


def errors(around, count, starts):
    at = around.low + np.arange(starts) * around.period / starts
    return np.array([error_by_bisection(around, s, count) for s in at])


@pytest.mark.parametrize(
    ("text", "count", "low"),
    [
        (ELLIPSE, 3, "0"),
        (ELLIPSE, 4, "1"),
        (OVAL, 3, "0"),
        (OVAL, 4, "2"),
        (OVAL, 6, "-1/3"),
        (OVAL, 20, "0"),
    ],
)
def test_no_start_of_many_is_better(text, count, low):
    around = circuit(text, low=low)
    best = around.best_start(count)
    every = errors(around, count, 500 if count < 10 else 40)
    assert best.error <= every.min() * (1 + WINDOW)
    assert best.floor < every.min() * (1 + WINDOW)
    assert best.gap == pytest.approx(1e-4)
    assert around.error_from(best.at, count) == best.error
    assert around.low <= best.at <= around.low + around.period
    assert error_by_bisection(around, best.at, count) == pytest.approx(best.error, rel=WINDOW)


def test_the_start_matters():
    """For few pieces by half; for many it cannot be seen."""
    every = errors(circuit(OVAL), 3, 100)
    assert every.max() > 1.5 * every.min()
    every = errors(circuit(OVAL), 30, 20)
    assert every.max() < every.min() * (1 + 5 * WINDOW)


@pytest.mark.parametrize(("text", "metric"), [(CIRCLE, "hausdorff"), (CIRCLE, "area"), (ELLIPSE, "area")])
@pytest.mark.parametrize("count", [3, 8])
def test_where_all_starts_are_equal_the_first_is_kept(text, metric, count):
    around = circuit(text, metric=metric)
    best = around.best_start(count)
    assert best.error == pytest.approx(around.error_from(1.2345, count), rel=1e-9)
    assert best.gap == pytest.approx(1e-4)


def test_three_parabolas_round_a_circle():
    """Control points at distance 2, the middle at 5/4 or so far within: the parabola is off by 1/4."""
    assert circuit(CIRCLE).best_start(3).error == pytest.approx(0.25, rel=1e-9)


@pytest.mark.parametrize(("text", "count"), [(ELLIPSE, 4), (OVAL, 3), (OVAL, 6)])
def test_tolerances_just_above_and_below_the_least_error(text, count):
    around = circuit(text)
    least = around.best_start(count).error
    for tolerance in (least * 1.00001, least * 1.01):
        found, decided = around.start_within(tolerance, count)
        assert decided
        run = around.arcs_from(found).greedy(*window(tolerance, math.ulp(2.0)))
        assert len(run) == count
        assert run.error <= tolerance
        assert run.knots[-1] - run.knots[0] == pytest.approx(2 * math.pi, abs=1e-12)
    assert around.start_within(least * 0.9998, count) == (None, True)


def test_another_start_saves_a_piece():
    around = circuit(OVAL)
    tolerance = 0.2
    assert len(around.arcs_from(around.low).greedy(*window(tolerance, math.ulp(2.0)))) == 4
    found, _ = around.start_within(tolerance, 3)
    assert len(around.arcs_from(found).greedy(*window(tolerance, math.ulp(2.0)))) == 3


def test_a_curve_begun_elsewhere_ends_where_it_begins():
    stretch = circuit(OVAL).arcs_from(2.5).stretch
    assert (stretch.a, stretch.b) == (2.5, 2.5 + 2 * math.pi)
    assert stretch.start == stretch.end
    x, y = math.cos(2.5) + math.cos(5) / 20, math.sin(2.5)
    assert stretch.start.point == pytest.approx((x, y), abs=1e-15)


@pytest.mark.parametrize(("text", "primitive", "count"), [(OVAL, "conic", 4), (ELLIPSE, "biarc", 8)])
def test_across_unsplit_points_nothing_is_said_of_all_starts(text, primitive, count):
    around = circuit(text, primitive)
    assert around.division.free
    assert around.division.unsplit
    best = around.best_start(count)
    assert best.floor == 0
    assert best.error <= around.error_from(around.low, count)
    assert best.error == around.error_from(best.at, count)
    assert len(around.arcs_from(around.low + 1).points) == len(around.division.unsplit)
    found, decided = around.start_within(best.error * 1.01, count)
    assert found is not None
    assert decided
    assert around.best_start(1).error == math.inf
    assert around.start_within(best.error / 10, count) == (None, False)
    some = [around.error_from(start, count) for start in (0.3, 2.0)]
    assert best.error <= min(some) * 1.02
