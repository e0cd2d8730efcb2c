"""SVG files: read back independently, in 50-digit arithmetic, and compared with the exact pieces."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mpf

from osculant.cas.errors import ToleranceError
from osculant.files.svg import path_data, svg
from osculant.pieces.beziers import cubic_bound, cubics, ellipse, parabola_bound
from osculant.pieces.conics import Piece, classify
from osculant.pieces.piece import largest_of
from osculant.tolerances import writing_share
from tests.front.samples import circle, pieces, spline_of, written

SVG = "{http://www.w3.org/2000/svg}"
STEPS = [mpf(i) / 10 for i in range(11)]


# --- an SVG reader of our own: https://www.w3.org/TR/SVG11/implnote.html#ArcImplementationNotes ---


def read_path(data):
    """Return (letter, start, numbers, end) of each command after the first, as nearest doubles."""
    commands = re.findall(r"([A-Za-z])([^A-Za-df-z]*)", data)
    assert commands[0][0] == "M"
    result, here = [], None
    for letter, arguments in commands:
        numbers = [float(x) for x in arguments.split()]
        assert len(numbers) == {"M": 2, "L": 2, "Q": 4, "C": 6, "A": 7}[letter]
        end = numbers[-2:]
        if here is not None:
            result.append((letter, here, numbers[:-2], end))
        here = end
    return result


def trace(command):
    """Return points of a path command at equal parameters, in mpmath's precision."""
    letter, start, numbers, end = command
    if letter == "A":
        return trace_arc(start, *numbers, end)
    points = [start, *zip(numbers[::2], numbers[1::2]), end]
    n = len(points) - 1
    result = []
    for t in STEPS:
        b = [mpmath.binomial(n, k) * (1 - t) ** (n - k) * t**k for k in range(n + 1)]
        result.append(tuple(sum(x * mpf(p[i]) for x, p in zip(b, points)) for i in (0, 1)))
    return result


def trace_arc(start, rx, ry, degrees, large, sweep, end):
    """Convert end-point to centre parametrisation (F.6.5) and return points of the arc."""
    rx, ry, phi = mpf(rx), mpf(ry), mpf(degrees) * mpmath.pi / 180
    (x1, y1), (x2, y2) = (tuple(map(mpf, p)) for p in (start, end))
    cos, sin = mpmath.cos(phi), mpmath.sin(phi)
    dx, dy = (x1 - x2) / 2, (y1 - y2) / 2
    x, y = cos * dx + sin * dy, -sin * dx + cos * dy
    scale = x**2 / rx**2 + y**2 / ry**2
    assert scale < 1, "the arc's radii are too small for its ends"
    factor = mpmath.sqrt(1 / scale - 1) * (-1 if large == sweep else 1)
    cx, cy = factor * rx * y / ry, -factor * ry * x / rx
    theta1 = mpmath.atan2((y - cy) / ry, (x - cx) / rx)
    theta2 = mpmath.atan2((-y - cy) / ry, (-x - cx) / rx)
    delta = theta2 - theta1
    if sweep and delta < 0:
        delta += 2 * mpmath.pi
    if not sweep and delta > 0:
        delta -= 2 * mpmath.pi
    mx, my = (x1 + x2) / 2, (y1 + y2) / 2
    result = []
    for t in STEPS:
        ex, ey = rx * mpmath.cos(theta1 + t * delta), ry * mpmath.sin(theta1 + t * delta)
        result.append((cos * (ex + cx) - sin * (ey + cy) + mx, sin * (ex + cx) + cos * (ey + cy) + my))
    return result


# --- the exact piece ---


STARTS = 6  # of the search for the nearest point


