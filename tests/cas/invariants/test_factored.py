"""Forms as products, also those of a degree beyond which only powers of the parameter are split off."""

import pytest

from osculant.cas.formulas.parser import parse_tuple
from osculant.cas.invariants.factored import factored
from osculant.cas.jets.plane import PlaneJet
from osculant.curves.plane import PlaneCurve


@pytest.mark.parametrize("n", [5, 20, 61, 100, 300])
def test_the_curvature_of_a_power_vanishes_where_the_power_does(n):
    above, below = factored(parse_tuple(f"t, t^{n}"), PlaneJet, 2, "inflection_form")
    assert ([str(factor) for factor in above], below) == (["t"], [])


@pytest.mark.parametrize("n", [7, 100, 300])
def test_vertices_of_powers(n):
    """κ′ = 0 of y = tⁿ: (n − 2)(1 + n²t²ⁿ⁻²) = 3n²(n − 1)t²ⁿ⁻²."""
    points = PlaneCurve(f"t, t^{n}", 0, 1).special_points(["vertex", "sextactic"])
    assert all(point.decided for point in points)
    vertex = ((n - 2) / (n**2 * (2 * n - 1))) ** (1 / (2 * n - 2))
    assert [float(point.at) for point in points] == pytest.approx([0.0, vertex], abs=1e-12)
