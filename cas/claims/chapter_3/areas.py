"""Areas between a short arc and its parabola or conic in the affine frame, and what they sum up to."""

from __future__ import annotations

from functools import cache
from typing import Any

import sympy as sp
from flint import arb

from osculant.cas.formulas.parser import parse_constant, parse_tuple
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.jets.canonical import affine_arc
from osculant.cas.jets.plane import PlaneJet
from osculant.cas.laws.conics import canonical_coefficients
from osculant.cas.numbers.balls import PRECISION, constant, precision
from osculant.cas.numbers.quadrature import integral

#: area of an arc: its order in the affine length ρ
ORDERS = {"parabola": 5, "conic": 6}
rho = sp.Symbol("rho", positive=True)
k, k1, P, Q, c, x, u = sp.symbols("k k1 P Q c x u", real=True)


def chord_area(first: Any, second: Any, at: Any, low: Any, high: Any) -> Any:
    """½∫[α(u) − α(σ), α′(u)] du between parameters σ = low and τ = high (3.20)."""
    moved = [f - f.subs(at, low) for f in (first, second)]
    density = moved[0] * sp.diff(second, at) - moved[1] * sp.diff(first, at)
    whole = sp.Poly(density, at).integrate(at)
    return (whole.eval(high) - whole.eval(low)) / 2


@cache
def areas() -> tuple[Any, Any]:
    """A_γ(0, ρ) and A_β(0, ρ) to the order ρ⁵, β = γ + u²(ρ − u)²(Pt + Qn), in the affine frame at 0."""
    X, Y, _ = affine_arc(5, [k, *sp.symbols("k1:3")])
    first, second = (
        sp.Add(*(coefficient * u**i for i, coefficient in enumerate(row.coefficients))) for row in (X, Y)
    )
    shape = u**2 * (rho - u) ** 2
    # t = γ′ and n = γ″, as far as ρ⁵ needs them
    moved = [f + shape * (P * sp.diff(f, u) + Q * sp.diff(f, u, 2)) for f in (first, second)]
    gamma, beta = (
        sp.Add(*(sp.expand(chord_area(x1, x2, u, 0, rho)).coeff(rho, i) * rho**i for i in range(6)))
        for x1, x2 in ((first, second), (moved[0], moved[1]))
    )
    return gamma, beta


def moons(crossing: Any) -> tuple[Any, Any]:
    """Areas of x²(1 − x)²|x − c| before and after c."""
    shape = sp.expand(x**2 * (1 - x) ** 2 * (crossing - x))
    return sp.integrate(shape, (x, 0, crossing)), -sp.integrate(shape, (x, crossing, 1))


def area_at(crossing: Any) -> Any:
    """δ of a conic that crosses at cρ: the moons times the factor of dk/dr > 0 in the canonical form."""
    return sum(moons(crossing)) * sp.Rational(canonical_coefficients()[1]) * k1 * rho**6


def arc_factor(primitive: str) -> Any:
    """1/240 or 1/7680: δ/(|k|ρ⁵) or δ/(|dk/dr|ρ⁶) of one arc, derived in the module of theorem 3.6.4."""
    if primitive == "parabola":
        gamma, beta = areas()
        found = (gamma - beta).subs(Q, sp.Rational(canonical_coefficients()[0]) * k) / (k * rho**5)
    else:
        found = area_at(sp.Rational(1, 2)) / (k1 * rho**6)
    return sp.cancel(found)


@cache
def constant_of(example: tuple[str, str, str], primitive: str) -> Any:
    """The constant of (3.25) or (3.26) on an arc without special points inside, by quadrature.

    >>> from osculant.cas.claims.examples import SPIRAL_ARC
    >>> print(constant_of(SPIRAL_ARC, "conic").str(8, radius=False))
    2.0377782
    """
    (curve, low, high), order = example, ORDERS[primitive]
    with precision(PRECISION):
        balls = CurveBalls(parse_tuple(curve))
        ends = constant(parse_constant(low)), constant(parse_constant(high))

        def density(t: Any, balls: CurveBalls = balls) -> Any:
            return _affine_density(balls.jet(t, 5), primitive).mid()

        total, _ = integral(density, *ends)
        factor = arc_factor(primitive)
        return (total**order * arb(int(factor.p)) / int(factor.q)).root(order - 1)


def _affine_density(jet: PlaneJet, primitive: str) -> Any:
    invariant = abs(jet.affine_curvature if primitive == "parabola" else jet.affine_curvature_slope)
    return invariant.root(ORDERS[primitive]) * abs(jet.affine_speed) if invariant > 0 else arb(0)
