"""G-code, read back by an interpreter of our own and compared with the pieces and the curves."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

import osculant as osc
from osculant.cas.errors import DomainError, ToleranceError
from osculant.files.gcode import gcode
from osculant.files.motions import rounded_centre
from osculant.pieces.biarcs import Biarc
from osculant.pieces.conics import Piece
from osculant.pieces.helices import HelixArc, SpacePiece
from osculant.tolerances import writing_share
from tests.front.approximation.test_approximate import points_of
from tests.front.samples import spline_of, written
from tests.oracles import hausdorff

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
ELLIPSE = ("2*cos(t), sin(t)", "0", "2*pi")
INFLECTED = ("t, t**3", "-1", "1")
PLANES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}  # the last one is seen from its + side


# --- an interpreter ---


def interpret(text):
    """Return the start and the moves: (letter, {start}, {end}, {centre}, plane), numbers as fractions."""
    here, start, plane, moves = {}, None, "G17", []
    for line in text.splitlines():
        assert line.isascii() and len(line) <= 120
        if line.startswith("("):
            assert line.count("(") == line.count(")") == 1 and line.endswith(")")
            continue
        words = re.fullmatch(r"(?:[A-Z]-?\d+(?:\.\d+)? ?)+", line + " ")
        assert words, line
        words = line.split()
        for word in words:
            plane = word if word in PLANES else plane
        numbers = {word[0]: Fraction(word[1:]) for word in words if word[0] in "XYZIJK"}
        there = {**here, **{axis: numbers[axis] for axis in "XYZ" if axis in numbers}}
        if words[0] == "G0":
            assert start is None
            start = there
        elif words[0] in ("G1", "G2", "G3"):
            offsets = dict(zip("XYZ", "IJK"))
            centre = {axis: here[axis] + numbers[o] for axis, o in offsets.items() if o in numbers}
            assert len(centre) == (0 if words[0] == "G1" else 2)
            moves.append((words[0], here, there, centre, PLANES[plane]))
        here = there
    assert text.endswith("\nM2\n") and "G90" in text.split("G0 ")[0]
    return start, moves


def mismatch(move):
    """The difference of the two radii of an arc as printed, at 50 digits."""
    _, start, end, centre, _ = move
    with mp.workdps(50):
        radii = [
            mp.sqrt(sum(mp.mpf(d.numerator) ** 2 / mp.mpf(d.denominator) ** 2 for d in away))
            for away in ([p[axis] - centre[axis] for axis in centre] for p in (start, end))
        ]
        return abs(radii[0] - radii[1])


def sweep(move):
    """Angle at the start and signed angle turned by, by the sense of the word alone."""
    letter, start, end, centre, (a, b, _) = move
    angles = [math.atan2(float(p[b] - centre[b]), float(p[a] - centre[a])) for p in (start, end)]
    turned = (angles[1] - angles[0]) % math.tau
    return angles[0], turned if letter == "G3" else turned - math.tau


def trace(move, n=9):
    """Points of a move, the radius and the third coordinate growing evenly; shape (n, 2 or 3)."""
    letter, start, end, centre, plane = move
    axes = sorted(start)
    f = np.linspace(0, 1, n)
    points = {axis: float(start[axis]) + f * float(end[axis] - start[axis]) for axis in axes}
    if letter != "G1":
        a, b, _ = plane
        first, turned = sweep(move)
        radii = [math.hypot(*(float(p[axis] - centre[axis]) for axis in (a, b))) for p in (start, end)]
        radius, angle = radii[0] + f * (radii[1] - radii[0]), first + f * turned
        points[a], points[b] = (
            float(centre[a]) + radius * np.cos(angle),
            float(centre[b]) + radius * np.sin(angle),
        )
    return np.stack([points[axis] for axis in axes], axis=-1)


def check_words(text, decimals):
    """Every number has the decimals told, radii agree to half a last unit, and no arc is a full turn."""
    assert f"(decimals: {decimals};" in text
    assert {len(d) for d in re.findall(r"[XYZIJK]-?\d+\.(\d+)", text)} == {decimals}
    start, moves = interpret(text)
    for move in moves:
        assert move[1] != move[2]
        if move[0] != "G1":
            assert mismatch(move) * 10**decimals < 0.5
            radius = math.hypot(*(float(move[1][axis] - move[3][axis]) for axis in move[3]))
            assert abs(sweep(move)[1]) < 3.2 + 5 * 10.0**-decimals / radius  # of few units: rounded ends
    return start, moves


def to_arc(point, arc):
    """Distance of points to a circular arc or segment, from its centre."""
    (ax, ay), _, (cx, cy) = arc.legs
    half = math.atan2(ax * cy - ay * cx, ax * cx + ay * cy)
    start, chord = complex(*arc.start), complex(cx, cy)
    z = point[:, 0] + 1j * point[:, 1]
    ends = np.minimum(abs(z - start), abs(z - complex(*arc.end)))
    if arc.kind == "segment" or half == 0:
        along = np.clip(((z - start) / chord).real, 0, 1)
        return abs(z - start - along * chord)
    centre = start + chord * complex(1, 1 / math.tan(half)) / 2
    radius = abs(chord / (2 * math.sin(half)))
    angle = np.angle((z - centre) / (start - centre)) * math.copysign(1, half) % math.tau
    return np.where(angle <= 2 * abs(half), np.minimum(ends, abs(abs(z - centre) - radius)), ends)


def as_pieces(moves):
    """The read-back moves as pieces, for the distance oracle."""
    found = []
    for i, move in enumerate(moves):
        start, end = (tuple(float(p[axis]) for axis in "XY") for p in move[1:3])
        if move[0] == "G1":
            found.append(Piece.segment((i, i + 1), start, end))
            continue
        first, turned = sweep(move)
        direction = math.copysign(1, turned)
        chord, ahead = (
            complex(*end) - complex(*start),
            complex(math.cos(first), math.sin(first)) * 1j * direction,
        )
        assert math.cos(turned / 2) * abs(chord) == pytest.approx((ahead.conjugate() * chord).real, abs=1e-3)
        found.append(Piece.arc((i, i + 1), start, end, (ahead.real, ahead.imag)))
    return found


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4])
@pytest.mark.parametrize("formula", [SPIRAL, ELLIPSE, INFLECTED])
def test_read_back_within_the_tolerance(formula, tolerance):
    spline = osc.approximate(osc.curve(*formula), "biarc", tolerance)
    largest = float(np.abs(spline.bounding_box()).max())
    reserve = writing_share(tolerance, math.ulp(largest))
    text = written(spline, gcode, command="osculant approximate (all) of “it”")
    decimals = math.ceil(math.log10(8 / reserve))
    start, moves = check_words(text, decimals)
    assert "(command: osculant approximate [all] of ?it?)" in text
    assert len(moves) == 2 * len(spline) and float(start["X"]) == pytest.approx(spline.pieces[0].start[0])
    arcs = [arc for piece in spline.pieces for arc in piece.arcs]
    for move, arc in zip(moves, arcs):
        assert move[0] != "G1"
        assert to_arc(trace(move, 33), arc).max() <= reserve
    knots = spline.knots
    away = hausdorff(
        points_of(spline.curve),
        as_pieces(moves),
        [t for a, b in pairwise(knots) for t in (a, (a + b) / 2)] + knots[-1:],
    )
    assert away <= tolerance


@pytest.mark.parametrize("decimals", [3, 4, 5])
def test_few_decimals_need_a_stated_reserve(decimals):
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-2)
    with pytest.raises(
        ToleranceError, match=rf"Rounding to {decimals} decimals .*give 10 decimals, or a reserve of "
    ):
        written(spline, gcode, decimals=decimals)
    reserve = 8 * 10.0**-decimals
    text = written(spline, gcode, decimals=decimals, reserve=reserve)
    assert f"of writing at most {reserve!r} more)" in text
    moves = check_words(text, decimals)[1]
    for move, arc in zip(moves, [arc for piece in spline.pieces for arc in piece.arcs]):
        assert to_arc(trace(move, 33), arc).max() <= reserve / 2


def test_a_reserve_alone_has_four_decimals_at_least():
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-2)
    assert "(decimals: 4;" in written(spline, gcode, reserve=0.5)
    assert "(decimals: 5;" in written(spline, gcode, reserve=1e-4)
    with pytest.raises(ToleranceError, match="cannot be written to within 1e-17"):
        written(spline, gcode, reserve=1e-17)
    with pytest.raises(ToleranceError, match="cannot be written to within nan"):
        written(spline, gcode, reserve=math.nan)


@settings(max_examples=300, deadline=None)
@given(
    st.floats(0, math.tau),
    st.floats(0.01, 2 * math.pi - 0.3),
    st.sampled_from([-1, 1]),
    st.floats(-1, 5),
    st.floats(-5, 5),
)
def test_any_arc(angle, turning, sense, size, place):
    """Arcs of a tenth of a unit to many units; all of them stay within four units."""
    radius = 10**size / 1000
    first = complex(math.cos(angle), math.sin(angle)) * radius
    last = first * complex(math.cos(turning), sense * math.sin(turning))
    centre = complex(place, -place / 3)
    start, end = centre + first, centre + last
    ahead = first / abs(first) * 1j * sense
    arc = Piece.arc((0, 1), (start.real, start.imag), (end.real, end.imag), (ahead.real, ahead.imag))
    text = written(spline_of([arc]), gcode, decimals=3, reserve=8e-3)
    if "X" not in text.split("G0 ")[1].split("\n", 1)[1]:
        assert abs(start - end) < 2e-3
        return
    path = np.concatenate([trace(move, 33) for move in check_words(text, 3)[1]])
    assert to_arc(path, arc).max() <= 4e-3
    gaps = np.abs((path[:, 0] + 1j * path[:, 1])[:, None] - (arc.sample(65) @ [1, 1j])[None, :])
    assert gaps.min(axis=0).max() <= 5e-3 + radius * 2 * turning / 33  # nothing of the arc is left out


@settings(max_examples=300, deadline=None)
@given(st.integers(-60, 60), st.integers(4, 60), st.floats(0.01, math.pi / 3 - 0.01))
def test_shallow_arcs_have_a_centre(x, y, turning):
    """The bound of the docstring: a rounding exists below π/3, up to the centre's own shift."""
    chord = math.hypot(x, y)
    centre = rounded_centre((x, y), turning)
    radius = chord / (2 * math.sin(turning / 2))
    if math.sin(turning / 2) * radius < (radius - 1.2) / 2:
        assert centre is not None
    if centre is not None:
        assert abs(math.hypot(*centre) - math.hypot(x - centre[0], y - centre[1])) < 0.5


