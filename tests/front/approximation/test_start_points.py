"""The best start of a closed spline, against brute force over many starts."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.approximation.start_points import Start, best_start, start_within


class Pieces:
    """Pieces on a circle of length 1, longer for a larger level, and here than there."""

    def __init__(self, waves, depth, order=4):
        self.waves, self.depth, self.order = waves, depth, order

    def reach(self, start, level, count):
        for _ in range(count):
            wave = math.sin(2 * math.pi * self.waves * start)
            start += level ** (1 / self.order) * (1 + self.depth * wave)
        return start

    def error_from(self, start, count):
        """The level at which the greedy pieces just go round, by bisection."""
        low, high = 0.0, 1.0
        for _ in range(60):
            level = (low + high) / 2
            low, high = (low, level) if self.reach(start, level, count) >= start + 1 else (level, high)
        return high

    def errors(self, count, starts=400):
        """From starts all over the circle."""
        return np.array([self.error_from(s, count) for s in np.arange(starts) / starts])


#: waves, depth, pieces: depth·2π·waves < (1 − depth)·pieces, so that ends of pieces grow with their starts
MAPS = [(1, 0.15, 3), (2, 0.16, 3), (3, 0.13, 3), (3, 0.15, 4), (3, 0.15, 7), (2, 0.13, 2), (1, 0.0, 5)]


@pytest.mark.parametrize(("waves", "depth", "count"), MAPS)
def test_the_best_start_is_no_worse_than_any_and_its_floor_is_below_all(waves, depth, count):
    pieces = Pieces(waves, depth)
    best = best_start(lambda s: pieces.error_from(s, count), pieces.reach, 0.1234, 1.0, count)
    errors = pieces.errors(count)
    assert best.error <= errors.min() * (1 + 1e-9)
    assert best.error == pieces.error_from(best.at, count)
    assert 0 < best.floor < errors.min()
    assert best.gap == pytest.approx(1e-4)


def test_the_best_start_matters_where_pieces_and_waves_lock():
    """Else the tests above could not fail: every start would be the best."""
    errors = Pieces(3, 0.13).errors(3)
    assert errors.max() > 1.5 * errors.min()


class Valley(Pieces):
    """All starts are equal but those in one narrow place, from where pieces are a little longer."""

    def __init__(self):
        super().__init__(0, 0.0)

    def reach(self, start, level, count):
        for _ in range(count):
            off = math.remainder(start - 0.04567, 1.0) / 0.003
            start += level ** (1 / self.order) * (1 + 0.003 * math.exp(-off * off))
        return start


def test_a_valley_that_samples_miss_is_met_by_the_proof():
    pieces = Valley()
    best = best_start(lambda s: pieces.error_from(s, 3), pieces.reach, 0.0, 1.0, 3)
    errors = pieces.errors(3, 3000)
    assert np.median(errors) > errors.min() * 1.003
    assert best.floor < errors.min()
    assert best.error < errors.min() * (1 + 1e-4)
    assert best.gap == pytest.approx(1e-4)


@pytest.mark.parametrize("work", [0, 10, 1000, 30_000])
def test_bounded_work_widens_the_gap(work):
    pieces = Pieces(2, 0.16)
    best = best_start(lambda s: pieces.error_from(s, 3), pieces.reach, 0.0, 1.0, 3, work=work)
    assert best.floor <= pieces.errors(3).min()
    assert best.error == pytest.approx(best_start(
        lambda s: pieces.error_from(s, 3), pieces.reach, 0.0, 1.0, 3).error, rel=1e-9)  # fmt: skip
    assert (best.floor == 0) == (work <= 10)
    assert work > 1000 or best.gap > 1e-4


def test_errors_that_cannot_be_told_apart_end_the_proof():
    pieces = Pieces(2, 0.16)
    rough = best_start(lambda s: pieces.error_from(s, 3), pieces.reach, 0.0, 1.0, 3, resolution=1e-4)
    assert rough.gap == pytest.approx(1e-2)
    assert 1e-3 * rough.error < 1e-4 < 1e-2 * rough.error


def test_no_start_at_all():
    best = best_start(lambda s: math.inf, lambda s, level, count: s, 0.0, 1.0, 2)
    assert best == Start(0.0, math.inf, 0.0)


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(MAPS), st.floats(-0.3, 1.3), st.floats(0, 1))
def test_a_start_within_a_tolerance_is_found_or_excluded(shape, share, low):
    waves, depth, count = shape
    pieces = Pieces(waves, depth)
    errors = pieces.errors(count, 100)
    tolerance = float(errors.min() + share * max(np.ptp(errors), 0.01 * errors.min()))

    def reach(start, number):
        return pieces.reach(start, tolerance, number)

    found, decided = start_within(reach, reach, low, 1.0, count)
    if found is not None:
        assert decided
        assert reach(found, count) >= found + 1
    if share > 0.01:
        assert found is not None
    if share < -0.01:
        assert (found, decided) == (None, True)


def test_what_lies_between_two_accuracies_is_not_decided():
    """Errors within the tolerance do not go round, errors no smaller than it do."""
    found = start_within(lambda s, n: s + 0.3332 * n, lambda s, n: s + 0.3334 * n, 0.0, 1.0, 3)
    assert found == (None, False)


def test_little_work_excludes_nothing():
    def reach(start, count):
        return start + (1 - 1e-6) / 3 * count

    assert start_within(reach, reach, 0.0, 1.0, 3, work=300) == (None, False)
    assert start_within(reach, reach, 0.0, 1.0, 3, work=3_000_000) == (None, True)
