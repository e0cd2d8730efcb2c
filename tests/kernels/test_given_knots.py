"""Pieces on given arcs, and the quick count of greedy pieces."""

import math

import numpy as np
import pytest
from osculant.kernels.primitives import (
    AREA_PARABOLA,
    BIARC,
    CONIC,
    EQUISYMMETRIC,
    EQUISYMMETRIC_BIARC,
    LEAST_AREA,
    PARABOLA,
)

from osculant.cas.formulas.parser import parse_tuple
from osculant.codegen.jets import compile_jet
from osculant.kernels import counting, given_knots
from osculant.kernels import search as greedy
from osculant.kernels.conics import scan
from osculant.kernels.conics.minimax import minimax
from osculant.kernels.curves.plane import JET_SIZE

NOISE = 4 * math.ulp(1.0)
PLACE = (0.0, 0.0, 0.125, 1.0, NOISE)
SPIRAL = compile_jet(parse_tuple("t*cos(t), t*sin(t)"), 2)
ENDS = math.pi / 6, 2 * math.pi


def frames(jet, knots):
    source = (jet.address, PLACE, np.empty(JET_SIZE))
    return [greedy.frame(source, t) for t in knots]


def fit(code, knots, jet=SPIRAL):
    table = np.empty((len(knots) - 1, greedy.COLUMNS))
    ends = frames(jet, [knots[0], knots[-1]])
    given_knots.fit_arcs(code, jet.address, PLACE, np.asarray(knots), *ends, table)
    return table


CODES = [PARABOLA, CONIC, BIARC, AREA_PARABOLA, EQUISYMMETRIC, LEAST_AREA, EQUISYMMETRIC_BIARC]


@pytest.mark.parametrize("code", CODES)
@pytest.mark.parametrize("count", [4, 10, 40])
def test_given_arcs_get_the_best_pieces(code, count):
    knots = np.linspace(*ENDS, count + 1)
    table = fit(code, knots)
    at = frames(SPIRAL, knots)
    source = (SPIRAL.address, PLACE, np.empty(JET_SIZE))
    for i, row in enumerate(table):
        error, _ = minimax(code, source, knots[i], at[i], knots[i + 1], at[i + 1], scan.workspace())
        assert (row[0], row[1]) == (knots[i], knots[i + 1])
        assert row[greedy.ERROR] == pytest.approx(error, rel=1e-10 + NOISE / error)


@pytest.mark.parametrize("code", CODES)
def test_errors_change_smoothly_with_the_knots(code):
    knots = np.linspace(1.0, 6.0, 9)
    step = 1e-4
    errors = np.array(
        [fit(code, np.concatenate([[1.0], knots[1:-1] + i * step, [6.0]]))[:, 3] for i in range(5)]
    )
    rough = errors[0] - 4 * errors[1] + 6 * errors[2] - 4 * errors[3] + errors[4]
    assert np.abs(rough / errors[2]).max() < 16 * 1e-11


def test_an_arc_without_a_proper_piece_says_so():
    curve = compile_jet(parse_tuple("t, t^3"), 2)
    table = fit(EQUISYMMETRIC, [-1.0, 0.5, 1.0], curve)
    assert table[0, greedy.ERROR] == math.inf
    assert math.isnan(table[0, 2])
    assert math.isfinite(table[1, greedy.ERROR])


@pytest.mark.parametrize("code", CODES)
@pytest.mark.parametrize("level", [1e-3, 1e-6, 1e-9])
def test_the_quick_count_is_a_lower_bound(code, level):
    start, last = frames(SPIRAL, ENDS)
    call = (code, SPIRAL.address, PLACE, ENDS[0], start, ENDS[1], last)
    table = np.empty((4000, greedy.COLUMNS))

    def pieces(high):
        return greedy.spline(*call, high * (1 - 1e-6), high, 0.7, table)[0]

    assert pieces(1.03 * level) <= counting.count_larger(*call, level, 0.7) <= pieces(level)
