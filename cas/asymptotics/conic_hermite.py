"""Polynomial curves of odd degree n with 2n contacts with a conic: order 2n, and the constant in front.

On the unit circle a polynomial curve P(t) = x + iy with |P|² = 1 + G(t)² lies at the distance G²/2 from the
circle, up to higher order. Floater (Computer Aided Geometric Design 14, 1997) asks for n − 1 contacts at
each end and 2 in the middle, hence G = γ·g with g = t(t² − A²)^{(n−1)/2}. Several curves have these
contacts; the one taken here, from the rational parametrisation (1 + it)/(1 − it), is P = (1 + it)/(1 −
it)·(1 − cg): the pole at t = −i is removed by c = 1/g(−i), which is imaginary for odd n, so |P|² = 1 +
|c|²g². The arc has half the angle 2·atan A.

In the limit of a short arc the contacts come together, |P|² = 1 + γ²t^{2n}. The roots are 2n points on a
circle, n of which, one of each conjugate pair, belong to P; each choice is a curve. The angle of P grows
with the speed S = Σ ± sin((2j + 1)π/2n) when γ = 1, and the displacement at angle u is (u/S)^{2n}/2: the
larger the speed, the better. The choice above has S = 2 for n > 1, and S = 1 for n = 1, the tangent in the
middle; all roots in one half plane, as in Butterworth's filter, have the largest, S = 1/sin(π/2n). Both
agree for n ≤ 3.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import sympy as sp

from osculant.cas.errors import DomainError

#: the parameter of the curve, and of its ends
t, A = sp.symbols("t A", real=True)


def contact_factor(degree: int) -> Any:
    """g(t), with n − 1 zeros at each of ±A and 2 at 0 in g².

    Raises DomainError for a degree that is not odd and positive.

    >>> contact_factor(3)
    t*(-A**2 + t**2)
    """
    if degree < 1 or degree % 2 == 0:
        raise DomainError(f"The interpolant with 2n contacts exists here for odd degree n, not for {degree}.")
    return t * (t**2 - A**2) ** ((degree - 1) // 2)


@cache
def circle_interpolant(degree: int) -> tuple[Any, Any]:
    """(x, y), polynomials in t of that degree over ℚ(A): 2n contacts with the unit circle.

    Raises DomainError for a degree that is not odd and positive.

    >>> circle_interpolant(1)
    (1, t)
    """
    g = sp.expand(contact_factor(degree))
    pole = sp.expand(g.subs(t, -sp.I))  # g(−i) = −ib with a real b, since g is odd
    b = sp.expand(sp.I * pole)
    generators, domain = (t, A), sp.QQ_I
    quotient, rest = sp.div(
        sp.Poly(pole - g, *generators, domain=domain), sp.Poly(1 - sp.I * t, *generators, domain=domain)
    )
    if not rest.is_zero or b.has(sp.I):
        raise DomainError(f"The pole of the parametrisation stays at degree {degree}: no polynomial curve.")
    # P = (1 + it)·quotient/(−ib)
    numerator = (
        quotient
        * sp.Poly(1 + sp.I * t, *generators, domain=domain)
        * sp.Poly(sp.I, *generators, domain=domain)
    )
    x, y = (
        sp.Add(
            *(getattr(domain.convert(c), part) * t**m * A**n for (m, n), c in numerator.rep.to_dict().items())
        )
        for part in ("x", "y")
    )
    return sp.cancel(x / b), sp.cancel(y / b)


def speed(signs: tuple[int, ...]) -> Any:
    """S of a choice of roots: the sign says in which half plane the root of each conjugate pair lies.

    P = Π(1 − t/ρ) over the roots ρ = e^{iψ} of t^{2n} = −1, ψ = ±(2j + 1)π/2n, has P′/P = −Σ 1/ρ at 0.

    >>> speed((1, 1, 1)), speed((1, -1, 1))
    (2, 0)
    """
    n = len(signs)
    return sp.simplify(sum(s * sp.sin(sp.pi * (2 * j + 1) / (2 * n)) for j, s in enumerate(signs)))


def rational_speed(degree: int) -> Any:
    """S of `circle_interpolant`, dθ/dt at t = 0 when A = 0.

    >>> rational_speed(5)
    2
    """
    x, y = (c.subs(A, 0) for c in circle_interpolant(degree))
    angular = (x * sp.diff(y, t) - y * sp.diff(x, t)).subs(t, 0)
    return sp.simplify(angular)


def peak(degree: int) -> Fraction:
    """The height of (u² − 1)^{n−1}u² on [−1, 1], at u² = 1/n: the contacts at the ends and in the middle.

    >>> peak(3)
    Fraction(4, 27)
    """
    contact_factor(degree)
    w = sp.Symbol("w")
    shape = (1 - w) ** (degree - 1) * w  # w = u²
    critical = [r for r in sp.roots(sp.diff(shape, w), w) if 0 < r < 1] or [sp.Integer(1)]
    height = max(shape.subs(w, r) for r in critical)
    return Fraction(int(height.p), int(height.q))


def conic_constant(degree: int, rate: Any | None = None) -> Any:
    """c in the error c·|k|^{n−1}κ^{1/3}ℓ^{2n} of one short arc of a conic, ℓ = κ^{1/3}σ its affine length.

    Args:
        degree: n, odd.
        rate: the speed S of the choice of roots; that of `circle_interpolant` unless given.

    On a circle of radius 1 the error is (u/S)^{2n}/2 spread over the contacts; curvature scales as 1/radius
    and k as radius^{−4/3}, and both sides are affine invariants of the conic up to κ^{1/3}.

    >>> conic_constant(3)
    1/55296
    """
    rate = rational_speed(degree) if rate is None else rate
    return sp.Rational(*peak(degree).as_integer_ratio()) / (2 * (2 * rate) ** (2 * degree))
