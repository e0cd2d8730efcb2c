"""The best bihelices on given arcs: against mpmath's reference, the greedy spline, and the law's integral."""

import math

import mpmath as mp
import numpy as np
import pytest

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.geometry import bihelix_rules as reference
from osculant.kernels.bihelices.family import EQUIOSCILLATING, THESIS
from osculant.kernels.bihelices.records import COLUMNS, PEAKS, Bihelix
from osculant.kernels.given_knots import fit_arcs
from osculant.kernels.operations import ERROR, SHAPE, A
from osculant.kernels.quadrature import contents
from tests.kernels.arcs import SPACE, course_of, frame_at, jet_of, spline
from tests.kernels.bihelices.chains import BOTH, CONICAL, MOMENT


def fitted(text, knots, rule, place=SPACE):
    """The rows of the best pieces between the knots."""
    jet, fit = jet_of(text, 3), Bihelix(rule)
    knots = np.asarray(knots, dtype=float)
    table = np.empty((len(knots) - 1, COLUMNS))
    ends = frame_at(jet, knots[0], place), frame_at(jet, knots[-1], place)
    course = course_of(fit, jet, knots[0], knots[-1], place)
    fit_arcs(fit, jet.address, place, knots, *ends, course, table)
    return table


@pytest.mark.parametrize("text, a, b", [(MOMENT, 1.0, 1.1), (CONICAL, 2.0, 2.5), (MOMENT, 0.2, 0.5)])
def test_errors_are_those_of_the_reference(text, a, b):
    arc = reference.SpaceArc(parse_tuple(text), mp.mpf(a), mp.mpf(b))
    for rule, find in (
        (THESIS, reference.thesis_bihelix),
        (EQUIOSCILLATING, reference.equioscillating_bihelix),
    ):
        (row,) = fitted(text, [a, b], rule)
        first, second = map(float, reference.peaks(arc, find(arc)))
        if rule == EQUIOSCILLATING:  # the reference's peaks are less equal than these
            first = second = math.sqrt(first * second)
        assert row[ERROR] == pytest.approx(max(first, second), rel=1e-7)
    assert row[PEAKS] == pytest.approx(row[PEAKS + 1], rel=1e-9)


@BOTH
def test_the_greedy_pieces_are_found_again(rule):
    rows, reached, _ = spline(Bihelix(rule), jet_of(CONICAL, 3), 0.5, 6.0, (0.999999e-4, 1e-4), SPACE)
    assert reached == 6.0
    again = fitted(CONICAL, np.append(rows[:, A], 6.0), rule)
    assert np.allclose(again[:, ERROR], rows[:, ERROR], rtol=3e-7)
    assert np.allclose(again[:, SHAPE:], rows[:, SHAPE:], rtol=1e-5, atol=1e-6)


@BOTH
def test_an_error_belongs_to_its_arc_alone(rule):
    table = fitted(MOMENT, [0.0, 0.2, 0.5, 0.9], rule)
    for row, ends in zip(table, [(0.0, 0.2), (0.2, 0.5), (0.5, 0.9)], strict=True):
        assert np.array_equal(fitted(MOMENT, ends, rule)[0], row)


@BOTH
def test_errors_are_smooth_in_the_knots(rule):
    steps = np.linspace(-1e-6, 1e-6, 9)
    errors = np.array([fitted(CONICAL, [1.0, 1.4 + step], rule)[0, ERROR] for step in steps])
    line = np.polynomial.Polynomial.fit(steps, errors, 1)
    assert line.deriv()(0.0) > 0
    assert np.abs(errors / line(steps) - 1).max() < 3e-10


@BOTH
def test_units_of_length(rule):
    (row,) = fitted(MOMENT, [0.2, 0.7], rule)
    scaled = SPACE._replace(x=0.5, y=-1.0, z=2.0, scale=0.25)
    (other,) = fitted(MOMENT, [0.2, 0.7], rule, scaled)
    assert other[ERROR] / scaled.scale == pytest.approx(row[ERROR], rel=1e-9)
    assert other[SHAPE:] == pytest.approx(row[SHAPE:], rel=1e-7, abs=1e-8)


@BOTH
def test_arcs_without_a_bihelix_have_an_infinite_error(rule):
    table = fitted("cos(t), sin(t), t/9", [0.0, 7.0, 8.0, 15.0], rule)
    assert np.isinf(table[[0, 2], ERROR]).all()
    assert table[1, ERROR] < 1e-14


def contents_of(text, order, times, scale=1.0):
    jet = jet_of(text, 3)
    out = np.empty(len(times))
    contents(Bihelix(order=order), jet.address, scale, times, out)
    return out


def test_contents_are_the_laws_integrals():
    found = contents_of(MOMENT, 3.0, np.linspace(1, 2, 2001))[-1]
    # the law's constant is this integral, divided by the cube root of 324
    assert found / 324 ** (1 / 3) == pytest.approx(0.257807, rel=1e-5)  # cas.laws.bihelices
    salkowski = (
        "(-sin(11*t/5)/22 - 2*sin(t/5) - sin(t)/2)*4/5, "
        "(cos(11*t/5)/22 - 2*cos(t/5) + cos(t)/2)*4/5, 4/15*cos(6*t/5)"
    )
    found = contents_of(salkowski, 4.0, np.linspace(0.5, 2.0, 2001))[-1] / 5760 ** (1 / 4)
    assert found == pytest.approx(0.1168086097, rel=1e-6)


def test_contents_grow_and_have_the_dimension_of_the_order():
    times = np.linspace(0.0, 1.0, 301)
    plain, scaled = (contents_of(MOMENT, 3.0, times, scale) for scale in (1.0, 8.0))
    assert plain[0] == 0.0
    assert (np.diff(plain) > 0).all()
    assert np.allclose(scaled, 2.0 * plain, rtol=1e-9)


def test_contents_at_a_cusp_are_finite():
    found = contents_of("t^2, t^3, t^4", 3.0, np.linspace(0.0, 1.0, 1001))
    assert np.isfinite(found).all()
    assert (np.diff(found) > 0).all()
