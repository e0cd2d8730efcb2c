"""G-code, read back by an interpreter of our own and compared with the pieces and the curves."""

from __future__ import annotations

import math
import re
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.cas.errors import DomainError
from osculant.files.gcode import gcode
from osculant.files.motions import PROBES, best_centre
from osculant.pieces.biarcs import Biarc
from osculant.pieces.conics import Piece
from osculant.pieces.helices import HelixArc, SpacePiece
from tests.front.approximation.test_approximate import points_of
from tests.front.files.machine import interpret, mismatch, sweep, trace
from tests.front.samples import spline_of, written
from tests.oracles import hausdorff

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
ELLIPSE = ("2*cos(t), sin(t)", "0", "2*pi")
INFLECTED = ("t, t**3", "-1", "1")


def check_words(text, decimals):
    """Every number has the decimals told, radii agree to half a last unit, and no arc is a full turn."""
    assert f"decimals: {decimals}," in text
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
    """Without room for few decimals there are many."""
    spline = osc.approximate(osc.curve(*formula), "biarc", tolerance)
    room = tolerance - spline.error
    text = written(spline, gcode, command="osculant approximate (all) of “it”")
    decimals = math.ceil(-math.log10(room))
    start, moves = check_words(text, decimals)
    assert "(command: osculant approximate [all] of ?it?)" in text
    assert len(moves) == 2 * len(spline) and float(start["X"]) == pytest.approx(spline.pieces[0].start[0])
    arcs = [arc for piece in spline.pieces for arc in piece.arcs]
    for move, arc in zip(moves, arcs):
        assert move[0] != "G1"
        assert to_arc(trace(move, 33), arc).max() <= room
    knots = spline.knots
    away = hausdorff(
        points_of(spline.curve),
        as_pieces(moves),
        [t for a, b in pairwise(knots) for t in (a, (a + b) / 2)] + knots[-1:],
    )
    assert away <= tolerance


@pytest.mark.parametrize(
    ("tolerance", "units", "decimals"),
    [(1e-1, "mm", 3), (1e-2, "mm", 3), (1e-3, "mm", 4), (1e-2, "inch", 4), (1e-5, None, 6), (1.0, None, 3)],
)
def test_the_usual_decimals(tolerance, units, decimals, tmp_path):
    path = tmp_path / "a.nc"
    files = {path: {"units": units}}
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", tolerance, files=files)
    spline.write(path, units=units)
    check_words(path.read_text(), decimals)


@settings(max_examples=300, deadline=None)
@given(
    st.floats(0, math.tau),
    st.floats(0.01, 2 * math.pi - 0.3),
    st.sampled_from([-1, 1]),
    st.floats(-1, 5),
    st.floats(-5, 5),
)
def test_any_arc(angle, turning, sense, size, place):
    """Arcs of a tenth of a unit to many units; all of them stay within two units."""
    radius = 10**size / 1000
    first = complex(math.cos(angle), math.sin(angle)) * radius
    last = first * complex(math.cos(turning), sense * math.sin(turning))
    centre = complex(place, -place / 3)
    start, end = centre + first, centre + last
    ahead = first / abs(first) * 1j * sense
    arc = Piece.arc((0, 1), (start.real, start.imag), (end.real, end.imag), (ahead.real, ahead.imag))
    text = written(spline_of([arc]), gcode, decimals=3)
    if "X" not in text.split("G0 ")[1].split("\n", 1)[1]:
        assert abs(start - end) < 2e-3
        return
    path = np.concatenate([trace(move, 33) for move in check_words(text, 3)[1]])
    assert to_arc(path, arc).max() <= 2e-3
    gaps = np.abs((path[:, 0] + 1j * path[:, 1])[:, None] - (arc.sample(65) @ [1, 1j])[None, :])
    assert gaps.min(axis=0).max() <= 3e-3 + radius * 2 * turning / 33  # nothing of the arc is left out


@settings(max_examples=300, deadline=None)
@given(st.floats(0, math.tau), st.floats(5, 1e6), st.floats(0.3, math.pi / 2 - 0.01))
def test_arcs_have_a_centre(first, radius, turning):
    """Below π/3, up to the centre's own shift; what is meant lies near the circle, about as near as the ends.

    Over longer chords, such as an odd one along an axis, the two radii may differ too much everywhere.
    """
    angles = first + turning * PROBES
    meant = radius * (np.exp(1j * angles) - np.exp(1j * first))
    chord = round(meant[-1].real), round(meant[-1].imag)
    away = np.stack([meant.real, meant.imag], axis=-1)
    if min(radius * (1 - math.cos(turning / 2)), math.hypot(*chord)) < 3:
        return
    centre = best_centre(chord, away, turning)
    if math.sin(turning / 2) * radius < (radius - 1.2) / 2:
        assert centre is not None
    if centre is None:
        return
    begun, ended = math.hypot(*centre), math.dist(chord, centre)
    assert abs(begun - ended) < 0.5
    gaps = np.hypot(*(away - centre).T)
    assert max(np.abs(gaps - begun).max(), np.abs(gaps - ended).max()) < 1.3


