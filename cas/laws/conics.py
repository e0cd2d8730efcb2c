"""The laws of bitangent parabolas and of the best bitangent conics, for distances and for areas.

In the affine frame the curve is y = x²/2 + kx⁴/8 + (dk/dr)x⁵/40 + … (Lemma 2.2.2).  A parabola with the same
frame lacks the x⁴ term; a conic that has it lacks the x⁵ term.  Bitangent over an arc of affine length ρ,
the difference is that coefficient times the polynomial with the double zeros at the ends (and, for the
conic, a zero between, in the middle where both lobes are equal), (ρ/2)⁴⁺ᵐ xᵐ(1 − x²)² on [−1, 1], m = 0 or 1.
With ρ = κ^{1/3}σ and the factor κ^{1/3} from affine to Euclidean normal its peak gives Theorem 3.6.1:
|k|κ^{5/3}σ⁴/128 and |dk/dr|κ²σ⁵/(2000√5).  The integral of its absolute value gives Theorem 3.6.4, the areas
|k|ρ⁵/240 and |dk/dr|ρ⁶/7680: areas are the same in the affine frame.  So c for areas is that of the conics of
equal moons and of least area alike.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache, partial

from osculant.cas.formulas.expression import Node, call, mul, number
from osculant.cas.jets.canonical import affine_graph
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.law import Law


@cache
def canonical_coefficients() -> tuple[Fraction, Fraction]:
    """The factors of k in x⁴ and of dk/dr in x⁵ of the affine canonical form.

    >>> canonical_coefficients()
    (Fraction(1, 8), Fraction(1, 40))
    """
    y, (k, slope, *_) = affine_graph(5)
    # both quotients are exact; what is left must be constant, or it does not read as a fraction
    return Fraction(str(y[4] / k)), Fraction(str(y[5] / slope))


def distance_constant(crossings: int) -> Node:
    """c in the error c·|k|κ^{5/3}σ⁴ (no crossing: the parabola) or c·|dk/dr|κ²σ⁵ (one: the conic).

    The peak of xᵐ(1 − x²)² is where x² = m/(m + 4).

    >>> print(distance_constant(0), distance_constant(1))
    1/128 1/2000*sqrt(1/5)
    """
    at = Fraction(crossings, crossings + 4)
    rest = canonical_coefficients()[crossings] * (1 - at) ** 2 / 2 ** (4 + crossings)
    return mul(number(rest), call("sqrt", number(at))) if crossings else number(rest)


def area_constant(crossings: int) -> Node:
    """c in the area c·|k|ρ⁵ (no crossing) or c·|dk/dr|ρ⁶ (one) between a short arc and its approximation.

    The lobes' areas add; that of the conic is crossed in the middle, where both are equal and their sum
    is least.

    >>> print(area_constant(0), area_constant(1))
    1/240 1/7680
    """
    # ∫ xᵐ(1 − x²)² over [0, 1], one half of the arc
    half = sum(Fraction(c, crossings + n) for n, c in ((1, 1), (3, -2), (5, 1)))
    return number(2 * half * canonical_coefficients()[crossings] / 2 ** (5 + crossings))


def _parabola(jet: PlaneJet) -> object:
    kappa = abs(jet.curvature)
    return abs(jet.affine_curvature) * kappa * jet.root(kappa * kappa, 3)


def _conic(jet: PlaneJet) -> object:
    return abs(jet.affine_curvature_slope) * jet.curvature * jet.curvature


def _areas(law: Law, crossings: int) -> Law:
    """The displacement integrated along the arc: the same invariant, one order more."""
    return replace(law, metric="area", order=law.order + 1, constant=partial(area_constant, crossings))


_SOURCE = "osculant.cas.asymptotics.short_arcs"
PARABOLA = Law("parabola", "hausdorff", 4, 4, _parabola, partial(distance_constant, 0), _SOURCE)
CONIC = Law("conic", "hausdorff", 5, 5, _conic, partial(distance_constant, 1), _SOURCE)
#: (3.17), (3.18), (3.25), (3.26)
LAWS = (PARABOLA, CONIC, _areas(PARABOLA, 0), _areas(CONIC, 1))
