"""Certificates against 40-digit distances that share no code with them."""

import json
import math
from dataclasses import replace
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from mpmath import mpf

import osculant as osc
from osculant.cas.errors import DomainError, ToleranceError
from osculant.certificates.splines import certify
from osculant.curves.plane import PlaneCurve
from osculant.pieces.conics import Piece
from tests.front.samples import circle, pieces, spline_of


def spiral(t):
    return t * mpmath.cos(t), t * mpmath.sin(t)


def sextic(t):
    return 4 * mpmath.cos(t / 3) ** 3 * mpmath.cos(t), 4 * mpmath.cos(t / 3) ** 3 * mpmath.sin(t)


CASES = {
    "spiral": (spiral, "t*cos(t), t*sin(t)", "pi/6", "2*pi"),
    "far": (
        lambda t: (10**6 + spiral(t)[0], spiral(t)[1] - 10**6),
        "1000000 + t*cos(t), t*sin(t) - 1000000",
        "pi/6",
        "2*pi",
    ),
    "sextic": (sextic, "4*cos(t/3)**3*cos(t), 4*cos(t/3)**3*sin(t)", "-3*pi/4", "3*pi/4"),
    "cusp": (lambda t: (t**2, t**3), "t^2, t^3", -1, 1),
    "cusp between doubles": (
        lambda t: ((t - mpf(1) / 3) ** 2, (t - mpf(1) / 3) ** 3),
        "(t - 1/3)^2, (t - 1/3)^3",
        0,
        1,
    ),
    "inflections": (lambda t: (t, mpmath.sin(t)), "t, sin(t)", 0, 4),
    "pole nearby": (lambda t: (t, (t + mpf(1) / 50) ** -2), "t, 1/(t + 1/50)^2", 0, 4),
    "steep": (lambda t: (t, mpmath.log(t)), "t, log(t)", "1/1000", 3),
}


def exactly(point):
    return [mpf(c) for c in point]


def from_arc(point, arc):
    """The distance of a point from a conic arc, by the roots of a quartic."""
    w = mpf(arc.weight)
    (px, py), (mx, my), (qx, qy) = map(exactly, (arc.start, arc.middle, arc.end))
    x, y = point
    a, c = (mx - w * px, my - w * py), (qx - px, qy - py)
    # W·(point − X) and W²X′/2 as quadratics in v, from the highest power
    total = [2 - 2 * w, 2 * w - 2, mpf(1)]
    away = [[total[0] * d + 2 * e - f, total[1] * d - 2 * e, d] for d, e, f in zip((x - px, y - py), a, c)]
    along = [[e + (w * f - e) - f, f - 2 * e, e] for e, f in zip(a, c)]
    quartic = [mpf(0)] * 5
    for one, other in zip(away, along):
        for i, p in enumerate(one):
            for j, q in enumerate(other):
                quartic[i + j] += p * q
    size = max(map(abs, quartic))
    while quartic and abs(quartic[0]) <= size * mpf(10) ** -35:
        quartic.pop(0)
    roots = mpmath.polyroots(quartic, maxsteps=200, extraprec=200) if len(quartic) > 1 else []
    feet = [mpf(0), mpf(1), *(mpmath.re(v) for v in roots if 0 <= mpmath.re(v) <= 1)]
    squares = []
    for v in feet:
        t = mpmath.polyval(total, v)
        squares.append(sum((mpmath.polyval(d, v) / t) ** 2 for d in away))
    return mpmath.sqrt(min(squares))


def largest(curve, piece, samples=16):
    """The largest distance of the curve's points from the piece; each local maximum of samples is refined."""
    a, b = exactly(piece.interval)

    def apart(t):
        return min(from_arc(curve(t), arc) for arc in piece.arcs)

    times = [a + (b - a) * k / samples for k in range(samples + 1)]
    sampled = [apart(t) for t in times]
    found = [max(sampled)]
    for k in range(1, samples):
        if sampled[k] == max(sampled[k - 1 : k + 2]) and sampled[k] > found[0] / 2:
            low, high = times[k - 1], times[k + 1]
            for _ in range(14):  # thirds
                one, two = low + (high - low) * mpf("0.45"), low + (high - low) * mpf("0.55")
                low, high = (one, high) if apart(one) < apart(two) else (low, two)
            found.append(apart((low + high) / 2))
    return max(found)


