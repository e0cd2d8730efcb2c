"""Pieces on given arcs, and the quick count of greedy pieces."""

import math

import numpy as np
import pytest

from osculant.kernels import counting, given_knots, operations
from osculant.kernels.conics.records import EquisymmetricConic, Row
from osculant.kernels.operations import ERROR, A, B
from tests.kernels.arcs import (
    HERE,
    NOISE,
    PLANE,
    arc,
    best,
    course_of,
    frame_at,
    jet_of,
    name_of,
    spline,
    stretch,
)

PLACE = HERE._replace(scale=0.125)
SPIRAL = jet_of("t*cos(t), t*sin(t)")
ENDS = math.pi / 6, 2 * math.pi
ALL = pytest.mark.parametrize("fit", PLANE, ids=name_of)


def fitted(fit, knots, jet=SPIRAL):
    """The rows of the best pieces between the knots."""
    a, b = knots[0], knots[-1]
    table = np.empty((len(knots) - 1, operations.columns(type(fit))))
    ends = frame_at(jet, a, PLACE), frame_at(jet, b, PLACE)
    course = course_of(fit, jet, a, b, PLACE)
    given_knots.fit_arcs(fit, jet.address, PLACE, np.asarray(knots), *ends, course, table)
    return table


@ALL
@pytest.mark.parametrize("count", [4, 10, 40])
def test_given_arcs_get_the_best_pieces(fit, count):
    knots = np.linspace(*ENDS, count + 1)
    for i, row in enumerate(fitted(fit, knots)):
        error, _ = best(fit, arc(SPIRAL, knots[i], knots[i + 1], PLACE))
        assert (row[A], row[B]) == (knots[i], knots[i + 1])
        assert row[ERROR] == pytest.approx(error, rel=1e-10 + NOISE / error)


@ALL
def test_errors_change_smoothly_with_the_knots(fit):
    knots = np.linspace(1.0, 6.0, 9)
    step = 1e-4
    errors = np.array(
        [fitted(fit, np.concatenate([[1.0], knots[1:-1] + i * step, [6.0]]))[:, ERROR] for i in range(5)]
    )
    rough = errors[0] - 4 * errors[1] + 6 * errors[2] - 4 * errors[3] + errors[4]
    # every error is off by rounding, of coordinates below 1
    assert np.abs(rough / errors[2]).max() < 16 * (1e-11 + math.ulp(1.0) / errors.min())


def test_an_arc_without_a_proper_piece_says_so():
    first, second = (Row(*row) for row in fitted(EquisymmetricConic(), [-1.0, 0.5, 1.0], jet_of("t, t^3")))
    assert first.error == math.inf
    assert math.isnan(first.q)
    assert math.isfinite(second.error)


@ALL
@pytest.mark.parametrize("level", [1e-3, 1e-6, 1e-9])
def test_the_quick_count_is_a_lower_bound(fit, level):
    def pieces(high):
        window = high * (1 - 1e-6), high
        rows, reached, _ = spline(fit, SPIRAL, *ENDS, window, PLACE, capacity=50_000, length=0.7)
        assert reached == ENDS[1]
        return len(rows)

    call, course = stretch(fit, SPIRAL, *ENDS, PLACE), course_of(fit, SPIRAL, *ENDS, PLACE)
    count = counting.count_larger(*call, level, 0.7, course)
    assert pieces(1.03 * level) <= count <= pieces(level)
