"""Where a curve turns back within much less than its tolerance, errors do not depend on what samples hit."""

import numpy as np
import pytest

import osculant as osc
from tests.hausdorff import Formula, distance
from tests.random_curves import RESOLVED

#: where the curve turns, after its start at 0 or before its end at 1
TURNS = np.geomspace(1e-3, 0.3, 24)


@pytest.mark.parametrize("aside", [1e-3, 1e-6])
@pytest.mark.parametrize("late", [False, True])
@pytest.mark.parametrize("dimension", [2, 3])
def test_chords_are_at_least_as_wrong_as_the_curve_goes_beyond_them(dimension, late, aside):
    for turn in TURNS:
        at = float(f"{1 - turn if late else turn:.6g}")
        text = ", ".join([f"(t - {at})^2", f"{aside:g}*t", f"{aside:g}*t^2"][:dimension])
        curve = osc.curve(text, 0, 1)
        for tolerance in (1.01 * turn**2, 10 * turn**2, 0.1):
            for piece in osc.approximate(curve, "polygon", tolerance).pieces:
                a, b = piece.interval
                beyond = min((a - at) ** 2, (b - at) ** 2) if a < at < b else 0.0
                assert beyond * (1 - 1e-9) <= piece.error <= tolerance


def test_a_chord_that_begins_before_a_hairpin_of_a_millionth():
    inner = "(0.914497 + 0.245183*log(t))"
    text = f"{inner}^2 + 9.248*sin(36.86*{inner}), {inner}^3 + 0.0001558*{inner}"
    segments = osc.approximate(osc.curve(text, "1/100", 1), "polygon", 0.0156).to_json()["segments"]
    formula = Formula(text, "1/100", "1")
    edges = formula.parts(0.01, 1.0, RESOLVED * 0.0156)
    assert distance(formula, segments[0], edges) <= segments[0]["error"] * (1 + 1e-5)