def test_a_half_turn_over_an_odd_chord_is_cut():
    half = Piece.arc((0, 3), (0.0, 0.0), (-0.021, 0.0), (0.0, 1.0))
    moves = check_words(written(spline_of([half]), gcode, decimals=3, reserve=8e-3), 3)[1]
    assert [move[0] for move in moves] == ["G3", "G3"]


def test_an_arc_of_three_units_is_a_line():
    half = Piece.arc((0, 3), (0.0, 0.0), (-0.003, 0.0), (0.0, 1.0))
    (move,) = interpret(written(spline_of([half]), gcode, decimals=3, reserve=8e-3))[1]
    assert move[0] == "G1"
    wider = Piece.arc((0, 3), (0.0, 0.0), (-0.004, 0.0), (0.0, 1.0))
    (move,) = check_words(written(spline_of([wider]), gcode, decimals=3, reserve=8e-3), 3)[1]
    assert move[0] == "G3"


def test_far_centres_become_chords():
    """An arc of radius 1e7 and sagitta 1.25e-8: more than the reserve."""
    arc = Piece.arc((0, 1), (0.0, 0.0), (1.0, 0.0), (math.cos(5e-8), -math.sin(5e-8)))
    spline = spline_of([arc], tolerance=1e-3)
    lines = interpret(written(spline, gcode))[1]
    assert {move[0] for move in lines} == {"G1"}
    assert len(lines) == math.ceil(math.sqrt(1e-7 / (8 * 2.5e-10 / 4))) == 15
    for x, y in np.concatenate([trace(move) for move in lines]):
        assert abs(y + x * (1 - x) / 2e7) <= 2.5e-10  # to 1e-20 a parabola
    moves = check_words(written(spline, gcode, straight_radius=1e8), 11)[1]
    assert [move[0] for move in moves] == ["G3"]
    x, y = moves[0][3]["X"], moves[0][3]["Y"]
    assert abs(x - 0.5) <= 2e-11 and float(y) == pytest.approx(1e7, rel=1e-9)
    assert [move[0] for move in interpret(written(spline, gcode, straight_radius=1e8, reserve=1e-3))[1]] == [
        "G1"
    ]


