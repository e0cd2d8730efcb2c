"""Chains of pieces in the plane and in space: the same as their pieces, one by one."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import osculant as osc
from osculant.cas.errors import DomainError
from osculant.pieces.chain import Chain, conic_arcs
from osculant.pieces.conics import Piece
from osculant.pieces.helices import HelixArc, SpacePiece

#: with pieces of every class; a stretch of the last is straight
CURVES = {
    "conic": ("t*cos(t), t*sin(t)", "1/2", 6),
    "biarc": ("t, t^3", -1, 1),
    "bihelix": ("t*cos(t), t*sin(t), t", "1/2", 6),
}


def segment(a, b, start, end):
    length = math.dist(start, end)
    direction = tuple((q - p) / length for p, q in zip(start, end))
    return SpacePiece((a, b), (HelixArc(start, direction, direction, 0.0, 0.0, length),), 0.0)


def chains():
    for primitive, curve in CURVES.items():
        yield osc.approximate(osc.curve(*curve), primitive, 1e-2).chain
    helix = osc.approximate(osc.curve("cos(t), sin(t), t", 0, 2), "bihelix").pieces[0]
    yield Chain([helix, segment(2.0, 3.0, helix.end, (0.0, 0.0, 9.0))])


@pytest.fixture(scope="module", params=[0, 1, 2, 3], ids=[*CURVES, "helix and segment"])
def chain(request):
    return list(chains())[request.param]


def test_samples_are_those_of_the_pieces(chain):
    points = chain.sample(9)
    assert points.shape == (8 * len(chain) + 1, chain.dimension)
    size = chain.largest
    for i, piece in enumerate(chain.pieces):
        assert points[8 * i : 8 * i + 9] == pytest.approx(piece.sample(9), abs=1e-13 * size)


def test_parameters_are_divided_where_arcs_meet(chain):
    size = chain.largest
    for piece in chain.pieces:
        assert (piece.arc_ends[0], piece.arc_ends[-1]) == piece.interval
        for arc, (low, high) in zip(piece.arcs, pairwise(piece.arc_ends), strict=True):
            found = chain.evaluate([low, 0.7 * low + 0.3 * high])
            assert found == pytest.approx(arc.point([0.0, 0.3]), abs=1e-12 * size)
    assert chain.evaluate(chain.knots[-1]) == pytest.approx(chain.pieces[-1].end, abs=1e-13 * size)
    with pytest.raises(DomainError, match="has no point at t = "):
        chain.evaluate(chain.knots[-1] + 1)


def test_the_box_holds_the_samples_and_touches_them(chain):
    low, high = map(np.array, chain.bounding_box())
    points = chain.sample(2001)
    assert (points >= low - 1e-12).all() and (points <= high + 1e-12).all()
    assert np.allclose([points.min(axis=0), points.max(axis=0)], [low, high], atol=1e-4)


def test_numbers_are_those_of_start_and_pieces(chain):
    assert chain.numbers == chain.dimension + sum(piece.numbers for piece in chain.pieces)


@pytest.mark.parametrize("angle", [1e-9, 0.3, math.pi / 2, 2.5, math.pi])
def test_tangent_lines_meet_at_the_angle_between_them(angle):
    """In the plane and in space; where the tangent turns back is a cusp, and lines make the smaller angle."""
    corner = math.cos(angle), math.sin(angle)
    flat = [
        Piece.segment((0.0, 1.0), (-1.0, 0.0), (0.0, 0.0)),
        Piece.segment((1.0, 2.0), (0.0, 0.0), corner),
    ]
    high = [
        segment(0.0, 1.0, (0.0, -1.0, 0.0), (0.0, 0.0, 0.0)),
        segment(1.0, 2.0, (0.0,) * 3, (0.0, *corner)),
    ]
    for pieces in (flat, high):
        chain = Chain(pieces)
        assert chain.max_tangent_jump() == pytest.approx(min(angle, math.pi - angle), rel=1e-6, abs=1e-15)
        assert chain.cusps == ([1.0] if angle > 2 else [])


def test_only_pieces_in_the_plane_are_conic():
    assert len(conic_arcs([Piece.segment((0.0, 1.0), (0.0, 0.0), (1.0, 0.0))])) == 1
    with pytest.raises(
        DomainError, match=r"piece on \(0\.0, 1\.0\) is of kind 'segment', which is no arc of a conic"
    ):
        conic_arcs([segment(0.0, 1.0, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0))])