class Exact:
    """A piece in exact enough arithmetic."""

    def __init__(self, piece):
        w = mpf(piece.weight)
        self.w, self.graded = w, graded(piece.weight, 1001)
        self.samples = piece.point(self.graded)
        self.p0, self.m, self.p2 = (tuple(map(mpf, p)) for p in (piece.start, piece.middle, piece.end))
        self.a, self.b, self.c = (
            tuple(second - first for first, second in zip(p, q))
            for p, q in (
                ([w * x for x in self.p0], self.m),
                (self.m, [w * x for x in self.p2]),
                (self.p0, self.p2),
            )
        )

    def point(self, u):
        b0, b1, b2 = (1 - u) ** 2, 2 * u * (1 - u), u**2
        w = b0 + self.w * b1 + b2
        return tuple((b0 * p + b1 * m + b2 * q) / w for p, m, q in zip(self.p0, self.m, self.p2))

    def distance(self, point, allowed):
        """Return the distance of a point to the arc, or a greater number if that is within what is allowed.

        The starts are the nearest sample and then the nearest of those apart from the starts before: on a
        slim ellipse the nearest one may be on the other side, and its own side has other minima too.
        """
        gaps = np.hypot(*(self.samples - np.array(point, dtype=float)).T)
        best = self.distance_towards_centre(point)
        for _ in range(STARTS):
            nearest = int(gaps.argmin())
            best = min(best, self.distance_from(point, nearest))
            if best <= allowed:
                break
            gaps[max(nearest - 15, 0) : nearest + 16] = np.inf
        return best

    def distance_towards_centre(self, point):
        """Return the distance to the point of the ellipse's arc that lies towards its centre, or inf."""
        if not -1 < self.w < 1:
            return mpmath.inf
        square = (1 - self.w) * (1 + self.w)
        mean = [(x + y) / 2 for x, y in zip(self.p0, self.p2)]
        p = [(m - self.w * x) / square for m, x in zip(self.m, mean)]
        q = [c / (2 * mpmath.sqrt(square)) for c in self.c]
        gap = minus(point, [x - self.w * y for x, y in zip(mean, p)])
        area = p[0] * q[1] - p[1] * q[0]
        if area == 0:
            return mpmath.inf
        along, across = (gap[0] * q[1] - gap[1] * q[0]) / area, (p[0] * gap[1] - p[1] * gap[0]) / area
        if abs(mpmath.atan2(across, along)) > mpmath.acos(self.w):
            return mpmath.inf
        return abs(1 - 1 / mpmath.hypot(along, across)) * norm(gap)

    def distance_from(self, point, i):
        """Return the distance to the arc near its i-th sample: by Gauss–Newton, else by golden section."""
        u, best, settled = mpf(self.graded[i]), mpmath.inf, False
        for _ in range(6):
            gap = minus(point, self.point(u))
            w = (1 - u) ** 2 + self.w * 2 * u * (1 - u) + u**2
            legs = zip(self.a, self.b, self.c)
            speed = [2 * ((1 - u) ** 2 * a + u * (1 - u) * c + u**2 * b) / w**2 for a, b, c in legs]
            best = min(best, norm(gap))
            next_u = u + (gap[0] * speed[0] + gap[1] * speed[1]) / (speed[0] ** 2 + speed[1] ** 2)
            next_u = min(max(next_u, mpf(0)), mpf(1))
            settled = abs(next_u - u) * norm(speed) <= 1e-5 * best
            u = next_u
        return best if settled else min(best, self.by_golden_section(point, i))

    def by_golden_section(self, point, i):
        """Return the same for points farther away than the radius of curvature."""
        low, high = mpf(self.graded[max(i - 2, 0)]), mpf(self.graded[min(i + 2, len(self.graded) - 1)])
        ratio = (mpmath.sqrt(5) - 1) / 2
        best = mpmath.inf
        for _ in range(40):
            left, right = high - ratio * (high - low), low + ratio * (high - low)
            at_left, at_right = (norm(minus(point, self.point(u))) for u in (left, right))
            low, high = (low, right) if at_left < at_right else (left, high)
            best = min(best, at_left, at_right)
        return best


def graded(w, n):
    """Return n parameters u from 0 to 1 at equal steps of the eccentric or hyperbolic angle."""
    t = np.linspace(0, 1, n)
    if abs(w - 1) < 1e-9:
        return t
    wave, angle = (np.sin, np.arccos(w)) if w < 1 else (np.sinh, np.arccosh(w))
    before, after = wave(angle * t), wave(angle * (1 - t))
    return before / (before + after)


def minus(p, q):
    return mpf(p[0]) - q[0], mpf(p[1]) - q[1]


def norm(v):
    return mpmath.hypot(*v)


