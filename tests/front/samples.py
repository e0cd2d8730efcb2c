"""Pieces and splines for the tests of the front door."""

from __future__ import annotations

import math
from types import SimpleNamespace

from hypothesis import strategies as st

from osculant.pieces.conics import Piece, classify
from osculant.spline import Spline


def circle(a, b, *, radius=1.0, shift=0.0, error=0.0):
    """Return the arc of a circle from angle a to b < a + 2π."""
    half, mean = (b - a) / 2, (a + b) / 2
    weight = math.cos(half)
    ends = [(shift + radius * math.cos(t), shift + radius * math.sin(t)) for t in (a, b)]
    middle = (weight * shift + radius * math.cos(mean), weight * shift + radius * math.sin(mean))
    return Piece(classify(weight), (a, b), ends[0], ends[1], middle, weight, error)


def spline_of(pieces, *, text="x(t), y(t)", primitive="conic", tolerance=1e-6, predict=None):
    return Spline(
        curve=SimpleNamespace(text=text),
        primitive=primitive,
        metric="hausdorff",
        rule=None,
        tolerance=tolerance,
        pieces=tuple(pieces),
        judge=lambda: "by theory",
        predict=predict,
    )


def written(spline, writer, *, room=None, command=None, **options):
    """What a writer makes of a spline, with the room that `Spline.write` gives it."""
    facts = spline.facts(command)
    draft = writer(spline.chain, facts, facts.room(spline.chain) if room is None else room, **options)
    return draft.text(None)


@st.composite
def pieces(draw, weights=None):
    """Draw a conic arc of any size and place, with any end tangents and turning up to nearly 2π."""
    if weights is None:
        weights = st.one_of(
            st.floats(-0.95, 50),
            st.floats(-0.05, 0.05),
            st.builds(lambda x, s: 1 + s * 10**x, st.floats(-16, -1), st.sampled_from([-1, 1])),
            st.sampled_from([0.0, 0.5, 1.0, 2.0]),
        )
    w = draw(weights)
    scale = 10 ** draw(st.floats(-6, 6))
    turn = draw(st.floats(0, 2 * math.pi))
    slope = draw(st.floats(0.02, math.pi - 0.02)) * draw(st.sampled_from([-1, 1]))
    length = 10 ** draw(st.floats(-2, 1))
    shift = draw(st.sampled_from([0.0, 0.0, 1.0, 1e3]))
    chord = (scale * math.cos(turn), scale * math.sin(turn))
    leg = (scale * length * math.cos(turn + slope), scale * length * math.sin(turn + slope))
    start = (shift * scale, -shift * scale)
    end = (start[0] + chord[0], start[1] + chord[1])
    middle = (w * start[0] + leg[0], w * start[1] + leg[1])
    return Piece(classify(w), (0.0, 1.0), start, end, middle, w, 0.0)
