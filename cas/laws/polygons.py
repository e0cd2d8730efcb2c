"""The law of inscribed polygons, for distances and, in the plane, for areas.

A short arc is y = κx²/2 + … over its tangent in the middle, and its chord a parallel: between them lies
κ(h² − x²)/2 for |x| ≤ h = σ/2.  The peak of that gives κσ²/8, its integral κσ³/12; torsion does not enter.
Source: L. Fejes Tóth for convex curves; thesis, section 1.3.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from osculant.cas.formulas.expression import Node, number
from osculant.cas.laws.law import Law

#: of x⁰ and x² in the distance of the arc from its chord, for κ = h = 1
SAGITTA = (Fraction(1, 2), Fraction(-1, 2))


def distance_constant() -> Node:
    """c in κσ²/8: the distance at x = 0, h being σ/2.

    >>> print(distance_constant())
    1/8
    """
    return number(SAGITTA[0] / 2**2)


def area_constant() -> Node:
    """c in κσ³/12: the integral over [−h, h], h being σ/2.

    >>> print(area_constant())
    1/12
    """
    integral = 2 * sum((c / (2 * i + 1) for i, c in enumerate(SAGITTA)), Fraction(0))
    return number(integral / 2**3)


POLYGON = Law(
    "polygon",
    "hausdorff",
    order=2,
    jet=2,
    invariant=lambda jet: abs(jet.curvature),
    constant=distance_constant,
    source="osculant.cas.laws.polygons",
    spaces=(2, 3),
)
LAWS = (POLYGON, replace(POLYGON, metric="area", order=3, constant=area_constant, spaces=(2,)))
