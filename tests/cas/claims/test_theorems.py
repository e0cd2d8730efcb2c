"""Theorems A, B, C, P and G by other computations than those of their claims."""

from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from osculant.cas.claims.chapter_3 import six_zeros, spiral_chords
from osculant.cas.claims.chapter_3.greedy import _is_minimal
from osculant.cas.claims.chapter_3.witnesses import _first_hit
from osculant.cas.claims.chapter_5.spiral_samples import SPIRALS, Sample
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.moons import moons

MONOMIALS = (lambda z: z.real**2, lambda z: z.real * z.imag, lambda z: z.imag**2, lambda z: z.real,
             lambda z: z.imag, lambda z: 1)  # fmt: skip


def through(points):
    """The conic through five points, by the null vector of their monomials."""
    rows = mp.matrix([[m(z) for m in MONOMIALS] for z in points])
    coefficients = []
    for i in range(6):
        minor = mp.matrix([[rows[r, c] for c in range(6) if c != i] for r in range(5)])
        coefficients.append((-1) ** i * mp.det(minor))
    return lambda z: sum(c * m(z) for c, m in zip(coefficients, MONOMIALS))


@settings(max_examples=20, deadline=None)
@given(
    growth=st.floats(0.03, 0.6),
    turning=st.floats(0.5, 4.5),
    places=st.lists(st.integers(1, 99), min_size=5, max_size=5, unique=True),
)
def test_a_conic_through_five_places_of_a_strictly_convex_log_spiral_arc_meets_it_nowhere_else(
    growth, turning, places
):
    with mp.workdps(60):
        w = mp.mpc(growth, 1)
        chord = mp.exp(w * turning) - 1
        assume(mp.im(mp.conj(w) * chord) > 0 and mp.im(mp.conj(chord) * w * mp.exp(w * turning)) > 0)
        at = [mp.mpf(turning) * n / 100 for n in sorted(places)]
        conic = through([mp.exp(w * t) for t in at])
        signs = set()
        for i in range(241):
            t = mp.mpf(turning) * i / 240
            if min(abs(t - z) for z in at) > mp.mpf(10) ** -6:
                signs.add(mp.sign(conic(mp.exp(w * t)) * mp.fprod(t - z for z in at)))
        assert len(signs) == 1


def test_a_long_arc_of_the_spiral_meets_a_hyperbola_six_times():
    def equation(t):
        x, y = t * mp.cos(t), t * mp.sin(t)
        line = x + 2 * y / 25
        return (line - mp.mpf(1) / 2) * (line - mp.mpf(29) / 50) - y * y / 2000

    found = []
    grid = [mp.pi / 6 + (2 * mp.pi - mp.pi / 6) * i / 4000 for i in range(4001)]
    for one, two in pairwise(grid):
        if equation(one) * equation(two) < 0:
            found.append(one)
    assert len(found) == 6 == six_zeros.six_zeros("k monotone")[0]


@pytest.mark.parametrize("stretch", [1, 100, 10**4])
def test_the_turning_of_an_image_against_a_sum_of_small_angles(stretch):
    t = np.linspace(0.53, 4.95, 200_001)
    dx, dy = np.cos(t) - t * np.sin(t), np.sin(t) + t * np.cos(t)
    angle = np.unwrap(np.arctan2(stretch * (dy - dx / 5), dx + 0.08 * dy))
    if stretch > 1:
        assert abs(float(six_zeros.turning(arb(stretch)).mid()) - (angle[-1] - angle[0])) < 1e-9
        assert angle[-1] - angle[0] < np.pi + 8 / stretch
    assert angle[-1] - angle[0] > np.pi


def test_osculating_conics_of_a_spiral_of_many_turns_are_nested():
    w = mp.mpc("0.05", 1)
    with mp.workdps(30):
        for r in (0, 5, 12):
            # affine frame by derivatives: [γ′, γ″] = 1 after scaling the parameter
            g = [mp.exp(w * r) * w**n for n in range(5)]
            bracket = lambda a, b: mp.im(mp.conj(a) * b)  # noqa: E731
            points = [mp.exp(w * (r + d * mp.mpf(10) ** -4)) for d in (-2, -1, 0, 1, 2)]
            conic = through(points)
            signs = [mp.sign(conic(mp.exp(w * t))) for t in (r - 20, r - 6, r - 1, r + 1, r + 6, r + 20)]
            assert bracket(g[1], g[2]) > 0
            assert signs[0] == signs[1] == signs[2] == -signs[3] == -signs[4] == -signs[5]


