"""Cubic pieces against de Casteljau's rule and dense samples."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from osculant.cas.errors import DomainError
from osculant.pieces.chain import Chain, conic_arcs, plane_arcs
from osculant.pieces.cubics import Cubic

POINTS = st.lists(st.tuples(st.floats(-3, 3), st.floats(-3, 3)), min_size=4, max_size=4)


def made(points, interval=(0.0, 1.0)):
    start, first, last, end = points
    return Cubic(interval, start, (first, last), end, 0.0)


def casteljau(points, u):
    row = [np.array(point) for point in points]
    while len(row) > 1:
        row = [p + u * (q - p) for p, q in pairwise(row)]
    return row[0]


@settings(max_examples=50, deadline=None)
@given(POINTS, st.floats(0, 1))
def test_points(points, u):
    piece = made(points)
    assert piece.point(u) == pytest.approx(casteljau(points, u), abs=1e-14)
    assert tuple(piece.point(0.0)) == points[0] and tuple(piece.point(1.0)) == points[3]
    assert Chain([piece]).evaluate(u) == pytest.approx(piece.point(u), abs=1e-15)
    step = 1e-6
    rate = (casteljau(points, u + step) - casteljau(points, u - step)) / (2 * step)
    assert piece.velocity(u) == pytest.approx(rate, abs=1e-6)


@settings(max_examples=50, deadline=None)
@given(POINTS)
def test_boxes_and_lengths(points):
    piece = made(points)
    dense = piece.sample(4001)
    low, high = (np.array(corner) for corner in piece.bounding_box())
    assert (dense >= low - 1e-13).all() and (dense <= high + 1e-13).all()
    assert low == pytest.approx(dense.min(axis=0), abs=1e-5)
    assert high == pytest.approx(dense.max(axis=0), abs=1e-5)
    polygon = np.hypot(*np.diff(dense, axis=0).T).sum()
    assert polygon <= piece.length * (1 + 1e-9)
    assert piece.length == pytest.approx(polygon, rel=1e-5, abs=1e-9)


def test_tangents():
    piece = made([(0.0, 0.0), (1e-200, 1e-200), (1.0, 0.0), (2.0, 0.0)])
    assert piece.tangent(0.0) == pytest.approx([math.sqrt(0.5)] * 2)
    assert piece.tangent(1.0) == pytest.approx([1.0, 0.0])


def test_arcs():
    piece = made([(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)], (2.0, 3.0))
    assert plane_arcs([piece]) == [piece] and piece.numbers == 6 and piece.arc_ends == (2.0, 3.0)
    with pytest.raises(DomainError, match="of kind 'cubic', which is no arc of a conic"):
        conic_arcs([piece])
    assert piece.to_json() == {
        "kind": "cubic",
        "interval": [2.0, 3.0],
        "points": [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]],
        "error": 0.0,
    }
