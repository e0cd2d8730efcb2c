"""The laws of biarcs, c·|κ′|σᵖ: the best of a family for distances, the one of equal moons for areas."""

from __future__ import annotations

from functools import partial

from osculant.cas.formulas.expression import Node
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.law import Law


def _constant(metric: str) -> Node:
    from osculant.cas.formulas.sympy_bridge import from_sympy
    from osculant.cas.laws.arcs import arc_law

    return from_sympy(arc_law("biarc", metric).constant)


def _slope(jet: PlaneJet) -> object:
    return abs(jet.curvature_slope)


LAWS = tuple(
    Law("biarc", metric, order, 3, _slope, partial(_constant, metric), "osculant.cas.laws.arcs")
    for metric, order in (("hausdorff", 3), ("area", 4))
)