def deviation(piece, commands, allowed=0.0):
    """Return the largest distance of the commands' curve from a piece, after checking that it covers it.

    What is within the distance allowed may be taken for greater than it is.
    """
    with mpmath.workdps(50):
        exact = Exact(piece)
        traced = [trace(command) for command in commands]
        ends = norm(minus(traced[0][0], exact.p0)), norm(minus(traced[-1][-1], exact.p2))
        points = [point for part in traced for point in part]
        distance = float(max(*ends, *(exact.distance(point, allowed) for point in points)))
    points = np.array(points, dtype=float)
    spacing = np.hypot(*np.diff(points, axis=0).T).max()
    gaps = exact.samples[::25, None] - points[None]
    assert np.hypot(gaps[..., 0], gaps[..., 1]).min(axis=1).max() <= 2 * (spacing + distance)
    return distance


def size_of(piece):
    (left, bottom), (right, top) = piece.bounding_box()
    return max(right - left, top - bottom)


def largest_coordinate(piece):
    return largest_of([piece.bounding_box()])


# --- conversions ---


@given(pieces(st.floats(0.02, 2.99)))
@settings(max_examples=50, deadline=None)
def test_the_cubic_bound_holds_and_is_not_lavish(piece):
    assume(abs(piece.weight - 1) > 1e-3)
    a, w = piece.legs[0], piece.weight
    p1 = [p + v / w for p, v in zip(piece.start, a)]
    ratio = 4 * w / (3 * (1 + w))
    c1 = [p + ratio * (q - p) for p, q in zip(piece.start, p1)]
    c2 = [p + ratio * (q - p) for p, q in zip(piece.end, p1)]
    height = math.hypot(*piece.bulge) / w
    measured = deviation(piece, [("C", piece.start, [*c1, *c2], piece.end)])
    assert measured <= cubic_bound(w, height) + 8 * math.ulp(largest_coordinate(piece))
    # Where the bulge is normal to the chord and the weight near 1 the bound is nearly attained.
    flat = Piece(classify(w), (0, 1), (-1.0, 0.0), (1.0, 0.0), (0.0, 0.2 * w), w, 0.0)
    handles = [-1 + ratio, ratio * 0.2, 1 - ratio, ratio * 0.2]
    if 0.9 < w < 1.1:
        assert deviation(flat, [("C", flat.start, handles, flat.end)]) > 0.75 * cubic_bound(w, 0.2)


@given(pieces(), st.floats(-13, -2))
@settings(max_examples=50, deadline=None)
def test_cubics_keep_their_budget(piece, exponent):
    budget = 10**exponent * size_of(piece)
    start, commands = piece.start, []
    for c1, c2, end in cubics(piece, budget):
        commands.append(("C", start, [*c1, *c2], end))
        start = end
    assume(len(commands) <= 20)
    assert deviation(piece, commands, budget) <= budget + 4 * math.ulp(largest_coordinate(piece))


@given(pieces(st.floats(0.2, 5)))
@settings(max_examples=50, deadline=None)
def test_the_parabola_bound_holds(piece):
    control = [p + v / piece.weight for p, v in zip(piece.start, piece.legs[0])]
    measured = deviation(piece, [("Q", piece.start, control, piece.end)])
    assert measured <= parabola_bound(piece) + 8 * math.ulp(largest_coordinate(piece))


@given(pieces(st.floats(-0.95, 0.99)), st.integers(0, 3))
def test_the_ellipse_carries_the_arc(piece, halvings):
    """Principal axes against numpy's singular values, and the arc's points on the ellipse."""
    conic = ellipse(piece, halvings)
    w, sine = piece.weight, math.sqrt(1 - piece.weight**2)
    matrix = np.array([np.array(piece.bulge) / sine**2, np.array(piece.legs[2]) / (2 * sine)]).T
    slimness = conic.radii[0] / conic.radii[1]
    assert conic.radii[0] == pytest.approx(np.linalg.norm(matrix, 2), rel=1e-12)
    assert conic.radii[1] == pytest.approx(abs(np.linalg.det(matrix)) / conic.radii[0], rel=1e-14 * slimness)
    c, s = math.cos(conic.rotation), math.sin(conic.rotation)
    axes = np.array([[c, s], [-s, c]]) @ matrix / np.array(conic.radii)[:, None]
    assert axes @ axes.T == pytest.approx(np.eye(2), abs=1e-13 * slimness)
    assert conic.half_angle == pytest.approx(math.acos(w) / 2**halvings)
    centre = (np.array(piece.start) + np.array(piece.end)) / 2 - w * matrix[:, 0]
    x, y = np.linalg.solve(matrix, (np.array([piece.start, *conic.ends]) - centre).T)
    angles = np.linspace(-math.acos(w), math.acos(w), 2**halvings + 1)
    slack = 1e-13 * largest_coordinate(piece) / conic.radii[1] + 1e-12
    assert x == pytest.approx(np.cos(angles), abs=slack)
    assert y == pytest.approx(np.sin(angles), abs=slack)