@settings(max_examples=8, deadline=None)
@given(growth=st.floats(0.03, 0.4), turning=st.floats(0.8, 3.4))
def test_the_least_area_is_where_the_linear_form_vanishes(growth, turning):
    with mp.workdps(15):
        curve = ReferenceCurve(f"exp({growth}*t)*cos(t), exp({growth}*t)*sin(t)")
        pencil = BitangentPencil(curve, 0, turning)

        def form(t):
            l0, _, l2 = pencil.lines(pencil.frame(t).point)
            return l0 * pencil.sin_a - l2 * pencil.sin_b

        places = [pencil.b * i / 40 for i in range(1, 40)]
        values = [form(t) for t in places]
        assert sum(a * b < 0 for a, b in pairwise(values)) == 1
        root = mp.findroot(form, (places[10], places[30]), solver="anderson")
        best = sum(moons(pencil, pencil.through(root)))
        for other in (root * mp.mpf("0.97"), root * mp.mpf("1.03")):
            assert sum(moons(pencil, pencil.through(other))) > best


def test_the_linear_form_is_zero_on_the_line_through_the_middle_of_the_chord_and_p1():
    with mp.workdps(30):
        pencil = BitangentPencil(ReferenceCurve("t*cos(t), t*sin(t)"), 1, "2.2")
        for q in ("0.1", "0.4", "2"):
            l0, _, l2 = pencil.lines(pencil.member(mp.mpf(q), mp.mpf(1) / 2))
            assert abs(l0 * pencil.sin_a - l2 * pencil.sin_b) < mp.mpf(10) ** -25


@pytest.mark.parametrize("name", SPIRALS)
def test_biarcs_through_a_point_move_away_and_their_error_grows(name):
    curve, low, high = SPIRALS[name]
    with mp.workdps(15):
        a, width = mp.mpf(low), mp.mpf(high) - mp.mpf(low)
        errors = [curve.least(a, a + width * part / 10) for part in (5, 7, 9)]
        assert errors == sorted(errors) and errors[0] < errors[1] < errors[2]
        biarc = curve.through(a, a + width, a + width / 3)
        assert abs(biarc.displacement(*curve.frame(a + width / 3))) < 1e-10


def test_the_samples_of_spirals_are_what_they_say():
    for curve, low, high in SPIRALS.values():
        for part in (0.1, 0.5, 0.9):
            t = mp.mpf(low) + (mp.mpf(high) - mp.mpf(low)) * part
            velocity = mp.diff(curve.point, t)
            assert abs(velocity / abs(velocity) - curve.frame(t)[1]) < 1e-6
    assert isinstance(curve, Sample)


@settings(max_examples=40)
@given(st.floats(0, 10), st.floats(0.2, 7), st.floats(0, 1))
def test_distances_from_chords_are_enclosed(start, length, part):
    a, b, p = (
        np.array([(1 - t / 50) * np.cos(t), (1 - t / 50) * np.sin(t)])
        for t in (start, start + length, start + length * part)
    )
    along = np.clip((p - a) @ (b - a) / max((b - a) @ (b - a), 1e-30), 0, 1)
    exact = np.hypot(*(p - a - along * (b - a)))
    points = [spiral_chords.point(arb(t)) for t in (start + length * part, start, start + length)]
    low, high = spiral_chords.distance(*points)
    assert float(low) - 1e-9 <= exact <= float(high) + 1e-9


def test_greedy_is_judged_place_by_place():
    assert _is_minimal(((1, 2), (2, 3), (3, 4), (4, 5), (5,)))
    assert not _is_minimal(((1, 2, 3), (2, 3, 4, 5), (3,), (4,), (5,)))  # the first long arc leads nowhere


def test_first_hits_agree_with_displacement_on_short_arcs():
    with mp.workdps(20):
        pencil = BitangentPencil(ReferenceCurve("t*cos(t), t*sin(t)"), 1, 2)
        for q in (pencil.through("1.3"), pencil.parabola):
            for t in ("1.1", "1.5", "1.8"):
                assert abs(_first_hit(pencil, mp.mpf(t), q) - pencil.displacement(mp.mpf(t), q).d) < 1e-15