def test_a_half_turn_over_an_odd_chord_is_cut():
    half = Piece.arc((0, 3), (0.0, 0.0), (-0.021, 0.0), (0.0, 1.0))
    moves = check_words(written(spline_of([half]), gcode, decimals=3), 3)[1]
    assert [move[0] for move in moves] == ["G3", "G3"]


def test_an_arc_of_one_unit_is_a_line():
    half = Piece.arc((0, 3), (0.0, 0.0), (-0.001, 0.0), (0.0, 1.0))
    (move,) = interpret(written(spline_of([half]), gcode, decimals=3))[1]
    assert move[0] == "G1"
    wider = Piece.arc((0, 3), (0.0, 0.0), (-0.004, 0.0), (0.0, 1.0))
    (move,) = check_words(written(spline_of([wider]), gcode, decimals=3), 3)[1]
    assert move[0] == "G3"


def test_far_centres_become_chords():
    """An arc of radius 1e7 and sagitta 1.25e-8: more than the room."""
    arc = Piece.arc((0, 1), (0.0, 0.0), (1.0, 0.0), (math.cos(5e-8), -math.sin(5e-8)))
    spline = spline_of([arc], tolerance=1e-3)
    lines = interpret(written(spline, gcode, room=2.5e-10))[1]
    assert {move[0] for move in lines} == {"G1"} and len(lines) < 20
    for x, y in np.concatenate([trace(move) for move in lines]):
        assert abs(y + x * (1 - x) / 2e7) <= 2.5e-10  # to 1e-20 a parabola
    moves = check_words(written(spline, gcode, room=2.5e-10, largest_radius=1e8), 10)[1]
    assert [move[0] for move in moves] == ["G3"]
    assert to_arc(trace(moves[0]), arc).max() <= 2.5e-10 + 2 * math.ulp(1e7)
    few = written(spline, gcode, largest_radius=1e8, decimals=4)
    assert [move[0] for move in interpret(few)[1]] == ["G1"]


def test_radii_and_angles_of_a_machine():
    arcs = [circle_arc(0.5, 0, 3.0), circle_arc(20.0, 3.0, 6.0), circle_arc(3.0, 6.0, 6.5)]
    ends = [(0.5, 0.0)]
    for arc in arcs:
        shift = complex(*ends[-1]) - complex(*arc.start)
        ends.append((arc.end[0] + shift.real, arc.end[1] + shift.imag))
    pieces = [
        Piece.arc((i, i + 1), ends[i], ends[i + 1], tuple(arc.tangent(0.0).tolist()))
        for i, arc in enumerate(arcs)
    ]
    spline = spline_of(pieces, tolerance=1e-2)
    letters = "".join(move[0][1] for move in interpret(written(spline, gcode))[1])
    assert letters == "333"
    small = interpret(written(spline, gcode, smallest_radius=1.0))[1]
    assert {move[0] for move in small[:-2]} == {"G1"} and [move[0] for move in small[-2:]] == ["G3", "G3"]
    path = np.concatenate([trace(move, 33) for move in small])
    assert to_arc(path[: 33 * (len(small) - 2)], pieces[0]).max() < 1e-2
    assert {move[0] for move in interpret(written(spline, gcode, largest_radius=0.1))[1]} == {"G1"}
    for degrees in (180, 90, 30):
        moves = check_words(written(spline, gcode, largest_angle=degrees), 3)[1]
        assert {move[0] for move in moves} == {"G3"}
        assert max(abs(sweep(move)[1]) for move in moves) < math.radians(degrees) * 1.01


def circle_arc(radius, a, b):
    start, end = ((radius * math.cos(t), radius * math.sin(t)) for t in (a, b))
    return Piece.arc((a, b), start, end, (-math.sin(a), math.cos(a)))