def test_segments_units_feed():
    pieces = [
        Piece.segment((0, 1), (0.0, 0.0), (1.0, 0.0)),
        Piece.arc((1, 2), (1.0, 0.0), (1.0, 2.0), (1.0, 0.0)),
        Biarc("arc", (2, 3), (1.0, 2.0), (0.5, 2.5), (0.0, 3.0), ((-1.0, 0.0), (0.0, 1.0)), (-2.0, 2.0), 0.0),
    ]
    text = written(spline_of(pieces), gcode, units="mm", feed=250, reserve=1e-3)
    assert text.splitlines()[-7:] == [
        "G17 G90 G21",
        "G0 X0.0000 Y0.0000",
        "G1 X1.0000 Y0.0000 F250.0",
        "G3 X1.0000 Y2.0000 I0.0000 J1.0000",
        "G2 X0.5000 Y2.5000 I0.0000 J0.5000",
        "G3 X0.0000 Y3.0000 I-0.5000 J0.0000",
        "M2",
    ]
    assert "G20" in written(spline_of(pieces), gcode, units="inch") and "(units: those of" in written(
        spline_of(pieces), gcode
    )
    with pytest.raises(DomainError, match="feed rate is 0"):
        written(spline_of(pieces), gcode, feed=0)
    with pytest.raises(DomainError, match=r"decimals is 4\.5"):
        written(spline_of(pieces), gcode, decimals=4.5)
    with pytest.raises(DomainError, match="'mm' or 'inch', not 'm'"):
        written(spline_of(pieces), gcode, units="m")