FITS = [(name, "conic") for name in CASES]
FITS += [("spiral", "biarc"), ("cusp", "biarc"), ("spiral", "parabola"), ("sextic", "parabola")]


@pytest.mark.parametrize(("name", "primitive"), FITS)
def test_bounds_enclose_the_distance_and_are_tight(name, primitive):
    curve, text, low, high = CASES[name]
    tolerance = 1e-5
    spline = osc.approximate(osc.curve(text, low, high), primitive, tolerance)
    measured = spline.error
    proof = spline.certify()
    assert proof.within
    assert proof.upper == spline.error
    assert spline.error_kind == "certified"
    assert proof.upper == pytest.approx(measured, rel=1e-4)
    with mpmath.workdps(40):
        small = mpf(tolerance) * mpf("1e-8")
        for i in {0, len(spline) - 1}:
            bounds, piece = proof.pieces[i], spline.pieces[i]
            distance = largest(curve, piece)
            assert distance <= mpf(bounds.upper)
            assert mpf(bounds.lower) <= mpf(bounds.upper) <= distance * (1 + mpf("1e-5")) + small
            at_peak = min(from_arc(curve(mpf(bounds.at)), arc) for arc in piece.arcs)
            assert mpf(bounds.lower) <= at_peak * (1 + mpf("1e-9"))
            assert at_peak <= mpf(bounds.lower) * (1 + mpf("1e-5")) + small


@pytest.mark.parametrize("primitive", ["parabola", "conic", "biarc", "cubic"])
@pytest.mark.parametrize("tolerance", [0.3, 1, 3])
@pytest.mark.parametrize("name", ["spiral", "sextic"])
def test_bounds_are_tight_beyond_the_radii_of_curvature(name, tolerance, primitive):
    """There nearest points jump, and it may be the piece that has the point farthest from the other."""
    spline = osc.approximate(osc.curve(*CASES[name][1:]), primitive, tolerance)
    measured = spline.error
    proof = spline.certify()
    assert proof.within and spline.error_kind == "certified"
    assert proof.lower <= proof.upper <= proof.lower * (1 + 1e-5)
    assert measured == pytest.approx(proof.upper, rel=1e-5)
    for bounds, piece in zip(proof.pieces, spline.pieces):
        curve, points = spline.curve.jets(np.linspace(*piece.interval, 601))[..., 0], piece.sample(601)
        apart = np.hypot(*(curve[:, None] - points[None]).transpose(2, 0, 1))
        seen = max(apart.min(axis=0).max(), apart.min(axis=1).max())
        step = max(np.hypot(*np.diff(line, axis=0).T).max() for line in (curve, points))
        assert bounds.lower - step <= seen <= bounds.upper + step


def moved(piece, x, y):
    points = (piece.start, piece.end)
    start, end = ((px + x, py + y) for px, py in points)
    w = piece.weight
    return replace(piece, start=start, end=end, middle=(piece.middle[0] + w * x, piece.middle[1] + w * y))


def test_a_wrong_piece_raises_the_bound():
    curve = PlaneCurve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    piece = osc.approximate(curve, "conic", 1e-8).pieces[5]
    right = certify(curve, [piece], 1e-8)
    normal = piece.tangent(0.5)
    shifted = certify(curve, [moved(piece, -1e-9 * normal[1], 1e-9 * normal[0])], 1e-8)
    # at the middle of an equioscillating piece its displacement has either sign
    assert 0.9e-9 < shifted.lower - right.upper < shifted.upper - right.lower < 1.1e-9
    assert right.within
    assert not shifted.within
    swollen = certify(curve, [replace(piece, weight=piece.weight + 1e-6)], 1e-8)
    assert swollen.lower > right.upper + 1e-9
    assert not swollen.within