def test_segments_units_feed():
    pieces = [
        Piece.segment((0, 1), (0.0, 0.0), (1.0, 0.0)),
        Piece.arc((1, 2), (1.0, 0.0), (1.0, 2.0), (1.0, 0.0)),
        Biarc("arc", (2, 3), (1.0, 2.0), (0.5, 2.5), (0.0, 3.0), ((-1.0, 0.0), (0.0, 1.0)), (-2.0, 2.0), 0.0),
    ]
    spline = spline_of(pieces, tolerance=1e-2)
    text = written(spline, gcode, units="mm", feed=250)
    assert text.splitlines()[-7:] == [
        "G17 G90 G91.1 G94 G21",
        "G0 X0.000 Y0.000",
        "G1 X1.000 Y0.000 F250.0",
        "G3 X1.000 Y2.000 I0.000 J1.000",
        "G2 X0.500 Y2.500 I0.000 J0.500",
        "G3 X0.000 Y3.000 I-0.500 J0.000",
        "M2",
    ]
    assert " F600.0" in written(spline, gcode, units="mm") and " F24.0" in written(spline, gcode)
    assert "G20" in written(spline, gcode, units="inch") and "(units: those of" in written(spline, gcode)
    for wrong, says in (
        ({"feed": 0}, "feed rate is 0"),
        ({"decimals": 4.5}, r"decimals is 4\.5"),
        ({"decimals": -1}, "decimals is -1"),
        ({"units": "m"}, "'mm' or 'inch', not 'm'"),
        ({"dialect": "fanuc"}, "'fanuc' of G-code is unknown: choose linuxcnc, grbl or marlin"),
        ({"largest_angle": -1.0}, "largest angle is -1"),
        ({"smallest_radius": math.nan}, "smallest radius is nan"),
        ({"smallest_radius": 5.0, "largest_radius": 1.0}, "leaves no arcs"),
    ):
        with pytest.raises(DomainError, match=says):
            written(spline, gcode, **wrong)


def test_dialects():
    """Marlin reads one command a line, comments after a semicolon, and no M2; grbl's lines are short."""
    spline = osc.approximate(osc.curve(*SPIRAL), "biarc", 1e-2)
    marlin = written(spline, gcode, dialect="marlin", units="mm", room=1e-3).splitlines()
    assert marlin[-1] == "M400" and [line for line in marlin if line[0] == "G"][:2] == ["G90", "G21"]
    assert all(line.startswith((";", "G", "M400")) for line in marlin)
    assert written(spline, gcode, dialect="grbl", room=1e-3) == written(spline, gcode, room=1e-3)
    with pytest.raises(DomainError, match=r"lines of 79 characters .*: give fewer decimals"):
        written(spline, gcode, dialect="grbl", decimals=17)
    for dialect, limit in (("linuxcnc", 0.028), ("grbl", 0.005)):
        text = written(spline, gcode, dialect=dialect, decimals=1, units="mm")
        assert all(mismatch(move) < limit for move in interpret(text)[1] if move[0] != "G1")


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
    text = written(space_spline([arc]), gcode, decimals=11)
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
    assert np.abs(off - along * ahead).max() <= 2e-11
    assert np.abs(along).max() <= 1e-9


def test_the_sense_of_a_right_handed_screw():
    """Right-handed about +Z: anticlockwise and upwards, G3; left-handed downwards with the axis −Z: G2."""
    spline = osc.approximate(osc.curve("cos(t), sin(t), t", "0", "4*pi"), "bihelix", "1e-3")
    moves = check_words(written(spline, gcode, decimals=11), 11)[1]
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


def test_a_helix_that_hardly_leans_is_written_upright():
    nearly = helix(2, 1, 0.5, 0.3, 4.0, tilt=3e-12)
    assert {move[0] for move in interpret(written(space_spline([nearly]), gcode))[1]} == {"G3"}


def test_straight_lines_in_space():
    line = HelixArc((0.0, 0.0, 0.0), (0.6, 0.0, 0.8), (0.6, 0.0, 0.8), 0.0, 0.0, 5.0)
    assert written(space_spline([line]), gcode).splitlines()[-2] == "G1 X3.0000 Y0.0000 Z4.0000 F24.0"


def test_planes_change_as_needed():
    arcs = [helix(axis, 1, 0.5, 0.3, 4.0) for axis in (2, 1, 1, 0)]
    chain = [arcs[0]]
    for arc in arcs[1:]:
        chain.append(HelixArc(chain[-1].end, arc.direction, arc.axis, arc.curvature, arc.torsion, arc.length))
    words = re.findall(r"^G1[789]", written(space_spline(chain), gcode), re.MULTILINE)
    assert words == ["G17", "G18", "G19"]
    first = written(space_spline([helix(1, 1, 0.5, 0.3, 4.0)]), gcode, feed=1e-5).splitlines()[-4:-1]
    assert first[1] == "G18" and first[2].startswith("G3 ") and first[2].endswith(" F0.00001")
