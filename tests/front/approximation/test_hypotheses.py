"""What `minimal` says, and when: the theorems' hypotheses on the very arcs."""

import pytest

import osculant as osc
from osculant.cas.claims import all_claims
from osculant.cas.claims.claim import Method
from osculant.primitives.table import PRIMITIVES

SPIRAL = "t*cos(t), t*sin(t)"


@pytest.mark.parametrize("primitive", ["conic", "parabola", "biarc"])
@pytest.mark.parametrize("exponent", [2, 3, 6])
def test_ordinary_splines_are_minimal_by_theory(primitive, exponent):
    spline = osc.approximate(osc.curve(SPIRAL, "pi/6", "2*pi"), primitive, 10.0**-exponent)
    assert spline.minimal == "by theory"


@pytest.mark.parametrize(
    ("formula", "low", "high", "primitive", "count"),
    [
        (SPIRAL, "0.2", "3.4", "conic", 1),  # normals meet the member on its far side: another one is better
        (SPIRAL, "0.2", "5", "conic", 1),  # not strictly convex
        ("exp(t/9)*cos(t), exp(t/9)*sin(t)", "0", "6", "biarc", 1),  # likewise
    ],
)
def test_arcs_beyond_the_hypotheses_are_unknown(formula, low, high, primitive, count):
    curve = osc.curve(formula, low, high)
    try:
        alone = osc.approximate(curve, primitive, pieces=count)
    except osc.OsculantError:
        return  # no piece at all: nothing is said of it
    assert alone.minimal == "unknown"
    assert osc.approximate(curve, primitive, pieces=count + 3).minimal == "by theory"


def test_a_cusp_at_an_end_is_no_obstacle():
    cycloid = osc.curve("t - sin(t), 1 - cos(t)", 0, "2*pi")
    spline = osc.approximate(cycloid, "conic", 1e-4)
    assert len(spline) > 2 and spline.minimal == "by theory"


def test_sums_of_areas_are_unknown_and_the_largest_area_is_not():
    curve = osc.curve(SPIRAL, "pi/6", "2*pi")
    assert osc.approximate(curve, "conic", 1e-4, metric="area").minimal == "unknown"
    for rule in ("equisymmetric", "minimal-area"):
        assert osc.approximate(curve, pieces=9, metric="area", rule=rule).minimal == "by theory"
    assert osc.approximate(curve, "biarc", pieces=9, metric="area").minimal == "unknown"


def test_minimal_is_found_out_when_it_is_asked_for(monkeypatch):
    asked = []
    monkeypatch.setattr("osculant.approximation.approximate.hold", lambda *given: asked.append(given) or True)
    spline = osc.approximate(osc.curve(SPIRAL, "pi/6", "2*pi"), "conic", 1e-3)
    assert not asked
    assert spline.minimal == spline.minimal == "by theory"
    assert len(asked) == 1


def test_every_theorem_is_a_claim_that_is_a_proof():
    table = {claim.name: claim for claim in all_claims()}
    for primitive in (entry for by_name in PRIMITIVES.values() for entry in by_name.values()):
        for (metric, rule), theorem in primitive.theorems.items():
            assert rule in primitive.rules(metric)
            assert table[theorem.claim].method == Method.PROOF