# --- what is written ---


@given(pieces(), st.one_of(st.none(), st.floats(-12, -1)))
@settings(max_examples=100, deadline=None)
def test_the_written_curve_stays_within_the_reserve(piece, exponent):
    floor = writing_share(0.0, math.ulp(largest_coordinate(piece)))
    reserve = floor if exponent is None else max(floor, 10**exponent * size_of(piece))
    data, _ = path_data([piece], reserve)
    commands = read_path(data)
    assume(len(commands) <= 20)
    assert deviation(piece, commands, reserve) <= reserve


@given(st.floats(0.01, 0.95), st.floats(-7, 0), st.floats(-9, -2), st.floats(0, 7))
@settings(max_examples=50, deadline=None)
def test_tiny_arcs_of_large_ellipses(slimness, turning, exponent, start):
    """Arcs of an ellipse with semi-axes 1 and `slimness` that turn by 10^turning: down to near-parabolas."""
    half = 10**turning / 2
    w = math.cos(half)
    ends = [np.array([math.cos(start + x), slimness * math.sin(start + x)]) for x in (0, 2 * half)]
    middle = np.array([math.cos(start + half), slimness * math.sin(start + half)])
    piece = Piece("ellipse", (0, 1), tuple(ends[0]), tuple(ends[1]), tuple(middle), w, 0.0)
    reserve = max(10**exponent * size_of(piece), writing_share(0, math.ulp(1.0)))
    assert deviation(piece, read_path(path_data([piece], reserve)[0]), reserve) <= reserve


@pytest.mark.parametrize("radius", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("shift", [0.0, 1e3])
def test_arcs_of_circles_are_few_and_exact(radius, shift):
    for turning, count in ((0.5, 1), (2.0, 1), (math.pi, 2), (4.0, 2), (5.5, 4)):
        for direction in (1, -1):
            piece = circle(0.3, 0.3 + turning, radius=radius, shift=shift * radius)
            if direction < 0:
                piece = replace(piece, start=piece.end, end=piece.start)
            reserve = writing_share(1e-6 * radius, math.ulp(4 * (shift + 1) * radius))
            commands = read_path(path_data([piece], reserve)[0])
            assert [command[0] for command in commands] == ["A"] * count
            assert all(command[2][3:] == [0, direction > 0] for command in commands)
            assert deviation(piece, commands, reserve) <= reserve


@given(st.lists(pieces(), min_size=2, max_size=4), st.floats(-9, -2))
@settings(max_examples=30, deadline=None)
def test_pieces_join_and_share_their_rounding(parts, exponent):
    """Pieces of very different shape, moved end to end: rounding must suit the most sensitive."""
    chain, here, scale = [], (0.0, 0.0), size_of(parts[0])
    for piece in parts:
        shrink = scale / size_of(piece)
        (ax, ay), _, (cx, cy) = (tuple(shrink * x for x in leg) for leg in piece.legs)
        end = (here[0] + cx, here[1] + cy)
        middle = (piece.weight * here[0] + ax, piece.weight * here[1] + ay)
        chain.append(replace(piece, start=here, end=end, middle=middle))
        here = end
    reserve = max(
        10**exponent * scale, *(writing_share(0, math.ulp(largest_coordinate(piece))) for piece in chain)
    )
    commands = read_path(path_data(chain, reserve)[0])
    counts = [len(read_path(path_data([piece], reserve)[0])) for piece in chain]
    assert sum(counts) == len(commands)
    assume(len(commands) <= 20)
    for piece in chain:
        mine, commands = commands[: counts[0]], commands[counts.pop(0) :]
        assert deviation(piece, mine, reserve) <= reserve


def test_each_kind_has_its_command():
    parabola = Piece("parabola", (0, 1), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0), 1.0, 0.0)
    hyperbola = Piece("hyperbola", (1, 2), (2.0, 0.0), (4.0, 0.0), (4.5, -1.5), 1.5, 0.0)
    segment = Piece.segment((2, 3), (4.0, 0.0), (5.0, 1.0))
    half = Piece("ellipse", (3, 4), (5.0, 1.0), (5.0, 3.0), (3.0, 0.0), 0.0, 0.0)
    data, _ = path_data([parabola, hyperbola, segment, half], 1e-2)
    assert re.sub(r"[^A-Z]", "", data) == "MQCLAA"
    assert data.splitlines()[1] == "Q1 1 2 0"


