"""`primitive="best"`: the primitive that takes the fewest numbers to store."""

from __future__ import annotations

import pytest

import osculant as osc
from osculant.cas.errors import DomainError
from osculant.primitives.table import candidates

SPIRAL = ("t*cos(t), t*sin(t)", "pi/6", "2*pi")


@pytest.mark.parametrize("metric", ["hausdorff", "area"])
@pytest.mark.parametrize("tolerance", [0.3, 1e-2, 1e-5])
@pytest.mark.parametrize("formula", [SPIRAL, ("t, t^2 + t^5/50", 0, 1), ("3*cos(t), 2*sin(t)", 0, "2*pi")])
def test_no_other_primitive_takes_fewer_numbers(formula, tolerance, metric):
    curve = osc.curve(*formula)
    best = osc.approximate(curve, "best", tolerance, metric=metric)
    others = [osc.approximate(curve, name, tolerance, metric=metric) for name in candidates(2)]
    assert best.numbers == min(spline.numbers for spline in others)
    assert best.primitive in candidates(2)
    for spline in others:
        assert f"{spline.primitive}: {len(spline)} pieces, {spline.numbers} numbers" in best.choice


def test_numbers_of_each_kind():
    spiral = osc.curve(*SPIRAL)
    numbers = {name: osc.approximate(spiral, name, pieces=5).numbers for name in candidates(2)}
    assert numbers == {"parabola": 2 + 5 * 4, "conic": 2 + 5 * 5, "biarc": 2 + 5 * 6, "cubic": 2 + 5 * 6}
    assert osc.approximate(osc.curve("t, 2*t", 0, 1)).numbers == 4
    assert osc.approximate(osc.curve("cos(t), sin(t)", 0, 3), "biarc").numbers == 5


def test_what_the_curve_is_decides():
    assert osc.approximate(osc.curve("cos(t), sin(t)", 0, 3), "best").primitive == "biarc"
    assert osc.approximate(osc.curve("t, t^2", 0, 3), "best").primitive == "parabola"
    assert osc.approximate(osc.curve("t, 1/t", 1, 3), "best").primitive == "conic"


def test_a_number_of_pieces_or_a_rule_belongs_to_one_primitive():
    for choice in ({"pieces": 4}, {"rule": "minimal-area", "metric": "area"}):
        with pytest.raises(DomainError, match="belongs to one primitive: name that and not 'best'"):
            osc.approximate(osc.curve(*SPIRAL), "best", **choice)


def test_what_a_format_cannot_hold_is_said_of_that_format(tmp_path):
    files = [tmp_path / "a.svg", tmp_path / "b.nc"]
    best = osc.approximate(osc.curve(*SPIRAL), "best", 1e-2, files=files)
    assert best.primitive == "biarc"
    assert [choice for choice in best.choice if "not for" in choice] == [
        f"{name}: not for G-code" for name in candidates(2) if name != "biarc"
    ]
