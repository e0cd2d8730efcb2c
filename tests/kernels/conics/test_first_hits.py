"""The displacement on arcs that turn by more than π: the first hit of the normal on the member's side.

Not the nearer crossing: over [0.2, 3.4] of Archimedes' spiral one member's nearer crossings lie within 1.396
of the curve, and the member goes 1.87 away from it, between the feet of two normals.
"""

import numpy as np
import pytest

import osculant as osc
from osculant.kernels.conics import pencil as pencils
from osculant.kernels.generated import pencil as generated
from tests.hausdorff import Formula, distance
from tests.kernels.arcs import NOISE, arc, jet_of

SPIRAL, LOG = "t*cos(t), t*sin(t)", "exp(t/5)*cos(t), exp(t/5)*sin(t)"


def cross(v, w):
    return v[..., 0] * w[..., 1] - v[..., 1] * w[..., 0]


class Family:
    """The bitangent conics of an arc, from nothing but points and tangents of the curve."""

    def __init__(self, on, times):
        self.first, self.last = np.array(on.start[:2]), np.array(on.end[:2])
        self.tangents = np.array(on.start[2:]), np.array(on.end[2:])
        self.chord = (self.last - self.first) / np.linalg.norm(self.last - self.first)
        view = [pencils.sample(on.source, t) for t in times]
        self.points = np.array([v[:2] for v in view])
        self.normals = np.array([(-v[3], v[2]) for v in view])

    def lines(self, points):
        """[T₂, x − P₂], [ĉ, x − P₀] and [T₀, x − P₀]."""
        return (
            cross(self.tangents[1], points - self.last),
            cross(self.chord, points - self.first),
            cross(self.tangents[0], points - self.first),
        )

    def hits(self, q):
        """(on the member's side, nearest) of the normals' hits with the member's arc; infinite where none."""
        ends = [self.lines(self.points + d * self.normals) for d in (-1.0, 0.0, 1.0)]
        values = [l1**2 - 4 * q * l0 * l2 for l0, l1, l2 in ends]
        a, b, c = (values[0] + values[2]) / 2 - values[1], (values[2] - values[0]) / 2, values[1]
        # the arc lies where F > 0 for smaller Q: the member is to the right of it, where F < 0 to the left
        side = np.sign(c)
        first, nearest = np.full(len(a), np.inf), np.full(len(a), np.inf)
        with np.errstate(invalid="ignore"):
            roots = np.sqrt(b * b - 4 * a * c)
        for sign in (-1, 1):
            d = (-b + sign * roots) / (2 * a)
            l0, l1, l2 = self.lines(self.points + d[:, None] * self.normals)
            on_arc = (l0 > -1e-9) & (l1 < 1e-9) & (l2 > -1e-9)
            nearest = np.where(on_arc & (np.abs(d) < np.abs(nearest)), d, nearest)
            beside = on_arc & (d * side > 0) & (np.abs(d) < np.abs(first))
            first = np.where(beside, d, first)
        return first, nearest

    def segment(self, q, pen, interval):
        """The member as a piece's JSON."""
        w, reach = generated.weight(q, pen.chord, pen.sin_a, pen.sin_b, pen.sin_psi)
        middle = w * self.first + reach * self.tangents[0]
        ends = [self.first.tolist(), None, self.last.tolist()]
        return {"kind": "conic", "points": ends, "middle": middle, "weight": w, "interval": interval}


def seen(text, a, b, count=400):
    on = arc(jet_of(text), a, b)
    times = np.linspace(a, b, count + 2)[1:-1]
    pen = pencils.pencil(on.start, on.end, NOISE)
    largest = pen.sin_a * pen.sin_b / pen.sin_psi**2  # of bounded members where the arc turns more than π
    return on, times, pen, Family(on, times), largest


@pytest.mark.parametrize(
    ("text", "a", "b", "parts"),
    [
        (SPIRAL, 0.2, 3.4, (0.37, 0.381, 0.45, 0.6119, 0.8)),
        (SPIRAL, 0.3, 3.2, (0.3, 0.5, 0.7)),
        (LOG, 0.0, 3.6, (0.2, 0.4, 0.6)),
        (LOG, 0.0, 4.2, (0.3, 0.5, 0.7)),
    ],
)
def test_the_displacement_is_the_first_hit_on_the_members_side(text, a, b, parts):
    """And where every normal meets the member, max |d| is no less than the Hausdorff distance."""
    on, times, pen, family, largest = seen(text, a, b)
    formula = Formula(text, repr(a), repr(b))
    checked = 0
    for q in (part * largest for part in parts):
        first, _ = family.hits(q)
        d = np.array([pencils.displacement(pen, q, pencils.view(pen, on.source, t))[0] for t in times])
        both = np.isfinite(first) & np.isfinite(d)
        assert d[both] == pytest.approx(first[both], rel=1e-6, abs=1e-9)
        if np.isfinite(d).all():
            away = distance(formula, family.segment(q, pen, (a, b)), formula.parts(a, b, 1e-10))
            assert np.abs(d).max() * (1 + 1e-2) >= away
            checked += 1
    assert checked


def test_the_nearer_crossing_is_no_error():
    _, _, pen, family, largest = seen(SPIRAL, 0.2, 3.4)
    q = 0.381 * largest
    first, nearest = family.hits(q)
    formula = Formula(SPIRAL, "0.2", "3.4")
    away = distance(formula, family.segment(q, pen, (0.2, 3.4)), formula.parts(0.2, 3.4, 1e-10))
    assert np.abs(nearest).max() == pytest.approx(1.396, abs=2e-3)
    assert away == pytest.approx(1.8747, abs=1e-3)
    assert np.abs(first).max() == pytest.approx(away, rel=1e-3)


def test_the_error_of_the_one_conic_of_the_spiral_is_its_distance():
    """There are nearer conics, 1.46 away, that some normals miss: nothing is said of the least."""
    spline = osc.approximate(osc.curve(SPIRAL, "0.2", "3.4"), "conic", pieces=1)
    formula = Formula(SPIRAL, "0.2", "3.4")
    [segment] = spline.to_json()["segments"]
    away = distance(formula, segment, formula.parts(0.2, 3.4, 1e-10))
    assert away <= spline.error * (1 + 1e-6) and spline.error == pytest.approx(away, rel=1e-3)
    assert spline.minimal == "unknown"
    _, _, pen, family, largest = seen(SPIRAL, 0.2, 3.4)
    nearer = family.segment(0.331 * largest, pen, (0.2, 3.4))
    assert distance(formula, nearer, formula.parts(0.2, 3.4, 1e-10)) == pytest.approx(1.464, abs=2e-3)
