"""Best cubics of arcs against known values and an independent search; what the fast steps get wrong alone."""

import math

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.optimize import minimize

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.laws.cubics import CUBIC
from osculant.cas.numbers.balls import PRECISION, precision
from osculant.kernels.cubics.exchange import Arms
from osculant.kernels.cubics.records import Cubic
from osculant.kernels.cubics.roots import COLUMNS, real_zeros
from osculant.kernels.curves.jets import sample_many
from tests.kernels.arcs import NOISE, arc, best, confirm, course_of, jet_of, visit
from tests.kernels.cubics.curves import KNOWN, SPIRAL, displacements

FIT = Cubic()
EACH = pytest.mark.parametrize("known", KNOWN, ids=lambda known: f"{known.text} {known.a:.3g}")


@EACH
def test_known_arcs(known):
    error, arms = best(FIT, arc(jet_of(known.text), known.a, known.b))
    loose = 1e-10 + 4 * NOISE / known.error
    assert error == pytest.approx(known.error, rel=3e-9 if known.peaks == 2 else loose)
    # with two peaks the error is flat along the difference of the arms
    accuracy = 1e-4 * max(known.arm0, known.arm3) if known.peaks == 2 else 1e-9
    assert arms == pytest.approx((known.arm0, known.arm3), abs=accuracy)


@EACH
def test_fast_steps_on_known_arcs(known):
    """They find three equal peaks; what has two or four is left to the careful search."""
    on = arc(jet_of(known.text), known.a, known.b)
    error, arms, settled, _ = visit(FIT, on, 1e-9)
    if known.peaks == 3:
        assert settled and error == pytest.approx(known.error, rel=1e-8)
        assert (arms.a0, arms.a3) == pytest.approx((known.arm0, known.arm3), rel=1e-6)
    elif settled:  # one of four peaks was not seen: the measurement sees it
        assert confirm(FIT, arms, on, 16)[0] > 1.1 * error


@EACH
def test_no_arms_nearby_are_better(known):
    """By an independent displacement at dense points."""
    rows = np.empty((1500, 6))
    jet = jet_of(known.text)  # owns the code at its address
    sample_many(jet.address, np.linspace(known.a, known.b, len(rows)), rows)
    points, tangents = rows[:, [0, 3]], rows[:, [1, 4]]
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]

    def largest(arms):
        found = displacements(points, tangents, arms)
        return math.inf if found is None else np.abs(found).max()

    _, arms = best(FIT, arc(jet, known.a, known.b))
    least = largest(arms)
    assert least == pytest.approx(known.error, rel=2e-4)
    for angle in np.linspace(0, 2 * math.pi, 16, endpoint=False):
        for step in (1e-3, 1e-2):
            moved = arms.a0 * (1 + step * math.cos(angle)), arms.a3 * (1 + step * math.sin(angle))
            assert largest(moved) > least * (1 - 1e-4)


def test_the_best_of_three_local_minima():
    """Near t = 2 the spiral has three cubics with six contacts: none is kept but the best."""
    on = arc(jet_of(SPIRAL), 1.95, 2.05)
    error, arms = best(FIT, on)
    assert error == pytest.approx(8.83923397914e-11, rel=1e-5)
    assert (arms.a0, arms.a3) == pytest.approx((0.073531888217735, 0.075583639309185), rel=1e-6)
    unit = 0.5 * (arms.a0 + arms.a3)
    others = (-0.1137482, -0.05, 0.02)  # the first is another local minimum, of 4.31e-9
    for tilt in others:
        found, kept = confirm(FIT, Arms(unit * (1 + tilt), unit * (1 - tilt)), on, 16)
        assert found == pytest.approx(error, rel=1e-2)
        assert kept == pytest.approx(arms, rel=1e-3)


@pytest.mark.parametrize(
    ("text", "t"), [(SPIRAL, 2.0), (SPIRAL, 5.0), ("cos(t), sin(t)", 1.0), ("t, 3*t^3+t^4", 0.0)]
)
def test_short_arcs_obey_the_law(text, t):
    """Up to the square of their length."""
    jet, off = jet_of(text), []
    for half in (0.1, 0.05):
        length, _ = quad(lambda t: np.hypot(*jet(t)[:, 1]), t - half, t + half)
        with precision(PRECISION):
            law = float(CUBIC.ball() * CUBIC.invariant(CurveBalls(parse_tuple(text)).jet(arb(t), 6)))
        off.append(best(FIT, arc(jet, t - half, t + half))[0] / (law * length**6) - 1)
    assert abs(off[0]) < 0.05
    assert abs(off[1]) < 0.3 * abs(off[0]) + 2e-4