def test_pieces_exchanged_are_far_off():
    curve = PlaneCurve("t*cos(t), t*sin(t)", "pi/6", "2*pi")
    first, second = osc.approximate(curve, "conic", 1e-6).pieces[:2]
    proof = certify(curve, [replace(first, interval=second.interval)], 1e-6)
    distance = max(math.dist(first.start, second.start), math.dist(first.end, second.end))
    assert distance * 0.5 < proof.upper <= distance * 1.01
    assert not proof.within


@pytest.mark.parametrize("turn", [1.0, 3.1, math.pi, 3.2, 5.5])
def test_exact_arcs_of_any_weight_are_within_rounding(turn):
    curve = PlaneCurve("cos(t), sin(t)", 0, 6)
    piece = circle(0.0, turn)
    proof = certify(curve, [piece], 1e-9)
    assert proof.upper < 1e-12
    off = certify(curve, [circle(0.0, turn, radius=1 + 2.0**-20)], 1e-6)
    assert off.upper == pytest.approx(2.0**-20, rel=1e-6)
    assert off.lower == pytest.approx(2.0**-20, rel=1e-5)


def test_segments():
    line = osc.approximate(osc.curve("t, 2*t + 1/10", 0, "sqrt(2)"), "conic", 1e-6)
    assert line.error_kind == "exact"
    assert line.certify().upper < 1e-13
    assert line.error_kind == "certified"
    chord = Piece.segment((0.0, 2.0), (0.0, 0.0), (2.0, 4.0))
    proof = certify(PlaneCurve("t, t^2", 0, 2), [chord], 1.0)
    assert proof.lower <= 1 / math.sqrt(5) <= proof.upper
    assert proof.upper - proof.lower < 1e-5


@given(pieces())
@settings(deadline=None, max_examples=12, suppress_health_check=[HealthCheck.too_slow])
def test_any_piece_at_all_is_bounded_both_ways(piece):
    proof = certify(PlaneCurve("1 + t, t/2", 0, 1), [piece], 1.0)
    assert proof.lower <= proof.upper < math.inf
    with mpmath.workdps(40):
        there = [from_arc((1 + mpf(k) / 4, mpf(k) / 8), piece) for k in range(5)]
        assert max(there) <= proof.upper
        for x, y in piece.sample(9).tolist():
            along = min(mpf(1), max(mpf(0), (2 * (mpf(x) - 1) + mpf(y)) * 2 / 5))
            away = mpmath.hypot(mpf(x) - 1 - along, mpf(y) - along / 2)
            assert away <= proof.upper * (1 + 1e-12) + 1e-12  # the samples are rounded
        at = mpf(proof.pieces[0].at)
        of_curve = from_arc((1 + at, at / 2), piece)
    points = piece.sample(4001)
    u = np.clip((2 * (points[:, 0] - 1) + points[:, 1]) * 2 / 5, 0, 1)
    of_piece = np.hypot(points[:, 0] - 1 - u, points[:, 1] - u / 2).max()
    step = np.hypot(*np.diff(points, axis=0).T).max()
    assert proof.lower <= max(float(of_curve) * (1 + 1e-12), of_piece + step)


def test_the_whole_interval_is_covered_though_its_ends_are_no_doubles():
    # so steep that the last double is far from the end: 2⁻⁴⁰ before it the curve has a height of -0.9
    curve = PlaneCurve("t, 10^12*(t - sqrt(2))", "1414213562/10^9", "sqrt(2)")
    begin, end = curve.interval
    late = end - 2.0**-40
    with mpmath.workdps(40):
        low, height = (float(10**12 * (mpf(t) - mpmath.sqrt(2))) for t in (begin, late))
    segment = Piece.segment((begin, end), (begin, low), (late, height))
    proof = certify(curve, [segment], 1.0)
    assert proof.lower == pytest.approx(-height, rel=1e-5)
    assert proof.upper == pytest.approx(-height, rel=1e-5)
    assert certify(curve, [replace(segment, interval=(begin, late))], 1.0).upper < 1e-3


