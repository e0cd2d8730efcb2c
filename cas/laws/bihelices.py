"""The laws of bihelices: |κ′|σ³/324, and κ|τ′|σ⁴/5760 along curves of constant curvature, where κ′ vanishes.

`osculant.cas.asymptotics.bihelix_series` derives both displacements, and the claims about bihelices their
peaks.
"""

from __future__ import annotations

from fractions import Fraction

from osculant.cas.formulas.expression import number
from osculant.cas.jets.space import SpaceJet
from osculant.cas.laws.law import Law

_SOURCE = "osculant.cas.asymptotics.bihelix_series"


def _slope(jet: SpaceJet) -> object:
    return abs(jet.curvature_slope)


def _twist(jet: SpaceJet) -> object:
    return abs(jet.curvature * jet.torsion_slope)


LAWS = (
    Law("bihelix", "hausdorff", 3, 3, _slope, lambda: number(Fraction(1, 324)), _SOURCE, (3,)),
    Law("level bihelix", "hausdorff", 4, 4, _twist, lambda: number(Fraction(1, 5760)), _SOURCE, (3,)),
)
