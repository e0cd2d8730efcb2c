"""Bitangent conics with a fixed crossing, and the least area, as the arc grows: by other computations."""

from itertools import pairwise

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp

from osculant.cas.claims.chapter_3.least_area import ACROSS, ENDS, least_grows, moons_grow
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.geometry.bitangent import BitangentPencil, ReferenceCurve
from osculant.cas.geometry.moons import least_area, moons, signed_area
from osculant.cas.geometry.vectors import bracket
from osculant.cas.numbers.roots import root_between

SPIRAL = "t*cos(t), t*sin(t)"
CAYLEY = "4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)"


def equation(curve, a, s, crossing):
    """F of the member through a point of the curve, as a function of the point: from the lines themselves."""
    pencil = BitangentPencil(curve, a, s)
    c0, c1, c2 = pencil.lines(curve.frame(crossing).point)

    def value(point):
        l0, l1, l2 = pencil.lines(point)
        return l1**2 * c0 * c2 - c1**2 * l0 * l2

    return value


def log_spiral(growth, stretch=1, shear=0):
    """exp(gt)(cos t, sin t) under a linear map: k is monotone, and ever less so as g tends to 0."""
    x, y = (f"exp({growth}*t)*{f}(t)" for f in ("cos", "sin"))
    return ReferenceCurve(f"{stretch}*{x} + {shear}*{y}, {y}")


@pytest.mark.parametrize(
    "text, a, s, crossing",
    [
        (SPIRAL, "1", "2.5", "1.8"),
        (CAYLEY, "0.2", "1.4", "1.1"),
        ("t, exp(t)", "-1", "1", "-0.9"),
        ("exp(t/4)*cos(t), exp(t/4)*sin(t)", "0", "pi", "1"),  # parallel end tangents
        ("exp(t/9)*cos(t), exp(t/9)*sin(t)", "0", "3.6", "2"),  # turning by more than π
        ("t, t^2/2 - t^3/9", "-1", "1.2", "0.5"),  # across zeros of k: the formula asks for no spiral
    ],
)
def test_the_motion_of_the_conic_is_that_of_its_equation_by_finite_differences(text, a, s, crossing):
    with mp.workdps(40):
        a, s, crossing = mp.mpf(a), (mp.pi if s == "pi" else mp.mpf(s)), mp.mpf(crossing)
        curve = ReferenceCurve(text)
        pencil = BitangentPencil(curve, a, s)
        q, fixed = pencil.through(crossing), curve.frame(crossing).point
        here = equation(curve, a, s, crossing)
        bend = mp.diff(lambda u: here(curve.frame(u).point), s, 2)
        chord = fixed[0] - pencil.first.point[0], fixed[1] - pencil.first.point[1]

        def beside(t):  # of the line from the first end to the crossing
            x, y = pencil.member(q, t)
            return bracket(chord, (x - fixed[0], y - fixed[1]))

        tau = root_between(beside, mp.mpf("1e-6"), mp.mpf(1))
        along = [mp.diff(lambda t, i=i: pencil.member(q, t)[i], 1) for i in (0, 1)]
        rate = mp.hypot(*along) / pencil.last.speed
        for t in (mp.mpf(i) / 7 for i in range(1, 7)):
            point = pencil.member(q, t)
            velocity = mp.diff(lambda end, p=point: equation(curve, a, end, crossing)(p), s)
            below = (1 - t) ** 2 + 2 * pencil.weight(q) * t * (1 - t) + t * t
            formula = rate * bend * t * t * (1 - t) * (t - tau) / ((1 - tau) * below**2)
            assert abs(velocity - formula) < mp.mpf(10) ** -12 * abs(formula)


@settings(max_examples=25, deadline=None)
@given(
    growth=st.floats(0.01, 0.4),
    first=st.floats(0.4, 2.4),
    more=st.floats(0.05, 0.6),
    part=st.floats(0.1, 0.9),
    stretch=st.floats(0.5, 2),
    shear=st.floats(-1, 1),
)
def test_with_a_fixed_crossing_displacement_and_moons_grow(growth, first, more, part, stretch, shear):
    with mp.workdps(30):
        curve = log_spiral(growth, stretch, shear)
        crossing = mp.mpf(first) * part
        pencils = [BitangentPencil(curve, 0, end) for end in (first, mp.mpf(first) + more)]
        members = [(pencil, pencil.through(crossing)) for pencil in pencils]
        for i in range(1, 8):
            u = mp.mpf(first) * i / 8
            assume(abs(u - crossing) > 1e-3)
            small, large = (pencil.displacement(u, q).d for pencil, q in members)
            assert 0 < small / large < 1
        for low, high in ((lambda p: p.a, lambda p: crossing), (lambda p: crossing, lambda p: p.b)):
            small, large = (signed_area(p, q, low(p), high(p)) for p, q in members)
            assert 0 < small / large < 1


@pytest.mark.parametrize("growth", ["0.001", "0.2"])
def test_the_least_area_is_least_inside_and_grows(growth):
    with mp.workdps(15):
        curve, least = log_spiral(growth), []
        for end in ("0.8", "1.6", "1.61", "2.5"):
            pencil = BitangentPencil(curve, 0, end)
            tried = [sum(moons(pencil, pencil.through(pencil.b * i / 16))) for i in range(1, 16)]
            least.append(sum(moons(pencil, pencil.through(least_area(pencil)))))
            assert least[-1] <= min(tried)
            assert tried[0] > tried[1] > tried[2] and tried[-1] > tried[-2] > tried[-3]
        assert all(one < two for one, two in pairwise(least))


def test_a_crossing_near_the_end_of_the_shorter_arc_serves_it_better_than_the_longer():
    with mp.workdps(25):
        curve = ReferenceCurve(SPIRAL)
        crossing = least_area(BitangentPencil(curve, 1, 2))
        areas = []
        for beyond in ("0.01", "0.1", "0.3"):
            pencil = BitangentPencil(curve, 1, crossing + mp.mpf(beyond))
            areas.append(abs(signed_area(pencil, pencil.through(crossing), crossing)))
        assert areas[0] < areas[1] < areas[2] and areas[0] < areas[1] * mp.mpf("0.01")


@pytest.mark.parametrize("check", [moons_grow, least_grows])
def test_an_unknown_hypothesis_is_refused(check):
    with pytest.raises(DomainError, match=r"'k constant' is unknown: use 'k monotone' or .*extremum'\.$"):
        check("k constant")


@pytest.mark.parametrize("form", ACROSS)
def test_a_counterexample_that_is_none_is_not_taken_for_one(form, monkeypatch):
    monkeypatch.setitem(ACROSS, form, "t, exp(t)")
    with pytest.raises(UndecidedError, match="not certain"):
        moons_grow(form)


def test_the_ends_tried_are_ordered():
    assert sorted(map(float, ENDS)) == [float(end) for end in ENDS] and float(ENDS[-1]) == 1