def test_a_closed_curve_may_begin_anywhere():
    curve = PlaneCurve("cos(t), sin(t)", 0, "2*pi")
    start = 1.0
    knots = [start, start + 2, start + 4, start + 2 * math.pi]
    arcs = [circle(a, b) for a, b in pairwise(knots)]
    proof = certify(curve, arcs, 1e-6)
    assert proof.within
    assert proof.upper < 1e-12


def test_without_a_series_there_is_a_reason_and_no_bound():
    curve = PlaneCurve("t, 1/t", -1, 2)
    segment = Piece.segment((-1.0, 2.0), (-1.0, -1.0), (2.0, 0.5))
    spline = replace(spline_of([segment]), curve=curve, given="pieces")
    proof = spline.certify()
    assert proof.upper == math.inf
    assert not proof.within
    assert "a division by zero" in proof.pieces[0].reason
    assert spline.error_kind == "exact"  # as before: nothing was proved
    data = json.loads(json.dumps(spline.to_json(), allow_nan=False))["certificate"]
    assert data["upper"] is None
    assert data["pieces"][0]["upper"] is None
    assert data["pieces"][0]["reason"] == proof.pieces[0].reason


def test_a_bound_above_the_tolerance_says_so():
    spline = osc.approximate(osc.curve("t, exp(t)", 0, 1), "biarc", 1e-4)
    proof = certify(spline.curve, spline.pieces, 1e-6)
    assert not proof.within
    assert proof.lower > 1e-6
    assert proof.to_json()["within"] is False
    narrower = replace(spline, tolerance=1e-6)
    with pytest.raises(ToleranceError, match=r"proved to be at least [0-9.e-]+, beyond the tolerance 1e-06"):
        narrower.certify()
    assert narrower.certificate is None
    assert not replace(spline, tolerance=1e-6, given="pieces").certify().within


def test_a_certificate_is_remembered_and_written():
    spline = osc.approximate(osc.curve("t, exp(t)", 0, 1), "conic", 1e-6)
    before, estimate = spline.to_json(), spline.error
    assert spline.certificate is None
    assert before["certificate"] is None
    assert before["error_kind"] == "estimate"
    parts = []
    proof = spline.certify(parts.append)
    assert parts == [(i + 1) / len(spline) for i in range(len(spline))]
    assert spline.certify() is spline.certificate is proof
    data = json.loads(json.dumps(spline.to_json(), allow_nan=False))
    assert data["certificate"] == proof.to_json()
    assert (data["error"], data["error_kind"]) == (proof.upper, "certified")
    assert proof.upper == pytest.approx(estimate, rel=1e-5)
    assert data["errors"] == before["errors"]  # measured, as before
    assert proof.seconds / len(spline) < 1  # generous: about 0.01
    assert proof.bits == 128
    assert replace(spline, tolerance=1.0).certificate is None


def test_what_cannot_be_certified_is_refused():
    spline = osc.approximate(osc.curve("t, exp(t)", 0, 1), "conic", 1e-3)
    with pytest.raises(DomainError, match="metric 'area' cannot be certified"):
        replace(spline, metric="area").certify()
    with pytest.raises(DomainError, match="only the text is known"):
        spline_of([circle(0.0, 1.0)]).certify()
    space = osc.approximate(osc.curve("cos(t), sin(t), t", 0, 1), "bihelix")
    with pytest.raises(DomainError, match="no arc of a conic in the plane: approximate a curve in the plane"):
        space.certify()
    assert space.certificate is None
    first, last = circle(0.0, 1.0), circle(1.5, 2.0)
    with pytest.raises(DomainError, match=r"ends at t = 1\.0 and the next begins at 1\.5"):
        certify(PlaneCurve("cos(t), sin(t)", 0, 2), [first, last], 1.0)
