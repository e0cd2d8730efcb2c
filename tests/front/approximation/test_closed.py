"""Closed curves: never more pieces than from any start, with the proof or the gap told."""

from __future__ import annotations

import math

import numpy as np
import pytest

import osculant as osc
from osculant.cas.errors import DomainError

OVAL = "cos(t) + cos(2*t)/20, sin(t)"
EGG = "2*cos(t), sin(t)*(1 + cos(t)/10)"
ELLIPSE = "3*cos(t), 2*sin(t)"
LISSAJOUS = "2*cos(t + 1), sin(t)"


@pytest.mark.parametrize("metric", ["hausdorff", "area"])
@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc"])
@pytest.mark.parametrize("formula", [OVAL, EGG, ELLIPSE, LISSAJOUS])
def test_no_start_takes_fewer_pieces(formula, primitive, metric):
    whole = osc.curve(formula, 0, "2*pi")
    for tolerance in (0.05, 1e-3, 1e-5):
        spline = osc.approximate(whole, primitive, tolerance, metric=metric)
        assert spline.closed
        assert spline.error <= tolerance
        first, last = spline.pieces[0], spline.pieces[-1]
        assert first.start == pytest.approx(last.end, abs=1e-14)
        assert spline.knots[-1] - spline.knots[0] == pytest.approx(math.tau, abs=1e-12)
        (ax, ay), (bx, by) = first.tangent(0.0), last.tangent(1.0)
        assert abs(ax * by - ay * bx) < 1e-9
        for at in np.linspace(0, math.tau, 23):
            begun = osc.curve(formula, float(at), f"{float(at)!r} + 2*pi")
            other = osc.approximate(begun, primitive, tolerance, metric=metric, closed=False)
            assert len(spline) <= len(other), (at, tolerance)


@pytest.mark.parametrize("metric", ["hausdorff", "area"])
@pytest.mark.parametrize(
    ("formula", "primitive"), [(OVAL, "parabola"), (ELLIPSE, "parabola"), (OVAL, "conic"), (EGG, "biarc")]
)
def test_number_and_tolerance_are_inverse_on_closed_curves(formula, primitive, metric):
    curve = osc.curve(formula, 0, "2*pi")
    before = math.inf
    for count in (6, 8, 10, 12, 24):
        first = osc.approximate(curve, primitive, pieces=count, metric=metric)
        assert first.error < before
        before = first.error
        if len(first.splits) < 2 or primitive == "parabola":
            again = osc.approximate(curve, primitive, first.error * (1 + 1e-9), metric=metric)
            assert len(again) == count


def test_the_best_of_a_given_number_is_not_worse_from_any_start():
    curve = osc.curve(OVAL, 0, "2*pi")
    best = osc.approximate(curve, "parabola", pieces=4)
    assert 0 <= best.gap <= 1e-3
    errors = [
        osc.approximate(
            osc.curve(OVAL, float(at), f"{float(at)!r} + 2*pi"), "parabola", pieces=4, closed=False
        ).error
        for at in np.linspace(0, math.tau, 60)
    ]
    assert best.error <= min(errors) * (1 + 1e-9)
    assert best.error >= min(errors) * (1 - 1e-3)
    assert max(errors) > 1.05 * best.error


def test_closed_curves_that_begin_at_a_corner_or_are_open():
    drop = osc.approximate(osc.curve("t^2, t^3 - t", -1, 1), "conic", 1e-4)
    assert drop.closed
    assert drop.knots[0] == -1.0
    assert not osc.approximate(osc.curve(OVAL, 0, 3), "conic", 1e-4).closed
    with pytest.raises(DomainError, match=r"is not closed: it begins at \(1.05, 0\)"):
        osc.approximate(osc.curve(OVAL, 0, 3), "conic", 1e-4, closed=True)
    held = osc.approximate(osc.curve(OVAL, 0.5, "0.5 + 2*pi"), "parabola", 1e-3, closed=False)
    assert (held.knots[0], held.closed) == (0.5, False)


def test_a_whole_circle_or_ellipse_is_exact():
    assert osc.approximate(osc.curve(ELLIPSE, 0, "2*pi"), "conic", 1e-9).error_kind == "exact"
    circle = osc.approximate(osc.curve("cos(t), sin(t)", 0, "2*pi"), "biarc", pieces=3)
    assert (circle.error_kind, circle.minimal) == ("exact", "proved")
