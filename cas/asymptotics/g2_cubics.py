"""G² cubics themselves, and how many of them a curve needs: the numbers behind `hermite_cubics`.

For data (p, T, κ) at two ends the tangent lengths of the cubic b₀, b₀ + δ₀T₀, b₃ − δ₁T₁, b₃ solve
[T₀,T₁]δ₁ = [T₀,d] − (3/2)κ₀δ₀² and [T₀,T₁]δ₀ = [d,T₁] − (3/2)κ₁δ₁² with d = p₁ − p₀; δ₁ is eliminated and
leaves a quartic, whose fourth solution near −h, −h is no approximation.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import mpmath as mp
from flint import arb

from osculant.cas.asymptotics.contacts import CONTACTS
from osculant.cas.asymptotics.hermite_cubics import affine_jet, branches
from osculant.cas.errors import DomainError, UndecidedError
from osculant.cas.jets.balls import CurveBalls
from osculant.cas.numbers.balls import PRECISION, precision
from osculant.cas.numbers.quadrature import double_exponential

#: a root of the quartic whose imaginary part is below this part of its modulus counts as real
REAL = 1e-12
#: a quadrature whose last halving of the step changes the value by more than this has not settled
SETTLED = 1e-8

Vector = tuple[Any, Any]
#: a curve by any parameter: t to the point and its first two derivatives
Curve = Callable[[Any], tuple[Vector, Vector, Vector]]


def g2_cubics(curve: Curve, low: Any, high: Any) -> list[tuple[Vector, Vector, Vector, Vector]]:
    """The control points of all cubics with the curve's position, tangent and curvature at both parameters.

    Args:
        curve: point, first and second derivative as pairs of mpmath numbers.
        low: the parameter of the first end.
        high: that of the second.

    Only cubics with positive tangent lengths are returned: at most three for a short arc. The precision is
    mpmath's current one; the three solutions are as close as h⁷ᐟ³, so ask for many digits.

    Raises DomainError if the tangents are parallel or a curvature is 0: then the system is singular.

    >>> with mp.workdps(40):
    ...     arc = lambda t: ((mp.cos(t), mp.sin(t)), (-mp.sin(t), mp.cos(t)), (-mp.cos(t), -mp.sin(t)))
    ...     len(g2_cubics(arc, mp.mpf(0), mp.mpf(1) / 10))
    3
    """
    (p0, T0, first), (p1, T1, last) = (_frame(*curve(t)) for t in (low, high))
    d = (p1[0] - p0[0], p1[1] - p0[1])
    cross, rise, fall = _cross(T0, T1), _cross(T0, d), _cross(d, T1)
    if cross == 0 or first == 0 or last == 0:
        turning = mp.nstr(cross, 6)
        raise DomainError(
            f"The contact conditions are singular: curvatures {mp.nstr(first, 6)} and {mp.nstr(last, 6)}, "
            f"sine of the turning {turning}; choose an arc where none of them is 0."
        )
    # δ₁ = u − wδ₀² into crossδ₀ = fall − (3/2)κ₁δ₁²
    u, w, half = rise / cross, 3 * first / (2 * cross), mp.mpf(3) / 2 * last
    quartic = [half * w * w, mp.mpf(0), -2 * half * u * w, cross, half * u * u - fall]
    roots = mp.polyroots(quartic, maxsteps=500, extraprec=6 * mp.mp.prec)
    found = []
    for root in roots:
        delta = mp.re(root)
        other = u - w * delta * delta
        if abs(mp.im(root)) <= REAL * abs(root) and delta > 0 and other > 0:
            found.append(
                (p0, _along(p0, T0, delta), _along(p1, T1, -other), p1),
            )
    return found


def displacement(curve: Curve, cubic: Sequence[Vector], t: Any, start: Any) -> Any:
    """The distance from the curve to the cubic along the curve's normal at t, signed, by Newton's method.

    Args:
        curve: point, first and second derivative as pairs of mpmath numbers.
        t: its parameter where the normal stands.
        cubic: control points.
        start: a parameter in [0, 1] near the foot.
    """
    p, T, _ = _frame(*curve(t))

    def along(s: Any) -> Any:
        q = bezier(cubic, s)
        return (q[0] - p[0]) * T[0] + (q[1] - p[1]) * T[1]

    q = bezier(cubic, mp.findroot(along, start))
    return _cross(T, (q[0] - p[0], q[1] - p[1]))


def bezier(points: Sequence[Vector], s: Any) -> Vector:
    """De Casteljau's value of a Bézier curve.

    >>> bezier([(0, 0), (1, 2), (2, 0)], 0.5)
    (1.0, 1.0)
    """
    row = list(points)
    while len(row) > 1:
        row = [(p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])) for p, q in pairwise(row)]
    return row[0]


def error_coefficient(affine_curvature: Any, slope: Any, bend: Any) -> Any:
    """min |E|/64 over the real solutions: the error of one short arc is that times κ^{7/3}σ⁶.

    Raises DomainError where two solutions coincide.

    >>> mp.nstr(error_coefficient(mp.mpf(1), mp.mpf(0), mp.mpf(0)) * 64 * 128, 6)  # a circle
    '1.0'
    """
    best = branches(affine_curvature, slope, bend)[0]
    return abs(best.residual) / 2**CONTACTS


def complexity(curve: CurveBalls, low: Any, high: Any) -> Any:
    """C in N(ε) = C·ε^{−1/6} for G² cubics of least error over [low, high], to about 15 digits.

    Raises DomainError at an inflection, UndecidedError if the quadrature does not settle: the best solution
    may change inside, or its E may have a zero there; split at that point.

    >>> from osculant.cas.formulas.parser import parse_tuple
    >>> mp.nstr(complexity(CurveBalls(parse_tuple("cos(t), sin(t)")), 0, 1) ** 6 * 64 * 128, 6)
    '1.0'
    """
    with precision(PRECISION), mp.workprec(PRECISION):

        def density(t: Any) -> Any:
            x, y = ([_number(c) for c in row] for row in curve.coefficients(t, CONTACTS))
            speed = mp.sqrt(x[1] ** 2 + y[1] ** 2)
            kappa = abs(2 * (x[1] * y[2] - x[2] * y[1])) / speed**3
            error = error_coefficient(*affine_jet(x, y)) * mp.cbrt(kappa) ** 7
            return arb(mp.nstr(mp.root(error, CONTACTS) * speed, mp.mp.dps))

        value, change = double_exponential(density, arb(low), arb(high))
        if change > SETTLED * abs(float(value)):
            raise UndecidedError(
                f"The complexity integral did not settle on [{float(low):.6g}, {float(high):.6g}]: split it."
            )
        return _number(value)


def _number(value: Any) -> Any:
    return mp.mpf(value.mid().str(mp.mp.dps, radius=False))


def _frame(p: Vector, first: Vector, second: Vector) -> tuple[Vector, Vector, Any]:
    speed = mp.sqrt(first[0] ** 2 + first[1] ** 2)
    return p, (first[0] / speed, first[1] / speed), _cross(first, second) / speed**3


def _cross(p: Vector, q: Vector) -> Any:
    return p[0] * q[1] - p[1] * q[0]


def _along(p: Vector, T: Vector, length: Any) -> Vector:
    return p[0] + T[0] * length, p[1] + T[1] * length
