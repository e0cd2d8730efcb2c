"""Splines that are minimal by theory against all members of the family, on one arc and two: never beaten."""

import random

import pytest

import osculant as osc
from tests.front.approximation.brute import Curve, least, least_of_two

#: samples of an arc hide so much of an error at most, in parts of it
HIDDEN = 1e-3
FORMULAS = (
    "exp({p}*t)*cos(t), exp({p}*t)*sin(t)",
    "t*cos(t) + {p}, t*sin(t)",
    "t, exp({p}*t)",
    "t, -t^(2 + 3*{p})",
    "t*cos(t), {p}*t*sin(t)",
    "exp(-{p}*t)*sin(t), exp(-{p}*t)*cos(t)",
)


def random_arc(choose):
    """(formula, ends, primitive): spirals and graphs, that turn by up to about 4."""
    formula = choose.choice(FORMULAS).format(p=f"{choose.uniform(0.1, 0.9):.3f}")
    a = choose.uniform(0.6, 2.0)
    return formula, a, a + choose.uniform(0.2, 3.5), choose.choice(["conic", "biarc", "parabola"])


def beaten(seeds):
    """The cases in which brute force finds less, and how many were compared, of one piece and of two."""
    found, compared = [], [0, 0]
    for seed in seeds:
        formula, a, b, primitive = random_arc(random.Random(seed))
        curve = osc.curve(formula, repr(a), repr(b))
        own = Curve(formula)
        for pieces in (1, 2):
            try:
                spline = osc.approximate(curve, primitive, pieces=pieces)
            except osc.OsculantError:
                continue  # split, or no piece for so long an arc
            if spline.splits or spline.minimal != "by theory":
                continue
            if pieces == 1:
                brute = least(own, primitive, a, b, 400, 400)
            else:
                brute = least_of_two(own, primitive, a, b, 80, 100, 40)
            compared[pieces - 1] += 1
            if not spline.error * (1 - HIDDEN * (1 + 4 * (pieces - 1))) <= brute:
                found.append((seed, formula, a, b, primitive, pieces, spline.error, brute))
    return found, compared


def test_brute_force_does_not_beat_theory():
    found, (one, two) = beaten(range(12))
    assert not found
    assert one >= 4 and two >= 6


@pytest.mark.slow
def test_brute_force_never_beats_theory():
    found, (one, two) = beaten(range(200))
    assert not found
    assert one >= 150 and two >= 170


@pytest.mark.parametrize("primitive", ["conic", "biarc", "parabola"])
def test_brute_force_comes_close(primitive):
    """So that it would beat what is not the least."""
    formula, a, b = "exp(t/3)*cos(t), exp(t/3)*sin(t)", 0.6, 2.1
    spline = osc.approximate(osc.curve(formula, repr(a), repr(b)), primitive, pieces=1)
    close = least(Curve(formula), primitive, a, b, 2000, 400)
    assert close == pytest.approx(spline.error, rel=2e-2)
    two = osc.approximate(osc.curve(formula, repr(a), repr(b)), primitive, pieces=2)
    assert least_of_two(Curve(formula), primitive, a, b, 300, 100, 60) < 1.25 * two.error
