"""The integral that decides how many bihelices, or plane biarcs, a curve needs: a certified enclosure.

A short arc of length σ has the error c|κ′|σ³ (c = 1/324), so N(ε) ≈ c^{1/3} ∫|κ′|^{1/3} ds · ε^{−1/3}. With
S = |α̇|², C = |α̇ × α̈|² and P the form that vanishes where κ′ does (`SpaceJet.curvature_slope_form`) the
integrand is P^{1/3} S^{−1/2} C^{−1/6}: analytic off the zeros of P, S and C, so complex balls integrate it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import acb, arb

from osculant.cas.errors import DomainError
from osculant.cas.formulas.expression import Node
from osculant.cas.jets.space import SpaceJet
from osculant.cas.numbers.balls import precision
from osculant.cas.numbers.fields import ComplexBalls
from osculant.cas.numbers.taylor import program

#: working precision in bits, and the relative accuracy wanted
BITS, ACCURACY = 96, 1e-9
#: values of the integrand before the enclosure is left as wide as it is
EVALUATIONS = 20000


def curvature_slope_integral(coordinates: Sequence[Node], low: Any, high: Any) -> Any:
    """A ball that contains ∫|κ′|^{1/3} ds.

    Args:
        coordinates: three formulas in t, made of polynomials and of sin, cos, tan, sinh, cosh, tanh, exp.
        low: left end, a ball or number.
        high: right end.

    Zeros of κ′ are allowed, also at the ends. Raises DomainError for other functions, and if the enclosure is
    not finite: a cusp or a point with κ = 0 is in the way.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> print(curvature_slope_integral(parse_tuple("t, t^2, t^3"), 1, 2).str(8, radius=False))
    1.7706947
    """
    compiled = program(tuple(coordinates), 3)
    field = ComplexBalls()

    def density(t: Any, analytic: bool) -> Any:
        x, y, z = compiled.run(t, field)
        jet = SpaceJet(x, y, z)
        size = jet.inflection_form.log(analytic=True) / 6 + jet.speed_squared.log(analytic=True) / 2
        return _cube_root(jet.curvature_slope_form, analytic) * (-size).exp()

    with precision(BITS):
        ends = acb(low), acb(high)
        value = acb.integral(density, *ends, rel_tol=ACCURACY, abs_tol=ACCURACY, eval_limit=EVALUATIONS).real
    if not value.is_finite():
        raise DomainError(
            f"The integral of |κ′|^(1/3) from t = {float(arb(low)):.6g} to {float(arb(high)):.6g} is not "
            "finite: split the curve at its cusps and where κ = 0."
        )
    return value


def _cube_root(z: Any, analytic: bool) -> Any:
    """|z|^{1/3} for real z, continued from the half line where z is."""
    if z.real > 0 or z.real < 0:
        return ((z if z.real > 0 else -z).log(analytic=True) / 3).exp()
    if analytic or not z.is_finite():
        return acb(arb.nan())
    top = abs(z).upper()
    return acb(arb(0).union(top.root(3)))