def test_conics_are_refused():
    with pytest.raises(DomainError, match="is of kind 'parabola': approximate with biarcs"):
        written(spline_of([Piece("parabola", (0, 1), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0), 1.0, 0.0)]), gcode)


# --- space ---


def helix(axis, sense, curvature, torsion, length, tilt=0.0):
    """A helical arc about a coordinate axis, or one tilted from it, by its Darboux vector."""
    rate = math.hypot(curvature, torsion)
    # in a frame with the Darboux vector along its last vector: T = (0, κ/β, τ/β)
    frame = np.roll(np.eye(3), axis + 1, axis=1)  # rows: the two axes of the plane, and the axis
    if sense < 0:
        frame = np.array([frame[1], frame[0], -frame[2]])
    c, s = math.cos(tilt), math.sin(tilt)
    frame = (
        frame @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]) @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    )
    tangent = np.array([0, curvature, torsion]) / rate @ frame
    start = np.array([0.7, -0.3, 0.2])
    return HelixArc(tuple(start), tuple(tangent), tuple(frame[2]), curvature, torsion, length)


def space_spline(arcs, tolerance=1e-3):
    pieces = tuple(SpacePiece((i, i + 1), (arc,), 0.0) for i, arc in enumerate(arcs))
    return spline_of(pieces, text="x(t), y(t), z(t)", primitive="bihelix", tolerance=tolerance)


