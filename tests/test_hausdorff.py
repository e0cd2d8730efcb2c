"""The independent distance against distances that are known, and curves with what samples miss."""

import math

import numpy as np
import pytest

from tests.hausdorff import Formula, GaveUpError, distance, piece_points

ANGLE = 1.2


def segment(start, end, interval=(0.0, 1.0)):
    """A segment as a spline's JSON has it."""
    points = [list(start), [(x + y) / 2 for x, y in zip(start, end)], list(end)]
    return {
        "kind": "segment",
        "interval": list(interval),
        "points": points,
        "middle": points[1],
        "weight": 1.0,
    }


def arc_of_circle(radius, interval):
    """An arc about the origin as a biarc."""
    a, b = interval
    at = [[radius * math.cos(t), radius * math.sin(t)] for t in (a, (a + b) / 2, b)]
    tangents = [[-math.sin(t), math.cos(t)] for t in (a, (a + b) / 2)]
    return {"kind": "arc", "interval": [a, b], "points": at, "tangents": tangents}


def helix(radius, interval):
    """Two arcs of a helix about the third axis that rises by half the angle, one after the other."""
    a, b = interval
    curvature, torsion = radius / (radius**2 + 0.25), 0.5 / (radius**2 + 0.25)
    arcs = []
    for low, high in ((a, (a + b) / 3), ((a + b) / 3, b)):
        tangent = np.array([-radius * math.sin(low), radius * math.cos(low), 0.5]) / math.hypot(radius, 0.5)
        arcs.append(
            {
                "start": [radius * math.cos(low), radius * math.sin(low), low / 2],
                "tangent": tangent.tolist(),
                "axis": [0.0, 0.0, 1.0],
                "curvature": curvature,
                "torsion": torsion,
                "length": (high - low) * math.hypot(radius, 0.5),
            }
        )
    return {"kind": "bihelix", "interval": [a, b], "arcs": arcs}


def found(text, piece, accuracy=1e-9):
    """The distance of a piece and its arc of the curve."""
    a, b = piece["interval"]
    formula = Formula(text, str(a), str(b))
    return distance(formula, piece, formula.parts(a, b, accuracy), density=8)


def test_a_circle_and_its_chord():
    piece = segment((1.0, 0.0), (math.cos(ANGLE), math.sin(ANGLE)), (0.0, ANGLE))
    assert found("cos(t), sin(t)", piece) == pytest.approx(1 - math.cos(ANGLE / 2), rel=1e-9)


@pytest.mark.parametrize("radius", [1.01, 0.9999, 1 + 1e-7])
def test_arcs_of_circles(radius):
    piece = arc_of_circle(radius, (0.3, 3.0))
    assert found("cos(t), sin(t)", piece) == pytest.approx(abs(radius - 1), rel=1e-6, abs=1e-11)


def test_helices():
    assert found("cos(t), sin(t), t/2", helix(1.001, (0.0, 5.0))) == pytest.approx(1e-3, rel=1e-7)


def test_a_parabola_as_a_conic():
    # b₀P₀ + b₁M + b₂P₂ with w = 1 on (t, t²) from 0 to 1, and the same moved up
    exact = {"kind": "parabola", "interval": [0.0, 1.0], "points": [[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]}
    exact |= {"middle": [0.5, 0.0], "weight": 1.0}
    assert found("t, t^2", exact) < 1e-12
    moved = {**exact, "points": [[0.0, 0.01], [0.5, 0.01], [1.0, 1.01]], "middle": [0.5, 0.01]}
    # nowhere farther than the move, and the starts lie across one another
    assert found("t, t^2", moved) == pytest.approx(0.01, rel=1e-9)


def test_an_ellipse_as_a_conic_that_turns_by_more_than_half():
    piece = {"kind": "ellipse", "interval": [0.0, 4.0], "weight": math.cos(2.0)}
    start, end = [1.0, 0.0], [math.cos(4.0), math.sin(4.0)]
    # of a circle the middle weight is cos(turning/2), and M = (cos 2, sin 2)
    piece |= {"points": [start, None, end], "middle": [math.cos(2.0), math.sin(2.0)]}
    assert np.abs(np.linalg.norm(piece_points(piece, np.linspace(0, 1, 9)), axis=1) - 1).max() < 1e-15
    assert found("cos(t), sin(t)", piece) < 1e-10
    assert found("1.003*cos(t), 1.003*sin(t)", piece) == pytest.approx(0.003, rel=1e-6)


@pytest.mark.parametrize("width", [1e-2, 1e-6, 1e-9])
def test_a_bump_however_narrow(width):
    text = f"t, 0.001*exp(-((t-0.37)/{width:.12f})^2)"
    assert found(text, segment((0.0, 0.0), (1.0, 0.0))) == pytest.approx(1e-3, rel=1e-6)


def test_both_sides_count():
    assert found("t, 0*t", segment((0.0, 0.0), (1.5, 0.0))) == pytest.approx(0.5, rel=1e-9)
    assert found("1.5*t, 0*t", segment((0.0, 0.0), (1.0, 0.0))) == pytest.approx(0.5, rel=1e-9)


def test_feet_that_jump_from_one_side_to_the_other():
    # of the middle of its diameter every point of a half circle is nearest
    half = segment((1.0, 0.0), (-1.0, 0.0), (0.0, math.pi))
    assert found("cos(t), sin(t)", half) == pytest.approx(1.0, rel=1e-6)
    # the hairpin's segment lies between its legs
    hairpin = segment((0.0, 0.05), (1.0, 0.05))
    assert found("1 - (2*t-1)^2, 0.1*t", hairpin) == pytest.approx(0.05, rel=1e-6)


def test_uneven_parametrisations():
    piece = segment((0.0, 0.0), (1.0, 0.0))
    plain = found("t, t*(1-t)", piece)
    assert plain == pytest.approx(0.25, rel=1e-9)
    for power in (5, 9, 25):
        assert found(f"t^{power}, t^{power}*(1-t^{power})", piece) == pytest.approx(plain, rel=1e-6)


def test_it_gives_up_on_what_takes_too_many_parts():
    with pytest.raises(GaveUpError):
        Formula("t, sin(10^7*t)", "0", "1").parts(0.0, 1.0, 1e-9)