def test_radii_are_capped():
    """An ellipse 1e6 times larger than the piece is written as cubics, and so is one too slim."""
    for w, height in ((1 - 1e-11, 0.1), (0.9, 1e-7)):
        piece = Piece("ellipse", (0, 1), (-1.0, 0.0), (1.0, 0.0), (0.0, w * height), w, 0.0)
        data, _ = path_data([piece], 1e-15)
        assert "A" not in data
        assert deviation(piece, read_path(data), 1e-15) <= 1e-15


def test_fewer_digits_for_a_larger_reserve():
    arcs = [circle(i / 2, (i + 1) / 2) for i in range(4)]
    lengths = [len(path_data(arcs, reserve)[0]) for reserve in (1e-3, 1e-6, 1e-9, 1e-12)]
    assert lengths == sorted(lengths)
    assert lengths[0] < 130


@pytest.mark.parametrize("reserve", [0.0, -1.0, math.nan, 1e-20])
def test_a_reserve_below_rounding_is_refused(reserve):
    with pytest.raises(ToleranceError, match="name the file when approximating"):
        path_data([circle(0, 1)], reserve)


def test_only_the_path_of_a_closed_spline_is_closed():
    thirds = [circle(2 * math.pi * i / 3, 2 * math.pi * (i + 1) / 3) for i in range(3)]
    for spline, ends in (
        (replace(spline_of(thirds), closed=True), True),
        (spline_of(thirds), False),
        (replace(spline_of(thirds[:2]), closed=True), False),  # its ends do not meet
        (replace(spline_of([*thirds[:2], replace(thirds[2], end=(1 + 1e-9, 0.0))]), closed=True), False),
    ):
        path = ET.fromstring(written(spline, svg)).find(f".//{SVG}path[@id='spline']").get("d")
        assert path.endswith(" Z") == ends and path.count("Z") == ends  # XML makes a blank of a line end


def test_a_spline_without_room_for_rounding_is_refused(tmp_path):
    spline = spline_of([circle(0.0, 2.0, error=1e-6)], tolerance=1e-6)
    with pytest.raises(
        ToleranceError, match=r"leaves 0 of the tolerance .* name the file when approximating"
    ):
        spline.write(tmp_path / "a.svg")
    assert not list(tmp_path.iterdir())
    assert "<path" in written(spline, svg, room=1e-9)


def test_the_file_is_a_picture_with_its_history():
    spline = spline_of([circle(0, 2), circle(2, 4, error=1e-9)], text='cos(t), sin(t) < "&"', tolerance=1e-6)
    text = written(spline, svg, command="osculant approximate 'a < b & c' --tolerance 1e-6 \x00]]>")
    root = ET.fromstring(text)
    description = root.find(SVG + "desc").text
    assert "osculant approximate 'a < b & c' --tolerance 1e-6 \ufffd]]>" in description
    for fact in ("osculant 0.", "conic, 2 pieces", "tolerance: 1e-06", "error: 1e-09 (estimate)"):
        assert fact in description
    assert root.find(SVG + "title").text == 'cos(t), sin(t) < "&"'
    left, top, width, height = map(float, root.get("viewBox").split())
    box = np.ravel(spline.bounding_box())
    assert left < box[0] < box[2] < left + width
    assert top < -box[3] < -box[1] < top + height
    assert width < 1.15 * (box[2] - box[0])
    group = root.find(SVG + "g")
    assert group.get("transform") == "scale(1,-1)"
    curve, knots = group.findall(SVG + "path")
    assert (curve.get("id"), knots.get("id")) == ("spline", "knots")
    assert knots.get("d").count("M") == 3
    assert curve.get("d").count("M") == 1
    assert "knots" not in written(spline, svg, knots=False)
    assert "command" not in written(spline, svg)
