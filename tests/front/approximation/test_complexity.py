"""Predicted numbers of pieces and errors in both metrics: the protocol, its inverse, the quick integrals."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import osculant as osc
from osculant.approximation.division import divide
from osculant.approximation.prediction import Complexity, quick_complexity
from osculant.cas.laws.table import law_of
from osculant.primitives.table import METRICS, PRIMITIVES, choose

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")
SEXTIC = ("4*cos(t/3)^3*cos(t), 4*cos(t/3)^3*sin(t)", "-3*pi/4", "3*pi/4")
TOLERANCES = [10.0**-n for n in range(1, 7)]

constants = st.lists(st.floats(0.01, 30), min_size=1, max_size=4)
tolerances = st.floats(-7, 1).map(lambda x: 10**x)


def area_law(values, least=None, order=5):
    return Complexity("conic", "area", order, tuple(map(repr, values)), least or (1,) * len(values), 15)


# The corrected tables of the thesis.


@pytest.mark.parametrize(
    ("primitive", "digits", "counts"),
    [
        ("parabola", "4.5898927289745501", [9, 15, 26, 46, 82, 146]),
        ("conic", "2.0377782008099256", [4, 6, 9, 13, 21, 33]),
    ],
)
def test_table_3_2(primitive, digits, counts):
    law = osc.complexity(osc.curve(*SPIRAL), primitive, metric="area")
    assert (law.metric, law.primitive) == ("area", primitive)
    assert law.order == law_of(primitive, "area").spline_order == law_of(primitive).order
    assert law.to_json()["constant"].startswith(digits) and law.constants[0].startswith(digits)
    assert [law.count(tolerance) for tolerance in TOLERANCES] == counts


@pytest.mark.parametrize(
    ("primitive", "whole", "per_half"),
    [
        ("parabola", [8, 14, 24, 40, 72, 128], [6, 12, 20, 34, 60, 108]),
        ("conic", [4, 6, 8, 12, 18, 26], [4, 4, 6, 10, 16, 24]),
    ],
)
def test_table_3_4(primitive, whole, per_half):
    """The area allowed for the whole curve, or for each half (where theory is one too low once: 6, not 8)."""
    law = osc.complexity(osc.curve(*SEXTIC), primitive, metric="area", split_at=[0])
    assert [law.count(tolerance) for tolerance in TOLERANCES] == whole
    half = osc.complexity(osc.curve(SEXTIC[0], 0, SEXTIC[2]), primitive, metric="area")
    assert [2 * half.count(tolerance) for tolerance in TOLERANCES] == per_half
    # both halves have the same content S = C^{q/p}
    power = (law.order + 1) / law.order
    assert law.constant == pytest.approx(half.constant * 2**power, rel=1e-14)
    assert float(law.to_json()["constant"]) == pytest.approx(law.constant, rel=1e-14)
    assert law.constants[0] == law.constants[1]


# The protocol of n pieces with the area ε/n.


@settings(max_examples=200)
@given(constants, tolerances, st.sampled_from([3, 4, 5]), st.data())
def test_the_least_number_by_brute_force(values, tolerance, order, data):
    least = tuple(data.draw(st.integers(1, 4)) for _ in values)
    law = area_law(values, least, order)

    def needed(n):
        """Pieces of the area ε/n: every stretch alone takes N(a) with N·a its own whole area."""
        piece = tolerance / n
        contents = [c ** (order / (order + 1)) * piece ** (-1 / (order + 1)) for c in values]
        return sum(max(k, math.ceil(x * (1 - 1e-12))) for x, k in zip(contents, least))

    found = law.predicted_pieces(tolerance)
    assert needed(found) <= found
    assert all(needed(n) > n for n in range(1, found))
    assert sum(least) <= found < 2 ** len(values) * (law.predicted(tolerance) + sum(least)) + 2 * len(values)


@given(constants, st.integers(1, 5000), st.sampled_from(METRICS))
def test_pieces_and_errors_are_inverse(values, pieces, metric):
    law = Complexity("conic", metric, 5, tuple(map(repr, values)), (1,) * len(values), 15)
    error = law.predicted_error(pieces)
    assert law.predicted(error) == pytest.approx(pieces, rel=1e-12)
    assert law.predicted_error(2 * pieces) == pytest.approx(error / 32, rel=1e-12)
    if len(values) == 1:
        assert law.predicted_pieces(error * (1 + 1e-9)) == pieces


@given(constants)
def test_the_constant_of_several_stretches(values):
    """Pieces shared by content leave the least area: any other share of N pieces leaves more."""
    law = area_law(values)
    contents = [c ** (5 / 6) for c in values]

    def area(shares):
        return sum((c / (n * 1000)) ** 5 for c, n in zip(values, shares))

    best = [s / sum(contents) for s in contents]
    assert area(best) == pytest.approx(law.predicted_error(1000), rel=1e-10)
    if len(values) > 1:
        for other in ([1 / len(values)] * len(values), [c / sum(values) for c in values]):
            assert area(other) >= area(best) * (1 - 1e-12)
        assert law.constant > math.fsum(values)


def test_an_exact_curve_has_its_least_number():
    law = Complexity("conic", "area", 5, ("0", "0"), (2, 1), 15)
    assert (law.constant, law.predicted(1e-3), law.predicted_error(3)) == (0, 0, 0)
    assert law.predicted_pieces(1e-3) == 3
    assert law.to_json()["constant"] == "0"
    mixed = Complexity("conic", "area", 5, ("0", "1.0"), (2, 1), 15)
    assert mixed.constant == 1 and mixed.predicted_pieces(1.0) == 4  # 2 + ⌈3^{1/6}⌉ is more than 3
    assert area_law([1e100]).predicted_error(1) == math.inf


def test_bad_input():
    law = osc.complexity(osc.curve(*SPIRAL), "conic", metric="area")
    for tolerance in (0, -1, math.inf, math.nan):
        for ask in (law.predicted, law.predicted_pieces):
            with pytest.raises(osc.ToleranceError, match="positive"):
                ask(tolerance)
    for pieces in (0, -3, math.nan):
        with pytest.raises(osc.DomainError, match="at least one piece"):
            law.predicted_error(pieces)
    with pytest.raises(osc.DomainError, match="second term is not known for the metric 'area'"):
        osc.complexity(osc.curve(*SPIRAL), "conic", metric="area", next_term=True)
    with pytest.raises(osc.DomainError, match="'l2' is unknown: choose one of hausdorff, area"):
        osc.complexity(osc.curve(*SPIRAL), "conic", metric="l2")


# Doubles.


@pytest.mark.parametrize("metric", METRICS)
@pytest.mark.parametrize("primitive", PRIMITIVES[2])
@pytest.mark.parametrize("formula", [SPIRAL, SEXTIC, ("t, t^3", -1, 2), ("2*cos(t), sin(t)", 0, "2*pi")])
@pytest.mark.parametrize("scale", [1.0, 2.0**-40, 2.0**30])
def test_quick_constants(metric, primitive, formula, scale):
    curve = osc.curve(*formula)
    division = divide(curve, primitive)
    least = (1,) * len(division.stretches)
    if primitive == "cubic" and formula[0] == "t, t^3":  # a cubic itself: doubles tell no constant from 0
        with pytest.raises(osc.UndecidedError):
            quick_complexity(curve, choose(primitive, metric), division, least, scale)
        return
    quick = quick_complexity(curve, choose(primitive, metric), division, least, scale)
    exact = osc.complexity(curve, primitive, metric=metric)
    assert quick.constant == pytest.approx(exact.constant, rel=1e-9)
    assert (quick.metric, quick.order) == (exact.metric, exact.order)
    assert [float(c) for c in quick.constants] == pytest.approx([float(c) for c in exact.constants], rel=1e-9)


@pytest.mark.parametrize("metric", METRICS)
@pytest.mark.parametrize("primitive", PRIMITIVES[2])
def test_every_rule_has_the_order_of_its_law(metric, primitive):
    orders = {choose(primitive, metric, rule).order for rule in PRIMITIVES[2][primitive].rules(metric)}
    assert orders == {law_of(primitive, metric).order}