@pytest.mark.parametrize(
    ("text", "a", "b"),
    [
        ("t, t^3", -1, 1),
        ("t^3, t^2+t", -1, 2),
        ("t^3, t^2+t", -1, 1.2),
        ("t, t^2", 0, 3),
        ("t^2+t^3, 5-t", 0, 1),
        ("t, 2*t", 0, 1),
    ],
)
def test_cubics_have_no_error(text, a, b):
    error, arms = best(FIT, arc(jet_of(text), a, b))
    assert error == 0.0
    if text == "t, t^3":
        assert arms == pytest.approx([2 / 3 * math.sqrt(10)] * 2, rel=1e-6)


def test_arcs_that_no_cubic_follows():
    loops = arc(jet_of("cos(t), sin(t)"), 0.0, 6.2)
    assert best(FIT, loops)[0] > 0.2  # infinite, or with an error as large as the curve
    backwards = confirm(FIT, Arms(9.0, 9.0), arc(jet_of("cos(t), sin(t)"), 0.0, 1.0), 16)
    assert backwards[0] < 1e-4 or backwards[0] == math.inf
    turned = confirm(FIT, Arms(5.0, 5.0), arc(jet_of("t, 2*t"), 0.0, 1.0), 16)[0]
    assert turned == math.inf  # it goes back on itself


@settings(max_examples=60, deadline=None)
@given(st.lists(st.floats(-3, 3), min_size=4, max_size=4), st.floats(-2, 2))
def test_zeros_of_polynomials(zeros, factor):
    rows, found = np.zeros((COLUMNS, COLUMNS)), np.empty((2, COLUMNS + 1))
    rows[0] = factor * np.poly(zeros)[::-1]
    apart = min((abs(x - y) for i, x in enumerate(zeros) for y in zeros[:i]), default=1)
    count = real_zeros(rows, -4.0, 4.0, found)
    for zero in found[0, :count]:
        assert min(abs(zero - x) for x in zeros) < 1e-3
    if apart > 1e-2 and abs(factor) > 1e-3:
        assert found[0, :count] == pytest.approx(sorted(zeros), abs=1e-8)


def searched(points, tangents):
    """The least largest displacement by Nelder and Mead's method from a grid."""
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()

    def largest(parts):
        found = displacements(points, tangents, (parts[0] * length, parts[1] * length))
        if found is None:
            return math.inf
        height = np.abs(found)
        i = int(height.argmax())
        if not 0 < i < len(height) - 1:
            return height[i]
        before, here, after = height[i - 1 : i + 2]
        bend = before - 2 * here + after
        return here - (after - before) ** 2 / (8 * bend) if bend < 0 else here

    grid = [(x, y) for x in np.linspace(0.03, 0.75, 14) for y in np.linspace(0.03, 0.75, 14)]
    heights = sorted((largest(parts), parts) for parts in grid)
    least = math.inf
    for _, parts in heights[:4]:
        at = np.array(parts)
        for _ in range(2):
            simplex = at + np.array([[0.0, 0.0], [0.02, -0.02], [0.01, 0.01]])
            options = {"xatol": 1e-9, "fatol": 1e-15, "maxiter": 250, "initial_simplex": simplex}
            result = minimize(largest, at, method="Nelder-Mead", options=options)
            at, least = result.x, min(least, result.fun)
    return least


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_random_arcs_against_a_search(seed):
    random = np.random.default_rng(seed)
    texts = ("t, cosh(t)", "sin(t), sin(2*t)", "t, exp(-t^2)", "t, t^2/2+t^5/8", "t, sin(3*t)+t^2")
    text = texts[random.integers(len(texts))]
    jet = jet_of(text)
    while True:
        a = random.uniform(-1.5, 1.5)
        b = a + random.uniform(0.3, 2.0)
        if course_of(FIT, jet, a, b)[-1, 1] < 3.5:
            break
    rows = np.empty((160, 6))
    sample_many(jet.address, np.linspace(a, b, len(rows)), rows)
    tangents = rows[:, [1, 4]] / np.linalg.norm(rows[:, [1, 4]], axis=1)[:, None]
    least = searched(rows[:, [0, 3]], tangents)
    error, _ = best(FIT, arc(jet, a, b))
    # the parabola through three heights is too high or too low by the fourth power of the step
    assert error <= least * (1 + 2e-3) + 1e-13
    assert error >= least * (1 - 2e-2) - 1e-13