@settings(max_examples=100, deadline=None)
@given(
    st.sampled_from([0, 1, 2]),
    st.sampled_from([-1, 1]),
    st.floats(0.1, 3),
    st.one_of(st.just(0.0), st.floats(-3, 3)),
    st.floats(0.1, 6.2),
)
def test_helices_about_coordinate_axes(axis, sense, curvature, torsion, turning):
    arc = helix(axis, sense, curvature, torsion, turning / math.hypot(curvature, torsion))
    text = written(space_spline([arc]), gcode)
    moves = check_words(text, 11)[1]
    assert {move[0] for move in moves} == {"G3" if sense > 0 else "G2"}
    assert {move[4] for move in moves} == {("YZX", "ZXY", "XYZ")[axis]}
    assert "chords" not in text
    path = np.concatenate([trace(move) for move in moves])
    turned = np.cumsum([0.0, *(abs(sweep(move)[1]) for move in moves)])
    share = np.concatenate([np.linspace(a, b, 9) for a, b in pairwise(turned / turned[-1])])
    off = path - arc.point(share)
    ahead = arc.tangent(share)
    along = (off * ahead).sum(axis=1, keepdims=True)  # on a thin helix the angle is known less well
    assert np.abs(off - along * ahead).max() <= 2.5e-10
    assert np.abs(along).max() <= 1e-9


def test_the_sense_of_a_right_handed_screw():
    """Right-handed about +Z: anticlockwise and upwards, G3; left-handed downwards with the axis −Z: G2."""
    spline = osc.approximate(osc.curve("cos(t), sin(t), t", "0", "4*pi"), "bihelix", "1e-3")
    moves = check_words(written(spline, gcode), 11)[1]
    assert {move[0] for move in moves} == {"G3"} and all(move[2]["Z"] > move[1]["Z"] for move in moves)
    ends = [trace(move)[[0, -1]] for move in moves]
    assert np.allclose(ends[-1][1], [1, 0, 4 * math.pi], atol=1e-9)
    for move in moves:
        path = trace(move)
        assert np.allclose(
            path[:, :2], np.stack([np.cos(path[:, 2]), np.sin(path[:, 2])], axis=-1), atol=1e-9
        )
    mirror = osc.approximate(osc.curve("cos(t), -sin(t), t", "0", "4*pi"), "bihelix", "1e-3")
    assert {move[0] for move in interpret(written(mirror, gcode))[1]} == {"G2"}


def test_other_helices_are_chords_with_their_own_error():
    arcs = [helix(2, 1, 0.5, 0.3, 4.0, tilt=0.4), helix(2, 1, 0.5, 0.3, 4.0, tilt=1e-4)]
    for arc in arcs:
        for kept in (1e-3, 1e-5):
            text = written(space_spline([arc]), gcode, chord_tolerance=kept)
            moves = interpret(text)[1]
            n = math.ceil(4.0 * math.sqrt(0.5 / (8 * kept)))
            assert [move[0] for move in moves] == ["G1"] * n
            assert f"(chords: 1 helical arcs, at most {kept!r} more)" in text
            path = np.concatenate([trace(move, 17) for move in moves])
            share = np.concatenate([(k + np.linspace(0, 1, 17)) / n for k in range(n)])
            worst = np.linalg.norm(path - arc.point(share), axis=1).max()
            assert 0.95 * kept < worst <= kept
    nearly = helix(2, 1, 0.5, 0.3, 4.0, tilt=3e-12)
    assert {move[0] for move in interpret(written(space_spline([nearly]), gcode))[1]} == {"G3"}


def test_straight_lines_in_space():
    line = HelixArc((0.0, 0.0, 0.0), (0.6, 0.0, 0.8), (0.6, 0.0, 0.8), 0.0, 0.0, 5.0)
    assert written(space_spline([line]), gcode, reserve=1e-3).splitlines()[-2] == "G1 X3.0000 Y0.0000 Z4.0000"


def test_planes_change_as_needed():
    arcs = [helix(axis, 1, 0.5, 0.3, 4.0) for axis in (2, 1, 1, 0)]
    chain = [arcs[0]]
    for arc in arcs[1:]:
        chain.append(HelixArc(chain[-1].end, arc.direction, arc.axis, arc.curvature, arc.torsion, arc.length))
    words = re.findall(r"^G1[789]", written(space_spline(chain), gcode), re.MULTILINE)
    assert words == ["G17", "G18", "G19"]
    first = written(space_spline([helix(1, 1, 0.5, 0.3, 4.0)]), gcode, feed=1e-5).splitlines()[-4:-1]
    assert first[1] == "G18" and first[2].startswith("G3 ") and first[2].endswith(" F0.00001")
